//! The rules that were found, before they are an op graph.

use super::boxes::Boxes;
use super::corpus::{Class, Corpus};
use super::dependence;
use super::estimate::{SLOPE, choice};
use super::laws::{Law, Seen, integer};
use super::recolour::{ARGUMENT, CALL};
use super::rows::Row;
use super::slopes::Slope;
use crate::space::Axis;
use rustc_hash::FxHashMap;
use smallvec::SmallVec;
use std::collections::BTreeMap;

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct NodeId(pub u32);

/// One operation for all boxes that a node stands for.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Form {
    Fill(u32),
    Split {
        axis: Axis,
        parts: Vec<(Law, NodeId)>,
    },
    /// Units of about one length fill the box.
    Repeat {
        axis: Axis,
        unit: i32,
        child: NodeId,
    },
    Choose(Vec<NodeId>),
    /// Cells of a row, by kind.
    Row {
        row: Row,
        cells: Vec<NodeId>,
    },
    /// Courses that get narrower, and what is left behind the last of them.
    Slope {
        slope: Slope,
        course: NodeId,
        end: NodeId,
    },
    /// The child with arguments for its parameters.
    Call {
        parameters: Vec<u32>,
        arguments: Vec<u32>,
        child: NodeId,
    },
}

impl Form {
    /// The nodes that it leads to, in order.
    fn children(&self) -> Vec<NodeId> {
        match self {
            Form::Fill(_) => Vec::new(),
            Form::Split { parts, .. } => parts.iter().map(|(_, child)| *child).collect(),
            Form::Repeat { child, .. } | Form::Call { child, .. } => vec![*child],
            Form::Slope { course, end, .. } => vec![*course, *end],
            Form::Row { cells: children, .. } | Form::Choose(children) => children.clone(),
        }
    }

    /// The same nodes, to be replaced.
    pub fn children_mut(&mut self) -> Vec<&mut NodeId> {
        match self {
            Form::Fill(_) => Vec::new(),
            Form::Split { parts, .. } => parts.iter_mut().map(|(_, child)| child).collect(),
            Form::Repeat { child, .. } | Form::Call { child, .. } => vec![child],
            Form::Slope { course, end, .. } => vec![course, end],
            Form::Row { cells: children, .. } | Form::Choose(children) => children.iter_mut().collect(),
        }
    }
}

/// How a node describes the boxes of one class.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum How {
    Fill,
    /// Where the parts start, from the second one on.
    Split(SmallVec<[i32; 4]>),
    Repeat,
    Row,
    Slope,
    /// The number of the alternative.
    Choose(usize),
    /// The class with parameters.
    Call(Class),
}

#[derive(Clone, Debug)]
pub struct Node {
    pub form: Form,
    /// By class, all that it was made for.
    pub how: FxHashMap<Class, How>,
}

/// Nodes by their form: what is equal is one node.
#[derive(Default, Debug)]
pub struct Plan {
    nodes: Vec<Node>,
    known: FxHashMap<Form, NodeId>,
}

impl Plan {
    pub fn node(&self, id: NodeId) -> &Node {
        &self.nodes[id.0 as usize]
    }

    /// The node of that form, which now describes these classes too.
    pub fn add(&mut self, form: Form, how: impl IntoIterator<Item = (Class, How)>) -> NodeId {
        let next = NodeId(self.nodes.len() as u32);
        let id = *self.known.entry(form.clone()).or_insert(next);
        if id == next {
            self.nodes.push(Node { form, how: FxHashMap::default() });
        }
        self.nodes[id.0 as usize].how.extend(how);
        id
    }

    /// The choice between nodes, one for each class; the only one if they are the same.
    pub fn choose(&mut self, of: Vec<(Class, NodeId)>) -> NodeId {
        let mut distinct: Vec<NodeId> = Vec::new();
        let mut how = Vec::with_capacity(of.len());
        for (class, child) in of {
            let number = distinct.iter().position(|known| *known == child).unwrap_or_else(|| {
                distinct.push(child);
                distinct.len() - 1
            });
            how.push((class, How::Choose(number)));
        }
        match distinct.as_slice() {
            [only] => *only,
            _ => self.add(Form::Choose(distinct), how),
        }
    }

    /// A split of these boxes with other laws; any other node itself.
    pub fn with_laws(&mut self, id: NodeId, boxes: &Boxes, laws: Vec<Law>) -> NodeId {
        let Node { form: Form::Split { axis, parts }, how } = self.node(id) else { return id };
        let parts = laws.into_iter().zip(parts).map(|(law, (_, child))| (law, *child)).collect();
        let form = Form::Split { axis: *axis, parts };
        let how = boxes.classes().filter_map(|class| Some((class, how.get(&class)?.clone())));
        let how: Vec<(Class, How)> = how.collect();
        self.add(form, how)
    }

    pub fn children(&self, id: NodeId) -> Vec<NodeId> {
        self.node(id).form.children()
    }

    /// What `root` reaches, each once, children first.
    pub fn reachable(&self, root: NodeId) -> Vec<NodeId> {
        let mut order = Vec::new();
        let mut seen = vec![false; self.nodes.len()];
        let mut open = vec![(root, false)];
        while let Some((id, is_done)) = open.pop() {
            if is_done {
                order.push(id);
            } else if !std::mem::replace(&mut seen[id.0 as usize], true) {
                open.push((id, true));
                open.extend(self.children(id).into_iter().rev().map(|child| (child, false)));
            }
        }
        order
    }
}

/// The bits of describing `boxes` by `root`: of every operation once, and of all that is left to chance. Beyond all
/// measure where it does not describe all of them.
pub fn bits(plan: &Plan, corpus: &mut Corpus, root: NodeId, boxes: &Boxes) -> f64 {
    let all = occurrences(plan, corpus, root, boxes);
    let reference = f64::from(all.len() as u32).log2();
    let mut shapes = Shapes::default();
    let mut bits = 0.0;
    for (id, boxes) in all.iter().rev() {
        let node = plan.node(*id);
        if !describes(node, boxes) {
            return f64::INFINITY;
        }
        // A second node of a shape says its sizes only: such nodes become one where that is shorter.
        let is_new = shapes.add(plan, *id);
        let children = if is_new { plan.children(*id).len() } else { 1 };
        bits += model(&node.form, is_new) + reference * children as f64;
        bits += chance(node, corpus, boxes) + apart(plan, corpus, *id, boxes);
    }
    bits + called(plan, &all).values().map(|calls| dependence::of_calls(corpus, calls)).sum::<f64>()
}

/// Whether a node was made for all of these boxes. One that is equal to another in its form is one with it, and may cut a
/// box elsewhere: then what it leads to was made for other parts.
fn describes(node: &Node, boxes: &Boxes) -> bool {
    matches!(node.form, Form::Fill(_)) || boxes.classes().all(|class| node.how.contains_key(&class))
}

/// Nodes by their form without its sizes.
#[derive(Default)]
struct Shapes {
    known: FxHashMap<(u8, Vec<u32>), u32>,
    of: FxHashMap<NodeId, u32>,
}

impl Shapes {
    /// Whether a node, whose children were added before, is the first of its shape.
    fn add(&mut self, plan: &Plan, id: NodeId) -> bool {
        let mut children: Vec<u32> =
            plan.children(id).iter().filter_map(|child| self.of.get(child).copied()).collect();
        let kind = match &plan.node(id).form {
            Form::Fill(terminal) => {
                children.push(*terminal);
                0
            }
            Form::Split { axis, .. } => 1 + axis.index() as u8,
            Form::Repeat { axis, .. } => 4 + axis.index() as u8,
            Form::Call { arguments, .. } => {
                children.extend(arguments);
                8
            }
            Form::Slope { .. } => 9,
            Form::Row { row, .. } => 10 + row.axis.index() as u8,
            Form::Choose(_) => {
                children.sort_unstable();
                children.dedup();
                7
            }
        };
        let next = self.known.len() as u32;
        let shape = *self.known.entry((kind, children)).or_insert(next);
        self.of.insert(id, shape);
        shape == next
    }
}

/// The bits of drawing apart what goes together: the parts of a split, and units that stand side by side.
fn apart(plan: &Plan, corpus: &mut Corpus, id: NodeId, boxes: &Boxes) -> f64 {
    let mut rows = || -> Vec<(Vec<Class>, u32)> {
        let parts = |corpus: &mut Corpus, class| {
            inside(plan, corpus, id, class).into_iter().map(|(_, part)| part).collect()
        };
        boxes.iter().map(|(class, count)| (parts(corpus, class), count)).collect()
    };
    match &plan.node(id).form {
        Form::Split { axis, parts } => {
            let rows = rows();
            let drawn = parts.iter().enumerate().filter(|(_, (law, _))| law.is_drawn());
            let drawn: Vec<usize> = drawn.map(|(part, _)| part).collect();
            dependence::dependence(corpus, &rows, *axis)
                + dependence::of_lengths(corpus, &rows, *axis, &drawn)
        }
        Form::Repeat { axis, .. } => {
            let rows = rows();
            dependence::of_units(corpus, &rows, *axis)
        }
        Form::Row { row, .. } => {
            let rows = rows();
            dependence::of_cells(corpus, &rows, row.axis)
        }
        Form::Slope { slope, .. } => dependence::of_courses(corpus, boxes, slope),
        Form::Fill(_) | Form::Choose(_) | Form::Call { .. } => 0.0,
    }
}

/// What each rule is called with: by its node, the number of the materials with the classes that are made of them.
fn called(plan: &Plan, all: &[(NodeId, Boxes)]) -> BTreeMap<NodeId, Vec<(u64, Class, u32)>> {
    let mut calls: BTreeMap<NodeId, Vec<(u64, Class, u32)>> = BTreeMap::new();
    for (id, boxes) in all {
        let node = plan.node(*id);
        let Form::Call { child, .. } = &node.form else { continue };
        let handed = boxes.iter().filter_map(|(class, count)| match node.how.get(&class) {
            Some(How::Call(other)) => Some((u64::from(id.0), *other, count)),
            _ => None,
        });
        calls.entry(*child).or_default().extend(handed);
    }
    calls
}

/// The bits of what a node leaves to chance.
fn chance(node: &Node, corpus: &Corpus, boxes: &Boxes) -> f64 {
    match &node.form {
        Form::Fill(_) | Form::Repeat { .. } | Form::Slope { .. } | Form::Call { .. } => 0.0,
        Form::Split { axis, parts } => {
            let lengths = |number: usize| {
                boxes.iter().filter_map(move |(class, count)| {
                    let Some(How::Split(starts)) = node.how.get(&class) else { return None };
                    let low = number.checked_sub(1).map_or(0, |before| starts[before]);
                    let high =
                        starts.get(number).copied().unwrap_or_else(|| corpus.profile(class).len(*axis));
                    Some((high - low, count))
                })
            };
            parts.iter().enumerate().map(|(number, (law, _))| law.chance(lengths(number))).sum()
        }
        Form::Row { row, .. } => row.chance(),
        Form::Choose(children) => {
            let mut counts = vec![0; children.len()];
            for (class, count) in boxes.iter() {
                if let Some(How::Choose(number)) = node.how.get(&class) {
                    counts[*number] += count;
                }
            }
            counts.retain(|count| *count > 0);
            choice(counts.iter())
        }
    }
}

/// The bits of a form without its references; of one whose shape is known, those of its sizes.
fn model(form: &Form, is_new: bool) -> f64 {
    const KIND: f64 = 2.0;
    const AXIS: f64 = 1.6;
    let (structure, sizes) = match form {
        Form::Fill(_) => (KIND + 6.0, 0.0),
        Form::Split { parts, .. } => {
            (KIND + AXIS + integer(parts.len() as i32), parts.iter().map(|(law, _)| law.bits()).sum())
        }
        Form::Repeat { unit, .. } => (KIND + AXIS, integer(*unit)),
        Form::Row { row, .. } => (KIND + AXIS + row.model(), 0.0),
        Form::Slope { slope, .. } => (SLOPE, slope.ends().map(|(_, most)| integer(most)).sum()),
        Form::Call { arguments, .. } => (CALL + ARGUMENT * arguments.len() as f64, 0.0),
        Form::Choose(children) => (KIND + integer(children.len() as i32) + 3.0 * children.len() as f64, 0.0),
    };
    if is_new { structure + sizes } else { KIND + sizes }
}

/// Every box that each node stands for, from the boxes of the root on. A node comes after all that lead to it.
pub fn occurrences(plan: &Plan, corpus: &mut Corpus, root: NodeId, boxes: &Boxes) -> Vec<(NodeId, Boxes)> {
    let mut found: FxHashMap<NodeId, Vec<(Class, u32)>> = FxHashMap::default();
    found.insert(root, boxes.iter().collect());
    let mut order = plan.reachable(root);
    order.reverse();
    let mut all = Vec::with_capacity(order.len());
    for id in order {
        // An alternative that was made for other boxes may be taken by none of these.
        let Some(boxes) = found.remove(&id).map(Boxes::of) else { continue };
        for (class, count) in boxes.iter() {
            for (child, part) in inside(plan, corpus, id, class) {
                found.entry(child).or_default().push((part, count));
            }
        }
        all.push((id, boxes));
    }
    all
}

/// The alternatives of a choice that some of its boxes take, with those boxes.
pub fn alternatives(plan: &Plan, id: NodeId, boxes: &Boxes) -> Option<Vec<(NodeId, Boxes)>> {
    let node = plan.node(id);
    let Form::Choose(children) = &node.form else { return None };
    let mut groups: Vec<Vec<(Class, u32)>> = vec![Vec::new(); children.len()];
    for (class, count) in boxes.iter() {
        if let Some(How::Choose(number)) = node.how.get(&class) {
            groups[*number].push((class, count));
        }
    }
    let taken = children.iter().zip(groups).filter(|(_, group)| !group.is_empty());
    Some(taken.map(|(child, group)| (*child, Boxes::of(group))).collect())
}

/// How long the parts of a box of that class under a split are; nothing for any other box.
pub fn lengths(plan: &Plan, corpus: &Corpus, id: NodeId, class: Class) -> Vec<i32> {
    let node = plan.node(id);
    let (Form::Split { axis, .. }, Some(How::Split(starts))) = (&node.form, node.how.get(&class)) else {
        return Vec::new();
    };
    spans(starts, corpus.profile(class).len(*axis)).map(|(low, high)| high - low).collect()
}

/// Where parts start and end in a box of that length, of which these are the starts from the second one on.
pub fn spans(starts: &[i32], len: i32) -> impl Iterator<Item = (i32, i32)> {
    let low = std::iter::once(0).chain(starts.iter().copied());
    low.zip(starts.iter().copied().chain([len]))
}

/// The lengths of the parts of boxes under a split.
pub fn seen(plan: &Plan, corpus: &Corpus, id: NodeId, boxes: &Boxes) -> Vec<Seen> {
    boxes.iter().map(|(class, count)| (lengths(plan, corpus, id, class), count)).collect()
}

/// The parts of a box of that class under a node, each with the node that describes it.
pub fn inside(plan: &Plan, corpus: &mut Corpus, id: NodeId, class: Class) -> Vec<(NodeId, Class)> {
    let node = plan.node(id);
    match (&node.form, node.how.get(&class)) {
        (Form::Split { axis, parts }, Some(How::Split(starts))) => {
            let len = corpus.profile(class).len(*axis);
            let part = |((_, child), (low, high)): (&(Law, NodeId), (i32, i32))| {
                (*child, corpus.part(class, *axis, low, high))
            };
            parts.iter().zip(spans(starts, len)).map(part).collect()
        }
        (Form::Repeat { axis, unit, child }, Some(How::Repeat)) => {
            let len = corpus.profile(class).len(*axis);
            let starts = (0..len).step_by(*unit as usize);
            starts.map(|at| (*child, corpus.part(class, *axis, at, at + unit))).collect()
        }
        (Form::Row { row, cells }, Some(How::Row)) => {
            let classes = corpus.row(class, row.axis);
            let cell = |class: &Class| Some((cells[row.kind(corpus.terminal(*class))?], *class));
            classes.iter().filter_map(cell).collect()
        }
        (Form::Slope { slope, course, end }, Some(How::Slope)) => {
            let courses = slope.courses_of(corpus, class).into_iter().map(|part| (*course, part));
            let last = slope.end_of(corpus, class);
            courses.chain([(*end, last)]).collect()
        }
        (Form::Call { child, .. }, Some(How::Call(class))) => vec![(*child, *class)],
        (Form::Choose(children), Some(How::Choose(number))) => vec![(children[*number], class)],
        _ => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::super::corpus::Place;
    use super::super::volume::Volume;
    use super::*;
    use ndarray::Array3;

    #[test]
    fn what_does_not_describe_all_boxes_is_never_shorter() {
        let row = Volume::new(Array3::from_shape_vec((1, 1, 3), vec![1, 1, 2]).unwrap_or_default(), &[]);
        let mut corpus = Corpus::new(vec![row], 0);
        let places: Vec<Place> = corpus.examples();
        let boxes = Boxes::of(places.into_iter().map(|place| (corpus.class(place), 1)));
        let mut plan = Plan::default();
        let [stone, wood] = [1, 2].map(|terminal| plan.add(Form::Fill(terminal), []));
        let split =
            || Form::Split { axis: Axis::X, parts: vec![(Law::Float(1), stone), (Law::Const(1), wood)] };
        let root = plan.add(split(), []);
        assert_eq!(bits(&plan, &mut corpus, root, &boxes), f64::INFINITY);
        plan.add(split(), [(boxes.first(), How::Split(SmallVec::from_slice(&[2])))]);
        assert!(bits(&plan, &mut corpus, root, &boxes) < f64::INFINITY);
    }
}
