//! The rules one by one, from `cases.txt`.

use std::collections::BTreeMap;
use vox::block::BlockState;
use vox::grid::Grid;
use vox::neighbours::settle;
use vox::space::Cell;

struct Case {
    name: String,
    grid: Grid,
    /// Where each letter stands.
    cells: Vec<(char, Cell)>,
    expected: BTreeMap<char, String>,
}

fn meanings<'t>(lines: impl Iterator<Item = &'t str>) -> BTreeMap<char, String> {
    let pairs = lines.filter_map(|line| line.split_once(" = "));
    pairs.map(|(letter, state)| (letter.chars().next().unwrap(), state.to_owned())).collect()
}

fn case(text: &str) -> Case {
    let (given, expected) = text.split_once("=>\n").unwrap();
    let (name, body) = given.split_once('\n').unwrap();
    let plan: Vec<&str> = body.lines().take_while(|line| !line.contains(" = ")).collect();
    let letters = meanings(body.lines());
    let layers: Vec<&[&str]> = plan.split(|line| *line == "--").collect();
    let cells: Vec<(char, Cell)> = (0..).zip(&layers).flat_map(|(y, layer)| placed(y, layer)).collect();
    let size = cells.iter().fold(Cell::ZERO, |size, (_, cell)| size.max(*cell + 1));
    let mut grid = Grid::new(size);
    for (letter, cell) in &cells {
        let state = match letter {
            '.' => "air",
            '#' => "stone",
            letter => letters.get(letter).unwrap_or_else(|| panic!("{name}: {letter}")),
        };
        let id = grid.intern(&state.parse::<BlockState>().unwrap()).unwrap();
        grid.set(*cell, id);
    }
    Case { name: name.to_owned(), grid, cells, expected: meanings(expected.lines()) }
}

fn placed(y: i32, layer: &[&str]) -> Vec<(char, Cell)> {
    let rows = (0..).zip(layer);
    rows.flat_map(|(z, row)| (0..).zip(row.chars()).map(move |(x, letter)| (letter, Cell::new(x, y, z))))
        .collect()
}

#[test]
fn every_rule_gives_what_the_game_gives() {
    let cases = include_str!("cases.txt").split("## ").skip(1).map(case);
    let mut wrong = Vec::new();
    for mut case in cases {
        settle(&mut case.grid).unwrap();
        assert!(!case.expected.is_empty(), "{}", case.name);
        for (letter, expected) in &case.expected {
            let (_, cell) = case.cells.iter().find(|(other, _)| other == letter).unwrap();
            let found = case.grid.get(*cell).short();
            if found != *expected {
                wrong.push(format!(
                    "{}\n  {letter} expected {expected}\n  {letter} found    {found}",
                    case.name
                ));
            }
        }
    }
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

/// A grid of one layer above the other, each a row along x.
fn rows(layers: [&[&str]; 2]) -> Grid {
    let mut grid = Grid::new(Cell::new(layers[0].len() as i32, 2, 1));
    for (y, row) in (0..).zip(layers) {
        for (x, state) in (0..).zip(row) {
            let id = grid.intern(&state.parse::<BlockState>().unwrap()).unwrap();
            grid.set(Cell::new(x, y, 0), id);
        }
    }
    settle(&mut grid).unwrap();
    grid
}

#[test]
fn dust_climbs_under_what_does_not_conduct() {
    const CONDUCT: [&str; 13] = [
        "stone",
        "oak_planks",
        "target",
        "soul_sand",
        "mud",
        "redstone_lamp",
        "slime_block",
        "spawner",
        "barrier",
        "mangrove_roots",
        "packed_ice",
        "oak_slab[type=double]",
        "shulker_box",
    ];
    const INSULATE: [&str; 19] = [
        "air",
        "glass",
        "tinted_glass",
        "red_stained_glass",
        "glowstone",
        "sea_lantern",
        "ice",
        "tnt",
        "oxidized_copper_bulb",
        "copper_grate",
        "oak_leaves",
        "oak_slab[type=top]",
        "oak_stairs",
        "observer",
        "piston",
        "redstone_block",
        "honey_block",
        "snow[layers=8]",
        "powder_snow",
    ];
    let climbs = |above: &str| {
        let grid = rows([&["redstone_wire", "stone"], &[above, "redstone_wire"]]);
        grid.get(Cell::ZERO).get("east") == Some("up")
    };
    assert_eq!(CONDUCT.map(climbs), [false; 13], "{CONDUCT:?}");
    assert_eq!(INSULATE.map(climbs), [true; 19], "{INSULATE:?}");
}

#[test]
fn walls_have_posts_under_what_the_game_names() {
    const ON_POSTS: [&str; 8] = [
        "torch",
        "soul_torch",
        "redstone_torch",
        "tripwire",
        "oak_sign",
        "oak_wall_sign",
        "red_banner",
        "stone_pressure_plate",
    ];
    const NOT: [&str; 6] =
        ["air", "wall_torch", "soul_wall_torch", "oak_hanging_sign", "oak_wall_hanging_sign", "poppy"];
    let has_post = |above: &str| {
        let grid = rows([&["stone", "cobblestone_wall", "stone"], &["air", above, "air"]]);
        grid.get(Cell::X).get("up") == Some("true")
    };
    assert_eq!(ON_POSTS.map(has_post), [true; 8], "{ON_POSTS:?}");
    assert_eq!(NOT.map(has_post), [false; 6], "{NOT:?}");
}
