//! What blocks are for in a house, from where they stand in the examples.

use super::kinds::GROUND;
use crate::block::{self, Known, Shape};
use crate::grid::Grid;
use crate::space::{Axis, Cell};
use std::collections::BTreeMap;

/// Where a block stands in its column of cells.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Stand {
    Wall,
    Floor,
    Roof,
    Base,
}

/// What blocks of a name are for, in the order in which people ask for it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Role {
    Wall,
    Frame,
    Base,
    Flooring,
    RoofBlock,
    RoofStairs,
    RoofSlab,
    TrimStairs,
    TrimSlab,
    Pane,
    Door,
    Trapdoor,
    Fence,
    Parapet,
    Gate,
    Ground,
}

impl Role {
    /// The constant for the block that is most of it.
    pub fn word(self) -> &'static str {
        match self {
            Role::Wall => "wall",
            Role::Frame => "frame",
            Role::Base => "base",
            Role::Flooring => "flooring",
            Role::RoofBlock => "roof_block",
            Role::RoofStairs => "roof_stairs",
            Role::RoofSlab => "roof_slab",
            Role::TrimStairs => "trim_stairs",
            Role::TrimSlab => "trim_slab",
            Role::Pane => "pane",
            Role::Door => "main_door",
            Role::Trapdoor => "trapdoor",
            Role::Fence => "fence",
            Role::Parapet => "parapet",
            Role::Gate => "gate",
            Role::Ground => "ground",
        }
    }
}

/// The role of each block that is a building material, and how many cells it fills.
pub fn roles<'g>(grids: impl Iterator<Item = &'g Grid>) -> BTreeMap<String, (Role, u64)> {
    let mut stands: BTreeMap<String, BTreeMap<Stand, u64>> = BTreeMap::new();
    for grid in grids {
        let mut counts: BTreeMap<(u16, Stand), u64> = BTreeMap::new();
        for_each_run(grid, &mut |id, stand, len| *counts.entry((id, stand)).or_default() += len);
        for ((id, stand), count) in counts {
            let name = grid.palette().states()[usize::from(id)].short_name();
            *stands.entry(name.to_owned()).or_default().entry(stand).or_default() += count;
        }
    }
    let role = |(name, stands): (String, BTreeMap<Stand, u64>)| {
        // Of equals the first: `max_by_key` keeps the last.
        let (most, _) = stands.iter().rev().max_by_key(|(_, count)| **count)?;
        let role = role(block::known(&name)?, *most)?;
        Some((name, (role, stands.values().sum())))
    };
    stands.into_iter().filter_map(role).collect()
}

/// Goes through the columns of a grid, one run of equal states after another.
fn for_each_run(grid: &Grid, note: &mut impl FnMut(u16, Stand, u64)) {
    let size = grid.size();
    let height = Axis::Y.of(size);
    for (x, z) in (0..size.x).flat_map(|x| (0..size.z).map(move |z| (x, z))) {
        let at = |y: i32| grid.id(Cell::new(x, y, z));
        let is_air = |y: i32| grid.palette().states()[usize::from(at(y))].is_air();
        let Some(top) = (0..height).rev().find(|y| !is_air(*y)) else { continue };
        let mut low = 0;
        while low <= top {
            let high = (low..=top).find(|y| at(*y) != at(low)).unwrap_or(top + 1);
            let len = high - low;
            let stand = match (low, high) {
                (0, _) if 3 * len <= height => Stand::Base,
                (_, high) if high == top + 1 && 2 * len <= height => Stand::Roof,
                (_, high) if len == 1 && high <= top && is_air(high) => Stand::Floor,
                _ => Stand::Wall,
            };
            if !is_air(low) {
                note(at(low), stand, len as u64);
            }
            low = high;
        }
    }
}

/// Full blocks that stand in houses as furniture does.
const FURNITURE: [&str; 26] = [
    "barrel",
    "bee_nest",
    "beehive",
    "blast_furnace",
    "bookshelf",
    "cartography_table",
    "carved_pumpkin",
    "chiseled_bookshelf",
    "crafting_table",
    "dispenser",
    "dropper",
    "fletching_table",
    "furnace",
    "glowstone",
    "hay_block",
    "jack_o_lantern",
    "jukebox",
    "loom",
    "melon",
    "note_block",
    "observer",
    "pumpkin",
    "redstone_lamp",
    "smithing_table",
    "smoker",
    "target",
];

/// What a block is for that stands so; `None` for what is no building material.
fn role(known: &Known, stand: Stand) -> Option<Role> {
    let state = known.default_state();
    let name = state.short_name();
    if FURNITURE.contains(&name) || name.ends_with("_leaves") {
        return None;
    }
    let is_frame = ["_log", "_wood", "_stem", "_hyphae", "_pillar"].iter().any(|end| name.ends_with(end));
    Some(match (block::shape(&state), stand) {
        _ if GROUND.contains(&name) => Role::Ground,
        _ if name.contains("glass") => Role::Pane,
        (Shape::Pane(_), _) => Role::Pane,
        (Shape::Full, _) if is_frame => Role::Frame,
        (Shape::Full, Stand::Wall) => Role::Wall,
        (Shape::Full, Stand::Floor) => Role::Flooring,
        (Shape::Full, Stand::Roof) => Role::RoofBlock,
        (Shape::Full, Stand::Base) => Role::Base,
        (Shape::Stairs { .. }, Stand::Roof) => Role::RoofStairs,
        (Shape::Stairs { .. }, _) => Role::TrimStairs,
        (Shape::Slab(_), Stand::Roof) => Role::RoofSlab,
        (Shape::Slab(_), _) => Role::TrimSlab,
        (Shape::Door(_), _) => Role::Door,
        (Shape::Trapdoor(_), _) => Role::Trapdoor,
        (Shape::Fence(_), _) => Role::Fence,
        (Shape::Wall { .. }, _) => Role::Parapet,
        (Shape::Gate { .. }, _) => Role::Gate,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::super::labels::is_name;
    use super::*;

    /// A column of states, from the bottom up.
    fn column(names: &[&str]) -> Grid {
        let mut grid = Grid::new(Cell::new(1, names.len() as i32, 1));
        for (name, y) in names.iter().zip(0..) {
            let id = grid.intern(&name.parse().unwrap()).unwrap();
            grid.set(Cell::new(0, y, 0), id);
        }
        grid
    }

    #[test]
    fn blocks_are_for_what_stands_where_they_stand() {
        let house = column(&[
            "cobblestone",
            "oak_planks",
            "air",
            "oak_log",
            "bricks",
            "bricks",
            "glass",
            "spruce_planks",
            "oak_stairs",
        ]);
        let expected = [
            ("bricks", Role::Wall),
            ("cobblestone", Role::Base),
            ("glass", Role::Pane),
            ("oak_log", Role::Frame),
            ("oak_planks", Role::Flooring),
            ("oak_stairs", Role::RoofStairs),
            ("spruce_planks", Role::Wall),
        ];
        let found = roles([&house].into_iter());
        let found: Vec<(&str, Role)> = found.iter().map(|(name, (role, _))| (name.as_str(), *role)).collect();
        assert_eq!(found, expected);
    }

    #[test]
    fn furniture_and_plants_are_no_materials() {
        assert!(roles([&column(&["furnace", "oak_leaves", "torch", "mod:wall"])].into_iter()).is_empty());
    }

    #[test]
    fn words_of_roles_mean_nothing_else() {
        let all = [
            Role::Wall,
            Role::Frame,
            Role::Base,
            Role::Flooring,
            Role::RoofBlock,
            Role::RoofStairs,
            Role::RoofSlab,
            Role::TrimStairs,
            Role::TrimSlab,
            Role::Pane,
            Role::Door,
            Role::Trapdoor,
            Role::Fence,
            Role::Parapet,
            Role::Gate,
            Role::Ground,
        ];
        assert!(all.into_iter().all(|role| is_name(role.word())));
    }
}
