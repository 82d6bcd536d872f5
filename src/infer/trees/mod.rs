//! The trees of labelled boxes joined: one rule for many places of the examples, by description length.
//!
//! ```text
//! boxes --cuts--> Forest --padding--> Forest --explain--> Roles --merge--> Roles --emit--> OpGraph
//! ```

mod bounds;
mod cuts;
mod draw;
mod emit;
mod explain;
mod fixed;
mod forest;
mod form;
mod groups;
mod hist;
mod list;
mod merge;
mod padding;
mod role;
mod row;
mod sketch;

use super::emit::{Primitives, sizes};
use super::example::{Example, Terminal, Terminals};
use super::{Learnt, Method, Notes};
use crate::graph::{Builder, raise};
use crate::space::{Bounds, Cell};
use forest::Forest;
use role::{RoleId, Roles};

/// The bits of a rule among few.
const PRICE: f64 = 16.0;
/// A rule has to be worth such a share of the whole description: of more examples nobody wants more rules.
const SHARE: f64 = 1.0 / 400.0;

/// The roles of a forest, those that are one merged, at the price that a rule has for so much; and that of the roots.
fn merged(forest: &Forest) -> (Roles, RoleId) {
    let (plain, root) = explain::explain(forest, PRICE);
    let (mut roles, root) = explain::explain(forest, PRICE + SHARE * plain.bits(root));
    merge::merge(&mut roles, forest, root);
    (roles, root)
}

/// So few rules can be read as they are: they stay as exact as they are.
const FEW_RULES: usize = 64;

/// What labelled boxes have in common, if that takes fewer rules than what was learnt of each by itself. Lists forget in
/// which order their units come, which few rules need not.
pub fn shorter(apart: &Learnt, examples: &[Example]) -> Option<Learnt> {
    let count = |learnt: &Learnt| raise(&learnt.graph).rules.len();
    let apart = count(apart);
    let is_worth_it = examples.len() > 1 && apart > FEW_RULES;
    is_worth_it.then(|| joined(examples))?.filter(|joined| count(joined) < apart)
}

/// Learns one op graph from labelled boxes; `None` where some of them cannot be cut.
fn joined(examples: &[Example]) -> Option<Learnt> {
    let mut terminals = Terminals::default();
    let all: Vec<(Bounds, Vec<(Bounds, u32)>)> =
        examples.iter().map(|example| (example.bounds(), example.boxes(&mut terminals, &[]))).collect();
    let forest = cuts::shortest(&all)?;
    let (roles, root) = merged(&forest);
    let least = examples.iter().map(|example| example.bounds().size()).reduce(Cell::min)?;
    let mut primitives = Primitives::default();
    let mut builder = Builder::default();
    let mut leaf = |builder: &mut Builder, label: u32| match &terminals.list[label as usize] {
        Terminal::Label(label) => primitives.labelled(builder, label),
        Terminal::Block(_) => builder.nil(),
    };
    let node = emit::emit((&roles, &forest), root, least, &mut builder, &mut leaf);
    let (mut graph, _) = builder.finish(node);
    graph.sizes = sizes(examples);
    let labels = primitives.place_in(&mut graph);
    Some(Learnt { graph, labels, by: Method::Joint, is_proved: false, notes: Notes::default() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::graph::{OpGraph, raise};
    use crate::grid::{LabelledBox, LabelledBoxes};
    use crate::infer::derived;
    use crate::run::{Library, Options, run};

    /// Rows of towers of these heights, three blocks wide; rows are two apart.
    fn town(rows: &[&[i32]]) -> Example {
        let tower = |row: usize, at: usize, height: i32| {
            let low = Cell::new(3 * at as i32, 0, 5 * row as i32);
            let bounds = Bounds::new(low, low + Cell::new(3, height, 3));
            LabelledBox { label: "rect".to_owned(), bounds }
        };
        let towers = rows.iter().enumerate();
        let towers = towers.flat_map(|(row, heights)| {
            heights.iter().enumerate().map(move |(at, height)| tower(row, at, *height))
        });
        Example::Boxes(LabelledBoxes::new(towers.collect()).unwrap())
    }

    fn towns() -> Vec<Example> {
        let one: [&[i32]; 3] = [&[4, 9, 6, 5], &[8, 3, 7], &[5, 4, 9, 6, 7]];
        let two: [&[i32]; 4] = [&[7, 6, 3], &[9, 5, 5, 8, 4], &[6, 8, 3, 4], &[3, 7, 9]];
        let three: [&[i32]; 2] = [&[5, 5, 8, 7], &[4, 6, 9, 3, 8]];
        vec![town(&one), town(&two), town(&three)]
    }

    fn runs(graph: &OpGraph, seed: u64) -> bool {
        run(graph, &Library::new(), &Options { seed, ..Options::default() }).is_ok()
    }

    #[test]
    fn rows_of_any_number_are_one_rule() {
        let examples = towns();
        let learnt = joined(&examples).unwrap();
        let text = raise(&learnt.graph).to_string();
        assert!(raise(&learnt.graph).rules.len() <= 8, "{text}");
        assert_eq!(derived(&examples, &learnt.graph, &learnt.labels, 1 << 16), [true; 3], "{text}");
        assert!((0..200).all(|seed| runs(&learnt.graph, seed)), "{text}");
        assert_eq!(raise(&joined(&towns()).unwrap().graph).to_string(), text);
    }
}
