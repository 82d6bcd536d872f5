//! Facades: a labelled layout becomes a grammar that stretches (seed 4, and the method that it set out to build: Wu, Yan,
//! Dong, Zhang and Wonka, "Inverse Procedural Modeling of Facade Layouts", 2014). Knows nothing of files.
//!
//! ```text
//! Drawing --lined--> Lined --snap--> Layout --Cutter, Groups--> structures, repeats
//!                                      \--parse: greedy or searched--> Plan, Rules --emit--> OpGraph
//! ```

mod building;
mod cuts;
mod drawing;
mod emit;
mod error;
mod fold;
mod greedy;
mod groups;
mod labels;
mod layout;
mod plan;
mod proof;
mod rules;
mod search;
mod snap;
mod stretch;

use crate::graph::OpGraph;
use crate::run::{Library, RunError};

pub use building::{Form, Roof};
pub use cuts::{Cutter, Structures};
pub use drawing::{Area, Drawing, Lined, Place};
pub use emit::{Depth, FACADE};
pub use error::FacadeError;
pub use groups::{Counts, Groups};
pub use labels::{LabelsError, LabelsProblem, Meaning, Meanings, Meant, Stretch, What, meant};
pub use layout::{Layout, Leaf, Region, Side};
pub use plan::{Node, Plan};
pub use rules::{Length, Rule, RuleItem, Rules, Symbol};
pub use search::{Method, Parsed, parse};
pub use snap::{Near, Scale, Snapped, snap};

/// How a facade is learnt.
#[derive(Clone, Debug, Default)]
pub struct Options {
    pub scale: Scale,
    pub near: Near,
    pub method: Method,
    pub meanings: Meanings,
    /// The blocks from the front to the back; as the labels need if not given.
    pub depth: Option<u32>,
    pub form: Form,
}

/// What was learnt of a layout.
#[derive(Clone, Debug)]
pub struct Facade {
    pub graph: OpGraph,
    /// The layout in blocks.
    pub layout: Layout,
    pub blocks_per_unit: f64,
    /// How many lines met others, and how far a line moved at the most, in blocks.
    pub met: usize,
    pub moved: f64,
    pub meant: Meant,
    pub depth: Depth,
    /// Of the layout as it was drawn.
    pub counts: Counts,
    /// The rules before they learnt to stretch.
    pub rules: Rules,
}

/// Why nothing is learnt of a layout.
#[derive(Debug, thiserror::Error)]
pub enum InferError {
    #[error(transparent)]
    Facade(#[from] FacadeError),
    #[error(transparent)]
    Labels(#[from] LabelsError),
}

/// The grammar of a facade: at its own size it gives the layout, at others its windows stay whole.
///
/// # Errors
///
/// Where the areas do not tile a rectangle, the scale has no block for each, no straight lines cut them, or what is said
/// of labels is about none of them.
pub fn infer(drawing: &Drawing, options: &Options) -> Result<Facade, InferError> {
    let lined = drawing.lined()?;
    options.meanings.check(lined.layout.labels())?;
    let counts = counts(&lined.layout)?;
    let snapped = snap(&lined, options.scale, options.near)?;
    let steps = steps(&lined, &snapped);
    let meant = meant(&snapped.layout, &options.meanings, &steps);
    let soft: Vec<bool> = meant.list.iter().map(|meaning| meaning.stretch == Stretch::Soft).collect();
    let Snapped { layout, blocks_per_unit, met, moved } = snapped;
    let layout = cuts::made_cuttable(layout, &soft)?;
    let Parsed { plan, rules } = parsed(&layout, options.method)?;
    let depth = Depth::of(&meant.list);
    let emitted = emit::emit(&layout, &plan, &rules, &meant.list, depth);
    let [width, height] = layout.size();
    let size = [width, height, options.depth.unwrap_or(depth.total()).max(1)];
    let graph = building::formed(emitted, options.form, size, depth);
    Ok(Facade { graph, layout, blocks_per_unit, met, moved, meant, depth, counts, rules })
}

/// The groups of a layout (seed 4, section 6.1). A layout that no straight lines cut has those that they do.
fn counts(layout: &Layout) -> Result<Counts, FacadeError> {
    let cutter = Cutter::new(layout)?;
    Ok(Groups::of(&cutter, &mut Structures::default()).counts())
}

/// The rules of a layout that straight lines cut.
///
/// # Errors
///
/// Where there are too many lines.
pub fn parsed(layout: &Layout, method: Method) -> Result<Parsed, FacadeError> {
    let cutter = Cutter::new(layout)?;
    let mut structures = Structures::default();
    let groups = match method {
        Method::Greedy => Groups::default(),
        Method::Searched => Groups::of(&cutter, &mut structures),
    };
    Ok(parse(&cutter, &mut structures, &groups, layout.labels().len(), method))
}

/// By label, how many blocks before the walls a drawing puts it; none where it puts all in one plane.
fn steps(lined: &Lined, snapped: &Snapped) -> Vec<Option<i32>> {
    /// A smaller part of a unit is noise.
    const NOISE: f64 = 1e-4;
    let layout = &snapped.layout;
    let front = |label: usize| {
        let own = layout.leaves().iter().zip(&lined.fronts).filter(|(leaf, _)| leaf.label as usize == label);
        own.filter_map(|(_, front)| *front).reduce(f64::max)
    };
    let labels = layout.labels().len();
    let fronts: Vec<Option<f64>> = (0..labels).map(front).collect();
    let plain = meant(layout, &Meanings::default(), &[]);
    let soft = (0..labels).filter(|label| plain.list[*label].stretch == Stretch::Soft);
    let wall = soft.max_by_key(|label| labels::area(layout, *label)).and_then(|label| fronts[label]);
    let is_flat = fronts.iter().flatten().all(|front| wall.is_some_and(|wall| (front - wall).abs() < NOISE));
    let step = |front: f64, wall: f64| {
        let blocks = (front - wall) * snapped.blocks_per_unit;
        if (front - wall).abs() < NOISE { 0 } else { (blocks.abs().round().max(1.0) * blocks.signum()) as i32 }
    };
    fronts.iter().map(|front| if is_flat { None } else { Some(step((*front)?, wall?)) }).collect()
}

impl Facade {
    /// How many leaves a run of `graph`, which begins with the facade, gives block for block.
    ///
    /// # Errors
    ///
    /// Where it does not run.
    pub fn reproduced(&self, graph: &OpGraph, library: &Library) -> Result<usize, RunError> {
        proof::reproduced(graph, &self.layout, &self.meant.list, self.depth, library)
    }
}
