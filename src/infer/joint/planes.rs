//! Planes that cut all boxes of a rule, each given in one way for all of them.

use super::boxes::Boxes;
use super::corpus::Corpus;
use crate::space::Axis;
use std::collections::BTreeSet;

/// Bits of a plane at a fixed distance from an end of the box.
pub const FIXED: f64 = 7.0;
/// Bits of one at a fixed share of its length.
const SHARE: f64 = 9.0;
/// Bits of one that is free, beside those of where it stands.
const FREE: f64 = 11.0;

/// Where a plane cuts each class, in order, and the bits of saying so.
#[derive(Clone, PartialEq, Debug)]
pub struct Plane {
    pub axis: Axis,
    pub at: Vec<i32>,
    pub stands: Stands,
    pub bits: f64,
}

/// Whether it can be told from the length of a box where a plane stands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Stands {
    /// At one distance from an end, or at one share.
    ByLaw,
    Freely,
}

impl Plane {
    /// The boxes on both sides.
    pub fn halves(&self, corpus: &mut Corpus, boxes: &Boxes) -> [Boxes; 2] {
        let mut below = self.at.iter();
        let mut above = self.at.iter();
        [
            boxes.parts(corpus, self.axis, |_, _| (0, below.next().copied().unwrap_or(0))),
            boxes.parts(corpus, self.axis, |corpus, class| {
                (above.next().copied().unwrap_or(0), corpus.profile(class).len(self.axis))
            }),
        ]
    }
}

/// All planes: at one distance from either end, or at the change of that number from either end. Each changes
/// something in one box at least, and goes through no whole of two blocks, if there are such planes.
pub fn planes(corpus: &Corpus, boxes: &Boxes) -> Vec<Plane> {
    let sparing =
        Axis::ALL.into_iter().flat_map(|axis| across(corpus, boxes, axis, true)).collect::<Vec<Plane>>();
    match sparing.is_empty() {
        true => Axis::ALL.into_iter().flat_map(|axis| across(corpus, boxes, axis, false)).collect(),
        false => sparing,
    }
}

fn across(corpus: &Corpus, boxes: &Boxes, axis: Axis, spares_wholes: bool) -> Vec<Plane> {
    let lens: Vec<i32> = boxes.classes().map(|class| corpus.profile(class).len(axis)).collect();
    let starts: Vec<&[i32]> = boxes.classes().map(|class| corpus.profile(class).starts(axis)).collect();
    let changes = || {
        starts.iter().zip(&lens).flat_map(|(starts, len)| starts[1..].iter().map(move |at| (*at, len - at)))
    };
    let mut ways: BTreeSet<Vec<i32>> = BTreeSet::new();
    for from_start in changes().map(|(at, _)| at).collect::<BTreeSet<i32>>() {
        ways.insert(lens.iter().map(|_| from_start).collect());
    }
    for from_end in changes().map(|(_, behind)| behind).collect::<BTreeSet<i32>>() {
        ways.insert(lens.iter().map(|len| len - from_end).collect());
    }
    let fewest = starts.iter().map(|starts| starts.len()).min().unwrap_or(0);
    for number in 1..fewest {
        ways.insert(starts.iter().map(|starts| starts[number]).collect());
        ways.insert(starts.iter().map(|starts| starts[starts.len() - number]).collect());
    }
    let is_inside = |way: &Vec<i32>| way.iter().zip(&lens).all(|(at, len)| *at > 0 && at < len);
    let spares = |way: &Vec<i32>| {
        let mut cuts = boxes.classes().zip(way);
        cuts.all(|(class, at)| !corpus.is_whole_across(class, axis, *at))
    };
    let ways = ways.into_iter().filter(|way| is_inside(way) && (!spares_wholes || spares(way)));
    let plane = |at: Vec<i32>| {
        let (stands, bits) = bits(boxes, &at, &lens);
        Plane { axis, at, stands, bits }
    };
    ways.map(plane).collect()
}

fn bits(boxes: &Boxes, at: &[i32], lens: &[i32]) -> (Stands, f64) {
    let is_one = |mut values: Box<dyn Iterator<Item = i32> + '_>| {
        let first = values.next();
        values.all(|value| Some(value) == first)
    };
    if is_one(Box::new(at.iter().copied())) || is_one(Box::new(at.iter().zip(lens).map(|(at, len)| len - at)))
    {
        return (Stands::ByLaw, FIXED);
    }
    if is_share(at, lens) {
        return (Stands::ByLaw, SHARE);
    }
    let values = |from_end: bool| {
        let all = at.iter().zip(lens).map(move |(at, len)| if from_end { len - at } else { *at });
        all.collect::<BTreeSet<i32>>().len()
    };
    (Stands::Freely, FREE + f64::from(boxes.count()) * (values(false).min(values(true)) as f64).log2())
}

/// Whether the plane stands at one share of every length, as rounding has it.
fn is_share(at: &[i32], lens: &[i32]) -> bool {
    const PARTS: i32 = 6;
    let shares = (2..=PARTS).flat_map(|parts| (1..parts).map(move |share| (share, parts)));
    let stands = |share: i32, parts: i32| {
        at.iter().zip(lens).all(|(at, len)| (2 * (at * parts - share * len)).abs() <= parts)
    };
    shares.into_iter().any(|(share, parts)| stands(share, parts))
}
