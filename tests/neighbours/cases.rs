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
