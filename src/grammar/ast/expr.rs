use crate::grammar::Span;
use crate::space::Axis;

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
    /// A block state with its namespace or properties: `oak_stairs[facing=east]`. A bare name is one that no constant
    /// hides: those of imported files do not see the constants of others.
    Block(String),
    /// A file in quotes.
    File(String),
    /// `scope.sx` and its like.
    ScopeSize(Axis),
    Unary(UnaryOp, Box<Expr>),
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    Call(Function, Vec<Expr>),
    /// `split.index` and its like.
    Share(Share),
    /// `pick{ 3 : oak | 1 : birch }`: one value, drawn by weight.
    Pick(Vec<(Expr, Expr)>),
    /// `mix{ 70 : stone | 30 : andesite }`: a block drawn by weight for each cell.
    Mix(Vec<(Expr, Expr)>),
    /// `gradient(y){ stone | diorite }`: blocks that pass into one another along an axis.
    Gradient(Box<Expr>, Vec<Expr>),
    /// `same(key, value)`: a value whose draws come from the key.
    Same(Box<Expr>, Box<Expr>),
    /// `occ(noparent, 2)`: how other shapes cover this one.
    Occlusion {
        against: Against,
        distance: Option<Box<Expr>>,
    },
    /// `visible(street)`.
    Visible(String),
}

/// Where a scope stands among its like.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Share {
    /// `split.index`: its number in the split or repeat around it, from 0.
    Index,
    /// `split.total`: how many there are.
    Total,
}

/// The shapes that an occlusion query looks at.
#[derive(Clone, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Against {
    /// Every shape that there is or was.
    All,
    /// Those that nothing has replaced yet.
    Active,
    /// All but those that this one comes from.
    NoParent,
    Label(String),
}

impl Against {
    pub fn of_name(name: &str) -> Against {
        match name {
            "all" => Against::All,
            "active" => Against::Active,
            "noparent" => Against::NoParent,
            label => Against::Label(label.to_owned()),
        }
    }

    pub fn name(&self) -> &str {
        match self {
            Against::All => "all",
            Against::Active => "active",
            Against::NoParent => "noparent",
            Against::Label(label) => label,
        }
    }
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

    pub fn is_comparison(self) -> bool {
        self.binding() == BinaryOp::Equal.binding()
    }

    /// The operator that says the same with its sides exchanged, for a comparison.
    pub fn mirrored(self) -> BinaryOp {
        match self {
            BinaryOp::Less => BinaryOp::Greater,
            BinaryOp::LessEqual => BinaryOp::GreaterEqual,
            BinaryOp::Greater => BinaryOp::Less,
            BinaryOp::GreaterEqual => BinaryOp::LessEqual,
            other => other,
        }
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
    Gauss,
    Triangular,
}

impl Function {
    pub const ALL: [Function; 10] = [
        Function::Rand,
        Function::Randint,
        Function::Min,
        Function::Max,
        Function::Abs,
        Function::Floor,
        Function::Ceil,
        Function::Round,
        Function::Gauss,
        Function::Triangular,
    ];

    pub fn name(self) -> &'static str {
        ["rand", "randint", "min", "max", "abs", "floor", "ceil", "round", "gauss", "triangular"]
            [self as usize]
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
            Function::Gauss if count == 2 => Ok(()),
            Function::Gauss => Err("`gauss(mean, deviation)`"),
            Function::Triangular if count == 3 => Ok(()),
            Function::Triangular => Err("`triangular(low, mode, high)`"),
            Function::Min | Function::Max if count >= 2 => Ok(()),
            Function::Min | Function::Max => Err("two numbers or more"),
            _ if count == 1 => Ok(()),
            _ => Err("one number"),
        }
    }
}
