use super::{BiomeMap, Biomes, Grid, Metadata, Region, entity};
use crate::block::{Mirror, Motion, Palette};
use crate::nbt::{Compound, Tag};
use crate::space::{Bounds, Cell, Turn};
use glam::I64Vec3;
use ndarray::{Array2, Array3, ArrayView2, ArrayView3, Axis};

impl Grid {
    /// This build turned about the vertical, with all that is in it. The point of copying stays where it is.
    pub fn turned(&self, turn: Turn) -> Grid {
        self.moved(Motion::Turn(turn))
    }

    /// This build mirrored, with all that is in it. The point of copying stays where it is.
    pub fn mirrored(&self, mirror: Mirror) -> Grid {
        self.moved(Motion::Mirror(mirror))
    }

    fn moved(&self, motion: Motion) -> Grid {
        let size = self.size();
        let (palette, ids) = moved_palette(&self.palette, motion);
        let mut cells = moved_cells(self.cells.view(), motion);
        if ids.iter().enumerate().any(|(old, new)| old != usize::from(*new)) {
            cells.mapv_inplace(|id| ids[usize::from(id)]);
        }
        let block_entities = self.block_entities.iter().map(|(place, data)| {
            let place = moved_box(motion, cell_box(Cell::from_array(*place)), size).min;
            (place.to_array(), moved_block_entity(data, motion))
        });
        Grid {
            cells,
            palette,
            block_entities: block_entities.collect(),
            metadata: moved_metadata(&self.metadata, motion, size),
            variants: self.variants.iter().map(|variant| variant.moved(motion)).collect(),
        }
    }
}

/// The palette with its states moved, and the new number of each old one: states that the game does not have
/// may become equal.
fn moved_palette(old: &Palette, motion: Motion) -> (Palette, Vec<u16>) {
    let mut palette = Palette::default();
    let moved = old.states().iter().map(|state| palette.intern(&state.moved(motion)));
    let ids = moved.map(|id| id.expect("no more states than before")).collect();
    (palette, ids)
}

fn moved_cells(cells: ArrayView3<u16>, motion: Motion) -> Array3<u16> {
    let mut cells = cells;
    if is_odd(motion) {
        cells.swap_axes(1, 2);
    }
    let [x, z] = turned_round(motion);
    [(2, x), (1, z)]
        .into_iter()
        .filter(|(_, round)| *round)
        .for_each(|(axis, _)| cells.invert_axis(Axis(axis)));
    cells.as_standard_layout().into_owned()
}

fn moved_columns(columns: ArrayView2<u16>, motion: Motion) -> Array2<u16> {
    let cells = moved_cells(columns.insert_axis(Axis(0)), motion);
    cells.index_axis_move(Axis(0), 0)
}

/// Whether x and z change places.
fn is_odd(motion: Motion) -> bool {
    let [x, ..] = motion.apply([1, 0, 0]);
    x == 0
}

/// Whether the new x and the new z run against the old axes that they are taken from.
fn turned_round(motion: Motion) -> [bool; 2] {
    let [x, _, z] = motion.apply([1, 0, 1]);
    [x < 0, z < 0]
}

/// Where a box within a build of `size` goes.
fn moved_box(motion: Motion, bounds: Bounds, size: Cell) -> Bounds {
    let low = about_origin(motion, Bounds::of_size(size)).min;
    let moved = about_origin(motion, bounds);
    Bounds::new(moved.min - low, moved.max - low)
}

/// Where a box goes that is moved about the middle of the block at the origin.
fn about_origin(motion: Motion, bounds: Bounds) -> Bounds {
    let corners = [bounds.min, bounds.max - Cell::ONE];
    let [a, b] = corners.map(|corner| Cell::from_array(motion.apply(corner.to_array())));
    Bounds::new(a.min(b), a.max(b) + Cell::ONE)
}

fn cell_box(cell: Cell) -> Bounds {
    Bounds::new(cell, cell + Cell::ONE)
}

fn moved_metadata(old: &Metadata, motion: Motion, size: Cell) -> Metadata {
    let region = |region: &Region| region.moved(moved_box(motion, region.bounds, size));
    let corner = about_origin(motion, Bounds::of_size(size)).min;
    Metadata {
        data_version: old.data_version,
        offset: moved_offset(old.offset, motion, corner),
        tags: old.tags.clone(),
        own: old.own.clone(),
        entities: old.entities.iter().map(|entity| entity::moved(entity, motion, corner)).collect(),
        biomes: old.biomes.as_ref().map(|biomes| moved_biomes(biomes, motion)),
        regions: old.regions.iter().map(region).collect(),
    }
}

/// In long numbers: a file may claim any offset.
fn moved_offset(offset: Cell, motion: Motion, corner: Cell) -> Cell {
    let low = I64Vec3::from_array(motion.apply(offset.as_i64vec3().to_array())) + corner.as_i64vec3();
    low.clamp(Cell::MIN.as_i64vec3(), Cell::MAX.as_i64vec3()).as_ivec3()
}

fn moved_biomes(biomes: &Biomes, motion: Motion) -> Biomes {
    let map = match &biomes.map {
        BiomeMap::Columns(columns) => BiomeMap::Columns(moved_columns(columns.view(), motion)),
        BiomeMap::Cells(cells) => BiomeMap::Cells(moved_cells(cells.view(), motion)),
    };
    Biomes { names: biomes.names.clone(), map }
}

/// Before 1.13 heads kept their direction with their data.
fn moved_block_entity(data: &Compound, motion: Motion) -> Compound {
    let mut data = data.clone();
    let is_head =
        matches!(data.get("id"), Some(Tag::String(id)) if id.to_ascii_lowercase().ends_with("skull"));
    if let Some(Tag::Byte(rotation)) = data.get_mut("Rot").filter(|_| is_head) {
        *rotation = motion.sixteenth(i32::from(*rotation)) as i8;
    }
    data
}
