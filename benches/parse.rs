//! How fast buildings are parsed under the grammars that made them, and under one that did not.

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use vox::graph::{OpGraph, lower};
use vox::grid::Grid;
use vox::parse::{Laws, Parser};
use vox::run::{Library, Options, run};

const GRAMMARS: [(&str, &str); 3] = [
    ("cottage", include_str!("../grammars/cottage.grammar")),
    ("garage", include_str!("../grammars/garage.grammar")),
    ("better-roofs", include_str!("../grammars/better-roofs.grammar")),
];

fn graph(text: &str) -> OpGraph {
    let grammar = text.parse().expect("the grammar parses");
    let checked = vox::grammar::check(grammar).expect("the grammar has no error");
    lower(&checked, None).expect("the grammar has a first rule")
}

fn houses(graph: &OpGraph, count: u64) -> Vec<Grid> {
    let made =
        |seed| run(graph, &Library::new(), &Options { seed, ..Options::default() }).expect("it runs").made;
    (0..count).map(made).collect()
}

/// Houses one after the other, by a parser that is new to them and by one that has seen others.
fn derives(c: &mut Criterion) {
    for (name, text) in GRAMMARS {
        let graph = graph(text);
        let houses = houses(&graph, 40);
        let cells: u64 = houses.iter().map(|house| house.bounds().volume()).sum();
        let mut group = c.benchmark_group(format!("parse/{name}"));
        group.throughput(Throughput::Elements(houses.len() as u64));
        group.sample_size(20);
        println!("{name}: {} cells a house", cells / houses.len() as u64);
        let laws = [(Laws::AsWritten, "as written"), (Laws::Widened, "widened")];
        // Large houses have too many boxes to be parsed with lengths of any kind in a bench.
        for (laws, word) in
            laws.into_iter().filter(|(laws, _)| *laws == Laws::AsWritten || name != "better-roofs")
        {
            group.bench_function(format!("40 houses, {word}"), |b| {
                b.iter_batched_ref(
                    || Parser::new(&graph, laws),
                    |parser| houses.iter().filter(|house| parser.derives(black_box(house))).count(),
                    BatchSize::LargeInput,
                );
            });
        }
        group.finish();
    }
}

/// What houses of one grammar leave open under another.
fn unexplained(c: &mut Criterion) {
    let [cottage, garage] = [graph(GRAMMARS[0].1), graph(GRAMMARS[1].1)];
    let houses = houses(&garage, 5);
    let mut group = c.benchmark_group("parse/unexplained");
    group.sample_size(10);
    group.throughput(Throughput::Elements(houses.len() as u64));
    group.bench_function("5 garages under the cottage's grammar", |b| {
        b.iter_batched_ref(
            || Parser::new(&cottage, Laws::AsWritten),
            |parser| houses.iter().filter(|house| parser.parse(black_box(house)).is_ok()).count(),
            BatchSize::LargeInput,
        );
    });
    group.finish();
}

criterion_group!(benches, derives, unexplained);
criterion_main!(benches);
