use super::Footprint;
use crate::space::{Frame, Rect, SIDES, Spot, View};
use fixedbitset::FixedBitSet;

impl Footprint {
    /// The pieces that do not touch one another but at corners, from the front left on as `frame` lies.
    pub fn parts(&self, frame: Frame) -> Vec<Footprint> {
        let view = View::of(self.area, frame);
        let mut seen = FixedBitSet::with_capacity(self.area.area());
        let mut parts = Vec::new();
        for place in Rect::new(Spot::ZERO, view.lengths()).spots() {
            let spot = view.spot(place);
            if self.contains(spot) && !seen.contains(self.number(spot)) {
                parts.push(Footprint::of_spots(&self.piece(spot, &mut seen)));
            }
        }
        parts
    }

    /// The cells that are joined to one; all become `seen`.
    fn piece(&self, start: Spot, seen: &mut FixedBitSet) -> Vec<Spot> {
        let mut piece = vec![start];
        let mut next = 0;
        seen.insert(self.number(start));
        while let Some(&spot) = piece.get(next) {
            next += 1;
            let joined = SIDES.map(|step| spot + step).into_iter();
            piece.extend(joined.filter(|&spot| self.contains(spot) && !seen.put(self.number(spot))));
        }
        piece
    }

    fn of_spots(spots: &[Spot]) -> Footprint {
        let cell = |&spot: &Spot| Rect::new(spot, spot + 1);
        let area = spots.iter().map(cell).fold(Rect::new(Spot::ZERO, Spot::ZERO), |all, one| all.union(&one));
        let mut footprint = Footprint { area, cells: FixedBitSet::with_capacity(area.area()) };
        for &spot in spots {
            let number = footprint.number(spot);
            footprint.cells.insert(number);
        }
        footprint
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{drawing, drawn, footprints};
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn parts_count_from_the_front_left() {
        let parts = drawn(&["##.#", "....", "##.#", ".###"]).parts(Frame::default());
        let drawings: Vec<_> = parts.iter().map(drawing).collect();
        assert_eq!(drawings, [vec!["##.#", ".###"], vec!["##"], vec!["#"]]);
    }

    proptest! {
        #[test]
        fn parts_are_the_whole_and_do_not_touch(footprint in footprints()) {
            let parts = footprint.parts(Frame::default());
            prop_assert_eq!(parts.iter().map(Footprint::len).sum::<usize>(), footprint.len());
            for part in &parts {
                let beside = |spot: Spot| SIDES.map(|step| spot + step).into_iter().any(|spot| part.contains(spot));
                prop_assert!(part.spots().all(|spot| footprint.contains(spot)));
                prop_assert!(footprint.spots().all(|spot| part.contains(spot) || !beside(spot)));
                prop_assert_eq!(part.parts(Frame::default()).len(), 1);
            }
        }
    }
}
