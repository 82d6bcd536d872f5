//! Layers between two given ones, put together of faces that the examples show.
//!
//! What each face of each layer may be is narrowed until all agree: faces behind one another make a neighbourhood that
//! is seen, faces beside one another share cells. What stays open is tried.

use super::faces::Faces;
use crate::infer::neighbourhood::OUTSIDE;
use ndarray::{Array2, Array3};
use std::collections::BTreeSet;

/// So many faces are decided by trying at most, in all ways together.
const MOST_TRIED: usize = 64;
/// The corners of a face, as they lie in its cells.
const CORNERS: [(usize, usize); 4] = [(0, 0), (0, 1), (1, 0), (1, 1)];

/// What each face may be.
#[derive(Clone)]
pub struct Loom<'a> {
    faces: &'a Faces,
    /// By layer, row and column.
    open: Array3<Vec<u32>>,
}

/// The layers before and behind those that are looked for.
#[derive(Clone, Copy)]
pub struct Ends<'a> {
    pub before: &'a Array2<u32>,
    pub behind: &'a Array2<u32>,
}

impl<'a> Loom<'a> {
    /// All that `count` layers between two given ones may be; `None` if there is nothing at some place.
    pub fn between(faces: &'a Faces, ends: Ends<'_>, count: usize) -> Option<Loom<'a>> {
        let (rows, columns) = ends.before.dim();
        let mut open = Array3::from_elem((count, rows, columns), Vec::new());
        for ((row, column), before) in ends.before.indexed_iter() {
            let behind = ends.behind[[row, column]];
            let is_inside = |face: &u32| lies_inside(faces.cells(*face), (row, column), (rows, columns));
            for (layer, faces) in chains(faces, *before, behind, count)?.into_iter().enumerate() {
                open[[layer, row, column]] = faces.into_iter().filter(is_inside).collect();
            }
        }
        let mut loom = Loom { faces, open };
        loom.narrow().then_some(loom)
    }

    /// Cells for the layers, as near to `wanted` as comes first, without a border; `None` if none was found.
    pub fn woven(self, wanted: &Array3<Option<u32>>) -> Option<Array3<u32>> {
        let mut left = MOST_TRIED;
        self.decided(wanted, &mut left).map(|loom| loom.cells())
    }

    fn decided(self, wanted: &Array3<Option<u32>>, left: &mut usize) -> Option<Loom<'a>> {
        let open = self.open.indexed_iter().filter(|(_, faces)| faces.len() > 1);
        let Some((place, faces)) = open.min_by_key(|(_, faces)| faces.len()) else { return Some(self) };
        let mut faces = faces.clone();
        faces.sort_by_key(|face| (wanted[place] != Some(*face), *face));
        for face in faces {
            *left = left.checked_sub(1)?;
            let mut next = self.clone();
            next.open[place] = vec![face];
            if next.narrow()
                && let Some(found) = next.decided(wanted, left)
            {
                return Some(found);
            }
        }
        None
    }

    /// Takes out what agrees with nothing beside it; whether everything is left something.
    fn narrow(&mut self) -> bool {
        loop {
            let before = self.choices();
            self.agree_beside();
            self.agree_behind();
            if self.open.iter().any(Vec::is_empty) {
                return false;
            }
            if self.choices() == before {
                return true;
            }
        }
    }

    fn choices(&self) -> usize {
        self.open.iter().map(Vec::len).sum()
    }

    /// Faces of one layer share cells.
    fn agree_beside(&mut self) {
        let (layers, rows, columns) = self.open.dim();
        let mut cells: Array3<Option<BTreeSet<u32>>> =
            Array3::from_elem((layers, rows + 1, columns + 1), None);
        for ((layer, row, column), faces) in self.open.indexed_iter() {
            for (corner, (u, v)) in CORNERS.into_iter().enumerate() {
                let own: BTreeSet<u32> = faces.iter().map(|face| self.faces.cells(*face)[corner]).collect();
                let cell = &mut cells[[layer, row + u, column + v]];
                *cell = Some(match cell.take() {
                    Some(others) => &others & &own,
                    None => own,
                });
            }
        }
        let known = self.faces;
        for ((layer, row, column), faces) in self.open.indexed_iter_mut() {
            faces.retain(|face| {
                CORNERS.into_iter().zip(known.cells(*face)).all(|((u, v), terminal)| {
                    cells[[layer, row + u, column + v]].as_ref().is_some_and(|cell| cell.contains(&terminal))
                })
            });
        }
    }

    /// Faces of two layers make a neighbourhood that is seen.
    fn agree_behind(&mut self) {
        let (layers, rows, columns) = self.open.dim();
        let known = self.faces;
        for layer in 1..layers {
            for place in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
                let (low, high) = ([layer - 1, place.0, place.1], [layer, place.0, place.1]);
                let mut before = std::mem::take(&mut self.open[low]);
                let behind = &mut self.open[high];
                before.retain(|low| behind.iter().any(|high| known.may_follow(*low, *high)));
                behind.retain(|high| before.iter().any(|low| known.may_follow(*low, *high)));
                self.open[low] = before;
            }
        }
    }

    /// The cells of layers of which each face is decided, without a border.
    fn cells(&self) -> Array3<u32> {
        let (layers, rows, columns) = self.open.dim();
        Array3::from_shape_fn((layers, rows - 1, columns - 1), |(layer, row, column)| {
            self.faces.cells(self.open[[layer, row, column]][0])[3]
        })
    }
}

/// Whether there is a way from one face to another with `count` faces between them.
pub fn leads(faces: &Faces, before: u32, behind: u32, count: usize) -> bool {
    match count {
        0 => faces.may_follow(before, behind),
        1 => faces.behind(before).iter().any(|face| faces.may_follow(*face, behind)),
        _ => faces.behind(before).iter().any(|face| leads(faces, *face, behind, count - 1)),
    }
}

/// By layer, the faces of all ways from one face to another with `count` faces between them, each pair of which makes a
/// neighbourhood that is seen; `None` if there is no way. `count` is 2 at the most.
fn chains(faces: &Faces, before: u32, behind: u32, count: usize) -> Option<Vec<Vec<u32>>> {
    let leads = |face: &&u32| faces.may_follow(**face, behind);
    match count {
        0 => faces.may_follow(before, behind).then(Vec::new),
        1 => {
            let only: Vec<u32> = faces.behind(before).iter().filter(leads).copied().collect();
            (!only.is_empty()).then(|| vec![only])
        }
        _ => {
            let ends = faces.before(behind);
            let reaches = |face: &&u32| ends.iter().any(|end| faces.may_follow(**face, *end));
            let first: Vec<u32> = faces.behind(before).iter().filter(reaches).copied().collect();
            let reached = |end: &&u32| first.iter().any(|face| faces.may_follow(*face, **end));
            let second: Vec<u32> = ends.iter().filter(reached).copied().collect();
            (!first.is_empty()).then(|| vec![first, second])
        }
    }
}

/// Whether a face at a place of a layer with a border has that border where it is, and nowhere else.
fn lies_inside(cells: [u32; 4], (row, column): (usize, usize), (rows, columns): (usize, usize)) -> bool {
    CORNERS.into_iter().zip(cells).all(|((u, v), terminal)| {
        let (row, column) = (row + u, column + v);
        let is_border = row == 0 || column == 0 || row == rows || column == columns;
        is_border == (terminal == OUTSIDE)
    })
}
