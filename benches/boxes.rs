//! How box splitting grows with the number of boxes, and against trying every plane on every box.

#[path = "../tests/common/jumble.rs"]
mod jumble;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use vox::graph::lower;
use vox::grid::LabelledBoxes;
use vox::infer::{
    Example, Freedom, Method, Node, NodeId, Part, Tree, TreeBuilder, UPRIGHT_FIRST, infer, split_boxes,
};
use vox::run::{Options, run_boxes};
use vox::space::{Axis, Bounds, Cell};

const SIZES: [usize; 7] = [500, 2_000, 8_000, 32_000, 125_000, 500_000, 1_000_000];
const NAIVE_SIZES: [usize; 3] = [500, 2_000, 8_000];

fn ordered(c: &mut Criterion) {
    let mut group = c.benchmark_group("boxes/ordered");
    group.sample_size(10);
    for n in SIZES {
        let (container, boxes) = jumble::jumble(n, 1);
        group.throughput(Throughput::Elements(n as u64));
        group.bench_with_input(BenchmarkId::from_parameter(n), &boxes, |b, boxes| {
            b.iter(|| split_boxes(container, black_box(boxes), UPRIGHT_FIRST));
        });
    }
    group.finish();
}

fn naive(c: &mut Criterion) {
    let mut group = c.benchmark_group("boxes/naive");
    group.sample_size(10);
    for n in NAIVE_SIZES {
        let (container, boxes) = jumble::jumble(n, 1);
        assert_eq!(count(&naive_tree(container, &boxes), container), n);
        group.throughput(Throughput::Elements(n as u64));
        group.bench_with_input(BenchmarkId::from_parameter(n), &boxes, |b, boxes| {
            b.iter(|| naive_tree(container, black_box(boxes)));
        });
    }
    group.finish();
}

fn count(tree: &Tree, container: Bounds) -> usize {
    tree.nodes(container).filter(|(_, node)| matches!(node, Node::Leaf(_))).count()
}

/// The thesis's first method: the first plane of a box that no other box crosses, and so on in both halves.
fn naive_tree(container: Bounds, boxes: &[(Bounds, u32)]) -> Tree {
    let mut tree = TreeBuilder::new();
    let root = naive_node(container, boxes, &mut tree);
    tree.finish(root)
}

fn naive_node(cell: Bounds, boxes: &[(Bounds, u32)], tree: &mut TreeBuilder) -> NodeId {
    match boxes {
        [] => tree.nil(),
        [(bounds, label)] if *bounds == cell => tree.leaf(*label),
        _ => {
            let (axis, at) = clear_plane(cell, boxes).expect("boxes of a split tree");
            let (below, above): (Vec<_>, Vec<_>) = boxes.iter().partition(|(b, _)| axis.of(b.max) <= at);
            let [low, high] = [axis.of(cell.min), axis.of(cell.max)];
            let halves = [(low, at, below), (at, high, above)];
            let parts = halves.map(|(low, high, boxes)| Part {
                len: high - low,
                child: naive_node(cell.slab(axis, low, high), &boxes, tree),
            });
            tree.split(axis, parts)
        }
    }
}

fn clear_plane(cell: Bounds, boxes: &[(Bounds, u32)]) -> Option<(Axis, i32)> {
    let planes = boxes.iter().flat_map(|(bounds, _)| {
        Axis::ALL.into_iter().flat_map(move |axis| [(axis, axis.of(bounds.min)), (axis, axis.of(bounds.max))])
    });
    planes
        .filter(|(axis, at)| axis.of(cell.min) < *at && *at < axis.of(cell.max))
        .find(|&(axis, at)| boxes.iter().all(|(b, _)| axis.of(b.max) <= at || at <= axis.of(b.min)))
}

/// What is learnt of three and of ten cities of seed 1: the rules, and how long it takes without the proof of the command.
fn cities(c: &mut Criterion) {
    let checked =
        vox::grammar::read(include_str!("../tests/seed1/skyscraper-city.grammar")).expect("it is right");
    let city = lower(&checked, None).expect("it has a first rule");
    let example = |seed| {
        let options = Options { seed, size: Some(Cell::new(128, 128, 64)), ..Options::default() };
        let made = run_boxes(&city, &options).expect("it runs").made;
        Example::Boxes(LabelledBoxes::new(made).expect("it holds something"))
    };
    let mut group = c.benchmark_group("boxes/cities");
    group.sample_size(10);
    for count in [3, 10] {
        let examples: Vec<Example> = (0..count).map(example).collect();
        let learn = || infer(&examples, Method::Joint, Freedom::Seen).expect("it is learnt");
        println!("{count} cities: {} rules", learn().grammar().rules.len());
        group.bench_function(BenchmarkId::from_parameter(count), |b| b.iter(learn));
    }
    group.finish();
}

criterion_group!(benches, ordered, naive, cities);
criterion_main!(benches);
