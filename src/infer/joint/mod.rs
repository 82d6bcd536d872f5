//! Joint induction: one operation explains all the boxes that a rule stands for, across all examples, and is
//! chosen by the bits of its description.
//!
//! ```text
//! Example --volume--> Volume --corpus--> classes of boxes --explain--> Plan --emit--> OpGraph
//! ```

mod alternation;
mod blame;
mod boxes;
mod by_length;
mod contexts;
mod corpus;
mod dependence;
mod derivation;
pub mod emit;
pub mod estimate;
mod explain;
mod feasible;
mod fold;
mod groups;
pub mod laws;
mod limits;
mod memo;
mod merge;
mod narrow;
mod pairs;
mod peel;
mod places;
mod plan;
mod planes;
mod pool;
mod recolour;
mod refit;
mod repeats;
mod replace;
mod rows;
mod samples;
mod scope;
mod seams;
mod sides;
mod slopes;
mod starts;
mod stretch;
mod task;
mod volume;

use super::example::{Example, Terminals};
use super::{Freedom, Learnt};
use crate::block;
use crate::grid::Grid;
use crate::space::{Axis, Cell};
use corpus::Corpus;
use estimate::Estimates;
use samples::Shown;
use task::{First, Known, Searched, Task};
use volume::Volume;

/// Examples of more cells than this in all are not searched, as dozens of samples would have to be made and looked at;
/// nor any that is longer on an axis: cuts are nested as deep as there are slices.
const MOST_CELLS: u64 = 1 << 20;
const LONGEST: i32 = 128;

/// Learns one op graph from several examples of blocks, none of them empty. `open` are the examples without what
/// the neighbours of blocks decide.
///
/// Where samples show what no example shows, what is to blame is repaired, and what that touches is explained again;
/// once they do not, rules that are one become one, if they still do not. `None` where no operation describes most of
/// the examples together with others, where what was found makes nothing but the examples, or where to find it would
/// take too long.
pub fn joint(examples: &[&Grid], open: &[Example], freedom: Freedom) -> Option<Learnt> {
    let cells: u64 = examples.iter().map(|grid| grid.bounds().volume()).sum();
    let is_long = |grid: &&Grid| grid.size().max_element() > LONGEST;
    if examples.len() < 2 || cells > MOST_CELLS || examples.iter().any(is_long) {
        return None;
    }
    let task = Task { open, freedom, shown: Shown::by(examples) };
    let mut known = known(examples, open);
    let plain = task.search(&mut known, First::Any, |_| true)?;
    let is_promising = |outset: f64| plain.is_far_off() || outset <= NEAR * plain.outset;
    let told_apart =
        (0..CHOICES).map_while(|choice| task.search(&mut known, First::Choice(choice), is_promising));
    let told_apart: Vec<Searched> = told_apart.collect();
    let found = told_apart.into_iter().chain([plain]).filter_map(|searched| searched.found);
    let shortest = found.min_by(|one, other| one.bits.total_cmp(&other.bits));
    shortest.map(|found| found.learnt)
}

/// So many ways to tell the examples apart are tried before anything else: a choice that decides on all beside it, such
/// as on which side a wing stands, is shorter only once everything is explained and pooled.
const CHOICES: usize = 3;
/// Those only whose description at the outset is so much longer than without, unless repairs made that one longer.
const NEAR: f64 = 1.15;

fn known(examples: &[&Grid], open: &[Example]) -> Known {
    let mut terminals = Terminals::default();
    let cells = open.iter().filter_map(|example| example.cells(&mut terminals));
    let volumes = cells.zip(examples).map(|(cells, grid)| Volume::new(cells, &wholes(grid))).collect();
    let corpus = Corpus::new(volumes, terminals.air());
    Known { terminals, corpus, estimates: Estimates::default(), used: 0 }
}

/// The first halves of doors, beds and the like, with the axis on which the second one stands.
fn wholes(grid: &Grid) -> Vec<(Axis, Cell)> {
    let steps: Vec<Option<Cell>> =
        grid.palette().states().iter().map(|state| block::other_half(state).map(|(step, _)| step)).collect();
    let bounds = grid.bounds();
    let whole = |cell: Cell| {
        let step = steps[usize::from(grid.id(cell))]?;
        let axis = Axis::ALL.into_iter().find(|axis| axis.of(step) != 0)?;
        let low = cell.min(cell + step);
        (bounds.contains(cell + step)).then_some((axis, low))
    };
    bounds.cells().filter_map(whole).collect()
}
