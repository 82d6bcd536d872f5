//! Shapes and buildings drawn in letters.

use crate::shapes::{Placed, Production, ShapeGrammar};
use crate::space::{Axis, Bounds, Cell};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

/// Blocks, and the box around them.
struct Sketch {
    blocks: BTreeMap<[i32; 3], String>,
    bounds: Bounds,
}

impl Sketch {
    fn of(blocks: impl Iterator<Item = (Cell, String)>) -> Sketch {
        let blocks: BTreeMap<_, _> = blocks.map(|(cell, name)| (cell.to_array(), name)).collect();
        let bounds = Bounds::around(blocks.keys().map(|cell| Cell::from_array(*cell)));
        Sketch { blocks, bounds: bounds.unwrap_or(Bounds::of_size(Cell::ZERO)) }
    }

    /// The axis to look along: the shortest, and a floor from above.
    fn along(&self) -> Axis {
        Axis::ALL.into_iter().rev().min_by_key(|axis| self.bounds.len(*axis)).unwrap_or(Axis::Z)
    }

    /// The letter of each block: of those that begin alike, the later ones take another of their letters.
    fn letters(&self) -> BTreeMap<&str, char> {
        let names: BTreeSet<&str> = self.blocks.values().map(String::as_str).collect();
        let mut letters: BTreeMap<&str, char> = BTreeMap::new();
        for name in names {
            let own = name.chars().filter(char::is_ascii_lowercase);
            let all = own.chain('a'..='z').chain('A'..='Z');
            let free = all.into_iter().find(|letter| !letters.values().any(|taken| taken == letter));
            letters.insert(name, free.unwrap_or('?'));
        }
        letters
    }

    /// The nearest block of each column along an axis, and which letter is what.
    fn text(&self) -> String {
        let along = self.along();
        let letters = self.letters();
        let [across, up] = match along {
            Axis::X => [Axis::Z, Axis::Y],
            Axis::Y => [Axis::X, Axis::Z],
            Axis::Z => [Axis::X, Axis::Y],
        };
        let Bounds { min, max } = self.bounds;
        let mut text = String::new();
        for row in 0..self.bounds.len(up) {
            text += "       ";
            for column in 0..self.bounds.len(across) {
                let height = if up == Axis::Y { up.of(max) - 1 - row } else { up.of(min) + row };
                text.push(self.nearest(along, (across, across.of(min) + column), (up, height), &letters));
            }
            text.truncate(text.trim_end().len());
            text.push('\n');
        }
        let legend: Vec<String> = letters.iter().map(|(name, letter)| format!("{letter} {name}")).collect();
        let _ = writeln!(text, "       {}", legend.join(", "));
        text
    }

    fn nearest(
        &self,
        along: Axis,
        column: (Axis, i32),
        row: (Axis, i32),
        letters: &BTreeMap<&str, char>,
    ) -> char {
        let depths = (along.of(self.bounds.min)..along.of(self.bounds.max)).rev();
        let mut blocks = depths.filter_map(|depth| {
            let mut cell = [0; 3];
            for (axis, place) in [(along, depth), column, row] {
                cell[axis.index()] = place;
            }
            self.blocks.get(&cell)
        });
        blocks.next().map_or(' ', |name| letters[name.as_str()])
    }
}

fn named<'a>(
    grammar: &'a ShapeGrammar,
    blocks: impl Iterator<Item = (Cell, u32)> + 'a,
) -> impl Iterator<Item = (Cell, String)> + 'a {
    blocks.map(|(cell, state)| (cell, grammar.parts.states.get(state).short_name().to_owned()))
}

/// A shape that a rule gives: its blocks, where nothing is yet.
pub fn shape(grammar: &ShapeGrammar, production: &Production<'_>, placed: &Placed) -> String {
    let added = production.blocks(placed).filter(|(cell, _)| production.is_free(*cell));
    Sketch::of(named(grammar, added)).text()
}

/// A whole building from the south.
pub fn building(grammar: &ShapeGrammar, production: &Production<'_>) -> String {
    let blocks = production.placed().iter().flat_map(|placed| production.blocks(placed));
    Sketch::of(named(grammar, blocks)).text()
}

/// A shape in a few words: its size and where it is.
pub fn words(grammar: &ShapeGrammar, placed: &Placed) -> String {
    let blocks = grammar.parts.blocks(placed.form, placed.placement);
    let bounds = Bounds::around(blocks.map(|(cell, _)| cell)).unwrap_or(Bounds::of_size(Cell::ZERO));
    let (size, low) = (bounds.size(), bounds.min);
    format!("{} x {} x {} at {}, {}, {}", size.x, size.y, size.z, low.x, low.y, low.z)
}
