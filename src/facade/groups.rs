//! Bottom-up: every rectangle of leaves that smaller ones make up (seed 4, sections 5.0.3 and 5.0.4).

use super::cuts::{Cutter, StructureId, Structures};
use super::{Region, Side};
use rustc_hash::{FxHashMap, FxHashSet};

/// A rectangle of leaves.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Group {
    pub region: Region,
    pub structure: StructureId,
    /// How many leaves it holds.
    pub leaves: u32,
}

/// All groups of a layout, the smallest first.
#[derive(Clone, Debug, Default)]
pub struct Groups {
    pub list: Vec<Group>,
    /// How often each structure stands, by its id.
    pub times: Vec<u32>,
    /// Whether there were more than were looked for.
    pub is_cut_short: bool,
}

/// A full grid of n by n windows has n^4 / 4 groups: more than this are not looked for.
const MOST: usize = 50_000;

impl Groups {
    /// Joins neighbours that share a whole side, those with fewer leaves first. Every group is found once,
    /// from whichever two parts it is made first.
    pub fn of(cutter: &Cutter, structures: &mut Structures) -> Groups {
        let mut finder = Finder::default();
        for leaf in cutter.leaves() {
            finder.add(*leaf, 1);
        }
        let mut size = 1;
        while size < finder.by_size.len() && !finder.is_full() {
            let mut at = 0;
            // Joining adds groups of more leaves only.
            while at < finder.by_size[size].len() && !finder.is_full() {
                let region = finder.by_size[size][at];
                finder.join(region, size as u32);
                at += 1;
            }
            size += 1;
        }
        let is_cut_short = finder.is_full();
        let mut list = Vec::with_capacity(finder.seen.len());
        for (leaves, regions) in finder.by_size.iter().enumerate() {
            for region in regions {
                if let Ok(structure) = structures.of(cutter, region) {
                    list.push(Group { region: *region, structure, leaves: leaves as u32 });
                }
            }
        }
        let mut times = vec![0; structures.count()];
        list.iter().for_each(|group| times[group.structure as usize] += 1);
        Groups { list, times, is_cut_short }
    }

    /// Those that hold several leaves and stand more than once in structure.
    pub fn repeated(&self) -> impl Iterator<Item = &Group> {
        self.list.iter().filter(|group| group.leaves > 1 && self.times[group.structure as usize] > 1)
    }

    /// How many structures and groups there are, as seed 4 counts them: single leaves are groups as well.
    pub fn counts(&self) -> Counts {
        let structures: FxHashSet<StructureId> = self.list.iter().map(|group| group.structure).collect();
        let repeated = self.list.iter().filter(|group| self.times[group.structure as usize] > 1).count();
        Counts { structures: structures.len(), groups: self.list.len(), repeated }
    }
}

/// How many groups a layout has.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Counts {
    /// Of different structures.
    pub structures: usize,
    pub groups: usize,
    /// Groups whose structure stands more than once.
    pub repeated: usize,
}

type SideOf = (Side, bool, u32, [u32; 2]);

#[derive(Default)]
struct Finder {
    seen: FxHashSet<Region>,
    /// Groups by their number of leaves.
    by_size: Vec<Vec<Region>>,
    /// Groups by a side that another may share: its axis, whether it is the high one, where it stands and its ends.
    by_side: FxHashMap<SideOf, Vec<(Region, u32)>>,
}

impl Finder {
    fn is_full(&self) -> bool {
        self.seen.len() >= MOST
    }

    fn add(&mut self, region: Region, leaves: u32) {
        if self.is_full() || !self.seen.insert(region) {
            return;
        }
        let size = leaves as usize;
        if self.by_size.len() <= size {
            self.by_size.resize(size + 1, Vec::new());
        }
        self.by_size[size].push(region);
    }

    /// Joins a group with all those of as many leaves or fewer that stand beside it.
    fn join(&mut self, region: Region, leaves: u32) {
        for axis in Side::ALL {
            let [low, high] = region.sides[axis.index()];
            let ends = region.sides[axis.other().index()];
            // From now on it can be found, also by itself: it is no neighbour of itself.
            self.by_side.entry((axis, false, low, ends)).or_default().push((region, leaves));
            self.by_side.entry((axis, true, high, ends)).or_default().push((region, leaves));
            let after = self.by_side.get(&(axis, false, high, ends)).cloned().unwrap_or_default();
            let before = self.by_side.get(&(axis, true, low, ends)).cloned().unwrap_or_default();
            for (other, more) in after {
                self.add(region.part(axis, low, other.sides[axis.index()][1]), leaves + more);
            }
            for (other, more) in before {
                self.add(region.part(axis, other.sides[axis.index()][0], high), leaves + more);
            }
        }
    }
}
