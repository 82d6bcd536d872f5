//! Inference: examples become an op graph. Knows nothing of files.
//!
//! ```text
//! Grid --cuboids--> boxes of one block state --split_boxes--> Tree --combine--> Kinds --emit--> OpGraph
//!   \--weave--> further Grids                                                      |
//!   \--exchanges--> planes where examples can be exchanged ------------------------/
//! ```
//!
//! That is how examples are learnt one by one. `joint` explains all at once, `trees` joins those of labelled boxes.

pub mod boxes;
mod combine;
pub mod cuboids;
mod emit;
mod example;
mod exchange;
mod fold;
mod held;
mod joint;
mod kinship;
mod law;
mod naming;
mod neighbourhood;
mod shaped;
mod swaps;
pub mod tree;
mod trees;
mod variety;
mod weave;

use crate::grammar::Grammar;
use crate::graph::OpGraph;
use crate::grid::Grid;
use combine::{Chance, Slab};
use exchange::Exchange;
use held::Held;
use neighbourhood::Shown;
use std::borrow::Cow;
use swaps::{Settled, Site};

pub use crate::parse::Labels;
pub use boxes::{BadBoxes, PLAN_FIRST, Turns, UPRIGHT_FIRST, split_boxes};
pub use cuboids::cuboids;
pub use example::{Example, Terminal, Terminals, derived};
pub use naming::Notes;
pub use tree::{Node, NodeId, Part, Tree, TreeBuilder};
pub use variety::variety;

/// Why nothing could be learnt.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum InferError {
    #[error("there is no example to learn from")]
    NoExample,
    #[error("the example is empty: it holds nothing but air")]
    Empty { example: usize },
    #[error("{problem}")]
    Boxes { example: usize, problem: BadBoxes },
    #[error("some examples are blocks and some are labelled boxes: learn from one kind at a time")]
    Mixed { example: usize },
}

impl InferError {
    /// The number of the example that the error is about, from 0.
    pub fn example(&self) -> Option<usize> {
        match self {
            InferError::NoExample => None,
            InferError::Empty { example }
            | InferError::Boxes { example, .. }
            | InferError::Mixed { example } => Some(*example),
        }
    }
}

/// What was learnt.
#[derive(Clone, Debug)]
pub struct Learnt {
    pub graph: OpGraph,
    pub labels: Labels,
    /// The method that learnt it.
    pub by: Method,
    /// Whether a parser has shown already that the graph derives every example.
    pub is_proved: bool,
    /// Comments for whoever reads it.
    pub notes: Notes,
}

impl Learnt {
    /// The grammar that says it, with comments.
    pub fn grammar(&self) -> Grammar {
        self.notes.write(&self.graph)
    }
}

/// How examples become rules.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Method {
    /// One operation explains all the boxes that a rule stands for, across all examples; the shortest
    /// description wins. A single building, and buildings that share too little or are too large for
    /// the search, are learnt by [`Method::Boxes`]; so are labelled boxes, which are then joined role by role where that
    /// makes many rules few.
    #[default]
    Joint,
    /// The method of seed 1 (chapters 9 and 10): split each example into its terminals, then make one operation
    /// of what is equal or differs in size only. Examples of blocks that have one size are first cut at the
    /// planes where they can be exchanged.
    Boxes,
    /// As [`Method::Boxes`], with SIGI's shapes as terminals in place of the largest cuboids: the step that the authors of
    /// seed 3 propose ("Split Grammar Induction").
    Shapes,
}

/// How far what is learnt may leave its examples.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Freedom {
    /// Nothing stands beside one another that does so in no example.
    #[default]
    Seen,
    /// Whatever the shortest description allows. Of buildings that are learnt one by one, also what stands beside one
    /// another in examples that are turned or mirrored.
    Free,
}

/// Learns one op graph from all examples.
///
/// The graph derives every example; a [`Parser`](crate::parse::Parser) proves it.
pub fn infer(examples: &[Example], method: Method, freedom: Freedom) -> Result<Learnt, InferError> {
    let first = examples.first().ok_or(InferError::NoExample)?;
    for (number, example) in examples.iter().enumerate() {
        if example.is_empty() {
            return Err(InferError::Empty { example: number });
        }
        if std::mem::discriminant(example) != std::mem::discriminant(first) {
            return Err(InferError::Mixed { example: number });
        }
    }
    let open: Vec<Example> = examples.iter().map(Example::open).collect();
    let grids = examples.iter().filter_map(|example| match example {
        Example::Blocks(grid) => Some(grid),
        Example::Boxes(_) => None,
    });
    let grids: Vec<&Grid> = grids.collect();
    let learnt = match method {
        Method::Joint if freedom == Freedom::Free || kinship::may_be_kin(&open) => {
            let one_by_one = || by_boxes(&open, freedom, Mixing::of(&open, freedom), method);
            joint::joint(&grids, &open, freedom).map_or_else(one_by_one, Ok)
        }
        Method::Joint | Method::Boxes | Method::Shapes => by_boxes(&open, freedom, Mixing::Woven, method),
    };
    let learnt = learnt?;
    let joined = match (method, first) {
        (Method::Joint, Example::Boxes(_)) => trees::shorter(&learnt, &open),
        _ => None,
    };
    let joined = joined.and_then(|joined| proved(naming::name(joined, examples), &open));
    Ok(joined.unwrap_or_else(|| naming::name(learnt, examples)))
}

/// The steps of a proof of one example, about a second: what takes longer to prove is left.
const MOST_PROVED: u64 = 1 << 18;

/// What a parser proves.
fn proved(learnt: Learnt, examples: &[Example]) -> Option<Learnt> {
    let all = derived(examples, &learnt.graph, &learnt.labels, MOST_PROVED);
    all.into_iter().all(|is| is).then_some(Learnt { is_proved: true, ..learnt })
}

/// How examples that are learnt one by one are mixed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Mixing {
    /// Slabs and parts of them stand in for one another.
    Swapped,
    /// They are also woven into further ones.
    Woven,
}

impl Mixing {
    /// Examples that share a plan are not woven, which would break it.
    fn of(examples: &[Example], freedom: Freedom) -> Mixing {
        match freedom == Freedom::Seen && kinship::are_kin(examples) {
            true => Mixing::Swapped,
            false => Mixing::Woven,
        }
    }
}

fn by_boxes(
    examples: &[Example],
    freedom: Freedom,
    mixing: Mixing,
    method: Method,
) -> Result<Learnt, InferError> {
    let mut terminals = Terminals::default();
    examples.iter().for_each(|example| terminals.enter(example));
    let images = match freedom {
        Freedom::Seen => Vec::new(),
        Freedom::Free => examples.iter().flat_map(Example::images).collect(),
    };
    let mut shown = may_mix(examples).then(|| Shown::by(examples, &images, &mut terminals)).flatten();
    let mut exchanges = exchange::exchanges(examples, shown.as_ref(), &terminals);
    let mut sites = Vec::new();
    let mut all = Cow::Borrowed(examples);
    if let Some(shown) = &mut shown {
        let mut settled = Settled::by(examples.iter().chain(&images));
        sites = swaps::sites(examples, shown, &terminals, &mut settled, &exchanges);
        let needs_more =
            |own: usize| mixing == Mixing::Woven && ways(own, &sites[own], &exchanges) < MANY_WAYS;
        let woven = weave::woven(shown, &terminals, &mut settled, needs_more);
        if !woven.is_empty() {
            all.to_mut().extend(woven.iter().map(|cells| Example::Blocks(terminals.grid(cells))));
            shown.add(woven);
            exchanges.extend((examples.len()..all.len()).map(Exchange::alone));
            let further = swaps::sites(&all[examples.len()..], shown, &terminals, &mut settled, &exchanges);
            sites.extend(further);
        }
    }
    let chance = chance(examples, freedom);
    if method != Method::Shapes {
        let held = Held::new(sites, Vec::new(), chance, &mut terminals);
        return learnt_apart(&all, &held, chance, &exchanges, terminals);
    }
    sites.resize_with(all.len(), Vec::new);
    let mut plain = Vec::new();
    for (example, sites) in all.iter().zip(&mut sites) {
        let shaped = shaped::shaped(example, sites, &mut terminals);
        sites.extend(shaped.sites);
        plain.push(shaped.plain);
    }
    let held = Held::new(sites, plain, chance, &mut terminals);
    let learnt = learnt_apart(&all, &held, chance, &exchanges, terminals)?;
    Ok(Learnt { by: Method::Shapes, ..learnt })
}

/// Where sizes may be left to chance. What is drawn puts blocks side by side that no example shows so.
fn chance(examples: &[Example], freedom: Freedom) -> Chance {
    match (examples.first(), freedom) {
        (Some(Example::Blocks(_)), Freedom::Seen) => Chance::Nowhere,
        (Some(Example::Blocks(_)), Freedom::Free) => Chance::Bodies,
        _ => Chance::Anywhere,
    }
}

/// What is learnt of examples with what their sites hold, and of where they can be exchanged.
fn learnt_apart(
    examples: &[Example],
    held: &Held,
    chance: Chance,
    exchanges: &[Exchange],
    mut terminals: Terminals,
) -> Result<Learnt, InferError> {
    let mut slabs = Vec::new();
    for (number, example) in examples.iter().enumerate() {
        let group = exchanges.iter().find(|group| group.members.contains(&number));
        let boxes = group.map_or_else(Vec::new, |group| group.slabs(example.bounds()));
        let trees = held.trees(number, example, &boxes, &mut terminals);
        let trees = trees.map_err(|problem| InferError::Boxes { example: number, problem })?;
        slabs.extend(boxes.into_iter().zip(trees).map(|(bounds, tree)| Slab { bounds, tree }));
    }
    let kinds = combine::combine(&slabs, chance, held.labels());
    Ok(emit::emit(&kinds, held, exchanges, &terminals, examples))
}

/// An example that can be made in so many ways is not woven into further ones: nine of ten are new already.
const MANY_WAYS: usize = 10;

/// In how many ways an example can be made with what its sites hold; many if it can be exchanged with others.
fn ways(example: usize, sites: &[Site], exchanges: &[Exchange]) -> usize {
    let is_exchanged = exchanges.iter().any(|group| group.exchanges(example));
    let held = sites.iter().map(|site| site.contents.len());
    if is_exchanged { usize::MAX } else { held.fold(1, usize::saturating_mul) }
}

/// Examples of more cells than this in all are given back as they are: to look for what they can exchange takes
/// longer than anything else.
const MOST_MIXED: u64 = 1 << 18;

/// Whether parts of examples may stand in for one another. One example alone is to be given back as it is.
fn may_mix(examples: &[Example]) -> bool {
    let cells: u64 = examples.iter().map(|example| example.bounds().volume()).sum();
    examples.len() > 1 && cells <= MOST_MIXED
}
