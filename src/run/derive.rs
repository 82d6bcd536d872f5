//! The derivation: operations run on scopes until only primitives are left (seed 1, section 4.1).

use super::error::{Kind, RunError, Warning};
use super::eval::{Env, Value};
use super::place::Place;
use super::rhythm::written_out;
use super::start::weighted;
use super::{Options, Overrun};
use crate::grammar::ast::{Face, SizeKind};
use crate::graph::{Arg, Expr, Group, NodeIndex, Op, OpGraph, Size, Thing};
use crate::space::{Axis, Bounds, Cell, Length, Misfit, Scope, Turn, Up, clip, fit, shares};
use std::collections::BTreeMap;
use std::rc::Rc;

/// A primitive and the scope it fills.
#[derive(Clone, Copy, Debug)]
pub struct Placement<'g> {
    pub name: &'g Thing,
    pub material: Option<&'g Thing>,
    pub scope: Scope,
}

/// How far from the origin a scope may reach, in blocks: twice as far is still a coordinate.
const FAR: i32 = 1 << 29;

/// Takes each placement; a warning it gives back goes with those of the derivation.
pub type Sink<'s, 'g> = dyn FnMut(Placement<'g>) -> Result<(), Kind> + 's;

/// Derives `graph` on `start` and hands every primitive to `sink`, in the order of the text: where scopes
/// overlap, later ones overwrite earlier ones. Scopes of no volume are skipped.
pub fn derive<'g>(
    graph: &'g OpGraph,
    start: Scope,
    options: &Options,
    sink: &mut Sink<'_, 'g>,
) -> Result<Vec<Warning>, RunError> {
    let constants = constants(graph, options.seed).map_err(RunError::anywhere)?;
    let root = Task {
        node: graph.root(),
        scope: start,
        params: Rc::from([]),
        place: Place::start(options.seed),
        depth: 0,
    };
    let plot = start.bounds;
    let mut derivation = Derivation {
        graph,
        constants,
        options,
        plot,
        sink,
        stack: vec![root],
        steps: 0,
        warnings: BTreeMap::new(),
    };
    while let Some(task) = derivation.stack.pop() {
        let node = task.node;
        derivation.step(task).map_err(|kind| RunError::at(graph, node, kind))?;
    }
    let told = derivation.warnings.into_iter();
    Ok(told.map(|(node, (kind, times))| Warning { error: RunError::at(graph, node, kind), times }).collect())
}

/// The values of the constants, each drawn from a stream of its own name.
pub fn constants(graph: &OpGraph, seed: u64) -> Result<Vec<Value<'_>>, Kind> {
    let mut values = Vec::with_capacity(graph.constants.len());
    for (name, value) in &graph.constants {
        let place = Place::start(seed).named(name);
        let value = Env::new(&values, &[], None, place).value(value)?;
        values.push(value);
    }
    Ok(values)
}

/// An operation that is still to run, and where.
struct Task<'g> {
    node: NodeIndex,
    scope: Scope,
    params: Rc<[Value<'g>]>,
    place: Place,
    depth: u32,
}

impl<'g> Task<'g> {
    /// The task of the child of that number, in `scope`.
    fn child(&self, number: usize, node: NodeIndex, scope: Scope) -> Task<'g> {
        Task {
            node,
            scope,
            params: self.params.clone(),
            place: self.place.child(number),
            depth: self.depth + 1,
        }
    }
}

struct Derivation<'a, 's, 'g> {
    graph: &'g OpGraph,
    constants: Vec<Value<'g>>,
    options: &'a Options,
    plot: Bounds,
    sink: &'a mut Sink<'s, 'g>,
    /// The last task is the next to run: children are pushed in reverse.
    stack: Vec<Task<'g>>,
    steps: u64,
    warnings: BTreeMap<NodeIndex, (Kind, u64)>,
}

type Step = Result<(), Kind>;

impl<'g> Derivation<'_, '_, 'g> {
    fn step(&mut self, task: Task<'g>) -> Step {
        let limits = self.options.limits;
        self.steps += 1;
        if task.depth > limits.depth {
            return Err(Kind::TooDeep(limits.depth));
        }
        if self.steps > limits.steps {
            return Err(Kind::TooManySteps(limits.steps));
        }
        let graph = self.graph;
        match graph.op(task.node) {
            Op::Nil => Ok(()),
            Op::Primitive { name, material } => {
                let mut env = self.env(&task);
                let name = env.thing(name)?;
                let material = material.as_ref().map(|material| env.thing(material)).transpose()?;
                self.primitive(&task, name, material)
            }
            Op::Split { axis, groups } => {
                let axis = self.env(&task).axis(axis)?;
                self.split(&task, axis, groups)
            }
            Op::Repeat { axis, size } => {
                let mut env = self.env(&task);
                let (axis, size) = (env.axis(axis)?, env.number(size)?);
                if size <= 0.0 {
                    return Err(Kind::Step { what: "size", value: size });
                }
                self.repeat(&task, axis, (f64::from(task.scope.len(axis)) / size - 1e-6).ceil())
            }
            Op::RepeatN { axis, count } => {
                let mut env = self.env(&task);
                let (axis, count) = (env.axis(axis)?, env.number(count)?.round());
                if count < 0.0 {
                    return Err(Kind::Step { what: "count", value: count });
                }
                self.repeat(&task, axis, count)
            }
            Op::Translate(delta) => {
                let delta = self.lengths(&task, delta)?;
                let scope = task.scope.moved(delta);
                self.only(&task, scope)
            }
            Op::Resize(size) => {
                let size = self.lengths(&task, size)?;
                let scope = task.scope.resized(size.max(Cell::ZERO));
                self.only(&task, scope)
            }
            Op::Rotate { axis, angle } => {
                let mut env = self.env(&task);
                let (axis, angle) = (env.axis(axis)?, env.number(angle)?);
                if axis != graph.up.axis() {
                    return Err(Kind::NotVertical { up: graph.up.to_string() });
                }
                let scope = task.scope.turned(quarter_turns(angle)?);
                self.only(&task, scope)
            }
            Op::Comp => self.comp(&task),
            Op::Choose => self.choose(task),
            Op::Call(args) => self.call(task, args),
        }
    }

    fn env<'t>(&'t self, task: &'t Task<'g>) -> Env<'t, 'g> {
        Env::new(&self.constants, &task.params, Some(&task.scope), task.place)
    }

    fn push(&mut self, task: Task<'g>) {
        if !task.scope.is_empty() {
            self.stack.push(task);
        }
    }

    fn warn(&mut self, node: NodeIndex, kind: Kind) {
        self.warnings.entry(node).or_insert((kind, 0)).1 += 1;
    }

    /// Hands a primitive on. A door without room is a warning: the rest of the building still stands.
    fn primitive(&mut self, task: &Task<'g>, name: &'g Thing, material: Option<&'g Thing>) -> Step {
        let scope = self.inside(task)?;
        if scope.is_empty() {
            return Ok(());
        }
        match (self.sink)(Placement { name, material, scope }) {
            Err(kind @ Kind::NoRoomForDoor) => {
                self.warn(task.node, kind);
                Ok(())
            }
            result => result,
        }
    }

    /// The part of a primitive's scope that lies inside the start scope. What leaves it is told only here:
    /// `T` may move a scope out that `S` then makes small enough.
    fn inside(&mut self, task: &Task<'g>) -> Result<Scope, Kind> {
        let bounds = task.scope.bounds.intersect(&self.plot);
        if bounds != task.scope.bounds {
            match self.options.overrun {
                Overrun::Refuse => return Err(Kind::OutsidePlot),
                Overrun::Clip => self.warn(task.node, Kind::OutsidePlot),
            }
        }
        Ok(Scope { bounds, ..task.scope })
    }

    /// Runs the only child in `scope`.
    fn only(&mut self, task: &Task<'g>, scope: Scope) -> Step {
        if scope.bounds.min.min_element() < -FAR || scope.bounds.max.max_element() > FAR {
            return Err(Kind::OutsidePlot);
        }
        let graph = self.graph;
        for (_, child) in graph.children(task.node) {
            self.push(task.child(0, child, scope));
        }
        Ok(())
    }

    fn split(&mut self, task: &Task<'g>, axis: Axis, groups: &'g [Group]) -> Step {
        let total = task.scope.len(axis);
        let graph = self.graph;
        let mut children = Vec::new();
        let mut lengths = Vec::new();
        let mut env = Env::new(&self.constants, &task.params, Some(&task.scope), task.place);
        for (arg, child) in graph.children(task.node) {
            if let Arg::Size(size) = arg {
                lengths.push(length(size, total, &mut env)?);
                children.push(child);
            }
        }
        if !groups.is_empty() {
            let order = written_out(&lengths, groups, total)?;
            lengths = order.iter().map(|at| lengths[*at]).collect();
            children = order.iter().map(|at| children[*at]).collect();
        }
        let bounds = self.fitted(task, axis, total, &lengths)?;
        for (number, child) in children.into_iter().enumerate().rev() {
            let part = task.scope.part(axis, bounds[number], bounds[number + 1]);
            self.push(task.child(number, child, part));
        }
        Ok(())
    }

    fn fitted(
        &mut self,
        task: &Task<'g>,
        axis: Axis,
        total: i32,
        lengths: &[Length],
    ) -> Result<Vec<i32>, Kind> {
        fit(total, lengths).or_else(|misfit| {
            let kind = Kind::Misfit { misfit, axis: axis.to_string() };
            match (self.options.overrun, misfit) {
                (Overrun::Refuse, _) | (_, Misfit::Negative { .. }) => Err(kind),
                (Overrun::Clip, _) => {
                    self.warn(task.node, kind);
                    Ok(clip(total, lengths))
                }
            }
        })
    }

    fn repeat(&mut self, task: &Task<'g>, axis: Axis, count: f64) -> Step {
        let graph = self.graph;
        let total = task.scope.len(axis);
        if count > self.options.limits.steps as f64 {
            return Err(Kind::TooManySteps(self.options.limits.steps));
        }
        // Shares of no length are work as well.
        self.steps += (count - f64::from(total)).max(0.0) as u64;
        let first = self.stack.len();
        for (_, child) in graph.children(task.node) {
            for (number, (low, high)) in
                shares(total, count as u32).enumerate().filter(|(_, (low, high))| low < high)
            {
                let part = task.scope.part(axis, low, high);
                self.push(task.child(number, child, part));
            }
        }
        self.stack[first..].reverse();
        Ok(())
    }

    /// Three lengths of an operation, rounded to whole blocks.
    fn lengths(&self, task: &Task<'g>, sizes: &'g [Size; 3]) -> Result<Cell, Kind> {
        let mut env = self.env(task);
        let mut lengths = Cell::ZERO;
        for (axis, size) in Axis::ALL.into_iter().zip(sizes) {
            let (Length::Absolute(size) | Length::Floating(size)) =
                length(size, task.scope.len(axis), &mut env)?;
            lengths[axis.index()] = (size + 0.5).floor().clamp(-f64::from(FAR), f64::from(FAR)) as i32;
        }
        Ok(lengths)
    }

    /// The faces of the scope's shell, one block thick. A cell that lies on several of the named faces
    /// belongs to the first of top, bottom, front, back, left and right.
    fn comp(&mut self, task: &Task<'g>) -> Step {
        let graph = self.graph;
        let parts: Vec<(Face, NodeIndex)> = graph
            .children(task.node)
            .filter_map(|(arg, child)| match arg {
                Arg::Face(face) => Some((*face, child)),
                _ => None,
            })
            .collect();
        let mut rest = task.scope;
        let mut tasks = Vec::new();
        for (number, face) in [Face::Top, Face::Bottom, Face::Front, Face::Back, Face::Left, Face::Right]
            .into_iter()
            .enumerate()
        {
            if let Some(child) = named_face(&parts, face)
                && !rest.is_empty()
            {
                let (shell, inner) = peel(&rest, face);
                tasks.push(task.child(number, child, shell));
                rest = inner;
            }
        }
        tasks.into_iter().rev().for_each(|task| self.push(task));
        Ok(())
    }

    fn choose(&mut self, task: Task<'g>) -> Step {
        let graph = self.graph;
        let mut env = self.env(&task);
        let mut weights = Vec::new();
        let mut open = Vec::new();
        for (number, (arg, child)) in graph.children(task.node).enumerate() {
            let Arg::Alternative(alternative) = arg else { continue };
            if alternative.condition.as_ref().map_or(Ok(true), |condition| env.truth(condition))? {
                weights.push(env.number(&alternative.weight)?);
                open.push((number, child));
            }
        }
        let chosen = match open.as_slice() {
            [] => return Err(Kind::NoRule { scope: Axis::ALL.map(|axis| task.scope.len(axis)).into() }),
            [only] => *only,
            _ => open[weighted(&weights, env.draw())?],
        };
        let scope = task.scope;
        self.push(task.child(chosen.0, chosen.1, scope));
        Ok(())
    }

    fn call(&mut self, task: Task<'g>, args: &'g [Expr]) -> Step {
        let graph = self.graph;
        let mut env = self.env(&task);
        let mut params = Vec::with_capacity(args.len());
        for arg in args {
            params.push(env.value(arg)?);
        }
        let params: Rc<[Value<'g>]> = params.into();
        for (_, child) in graph.children(task.node) {
            self.push(Task { params: params.clone(), ..task.child(0, child, task.scope) });
        }
        Ok(())
    }
}

fn length<'g>(size: &'g Size, total: i32, env: &mut Env<'_, 'g>) -> Result<Length, Kind> {
    let value = env.number(&size.value)?;
    Ok(match size.kind {
        SizeKind::Absolute => Length::Absolute(value),
        SizeKind::Floating => Length::Floating(value),
        SizeKind::Relative => Length::Absolute(value * f64::from(total)),
    })
}

/// A multiple of a quarter turn in radians, or of 90 in degrees: no number but 0 is both.
fn quarter_turns(angle: f64) -> Result<Turn, Kind> {
    let near = |quarters: f64| (quarters - quarters.round()).abs() < 1e-6;
    let radians = angle / std::f64::consts::FRAC_PI_2;
    let degrees = angle / 90.0;
    let quarters =
        [radians, degrees].into_iter().find(|quarters| near(*quarters)).ok_or(Kind::Angle(angle))?;
    Ok(Turn::quarters(quarters.round().rem_euclid(4.0) as i32))
}

/// The operation for a face: the one that names it, else that for all sides, else that for all faces.
fn named_face(parts: &[(Face, NodeIndex)], face: Face) -> Option<NodeIndex> {
    let is_upright = !matches!(face, Face::Top | Face::Bottom);
    let names = [Some(face), is_upright.then_some(Face::Side), Some(Face::All)];
    let mut found =
        names.into_iter().flatten().filter_map(|name| parts.iter().find(|(known, _)| *known == name));
    found.next().map(|(_, child)| *child)
}

/// The slab of a face, with its own axes (x along the face from left to right as seen from outside), and
/// what is left of the scope.
fn peel(scope: &Scope, face: Face) -> (Scope, Scope) {
    // The front is where the plan's second direction comes from: the high end of z, or the low end of y.
    let (depth, front_is_low) = match scope.frame.up {
        Up::Y => (Axis::Z, false),
        Up::Z => (Axis::Y, true),
    };
    let up = scope.frame.up.axis();
    let (axis, is_low, turn) = match face {
        Face::Top => (up, false, 0),
        Face::Bottom => (up, true, 0),
        Face::Back => (depth, !front_is_low, 2),
        Face::Left => (Axis::X, true, 3),
        Face::Right => (Axis::X, false, 1),
        Face::Front | Face::Side | Face::All => (depth, front_is_low, 0),
    };
    let length = scope.len(axis);
    let (shell, rest) = match is_low {
        true => (scope.part(axis, 0, 1), scope.part(axis, 1, length)),
        false => (scope.part(axis, length - 1, length), scope.part(axis, 0, length - 1)),
    };
    (shell.turned(Turn::quarters(turn)), rest)
}
