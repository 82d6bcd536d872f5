//! From roles to an op graph.

use super::bounds::{Least, Need, fits_all, least};
use super::draw::{Draw, number};
use super::fixed::{elastic, fixed};
use super::forest::Forest;
use super::form::{Form, Key};
use super::hist::Hist;
use super::list::{List, list};
use super::role::{RoleId, Roles};
use super::row::Row;
use super::sketch::{Order, Sketch, Way};
use crate::grammar::ast::BinaryOp;
use crate::graph::{Alternative, Arg, Builder, Expr, NodeIndex, Op};
use crate::space::{Axis, Cell};
use std::collections::BTreeMap;

/// The node of a role in a new graph. `leaf` makes the nodes of labels; the start scope is `size` at least.
pub fn emit(
    (roles, forest): (&Roles, &Forest),
    root: RoleId,
    size: Cell,
    builder: &mut Builder,
    leaf: &mut dyn FnMut(&mut Builder, u32) -> NodeIndex,
) -> NodeIndex {
    let mut writer =
        Writer { roles, forest, least: least(roles, forest, root, size), lists: BTreeMap::new() };
    let mut ways: Vec<(Place, Vec<Way>)> = Vec::new();
    for id in roles.reached(root).into_iter().filter(|id| roles.role(*id).leaf().is_none()) {
        let own = writer.ways(id);
        ways.push((Place::Role(id), own));
        ways.extend(
            std::mem::take(&mut writer.lists).into_iter().map(|(axis, rest)| (Place::Rest(id, axis), rest)),
        );
    }
    let mut graph = Graph {
        roles,
        builder,
        leaf,
        nodes: BTreeMap::new(),
        ways: ways.iter().map(|(place, ways)| (*place, ways.as_slice())).collect(),
    };
    graph.run(roles.find(root))
}

/// What has a node of its own.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Place {
    Role(RoleId),
    Rest(RoleId, Axis),
}

struct Writer<'r> {
    roles: &'r Roles,
    forest: &'r Forest,
    least: Least,
    /// The rules of what is left of the lists of the role at hand.
    lists: BTreeMap<Axis, Vec<Way>>,
}

impl Writer<'_> {
    fn ways(&mut self, id: RoleId) -> Vec<Way> {
        let role = self.roles.role(id);
        let forms: Vec<(&Key, &Form)> = role.forms.iter().collect();
        if let [(Key::List(axis), form)] = forms[..] {
            let list = self.list(*axis, form, &Sketch::Role(id));
            if matches!(list.whole, Sketch::Role(_)) {
                return list.rest;
            }
        }
        let fitting = fits_all(self.roles, self.forest, role, self.least[&id]);
        let need = |key: &Key| if fitting.as_ref() == Some(key) { Need::Bare } else { Need::Seen };
        let mut ways: Vec<Way> = forms.iter().map(|(key, form)| self.way(id, key, form, need(key))).collect();
        if ways.iter().all(|way| way.condition.is_some()) {
            self.add_last(&forms, &mut ways);
        }
        ways
    }

    /// What stands where all else is too long.
    fn add_last(&self, forms: &[(&Key, &Form)], ways: &mut Vec<Way>) {
        let rows_of = forms.iter().filter(|(key, _)| matches!(key, Key::Fixed { .. } | Key::List(_)));
        let Some((key, form)) = rows_of.max_by_key(|(_, form)| form.count) else { return };
        let sketch = match key {
            Key::Fixed { axis, .. } => elastic(*axis, &self.rows(form, *axis), &self.children(form)),
            _ => self.child(form.children[0]),
        };
        ways.push(Way { condition: None, weight: 1, order: Order::Last, sketch });
    }

    fn way(&mut self, id: RoleId, key: &Key, form: &Form, need: Need) -> Way {
        let least = |axis: Axis| axis.of(self.least[&id]);
        let (sketch, need) = match key {
            Key::Nil => (Sketch::Nil, None),
            Key::Leaf(label) => (Sketch::Leaf(*label), None),
            Key::Fixed { axis, .. } => {
                let fixed = fixed(*axis, &self.rows(form, *axis), &self.children(form), least(*axis), need);
                (fixed.sketch, Some((*axis, fixed.need)))
            }
            Key::Even(axis) => (self.even(*axis, form), None),
            Key::List(axis) => {
                let list = self.list(*axis, form, &Sketch::Rest(id, *axis));
                self.lists.insert(*axis, list.rest);
                (list.whole, Some((*axis, list.need)))
            }
        };
        let condition = need
            .filter(|(axis, need)| *need > axis.of(self.least[&id]))
            .map(|(axis, need)| Expr::binary(BinaryOp::GreaterEqual, Expr::ScopeSize(axis), number(need)));
        Way { condition, weight: form.count, order: Order::First, sketch }
    }

    fn list(&self, axis: Axis, form: &Form, rest: &Sketch) -> List {
        list(axis, &self.rows(form, axis), &self.child(form.children[0]), rest)
    }

    fn rows(&self, form: &Form, axis: Axis) -> Vec<Row> {
        self.roles.rows(self.forest, form, axis)
    }

    /// Equal shares: by their size, if that tells how many there are, else as many as is drawn.
    fn even(&self, axis: Axis, form: &Form) -> Sketch {
        let rows = self.rows(form, axis);
        let counts = Hist::of(rows.iter().map(|row| row.units.len() as i32));
        let longest = rows.iter().map(Row::len).max().unwrap_or(1);
        let fits =
            |size: &i32| rows.iter().all(|row| (row.len() + size - 1) / size == row.units.len() as i32);
        let size = (1..=longest).find(fits).filter(|_| counts.entries().len() > 1);
        let unit = Box::new(self.child(form.children[0]));
        match size {
            Some(size) => Sketch::Repeat { axis, size: number(size), unit },
            None => Sketch::Times { axis, count: Draw::of(counts.entries()).expr, unit },
        }
    }

    fn children(&self, form: &Form) -> Vec<Sketch> {
        form.children.iter().map(|child| self.child(*child)).collect()
    }

    fn child(&self, id: RoleId) -> Sketch {
        let id = self.roles.find(id);
        self.roles.role(id).leaf().map_or(Sketch::Role(id), Sketch::Leaf)
    }
}

struct Graph<'g> {
    roles: &'g Roles,
    builder: &'g mut Builder,
    leaf: &'g mut dyn FnMut(&mut Builder, u32) -> NodeIndex,
    nodes: BTreeMap<Place, NodeIndex>,
    ways: BTreeMap<Place, &'g [Way]>,
}

impl Graph<'_> {
    fn run(&mut self, root: RoleId) -> NodeIndex {
        if let Some(label) = self.roles.role(root).leaf() {
            return (self.leaf)(self.builder, label);
        }
        let places: Vec<Place> = self.ways.keys().copied().collect();
        for place in &places {
            if let Some(op) = self.op(*place) {
                let node = self.builder.later(op);
                self.nodes.insert(*place, node);
            }
        }
        for place in places {
            self.complete(place);
        }
        self.node(Place::Role(root))
    }

    /// The operation of a place; `None` where it is what another one is.
    fn op(&self, place: Place) -> Option<Op> {
        match self.ways[&place] {
            [Way { condition: None, sketch, .. }] => match sketch {
                Sketch::Split { axis, .. } => Some(split_op(*axis)),
                Sketch::Call(args, _) => Some(Op::Call(args.clone())),
                Sketch::Nil => Some(Op::Nil),
                Sketch::Repeat { axis, size, .. } => Some(repeat_op(*axis, size)),
                Sketch::Times { axis, count, .. } => Some(times_op(*axis, count)),
                Sketch::Leaf(_) | Sketch::Role(_) | Sketch::Rest(..) => None,
            },
            _ => Some(Op::Choose),
        }
    }

    fn node(&mut self, place: Place) -> NodeIndex {
        match self.nodes.get(&place) {
            Some(node) => *node,
            None => {
                let sketch = self.ways[&place][0].sketch.clone();
                self.sketched(&sketch)
            }
        }
    }

    fn complete(&mut self, place: Place) {
        let Some(&node) = self.nodes.get(&place) else { return };
        let ways = self.ways[&place];
        let children = match ways {
            [Way { condition: None, sketch, .. }] => match sketch {
                Sketch::Split { parts, .. } => {
                    parts.iter().map(|(size, part)| (Arg::Size(size.clone()), self.sketched(part))).collect()
                }
                Sketch::Call(_, inner)
                | Sketch::Repeat { unit: inner, .. }
                | Sketch::Times { unit: inner, .. } => {
                    vec![(Arg::None, self.sketched(inner))]
                }
                _ => Vec::new(),
            },
            ways => ways
                .iter()
                .map(|way| (Arg::Alternative(alternative(way)), self.sketched(&way.sketch)))
                .collect(),
        };
        self.builder.complete(node, children);
    }

    fn sketched(&mut self, sketch: &Sketch) -> NodeIndex {
        match sketch {
            Sketch::Nil => self.builder.nil(),
            Sketch::Leaf(label) => (self.leaf)(self.builder, *label),
            Sketch::Role(id) => self.node(Place::Role(*id)),
            Sketch::Rest(id, axis) => self.node(Place::Rest(*id, *axis)),
            Sketch::Split { axis, parts } => {
                let parts = parts.iter().map(|(size, part)| (Arg::Size(size.clone()), self.sketched(part)));
                let parts = parts.collect();
                self.builder.node(split_op(*axis), parts)
            }
            Sketch::Repeat { axis, size, unit } => {
                let unit = self.sketched(unit);
                self.builder.node(repeat_op(*axis, size), vec![(Arg::None, unit)])
            }
            Sketch::Times { axis, count, unit } => {
                let unit = self.sketched(unit);
                self.builder.node(times_op(*axis, count), vec![(Arg::None, unit)])
            }
            Sketch::Call(args, inner) => {
                let inner = self.sketched(inner);
                self.builder.node(Op::Call(args.clone()), vec![(Arg::None, inner)])
            }
        }
    }
}

fn repeat_op(axis: Axis, size: &Expr) -> Op {
    Op::Repeat { axis: Expr::Axis(axis), size: size.clone(), snap: None }
}

fn times_op(axis: Axis, count: &Expr) -> Op {
    Op::RepeatN { axis: Expr::Axis(axis), count: count.clone() }
}

fn split_op(axis: Axis) -> Op {
    Op::Split { axis: Expr::Axis(axis), snap: None, groups: Vec::new() }
}

fn alternative(way: &Way) -> Alternative {
    let plain = Alternative::plain(number(way.weight as i32));
    let priority = plain.priority + u32::from(way.order == Order::Last);
    Alternative { condition: way.condition.clone(), priority, ..plain }
}
