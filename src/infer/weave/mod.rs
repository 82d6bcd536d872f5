//! Further buildings: the beginning of one example and the end of another one, or of the same, along an axis, with a few
//! layers between them that are put together of what the examples show. So houses become longer, shorter and higher.
//!
//! ```text
//! Seen --faces--> what stands behind what --loom--> layers between two given ones --> Examples
//! ```

mod faces;
mod loom;

use super::example::Terminals;
use super::exchange::array_axis;
use super::neighbourhood::{Shown, bordered};
use super::swaps::{Frame, Settled};
use crate::space::Axis;
use faces::Faces;
use loom::{Ends, Loom};
use ndarray::{Array2, Array3, ArrayView3, Slice, concatenate};
use std::collections::BTreeSet;
use std::ops::Range;

/// So many layers are put between a beginning and an end at most: with more, they hardly depend on either.
const MOST_LAYERS: usize = 2;
/// Of each example so many further buildings are made: they are alternatives for a person to read.
const MOST_MADE: usize = 4;
/// So many ways to weave are tried for each example.
const MOST_TRIED: usize = 24;

/// Where a building is cut, and what goes on there. Layers are counted in arrays with a border.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
struct Cut {
    axis: Axis,
    /// The last layer of the beginning.
    last: usize,
    /// So many layers are woven.
    woven: usize,
    /// The example that ends it, and its first layer there.
    other: usize,
    first: usize,
    /// How long the building becomes.
    length: usize,
}

/// The buildings that can be woven of examples, in the order of those that they begin like, of which those are left out
/// that need no more. They show only neighbourhoods that are seen, are as sound as the examples, and none is an example
/// with more or less air around it.
pub fn woven(
    shown: &Shown,
    terminals: &Terminals,
    settled: &mut Settled,
    needs_more: impl Fn(usize) -> bool,
) -> Vec<Array3<u32>> {
    let is_nothing = terminals.are_nothing();
    let frames: Vec<Frame> =
        shown.bordered.iter().map(|cells| Frame::of(cells, &is_nothing, &terminals.list)).collect();
    let looms: Vec<Across> = Axis::ALL.into_iter().map(|axis| Across::new(axis, shown)).collect();
    let mut known: BTreeSet<Core> = shown.cells.iter().map(|cells| core(cells, &is_nothing)).collect();
    let mut all = Vec::new();
    for own in (0..shown.cells.len()).filter(|own| needs_more(*own)) {
        let mut made: Vec<(Axis, usize, usize)> = Vec::new();
        for cut in cuts(own, &looms).into_iter().take(MOST_TRIED) {
            let sort = (cut.axis, cut.length, cut.other);
            if made.len() == MOST_MADE || made.contains(&sort) {
                continue;
            }
            let Some(cells) = weave(own, cut, &looms, shown) else { continue };
            let frame = Frame::of(&bordered(&cells), &is_nothing, &terminals.list);
            let is_sound = frame.is_as_sound_as(&frames[own]) || frame.is_as_sound_as(&frames[cut.other]);
            let core = core(&cells, &is_nothing);
            if is_sound && !known.contains(&core) && settled.shows_all(terminals.grid(&cells)) {
                known.insert(core);
                made.push(sort);
                all.push(cells);
            }
        }
    }
    all
}

/// The examples seen across one axis.
struct Across {
    axis: Axis,
    faces: Faces,
    /// By example, the faces of its layers.
    layers: Vec<Vec<Array2<u32>>>,
}

impl Across {
    fn new(axis: Axis, shown: &Shown) -> Across {
        let faces = Faces::across(axis, &shown.seen);
        let layers = shown.bordered.iter().map(|cells| faces.layers(cells, axis)).collect();
        Across { axis, faces, layers }
    }

    /// Where an example can be cut, as far as each place by itself allows.
    fn cuts(&self, own: usize) -> Vec<Cut> {
        let mut cuts = Vec::new();
        let cross = |example: usize| self.layers[example][0].dim();
        for other in (0..self.layers.len()).filter(|other| cross(*other) == cross(own)) {
            // What stood in the way last is likely to do so again.
            let mut hurdle = (0, 0);
            for cut in self.lengths(own, other) {
                if self.is_possible(own, cut, &mut hurdle) {
                    cuts.push(cut);
                }
            }
        }
        cuts
    }

    /// All ways to begin like `own` and end like `other` that are neither an example again nor half as long again
    /// as the longer one.
    fn lengths(&self, own: usize, other: usize) -> impl Iterator<Item = Cut> {
        let axis = self.axis;
        let [length, end] = [own, other].map(|example| self.layers[example].len() - 2);
        let ways = (1..length).flat_map(move |last| {
            (2..=end).flat_map(move |first| (0..=MOST_LAYERS).map(move |woven| (last, first, woven)))
        });
        let cuts = ways.map(move |(last, first, woven)| Cut {
            axis,
            last,
            woven,
            other,
            first,
            length: last + woven + end + 1 - first,
        });
        let (shortest, longest) = (length.min(end), length.max(end));
        cuts.filter(move |cut| {
            let is_own = own == other && cut.first == cut.last + cut.woven + 1;
            !is_own && 2 * cut.length >= shortest && 2 * cut.length <= 3 * longest
        })
    }

    fn is_possible(&self, own: usize, cut: Cut, hurdle: &mut (usize, usize)) -> bool {
        let Ends { before, behind } = self.ends(own, cut);
        let is_open =
            |place: (usize, usize)| loom::leads(&self.faces, before[place], behind[place], cut.woven);
        if !is_open(*hurdle) {
            return false;
        }
        let closed = before.indexed_iter().map(|(place, _)| place).find(|place| !is_open(*place));
        *hurdle = closed.unwrap_or(*hurdle);
        closed.is_none()
    }

    fn ends(&self, own: usize, cut: Cut) -> Ends<'_> {
        Ends { before: &self.layers[own][cut.last], behind: &self.layers[cut.other][cut.first] }
    }
}

/// Where an example can be cut, those first that need the fewest layers, of these those that are cut nearest to the
/// middle: what is cut at the end is hardly another building.
fn cuts(own: usize, looms: &[Across]) -> Vec<Cut> {
    let mut cuts: Vec<Cut> = looms.iter().flat_map(|across| across.cuts(own)).collect();
    cuts.sort_by_key(|cut| (cut.woven, (2 * cut.last + cut.woven).abs_diff(cut.length), *cut));
    cuts
}

/// The building of a cut, if there is one.
fn weave(own: usize, cut: Cut, looms: &[Across], shown: &Shown) -> Option<Array3<u32>> {
    let across = looms.iter().find(|across| across.axis == cut.axis)?;
    let loom = Loom::between(&across.faces, across.ends(own, cut), cut.woven)?;
    let along = ndarray::Axis(array_axis(cut.axis));
    let (rows, columns) = across.layers[own][0].dim();
    let wanted = Array3::from_shape_fn((cut.woven, rows, columns), |(layer, row, column)| {
        let layer = across.layers[own].get(cut.last + 1 + layer)?;
        Some(layer[[row, column]])
    });
    let mut between = loom.woven(&wanted)?;
    // It is indexed by layer first.
    match cut.axis {
        Axis::Y => {}
        Axis::Z => between.swap_axes(0, 1),
        Axis::X => between = between.permuted_axes([1, 2, 0]),
    }
    let part = |example: usize, layers: Range<usize>| slab(&shown.cells[example], along, layers);
    let begin = part(own, 0..cut.last);
    let end = part(cut.other, cut.first - 1..shown.cells[cut.other].len_of(along));
    concatenate(along, &[begin, between.view(), end])
        .ok()
        .map(|cells| cells.as_standard_layout().into_owned())
}

fn slab(cells: &Array3<u32>, along: ndarray::Axis, layers: Range<usize>) -> ArrayView3<'_, u32> {
    cells.slice_axis(along, Slice::from(layers))
}

/// A building without the air around it: its size, and its terminals.
type Core = ([usize; 3], Vec<u32>);

fn core(cells: &Array3<u32>, is_nothing: &[bool]) -> Core {
    let mut view = cells.view();
    for axis in 0..3 {
        let is_empty = |layer: ndarray::ArrayView2<u32>| layer.iter().all(|cell| is_nothing[*cell as usize]);
        let layers = || view.axis_iter(ndarray::Axis(axis));
        let low = layers().take_while(|layer| is_empty(*layer)).count();
        let high = layers().rev().take_while(|layer| is_empty(*layer)).count();
        let end = view.shape()[axis].saturating_sub(high).max(low);
        view.slice_axis_inplace(ndarray::Axis(axis), Slice::from(low..end));
    }
    let (y, z, x) = view.dim();
    ([y, z, x], view.iter().copied().collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::block::BlockState;
    use crate::grid::Grid;
    use crate::infer::example::Example;
    use crate::infer::neighbourhood::{corners, neighbourhood};
    use crate::space::Cell;
    use proptest::prelude::*;

    /// Layers of one block each, along an axis.
    fn rod(axis: Axis, blocks: &[&str]) -> Example {
        let mut grid = Grid::new(Cell::ONE + axis.unit() * (blocks.len() as i32 - 1));
        for (at, name) in (0..).zip(blocks) {
            let id = grid.intern(&BlockState::new(name).unwrap()).unwrap();
            grid.set(axis.unit() * at, id);
        }
        Example::Blocks(grid)
    }

    fn woven_of(examples: &[Example]) -> (Shown, Vec<Array3<u32>>) {
        let mut terminals = Terminals::default();
        terminals.enter(&Example::Blocks(Grid::new(Cell::ONE)));
        examples.iter().for_each(|example| terminals.enter(example));
        let shown = Shown::by(examples, &[], &mut terminals).unwrap();
        let mut settled = Settled::by(examples);
        let woven = woven(&shown, &terminals, &mut settled, |_| true);
        (shown, woven)
    }

    #[test]
    fn what_repeats_becomes_longer_and_shorter() {
        for axis in Axis::ALL {
            let (_, woven) = woven_of(&[rod(axis, &["bricks", "stone", "stone", "stone", "glass"])]);
            let mut lengths: Vec<usize> = woven.iter().map(|cells| cells.len()).collect();
            lengths.sort_unstable();
            assert_eq!(lengths, [3, 4, 6, 7], "{axis:?}");
        }
    }

    #[test]
    fn what_never_repeats_stays() {
        let (_, woven) = woven_of(&[rod(Axis::X, &["bricks", "stone", "dirt", "glass"])]);
        assert_eq!(woven, [] as [Array3<u32>; 0]);
    }

    #[test]
    fn one_goes_on_as_another() {
        let first = rod(Axis::X, &["bricks", "stone", "dirt", "glass"]);
        let second = rod(Axis::X, &["sand", "stone", "dirt", "clay"]);
        let (_, woven) = woven_of(&[first, second]);
        assert_eq!(woven.len(), 2);
    }

    proptest! {
        #[test]
        fn nothing_is_shown_that_was_not_seen(ids in prop::collection::vec(0..3usize, 4 * 3 * 3)) {
            let mut grid = Grid::new(Cell::new(4, 3, 3));
            for (cell, id) in grid.bounds().cells().zip(ids) {
                let state = BlockState::new(["air", "stone", "glass"][id]).unwrap();
                let id = grid.intern(&state).unwrap();
                grid.set(cell, id);
            }
            let (shown, woven) = woven_of(&[Example::Blocks(grid)]);
            for cells in woven.iter().map(bordered) {
                prop_assert!(
                    corners(cells.dim()).all(|corner| shown.seen.contains(&neighbourhood(&cells, corner)))
                );
            }
        }
    }
}
