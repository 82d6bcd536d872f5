use crate::block::{BlockState, Cuboid, Rgba, boxes};
use crate::grid::Grid;
use std::collections::BTreeMap;

/// The materials of a mesh in order of name: one for every block, and one for every colour that a part of a block has
/// instead of the block's.
pub(super) struct Materials(Vec<(String, Rgba)>);

impl Materials {
    pub fn of(grid: &Grid, color: impl Fn(&BlockState) -> Rgba) -> Materials {
        let mut states: Vec<&BlockState> = grid.palette().states().iter().collect();
        states.sort_unstable();
        let mut named = BTreeMap::new();
        for state in states {
            for part in boxes(state) {
                let color = part.color.unwrap_or_else(|| color(state));
                named.entry(name(state, &part)).or_insert(color);
            }
        }
        Materials(named.into_iter().collect())
    }

    /// The number of the material of a part of `state`.
    pub fn number(&self, state: &BlockState, part: &Cuboid) -> usize {
        let name = name(state, part);
        self.0.partition_point(|(other, _)| *other < name)
    }

    pub fn is_opaque(&self, number: usize) -> bool {
        self.0[number].1.is_opaque()
    }

    pub fn len(&self) -> usize {
        self.0.len()
    }

    pub fn name(&self, number: usize) -> &str {
        &self.0[number].0
    }

    /// The file that says how they look.
    pub fn mtl(&self) -> String {
        self.0.iter().map(|(name, color)| mtl(name, *color)).collect()
    }
}

fn name(state: &BlockState, part: &Cuboid) -> String {
    match part.color {
        None => state.short_name().to_owned(),
        Some(Rgba([red, green, blue, alpha])) => format!("detail_{red:02x}{green:02x}{blue:02x}{alpha:02x}"),
    }
}

/// Programs read either of `d` and `Tr`, of which one says how much of what is behind is hidden, the other how much
/// is seen.
fn mtl(name: &str, color: Rgba) -> String {
    let [red, green, blue, alpha] = color.0.map(|channel| f64::from(channel) / 255.0);
    let clear = match color.is_opaque() {
        true => String::new(),
        false => format!("d {alpha:.4}\nTr {:.4}\n", 1.0 - alpha),
    };
    format!("newmtl {name}\nKd {red:.4} {green:.4} {blue:.4}\n{clear}")
}
