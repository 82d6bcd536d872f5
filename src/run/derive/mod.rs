//! The derivation: operations run on scopes until only primitives are left (seed 1, section 4.1).

mod choose;
mod divide;
mod primitive;
mod scope;
mod task;

use crate::graph::{Expr, NodeIndex, Op, OpGraph, Thing};
use crate::run::Options;
use crate::run::error::{Kind, RunError, Warning};
use crate::run::eval::{Around, Env, Site, Things, Value, World};
use crate::run::known::Known;
use crate::run::place::Place;
use crate::run::rounds::{needs_rounds, rounds};
use crate::run::trail::Step as Taken;
use crate::run::trail::{Observer, Trail};
use crate::space::{Bounds, Cell, Footprint, Scope};
use smallvec::SmallVec;
use std::collections::BTreeMap;
use std::rc::Rc;

pub use scope::quarter_turns;
pub use task::Task;

/// Differences below this are noise of floating-point arithmetic.
const NOISE: f64 = 1e-6;

/// Scopes that wait for their operation, at the most: each takes memory.
const MOST_OPEN: f64 = (1 << 22) as f64;

/// A list that most often has few elements, which then need no memory of their own.
type Few<T> = SmallVec<[T; 8]>;

/// A primitive and the scope it fills.
#[derive(Clone, Debug)]
pub struct Placement<'g> {
    pub name: &'g Thing,
    pub material: Option<&'g Thing>,
    pub options: SmallVec<[(&'g str, Value<'g>); 0]>,
    pub scope: Scope,
    /// The part of the plan that is there, inside the scope; `None` is all of it.
    pub footprint: Option<Rc<Footprint>>,
    /// What led here, if it is observed.
    pub trail: Trail,
}

/// How far from the origin a scope may reach, in blocks: twice as far is still a coordinate.
const FAR: i32 = 1 << 29;

/// Takes each placement; a warning it gives back goes with those of the derivation.
pub type Sink<'s, 'g> = dyn FnMut(Placement<'g>) -> Result<(), Kind> + 's;

/// Derives `graph` on `start` and hands every primitive to `sink`, in the order of the text: where scopes
/// overlap, later ones overwrite earlier ones. Scopes of no volume are skipped.
pub fn derive<'o, 'g>(
    graph: &'g OpGraph,
    things: &'g Things,
    start: Scope,
    options: &Options,
    observer: Option<&'o mut (dyn Observer + 'o)>,
    sink: &mut Sink<'_, 'g>,
) -> Result<Vec<Warning>, RunError> {
    let (mut derivation, root) = begin(graph, things, start, options, sink)?;
    derivation.observer = observer;
    match derivation.known {
        None => derivation.stream(root)?,
        Some(_) => rounds(&mut derivation, root, &mut |_| {})?,
    }
    Ok(derivation.told())
}

/// A derivation before its first step.
pub fn begin<'a, 'o, 's, 'g>(
    graph: &'g OpGraph,
    things: &'g Things,
    start: Scope,
    options: &'a Options,
    sink: &'a mut Sink<'s, 'g>,
) -> Result<(Derivation<'a, 'o, 's, 'g>, Task<'g>), RunError> {
    let root = Task {
        node: graph.root(),
        site: Site { scope: start, index: 0, total: 1 },
        around: Rc::new(Around::start(options.seed)),
        place: Place::start(options.seed),
        depth: 0,
        number: 0,
        trail: Trail::default(),
    };
    let derivation = Derivation {
        graph,
        world: World::new(graph, things, options.seed).map_err(RunError::anywhere)?,
        options,
        plot: start.bounds,
        observer: None,
        sink,
        stack: Vec::new(),
        placed: None,
        known: needs_rounds(graph, options).then(|| Known::new(graph)),
        steps: 0,
        warnings: BTreeMap::new(),
    };
    Ok((derivation, root))
}

/// What steps share. A step leaves the children of its operation on the stack. What it places goes to the sink, or in
/// rounds beside the stack: there it has to wait for what comes before it in the text.
pub struct Derivation<'a, 'o, 's, 'g> {
    pub graph: &'g OpGraph,
    pub world: World<'g>,
    pub options: &'a Options,
    pub plot: Bounds,
    pub observer: Option<&'o mut (dyn Observer + 'o)>,
    sink: &'a mut Sink<'s, 'g>,
    /// The last task is the next to run: children are pushed in reverse.
    pub stack: Vec<Task<'g>>,
    pub placed: Option<Placement<'g>>,
    /// The other shapes, if rules ask of them.
    pub known: Option<Known<'g>>,
    steps: u64,
    warnings: BTreeMap<NodeIndex, (Kind, u64)>,
}

type Step = Result<(), Kind>;

impl<'g> Derivation<'_, '_, '_, 'g> {
    /// Derives depth first: nothing is kept but what is still to run.
    fn stream(&mut self, root: Task<'g>) -> Result<(), RunError> {
        let graph = self.graph;
        self.stack.push(root);
        while let Some(mut task) = self.stack.pop() {
            self.observe(&mut task);
            self.step(&task).map_err(|kind| RunError::at(graph, task.node, kind))?;
        }
        Ok(())
    }

    /// Shows an operation to who looks on.
    pub fn observe(&mut self, task: &mut Task<'g>) {
        if let Some(observer) = &mut self.observer {
            let Task { node, number, site: Site { scope, .. }, .. } = *task;
            task.trail =
                observer.step(Taken { node, number, scope, before: std::mem::take(&mut task.trail) });
        }
    }

    fn told(self) -> Vec<Warning> {
        let told = self.warnings.into_iter();
        let told = told.map(|(node, (kind, times))| (RunError::at(self.graph, node, kind), times));
        told.map(|(error, times)| Warning { error, times }).collect()
    }

    pub fn step(&mut self, task: &Task<'g>) -> Step {
        self.count(task)?;
        let graph = self.graph;
        match graph.op(task.node) {
            Op::Nil => Ok(()),
            Op::Primitive { name, material, options } => {
                self.primitive(task, name, material.as_ref(), options)
            }
            Op::All => {
                self.all(task);
                Ok(())
            }
            Op::Split { axis, snap, groups } => self.split(task, axis, snap.as_ref(), groups),
            Op::Repeat { axis, size, snap } => self.repeat_in_sections(task, axis, size, snap.as_ref()),
            Op::RepeatN { axis, count } => {
                let (axis, count) = self.so_often(task, axis, count)?;
                self.repeat(task, axis, &[(0, task.scope().len(axis), count)])
            }
            Op::Translate(delta) => {
                let delta = self.lengths(task, delta)?;
                self.moved(task, delta)
            }
            Op::Resize(size) => {
                let size = self.lengths(task, size)?;
                self.only(task, task.site.scope.resized(size.max(Cell::ZERO)))
            }
            Op::Rotate { axis, angle } => {
                let turn = self.turn(task, axis, angle)?;
                self.only(task, task.site.scope.turned(turn))
            }
            Op::Carve { how, args } => self.carve(task, *how, args),
            Op::Local => self.around(task, Around { local: task.place, ..(*task.around).clone() }),
            Op::Same(key) => self.same(task, key),
            Op::Style(style) => self.around(task, Around { style: style + 1, ..(*task.around).clone() }),
            Op::Snap { axis, label } => self.mark(task, axis, label.as_deref()),
            Op::Shape(_) => self.only(task, *task.scope()),
            Op::Choose => self.choose(task),
            Op::Call(args) => self.call(task, args),
        }
    }

    /// Counts a step against the limits.
    pub fn count(&mut self, task: &Task<'g>) -> Step {
        let limits = self.options.limits;
        self.work(1)?;
        if task.depth > limits.depth { Err(Kind::TooDeep(limits.depth)) } else { Ok(()) }
    }

    fn work(&mut self, steps: u64) -> Step {
        let limit = self.options.limits.steps;
        self.steps = self.steps.saturating_add(steps);
        if self.steps > limit { Err(Kind::TooManySteps(limit)) } else { Ok(()) }
    }

    fn env<'t>(&'t self, task: &'t Task<'g>) -> Env<'t, 'g> {
        Env::new(&self.world, &task.around, Some(&task.site), task.place).knowing(self.known.as_ref())
    }

    /// Children without a block are skipped, but those of a scope that was carved flat: `S` may give it depth.
    fn push(&mut self, parent: &Task<'g>, task: Task<'g>) {
        if !task.scope().is_empty() || parent.scope().is_empty() {
            self.stack.push(task);
        }
    }

    /// Runs the only child with other surroundings.
    fn around(&mut self, task: &Task<'g>, around: Around<'g>) -> Step {
        let graph = self.graph;
        let around = Rc::new(around);
        for (_, child) in graph.children(task.node) {
            self.push(task, Task { around: around.clone(), ..task.child(0, child, *task.scope()) });
        }
        Ok(())
    }

    /// Runs the only child as if it stood at the place of a key.
    fn same(&mut self, task: &Task<'g>, key: &'g Expr) -> Step {
        let graph = self.graph;
        let place = self.env(task).keyed(key)?;
        for (_, child) in graph.children(task.node) {
            self.push(task, Task { place, ..task.child(0, child, *task.scope()) });
        }
        Ok(())
    }

    /// Runs every child in the same scope.
    fn all(&mut self, task: &Task<'g>) {
        let graph = self.graph;
        let first = self.stack.len();
        for (number, (_, child)) in graph.children(task.node).enumerate() {
            self.push(task, task.child(number, child, *task.scope()));
        }
        self.stack[first..].reverse();
    }

    fn warn(&mut self, node: NodeIndex, kind: Kind) {
        self.warnings.entry(node).or_insert((kind, 0)).1 += 1;
    }
}
