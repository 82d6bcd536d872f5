//! Laws of box splitting.

#[path = "common/jumble.rs"]
mod jumble;

use proptest::prelude::*;
use vox::infer::{BadBoxes, Node, Tree, UPRIGHT_FIRST, split_boxes};
use vox::space::{Axis, Bounds, Cell};

type Labelled = (Bounds, u32);

fn boxed(min: [i32; 3], max: [i32; 3]) -> Bounds {
    Bounds::new(Cell::from(min), Cell::from(max))
}

/// Boxes that do not overlap: those of random ones that hit none before.
fn scattered() -> impl Strategy<Value = (Bounds, Vec<Labelled>)> {
    let random_box = (prop::array::uniform3(0..9i32), prop::array::uniform3(1..5i32))
        .prop_map(|(min, size)| Bounds::new(Cell::from(min), Cell::from(min) + Cell::from(size)));
    prop::collection::vec((random_box, 0..4u32), 0..60).prop_map(|all| {
        let mut kept: Vec<Labelled> = Vec::new();
        for (bounds, label) in all {
            if kept.iter().all(|(other, _)| other.intersect(&bounds).is_empty()) {
                kept.push((bounds, label));
            }
        }
        (boxed([-1, 0, 0], [13, 14, 13]), kept)
    })
}

/// Which box each leaf is a piece of: the leaf's box must be inside.
fn owner(boxes: &[Labelled], (leaf, label): Labelled) -> Option<usize> {
    boxes.iter().position(|(bounds, l)| *l == label && bounds.contains_box(&leaf))
}

fn assert_tiles(tree: &Tree, container: Bounds, boxes: &[Labelled]) {
    let mut filled = vec![0; boxes.len()];
    for leaf in tree.leaves(container) {
        let owner = owner(boxes, leaf).unwrap_or_else(|| panic!("{leaf:?} is in no box"));
        filled[owner] += leaf.0.volume();
    }
    let volumes: Vec<u64> = boxes.iter().map(|(bounds, _)| bounds.volume()).collect();
    assert_eq!(filled, volumes);
}

fn assert_normal(tree: &Tree, container: Bounds) {
    for (bounds, node) in tree.nodes(container) {
        let Node::Split { axis, parts } = node else { continue };
        assert!(parts.len() > 1 && parts.iter().all(|part| part.len > 0));
        assert_eq!(parts.iter().map(|part| part.len).sum::<i32>(), bounds.len(axis));
        for part in parts {
            assert!(!matches!(tree.node(part.child), Node::Split { axis: inner, .. } if inner == axis));
        }
        let nil = |i: usize| tree.node(parts[i].child) == Node::Nil;
        assert!((1..parts.len()).all(|i| !(nil(i - 1) && nil(i))));
    }
}

fn sorted(mut boxes: Vec<Labelled>) -> Vec<Labelled> {
    boxes.sort_by_key(|(bounds, _)| (bounds.min.to_array(), bounds.max.to_array()));
    boxes
}

proptest! {
    #[test]
    fn the_leaves_tile_the_boxes((container, boxes) in scattered()) {
        let tree = split_boxes(container, &boxes, UPRIGHT_FIRST).unwrap();
        assert_tiles(&tree, container, &boxes);
        assert_normal(&tree, container);
    }

    #[test]
    fn boxes_of_a_split_tree_are_never_cut(n in 1..400usize, seed: u64) {
        let (container, boxes) = jumble::jumble(n, seed);
        let tree = split_boxes(container, &boxes, UPRIGHT_FIRST).unwrap();
        assert_normal(&tree, container);
        prop_assert_eq!(sorted(tree.leaves(container).collect()), sorted(boxes));
    }

    #[test]
    fn the_order_of_the_boxes_does_not_matter(
        ((container, boxes), shuffled) in
            scattered().prop_flat_map(|(c, boxes)| (Just((c, boxes.clone())), Just(boxes).prop_shuffle()))
    ) {
        prop_assert_eq!(split_boxes(container, &boxes, UPRIGHT_FIRST), split_boxes(container, &shuffled, UPRIGHT_FIRST));
    }

    #[test]
    fn the_first_cut_goes_through_the_fewest_boxes((_, boxes) in scattered()) {
        prop_assume!(boxes.len() > 1);
        let container = boxes.iter().map(|(bounds, _)| *bounds).reduce(|a, b| a.union(&b)).unwrap();
        let tree = split_boxes(container, &boxes, UPRIGHT_FIRST).unwrap();
        let (axis, at) = cuts(&tree, container);
        let least = at.into_iter().map(|at| crossing(&boxes, axis, at)).min();
        prop_assert_eq!(least, fewest_crossing(container, &boxes));
    }

    #[test]
    fn overlap_is_an_error_naming_the_pair(
        (container, mut boxes) in scattered().prop_filter("a box", |(_, boxes)| !boxes.is_empty()),
        which: prop::sample::Index,
        size in prop::array::uniform3(1..6i32),
    ) {
        let mut extra = boxes[which.index(boxes.len())].0;
        extra.max = (extra.min + Cell::from(size)).min(container.max);
        boxes.push((extra, 9));
        let error = split_boxes(container, &boxes, UPRIGHT_FIRST).unwrap_err();
        let BadBoxes::Overlap(a, b) = error else { panic!("{error}") };
        prop_assert!(a < b && !boxes[a].0.intersect(&boxes[b].0).is_empty());
    }
}

#[test]
fn empty_space_is_one_nil() {
    let tree = split_boxes(boxed([0; 3], [4; 3]), &[], UPRIGHT_FIRST).unwrap();
    assert_eq!(tree.node(tree.root()), Node::Nil);
}

#[test]
fn one_box_in_a_corner_is_trimmed_once_per_axis() {
    let container = boxed([0; 3], [4; 3]);
    let boxes = [(boxed([0; 3], [1; 3]), 7)];
    let tree = split_boxes(container, &boxes, UPRIGHT_FIRST).unwrap();
    let splits = tree.nodes(container).filter(|(_, node)| matches!(node, Node::Split { .. })).count();
    assert_eq!(splits, 3);
    assert_eq!(tree.leaves(container).collect::<Vec<_>>(), boxes);
}

/// Four bars around a post: no plane is clear, and one cut is enough.
#[test]
fn a_pinwheel_costs_one_cut() {
    let bars = [
        boxed([0, 0, 0], [2, 1, 1]),
        boxed([2, 0, 0], [3, 1, 2]),
        boxed([1, 0, 2], [3, 1, 3]),
        boxed([0, 0, 1], [1, 1, 3]),
        boxed([1, 0, 1], [2, 1, 2]),
    ];
    let boxes: Vec<Labelled> = bars.into_iter().zip(0..).collect();
    let container = boxed([0; 3], [3, 1, 3]);
    let tree = split_boxes(container, &boxes, UPRIGHT_FIRST).unwrap();
    assert_tiles(&tree, container, &boxes);
    assert_eq!(tree.leaves(container).count(), 6);
    // All four planes are as good: x goes before z, and the low end first.
    assert_eq!(cuts(&tree, container), (Axis::X, vec![1]));
}

/// Where the root of a tree splits its container.
fn cuts(tree: &Tree, container: Bounds) -> (Axis, Vec<i32>) {
    let Node::Split { axis, parts } = tree.node(tree.root()) else { panic!("the root is no split") };
    let mut ends: Vec<i32> = parts
        .iter()
        .scan(axis.of(container.min), |end, part| {
            *end += part.len;
            Some(*end)
        })
        .collect();
    ends.pop();
    (axis, ends)
}

fn crossing(boxes: &[Labelled], axis: Axis, at: i32) -> usize {
    boxes.iter().filter(|(b, _)| axis.of(b.min) < at && at < axis.of(b.max)).count()
}

/// The fewest boxes that any plane inside the container cuts, of those at a face of a box.
fn fewest_crossing(container: Bounds, boxes: &[Labelled]) -> Option<usize> {
    let faces = |axis: Axis| boxes.iter().flat_map(move |(b, _)| [axis.of(b.min), axis.of(b.max)]);
    let inside = |axis: Axis, at: &i32| axis.of(container.min) < *at && *at < axis.of(container.max);
    let counts =
        |axis| faces(axis).filter(move |at| inside(axis, at)).map(move |at| crossing(boxes, axis, at));
    Axis::ALL.into_iter().flat_map(counts).min()
}

#[test]
fn boxes_must_have_cells_inside_the_container() {
    let container = boxed([0; 3], [4; 3]);
    let good = (boxed([0; 3], [1; 3]), 0);
    let split = |bounds| split_boxes(container, &[good, (bounds, 0)], UPRIGHT_FIRST).unwrap_err();
    assert_eq!(split(boxed([1, 1, 1], [2, 1, 2])), BadBoxes::Empty(1));
    assert_eq!(split(boxed([1, 1, 1], [2, 5, 2])), BadBoxes::Outside(1));
    assert_eq!(
        split_boxes(boxed([i32::MIN; 3], [i32::MAX; 3]), &[good], UPRIGHT_FIRST),
        Err(BadBoxes::Container)
    );
}
