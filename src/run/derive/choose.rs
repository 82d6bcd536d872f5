//! Which of the rules of a label applies.

use super::{Derivation, Few, Step, Task};
use crate::graph::{Alternative, Arg, Expr, NodeIndex};
use crate::run::error::Kind;
use crate::run::eval::Around;
use crate::run::start::weighted;
use std::rc::Rc;

impl<'g> Derivation<'_, '_, '_, 'g> {
    /// Tries the rules of a label level by level.
    pub(super) fn choose(&mut self, task: &Task<'g>) -> Step {
        let mut level = self.next_level(task.node, None);
        while let Some(at) = level {
            if self.choose_at(task, at)? {
                return Ok(());
            }
            level = self.next_level(task.node, level);
        }
        Err(task.no_rule())
    }

    /// The first priority that a rule of a label has, after one.
    pub fn next_level(&self, node: NodeIndex, after: Option<u32>) -> Option<u32> {
        let levels = self.alternatives(node).map(|(_, alternative, _)| alternative.priority);
        levels.filter(|at| Some(*at) > after).min()
    }

    pub(super) fn alternatives(
        &self,
        node: NodeIndex,
    ) -> impl Iterator<Item = (usize, &'g Alternative, NodeIndex)> + use<'g> {
        let children = self.graph.children(node).enumerate();
        children.filter_map(|(number, (arg, child))| match arg {
            Arg::Alternative(alternative) => Some((number, alternative, child)),
            _ => None,
        })
    }

    /// Draws one of the rules of that priority whose conditions hold, if any does.
    pub fn choose_at(&mut self, task: &Task<'g>, level: u32) -> Result<bool, Kind> {
        let mut env = self.env(task);
        let (mut weights, mut open) = (Few::new(), Few::new());
        for (number, alternative, child) in self.alternatives(task.node) {
            if alternative.priority == level
                && alternative.condition.as_ref().map_or(Ok(true), |condition| env.truth(condition))?
            {
                weights.push(env.number(&alternative.weight)?);
                open.push((number, child));
            }
        }
        if open.is_empty() {
            return Ok(false);
        }
        let draw = if open.len() > 1 { env.draw() } else { 0.0 };
        let (number, child) = open[weighted(&weights, draw)?];
        self.push(task, task.child(number, child, *task.scope()));
        Ok(true)
    }

    pub(super) fn call(&mut self, task: &Task<'g>, args: &'g [Expr]) -> Step {
        let mut env = self.env(task);
        let mut params = Few::new();
        for arg in args {
            params.push(env.value(arg)?);
        }
        self.around(task, Around { params: Rc::from(params.as_slice()), ..(*task.around).clone() })
    }
}
