use crate::block::{self, BlockState, Family};
use crate::grammar::ast::{BinaryOp, Function, UnaryOp};
use crate::neighbours::opened;
use crate::space::Axis;
use std::hash::{Hash, Hasher};

/// An expression with its names resolved: parameters and constants by their place.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Expr {
    Number(Number),
    Axis(Axis),
    Thing(Thing),
    /// A parameter of the rule around it.
    Param(usize),
    /// A constant of the grammar.
    Constant(usize),
    ScopeSize(Axis),
    Unary(UnaryOp, Box<Expr>),
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    Call(Function, Vec<Expr>),
}

/// What a primitive is, or is made of.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Thing {
    /// A bare name: a primitive, a block or a family of blocks.
    Name(String),
    /// A block state with its namespace or properties.
    Block(String),
    /// A schematic file.
    File(String),
}

impl Thing {
    /// The text without quotes.
    pub fn text(&self) -> &str {
        match self {
            Thing::Name(text) | Thing::Block(text) | Thing::File(text) => text,
        }
    }

    /// The block that it is, with all properties but those that its neighbours are to decide; of a family, its
    /// full block.
    pub fn block(&self) -> Option<BlockState> {
        match self {
            Thing::Name(name) => {
                let known = block::known(name).and_then(|known| BlockState::new(known.name()).ok());
                known.map(|state| opened(&state)).or_else(|| Family::of(name).map(|family| family.full))
            }
            Thing::Block(text) => text.parse().ok().map(|state| opened(&state)),
            Thing::File(_) => None,
        }
    }
}

/// A finite number that compares by value: 0 and -0 are one number.
#[derive(Clone, Copy, Debug)]
pub struct Number(pub f64);

impl Number {
    fn bits(self) -> u64 {
        (self.0 + 0.0).to_bits()
    }
}

impl PartialEq for Number {
    fn eq(&self, other: &Number) -> bool {
        self.bits() == other.bits()
    }
}

impl Eq for Number {}

impl Hash for Number {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.bits().hash(state);
    }
}

impl Expr {
    pub fn number(value: f64) -> Expr {
        // Zero has no sign: -0 + 0 is 0.
        Expr::Number(Number(value + 0.0))
    }

    pub fn name(name: impl Into<String>) -> Expr {
        Expr::Thing(Thing::Name(name.into()))
    }

    /// `randint(low, high)`, or the number itself where both are the same.
    pub fn between(low: i32, high: i32) -> Expr {
        let bound = |bound: i32| Expr::number(f64::from(bound));
        match low == high {
            true => bound(low),
            false => Expr::Call(Function::Randint, vec![bound(low), bound(high)]),
        }
    }

    /// Whether its value depends on the parameters of a rule.
    pub fn uses_params(&self) -> bool {
        match self {
            Expr::Param(_) => true,
            Expr::Unary(_, operand) => operand.uses_params(),
            Expr::Binary(_, left, right) => left.uses_params() || right.uses_params(),
            Expr::Call(_, args) => args.iter().any(Expr::uses_params),
            Expr::Number(_) | Expr::Axis(_) | Expr::Thing(_) | Expr::Constant(_) | Expr::ScopeSize(_) => {
                false
            }
        }
    }
}
