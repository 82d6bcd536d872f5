//! Empty space is handed inwards: where a whole is trimmed at an end and so are some of its parts, all of them take
//! the space of the whole. The tallest tower of a row then has the same form as the others.

use super::forest::{Forest, Place, PlaceId, Shape, Slice, resized};
use crate::parse::stacked;
use crate::space::{Axis, Cell};

/// Empty space along an axis, in cells.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Padding {
    axis: Axis,
    low: i32,
    high: i32,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum End {
    Low,
    High,
}

/// The same boxes, with empty space as far inwards as it belongs.
pub fn padded_inwards(forest: &Forest) -> Forest {
    let mut padder = Padder { old: forest, new: Forest::default() };
    let roots = forest.roots.iter().map(|root| padder.copied(*root)).collect();
    padder.new.roots = roots;
    padder.new
}

struct Padder<'f> {
    old: &'f Forest,
    new: Forest,
}

impl Padder<'_> {
    fn copied(&mut self, id: PlaceId) -> PlaceId {
        stacked(|| {
            let place = self.old.place(id);
            match &place.shape {
                Shape::Split { axis, parts } => match self.trimmed(*axis, parts) {
                    Some((padding, inner)) => self.padded(inner, padding),
                    None => {
                        let parts = parts
                            .iter()
                            .map(|part| Slice { place: self.copied(part.place), ..*part })
                            .collect();
                        self.new.add(Place { shape: Shape::Split { axis: *axis, parts }, ..*place })
                    }
                },
                _ => self.new.add(place.clone()),
            }
        })
    }

    /// The only part of a split that is not empty, with the space at its ends.
    fn trimmed(&self, axis: Axis, parts: &[Slice]) -> Option<(Padding, PlaceId)> {
        let is_nil = |part: &Slice| matches!(self.old.place(part.place).shape, Shape::Nil);
        let mut full = parts.iter().filter(|part| !is_nil(part));
        let inner = full.next().filter(|_| full.next().is_none())?.place;
        let len = |part: Option<&Slice>| part.filter(|part| is_nil(part)).map_or(0, |part| part.len);
        Some((Padding { axis, low: len(parts.first()), high: len(parts.last()) }, inner))
    }

    /// What a place becomes with empty space at its ends.
    fn padded(&mut self, id: PlaceId, padding: Padding) -> PlaceId {
        stacked(|| self.pad(id, padding))
    }

    fn pad(&mut self, id: PlaceId, padding: Padding) -> PlaceId {
        let Padding { axis, low, high } = padding;
        if low == 0 && high == 0 {
            return self.copied(id);
        }
        let place = self.old.place(id);
        match &place.shape {
            Shape::Split { axis: own, parts } if *own != axis => {
                let is_trimmed = |end| parts.iter().any(|part| self.is_trimmed(part.place, axis, end));
                let inner = Padding {
                    axis,
                    low: if is_trimmed(End::Low) { low } else { 0 },
                    high: if is_trimmed(End::High) { high } else { 0 },
                };
                let outer = Padding { axis, low: low - inner.low, high: high - inner.high };
                let split = self.pad_parts(id, inner);
                self.wrapped(split, outer)
            }
            Shape::Split { parts, .. } => match self.trimmed(axis, parts) {
                Some((own, inner)) => {
                    self.padded(inner, Padding { low: low + own.low, high: high + own.high, axis })
                }
                None => {
                    let copied = self.copied(id);
                    self.wrapped(copied, padding)
                }
            },
            _ => {
                let copied = self.copied(id);
                self.wrapped(copied, padding)
            }
        }
    }

    /// A split across the axis of the space, which each of its parts takes.
    fn pad_parts(&mut self, id: PlaceId, padding: Padding) -> PlaceId {
        let place = self.old.place(id);
        let Shape::Split { axis, parts } = &place.shape else { return self.copied(id) };
        if padding.low == 0 && padding.high == 0 {
            return self.copied(id);
        }
        let parts =
            parts.iter().map(|part| Slice { place: self.padded(part.place, padding), ..*part }).collect();
        let len = padding.axis.of(place.size) + padding.low + padding.high;
        let size = resized(place.size, padding.axis, len);
        self.new.add(Place { size, shape: Shape::Split { axis: *axis, parts } })
    }

    /// A new place between empty ones.
    fn wrapped(&mut self, id: PlaceId, padding: Padding) -> PlaceId {
        let Padding { axis, low, high } = padding;
        if low == 0 && high == 0 {
            return id;
        }
        let place = self.new.place(id).clone();
        let (size, len) = (place.size, axis.of(place.size));
        let size = resized(size, axis, len + low + high);
        if matches!(place.shape, Shape::Nil) {
            return self.new.add(Place { size, shape: Shape::Nil });
        }
        let inner = match place.shape {
            Shape::Split { axis: own, parts } if own == axis => parts,
            _ => vec![Slice { len, place: id }],
        };
        let mut parts = Vec::with_capacity(inner.len() + 2);
        self.append(&mut parts, axis, size, low);
        parts.extend(inner);
        let trailing =
            parts.last().copied().filter(|last| matches!(self.new.place(last.place).shape, Shape::Nil));
        if trailing.is_some() {
            parts.pop();
        }
        self.append(&mut parts, axis, size, high + trailing.map_or(0, |last| last.len));
        if let [first, second, ..] = parts[..]
            && [first, second].iter().all(|part| matches!(self.new.place(part.place).shape, Shape::Nil))
        {
            parts.drain(..2);
            let mut joined = Vec::new();
            self.append(&mut joined, axis, size, first.len + second.len);
            parts.splice(0..0, joined);
        }
        self.new.add(Place { size, shape: Shape::Split { axis, parts } })
    }

    fn append(&mut self, parts: &mut Vec<Slice>, axis: Axis, size: Cell, len: i32) {
        if len > 0 {
            let place = self.new.add(Place { size: resized(size, axis, len), shape: Shape::Nil });
            parts.push(Slice { len, place });
        }
    }

    /// Whether a place, or some part of it that reaches as far, ends in empty space.
    fn is_trimmed(&self, id: PlaceId, axis: Axis, end: End) -> bool {
        stacked(|| match &self.old.place(id).shape {
            Shape::Split { axis: own, parts } if *own == axis => {
                let last = if end == End::Low { parts.first() } else { parts.last() };
                last.is_some_and(|part| matches!(self.old.place(part.place).shape, Shape::Nil))
            }
            Shape::Split { parts, .. } => parts.iter().any(|part| self.is_trimmed(part.place, axis, end)),
            _ => false,
        })
    }
}
