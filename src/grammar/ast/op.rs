use super::{Carving, Expr, Ident, Notes, Selector};
use crate::grammar::Span;

/// What a rule does with its scope.
#[derive(Clone, PartialEq, Debug)]
pub struct Successor {
    pub op: Op,
    pub span: Span,
    /// The comments beside it, if there are any.
    pub notes: Option<Box<Notes>>,
}

impl Successor {
    pub fn new(op: Op) -> Successor {
        Successor::at(op, Span::default())
    }

    pub fn at(op: Op, span: Span) -> Successor {
        Successor { op, span, notes: None }
    }

    /// Its comments, to add some.
    pub fn notes_mut(&mut self) -> &mut Notes {
        self.notes.get_or_insert_default()
    }
}

#[derive(Clone, PartialEq, Debug)]
pub enum Op {
    /// `I(name)` or `I(shape, material, option = value)`.
    Primitive {
        name: Expr,
        material: Option<Expr>,
        options: Vec<(Ident, Expr)>,
    },
    Nil,
    /// `label` or `label(arguments)`.
    Call {
        label: Ident,
        args: Vec<Expr>,
    },
    /// `a b c`: several operations in one scope. Where they overlap, later ones overwrite earlier ones.
    All(Vec<Successor>),
    /// `split(axis){ size : op | ... }`.
    Split {
        axis: Expr,
        snap: Option<Snap>,
        items: Vec<Item>,
    },
    /// `repeat(axis, size){ op }`.
    Repeat {
        axis: Expr,
        size: Expr,
        snap: Option<Snap>,
        body: Box<Successor>,
    },
    /// `repeatN(axis, count){ op }`.
    RepeatN {
        axis: Expr,
        count: Expr,
        body: Box<Successor>,
    },
    /// `comp(f){ front : op | ... }` and all else that carves named parts out of a scope.
    Carve {
        how: Carving,
        args: Vec<Expr>,
        parts: Vec<(Selector, Successor)>,
    },
    /// `T(dx, dy, dz){ op }` and all else that changes the scope of one operation, or what it sees.
    Within {
        change: Change,
        body: Box<Successor>,
    },
    /// `snap(axis, label)`: marks the planes that bound the scope.
    Snap {
        axis: Expr,
        label: Option<Ident>,
    },
}

/// What an operation sees differently from the one around it.
#[derive(Clone, PartialEq, Debug)]
pub enum Change {
    /// `T(dx, dy, dz)`.
    Translate([Size; 3]),
    /// `S(sx, sy, sz)`.
    Resize([Size; 3]),
    /// `R(axis, angle)`.
    Rotate { axis: Expr, angle: Expr },
    /// `local`: snap planes and coherent draws inside stay inside.
    Local,
    /// `same(key)`: draws come from the key, not from the place.
    Same(Expr),
    /// `style(name)`: constants have the values of a style.
    Style(Ident),
}

/// Which snap planes a split or a repeat heeds: those of a label, or all.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Snap {
    pub label: Option<String>,
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
