//! The cases that conditions tell apart. A condition compares things with numbers; between two of those numbers its
//! truth cannot change, so that one try in each stretch tells all.

use crate::grammar::ast::*;
use crate::grammar::check::numbers::applied;

/// One thing that conditions compare: `scope.sx`, or the difference of two, of which only the sign matters.
#[derive(Clone, Debug)]
pub struct Variable<'g> {
    pub left: &'g Expr,
    pub right: Option<&'g Expr>,
    name: String,
    /// The numbers that it is compared with, rising.
    cuts: Vec<f64>,
}

/// The values from one number to another, or a single one.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Stretch {
    pub low: f64,
    pub high: f64,
}

impl Stretch {
    pub fn is_point(self) -> bool {
        self.low == self.high
    }

    /// A number in it.
    fn sample(self) -> f64 {
        match (self.low.is_finite(), self.high.is_finite()) {
            (true, true) => f64::midpoint(self.low, self.high),
            (true, false) => self.low + 1.0,
            (false, true) => self.high - 1.0,
            (false, false) => 0.0,
        }
    }

    fn holds_length(self) -> bool {
        let first = if self.is_point() { self.low.ceil() } else { self.low.floor() + 1.0 };
        self.high >= 0.0 && (first.max(0.0) < self.high || (self.is_point() && first == self.high))
    }
}

impl Variable<'_> {
    /// The numbers it is compared with and the stretches between them.
    pub fn stretches(&self) -> Vec<Stretch> {
        let point = |cut: &f64| Stretch { low: *cut, high: *cut };
        let mut out = vec![Stretch { low: f64::NEG_INFINITY, high: self.cuts[0] }];
        for (at, cut) in self.cuts.iter().enumerate() {
            out.push(point(cut));
            let high = self.cuts.get(at + 1).copied().unwrap_or(f64::INFINITY);
            out.push(Stretch { low: *cut, high });
        }
        // Lengths and places are whole, and none is below zero.
        let is_length =
            self.right.is_none() && matches!(self.left.kind, ExprKind::ScopeSize(_) | ExprKind::Share(_));
        out.retain(|stretch| !is_length || stretch.holds_length());
        out
    }
}

/// What some conditions compare.
pub struct Cases<'g> {
    pub variables: Vec<Variable<'g>>,
}

/// More cases than this are not tried.
const MOST: usize = 4096;

impl<'g> Cases<'g> {
    pub fn of(conditions: &[&'g Expr]) -> Cases<'g> {
        let mut cases = Cases { variables: Vec::new() };
        conditions.iter().for_each(|condition| cases.collect(condition));
        for variable in &mut cases.variables {
            variable.cuts.sort_by(f64::total_cmp);
            variable.cuts.dedup();
        }
        cases
    }

    fn collect(&mut self, condition: &'g Expr) {
        match &condition.kind {
            ExprKind::Binary(BinaryOp::And | BinaryOp::Or, left, right) => {
                self.collect(left);
                self.collect(right);
            }
            ExprKind::Unary(UnaryOp::Not, operand) => self.collect(operand),
            _ if known_number(condition).is_some() => {}
            _ => {
                let Comparison { left, right, cut, .. } = Comparison::of(condition);
                let name = name_of(left, right);
                match self.variables.iter_mut().find(|variable| variable.name == name) {
                    Some(variable) => variable.cuts.push(cut),
                    None => self.variables.push(Variable { left, right, name, cuts: vec![cut] }),
                }
            }
        }
    }

    /// Every case: a stretch for each variable; none where there are too many.
    pub fn all(&self) -> Option<Vec<Vec<Stretch>>> {
        let mut all = vec![Vec::new()];
        for variable in &self.variables {
            let stretches = variable.stretches();
            if all.len() * stretches.len() > MOST {
                return None;
            }
            let longer = |case: Vec<Stretch>| {
                stretches.iter().map(move |stretch| [case.as_slice(), &[*stretch]].concat())
            };
            all = all.into_iter().flat_map(longer).collect();
        }
        Some(all)
    }

    /// Whether a condition holds in a case.
    pub fn holds(&self, condition: &Expr, case: &[Stretch]) -> bool {
        match &condition.kind {
            ExprKind::Binary(BinaryOp::And, left, right) => self.holds(left, case) && self.holds(right, case),
            ExprKind::Binary(BinaryOp::Or, left, right) => self.holds(left, case) || self.holds(right, case),
            ExprKind::Unary(UnaryOp::Not, operand) => !self.holds(operand, case),
            _ => match known_number(condition) {
                Some(number) => number != 0.0,
                None => self.compares(&Comparison::of(condition), case),
            },
        }
    }

    fn compares(&self, comparison: &Comparison<'_>, case: &[Stretch]) -> bool {
        let name = name_of(comparison.left, comparison.right);
        let at = self.variables.iter().position(|variable| variable.name == name);
        let value = at.and_then(|at| case.get(at)).map_or(0.0, |stretch| stretch.sample());
        applied(comparison.op, value, comparison.cut) != 0.0
    }
}

/// Whether some case makes all conditions hold, as far as can be told.
pub fn can_all_hold(conditions: &[&Expr]) -> bool {
    let cases = Cases::of(conditions);
    let all_hold = |case: &Vec<Stretch>| conditions.iter().all(|condition| cases.holds(condition, case));
    cases.all().is_none_or(|all| all.iter().any(all_hold))
}

/// A condition as a comparison with a number.
struct Comparison<'g> {
    left: &'g Expr,
    right: Option<&'g Expr>,
    op: BinaryOp,
    cut: f64,
}

impl<'g> Comparison<'g> {
    fn of(condition: &'g Expr) -> Comparison<'g> {
        match &condition.kind {
            ExprKind::Binary(op, left, right) if op.is_comparison() => {
                match (known_number(left), known_number(right)) {
                    (_, Some(cut)) => Comparison { left, right: None, op: *op, cut },
                    (Some(cut), None) => Comparison { left: right, right: None, op: op.mirrored(), cut },
                    (None, None) => Comparison { left, right: Some(right), op: *op, cut: 0.0 },
                }
            }
            // A number holds where it is not zero.
            _ => Comparison { left: condition, right: None, op: BinaryOp::NotEqual, cut: 0.0 },
        }
    }
}

/// Two expressions of one name have the same value in a case: those that draw have a value of their own each time.
fn name_of(left: &Expr, right: Option<&Expr>) -> String {
    let text = match right {
        Some(right) => format!("{left} - ({right})"),
        None => left.to_string(),
    };
    match draws(left) || right.is_some_and(draws) {
        true => format!("{text} at {:p}", std::ptr::from_ref(left)),
        false => text,
    }
}

/// Whether an expression may have another value each time it is asked for.
pub fn draws(expr: &Expr) -> bool {
    let mut draws = false;
    for_each_expr(expr, &mut |part| {
        draws |= match &part.kind {
            ExprKind::Pick(_) | ExprKind::Mix(_) | ExprKind::Same(..) => true,
            ExprKind::Call(function, _) => matches!(
                function,
                Function::Rand | Function::Randint | Function::Gauss | Function::Triangular
            ),
            _ => false,
        };
    });
    draws
}

/// The value of an expression of numbers alone.
pub fn known_number(expr: &Expr) -> Option<f64> {
    match &expr.kind {
        ExprKind::Number(number) => Some(*number),
        // Words of the language, which nothing else can be called.
        ExprKind::Name(name) => match name.as_str() {
            "true" => Some(1.0),
            "false" => Some(0.0),
            "pi" => Some(std::f64::consts::PI),
            _ => None,
        },
        ExprKind::Unary(UnaryOp::Negate, operand) => known_number(operand).map(|number| -number),
        ExprKind::Unary(UnaryOp::Not, operand) => {
            known_number(operand).map(|number| f64::from(u8::from(number == 0.0)))
        }
        ExprKind::Binary(op, left, right) => Some(applied(*op, known_number(left)?, known_number(right)?)),
        _ => None,
    }
    .filter(|number| number.is_finite())
}
