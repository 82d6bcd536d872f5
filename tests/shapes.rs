//! Shapes of the buildings of SIGI's authors, against the logs of their program.

#[path = "common/real.rs"]
mod real;

use std::path::Path;
use vox::shapes::{Building, Cost, Operation, Overlap, Rest, Settings, Shape, Specification, Statistics, cut, search};

/// What the authors' program found with some parameters.
struct Row {
    settings: Settings,
    is_cut: bool,
    shapes: usize,
    blocks: usize,
    redundant: usize,
}

/// The rows of a log: a heading of five lines before each block of rows, then named values of one row after another.
fn rows(text: &str) -> Vec<Row> {
    let mut rows = Vec::new();
    let mut settings = Settings { rest: Rest::Left, ..Settings::default() };
    let (mut is_cut, mut shapes) = (false, 0);
    let mut blocks = 0.0;
    for (name, value) in text.lines().filter_map(|line| line.rsplit_once(": ")) {
        let choice = || value.parse::<usize>().expect("a choice is a number");
        let number = || value.parse::<f64>().expect("a value is a number");
        match name {
            _ if name.starts_with("Rect(0)") => {
                settings.specification =
                    [Specification::Rectangular, Specification::Planar, Specification::Solid][choice()];
            }
            _ if name.starts_with("Merge(0)") => {
                settings.operation = [Operation::Merge, Operation::Split, Operation::Both][choice()];
            }
            "Cost function" => settings.cost = [Cost::Additive, Cost::Varied, Cost::Alike][choice()],
            "Overlap allowed" => settings.overlap = if value == "True" { Overlap::Shared } else { Overlap::Apart },
            "Post split" => is_cut = value == "True",
            "Alpha" => settings.alpha = number(),
            "Number of shapes" => shapes = choice(),
            "Mean shape size" => blocks = number() * shapes as f64,
            "Number of 'redundant' identical shapes" => {
                rows.push(Row { settings, is_cut, shapes, blocks: blocks.round() as usize, redundant: choice() });
            }
            _ => {}
        }
    }
    rows
}

fn found(building: &Building, row: &Row) -> Statistics {
    let shapes = search(building, &row.settings);
    let shapes: Vec<Shape> = if row.is_cut { cut(building, shapes) } else { shapes };
    Statistics::of(building, &shapes)
}

fn agrees(building: &Building, row: &Row) -> bool {
    let found = found(building, row);
    let blocks = (found.mean_size * found.shapes as f64).round() as usize;
    (found.shapes, blocks, found.redundant) == (row.shapes, row.blocks, row.redundant)
}

fn example(folder: &Path, number: u32) -> (Building, Vec<Row>) {
    let bytes = std::fs::read(folder.join(format!("E{number}.schematic"))).expect("the example is there");
    let grid = vox::io::decode(&bytes, &vox::io::Limits::default()).expect("it is a schematic").content;
    let vox::io::Content::Grid(grid) = grid else { panic!("a schematic holds blocks") };
    let log = std::fs::read_to_string(folder.join(format!("logs/experiment{number}.txt"))).expect("its log is there");
    (Building::of(&grid), rows(&log))
}

const EXAMPLES: [u32; 8] = [1, 2, 3, 4, 5, 6, 7, 9];

/// The rows that the authors recommend: rectangles by merges, of their first cost with alpha 1.
#[test]
fn recommended_parameters_give_what_the_authors_logged() {
    let Some(folder) = real::folder().map(|data| data.join("sigi")) else { return };
    for number in EXAMPLES {
        let (building, rows) = example(&folder, number);
        let recommended = rows.iter().filter(|row| {
            let Settings { specification, operation, cost, alpha, .. } = row.settings;
            (specification, operation, cost, alpha)
                == (Specification::Rectangular, Operation::Merge, Cost::Additive, 1.0)
        });
        let recommended: Vec<&Row> = recommended.collect();
        assert_eq!(recommended.len(), 4, "E{number}: with and without overlap, cut and not");
        for row in recommended {
            assert!(agrees(&building, row), "E{number}, {:?}: {:?}", row.settings, found(&building, row));
        }
    }
}

/// Of all rows nine in ten agree; docs/performance.md says where the others come from.
#[test]
fn most_parameters_give_what_the_authors_logged() {
    let Some(folder) = real::folder().map(|data| data.join("sigi")) else { return };
    let (mut agreeing, mut all) = (0, 0);
    for number in EXAMPLES {
        let (building, rows) = example(&folder, number);
        let count = rows.iter().filter(|row| agrees(&building, row)).count();
        println!("E{number}: {count} of {} rows agree", rows.len());
        agreeing += count;
        all += rows.len();
    }
    println!("{agreeing} of {all} rows agree");
    assert!(agreeing * 100 >= all * 92, "{agreeing} of {all}");
}
