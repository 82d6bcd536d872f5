//! Planes where examples can be exchanged: one side from one example, the other side from another.
//!
//! Two examples of one size can be exchanged at a plane if every block neighbourhood of 2 x 2 x 2 that
//! would then straddle the plane was seen in some example. Halves of doors and beds stay together by the
//! same token: no example shows one without the other. And what all examples of a size show equally often
//! (one door, one chimney) has to stand equally often before the plane, so that no house ends up with two
//! of it, or with none.

use super::example::{Example, Terminal, Terminals};
use super::neighbourhood::{Neighbourhood, Place, Seen, Shown, corners, places};
use crate::block::{self, Shape};
use crate::space::{Axis, Bounds, Cell};
use ndarray::{ArrayView3, Slice};
use std::collections::BTreeMap;
use std::ops::Range;

/// Examples of one size, and the planes on one axis where they can be exchanged.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Exchange {
    /// The numbers of the examples.
    pub members: Vec<usize>,
    pub axis: Axis,
    /// From the low end up.
    pub planes: Vec<Plane>,
}

/// A plane across an axis, and which examples can be exchanged at it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Plane {
    /// The cells below it, from the low end of the example.
    pub at: i32,
    /// By member: examples of one class can be exchanged.
    pub classes: Vec<usize>,
}

/// More planes than this make a grammar that nobody reads.
const MOST_PLANES: usize = 4;
/// Slabs are this thick at least.
const THINNEST: i32 = 2;

/// Groups the examples by size and finds the planes of each group, on the axis where they allow most.
/// Labelled boxes have none: they are not made of neighbourhoods.
pub fn exchanges(examples: &[Example], shown: Option<&Shown>, terminals: &Terminals) -> Vec<Exchange> {
    let kinds: Vec<String> = terminals.list.iter().map(kind).collect();
    let exchange = |members: Vec<usize>| {
        let found = shown.filter(|_| members.len() > 1).map(|shown| {
            let grids: Vec<ArrayView3<u32>> =
                members.iter().map(|member| shown.cells[*member].view()).collect();
            let bordered = members.iter().map(|member| shown.bordered[*member].view()).collect();
            let fixtures = fixtures(&grids, &kinds);
            Group { grids, bordered, seen: &shown.seen, fixtures }.best_planes()
        });
        let (axis, planes) = found.unwrap_or((Axis::Y, Vec::new()));
        Exchange { members, axis, planes }
    };
    by_size(examples).into_iter().map(exchange).collect()
}

impl Exchange {
    /// Of an example by itself, which is not exchanged.
    pub fn alone(member: usize) -> Exchange {
        Exchange { members: vec![member], axis: Axis::Y, planes: Vec::new() }
    }

    /// Whether something else can stand past a plane of an example.
    pub fn exchanges(&self, member: usize) -> bool {
        let is_exchanged = |plane: &Plane| self.exchangeable(plane, member).len() > 1;
        self.members.contains(&member) && self.planes.iter().any(is_exchanged)
    }

    /// Whether what a box of an example holds stands beside no plane: nothing past a plane has a say in it.
    pub fn leaves_whole(&self, bounds: Bounds) -> bool {
        let (low, high) = (self.axis.of(bounds.min), self.axis.of(bounds.max));
        self.planes.iter().all(|plane| high < plane.at || low > plane.at)
    }

    /// The boxes between the planes of an example that fills `bounds`, from the low end up.
    pub fn slabs(&self, bounds: Bounds) -> Vec<Bounds> {
        let (low, high) = (self.axis.of(bounds.min), self.axis.of(bounds.max));
        let planes = self.planes.iter().map(|plane| low + plane.at);
        let limits: Vec<i32> = [low].into_iter().chain(planes).chain([high]).collect();
        limits.windows(2).map(|pair| bounds.slab(self.axis, pair[0], pair[1])).collect()
    }

    /// The members that can stand past `plane` where `member` stands before it.
    pub fn exchangeable(&self, plane: &Plane, member: usize) -> Vec<usize> {
        let classes = || self.members.iter().zip(&plane.classes);
        let own = classes().find(|(other, _)| **other == member).map(|(_, class)| class);
        classes().filter(|(_, class)| Some(*class) == own).map(|(other, _)| *other).collect()
    }
}

fn by_size(examples: &[Example]) -> Vec<Vec<usize>> {
    let mut groups: Vec<(Cell, Vec<usize>)> = Vec::new();
    for (number, example) in examples.iter().enumerate() {
        let size = example.bounds().size();
        match groups.iter_mut().find(|(known, _)| *known == size) {
            Some((_, members)) => members.push(number),
            None => groups.push((size, vec![number])),
        }
    }
    groups.into_iter().map(|(_, members)| members).collect()
}

/// The neighbourhoods around the plane where `below` stands before it and `above` past it. Both have a border.
fn straddling<'a>(
    below: ArrayView3<'a, u32>,
    above: ArrayView3<'a, u32>,
    axis: Axis,
    at: i32,
) -> impl Iterator<Item = Neighbourhood> + 'a {
    let along = array_axis(axis);
    let on_plane = corners(below.dim()).filter(move |corner| corner[along] == at as usize);
    let cell = move |place: Place| if place[along] <= at as usize { below[place] } else { above[place] };
    on_plane.map(move |corner| places(corner).map(cell))
}

/// The axis of an array of cells, which is indexed `[y, z, x]`.
pub fn array_axis(axis: Axis) -> usize {
    match axis {
        Axis::Y => 0,
        Axis::Z => 1,
        Axis::X => 2,
    }
}

/// Examples of one size as arrays of terminals, without and with a border.
struct Group<'a> {
    grids: Vec<ArrayView3<'a, u32>>,
    bordered: Vec<ArrayView3<'a, u32>>,
    seen: &'a Seen,
    /// By terminal, the number of the fixture that it belongs to.
    fixtures: Vec<Option<usize>>,
}

impl Group<'_> {
    /// The planes on the axis where they allow the most that is new; of equal ones on y, then x, then z.
    fn best_planes(&self) -> (Axis, Vec<Plane>) {
        let found = [Axis::Z, Axis::X, Axis::Y].map(|axis| (axis, self.planes(axis)));
        let best = found.into_iter().max_by_key(|(_, (gain, _))| *gain);
        best.map_or((Axis::Y, Vec::new()), |(axis, (_, planes))| (axis, planes))
    }

    fn length(&self, axis: Axis) -> i32 {
        self.grids[0].len_of(ndarray::Axis(array_axis(axis))) as i32
    }

    /// The planes to use on an axis, and how many combinations they allow that no example shows.
    fn planes(&self, axis: Axis) -> (usize, Vec<Plane>) {
        let mut found: Vec<(usize, Plane)> = (THINNEST..=self.length(axis) - THINNEST)
            .map(|at| Plane { at, classes: self.classes(axis, at) })
            .map(|plane| (self.gain(axis, &plane), plane))
            .filter(|(gain, _)| *gain > 0)
            .collect();
        found.sort_by_key(|(gain, plane)| (std::cmp::Reverse(*gain), plane.at));
        let (mut total, mut chosen): (usize, Vec<Plane>) = (0, Vec::new());
        for (gain, plane) in found {
            let is_apart = chosen.iter().all(|other| (other.at - plane.at).abs() >= THINNEST);
            if is_apart && chosen.len() < MOST_PLANES {
                total += gain;
                chosen.push(plane);
            }
        }
        chosen.sort_by_key(|plane| plane.at);
        (total, chosen)
    }

    /// By member, the number of the first class whose members can all be exchanged with it.
    fn classes(&self, axis: Axis, at: i32) -> Vec<usize> {
        let counts: Vec<Vec<u32>> =
            self.grids.iter().map(|grid| self.fixtures_before(*grid, axis, at)).collect();
        let fits = |a: usize, b: usize| {
            straddling(self.bordered[a], self.bordered[b], axis, at).all(|cells| self.seen.contains(&cells))
        };
        let agree = |a: usize, b: usize| counts[a] == counts[b] && fits(a, b) && fits(b, a);
        let mut classes: Vec<Vec<usize>> = Vec::new();
        let mut of_member = Vec::with_capacity(self.grids.len());
        for member in 0..self.grids.len() {
            let joins = |class: &Vec<usize>| class.iter().all(|other| agree(*other, member));
            let class = classes.iter().position(joins).unwrap_or(classes.len());
            match classes.get_mut(class) {
                Some(members) => members.push(member),
                None => classes.push(vec![member]),
            }
            of_member.push(class);
        }
        of_member
    }

    /// How often each fixture stands before a plane.
    fn fixtures_before(&self, grid: ArrayView3<u32>, axis: Axis, at: i32) -> Vec<u32> {
        let mut counts = vec![0; self.fixtures.len()];
        let before = slab(grid, axis, 0..at as usize);
        let numbers = before.iter().filter_map(|terminal| self.fixtures[*terminal as usize]);
        numbers.for_each(|number| counts[number] += 1);
        counts
    }

    /// How many combinations a plane allows that no example shows.
    fn gain(&self, axis: Axis, plane: &Plane) -> usize {
        let (at, length) = (plane.at as usize, self.length(axis) as usize);
        let count = plane.classes.iter().max().map_or(0, |last| last + 1);
        let gain = |class: usize| {
            let members = || self.grids.iter().zip(&plane.classes).filter(move |(_, own)| **own == class);
            let kinds =
                |range: Range<usize>| distinct(members().map(|(grid, _)| slab(*grid, axis, range.clone())));
            kinds(0..at) * kinds(at..length) - kinds(0..length)
        };
        (0..count).map(gain).sum()
    }
}

/// What a terminal is counted as: doors are doors and beds are beds, whatever they are made of.
fn kind(terminal: &Terminal) -> String {
    match terminal {
        Terminal::Label(label) => label.clone(),
        Terminal::Block(state) => match block::shape(state) {
            Shape::Air => String::new(),
            Shape::Door(_) => "door".to_owned(),
            Shape::Bed(_) => "bed".to_owned(),
            _ => state.name().to_owned(),
        },
    }
}

/// By terminal, the number of its kind if all grids show that kind equally often.
fn fixtures(grids: &[ArrayView3<u32>], kinds: &[String]) -> Vec<Option<usize>> {
    let counted: Vec<BTreeMap<&str, u32>> = grids
        .iter()
        .map(|grid| {
            let mut counts = BTreeMap::new();
            grid.iter()
                .for_each(|terminal| *counts.entry(kinds[*terminal as usize].as_str()).or_insert(0) += 1);
            counts
        })
        .collect();
    let is_fixture = |kind: &&str| {
        !kind.is_empty() && counted.iter().all(|counts| counts.get(kind) == counted[0].get(kind))
    };
    let fixtures: Vec<&str> = counted[0].keys().copied().filter(is_fixture).collect();
    kinds.iter().map(|kind| fixtures.iter().position(|fixture| fixture == kind)).collect()
}

fn slab<'a>(mut grid: ArrayView3<'a, u32>, axis: Axis, range: Range<usize>) -> ArrayView3<'a, u32> {
    grid.slice_axis_inplace(ndarray::Axis(array_axis(axis)), Slice::from(range));
    grid
}

/// How many of the views differ.
fn distinct<'a>(views: impl Iterator<Item = ArrayView3<'a, u32>>) -> usize {
    let mut known = Vec::new();
    for view in views {
        if !known.contains(&view) {
            known.push(view);
        }
    }
    known.len()
}
