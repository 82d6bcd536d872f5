//! Forms: what the places of one role look like, and what it takes to say so.

use super::forest::Kind;
use super::hist::Hist;
use super::role::RoleId;
use super::row::Row;
use crate::infer::joint::estimate::choice;
use crate::infer::joint::laws::integer;
use crate::space::Axis;

/// What places of one form have in common.
#[derive(Clone, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Key {
    Nil,
    Leaf(u32),
    /// Units in this order.
    Fixed {
        axis: Axis,
        slots: Vec<Slot>,
    },
    /// Equal shares of one role.
    Even(Axis),
    /// Any number of units of one role.
    List(Axis),
}

/// A unit of a row of known order.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct Slot {
    pub kind: Kind,
    /// The number of the set of labels in it.
    pub holds: u32,
    pub behind: Behind,
}

/// What lies between a unit and the next.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Behind {
    Unit,
    Gap,
}

/// The places of one form in one role.
#[derive(Clone, Debug)]
pub struct Form {
    pub count: u32,
    /// Of a fixed row, the space before, each unit with the gap behind it.
    pub fixed: Vec<Hist>,
    pub list: Lengths,
    /// The roles of the units; of a list, the one of them all.
    pub children: Vec<RoleId>,
    /// The numbers of the sets of places that have it.
    pub sources: Vec<u32>,
}

/// The lengths of rows as lists, in cells.
#[derive(Clone, Default, Debug)]
pub struct Lengths {
    pub lead: Hist,
    /// Units that others follow: the last one takes what is left.
    pub unit: Hist,
    pub gap: Hist,
    pub tail: Hist,
    pub rows: u32,
    /// How many shares there are, if all rows are even.
    pub shares: Option<Hist>,
}

impl Lengths {
    pub fn of(rows: &[Row]) -> Lengths {
        Lengths {
            lead: Hist::of(rows.iter().map(|row| row.lead)),
            unit: Hist::of(rows.iter().flat_map(Row::followed)),
            gap: Hist::of(rows.iter().flat_map(Row::gaps)),
            tail: Hist::of(rows.iter().map(Row::tail)),
            rows: rows.len() as u32,
            shares: rows
                .iter()
                .all(Row::is_even)
                .then(|| Hist::of(rows.iter().map(|row| row.units.len() as i32))),
        }
    }

    pub fn plus(&self, other: &Lengths) -> Lengths {
        Lengths {
            lead: self.lead.plus(&other.lead),
            unit: self.unit.plus(&other.unit),
            gap: self.gap.plus(&other.gap),
            tail: self.tail.plus(&other.tail),
            rows: self.rows + other.rows,
            shares: self.shares.as_ref().zip(other.shares.as_ref()).map(|(own, other)| own.plus(other)),
        }
    }

    /// The bits of all lengths and of where rows end.
    pub fn bits(&self) -> f64 {
        let ends = entropy([self.rows, self.gap.count()]);
        self.lead.bits() + self.unit.bits() + self.gap.bits() + self.tail.bits() + ends
    }
}

/// The bits of a part of a row, and of a reference to a role.
const PART: f64 = 4.0;

impl Form {
    pub fn of(key: &Key, rows: &[Row], source: u32) -> Form {
        let fixed = match key {
            Key::Fixed { slots, .. } => fixed_lengths(slots.len(), rows),
            _ => Vec::new(),
        };
        let list = Lengths::of(rows);
        Form { count: rows.len() as u32, fixed, list, children: Vec::new(), sources: vec![source] }
    }

    pub fn plus(&self, other: &Form) -> Form {
        let fixed = self.fixed.iter().zip(&other.fixed).map(|(own, other)| own.plus(other));
        Form {
            count: self.count + other.count,
            fixed: fixed.collect(),
            list: self.list.plus(&other.list),
            children: self.children.clone(),
            sources: self.sources.iter().chain(&other.sources).copied().collect(),
        }
    }

    /// The bits of its rules, each of them at a price, and of all lengths, but not of what the units are.
    pub fn bits(&self, key: &Key, price: f64) -> f64 {
        price
            + match key {
                Key::Nil => 0.0,
                Key::Leaf(_) => PART,
                Key::Fixed { slots, .. } => PART * slots.len() as f64 + fixed_bits(&self.fixed),
                Key::Even(_) => PART + self.list.shares.as_ref().map_or(0.0, Hist::bits),
                Key::List(_) => price + PART + self.list.bits(),
            }
    }
}

/// One part floats: its length is what the others leave.
pub fn fixed_bits(parts: &[Hist]) -> f64 {
    let bits = || parts.iter().map(Hist::bits);
    bits().sum::<f64>() - bits().fold(0.0, f64::max) + integer(parts.len() as i32)
}

/// The lengths of the space before, and of each unit and the gap behind it.
pub fn fixed_lengths(units: usize, rows: &[Row]) -> Vec<Hist> {
    let unit = |at: usize| rows.iter().map(move |row| row.units[at]);
    let pairs = (0..units)
        .flat_map(|at| [Hist::of(unit(at).map(|unit| unit.len)), Hist::of(unit(at).map(|unit| unit.gap))]);
    std::iter::once(Hist::of(rows.iter().map(|row| row.lead))).chain(pairs).collect()
}

/// The bits of telling which of several things each of so many is.
pub fn entropy(counts: impl IntoIterator<Item = u32>) -> f64 {
    let counts: Vec<u32> = counts.into_iter().filter(|count| *count > 0).collect();
    choice(counts.iter())
}
