//! Numbers of a grammar that have to come out otherwise as well.

use super::change::Change;
use super::texts::{Edit, Program};
use crate::grammar::ast::{BinaryOp, Constant, Expr, ExprKind, Function, Rule};
use crate::grammar::{Name, Names};
use crate::space::Scope;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// Where an expression is looked at: in a rule, or outside of all.
#[derive(Clone, Debug, Default)]
pub struct Site<'p> {
    pub rule: Option<&'p Rule>,
    pub scope: Option<Scope>,
    /// The arguments of the rule, and where they stand.
    pub call: Option<(&'p [Expr], Rc<Site<'p>>)>,
}

/// What is asked of expressions, by their places.
pub struct Demands<'p> {
    program: &'p Program,
    asked: BTreeMap<(usize, usize), Asked<'p>>,
}

struct Asked<'p> {
    expr: &'p Expr,
    what: String,
    wish: Wish,
}

enum Wish {
    /// To come to these values as well.
    Values(BTreeSet<i32>),
    /// To be the weight of a floating part instead of a length.
    Float,
}

impl<'p> Demands<'p> {
    pub fn new(program: &'p Program) -> Demands<'p> {
        Demands { program, asked: BTreeMap::new() }
    }

    /// Asks that an expression may come to a value; `None` where that cannot be written by widening a number. `what`
    /// says what it is a number of.
    pub fn ask(&mut self, expr: &'p Expr, value: f64, what: &str, site: &Site<'p>) -> Option<()> {
        match &expr.kind {
            ExprKind::Number(_) | ExprKind::Pick(_) => self.note(expr, value, what),
            ExprKind::Call(Function::Randint | Function::Rand, _) => self.note(expr, value, what),
            ExprKind::Call(Function::Round | Function::Floor | Function::Ceil, args) => {
                self.ask(args.first()?, value, what, site)
            }
            ExprKind::Same(_, inner) => self.ask(inner, value, what, site),
            ExprKind::Binary(op, left, right) => {
                let wanted = self.certain(right, site).and_then(|right| undone_left(*op, value, right));
                wanted.and_then(|wanted| self.ask(left, wanted, what, site)).or_else(|| {
                    let wanted = undone_right(*op, value, self.certain(left, site)?)?;
                    self.ask(right, wanted, what, site)
                })
            }
            ExprKind::Name(name) => match self.named(name, site) {
                Name::Param(at) => {
                    let (args, caller) = site.call.as_ref()?;
                    self.ask(args.get(at)?, value, what, caller)
                }
                Name::Constant(at) => self.ask_constant(self.constants().get(at)?, value),
                _ => None,
            },
            _ => None,
        }
    }

    /// A range that the text gives an attribute is kept.
    fn ask_constant(&mut self, constant: &'p Constant, value: f64) -> Option<()> {
        let range = constant.attribute.as_ref().and_then(|attribute| attribute.range.as_ref());
        let is_within = match range.map(|[low, high]| (literal(low), literal(high))) {
            None => true,
            Some((Some(low), Some(high))) => low <= value && value <= high,
            Some(_) => false,
        };
        match is_within {
            true => self.ask(&constant.value, value, &format!("`{}`", constant.name.name), &Site::default()),
            false => None,
        }
    }

    fn note(&mut self, expr: &'p Expr, value: f64, what: &str) -> Option<()> {
        let whole = (value.fract().abs() < 1e-6 && (0.0..=1e6).contains(&value)).then_some(value as i32)?;
        if !covers(expr, f64::from(whole))? {
            let key = (expr.span.start, expr.span.end);
            let wish = Wish::Values(BTreeSet::new());
            let asked = self.asked.entry(key).or_insert(Asked { expr, what: what.to_owned(), wish });
            if let Wish::Values(values) = &mut asked.wish {
                values.insert(whole);
            }
        }
        Some(())
    }

    /// Asks that a part floats whose length is a plain number.
    pub fn float(&mut self, expr: &'p Expr, what: &str) -> Option<()> {
        literal(expr)?;
        let asked = Asked { expr, what: what.to_owned(), wish: Wish::Float };
        self.asked.insert((expr.span.start, expr.span.end), asked);
        Some(())
    }

    fn constants(&self) -> &'p [Constant] {
        &self.program.checked.grammar().constants
    }

    fn named(&self, name: &str, site: &Site<'p>) -> Name {
        let params = site.rule.map_or(&[][..], |rule| &rule.params);
        Names { params, constants: self.constants() }.resolve(name)
    }

    /// The value of an expression that has but one.
    fn certain(&self, expr: &Expr, site: &Site<'p>) -> Option<f64> {
        match &expr.kind {
            ExprKind::Number(value) => Some(*value),
            ExprKind::ScopeSize(axis) => site.scope.map(|scope| f64::from(scope.len(*axis))),
            ExprKind::Binary(op, left, right) => {
                let (left, right) = (self.certain(left, site)?, self.certain(right, site)?);
                match op {
                    BinaryOp::Add => Some(left + right),
                    BinaryOp::Subtract => Some(left - right),
                    BinaryOp::Multiply => Some(left * right),
                    BinaryOp::Divide => Some(left / right),
                    _ => None,
                }
            }
            ExprKind::Name(name) => match self.named(name, site) {
                Name::Constant(at) => self.certain(&self.constants().get(at)?.value, &Site::default()),
                _ => None,
            },
            _ => None,
        }
    }

    /// The edits that give all that was asked for, with what to tell of them.
    pub fn granted(self) -> Option<(Vec<Edit>, Vec<Change>)> {
        let granted = self.asked.values().map(|asked| {
            let to = match &asked.wish {
                Wish::Values(values) => widened(self.program, asked.expr, values)?,
                Wish::Float => "~1".to_owned(),
            };
            let from = self.program.words(asked.expr.span).to_owned();
            let edit = self.program.edit(asked.expr.span, to.clone());
            Some((edit, Change::Widened { what: asked.what.clone(), from, to }))
        });
        granted.collect::<Option<Vec<(Edit, Change)>>>().map(|list| list.into_iter().unzip())
    }
}

fn literal(expr: &Expr) -> Option<f64> {
    match expr.kind {
        ExprKind::Number(value) => Some(value),
        _ => None,
    }
}

/// Whether an expression comes to a value already; `None` where it is none that can be widened.
fn covers(expr: &Expr, value: f64) -> Option<bool> {
    match &expr.kind {
        ExprKind::Number(own) => (own.fract() == 0.0).then_some(*own == value),
        ExprKind::Call(_, ends) => {
            let (low, high) = (literal(ends.first()?)?, literal(ends.get(1)?)?);
            (low <= high).then_some(low <= value && value <= high)
        }
        ExprKind::Pick(parts) => Some(parts.iter().any(|(_, known)| literal(known) == Some(value))),
        _ => None,
    }
}

/// What an operand has to be for the result of an operation, given the one on its right.
fn undone_left(op: BinaryOp, result: f64, right: f64) -> Option<f64> {
    match op {
        BinaryOp::Add => Some(result - right),
        BinaryOp::Subtract => Some(result + right),
        BinaryOp::Multiply => Some(result / right),
        BinaryOp::Divide => Some(result * right),
        _ => None,
    }
}

/// The same, given the one on its left.
fn undone_right(op: BinaryOp, result: f64, left: f64) -> Option<f64> {
    match op {
        BinaryOp::Add => Some(result - left),
        BinaryOp::Subtract => Some(left - result),
        BinaryOp::Multiply => Some(result / left),
        BinaryOp::Divide => Some(left / result),
        _ => None,
    }
}

/// The words for an expression that may come to these values as well.
fn widened(program: &Program, expr: &Expr, values: &BTreeSet<i32>) -> Option<String> {
    let (least, most) = (f64::from(*values.first()?), f64::from(*values.last()?));
    match &expr.kind {
        ExprKind::Number(own) => {
            let mut all = values.clone();
            all.insert(*own as i32);
            Some(one_of(&all))
        }
        ExprKind::Call(function, ends) => {
            let (low, high) = (literal(ends.first()?)?, literal(ends.get(1)?)?);
            Some(format!("{}({}, {})", function.name(), low.min(least), high.max(most)))
        }
        ExprKind::Pick(_) => {
            let words = program.words(expr.span).trim_end().strip_suffix('}')?.trim_end();
            let more: String = values.iter().map(|value| format!(" | 1 : {value}")).collect();
            Some(format!("{words}{more} }}"))
        }
        _ => None,
    }
}

/// One of some numbers: a range where they follow one another.
fn one_of(values: &BTreeSet<i32>) -> String {
    let (low, high) = (values.first().copied().unwrap_or(0), values.last().copied().unwrap_or(0));
    match high - low == values.len() as i32 - 1 {
        true => format!("randint({low}, {high})"),
        false => {
            let parts: Vec<String> = values.iter().map(|value| format!("1 : {value}")).collect();
            format!("pick{{ {} }}", parts.join(" | "))
        }
    }
}
