//! The trees of all examples as places with their sizes.

use crate::infer::tree::{Node, Tree};
use crate::space::{Axis, Bounds, Cell};

/// The number of a place, children before parents.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct PlaceId(pub u32);

/// A box of an example, and how it is divided.
#[derive(Clone, Debug)]
pub struct Place {
    /// In cells.
    pub size: Cell,
    pub shape: Shape,
}

#[derive(Clone, Debug)]
pub enum Shape {
    Nil,
    Leaf(u32),
    /// Side by side along the axis, from its low end.
    Split {
        axis: Axis,
        parts: Vec<Slice>,
    },
}

/// A part of a split: its length in cells, at least 1, and what it holds.
#[derive(Clone, Copy, Debug)]
pub struct Slice {
    pub len: i32,
    pub place: PlaceId,
}

/// All that can be told of a place without looking into it.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Kind {
    Nil,
    Leaf(u32),
    Split(Axis),
}

#[derive(Clone, Default, Debug)]
pub struct Forest {
    places: Vec<Place>,
    pub roots: Vec<PlaceId>,
}

impl Forest {
    /// The trees with their boxes.
    pub fn plant<'t>(trees: impl IntoIterator<Item = (&'t Tree, Bounds)>) -> Forest {
        let mut forest = Forest::default();
        for (tree, bounds) in trees {
            let root = forest.plant_tree(tree, bounds);
            forest.roots.push(root);
        }
        forest
    }

    /// Adds the places of a tree, children first.
    fn plant_tree(&mut self, tree: &Tree, bounds: Bounds) -> PlaceId {
        let order = tree.in_levels(bounds);
        let last = self.places.len() + order.len() - 1;
        let number = |at: usize| PlaceId((last - at) as u32);
        for (id, bounds, children) in order.into_iter().rev() {
            let shape = match tree.node(id) {
                Node::Nil => Shape::Nil,
                Node::Leaf(label) => Shape::Leaf(label),
                Node::Split { axis, parts } => {
                    let slice = |(at, len)| Slice { len, place: number(children + at) };
                    let parts = parts.iter().map(|part| part.len).enumerate().map(slice).collect();
                    Shape::Split { axis, parts }
                }
            };
            self.places.push(Place { size: bounds.size(), shape });
        }
        number(0)
    }

    pub fn add(&mut self, place: Place) -> PlaceId {
        self.places.push(place);
        PlaceId(self.places.len() as u32 - 1)
    }

    pub fn place(&self, id: PlaceId) -> &Place {
        &self.places[id.0 as usize]
    }

    pub fn kind(&self, id: PlaceId) -> Kind {
        match self.place(id).shape {
            Shape::Nil => Kind::Nil,
            Shape::Leaf(label) => Kind::Leaf(label),
            Shape::Split { axis, .. } => Kind::Split(axis),
        }
    }

    /// How many places there are; their numbers are those below it.
    pub fn len(&self) -> usize {
        self.places.len()
    }

    /// All places, children before parents.
    pub fn ids(&self) -> impl Iterator<Item = PlaceId> + use<> {
        (0..self.places.len() as u32).map(PlaceId)
    }
}

/// A size with another length along an axis.
pub fn resized(size: Cell, axis: Axis, len: i32) -> Cell {
    size + axis.unit() * (len - axis.of(size))
}
