//! The boxes of all examples, those of equal content known by one number.

use super::fold::{Token, folded};
use super::peel::Peel;
use super::seams::Seams;
use super::volume::Volume;
use crate::grid::Content;
use crate::space::{Axis, Bounds, Cell};
use rustc_hash::{FxHashMap, FxHashSet, FxHasher};
use smallvec::SmallVec;
use std::collections::BTreeMap;
use std::hash::Hasher;
use std::rc::Rc;

/// A box in an example.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Place {
    pub example: u32,
    pub bounds: Bounds,
}

/// The number of all boxes with one content.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Class(pub u32);

/// The number of all contents that are equal once every slice that equals its predecessor is left out, on all
/// axes: a shape without its sizes.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Skeleton(pub u32);

/// Slices that follow one another, their longest repeat written once: equal ones have one number.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Sequence {
    pub number: u32,
    /// So many tokens write it down.
    pub pieces: u32,
}

/// What is known of a class.
#[derive(Clone, Debug)]
pub struct Profile {
    /// The first place where it was seen.
    pub place: Place,
    /// By axis: where slices differ from the one before, from the low end of the box. The first is 0.
    pub starts: [SmallVec<[i32; 8]>; 3],
    pub skeleton: Skeleton,
}

impl Profile {
    pub fn len(&self, axis: Axis) -> i32 {
        self.place.bounds.len(axis)
    }

    pub fn size(&self) -> Cell {
        self.place.bounds.size()
    }

    pub fn starts(&self, axis: Axis) -> &[i32] {
        &self.starts[axis.index()]
    }

    /// Whether all its cells are equal.
    pub fn is_uniform(&self) -> bool {
        self.starts.iter().all(|starts| starts.len() == 1)
    }
}

/// To read so many cells takes as long as to look for a part that is known.
const CELLS: u64 = 16;

/// Terminals from this number on are parameters.
const PARAMETER: u32 = 1 << 31;

pub fn is_parameter(terminal: u32) -> bool {
    terminal >= PARAMETER
}

/// What is found out of a class once it is asked for.
#[derive(Clone, Default, Debug)]
struct Found {
    /// By axis: the skeletons of the slices that differ from the one before.
    slices: [Option<Rc<[Skeleton]>>; 3],
    /// By axis: the classes of all slices.
    rows: [Option<Rc<[Class]>>; 3],
    sequences: [Option<Sequence>; 3],
    /// The terminals that there are, in order of their numbers.
    terminals: Option<Rc<[u32]>>,
    pattern: Option<Rc<Pattern>>,
}

/// The terminals of a class where slices differ, as numbers in the order in which they come, and that order.
#[derive(PartialEq, Eq, Debug)]
pub struct Pattern {
    pub numbers: Rc<[u32]>,
    pub order: Vec<u32>,
}

/// All examples with what was asked about their boxes.
#[derive(Debug)]
pub struct Corpus {
    volumes: Vec<Volume>,
    classes: FxHashMap<Content, Class>,
    profiles: Vec<Profile>,
    skeletons: FxHashMap<u64, Skeleton>,
    /// The classes of parts, by axis and by where they start and end.
    parts: FxHashMap<(Class, Axis, i32, i32), Class>,
    /// By class: what was found out of it since.
    found: Vec<Found>,
    /// The numbers of sequences of slices.
    folded: FxHashMap<Vec<Token>, u32>,
    /// How many courses can be peeled off a class.
    peeled: FxHashMap<(Class, Peel), i32>,
    seams: Seams,
    fits: FxHashMap<(Class, Class, Axis), bool>,
    /// What never stands side by side for all that the examples show.
    torn: FxHashSet<(Class, Class, Axis)>,
    /// The number of air.
    pub air: u32,
    /// Whether rows of things are drawn cell by cell.
    pub draws_rows: bool,
    /// Where each volume that is no example was taken from, with other terminals, behind all examples.
    origins: Vec<Place>,
    recoloured: FxHashMap<(Class, BTreeMap<u32, u32>), Class>,
    /// By what it stands for, the terminal of each parameter.
    parameters: FxHashMap<Vec<u32>, u32>,
    /// How often it was asked for the part of a box, and what it took to tell new ones: a measure of the work done.
    pub asked: u64,
    /// Where the search is cut short.
    pub most_asked: u64,
}

impl Corpus {
    pub fn new(volumes: Vec<Volume>, air: u32) -> Corpus {
        Corpus {
            seams: Seams::of(&volumes),
            fits: FxHashMap::default(),
            torn: FxHashSet::default(),
            air,
            draws_rows: false,
            origins: Vec::new(),
            recoloured: FxHashMap::default(),
            parameters: FxHashMap::default(),
            asked: 0,
            most_asked: u64::MAX,
            volumes,
            classes: FxHashMap::default(),
            profiles: Vec::new(),
            skeletons: FxHashMap::default(),
            parts: FxHashMap::default(),
            found: Vec::new(),
            folded: FxHashMap::default(),
            peeled: FxHashMap::default(),
        }
    }

    /// Begins another search, of so much work: nothing is torn, and what was found out is known.
    pub fn begin(&mut self, most_asked: u64) {
        (self.asked, self.most_asked) = (0, most_asked);
        self.torn.clear();
    }

    /// Whether so much was looked at that the search is cut short.
    pub fn is_spent(&self) -> bool {
        self.asked > self.most_asked
    }

    pub fn volume(&self, place: Place) -> &Volume {
        &self.volumes[place.example as usize]
    }

    /// The examples, whole.
    pub fn examples(&self) -> Vec<Place> {
        let examples = self.volumes.len() - self.origins.len();
        let places = self.volumes[..examples].iter().zip(0..);
        places.map(|(volume, example)| Place { example, bounds: Bounds::of_size(volume.size()) }).collect()
    }

    pub fn profile(&self, class: Class) -> &Profile {
        &self.profiles[class.0 as usize]
    }

    /// The terminal at the low corner of a class.
    pub fn terminal(&self, class: Class) -> u32 {
        let place = self.profile(class).place;
        self.volume(place).get(place.bounds.min)
    }

    pub fn class(&mut self, place: Place) -> Class {
        let key = self.volume(place).content(place.bounds);
        if let Some(&known) = self.classes.get(&key) {
            return known;
        }
        let starts = Axis::ALL.map(|axis| self.starts(place, axis, 0..place.bounds.len(axis)));
        self.enter(key, place, starts)
    }

    /// The class of the part of a class from `low` to `high` on an axis, from its low end.
    pub fn part(&mut self, class: Class, axis: Axis, low: i32, high: i32) -> Class {
        self.asked += 1;
        if let Some(&known) = self.parts.get(&(class, axis, low, high)) {
            return known;
        }
        let Profile { place, .. } = *self.profile(class);
        let start = axis.of(place.bounds.min);
        let place = Place { bounds: place.bounds.slab(axis, start + low, start + high), ..place };
        let part = self.class_within(class, place);
        self.parts.insert((class, axis, low, high), part);
        part
    }

    /// The class of a box in a class, told from its low corner.
    pub fn inside(&mut self, class: Class, bounds: Bounds) -> Class {
        Axis::ALL.into_iter().fold(class, |class, axis| {
            let (low, high) = (axis.of(bounds.min), axis.of(bounds.max));
            match (low, high) == (0, self.profile(class).len(axis)) {
                true => class,
                false => self.part(class, axis, low, high),
            }
        })
    }

    /// How many courses can be peeled off a class, found out once.
    pub fn peeled(&mut self, class: Class, peel: Peel, find: impl FnOnce(&Corpus) -> i32) -> i32 {
        if let Some(&known) = self.peeled.get(&(class, peel)) {
            return known;
        }
        let found = find(self);
        self.peeled.insert((class, peel), found);
        found
    }

    /// The class of a place in a box of a known class: slices that are equal in all of the box are so in a part.
    fn class_within(&mut self, class: Class, place: Place) -> Class {
        let key = self.volume(place).content(place.bounds);
        if let Some(&known) = self.classes.get(&key) {
            return known;
        }
        let whole = self.profile(class);
        let starts = Axis::ALL.map(|axis| {
            let low = axis.of(place.bounds.min) - axis.of(whole.place.bounds.min);
            let inside = whole.starts(axis).iter().map(|at| at - low);
            let inside = inside.filter(|at| (1..place.bounds.len(axis)).contains(at));
            let from_start = std::iter::once(0).chain(inside);
            let others = axis.others();
            match others.into_iter().all(|other| place.bounds.len(other) == whole.len(other)) {
                true => from_start.collect(),
                false => self.starts(place, axis, from_start),
            }
        });
        self.enter(key, place, starts)
    }

    /// Numbers a content that is new.
    fn enter(&mut self, key: Content, place: Place, starts: [SmallVec<[i32; 8]>; 3]) -> Class {
        let skeleton = self.skeleton(place, &starts);
        self.asked += starts.iter().map(|starts| starts.len() as u64).product::<u64>() / CELLS;
        self.asked += starts.iter().map(|starts| starts.len() as u64).sum::<u64>();
        let class = Class(self.profiles.len() as u32);
        self.profiles.push(Profile { place, starts, skeleton });
        self.found.push(Found::default());
        self.classes.insert(key, class);
        class
    }

    /// Whether a plane goes through a whole of two blocks.
    pub fn is_whole_across(&self, class: Class, axis: Axis, at: i32) -> bool {
        let place = self.profile(class).place;
        self.volume(place).is_whole_across(place.bounds, axis, axis.of(place.bounds.min) + at)
    }

    /// Whether two boxes could stand one behind the other: where they meet they show nothing that no example
    /// shows. `None` if they differ in size across the axis.
    pub fn fit(&mut self, left: Class, right: Class, axis: Axis) -> Option<bool> {
        let [last, first] = self.ends(left, right, axis);
        if self.torn.contains(&(last, first, axis)) {
            return Some(false);
        }
        if let Some(&known) = self.fits.get(&(last, first, axis)) {
            return Some(known);
        }
        let [one, other] = [last, first].map(|class| self.profile(class).place);
        if one.bounds.size() != other.bounds.size() {
            return None;
        }
        let fits = self.seams.fit((self.volume(one), one.bounds), (self.volume(other), other.bounds), axis);
        self.fits.insert((last, first, axis), fits);
        Some(fits)
    }

    /// The last slice of the left box and the first of the right one.
    pub fn ends(&mut self, left: Class, right: Class, axis: Axis) -> [Class; 2] {
        let len = self.profile(left).len(axis);
        [self.part(left, axis, len - 1, len), self.part(right, axis, 0, 1)]
    }

    /// Boxes that end in `last` never stand before boxes that begin with `first` any more; whether that is new.
    pub fn tear(&mut self, last: Class, first: Class, axis: Axis) -> bool {
        self.torn.insert((last, first, axis))
    }

    /// The class of a box with other terminals.
    pub fn recoloured(&mut self, class: Class, map: &BTreeMap<u32, u32>) -> Class {
        let key = (class, map.clone());
        if let Some(&known) = self.recoloured.get(&key) {
            return known;
        }
        let place = self.profile(class).place;
        let other = |terminal| map.get(&terminal).copied().unwrap_or(terminal);
        let volume = self.volume(place).recoloured(place.bounds, other);
        self.asked += place.bounds.volume();
        self.seams.add(&volume);
        let bounds = Bounds::of_size(volume.size());
        let example = self.volumes.len() as u32;
        let origin = self.origin(place);
        self.volumes.push(volume);
        self.origins.push(origin);
        let recoloured = self.class(Place { example, bounds });
        self.recoloured.insert(key, recoloured);
        recoloured
    }

    /// Where a box was in an example, before it had other terminals.
    pub fn origin(&self, place: Place) -> Place {
        let examples = self.volumes.len() - self.origins.len();
        match (place.example as usize).checked_sub(examples).and_then(|number| self.origins.get(number)) {
            Some(whole) => {
                let Bounds { min, max } = place.bounds;
                let bounds = Bounds::new(min + whole.bounds.min, max + whole.bounds.min);
                Place { example: whole.example, bounds }
            }
            None => place,
        }
    }

    /// The terminal of the parameter that stands for these terminals.
    pub fn parameter(&mut self, stands_for: &[u32]) -> u32 {
        let next = PARAMETER + self.parameters.len() as u32;
        *self.parameters.entry(stands_for.to_vec()).or_insert(next)
    }

    pub fn pattern(&mut self, class: Class) -> Rc<Pattern> {
        if let Some(known) = &self.found(class).pattern {
            return known.clone();
        }
        let Profile { place, starts, .. } = self.profile(class);
        let mut order: Vec<u32> = Vec::new();
        let mut numbers: Vec<u32> = starts.iter().map(|starts| starts.len() as u32).collect();
        for terminal in cells(self.volume(*place), place.bounds.min, starts) {
            let number = order.iter().position(|known| *known == terminal);
            numbers.push(number.unwrap_or(order.len()) as u32);
            if number.is_none() {
                order.push(terminal);
            }
        }
        let pattern = Rc::new(Pattern { numbers: numbers.into(), order });
        self.found_mut(class).pattern = Some(pattern.clone());
        pattern
    }

    fn found(&self, class: Class) -> &Found {
        &self.found[class.0 as usize]
    }

    fn found_mut(&mut self, class: Class) -> &mut Found {
        &mut self.found[class.0 as usize]
    }

    /// The skeletons of the slices across an axis, those left out that equal the one before.
    pub fn slices(&mut self, class: Class, axis: Axis) -> Rc<[Skeleton]> {
        if let Some(known) = &self.found(class).slices[axis.index()] {
            return known.clone();
        }
        let starts = self.profile(class).starts[axis.index()].clone();
        let slice = |corpus: &mut Corpus, at: &i32| {
            let class = corpus.part(class, axis, *at, *at + 1);
            corpus.profile(class).skeleton
        };
        let slices: Rc<[Skeleton]> = starts.iter().map(|at| slice(self, at)).collect();
        self.found_mut(class).slices[axis.index()] = Some(slices.clone());
        slices
    }

    /// The slices that differ from the one before, as one number.
    pub fn sequence(&mut self, class: Class, axis: Axis) -> Sequence {
        if let Some(known) = self.found(class).sequences[axis.index()] {
            return known;
        }
        let folded = folded(&self.slices(class, axis));
        let pieces = folded.len() as u32;
        let next = self.folded.len() as u32;
        let sequence = Sequence { number: *self.folded.entry(folded).or_insert(next), pieces };
        self.found_mut(class).sequences[axis.index()] = Some(sequence);
        sequence
    }

    /// The classes of all slices across an axis.
    pub fn row(&mut self, class: Class, axis: Axis) -> Rc<[Class]> {
        if let Some(known) = &self.found(class).rows[axis.index()] {
            return known.clone();
        }
        let len = self.profile(class).len(axis);
        let starts = self.profile(class).starts[axis.index()].clone();
        let mut row = Vec::with_capacity(len as usize);
        for (number, at) in starts.iter().enumerate() {
            let slice = self.part(class, axis, *at, at + 1);
            let end = starts.get(number + 1).copied().unwrap_or(len);
            row.extend((*at..end).map(|_| slice));
        }
        let row: Rc<[Class]> = row.into();
        self.found_mut(class).rows[axis.index()] = Some(row.clone());
        row
    }

    /// The terminals in a class, in order of their numbers.
    pub fn terminals(&mut self, class: Class) -> Rc<[u32]> {
        if let Some(known) = &self.found(class).terminals {
            return known.clone();
        }
        let Profile { place, starts, .. } = self.profile(class);
        let mut all: Vec<u32> = cells(self.volume(*place), place.bounds.min, starts).collect();
        all.sort_unstable();
        all.dedup();
        let all: Rc<[u32]> = all.into();
        self.found_mut(class).terminals = Some(all.clone());
        all
    }

    /// Where slices differ from the one before, of some that may.
    fn starts(&self, place: Place, axis: Axis, all: impl Iterator<Item = i32>) -> SmallVec<[i32; 8]> {
        let (volume, bounds) = (self.volume(place), place.bounds);
        let low = axis.of(bounds.min);
        let mut before = None;
        let differs = |at: &i32| {
            let own = Some(volume.content(bounds.slab(axis, low + at, low + at + 1)));
            std::mem::replace(&mut before, own) != own
        };
        all.filter(differs).collect()
    }

    fn skeleton(&mut self, place: Place, starts: &[SmallVec<[i32; 8]>; 3]) -> Skeleton {
        let volume = &self.volumes[place.example as usize];
        let min = place.bounds.min;
        let mut hasher = FxHasher::default();
        starts.iter().for_each(|starts| hasher.write_usize(starts.len()));
        let mut sum = hasher.finish();
        for terminal in cells(volume, min, starts) {
            let terminal = u64::from(terminal);
            sum = (sum.rotate_left(5) ^ terminal.wrapping_add(1)).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        }
        let next = Skeleton(self.skeletons.len() as u32);
        *self.skeletons.entry(sum).or_insert(next)
    }
}

/// The terminals where slices differ on all axes, from the low end of a box.
fn cells(volume: &Volume, min: Cell, starts: &[SmallVec<[i32; 8]>; 3]) -> impl Iterator<Item = u32> {
    let [xs, ys, zs] = starts;
    let rows = ys.iter().flat_map(move |y| zs.iter().map(move |z| (*y, *z)));
    rows.flat_map(move |(y, z)| xs.iter().map(move |x| volume.get(min + Cell::new(*x, y, z))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use ndarray::Array3;
    use proptest::prelude::*;

    proptest! {
        /// What is told of a part by way of the whole is what is told of the place itself.
        #[test]
        fn parts_are_what_stands_there(
            cells in prop::collection::vec(0u32..2, 60),
            cuts in prop::collection::vec((0usize..3, 0i32..5, 1i32..5), 1..4),
        ) {
            let volume = Volume::new(Array3::from_shape_vec((3, 4, 5), cells).unwrap_or_default(), &[]);
            let mut corpus = Corpus::new(vec![volume.clone()], 0);
            let mut place = corpus.examples()[0];
            let mut class = corpus.class(place);
            for (axis, low, len) in cuts {
                let axis = Axis::ALL[axis];
                let low = low.min(place.bounds.len(axis) - 1);
                let high = (low + len).min(place.bounds.len(axis));
                let start = axis.of(place.bounds.min);
                place.bounds = place.bounds.slab(axis, start + low, start + high);
                class = corpus.part(class, axis, low, high);
            }
            let mut afresh = Corpus::new(vec![volume], 0);
            let own = afresh.class(place);
            prop_assert_eq!(&corpus.profile(class).starts, &afresh.profile(own).starts);
            prop_assert_eq!(corpus.terminals(class), afresh.terminals(own));
            prop_assert_eq!(corpus.profile(class).place.bounds.size(), place.bounds.size());
        }
    }
}
