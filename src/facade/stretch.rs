//! How splits take other lengths than they were drawn with: windows stay whole, walls give and take, and repeats come and
//! go.

use super::plan::{Item, Node, NodeId, Plan};
use super::{Side, Stretch};
use crate::graph::Group;
use crate::run::written_out;
use crate::space::{self, fit};
use std::ops::Range;

/// What the nodes of a plan can do, by number.
#[derive(Clone, Debug, Default)]
pub struct Giving {
    /// Along x and y: whether a node can have other lengths, its windows whole.
    pub stretches: [Vec<bool>; 2],
    /// Along x and y: whether there is anything in a node that cannot.
    pub is_hard: [Vec<bool>; 2],
    /// Along x and y: whether what stands in a node comes again in it, so that it can come more often.
    pub repeats: [Vec<bool>; 2],
    /// Whether a window or the like is in it.
    pub has_window: Vec<bool>,
    /// Whether some wall is in it: what has none is a part of something, such as a frame of its window.
    pub has_wall: Vec<bool>,
    /// Whether a door is in it: buildings have no further one.
    pub has_door: Vec<bool>,
}

/// Where something comes again.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Again {
    /// Among the parts of a split.
    Here,
    /// Among them or in one of them.
    Anywhere,
}

/// A node stretches across the axis of its split if so much of it does: the rest then stands in walls.
const MOST_OF_IT: f64 = 0.6;

impl Giving {
    pub fn of(plan: &Plan, stretch: &[Stretch], doors: &[bool]) -> Giving {
        let mut giving = Giving::default();
        for (number, node) in plan.nodes.iter().enumerate() {
            match node {
                Node::Leaf(label) => giving.add_leaf(stretch[*label as usize], doors[*label as usize]),
                Node::Split { axis, items } => {
                    let any = |list: &[bool]| plan.parts(number).any(|part| list[part.node]);
                    let (window, door) = (any(&giving.has_window), any(&giving.has_door));
                    let hard = [any(&giving.is_hard[0]), any(&giving.is_hard[1])];
                    let seen = items.iter().any(|item| giving.is_repeat(item));
                    let along = (
                        seen || any(&giving.stretches[axis.index()]),
                        giving.comes_again(plan, number, Again::Anywhere),
                    );
                    let other = axis.other().index();
                    let anything = vec![true; number];
                    let across = (
                        mostly(items, &anything, &giving.stretches[other]),
                        window && mostly(items, &giving.has_window, &giving.repeats[other]),
                    );
                    for (side, (stretches, repeats)) in [(axis.index(), along), (other, across)] {
                        giving.stretches[side].push(stretches);
                        giving.repeats[side].push(repeats && stretches);
                        giving.is_hard[side].push(hard[side]);
                    }
                    giving.has_wall.push(any(&giving.has_wall));
                    giving.has_window.push(window);
                    giving.has_door.push(door);
                }
            }
        }
        giving
    }

    /// Whether an item comes several times and has a window: walls that were drawn in pieces are walls all the same.
    fn is_repeat(&self, item: &Item) -> bool {
        item.times > 1 && item.parts.iter().any(|part| self.has_window[part.node])
    }

    fn add_leaf(&mut self, stretch: Stretch, is_door: bool) {
        let is_soft = [stretch != Stretch::Hard, stretch == Stretch::Soft];
        for (axis, is_soft) in is_soft.into_iter().enumerate() {
            self.stretches[axis].push(is_soft);
            self.is_hard[axis].push(!is_soft);
            self.repeats[axis].push(false);
        }
        self.has_wall.push(stretch == Stretch::Soft);
        self.has_window.push(stretch == Stretch::Hard);
        self.has_door.push(is_door);
    }

    /// Whether a split has a part with a window that stands in it more than once, or one in which that is so.
    fn comes_again(&self, plan: &Plan, node: NodeId, again: Again) -> bool {
        let Node::Split { axis, items } = &plan.nodes[node] else { return false };
        let nodes: Vec<NodeId> = plan.parts(node).map(|part| part.node).collect();
        let often = |node: &NodeId| nodes.iter().filter(|other| *other == node).count() > 1;
        let inside = |node: &NodeId| again == Again::Anywhere && self.repeats[axis.index()][*node];
        items.iter().any(|item| self.is_repeat(item))
            || nodes.iter().any(|node| inside(node) || (self.has_window[*node] && often(node)))
    }
}

/// Whether that is so of most of the parts of a split that count, by length.
fn mostly(items: &[Item], counts: &[bool], is_so: &[bool]) -> bool {
    let all =
        || items.iter().flat_map(|item| item.parts.iter().map(|part| (item.times * part.length, part.node)));
    let parts = || all().filter(|(_, node)| counts[*node]);
    let all: u32 = parts().map(|(length, _)| length).sum();
    let those: u32 = parts().filter(|(_, node)| is_so[*node]).map(|(length, _)| length).sum();
    f64::from(those) >= MOST_OF_IT * f64::from(all)
}

/// A split that takes any length.
#[derive(Clone, PartialEq, Debug)]
pub struct Stretched {
    pub parts: Vec<Stretchy>,
    /// The runs of parts that repeat as they fit.
    pub repeats: Vec<Range<usize>>,
}

/// A part of it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Stretchy {
    /// Nothing was drawn there: it is wall, where there is room.
    pub node: Option<NodeId>,
    pub length: Length,
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Length {
    /// A share of what is left, in proportion to its own length.
    Share(f64),
    /// So many blocks, and nothing in scopes shorter than `from`.
    Whole { blocks: u32, from: u32 },
}

/// The share of a wall that has no length in the layout: it rounds to none.
const FILLER: f64 = 0.25;

/// A node in the middle of walls that have no length in the layout.
pub fn walled(node: NodeId, length: u32) -> Stretched {
    let filler = Stretchy { node: None, length: Length::Share(FILLER) };
    let own = Stretchy { node: Some(node), length: Length::Whole { blocks: length, from: length } };
    Stretched { parts: vec![filler, own, filler], repeats: Vec::new() }
}

/// A split that takes any length; `None` if no way was found that keeps all hard parts whole.
pub fn stretched(plan: &Plan, giving: &Giving, node: NodeId) -> Option<Stretched> {
    let Node::Split { axis, items } = &plan.nodes[node] else { return None };
    let natural =
        items.iter().map(|item| item.times * item.parts.iter().map(|part| part.length).sum::<u32>()).sum();
    let seen = parts(plan, giving, *axis, node);
    // What comes again in a part leaves no room for further parts, unless those are of a kind.
    let is_room = !plan.parts(node).any(|part| giving.repeats[axis.index()][part.node])
        || giving.comes_again(plan, node, Again::Here);
    let grown = (seen.repeats.is_empty() && is_room).then(|| grown(giving, *axis, &seen)).flatten();
    let candidates = grown.into_iter().chain([seen]).flat_map(|split| [split.clone(), split.stiff_inside()]);
    let guarded = candidates.map(|split| split.with_fillers().guarded(giving, *axis, natural));
    let drawn: Vec<u32> = items.iter().flat_map(Item::written_out).map(|part| part.length).collect();
    guarded.into_iter().find(|split| split.holds(natural) && split.gives_back(&drawn))
}

/// The parts of a split as they were seen. What holds something hard is whole, unless what is in it comes again there; if
/// nothing else gives, parts of it that can stretch do.
fn parts(plan: &Plan, giving: &Giving, axis: Side, node: NodeId) -> Stretched {
    let (side, mut split) = (axis.index(), Stretched { parts: Vec::new(), repeats: Vec::new() });
    let Node::Split { items, .. } = &plan.nodes[node] else { return split };
    let again = |node: NodeId| giving.repeats[side][node];
    let is_repeat = |item: &Item| giving.is_repeat(item);
    let gives = items.iter().any(is_repeat)
        || plan.parts(node).any(|part| !giving.is_hard[side][part.node] || again(part.node));
    for item in items {
        let start = split.parts.len();
        let is_repeat = is_repeat(item);
        let times = if is_repeat { 1 } else { item.times as usize };
        for part in (0..times).flat_map(|_| &item.parts) {
            let may = !gives || !giving.is_hard[side][part.node] || again(part.node);
            let length = match giving.stretches[side][part.node] && may {
                true => Length::Share(f64::from(part.length)),
                false => Length::Whole { blocks: part.length, from: 0 },
            };
            split.parts.push(Stretchy { node: Some(part.node), length });
        }
        if is_repeat {
            split.repeats.push(start..split.parts.len());
        }
    }
    split
}

/// With a part that comes again where there is room, though the layout shows no row of it: a window with the wall beside
/// it, a storey with what lies below it. Best are those that are mirrored by another, which then comes again as well, then
/// those that stand most often, then those nearest to the middle.
fn grown(giving: &Giving, axis: Side, seen: &Stretched) -> Option<Stretched> {
    let units: Vec<Unit> = (0..seen.parts.len()).filter_map(|at| unit(giving, axis, seen, at)).collect();
    let mirror = |unit: &Unit| {
        let range = seen.parts.len() - unit.range.end..seen.parts.len() - unit.range.start;
        let lengths = |range: &Range<usize>| {
            seen.parts[range.clone()].iter().map(|part| part.length).collect::<Vec<_>>()
        };
        let is_mirrored = lengths(&range).iter().rev().eq(&lengths(&unit.range));
        (axis == Side::X && is_mirrored).then(|| units.iter().find(|other| other.range == range)).flatten()
    };
    let best = units.iter().max_by(|a, b| {
        let (a_mirrored, b_mirrored) = (mirror(a).is_some(), mirror(b).is_some());
        a_mirrored
            .cmp(&b_mirrored)
            .then(a.often.cmp(&b.often))
            .then(b.off.abs().total_cmp(&a.off.abs()))
            .then(a.at.cmp(&b.at))
    })?;
    let mut repeats = vec![best.range.clone()];
    let is_apart = |other: &&Unit| other.range.end <= best.range.start || best.range.end <= other.range.start;
    repeats.extend(mirror(best).filter(is_apart).map(|other| other.range.clone()));
    repeats.sort_by_key(|range| range.start);
    Some(Stretched { parts: seen.parts.clone(), repeats })
}

/// Parts that may come again together.
struct Unit {
    /// The part with the window in it.
    at: usize,
    range: Range<usize>,
    /// How often that part stands in its split.
    often: usize,
    /// How far it is from the middle, in blocks.
    off: f64,
}

fn unit(giving: &Giving, axis: Side, seen: &Stretched, at: usize) -> Option<Unit> {
    let parts = &seen.parts;
    let has_window = |at: usize| parts[at].node.is_some_and(|node| giving.has_window[node]);
    let has_door = |at: usize| parts[at].node.is_some_and(|node| giving.has_door[node]);
    if !has_window(at) || has_door(at) {
        return None;
    }
    let often = parts.iter().filter(|part| part.node == parts[at].node).count();
    let is_first = !(0..at).any(has_window);
    let is_only = (0..parts.len()).filter(|at| has_window(*at)).count() == 1;
    // A ground floor that is like no other comes once.
    if axis == Side::Y && is_first && often == 1 && !is_only {
        return None;
    }
    let off = middles(parts)[at];
    // What is between two of a kind belongs to them, whatever it is; else there has to be wall.
    let separates = |other: usize| parts[other].is_share() || (often > 1 && giving_room(seen, other));
    let before =
        at.checked_sub(1).filter(|other| !has_window(*other) && separates(*other)).map(|other| other..at + 1);
    let after = Some(at + 1)
        .filter(|other| *other < parts.len() && !has_window(*other) && separates(*other))
        .map(|other| at..other + 1);
    // The wall on the side of the middle goes with it, so that mirrored units mirror each other; with a storey that below.
    let range = if axis == Side::Y || off > 0.0 { before.or(after) } else { after.or(before) };
    range.map(|range| Unit { at, range, often, off })
}

/// Whether a part stands between two others.
fn giving_room(seen: &Stretched, at: usize) -> bool {
    at > 0 && at + 1 < seen.parts.len()
}

/// How far the middle of each part is from the middle of all, in blocks.
fn middles(parts: &[Stretchy]) -> Vec<f64> {
    let length = |part: &Stretchy| match part.length {
        Length::Share(share) => share,
        Length::Whole { blocks, .. } => f64::from(blocks),
    };
    let total: f64 = parts.iter().map(length).sum();
    let mut at = -total / 2.0;
    let middle = |part: &Stretchy| {
        at += length(part);
        at - length(part) / 2.0
    };
    parts.iter().map(middle).collect()
}

impl Stretched {
    fn is_inside(&self, at: usize) -> bool {
        self.repeats.iter().any(|range| range.contains(&at))
    }

    /// With whole lengths inside repeats, which then come as often as all of them fits.
    fn stiff_inside(mut self) -> Stretched {
        for at in 0..self.parts.len() {
            if let (true, Length::Share(share)) = (self.is_inside(at), self.parts[at].length) {
                self.parts[at].length = Length::Whole { blocks: share as u32, from: 0 };
            }
        }
        self
    }

    /// With walls of no length at both ends where nothing outside of repeats gives.
    fn with_fillers(mut self) -> Stretched {
        let gives = (0..self.parts.len())
            .any(|at| !self.is_inside(at) && matches!(self.parts[at].length, Length::Share(_)));
        let gives_inside = (0..self.parts.len())
            .any(|at| self.is_inside(at) && matches!(self.parts[at].length, Length::Share(_)));
        if !gives && !gives_inside {
            let filler = Stretchy { node: None, length: Length::Share(FILLER) };
            self.parts.insert(0, filler);
            self.parts.push(filler);
            self.repeats.iter_mut().for_each(|range| *range = range.start + 1..range.end + 1);
        }
        self
    }

    /// With the least scope for each hard part outside of repeats, and for those that share a repeat with walls. What is
    /// nearest to the middle stays longest, of storeys the lowest, and doors before all.
    fn guarded(mut self, giving: &Giving, axis: Side, natural: u32) -> Stretched {
        let mut sum = 0;
        let levels = self.levels(giving, axis);
        for level in &levels {
            sum += level.iter().map(|at| self.whole(*at) + 1).sum::<u32>();
            self.show(level, (sum + 1).min(natural));
        }
        // In scopes in which walls have no room between windows, the outermost go.
        let mut shown = levels.len();
        for total in (1..natural).rev() {
            while shown > 0 && !self.fits(total) {
                shown -= 1;
                self.show(&levels[shown], total + 1);
            }
        }
        self
    }

    /// The parts that are shown only where there is room, those that are shown first before the others. What stands wall to
    /// wall without a wall is one thing: a frame is not shown without its window.
    fn levels(&self, giving: &Giving, axis: Side) -> Vec<Vec<usize>> {
        let has_share = |range: &Range<usize>| self.parts[range.clone()].iter().any(|part| part.is_share());
        let repeat = |at: usize| self.repeats.iter().position(|range| range.contains(&at));
        let is_free = |at: usize| repeat(at).is_none_or(|repeat| has_share(&self.repeats[repeat]));
        let is_bare = |at: usize| self.parts[at].node.is_some_and(|node| !giving.has_wall[node]);
        let is_one =
            |a: &usize, b: &usize| a + 1 == *b && is_bare(*a) && is_bare(*b) && repeat(*a) == repeat(*b);
        let shown: Vec<usize> =
            (0..self.parts.len()).filter(|at| !self.parts[*at].is_share() && is_free(*at)).collect();
        let middle = (self.parts.len() as i64) - 1;
        let rank = |things: &[usize]| {
            let is_door = |at: &usize| self.parts[*at].node.is_some_and(|node| giving.has_door[node]);
            let off = things.iter().map(|at| (2 * *at as i64 - middle).abs()).min().unwrap_or(0);
            match axis {
                _ if things.iter().any(is_door) => -1,
                Side::X => off,
                // Low houses have the lower storeys of high ones.
                Side::Y => things[0] as i64,
            }
        };
        let mut ranked: Vec<(i64, &[usize])> =
            shown.chunk_by(is_one).map(|things| (rank(things), things)).collect();
        ranked.sort_unstable();
        let level =
            |level: &[(i64, &[usize])]| level.iter().flat_map(|(_, things)| things.iter().copied()).collect();
        ranked.chunk_by(|a, b| a.0 == b.0).map(level).collect()
    }

    fn whole(&self, at: usize) -> u32 {
        match self.parts[at].length {
            Length::Whole { blocks, .. } => blocks,
            Length::Share(_) => 0,
        }
    }

    fn show(&mut self, level: &[usize], from: u32) {
        for at in level {
            self.parts[*at].length = Length::Whole { blocks: self.whole(*at), from };
        }
    }

    /// The lengths in a scope of `total` blocks.
    fn lengths(&self, total: u32) -> Vec<space::Length> {
        let length = |part: &Stretchy| match part.length {
            Length::Share(share) => space::Length::Floating(share),
            Length::Whole { blocks, from } => {
                space::Length::Absolute(f64::from(if total >= from { blocks } else { 0 }))
            }
        };
        self.parts.iter().map(length).collect()
    }

    /// Whether it fits scopes of all lengths, tried out as a run does it.
    fn holds(&self, natural: u32) -> bool {
        let most = (4 * natural).clamp(64, 2048).max(natural + 1);
        (1..=most).all(|total| self.fits(total))
    }

    /// Whether at its own length it has the parts that were drawn.
    fn gives_back(&self, drawn: &[u32]) -> bool {
        let bounds = self.bounds(drawn.iter().sum()).map(|(_, bounds)| bounds);
        let lengths =
            bounds.unwrap_or_default().windows(2).map(|ends| (ends[1] - ends[0]) as u32).collect::<Vec<_>>();
        lengths.into_iter().filter(|length| *length > 0).eq(drawn.iter().copied())
    }

    /// The lengths of all parts in a scope, repeats written out, and where they end; `None` where they do not fit.
    fn bounds(&self, total: u32) -> Option<(Vec<space::Length>, Vec<i32>)> {
        let lengths = self.lengths(total);
        let groups: Vec<Group> = self.repeats.iter().map(|range| Group { children: range.clone() }).collect();
        let order = match groups.is_empty() {
            true => (0..lengths.len()).collect(),
            false => written_out(&lengths, &groups, total as i32).ok()?,
        };
        let out: Vec<space::Length> = order.iter().map(|at| lengths[*at]).collect();
        let bounds = fit(total as i32, &out).ok()?;
        Some((out, bounds))
    }

    /// Whether every hard part is whole or left out in a scope, with wall between any two that have wall between them.
    fn fits(&self, total: u32) -> bool {
        let Some((out, bounds)) = self.bounds(total) else { return false };
        // The wall since the last hard part that is there: none where no wall was meant to be.
        let mut wall = None;
        let mut is_first = true;
        for (length, ends) in out.iter().zip(bounds.windows(2)) {
            let blocks = ends[1] - ends[0];
            match length {
                space::Length::Floating(_) => wall = Some(wall.unwrap_or(0) + blocks),
                space::Length::Absolute(size) if f64::from(blocks) != *size => return false,
                space::Length::Absolute(_) if blocks == 0 => {}
                space::Length::Absolute(_) => {
                    if !is_first && wall == Some(0) {
                        return false;
                    }
                    (wall, is_first) = (None, false);
                }
            }
        }
        true
    }
}

impl Stretchy {
    fn is_share(&self) -> bool {
        matches!(self.length, Length::Share(_))
    }
}
