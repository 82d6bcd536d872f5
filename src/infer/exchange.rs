//! Planes where examples can be exchanged: one side from one example, the other side from another.
//!
//! Two examples of one size can be exchanged at a plane if every block neighbourhood of 2 x 2 x 2 that
//! would then straddle the plane was seen in some example. Halves of doors and beds stay together by the
//! same token: no example shows one without the other.

use super::example::{Example, Terminals};
use crate::space::{Axis, Bounds, Cell};
use ndarray::{Array3, ArrayView3, Slice};
use rustc_hash::FxHashSet;
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
pub fn exchanges(examples: &[Example], terminals: &mut Terminals) -> Vec<Exchange> {
    let groups = by_size(examples);
    if groups.iter().all(|members| members.len() == 1) {
        let alone = |members| Exchange { members, axis: Axis::Y, planes: Vec::new() };
        return groups.into_iter().map(alone).collect();
    }
    let cells: Vec<Option<Array3<u32>>> = examples.iter().map(|example| example.cells(terminals)).collect();
    let seen: FxHashSet<Neighbourhood> = cells.iter().flatten().flat_map(neighbourhoods).collect();
    groups
        .into_iter()
        .map(|members| {
            let grids: Option<Vec<&Array3<u32>>> =
                members.iter().map(|member| cells[*member].as_ref()).collect();
            let (axis, planes) = grids.map_or((Axis::Y, Vec::new()), |grids| best_planes(&grids, &seen));
            Exchange { members, axis, planes }
        })
        .collect()
}

impl Exchange {
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

/// The terminals of 2 x 2 x 2 cells, in the order of their places.
type Neighbourhood = [u32; 8];

/// What lies outside of an example.
const OUTSIDE: u32 = u32::MAX;

/// A place in an array: `[y, z, x]`.
type Place = [usize; 3];

/// Every neighbourhood of an example, those at its borders with what lies outside.
fn neighbourhoods(cells: &Array3<u32>) -> impl Iterator<Item = Neighbourhood> {
    corners(cells.dim(), None).map(move |corner| neighbourhood(corner, |place| padded(cells, place)))
}

/// The neighbourhoods around the plane where `below` stands before it and `above` past it.
fn straddling<'a>(
    below: &'a Array3<u32>,
    above: &'a Array3<u32>,
    axis: Axis,
    at: i32,
) -> impl Iterator<Item = Neighbourhood> + 'a {
    let along = array_axis(axis);
    corners(below.dim(), Some((along, at as usize))).map(move |corner| {
        neighbourhood(corner, |place| padded(if place[along] <= at as usize { below } else { above }, place))
    })
}

/// The low corners of neighbourhoods in an array with a border one cell wide; on one plane if it is given.
fn corners((y, z, x): (usize, usize, usize), plane: Option<(usize, usize)>) -> impl Iterator<Item = Place> {
    let mut ranges = [0..=y, 0..=z, 0..=x];
    if let Some((along, at)) = plane {
        ranges[along] = at..=at;
    }
    let [ys, zs, xs] = ranges;
    ys.flat_map(move |y| {
        let xs = xs.clone();
        zs.clone().flat_map(move |z| xs.clone().map(move |x| [y, z, x]))
    })
}

fn neighbourhood([y, z, x]: Place, cell: impl Fn(Place) -> u32) -> Neighbourhood {
    std::array::from_fn(|at| cell([y + at / 4, z + at / 2 % 2, x + at % 2]))
}

/// The terminal at a place, counted with a border one cell wide.
fn padded(cells: &Array3<u32>, place: Place) -> u32 {
    let [y, z, x] = place.map(|n| n.wrapping_sub(1));
    cells.get([y, z, x]).copied().unwrap_or(OUTSIDE)
}

/// The axis of an array of cells, which is indexed `[y, z, x]`.
fn array_axis(axis: Axis) -> usize {
    match axis {
        Axis::Y => 0,
        Axis::Z => 1,
        Axis::X => 2,
    }
}

/// The planes on the axis where they allow the most that is new; of equal ones on y, then x, then z.
fn best_planes(grids: &[&Array3<u32>], seen: &FxHashSet<Neighbourhood>) -> (Axis, Vec<Plane>) {
    let found = [Axis::Z, Axis::X, Axis::Y].map(|axis| (axis, planes(grids, axis, seen)));
    let best = found.into_iter().max_by_key(|(_, (gain, _))| *gain);
    best.map_or((Axis::Y, Vec::new()), |(axis, (_, planes))| (axis, planes))
}

/// The planes to use on an axis, and how many combinations they allow that no example shows.
fn planes(grids: &[&Array3<u32>], axis: Axis, seen: &FxHashSet<Neighbourhood>) -> (usize, Vec<Plane>) {
    let length = grids[0].len_of(ndarray::Axis(array_axis(axis))) as i32;
    let mut found: Vec<(usize, Plane)> = (THINNEST..=length - THINNEST)
        .map(|at| Plane { at, classes: classes(grids, axis, at, seen) })
        .map(|plane| (gain(grids, axis, &plane), plane))
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
fn classes(grids: &[&Array3<u32>], axis: Axis, at: i32, seen: &FxHashSet<Neighbourhood>) -> Vec<usize> {
    let fits =
        |a: usize, b: usize| straddling(grids[a], grids[b], axis, at).all(|cells| seen.contains(&cells));
    let mut classes: Vec<Vec<usize>> = Vec::new();
    let mut of_member = Vec::with_capacity(grids.len());
    for member in 0..grids.len() {
        let joins =
            |class: &Vec<usize>| class.iter().all(|other| fits(*other, member) && fits(member, *other));
        let class = classes.iter().position(joins).unwrap_or(classes.len());
        match classes.get_mut(class) {
            Some(members) => members.push(member),
            None => classes.push(vec![member]),
        }
        of_member.push(class);
    }
    of_member
}

/// How many combinations a plane allows that no example shows.
fn gain(grids: &[&Array3<u32>], axis: Axis, plane: &Plane) -> usize {
    let length = grids[0].len_of(ndarray::Axis(array_axis(axis)));
    let at = plane.at as usize;
    let count = plane.classes.iter().max().map_or(0, |last| last + 1);
    (0..count)
        .map(|class| {
            let members = || grids.iter().zip(&plane.classes).filter(|(_, own)| **own == class);
            let kinds =
                |range: Range<usize>| distinct(members().map(|(grid, _)| slab(grid, axis, range.clone())));
            kinds(0..at) * kinds(at..length) - kinds(0..length)
        })
        .sum()
}

fn slab(grid: &Array3<u32>, axis: Axis, range: Range<usize>) -> ArrayView3<'_, u32> {
    grid.slice_axis(ndarray::Axis(array_axis(axis)), Slice::from(range))
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
