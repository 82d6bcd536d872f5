//! Operations that wait for their turn.

use crate::graph::NodeIndex;
use crate::run::body::Body;
use crate::run::error::Kind;
use crate::run::eval::{Around, Site};
use crate::run::place::Place;
use crate::run::trail::Trail;
use crate::space::{Axis, Bounds, Scope};
use std::rc::Rc;

/// An operation that is still to run, and where.
#[derive(Clone)]
pub struct Task<'g> {
    pub node: NodeIndex,
    pub(super) site: Site,
    pub(super) around: Rc<Around<'g>>,
    pub(super) place: Place,
    pub(super) depth: u32,
    /// Which child of the operation before it this is, and the operations that led here, if they are observed.
    pub(super) number: u32,
    pub trail: Trail,
}

impl<'g> Task<'g> {
    pub fn scope(&self) -> &Scope {
        &self.site.scope
    }

    /// The scope and what of its plan is there, if anything is.
    pub fn body(&self) -> Option<Body> {
        Body::within(self.site.scope, self.around.footprint.as_ref())
    }

    /// The same within `bounds`, if there are blocks.
    pub fn body_within(&self, bounds: Bounds) -> Option<Body> {
        let scope = Scope { bounds: self.site.scope.bounds.intersect(&bounds), ..self.site.scope };
        Body::within(scope, self.around.footprint.as_ref()).filter(|body| !body.scope.is_empty())
    }

    pub fn no_rule(&self) -> Kind {
        Kind::NoRule { scope: Axis::ALL.map(|axis| self.scope().len(axis)).into() }
    }

    /// The task of the child of that number, in `scope`.
    pub(super) fn child(&self, number: usize, node: NodeIndex, scope: Scope) -> Task<'g> {
        Task {
            node,
            site: Site { scope, ..self.site },
            around: self.around.clone(),
            place: self.place.child(number),
            depth: self.depth + 1,
            number: number as u32,
            trail: self.trail.clone(),
        }
    }

    /// As [`Task::child`], for one of the shares of a split.
    pub(super) fn share(&self, number: usize, total: usize, node: NodeIndex, scope: Scope) -> Task<'g> {
        let site = Site { scope, index: number as u32, total: total as u32 };
        Task { site, ..self.child(number, node, scope) }
    }
}
