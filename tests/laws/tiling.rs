//! Splits, repeats and rhythms fill their scope: no gap, no overlap, no drift.

use super::{SHORT, blocks, boxes, graph_of, options};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;
use vox::grammar::ast::*;
use vox::grid::{Grid, LabelledBox};
use vox::run::{Options, Overrun};
use vox::space::{Axis, Bounds, Cell};

const BLOCKS: [&str; 4] = ["stone", "dirt", "glass", "oak_planks"];

proptest! {
    #[test]
    fn parts_tile_the_scope(grammar in tilings(), size in sizes(), seed in 0..9u64) {
        let graph = graph_of(grammar);
        let clipping = Options { overrun: Overrun::Clip, limits: SHORT, ..options(size, seed) };
        let clipped = boxes(&graph, &clipping);
        prop_assert!(clipped.is_ok(), "{}", clipped.unwrap_err());
        assert_tiles(&clipped.unwrap(), Cell::from(size))?;
        if let Ok(boxes) = boxes(&graph, &options(size, seed)) {
            assert_tiles(&boxes, Cell::from(size))?;
        }
    }

    #[test]
    fn boxes_and_blocks_agree(grammar in tilings(), size in sizes(), seed in 0..9u64) {
        let graph = graph_of(grammar);
        let options = Options { overrun: Overrun::Clip, ..options(size, seed) };
        let grid = blocks(&graph, &options).unwrap();
        for labelled in boxes(&graph, &options).unwrap() {
            for cell in labelled.bounds.cells() {
                prop_assert_eq!(grid.get(cell).short_name(), &labelled.label);
            }
        }
    }

    #[test]
    fn symmetric_rules_make_symmetric_buildings(body in symmetric(), size in sizes()) {
        let graph = graph_of(one_rule(body));
        if let Ok(grid) = blocks(&graph, &options(size, 0)) {
            prop_assert!(is_mirrored(&grid), "{}", vox::graph::raise(&graph));
        }
    }
}

fn sizes() -> impl Strategy<Value = [i32; 3]> {
    [1..14i32, 1..9, 1..14]
}

fn assert_tiles(boxes: &[LabelledBox], size: Cell) -> Result<(), TestCaseError> {
    let mut covered = Grid::new(size);
    for labelled in boxes {
        prop_assert!(Bounds::of_size(size).contains_box(&labelled.bounds), "{:?} lies outside", labelled);
        for cell in labelled.bounds.cells() {
            prop_assert_eq!(covered.id(cell), 0, "two boxes hold {}", cell);
            covered.set(cell, 1);
        }
    }
    let gap = covered.bounds().cells().find(|cell| covered.id(*cell) == 0);
    prop_assert_eq!(gap, None, "no box holds this cell");
    Ok(())
}

fn is_mirrored(grid: &Grid) -> bool {
    let last = grid.size().x - 1;
    grid.bounds().cells().all(|cell| grid.id(cell) == grid.id(Cell { x: last - cell.x, ..cell }))
}

fn one_rule(successor: Successor) -> Grammar {
    Grammar { rules: vec![rule("start", successor)], ..Grammar::default() }
}

fn rule(label: &str, successor: Successor) -> Rule {
    Rule {
        comments: Vec::new(),
        behind: None,
        label: Ident::new(label),
        params: Vec::new(),
        condition: None,
        successor,
        weight: None,
        priority: Rule::FIRST,
    }
}

/// Grammars that leave no cell out: every split has a floating part, every leaf is a block, and the choices
/// of `any` are made at random.
pub fn tilings() -> impl Strategy<Value = Grammar> {
    (tiling(), tiling(), tiling()).prop_map(|(start, one, two)| {
        // The choices lie below the start, so that they never lead back to it.
        let rules = vec![rule("start", start), rule("any", closed(one)), rule("any", closed(two))];
        Grammar { rules, ..Grammar::default() }
    })
}

/// An operation whose calls are replaced by a block, so that it ends.
fn closed(successor: Successor) -> Successor {
    let close = |body: Box<Successor>| Box::new(closed(*body));
    Successor::new(match successor.op {
        Op::Call { .. } => return block("glass"),
        Op::Split { axis, snap, items } => {
            Op::Split { axis, snap, items: items.into_iter().map(closed_item).collect() }
        }
        Op::Repeat { axis, size, snap, body } => Op::Repeat { axis, size, snap, body: close(body) },
        Op::RepeatN { axis, count, body } => Op::RepeatN { axis, count, body: close(body) },
        op => op,
    })
}

fn closed_item(item: Item) -> Item {
    match item {
        Item::Part { size, body } => Item::Part { size, body: closed(body) },
        Item::Group { items, span } => {
            Item::Group { items: items.into_iter().map(closed_item).collect(), span }
        }
    }
}

fn tiling() -> impl Strategy<Value = Successor> {
    let any = Successor::new(Op::Call { label: Ident::new("any"), args: Vec::new() });
    let leaf = prop_oneof![3 => select(&BLOCKS[..]).prop_map(block), 1 => Just(any)];
    leaf.prop_recursive(4, 20, 4, |inner| {
        let body = || inner.clone().prop_map(Box::new);
        prop_oneof![
            3 => split(inner.clone()),
            1 => (axis(), length(), body()).prop_map(|(axis, size, body)| Op::Repeat { axis, size, snap: None, body }),
            1 => (axis(), 1..7u32, body())
                .prop_map(|(axis, count, body)| Op::RepeatN { axis, count: Expr::number(count.into()), body }),
        ]
        .prop_map(Successor::new)
    })
}

/// A split of parts and rhythms, with a floating part among them.
fn split(body: impl Strategy<Value = Successor> + Clone + 'static) -> impl Strategy<Value = Op> {
    let part = (kind(), length(), body.clone())
        .prop_map(|(kind, value, body)| Item::Part { size: Size { kind, value }, body });
    let item = part.prop_recursive(2, 5, 3, |inner| {
        vec(inner, 1..3).prop_map(|items| Item::Group { items, span: Default::default() })
    });
    (axis(), vec(item, 0..4), 0..4usize, body).prop_map(|(axis, mut items, at, body)| {
        items.insert(at.min(items.len()), floating(body));
        Op::Split { axis, snap: None, items }
    })
}

/// An operation that is its own mirror image along x: parts in pairs around a floating middle.
fn symmetric() -> impl Strategy<Value = Successor> {
    select(&BLOCKS[..]).prop_map(block).prop_recursive(3, 12, 3, |inner| {
        let part = (kind(), length(), inner.clone())
            .prop_map(|(kind, value, body)| Item::Part { size: Size { kind, value }, body });
        let halves = (vec(part, 0..3), inner.clone()).prop_map(|(half, middle)| {
            let items = half.iter().cloned().chain([floating(middle)]).chain(half.iter().rev().cloned());
            Op::Split { axis: Expr::name("x"), snap: None, items: items.collect() }
        });
        let upright = vec(inner.clone().prop_map(floating), 1..4).prop_map(|items| Op::Split {
            axis: Expr::name("y"),
            snap: None,
            items,
        });
        let odd = (0..3u32, inner.prop_map(Box::new)).prop_map(|(half, body)| Op::RepeatN {
            axis: Expr::name("x"),
            count: Expr::number(f64::from(2 * half + 1)),
            body,
        });
        prop_oneof![halves, upright, odd].prop_map(Successor::new)
    })
}

fn block(name: &str) -> Successor {
    Successor::new(Op::Primitive { name: Expr::name(name), material: None, options: Vec::new() })
}

fn floating(body: Successor) -> Item {
    Item::Part { size: Size { kind: SizeKind::Floating, value: Expr::number(1.0) }, body }
}

fn axis() -> impl Strategy<Value = Expr> {
    select(&Axis::ALL[..]).prop_map(|axis| Expr::name(axis.to_string()))
}

fn kind() -> impl Strategy<Value = SizeKind> {
    select(vec![SizeKind::Absolute, SizeKind::Floating])
}

fn length() -> impl Strategy<Value = Expr> {
    prop_oneof![3 => (1..4u32).prop_map(f64::from), 1 => 0.3..4.0f64].prop_map(Expr::number)
}
