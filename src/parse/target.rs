//! What has to be derived: blocks, or labelled boxes.

use super::states::{KindId, States};
use crate::block::PaletteFull;
use crate::grid::{BoxHashes, Content, Grid, LabelledBoxes};
use crate::neighbours::{settle, unsettle};
use crate::space::{Axis, Bounds, Cell, Corners, Turn};
use fixedbitset::FixedBitSet;
use rstar::{RTree, RTreeObject};
use rustc_hash::FxHashMap;
use std::cell::RefCell;
use std::rc::Rc;

/// A building to find a derivation of.
#[derive(Debug)]
pub enum Target<'e> {
    Blocks(Blocks),
    Boxes(Placed<'e>),
}

/// The blocks of a grid by their kinds.
#[derive(Clone, Debug)]
pub struct Blocks {
    size: Cell,
    /// In the order of schematic files.
    kinds: Vec<KindId>,
    hashes: BoxHashes,
    /// How many cells that are not air lie between the low corner and each corner.
    solid: Vec<u32>,
}

/// Labelled boxes by their place. No array of the container: it may be far larger than what stands in it.
#[derive(Debug)]
pub struct Placed<'e> {
    labels: FxHashMap<Bounds, (&'e str, Turn)>,
    tree: RTree<Corners>,
    container: Bounds,
    /// What was asked before: many operations ask the same.
    planes: RefCell<FxHashMap<(Bounds, Axis), Rc<Planes>>>,
    empty: RefCell<FxHashMap<Bounds, bool>>,
}

impl Blocks {
    /// The blocks of a grid of that data version, as they are when all neighbours have had their say, and as a grammar writes them.
    pub fn of(grid: &Grid, data_version: i32, states: &mut States) -> Result<Blocks, PaletteFull> {
        let bare = Grid::from_cells(grid.cells().clone(), grid.palette().clone());
        let mut settled = bare.unwrap_or_else(|| Grid::new(Cell::ZERO));
        settled.metadata.data_version = Some(data_version);
        settle(&mut settled)?;
        let mut open = settled.clone();
        unsettle(&mut open)?;
        let own = |grid: &Grid, states: &mut States| {
            grid.palette().states().iter().map(|state| states.number(state)).collect::<Vec<_>>()
        };
        let (open_ids, settled_ids) = (own(&open, states), own(&settled, states));
        let cells = open.cells().iter().zip(settled.cells());
        let kinds = cells.map(|(open, settled)| {
            states.kind(open_ids[usize::from(*open)], settled_ids[usize::from(*settled)])
        });
        let kinds = kinds.collect();
        Ok(Blocks::of_kinds(grid.size(), kinds, states))
    }

    pub fn of_kinds(size: Cell, kinds: Vec<KindId>, states: &States) -> Blocks {
        let hashes = BoxHashes::new(size, kinds.iter().map(|kind| kind.number()));
        let mut blocks = Blocks { size, kinds, hashes, solid: Vec::new() };
        blocks.count(states);
        blocks
    }

    fn count(&mut self, states: &States) {
        let corners = (self.size + Cell::ONE).as_i64vec3().element_product().max(1) as usize;
        self.solid = vec![0; corners];
        for (cell, kind) in Bounds::of_size(self.size).cells().zip(&self.kinds) {
            let own = u32::from(!states.is_air(*kind));
            let at = |x: i32, y: i32, z: i32| self.solid[self.corner(cell + Cell::new(x, y, z))];
            let faces = at(0, 1, 1) + at(1, 0, 1) + at(1, 1, 0) + at(0, 0, 0) + own;
            let sum = faces - at(0, 0, 1) - at(0, 1, 0) - at(1, 0, 0);
            let last = self.corner(cell + Cell::ONE);
            self.solid[last] = sum;
        }
    }

    fn corner(&self, corner: Cell) -> usize {
        let [width, depth] = [self.size.x as usize + 1, self.size.z as usize + 1];
        (corner.y as usize * depth + corner.z as usize) * width + corner.x as usize
    }

    pub fn bounds(&self) -> Bounds {
        Bounds::of_size(self.size)
    }

    /// All kinds in the order of schematic files.
    pub fn kinds(&self) -> &[KindId] {
        &self.kinds
    }

    pub fn kind(&self, cell: Cell) -> KindId {
        self.kinds[self.place(cell)]
    }

    /// The number of a cell in the order of schematic files.
    pub fn place(&self, cell: Cell) -> usize {
        (cell.y as usize * self.size.z as usize + cell.z as usize) * self.size.x as usize + cell.x as usize
    }

    /// The kinds of a box, row by row.
    pub fn rows(&self, bounds: Bounds) -> impl Iterator<Item = &[KindId]> {
        let width = bounds.len(Axis::X).max(0) as usize;
        (bounds.min.y..bounds.max.y).flat_map(move |y| {
            (bounds.min.z..bounds.max.z).map(move |z| {
                let row = (y as usize * self.size.z as usize + z as usize) * self.size.x as usize;
                &self.kinds[row + bounds.min.x as usize..][..width]
            })
        })
    }

    /// How many cells of a box are not air.
    pub fn solid(&self, bounds: Bounds) -> u32 {
        if bounds.is_empty() {
            return 0;
        }
        let [low, high] = [bounds.min, bounds.max];
        let at = |x: i32, y: i32, z: i32| i64::from(self.solid[self.corner(Cell::new(x, y, z))]);
        let layer =
            |y| at(high.x, y, high.z) - at(low.x, y, high.z) - at(high.x, y, low.z) + at(low.x, y, low.z);
        (layer(high.y) - layer(low.y)) as u32
    }
}

impl<'e> Placed<'e> {
    pub fn of(boxes: &'e LabelledBoxes) -> Placed<'e> {
        Placed {
            labels: boxes.boxes.iter().map(|labelled| (labelled.bounds, labelled.turned())).collect(),
            tree: RTree::bulk_load(boxes.boxes.iter().map(|labelled| Corners(labelled.bounds)).collect()),
            container: boxes.container,
            planes: RefCell::default(),
            empty: RefCell::default(),
        }
    }

    /// The label of a box, without what says how it is turned, and that.
    pub fn label(&self, bounds: Bounds) -> Option<(&'e str, Turn)> {
        self.labels.get(&bounds).copied()
    }

    /// How many cells of a box the labelled boxes fill.
    pub fn volume(&self, bounds: Bounds) -> u64 {
        let shared = self.within(bounds).map(|own| own.intersect(&bounds).volume());
        shared.sum()
    }

    /// The boxes that share a cell with one.
    fn within(&self, bounds: Bounds) -> impl Iterator<Item = Bounds> {
        let near = self.tree.locate_in_envelope_intersecting(Corners(bounds).envelope());
        near.map(|corners| corners.0).filter(move |own| !own.intersect(&bounds).is_empty())
    }

    fn is_empty(&self, bounds: Bounds) -> bool {
        *self.empty.borrow_mut().entry(bounds).or_insert_with(|| self.within(bounds).next().is_none())
    }

    /// The planes across an axis of a scope; where the scope cuts a box itself, none is clear.
    pub fn planes(&self, scope: Bounds, axis: Axis) -> Rc<Planes> {
        let mut known = self.planes.borrow_mut();
        known.entry((scope, axis)).or_insert_with(|| Rc::new(self.find_planes(scope, axis))).clone()
    }

    fn find_planes(&self, scope: Bounds, axis: Axis) -> Planes {
        let low = axis.of(scope.min);
        let count = scope.len(axis).max(0) as usize + 1;
        let mut planes =
            Planes { clear: FixedBitSet::with_capacity(count), faces: FixedBitSet::with_capacity(count) };
        planes.clear.insert_range(..);
        for own in self.within(scope) {
            if !scope.contains_box(&own) {
                planes.clear.clear();
                break;
            }
            let (from, to) = ((axis.of(own.min) - low) as usize, (axis.of(own.max) - low) as usize);
            planes.clear.remove_range(from + 1..to);
            planes.faces.insert(from);
            planes.faces.insert(to);
        }
        planes
    }
}

/// Planes across a scope, by their distance from its low end.
#[derive(Debug)]
pub struct Planes {
    /// Those that cut no box.
    pub clear: FixedBitSet,
    /// Those where a box begins or ends.
    pub faces: FixedBitSet,
}

impl Target<'_> {
    pub fn bounds(&self) -> Bounds {
        match self {
            Target::Blocks(blocks) => blocks.bounds(),
            Target::Boxes(boxes) => boxes.container,
        }
    }

    /// What a box holds. Labelled boxes are told apart by their place, unless there are none.
    pub fn content(&self, bounds: Bounds) -> Content {
        match self {
            Target::Blocks(blocks) => blocks.hashes.content(bounds),
            Target::Boxes(boxes) => {
                let pair = |a: i32, b: i32| u64::from(a as u32) << 32 | u64::from(b as u32);
                let size = bounds.size().to_array().map(|length| length as u32);
                if boxes.is_empty(bounds) {
                    return Content { size, hash: [u64::MAX; 2] };
                }
                Content { size, hash: [pair(bounds.min.x, bounds.min.y), pair(bounds.min.z, 0)] }
            }
        }
    }

    pub fn is_empty(&self, bounds: Bounds) -> bool {
        match self {
            Target::Blocks(blocks) => blocks.solid(bounds) == 0,
            Target::Boxes(boxes) => boxes.is_empty(bounds),
        }
    }
}
