use super::{Frame, Rect, Spot};
use glam::Vec3Swizzles;

/// A rectangle of the plan as who stands at its front sees it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct View {
    corner: Spot,
    directions: [Spot; 2],
    lengths: Spot,
}

impl View {
    pub fn of(area: Rect, frame: Frame) -> View {
        let directions = frame.plan().map(|direction| direction.xz());
        let [right, away] = directions;
        let corner = Spot::select((right + away).cmpgt(Spot::ZERO), area.min, area.max - 1);
        let lengths = Spot::new(right.dot(area.size()).abs(), away.dot(area.size()).abs());
        View { corner, directions, lengths }
    }

    /// The place of a cell: how many cells to the right and how many away from the front left one.
    pub fn place(&self, spot: Spot) -> Spot {
        let [right, away] = self.directions;
        Spot::new(right.dot(spot - self.corner), away.dot(spot - self.corner))
    }

    /// The cell at a place.
    pub fn spot(&self, place: Spot) -> Spot {
        let [right, away] = self.directions;
        self.corner + right * place.x + away * place.y
    }

    /// The steps to the right and away from the front.
    pub fn directions(&self) -> [Spot; 2] {
        self.directions
    }

    /// The lengths to the right and away from the front.
    pub fn lengths(&self) -> Spot {
        self.lengths
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::space::{Turn, Up};

    #[test]
    fn places_count_from_the_front_left_in_every_frame() {
        let area = Rect::new(Spot::new(-2, 3), Spot::new(4, 7));
        let frames = Turn::ALL.into_iter().flat_map(|turn| [Up::Y, Up::Z].map(|up| Frame { up, turn }));
        for view in frames.map(|frame| View::of(area, frame)) {
            let places = Rect::new(Spot::ZERO, view.lengths());
            assert_eq!(places.area(), area.area());
            for spot in area.spots() {
                assert!(places.contains(view.place(spot)), "{view:?}");
                assert_eq!(view.spot(view.place(spot)), spot);
            }
        }
        let plain = View::of(area, Frame::default());
        assert_eq!(plain.spot(Spot::ZERO), Spot::new(-2, 6));
    }
}
