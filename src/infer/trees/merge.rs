//! Roles that are one: two become one where that takes fewer bits, and with them what stands in the same places of both.
//!
//! The order is that of Lang, Pearlmutter and Price (1998, "Results of the Abbadingo one DFA learning competition"):
//! roles that are settled take in those that they lead to, or else these are settled as well.

use super::forest::{Forest, Kind};
use super::form::{Form, Key};
use super::hist::Hist;
use super::role::{Role, RoleId, Roles};
use super::row::{Row, Unit};
use crate::space::Axis;
use std::collections::{BTreeMap, BTreeSet, VecDeque};

/// So many bits have to be won, as the choice between all pairs costs some as well.
const MARGIN: f64 = 10.0;
/// The bits of places along an axis that are far longer than others of the same role.
const UNALIKE: f64 = 20.0;
/// Lengths that differ more than this many times over are unlike.
const ALIKE: i32 = 3;
/// More roles than these are not folded at once.
const MOST_FOLDED: usize = 2000;
/// A role is compared with so many settled ones, those of the most places.
const MOST_SETTLED: usize = 48;

/// Merges what is shorter as one.
pub fn merge(roles: &mut Roles, forest: &Forest, root: RoleId) {
    settle(roles, root);
    for _ in 0..MOST_ROUNDS {
        let listed = generalise(roles, root) | reread(roles, forest, root);
        let merged = settle(roles, root);
        if !listed && !merged {
            break;
        }
    }
}

/// So often rows become lists and roles are compared again.
const MOST_ROUNDS: usize = 4;

/// Compares every role with those settled before it; says whether any were merged.
fn settle(roles: &mut Roles, root: RoleId) -> bool {
    let mut settled: Vec<RoleId> = Vec::new();
    let mut open: VecDeque<RoleId> = VecDeque::from([roles.find(root)]);
    let mut merged = false;
    while let Some(id) = open.pop_front() {
        let id = roles.find(id);
        if settled.contains(&id) || roles.role(id).leaf().is_some() {
            continue;
        }
        if let Some(fold) = into_settled(roles, &settled, id) {
            fold.apply(roles);
            merged = true;
            settled = distinct(roles, settled);
            // What they lead to may have grown.
            let next = settled.iter().flat_map(|id| children(roles, *id));
            open.extend(next.filter(|id| !settled.contains(id)));
        } else {
            settled.push(id);
            open.extend(children(roles, id));
        }
        open = distinct(roles, open).into();
    }
    merged
}

/// The fold of a role into a settled one that wins most.
fn into_settled(roles: &Roles, settled: &[RoleId], id: RoleId) -> Option<Fold> {
    let folds = settled.iter().take(MOST_SETTLED).filter_map(|known| Fold::of(roles, *known, id));
    let worth_it = folds.filter(|fold| fold.gain > MARGIN);
    worth_it.reduce(|best, fold| if fold.gain > best.gain { fold } else { best })
}

/// What these roles are now, each once.
fn distinct(roles: &Roles, ids: impl IntoIterator<Item = RoleId>) -> Vec<RoleId> {
    let mut known = BTreeSet::new();
    ids.into_iter().map(|id| roles.find(id)).filter(|id| known.insert(*id)).collect()
}

fn children(roles: &Roles, id: RoleId) -> Vec<RoleId> {
    let forms = roles.role(id).forms.values();
    forms.flat_map(|form| form.children.iter().map(|child| roles.find(*child))).collect()
}

/// Rows of few places that are shorter as lists become such; says whether any did.
fn generalise(roles: &mut Roles, root: RoleId) -> bool {
    let mut any = false;
    for id in roles.reached(root) {
        for axis in Axis::ALL {
            if roles.find(id) == id
                && let Some(fold) = lists(roles, id, axis)
            {
                fold.apply(roles);
                any = true;
            }
        }
    }
    any
}

/// The rarest rows of a role along an axis as a list, or those whose shares are even as one form: whichever wins most.
fn lists(roles: &Roles, id: RoleId, axis: Axis) -> Option<Fold> {
    let forms = &roles.role(id).forms;
    let rows = forms.iter().filter(|(key, _)| matches!(key, Key::Fixed { axis: own, .. } if *own == axis));
    let mut rows: Vec<(u32, &Key)> = rows.map(|(key, form)| (form.count, key)).collect();
    rows.sort();
    let lists = (1..=rows.len()).filter_map(|count| {
        let rarest = rows[..count].iter().map(|(_, key)| *key).collect();
        Fold::listed(roles, id, &rarest, &Key::List(axis))
    });
    let even: BTreeSet<&Key> =
        rows.iter().map(|(_, key)| *key).filter(|key| forms[*key].list.shares.is_some()).collect();
    let evens = (!even.is_empty()).then(|| Fold::listed(roles, id, &even, &Key::Even(axis))).flatten();
    let best = lists.chain(evens).max_by(|one, other| one.gain.total_cmp(&other.gain));
    best.filter(|fold| fold.gain > MARGIN)
}

/// Places of the kind of which others have space at an end become those without any; says whether any did.
fn reread(roles: &mut Roles, forest: &Forest, root: RoleId) -> bool {
    let mut any = false;
    for id in roles.reached(root) {
        while let Some(fold) = rereadings(roles, forest, id).filter(|_| roles.find(id) == id) {
            fold.apply(roles);
            any = true;
        }
    }
    any
}

fn rereadings(roles: &Roles, forest: &Forest, id: RoleId) -> Option<Fold> {
    let forms = &roles.role(id).forms;
    let alone = forms.keys().filter_map(|key| match key {
        Key::Fixed { axis, slots } if slots.len() == 1 => Some((key, *axis, slots[0].kind)),
        _ => None,
    });
    let folds = alone.flat_map(|(row, axis, kind)| {
        let same = forms.keys().filter(move |key| is_of(key, kind, axis));
        same.filter_map(move |key| Fold::reread(roles, forest, id, (row, axis), key))
    });
    folds.filter(|fold| fold.gain > MARGIN).max_by(|one, other| one.gain.total_cmp(&other.gain))
}

/// Whether a form is of a kind, and not along the axis.
fn is_of(key: &Key, kind: Kind, along: Axis) -> bool {
    match key {
        Key::Nil => false,
        Key::Leaf(label) => kind == Kind::Leaf(*label),
        Key::Fixed { axis, .. } | Key::Even(axis) | Key::List(axis) => {
            kind == Kind::Split(*axis) && *axis != along
        }
    }
}

/// Roles that become one, with all that they lead to.
struct Fold {
    changed: BTreeMap<RoleId, Role>,
    merged: BTreeMap<RoleId, RoleId>,
    /// The bits that are won.
    gain: f64,
}

impl Fold {
    fn of(roles: &Roles, one: RoleId, other: RoleId) -> Option<Fold> {
        let mut fold = Fold { changed: BTreeMap::new(), merged: BTreeMap::new(), gain: 0.0 };
        fold.run(roles, vec![(one, other)]).then_some(fold)
    }

    /// Some rows of a role become a list.
    fn listed(roles: &Roles, id: RoleId, listed: &BTreeSet<&Key>, list: &Key) -> Option<Fold> {
        let mut fold = Fold { changed: BTreeMap::new(), merged: BTreeMap::new(), gain: 0.0 };
        let role = roles.role(id);
        let mut new = Role { forms: BTreeMap::new(), sizes: role.sizes.clone() };
        let mut open = Vec::new();
        for (key, form) in &role.forms {
            let key = if listed.contains(key) { list.clone() } else { key.clone() };
            enter(&mut new, key, form, &mut open);
        }
        fold.gain += role.bits(roles.price) - new.bits(roles.price);
        fold.changed.insert(roles.find(id), new);
        fold.run(roles, open).then_some(fold)
    }

    /// A form of a role becomes one of the only unit of another one.
    fn reread(
        roles: &Roles,
        forest: &Forest,
        id: RoleId,
        (row, axis): (&Key, Axis),
        moved: &Key,
    ) -> Option<Fold> {
        let role = roles.role(id);
        let inner_id = roles.find(role.forms[row].children[0]);
        if inner_id == roles.find(id) {
            return None;
        }
        let inner = roles.role(inner_id);
        let form = &role.forms[moved];
        let rows = roles.rows(forest, form, axis);
        let without = role.forms.iter().filter(|(key, _)| *key != moved);
        let grown = |(key, own): (&Key, &Form)| {
            let own = if key == row { own.plus(&whole(form, &rows, row)) } else { own.clone() };
            (key.clone(), own)
        };
        let outer = Role { forms: without.map(grown).collect(), sizes: role.sizes.clone() };
        let sizes = |axis: Axis| {
            let own = rows.iter().map(|row| axis.of(forest.place(row.place).size));
            inner.sizes[axis.index()].plus(&Hist::of(own))
        };
        let mut open = Vec::new();
        let mut unit = Role { forms: inner.forms.clone(), sizes: Axis::ALL.map(sizes) };
        enter(&mut unit, moved.clone(), form, &mut open);
        let bits = |roles_of: [&Role; 2]| roles_of.map(|role| role.bits(roles.price)).iter().sum::<f64>();
        let gain = bits([role, inner]) - bits([&outer, &unit]);
        let changed = [(roles.find(id), outer), (inner_id, unit)].into();
        let mut fold = Fold { changed, merged: BTreeMap::new(), gain };
        fold.run(roles, open).then_some(fold)
    }

    fn find(&self, roles: &Roles, id: RoleId) -> RoleId {
        let mut id = roles.find(id);
        while let Some(next) = self.merged.get(&id) {
            id = *next;
        }
        id
    }

    fn run(&mut self, roles: &Roles, mut open: Vec<(RoleId, RoleId)>) -> bool {
        let mut folded = 0;
        while let Some((one, other)) = open.pop() {
            let (one, other) = (self.find(roles, one), self.find(roles, other));
            if one == other {
                continue;
            }
            folded += 1;
            let left = roles.work.get();
            if folded > MOST_FOLDED || left == 0 {
                return false;
            }
            roles.work.set(left - 1);
            let (kept, lost) = (one.min(other), one.max(other));
            let get = |id: RoleId| self.changed.get(&id).unwrap_or(&roles.list[id.0 as usize]);
            let (a, b) = (get(kept), get(lost));
            let new = joined(a, b, &mut open);
            let bits = |role: &Role| role.bits(roles.price);
            self.gain += bits(a) + bits(b) - bits(&new) - unalike(a, b);
            self.changed.remove(&lost);
            self.changed.insert(kept, new);
            self.merged.insert(lost, kept);
        }
        true
    }

    fn apply(self, roles: &mut Roles) {
        for (id, role) in self.changed {
            roles.list[id.0 as usize] = role;
        }
        for (lost, kept) in self.merged {
            roles.merged[lost.0 as usize] = kept;
            roles.list[lost.0 as usize] = Role::default();
        }
    }
}

/// A row of one unit each, of the places of another form.
fn whole(form: &Form, rows: &[Row], key: &Key) -> Form {
    let alone = |row: &Row| {
        let unit = Unit { len: row.len(), gap: 0, place: row.place };
        Row { units: vec![unit], ..row.clone() }
    };
    let places: Vec<Row> = rows.iter().map(alone).collect();
    Form { sources: form.sources.clone(), ..Form::of(key, &places, 0) }
}

/// Two roles as one; what stands in the same places of both is to be folded as well.
fn joined(one: &Role, other: &Role, open: &mut Vec<(RoleId, RoleId)>) -> Role {
    let sizes = [0, 1, 2].map(|axis: usize| one.sizes[axis].plus(&other.sizes[axis]));
    let mut role = Role { forms: BTreeMap::new(), sizes };
    let lists: BTreeSet<&Key> = one
        .forms
        .keys()
        .chain(other.forms.keys())
        .filter(|key| matches!(key, Key::List(_) | Key::Even(_)))
        .collect();
    for (own, others) in [(one, other), (other, one)] {
        for (key, form) in &own.forms {
            let options = match key {
                Key::Fixed { axis, .. } => {
                    let even = form.list.shares.as_ref().map(|_| Key::Even(*axis));
                    even.into_iter().chain([Key::List(*axis)]).collect()
                }
                _ => Vec::new(),
            };
            // Of two roles one may have lists where the other has rows that it has not.
            let list = options.into_iter().find(|list| {
                lists.contains(list) && !own.forms.contains_key(list) && !others.forms.contains_key(key)
            });
            enter(&mut role, list.unwrap_or_else(|| key.clone()), form, open);
        }
    }
    role
}

/// Adds a form to a role.
fn enter(role: &mut Role, key: Key, form: &Form, open: &mut Vec<(RoleId, RoleId)>) {
    let mut form = form.clone();
    if matches!(key, Key::List(_) | Key::Even(_)) {
        let first = form.children[0];
        open.extend(form.children.drain(1..).map(|child| (first, child)));
        form.fixed.clear();
    }
    match role.forms.get_mut(&key) {
        Some(known) => {
            open.extend(known.children.iter().copied().zip(form.children.iter().copied()));
            *known = known.plus(&form);
        }
        None => drop(role.forms.insert(key, form)),
    }
}

/// What it costs that places are of other sizes.
fn unalike(one: &Role, other: &Role) -> f64 {
    let differ = |(one, other): (&Hist, &Hist)| {
        let ((low, high), (other_low, other_high)) = (one.quartiles(), other.quartiles());
        low > ALIKE * other_high || other_low > ALIKE * high
    };
    UNALIKE * one.sizes.iter().zip(&other.sizes).filter(|pair| differ(*pair)).count() as f64
}
