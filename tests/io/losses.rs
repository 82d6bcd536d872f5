//! The law of all formats: what of a build does not come back from a file is named among what is lost, and what is
//! not named comes back.

use super::round_trip::{complete, near};
use ndarray::{Array2, Array3};
use proptest::collection::{btree_map, vec};
use proptest::option;
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use tempfile::TempDir;
use vox::block::{BlockState, Known, Palette, Version, all, color, legal_in};
use vox::grid::{BiomeMap, Biomes, Dialect, Entity, Grid, Metadata, Own, Region};
use vox::io::{
    Content, Decoded, Encoded, Jigsaws, Limits, LitematicVersion, Lost, Options, SchemVersion, WriteError,
    decode_with, encode_litematic, encode_regions, encode_schem, encode_structure, encode_vox, read_world,
};
use vox::nbt::{Compound, Tag};
use vox::space::{Bounds, Cell};

/// A format that grids are written in.
#[derive(Clone, Copy, Debug)]
enum Written {
    Schem(SchemVersion),
    Litematic(LitematicVersion),
    Structure,
    Regions,
    Model,
}

const WRITTEN: [Written; 7] = [
    Written::Schem(SchemVersion::V2),
    Written::Schem(SchemVersion::V3),
    Written::Litematic(LitematicVersion::V6),
    Written::Litematic(LitematicVersion::V7),
    Written::Structure,
    Written::Regions,
    Written::Model,
];

/// Where builds stand in worlds: at the corner of four chunks.
const PLACE: Cell = Cell::new(-2, 60, 14);

impl Written {
    /// The build as it is to come back: whole states, and no voxel where there is nothing.
    fn expected(self, grid: &Grid) -> Grid {
        let mut grid = complete(grid.clone());
        if matches!(self, Written::Model) {
            let seen =
                |state: &BlockState| if state.is_nothing() { BlockState::air() } else { state.clone() };
            grid.map_states(seen).unwrap();
        }
        grid
    }

    /// What comes back of `grid`, and what is said to be lost.
    fn through(self, grid: &Grid) -> Result<(Grid, Vec<Lost>), WriteError> {
        let options = Options { jigsaws: Jigsaws::Keep, ..Options::default() };
        let read = |bytes: &[u8]| grid_of(decode_with(bytes, &Limits::default(), &options).unwrap());
        let file = |Encoded { bytes, lost }| (read(&bytes), lost);
        Ok(match self {
            Written::Schem(version) => file(encode_schem(grid, version)?),
            Written::Litematic(version) => file(encode_litematic(grid, version)?),
            Written::Structure => file(encode_structure(grid)?),
            Written::Model => file(encode_vox(grid, color)?),
            Written::Regions => through_world(grid)?,
        })
    }
}

fn through_world(grid: &Grid) -> Result<(Grid, Vec<Lost>), WriteError> {
    let regions = encode_regions(grid, PLACE)?;
    let folder = TempDir::new()?;
    for (name, bytes) in &regions.files {
        let path = folder.path().join(name);
        std::fs::create_dir_all(path.parent().unwrap())?;
        std::fs::write(path, bytes)?;
    }
    std::fs::create_dir_all(folder.path().join("region"))?;
    std::fs::write(folder.path().join("region/r.9.9.mca"), [0; 8192])?;
    let part = Bounds::new(PLACE, PLACE + grid.size());
    let back = grid_of(read_world(folder.path(), Some(part), &Limits::default()).unwrap());
    Ok((back, regions.lost))
}

fn grid_of(decoded: Decoded) -> Grid {
    match decoded.content {
        Content::Grid(grid) => grid,
        Content::Boxes(_) => panic!("expected a grid"),
    }
}

fn any_state() -> impl Strategy<Value = BlockState> {
    let known =
        prop::sample::select(all().iter().collect::<Vec<_>>()).prop_flat_map(|known: &'static Known| {
            let pairs = known.properties().iter().map(|property| {
                option::of(prop::sample::select(property.values.clone()))
                    .prop_map(|value| value.map(|value| (property.key, value)))
            });
            pairs.collect::<Vec<_>>().prop_map(|pairs| {
                let bare = BlockState::new(known.name()).unwrap();
                pairs.into_iter().flatten().fold(bare, |state, (key, value)| state.with(key, value))
            })
        });
    let modded = "[a-z]{1,5}".prop_map(|name| format!("mod:{name}[size=big]").parse().unwrap());
    prop_oneof![6 => known, 1 => modded, 1 => Just(BlockState::structure_void())]
}

fn any_tag() -> impl Strategy<Value = Tag> {
    let leaf = prop_oneof![
        any::<i8>().prop_map(Tag::Byte),
        any::<i32>().prop_map(Tag::Int),
        any::<i64>().prop_map(Tag::Long),
        "[a-z \u{e9}]{1,6}".prop_map(Tag::String),
        vec(any::<i32>(), 0..3).prop_map(Tag::IntArray),
    ];
    leaf.prop_recursive(2, 6, 3, |inner| {
        prop_oneof![
            // Lists of the game hold one kind of tag.
            (inner.clone(), 0..3usize).prop_map(|(tag, count)| Tag::List(vec![tag; count])),
            btree_map("[a-z]{1,4}", inner, 0..3).prop_map(|tags| Tag::Compound(tags.into_iter().collect())),
        ]
    })
}

fn any_tags(names: &'static str) -> impl Strategy<Value = Compound> {
    btree_map(names, any_tag(), 0..3).prop_map(|tags| tags.into_iter().collect())
}

/// The data of a block entity or an entity: most say what they are. No name is as short as `Pos`: places are kept
/// beside the data.
fn any_data() -> impl Strategy<Value = Compound> {
    let id = prop_oneof![
        6 => "[a-z]{1,6}".prop_map(|id| Some(Tag::String(id))),
        1 => Just(None),
        1 => Just(Some(Tag::Int(7))),
    ];
    (id, any_tags("[A-Z][a-z]{3,5}")).prop_map(|(id, mut data)| {
        data.extend(id.map(|id| ("id".to_owned(), id)));
        data
    })
}

fn any_size() -> impl Strategy<Value = Cell> {
    (1..7, 1..4, 1..7).prop_map(|(x, y, z)| Cell::new(x, y, z))
}

fn any_cell(size: Cell) -> impl Strategy<Value = Cell> {
    (0..size.x, 0..size.y, 0..size.z).prop_map(|(x, y, z)| Cell::new(x, y, z))
}

fn any_blocks(size: Cell) -> impl Strategy<Value = Grid> {
    let data = btree_map(any_cell(size).prop_map(|cell| cell.to_array()), any_data(), 0..4);
    let volume = Bounds::of_size(size).volume() as usize;
    (vec(any_state(), 1..5), vec(0..6usize, volume), data).prop_map(move |(states, picks, data)| {
        let mut palette = Palette::default();
        let ids: Vec<u16> = states.iter().map(|state| palette.intern(state).unwrap()).collect();
        let ids = picks.into_iter().map(|pick| if pick == 0 { 0 } else { ids[pick % ids.len()] }).collect();
        let [x, y, z] = size.to_array().map(|n| n as usize);
        let mut grid = Grid::from_cells(Array3::from_shape_vec((y, z, x), ids).unwrap(), palette).unwrap();
        grid.block_entities = data;
        grid
    })
}

fn any_biomes(size: Cell) -> impl Strategy<Value = Option<Biomes>> {
    let [x, y, z] = size.to_array().map(|n| n as usize);
    let names = || ["plains", "minecraft:desert", "mod:mire"].map(str::to_owned).to_vec();
    let columns = vec(0..3u16, x * z)
        .prop_map(move |ids| BiomeMap::Columns(Array2::from_shape_vec((z, x), ids).unwrap()));
    let cells = vec(0..3u16, x * y * z)
        .prop_map(move |ids| BiomeMap::Cells(Array3::from_shape_vec((y, z, x), ids).unwrap()));
    let one = Just(BiomeMap::Columns(Array2::zeros((z, x))));
    option::of(prop_oneof![columns, cells, one].prop_map(move |map| Biomes { names: names(), map }))
}

fn any_region(size: Cell) -> impl Strategy<Value = Region> {
    (any_cell(size), any_cell(size), "[a-z]{1,3}", any_tags("[A-Z][a-z]{2,5}"))
        .prop_map(|(a, b, name, tags)| Region { name, bounds: Bounds::new(a.min(b), a.max(b) + 1), tags })
}

fn any_regions(size: Cell) -> impl Strategy<Value = Vec<Region>> {
    let whole = (any_tags("[A-Z][a-z]{2,5}"), "[a-z]{1,3}")
        .prop_map(move |(tags, name)| vec![Region { name, bounds: Bounds::of_size(size), tags }]);
    prop_oneof![Just(Vec::new()), whole, vec(any_region(size), 0..4)]
}

fn any_own() -> impl Strategy<Value = Option<Own>> {
    use Dialect::{Axiom, Bedrock, Blueprint, Litematica, Mcedit, Sponge, Structure};
    let dialects = vec![Sponge, Litematica, Structure, Mcedit, Blueprint, Bedrock, Axiom];
    let own = (prop::sample::select(dialects), any_tags("Mod[a-z]{1,5}"));
    let own = own.prop_filter("own tags", |(_, tags)| !tags.is_empty());
    option::of(own.prop_map(|(dialect, tags)| Own { dialect, tags }))
}

fn any_metadata(size: Cell) -> impl Strategy<Value = Metadata> {
    let versions: Vec<i32> = Version::all().map(Version::data_version).collect();
    let data_version = option::of(prop::sample::select(versions));
    let offset = prop_oneof![Just(Cell::ZERO), [-99..99i32, -99..99, -99..99].prop_map(Cell::from_array)];
    let [x, y, z] = size.to_array();
    let place = [0..x * 32, 0..y * 32, 0..z * 32].prop_map(|place| place.map(|n| f64::from(n) / 32.0));
    let entities = vec((place, any_data()), 0..4);
    let tags = any_tags("Name|Author|Description|Date|Note|TimeModified");
    let all = (data_version, offset, tags, any_own(), entities, any_biomes(size), any_regions(size));
    all.prop_map(|(data_version, offset, tags, own, entities, biomes, regions)| Metadata {
        data_version,
        offset,
        tags,
        own,
        entities: entities.into_iter().map(|(place, data)| Entity { place, block: None, data }).collect(),
        biomes,
        regions,
    })
}

fn any_build() -> impl Strategy<Value = Grid> {
    any_size().prop_flat_map(|size| {
        let variants = prop_oneof![
            3 => Just(Vec::new()),
            1 => vec(any_blocks(size), 1..3),
            1 => any_size().prop_flat_map(|size| vec(any_blocks(size), 1..2)),
        ];
        (any_blocks(size), any_metadata(size), variants).prop_map(|(mut grid, metadata, variants)| {
            grid.metadata = metadata;
            grid.variants = variants;
            grid
        })
    })
}

/// What is said to be lost, to be asked for.
struct Said<'a>(&'a [Lost]);

impl Said<'_> {
    /// The sum of what `count` gives for each.
    fn count(&self, count: impl Fn(&Lost) -> Option<usize>) -> usize {
        self.0.iter().filter_map(count).sum()
    }

    fn any(&self, is: impl Fn(&Lost) -> bool) -> bool {
        self.0.iter().any(is)
    }

    fn names(&self, names: impl Fn(&Lost) -> Option<&Vec<String>>) -> BTreeSet<&String> {
        self.0.iter().filter_map(names).flatten().collect()
    }
}

/// Whether all of `grid` that is not said to be lost is in `back`, and nothing that is said to be.
fn check(grid: &Grid, back: &Grid, said: &Said) -> Result<(), TestCaseError> {
    blocks(grid, back, said)?;
    block_entities(grid, back, said)?;
    entities(grid, back, said)?;
    biomes(grid, back, said)?;
    regions(grid, back, said)?;
    rest(&grid.metadata, &back.metadata, said)
}

/// The variants that are kept, each as it was and as it is, and the grids themselves before them.
fn looks<'a>(
    grid: &'a Grid,
    back: &'a Grid,
    said: &Said,
) -> Result<Vec<(&'a Grid, &'a Grid)>, TestCaseError> {
    let told = said.count(|lost| if let Lost::Variants(count) = lost { Some(*count) } else { None });
    prop_assert_eq!(grid.variants.len() - back.variants.len(), told, "variants");
    // Those of another size go.
    let kept = grid.variants.iter().filter(|variant| variant.size() == grid.size());
    Ok([(grid, back)].into_iter().chain(kept.zip(&back.variants)).collect())
}

fn blocks(grid: &Grid, back: &Grid, said: &Said) -> Result<(), TestCaseError> {
    let looks = looks(grid, back, said)?;
    if said.any(|lost| *lost == Lost::States) {
        return Ok(());
    }
    let mut now_air = BTreeSet::new();
    for (was, is) in looks {
        prop_assert_eq!(was.size(), is.size());
        for cell in was.bounds().cells() {
            match *was.get(cell) == BlockState::structure_void() && is.get(cell).is_air() {
                true => drop(now_air.insert(cell.to_array())),
                false => prop_assert_eq!(was.get(cell), is.get(cell)),
            }
        }
    }
    let told = said.count(|lost| if let Lost::LeftAlone(count) = lost { Some(*count) } else { None });
    prop_assert_eq!(now_air.len(), told, "cells to be left alone are air");
    Ok(())
}

fn block_entities(grid: &Grid, back: &Grid, said: &Said) -> Result<(), TestCaseError> {
    let missing = |(was, is): (&Grid, &Grid)| {
        was.block_entities.iter().filter(|&(place, data)| is.block_entities.get(place) != Some(data)).count()
    };
    let missing: usize = looks(grid, back, said)?.into_iter().map(missing).sum();
    prop_assert!(back.block_entities.keys().all(|place| grid.block_entities.contains_key(place)));
    let told = said.count(|lost| match lost {
        Lost::BlockEntities(count) | Lost::UnnamedBlockEntities(count) => Some(*count),
        _ => None,
    });
    prop_assert_eq!(missing, told, "block entities");
    Ok(())
}

fn entities(grid: &Grid, back: &Grid, said: &Said) -> Result<(), TestCaseError> {
    let sorted = |grid: &Grid| {
        let mut entities = grid.metadata.entities.clone();
        entities.retain(|entity| matches!(entity.data.get("id"), Some(Tag::String(_))));
        entities.sort_by_key(|entity| format!("{:.6?} {:?}", entity.place, entity.data));
        entities
    };
    let told = said.count(|lost| match lost {
        Lost::Entities(count) | Lost::UnnamedEntities(count) => Some(*count),
        _ => None,
    });
    prop_assert_eq!(grid.metadata.entities.len() - back.metadata.entities.len(), told, "entities");
    if !back.metadata.entities.is_empty() {
        prop_assert!(near(&sorted(back), &sorted(grid)));
    }
    Ok(())
}

/// The name of the biome of each cell.
fn biome_names(grid: &Grid) -> Option<Vec<&str>> {
    let biomes = grid.metadata.biomes.as_ref()?;
    let name = |cell: Cell| {
        let [x, y, z] = cell.to_array().map(|n| n as usize);
        let id = match &biomes.map {
            BiomeMap::Columns(columns) => columns[[z, x]],
            BiomeMap::Cells(cells) => cells[[y, z, x]],
        };
        &biomes.names[usize::from(id)][..]
    };
    Some(grid.bounds().cells().map(name).collect())
}

fn biomes(grid: &Grid, back: &Grid, said: &Said) -> Result<(), TestCaseError> {
    let Some(names) = biome_names(grid) else { return Ok(()) };
    let found = biome_names(back).unwrap_or_else(|| vec![""; names.len()]);
    let differs = |at: usize| names[at] != found[at];
    // What a cell to be left alone stands in is left alone, too.
    let is_built = |cell: Cell| *grid.get(cell) != BlockState::structure_void();
    let built = grid.bounds().cells().enumerate().filter(|&(_, cell)| is_built(cell));
    match said.any(|lost| *lost == Lost::Biomes) {
        true => prop_assert!((0..names.len()).any(differs), "biomes are there"),
        false => prop_assert!(!built.map(|(at, _)| at).any(differs), "biomes differ"),
    }
    Ok(())
}

fn regions(grid: &Grid, back: &Grid, said: &Said) -> Result<(), TestCaseError> {
    let told = said.any(|lost| matches!(lost, Lost::Regions { .. }));
    let [was, is] = [grid, back].map(|grid| &grid.metadata.regions);
    // The name of one alone is no loss.
    if told || was.is_empty() || (is.is_empty() && was.len() == 1 && was[0].tags.is_empty()) {
        return Ok(());
    }
    let sorted = |regions: &[Region]| {
        let mut regions = regions.to_vec();
        regions.sort_by_key(|region| format!("{:?} {:?}", region.bounds, region.tags));
        regions.into_iter().map(|region| (region.bounds, region.tags)).collect::<Vec<_>>()
    };
    prop_assert_eq!(sorted(was), sorted(is));
    Ok(())
}

fn rest(was: &Metadata, is: &Metadata, said: &Said) -> Result<(), TestCaseError> {
    if !said.any(|lost| matches!(lost, Lost::Offset(_))) {
        prop_assert_eq!(was.offset, is.offset);
    }
    let names = said.names(|lost| if let Lost::Metadata(names) = lost { Some(names) } else { None });
    let kept = |tags: &Compound| -> BTreeMap<String, Tag> {
        let kept = tags.iter().filter(|(name, _)| !names.contains(&name.to_string()));
        kept.map(|(name, tag)| (name.to_string(), tag.clone())).collect()
    };
    prop_assert_eq!(kept(&was.tags), kept(&is.tags));
    let names = said.names(|lost| if let Lost::Own(names) = lost { Some(names) } else { None });
    let own = |own: &Option<Own>| -> Vec<String> {
        let all = own.iter().flat_map(|own| own.tags.keys().map(ToString::to_string));
        all.filter(|name| !names.contains(name)).collect()
    };
    prop_assert_eq!(own(&was.own), own(&is.own));
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn what_does_not_come_back_is_named(grid in any_build()) {
        for format in WRITTEN {
            let (back, lost) = match format.through(&grid) {
                Err(WriteError::OldBlocks(_)) => continue,
                through => through.unwrap(),
            };
            check(&format.expected(&grid), &back, &Said(&lost))
                .map_err(|error| TestCaseError::fail(format!("{format:?}: {error}, lost {lost:?}")))?;
        }
    }

    #[test]
    fn what_is_written_is_legal_in_the_version(grid in any_build()) {
        let version = grid.version();
        let mut grid = grid;
        grid.variants.clear();
        // Blocks of other versions are refused or told of elsewhere. Without its level, nothing tells that water in cauldrons
        // came later.
        let is_clear = |state: &BlockState| state.short() != "water_cauldron" && legal_in(state, version);
        grid.map_states(|state| if is_clear(state) { state.clone() } else { BlockState::air() }).unwrap();
        let data_version = grid.data_version();
        for format in WRITTEN {
            let (Ok((back, _)), false) = (format.through(&grid), matches!(format, Written::Model)) else {
                continue;
            };
            // A world of chunks that are left alone has none.
            prop_assert!(back.metadata.data_version.is_none_or(|found| found == data_version));
            for state in back.palette().states() {
                prop_assert!(legal_in(state, version), "{:?}: {state} in {version}", format);
            }
        }
    }
}
