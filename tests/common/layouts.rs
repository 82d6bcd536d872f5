//! Random layouts for tests and benches: rectangles that straight lines cut, as files have them, with noise.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg32;
use vox::facade::{Area, Drawing, Place};

const LABELS: [&str; 6] = ["wall1", "window1", "wall2", "window2", "door1", "pot"];
/// As much as seed 4's files carry.
const NOISE: f64 = 1e-6;

/// A layout of about so many leaves in the unit square. Rows and columns often repeat, as they do on facades.
pub fn layout(leaves: usize, seed: u64) -> Drawing {
    let mut rng = Pcg32::seed_from_u64(seed);
    let mut areas = Vec::new();
    cut([[0.0, 1.0], [0.0, 1.0]], leaves, &mut rng, &mut areas);
    for area in &mut areas {
        for end in area.sides.iter_mut().flatten() {
            *end += rng.random_range(-NOISE..NOISE);
        }
    }
    Drawing { areas }
}

type Sides = [[f64; 2]; 2];

fn cut(sides: Sides, leaves: usize, rng: &mut Pcg32, areas: &mut Vec<Area>) {
    if leaves < 2 {
        let label = LABELS[rng.random_range(0..LABELS.len())].to_owned();
        return areas.push(Area { label, sides, front: None, place: Place::Line(areas.len() + 1) });
    }
    let axis = usize::from(rng.random::<bool>());
    let parts = rng.random_range(2..=leaves.min(5));
    // Ends on a grid of twentieths: some lines are those of neighbours, most are not.
    let mut ends: Vec<u32> = (0..parts - 1).map(|_| rng.random_range(1..20)).collect();
    ends.sort_unstable();
    ends.dedup();
    let [low, high] = sides[axis];
    let at = |twentieths: u32| low + (high - low) * f64::from(twentieths) / 20.0;
    let lows = std::iter::once(0).chain(ends.iter().copied());
    let highs = ends.iter().copied().chain([20]);
    let share = leaves / (ends.len() + 1);
    let repeats = rng.random_range(0..3) == 0;
    let seed: u64 = rng.random();
    for (low, high) in lows.zip(highs) {
        let mut part = sides;
        part[axis] = [at(low), at(high)];
        match repeats {
            true => cut(part, share, &mut Pcg32::seed_from_u64(seed), areas),
            false => cut(part, share, rng, areas),
        }
    }
}

/// A plain facade of rows of windows with wall around each, so many across and up.
pub fn rows(across: usize, up: usize) -> Drawing {
    let mut areas = Vec::new();
    let mut add = |label: &str, x: [f64; 2], y: [f64; 2]| {
        let place = Place::Line(areas.len() + 1);
        areas.push(Area { label: label.to_owned(), sides: [x, y], front: None, place });
    };
    let width = (4 * across + 2) as f64;
    for row in 0..up {
        let low = (5 * row) as f64;
        add("wall", [0.0, width], [low, low + 2.0]);
        for column in 0..across {
            let left = (4 * column) as f64;
            add("wall", [left, left + 2.0], [low + 2.0, low + 5.0]);
            add("window", [left + 2.0, left + 4.0], [low + 2.0, low + 5.0]);
        }
        add("wall", [width - 2.0, width], [low + 2.0, low + 5.0]);
    }
    Drawing { areas }
}
