//! Which of the shapes that a search ends with are kept (seed 3, "Local search").

use super::building::Building;
use super::price::Price;
use super::search::Piece;
use super::settings::{Overlap, Settings, Specification};
use fixedbitset::FixedBitSet;
use std::cmp::Reverse;

/// The pieces that are kept, as the settings ask for.
pub fn chosen(building: &Building, settings: &Settings, pieces: Vec<Piece>) -> Vec<Piece> {
    let pieces = match settings.specification {
        Specification::Mixed => cheapest_first(settings, pieces),
        _ => largest_first(pieces),
    };
    match settings.overlap {
        Overlap::Shared => kept(building, pieces, adds_to),
        Overlap::Apart => kept(building, pieces, is_apart_from),
    }
}

fn largest_first(mut pieces: Vec<Piece>) -> Vec<Piece> {
    pieces.sort_by_key(|piece| Reverse(piece.blocks.len()));
    pieces
}

/// By what each block of a shape costs, so that each part of a building gets shapes of the specification that suits it.
fn cheapest_first(settings: &Settings, mut pieces: Vec<Piece>) -> Vec<Piece> {
    let price = Price { cost: settings.cost, alpha: settings.alpha };
    let per_block =
        |piece: &Piece| (price.per_shape() + price.measure(&piece.tally)) / piece.blocks.len() as f64;
    pieces.sort_by(|one, other| per_block(one).total_cmp(&per_block(other)));
    pieces
}

/// From the largest on, the pieces that hold a block which none before them holds.
pub fn covering(building: &Building, pieces: Vec<Piece>) -> Vec<Piece> {
    kept(building, largest_first(pieces), adds_to)
}

fn adds_to(piece: &Piece, covered: &FixedBitSet) -> bool {
    piece.blocks.iter().any(|block| !covered[*block as usize])
}

fn is_apart_from(piece: &Piece, covered: &FixedBitSet) -> bool {
    piece.blocks.iter().all(|block| !covered[*block as usize])
}

fn kept(
    building: &Building,
    mut pieces: Vec<Piece>,
    keep: impl Fn(&Piece, &FixedBitSet) -> bool,
) -> Vec<Piece> {
    let mut covered = FixedBitSet::with_capacity(building.len());
    pieces.retain(|piece| {
        let kept = keep(piece, &covered);
        if kept {
            piece.blocks.iter().for_each(|block| covered.insert(*block as usize));
        }
        kept
    });
    pieces
}
