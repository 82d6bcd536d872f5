//! MagicaVoxel models: written and read, scenes with turns, another reader's opinion, and damage.

use super::examples::magica::{
    chunk, colors, dictionary, file, group, model, numbers, scene, shape, transform,
};
use super::{read, read_grid};
use ndarray::Array3;
use proptest::collection::vec;
use proptest::prelude::*;
use std::collections::BTreeMap;
use vox::block::{BlockState, Palette, Rgba, color};
use vox::grid::Grid;
use vox::io::{Encoded, Limits, Lost, Warning, encode_vox};
use vox::space::{Bounds, Cell};

/// Blocks that voxels become: air and some of the plain ones.
const PLAIN: [&str; 6] =
    ["white_concrete", "red_terracotta", "oak_planks", "stone", "gold_block", "warped_wart_block"];

fn encode(grid: &Grid) -> Encoded {
    encode_vox(grid, color).unwrap()
}

fn state(text: &str) -> BlockState {
    text.parse().unwrap()
}

fn palette(names: &[&str]) -> Palette {
    let mut palette = Palette::default();
    for name in names {
        palette.intern(&state(name)).unwrap();
    }
    palette
}

fn any_grid(names: &'static [&'static str]) -> impl Strategy<Value = Grid> {
    (1..12usize, 1..12usize, 1..12usize).prop_flat_map(move |(x, y, z)| {
        vec(0..=names.len() as u16, x * y * z).prop_map(move |cells| {
            let cells = Array3::from_shape_vec((y, z, x), cells).unwrap();
            Grid::from_cells(cells, palette(names)).unwrap()
        })
    })
}

/// The voxels of a file as another reader sees them, by their places in a grid, with their colours.
fn seen_by_another(bytes: &[u8], size: Cell) -> BTreeMap<[i32; 3], [u8; 4]> {
    let file = dot_vox::load_bytes(bytes).unwrap();
    let [model] = &file.models[..] else { panic!("expected one model") };
    let voxels = model.voxels.iter().map(|voxel| {
        let place = [i32::from(voxel.x), i32::from(voxel.z), size.z - 1 - i32::from(voxel.y)];
        let dot_vox::Color { r, g, b, a } = file.palette[usize::from(voxel.i)];
        (place, [r, g, b, a])
    });
    voxels.collect()
}

proptest! {
    #[test]
    fn plain_blocks_come_back_as_themselves(grid in any_grid(&PLAIN)) {
        let encoded = encode(&grid);
        prop_assert_eq!(&encoded, &encode(&grid));
        let decoded = read(&encoded.bytes).unwrap();
        prop_assert_eq!(decoded.warnings, vec![]);
        prop_assert!(read_grid(&encoded.bytes).same_blocks(&grid));
    }

    #[test]
    fn another_reader_sees_every_block_in_its_colour(
        grid in any_grid(&["oak_stairs[facing=east]", "glass", "water", "oak_fence", "mod:thing"]),
    ) {
        let seen = seen_by_another(&encode(&grid).bytes, grid.size());
        let cells = grid.bounds().cells().filter(|&cell| !grid.get(cell).is_air());
        let expected = cells.map(|cell| (cell.to_array(), color(grid.get(cell)).0)).collect();
        prop_assert_eq!(seen, expected);
    }

    #[test]
    fn damaged_files_are_read_or_refused(
        grid in any_grid(&PLAIN), at: prop::sample::Index, byte: u8, large: bool,
    ) {
        let mut bytes = if large { scene() } else { encode(&grid).bytes };
        let at = at.index(bytes.len());
        bytes[at] = byte;
        let _ = read(&bytes);
        let _ = read(&bytes[..at]);
    }
}

#[test]
fn builds_longer_than_a_model_are_a_scene_of_several() {
    let mut grid = Grid::new(Cell::new(600, 3, 257));
    let ids = PLAIN.map(|name| grid.intern(&state(name)).unwrap());
    for (at, cell) in grid.bounds().cells().enumerate().step_by(11) {
        grid.set(cell, ids[at % ids.len()]);
    }
    let encoded = encode(&grid);
    let file = dot_vox::load_bytes(&encoded.bytes).unwrap();
    assert_eq!((file.models.len(), file.scenes.len()), (6, 2 + 2 * 6));
    assert!(read_grid(&encoded.bytes).same_blocks(&grid));
}

#[test]
fn more_colours_than_a_palette_holds_are_joined_with_the_nearest() {
    let mut grid = Grid::new(Cell::new(100, 1, 3));
    for (n, cell) in grid.bounds().cells().enumerate() {
        let id = grid.intern(&state(&format!("mod:n{n}"))).unwrap();
        grid.set(cell, id);
    }
    let number = |state: &BlockState| state.name()[5..].parse::<u16>().unwrap_or_default();
    let shade = |state: &BlockState| {
        let n = number(state);
        Rgba::rgb((n % 256) as u8, (n / 256) as u8, 0)
    };
    let encoded = encode_vox(&grid, shade).unwrap();
    assert_eq!(encoded.lost, [Lost::States, Lost::Colors { found: 300, kept: 255 }]);
    let seen = seen_by_another(&encoded.bytes, grid.size());
    assert_eq!(seen.len(), 300);
    for (place, [red, green, ..]) in seen {
        let Rgba([r, g, ..]) = shade(grid.get(Cell::from_array(place)));
        assert!(red.abs_diff(r) <= 45 && green.abs_diff(g) <= 1, "{place:?}: {red} {green}, not {r} {g}");
    }
}

#[test]
fn what_has_no_colour_is_told_of() {
    let mut grid = Grid::new(Cell::ONE);
    assert_eq!(encode(&grid).lost, []);
    let id = grid.intern(&BlockState::structure_void()).unwrap();
    grid.set(Cell::ZERO, id);
    grid.metadata.offset = Cell::X;
    assert_eq!(encode(&grid).lost, [Lost::Offset(Cell::X)]);
    let error = encode_vox(&Grid::new(Cell::X), color).unwrap_err().to_string();
    assert_eq!(error, "the size 1 x 0 x 0 cannot be written: there is no block in it");
}

#[test]
fn models_are_turned_about_their_middles_and_placed() {
    let decoded = read(&scene()).unwrap();
    assert_eq!(decoded.warnings, [Warning::ModelsHidden(1)]);
    let grid = read_grid(&scene());
    assert_eq!(grid.size(), Cell::new(10, 1, 3));
    let blocks: BTreeMap<[i32; 3], &str> = grid
        .bounds()
        .cells()
        .filter(|&cell| !grid.get(cell).is_air())
        .map(|cell| (cell.to_array(), grid.get(cell).short_name()))
        .collect();
    let expected = [
        ([0, 0, 1], "white_concrete"),
        ([9, 0, 0], "white_concrete"),
        ([9, 0, 1], "white_concrete"),
        ([9, 0, 2], "gold_block"),
    ];
    assert_eq!(blocks, expected.into());
}

#[test]
fn files_without_a_palette_have_the_one_of_the_format() {
    let voxels: Vec<[u8; 4]> = (1..=255).map(|n| [n, 0, 0, n]).collect();
    let grid = read_grid(&file(&[model([256, 1, 1], &voxels)]));
    let colors: Vec<[u8; 3]> = dot_vox::DEFAULT_PALETTE.iter().map(|c| [c.r, c.g, c.b]).collect();
    let with_palette = read_grid(&file(&[model([256, 1, 1], &voxels), self::colors(&colors)]));
    assert!(grid.same_blocks(&with_palette));
    assert!(grid.palette().states().len() > 20);
}

#[test]
fn later_frames_and_voxels_outside_are_left_out_with_a_word() {
    let frames = file(&[model([1, 1, 1], &[[0, 0, 0, 1], [1, 0, 0, 1]]), model([2, 2, 2], &[])]);
    let decoded = read(&frames).unwrap();
    assert_eq!(decoded.warnings, [Warning::FramesLater(1), Warning::VoxelsOutside(1)]);
    assert_eq!(read_grid(&frames).bounds(), Bounds::of_size(Cell::ONE));
}

#[test]
fn later_frames_of_a_scene_are_left_out_with_a_word() {
    let key = |frame: &str| dictionary(&[("_f", frame)]);
    let moves = [numbers(&[0]), dictionary(&[]), numbers(&[1, -1, 0, 2]), key("0"), key("7")].concat();
    let three =
        [numbers(&[1]), dictionary(&[]), numbers(&[3, 1]), key("0"), numbers(&[0]), key("3")].concat();
    let voxel = [[0, 0, 0, 1]];
    // Of the three frames that the last number promises, two are there.
    let scene = |shape: &[u8]| {
        file(&[
            model([1, 1, 1], &voxel),
            model([2, 1, 1], &voxel),
            chunk("nTRN", &moves),
            chunk("nSHP", shape),
        ])
    };
    assert_eq!(read(&scene(&three)).unwrap().warnings, [Warning::FramesLater(1)]);
    assert_eq!(read_grid(&scene(&three)).bounds(), Bounds::of_size(Cell::new(2, 1, 1)));
    let whole = [three, numbers(&[1]), key("9")].concat();
    assert_eq!(read(&scene(&whole)).unwrap().warnings, [Warning::FramesLater(2)]);
}

#[test]
fn broken_files_are_refused() {
    let one = || model([1, 1, 1], &[[0, 0, 0, 1]]);
    let cases = [
        (b"VOX \x96\0".to_vec(), "`VOX ` takes 8 bytes more than the 6 that are left"),
        (b"VOX \x96\0\0\0NIAM\0\0\0\0\0\0\0\0".to_vec(), "expected a chunk `MAIN`, found `NIAM`"),
        (file(&[]), "there is no model: expected `SIZE` and `XYZI`"),
        (
            file(&[model([1, 257, 1], &[])]),
            "model 0 is 1 x 257 x 1: expected 1 to 256 voxels along each axis",
        ),
        (file(&[model([0, 1, 1], &[])]), "model 0 is 0 x 1 x 1: expected 1 to 256"),
        (
            file(&[chunk("SIZE", &numbers(&[1, 1, 1])), chunk("XYZI", &numbers(&[-1]))]),
            "`XYZI` takes 17179869180 bytes more than the 0 that are left",
        ),
        (file(&[one(), transform(0, &[], &[])]), "the scene has no node 1, which another one holds"),
        (file(&[one(), transform(0, &[], &[]), shape(1, 7)]), "the scene has a model 7, but there are 1"),
        (file(&[one(), group(0, &[0])]), "the scene has more than 262144 parts, or holds itself"),
        (file(&[one(), group(0, &[0, 0])]), "the scene has more than 262144 parts, or holds itself"),
        (
            file(&[one(), transform(0, &[], &[("_t", "1 2")])]),
            "`1 2` is no place: expected three whole numbers",
        ),
        (file(&[one(), transform(0, &[], &[("_r", "0")])]), "`0` is no rotation"),
        (
            file(&[one(), transform(0, &[], &[("_t", "2000000000 0 0")]), shape(1, 0)]),
            "the models of the scene lie too far apart",
        ),
        (
            file(&[
                one(),
                group(0, &[1, 3]),
                transform(1, &[], &[]),
                shape(2, 0),
                transform(3, &[], &[("_t", "500000 500000 0")]),
                shape(4, 0),
            ]),
            "the size 500001 x 1 x 500001 makes 250001000001 blocks, more than 268435456, the limit",
        ),
    ];
    for (bytes, message) in cases {
        let error = read(&bytes).unwrap_err().to_string();
        assert!(error.starts_with(message), "expected: {message}\n   found: {error}");
    }
}

#[test]
fn a_model_in_many_places_counts_each_time() {
    let children: Vec<i32> = vec![1; 1000];
    let bytes = file(&[
        model([8, 8, 8], &[[0, 0, 0, 1]; 512]),
        group(0, &children),
        transform(1, &[], &[]),
        shape(2, 0),
    ]);
    let limits = Limits { max_cells: 500_000, ..Limits::default() };
    let error = vox::io::decode(&bytes, &limits).unwrap_err().to_string();
    assert_eq!(error, "the size 8 x 8 x 8 makes 512000 blocks, more than 500000, the limit");
}
