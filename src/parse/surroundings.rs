//! What a node sees of the world around it: arguments, constants, its place among shares. Equal surroundings have
//! one number, so that what was found in one place holds in another.

use super::draw::{Draw, Sight};
use super::needs::Needs;
use super::value::Value;
use crate::graph::{Expr, NodeIndex, OpGraph};
use crate::space::Scope;
use fixedbitset::FixedBitSet;
use rustc_hash::FxHashMap;
use std::hash::Hash;
use std::sync::Arc;

/// The values of all constants, style by style; `None` for those that are not asked for.
type Table = Vec<Option<Value>>;

#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Surroundings {
    pub params: Arc<[Value]>,
    pub share: (u32, u32),
    /// The number of a table of constants.
    pub table: u32,
    /// Which part of the table counts: 0, or the number of a style and one.
    pub style: usize,
}

/// The number of surroundings.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct Around(u32);

impl Around {
    /// Nothing to see.
    pub const NOTHING: Around = Around(0);
}

/// Surroundings and tables by number.
#[derive(Debug)]
pub struct Known {
    surroundings: Numbered<Surroundings>,
    tables: Numbered<Table>,
    /// What a node sees of surroundings, if it sees anything.
    seen: FxHashMap<(Around, NodeIndex), Around>,
    empty: Arc<[Value]>,
}

#[derive(Debug)]
struct Numbered<T> {
    list: Vec<T>,
    numbers: FxHashMap<T, u32>,
}

impl<T: Clone + Eq + Hash> Numbered<T> {
    fn starting(first: T) -> Numbered<T> {
        Numbered { list: vec![first.clone()], numbers: FxHashMap::from_iter([(first, 0)]) }
    }

    fn number(&mut self, value: T) -> u32 {
        if let Some(&number) = self.numbers.get(&value) {
            return number;
        }
        self.list.push(value.clone());
        self.numbers.insert(value, self.list.len() as u32 - 1);
        self.list.len() as u32 - 1
    }
}

impl Default for Known {
    fn default() -> Known {
        let empty: Arc<[Value]> = Arc::from([]);
        let nothing = Surroundings { params: empty.clone(), share: (0, 1), table: 0, style: 0 };
        Known {
            surroundings: Numbered::starting(nothing),
            tables: Numbered::starting(Vec::new()),
            seen: FxHashMap::default(),
            empty,
        }
    }
}

impl Known {
    pub fn get(&self, around: Around) -> &Surroundings {
        &self.surroundings.list[around.0 as usize]
    }

    fn number(&mut self, surroundings: Surroundings) -> Around {
        Around(self.surroundings.number(surroundings))
    }

    /// The surroundings of a run's start.
    pub fn start(&mut self, table: Table) -> Around {
        let table = self.tables.number(table);
        self.number(Surroundings { table, ..self.get(Around::NOTHING).clone() })
    }

    pub fn with_params(&mut self, around: Around, params: Vec<Value>) -> Around {
        self.number(Surroundings { params: Arc::from(params), ..self.get(around).clone() })
    }

    pub fn with_style(&mut self, around: Around, style: usize) -> Around {
        self.number(Surroundings { style, ..self.get(around).clone() })
    }

    pub fn with_share(&mut self, around: Around, share: (u32, u32)) -> Around {
        self.number(Surroundings { share, ..self.get(around).clone() })
    }

    /// What a node sees of surroundings.
    pub fn seen_by(&mut self, node: NodeIndex, needs: &Needs, around: Around) -> Around {
        if around == Around::NOTHING || needs.is_none() {
            return Around::NOTHING;
        }
        if let Some(&seen) = self.seen.get(&(around, node)) {
            return seen;
        }
        let all = self.get(around).clone();
        let table = self.narrowed(all.table, &needs.constants);
        let seen = self.number(Surroundings {
            params: if needs.params { all.params } else { self.empty.clone() },
            share: if needs.share { all.share } else { (0, 1) },
            table,
            style: if needs.constants.is_clear() { 0 } else { all.style },
        });
        self.seen.insert((around, node), seen);
        seen
    }

    /// The table with the values of these constants alone.
    fn narrowed(&mut self, table: u32, constants: &FixedBitSet) -> u32 {
        if table == 0 || constants.is_clear() {
            return 0;
        }
        let width = constants.len().max(1);
        let all = self.tables.list[table as usize].iter().enumerate();
        let narrowed = all.map(|(at, value)| value.clone().filter(|_| constants.contains(at % width)));
        let narrowed = narrowed.collect();
        self.tables.number(narrowed)
    }

    /// What the expressions of an operation see; a grammar has `count` constants.
    pub fn sight<'a>(&'a self, around: Around, count: usize, scope: &'a Scope) -> Sight<'a> {
        let Surroundings { params, share, table, style } = self.get(around);
        let constants = self.tables.list[*table as usize].get(style * count..).unwrap_or(&[]);
        Sight { params, constants, share: *share, scope: Some(scope) }
    }
}

/// Tables that are drawn, at the most.
const MOST_TABLES: usize = 1 << 12;

/// All values that the constants in `asked` may have together, with the chance of each.
pub fn tables(graph: &OpGraph, asked: &FixedBitSet) -> Vec<(Table, f64)> {
    let asked = with_those_they_use(graph, asked);
    let mut open: Vec<(Table, f64)> = vec![(Vec::new(), 1.0)];
    for style in 0..=graph.styles.len() {
        for at in 0..graph.constants.len() {
            let mut next = Vec::new();
            for (table, chance) in open {
                let values = values(graph, &asked, &table, style, at);
                for (value, own) in values.into_iter().take(MOST_TABLES.saturating_sub(next.len())) {
                    let mut table = table.clone();
                    table.push(value);
                    next.push((table, chance * own));
                }
            }
            open = next;
        }
    }
    open
}

/// The values that a constant may have in a style, given those before it.
fn values(
    graph: &OpGraph,
    asked: &FixedBitSet,
    table: &Table,
    style: usize,
    at: usize,
) -> Vec<(Option<Value>, f64)> {
    if !asked.contains(at) {
        return vec![(None, 1.0)];
    }
    let count = graph.constants.len();
    let styled = style.checked_sub(1).and_then(|style| graph.styles.get(style));
    let own =
        styled.and_then(|style| style.values.iter().find(|(place, _)| *place == at)).map(|(_, value)| value);
    let expr = own.unwrap_or(&graph.constants[at].value);
    let mut uses_changed = own.is_some();
    expr.for_each(&mut |part| {
        if let Expr::Constant(used) = part {
            uses_changed |= table.get(style * count + used) != table.get(*used);
        }
    });
    // What a style leaves as it is comes from the same draw.
    if style > 0 && !uses_changed {
        return vec![(table[at].clone(), 1.0)];
    }
    let sight =
        Sight { params: &[], constants: &table[style * count..], share: (0, 1), scope: None::<&Scope> };
    let drawn = sight.draw(expr).map(Draw::handed_on).unwrap_or_default();
    drawn.into_iter().map(|(value, chance)| (Some(value), chance)).collect()
}

/// The constants and those that their values are made of.
fn with_those_they_use(graph: &OpGraph, asked: &FixedBitSet) -> FixedBitSet {
    let mut all = asked.clone();
    all.grow(graph.constants.len());
    // A constant uses only those above it.
    for at in (0..graph.constants.len()).rev().collect::<Vec<_>>() {
        if all.contains(at) {
            let own = std::iter::once(&graph.constants[at].value);
            let styled = graph.styles.iter().flat_map(|style| &style.values);
            let styled = styled.filter(|(place, _)| *place == at).map(|(_, value)| value);
            for expr in own.chain(styled) {
                expr.for_each(&mut |part| {
                    if let Expr::Constant(used) = part {
                        all.insert(*used);
                    }
                });
            }
        }
    }
    all
}
