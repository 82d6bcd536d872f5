//! Structures of Bedrock Edition: NBT with the low byte first, and names that are not Java's.

use super::examples::mcstructure::{Structure, block, compound, ints, text};
use super::{read, read_grid, tags};
use vox::grid::Dialect;
use vox::io::Warning;
use vox::nbt::{Compound, Tag};

fn states(bytes: &[u8]) -> Vec<String> {
    let grid = read_grid(bytes);
    grid.bounds().cells().map(|cell| grid.get(cell).short()).collect()
}

#[test]
fn cells_run_along_z_first() {
    let palette = vec![block("minecraft:air", []), block("minecraft:stone", []), block("minecraft:dirt", [])];
    let indices = [0, 1, 2, 0, 0, -1, 0, 0];
    let grid = read_grid(&Structure::of([2, 2, 2], [&indices, &[-1; 8]], palette).file());
    let at = |x, y, z| grid.get(vox::space::Cell::new(x, y, z)).short();
    assert_eq!([at(0, 0, 1), at(0, 1, 0), at(1, 0, 1)], ["stone", "dirt", "structure_void"]);
    assert_eq!(grid.metadata.data_version, None);
    let own = grid.metadata.own.unwrap();
    assert_eq!(
        (own.dialect, own.tags),
        (Dialect::Bedrock, tags([("structure_world_origin", ints(&[100, 64, -7]))]))
    );
}

#[test]
fn names_and_states_become_those_of_java() {
    let stairs =
        block("minecraft:oak_stairs", [("weirdo_direction", Tag::Int(1)), ("upside_down_bit", Tag::Byte(1))]);
    let old = block("minecraft:stone", [("stone_type", text("diorite"))]);
    let java = block("minecraft:dirt_path", []);
    let stranger = block("Mod:Lamp", [("lit", Tag::Byte(1))]);
    let bytes = Structure::of([4, 1, 1], [&[0, 1, 2, 3], &[-1; 4]], vec![stairs, old, java, stranger]).file();
    assert_eq!(
        states(&bytes),
        [
            "oak_stairs[facing=west,half=top,shape=straight,waterlogged=false]",
            "diorite",
            "dirt_path",
            "mod:lamp[lit=1]"
        ]
    );
    let unknown = Warning::UnknownBedrock { blocks: 1, names: "mod:lamp".into() };
    assert_eq!(read(&bytes).unwrap().warnings, [unknown]);
}

#[test]
fn water_of_the_second_layer() {
    let palette = vec![
        block("minecraft:water", [("liquid_depth", Tag::Int(0))]),
        block("minecraft:oak_fence", []),
        block("minecraft:air", []),
        block("minecraft:dirt", []),
    ];
    let bytes = Structure::of([5, 1, 1], [&[1, 2, 3, -1, 1], &[0, 0, 0, 0, -1]], palette).file();
    let fence = |wet| format!("oak_fence[east=false,north=false,south=false,waterlogged={wet},west=false]");
    let expected = [&fence(true), "water[level=0]", "dirt", "structure_void", &fence(false)];
    assert_eq!(states(&bytes), expected);
    assert_eq!(read(&bytes).unwrap().warnings, [Warning::WaterDropped(2)]);
}

#[test]
fn block_entities_decide_states() {
    let id = |id| ("id", text(id));
    let plant = compound([("name", text("minecraft:poppy"))]);
    let cases = [
        (
            block(
                "minecraft:bed",
                [
                    ("direction", Tag::Int(0)),
                    ("head_piece_bit", Tag::Byte(0)),
                    ("occupied_bit", Tag::Byte(0)),
                ],
            ),
            tags([id("Bed"), ("color", Tag::Byte(11))]),
            "blue_bed[facing=south,occupied=false,part=foot]",
        ),
        (
            block("minecraft:standing_banner", [("ground_sign_direction", Tag::Int(4))]),
            tags([id("Banner"), ("Base", Tag::Int(0))]),
            "black_banner[rotation=4]",
        ),
        (
            block("minecraft:skull", [("facing_direction", Tag::Int(1))]),
            tags([id("Skull"), ("SkullType", Tag::Byte(2)), ("Rotation", Tag::Float(-90.0))]),
            "zombie_head[rotation=12]",
        ),
        (
            block("minecraft:flower_pot", [("update_bit", Tag::Byte(0))]),
            tags([id("FlowerPot"), ("PlantBlock", plant)]),
            "potted_poppy",
        ),
        (
            block("minecraft:noteblock", []),
            tags([id("Music"), ("note", Tag::Byte(5))]),
            "note_block[instrument=harp,note=5,powered=false]",
        ),
        (
            block("minecraft:red_shulker_box", []),
            tags([id("ShulkerBox"), ("facing", Tag::Byte(4))]),
            "red_shulker_box[facing=west]",
        ),
    ];
    for (block, data, expected) in cases {
        let bytes = Structure::with_entity(block, data).file();
        assert_eq!(states(&bytes), [expected]);
        assert_eq!(read(&bytes).unwrap().warnings, [], "{expected}");
    }
}

#[test]
fn block_entities_get_the_ids_of_java() {
    let chest =
        |data| Structure::with_entity(block("minecraft:chest", [("facing_direction", Tag::Int(3))]), data);
    let place = [("x", Tag::Int(100)), ("isMovable", Tag::Byte(1)), ("id", text("Chest"))];
    let empty = chest(tags(place.clone())).file();
    assert_eq!(read_grid(&empty).block_entities, [([0; 3], tags([("id", text("minecraft:chest"))]))].into());
    assert_eq!(read(&empty).unwrap().warnings, []);
    let mut full = tags(place);
    full.insert("Items", Tag::List(vec![compound([("Name", text("minecraft:stick"))])]));
    assert_eq!(read(&chest(full).file()).unwrap().warnings, [Warning::BedrockData(1)]);
}

#[test]
fn signs_keep_their_words() {
    let sign = block("minecraft:standing_sign", [("ground_sign_direction", Tag::Int(0))]);
    let words = [
        tags([("id", text("Sign")), ("Text", text("The\nInn"))]),
        tags([("id", text("Sign")), ("FrontText", compound([("Text", text("The\nInn"))]))]),
    ];
    for data in words {
        let bytes = Structure::with_entity(sign.clone(), data).file();
        let data = read_grid(&bytes).block_entities[&[0; 3]].clone();
        let Tag::Compound(front) = &data["front_text"] else { panic!("{data:?}") };
        let lines = ["\"The\"", "\"Inn\"", "\"\"", "\"\""];
        assert_eq!(front["messages"], Tag::List(lines.map(text).to_vec()));
        assert_eq!(data["id"], text("minecraft:sign"));
    }
}

#[test]
fn signs_keep_their_colour_glow_and_wax() {
    let red = 0xff_b0_2e_26_u32.cast_signed();
    let front = [("Text", text("Inn")), ("SignTextColor", Tag::Int(red)), ("IgnoreLighting", Tag::Byte(1))];
    let data = tags([("id", text("Sign")), ("FrontText", compound(front)), ("IsWaxed", Tag::Byte(1))]);
    let sign = block("minecraft:standing_sign", [("ground_sign_direction", Tag::Int(0))]);
    let data = read_grid(&Structure::with_entity(sign, data).file()).block_entities[&[0; 3]].clone();
    let side = |name: &str| match &data[name] {
        Tag::Compound(side) => (side["color"].clone(), side["has_glowing_text"].clone()),
        _ => panic!("{data:?}"),
    };
    assert_eq!(side("front_text"), (text("red"), Tag::Byte(1)));
    assert_eq!(side("back_text"), (text("black"), Tag::Byte(0)));
    assert_eq!(data["is_waxed"], Tag::Byte(1));
}

#[test]
fn what_is_left_out_is_told() {
    let palette = ["minecraft:stone", "minecraft:snow_layer", "minecraft:water"].map(|name| block(name, []));
    let mut structure = Structure::of([3, 1, 1], [&[0, -1, 0], &[1, 2, -1]], palette.to_vec());
    let ticks = Tag::List(vec![compound([]), compound([])]);
    structure.data = tags([("0", compound([("tick_queue_data", ticks), ("mod:heat", Tag::Int(3))]))]);
    let mut bytes = structure.file();
    bytes.extend([0; 7]);
    let expected = [
        Warning::WaterDropped(1),
        Warning::SecondLayer(1),
        Warning::TicksDropped(2),
        Warning::TagsDropped("structure.palette.default.block_position_data.<cell>.mod:heat".into()),
        Warning::Trailing(7),
    ];
    assert_eq!(read(&bytes).unwrap().warnings, expected);
}

#[test]
fn entities_count_from_the_low_corner() {
    let mut structure = Structure::of([1, 1, 1], [&[0], &[-1]], vec![block("minecraft:air", [])]);
    let place = Tag::List([100.5, 65.0, -6.5].map(Tag::Float).to_vec());
    structure.entities = Tag::List(vec![compound([("identifier", text("minecraft:cow")), ("Pos", place)])]);
    let bytes = structure.file();
    let entities = read_grid(&bytes).metadata.entities;
    assert_eq!(entities[0].place, [0.5, 1.0, 0.5]);
    assert_eq!(entities[0].data, tags([("id", text("minecraft:cow"))]));
    assert_eq!(read(&bytes).unwrap().warnings, [Warning::BedrockData(1)]);
}

#[test]
fn places_outside_are_left_out() {
    for key in ["1", "-1", "99999999999999999999", "x"] {
        let mut structure = Structure::with_entity(block("minecraft:chest", []), Compound::new());
        let data = structure.data.remove("0").unwrap();
        structure.data.insert(key.to_owned(), data);
        let decoded = read(&structure.file()).unwrap();
        assert!(decoded.warnings.contains(&Warning::BlockEntitiesOutside(1)), "{key}");
    }
}

#[test]
fn refusals_name_the_field_and_what_was_expected() {
    let small = || Structure::of([2, 1, 1], [&[0, 0], &[-1, -1]], vec![block("minecraft:air", [])]);
    let sized = |size: &[i32]| Structure { size: ints(size), ..small() };
    let layered = |layers: &[&[i32]]| {
        let layers = Tag::List(layers.iter().map(|layer| ints(layer)).collect());
        Structure { layers, ..small() }
    };
    let cases = [
        (sized(&[0, 1, 1]), "the tag `size[0]` is 0: expected 1 to 65,535"),
        (sized(&[1, -7, 1]), "the tag `size[1]` is -7: expected 1 to 65,535"),
        (sized(&[1, 1, i32::MAX]), "the tag `size[2]` is 2147483647: expected 1 to 65,535"),
        (sized(&[1, 1]), "the tag `size` is a List of 2: expected an Int Array of 3"),
        (
            sized(&[3, 1, 1]),
            "the size 3 x 1 x 1 makes 3 blocks, but `structure.block_indices[0]` holds only 2",
        ),
        (
            sized(&[65_535, 65_535, 65_535]),
            "the size 65535 x 65535 x 65535 makes 281462092005375 blocks, more than",
        ),
        (layered(&[]), "the tag `structure.block_indices[0]` is missing: expected a List"),
        (
            layered(&[&[0, 0], &[0]]),
            "the size 2 x 1 x 1 makes 2 blocks, but `structure.block_indices[1]` holds only 1",
        ),
        (
            layered(&[&[0, 1]]),
            "`structure.block_indices[0]`, block (1, 0, 0): index 1 is not in the palette of 1 entries",
        ),
        (
            Structure { palette: vec![block("a b", [])], ..small() },
            "the entry `a b[]` of `structure.palette.default.block_palette[0].name` is no block state",
        ),
        (
            Structure { palette: vec![block("mod:a", [("b", text("c]d"))])], ..small() },
            "the entry `mod:a[b=c]d]` of `structure.palette.default.block_palette[0].name` is no block state",
        ),
    ];
    for (structure, message) in cases {
        let found = read(&structure.file()).unwrap_err().to_string();
        assert!(found.starts_with(message), "expected: {message}\n   found: {found}");
    }
    let whole = small().file();
    for len in 40..whole.len() {
        assert!(read(&whole[..len]).is_err(), "{len}");
    }
}
