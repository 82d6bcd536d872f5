//! Shapes and buildings drawn in letters.

use crate::shapes::{Placed, Production, ShapeGrammar};
use crate::space::{Axis, Cell};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

/// Blocks, and the box around them.
struct Drawing {
    blocks: BTreeMap<[i32; 3], String>,
    low: Cell,
    high: Cell,
}

impl Drawing {
    fn of(blocks: impl Iterator<Item = (Cell, String)>) -> Drawing {
        let blocks: BTreeMap<_, _> = blocks.map(|(cell, name)| (cell.to_array(), name)).collect();
        let cells = || blocks.keys().map(|cell| Cell::from_array(*cell));
        let (low, high) =
            cells().fold((Cell::MAX, Cell::MIN), |(low, high), cell| (low.min(cell), high.max(cell)));
        Drawing { blocks, low, high }
    }

    /// The axis to look along: the shortest, and a floor from above.
    fn along(&self) -> Axis {
        let size = self.high - self.low;
        Axis::ALL.into_iter().rev().min_by_key(|axis| axis.of(size)).unwrap_or(Axis::Z)
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
        let mut text = String::new();
        for row in 0..=up.of(self.high - self.low) {
            text += "       ";
            for column in 0..=across.of(self.high - self.low) {
                let height = if up == Axis::Y { up.of(self.high) - row } else { up.of(self.low) + row };
                text.push(self.nearest(
                    along,
                    (across, across.of(self.low) + column),
                    (up, height),
                    &letters,
                ));
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
        let depths = (along.of(self.low)..=along.of(self.high)).rev();
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
    Drawing::of(named(grammar, added)).text()
}

/// A whole building from the south.
pub fn building(grammar: &ShapeGrammar, production: &Production<'_>) -> String {
    let blocks = production.placed().iter().flat_map(|placed| production.blocks(placed));
    Drawing::of(named(grammar, blocks)).text()
}

/// A shape in a few words: its size and where it is.
pub fn words(grammar: &ShapeGrammar, placed: &Placed) -> String {
    let Drawing { low, high, .. } =
        Drawing::of(named(grammar, grammar.parts.blocks(placed.form, placed.placement)));
    let size = high - low + Cell::ONE;
    format!("{} x {} x {} at {}, {}, {}", size.x, size.y, size.z, low.x, low.y, low.z)
}
