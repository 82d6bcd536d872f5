//! Box splitting: the split tree of a set of labelled boxes, by the ordered-box algorithm.
//!
//! The thesis sorts the bounds of all boxes once per axis and then sweeps the axes in turn. Every box
//! points to its smallest container; a container counts its open boxes and is split wherever the count
//! returns to zero. Here the boxes of a container stand together in the three orders, sorted by their
//! low ends: the count is zero before a box that begins at or past every earlier high end, so the maxima
//! need no places of their own in the order, and a stable partition hands each child its three orders
//! still sorted. A sweep then runs over one container in consecutive memory. The time is the same:
//! n log n for the sort, and n for each level of the tree.
//!
//! Two things differ from the thesis. A container keeps the cross extents of its parent and is trimmed
//! by empty parts down to its boxes, where the thesis loses that space. And where no plane is clear of
//! boxes on any axis (a pinwheel), where the thesis does not end, the plane that cuts the fewest boxes
//! cuts them in two.

use super::tree::{NodeId, Part, Tree, TreeBuilder};
use crate::space::{Axis, Bounds};
use std::ops::Range;

/// Why boxes have no split tree. Boxes go by their index.
#[derive(Clone, Copy, PartialEq, Eq, Debug, thiserror::Error)]
pub enum BadBoxes {
    #[error("box {0} holds no cells")]
    Empty(usize),
    #[error("box {0} is not inside the container")]
    Outside(usize),
    #[error("boxes {0} and {1} overlap")]
    Overlap(usize, usize),
    #[error("the container is longer than 2,147,483,647 cells")]
    Container,
    #[error("{0} boxes are too many")]
    TooMany(usize),
}

/// The order in which the axes take turns; the first divides the whole.
pub type Turns = [Axis; 3];

/// Houses come apart into storeys first.
pub const UPRIGHT_FIRST: Turns = [Axis::Y, Axis::X, Axis::Z];

/// Plots come apart into buildings first, as in seed 1.
pub const PLAN_FIRST: Turns = [Axis::X, Axis::Z, Axis::Y];

/// The split tree of `boxes`, each with its label, in `container`; what they leave free is nil.
///
/// Splits at every plane that is clear of boxes, on one axis after the other, as `turns` has them. A container without such a
/// plane is cut where the fewest boxes are cut, of equal ones where the two sides hold the most equal
/// numbers of boxes, then on y before x before z, then at the low end; a cut box becomes two leaves of
/// its label. The order of the boxes does not matter.
pub fn split_boxes(container: Bounds, boxes: &[(Bounds, u32)], turns: Turns) -> Result<Tree, BadBoxes> {
    split_boxes_by(container, boxes, turns, Succession::InTurn)
}

/// Which axis is tried first inside of a split.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Succession {
    /// The one after that of the split, as in seed 1.
    InTurn,
    /// The first of all.
    Afresh,
}

/// As [`split_boxes`], with another succession of the axes.
pub fn split_boxes_by(
    container: Bounds,
    boxes: &[(Bounds, u32)],
    turns: Turns,
    succession: Succession,
) -> Result<Tree, BadBoxes> {
    check(container, boxes)?;
    let mut tree = TreeBuilder::new();
    let root = match boxes {
        [] => tree.nil(),
        _ => Splitter::new(boxes, (turns, succession), &mut tree).run(container)?,
    };
    Ok(tree.finish(root))
}

fn check(container: Bounds, boxes: &[(Bounds, u32)]) -> Result<(), BadBoxes> {
    let overlong = |axis: Axis| axis.of(container.max).checked_sub(axis.of(container.min)).is_none();
    if Axis::ALL.into_iter().any(overlong) {
        return Err(BadBoxes::Container);
    }
    u32::try_from(boxes.len()).map_err(|_| BadBoxes::TooMany(boxes.len()))?;
    for (i, (bounds, _)) in boxes.iter().enumerate() {
        if bounds.min.cmpge(bounds.max).any() {
            return Err(BadBoxes::Empty(i));
        }
        if !container.contains_box(bounds) {
            return Err(BadBoxes::Outside(i));
        }
    }
    Ok(())
}

/// A box, or what cuts have left of one. Pieces go by their number.
#[derive(Clone, Copy)]
struct Piece {
    /// The index of the box in the input.
    index: u32,
    label: u32,
}

/// The extent of one piece along one axis.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
struct Span {
    low: i32,
    high: i32,
    /// The number of the piece.
    id: u32,
}

/// Neighbours in an order that no plane divides: the boxes of one part of a split.
#[derive(Clone, Copy, Debug)]
struct Group {
    /// The place of its first span.
    start: usize,
    low: i32,
    high: i32,
}

/// Where a container of several boxes is divided.
enum Division {
    /// At every clear plane of this axis.
    Clear(Axis),
    /// At one plane, through boxes.
    Through(Plane),
}

/// The plane across `axis` below the cells at `at`.
#[derive(Clone, Copy)]
struct Plane {
    axis: Axis,
    at: i32,
}

/// Which sides of a plane a piece lies on.
#[derive(Clone, Copy)]
enum Side {
    Below,
    Above,
    /// The number of the piece that its upper half becomes.
    Both(u32),
}

/// Work to do, on a stack. The last part of a split is done first: its boxes then stand at the end of
/// the orders, where cut boxes have room to become more.
enum Task {
    /// An empty part of this length.
    Nil(i32),
    /// The container of the boxes from `start` to the end of the orders.
    Container { start: usize, place: Place, settled: Option<Axis> },
    /// The split whose parts were collected from `first` on is complete. It is `len` long in its parent.
    Close { axis: Axis, first: usize, len: i32 },
}

/// A box that is one part of a split along `axis`.
#[derive(Clone, Copy)]
struct Place {
    cell: Bounds,
    axis: Axis,
}

impl Place {
    fn len(&self) -> i32 {
        self.cell.len(self.axis)
    }
}

struct Splitter<'a> {
    tree: &'a mut TreeBuilder,
    turns: Turns,
    succession: Succession,
    pieces: Vec<Piece>,
    /// By axis: the spans of all containers still to do, one container after the other, by low end.
    orders: [Vec<Span>; 3],
    tasks: Vec<Task>,
    /// The parts of all open splits, from the high end.
    parts: Vec<Part>,
    groups: Vec<Group>,
    /// By piece: which part of the split at hand it goes to.
    part_of: Vec<u32>,
    /// By piece: where it lies from the cut at hand.
    sides: Vec<Side>,
    cursors: Vec<usize>,
    scratch: Vec<Span>,
}

impl<'a> Splitter<'a> {
    fn new(
        boxes: &[(Bounds, u32)],
        (turns, succession): (Turns, Succession),
        tree: &'a mut TreeBuilder,
    ) -> Splitter<'a> {
        let pieces = numbered_along_x(boxes);
        Splitter {
            tree,
            turns,
            succession,
            orders: Axis::ALL.map(|axis| sorted_spans(boxes, &pieces, axis)),
            part_of: vec![0; pieces.len()],
            pieces,
            tasks: Vec::new(),
            parts: Vec::new(),
            groups: Vec::new(),
            sides: Vec::new(),
            cursors: Vec::new(),
            scratch: Vec::new(),
        }
    }

    /// Everything is a part of some split, the whole as well: of one with a single part, which falls away.
    fn run(mut self, container: Bounds) -> Result<NodeId, BadBoxes> {
        let place = Place { cell: container, axis: self.turns[2] };
        self.tasks.push(Task::Close { axis: place.axis, first: 0, len: place.len() });
        self.tasks.push(Task::Container { start: 0, place, settled: None });
        while let Some(task) = self.tasks.pop() {
            match task {
                Task::Nil(len) => self.nil(len),
                Task::Container { start, place, settled } => self.container(start, place, settled)?,
                Task::Close { axis, first, len } => self.close(axis, first, len),
            }
        }
        Ok(self.parts[0].child)
    }

    fn nil(&mut self, len: i32) {
        if len > 0 {
            self.parts.push(Part { len, child: self.tree.nil() });
        }
    }

    fn close(&mut self, axis: Axis, first: usize, len: i32) {
        let child = self.tree.split(axis, self.parts.drain(first..).rev());
        self.parts.push(Part { len, child });
    }

    /// Divides the container, or makes a leaf of its last box. `settled` is an axis already known to have
    /// no clear plane.
    fn container(&mut self, start: usize, place: Place, settled: Option<Axis>) -> Result<(), BadBoxes> {
        if self.orders[0].len() - start == 1 {
            self.leaf(start, place);
            return Ok(());
        }
        match self.division(start, place.axis, settled)? {
            Division::Clear(axis) => self.split(start, place, axis),
            Division::Through(plane) => self.cut(start, place, plane),
        }
        Ok(())
    }

    fn leaf(&mut self, start: usize, place: Place) {
        let place = self.trim(start, place, &Axis::ALL);
        let id = self.orders[0][start].id;
        let child = self.tree.leaf(self.pieces[id as usize].label);
        self.parts.push(Part { len: place.len(), child });
        self.orders.iter_mut().for_each(|order| order.truncate(start));
    }

    fn division(&mut self, start: usize, last: Axis, settled: Option<Axis>) -> Result<Division, BadBoxes> {
        let axes = match self.succession {
            Succession::InTurn => turns_after(self.turns, last),
            Succession::Afresh => self.turns,
        };
        for axis in axes.into_iter().filter(|&axis| Some(axis) != settled) {
            sweep(&self.orders[axis.index()], start, &mut self.groups);
            if self.groups.len() > 1 {
                return Ok(Division::Clear(axis));
            }
        }
        least_cut(self.orders.each_ref().map(|order| &order[start..]))
            .map(Division::Through)
            .ok_or_else(|| self.overlap(start))
    }

    /// Where several boxes have no plane between them, they are all one box.
    fn overlap(&self, start: usize) -> BadBoxes {
        let [a, b] = [0, 1].map(|i| self.pieces[self.orders[0][start + i].id as usize].index as usize);
        BadBoxes::Overlap(a.min(b), a.max(b))
    }

    /// Splits the container at the groups of the last sweep, which was along `axis`.
    fn split(&mut self, start: usize, place: Place, axis: Axis) {
        let place = self.trim(start, place, &axis.others());
        let place = self.open(place, axis);
        self.distribute(start, axis);
        let mut low = axis.of(place.cell.min);
        for group in &self.groups {
            self.tasks.push(Task::Nil(group.low - low));
            let place = Place { cell: place.cell.slab(axis, group.low, group.high), axis };
            self.tasks.push(Task::Container { start: group.start, place, settled: Some(axis) });
            low = group.high;
        }
        self.tasks.push(Task::Nil(axis.of(place.cell.max) - low));
    }

    /// Cuts the container in two at one plane, and with it the boxes that cross the plane.
    fn cut(&mut self, start: usize, place: Place, plane: Plane) {
        let place = self.trim(start, place, &Axis::ALL);
        let Place { cell, axis } = self.open(place, plane.axis);
        let middle = self.cut_orders(start, plane);
        let below = cell.slab(axis, axis.of(cell.min), plane.at);
        let above = cell.slab(axis, plane.at, axis.of(cell.max));
        for (start, cell) in [(start, below), (middle, above)] {
            self.tasks.push(Task::Container { start, place: Place { cell, axis }, settled: None });
        }
    }

    /// Begins a split along `axis` in `place`; parts along the axis of the split above just join that.
    fn open(&mut self, place: Place, axis: Axis) -> Place {
        if axis != place.axis {
            self.tasks.push(Task::Close { axis, first: self.parts.len(), len: place.len() });
        }
        Place { cell: place.cell, axis }
    }

    /// Parts off the empty space beside the boxes from `start` on; returns what is left.
    fn trim(&mut self, start: usize, mut place: Place, axes: &[Axis]) -> Place {
        for &axis in axes {
            let (low, high) = extent(&self.orders[axis.index()][start..]);
            let [before, after] = [low - axis.of(place.cell.min), axis.of(place.cell.max) - high];
            if before + after > 0 {
                place = self.open(place, axis);
                place.cell = place.cell.slab(axis, low, high);
                self.tasks.push(Task::Nil(before));
                self.nil(after);
            }
        }
        place
    }

    /// Brings the two other orders into the groups of the order along `axis`.
    fn distribute(&mut self, start: usize, axis: Axis) {
        let order = &self.orders[axis.index()];
        for (part, range) in ranges(&self.groups, order.len()).enumerate() {
            order[range].iter().for_each(|span| self.part_of[span.id as usize] = part as u32);
        }
        for other in axis.others() {
            let order = &mut self.orders[other.index()][start..];
            self.cursors.clear();
            self.cursors.extend(self.groups.iter().map(|group| group.start - start));
            self.scratch.resize(order.len(), Span::default());
            for &span in &*order {
                let cursor = &mut self.cursors[self.part_of[span.id as usize] as usize];
                self.scratch[*cursor] = span;
                *cursor += 1;
            }
            order.copy_from_slice(&self.scratch);
        }
    }
}

impl Splitter<'_> {
    /// Cuts all three orders from `start` on: first what lies below the plane, then what lies above.
    /// Returns where the second begins.
    fn cut_orders(&mut self, start: usize, plane: Plane) -> usize {
        self.note_sides(start, plane);
        let middles = Axis::ALL.map(|along| self.cut_order(start, along, plane));
        middles[0]
    }

    /// Notes on which sides each piece lies, and makes a new piece of each upper half.
    fn note_sides(&mut self, start: usize, plane: Plane) {
        self.sides.resize(self.pieces.len(), Side::Below);
        for span in &self.orders[plane.axis.index()][start..] {
            self.sides[span.id as usize] = match (span.low < plane.at, span.high > plane.at) {
                (true, false) => Side::Below,
                (false, _) => Side::Above,
                (true, true) => Side::Both(self.pieces.len() as u32),
            };
            if let Side::Both(_) = self.sides[span.id as usize] {
                self.pieces.push(self.pieces[span.id as usize]);
            }
        }
        self.part_of.resize(self.pieces.len(), 0);
    }

    fn cut_order(&mut self, start: usize, along: Axis, plane: Plane) -> usize {
        let order = &mut self.orders[along.index()];
        let mut end = start;
        self.scratch.clear();
        for i in start..order.len() {
            let span = order[i];
            let (below, above) = halves(span, self.sides[span.id as usize], along, plane);
            if let Some(below) = below {
                order[end] = below;
                end += 1;
            }
            self.scratch.extend(above);
        }
        order.truncate(end);
        order.extend_from_slice(&self.scratch);
        end
    }
}

/// What a plane leaves below and above of a span along an axis.
fn halves(span: Span, side: Side, along: Axis, plane: Plane) -> (Option<Span>, Option<Span>) {
    match side {
        Side::Below => (Some(span), None),
        Side::Above => (None, Some(span)),
        Side::Both(id) if along == plane.axis => {
            (Some(Span { high: plane.at, ..span }), Some(Span { low: plane.at, id, ..span }))
        }
        Side::Both(id) => (Some(span), Some(Span { id, ..span })),
    }
}

/// What is near in space is then near in memory.
fn numbered_along_x(boxes: &[(Bounds, u32)]) -> Vec<Piece> {
    let mut along_x: Vec<(i32, u32)> = boxes.iter().map(|(bounds, _)| bounds.min.x).zip(0..).collect();
    along_x.sort_unstable();
    along_x.into_iter().map(|(_, index)| Piece { index, label: boxes[index as usize].1 }).collect()
}

fn sorted_spans(boxes: &[(Bounds, u32)], pieces: &[Piece], axis: Axis) -> Vec<Span> {
    let span = |(piece, id): (&Piece, u32)| {
        let bounds = boxes[piece.index as usize].0;
        Span { low: axis.of(bounds.min), high: axis.of(bounds.max), id }
    };
    let mut spans: Vec<Span> = pieces.iter().zip(0..).map(span).collect();
    if axis != Axis::X {
        spans.sort_unstable_by_key(|span| span.low);
    }
    spans
}

/// The axes in the order of `turns`, from the one after `last` round to `last` itself.
fn turns_after(turns: Turns, last: Axis) -> Turns {
    let at = turns.iter().position(|axis| *axis == last).unwrap_or(0);
    [1, 2, 3].map(|step| turns[(at + step) % 3])
}

/// The groups of the spans from `start` on, which are sorted by low end: the open spans are counted down
/// to none wherever one begins at or past the furthest high end so far.
fn sweep(order: &[Span], start: usize, groups: &mut Vec<Group>) {
    groups.clear();
    for (i, span) in order.iter().enumerate().skip(start) {
        match groups.last_mut() {
            Some(group) if span.low < group.high => group.high = group.high.max(span.high),
            _ => groups.push(Group { start: i, low: span.low, high: span.high }),
        }
    }
}

/// The places of each group in an order of length `end`.
fn ranges(groups: &[Group], end: usize) -> impl Iterator<Item = Range<usize>> {
    let ends = groups.iter().skip(1).map(|group| group.start).chain([end]);
    groups.iter().zip(ends).map(|(group, end)| group.start..end)
}

/// From the lowest low end to the highest high end; there is at least one span, sorted by low end.
fn extent(order: &[Span]) -> (i32, i32) {
    let high = order.iter().map(|span| span.high).max();
    (order[0].low, high.unwrap_or(order[0].low))
}

/// The plane inside that cuts the fewest boxes; `None` where no box ends or begins inside.
fn least_cut(orders: [&[Span]; 3]) -> Option<Plane> {
    let best = |(rank, axis): (usize, Axis)| {
        let (cut, imbalance, at) = least_cut_along(orders[axis.index()])?;
        Some(((cut, imbalance, rank), Plane { axis, at }))
    };
    let planes = [Axis::Y, Axis::X, Axis::Z].into_iter().enumerate().filter_map(best);
    planes.min_by_key(|&(cost, _)| cost).map(|(_, plane)| plane)
}

/// How many boxes the best plane across this order cuts, by how many boxes its sides differ, and where.
fn least_cut_along(order: &[Span]) -> Option<(usize, usize, i32)> {
    let mut highs: Vec<i32> = order.iter().map(|span| span.high).collect();
    highs.sort_unstable();
    let inside = order[0].low + 1..*highs.last()?;
    let mut planes: Vec<i32> = order.iter().map(|span| span.low).chain(highs.iter().copied()).collect();
    planes.retain(|at| inside.contains(at));
    planes.sort_unstable();
    planes.dedup();
    let (mut begun, mut ended) = (0, 0);
    let cost = |at| {
        begun += order[begun..].iter().take_while(|span| span.low < at).count();
        ended += highs[ended..].iter().take_while(|&&high| high <= at).count();
        (begun - ended, begun.abs_diff(order.len() - ended), at)
    };
    planes.into_iter().map(cost).min()
}
