//! Layouts on whole numbers: rectangles with labels that tile a rectangle.

use super::drawing::Fault;
use std::collections::BTreeMap;

/// A half-open rectangle, as the low and the high end along x and y.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Region {
    pub sides: [[u32; 2]; 2],
}

impl Region {
    pub fn len(&self, axis: Side) -> u32 {
        let [low, high] = self.sides[axis.index()];
        high - low
    }

    /// The part of it from `low` to `high`.
    pub fn part(&self, axis: Side, low: u32, high: u32) -> Region {
        let mut sides = self.sides;
        sides[axis.index()] = [low, high];
        Region { sides }
    }

    pub fn contains(&self, other: &Region) -> bool {
        self.sides.iter().zip(&other.sides).all(|(own, its)| own[0] <= its[0] && its[1] <= own[1])
    }
}

/// An axis of a layout.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Side {
    X,
    Y,
}

impl Side {
    pub const ALL: [Side; 2] = [Side::X, Side::Y];

    pub fn index(self) -> usize {
        self as usize
    }

    pub fn other(self) -> Side {
        match self {
            Side::X => Side::Y,
            Side::Y => Side::X,
        }
    }
}

/// A rectangle with a label, by its number.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Leaf {
    pub label: u32,
    pub region: Region,
}

/// Leaves that tile the rectangle from 0 to its size: no gap, no overlap, none empty.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Layout {
    size: [u32; 2],
    labels: Vec<String>,
    leaves: Vec<Leaf>,
}

impl Layout {
    /// The layout of these leaves.
    ///
    /// # Errors
    ///
    /// The first place from the left where leaves overlap or leave a gap.
    pub fn new(size: [u32; 2], labels: Vec<String>, leaves: Vec<Leaf>) -> Result<Layout, Fault> {
        tiled(size, &leaves)?;
        Ok(Layout { size, labels, leaves })
    }

    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    pub fn whole(&self) -> Region {
        Region { sides: self.size.map(|length| [0, length]) }
    }

    pub fn labels(&self) -> &[String] {
        &self.labels
    }

    pub fn leaves(&self) -> &[Leaf] {
        &self.leaves
    }

    /// The same with the labels of a longer list, in which all of its own are.
    pub(super) fn relabelled(&self, labels: &[String]) -> Layout {
        let number = |label: u32| {
            labels.iter().position(|other| *other == self.labels[label as usize]).unwrap_or(0) as u32
        };
        let numbers: Vec<u32> = (0..self.labels.len() as u32).map(number).collect();
        let leaves = self.leaves.iter().map(|leaf| Leaf { label: numbers[leaf.label as usize], ..*leaf });
        Layout { size: self.size, labels: labels.to_vec(), leaves: leaves.collect() }
    }

    /// The same leaves with every line moved. Lines keep their order, and the two of a leaf stay apart.
    pub(super) fn moved(&self, lines: &[Vec<u32>; 2]) -> Layout {
        let at = |axis: usize, line: u32| lines[axis][line as usize];
        let moved = |region: &Region| Region {
            sides: [0, 1].map(|axis| region.sides[axis].map(|line| at(axis, line))),
        };
        let leaves = self.leaves.iter().map(|leaf| Leaf { region: moved(&leaf.region), ..*leaf });
        Layout {
            size: [0, 1].map(|axis| at(axis, self.size[axis])),
            labels: self.labels.clone(),
            leaves: leaves.collect(),
        }
    }

    /// The same with the leaves of `cut` divided by a line across `axis`.
    pub(super) fn divided(&self, cut: &[usize], axis: Side, at: u32) -> Layout {
        let mut leaves = self.leaves.clone();
        for leaf in cut {
            let whole = leaves[*leaf].region;
            let [low, high] = whole.sides[axis.index()];
            leaves[*leaf].region = whole.part(axis, low, at);
            leaves.push(Leaf { region: whole.part(axis, at, high), ..leaves[*leaf] });
        }
        Layout { leaves, labels: self.labels.clone(), ..*self }
    }
}

/// Sweeps a line to the right over all leaves. What it stands on has to be whole everywhere.
fn tiled(size: [u32; 2], leaves: &[Leaf]) -> Result<(), Fault> {
    let mut starts: Vec<usize> = (0..leaves.len()).collect();
    starts.sort_by_key(|leaf| leaves[*leaf].region.sides[0][0]);
    let mut ends = starts.clone();
    ends.sort_by_key(|leaf| leaves[*leaf].region.sides[0][1]);
    // What stands on the sweeping line: leaves by their low end along y.
    let mut open: BTreeMap<u32, usize> = BTreeMap::new();
    let (mut started, mut ended) = (0, 0);
    let mut at = 0;
    while at < size[0] {
        while let Some(leaf) = ends.get(ended).filter(|leaf| leaves[**leaf].region.sides[0][1] <= at) {
            open.remove(&leaves[*leaf].region.sides[1][0]);
            ended += 1;
        }
        while let Some(leaf) = starts.get(started).filter(|leaf| leaves[**leaf].region.sides[0][0] <= at) {
            let [low, high] = leaves[*leaf].region.sides[1];
            let below = open.range(..high).next_back().map(|(_, other)| *other);
            if let Some(other) = below.filter(|other| leaves[*other].region.sides[1][1] > low) {
                return Err(Fault::Overlap(other, *leaf));
            }
            open.insert(low, *leaf);
            started += 1;
        }
        let next_start = starts.get(started).map(|leaf| leaves[*leaf].region.sides[0][0]);
        let next_end = ends.get(ended).map(|leaf| leaves[*leaf].region.sides[0][1]);
        let next = next_start.into_iter().chain(next_end).min().unwrap_or(size[0]).min(size[0]);
        let mut top = 0;
        for leaf in open.values() {
            let [low, high] = leaves[*leaf].region.sides[1];
            if low > top {
                return Err(Fault::Gap(Region { sides: [[at, next], [top, low]] }));
            }
            top = high;
        }
        if top < size[1] {
            return Err(Fault::Gap(Region { sides: [[at, next], [top, size[1]]] }));
        }
        at = next;
    }
    Ok(())
}
