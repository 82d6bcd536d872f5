//! The derivation: operations run on scopes until only primitives are left (seed 1, section 4.1).

use super::body::Body;
use super::carve::{Part, carve};
use super::context::{sections, snapped};
use super::error::{Kind, RunError, Warning};
use super::eval::{Around, Env, Site, Things, Value, World};
use super::known::Known;
use super::place::Place;
use super::rhythm::written_out;
use super::rounds::{needs_rounds, rounds};
use super::start::weighted;
use super::trail::{Observer, Step as Taken, Trail};
use super::{Options, Overrun};
use crate::grammar::ast::{Carving, SizeKind, Snap};
use crate::graph::{Alternative, Arg, Expr, Group, NodeIndex, Op, OpGraph, Size, Thing};
use crate::space::{Axis, Bounds, Cell, Footprint, Length, Misfit, Scope, Spot, Turn, clip, fit, shares};
use glam::Vec3Swizzles;
use smallvec::SmallVec;
use std::collections::BTreeMap;
use std::rc::Rc;

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

/// An operation that is still to run, and where.
#[derive(Clone)]
pub struct Task<'g> {
    pub node: NodeIndex,
    site: Site,
    around: Rc<Around<'g>>,
    place: Place,
    depth: u32,
    /// Which child of the operation before it this is, and the operations that led here, if they are observed.
    number: u32,
    pub trail: Trail,
}

impl<'g> Task<'g> {
    pub fn scope(&self) -> &Scope {
        &self.site.scope
    }

    /// The scope and what of its plan is there, if anything is.
    pub fn body(&self) -> Option<Body> {
        Body::within(self.site.scope, self.around.footprint.as_ref())
    }

    /// The same within `bounds`, if there are blocks.
    pub fn body_within(&self, bounds: Bounds) -> Option<Body> {
        let scope = Scope { bounds: self.site.scope.bounds.intersect(&bounds), ..self.site.scope };
        Body::within(scope, self.around.footprint.as_ref()).filter(|body| !body.scope.is_empty())
    }

    pub fn no_rule(&self) -> Kind {
        Kind::NoRule { scope: Axis::ALL.map(|axis| self.scope().len(axis)).into() }
    }

    /// The task of the child of that number, in `scope`.
    fn child(&self, number: usize, node: NodeIndex, scope: Scope) -> Task<'g> {
        Task {
            node,
            site: Site { scope, ..self.site },
            around: self.around.clone(),
            place: self.place.child(number),
            depth: self.depth + 1,
            number: number as u32,
            trail: self.trail.clone(),
        }
    }

    /// As [`Task::child`], for one of the shares of a split.
    fn share(&self, number: usize, total: usize, node: NodeIndex, scope: Scope) -> Task<'g> {
        let site = Site { scope, index: number as u32, total: total as u32 };
        Task { site, ..self.child(number, node, scope) }
    }
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

    /// Marks the planes that bound the scope along an axis.
    fn mark(&mut self, task: &Task<'g>, axis: &'g Expr, label: Option<&str>) -> Step {
        let axis = self.env(task).axis(axis)?;
        if let Some(known) = &mut self.known {
            known.mark(task.around.local, label, task.scope(), axis);
        }
        Ok(())
    }

    /// The planes that a split or a repeat keeps to, counted from the low end of its scope.
    fn planes(&self, task: &Task<'g>, snap: Option<&Snap>, axis: Axis) -> Vec<i32> {
        match (&self.known, snap) {
            (Some(known), Some(snap)) => {
                known.planes(task.around.local, snap.label.as_deref(), task.scope(), axis)
            }
            _ => Vec::new(),
        }
    }

    fn warn(&mut self, node: NodeIndex, kind: Kind) {
        self.warnings.entry(node).or_insert((kind, 0)).1 += 1;
    }

    fn primitive(
        &mut self,
        task: &Task<'g>,
        name: &'g Expr,
        material: Option<&'g Expr>,
        options: &'g [(String, Expr)],
    ) -> Step {
        let mut env = self.env(task);
        let name = env.thing(name)?;
        let material = material.map(|material| env.thing(material)).transpose()?;
        let mut values = SmallVec::new();
        for (option, value) in options {
            values.push((option.as_str(), env.value(value)?));
        }
        let scope = self.inside(task)?;
        let body = Body::within(scope, task.around.footprint.as_ref()).filter(|body| !body.scope.is_empty());
        let Some(Body { scope, footprint }) = body else { return Ok(()) };
        let placement =
            Placement { name, material, options: values, scope, footprint, trail: task.trail.clone() };
        match self.known {
            None => self.hand_on(task.node, placement),
            Some(_) => {
                self.placed = Some(placement);
                Ok(())
            }
        }
    }

    /// Hands a primitive on. A door without room is a warning: the rest of the building still stands.
    pub fn hand_on(&mut self, node: NodeIndex, placement: Placement<'g>) -> Step {
        match (self.sink)(placement) {
            Err(kind @ Kind::NoRoomForDoor) => {
                self.warn(node, kind);
                Ok(())
            }
            result => result,
        }
    }

    /// The part of a primitive's scope that lies inside the start scope. What leaves it is told only here:
    /// `T` may move a scope out that `S` then makes small enough.
    fn inside(&mut self, task: &Task<'g>) -> Result<Scope, Kind> {
        let bounds = task.site.scope.bounds.intersect(&self.plot);
        if bounds != task.site.scope.bounds {
            match self.options.overrun {
                Overrun::Refuse => return Err(Kind::OutsidePlot),
                Overrun::Clip => self.warn(task.node, Kind::OutsidePlot),
            }
        }
        Ok(Scope { bounds, ..task.site.scope })
    }

    /// Runs the only child in the scope moved along its axes, and what is there of it moved with it.
    fn moved(&mut self, task: &Task<'g>, delta: Cell) -> Step {
        let scope = within_reach(task.scope().moved(delta))?;
        let shift = scope.bounds.min.xz() - task.scope().bounds.min.xz();
        match &task.around.footprint {
            Some(footprint) if shift != Spot::ZERO => {
                let footprint = Some(Rc::new(footprint.moved(shift)));
                let task = Task { site: Site { scope, ..task.site }, ..task.clone() };
                self.around(&task, Around { footprint, ..(*task.around).clone() })
            }
            _ => self.only(task, scope),
        }
    }

    /// Runs the only child in `scope`.
    fn only(&mut self, task: &Task<'g>, scope: Scope) -> Step {
        let scope = within_reach(scope)?;
        let graph = self.graph;
        for (_, child) in graph.children(task.node) {
            self.push(task, task.child(0, child, scope));
        }
        Ok(())
    }

    fn split(&mut self, task: &Task<'g>, axis: &'g Expr, snap: Option<&Snap>, groups: &'g [Group]) -> Step {
        let axis = self.env(task).axis(axis)?;
        let total = task.site.scope.len(axis);
        let (mut lengths, mut children) = self.parts(task, total)?;
        if !groups.is_empty() {
            let order = written_out(&lengths, groups, total)?;
            lengths = order.iter().map(|at| lengths[*at]).collect();
            children = order.iter().map(|at| children[*at]).collect();
        }
        let bounds = self.fitted(task, axis, total, &lengths)?;
        let bounds = self.snapped(task, snap, axis, bounds)?;
        let count = children.len();
        for (number, child) in children.into_iter().enumerate().rev() {
            if bounds[number] < bounds[number + 1] {
                let part = task.site.scope.part(axis, bounds[number], bounds[number + 1]);
                self.push(task, task.share(number, count, child, part));
            }
        }
        Ok(())
    }

    fn snapped(
        &mut self,
        task: &Task<'g>,
        snap: Option<&Snap>,
        axis: Axis,
        bounds: Vec<i32>,
    ) -> Result<Vec<i32>, Kind> {
        let planes = self.planes(task, snap, axis);
        self.work((planes.len() as u64).saturating_mul(bounds.len() as u64))?;
        Ok(if planes.is_empty() { bounds } else { snapped(&bounds, &planes) })
    }

    /// The lengths and the children of a split, as they are written.
    fn parts(&self, task: &Task<'g>, total: i32) -> Result<(Few<Length>, Few<NodeIndex>), Kind> {
        let mut env = self.env(task);
        let (mut lengths, mut children) = (Few::new(), Few::new());
        for (arg, child) in self.graph.children(task.node) {
            if let Arg::Size(size) = arg {
                lengths.push(length(size, total, &mut env)?);
                children.push(child);
            }
        }
        Ok((lengths, children))
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

    /// Repeats a size in each section that the snap planes leave, all of the scope where there are none; in each as
    /// often as it fits, rounded up (seed 1, section 4.3.4).
    fn repeat_in_sections(
        &mut self,
        task: &Task<'g>,
        axis: &'g Expr,
        size: &'g Expr,
        snap: Option<&Snap>,
    ) -> Step {
        let mut env = self.env(task);
        let (axis, size) = (env.axis(axis)?, env.number(size)?);
        if size <= 0.0 {
            return Err(Kind::Step { what: "size", value: size });
        }
        let fits = |(low, high)| (low, high, (f64::from(high - low) / size - NOISE).ceil().max(1.0));
        let sections = sections(task.scope().len(axis), &self.planes(task, snap, axis)).into_iter().map(fits);
        self.repeat(task, axis, &sections.collect::<Few<_>>())
    }

    fn so_often(&self, task: &Task<'g>, axis: &'g Expr, count: &'g Expr) -> Result<(Axis, f64), Kind> {
        let mut env = self.env(task);
        let (axis, count) = (env.axis(axis)?, env.number(count)?.round());
        match count >= 0.0 {
            true => Ok((axis, count)),
            false => Err(Kind::Step { what: "count", value: count }),
        }
    }

    fn turn(&self, task: &Task<'g>, axis: &'g Expr, angle: &'g Expr) -> Result<Turn, Kind> {
        let mut env = self.env(task);
        let (axis, angle) = (env.axis(axis)?, env.number(angle)?);
        match axis == self.graph.up.axis() {
            true => quarter_turns(angle),
            false => Err(Kind::NotVertical { up: self.graph.up.to_string() }),
        }
    }

    /// Divides sections of the scope, from one place to another, so often each.
    fn repeat(&mut self, task: &Task<'g>, axis: Axis, sections: &[(i32, i32, f64)]) -> Step {
        let graph = self.graph;
        let first = self.stack.len();
        let total: f64 = sections.iter().map(|(_, _, count)| count).sum();
        let mut number = 0;
        for &(from, to, count) in sections {
            self.make_room(to - from, count)?;
            for (_, child) in graph.children(task.node) {
                for (at, (low, high)) in
                    shares(to - from, count as u32).enumerate().filter(|(_, (low, high))| low < high)
                {
                    let part = task.scope().part(axis, from + low, from + high);
                    self.push(task, task.share(number + at, total as usize, child, part));
                }
            }
            number += count as usize;
        }
        self.stack[first..].reverse();
        Ok(())
    }

    /// Counts the shares of a length against the limits.
    fn make_room(&mut self, length: i32, count: f64) -> Step {
        if count > self.options.limits.steps as f64 {
            return Err(Kind::TooManySteps(self.options.limits.steps));
        }
        // Shares of no length are work as well.
        self.steps += (count - f64::from(length)).max(0.0) as u64;
        if self.stack.len() as f64 + count.min(f64::from(length)) > MOST_OPEN {
            return Err(Kind::TooWide(MOST_OPEN as u64));
        }
        Ok(())
    }

    /// Three lengths of an operation, rounded to whole blocks.
    fn lengths(&self, task: &Task<'g>, sizes: &'g [Size; 3]) -> Result<Cell, Kind> {
        let mut env = self.env(task);
        let mut lengths = Cell::ZERO;
        for (axis, size) in Axis::ALL.into_iter().zip(sizes) {
            let (Length::Absolute(size) | Length::Floating(size)) =
                length(size, task.site.scope.len(axis), &mut env)?;
            lengths[axis.index()] = (size + 0.5).floor().clamp(-f64::from(FAR), f64::from(FAR)) as i32;
        }
        Ok(lengths)
    }

    fn carve(&mut self, task: &Task<'g>, how: Carving, args: &'g [Expr]) -> Step {
        let lengths = self.widths(task, how, args)?;
        let Some(body) = task.body() else { return Ok(()) };
        let parts = self.graph.children(task.node).filter_map(|(arg, child)| match arg {
            Arg::Part(selector) => Some((selector, child)),
            _ => None,
        });
        let carved = carve(how, &lengths, &body, &parts.collect::<Few<_>>());
        for Part { number, child, body } in carved.into_iter().rev() {
            let Body { scope, footprint } = body;
            let part = task.child(number, child, scope);
            let around = match footprint.is_some() || task.around.footprint.is_some() {
                true => Rc::new(Around { footprint, ..(*task.around).clone() }),
                false => task.around.clone(),
            };
            self.stack.push(Task { around, ..part });
        }
        Ok(())
    }

    /// The lengths that a carving takes, rounded to whole blocks.
    fn widths(&self, task: &Task<'g>, how: Carving, args: &'g [Expr]) -> Result<Few<i32>, Kind> {
        let mut env = self.env(task);
        let mut widths = Few::new();
        for arg in args {
            let width = (env.number(arg)? + 0.5).floor();
            if width < 0.0 {
                return Err(Kind::Width { how, width });
            }
            widths.push(width.min(f64::from(FAR)) as i32);
        }
        Ok(widths)
    }

    /// Tries the rules of a label level by level.
    fn choose(&mut self, task: &Task<'g>) -> Step {
        let mut level = self.next_level(task.node, None);
        while let Some(at) = level {
            if self.choose_at(task, at)? {
                return Ok(());
            }
            level = self.next_level(task.node, level);
        }
        Err(task.no_rule())
    }

    /// The first priority that a rule of a label has, after one.
    pub fn next_level(&self, node: NodeIndex, after: Option<u32>) -> Option<u32> {
        let levels = self.alternatives(node).map(|(_, alternative, _)| alternative.priority);
        levels.filter(|at| Some(*at) > after).min()
    }

    fn alternatives(
        &self,
        node: NodeIndex,
    ) -> impl Iterator<Item = (usize, &'g Alternative, NodeIndex)> + use<'g> {
        let children = self.graph.children(node).enumerate();
        children.filter_map(|(number, (arg, child))| match arg {
            Arg::Alternative(alternative) => Some((number, alternative, child)),
            _ => None,
        })
    }

    /// Draws one of the rules of that priority whose conditions hold, if any does.
    pub fn choose_at(&mut self, task: &Task<'g>, level: u32) -> Result<bool, Kind> {
        let mut env = self.env(task);
        let (mut weights, mut open) = (Few::new(), Few::new());
        for (number, alternative, child) in self.alternatives(task.node) {
            if alternative.priority == level
                && alternative.condition.as_ref().map_or(Ok(true), |condition| env.truth(condition))?
            {
                weights.push(env.number(&alternative.weight)?);
                open.push((number, child));
            }
        }
        if open.is_empty() {
            return Ok(false);
        }
        let draw = if open.len() > 1 { env.draw() } else { 0.0 };
        let (number, child) = open[weighted(&weights, draw)?];
        self.push(task, task.child(number, child, *task.scope()));
        Ok(true)
    }

    fn call(&mut self, task: &Task<'g>, args: &'g [Expr]) -> Step {
        let mut env = self.env(task);
        let mut params = Few::new();
        for arg in args {
            params.push(env.value(arg)?);
        }
        self.around(task, Around { params: Rc::from(params.as_slice()), ..(*task.around).clone() })
    }
}

/// A scope whose coordinates can be reckoned with.
fn within_reach(scope: Scope) -> Result<Scope, Kind> {
    let Bounds { min, max } = scope.bounds;
    match min.min_element() < -FAR || max.max_element() > FAR {
        true => Err(Kind::OutsidePlot),
        false => Ok(scope),
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
    let near = |quarters: f64| (quarters - quarters.round()).abs() < NOISE;
    let radians = angle / std::f64::consts::FRAC_PI_2;
    let degrees = angle / 90.0;
    let quarters =
        [radians, degrees].into_iter().find(|quarters| near(*quarters)).ok_or(Kind::Angle(angle))?;
    Ok(Turn::quarters(quarters.round().rem_euclid(4.0) as i32))
}
