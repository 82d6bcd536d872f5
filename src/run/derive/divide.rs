//! Splits and repeats, and the planes that they snap to.

use super::{Derivation, Few, MOST_OPEN, NOISE, Step, Task};
use crate::grammar::ast::{SizeKind, Snap};
use crate::graph::{Arg, Expr, Group, NodeIndex, Size};
use crate::run::Overrun;
use crate::run::context::{sections, snapped};
use crate::run::error::Kind;
use crate::run::eval::Env;
use crate::run::rhythm::written_out;
use crate::space::{Axis, Length, Misfit, clip, fit, shares};

impl<'g> Derivation<'_, '_, '_, 'g> {
    pub(super) fn split(
        &mut self,
        task: &Task<'g>,
        axis: &'g Expr,
        snap: Option<&Snap>,
        groups: &'g [Group],
    ) -> Step {
        let axis = self.env(task).axis(axis)?;
        let total = task.site.scope.len(axis);
        let (mut lengths, mut children) = self.parts(task, total)?;
        if !groups.is_empty() {
            let order = written_out(&lengths, groups, total)?;
            lengths = order.iter().map(|at| lengths[*at]).collect();
            children = order.iter().map(|at| children[*at]).collect();
        }
        let bounds = self.fitted(task, axis, total, &lengths)?;
        let bounds = self.snapped(task, snap, axis, bounds)?;
        let count = children.len();
        for (number, child) in children.into_iter().enumerate().rev() {
            if bounds[number] < bounds[number + 1] {
                let part = task.site.scope.part(axis, bounds[number], bounds[number + 1]);
                self.push(task, task.share(number, count, child, part));
            }
        }
        Ok(())
    }

    pub(super) fn snapped(
        &mut self,
        task: &Task<'g>,
        snap: Option<&Snap>,
        axis: Axis,
        bounds: Vec<i32>,
    ) -> Result<Vec<i32>, Kind> {
        let planes = self.planes(task, snap, axis);
        self.work((planes.len() as u64).saturating_mul(bounds.len() as u64))?;
        Ok(if planes.is_empty() { bounds } else { snapped(&bounds, &planes) })
    }

    /// The lengths and the children of a split, as they are written.
    pub(super) fn parts(&self, task: &Task<'g>, total: i32) -> Result<(Few<Length>, Few<NodeIndex>), Kind> {
        let mut env = self.env(task);
        let (mut lengths, mut children) = (Few::new(), Few::new());
        for (arg, child) in self.graph.children(task.node) {
            if let Arg::Size(size) = arg {
                lengths.push(length(size, total, &mut env)?);
                children.push(child);
            }
        }
        Ok((lengths, children))
    }

    pub(super) fn fitted(
        &mut self,
        task: &Task<'g>,
        axis: Axis,
        total: i32,
        lengths: &[Length],
    ) -> Result<Vec<i32>, Kind> {
        fit(total, lengths).or_else(|misfit| {
            let kind = Kind::Misfit { misfit, axis: axis.to_string() };
            match (self.options.overrun, misfit) {
                (Overrun::Refuse, _) | (_, Misfit::Negative { .. }) => Err(kind),
                (Overrun::Clip, _) => {
                    self.warn(task.node, kind);
                    Ok(clip(total, lengths))
                }
            }
        })
    }

    /// Marks the planes that bound the scope along an axis.
    pub(super) fn mark(&mut self, task: &Task<'g>, axis: &'g Expr, label: Option<&str>) -> Step {
        let axis = self.env(task).axis(axis)?;
        if let Some(known) = &mut self.known {
            known.mark(task.around.local, label, task.scope(), axis);
        }
        Ok(())
    }

    /// The planes that a split or a repeat keeps to, counted from the low end of its scope.
    pub(super) fn planes(&self, task: &Task<'g>, snap: Option<&Snap>, axis: Axis) -> Vec<i32> {
        match (&self.known, snap) {
            (Some(known), Some(snap)) => {
                known.planes(task.around.local, snap.label.as_deref(), task.scope(), axis)
            }
            _ => Vec::new(),
        }
    }

    /// Repeats a size in each section that the snap planes leave, all of the scope where there are none; in each as
    /// often as it fits, rounded up (seed 1, section 4.3.4).
    pub(super) fn repeat_in_sections(
        &mut self,
        task: &Task<'g>,
        axis: &'g Expr,
        size: &'g Expr,
        snap: Option<&Snap>,
    ) -> Step {
        let mut env = self.env(task);
        let (axis, size) = (env.axis(axis)?, env.number(size)?);
        if size <= 0.0 {
            return Err(Kind::Step { what: "size", value: size });
        }
        let fits = |(low, high)| (low, high, (f64::from(high - low) / size - NOISE).ceil().max(1.0));
        let sections = sections(task.scope().len(axis), &self.planes(task, snap, axis)).into_iter().map(fits);
        self.repeat(task, axis, &sections.collect::<Few<_>>())
    }

    pub(super) fn so_often(
        &self,
        task: &Task<'g>,
        axis: &'g Expr,
        count: &'g Expr,
    ) -> Result<(Axis, f64), Kind> {
        let mut env = self.env(task);
        let (axis, count) = (env.axis(axis)?, env.number(count)?.round());
        match count >= 0.0 {
            true => Ok((axis, count)),
            false => Err(Kind::Step { what: "count", value: count }),
        }
    }

    /// Divides sections of the scope, from one place to another, so often each.
    pub(super) fn repeat(&mut self, task: &Task<'g>, axis: Axis, sections: &[(i32, i32, f64)]) -> Step {
        let graph = self.graph;
        let first = self.stack.len();
        let total: f64 = sections.iter().map(|(_, _, count)| count).sum();
        let mut number = 0;
        for &(from, to, count) in sections {
            self.make_room(to - from, count)?;
            for (_, child) in graph.children(task.node) {
                for (at, (low, high)) in
                    shares(to - from, count as u32).enumerate().filter(|(_, (low, high))| low < high)
                {
                    let part = task.scope().part(axis, from + low, from + high);
                    self.push(task, task.share(number + at, total as usize, child, part));
                }
            }
            number += count as usize;
        }
        self.stack[first..].reverse();
        Ok(())
    }

    /// Counts the shares of a length against the limits.
    pub(super) fn make_room(&mut self, length: i32, count: f64) -> Step {
        if count > self.options.limits.steps as f64 {
            return Err(Kind::TooManySteps(self.options.limits.steps));
        }
        // Shares of no length are work as well.
        self.steps += (count - f64::from(length)).max(0.0) as u64;
        if self.stack.len() as f64 + count.min(f64::from(length)) > MOST_OPEN {
            return Err(Kind::TooWide(MOST_OPEN as u64));
        }
        Ok(())
    }
}

pub(super) fn length<'g>(size: &'g Size, total: i32, env: &mut Env<'_, 'g>) -> Result<Length, Kind> {
    let value = env.number(&size.value)?;
    Ok(match size.kind {
        SizeKind::Absolute => Length::Absolute(value),
        SizeKind::Floating => Length::Floating(value),
        SizeKind::Relative => Length::Absolute(value * f64::from(total)),
    })
}
