//! Joint induction: one operation explains all the boxes that a rule stands for, across all examples, and is
//! chosen by the bits of its description.
//!
//! ```text
//! Example --volume--> Volume --corpus--> classes of boxes --explain--> Plan --emit--> OpGraph
//! ```

mod alternation;
mod blame;
mod boxes;
mod contexts;
mod corpus;
mod dependence;
mod derivation;
pub mod emit;
mod estimate;
mod explain;
mod feasible;
mod fold;
mod groups;
pub mod laws;
mod limits;
mod memo;
mod merge;
mod peel;
mod plan;
mod planes;
mod pool;
mod recolour;
mod repeats;
mod replace;
mod rows;
mod samples;
mod scope;
mod seams;
mod slopes;
mod starts;
mod volume;

use super::example::{Example, Terminals};
use super::{Freedom, Learnt};
use crate::block;
use crate::graph::OpGraph;
use crate::grid::Grid;
use crate::space::{Axis, Cell};
use blame::{Repair, Repairs, Suspects};
use boxes::Boxes;
use corpus::Corpus;
use emit::Emitted;
use explain::{Explainer, Search};
use limits::Limits;
use plan::NodeId;
use samples::Shown;
use starts::Sizes;
use volume::Volume;

/// So many steps are looked ahead.
const AHEAD: u8 = 1;
/// So often what is to blame is repaired.
const ROUNDS: usize = 100;
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
    let task = Task { examples, open, freedom, shown: Shown::by(examples) };
    let (plain, used) = task.search(First::Any, 0)?;
    let (mut found, mut all_used): (Vec<Found>, u64) = (plain.into_iter().collect(), used);
    for choice in 0..CHOICES {
        let Some((told_apart, used)) = task.search(First::Choice(choice), all_used) else { break };
        found.extend(told_apart);
        all_used += used;
    }
    let shortest = found.into_iter().min_by(|one, other| one.bits.total_cmp(&other.bits));
    shortest.map(|found| found.learnt)
}

/// So many ways to tell the examples apart are tried before anything else: a choice that decides on all beside it, such
/// as on which side a wing stands, is shorter only once everything is explained and pooled.
const CHOICES: usize = 3;

/// What is searched.
struct Task<'t> {
    examples: &'t [&'t Grid],
    open: &'t [Example],
    freedom: Freedom,
    shown: Shown,
}

/// What is done first with the examples.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum First {
    Any,
    /// They are told apart, by the choice of that number.
    Choice(usize),
}

/// What was learnt, and the bits of describing the examples by it.
struct Found {
    learnt: Learnt,
    bits: f64,
}

impl Task<'_> {
    /// The best description that one search finds, and the work that it took. Other searches have used up some of the
    /// work that may be done. `None` where even what is estimated best takes too long, or there is no such choice.
    fn search(&self, first: First, used: u64) -> Option<(Option<Found>, u64)> {
        let mut terminals = Terminals::default();
        let mut corpus = corpus(self.examples, self.open, &mut terminals);
        // What stands at the ends of rows, and what above them, would have to be told as well to show only what was seen.
        corpus.draws_rows = self.freedom == Freedom::Free;
        let places = corpus.examples();
        let boxes = Boxes::of(places.into_iter().map(|place| (corpus.class(place), 1)));
        let mut explainer = Explainer::new(&mut corpus);
        let may_begin = match first {
            First::Any => {
                explainer.explain(&boxes, Search(0));
                !explainer.is_spent()
            }
            First::Choice(number) => explainer.tell_apart_first(&boxes, number),
        };
        explainer.look_ahead(used);
        let found = may_begin.then(|| self.repaired(&mut explainer, &mut terminals, &boxes))?;
        Some((found, corpus.asked))
    }

    /// Explains the examples, and again after each repair of what samples show wrong, until they show nothing wrong.
    fn repaired(
        &self,
        explainer: &mut Explainer<'_>,
        terminals: &mut Terminals,
        boxes: &Boxes,
    ) -> Option<Found> {
        let mut limits = Limits::default();
        for _ in 0..ROUNDS {
            let root = explainer.explain_examples(boxes, Search(AHEAD));
            if explainer.is_spent() || explainer.tells_most_apart(root, boxes) {
                return None;
            }
            let emitted = self.emitted(explainer, terminals, (root, boxes), Sizes::Seen, &limits);
            let faults = match self.freedom {
                Freedom::Seen => self.shown.faults(&emitted.learnt.graph, terminals),
                Freedom::Free => Vec::new(),
            };
            if faults.is_empty() {
                let (learnt, bits) = self.pooled(explainer, terminals, (root, boxes), &limits);
                return self.shown.is_exceeded(&learnt.graph).then_some(Found { learnt, bits });
            }
            let made_for = explainer.in_use(boxes, Search(AHEAD));
            let mut suspects = Suspects {
                plan: &explainer.plan,
                corpus: explainer.corpus,
                emitted: &emitted,
                made_for: &made_for,
            };
            let ways: Vec<Repairs> = faults.iter().flat_map(|faulty| suspects.repairs(faulty)).collect();
            if !repair(explainer, &mut limits, &ways) {
                return None;
            }
        }
        None
    }

    fn emitted(
        &self,
        explainer: &mut Explainer<'_>,
        terminals: &Terminals,
        (root, boxes): (NodeId, &Boxes),
        sizes: Sizes,
        limits: &Limits,
    ) -> Emitted {
        emit::emit(&explainer.plan, explainer.corpus, root, boxes, terminals, (self.open, sizes), limits)
    }

    /// What has no faults with rules that are one made one, and with further start sizes, as long as it has none; and its
    /// bits.
    fn pooled(
        &self,
        explainer: &mut Explainer<'_>,
        terminals: &Terminals,
        (root, boxes): (NodeId, &Boxes),
        limits: &Limits,
    ) -> (Learnt, f64) {
        let is_like = |graph: &OpGraph| self.freedom == Freedom::Free || self.shown.is_like(graph);
        let learnt = |explainer: &mut Explainer<'_>, root, sizes| {
            self.emitted(explainer, terminals, (root, boxes), sizes, limits).learnt
        };
        let holds =
            |explainer: &mut Explainer<'_>, root| is_like(&learnt(explainer, root, Sizes::Seen).graph);
        let root = pool::pooled(explainer, root, boxes, Search(AHEAD), holds);
        let of_any_size = learnt(explainer, root, Sizes::Between);
        let learnt = match is_like(&of_any_size.graph) {
            true => of_any_size,
            false => learnt(explainer, root, Sizes::Seen),
        };
        (learnt, plan::bits(&explainer.plan, explainer.corpus, root, boxes))
    }
}

/// Makes the mildest repair of each fault that is new; boxes are kept apart only where nothing else is left to do.
/// Whether there was any.
fn repair(explainer: &mut Explainer<'_>, limits: &mut Limits, repairs: &[Repairs]) -> bool {
    let mut kept = Vec::new();
    let mut now: Vec<&Vec<Repair>> = Vec::new();
    for repairs in repairs {
        let (harsh, mild): (Vec<&Vec<Repair>>, Vec<&Vec<Repair>>) =
            repairs.iter().partition(|group| matches!(group.first(), Some(Repair::Keep(_))));
        // What was repaired for another fault may be all there is to this one.
        let made = mild.into_iter().find(|group| {
            now.contains(group)
                || group.iter().fold(false, |made, repair| made | make(explainer, limits, repair))
        });
        match made {
            Some(group) => now.push(group),
            None => kept.push(harsh),
        }
    }
    let mut is_new = !now.is_empty();
    if !is_new {
        for group in kept {
            is_new |= group.into_iter().flatten().any(|repair| make(explainer, limits, repair));
        }
    }
    is_new
}

fn make(explainer: &mut Explainer<'_>, limits: &mut Limits, repair: &Repair) -> bool {
    match repair {
        Repair::Tear { last, first, axis } => explainer.tear(*last, *first, *axis),
        Repair::Limit { boxes, axis } => limits.set(boxes, *axis),
        Repair::Keep(boxes) => explainer.keep(boxes),
    }
}

fn corpus(examples: &[&Grid], open: &[Example], terminals: &mut Terminals) -> Corpus {
    let cells = open.iter().filter_map(|example| example.cells(terminals));
    let volumes = cells.zip(examples).map(|(cells, grid)| Volume::new(cells, &wholes(grid))).collect();
    Corpus::new(volumes, terminals.air())
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
