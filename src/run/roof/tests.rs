use super::*;
use crate::space::{Frame, Turn, Up, shape_h, shape_l, shape_o, shape_t, shape_u};
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

type Blocks = BTreeMap<[i32; 3], BlockState>;

const KINDS: [Kind; 13] = [
    Kind::Gable,
    Kind::Hip,
    Kind::Gambrel,
    Kind::Mansard,
    Kind::CrossGable,
    Kind::Ridge,
    Kind::Shed,
    Kind::Pyramid,
    Kind::Cone,
    Kind::Dome,
    Kind::RightAngleTriangle,
    Kind::Corner,
    Kind::Trough,
];

const FRAME: Frame = Frame { up: Up::Y, turn: Turn::NONE };

fn scope(size: [i32; 3]) -> Scope {
    Scope::start(Cell::from(size), FRAME)
}

fn built(
    kind: Kind,
    family: &str,
    options: &Options,
    scope: &Scope,
    footprint: Option<&Footprint>,
) -> Blocks {
    let family = Family::of(family).expect("a material");
    let mut blocks = Blocks::new();
    build(kind, &family, options, (scope, footprint), &mut |cell, state| {
        let twice = blocks.insert(cell.to_array(), state.clone());
        assert_eq!(twice, None, "{kind:?} {options:?} {cell}");
    });
    blocks
}

/// The tops of a roof's columns, row by row from the front: the number of the topmost block, and then `=` for a full
/// block, `_` for a slab, `^` and its like for stairs by the way they rise, `o` and `i` for corners.
fn tops(blocks: &Blocks) -> Vec<String> {
    let spots = || blocks.keys().map(|&[x, _, z]| Spot::new(x, z));
    let around =
        spots().fold(Rect::new(Spot::ZERO, Spot::ZERO), |all, spot| all.union(&Rect::new(spot, spot + 1)));
    let mark = |state: &BlockState| match (state.get("shape"), state.get("facing"), state.get("type")) {
        (Some(shape), ..) if shape.starts_with("outer") => "o",
        (Some(shape), ..) if shape.starts_with("inner") => "i",
        (_, Some("east"), _) => ">",
        (_, Some("west"), _) => "<",
        (_, Some("north"), _) => "^",
        (_, Some("south"), _) => "v",
        (_, _, Some("top")) => "-",
        (_, _, Some(_)) => "_",
        _ => "=",
    };
    let top = |x: i32, z: i32| {
        let column = blocks.iter().filter(|(at, _)| at[0] == x && at[2] == z);
        let top = column.max_by_key(|(at, _)| at[1]);
        top.map_or(".".to_owned(), |(at, state)| format!("{}{}", at[1], mark(state)))
    };
    let row = |z| (around.min.x..around.max.x).map(|x| top(x, z)).collect::<Vec<_>>().join(" ");
    (around.min.y..around.max.y).rev().map(row).collect()
}

fn plain(kind: Kind, size: [i32; 3]) -> Vec<String> {
    tops(&built(kind, "oak", &Options::default(), &scope(size), None))
}

fn pitched(kind: Kind, pitch: f64, overhang: i32, footprint: &Footprint) -> Vec<String> {
    let options = Options { pitch: Some(pitch), overhang, ..Options::default() };
    tops(&built(kind, "oak", &options, &on(footprint), Some(footprint)))
}

/// A scope high enough for any roof on a footprint.
fn on(footprint: &Footprint) -> Scope {
    Scope { bounds: footprint.area().between(0, 200), frame: FRAME }
}

#[test]
fn a_gable_of_pitch_one_is_laid_in_stairs() {
    assert_eq!(plain(Kind::Gable, [1, 2, 4]), ["0^", "1^", "1v", "0v"]);
    assert_eq!(plain(Kind::Gable, [1, 3, 5]), ["0^", "1^", "2_", "1v", "0v"]);
}

#[test]
fn steps_of_two_blocks_are_level_at_the_back() {
    assert_eq!(plain(Kind::RightAngleTriangle, [5, 4, 1]), ["3< 2< 1= 1< 0<"]);
}

#[test]
fn a_corner_bends_on_its_diagonal() {
    assert_eq!(plain(Kind::Corner, [3, 3, 3]), ["0o 0^ 0^", "0> 1o 1^", "0> 1> 2o"]);
    assert_eq!(plain(Kind::Trough, [3, 3, 3]), ["0i 1> 2>", "1^ 1i 2>", "2^ 2^ 2i"]);
}

#[test]
fn a_corner_of_two_pitches_bends_where_its_steps_are_level() {
    assert_eq!(
        plain(Kind::Corner, [5, 4, 4]),
        ["0o 0^ 0^ 0^ 0^", "0> 1o 1^ 1^ 1^", "0> 1> 1= 2o 2^", "0> 1> 1= 2> 3o"]
    );
}

#[test]
fn the_ridge_of_a_steep_hip_is_straight() {
    assert_eq!(
        plain(Kind::Hip, [7, 3, 4]),
        ["0o 0^ 0^ 0^ 0^ 0^ 0o", "0> 2o 2^ 2^ 2^ 2o 0<", "0> 2o 2v 2v 2v 2o 0<", "0o 0v 0v 0v 0v 0v 0o"]
    );
}

#[test]
fn a_hip_of_one_pitch_goes_all_around() {
    assert_eq!(plain(Kind::Hip, [4, 2, 4]), ["0o 0^ 0^ 0o", "0> 1o 1o 0<", "0> 1o 1o 0<", "0o 0v 0v 0o"]);
    assert_eq!(plain(Kind::Hip, [4, 2, 3]), ["0o 0^ 0^ 0o", "0> 1_ 1_ 0<", "0o 0v 0v 0o"]);
}

#[test]
fn slopes_of_half_a_block_are_laid_in_slabs() {
    assert_eq!(plain(Kind::Shed, [1, 2, 4]), ["0_", "0=", "1_", "1="]);
}

#[test]
fn a_gambrel_is_steep_and_then_flat() {
    let options = Options { pitch: Some(1.0), ..Options::default() };
    let gambrel = built(Kind::Gambrel, "oak", &options, &scope([1, 20, 9]), None);
    assert_eq!(tops(&gambrel), ["0^", "2=", "3_", "3=", "4_", "3=", "3_", "2=", "0v"]);
}

#[test]
fn wings_have_gables_and_meet_in_a_valley() {
    let area = Rect::new(Spot::ZERO, Spot::new(7, 6));
    assert_eq!(
        pitched(Kind::Gable, 1.0, 0, &shape_l(area, FRAME, 3, 3)),
        [
            "0o 0^ 0^ 0^ 0^ 0^ 0^",
            "0> 1_ 1_ 1_ 1_ 1_ 1_",
            "0> 1_ 0i 0v 0v 0v 0v",
            "0> 1_ 0< . . . .",
            "0> 1_ 0< . . . .",
            "0> 1_ 0< . . . ."
        ]
    );
    assert_eq!(
        pitched(Kind::Gable, 1.0, 0, &shape_t(area, FRAME, 3, 3)),
        [
            "0^ 0^ 0^ 0^ 0^ 0^ 0^",
            "1_ 1_ 1_ 1_ 1_ 1_ 1_",
            "0v 0v 0i 1_ 0i 0v 0v",
            ". . 0> 1_ 0< . .",
            ". . 0> 1_ 0< . .",
            ". . 0> 1_ 0< . ."
        ]
    );
}

#[test]
fn eaves_go_on_down_and_verges_go_on_level() {
    let hut = Footprint::full(Rect::new(Spot::ZERO, Spot::new(2, 2)));
    assert_eq!(
        pitched(Kind::Gable, 1.0, 1, &hut),
        ["-1^ -1^ -1^ -1^", "0^ 0^ 0^ 0^", "0v 0v 0v 0v", "-1v -1v -1v -1v"]
    );
    assert_eq!(
        pitched(Kind::Hip, 0.5, 1, &hut),
        ["-1- -1- -1- -1-", "-1- 0_ 0_ -1-", "-1- 0_ 0_ -1-", "-1- -1- -1- -1-"]
    );
}

#[test]
fn a_height_cuts_a_roof_of_given_pitch() {
    let options = Options { pitch: Some(1.0), ..Options::default() };
    let cut = built(Kind::Gable, "oak", &options, &scope([1, 2, 7]), None);
    assert_eq!(tops(&cut), ["0^", "1^", "1=", "1=", "1=", "1v", "0v"]);
}

#[test]
fn thin_roofs_have_walls_under_their_gables() {
    let wall: BlockState = "bricks".parse().unwrap();
    let options =
        Options { pitch: Some(1.0), thickness: Some(1), wall: Some(wall.clone()), ..Options::default() };
    let blocks = built(Kind::Gable, "oak", &options, &scope([4, 3, 5]), None);
    let walls: Vec<[i32; 3]> =
        blocks.iter().filter(|(_, state)| **state == wall).map(|(at, _)| *at).collect();
    let gable = |x| [[x, 0, 1], [x, 0, 2], [x, 0, 3], [x, 1, 2]];
    assert_eq!(walls, [gable(0), gable(3)].concat());
    assert!(!blocks.contains_key(&[1, 0, 2]));
}

#[test]
fn a_bay_has_a_gable_and_a_long_side_has_none() {
    // The bay in front is as wide as it is deep; the bar behind it is a rectangle's long side at its back.
    let area = Rect::new(Spot::ZERO, Spot::new(9, 7));
    let bay = shape_t(area, FRAME.turned(Turn::quarters(2)), 3, 4);
    let ends = ends::gable_ends(&bay, &View::of(area, FRAME));
    let told: Vec<_> = ends.iter().map(|end| (end.outward().to_array(), end.len())).collect();
    assert_eq!(told, [([0, 1], 4), ([1, 0], 3), ([-1, 0], 3)]);
}

fn footprints() -> impl Strategy<Value = Footprint> {
    let sizes = (3..=40i32, 3..=40i32);
    (sizes, 0..7u8, [3..14i32, 3..14, 3..14, 3..14], 0..4).prop_map(|((x, z), letter, widths, turn)| {
        let area = Rect::new(Spot::new(-5, 7), Spot::new(x - 5, z + 7));
        let [a, b, c, d] = widths;
        let frame = FRAME.turned(Turn::quarters(turn));
        match letter {
            0 => Footprint::full(area),
            1 => shape_l(area, frame, a, b),
            2 => shape_u(area, frame, a, b, c),
            3 => shape_t(area, frame, a, b),
            4 => shape_h(area, frame, a, b, c),
            5 => shape_o(area, frame, [a, b, c, d]),
            _ => Footprint::round(area),
        }
    })
}

fn options() -> impl Strategy<Value = Options> {
    let pitches = prop_oneof![Just(None), Just(Some(0.5)), Just(Some(1.0)), Just(Some(2.0))];
    let thicknesses = prop_oneof![Just(None), Just(Some(1)), Just(Some(2))];
    (pitches, thicknesses, 0..=2i32).prop_map(|(pitch, thickness, overhang)| Options {
        pitch,
        overhang,
        thickness,
        wall: None,
    })
}

fn families() -> impl Strategy<Value = &'static str> {
    prop_oneof![Just("oak"), Just("stone_bricks"), Just("white_wool")]
}

/// The cells of a box around some blocks that air from outside gets to. The ground below them is shut.
fn aired(blocks: &Blocks, area: Rect) -> BTreeSet<[i32; 3]> {
    let high = blocks.keys().map(|at| at[1]).max().unwrap_or(0) + 2;
    let bounds = area.grown(1).between(0, high);
    let mut aired = BTreeSet::new();
    let mut open = vec![bounds.max - 1];
    while let Some(cell) = open.pop() {
        if bounds.contains(cell) && !blocks.contains_key(&cell.to_array()) && aired.insert(cell.to_array()) {
            open.extend(Cell::AXES.into_iter().flat_map(|step| [cell + step, cell - step]));
        }
    }
    aired
}

/// The blocks that hold on to the ground of a footprint, over sides, edges or corners.
fn held(blocks: &Blocks, footprint: &Footprint) -> usize {
    let mut held: BTreeSet<[i32; 3]> = BTreeSet::new();
    let mut open: Vec<Cell> = footprint.spots().map(|spot| Cell::new(spot.x, 0, spot.y)).collect();
    open.retain(|cell| blocks.contains_key(&cell.to_array()));
    let around = crate::space::Bounds::new(Cell::splat(-1), Cell::splat(2));
    while let Some(cell) = open.pop() {
        if blocks.contains_key(&cell.to_array()) && held.insert(cell.to_array()) {
            open.extend(around.cells().map(|step| cell + step));
        }
    }
    held.len()
}

/// Whether a roof has no hole, nothing that hangs in the air and no wind below it.
fn is_sound(
    kind: Kind,
    family: &str,
    options: &Options,
    footprint: &Footprint,
    height: i32,
) -> Result<(), TestCaseError> {
    let scope = Scope { bounds: footprint.area().between(0, height), frame: FRAME };
    let blocks = built(kind, family, options, &scope, Some(footprint));
    let mut highest: BTreeMap<[i32; 2], i32> = BTreeMap::new();
    for at in blocks.keys() {
        let high = highest.entry([at[0], at[2]]).or_insert(at[1]);
        *high = at[1].max(*high);
    }
    // Rain falls through nowhere, and every eave is covered.
    let reach = Site::of(kind, &scope, Some(footprint), options).reach;
    for spot in reach.spots() {
        let top = highest.get(&[spot.x, spot.y]).copied();
        prop_assert!(top.is_some(), "a hole at {}", spot);
        prop_assert!(
            !footprint.contains(spot) || (0..height).contains(&top.unwrap()),
            "{:?} at {}",
            top,
            spot
        );
    }
    prop_assert_eq!(highest.len(), reach.len());
    // Nothing hangs in the air.
    prop_assert_eq!(held(&blocks, footprint), blocks.len());
    // No wind gets below the roof.
    let aired = aired(&blocks, footprint.area());
    for spot in footprint.spots() {
        let top = highest[&[spot.x, spot.y]];
        for level in 0..top {
            prop_assert!(!aired.contains(&[spot.x, level, spot.y]), "wind at {} {}", spot, level);
            let is_filled = blocks.contains_key(&[spot.x, level, spot.y]);
            prop_assert!(is_filled || options.thickness.is_some());
        }
    }
    Ok(())
}

/// Every size from 3x3 to 40x40: each under one kind, pitch and thickness after another, or with `VOX_ROOFS=all` under
/// all of them, which takes minutes.
#[test]
fn roofs_of_every_size_are_sound() {
    let all = std::env::var_os("VOX_ROOFS").is_some();
    let pitches = [None, Some(0.5), Some(1.0), Some(2.0)];
    let cases = || {
        KINDS.into_iter().flat_map(move |kind| {
            pitches
                .into_iter()
                .flat_map(move |pitch| [None, Some(1)].map(|thickness| (kind, pitch, thickness)))
        })
    };
    let sizes = (3..=40).flat_map(|x| (3..=40).map(move |z| (x, z)));
    for (number, (x, z)) in sizes.enumerate() {
        let footprint = Footprint::full(Rect::new(Spot::ZERO, Spot::new(x, z)));
        let chosen = cases().enumerate().filter(|(at, _)| all || *at == number % cases().count());
        for (_, (kind, pitch, thickness)) in chosen {
            let options = Options { pitch, thickness, overhang: 1, wall: None };
            let height = if pitch.is_some() { 100 } else { 1 + x.min(z) / 2 };
            is_sound(kind, "oak", &options, &footprint, height)
                .unwrap_or_else(|error| panic!("{kind:?} over {x} x {z}, {options:?}: {error}"));
        }
    }
}

proptest! {
    #[test]
    fn roofs_are_sound(
        kind in prop::sample::select(KINDS.to_vec()),
        footprint in footprints(),
        options in options(),
        family in families(),
        height in 1..20i32,
    ) {
        is_sound(kind, family, &options, &footprint, if options.pitch.is_some() { 100 } else { height })?;
    }

    #[test]
    fn roofs_are_as_symmetric_as_their_footprints(
        kind in prop::sample::select(KINDS[..10].to_vec()),
        footprint in footprints(),
        options in options(),
        height in 1..20i32,
    ) {
        let scope = Scope { bounds: footprint.area().between(0, height), frame: FRAME };
        let blocks = built(kind, "oak", &options, &scope, Some(&footprint));
        let area = footprint.area();
        for axis in [0, 1] {
            let flip = |spot: Spot| {
                let mut flipped = spot;
                flipped[axis] = area.min[axis] + area.max[axis] - 1 - spot[axis];
                flipped
            };
            if footprint.spots().all(|spot| footprint.contains(flip(spot))) && (kind, axis) != (Kind::Shed, 1) {
                for [x, y, z] in blocks.keys() {
                    let [x, z] = flip(Spot::new(*x, *z)).to_array();
                    prop_assert!(blocks.contains_key(&[x, *y, z]), "{} {} {}", x, y, z);
                }
            }
        }
    }

    #[test]
    fn roofs_turn_with_their_frame(
        kind in prop::sample::select(KINDS.to_vec()),
        size in [1..12i32, 1..12, 1..12],
        options in options(),
    ) {
        let turn = Turn::quarters(1);
        let plain = built(kind, "oak", &options, &scope(size), None);
        let turned = built(kind, "oak", &options, &Scope::start(Cell::from(size), FRAME.turned(turn)), None);
        prop_assert_eq!(plain.len(), turned.len());
        // What ran east runs north.
        for (at, state) in &plain {
            let [x, y, z] = turn.apply(Cell::from(*at)).to_array();
            let there = turned.get(&[x, y, z + size[0] - 1]);
            // Where slopes meet, either may end up with the bend.
            let is_bent = |state: &BlockState| state.get("shape").is_some_and(|shape| shape != "straight");
            let meets = is_bent(state) || there.is_some_and(is_bent);
            prop_assert!(there == Some(&state.turned(turn)) || meets, "{:?} {:?}", there, state);
        }
    }
}
