//! Operations that change the scope of another, or carve parts out of it.

use super::divide::length;
use super::{Derivation, FAR, Few, NOISE, Step, Task};
use crate::grammar::ast::Carving;
use crate::graph::{Arg, Expr, Size};
use crate::run::body::Body;
use crate::run::carve::{Part, carve};
use crate::run::error::Kind;
use crate::run::eval::{Around, Site};
use crate::space::{Axis, Bounds, Cell, Length, Scope, Spot, Turn};
use glam::Vec3Swizzles;
use std::rc::Rc;

impl<'g> Derivation<'_, '_, '_, 'g> {
    /// Runs the only child in the scope moved along its axes, and what is there of it moved with it.
    pub(super) fn moved(&mut self, task: &Task<'g>, delta: Cell) -> Step {
        let scope = within_reach(task.scope().moved(delta))?;
        let shift = scope.bounds.min.xz() - task.scope().bounds.min.xz();
        match &task.around.footprint {
            Some(footprint) if shift != Spot::ZERO => {
                let footprint = Some(Rc::new(footprint.moved(shift)));
                let task = Task { site: Site { scope, ..task.site }, ..task.clone() };
                self.around(&task, Around { footprint, ..(*task.around).clone() })
            }
            _ => self.only(task, scope),
        }
    }

    /// Runs the only child in `scope`.
    pub(super) fn only(&mut self, task: &Task<'g>, scope: Scope) -> Step {
        let scope = within_reach(scope)?;
        let graph = self.graph;
        for (_, child) in graph.children(task.node) {
            self.push(task, task.child(0, child, scope));
        }
        Ok(())
    }

    pub(super) fn turn(&self, task: &Task<'g>, axis: &'g Expr, angle: &'g Expr) -> Result<Turn, Kind> {
        let mut env = self.env(task);
        let (axis, angle) = (env.axis(axis)?, env.number(angle)?);
        match axis == self.graph.up.axis() {
            true => quarter_turns(angle),
            false => Err(Kind::NotVertical { up: self.graph.up.to_string() }),
        }
    }

    /// Three lengths of an operation, rounded to whole blocks.
    pub(super) fn lengths(&self, task: &Task<'g>, sizes: &'g [Size; 3]) -> Result<Cell, Kind> {
        let mut env = self.env(task);
        let mut lengths = Cell::ZERO;
        for (axis, size) in Axis::ALL.into_iter().zip(sizes) {
            let (Length::Absolute(size) | Length::Floating(size)) =
                length(size, task.site.scope.len(axis), &mut env)?;
            lengths[axis.index()] = (size + 0.5).floor().clamp(-f64::from(FAR), f64::from(FAR)) as i32;
        }
        Ok(lengths)
    }

    pub(super) fn carve(&mut self, task: &Task<'g>, how: Carving, args: &'g [Expr]) -> Step {
        let lengths = self.widths(task, how, args)?;
        let Some(body) = task.body() else { return Ok(()) };
        let parts = self.graph.children(task.node).filter_map(|(arg, child)| match arg {
            Arg::Part(selector) => Some((selector, child)),
            _ => None,
        });
        let carved = carve(how, &lengths, &body, &parts.collect::<Few<_>>());
        for Part { number, child, body } in carved.into_iter().rev() {
            let Body { scope, footprint } = body;
            let part = task.child(number, child, scope);
            let around = match footprint.is_some() || task.around.footprint.is_some() {
                true => Rc::new(Around { footprint, ..(*task.around).clone() }),
                false => task.around.clone(),
            };
            self.stack.push(Task { around, ..part });
        }
        Ok(())
    }

    /// The lengths that a carving takes, rounded to whole blocks.
    pub(super) fn widths(&self, task: &Task<'g>, how: Carving, args: &'g [Expr]) -> Result<Few<i32>, Kind> {
        let mut env = self.env(task);
        let mut widths = Few::new();
        for arg in args {
            let width = (env.number(arg)? + 0.5).floor();
            if width < 0.0 {
                return Err(Kind::Width { how, width });
            }
            widths.push(width.min(f64::from(FAR)) as i32);
        }
        Ok(widths)
    }
}

/// A scope whose coordinates can be reckoned with.
fn within_reach(scope: Scope) -> Result<Scope, Kind> {
    let Bounds { min, max } = scope.bounds;
    match min.min_element() < -FAR || max.max_element() > FAR {
        true => Err(Kind::OutsidePlot),
        false => Ok(scope),
    }
}

/// A multiple of a quarter turn in radians, or of 90 in degrees: no number but 0 is both.
pub fn quarter_turns(angle: f64) -> Result<Turn, Kind> {
    let near = |quarters: f64| (quarters - quarters.round()).abs() < NOISE;
    let radians = angle / std::f64::consts::FRAC_PI_2;
    let degrees = angle / 90.0;
    let quarters =
        [radians, degrees].into_iter().find(|quarters| near(*quarters)).ok_or(Kind::Angle(angle))?;
    Ok(Turn::quarters(quarters.round().rem_euclid(4.0) as i32))
}
