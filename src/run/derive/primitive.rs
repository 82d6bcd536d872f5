//! What is placed.

use super::{Derivation, Placement, Step, Task};
use crate::graph::{Expr, NodeIndex};
use crate::run::Overrun;
use crate::run::body::Body;
use crate::run::error::Kind;
use crate::space::Scope;
use smallvec::SmallVec;

impl<'g> Derivation<'_, '_, '_, 'g> {
    pub(super) fn primitive(
        &mut self,
        task: &Task<'g>,
        name: &'g Expr,
        material: Option<&'g Expr>,
        options: &'g [(String, Expr)],
    ) -> Step {
        let mut env = self.env(task);
        let name = env.thing(name)?;
        let material = material.map(|material| env.thing(material)).transpose()?;
        let mut values = SmallVec::new();
        for (option, value) in options {
            values.push((option.as_str(), env.value(value)?));
        }
        let scope = self.inside(task)?;
        let body = Body::within(scope, task.around.footprint.as_ref()).filter(|body| !body.scope.is_empty());
        let Some(Body { scope, footprint }) = body else { return Ok(()) };
        let placement =
            Placement { name, material, options: values, scope, footprint, trail: task.trail.clone() };
        match self.known {
            None => self.hand_on(task.node, placement),
            Some(_) => {
                self.placed = Some(placement);
                Ok(())
            }
        }
    }

    /// Hands a primitive on. A door without room is a warning: the rest of the building still stands.
    pub fn hand_on(&mut self, node: NodeIndex, placement: Placement<'g>) -> Step {
        match (self.sink)(placement) {
            Err(kind @ Kind::NoRoomForDoor) => {
                self.warn(node, kind);
                Ok(())
            }
            result => result,
        }
    }

    /// The part of a primitive's scope that lies inside the start scope. What leaves it is told only here:
    /// `T` may move a scope out that `S` then makes small enough.
    pub(super) fn inside(&mut self, task: &Task<'g>) -> Result<Scope, Kind> {
        let bounds = task.site.scope.bounds.intersect(&self.plot);
        if bounds != task.site.scope.bounds {
            match self.options.overrun {
                Overrun::Refuse => return Err(Kind::OutsidePlot),
                Overrun::Clip => self.warn(task.node, Kind::OutsidePlot),
            }
        }
        Ok(Scope { bounds, ..task.site.scope })
    }
}
