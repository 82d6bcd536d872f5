//! The search for a cheap set of shapes (seed 3, "Inferring Shape Sets").

mod least;
mod piece;
mod set;
mod wander;

pub use piece::Piece;

use super::building::{Block, Building};
use super::choose;
use super::layer::Layer;
use super::price::Price;
use super::settings::{Cost, Operation, Rest, Search, Settings};
use super::shape::Shape;
use fixedbitset::FixedBitSet;
use set::{Goal, Reach, Set, Splits, Step};
use std::cmp::Reverse;

/// What is searched, and how.
#[derive(Clone, Copy)]
struct Task<'a> {
    building: &'a Building,
    settings: &'a Settings,
    layers: &'a [Layer],
}

/// The shapes of a building, the largest first.
pub fn search(building: &Building, settings: &Settings) -> Vec<Shape> {
    search_in(building, settings, &Layer::of(settings.specification))
}

/// The same in layers of choice. Each of them may be there once.
pub fn search_in(building: &Building, settings: &Settings, layers: &[Layer]) -> Vec<Shape> {
    let task = Task { building, settings, layers };
    let pieces = match settings.search {
        Search::Climb => climb_to_end(task, &in_order(building)),
        Search::Restarts(times) => wander::restarts(task, times),
        Search::Backtracking(times) => wander::backtracking(task, times),
        Search::Annealing(steps) => wander::annealing(task, steps),
    };
    pieces.into_iter().map(|piece| Shape { layer: piece.layer, blocks: piece.blocks }).collect()
}

fn in_order(building: &Building) -> Vec<Block> {
    (0..building.len() as Block).collect()
}

/// What is kept of a climb from the given blocks. Blocks that are in nothing that is kept are climbed from again, if the
/// settings say so.
fn climb_to_end(task: Task<'_>, order: &[Block]) -> Vec<Piece> {
    finished(task, climb(task, order))
}

/// The pieces that are kept, with those of the blocks that are left over.
fn finished(task: Task<'_>, pieces: Vec<Piece>) -> Vec<Piece> {
    let Task { building, settings, .. } = task;
    let mut kept = choose::chosen(building, settings, pieces);
    if settings.rest == Rest::Searched {
        loop {
            let left = left_over(building, &kept);
            if left.is_empty() {
                break;
            }
            kept.extend(choose::chosen(building, settings, climb(task, &left)));
        }
        kept.sort_by_key(|piece| Reverse(piece.blocks.len()));
    }
    kept
}

fn left_over(building: &Building, pieces: &[Piece]) -> Vec<Block> {
    let mut covered = FixedBitSet::with_capacity(building.len());
    pieces.iter().flat_map(|piece| &piece.blocks).for_each(|block| covered.insert(*block as usize));
    covered.zeroes().map(|block| block as Block).collect()
}

/// Climbs from single blocks, or from the largest shapes.
fn climb(task: Task<'_>, order: &[Block]) -> Vec<Piece> {
    let Task { building, settings, layers } = task;
    let (goal, splits) = (goal(settings), splits(settings.operation));
    let set = match settings.operation {
        Operation::Merge | Operation::Both => Set::of_blocks(building, layers, order, goal, splits),
        Operation::Split => Set::of(building, largest(building, layers, order).into_iter(), goal, splits),
    };
    let reach = first_reach(settings.cost);
    climbed(set, settings.operation, reach).into_pieces()
}

fn goal(settings: &Settings) -> Goal {
    Goal::Cheapest(Price { cost: settings.cost, alpha: settings.alpha })
}

fn splits(operation: Operation) -> Splits {
    if operation == Operation::Merge { Splits::Never } else { Splits::Wanted }
}

/// Shapes that nothing can be joined with, without those that others cover.
fn largest(building: &Building, layers: &[Layer], order: &[Block]) -> Vec<(Layer, Vec<Block>)> {
    let set = Set::of_blocks(building, layers, order, Goal::Largest, Splits::Never);
    let pieces = climbed(set, Operation::Merge, Reach::NotDearer).into_pieces();
    choose::covering(building, pieces).into_iter().map(|piece| (piece.layer, piece.blocks)).collect()
}

/// The authors' program takes its first merge whatever it costs.
fn first_reach(cost: Cost) -> Reach {
    if cost == Cost::Paper { Reach::NotDearer } else { Reach::Legal }
}

/// Takes steps by which the cost does not rise, until there are none or two of them have left it as it was.
fn climbed(mut set: Set<'_>, operation: Operation, mut reach: Reach) -> Set<'_> {
    let mut ties = 0;
    while ties < 2
        && let Some((step, rise)) = next(&mut set, operation, std::mem::replace(&mut reach, Reach::NotDearer))
    {
        set.take(step);
        ties += usize::from(rise == 0.0);
    }
    set
}

fn next(set: &mut Set<'_>, operation: Operation, reach: Reach) -> Option<(Step, f64)> {
    match operation {
        Operation::Merge => set.first_merge(reach),
        Operation::Split => set.first_split(),
        Operation::Both => match (set.first_merge(reach), set.first_split()) {
            (Some(merge), _) if reach == Reach::Legal => Some(merge),
            (Some(merge), Some(split)) => Some(if merge.1 < split.1 { merge } else { split }),
            // A merge that leaves the cost as it is would be undone by a split.
            (Some(merge), None) => Some(merge).filter(|merge| merge.1 < 0.0),
            (None, split) => split,
        },
    }
}
