//! Roles: what one rule stands for in all examples.

use super::forest::{Forest, PlaceId};
use super::form::{Form, Key, entropy};
use super::hist::Hist;
use super::row::Row;
use crate::space::Axis;
use std::cell::Cell;
use std::collections::BTreeMap;

#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct RoleId(pub u32);

/// The places that one rule stands for.
#[derive(Clone, Default, Debug)]
pub struct Role {
    pub forms: BTreeMap<Key, Form>,
    /// The lengths of its places along each axis, in cells.
    pub sizes: [Hist; 3],
}

/// All roles of the examples.
#[derive(Clone, Debug)]
pub struct Roles {
    /// The bits that a rule has to be worth.
    pub price: f64,
    /// How many more roles may be folded to see what that is worth.
    pub work: Cell<u32>,
    pub list: Vec<Role>,
    /// The places that forms refer to.
    pub places: Vec<Vec<PlaceId>>,
    /// For a role that became another one, that.
    pub merged: Vec<RoleId>,
}

/// More roles than these are not folded in all, which takes about a second.
const MOST_WORK: u32 = 1 << 17;

/// The bits of a rule.
const RULE: f64 = 6.0;

impl Role {
    /// The bits of its rules, each of them at a price, and of all choices and lengths.
    pub fn bits(&self, price: f64) -> f64 {
        if self.leaf().is_some() {
            return 0.0;
        }
        let forms: f64 = self.forms.iter().map(|(key, form)| form.bits(key, price)).sum();
        RULE + forms + entropy(self.forms.values().map(|form| form.count))
    }

    /// The label of a role that is nothing but one leaf: it needs no rule.
    pub fn leaf(&self) -> Option<u32> {
        match self.forms.keys().next() {
            Some(Key::Leaf(label)) if self.forms.len() == 1 => Some(*label),
            _ => None,
        }
    }
}

impl Roles {
    pub fn new(price: f64) -> Roles {
        Roles { price, work: Cell::new(MOST_WORK), list: Vec::new(), places: Vec::new(), merged: Vec::new() }
    }

    /// The places of a form, as rows along an axis.
    pub fn rows(&self, forest: &Forest, form: &Form, axis: Axis) -> Vec<Row> {
        let places = form.sources.iter().flat_map(|source| &self.places[*source as usize]);
        places.map(|place| Row::of(forest, *place, axis)).collect()
    }

    /// What a role became.
    pub fn find(&self, id: RoleId) -> RoleId {
        let mut id = id;
        while self.merged[id.0 as usize] != id {
            id = self.merged[id.0 as usize];
        }
        id
    }

    pub fn role(&self, id: RoleId) -> &Role {
        &self.list[self.find(id).0 as usize]
    }

    pub fn add(&mut self, role: Role) -> RoleId {
        let id = RoleId(self.list.len() as u32);
        self.list.push(role);
        self.merged.push(id);
        id
    }

    /// The roles that a role leads to, in order of first sight, itself first.
    pub fn reached(&self, root: RoleId) -> Vec<RoleId> {
        let mut order = vec![self.find(root)];
        let mut known = vec![false; self.list.len()];
        known[order[0].0 as usize] = true;
        let mut at = 0;
        while at < order.len() {
            for form in self.list[order[at].0 as usize].forms.values() {
                for child in &form.children {
                    let child = self.find(*child);
                    if !std::mem::replace(&mut known[child.0 as usize], true) {
                        order.push(child);
                    }
                }
            }
            at += 1;
        }
        order
    }

    /// The bits of all that a role leads to.
    pub fn bits(&self, root: RoleId) -> f64 {
        self.reached(root).iter().map(|id| self.role(*id).bits(self.price)).sum()
    }
}
