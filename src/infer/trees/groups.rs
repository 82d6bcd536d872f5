//! Things that stand side by side without space between them are one group, where other space divides the row.

use super::forest::{Forest, Place, PlaceId, Shape, Slice, resized};
use crate::space::{Axis, Cell};

/// The same boxes; rows that space divides are rows of groups.
pub fn grouped(forest: &Forest) -> Forest {
    let mut grouper = Grouper { old: forest, new: Forest::default() };
    let new: Vec<PlaceId> =
        forest.ids().scan(Vec::new(), |known, id| Some(grouper.copied(id, known))).collect();
    grouper.new.roots = forest.roots.iter().map(|root| new[root.0 as usize]).collect();
    grouper.new
}

struct Grouper<'f> {
    old: &'f Forest,
    new: Forest,
}

impl Grouper<'_> {
    /// A place of which all parts were copied; `known` has what they became.
    fn copied(&mut self, id: PlaceId, known: &mut Vec<PlaceId>) -> PlaceId {
        let place = self.old.place(id);
        let shape = match &place.shape {
            Shape::Split { axis, parts } => {
                let parts: Vec<Slice> =
                    parts.iter().map(|part| Slice { place: known[part.place.0 as usize], ..*part }).collect();
                Shape::Split { axis: *axis, parts: self.parts(*axis, place.size, parts) }
            }
            shape => shape.clone(),
        };
        let new = self.new.add(Place { size: place.size, shape });
        known.push(new);
        new
    }

    fn parts(&mut self, axis: Axis, size: Cell, parts: Vec<Slice>) -> Vec<Slice> {
        let is_nil = |part: &Slice| matches!(self.new.place(part.place).shape, Shape::Nil);
        let runs: Vec<Vec<Slice>> =
            parts.chunk_by(|one, other| !is_nil(one) && !is_nil(other)).map(<[Slice]>::to_vec).collect();
        let full = runs.iter().filter(|run| !is_nil(&run[0])).count();
        if full < 2 {
            return parts;
        }
        runs.into_iter().map(|run| self.group(axis, size, run)).collect()
    }

    fn group(&mut self, axis: Axis, size: Cell, run: Vec<Slice>) -> Slice {
        if let [only] = run[..] {
            return only;
        }
        let len = run.iter().map(|part| part.len).sum();
        let place = Place { size: resized(size, axis, len), shape: Shape::Split { axis, parts: run } };
        Slice { len, place: self.new.add(place) }
    }
}
