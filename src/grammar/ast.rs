//! The syntax tree: what a grammar file says, faithful to its text.

use super::Span;
use crate::space::{Axis, Up};

/// A whole grammar file.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Grammar {
    /// Comment lines before a blank line at the head of the file.
    pub preamble: Vec<String>,
    pub up: Up,
    /// `data_version 3465`: the version of the game that the block states belong to.
    pub data_version: Option<i32>,
    pub sizes: Vec<StartSize>,
    pub constants: Vec<Constant>,
    pub rules: Vec<Rule>,
}

/// `size(9, 7, 12) : 2`: a size that the start scope may have, with its weight.
#[derive(Clone, PartialEq, Debug)]
pub struct StartSize {
    pub comments: Vec<String>,
    pub size: [Expr; 3],
    pub weight: Option<Expr>,
    pub span: Span,
}

/// `floor = 4`: a value that is drawn once for a whole run.
#[derive(Clone, PartialEq, Debug)]
pub struct Constant {
    pub comments: Vec<String>,
    pub name: Ident,
    pub value: Expr,
}

/// `label(params) : condition --> successor : weight`.
#[derive(Clone, PartialEq, Debug)]
pub struct Rule {
    /// The comment lines above the rule.
    pub comments: Vec<String>,
    pub label: Ident,
    pub params: Vec<Ident>,
    pub condition: Option<Expr>,
    pub successor: Successor,
    pub weight: Option<Expr>,
}

#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Ident {
    pub name: String,
    pub span: Span,
}

impl Ident {
    pub fn new(name: impl Into<String>) -> Ident {
        Ident { name: name.into(), span: Span::default() }
    }
}

/// What a rule does with its scope.
#[derive(Clone, PartialEq, Debug)]
pub struct Successor {
    pub op: Op,
    pub span: Span,
}

impl Successor {
    pub fn new(op: Op) -> Successor {
        Successor { op, span: Span::default() }
    }
}

#[derive(Clone, PartialEq, Debug)]
pub enum Op {
    /// `I(name)` or `I(shape, material)`.
    Primitive {
        name: Expr,
        material: Option<Expr>,
    },
    Nil,
    /// `label` or `label(arguments)`.
    Call {
        label: Ident,
        args: Vec<Expr>,
    },
    /// `split(axis){ size : op | ... }`.
    Split {
        axis: Expr,
        items: Vec<Item>,
    },
    /// `repeat(axis, size){ op }`.
    Repeat {
        axis: Expr,
        size: Expr,
        body: Box<Successor>,
    },
    /// `repeatN(axis, count){ op }`.
    RepeatN {
        axis: Expr,
        count: Expr,
        body: Box<Successor>,
    },
    /// `T(dx, dy, dz){ op }`.
    Translate {
        delta: [Size; 3],
        body: Box<Successor>,
    },
    /// `S(sx, sy, sz){ op }`.
    Resize {
        size: [Size; 3],
        body: Box<Successor>,
    },
    /// `R(axis, angle){ op }`.
    Rotate {
        axis: Expr,
        angle: Expr,
        body: Box<Successor>,
    },
    /// `comp(f){ face : op | ... }`.
    Comp {
        parts: Vec<(Face, Successor)>,
    },
}

/// One item of a split: a part, or a rhythm group that is repeated as often as it fits.
#[derive(Clone, PartialEq, Debug)]
#[expect(clippy::large_enum_variant, reason = "nearly every item is a part")]
pub enum Item {
    Part { size: Size, body: Successor },
    Group { items: Vec<Item>, span: Span },
}

/// A size along an axis.
#[derive(Clone, PartialEq, Debug)]
pub struct Size {
    pub kind: SizeKind,
    pub value: Expr,
}

#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum SizeKind {
    /// In blocks.
    Absolute,
    /// `~`: a share of what the absolute parts leave.
    Floating,
    /// `'`: a fraction of the scope.
    Relative,
}

/// The faces that a component split can name. `Side` is the four upright ones, `All` all six.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Face {
    Front,
    Back,
    Left,
    Right,
    Top,
    Bottom,
    Side,
    All,
}

impl Face {
    pub const NAMES: [(&'static str, Face); 8] = [
        ("front", Face::Front),
        ("back", Face::Back),
        ("left", Face::Left),
        ("right", Face::Right),
        ("top", Face::Top),
        ("bottom", Face::Bottom),
        ("side", Face::Side),
        ("all", Face::All),
    ];

    pub fn name(self) -> &'static str {
        Face::NAMES[self as usize].0
    }
}

#[derive(Clone, PartialEq, Debug)]
pub struct Expr {
    pub kind: ExprKind,
    pub span: Span,
}

impl Expr {
    pub fn new(kind: ExprKind) -> Expr {
        Expr { kind, span: Span::default() }
    }

    pub fn number(value: f64) -> Expr {
        Expr::new(ExprKind::Number(value))
    }

    pub fn name(name: impl Into<String>) -> Expr {
        Expr::new(ExprKind::Name(name.into()))
    }
}

#[derive(Clone, PartialEq, Debug)]
pub enum ExprKind {
    Number(f64),
    /// A parameter, constant, axis, block or primitive, told apart by what is in scope.
    Name(String),
    /// A block state with its namespace or properties: `oak_stairs[facing=east]`.
    Block(String),
    /// A file in quotes.
    File(String),
    /// `scope.sx` and its like.
    ScopeSize(Axis),
    Unary(UnaryOp, Box<Expr>),
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    Call(Function, Vec<Expr>),
}

#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum UnaryOp {
    Negate,
    Not,
}

#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum BinaryOp {
    Or,
    And,
    Equal,
    NotEqual,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Add,
    Subtract,
    Multiply,
    Divide,
    Remainder,
}

impl BinaryOp {
    pub const ALL: [BinaryOp; 13] = [
        BinaryOp::Or,
        BinaryOp::And,
        BinaryOp::Equal,
        BinaryOp::NotEqual,
        BinaryOp::Less,
        BinaryOp::LessEqual,
        BinaryOp::Greater,
        BinaryOp::GreaterEqual,
        BinaryOp::Add,
        BinaryOp::Subtract,
        BinaryOp::Multiply,
        BinaryOp::Divide,
        BinaryOp::Remainder,
    ];

    pub fn symbol(self) -> &'static str {
        ["or", "and", "==", "!=", "<", "<=", ">", ">=", "+", "-", "*", "/", "%"][self as usize]
    }

    /// How tightly the operator binds: a higher number binds first. `not` binds at 2, unary minus at 6.
    pub fn binding(self) -> u8 {
        [0, 1, 3, 3, 3, 3, 3, 3, 4, 4, 5, 5, 5][self as usize]
    }
}

/// The functions of expressions.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Function {
    Rand,
    Randint,
    Min,
    Max,
    Abs,
    Floor,
    Ceil,
    Round,
}

impl Function {
    pub const ALL: [Function; 8] = [
        Function::Rand,
        Function::Randint,
        Function::Min,
        Function::Max,
        Function::Abs,
        Function::Floor,
        Function::Ceil,
        Function::Round,
    ];

    pub fn name(self) -> &'static str {
        ["rand", "randint", "min", "max", "abs", "floor", "ceil", "round"][self as usize]
    }

    pub fn of_name(name: &str) -> Option<Function> {
        Function::ALL.into_iter().find(|function| function.name() == name)
    }

    /// How many arguments it takes, and how to write that.
    pub fn takes(self, count: usize) -> Result<(), &'static str> {
        match self {
            Function::Rand if count == 0 || count == 2 => Ok(()),
            Function::Rand => Err("`rand(low, high)`, or `rand` alone for a number from 0 to 1"),
            Function::Randint if count == 2 => Ok(()),
            Function::Randint => Err("`randint(low, high)`"),
            Function::Min | Function::Max if count >= 2 => Ok(()),
            Function::Min | Function::Max => Err("two numbers or more"),
            _ if count == 1 => Ok(()),
            _ => Err("one number"),
        }
    }
}
