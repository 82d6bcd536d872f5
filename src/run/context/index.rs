use super::ShapeId;
use crate::space::{Bounds, Corners};
use rstar::primitives::GeomWithData;
use rstar::{RTree, RTreeObject};

/// Boxes in space with the shapes they belong to.
#[derive(Default)]
pub struct Index {
    tree: RTree<Entry>,
}

type Entry = GeomWithData<Corners, ShapeId>;

impl Index {
    /// Adds boxes. Many at once are packed together with those that are there: that is faster than to insert them one
    /// by one, and so is asking afterwards.
    pub fn extend(&mut self, fresh: Vec<(Bounds, ShapeId)>) {
        let entries = fresh.into_iter().map(|(bounds, shape)| GeomWithData::new(Corners(bounds), shape));
        if entries.len() >= self.tree.size() {
            let known = std::mem::take(&mut self.tree);
            self.tree = RTree::bulk_load(known.into_iter().chain(entries).collect());
        } else {
            entries.for_each(|entry| self.tree.insert(entry));
        }
    }

    /// The boxes that share a cell with the given one, or touch it.
    pub fn near(&self, bounds: Bounds) -> impl Iterator<Item = (Bounds, ShapeId)> {
        let found = self.tree.locate_in_envelope_intersecting(Corners(bounds).envelope());
        found.map(|entry| (entry.geom().0, entry.data))
    }

    /// Whether no box reaches beyond the given one.
    pub fn lies_within(&self, bounds: &Bounds) -> bool {
        let (outer, inner) = (Corners(*bounds).envelope(), self.tree.root().envelope());
        rstar::Envelope::contains_envelope(&outer, &inner)
    }
}
