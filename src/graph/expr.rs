use crate::block::{self, BlockState, Family};
use crate::grammar::ast::{Against, BinaryOp, Function, Share, UnaryOp};
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
    Share(Share),
    /// One of the values, by weight.
    Pick(Vec<(Expr, Expr)>),
    /// A block by weight for each cell.
    Mix(Vec<(Expr, Expr)>),
    /// Blocks that pass into one another along an axis.
    Gradient(Box<Expr>, Vec<Expr>),
    /// A block with other properties: `facing=north`.
    State(Box<Expr>, String),
    /// A value whose draws come from a key.
    Same(Box<Expr>, Box<Expr>),
    Occlusion {
        against: Against,
        distance: Option<Box<Expr>>,
    },
    Visible(String),
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
    /// A block by weight for each cell.
    Mix(Vec<(Number, Thing)>),
    /// Blocks that pass into one another along an axis of the scope.
    Gradient(Axis, Vec<Thing>),
}

impl Thing {
    /// The text without quotes; of several, that of the first.
    pub fn text(&self) -> &str {
        match self {
            Thing::Name(text) | Thing::Block(text) | Thing::File(text) => text,
            Thing::Mix(parts) => parts.first().map_or("mix", |(_, thing)| thing.text()),
            Thing::Gradient(_, parts) => parts.first().map_or("gradient", Thing::text),
        }
    }

    /// The block that it is, with all properties but those that its neighbours are to decide; of a family, its
    /// full block; of several, the first.
    pub fn block(&self) -> Option<BlockState> {
        match self {
            Thing::Name(name) => {
                let known = block::known(name).and_then(|known| BlockState::new(known.name()).ok());
                known.map(|state| opened(&state)).or_else(|| Family::of(name).map(|family| family.full))
            }
            Thing::Block(text) => text.parse().ok().map(|state| opened(&state)),
            Thing::File(_) => None,
            Thing::Mix(parts) => parts.first().and_then(|(_, thing)| thing.block()),
            Thing::Gradient(_, parts) => parts.first().and_then(Thing::block),
        }
    }

    /// The same block with other properties: `facing=north,half=top`.
    pub fn with(&self, properties: &str) -> Thing {
        match self {
            Thing::Name(name) => Thing::Block(format!("{name}[{properties}]")),
            Thing::Block(text) => Thing::Block(changed(text, properties)),
            Thing::File(name) => Thing::File(name.clone()),
            Thing::Mix(parts) => {
                Thing::Mix(parts.iter().map(|(weight, thing)| (*weight, thing.with(properties))).collect())
            }
            Thing::Gradient(axis, parts) => {
                Thing::Gradient(*axis, parts.iter().map(|thing| thing.with(properties)).collect())
            }
        }
    }
}

/// A block state's text with these properties in place of its own of the same names.
fn changed(text: &str, properties: &str) -> String {
    let (name, own) = text.split_once('[').unwrap_or((text, ""));
    let new: Vec<&str> = properties.split(',').collect();
    let key = |property: &str| property.split('=').next().unwrap_or("").to_owned();
    let kept = own
        .trim_end_matches(']')
        .split(',')
        .filter(|property| !property.is_empty() && new.iter().all(|other| key(other) != key(property)));
    let all: Vec<&str> = kept.chain(new.iter().copied()).collect();
    format!("{name}[{}]", all.join(","))
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

    pub fn binary(op: BinaryOp, left: Expr, right: Expr) -> Expr {
        Expr::Binary(op, Box::new(left), Box::new(right))
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
        let mut uses = false;
        self.for_each(&mut |part| uses |= matches!(part, Expr::Param(_)));
        uses
    }

    /// Whether it asks about other shapes.
    pub fn asks(&self) -> bool {
        let mut asks = false;
        self.for_each(&mut |part| asks |= matches!(part, Expr::Occlusion { .. } | Expr::Visible(_)));
        asks
    }

    /// Visits an expression and all its parts.
    pub fn for_each<'e>(&'e self, visit: &mut impl FnMut(&'e Expr)) {
        visit(self);
        match self {
            Expr::Unary(_, operand) | Expr::State(operand, _) => operand.for_each(visit),
            Expr::Binary(_, left, right) | Expr::Same(left, right) => {
                left.for_each(visit);
                right.for_each(visit);
            }
            Expr::Call(_, args) => args.iter().for_each(|arg| arg.for_each(visit)),
            Expr::Pick(parts) | Expr::Mix(parts) => parts.iter().for_each(|(weight, value)| {
                weight.for_each(visit);
                value.for_each(visit);
            }),
            Expr::Gradient(axis, blocks) => {
                axis.for_each(visit);
                blocks.iter().for_each(|block| block.for_each(visit));
            }
            Expr::Occlusion { distance, .. } => distance.iter().for_each(|distance| distance.for_each(visit)),
            Expr::Number(_)
            | Expr::Axis(_)
            | Expr::Thing(_)
            | Expr::Param(_)
            | Expr::Constant(_)
            | Expr::ScopeSize(_)
            | Expr::Share(_)
            | Expr::Visible(_) => {}
        }
    }
}
