//! Which sizes the start scope may have.

use super::Parser;
use super::draw::{Draw, Sight};
use super::surroundings::tables;
use crate::graph::{Expr, StartSize};
use crate::space::Cell;
use fixedbitset::FixedBitSet;

impl Parser<'_> {
    /// Whether a run may start on a scope of this size, in the grammar's own axes: whatever the size, where the grammar
    /// says none.
    pub fn starts(&self, size: Cell) -> bool {
        let graph = self.rules.graph;
        let mut asked = FixedBitSet::with_capacity(graph.constants.len());
        for expr in graph.sizes.iter().flat_map(|start| start.size.iter().chain([&start.weight])) {
            expr.for_each(&mut |part| {
                if let Expr::Constant(at) = part {
                    asked.grow_and_insert(*at);
                }
            });
        }
        graph.sizes.is_empty()
            || tables(graph, &asked).iter().any(|(table, _)| {
                let sight = Sight { params: &[], constants: table, share: (0, 1), scope: None };
                graph.sizes.iter().any(|start| can_be(&sight, start, size))
            })
    }
}

fn can_be(sight: &Sight<'_>, start: &StartSize, size: Cell) -> bool {
    let lengths = start.size.iter().zip(size.to_array());
    sight.weight(&start.weight).is_some_and(|weight| weight > 0.0)
        && lengths.into_iter().all(|(length, wanted)| is_among(sight, length, wanted))
}

fn is_among(sight: &Sight<'_>, length: &Expr, wanted: i32) -> bool {
    let rounds = |number: f64| number.round() as i32 == wanted;
    match sight.draw(length) {
        None => false,
        Some(Draw::Between(low, high)) => (low.round()..=high.round()).contains(&f64::from(wanted)),
        Some(drawn) => drawn.numbers().is_some_and(|list| list.iter().any(|(number, _)| rounds(*number))),
    }
}

#[cfg(test)]
mod tests {
    use crate::grammar::read;
    use crate::graph::lower;
    use crate::parse::{Laws, Parser};
    use crate::space::Cell;

    #[test]
    fn a_run_starts_on_the_sizes_that_the_grammar_says() {
        let starts = |text: &str, size: [i32; 3]| {
            let graph = lower(&read(&format!("{text}\na --> I(stone)")).unwrap(), None).unwrap();
            Parser::new(&graph, Laws::AsWritten).starts(Cell::from(size))
        };
        assert!(starts("", [3, 1, 4]), "where none is said, all are");
        let text = "wide = pick{ 1 : 5 | 1 : 9 }\nsize(randint(2, 4), 3, wide) : 2\nsize(7, 7, 7) : 0";
        assert!(starts(text, [2, 3, 5]) && starts(text, [4, 3, 9]));
        assert!(!starts(text, [5, 3, 5]) && !starts(text, [4, 3, 7]) && !starts(text, [7, 7, 7]));
    }
}
