//! Joint induction: one operation explains all the boxes that a rule stands for, across all examples, and is
//! chosen by the bits of its description.
//!
//! ```text
//! Example --volume--> Volume --corpus--> classes of boxes --explain--> Plan --emit--> OpGraph
//! ```

mod boxes;
mod contexts;
mod corpus;
mod dependence;
mod emit;
mod estimate;
mod explain;
mod feasible;
mod fold;
mod groups;
mod laws;
mod merge;
mod plan;
mod planes;
mod pool;
mod recolour;
mod repeats;
mod replace;
mod samples;
mod scope;
mod seams;
mod volume;

use super::example::{Example, Terminals};
use super::{Freedom, Learnt};
use crate::block;
use crate::graph::NodeIndex;
use crate::grid::Grid;
use crate::space::{Axis, Cell};
use boxes::Boxes;
use corpus::Corpus;
use emit::Emitted;
use explain::{Explainer, Search};
use samples::Shown;
use std::collections::BTreeSet;
use volume::Volume;

/// So many steps are looked ahead.
const AHEAD: u8 = 1;
/// Examples of more cells than this in all are not searched, nor any that is longer on an axis: cuts are nested as
/// deep as there are slices.
const MOST_CELLS: u64 = 250_000;
const LONGEST: i32 = 128;

/// Learns one op graph from several examples of blocks, none of them empty. `open` are the examples without what
/// the neighbours of blocks decide.
///
/// Where samples show what no example shows, the boxes that were mixed there are kept apart, and all is explained
/// again. Once they do not, rules that are one become one, if they still do not. `None` where no operation describes two examples, or where to find it would take too long.
pub fn joint(examples: &[&Grid], open: &[Example], freedom: Freedom) -> Option<Learnt> {
    let cells: u64 = examples.iter().map(|grid| grid.bounds().volume()).sum();
    let is_long = |grid: &&Grid| grid.size().max_element() > LONGEST;
    if examples.len() < 2 || cells > MOST_CELLS || examples.iter().any(is_long) {
        return None;
    }
    let mut terminals = Terminals::default();
    let mut corpus = corpus(examples, open, &mut terminals);
    let mut shown = Shown::by(examples);
    let places = corpus.examples();
    let boxes = Boxes::of(places.into_iter().map(|place| (corpus.class(place), 1)));
    let mut explainer = Explainer::new(&mut corpus);
    loop {
        let root = explainer.explain_examples(&boxes, Search(AHEAD));
        if explainer.is_spent() || explainer.tells_all_apart(root, &boxes) {
            return None;
        }
        let emitted = emit::emit(&explainer.plan, explainer.corpus, root, &boxes, &terminals, open);
        let blamed = match freedom {
            Freedom::Seen => shown.blamed(&emitted.learnt.graph),
            Freedom::Free => BTreeSet::new(),
        };
        if blamed.is_empty() {
            let holds = |explainer: &mut Explainer<'_>, root| {
                let emitted = emit::emit(&explainer.plan, explainer.corpus, root, &boxes, &terminals, open);
                freedom == Freedom::Free || shown.is_like(&emitted.learnt.graph)
            };
            let root = pool::pooled(&mut explainer, root, &boxes, Search(AHEAD), holds);
            return Some(
                emit::emit(&explainer.plan, explainer.corpus, root, &boxes, &terminals, open).learnt,
            );
        }
        if !keep_apart(&mut explainer, &emitted, &blamed) {
            return None;
        }
    }
}

fn corpus(examples: &[&Grid], open: &[Example], terminals: &mut Terminals) -> Corpus {
    let cells = open.iter().filter_map(|example| example.cells(terminals));
    let volumes = cells.zip(examples).map(|(cells, grid)| Volume::new(cells, &wholes(grid))).collect();
    Corpus::new(volumes, terminals.air())
}

/// Keeps apart what was mixed around each place that is to blame: the innermost boxes that are not kept apart yet.
/// Whether there were any.
fn keep_apart(explainer: &mut Explainer<'_>, emitted: &Emitted, blamed: &BTreeSet<Vec<NodeIndex>>) -> bool {
    let plan = explainer.restart();
    let mut is_new = false;
    for around in blamed {
        let nodes = around.iter().filter_map(|node| emitted.nodes.get(node)).flatten();
        let mut made_for = nodes.flat_map(|node| &plan.node(*node).made_for);
        is_new |= made_for.any(|boxes| explainer.keep(boxes));
    }
    is_new
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
