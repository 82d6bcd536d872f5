//! Which lengths the rules of a plan can fill.

use super::laws::Law;
use super::plan::{Form, NodeId, Plan};
use super::slopes::Slope;
use crate::space::Axis;
use rustc_hash::FxHashMap;

/// A set of lengths. Those from 127 on are not told apart: all of them are in.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Lengths(u128);

impl Lengths {
    pub const LONGEST: i32 = 127;
    pub const ALL: Lengths = Lengths(!1);
    pub const NONE: Lengths = Lengths(0);

    pub fn of(lengths: impl IntoIterator<Item = i32>) -> Lengths {
        Lengths(lengths.into_iter().fold(0, |bits, len| bits | 1 << len.clamp(0, Self::LONGEST)))
    }

    pub fn contains(self, len: i32) -> bool {
        len >= Self::LONGEST || (len >= 0 && self.0 >> len & 1 == 1)
    }

    pub fn iter(self) -> impl Iterator<Item = i32> {
        (0..=Self::LONGEST).filter(move |len| self.0 >> len & 1 == 1)
    }

    /// The sums of one length of each.
    pub fn plus(self, other: Lengths) -> Lengths {
        let sums = self.iter().flat_map(|len| other.iter().map(move |more| len + more));
        Lengths::of(sums.filter(|len| *len <= Self::LONGEST))
    }

    pub fn and(self, other: Lengths) -> Lengths {
        Lengths(self.0 & other.0)
    }

    pub fn or(self, other: Lengths) -> Lengths {
        Lengths(self.0 | other.0)
    }

    /// All others.
    pub fn inverse(self) -> Lengths {
        Lengths(!self.0)
    }
}

/// By node, the lengths on each axis that it can fill, the axes by themselves.
pub type Feasible = FxHashMap<NodeId, [Lengths; 3]>;

/// The lengths of all that `root` reaches.
pub fn feasible(plan: &Plan, root: NodeId) -> Feasible {
    let mut known = Feasible::default();
    for id in plan.reachable(root) {
        let lengths = Axis::ALL.map(|axis| along(plan, &known, id, axis));
        known.insert(id, lengths);
    }
    known
}

fn along(plan: &Plan, known: &Feasible, id: NodeId, along: Axis) -> Lengths {
    let of = |child: &NodeId| known[child][along.index()];
    match &plan.node(id).form {
        Form::Fill(_) | Form::Row { .. } => Lengths::ALL,
        Form::Split { axis, parts } if *axis == along => {
            let parts = parts.iter().map(|(law, child)| lengths(law).and(of(child)));
            parts.fold(Lengths::of([0]), Lengths::plus)
        }
        Form::Repeat { axis, unit, child } if *axis == along => match of(child).contains(*unit) {
            true => Lengths::of((1..=Lengths::LONGEST / unit).map(|count| count * unit)),
            false => Lengths::of([]),
        },
        Form::Split { .. } | Form::Repeat { .. } | Form::Call { .. } => {
            plan.children(id).iter().map(of).fold(Lengths::ALL, Lengths::and)
        }
        Form::Slope { slope, course, end } => sloped(slope, of(course), of(end), along),
        Form::Choose(children) => children.iter().map(of).fold(Lengths::of([]), Lengths::or),
    }
}

/// The lengths that a slope can fill: those that end, and those that leave such a one behind a course.
fn sloped(slope: &Slope, course: Lengths, end: Lengths, along: Axis) -> Lengths {
    let step = slope.peel.step(along);
    if step == 0 {
        return course.and(end);
    }
    let most = slope.ends().find(|(axis, _)| *axis == along).map(|(_, most)| most);
    let end = match (along, slope.cap) {
        (Axis::Y, Some(cap)) => Lengths::of(cap..=Lengths::LONGEST),
        _ => end,
    };
    // Where another axis ends it, it may end at any length.
    let may_end =
        |len: i32| end.contains(len) && (most.is_none_or(|most| len <= most) || slope.ends().count() > 1);
    let has_course = |len: i32| along == Axis::Y || course.contains(len);
    (1..=Lengths::LONGEST).fold(Lengths::NONE, |fills, len| {
        let goes_on =
            most.is_none_or(|most| len > most) && has_course(len) && len > step && fills.contains(len - step);
        if may_end(len) || goes_on { fills.or(Lengths::of([len])) } else { fills }
    })
}

/// The lengths that a law may give; one that goes by another part's may give any.
fn lengths(law: &Law) -> Lengths {
    match law {
        Law::Const(len) => Lengths::of([*len]),
        Law::Float(_) | Law::Same(_) => Lengths::ALL,
        Law::Range { low, high, step } => Lengths::of((*low..=*high).step_by(*step as usize)),
        Law::Table(entries) => Lengths::of(entries.iter().map(|(len, _)| *len)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_sum_to_what_their_split_can_fill() {
        let mut plan = Plan::default();
        let stone = plan.add(Form::Fill(0), []);
        let pair = plan.add(Form::Repeat { axis: Axis::X, unit: 2, child: stone }, []);
        let parts = vec![(Law::Const(1), stone), (Law::Float(1), pair)];
        let split = plan.add(Form::Split { axis: Axis::X, parts }, []);
        let [x, y, _] = feasible(&plan, split)[&split];
        assert!([3, 5, 7, 300].into_iter().all(|len| x.contains(len)));
        assert!([0, 1, 2, 4].into_iter().all(|len| !x.contains(len)));
        assert!(y.contains(1) && y.contains(100));
    }
}
