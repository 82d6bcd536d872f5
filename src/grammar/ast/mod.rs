//! The syntax tree: what a grammar file says, faithful to its text.

mod carving;
mod expr;
mod notes;
mod op;
mod visit;

use super::Span;
use crate::space::Up;
use std::collections::BTreeSet;

pub use carving::{Carving, Face, Selector};
pub use expr::{Against, BinaryOp, Expr, ExprKind, Function, Share, UnaryOp};
pub use notes::Notes;
pub use op::{Change, Item, Op, Size, SizeKind, Snap, Successor};
pub use visit::{for_each_call, for_each_child, for_each_child_mut, for_each_expr, for_each_expr_of_rule};

/// A whole grammar file.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Grammar {
    /// Comment lines before a blank line at the head of the file.
    pub preamble: Vec<String>,
    pub up: Up,
    /// `data_version 3465`: the version of the game that the block states belong to.
    pub data_version: Option<i32>,
    pub imports: Vec<Import>,
    pub sizes: Vec<StartSize>,
    pub constants: Vec<Constant>,
    pub styles: Vec<Style>,
    pub rules: Vec<Rule>,
    /// Labels whose rules come from imports: not all of them need to be used.
    pub imported: BTreeSet<String>,
    /// Comment lines at the end of the file.
    pub epilogue: Vec<String>,
}

/// `import "walls.grammar" as walls`: another file's constants and rules.
#[derive(Clone, PartialEq, Debug)]
pub struct Import {
    pub comments: Vec<String>,
    /// The comment behind it on its last line.
    pub behind: Option<String>,
    pub file: String,
    /// What its names begin with here: `walls.brick`.
    pub prefix: Option<Ident>,
    pub span: Span,
}

/// `size(9, 7, 12) : 2`: a size that the start scope may have, with its weight.
#[derive(Clone, PartialEq, Debug)]
pub struct StartSize {
    pub comments: Vec<String>,
    /// The comment behind it on its last line.
    pub behind: Option<String>,
    pub size: [Expr; 3],
    pub weight: Option<Expr>,
    pub span: Span,
}

/// `floor = 4`: a value that is drawn once for a whole run.
#[derive(Clone, PartialEq, Debug)]
pub struct Constant {
    pub comments: Vec<String>,
    /// The comment behind it on its last line.
    pub behind: Option<String>,
    pub name: Ident,
    pub value: Expr,
    /// What `attr` tells about it, if it is one that a run may set.
    pub attribute: Option<Attribute>,
}

/// `attr floors = 4 range(1, 9) group("Massing") about("storeys")`.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Attribute {
    pub range: Option<[Expr; 2]>,
    pub group: Option<String>,
    pub about: Option<String>,
}

/// `style spruce { wall = spruce_planks }`: other values for constants.
#[derive(Clone, PartialEq, Debug)]
pub struct Style {
    pub comments: Vec<String>,
    /// The comment behind it on its last line.
    pub behind: Option<String>,
    pub name: Ident,
    pub values: Vec<(Ident, Expr)>,
}

/// `label(params) : condition --> successor : weight`.
#[derive(Clone, PartialEq, Debug)]
pub struct Rule {
    /// The comment lines above.
    pub comments: Vec<String>,
    /// The comment behind it on its last line.
    pub behind: Option<String>,
    pub label: Ident,
    pub params: Vec<Ident>,
    pub condition: Option<Expr>,
    pub successor: Successor,
    pub weight: Option<Expr>,
    /// The level of detail: rules of a lower number come first.
    pub priority: u32,
}

impl Rule {
    /// The priority of rules where the file says nothing.
    pub const FIRST: u32 = 1;
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
