use super::*;
use crate::space::{Axis, Frame};
use proptest::prelude::*;
use std::collections::BTreeMap;

type Blocks = BTreeMap<[i32; 3], BlockState>;

fn built(kind: Kind, family: &str, thickness: Option<i32>, size: [i32; 3]) -> Blocks {
    let family = Family::of(family).expect("a material");
    let options = Options { thickness, ..Options::default() };
    let scope = Scope::start(Cell::from(size), Frame::default());
    let mut blocks = Blocks::new();
    build(kind, &family, &options, (&scope, None), &mut |cell, state| {
        assert!(scope.bounds.contains(cell));
        assert_eq!(blocks.insert(cell.to_array(), state.clone()), None, "{cell}");
    });
    blocks
}

/// One level, row by row from the back: `#` for a full block, `_` and `-` for lower and upper slabs, `s` for stairs.
fn level(blocks: &Blocks, size: [i32; 3], y: i32) -> Vec<String> {
    let mark = |x, z| blocks.get(&[x, y, z]).map_or('.', mark);
    (0..size[2]).map(|z| (0..size[0]).map(|x| mark(x, z)).collect()).collect()
}

fn mark(state: &BlockState) -> char {
    match (state.get("shape"), state.get("type")) {
        (Some(_), _) => 's',
        (_, Some("top")) => '-',
        (_, Some("bottom")) => '_',
        _ => '#',
    }
}

/// The front of an arch, from the top down.
fn front(size: [i32; 3], thickness: Option<i32>) -> Vec<String> {
    let blocks = built(Kind::Arch, "oak", thickness, size);
    let mark = |x, y| blocks.get(&[x, y, 0]).map_or('.', mark);
    (0..size[1]).rev().map(|y| (0..size[0]).map(|x| mark(x, y)).collect()).collect()
}

#[test]
fn arches_are_round_below() {
    assert_eq!(front([7, 5, 1], None), ["#######", "#s...s#", "#.....#", "#.....#", "#.....#"]);
    assert_eq!(front([2, 3, 1], None), ["##", "##", "##"]);
}

#[test]
fn towers_have_walls_without_gaps() {
    let blocks = built(Kind::Cylinder, "oak", Some(1), [7, 2, 7]);
    let expected = ["..###..", ".#...#.", "#.....#", "#.....#", "#.....#", ".#...#.", "..###.."];
    assert_eq!(level(&blocks, [7, 2, 7], 0), expected);
    assert_eq!(level(&blocks, [7, 2, 7], 1), expected);
}

#[test]
fn steps_go_up_to_the_right_from_the_front() {
    let blocks = built(Kind::SpiralStair, "oak", None, [3, 4, 3]);
    assert_eq!(level(&blocks, [3, 4, 3], 0), ["...", ".#.", "_-."]);
    assert_eq!(level(&blocks, [3, 4, 3], 1), ["...", ".#-", ".._"]);
}

proptest! {
    #[test]
    fn balls_are_symmetric_and_fill_their_box(size in [1..20i32, 1..20, 1..20], thickness in prop::option::of(1..3i32)) {
        let blocks = built(Kind::Sphere, "oak", thickness, size);
        for axis in Axis::ALL.map(Axis::index) {
            let (least, most) = (blocks.keys().map(|at| at[axis]).min(), blocks.keys().map(|at| at[axis]).max());
            prop_assert_eq!((least, most), (Some(0), Some(size[axis] - 1)));
            for mut at in blocks.keys().copied() {
                at[axis] = size[axis] - 1 - at[axis];
                prop_assert!(blocks.contains_key(&at));
            }
        }
    }

    #[test]
    fn shells_have_no_gaps(size in [1..16i32, 1..16, 1..16], thickness in 1..3i32, kind in 0..2) {
        let kind = [Kind::Cylinder, Kind::Sphere][kind as usize];
        let whole = built(kind, "oak", None, size);
        let shell = built(kind, "oak", Some(thickness), size);
        // What is hollow touches nothing but blocks, up and down apart in a cylinder.
        let axes = if kind == Kind::Sphere { vec![Axis::X, Axis::Y, Axis::Z] } else { vec![Axis::X, Axis::Z] };
        for at in whole.keys().filter(|at| !shell.contains_key(*at)) {
            for step in axes.iter().flat_map(|axis| [axis.unit(), -axis.unit()]) {
                prop_assert!(whole.contains_key(&(Cell::from(*at) + step).to_array()));
            }
        }
        prop_assert!(shell.keys().all(|at| whole.contains_key(at)));
    }

    #[test]
    fn spiral_stairs_can_be_walked(x in 3..10i32, z in 3..10i32, y in 1..30i32, family in 0..2) {
        let family = ["oak", "white_wool"][family as usize];
        let size = [x, y, z];
        let blocks = built(Kind::SpiralStair, family, None, size);
        // The heights of all steps in half blocks, as one climbs.
        let post = built(Kind::SpiralStair, family, None, [x, 1, z]);
        let is_post = |x: i32, z: i32| (1..y).all(|y| blocks.contains_key(&[x, y, z])) && post.contains_key(&[x, 0, z]);
        let top = |(at, state): (&[i32; 3], &BlockState)| {
            (at[1] + 1) * 2 - i32::from(state.get("type") == Some("bottom"))
        };
        let steps: Vec<([i32; 3], i32)> = blocks.iter().filter(|(at, _)| y < 3 || !is_post(at[0], at[2])).map(|step| (*step.0, top(step))).collect();
        for (at, _) in &steps {
            for above in 1..4 {
                prop_assert!(y < 3 || !blocks.contains_key(&[at[0], at[1] + above, at[2]]), "no room at {:?}", at);
            }
        }
        if y >= 3 {
            let mut reached: Vec<usize> = steps.iter().enumerate().filter(|(_, step)| step.1 <= 2).map(|(at, _)| at).collect();
            let mut next = 0;
            while let Some(&from) = reached.get(next) {
                next += 1;
                for (to, step) in steps.iter().enumerate() {
                    let [dx, dz] = [0, 2].map(|axis| (step.0[axis] - steps[from].0[axis]).abs());
                    let rise = (step.1 - steps[from].1).abs();
                    if dx + dz == 1 && rise <= 2 && !reached.contains(&to) {
                        reached.push(to);
                    }
                }
            }
            prop_assert_eq!(reached.len(), steps.len());
            prop_assert_eq!(steps.iter().map(|step| step.1).max(), Some(2 * y));
        }
    }
}
