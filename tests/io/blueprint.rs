//! Blueprints of Structurize.

use super::examples::blueprint::{file, small, state, text, with};
use super::real::folder;
use super::{read, read_grid, tags};
use std::collections::BTreeMap;
use vox::grid::{Dialect, Grid};
use vox::io::Warning;
use vox::nbt::{Compound, Tag};
use vox::space::Cell;

fn states(grid: &Grid) -> Vec<String> {
    grid.bounds().cells().map(|cell| grid.get(cell).short()).collect()
}

#[test]
fn two_blocks_stand_in_one_number() {
    let grid = read_grid(&file(&small()));
    assert_eq!(states(&grid), ["oak_log[axis=x]", "air", "structure_void"]);
    assert_eq!(grid.metadata.data_version, Some(2586));
}

#[test]
fn what_only_a_world_can_tell_is_left_alone() {
    for name in ["structurize:blocksolidsubstitution", "structurize:blockfluidsubstitution"] {
        let palette = vec![state(name, Compound::new())];
        let root = with(small(), [("palette", Tag::List(palette)), ("blocks", Tag::IntArray(vec![0, 0]))]);
        let bytes = file(&root);
        assert_eq!(read(&bytes).unwrap().warnings, [Warning::Ground(3)]);
        assert_eq!(states(&read_grid(&bytes)), ["structure_void"; 3]);
    }
}

#[test]
fn what_the_file_says_of_itself() {
    let anchor = tags([("x", Tag::Int(2)), ("y", Tag::Int(0)), ("z", Tag::Int(i32::MIN))]);
    let structurize =
        tags([("structurize", Tag::Compound(tags([("primary_offset", Tag::Compound(anchor))])))]);
    let chest = tags([
        ("x", Tag::Short(1)),
        ("y", Tag::Short(0)),
        ("z", Tag::Short(0)),
        ("id", text("minecraft:chest")),
    ]);
    let far = with(chest.clone(), [("y", Tag::Short(1))]);
    let root = with(
        small(),
        [
            ("name", text("hut")),
            ("architects", Tag::List(vec![text("Ann"), text("Bo")])),
            ("optional_data", Tag::Compound(structurize)),
            ("tile_entities", Tag::List(vec![Tag::Compound(chest), Tag::Compound(far)])),
        ],
    );
    let decoded = read(&file(&root)).unwrap();
    assert_eq!(decoded.warnings, [Warning::BlockEntitiesOutside(1)]);
    let grid = read_grid(&file(&root));
    assert_eq!(grid.block_entities, [([1, 0, 0], tags([("id", text("minecraft:chest"))]))].into());
    assert_eq!(grid.metadata.tags, tags([("Name", text("hut")), ("Author", text("Ann, Bo"))]));
    assert_eq!(grid.metadata.offset, Cell::new(-2, 0, i32::MAX));
    let own = grid.metadata.own.unwrap();
    assert_eq!(own.dialect, Dialect::Blueprint);
    assert_eq!(own.tags.into_keys().collect::<Vec<_>>(), ["optional_data", "required_mods"]);
}

#[test]
fn refusals_name_the_field_and_what_was_expected() {
    let cases = [
        (("version", Tag::Byte(2)), "the tag `version` is 2: vox knows version 1 of this format"),
        (("size_x", Tag::Short(0)), "the tag `size_x` is 0: a schematic is at least one block wide"),
        (("size_y", Tag::Short(-1)), "the size 3 x 65535 x 1 makes 196605 blocks, but `blocks` holds only 4"),
        (("size_y", Tag::Short(2)), "the size 3 x 2 x 1 makes 6 blocks, but `blocks` holds only 4"),
        (("blocks", Tag::Int(1)), "the tag `blocks` is an Int (1): expected an Int Array"),
        (
            ("blocks", Tag::IntArray(vec![0, -1])),
            "`blocks`, block (2, 0, 0): index 65535 is not in the palette of 3 entries",
        ),
        (
            ("palette", Tag::List(vec![Tag::Int(1)])),
            "the tag `palette[0]` is an Int (1): expected a Compound",
        ),
        (
            ("palette", Tag::List(vec![state("Oak", Compound::new())])),
            "the entry `Oak` of `palette[0].Name` is no block state",
        ),
        (
            ("tile_entities", Tag::List(vec![Tag::Compound(Compound::new())])),
            "the tag `tile_entities[0].x` is missing: expected an Int",
        ),
        (
            ("entities", Tag::List(vec![Tag::Compound(Compound::new())])),
            "the tag `entities[0].Pos` is missing: expected a List of 3 Doubles",
        ),
    ];
    for (tag, message) in cases {
        let found = read(&file(&with(small(), [tag]))).unwrap_err().to_string();
        assert!(found.starts_with(message), "expected: {message}\n   found: {found}");
    }
}

/// How often each block stands in a grid; the schematics have air where there is nothing.
fn counts(grid: &Grid) -> BTreeMap<String, usize> {
    let mut counts = BTreeMap::new();
    for cell in grid.bounds().cells() {
        let state = grid.get(cell);
        let name = if state.short_name() == "structure_void" { "air".to_owned() } else { state.short() };
        *counts.entry(name).or_insert(0) += 1;
    }
    counts
}

#[test]
fn houses_hold_the_same_blocks_as_their_schematics() {
    let Some(folder) = folder() else { return };
    let mut compared = 0;
    for path in glob::glob(&folder.join("houses/*/*.blueprint").to_string_lossy()).unwrap() {
        let path = path.unwrap();
        let blueprint = read_grid(&std::fs::read(&path).unwrap());
        let schematic = read_grid(&std::fs::read(path.with_extension("schem")).unwrap());
        assert_eq!(blueprint.size(), schematic.size(), "{}", path.display());
        assert_eq!(counts(&blueprint), counts(&schematic), "{}", path.display());
        compared += 1;
    }
    assert!(compared > 0, "no blueprints in {}", folder.display());
}
