//! Shapes in colours, for pictures.

use super::part::{Part, Parts};
use crate::block::Rgba;
use crate::space::{Bounds, Cell};
use ndarray::Array3;

/// How far shapes are moved apart.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Spread {
    /// They stand as in the example.
    #[default]
    Whole,
    /// Each is as far again from the middle.
    Exploded,
}

/// Cells indexed `[y, z, x]`: 0 where nothing is, otherwise one more than the form of the shape there. Of shapes that share a
/// block, the smallest is seen.
pub fn paint(parts: &Parts, shapes: &[&Part], spread: Spread) -> Array3<u16> {
    let mut shapes: Vec<(u16, Vec<Cell>)> = shapes
        .iter()
        .map(|part| (number(part.form), parts.blocks_of(part).map(|(cell, _)| cell).collect()))
        .collect();
    if spread == Spread::Exploded {
        explode(&mut shapes);
    }
    shapes.sort_by_key(|(_, cells)| std::cmp::Reverse(cells.len()));
    let all = shapes.iter().flat_map(|(_, cells)| cells.iter().copied());
    let Some(bounds) = Bounds::around(all) else { return Array3::zeros((0, 0, 0)) };
    let [width, height, depth] = bounds.size().to_array().map(|n| n as usize);
    let mut painted = Array3::zeros((height, depth, width));
    for (number, cells) in &shapes {
        for cell in cells {
            let [x, y, z] = (*cell - bounds.min).to_array().map(|n| n as usize);
            painted[[y, z, x]] = *number;
        }
    }
    painted
}

/// Moves each shape away from the middle of all, by as much as its own middle is away from it.
fn explode(shapes: &mut [(u16, Vec<Cell>)]) {
    let twice_middle = |bounds: Option<Bounds>| bounds.map_or(Cell::ZERO, |bounds| bounds.min + bounds.max);
    let all = twice_middle(Bounds::around(shapes.iter().flat_map(|(_, cells)| cells.iter().copied())));
    for (_, cells) in shapes {
        let away = (twice_middle(Bounds::around(cells.iter().copied())) - all) / 2;
        cells.iter_mut().for_each(|cell| *cell += away);
    }
}

/// The number of a form among the colours.
fn number(form: usize) -> u16 {
    u16::try_from(form + 1).unwrap_or(u16::MAX)
}

/// The colours of all forms, as numbered by [`paint`].
pub fn colors(parts: &Parts) -> Vec<Option<Rgba>> {
    let forms = (0..parts.forms.len().min(usize::from(u16::MAX))).map(|form| {
        let [red, green, blue] = color(form);
        Some(Rgba::rgb(red, green, blue))
    });
    std::iter::once(None).chain(forms).collect()
}

/// The colour of a form: hues go round by the golden angle, so that neighbours in number differ.
pub fn color(form: usize) -> [u8; 3] {
    let hue = (form as f32 * 0.618_034).fract() * 6.0;
    let (light, strength) = [(0.62, 0.62), (0.48, 0.55), (0.74, 0.5)][form / 8 % 3];
    let channel = |from: f32| {
        let turn = (hue + from).rem_euclid(6.0);
        let level = (turn - 3.0).abs() - 1.0;
        let pure = level.clamp(0.0, 1.0);
        ((light + (pure - 0.5) * strength) * 255.0).clamp(0.0, 255.0) as u8
    };
    [channel(0.0), channel(4.0), channel(2.0)]
}
