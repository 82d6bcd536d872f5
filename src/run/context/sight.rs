//! Sightlines: whether a shape sees another across what stands between.
//!
//! The shortest lines between two boxes are parallel. Along an axis where the boxes overlap there is one at every
//! place of the overlap; along the others, the gaps, all run from end to end. A box between that some line crosses cuts
//! all lines over its width, so the lines that it leaves free are those beside it: what is asked is whether the boxes
//! between cover the overlap.

use super::cover::covers;
use super::occlusion::grown;
use super::{Asker, Label, ShapeId, Snapshot};
use crate::space::{Axis, Bounds};

/// How two boxes lie along an axis.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Lie {
    /// They overlap between these.
    Along(i32, i32),
    /// A gap, seen from the first; of no length where they touch.
    Across(i32, i32),
}

/// A box of the asker, one of a shape that it may see, and that shape.
type Pair = (Bounds, Bounds, ShapeId);

impl Snapshot<'_> {
    /// Whether the asker sees a shape of that label: of the shortest lines to the nearest of them, one at least is not
    /// cut by another shape. The two, their ancestors and what they are made of cut nothing; neither do shapes that
    /// lines touch at their ends only. A line along the very surface of a shape is cut by it.
    ///
    /// A flat shape sees only what lies wholly to one side of it, and not along itself: the side of a house does not
    /// see the street that its front sees. The asker and its ancestors are not looked for.
    pub fn visible(&self, asker: Asker<'_>, label: Label) -> bool {
        self.nearest(asker, label).into_iter().any(|pair| self.is_in_sight(asker.shape, pair))
    }

    /// The pairs of boxes at the least distance from one another.
    fn nearest(&self, asker: Asker<'_>, label: Label) -> Vec<Pair> {
        let (Some(index), Some(hull)) =
            (self.labelled(label), asker.boxes.iter().copied().reduce(|hull, bounds| hull.union(&bounds)))
        else {
            return Vec::new();
        };
        let mut reach: i32 = 1;
        loop {
            let window = grown(&hull, reach);
            let found = index.near(window).filter(|(_, shape)| !self.is_within(asker.shape, *shape));
            let (distance, pairs) = closest(asker.boxes, found);
            // What lies outside of the window is farther than its reach.
            if distance <= u64::from(reach.unsigned_abs()).pow(2) || index.lies_within(&window) {
                return pairs;
            }
            reach = reach.saturating_mul(2);
        }
    }

    fn is_in_sight(&self, asker: ShapeId, (own, target, seen): Pair) -> bool {
        let lies = Axis::ALL.map(|axis| lie(&own, &target, axis));
        if is_along_itself(&own, &lies) {
            return false;
        }
        if lies.iter().all(|lie| gap(*lie) == 0) {
            return true;
        }
        let cuts = self.near(between(&lies)).filter(|(bounds, shape)| {
            is_cut(&lies, bounds) && !self.are_kin(*shape, asker) && !self.are_kin(*shape, seen)
        });
        let shadows = cuts.map(|(bounds, _)| flattened(&lies, bounds)).collect();
        !covers(shadows, &flattened(&lies, between(&lies)))
    }
}

/// The pairs at the least distance, and its square.
fn closest(own: &[Bounds], found: impl Iterator<Item = (Bounds, ShapeId)>) -> (u64, Vec<Pair>) {
    let (mut least, mut pairs) = (u64::MAX, Vec::new());
    for (target, shape) in found {
        for bounds in own {
            let distance = squared_distance(bounds, &target);
            if distance < least {
                pairs.clear();
            }
            if distance <= least {
                least = distance;
                pairs.push((*bounds, target, shape));
            }
        }
    }
    (least, pairs)
}

fn squared_distance(one: &Bounds, other: &Bounds) -> u64 {
    let gaps = Axis::ALL.map(|axis| gap(lie(one, other, axis)));
    gaps.into_iter().fold(0, |sum, gap| sum.saturating_add(gap.saturating_mul(gap)))
}

fn lie(one: &Bounds, other: &Bounds, axis: Axis) -> Lie {
    let ((low, high), (other_low, other_high)) = (ends(one, axis), ends(other, axis));
    let shared = (low.max(other_low), high.min(other_high));
    if shared.0 < shared.1 {
        Lie::Along(shared.0, shared.1)
    } else if high <= other_low {
        Lie::Across(high, other_low)
    } else if other_high <= low {
        Lie::Across(low, other_high)
    } else {
        // One of them is flat and lies within the other.
        Lie::Across(shared.0, shared.0)
    }
}

fn ends(bounds: &Bounds, axis: Axis) -> (i32, i32) {
    (axis.of(bounds.min), axis.of(bounds.max))
}

fn gap(lie: Lie) -> u64 {
    match lie {
        Lie::Along(..) => 0,
        Lie::Across(from, to) => u64::from(from.abs_diff(to)),
    }
}

/// Whether lines from a flat box run along it.
fn is_along_itself(own: &Bounds, lies: &[Lie; 3]) -> bool {
    let mut flat = Axis::ALL.into_iter().filter(|axis| own.len(*axis) == 0);
    let (Some(axis), None) = (flat.next(), flat.next()) else { return false };
    let is_before = gap(lies[axis.index()]) > 0;
    let is_beside = |axis: &Axis| matches!(lies[axis.index()], Lie::Across(..));
    !is_before && axis.others().iter().any(is_beside)
}

/// The box that holds all lines.
fn between(lies: &[Lie; 3]) -> Bounds {
    let mut bounds = Bounds::of_size(crate::space::Cell::ZERO);
    for (axis, lie) in Axis::ALL.into_iter().zip(lies) {
        let (Lie::Along(one, other) | Lie::Across(one, other)) = *lie;
        bounds = bounds.slab(axis, one.min(other), one.max(other));
    }
    bounds
}

/// The box as lines meet it: one cell deep wherever there is a gap.
fn flattened(lies: &[Lie; 3], bounds: Bounds) -> Bounds {
    let gaps = Axis::ALL.into_iter().filter(|axis| matches!(lies[axis.index()], Lie::Across(..)));
    gaps.fold(bounds, |bounds, axis| bounds.slab(axis, 0, 1))
}

/// Whether lines cross the box, or run along its surface, somewhere between their ends. Where they do so along
/// one axis is a range of shares of their length; these ranges have to meet.
fn is_cut(lies: &[Lie; 3], bounds: &Bounds) -> bool {
    let (mut enter, mut leave) = (Share(0, 1), Share(1, 1));
    for (axis, lie) in Axis::ALL.into_iter().zip(lies) {
        let Lie::Across(from, to) = *lie else { continue };
        let (low, high) = ends(bounds, axis);
        let (near, far) = if from <= to { (low, high) } else { (high, low) };
        if from == to {
            if from < low || from > high {
                return false;
            }
            continue;
        }
        let share =
            |place: i32| Share::of(i64::from(place) - i64::from(from), i64::from(to) - i64::from(from));
        enter = if enter.is_below(share(near)) { share(near) } else { enter };
        leave = if share(far).is_below(leave) { share(far) } else { leave };
    }
    !leave.is_below(enter) && enter.is_below(Share(1, 1)) && Share(0, 1).is_below(leave)
}

/// A fraction with a denominator above zero.
#[derive(Clone, Copy)]
struct Share(i64, i64);

impl Share {
    /// A part of a whole that is not zero; both may run backwards.
    fn of(part: i64, whole: i64) -> Share {
        Share(part * whole.signum(), whole.abs())
    }

    fn is_below(self, other: Share) -> bool {
        i128::from(self.0) * i128::from(other.1) < i128::from(other.0) * i128::from(self.1)
    }
}

#[cfg(test)]
mod tests {
    use super::super::Configuration;
    use super::*;
    use crate::space::Cell;
    use proptest::prelude::*;
    use smallvec::smallvec;

    fn of(min: [i32; 3], max: [i32; 3]) -> Bounds {
        Bounds::new(min.into(), max.into())
    }

    const STREET: Label = Label(0);

    /// Whether the first box sees the second, as a street, with the others between as shapes of their own.
    fn sees(own: Bounds, street: Bounds, others: &[Bounds]) -> bool {
        let mut configuration = Configuration::default();
        configuration.add(None, Some(STREET), smallvec![street]);
        let asker = configuration.add(None, Some(Label(1)), smallvec![own]);
        for other in others {
            configuration.add(None, None, smallvec![*other]);
        }
        configuration.refresh();
        let snapshot = configuration.view();
        snapshot.visible(snapshot.asker(asker), STREET)
    }

    #[test]
    fn only_the_front_of_a_house_sees_the_street() {
        let street = of([-10, 0, 12], [30, 1, 15]);
        let [front, back] = [of([0, 0, 8], [10, 6, 9]), of([0, 0, 0], [10, 6, 1])];
        let [left, right] = [of([0, 0, 1], [1, 6, 8]), of([9, 0, 1], [10, 6, 8])];
        let all = [front, back, left, right];
        let seen =
            all.map(|own| sees(own, street, &all.into_iter().filter(|b| *b != own).collect::<Vec<_>>()));
        assert_eq!(seen, [true, false, false, false]);
    }

    #[test]
    fn only_the_flat_front_of_a_house_sees_the_street() {
        let street = of([-10, 0, 12], [30, 1, 15]);
        let [front, back] = [of([0, 0, 9], [10, 6, 9]), of([0, 0, 0], [10, 6, 0])];
        let [left, right] = [of([0, 0, 0], [0, 6, 9]), of([10, 0, 0], [10, 6, 9])];
        let all = [front, back, left, right];
        let seen =
            all.map(|own| sees(own, street, &all.into_iter().filter(|b| *b != own).collect::<Vec<_>>()));
        assert_eq!(seen, [true, false, false, false]);
    }

    #[test]
    fn a_gap_in_a_hedge_is_enough() {
        let (own, street) = (of([0, 0, 0], [10, 6, 1]), of([0, 0, 9], [10, 1, 12]));
        let hedge = |low, high| of([low, 0, 4], [high, 6, 5]);
        assert!(sees(own, street, &[hedge(0, 4), hedge(5, 10)]));
        assert!(!sees(own, street, &[hedge(0, 4), hedge(3, 10)]));
        assert!(!sees(own, street, &[hedge(-5, 15)]));
    }

    #[test]
    fn slanted_lines_are_cut_by_what_they_pass() {
        let (window, street) = (of([4, 8, 0], [6, 10, 1]), of([0, 0, 9], [10, 1, 12]));
        assert!(sees(window, street, &[of([0, 0, 1], [10, 1, 9])]), "grass below");
        assert!(sees(window, street, &[of([0, 0, 1], [10, 4, 4])]), "a low shed");
        assert!(!sees(window, street, &[of([0, 0, 4], [10, 5, 6])]), "a high shed");
        let corner = of([20, 0, 20], [30, 6, 30]);
        assert!(sees(window, corner, &[]));
        assert!(!sees(window, corner, &[of([10, 5, 8], [14, 9, 12])]), "a tower before the corner");
    }

    #[test]
    fn the_nearest_counts_and_kin_is_never_in_the_way() {
        let mut configuration = Configuration::default();
        let mut add =
            |parent, label, min, max| configuration.add(parent, Some(Label(label)), smallvec![of(min, max)]);
        let lot = add(None, 2, [0, 0, 0], [20, 9, 20]);
        let house = add(Some(lot), 1, [0, 0, 0], [9, 9, 5]);
        let wing = add(Some(house), 3, [0, 0, 5], [9, 9, 7]);
        add(Some(lot), 0, [0, 0, 12], [9, 1, 14]);
        let far = add(Some(lot), 0, [-8, 0, 0], [-6, 1, 5]);
        configuration.refresh();
        let snapshot = configuration.view();
        let sees = |shape, label| snapshot.visible(snapshot.asker(shape), Label(label));
        assert!(sees(house, 0) && sees(wing, 0) && sees(far, 1));
        assert!(
            !sees(lot, 2) && !sees(house, 2) && !sees(lot, 9),
            "itself, an ancestor, a label of no shape"
        );
    }

    fn beside() -> impl Strategy<Value = Bounds> {
        ([0..6i32, 0..6, 1..8], [0..7i32, 0..7, 0..4])
            .prop_map(|(min, size)| Bounds::new(Cell::from(min), Cell::from(min) + Cell::from(size)))
    }

    proptest! {
        #[test]
        fn straight_lines_are_free_where_a_column_is(others in prop::collection::vec(beside(), 0..6)) {
            let (own, street) = (of([0, 0, 0], [5, 5, 2]), of([1, 1, 8], [9, 4, 9]));
            let is_free = |x: i32, y: i32| others.iter().all(|other| {
                let holds = other.min.x <= x && x < other.max.x && other.min.y <= y && y < other.max.y;
                !holds || other.max.z <= 2 || other.min.z >= 8
            });
            let expected = (1..5).any(|x| (1..4).any(|y| is_free(x, y)));
            prop_assert_eq!(sees(own, street, &others), expected);
            prop_assert_eq!(sees(street, own, &others), expected);
        }
    }
}
