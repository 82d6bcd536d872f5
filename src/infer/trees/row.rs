//! A place along an axis: things with gaps between them.

use super::forest::{Forest, PlaceId, Shape};
use crate::space::{Axis, shares};

/// What stands along an axis. Lengths are in cells.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Row {
    pub place: PlaceId,
    /// The space before the first unit.
    pub lead: i32,
    pub units: Vec<Unit>,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Unit {
    pub len: i32,
    /// The space behind it.
    pub gap: i32,
    pub place: PlaceId,
}

impl Row {
    /// A place that is not empty; one that is not divided along the axis is a row of itself.
    pub fn of(forest: &Forest, id: PlaceId, axis: Axis) -> Row {
        let place = forest.place(id);
        let mut row = Row { place: id, lead: 0, units: Vec::new() };
        match &place.shape {
            Shape::Split { axis: own, parts } if *own == axis => {
                for part in parts {
                    match (&forest.place(part.place).shape, row.units.last_mut()) {
                        (Shape::Nil, Some(last)) => last.gap += part.len,
                        (Shape::Nil, None) => row.lead += part.len,
                        _ => row.units.push(Unit { len: part.len, gap: 0, place: part.place }),
                    }
                }
            }
            _ => row.units.push(Unit { len: axis.of(place.size), gap: 0, place: id }),
        }
        row
    }

    /// The space before, then each unit and the gap behind it.
    pub fn lengths(&self) -> Vec<i32> {
        let units = self.units.iter().flat_map(|unit| [unit.len, unit.gap]);
        std::iter::once(self.lead).chain(units).collect()
    }

    /// The space behind the last unit.
    pub fn tail(&self) -> i32 {
        self.units.last().map_or(0, |unit| unit.gap)
    }

    pub fn len(&self) -> i32 {
        self.lead + self.units.iter().map(|unit| unit.len + unit.gap).sum::<i32>()
    }

    /// Whether its units are equal shares of it, as whole cells allow, without any space.
    pub fn is_even(&self) -> bool {
        let shares = shares(self.len(), self.units.len() as u32).map(|(low, high)| (high - low, 0));
        self.units.len() > 1
            && self.lead == 0
            && shares.eq(self.units.iter().map(|unit| (unit.len, unit.gap)))
    }

    /// The lengths of the units that others follow.
    pub fn followed(&self) -> impl Iterator<Item = i32> {
        let inner = self.units.len().saturating_sub(1);
        self.units[..inner].iter().map(|unit| unit.len)
    }

    /// The gaps between units.
    pub fn gaps(&self) -> impl Iterator<Item = i32> {
        let inner = self.units.len().saturating_sub(1);
        self.units[..inner].iter().map(|unit| unit.gap)
    }
}
