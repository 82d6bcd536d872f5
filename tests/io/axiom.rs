//! Blueprints of Axiom.

use super::examples::axiom::{blocks, file, header, section, text};
use super::{read, read_grid, tags};
use vox::grid::{Dialect, Grid};
use vox::io::{Content, Limits, Warning, decode};
use vox::nbt::{Compound, Tag};
use vox::space::Cell;

fn states(grid: &Grid) -> Vec<String> {
    grid.bounds().cells().map(|cell| grid.get(cell).short()).collect()
}

#[test]
fn sections_join_to_the_smallest_box() {
    // (15, 0, 0) in one section and (0, 0, 0) in the next lie side by side.
    let sections = vec![
        section([-1, 0, 0], &["minecraft:void_air", "minecraft:stone"], &[(15, 1)]),
        section([0, 0, 0], &["minecraft:void_air", "minecraft:air", "minecraft:dirt"], &[(0, 2), (16, 1)]),
    ];
    let grid = read_grid(&file(&header(), b"", &blocks(sections)));
    assert_eq!(grid.size(), Cell::new(2, 1, 2));
    let at = |x, z| grid.get(Cell::new(x, 0, z)).short();
    assert_eq!([at(0, 0), at(1, 0), at(0, 1), at(1, 1)], ["stone", "dirt", "structure_void", "air"]);
    assert_eq!(grid.metadata.offset, Cell::new(-1, 0, 0));
    assert_eq!(grid.metadata.data_version, Some(3700));
}

#[test]
fn before_version_2_another_block_says_nothing() {
    let old = tags([("Version", Tag::Int(1))]);
    let sections = || vec![section([0; 3], &["minecraft:structure_void", "minecraft:void_air"], &[(0, 1)])];
    assert_eq!(states(&read_grid(&file(&old, b"", &blocks(sections())))), ["void_air"]);
    let grid = read_grid(&file(&header(), b"", &blocks(sections())));
    assert_eq!(grid.size(), Cell::splat(16), "nothing is left but the section");
}

#[test]
fn a_single_state_needs_no_data() {
    let grid = read_grid(&file(&header(), b"", &blocks(vec![section([0; 3], &["minecraft:stone"], &[])])));
    assert_eq!(grid.size(), Cell::splat(16));
    assert!(states(&grid).iter().all(|state| state == "stone"));
}

#[test]
fn long_palettes_take_more_bits() {
    let names: Vec<String> = (0..17).map(|n| format!("mod:b{n}")).collect();
    let palette = names.iter().map(|name| Tag::Compound(tags([("Name", text(name))]))).collect();
    // Five bits an entry, twelve entries a Long: entry 12 opens the second.
    let mut longs = vec![0i64; 342];
    longs[0] = 16 | 3 << 55;
    longs[1] = 15;
    let states = tags([("palette", Tag::List(palette)), ("data", Tag::LongArray(longs))]);
    let section = tags([
        ("X", Tag::Int(0)),
        ("Y", Tag::Int(0)),
        ("Z", Tag::Int(0)),
        ("BlockStates", Tag::Compound(states)),
    ]);
    let grid = read_grid(&file(&header(), b"", &blocks(vec![Tag::Compound(section)])));
    let at = |x| grid.get(Cell::new(x, 0, 0)).short();
    assert_eq!([at(0), at(1), at(11), at(12)], ["mod:b16", "mod:b0", "mod:b3", "mod:b15"]);
}

#[test]
fn what_the_file_says_of_itself() {
    let chest =
        tags([("x", Tag::Int(3)), ("y", Tag::Int(4)), ("z", Tag::Int(5)), ("id", text("minecraft:chest"))]);
    let mut far = chest.clone();
    far.insert("x", Tag::Int(i32::MIN));
    let mut root = blocks(vec![section(
        [0; 3],
        &["minecraft:void_air", "minecraft:chest"],
        &[(3 + 16 * 5 + 256 * 4, 1)],
    )]);
    root.insert("BlockEntities", Tag::List(vec![Tag::Compound(chest), Tag::Compound(far)]));
    let decoded = read(&file(&header(), b"png", &root)).unwrap();
    assert_eq!(decoded.warnings, [Warning::BlockEntitiesOutside(1)]);
    let Content::Grid(grid) = decoded.content else { panic!("no grid") };
    assert_eq!(grid.block_entities, [([0; 3], tags([("id", text("minecraft:chest"))]))].into());
    assert_eq!(grid.metadata.tags, tags([("Name", text("hut")), ("Author", text("Ann"))]));
    let own = grid.metadata.own.unwrap();
    assert_eq!(own.dialect, Dialect::Axiom);
    let picture = Tag::ByteArray(b"png".map(|byte| byte.cast_signed()).to_vec());
    assert_eq!(own.tags, tags([("BlockCount", Tag::Int(2)), ("Thumbnail", picture)]));
}

#[test]
fn refusals_name_the_field_and_what_was_expected() {
    let stone = || section([0; 3], &["minecraft:stone"], &[]);
    let two = ["minecraft:stone", "minecraft:dirt"];
    let short = || {
        let states = tags([
            ("palette", Tag::List(two.map(|name| Tag::Compound(tags([("Name", text(name))]))).to_vec())),
            ("data", Tag::LongArray(vec![0; 255])),
        ]);
        let Tag::Compound(section) = stone() else { panic!("a section is a compound") };
        Tag::Compound(section.into_iter().chain(tags([("BlockStates", Tag::Compound(states))])).collect())
    };
    let cases = [
        (Compound::new(), "the tag `blocks.BlockRegion` is missing: expected a List"),
        (
            blocks(vec![section([0; 3], &[], &[])]),
            "`blocks.BlockRegion[0].BlockStates.data`, block (0, 0, 0): index 0 is not in the palette of 0 entries",
        ),
        (
            blocks(vec![section([0; 3], &two, &[(16, 5)])]),
            "`blocks.BlockRegion[0].BlockStates.data`, block (0, 0, 1): index 5 is not in the palette of 2 entries",
        ),
        (blocks(vec![short()]), "`blocks.BlockRegion[0].BlockStates.data` holds only 255 of 256 Longs"),
        (
            blocks(vec![section([0, i32::MAX, 0], &two, &[])]),
            "the tag `blocks.BlockRegion[0].Y` is 2147483647: expected -2,097,152 to 2,097,151",
        ),
        (
            blocks(vec![stone(), section([0, 2_000_000, 0], &["minecraft:stone"], &[])]),
            "the size 16 x 32000016 x 16 makes 8192004096 blocks, more than 268435456, the limit",
        ),
    ];
    for (root, message) in cases {
        let found = read(&file(&header(), b"", &root)).unwrap_err().to_string();
        assert_eq!(found, message);
    }
}

#[test]
fn many_sections_in_few_bytes() {
    let sections = (0..9).map(|_| section([0; 3], &["minecraft:stone"], &[])).collect();
    let limits = Limits { max_cells: 8 * 4096, ..Limits::default() };
    let error = decode(&file(&header(), b"", &blocks(sections)), &limits).unwrap_err().to_string();
    assert_eq!(error, "the file holds 9 sections of blocks, more than 8, the limit");
}

#[test]
fn every_truncation_is_an_error() {
    let whole = file(&header(), b"png", &blocks(vec![section([0; 3], &["minecraft:stone"], &[])]));
    assert!(read(&whole).is_ok());
    for len in 4..whole.len() {
        assert!(read(&whole[..len]).is_err(), "{len}");
    }
    let error = read(&whole[..20]).unwrap_err().to_string();
    assert_eq!(error, "the file ends within its header: only 16 bytes are left for it and its length");
}
