//! From places to roles: what stands in one place of one form is one role, from the whole examples down.

use super::forest::{Forest, Kind, PlaceId, Shape};
use super::form::{Behind, Form, Key, Lengths, Slot, entropy, fixed_bits, fixed_lengths};
use super::hist::Hist;
use super::role::{Role, RoleId, Roles};
use super::row::{Row, Unit};
use crate::space::Axis;
use std::collections::{BTreeMap, BTreeSet, VecDeque};

/// More orders of units in one role than these are lists.
const MOST_ORDERS: usize = 8;

/// The roles of all places, and that of the roots, where a rule has to be worth `price` bits.
pub fn explain(forest: &Forest, price: f64) -> (Roles, RoleId) {
    let mut explainer =
        Explainer { forest, holds: Holds::of(forest), roles: Roles::new(price), open: VecDeque::new() };
    let root = explainer.role(forest.roots.clone());
    while let Some((id, places)) = explainer.open.pop_front() {
        explainer.complete(id, &places);
    }
    (explainer.roles, root)
}

struct Explainer<'f> {
    forest: &'f Forest,
    holds: Holds,
    roles: Roles,
    open: VecDeque<(RoleId, Vec<PlaceId>)>,
}

impl Explainer<'_> {
    /// The role of places, which is explained later.
    fn role(&mut self, places: Vec<PlaceId>) -> RoleId {
        let id = self.roles.add(Role::default());
        self.open.push_back((id, places));
        id
    }

    fn complete(&mut self, id: RoleId, places: &[PlaceId]) {
        let mut forms = BTreeMap::new();
        for (key, rows) in self.forms(places) {
            let source = self.roles.places.len() as u32;
            let mut form = Form::of(&key, &rows, source);
            form.children = self.children(&key, &rows);
            self.roles.places.push(rows.iter().map(|row| row.place).collect());
            forms.insert(key, form);
        }
        let size = |axis: Axis| Hist::of(places.iter().map(|place| axis.of(self.forest.place(*place).size)));
        self.roles.list[id.0 as usize] = Role { forms, sizes: Axis::ALL.map(size) };
    }

    fn children(&mut self, key: &Key, rows: &[Row]) -> Vec<RoleId> {
        match key {
            Key::Nil | Key::Leaf(_) => Vec::new(),
            Key::Even(_) | Key::List(_) => vec![self.role(units(rows).collect())],
            Key::Fixed { slots, .. } => (0..slots.len())
                .map(|at| self.role(rows.iter().map(|row| row.units[at].place).collect()))
                .collect(),
        }
    }

    /// The forms of places with their rows.
    fn forms(&self, places: &[PlaceId]) -> Vec<(Key, Vec<Row>)> {
        let mut kinds: BTreeMap<Kind, Vec<PlaceId>> = BTreeMap::new();
        places.iter().for_each(|place| kinds.entry(self.forest.kind(*place)).or_default().push(*place));
        let count = |axis: &Axis| kinds.get(&Kind::Split(*axis)).map_or(0, Vec::len);
        let mut axes = Axis::ALL;
        axes.sort_by_key(|axis| (std::cmp::Reverse(count(axis)), *axis));
        let mut forms = Vec::new();
        for axis in axes {
            let Some(places) = kinds.remove(&Kind::Split(axis)) else { continue };
            let mut rows = self.rows(axis, &places);
            for kind in self.trimmed(axis, &rows) {
                rows.extend(kinds.remove(&kind).iter().flat_map(|places| self.rows(axis, places)));
            }
            forms.extend(self.orders(axis, rows));
        }
        forms.extend(kinds.into_iter().map(|(kind, places)| match kind {
            Kind::Leaf(label) => (Key::Leaf(label), self.rows(Axis::Y, &places)),
            _ => (
                Key::Nil,
                places.into_iter().map(|place| Row { place, lead: 0, units: Vec::new() }).collect(),
            ),
        }));
        forms
    }

    fn rows(&self, axis: Axis, places: &[PlaceId]) -> Vec<Row> {
        places.iter().map(|place| Row::of(self.forest, *place, axis)).collect()
    }

    /// What stands alone in rows with space at an end: places of that kind are such rows without any.
    fn trimmed(&self, axis: Axis, rows: &[Row]) -> BTreeSet<Kind> {
        let alone = rows.iter().filter(|row| row.units.len() == 1);
        let kinds = alone.map(|row| self.forest.kind(row.units[0].place));
        kinds.filter(|kind| *kind != Kind::Split(axis)).collect()
    }

    /// Rows along an axis: even ones, those of one order, and lists, as it is the shortest.
    fn orders(&self, axis: Axis, rows: Vec<Row>) -> Vec<(Key, Vec<Row>)> {
        let (even, rest): (Vec<Row>, Vec<Row>) = rows.iter().cloned().partition(Row::is_even);
        let (bits, all) = self.ordered(axis, rows);
        if even.is_empty() {
            return all;
        }
        let (rest_bits, mut split) = self.ordered(axis, rest.clone());
        let choice = entropy([even.len() as u32, rest.len() as u32]);
        if self.even_bits(&even) + rest_bits + choice >= bits {
            return all;
        }
        split.push((Key::Even(axis), even));
        split
    }

    /// Rows by the order of their units, as far as that is shorter than lists, with the bits of it.
    fn ordered(&self, axis: Axis, rows: Vec<Row>) -> (f64, Vec<(Key, Vec<Row>)>) {
        let mut orders: BTreeMap<Vec<Slot>, Vec<Row>> = BTreeMap::new();
        for row in rows {
            orders.entry(self.slots(&row)).or_default().push(row);
        }
        let mut orders: Vec<(Vec<Slot>, Vec<Row>)> = orders.into_iter().collect();
        orders.sort_by(|(one, rows), (other, others)| others.len().cmp(&rows.len()).then(one.cmp(other)));
        let (bits, fixed) = self.best_count(&orders);
        let listed: Vec<Row> = orders.split_off(fixed).into_iter().flat_map(|(_, rows)| rows).collect();
        let fixed = orders.into_iter().map(|(slots, rows)| (Key::Fixed { axis, slots }, rows));
        let list = Some((Key::List(axis), listed)).filter(|(_, rows)| !rows.is_empty());
        (bits, fixed.chain(list).collect())
    }

    fn even_bits(&self, rows: &[Row]) -> f64 {
        self.roles.price
            + Hist::of(rows.iter().map(|row| row.units.len() as i32)).bits()
            + self.set_bits(units(rows))
    }

    /// How many of the orders are worth a form of their own.
    fn best_count(&self, orders: &[(Vec<Slot>, Vec<Row>)]) -> (f64, usize) {
        let most = orders.len().min(MOST_ORDERS);
        let bits = |fixed: usize| {
            let own: f64 = orders[..fixed].iter().map(|(slots, rows)| self.fixed_bits(slots, rows)).sum();
            let rest: Vec<Row> = orders[fixed..].iter().flat_map(|(_, rows)| rows.iter().cloned()).collect();
            let counts = orders[..fixed].iter().map(|(_, rows)| rows.len() as u32);
            own + self.list_bits(&rest) + entropy(counts.chain([rest.len() as u32]))
        };
        let order = |one: &(usize, f64), other: &(usize, f64)| one.1.total_cmp(&other.1);
        (0..=most)
            .map(|fixed| (fixed, bits(fixed)))
            .min_by(order)
            .map_or((0.0, 0), |(fixed, bits)| (bits, fixed))
    }

    fn fixed_bits(&self, slots: &[Slot], rows: &[Row]) -> f64 {
        let units = (0..slots.len()).map(|at| self.set_bits(rows.iter().map(|row| row.units[at].place)));
        self.roles.price + fixed_bits(&fixed_lengths(slots.len(), rows)) + units.sum::<f64>()
    }

    fn list_bits(&self, rows: &[Row]) -> f64 {
        if rows.is_empty() {
            return 0.0;
        }
        2.0 * self.roles.price + Lengths::of(rows).bits() + self.set_bits(units(rows))
    }

    /// About the bits of what places are.
    fn set_bits(&self, places: impl Iterator<Item = PlaceId>) -> f64 {
        let mut kinds: BTreeMap<(Kind, u32), u32> = BTreeMap::new();
        places.for_each(|place| {
            *kinds.entry((self.forest.kind(place), self.holds.of_place(place))).or_default() += 1
        });
        let own = |(kind, _): &(Kind, u32)| match kind {
            Kind::Nil | Kind::Leaf(_) => LEAF,
            Kind::Split(_) => SPLIT,
        };
        kinds.keys().map(own).sum::<f64>() + entropy(kinds.values().copied())
    }

    fn slots(&self, row: &Row) -> Vec<Slot> {
        let last = row.units.len() - 1;
        let slot = |(at, unit): (usize, &Unit)| Slot {
            kind: self.forest.kind(unit.place),
            holds: self.holds.of_place(unit.place),
            behind: if at < last && unit.gap > 0 { Behind::Gap } else { Behind::Unit },
        };
        row.units.iter().enumerate().map(slot).collect()
    }
}

/// The places of all units of rows.
fn units(rows: &[Row]) -> impl Iterator<Item = PlaceId> {
    rows.iter().flat_map(|row| row.units.iter().map(|unit| unit.place))
}

/// About the bits of a leaf and a split.
const LEAF: f64 = 4.0;
const SPLIT: f64 = 14.0;

/// Which labels each place holds, as the number of the set of them.
struct Holds(Vec<u32>);

impl Holds {
    fn of(forest: &Forest) -> Holds {
        let mut sets: BTreeMap<BTreeSet<u32>, u32> = BTreeMap::new();
        let mut all: Vec<BTreeSet<u32>> = Vec::new();
        let mut numbers: Vec<u32> = Vec::with_capacity(forest.len());
        for id in forest.ids() {
            let own: BTreeSet<u32> = match &forest.place(id).shape {
                Shape::Nil => BTreeSet::new(),
                Shape::Leaf(label) => BTreeSet::from([*label]),
                Shape::Split { parts, .. } => {
                    let below: BTreeSet<u32> =
                        parts.iter().map(|part| numbers[part.place.0 as usize]).collect();
                    below.iter().flat_map(|set| all[*set as usize].iter().copied()).collect()
                }
            };
            let next = all.len() as u32;
            let number = *sets.entry(own.clone()).or_insert(next);
            if number == next {
                all.push(own);
            }
            numbers.push(number);
        }
        Holds(numbers)
    }

    fn of_place(&self, id: PlaceId) -> u32 {
        self.0[id.0 as usize]
    }
}
