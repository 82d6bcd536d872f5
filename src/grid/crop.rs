use super::{BiomeMap, Biomes, Entity, Grid, Metadata, Region, entity};
use crate::block::{BlockState, Palette};
use crate::space::{Bounds, Cell};
use ndarray::{ArrayView2, ArrayView3, s};

impl Grid {
    /// The part of this build inside `bounds`, with all that is in it. The point of copying stays where it is.
    pub fn cropped(&self, bounds: Bounds) -> Grid {
        let inside = self.metadata.entities.iter().filter(|entity| bounds.contains(entity.home()));
        self.cropped_with(bounds, inside)
    }

    /// This build without the air around it: nothing else is lost, also not what hangs outside of its walls. `None` where
    /// all is air or left alone.
    pub fn trimmed(&self) -> Option<Grid> {
        Some(self.cropped_with(self.occupied()?, &self.metadata.entities))
    }

    /// The part of this build inside `bounds`, with these of its entities.
    pub(super) fn cropped_with<'a>(
        &self,
        bounds: Bounds,
        entities: impl IntoIterator<Item = &'a Entity>,
    ) -> Grid {
        let inside = self.bounds().intersect(&bounds);
        let bounds = Bounds::new(inside.min.min(inside.max), inside.max);
        let (cells, palette) = compacted(part(self.cells.view(), bounds), &self.palette);
        let slice = [bounds.min.x, i32::MIN, i32::MIN]..[bounds.max.x, i32::MIN, i32::MIN];
        let block_entities = self.block_entities.range(slice).filter_map(|(place, data)| {
            let place = Cell::from_array(*place);
            bounds.contains(place).then(|| ((place - bounds.min).to_array(), data.clone()))
        });
        Grid {
            cells,
            palette,
            block_entities: block_entities.collect(),
            metadata: cropped_metadata(&self.metadata, bounds, entities),
            variants: self.variants.iter().map(|variant| variant.cropped(bounds)).collect(),
        }
    }

    /// The smallest box around what is there: blocks, in any of the variants, and entities. `None` where all is air
    /// or left alone.
    pub fn occupied(&self) -> Option<Bounds> {
        let builds = std::iter::once(self).chain(&self.variants);
        let blocks = builds.filter_map(Grid::built);
        let homes = self.metadata.entities.iter().map(|entity| one(entity.home()));
        blocks
            .chain(homes.filter(|home| self.bounds().contains(home.min)))
            .reduce(|all, next| all.union(&next))
    }

    fn built(&self) -> Option<Bounds> {
        let solid: Vec<bool> = self.palette.states().iter().map(|state| !state.is_nothing()).collect();
        let rows = self.cells.rows().into_iter().zip(row_places(self.size()));
        let spans = rows.filter_map(|(row, place)| {
            let is_solid = |id: &u16| solid[usize::from(*id)];
            let low = row.iter().position(is_solid)? as i32;
            let high = row.len() as i32 - row.iter().rev().position(is_solid)? as i32;
            Some(Bounds::new(place + Cell::X * low, place + Cell::new(high, 1, 1)))
        });
        spans.reduce(|all, next| all.union(&next))
    }
}

/// Where each row of cells begins.
fn row_places(size: Cell) -> impl Iterator<Item = Cell> {
    Bounds::of_size(size.with_x(1)).cells()
}

fn one(cell: Cell) -> Bounds {
    Bounds::new(cell, cell.saturating_add(Cell::ONE))
}

fn part<'a>(cells: ArrayView3<'a, u16>, bounds: Bounds) -> ArrayView3<'a, u16> {
    let ([x0, y0, z0], [x1, y1, z1]) = (super::index3(bounds.min), super::index3(bounds.max));
    cells.slice_move(s![y0..y1, z0..z1, x0..x1])
}

/// The cells with a palette of only the states that are used.
fn compacted(cells: ArrayView3<u16>, palette: &Palette) -> (ndarray::Array3<u16>, Palette) {
    let mut used = vec![false; palette.states().len()];
    cells.iter().for_each(|id| used[usize::from(*id)] = true);
    let mut small = Palette::default();
    let number = |(state, used): (&BlockState, bool)| match used {
        true => small.intern(state).expect("no more states than before"),
        false => Palette::AIR,
    };
    let ids: Vec<u16> = palette.states().iter().zip(used).map(number).collect();
    let cells = cells.mapv(|id| ids[usize::from(id)]);
    (cells, small)
}

fn cropped_metadata<'a>(
    old: &Metadata,
    bounds: Bounds,
    entities: impl IntoIterator<Item = &'a Entity>,
) -> Metadata {
    let entities = entities.into_iter();
    Metadata {
        data_version: old.data_version,
        offset: old.offset.saturating_add(bounds.min),
        tags: old.tags.clone(),
        own: old.own.clone(),
        entities: entities.map(|entity| entity::shifted(entity, -bounds.min)).collect(),
        biomes: old.biomes.as_ref().map(|biomes| cropped_biomes(biomes, bounds)),
        regions: old.regions.iter().filter_map(|region| cropped_region(region, bounds)).collect(),
    }
}

fn cropped_region(region: &Region, bounds: Bounds) -> Option<Region> {
    let inside = region.bounds.intersect(&bounds);
    let moved = Bounds::new(inside.min - bounds.min, inside.max - bounds.min);
    (!inside.is_empty()).then(|| match inside == region.bounds {
        true => Region { bounds: moved, ..region.clone() },
        false => region.moved(moved),
    })
}

fn cropped_biomes(biomes: &Biomes, bounds: Bounds) -> Biomes {
    let columns = |columns: ArrayView2<u16>| {
        let ([x0, _, z0], [x1, _, z1]) = (super::index3(bounds.min), super::index3(bounds.max));
        columns.slice(s![z0..z1, x0..x1]).to_owned()
    };
    let map = match &biomes.map {
        BiomeMap::Columns(all) => BiomeMap::Columns(columns(all.view())),
        BiomeMap::Cells(cells) => BiomeMap::Cells(part(cells.view(), bounds).to_owned()),
    };
    Biomes { names: biomes.names.clone(), map }
}
