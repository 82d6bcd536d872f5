//! Operations before they are a graph.

use super::role::RoleId;
use crate::graph::{Expr, Size};
use crate::space::Axis;

#[derive(Clone, PartialEq, Debug)]
pub enum Sketch {
    Nil,
    Leaf(u32),
    Role(RoleId),
    /// What is left of a list of a role.
    Rest(RoleId, Axis),
    Split {
        axis: Axis,
        parts: Vec<(Size, Sketch)>,
    },
    /// Equal shares of about that size.
    Repeat {
        axis: Axis,
        size: Expr,
        unit: Box<Sketch>,
    },
    /// So many equal shares.
    Times {
        axis: Axis,
        count: Expr,
        unit: Box<Sketch>,
    },
    /// Parameters that are drawn for what is inside.
    Call(Vec<Expr>, Box<Sketch>),
}

/// One of the rules of a role.
#[derive(Clone, Debug)]
pub struct Way {
    /// A condition of the scope; `None` where it always holds.
    pub condition: Option<Expr>,
    /// How often it was seen.
    pub weight: u32,
    pub order: Order,
    pub sketch: Sketch,
}

/// When an alternative is tried.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Order {
    First,
    /// Where the conditions of no other hold.
    Last,
}

/// A split along an axis; parts of one come to what they are.
pub fn split(axis: Axis, parts: Vec<(Size, Sketch)>) -> Sketch {
    match <[(Size, Sketch); 1]>::try_from(parts) {
        Ok([(_, only)]) => only,
        Err(parts) => Sketch::Split { axis, parts },
    }
}
