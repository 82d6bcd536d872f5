//! Searches that go beyond the first set that no step makes cheaper (seed 3, "SIGI and Related Work": the search can get
//! stuck in bad local optima).

use super::piece::Piece;
use super::set::{Goal, Reach, Set, Splits, Step};
use super::{Task, climb, climb_to_end, climbed, finished, goal, in_order};
use crate::shapes::building::Block;
use crate::shapes::cost::cost;
use crate::shapes::layer::Layer;
use crate::shapes::settings::Operation;
use rand::seq::{IndexedRandom, SliceRandom};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::num::NonZeroU32;

/// Climbs from the blocks in their order and in random orders, and keeps the cheapest set.
pub fn restarts(task: Task<'_>, times: NonZeroU32) -> Vec<Piece> {
    let mut random = Pcg64Mcg::seed_from_u64(task.settings.seed);
    let mut order = in_order(task.building);
    let mut best = Best::new(task, climb_to_end(task, &order));
    for _ in 0..times.get() {
        order.shuffle(&mut random);
        best.offer(climb_to_end(task, &order));
    }
    best.pieces
}

/// So many of the pieces are broken into blocks at a time: one in ten, but at least two.
const BROKEN: usize = 10;

/// Breaks pieces of the best set into blocks, climbs again, and goes on from there if what is kept is no dearer.
pub fn backtracking(task: Task<'_>, times: NonZeroU32) -> Vec<Piece> {
    let mut random = Pcg64Mcg::seed_from_u64(task.settings.seed);
    let mut whole = climb(task, &in_order(task.building));
    let mut best = Best::new(task, finished(task, whole.clone()));
    for _ in 0..times.get() {
        let set = Set::of(task.building, broken(&whole, &mut random), goal(task.settings), Splits::Wanted);
        let again = climbed(set, Operation::Both, Reach::NotDearer).into_pieces();
        if best.offer(finished(task, again.clone())) {
            whole = again;
        }
    }
    best.pieces
}

fn broken(pieces: &[Piece], random: &mut Pcg64Mcg) -> impl Iterator<Item = (Layer, Vec<Block>)> + use<> {
    let count = (pieces.len() / BROKEN).max(2);
    let mut shapes = Vec::new();
    let drawn: Vec<usize> =
        rand::seq::index::sample(random, pieces.len(), count.min(pieces.len())).into_vec();
    for (index, piece) in pieces.iter().enumerate() {
        match drawn.contains(&index) {
            true => shapes.extend(piece.blocks.iter().map(|block| (piece.layer, vec![*block]))),
            false => shapes.push((piece.layer, piece.blocks.clone())),
        }
    }
    // Blocks of one layer meet in another order than the first time.
    shapes.shuffle(random);
    shapes.into_iter()
}

/// The temperature of the first step, as a share of what one more shape costs; the last step's is a hundredth of that.
const HOTTEST: f64 = 2.0;

/// Takes random steps, dearer ones with a probability that falls with what they cost and with time; then climbs.
pub fn annealing(task: Task<'_>, steps: NonZeroU32) -> Vec<Piece> {
    let mut random = Pcg64Mcg::seed_from_u64(task.settings.seed);
    let first = climb(task, &in_order(task.building));
    let mut best = Best::new(task, finished(task, first.clone()));
    let shapes = first.into_iter().map(|piece| (piece.layer, piece.blocks));
    let mut set = Set::of(task.building, shapes, goal(task.settings), Splits::Wanted);
    let Goal::Cheapest(price) = goal(task.settings) else { return best.pieces };
    let total = task.building.len() as u64 * u64::from(steps.get());
    for step in 0..total {
        let cold = step as f64 / total as f64;
        let heat = HOTTEST * price.per_shape() * libm::pow(0.01, cold);
        if let Some(step) = random_step(&set, &mut random) {
            let rise = set.rise_by(step);
            if rise <= 0.0 || random.random::<f64>() < libm::exp(-rise / heat) {
                set.take(step);
            }
        }
    }
    best.offer(finished(task, climbed(set, Operation::Both, Reach::NotDearer).into_pieces()));
    best.pieces
}

/// A merge or a split of a piece that is drawn; none if that piece has none.
fn random_step(set: &Set<'_>, random: &mut Pcg64Mcg) -> Option<Step> {
    let id = *set.alive().choose(random)?;
    if random.random_bool(0.5) {
        let partners: Vec<_> = set.partners(id).collect();
        partners.choose(random).map(|other| Step::Merge(id.min(*other), id.max(*other)))
    } else {
        let cuts = set.legal_cuts(id);
        cuts.choose(random).map(|cut| Step::Split(id, *cut))
    }
}

/// The cheapest set so far.
struct Best<'a> {
    task: Task<'a>,
    pieces: Vec<Piece>,
    cost: f64,
}

impl<'a> Best<'a> {
    fn new(task: Task<'a>, pieces: Vec<Piece>) -> Best<'a> {
        let shapes = pieces.iter().map(|piece| (piece.layer, piece.blocks.as_slice()));
        let cost = cost(task.building, task.settings, shapes);
        Best { task, pieces, cost }
    }

    /// Whether a set is no dearer, and so the best.
    fn offer(&mut self, pieces: Vec<Piece>) -> bool {
        let offered = Best::new(self.task, pieces);
        let is_best = offered.cost <= self.cost;
        if is_best {
            (self.pieces, self.cost) = (offered.pieces, offered.cost);
        }
        is_best
    }
}
