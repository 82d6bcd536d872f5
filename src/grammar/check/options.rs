//! Options of primitives.

use super::expressions::is_thing;
use super::{Checker, Expected};
use crate::grammar::Code;
use crate::grammar::ast::*;
use crate::grammar::names::{OPTIONS, closest, is_primitive};

impl Checker<'_> {
    /// That each option exists, stands once, and has a value of its kind.
    pub(super) fn options(&mut self, name: &Expr, options: &[(Ident, Expr)], params: &[Ident]) {
        self.takes_options(name, options, params);
        for (at, (option, value)) in options.iter().enumerate() {
            let expected = match option.name.as_str() {
                "wall" => Expected::Thing,
                known if OPTIONS.contains(&known) => Expected::Number,
                _ => {
                    self.unknown_option(option);
                    Expected::Any
                }
            };
            self.expr(value, params, expected);
            if options[..at].iter().any(|(other, _)| other == option) {
                let message = format!("the option `{}` stands twice", option.name);
                self.tell(Code::OptionTwice, option.span, message, "again", "keep one of the two".to_owned());
            }
        }
    }

    fn unknown_option(&mut self, option: &Ident) {
        let near = closest(&option.name, OPTIONS.into_iter());
        let hint = near.map_or_else(
            || format!("the options are {}", OPTIONS.join(", ")),
            |near| format!("did you mean `{near}`?"),
        );
        let message = format!("there is no option `{}`", option.name);
        self.tell(Code::UnknownOption, option.span, message, "not known", hint);
    }

    /// Only shapes have options: a block or a file is what it is.
    fn takes_options(&mut self, name: &Expr, options: &[(Ident, Expr)], params: &[Ident]) {
        let is_other = match &name.kind {
            ExprKind::Name(text) => !is_primitive(text) && is_thing(text) && !self.is_defined(text, params),
            ExprKind::Block(text) => !self.is_changed_name(text, params),
            ExprKind::File(_) | ExprKind::Mix(_) | ExprKind::Gradient(..) => true,
            _ => false,
        };
        if let Some((option, _)) = options.first().filter(|_| is_other) {
            let message = format!("`{name}` takes no options");
            let hint = "options are for shapes such as `gable`, as in `I(gable, oak, pitch = 1)`".to_owned();
            self.tell(Code::UnknownOption, option.span, message, "not for this", hint);
        }
    }
}
