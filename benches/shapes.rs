//! Shapes: the tables of SIGI's evaluation with both costs, what further searches save, and how long searches take.
//!
//! `cargo bench --bench shapes` prints all; it needs the authors' examples in `VOX_DATA` or `../shared/data`.

#[path = "../tests/common/real.rs"]
mod real;

use std::collections::BTreeMap;
use std::num::NonZeroU32;
use std::path::Path;
use std::time::Instant;
use vox::grid::Grid;
use vox::shapes::{
    Building, Cost, Operation, Overlap, Rest, Search, Settings, Specification, Statistics, cost, search,
};

const ALPHAS: [f64; 12] = [0.0, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 2.0, 5.0, 10.0, 100.0];
const SPECIFICATIONS: [Specification; 3] =
    [Specification::Rectangular, Specification::Planar, Specification::Solid];
const OPERATIONS: [Operation; 3] = [Operation::Merge, Operation::Split, Operation::Both];
const OVERLAPS: [Overlap; 2] = [Overlap::Apart, Overlap::Shared];

fn main() {
    let Some(data) = real::folder() else { return };
    let buildings: Vec<(u32, Building)> = [1, 2, 3, 4, 5, 6, 7, 9]
        .map(|number| (number, Building::of(&grid(&data.join(format!("sigi/E{number}.schematic"))))))
        .into();
    for cost in [Cost::Additive, Cost::Paper] {
        tables(&buildings, cost);
    }
    searches(&buildings);
    times(&data, &buildings);
}

fn grid(path: &Path) -> Grid {
    let bytes = std::fs::read(path).expect("the example is there");
    match vox::io::decode(&bytes, &vox::io::Limits::default()).expect("it can be read").content {
        vox::io::Content::Grid(grid) => grid,
        vox::io::Content::Boxes(_) => panic!("a schematic holds blocks"),
    }
}

/// Tables 1 to 4 of seed 3, over all parameters.
fn tables(buildings: &[(u32, Building)], cost: Cost) {
    let mut rows: BTreeMap<String, Vec<Statistics>> = BTreeMap::new();
    for (_, building) in buildings {
        for specification in SPECIFICATIONS {
            for operation in OPERATIONS {
                for overlap in OVERLAPS {
                    for alpha in ALPHAS {
                        let settings = Settings {
                            specification,
                            operation,
                            cost,
                            alpha,
                            overlap,
                            rest: Rest::Left,
                            ..Settings::default()
                        };
                        let found = Statistics::of(building, &search(building, &settings));
                        let mut enter = |row: String| rows.entry(row).or_default().push(found);
                        if operation == Operation::Merge {
                            enter(format!("1 overlap {overlap:?}"));
                        }
                        enter(format!("2 alpha {alpha:>6.2}"));
                        enter(format!("3 operation {operation:?}"));
                        enter(format!("4 shapes {specification:?}"));
                    }
                }
            }
        }
    }
    println!(
        "\n{cost:?} cost: averages, then medians, of the number of shapes, % matching, size, complexity"
    );
    for (row, found) in rows {
        let of = |value: fn(&Statistics) -> f64| found.iter().map(value).collect::<Vec<f64>>();
        let columns = [
            of(|s| s.shapes as f64),
            of(Statistics::matching_percent),
            of(|s| s.mean_size),
            of(|s| s.complexity),
        ];
        let means = columns.each_ref().map(|column| column.iter().sum::<f64>() / column.len() as f64);
        let medians = columns.map(|mut column| {
            column.sort_by(f64::total_cmp);
            column[column.len() / 2]
        });
        println!("  {row:<24} {means:8.3?} {medians:8.3?}");
    }
}

/// What sets cost that further searches find, and sets of mixed specifications, beside those of the hill climbing.
fn searches(buildings: &[(u32, Building)]) {
    let twenty = NonZeroU32::new(20).expect("twenty is not zero");
    let base = Settings::default();
    let of = |search| Settings { search, ..base };
    let kinds = [
        ("climb", base),
        ("restarts", of(Search::Restarts(twenty))),
        ("backtracking", of(Search::Backtracking(twenty))),
        ("annealing", of(Search::Annealing(twenty))),
        ("2D", Settings { specification: Specification::Planar, ..base }),
        ("3D", Settings { specification: Specification::Solid, ..base }),
        ("mixed", Settings { specification: Specification::Mixed, ..base }),
    ];
    println!("\nthe cost of whole sets, additive, alpha 1");
    for (name, settings) in kinds {
        let costs = buildings.iter().map(|(number, building)| {
            let shapes = search(building, &settings);
            let cost =
                cost(building, &settings, shapes.iter().map(|shape| (shape.layer, shape.blocks.as_slice())));
            format!("E{number} {cost:7.2}")
        });
        println!("  {name:<13} {}", costs.collect::<Vec<_>>().join("  "));
    }
}

/// The least time of ten searches, in milliseconds.
fn times(data: &Path, buildings: &[(u32, Building)]) {
    println!("\nmilliseconds of a search: rectangles by merges, with overlap");
    let settings = Settings { overlap: Overlap::Shared, rest: Rest::Left, ..Settings::default() };
    let time = |building: &Building| {
        let runs = (0..10).map(|_| {
            let start = Instant::now();
            std::hint::black_box(search(building, &settings));
            start.elapsed().as_secs_f64() * 1e3
        });
        runs.fold(f64::INFINITY, f64::min)
    };
    for (number, building) in buildings {
        println!("  E{number}: {:8.2} for {} blocks", time(building), building.len());
    }
    for name in ["mansion.litematic", "island.litematic"] {
        let building = Building::of(&grid(&data.join("builds").join(name)));
        println!("  {name}: {:8.2} for {} blocks", time(&building), building.len());
    }
}
