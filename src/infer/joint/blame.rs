//! What is to blame for what a sample shows and no example does, and what would prevent it.

use super::boxes::Boxes;
use super::by_length::{self, Drawn};
use super::corpus::{Class, Corpus, Place};
use super::derivation::{At, Derivation, Operation};
use super::emit::Emitted;
use super::limits::between;
use super::narrow::{self, Blamed};
use super::pairs;
use super::plan::{self, Form, NodeId, Plan};
use super::samples::{Fault, Faulty};
use crate::space::{Axis, Bounds, Cell};
use ndarray::Array3;
use rustc_hash::FxHashMap;

/// What keeps a fault from coming again.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Repair {
    /// Boxes that end so never stand before boxes that begin so.
    Tear { last: Class, first: Class, axis: Axis },
    /// What was made for these boxes stands only where a scope is as long as they.
    Limit { boxes: Boxes, axis: Axis },
}

/// What was learnt, to find out what is to blame.
pub struct Suspects<'s> {
    pub plan: &'s Plan,
    pub corpus: &'s mut Corpus,
    pub emitted: &'s Emitted,
    /// The boxes that each node of the plan was made for.
    pub made_for: &'s FxHashMap<NodeId, Vec<Boxes>>,
}

/// The repairs of one fault.
#[derive(Default, Debug)]
pub struct Repairs {
    /// The mildest first; those of equal mildness stand together.
    pub mild: Vec<Vec<Repair>>,
    /// What would have to be mixed with no other, if nothing else is left to do: the least first.
    pub kept: Vec<Boxes>,
}

impl Suspects<'_> {
    /// What would prevent each fault of a sample.
    pub fn repairs(&mut self, faulty: &Faulty) -> Vec<Repairs> {
        let derivation = &faulty.derivation;
        match &faulty.fault {
            Fault::Failed => {
                derivation.last().map(|at| self.of_sizes(derivation, at, &Axis::ALL)).into_iter().collect()
            }
            Fault::Unseen { cells, windows } => {
                let sample = Sample { derivation, cells };
                windows.iter().flat_map(|window| self.of_window(&sample, *window)).collect()
            }
        }
    }

    /// For each place of a fault, what the sample may have made wrong there.
    pub fn blamed(&self, faulty: &Faulty) -> Vec<Blamed> {
        let Fault::Unseen { cells, windows } = &faulty.fault else { return Vec::new() };
        let of = |window: &Bounds| Blamed {
            pairs: pairs::unseen(self.plan, self.corpus, self.emitted, (&faulty.derivation, cells), *window),
            choices: narrow::taken(self.plan, self.emitted, &faulty.derivation, *window),
        };
        windows.iter().map(of).collect()
    }

    /// Where two parts meet whose ends were seen there, but never together, they are torn apart. An end that was not
    /// seen there has its cause within its part.
    fn of_window(&mut self, sample: &Sample<'_>, window: Bounds) -> Vec<Repairs> {
        let inside = window.intersect(&sample.bounds());
        let Some(at) = sample.derivation.innermost(inside) else { return Vec::new() };
        let Some(meeting) = self.meeting(sample, at, window) else {
            return vec![self.of_sizes(sample.derivation, at, &Axis::ALL)];
        };
        let shown = meeting.ends.iter().map(|ends| {
            std::array::from_fn(|side| {
                shows(self.corpus, ends[side], &sample.cells(meeting.halves[side], meeting.axis))
            })
        });
        let shown: Vec<[bool; 2]> = shown.collect();
        let unseen = [0, 1].into_iter().filter(|side| !shown.iter().any(|shown| shown[*side]));
        let unseen: Vec<usize> = unseen.collect();
        if !unseen.is_empty() {
            let within = unseen.into_iter().flat_map(|side| self.of_window(sample, meeting.halves[side]));
            return within.collect();
        }
        let others: Vec<Axis> = Axis::ALL.into_iter().filter(|axis| *axis != meeting.axis).collect();
        let of_sizes = self.of_sizes(sample.derivation, at, &others);
        let torn = if shown.contains(&[true; 2]) { Vec::new() } else { torn(&meeting, &shown) };
        vec![Repairs { mild: std::iter::once(torn).chain(of_sizes.mild).collect(), ..of_sizes }]
    }

    /// The parts of an operation that meet in a window, with what meets there in all its boxes.
    fn meeting(&mut self, sample: &Sample<'_>, at: At, window: Bounds) -> Option<Meeting> {
        let touched =
            sample.derivation.children(at).filter(|part| !part.bounds.intersect(&window).is_empty());
        let [low, high] = <[Operation; 2]>::try_from(touched.collect::<Vec<Operation>>()).ok()?;
        let axis = Axis::ALL.into_iter().find(|axis| axis.of(low.bounds.max) == axis.of(high.bounds.min))?;
        let mut ends = Vec::new();
        for id in self.emitted.planned(sample.derivation, at) {
            for class in self.emitted.boxes(id).classes().collect::<Vec<Class>>() {
                if let Form::Slope { slope, .. } = &self.plan.node(id).form {
                    // Inside what is left of a box all that meets is air.
                    if axis == Axis::Y {
                        let seams = slope.seams_of(self.corpus, class);
                        ends.extend(seams.into_iter().map(|[low, high]| self.corpus.ends(low, high, axis)));
                    }
                    continue;
                }
                let parts: Vec<Class> = plan::inside(self.plan, self.corpus, id, class)
                    .into_iter()
                    .map(|(_, part)| part)
                    .collect();
                let pairs = match self.plan.node(id).form {
                    Form::Split { .. } => vec![(low.number, high.number)],
                    _ => (1..parts.len()).map(|high| (high - 1, high)).collect(),
                };
                for (low, high) in pairs {
                    if let (Some(low), Some(high)) = (parts.get(low), parts.get(high)) {
                        ends.push(self.corpus.ends(*low, *high, axis));
                    }
                }
            }
        }
        let plane = axis.of(high.bounds.min);
        let halves = [(plane - 1, plane), (plane, plane + 1)].map(|(low, high)| window.slab(axis, low, high));
        Some(Meeting { axis, halves, ends })
    }

    /// Limits of what the operation is part of, the innermost first; then what was made for the boxes of the
    /// operations around it is kept apart.
    fn of_sizes(&self, derivation: &Derivation, at: At, axes: &[Axis]) -> Repairs {
        let limits = derivation.from(at).flat_map(|at| {
            let bounds = derivation.get(at).bounds;
            let limits = axes.iter().filter_map(move |axis| {
                let boxes = self.limited(derivation, at, *axis, bounds.len(*axis))?;
                Some(vec![Repair::Limit { boxes, axis: *axis }])
            });
            limits.collect::<Vec<Vec<Repair>>>()
        });
        let kept = derivation
            .from(at)
            .flat_map(|at| self.emitted.planned(derivation, at))
            .flat_map(|id| self.made_for.get(&id).into_iter().flatten().cloned());
        Repairs { mild: limits.collect(), kept: kept.collect() }
    }

    /// The boxes that an alternative was made for, if another one is to be preferred at this length; those of all
    /// examples, if a building has a length of none of them.
    fn limited(&self, derivation: &Derivation, at: At, axis: Axis, len: i32) -> Option<Boxes> {
        let covers = |boxes: &Boxes| between(self.corpus, boxes, axis).contains(len);
        if derivation.before(at).is_none() {
            let all = self.emitted.boxes(self.emitted.root);
            let is_seen = all.classes().any(|class| self.corpus.profile(class).len(axis) == len);
            return (!is_seen).then(|| all.clone());
        }
        let (own, alternatives) = self.emitted.alternatives(self.plan, derivation, at)?;
        let is_other = !covers(&own) && alternatives.iter().any(|(_, boxes)| covers(boxes));
        is_other.then_some(own)
    }
}

/// For each place of a fault, what the sample drew there and no example draws at this length.
pub fn drawn(plan: &Plan, corpus: &Corpus, emitted: &Emitted, faulty: &Faulty) -> Vec<Vec<Drawn>> {
    let Fault::Unseen { windows, .. } = &faulty.fault else { return Vec::new() };
    let of = |window: &Bounds| by_length::drawn(plan, corpus, emitted, &faulty.derivation, *window);
    windows.iter().map(of).collect()
}

/// A sample whose cells are without what neighbours decide.
struct Sample<'s> {
    derivation: &'s Derivation,
    cells: &'s Array3<u32>,
}

impl Sample<'_> {
    fn bounds(&self) -> Bounds {
        let (y, z, x) = self.cells.dim();
        Bounds::of_size(Cell::new(x as i32, y as i32, z as i32))
    }

    /// What is in a window that is one cell thin on an axis.
    fn cells(&self, window: Bounds, thin: Axis) -> Cells {
        let all = self.bounds();
        let inside = window.intersect(&all);
        let get = |cell: Cell| self.cells[[cell.y as usize, cell.z as usize, cell.x as usize]];
        let edge = |axis: Axis| match axis {
            _ if axis == thin => Edge::None,
            _ if axis.of(window.min) < axis.of(all.min) => Edge::Low,
            _ if axis.of(window.max) > axis.of(all.max) => Edge::High,
            _ => Edge::None,
        };
        Cells {
            size: inside.size(),
            terminals: inside.cells().map(get).collect(),
            edges: Axis::ALL.map(edge),
        }
    }
}

/// A few cells.
struct Cells {
    size: Cell,
    terminals: Vec<u32>,
    /// By axis: at which end of a building they stand.
    edges: [Edge; 3],
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Edge {
    None,
    Low,
    High,
}

/// Two parts that meet in a window.
struct Meeting {
    axis: Axis,
    /// The window in either part.
    halves: [Bounds; 2],
    /// The last slice of the low part and the first of the high one, of all boxes.
    ends: Vec<[Class; 2]>,
}

/// Whether a class shows these cells somewhere.
fn shows(corpus: &Corpus, class: Class, cells: &Cells) -> bool {
    let Place { bounds, .. } = corpus.profile(class).place;
    let volume = corpus.volume(corpus.profile(class).place);
    let most = bounds.size() - cells.size;
    let starts = Axis::ALL.map(|axis| match (axis.of(most), cells.edges[axis.index()]) {
        (most, Edge::None) => (0, most),
        (most, Edge::Low) => (0, most.min(0)),
        (most, Edge::High) => (most, most),
    });
    let corner = |end: fn(&(i32, i32)) -> i32| Cell::from_array(starts.each_ref().map(end));
    let starts = Bounds::new(corner(|(low, _)| *low), corner(|(_, high)| high + 1));
    if most.min_element() < 0 {
        return false;
    }
    let is_at = |start: Cell| {
        let mut steps = Bounds::of_size(cells.size).cells().zip(&cells.terminals);
        steps.all(|(step, terminal)| volume.get(bounds.min + start + step) == *terminal)
    };
    starts.cells().any(is_at)
}

/// Every end that shows one half of the window beside every one that shows the other.
fn torn(meeting: &Meeting, shown: &[[bool; 2]]) -> Vec<Repair> {
    let side = |side: usize| {
        let own = meeting.ends.iter().zip(shown).filter(move |(_, shown)| shown[side]);
        own.map(move |(ends, _)| ends[side])
    };
    let pairs = side(0).flat_map(|last| side(1).map(move |first| (last, first)));
    let mut torn: Vec<Repair> =
        pairs.map(|(last, first)| Repair::Tear { last, first, axis: meeting.axis }).collect();
    torn.sort_unstable();
    torn.dedup();
    torn
}
