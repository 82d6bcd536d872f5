//! Seams: where blocks stand beside one another as they do in no example.

use super::cells::Cells;
use super::patterns::Seams;

/// How many neighbourhoods of 2 x 2 x 2 in samples stand in no example, for each 1,000 cells of the samples.
pub fn unseen_seams(samples: &[Cells], examples: &Seams) -> f64 {
    let cells: usize = samples.iter().map(Cells::len).sum();
    let found = Seams::of(samples);
    let unseen = found.counts().iter().filter(|(cube, _)| examples.count(cube) == 0);
    let unseen: u64 = unseen.map(|(_, count)| count).sum();
    match cells {
        0 => 0.0,
        cells => 1000.0 * unseen as f64 / cells as f64,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ndarray::Array3;

    fn row(cells: &[u32]) -> Cells {
        Array3::from_shape_vec((1, 1, cells.len()), cells.to_vec()).unwrap()
    }

    #[test]
    fn a_copy_has_no_unseen_seam() {
        let example = row(&[1, 2, 3]);
        assert_eq!(unseen_seams(std::slice::from_ref(&example), &Seams::of([&example])), 0.0);
    }

    #[test]
    fn a_new_neighbour_is_an_unseen_seam() {
        let examples = Seams::of([&row(&[1, 2, 3, 2])]);
        // 2 stands at the border on the right only, and never before another 2: in four cubes each.
        assert_eq!(unseen_seams(&[row(&[1, 2, 2])], &examples), 4.0 * 1000.0 / 3.0);
        assert_eq!(unseen_seams(&[row(&[2, 3, 2])], &examples), 4.0 * 1000.0 / 3.0);
    }

    #[test]
    fn nothing_has_no_seam() {
        assert_eq!(unseen_seams(&[], &Seams::of([])), 0.0);
    }
}
