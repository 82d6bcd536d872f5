//! What a derivation knows of its shapes while rules ask of them.

use super::body::Body;
use super::context::{Against, Asker, Configuration, Label, Occlusion, Planes, Region, ShapeId};
use super::place::Place;
use crate::grammar::ast;
use crate::graph::{Op, OpGraph};
use crate::space::{Axis, Bounds, Scope};
use std::collections::BTreeMap;

/// How far a distance reaches at the most: farther than any scope lies.
const FAR: f64 = (1 << 30) as f64;

/// The shapes and planes so far. Answers are those of the last round, whatever has come since.
pub struct Known<'g> {
    configuration: Configuration,
    replaced: Vec<ShapeId>,
    planes: Planes,
    marked: Vec<(Region, Option<Label>, Axis, i32)>,
    labels: BTreeMap<&'g str, Label>,
    /// The shape whose operation is being stepped.
    pub asker: Option<ShapeId>,
}

impl<'g> Known<'g> {
    pub fn new(graph: &'g OpGraph) -> Known<'g> {
        let mut labels = BTreeMap::new();
        for node in graph.nodes() {
            if let Op::Shape(label) | Op::Snap { label: Some(label), .. } = graph.op(node) {
                let next = Label(labels.len() as u32);
                labels.entry(label.as_str()).or_insert(next);
            }
        }
        Known {
            configuration: Configuration::default(),
            replaced: Vec::new(),
            planes: Planes::default(),
            marked: Vec::new(),
            labels,
            asker: None,
        }
    }

    pub fn add(&mut self, parent: Option<ShapeId>, label: Option<&str>, body: &Body) -> ShapeId {
        let label = label.and_then(|label| self.labels.get(label).copied());
        self.configuration.add(parent, label, body.boxes())
    }

    pub fn replace(&mut self, shape: ShapeId) {
        self.replaced.push(shape);
    }

    /// Marks the planes that bound a scope along one of its axes.
    pub fn mark(&mut self, local: Place, label: Option<&str>, scope: &Scope, axis: Axis) {
        let label = label.and_then(|label| self.labels.get(label).copied());
        let world = scope.frame.world_axis(axis);
        for at in [world.of(scope.bounds.min), world.of(scope.bounds.max)] {
            self.marked.push((region(local), label, world, at));
        }
    }

    /// Makes what came in the last round known to those who ask in the next.
    pub fn settle(&mut self) {
        self.replaced.drain(..).for_each(|shape| self.configuration.replace(shape));
        for (region, label, axis, at) in self.marked.drain(..) {
            self.planes.mark(region, label, axis, at);
        }
    }

    /// Makes all shapes so far ready to be found.
    pub fn refresh(&mut self) {
        self.configuration.refresh();
    }

    /// The planes that cut a scope along one of its axes, counted from its low end and in order.
    pub fn planes(&self, local: Place, label: Option<&str>, scope: &Scope, axis: Axis) -> Vec<i32> {
        let label = match label.map(|label| self.labels.get(label)) {
            Some(None) => return Vec::new(),
            Some(Some(label)) => Some(*label),
            None => None,
        };
        let world = scope.frame.world_axis(axis);
        let (low, high) = (world.of(scope.bounds.min), world.of(scope.bounds.max));
        let found = self.planes.between(region(local), label, world, low, high);
        match world.of(scope.frame.direction(axis)) > 0 {
            true => found.map(|at| at - low).collect(),
            false => found.map(|at| high - at).rev().collect(),
        }
    }

    /// How much of a scope others cover: 0, 1 or 2 for none, part and full. A flat scope asks for the layer that `S` would
    /// give it, which lies before the face that it was carved from.
    pub fn occlusion(&self, body: &Body, against: &ast::Against, distance: f64) -> f64 {
        let Some(against) = self.against(against) else { return 0.0 };
        let flat = Axis::ALL.into_iter().filter(|axis| body.scope.len(*axis) == 0);
        let layer = flat.fold(body.scope, |scope, axis| scope.part(axis, 0, 1));
        let boxes = Body { scope: layer, ..body.clone() }.boxes();
        let distance = (distance + 0.5).floor().clamp(0.0, FAR) as i32;
        self.ask(&boxes, |view, asker| match view.occlusion(asker, against, distance) {
            Occlusion::None => 0.0,
            Occlusion::Part => 1.0,
            Occlusion::Full => 2.0,
        })
    }

    pub fn visible(&self, body: &Body, label: &str) -> f64 {
        let Some(label) = self.labels.get(label) else { return 0.0 };
        self.ask(&body.boxes(), |view, asker| f64::from(u8::from(view.visible(asker, *label))))
    }

    fn ask(&self, boxes: &[Bounds], ask: impl FnOnce(super::context::Snapshot<'_>, Asker<'_>) -> f64) -> f64 {
        self.asker.map_or(0.0, |shape| ask(self.configuration.view(), Asker { shape, boxes }))
    }

    /// `None` for a label that no shape has.
    fn against(&self, against: &ast::Against) -> Option<Against> {
        Some(match against {
            ast::Against::All => Against::All,
            ast::Against::Active => Against::Active,
            ast::Against::NoParent => Against::NoParent,
            ast::Against::Label(label) => Against::Label(*self.labels.get(label.as_str())?),
        })
    }
}

fn region(local: Place) -> Region {
    Region(local.number())
}
