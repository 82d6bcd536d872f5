//! How fast grammars become grids and files.

use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use vox::graph::{OpGraph, lower};
use vox::io::{SchemVersion, encode_schem};
use vox::run::{Library, Options, run};
use vox::space::Cell;

fn graph(text: &str) -> OpGraph {
    let grammar = text.parse().expect("the grammar parses");
    let checked = vox::grammar::check(grammar).expect("the grammar has no error");
    lower(&checked, None).expect("the grammar has a first rule")
}

fn options(size: [i32; 3]) -> Options {
    Options { size: Some(Cell::from(size)), ..Options::default() }
}

/// 64 x 96 x 64 blocks in cells of 4 x 4 x 4, each a slab of 1 and a body of 3: 12,288 leaves.
fn cells(c: &mut Criterion) {
    let graph = graph(
        "tower --> repeat(y, 4){ repeat(z, 4){ repeat(x, 4){ cell } } }
         cell --> split(y){ 1 : I(smooth_stone) | 3 : I(bricks) }",
    );
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

criterion_group!(benches, cells, city);
criterion_main!(benches);
