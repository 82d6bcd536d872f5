//! Occlusion: how much of a shape the others cover.

use super::cover::covers;
use super::{Label, ShapeId, Snapshot, State};
use crate::space::{Bounds, Cell};
use smallvec::SmallVec;

/// How much of a shape the others cover.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Occlusion {
    /// No cell is shared.
    None,
    Part,
    /// Every cell lies in another shape; several may share them out among themselves.
    Full,
}

/// Which shapes count. The one that asks never does.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Against {
    All,
    /// Those that are not replaced yet.
    Active,
    /// All but the ancestors.
    NoParent,
    /// Those of a label, but for the ancestors.
    Label(Label),
}

/// Who asks: a scope, and the shape in whose rule it stands.
#[derive(Clone, Copy, Debug)]
pub struct Asker<'b> {
    pub shape: ShapeId,
    pub boxes: &'b [Bounds],
}

impl<'c> Snapshot<'c> {
    /// A shape as it asks for itself.
    pub fn asker(&self, shape: ShapeId) -> Asker<'c> {
        Asker { shape, boxes: &self.shape(shape).boxes }
    }

    /// How much of the asker the others cover, once each of its boxes has grown by `distance` blocks on all six
    /// sides. So with a distance of 1 a shape beside it is part of the answer, and one across a corner as well.
    /// Shapes without a cell, flat ones, cover nothing, and nothing covers them unless they grow.
    pub fn occlusion(&self, asker: Asker<'_>, against: Against, distance: i32) -> Occlusion {
        let grown: SmallVec<[Bounds; 1]> = asker.boxes.iter().map(|bounds| grown(bounds, distance)).collect();
        let mut answers = grown.iter().filter(|bounds| !bounds.is_empty()).map(|bounds| {
            let others = self.met(asker.shape, against, bounds);
            match others.is_empty() {
                true => Occlusion::None,
                false if covers(others, bounds) => Occlusion::Full,
                false => Occlusion::Part,
            }
        });
        let Some(first) = answers.next() else { return Occlusion::None };
        match answers.all(|answer| answer == first) {
            true => first,
            false => Occlusion::Part,
        }
    }

    /// The boxes of the shapes that count and share a cell with `bounds`.
    fn met(&self, asker: ShapeId, against: Against, bounds: &Bounds) -> Vec<Bounds> {
        let meets = |other: &Bounds| !other.intersect(bounds).is_empty() && !other.is_empty();
        let counts = |(other, shape): (Bounds, ShapeId)| {
            (meets(&other) && self.counts(asker, against, shape)).then_some(other)
        };
        match against {
            Against::Label(label) => self
                .labelled(label)
                .map_or_else(Vec::new, |index| index.near(*bounds).filter_map(counts).collect()),
            _ => self.near(*bounds).filter_map(counts).collect(),
        }
    }

    fn counts(&self, asker: ShapeId, against: Against, shape: ShapeId) -> bool {
        match against {
            Against::All => shape != asker,
            Against::Active => shape != asker && self.shape(shape).state == State::Active,
            Against::NoParent | Against::Label(_) => !self.is_within(asker, shape),
        }
    }
}

/// The box grown by `distance` blocks on every side, within what coordinates can say. Less than none is none.
pub(super) fn grown(bounds: &Bounds, distance: i32) -> Bounds {
    let by = Cell::splat(distance.max(0));
    Bounds::new(bounds.min.saturating_sub(by), bounds.max.saturating_add(by))
}

#[cfg(test)]
mod tests {
    use super::super::Configuration;
    use super::*;
    use proptest::prelude::*;
    use smallvec::smallvec;

    /// Shapes of three labels, terminals and replaced ones, each below any of the earlier.
    #[derive(Clone, Debug)]
    struct Given {
        parent: prop::sample::Index,
        label: Option<u32>,
        boxes: Vec<Bounds>,
        is_replaced: bool,
    }

    fn bounds() -> impl Strategy<Value = Bounds> {
        ([-4..4i32, -4..4, -4..4], [0..6i32, 0..6, 0..6])
            .prop_map(|(min, size)| Bounds::new(Cell::from(min), Cell::from(min) + Cell::from(size)))
    }

    fn given() -> impl Strategy<Value = Given> {
        let boxes = prop::collection::vec(bounds(), 1..3);
        (any::<prop::sample::Index>(), prop::option::of(0..3u32), boxes, any::<bool>())
            .prop_map(|(parent, label, boxes, is_replaced)| Given { parent, label, boxes, is_replaced })
    }

    fn configuration(given: &[Given], snapshot_at: usize) -> (Configuration, Vec<ShapeId>) {
        let mut configuration = Configuration::default();
        let mut ids: Vec<ShapeId> = Vec::new();
        for (at, shape) in given.iter().enumerate() {
            let parent = (at > 0).then(|| ids[shape.parent.index(at)]);
            ids.push(configuration.add(
                parent,
                shape.label.map(Label),
                shape.boxes.iter().copied().collect(),
            ));
            if at == snapshot_at {
                configuration.refresh();
            }
        }
        for (id, shape) in ids.iter().zip(given) {
            if shape.is_replaced {
                configuration.replace(*id);
            }
        }
        (configuration, ids)
    }

    /// The answer by looking at every cell.
    fn by_cells(
        snapshot: Snapshot<'_>,
        ids: &[ShapeId],
        asker: ShapeId,
        against: Against,
        distance: i32,
    ) -> Occlusion {
        let others: Vec<ShapeId> =
            ids.iter().copied().filter(|id| snapshot.counts(asker, against, *id)).collect();
        let others: Vec<ShapeId> = match against {
            Against::Label(label) => {
                others.into_iter().filter(|id| snapshot.shape(*id).label == Some(label)).collect()
            }
            _ => others,
        };
        let is_covered =
            |cell: Cell| others.iter().any(|id| snapshot.shape(*id).boxes.iter().any(|b| b.contains(cell)));
        let cells = snapshot.shape(asker).boxes.iter().flat_map(|bounds| grown(bounds, distance).cells());
        let covered: Vec<bool> = cells.map(is_covered).collect();
        match (covered.contains(&true), covered.contains(&false)) {
            (false, _) => Occlusion::None,
            (true, true) => Occlusion::Part,
            (true, false) => Occlusion::Full,
        }
    }

    fn against() -> impl Strategy<Value = Against> {
        prop_oneof![
            Just(Against::All),
            Just(Against::Active),
            Just(Against::NoParent),
            (0..4u32).prop_map(|label| Against::Label(Label(label))),
        ]
    }

    proptest! {
        #[test]
        fn answers_are_those_of_the_cells(
            given in prop::collection::vec(given(), 1..12),
            snapshot_at in 0..12usize,
            asker in any::<prop::sample::Index>(),
            against in against(),
            distance in 0..3i32,
        ) {
            let (mut configuration, ids) = configuration(&given, snapshot_at);
            configuration.refresh();
        let snapshot = configuration.view();
            let asker = *asker.get(&ids);
            let expected = by_cells(snapshot, &ids, asker, against, distance);
            prop_assert_eq!(snapshot.occlusion(snapshot.asker(asker), against, distance), expected);
        }
    }

    #[test]
    fn a_split_is_hidden_by_its_parent_only() {
        let mut configuration = Configuration::default();
        let of = |min: [i32; 3], max: [i32; 3]| smallvec![Bounds::new(min.into(), max.into())];
        let wall = configuration.add(None, Some(Label(0)), of([0, 0, 0], [6, 4, 1]));
        configuration.replace(wall);
        let tile = configuration.add(Some(wall), Some(Label(1)), of([0, 0, 0], [3, 4, 1]));
        let beside = configuration.add(Some(wall), Some(Label(1)), of([3, 0, 0], [6, 4, 1]));
        let tower = configuration.add(None, Some(Label(2)), of([4, 0, -2], [9, 9, 3]));
        configuration.refresh();
        let snapshot = configuration.view();
        let ask = |shape, against, distance| snapshot.occlusion(snapshot.asker(shape), against, distance);
        assert_eq!(ask(tile, Against::All, 0), Occlusion::Full);
        assert_eq!(ask(tile, Against::Active, 0), Occlusion::None);
        assert_eq!(ask(tile, Against::NoParent, 0), Occlusion::None);
        assert_eq!(ask(tile, Against::NoParent, 1), Occlusion::Part);
        assert_eq!(ask(tile, Against::Label(Label(2)), 1), Occlusion::None);
        assert_eq!(ask(tile, Against::Label(Label(2)), 2), Occlusion::Part);
        assert_eq!(ask(beside, Against::Label(Label(2)), 0), Occlusion::Part);
        assert_eq!(ask(tower, Against::Label(Label(0)), 0), Occlusion::Part);
        assert_eq!(ask(tower, Against::Label(Label(7)), 0), Occlusion::None);
    }
}
