use super::{Entity, Grid, Metadata};
use crate::block::{BlockState, complete};
use crate::nbt::{Compound, Name};
use crate::space::{Bounds, Cell};
use std::collections::{BTreeMap, BTreeSet};

/// What is different between two builds, both seen from their low corners.
#[derive(Clone, PartialEq, Debug)]
pub struct Diff {
    pub sizes: [Cell; 2],
    /// Within what both have, the most frequent first.
    pub blocks: Vec<BlockDiff>,
    /// Places whose block entities are not the same.
    pub block_entities: Vec<Cell>,
    /// Entities that only the one or the other has.
    pub entities: [Vec<Entity>; 2],
    /// What else is not the same, by name.
    pub metadata: BTreeSet<String>,
}

/// A block that stands where the other build has another.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct BlockDiff {
    pub states: [BlockState; 2],
    pub count: u64,
    /// Where it is so first.
    pub first: Cell,
}

impl Diff {
    /// Absent properties mean a block's defaults, in whatever way the two are written.
    pub fn of(a: &Grid, b: &Grid) -> Diff {
        Diff {
            sizes: [a.size(), b.size()],
            blocks: blocks(a, b),
            block_entities: changed(&a.block_entities, &b.block_entities),
            entities: [only_in(a, b), only_in(b, a)],
            metadata: metadata(a, b),
        }
    }

    pub fn is_none(&self) -> bool {
        let [a, b] = self.sizes;
        let empty = self.blocks.is_empty() && self.block_entities.is_empty() && self.metadata.is_empty();
        a == b && empty && self.entities.iter().all(Vec::is_empty)
    }
}

fn blocks(a: &Grid, b: &Grid) -> Vec<BlockDiff> {
    let states = [a, b].map(|grid| grid.palette.states().iter().map(complete).collect::<Vec<_>>());
    let ids = shared_ids(&states);
    let common = Bounds::of_size(a.size().min(b.size()));
    let mut found: BTreeMap<[u16; 2], (u64, Cell)> = BTreeMap::new();
    for cell in common.cells() {
        let pair = [a.id(cell), b.id(cell)];
        if ids[0][usize::from(pair[0])] != ids[1][usize::from(pair[1])] {
            found.entry(pair).or_insert((0, cell)).0 += 1;
        }
    }
    let mut blocks: Vec<BlockDiff> = found
        .into_iter()
        .map(|([from, to], (count, first))| {
            let states = [&states[0][usize::from(from)], &states[1][usize::from(to)]].map(Clone::clone);
            BlockDiff { states, count, first }
        })
        .collect();
    blocks.sort_by(|x, y| y.count.cmp(&x.count).then_with(|| x.states.cmp(&y.states)));
    blocks
}

/// A number for each state of both palettes, equal where the states are.
fn shared_ids(states: &[Vec<BlockState>; 2]) -> [Vec<u32>; 2] {
    let all: BTreeSet<&BlockState> = states.iter().flatten().collect();
    let numbers: BTreeMap<&BlockState, u32> = all.into_iter().zip(0..).collect();
    states.each_ref().map(|states| states.iter().map(|state| numbers[state]).collect())
}

fn changed(a: &BTreeMap<[i32; 3], Compound>, b: &BTreeMap<[i32; 3], Compound>) -> Vec<Cell> {
    let places: BTreeSet<&[i32; 3]> = a.keys().chain(b.keys()).collect();
    let changed = places.into_iter().filter(|place| a.get(*place) != b.get(*place));
    changed.map(|place| Cell::from_array(*place)).collect()
}

/// The entities of `a` that `b` has no equal of, or not as many.
fn only_in(a: &Grid, b: &Grid) -> Vec<Entity> {
    let mut others: BTreeMap<[i64; 3], Vec<&Entity>> = BTreeMap::new();
    for other in &b.metadata.entities {
        others.entry(block_of(other.place)).or_default().push(other);
    }
    let mut is_alone = |entity: &&Entity| {
        let around = blocks_around(entity.place);
        !around.into_iter().any(|block| others.get_mut(&block).is_some_and(|there| take(there, entity)))
    };
    a.metadata.entities.iter().filter(|entity| is_alone(entity)).cloned().collect()
}

/// Takes the equal of `entity` out; whether there was one.
fn take(others: &mut Vec<&Entity>, entity: &Entity) -> bool {
    let found = others.iter().position(|other| is_same(other, entity));
    found.map(|at| others.swap_remove(at)).is_some()
}

/// Formats count places from different points, so sums round.
const NEAR: f64 = 1e-6;

fn is_same(a: &Entity, b: &Entity) -> bool {
    a.data == b.data && a.place.iter().zip(b.place).all(|(a, b)| (a - b).abs() < NEAR)
}

/// The block that a place is in.
fn block_of(place: [f64; 3]) -> [i64; 3] {
    place.map(|n| n.floor() as i64)
}

/// The blocks that the place of an equal may be in: on the line between two it is in either.
fn blocks_around(place: [f64; 3]) -> BTreeSet<[i64; 3]> {
    let corners = (0..8).map(|corner| {
        let off = |axis: usize| if corner >> axis & 1 == 0 { -NEAR } else { NEAR };
        block_of([place[0] + off(0), place[1] + off(1), place[2] + off(2)])
    });
    corners.collect()
}

/// A single region is one whole by another name.
fn metadata(a: &Grid, b: &Grid) -> BTreeSet<String> {
    let (x, y): (&Metadata, &Metadata) = (&a.metadata, &b.metadata);
    let fields = [
        ("data version", x.data_version == y.data_version),
        ("offset", x.offset == y.offset),
        ("biomes", x.biomes == y.biomes),
        ("regions", x.regions == y.regions || [x, y].iter().all(|one| one.regions.len() < 2)),
        ("other tags", x.own == y.own),
        ("variants", same_variants(a, b)),
    ];
    let fields = fields.into_iter().filter(|(_, same)| !same).map(|(name, _)| name.to_owned());
    let names: BTreeSet<&Name> = x.tags.keys().chain(y.tags.keys()).collect();
    let tags = names.into_iter().filter(|name| x.tags.get(name) != y.tags.get(name));
    fields.chain(tags.map(String::from)).collect()
}

fn same_variants(a: &Grid, b: &Grid) -> bool {
    let pairs = || a.variants.iter().zip(&b.variants);
    a.variants.len() == b.variants.len()
        && pairs().all(|(a, b)| a.size() == b.size() && blocks(a, b).is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_in_another_way_is_the_same() {
        let a = Grid::row(&["stone", "oak_slab", "air"]);
        let b = Grid::row(&["stone", "oak_slab[type=bottom]", "air"]);
        assert!(Diff::of(&a, &b).is_none());
    }

    #[test]
    fn blocks_are_counted_by_what_becomes_of_them() {
        let a = Grid::row(&["stone", "dirt", "stone", "stone"]);
        let b = Grid::row(&["glass", "dirt", "glass", "dirt", "dirt"]);
        let diff = Diff::of(&a, &b);
        let found: Vec<_> =
            diff.blocks.iter().map(|diff| (diff.count, diff.states[1].short(), diff.first.x)).collect();
        assert_eq!(found, [(2, "glass".to_owned(), 0), (1, "dirt".to_owned(), 3)]);
        assert_eq!(diff.sizes.map(|size| size.x), [4, 5]);
    }

    #[test]
    fn all_else_is_compared() {
        let cow = |x: f64| Entity { place: [x, 0.0, 0.0], block: None, data: Compound::new() };
        let (mut a, mut b) = (Grid::row(&["stone"]), Grid::row(&["stone"]));
        a.block_entities.insert([0; 3], Compound::new());
        a.metadata.entities = vec![cow(0.0), cow(0.5), cow(0.5)];
        b.metadata.entities = vec![cow(0.5), cow(0.25)];
        b.metadata.offset = Cell::X;
        b.metadata.tags.insert("Name".to_owned(), crate::nbt::Tag::Byte(1));
        b.variants.push(Grid::row(&["dirt"]));
        let diff = Diff::of(&a, &b);
        assert_eq!(diff.block_entities, [Cell::ZERO]);
        assert_eq!(diff.entities, [vec![cow(0.0), cow(0.5)], vec![cow(0.25)]]);
        let names: Vec<&String> = diff.metadata.iter().collect();
        assert_eq!(names, ["Name", "offset", "variants"]);
        assert!(!diff.is_none() && Diff::of(&b, &b).is_none());
    }
}
