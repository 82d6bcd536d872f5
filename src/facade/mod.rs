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
pub use emit::{Depth, VARIETY, Variety, facade_label};
pub use error::FacadeError;
pub use groups::{Counts, Groups};
pub use labels::{LabelsError, LabelsProblem, Meaning, Meanings, Meant, Stretch, What, is_wall, meant};
pub use layout::{Layout, Leaf, Region, Side};
pub use plan::{Node, Plan};
pub use rules::{Length, Rule, RuleItem, Rules, Symbol};
pub use search::{Method, Parsed, parse};
pub use snap::{Near, Scale, Snapped, snap};

/// How facades are learnt.
#[derive(Clone, Debug, Default)]
pub struct Options {
    pub scale: Scale,
    pub near: Near,
    pub method: Method,
    pub variety: Variety,
    pub meanings: Meanings,
    /// The blocks from the front to the back; as the labels need if not given.
    pub depth: Option<u32>,
    pub form: Form,
}

/// What was learnt of layouts.
#[derive(Clone, Debug)]
pub struct Learnt {
    pub graph: OpGraph,
    /// In the order of the layouts.
    pub facades: Vec<Facade>,
    pub meant: Meant,
    pub depth: Depth,
}

/// What was learnt of one layout.
#[derive(Clone, Debug)]
pub struct Facade {
    /// The layout in blocks.
    pub layout: Layout,
    pub blocks_per_unit: f64,
    /// How many lines met others, and how far a line moved at the most, in blocks.
    pub met: usize,
    pub moved: f64,
    /// Of the layout as it was drawn.
    pub counts: Counts,
    /// The rules before they learnt to stretch.
    pub rules: Rules,
}

/// Why nothing is learnt of layouts.
#[derive(Debug, thiserror::Error)]
pub enum InferError {
    #[error("{error}")]
    Facade {
        /// The number of the layout, from 0.
        layout: usize,
        error: FacadeError,
    },
    #[error(transparent)]
    Labels(#[from] LabelsError),
}

/// One grammar of all facades: at its own size each gives its layout, at others its windows stay whole.
///
/// # Errors
///
/// Where the areas of a layout do not tile a rectangle, the scale has no block for each, no straight lines cut them, or
/// what is said of labels is about none of them.
pub fn infer(drawings: &[Drawing], options: &Options) -> Result<Learnt, InferError> {
    let mut drawn = Vec::with_capacity(drawings.len());
    for (number, drawing) in drawings.iter().enumerate() {
        let placed = |error| InferError::Facade { layout: number, error };
        drawn.push(Drawn::of(drawing, options).map_err(placed)?);
    }
    let labels = labels_of(&drawn);
    options.meanings.check(&labels)?;
    let layouts: Vec<Layout> = drawn.iter().map(|drawn| drawn.snapped.layout.relabelled(&labels)).collect();
    let meant = meant(&layouts, &options.meanings, &steps(&drawn, &layouts));
    let soft: Vec<bool> = meant.list.iter().map(|meaning| meaning.stretch == Stretch::Soft).collect();
    let mut parsed = Vec::with_capacity(layouts.len());
    for (number, layout) in layouts.into_iter().enumerate() {
        let placed = |error| InferError::Facade { layout: number, error };
        let layout = cuts::made_cuttable(layout, &soft).map_err(placed)?;
        let rules = self::parsed(&layout, options.method).map_err(placed)?;
        parsed.push((layout, rules));
    }
    let depth = Depth::of(&meant.list);
    let emitted = emit::emit(&parsed, &meant.list, depth, options.variety);
    let deep = options.depth.unwrap_or(depth.total()).max(1);
    let sizes: Vec<[u32; 3]> =
        parsed.iter().map(|(layout, _)| [layout.size()[0], layout.size()[1], deep]).collect();
    let graph = building::formed(emitted, options.form, &sizes, depth);
    let facades = drawn.into_iter().zip(parsed).map(|(drawn, (layout, Parsed { rules, .. }))| {
        let Snapped { blocks_per_unit, met, moved, .. } = drawn.snapped;
        Facade { layout, blocks_per_unit, met, moved, counts: drawn.counts, rules }
    });
    Ok(Learnt { graph, facades: facades.collect(), meant, depth })
}

/// A layout on its way from lines to blocks.
struct Drawn {
    lined: Lined,
    counts: Counts,
    snapped: Snapped,
}

impl Drawn {
    fn of(drawing: &Drawing, options: &Options) -> Result<Drawn, FacadeError> {
        let lined = drawing.lined()?;
        let counts = counts(&lined.layout)?;
        let snapped = snap(&lined, options.scale, options.near)?;
        Ok(Drawn { lined, counts, snapped })
    }
}

/// The labels of all layouts, in order of first use.
fn labels_of(drawn: &[Drawn]) -> Vec<String> {
    let mut labels: Vec<String> = Vec::new();
    for label in drawn.iter().flat_map(|drawn| drawn.lined.layout.labels()) {
        if !labels.contains(label) {
            labels.push(label.clone());
        }
    }
    labels
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

/// By label, how many blocks before the walls the drawings put it; none where they put all in one plane.
fn steps(drawn: &[Drawn], layouts: &[Layout]) -> Vec<Option<i32>> {
    /// A smaller part of a unit is noise.
    const NOISE: f64 = 1e-4;
    let Some(first) = layouts.first() else { return Vec::new() };
    // How far each label reaches to the front, in blocks.
    let fronts = drawn.iter().zip(layouts).flat_map(|(drawn, layout)| {
        let scale = drawn.snapped.blocks_per_unit;
        let fronts = layout.leaves().iter().zip(&drawn.lined.fronts);
        fronts.filter_map(move |(leaf, front)| Some((leaf.label as usize, (*front)?, scale)))
    });
    let mut highest: Vec<Option<(f64, f64)>> = vec![None; first.labels().len()];
    for (label, front, scale) in fronts {
        let known = &mut highest[label];
        *known = Some(known.map_or((front, scale), |(other, scale)| (other.max(front), scale)));
    }
    let plain = meant(layouts, &Meanings::default(), &[]);
    let soft = (0..highest.len()).filter(|label| plain.list[*label].stretch == Stretch::Soft);
    let area = |label: usize| layouts.iter().map(|layout| labels::area(layout, label)).sum::<u64>();
    let Some((wall, _)) = soft.max_by_key(|label| area(*label)).and_then(|label| highest[label]) else {
        return Vec::new();
    };
    let step = |(front, scale): (f64, f64)| match front - wall {
        off if off.abs() < NOISE => 0,
        off => ((off * scale).abs().round().max(1.0) * off.signum()) as i32,
    };
    let steps: Vec<Option<i32>> = highest.iter().map(|highest| highest.map(step)).collect();
    let is_flat = steps.iter().flatten().all(|step| *step == 0);
    if is_flat { Vec::new() } else { steps }
}

impl Learnt {
    /// How many leaves of a layout, by its number, a run of `graph` gives block for block: the graph that begins with its
    /// facade.
    ///
    /// # Errors
    ///
    /// Where it does not run.
    pub fn reproduced(&self, number: usize, graph: &OpGraph, library: &Library) -> Result<usize, RunError> {
        proof::reproduced(graph, &self.facades[number].layout, &self.meant.list, self.depth, library)
    }
}
