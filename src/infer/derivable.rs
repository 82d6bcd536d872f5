//! Proof that a graph derives an example: a search for the choices that give it, cell for cell.

use super::Labels;
use super::emit::turned_label;
use super::example::Example;
use crate::grammar::ast::{BinaryOp, Function, SizeKind};
use crate::graph::{Arg, Expr, NodeIndex, Op, OpGraph, Size};
use crate::grid::{Grid, LabelledBoxes};
use crate::space::{Axis, Bounds, Frame, Length, Scope, Turn, fit, shares};
use rustc_hash::FxHashMap;

/// Whether a graph derives an example.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Derivable {
    Yes,
    /// It does not, or by operations that the search does not follow: those that inference never makes.
    NotShown,
}

/// Searches for a derivation of `example` from the root of `graph`, on a scope of the example's size.
/// `labels` says which label a constant stands for.
pub fn derivable(graph: &OpGraph, labels: &Labels, example: &Example) -> Derivable {
    let example = &example.open();
    let target = Target::of(example);
    let frame = Frame { up: graph.up, turn: Turn::NONE };
    let mut search = Search { graph, labels, target, known: FxHashMap::default() };
    match search.derives(graph.root(), Scope { bounds: example.bounds(), frame }) {
        true => Derivable::Yes,
        false => Derivable::NotShown,
    }
}

/// What has to be derived.
enum Target<'e> {
    Blocks(&'e Grid),
    Boxes(Placed<'e>),
}

/// Labelled boxes by their place. No array of the container: it may be far larger than what stands in it.
struct Placed<'e> {
    labels: FxHashMap<Bounds, &'e str>,
    /// By low end on x.
    in_order: Vec<Bounds>,
    /// The longest box on x.
    widest: i32,
}

impl<'e> Placed<'e> {
    fn of(boxes: &'e LabelledBoxes) -> Placed<'e> {
        let mut in_order: Vec<Bounds> = boxes.boxes.iter().map(|labelled| labelled.bounds).collect();
        in_order.sort_unstable_by_key(|bounds| bounds.min.x);
        Placed {
            labels: boxes.boxes.iter().map(|labelled| (labelled.bounds, labelled.label.as_str())).collect(),
            widest: in_order.iter().map(|bounds| bounds.len(Axis::X)).max().unwrap_or(0),
            in_order,
        }
    }

    fn is_empty(&self, bounds: Bounds) -> bool {
        let first = self.in_order.partition_point(|other| other.min.x <= bounds.min.x - self.widest);
        let near = self.in_order[first..].iter().take_while(|other| other.min.x < bounds.max.x);
        near.into_iter().all(|other| other.intersect(&bounds).is_empty())
    }
}

impl<'e> Target<'e> {
    fn of(example: &'e Example) -> Target<'e> {
        match example {
            Example::Blocks(grid) => Target::Blocks(grid),
            Example::Boxes(boxes) => Target::Boxes(Placed::of(boxes)),
        }
    }

    fn is_empty(&self, bounds: Bounds) -> bool {
        match self {
            Target::Blocks(grid) => bounds.cells().all(|cell| grid.get(cell).is_air()),
            Target::Boxes(boxes) => boxes.is_empty(bounds),
        }
    }

    /// Whether `scope` holds exactly the primitive of that name.
    fn is_primitive(&self, graph: &OpGraph, labels: &Labels, name: &Expr, scope: &Scope) -> bool {
        match (self, name) {
            (Target::Blocks(grid), Expr::Thing(thing)) => thing.block().is_some_and(|wanted| {
                let wanted = wanted.turned(scope.frame.turn);
                scope.bounds.cells().all(|cell| *grid.get(cell) == wanted)
            }),
            (Target::Blocks(_), _) => false,
            (Target::Boxes(boxes), name) => boxes.labels.get(&scope.bounds).is_some_and(|label| {
                let (label, turn) = turned_label(label);
                Some(label) == label_of(graph, labels, name)
                    && Turn::quarters(i32::from(turn)) == scope.frame.turn
            }),
        }
    }
}

/// The label that a primitive stands for.
fn label_of<'g>(graph: &'g OpGraph, labels: &'g Labels, name: &'g Expr) -> Option<&'g str> {
    match name {
        Expr::Thing(thing) => Some(thing.text()),
        Expr::Constant(at) => {
            let name = &graph.constants.get(*at)?.name;
            Some(labels.get(name).unwrap_or(name))
        }
        _ => None,
    }
}

/// More ways than this to size one split are not tried.
const MOST_WAYS: usize = 1 << 20;

struct Search<'g, 'e> {
    graph: &'g OpGraph,
    labels: &'g Labels,
    target: Target<'e>,
    known: FxHashMap<(NodeIndex, Scope), bool>,
}

impl<'g> Search<'g, '_> {
    fn derives(&mut self, node: NodeIndex, scope: Scope) -> bool {
        if scope.is_empty() {
            return true;
        }
        if let Some(&known) = self.known.get(&(node, scope)) {
            return known;
        }
        // A ring of rules that comes back to the same scope derives nothing new there.
        self.known.insert((node, scope), false);
        let found = self.search(node, scope);
        self.known.insert((node, scope), found);
        found
    }

    fn search(&mut self, node: NodeIndex, scope: Scope) -> bool {
        let graph = self.graph;
        let mut children = graph.children(node);
        match graph.op(node) {
            Op::Nil => self.target.is_empty(scope.bounds),
            Op::Primitive { name, material: None, options } if options.is_empty() => {
                self.target.is_primitive(graph, self.labels, name, &scope)
            }
            Op::Choose => children.any(|(arg, child)| match arg {
                Arg::Alternative(alternative) => {
                    alternative.weight != Expr::number(0.0)
                        && alternative.condition.as_ref().is_none_or(|condition| holds(condition, &scope))
                        && self.derives(child, scope)
                }
                _ => false,
            }),
            Op::Split { axis: Expr::Axis(axis), snap: None, groups } if groups.is_empty() => {
                self.split(node, *axis, scope)
            }
            Op::Repeat { axis: Expr::Axis(axis), size: Expr::Number(size), snap: None } if size.0 >= 1.0 => {
                let count = (f64::from(scope.len(*axis)) / size.0).ceil();
                self.repeat(node, *axis, count as u32, scope)
            }
            Op::RepeatN { axis: Expr::Axis(axis), count: Expr::Number(count) } if count.0 >= 1.0 => {
                self.repeat(node, *axis, count.0 as u32, scope)
            }
            Op::Rotate { angle: Expr::Number(angle), .. } if angle.0 % 90.0 == 0.0 => {
                let turn = Turn::quarters((angle.0 / 90.0) as i32);
                children.all(|(_, child)| self.derives(child, scope.turned(turn)))
            }
            _ => false,
        }
    }

    fn repeat(&mut self, node: NodeIndex, axis: Axis, count: u32, scope: Scope) -> bool {
        let graph = self.graph;
        graph.children(node).all(|(_, child)| {
            shares(scope.len(axis), count).all(|(low, high)| self.derives(child, scope.part(axis, low, high)))
        })
    }

    fn split(&mut self, node: NodeIndex, axis: Axis, scope: Scope) -> bool {
        let graph = self.graph;
        let parts: Option<Vec<(Vec<Length>, NodeIndex)>> = graph
            .children(node)
            .map(|(arg, child)| match arg {
                Arg::Size(size) => Some((lengths(size)?, child)),
                _ => None,
            })
            .collect();
        let Some(parts) = parts else { return false };
        let ways = parts.iter().try_fold(1, |ways: usize, (lengths, _)| ways.checked_mul(lengths.len()));
        if ways.is_none_or(|ways| ways > MOST_WAYS) {
            return false;
        }
        (0..ways.unwrap_or(0)).any(|way| self.sized(&parts, way, axis, scope))
    }

    /// Tries one way to size the parts, numbered in the order of the lengths they may have.
    fn sized(
        &mut self,
        parts: &[(Vec<Length>, NodeIndex)],
        mut way: usize,
        axis: Axis,
        scope: Scope,
    ) -> bool {
        let mut chosen = Vec::with_capacity(parts.len());
        for (lengths, _) in parts {
            chosen.push(lengths[way % lengths.len()]);
            way /= lengths.len();
        }
        let Ok(bounds) = fit(scope.len(axis), &chosen) else { return false };
        let mut places = bounds.windows(2).map(|pair| scope.part(axis, pair[0], pair[1]));
        parts.iter().all(|(_, child)| places.next().is_some_and(|place| self.derives(*child, place)))
    }
}

/// The lengths that a part may have.
fn lengths(size: &Size) -> Option<Vec<Length>> {
    match size.kind {
        SizeKind::Floating => match &size.value {
            Expr::Number(weight) => Some(vec![Length::Floating(weight.0)]),
            _ => None,
        },
        SizeKind::Absolute => {
            Some(numbers(&size.value)?.into_iter().map(|n| Length::Absolute(f64::from(n))).collect())
        }
        SizeKind::Relative => None,
    }
}

/// The whole numbers that an expression may give: a number, a range, or a multiple of one.
fn numbers(expr: &Expr) -> Option<Vec<i32>> {
    match expr {
        Expr::Number(number) => Some(vec![number.0 as i32]),
        Expr::Call(Function::Randint, bounds) => match bounds.as_slice() {
            [Expr::Number(low), Expr::Number(high)] => Some((low.0 as i32..=high.0 as i32).collect()),
            _ => None,
        },
        Expr::Binary(BinaryOp::Multiply, step, range) => match &**step {
            Expr::Number(step) => Some(numbers(range)?.into_iter().map(|n| n * step.0 as i32).collect()),
            _ => None,
        },
        _ => None,
    }
}

/// Whether a condition on the lengths of the scope holds.
fn holds(condition: &Expr, scope: &Scope) -> bool {
    match condition {
        Expr::Binary(BinaryOp::And, left, right) => holds(left, scope) && holds(right, scope),
        Expr::Binary(BinaryOp::Or, left, right) => holds(left, scope) || holds(right, scope),
        Expr::Binary(BinaryOp::Equal, left, right) => match (&**left, &**right) {
            (Expr::ScopeSize(axis), Expr::Number(length)) => f64::from(scope.len(*axis)) == length.0,
            _ => false,
        },
        _ => false,
    }
}
