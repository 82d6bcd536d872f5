//! Schematics of MCEdit: numbers become states, and block entities what they are today.

use super::examples::mcedit::{bytes, file, row, text, with};
use super::real::folder;
use super::{read, read_grid, tags};
use vox::block::{LEGACY_DATA_VERSION, check};
use vox::grid::{Dialect, Grid};
use vox::io::{Content, Warning};
use vox::nbt::{Compound, Tag};
use vox::space::Cell;

/// What stands in the first cell.
fn first(grid: &Grid) -> String {
    grid.get(Cell::ZERO).short()
}

fn states(root: &Compound) -> Vec<String> {
    let grid = read_grid(&file(root));
    grid.bounds().cells().map(|cell| grid.get(cell).short()).collect()
}

#[test]
fn numbers_become_states() {
    let found = states(&row(&[(0, 0), (53, 5), (35, 14), (64, 9), (17, 0x32)]));
    let expected = [
        "air",
        "oak_stairs[facing=west,half=top,shape=straight,waterlogged=false]",
        "red_wool",
        "oak_door[facing=north,half=upper,hinge=right,open=false,powered=false]",
        "birch_log[axis=y]",
    ];
    assert_eq!(found[..4], expected[..4]);
    assert_eq!(found[4], expected[4], "only the low half of a data byte counts");
}

#[test]
fn what_a_number_cannot_mean_is_told() {
    let decoded = read(&file(&row(&[(1, 9), (1, 9), (4, 1), (254, 3)]))).unwrap();
    assert_eq!(
        decoded.warnings,
        [
            Warning::UnknownData { blocks: 3, ids: "1:9, 4:1".into() },
            Warning::UnknownIds { blocks: 1, ids: "254:3".into() },
        ]
    );
    let found = states(&row(&[(1, 9), (4, 1), (254, 3)]));
    assert_eq!(found, ["stone", "cobblestone", "legacy:254[data=3]"]);
}

#[test]
fn names_of_the_file_come_before_numbers() {
    let mapping = tags([
        ("minecraft:stone", Tag::Short(7)),
        ("Mod:Thing", Tag::Short(300)),
        ("minecraft:planks", Tag::Short(301)),
    ]);
    let named = with(
        row(&[(7, 1), (44, 0), (45, 2), (9, 0)]),
        [("SchematicaMapping", Tag::Compound(mapping)), ("AddBlocks", bytes(&[0x01, 0x10]))],
    );
    let found = states(&named);
    assert_eq!(found, ["granite", "mod:thing", "birch_planks", "water[level=0]"], "9 has no other name");
}

#[test]
fn high_bits_in_every_layout() {
    let plain = row(&[(1, 0), (2, 0), (3, 0)]);
    let halves = with(plain.clone(), [("AddBlocks", bytes(&[0x21, 0x03]))]);
    let decoded = read(&file(&halves)).unwrap();
    assert_eq!(states(&halves), ["legacy:257", "legacy:514", "legacy:771"]);
    assert!(decoded.warnings.contains(&Warning::HalvesOfIds));
    let whole = with(plain.clone(), [("Add", bytes(&[1, 2, 3]))]);
    assert_eq!(states(&whole), ["legacy:257", "legacy:514", "legacy:771"]);
    let zero = with(plain, [("AddBlocks", bytes(&[0, 0]))]);
    assert_eq!(read(&file(&zero)).unwrap().warnings, []);
}

/// A file of one block with a block entity.
fn one(block: (u8, u8), id: &str, data: Compound) -> Vec<u8> {
    let place = tags([("x", Tag::Int(0)), ("y", Tag::Int(0)), ("z", Tag::Int(0)), ("id", text(id))]);
    let entity = with(place, []).into_iter().chain(data).collect();
    file(&with(row(&[block]), [("TileEntities", Tag::List(vec![Tag::Compound(entity)]))]))
}

fn byte(name: &str, n: i8) -> Compound {
    tags([(name, Tag::Byte(n))])
}

#[test]
fn block_entities_that_decide_states_move_into_them() {
    let pot = |item: Tag, data: i32| tags([("Item", item), ("Data", Tag::Int(data))]);
    let skull = |kind, rot| tags([("SkullType", Tag::Byte(kind)), ("Rot", Tag::Byte(rot))]);
    let note = tags([("note", Tag::Byte(7)), ("powered", Tag::Byte(1))]);
    let cases = [
        (
            (26, 9),
            "minecraft:bed",
            tags([("color", Tag::Int(3))]),
            "light_blue_bed[facing=west,occupied=false,part=head]",
        ),
        ((144, 1), "Skull", skull(3, 12), "player_head[powered=false,rotation=12]"),
        ((144, 4), "Skull", skull(4, 0), "creeper_wall_head[facing=west,powered=false]"),
        ((176, 5), "Banner", tags([("Base", Tag::Int(1))]), "red_banner[rotation=5]"),
        ((177, 2), "minecraft:banner", tags([("Base", Tag::Int(15))]), "white_wall_banner[facing=north]"),
        ((140, 0), "FlowerPot", pot(text("minecraft:red_flower"), 4), "potted_red_tulip"),
        ((140, 0), "FlowerPot", pot(Tag::Int(31), 2), "potted_fern"),
        ((140, 0), "minecraft:flower_pot", pot(text("minecraft:air"), 0), "flower_pot"),
        ((140, 0), "minecraft:flower_pot", pot(text("mod:rose"), 0), "flower_pot"),
        ((25, 0), "Music", note, "note_block[instrument=harp,note=7,powered=true]"),
        ((26, 0), "minecraft:bed", byte("color", -3), "red_bed[facing=south,occupied=false,part=foot]"),
        ((144, 1), "Skull", skull(77, -1), "skeleton_skull[powered=false,rotation=0]"),
        ((1, 0), "Skull", skull(1, 1), "stone"),
    ];
    for (block, id, data, expected) in cases {
        assert_eq!(first(&read_grid(&one(block, id, data))), expected, "{id}");
    }
    assert!(read_grid(&one((140, 0), "FlowerPot", Compound::new())).block_entities.is_empty());
}

#[test]
fn block_entities_take_the_form_of_today() {
    let of = |block, id, data| read_grid(&one(block, id, data)).block_entities[&[0, 0, 0]].clone();
    let id = |id| ("id", text(id));
    assert_eq!(of((54, 2), "Chest", Compound::new()), tags([id("minecraft:chest")]));
    assert_eq!(of((146, 2), "Chest", Compound::new()), tags([id("minecraft:trapped_chest")]));
    assert_eq!(of((1, 0), "mod.Thing", byte("a", 1)), tags([id("mod.Thing"), ("a", Tag::Byte(1))]));
    let named = of((54, 2), "Chest", tags([("CustomName", text("My \"box\""))]));
    assert_eq!(named["CustomName"], text("\"My \\\"box\\\"\""));
    let pattern =
        |color| Tag::List(vec![Tag::Compound(tags([("Color", Tag::Int(color)), ("Pattern", text("bs"))]))]);
    let banner = of((176, 0), "Banner", tags([("Base", Tag::Int(0)), ("Patterns", pattern(4))]));
    assert_eq!(banner, tags([id("minecraft:banner"), ("Patterns", pattern(11))]));
}

#[test]
fn signs_keep_their_words() {
    let sign = one((63, 0), "Sign", tags([("Text1", text("Inn")), ("Text2", text("{\"text\":\"open\"}"))]));
    let data = read_grid(&sign).block_entities[&[0, 0, 0]].clone();
    let Tag::Compound(front) = &data["front_text"] else { panic!("{data:?}") };
    let lines = ["\"Inn\"", "{\"text\":\"open\"}", "\"\"", "\"\""];
    assert_eq!(front["messages"], Tag::List(lines.map(text).to_vec()));
    assert!(!data.contains_key("Text1"));
}

#[test]
fn items_and_entities_of_old_are_kept_and_told() {
    let items =
        Tag::List(vec![Tag::Compound(tags([("id", text("minecraft:wool")), ("Damage", Tag::Short(14))]))]);
    let chest = one((54, 2), "Chest", tags([("Items", items.clone())]));
    assert_eq!(read(&chest).unwrap().warnings, [Warning::OldItems(1)]);
    assert_eq!(read_grid(&chest).block_entities[&[0, 0, 0]]["Items"], items);
    let pig =
        tags([("id", text("minecraft:pig")), ("Pos", Tag::List([0.5, 0.0, 0.5].map(Tag::Double).to_vec()))]);
    let bytes = file(&with(row(&[(2, 0)]), [("Entities", Tag::List(vec![Tag::Compound(pig)]))]));
    assert_eq!(read(&bytes).unwrap().warnings, [Warning::OldEntities(1)]);
    let entities = read_grid(&bytes).metadata.entities;
    assert_eq!(entities[0].place, [0.5, 0.0, 0.5]);
    assert_eq!(entities[0].data, tags([("id", text("minecraft:pig"))]));
}

#[test]
fn upper_halves_of_plants_are_what_they_stand_on() {
    let two_high = [("Width", Tag::Short(1)), ("Height", Tag::Short(2))];
    let found = states(&with(row(&[(175, 4), (175, 8)]), two_high));
    assert_eq!(found, ["rose_bush[half=lower]", "rose_bush[half=upper]"]);
}

#[test]
fn the_rest_of_the_file_is_kept() {
    let root = with(
        row(&[(2, 0)]),
        [("WEOffsetX", Tag::Int(-3)), ("WEOffsetZ", Tag::Int(4)), ("Icon", text("grass"))],
    );
    let metadata = read_grid(&file(&root)).metadata;
    assert_eq!(metadata.offset, Cell::new(-3, 0, 4));
    assert_eq!(metadata.data_version, Some(LEGACY_DATA_VERSION));
    let own = metadata.own.unwrap();
    assert_eq!((own.dialect, own.tags), (Dialect::Mcedit, tags([("Icon", text("grass"))])));
}

#[test]
fn refusals_name_the_field_and_what_was_expected() {
    let cases = [
        (("Materials", text("Pocket")), "the tag `Materials` is `Pocket`: vox knows only `Alpha`"),
        (("Height", Tag::Short(0)), "the tag `Height` is 0: a schematic is at least one block wide"),
        (("Height", Tag::Short(-1)), "the size 2 x 65535 x 1 makes 131070 blocks, but `Blocks` holds only 2"),
        (("Data", bytes(&[0])), "the size 2 x 1 x 1 makes 2 blocks, but `Data` holds only 1"),
        (("Data", Tag::Int(1)), "the tag `Data` is an Int (1): expected a Byte Array"),
        (("AddBlocks", bytes(&[])), "`AddBlocks` holds only 0 bytes, too few for all blocks"),
        (("Add", bytes(&[1])), "`Add` holds only 1 bytes, too few for all blocks"),
        (
            ("TileEntities", Tag::List(vec![Tag::Compound(Compound::new())])),
            "the tag `TileEntities[0].x` is missing: expected an Int",
        ),
    ];
    for (tag, message) in cases {
        let found = read(&file(&with(row(&[(1, 0), (2, 0)]), [tag]))).unwrap_err().to_string();
        assert!(found.starts_with(message), "expected: {message}\n   found: {found}");
    }
}

#[test]
fn real_files_are_read_into_legal_states() {
    let Some(folder) = folder() else { return };
    let mut count = 0;
    for pattern in ["builds/*.schematic", "sigi/*.schematic"] {
        for path in glob::glob(&folder.join(pattern).to_string_lossy()).unwrap() {
            let path = path.unwrap();
            let decoded =
                read(&std::fs::read(&path).unwrap()).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
            let Content::Grid(grid) = decoded.content else { panic!("{}: no grid", path.display()) };
            assert!(grid.cells().iter().any(|&id| id != 0), "{}", path.display());
            for state in grid.palette().states() {
                assert_eq!(check(state), Ok(()), "{}: {state}", path.display());
                assert!(!state.name().starts_with("legacy:"), "{}: {state}", path.display());
            }
            count += 1;
        }
    }
    assert!(count > 0, "no schematics in {}", folder.display());
}
