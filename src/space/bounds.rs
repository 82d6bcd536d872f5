use super::{Axis, Cell};

/// A half-open box of cells: `min` is inside, `max` is the first cell past the far corner.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Bounds {
    pub min: Cell,
    pub max: Cell,
}

impl Bounds {
    pub fn new(min: Cell, max: Cell) -> Bounds {
        Bounds { min, max }
    }

    /// The box of `size` with its low corner at the origin.
    pub fn of_size(size: Cell) -> Bounds {
        Bounds::new(Cell::ZERO, size)
    }

    /// The smallest box that holds all of `cells`; `None` of no cell.
    pub fn around(cells: impl IntoIterator<Item = Cell>) -> Option<Bounds> {
        cells.into_iter().map(|cell| Bounds::new(cell, cell + 1)).reduce(|all, cell| all.union(&cell))
    }

    pub fn size(&self) -> Cell {
        self.max - self.min
    }

    pub fn len(&self, axis: Axis) -> i32 {
        axis.of(self.size())
    }

    pub fn is_empty(&self) -> bool {
        self.size().min_element() <= 0
    }

    /// The number of cells inside, of any corners that a file may say.
    pub fn volume(&self) -> u64 {
        let size = (self.max.as_i64vec3() - self.min.as_i64vec3()).max(glam::I64Vec3::ZERO);
        size.to_array().into_iter().fold(1, |volume, length| volume.saturating_mul(length as u64))
    }

    pub fn contains(&self, cell: Cell) -> bool {
        cell.cmpge(self.min).all() && cell.cmplt(self.max).all()
    }

    pub fn contains_box(&self, other: &Bounds) -> bool {
        other.min.cmpge(self.min).all() && other.max.cmple(self.max).all()
    }

    pub fn intersect(&self, other: &Bounds) -> Bounds {
        Bounds::new(self.min.max(other.min), self.max.min(other.max))
    }

    pub fn union(&self, other: &Bounds) -> Bounds {
        Bounds::new(self.min.min(other.min), self.max.max(other.max))
    }

    /// The slab of this box from `low` to `high` along `axis`, in the same coordinates as the box.
    pub fn slab(&self, axis: Axis, low: i32, high: i32) -> Bounds {
        let mut slab = *self;
        slab.min[axis.index()] = low;
        slab.max[axis.index()] = high;
        slab
    }

    /// Every cell, x fastest, then z, then y: the order of schematic files.
    pub fn cells(self) -> impl Iterator<Item = Cell> {
        (self.min.y..self.max.y).flat_map(move |y| {
            (self.min.z..self.max.z)
                .flat_map(move |z| (self.min.x..self.max.x).map(move |x| Cell::new(x, y, z)))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_box_around_cells_is_the_smallest_that_holds_them() {
        let cells = [Cell::new(3, -1, 2), Cell::new(0, 4, 2)];
        let around = Bounds::around(cells);
        assert_eq!(around, Some(Bounds::new(Cell::new(0, -1, 2), Cell::new(4, 5, 3))));
        assert_eq!(Bounds::around([]), None);
    }

    #[test]
    fn the_volume_of_any_corners_is_a_number() {
        let far = Bounds::new(Cell::MIN, Cell::MAX);
        assert_eq!(far.volume(), u64::MAX);
        assert_eq!(Bounds::new(Cell::MAX, Cell::MIN).volume(), 0);
        assert_eq!(Bounds::of_size(Cell::new(2, 3, 4)).volume(), 24);
    }
}
