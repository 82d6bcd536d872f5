//! How fast grammars become grids and files.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use vox::graph::{OpGraph, lower};
use vox::io::{SchemVersion, encode_schem};
use vox::run::{Library, Options, Things, derive, run};
use vox::space::{Cell, Frame, Scope};

fn graph(text: &str) -> OpGraph {
    let grammar = text.parse().expect("the grammar parses");
    let checked = vox::grammar::check(grammar).expect("the grammar has no error");
    lower(&checked, None).expect("the grammar has a first rule")
}

fn options(size: [i32; 3]) -> Options {
    Options { size: Some(Cell::from(size)), ..Options::default() }
}

/// The derivation alone: scopes a second, without a grid.
fn scopes(c: &mut Criterion) {
    let graph = graph(CELLS);
    let options = options([64, 96, 64]);
    let start = Scope::start(Cell::new(64, 96, 64), Frame::default());
    // 24 floors, 16 rows in each, 16 cells in each, and a split with two leaves in every cell.
    let scopes = 1 + 24 * (1 + 16 * (1 + 16 * 3));
    let mut group = c.benchmark_group("scopes");
    group.throughput(Throughput::Elements(scopes));
    group.bench_function("derive", |b| {
        b.iter(|| {
            let things = Things::default();
            let mut placed = 0u64;
            derive(&graph, &things, start, &options, None, &mut |placement| {
                placed += u64::from(!placement.scope.is_empty());
                Ok(())
            })
            .expect("it runs");
            black_box(placed)
        });
    });
    group.finish();
}

/// Villages of 252, 504 and 1,008 plots: time grows as they do.
fn village(c: &mut Criterion) {
    let graph = graph(include_str!("../grammars/village.grammar"));
    let library = Library::new();
    let mut group = c.benchmark_group("village");
    group.sample_size(10);
    for (houses, z) in [(252, 234), (504, 468), (1008, 936)] {
        let options = options([392, 24, z]);
        group.throughput(Throughput::Elements(houses));
        group.bench_function(format!("{houses} houses"), |b| {
            b.iter(|| run(black_box(&graph), &library, &options))
        });
    }
    group.finish();
}

const CELLS: &str = "tower --> repeat(y, 4){ repeat(z, 4){ repeat(x, 4){ cell } } }
     cell --> split(y){ 1 : I(smooth_stone) | 3 : I(bricks) }";

/// 64 x 96 x 64 blocks in cells of 4 x 4 x 4, each a slab of 1 and a body of 3: 12,288 leaves.
fn cells(c: &mut Criterion) {
    let graph = graph(CELLS);
    let library = Library::new();
    let options = options([64, 96, 64]);
    let mut group = c.benchmark_group("cells");
    group.bench_function("derive", |b| b.iter(|| run(black_box(&graph), &library, &options)));
    group.bench_function("derive and write .schem", |b| {
        b.iter(|| {
            let made = run(black_box(&graph), &library, &options).expect("it runs").made;
            encode_schem(&made, SchemVersion::V2)
        });
    });
    group.finish();
}

/// Cities of 512 x 512 x 96 blocks: that of seed 1 as printed, and ours with streets and windows.
fn city(c: &mut Criterion) {
    let library = Library::new();
    let options = options([512, 512, 96]);
    let mut group = c.benchmark_group("city");
    group.sample_size(20);
    let cities = [
        ("as printed", include_str!("../tests/seed1/skyscraper-city.grammar")),
        ("with windows", include_str!("../grammars/skyscraper-city.grammar")),
    ];
    for (name, text) in cities {
        let graph = graph(text);
        group.bench_function(name, |b| b.iter(|| run(black_box(&graph), &library, &options)));
    }
    group.finish();
}

criterion_group!(benches, scopes, cells, city, village);
criterion_main!(benches);
