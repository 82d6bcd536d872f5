//! Random split trees, for tests and benches: boxes that can be told apart by clean cuts alone.

use rand::seq::SliceRandom;
use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg32;
use vox::space::{Axis, Bounds, Cell};

const BRANCHING: usize = 5;
const DEPTH: u32 = 6;

enum Plan {
    Leaf(Cell),
    Split(Axis, Vec<Plan>),
}

/// `n` labelled boxes, at least 1, in no order, and a container around them, from a random split tree of up to five
/// parts a split and depth 6, or as deep as so many boxes need. Some boxes fill their place in the tree,
/// others leave space beside them.
pub fn jumble(n: usize, seed: u64) -> (Bounds, Vec<(Bounds, u32)>) {
    let mut rng = Pcg32::seed_from_u64(seed);
    let depth = DEPTH.max(n.ilog(BRANCHING) + 2);
    let plan = plan(n, depth, None, &mut rng);
    let container = Bounds::of_size(size(&plan));
    let mut boxes = Vec::with_capacity(n);
    lay_out(&plan, container, &mut rng, &mut boxes);
    boxes.shuffle(&mut rng);
    (container, boxes)
}

fn plan(n: usize, depth: u32, above: Option<Axis>, rng: &mut impl Rng) -> Plan {
    if n == 1 {
        return Plan::Leaf(Cell::from_array([(); 3].map(|()| rng.random_range(1..10))));
    }
    let axes: Vec<Axis> = Axis::ALL.into_iter().filter(|&axis| Some(axis) != above).collect();
    let axis = axes[rng.random_range(0..axes.len())];
    let counts = shares(n, BRANCHING.pow(depth - 1), rng);
    Plan::Split(axis, counts.into_iter().map(|n| plan(n, depth - 1, Some(axis), rng)).collect())
}

/// Deals `n` boxes to two to five parts, to none more than `most`.
fn shares(n: usize, most: usize, rng: &mut impl Rng) -> Vec<usize> {
    let parts = rng.random_range(n.div_ceil(most).max(2)..=BRANCHING.min(n));
    let mut left = n;
    (1..=parts)
        .rev()
        .map(|parts_left| {
            let rest = parts_left - 1;
            let low = left.saturating_sub(rest * most).max(1);
            let high = most.min(left - rest).min((2 * left / parts_left).max(low));
            let share = if rest == 0 { left } else { rng.random_range(low..=high) };
            left -= share;
            share
        })
        .collect()
}

fn size(plan: &Plan) -> Cell {
    match plan {
        Plan::Leaf(size) => *size,
        Plan::Split(axis, parts) => {
            let sizes = || parts.iter().map(size);
            let mut total = sizes().fold(Cell::ONE, Cell::max);
            total[axis.index()] = sizes().map(|size| axis.of(size)).sum();
            total
        }
    }
}

fn lay_out(plan: &Plan, cell: Bounds, rng: &mut impl Rng, boxes: &mut Vec<(Bounds, u32)>) {
    match plan {
        Plan::Leaf(size) => {
            let size = if rng.random() { *size } else { cell.size() };
            let bounds = Bounds::new(cell.min, cell.min + size);
            boxes.push((bounds, rng.random_range(0..8)));
        }
        Plan::Split(axis, parts) => {
            let mut low = axis.of(cell.min);
            for part in parts {
                let high = low + axis.of(size(part));
                lay_out(part, cell.slab(*axis, low, high), rng, boxes);
                low = high;
            }
        }
    }
}
