//! The configuration: all shapes of a derivation so far.

use super::index::Index;
use crate::space::Bounds;
use smallvec::SmallVec;

/// The number of a shape. A parent has a lower one than its children.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct ShapeId(u32);

impl ShapeId {
    /// The start of the derivation.
    pub const FIRST: ShapeId = ShapeId(0);

    pub(super) fn index(self) -> usize {
        self.0 as usize
    }
}

/// The number of a label.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Label(pub u32);

/// The boxes of a shape, which share no cell: one most often, those of its footprint else.
pub type Boxes = SmallVec<[Bounds; 1]>;

/// Whether a shape has been replaced by what its rule makes of it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum State {
    Active,
    Replaced,
}

#[derive(Clone, Debug)]
pub struct Shape {
    pub parent: Option<ShapeId>,
    /// `None` for terminals.
    pub label: Option<Label>,
    pub boxes: Boxes,
    pub state: State,
    /// How many ancestors it has.
    depth: u32,
    /// An ancestor further up, so that an ancestor is found in steps as few as the logarithm of the depth. The first
    /// shape is its own.
    jump: ShapeId,
}

/// The shapes in the order in which they came. Replaced ones stay: queries may ask for them.
#[derive(Default)]
pub struct Configuration {
    shapes: Vec<Shape>,
    all: Index,
    /// One index for each label.
    labelled: Vec<Index>,
    /// How many of the shapes the indices know.
    indexed: usize,
}

impl Configuration {
    /// Adds an active shape. There is room for 2^32.
    pub fn add(&mut self, parent: Option<ShapeId>, label: Option<Label>, boxes: Boxes) -> ShapeId {
        let id = ShapeId(self.shapes.len() as u32);
        let (depth, jump) = parent.map_or((0, id), |parent| self.below(parent));
        self.shapes.push(Shape { parent, label, boxes, state: State::Active, depth, jump });
        id
    }

    pub fn replace(&mut self, shape: ShapeId) {
        self.shapes[shape.index()].state = State::Replaced;
    }

    pub fn len(&self) -> usize {
        self.shapes.len()
    }

    pub fn is_empty(&self) -> bool {
        self.shapes.is_empty()
    }

    /// The configuration for those who ask: shapes that came after the last refresh are not found.
    pub fn view(&self) -> Snapshot<'_> {
        Snapshot { configuration: self }
    }

    /// Makes all shapes ready to be found.
    pub fn refresh(&mut self) {
        let labels = self.shapes[self.indexed..].iter().filter_map(|shape| shape.label);
        let labels = labels.map(|label| label.0 as usize + 1).max().unwrap_or(0);
        self.labelled.resize_with(labels.max(self.labelled.len()), Index::default);
        let mut fresh = vec![Vec::new(); self.labelled.len()];
        let mut all = Vec::new();
        for (at, shape) in self.shapes.iter().enumerate().skip(self.indexed) {
            for bounds in &shape.boxes {
                let entry = (*bounds, ShapeId(at as u32));
                all.push(entry);
                if let Some(label) = shape.label {
                    fresh[label.0 as usize].push(entry);
                }
            }
        }
        self.all.extend(all);
        for (index, entries) in self.labelled.iter_mut().zip(fresh) {
            index.extend(entries);
        }
        self.indexed = self.shapes.len();
    }

    /// The depth and the jump of a child: jumps double as the digits of a skew binary number do.
    fn below(&self, parent: ShapeId) -> (u32, ShapeId) {
        let shape = &self.shapes[parent.index()];
        let near = &self.shapes[shape.jump.index()];
        let far = &self.shapes[near.jump.index()];
        let is_even = shape.depth - near.depth == near.depth - far.depth && shape.depth > 0;
        (shape.depth + 1, if is_even { near.jump } else { parent })
    }
}

/// A configuration whose shapes can all be found.
#[derive(Clone, Copy)]
pub struct Snapshot<'c> {
    configuration: &'c Configuration,
}

impl<'c> Snapshot<'c> {
    pub fn shape(&self, id: ShapeId) -> &'c Shape {
        &self.configuration.shapes[id.index()]
    }

    /// Whether `above` is `below` or one of its ancestors.
    pub fn is_within(&self, below: ShapeId, above: ShapeId) -> bool {
        let target = self.shape(above).depth;
        let mut at = below;
        while self.shape(at).depth > target {
            let shape = self.shape(at);
            let is_too_far = self.shape(shape.jump).depth < target;
            at = match shape.parent {
                Some(parent) if is_too_far => parent,
                _ => shape.jump,
            };
        }
        at == above
    }

    /// Whether one of two shapes is the other or an ancestor of it.
    pub fn are_kin(&self, one: ShapeId, other: ShapeId) -> bool {
        self.is_within(one, other) || self.is_within(other, one)
    }

    /// The shapes with a box that meets or touches the box, one entry for each such box.
    pub(super) fn near(&self, bounds: Bounds) -> impl Iterator<Item = (Bounds, ShapeId)> + use<'c> {
        self.configuration.all.near(bounds)
    }

    /// The shapes of a label; none where the label is not in use.
    pub(super) fn labelled(&self, label: Label) -> Option<&'c Index> {
        self.configuration.labelled.get(label.0 as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use smallvec::smallvec;

    proptest! {
        #[test]
        fn ancestors_are_those_that_parents_lead_to(parents in prop::collection::vec(any::<prop::sample::Index>(), 0..60)) {
            let mut configuration = Configuration::default();
            let mut ids = vec![configuration.add(None, None, smallvec![])];
            for parent in parents {
                // Most shapes hang on a late one, so that the tree is deep.
                let late = ids.len() - 1 - parent.index(ids.len()).min(2).min(ids.len() - 1);
                ids.push(configuration.add(Some(ids[late]), None, smallvec![]));
            }
            configuration.refresh();
        let snapshot = configuration.view();
            for &below in &ids {
                let chain: Vec<ShapeId> =
                    std::iter::successors(Some(below), |id| snapshot.shape(*id).parent).collect();
                for &above in &ids {
                    prop_assert_eq!(snapshot.is_within(below, above), chain.contains(&above));
                }
            }
        }
    }
}
