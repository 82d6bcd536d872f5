//! How the nodes of a plan take to lengths that they were not seen in.

use super::laws::{Law, Part, Stretch};
use super::plan::{Form, NodeId, Plan};
use super::slopes::End;
use crate::space::Axis;

/// The parts of a split along an axis.
pub fn parts(plan: &Plan, children: &[NodeId], along: Axis) -> Vec<Part> {
    let part = |child: &NodeId| Part { stretch: stretch(plan, *child, along), look: child.0 };
    children.iter().map(part).collect()
}

/// How a node takes to other lengths.
pub fn stretch(plan: &Plan, node: NodeId, along: Axis) -> Stretch {
    match &plan.node(node).form {
        Form::Call { child, .. } => stretch(plan, *child, along),
        Form::Fill(_) => Stretch::Alike,
        Form::Split { axis, parts } if *axis != along => {
            parts.iter().map(|(_, child)| stretch(plan, *child, along)).max().unwrap_or(Stretch::Stiff)
        }
        Form::Split { parts, .. } => {
            let floating = parts.iter().filter(|(law, _)| matches!(law, Law::Float(_)));
            let bends = floating.map(|(_, child)| stretch(plan, *child, along).max(Stretch::Bends));
            bends.min().unwrap_or(Stretch::Stiff)
        }
        Form::Row { .. } => Stretch::Bends,
        // Air above a ridge may be as high as it likes.
        Form::Slope { slope, end, .. } if along == Axis::Y => match slope.end {
            End::Run(_) if slope.cap.is_some() => Stretch::Bends,
            End::Run(_) => stretch(plan, *end, along).max(Stretch::Bends),
            End::Rise(_) => Stretch::Stiff,
        },
        Form::Slope { slope, .. } if slope.peel.step(along) > 0 => Stretch::Stiff,
        Form::Slope { course, end, .. } => stretch(plan, *course, along).max(stretch(plan, *end, along)),
        Form::Choose(children) => {
            let of = children.iter().map(|child| stretch(plan, *child, along));
            of.max().unwrap_or(Stretch::Stiff).max(Stretch::Bends)
        }
        Form::Repeat { .. } => Stretch::Stiff,
    }
}
