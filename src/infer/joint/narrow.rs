//! Choices that are made otherwise in some places: what no example takes there is not to be had there.
//!
//! A tower of mud may stand in any lot of the examples but those in the corners. Then the lots in the corners are another
//! choice, between the rest.

use super::boxes::Boxes;
use super::corpus::{Class, Corpus};
use super::derivation::{At, Derivation};
use super::emit::Emitted;
use super::laws::Law;
use super::pairs::{self, Barred};
use super::places::{Edge, Path, Unit, chosen, each_place};
use super::plan::{self, Form, How, NodeId, Plan};
use super::replace::replaced;
use crate::graph::Op;
use crate::space::{Axis, Bounds};
use std::collections::{BTreeMap, BTreeSet};

/// A choice as far as it is made below some operations, the outermost first.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
struct Narrowing {
    choice: NodeId,
    below: Vec<(NodeId, Edge)>,
}

/// A choice that a sample made.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Taken {
    choice: NodeId,
    child: NodeId,
    path: Vec<(NodeId, Edge)>,
}

/// What a sample may have made wrong in one place: one of these has to be made otherwise.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Blamed {
    pub pairs: Vec<Barred>,
    pub choices: Vec<Taken>,
}

/// The choices that a derivation made in the scopes that touch a window, the outermost first.
pub fn taken(plan: &Plan, emitted: &Emitted, derivation: &Derivation, window: Bounds) -> Vec<Taken> {
    let is_near = |at: &At| !derivation.get(*at).bounds.intersect(&window).is_empty();
    let all = (0..derivation.len()).filter(is_near);
    let mut taken: Vec<Taken> = all.filter_map(|at| taken_at(plan, emitted, derivation, at)).collect();
    taken.sort();
    taken.dedup();
    taken
}

/// The choice whose alternative an operation is, if it is one.
fn taken_at(plan: &Plan, emitted: &Emitted, derivation: &Derivation, at: At) -> Option<Taken> {
    let before = derivation.before(at)?;
    let chain: Vec<At> = derivation.from(at).collect();
    let mut walk = Walk { plan, emitted, id: emitted.root, path: Vec::new() };
    for pair in chain.windows(2).rev() {
        let choice = walk.step(derivation, pair[1], pair[0])?;
        if pair[1] == before {
            let (choice, child) = choice?;
            walk.path.pop();
            return Some(Taken { choice, child, path: walk.path });
        }
    }
    None
}

/// The way through a plan that a derivation takes.
struct Walk<'w> {
    plan: &'w Plan,
    emitted: &'w Emitted,
    id: NodeId,
    path: Vec<(NodeId, Edge)>,
}

impl Walk<'_> {
    /// Goes from one operation to the next, over nodes that are written as no operation; the choice that was made, if
    /// there was one. `None` where an operation is written as several.
    fn step(&mut self, derivation: &Derivation, from: At, to: At) -> Option<Option<(NodeId, NodeId)>> {
        let op = self.emitted.op(derivation.get(from).node);
        self.skip(op);
        let number = derivation.get(to).number;
        let id = self.id;
        let (edge, child) = match (op, &self.plan.node(id).form) {
            (Op::Call(_), Form::Call { child, .. }) => (Edge::Child(0), *child),
            (Op::Call(_), _) => return Some(None),
            (Op::Split { .. }, Form::Split { parts, .. }) => (Edge::Child(number), parts.get(number)?.1),
            (Op::Repeat { .. }, Form::Repeat { axis, unit, child }) => {
                let count = derivation.get(from).bounds.len(*axis) / unit;
                (Edge::Unit(Unit::of(number, count as usize)), *child)
            }
            (Op::Choose, Form::Choose(children)) => {
                let alternatives = plan::alternatives(self.plan, id, self.emitted.boxes(id))?;
                let child = alternatives.get(number)?.0;
                (Edge::Child(children.iter().position(|own| *own == child)?), child)
            }
            _ => return None,
        };
        self.path.push((id, edge));
        self.id = child;
        Some(matches!(op, Op::Choose).then_some((id, child)))
    }

    /// Calls without arguments, and choices of one, are written as what they lead to.
    fn skip(&mut self, op: &Op) {
        loop {
            let child = match &self.plan.node(self.id).form {
                Form::Call { child, .. } if !matches!(op, Op::Call(_)) => *child,
                Form::Choose(_) => {
                    let alternatives = plan::alternatives(self.plan, self.id, self.emitted.boxes(self.id));
                    match alternatives.as_deref() {
                        Some([(only, _)]) => *only,
                        _ => return,
                    }
                }
                _ => return,
            };
            let number = self.plan.children(self.id).iter().position(|own| *own == child).unwrap_or(0);
            self.path.push((self.id, Edge::Child(number)));
            self.id = child;
        }
    }
}

/// The root of the plan with rows and choices narrowed so that none of `blamed` comes again; the same root where nothing
/// can be narrowed.
pub fn narrowed(
    plan: &mut Plan,
    corpus: &mut Corpus,
    (root, boxes): (NodeId, &Boxes),
    blamed: &[Blamed],
) -> NodeId {
    let choices: BTreeSet<NodeId> =
        blamed.iter().flat_map(|blamed| &blamed.choices).map(|taken| taken.choice).collect();
    let seen = Seen::of(plan, corpus, (root, boxes), &choices);
    let of_choices = blamed.iter().filter(|blamed| blamed.pairs.is_empty());
    let mut wanted: Vec<Narrowing> = of_choices.filter_map(|blamed| seen.mildest(&blamed.choices)).collect();
    wanted.sort_by_key(|narrowing| (narrowing.below.len(), narrowing.clone()));
    wanted.dedup();
    let mut made = pairs::without(plan, blamed.iter().flat_map(|blamed| &blamed.pairs));
    for narrowing in wanted {
        let top = narrowing.below[0].0;
        let is_apart = |other: &NodeId| !leads_to(plan, *other, top) && !leads_to(plan, top, *other);
        if made.iter().all(|(other, _)| is_apart(other)) {
            made.extend(seen.narrow(plan, corpus, &narrowing).map(|new| (top, new)));
        }
    }
    replaced(plan, root, &made)
}

fn leads_to(plan: &Plan, from: NodeId, to: NodeId) -> bool {
    plan.reachable(from).contains(&to)
}

/// Where some choices are made in the examples.
struct Seen {
    places: BTreeMap<NodeId, Vec<Place>>,
    /// By repeat, the boxes that it stands for below each path.
    repeats: BTreeMap<NodeId, Vec<Place>>,
}

/// A path with the class that is at its end.
struct Place {
    path: Vec<(NodeId, Edge)>,
    class: Class,
    child: Option<NodeId>,
}

impl Place {
    fn is_below(&self, path: &Path) -> bool {
        self.path.ends_with(path)
    }
}

impl Seen {
    fn of(
        plan: &Plan,
        corpus: &mut Corpus,
        (root, boxes): (NodeId, &Boxes),
        choices: &BTreeSet<NodeId>,
    ) -> Seen {
        let mut seen = Seen { places: BTreeMap::new(), repeats: BTreeMap::new() };
        each_place(plan, corpus, root, boxes, |id, path, class| {
            let place = || Place { path: path.to_vec(), class, child: chosen(plan, id, class) };
            if choices.contains(&id) {
                seen.places.entry(id).or_default().push(place());
            }
            if let Form::Repeat { .. } = plan.node(id).form {
                seen.repeats.entry(id).or_default().push(place());
            }
        });
        seen
    }

    /// The narrowing that keeps one of the choices from being made again where no example makes it, below as few
    /// operations as tell of that.
    fn mildest(&self, taken: &[Taken]) -> Option<Narrowing> {
        let narrowings = taken.iter().rev().filter_map(|taken| self.narrowing(taken));
        narrowings.min_by_key(|narrowing| narrowing.below.len())
    }

    fn narrowing(&self, taken: &Taken) -> Option<Narrowing> {
        let places = self.places.get(&taken.choice)?;
        let below = (0..taken.path.len()).rev().map(|from| &taken.path[from..]).find(|path| {
            let mut there = places.iter().filter(|place| place.is_below(path));
            there.all(|place| place.child != Some(taken.child))
        })?;
        let is_seen = places.iter().any(|place| place.is_below(below));
        is_seen.then(|| Narrowing { choice: taken.choice, below: below.to_vec() })
    }

    /// What stands in the place of the outermost operation of a narrowing.
    fn narrow(&self, plan: &mut Plan, corpus: &mut Corpus, narrowing: &Narrowing) -> Option<NodeId> {
        let Narrowing { choice, below } = narrowing;
        let there = self.places[choice].iter().filter(|place| place.is_below(below));
        let mut of: Vec<(Class, NodeId)> =
            there.filter_map(|place| Some((place.class, place.child?))).collect();
        of.sort_unstable();
        of.dedup();
        let mut node = plan.choose(of);
        for (number, (id, edge)) in below.iter().enumerate().rev() {
            node = match edge {
                Edge::Child(child) => with_child(plan, *id, *child, node),
                Edge::Unit(unit) => {
                    let above = &below[..number];
                    let there = self.repeats[id].iter().filter(|place| place.is_below(above));
                    let classes: BTreeSet<Class> = there.map(|place| place.class).collect();
                    with_unit(plan, corpus, (*id, &classes), *unit, node)?
                }
            };
        }
        Some(node)
    }
}

/// A node with another child in one place.
fn with_child(plan: &mut Plan, id: NodeId, number: usize, new: NodeId) -> NodeId {
    let plan::Node { mut form, how } = plan.node(id).clone();
    if let Some(child) = form.children_mut().into_iter().nth(number) {
        *child = new;
    }
    plan.add(form, how)
}

/// A repeat of these classes with another unit at an end, or between the ends: a split with the rest beside it. Classes
/// that have too few units for that are told apart; `None` where all have.
fn with_unit(
    plan: &mut Plan,
    corpus: &mut Corpus,
    (id, classes): (NodeId, &BTreeSet<Class>),
    which: Unit,
    new: NodeId,
) -> Option<NodeId> {
    let Form::Repeat { axis, unit, child } = plan.node(id).form else { return None };
    let (ends, inner) = match which {
        Unit::First => ([Some(new), None], child),
        Unit::Last => ([None, Some(new)], child),
        Unit::Inner => ([Some(child), Some(child)], new),
        Unit::Only => return None,
    };
    let least = 1 + ends.iter().flatten().count() as i32;
    let count = |class: &Class| corpus.profile(*class).len(axis) / unit;
    let (many, few): (Vec<Class>, Vec<Class>) = classes.iter().partition(|class| count(class) >= least);
    let counts: Vec<i32> = few.iter().map(count).collect();
    if many.is_empty() {
        return None;
    }
    let split = with_ends(plan, corpus, (axis, unit), &many, (ends, inner));
    let few = few
        .into_iter()
        .zip(counts)
        .map(|(class, count)| (class, in_a_row(plan, (axis, unit), (class, count), child)));
    let few: Vec<(Class, NodeId)> = few.collect();
    let mut of: Vec<(Class, NodeId)> = many.into_iter().map(|class| (class, split)).chain(few).collect();
    of.sort_unstable();
    Some(plan.choose(of))
}

/// A class of so many units, each as a part of its own.
fn in_a_row(
    plan: &mut Plan,
    (axis, unit): (Axis, i32),
    (class, count): (Class, i32),
    child: NodeId,
) -> NodeId {
    if count == 1 {
        return child;
    }
    let parts = (0..count).map(|_| (Law::Const(unit), child)).collect();
    let starts = (1..count).map(|number| number * unit).collect();
    plan.add(Form::Split { axis, parts }, [(class, How::Split(starts))])
}

/// A repeat of these classes between units of their own at one end or both.
fn with_ends(
    plan: &mut Plan,
    corpus: &mut Corpus,
    (axis, unit): (Axis, i32),
    classes: &[Class],
    (ends, inner): ([Option<NodeId>; 2], NodeId),
) -> NodeId {
    let [before, behind] = ends.map(|end| if end.is_some() { unit } else { 0 });
    let mut how = Vec::new();
    let mut rest = Vec::new();
    for class in classes {
        let high = corpus.profile(*class).len(axis) - behind;
        let planes = [(before > 0).then_some(before), (behind > 0).then_some(high)];
        how.push((*class, How::Split(planes.into_iter().flatten().collect())));
        rest.push((corpus.part(*class, axis, before, high), How::Repeat));
    }
    let repeat = plan.add(Form::Repeat { axis, unit, child: inner }, rest);
    let [first, last] = ends.map(|end| end.map(|node| (Law::Const(unit), node)));
    let parts = first.into_iter().chain([(Law::Float(1), repeat)]).chain(last).collect();
    plan.add(Form::Split { axis, parts }, how)
}
