//! How short the scopes of each role may be.

use super::forest::{Forest, Kind};
use super::form::{Form, Key, Slot};
use super::hist::Hist;
use super::role::{Role, RoleId, Roles};
use super::row::Row;
use crate::space::{Axis, Cell};
use std::collections::BTreeMap;

/// By role, the least length along each axis, in cells.
pub type Least = BTreeMap<RoleId, Cell>;

/// How long parts have to be at least.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Need {
    /// As long as they were seen.
    Seen,
    /// A cell, if they are not empty.
    Bare,
}

/// The least scopes that the rules of `root` may lead to, from a start scope of `size`.
///
/// A part is never shorter than it was seen, as conditions and limits of draws see to it, but where its rule has to
/// fit all scopes; across the axis it is as long as the whole.
pub fn least(roles: &Roles, forest: &Forest, root: RoleId, size: Cell) -> Least {
    let mut least = Least::from([(roles.find(root), size)]);
    let mut open = vec![roles.find(root)];
    while let Some(id) = open.pop() {
        let own = least[&id];
        let role = roles.role(id);
        let fitting = fits_all(roles, forest, role, own);
        for (key, form) in &role.forms {
            let need = if fitting.as_ref() == Some(key) { Need::Bare } else { Need::Seen };
            for (child, size) in below(roles, forest, key, form, own, need) {
                let child = roles.find(child);
                let known = least.get(&child).copied();
                let new = known.map_or(size, |known| known.min(size));
                if known != Some(new) {
                    least.insert(child, new);
                    open.push(child);
                }
            }
        }
    }
    least
}

/// The form of a role that has to fit all its scopes, though it was seen in longer ones only: where no other does.
pub fn fits_all(roles: &Roles, forest: &Forest, role: &Role, least: Cell) -> Option<Key> {
    let needs = role.forms.iter().map(|(key, form)| (need(roles, forest, key, form), key));
    let needs: Vec<(Option<(Axis, i32)>, &Key)> = needs.collect();
    let is_short = |need: &Option<(Axis, i32)>| need.is_none_or(|(axis, need)| need <= axis.of(least));
    if needs.iter().any(|(need, _)| is_short(need)) {
        return None;
    }
    let order = |(need, key): &(Option<(Axis, i32)>, &Key)| {
        (need.map_or(0, |(axis, need)| need - axis.of(least)), std::cmp::Reverse(role.forms[*key].count))
    };
    needs.iter().min_by_key(|need| order(need)).map(|(_, key)| (*key).clone())
}

/// The shortest scope that a form was seen in.
fn need(roles: &Roles, forest: &Forest, key: &Key, form: &Form) -> Option<(Axis, i32)> {
    match key {
        Key::Fixed { axis, slots } => {
            let rows = roles.rows(forest, form, *axis);
            let shortest = rows
                .iter()
                .map(Row::lengths)
                .reduce(|one, other| one.iter().zip(&other).map(|(one, other)| *one.min(other)).collect());
            let is_leaf = |slot: &Slot| matches!(slot.kind, Kind::Leaf(_));
            // What looks alike at any length needs no more than a cell.
            let shortest = shortest.unwrap_or_default();
            let varies = |at: usize| rows.iter().any(|row| row.lengths()[at] != shortest[at]);
            let needed = shortest.iter().enumerate().map(|(at, len)| match at % 2 {
                1 if is_leaf(&slots[at / 2]) && varies(at) => 1,
                0 if varies(at) => 0,
                _ => *len,
            });
            Some((*axis, needed.sum()))
        }
        Key::List(axis) if form.list.lead.range().1 + form.list.tail.range().1 > 0 => {
            let space = |hist: &Hist| {
                let (low, high) = hist.range();
                if low == high { low } else { 0 }
            };
            Some((*axis, 1 + space(&form.list.lead) + space(&form.list.tail)))
        }
        _ => None,
    }
}

/// The least scopes of the units of a form.
fn below(
    roles: &Roles,
    forest: &Forest,
    key: &Key,
    form: &Form,
    own: Cell,
    need: Need,
) -> Vec<(RoleId, Cell)> {
    let sized = |axis: Axis, len: i32| {
        let mut size = own;
        size[axis.index()] = len.min(axis.of(own)).max(1);
        size
    };
    match key {
        Key::Nil | Key::Leaf(_) => Vec::new(),
        Key::Fixed { axis, .. } => {
            let rows = roles.rows(forest, form, *axis);
            let unit = |at: usize| match need {
                Need::Seen => rows.iter().map(|row| row.units[at].len).min().unwrap_or(1),
                Need::Bare => 1,
            };
            form.children.iter().enumerate().map(|(at, child)| (*child, sized(*axis, unit(at)))).collect()
        }
        Key::Even(axis) => {
            let most = form.list.shares.as_ref().map_or(1, |shares| shares.range().1);
            vec![(form.children[0], sized(*axis, axis.of(own) / most.max(1)))]
        }
        Key::List(axis) => vec![(form.children[0], sized(*axis, 1))],
    }
}
