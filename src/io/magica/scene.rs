//! Where the models of a scene stand.

use super::MagicaError;
use super::chunks::{File, Node, Transform};
use std::slice;

/// So many parts of a scene are looked at. Nodes may be held by several others, so small files can ask for any number.
const MOST_PARTS: usize = 1 << 18;

/// A model at its place.
pub(super) struct Placed {
    pub model: usize,
    pub motion: Motion,
}

/// Turns about the middle of a model and then moves it. Turns take axes to axes, so may also mirror.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Motion {
    /// Which axis each one is taken from, and whether backwards (-1) or not (1).
    axes: [(usize, i64); 3],
    shift: [i64; 3],
}

impl Motion {
    pub const NONE: Motion = Motion { axes: [(0, 1), (1, 1), (2, 1)], shift: [0; 3] };

    /// This motion after `first`.
    fn after(self, first: Motion) -> Motion {
        let axis = |(from, sign): (usize, i64)| (first.axes[from].0, first.axes[from].1 * sign);
        let shift = |i: usize| {
            let (from, sign) = self.axes[i];
            sign * first.shift[from] + self.shift[i]
        };
        Motion { axes: self.axes.map(axis), shift: [0, 1, 2].map(shift) }
    }

    /// The cell where the cell `at` of a model of `size` goes. Models turn about the middle, rounded down.
    pub fn apply(self, at: [i32; 3], size: [i32; 3]) -> [i64; 3] {
        [0, 1, 2].map(|i| {
            let (from, sign) = self.axes[i];
            let from_middle = i64::from(at[from]) - i64::from(size[from] / 2);
            // Backwards, the far side of a cell becomes its low one.
            self.shift[i] + if sign < 0 { -from_middle - 1 } else { from_middle }
        })
    }
}

/// Calls `each` with the models of the scene in order. Gives how many are hidden and left out. Files without a scene
/// hold one model, or the frames of an animation, of which the first is taken.
pub(super) fn visit(
    file: &File,
    each: &mut dyn FnMut(Placed) -> Result<(), MagicaError>,
) -> Result<usize, MagicaError> {
    if file.nodes.is_empty() {
        (!file.models.is_empty()).then(|| each(Placed { model: 0, motion: Motion::NONE })).transpose()?;
        return Ok(0);
    }
    let mut hidden = 0;
    let mut parts = 0;
    // The nodes from the root on, by what is left of their children.
    let mut open = vec![(slice::from_ref(&ROOT).iter(), Motion::NONE)];
    while let Some((children, motion)) = open.last_mut() {
        let motion = *motion;
        let Some(number) = children.next() else {
            open.pop();
            continue;
        };
        match file.nodes.get(number).ok_or(MagicaError::NoNode(*number))? {
            Node::Transform(node) if node.hidden || file.hidden_layers.contains(&node.layer) => hidden += 1,
            Node::Transform(node) => {
                open.push((slice::from_ref(&node.child).iter(), motion.after(motion_of(node)?)))
            }
            Node::Group(children) => open.push((children.iter(), motion)),
            Node::Shape(shape) => {
                if let Some(model) = shape.model {
                    each(place(file, model, motion)?)?;
                }
            }
        }
        parts += 1;
        if parts > MOST_PARTS || open.len() > file.nodes.len() + 1 {
            return Err(MagicaError::LongScene(MOST_PARTS));
        }
    }
    Ok(hidden)
}

const ROOT: u32 = 0;

fn place(file: &File, model: u32, motion: Motion) -> Result<Placed, MagicaError> {
    let index = usize::try_from(model).ok().filter(|&index| index < file.models.len());
    let index = index.ok_or(MagicaError::SceneModel(model, file.models.len()))?;
    Ok(Placed { model: index, motion })
}

fn motion_of(node: &Transform) -> Result<Motion, MagicaError> {
    let axes = node.rotation.as_deref().map_or(Ok(Motion::NONE.axes), rotation)?;
    let shift = node.translation.as_deref().map_or(Ok([0; 3]), translation)?;
    Ok(Motion { axes, shift })
}

fn translation(text: &str) -> Result<[i64; 3], MagicaError> {
    let numbers = text.split_whitespace().map(|word| word.parse::<i32>().map(i64::from));
    let numbers = numbers.collect::<Result<Vec<i64>, _>>().ok();
    let numbers = numbers.and_then(|numbers| numbers.try_into().ok());
    numbers.ok_or_else(|| MagicaError::Translation(text.to_owned()))
}

/// Reads a matrix of three rows with one number each that is not zero: bits 0-1 and 2-3 say where it is in the first
/// two rows, bits 4 to 6 are set where it is -1.
fn rotation(text: &str) -> Result<[(usize, i64); 3], MagicaError> {
    let bad = || MagicaError::Rotation(text.to_owned());
    let bits: usize = text.trim().parse::<u8>().map_err(|_| bad())?.into();
    let (first, second) = (bits & 3, bits >> 2 & 3);
    if first == second || first > 2 || second > 2 {
        return Err(bad());
    }
    let sign = |bit: usize| if bits >> bit & 1 == 1 { -1 } else { 1 };
    Ok([(first, sign(4)), (second, sign(5)), (3 - first - second, sign(6))])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rotations_are_read_as_the_format_writes_them() {
        // The example of the format's description: rows 0 1 0, 0 0 -1 and -1 0 0.
        let example = 1 | 2 << 2 | 1 << 5 | 1 << 6;
        assert_eq!(rotation(&example.to_string()), Ok([(1, 1), (2, -1), (0, -1)]));
        for bad in ["0", "3", "12", "256", "x", ""] {
            assert_eq!(rotation(bad), Err(MagicaError::Rotation(bad.to_owned())));
        }
    }

    #[test]
    fn a_quarter_turn_keeps_a_model_about_its_middle() {
        // Rows 0 -1 0, 1 0 0 and 0 0 1: x to y.
        let turn = Motion { axes: rotation("17").unwrap(), shift: [0; 3] };
        let size = [2, 2, 1];
        assert_eq!(turn.apply([1, 1, 0], size), [-1, 0, 0]);
        assert_eq!(turn.apply([0, 0, 0], size), [0, -1, 0]);
        let half = turn.after(turn);
        assert_eq!(half.apply([1, 1, 0], size), [-1, -1, 0]);
        assert_eq!(half.after(half), Motion::NONE);
    }

    #[test]
    fn a_motion_moves_what_the_inner_one_has_moved() {
        let inner = Motion { shift: [10, 0, 0], ..Motion::NONE };
        let outer = Motion { axes: rotation("17").unwrap(), shift: [0, 0, 5] };
        assert_eq!(outer.after(inner).shift, [0, 10, 5]);
    }
}
