//! Boxes that are the same in other materials: one description, whose blocks are parameters.

use super::boxes::Boxes;
use super::corpus::{Class, Corpus, Pattern};
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// So many groups of boxes are told apart by their materials, of so many blocks of their own at the most.
const MOST_GROUPS: usize = 8;
const MOST_OWN: usize = 8;
/// Bits of a call, and of each block that it hands over.
pub const CALL: f64 = 4.0;
pub const ARGUMENT: f64 = 6.0;

/// Boxes in their own materials.
#[derive(Clone, Debug)]
pub struct Recoloured {
    /// What stands for each parameter in these boxes.
    pub arguments: Vec<u32>,
    /// Every class with the one that has parameters in its place.
    pub classes: Vec<(Class, Class, u32)>,
}

impl Recoloured {
    /// The boxes with parameters for blocks.
    fn boxes(&self) -> impl Iterator<Item = (Class, u32)> {
        self.classes.iter().map(|(_, class, count)| (*class, *count))
    }

    pub fn count(&self) -> u32 {
        self.classes.iter().map(|(.., count)| count).sum()
    }
}

/// Groups of boxes that differ in their materials.
#[derive(Clone, Debug)]
pub struct Recolouring {
    /// The terminals that stand for the parameters.
    pub parameters: Vec<u32>,
    pub groups: Vec<Recoloured>,
}

impl Recolouring {
    /// Of boxes that are made of so many kinds of blocks; the other blocks are equal in all of them.
    pub fn of(corpus: &mut Corpus, boxes: &Boxes) -> Option<Recolouring> {
        let groups = groups(corpus, boxes)?;
        let maps = maps(corpus, &groups)?;
        let columns = columns(&groups, &maps);
        if columns.is_empty() {
            return None;
        }
        let parameters: Vec<u32> = columns.iter().map(|column| corpus.parameter(column)).collect();
        let groups = groups.iter().enumerate().map(|(number, group)| {
            let arguments: Vec<u32> = columns.iter().map(|column| column[number]).collect();
            let map: BTreeMap<u32, u32> = arguments.iter().copied().zip(parameters.iter().copied()).collect();
            let recoloured =
                |(class, count): &(Class, u32)| (*class, corpus.recoloured(*class, &map), *count);
            Recoloured { classes: group.classes.iter().map(recoloured).collect(), arguments }
        });
        Some(Recolouring { groups: groups.collect(), parameters })
    }

    /// Every box with parameters for blocks, by the number of its materials.
    pub fn called(&self) -> Vec<(u64, Class, u32)> {
        let groups = (0..).zip(&self.groups);
        groups
            .flat_map(|(number, group)| group.boxes().map(move |(class, count)| (number, class, count)))
            .collect()
    }

    /// All boxes with parameters for blocks.
    pub fn boxes(&self) -> Boxes {
        Boxes::of(self.groups.iter().flat_map(Recoloured::boxes))
    }

    /// The number of the group that each class of some of the boxes goes with. One that looks the same in the blocks of
    /// several groups goes with most of the others: a wall without windows tells nothing of their glass.
    pub fn shared_out(&self, corpus: &mut Corpus, boxes: &Boxes) -> BTreeMap<Class, usize> {
        let own: BTreeMap<Class, usize> = self
            .groups
            .iter()
            .enumerate()
            .flat_map(|(number, group)| group.classes.iter().map(move |(class, ..)| (*class, number)))
            .collect();
        let all: Vec<(Class, u32, Vec<usize>)> = boxes
            .iter()
            .filter_map(|(class, count)| {
                Some((class, count, self.looks_like(corpus, class, *own.get(&class)?)))
            })
            .collect();
        let sure = |number: usize| -> u32 {
            all.iter().filter(|(.., groups)| *groups == [number]).map(|(_, count, _)| count).sum()
        };
        let likeliest =
            |groups: &[usize]| groups.iter().copied().max_by_key(|number| (sure(*number), Reverse(*number)));
        all.iter().filter_map(|(class, _, groups)| Some((*class, likeliest(groups)?))).collect()
    }

    /// The classes that the group of that number describes, its own and those that look the same in its blocks, each with
    /// the one that has parameters.
    pub fn described(&self, corpus: &mut Corpus, number: usize) -> Vec<(Class, Class)> {
        let all = self.groups.iter().enumerate().flat_map(|(own, group)| {
            group.classes.iter().map(move |(class, other, _)| (own, *class, *other))
        });
        let described = all.filter(|(own, class, _)| self.looks_like(corpus, *class, *own).contains(&number));
        described.map(|(_, class, other)| (class, other)).collect()
    }

    /// The groups in whose blocks a class of the group `own` looks the same.
    fn looks_like(&self, corpus: &mut Corpus, class: Class, own: usize) -> Vec<usize> {
        let terminals = corpus.terminals(class);
        let is_shown = |terminal: &u32| terminals.binary_search(terminal).is_ok();
        let is_alike = |other: &usize| {
            let [one, other] = [own, *other].map(|number| &self.groups[number].arguments);
            one.iter().zip(other).all(|(one, other)| one == other || (!is_shown(one) && !is_shown(other)))
        };
        (0..self.groups.len()).filter(is_alike).collect()
    }
}

/// Boxes of some materials.
struct Group {
    terminals: BTreeSet<u32>,
    classes: Vec<(Class, u32)>,
}

impl Group {
    /// The blocks that not all groups have.
    fn own(&self, common: &BTreeSet<u32>) -> BTreeSet<u32> {
        self.terminals.difference(common).copied().collect()
    }
}

/// The boxes by their materials, each with those that have some of them only.
fn groups(corpus: &mut Corpus, boxes: &Boxes) -> Option<Vec<Group>> {
    let mut by: BTreeMap<BTreeSet<u32>, Vec<(Class, u32)>> = BTreeMap::new();
    for (class, count) in boxes.iter() {
        by.entry(corpus.terminals(class).iter().copied().collect()).or_default().push((class, count));
    }
    let mut sets: Vec<BTreeSet<u32>> = by.keys().cloned().collect();
    sets.sort_by_key(|set| std::cmp::Reverse(set.len()));
    let mut groups: Vec<Group> = Vec::new();
    for set in sets {
        let classes = by.remove(&set).unwrap_or_default();
        match groups.iter_mut().find(|group| group.terminals.is_superset(&set)) {
            Some(group) => group.classes.extend(classes),
            None => groups.push(Group { terminals: set, classes }),
        }
    }
    (2..=MOST_GROUPS).contains(&groups.len()).then_some(groups)
}

/// What the blocks of each group are in the first one; those that all of them have are themselves.
fn maps(corpus: &mut Corpus, groups: &[Group]) -> Option<Vec<BTreeMap<u32, u32>>> {
    let common = groups.iter().skip(1).fold(groups[0].terminals.clone(), |common, group| {
        common.intersection(&group.terminals).copied().collect()
    });
    let own: Vec<BTreeSet<u32>> = groups.iter().map(|group| group.own(&common)).collect();
    if own.iter().any(|own| own.is_empty() || own.len() > MOST_OWN || own.contains(&corpus.air)) {
        return None;
    }
    let patterns = groups.iter().map(|group| -> Vec<Rc<Pattern>> {
        group.classes.iter().map(|(class, _)| corpus.pattern(*class)).collect()
    });
    let patterns: Vec<Vec<Rc<Pattern>>> = patterns.collect();
    let first = &patterns[0];
    let map = |patterns: &Vec<Rc<Pattern>>, own: &BTreeSet<u32>| {
        let alike = patterns.iter().flat_map(|pattern| {
            let same = first.iter().filter(|other| other.numbers == pattern.numbers);
            same.map(|other| pattern.order.iter().copied().zip(other.order.iter().copied()).collect())
        });
        let keeps =
            |map: &BTreeMap<u32, u32>| map.iter().all(|(from, to)| from == to || !common.contains(from));
        let best = alike.filter(keeps).max_by_key(BTreeMap::len);
        best.or_else(|| in_order(patterns, own, first, &groups[0].own(&common)))
    };
    patterns.iter().zip(&own).skip(1).map(|(patterns, own)| map(patterns, own)).collect()
}

/// The blocks of two groups as they come, if they are as many.
fn in_order(
    one: &[Rc<Pattern>],
    own: &BTreeSet<u32>,
    other: &[Rc<Pattern>],
    others: &BTreeSet<u32>,
) -> Option<BTreeMap<u32, u32>> {
    let order = |patterns: &[Rc<Pattern>], own: &BTreeSet<u32>| -> Option<Vec<u32>> {
        let all = patterns.iter().map(|pattern| -> Vec<u32> {
            pattern.order.iter().copied().filter(|terminal| own.contains(terminal)).collect()
        });
        all.into_iter().find(|order| order.len() == own.len())
    };
    let (from, to) = (order(one, own)?, order(other, others)?);
    (from.len() == to.len()).then(|| from.into_iter().zip(to).collect())
}

/// The blocks that are parameters: of each what it is in every group, where it is not the same in all.
fn columns(groups: &[Group], maps: &[BTreeMap<u32, u32>]) -> Vec<Vec<u32>> {
    let column = |terminal: &u32| -> Option<Vec<u32>> {
        let others = maps.iter().map(|map| map.iter().find(|(_, to)| *to == terminal).map(|(from, _)| *from));
        let column: Option<Vec<u32>> = std::iter::once(Some(*terminal)).chain(others).collect();
        column.filter(|column| column.iter().any(|own| own != terminal))
    };
    groups[0].terminals.iter().filter_map(column).collect()
}

#[cfg(test)]
mod tests {
    use super::super::corpus::{Place, is_parameter};
    use super::super::volume::Volume;
    use super::*;
    use crate::space::Bounds;
    use ndarray::Array3;

    const AIR: u32 = 0;

    fn rows(rows: &[&[u32]]) -> (Corpus, Boxes) {
        let volume = |row: &&[u32]| {
            Volume::new(Array3::from_shape_vec((1, 1, row.len()), row.to_vec()).unwrap_or_default(), &[])
        };
        let mut corpus = Corpus::new(rows.iter().map(volume).collect(), AIR);
        let places = corpus.examples();
        let boxes = Boxes::of(places.into_iter().map(|place| (corpus.class(place), 1)));
        (corpus, boxes)
    }

    #[test]
    fn what_differs_in_blocks_only_is_the_same_with_parameters() {
        let (mut corpus, boxes) = rows(&[&[1, 2, 0, 9], &[1, 1, 2, 0, 9], &[3, 4, 0, 9]]);
        let recolouring = Recolouring::of(&mut corpus, &boxes).expect("two materials");
        let mut arguments: Vec<Vec<u32>> =
            recolouring.groups.iter().map(|group| group.arguments.clone()).collect();
        arguments.sort();
        assert_eq!(arguments, [[1, 2], [3, 4]]);
        assert!(recolouring.parameters.iter().all(|parameter| is_parameter(*parameter)));
        // The first and the last row have become one.
        assert_eq!(recolouring.boxes().kinds(), 2);
        let first = recolouring.boxes().first();
        assert!(corpus.terminals(first).iter().all(|terminal| !(1..=4).contains(terminal)));
    }

    #[test]
    fn what_shows_no_material_goes_with_what_it_stands_among() {
        let (mut corpus, boxes) = rows(&[&[1, 2, 1], &[1, 3, 1], &[1, 3, 3, 1], &[1, 1]]);
        let recolouring = Recolouring::of(&mut corpus, &boxes).expect("two materials");
        let class: Vec<Class> = corpus.examples().into_iter().map(|place| corpus.class(place)).collect();
        for (others, number) in [([0, 3], 0), ([1, 3], 1)] {
            let some = Boxes::of(others.map(|other| (class[other], 1)));
            let shared_out = recolouring.shared_out(&mut corpus, &some);
            assert_eq!(shared_out[&class[3]], shared_out[&class[others[0]]]);
            assert_eq!(recolouring.groups[shared_out[&class[3]]].arguments, [[2], [3]][number]);
        }
    }

    #[test]
    fn boxes_with_parameters_know_where_they_come_from() {
        let (mut corpus, boxes) = rows(&[&[1, 2, 0], &[3, 4, 0]]);
        let recolouring = Recolouring::of(&mut corpus, &boxes).expect("two materials");
        let place = corpus.profile(recolouring.boxes().first()).place;
        let part = Place { bounds: place.bounds.slab(crate::space::Axis::X, 1, 2), ..place };
        let origin = corpus.origin(part);
        assert!(origin.example < 2);
        assert_eq!(origin.bounds, Bounds::of_size(place.bounds.size()).slab(crate::space::Axis::X, 1, 2));
    }

    #[test]
    fn what_is_of_the_same_blocks_or_of_air_is_not_told_apart_by_materials() {
        for all in [&[&[1u32, 2, 0][..], &[1, 1, 2, 0]][..], &[&[1, 2], &[1, 0]], &[&[1], &[1, 1]]] {
            let (mut corpus, boxes) = rows(all);
            assert!(Recolouring::of(&mut corpus, &boxes).is_none(), "{all:?}");
        }
    }
}
