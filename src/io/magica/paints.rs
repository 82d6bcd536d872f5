//! The blocks that colours become.

use super::colors::nearest;
use crate::block::{BlockState, color, known};

/// The block nearest in colour.
pub(super) fn block(rgb: [u8; 3]) -> Option<BlockState> {
    let paints = paints();
    let colors: Vec<[u8; 3]> = paints.iter().map(|(_, color)| *color).collect();
    nearest(rgb, &colors).map(|at| paints[at].0.clone())
}

/// The blocks to choose from, with their colours.
fn paints() -> Vec<(BlockState, [u8; 3])> {
    let lines = include_str!("paints.txt").lines().filter(|line| !line.starts_with('#'));
    let states = lines.flat_map(str::split_whitespace).filter_map(|name| Some(known(name)?.default_state()));
    states.map(|state| (rgb(&state), state)).map(|(rgb, state)| (state, rgb)).collect()
}

fn rgb(state: &BlockState) -> [u8; 3] {
    let [red, green, blue, _] = color(state).0;
    [red, green, blue]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::block::{Shape, shape};
    use std::collections::BTreeSet;

    #[test]
    fn paints_are_plain_blocks_and_come_back_as_themselves() {
        let text = include_str!("paints.txt").lines().filter(|line| !line.starts_with('#'));
        let names: Vec<&str> = text.flat_map(str::split_whitespace).collect();
        let paints = paints();
        assert_eq!(paints.iter().map(|(state, _)| state.short_name()).collect::<Vec<_>>(), names);
        for (state, rgb) in &paints {
            assert_eq!(shape(state), Shape::Full, "{state}");
            assert!(color(state).is_opaque(), "{state}");
            assert_eq!(state.properties().count(), 0, "{state}");
            assert_eq!(block(*rgb).as_ref(), Some(state));
        }
        let colors: BTreeSet<_> = paints.iter().map(|(_, color)| color).collect();
        assert_eq!(colors.len(), paints.len(), "each has a colour of its own");
    }
}
