//! Ways to tell boxes apart that one operation does not describe.

use super::boxes::Boxes;
use super::corpus::{Class, Corpus};
use super::fold::folded;
use crate::space::{Axis, Cell};
use std::collections::{BTreeMap, BTreeSet};
use std::hash::{DefaultHasher, Hash, Hasher};

/// More alternatives than this are told apart in steps.
const MOST: usize = 12;

/// Every partition of the boxes by a signature, with two groups at least, and each class by itself. Groups are in
/// order of their first class.
pub fn groupings(corpus: &mut Corpus, boxes: &Boxes) -> Vec<Vec<Boxes>> {
    let mut found: Vec<Vec<Boxes>> = Vec::new();
    let terminals: BTreeSet<u32> = boxes.classes().flat_map(|class| terminals(corpus, class)).collect();
    let holds = terminals.into_iter().map(Signature::Holds);
    for signature in SIGNATURES.into_iter().map(Signature::Of).chain(holds) {
        let mut groups: BTreeMap<u64, Vec<(Class, u32)>> = BTreeMap::new();
        let mut order: Vec<u64> = Vec::new();
        for (class, count) in boxes.iter() {
            let key = signature.of(corpus, class);
            let group = groups.entry(key).or_insert_with(|| {
                order.push(key);
                Vec::new()
            });
            group.push((class, count));
        }
        let parted: Vec<Boxes> = order.iter().map(|key| Boxes::of(groups[key].iter().copied())).collect();
        if (2..=MOST).contains(&parted.len()) && !found.contains(&parted) {
            found.push(parted);
        }
    }
    let alone = boxes.each();
    if alone.len() > 1 && !found.contains(&alone) {
        found.push(alone);
    }
    found
}

/// What boxes are told apart by.
enum Signature {
    Of(fn(&mut Corpus, Class) -> u64),
    /// Whether there is a terminal.
    Holds(u32),
}

impl Signature {
    fn of(&self, corpus: &mut Corpus, class: Class) -> u64 {
        match self {
            Signature::Of(label) => label(corpus, class),
            Signature::Holds(terminal) => u64::from(terminals(corpus, class).contains(terminal)),
        }
    }
}

const SIGNATURES: [fn(&mut Corpus, Class) -> u64; 16] = [
    |corpus, class| u64::from(corpus.profile(class).skeleton.0),
    |corpus, class| hash(&folded(&corpus.slices(class, Axis::X))),
    |corpus, class| hash(&folded(&corpus.slices(class, Axis::Y))),
    |corpus, class| hash(&folded(&corpus.slices(class, Axis::Z))),
    |corpus, class| hash(&Axis::ALL.map(|axis| corpus.profile(class).starts(axis).len())),
    |corpus, class| corpus.profile(class).starts(Axis::X).len() as u64,
    |corpus, class| corpus.profile(class).starts(Axis::Y).len() as u64,
    |corpus, class| corpus.profile(class).starts(Axis::Z).len() as u64,
    |corpus, class| hash(&corpus.slices(class, Axis::X).first()),
    |corpus, class| hash(&corpus.slices(class, Axis::X).last()),
    |corpus, class| hash(&corpus.slices(class, Axis::Y).first()),
    |corpus, class| hash(&corpus.slices(class, Axis::Y).last()),
    |corpus, class| hash(&corpus.slices(class, Axis::Z).first()),
    |corpus, class| hash(&corpus.slices(class, Axis::Z).last()),
    |corpus, class| match corpus.profile(class).is_uniform() {
        true => u64::from(corpus.terminal(class)) + 1,
        false => 0,
    },
    materials,
];

/// Which terminals there are, as one number.
pub fn materials(corpus: &mut Corpus, class: Class) -> u64 {
    hash(&terminals(corpus, class))
}

pub fn terminals(corpus: &Corpus, class: Class) -> BTreeSet<u32> {
    let profile = corpus.profile(class);
    let (place, starts) = (profile.place, &profile.starts);
    let volume = corpus.volume(place);
    let mut all = BTreeSet::new();
    for &y in &starts[1] {
        for &z in &starts[2] {
            all.extend(starts[0].iter().map(|&x| volume.get(place.bounds.min + Cell::new(x, y, z))));
        }
    }
    all
}

/// With fixed keys, so that it is the same in every run.
fn hash(value: &impl Hash) -> u64 {
    let mut hasher = DefaultHasher::new();
    value.hash(&mut hasher);
    hasher.finish()
}
