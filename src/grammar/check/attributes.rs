//! Ranges of attributes: that they hold the values that the file itself gives.

use super::Checker;
use super::flow::Flow;
use crate::grammar::Code;

impl Checker<'_> {
    pub(super) fn attributes(&mut self, flow: &Flow<'_>) {
        let grammar = self.grammar;
        for constant in &grammar.constants {
            let Some([low, high]) =
                constant.attribute.as_ref().and_then(|attribute| attribute.range.as_ref())
            else {
                continue;
            };
            let (least, most) = (flow.constant_numbers(low).low(), flow.constant_numbers(high).high());
            if least > most {
                let hint = format!("the least comes first: `range({high}, {low})`");
                let message = format!("the range of `{}` is empty", constant.name.name);
                self.tell(Code::EmptyRange, low.span.to(high.span), message, "holds no value", hint);
                continue;
            }
            let styled = grammar.styles.iter().flat_map(|style| &style.values);
            let styled = styled.filter(|(name, _)| *name == constant.name).map(|(_, value)| value);
            for value in styled.chain([&constant.value]) {
                let numbers = flow.constant_numbers(value);
                if numbers.high() < least || numbers.low() > most {
                    let message = format!(
                        "`{}` is {value}, outside of its range from {low} to {high}",
                        constant.name.name
                    );
                    let hint = "change the value, or the range".to_owned();
                    self.tell(Code::OutOfRange, value.span, message, "out of range", hint);
                }
            }
        }
    }
}
