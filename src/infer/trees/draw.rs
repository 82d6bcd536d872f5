//! What says a length that is left to chance.

use crate::grammar::ast::{BinaryOp, Function};
use crate::graph::Expr;
use crate::infer::joint::emit::value;
use crate::infer::joint::laws::{Law, law_of};
use crate::space::Axis;

/// A length that is drawn, with its least and its greatest, in cells.
#[derive(Clone, Debug)]
pub struct Draw {
    pub low: i32,
    pub high: i32,
    pub expr: Expr,
}

/// Tables of more lengths than this are told as ranges by weight.
const LONG: usize = 4;
/// So many ranges at most.
const MOST_RANGES: usize = 5;
/// The bits of a range in a table.
const RANGE: f64 = 14.0;

impl Draw {
    /// The shortest way to draw these lengths, each with how often it was seen.
    pub fn of(lengths: &[(i32, u32)]) -> Draw {
        Draw::by(&law_of(lengths.iter().copied()))
    }

    /// A draw by a law that gives lengths by itself.
    pub fn by(law: &Law) -> Draw {
        let (low, high) = (law.lengths().min().unwrap_or(0), law.lengths().max().unwrap_or(0));
        let expr = match law {
            Law::Table(entries) if entries.len() > LONG => ranges(entries),
            law => value(law),
        };
        Draw { low, high, expr }
    }

    /// The same, but none that leaves less than `rest` of the scope along an axis.
    pub fn within(self, axis: Axis, rest: i32) -> Draw {
        let most = minus(Expr::ScopeSize(axis), rest);
        Draw { expr: Expr::Call(Function::Min, vec![self.expr, most]), ..self }
    }

    /// The same, but `count` of them leave `rest` of the scope along an axis at least.
    pub fn within_several(self, axis: Axis, rest: i32, count: i32) -> Draw {
        if count <= 1 {
            return self.within(axis, rest);
        }
        let left = minus(Expr::ScopeSize(axis), rest);
        let share = Expr::binary(BinaryOp::Divide, left, number(count));
        let most = Expr::Call(Function::Floor, vec![share]);
        Draw { expr: Expr::Call(Function::Min, vec![self.expr, most]), ..self }
    }
}

/// A table as ranges by weight, as many as are the shortest to say.
fn ranges(entries: &[(i32, u32)]) -> Expr {
    let total: u32 = entries.iter().map(|(_, count)| count).sum();
    let bits = |bin: &[(i32, u32)]| {
        let count: u32 = bin.iter().map(|(_, count)| count).sum();
        let span = bin[bin.len() - 1].0 - bin[0].0 + 1;
        RANGE + f64::from(count) * (f64::from(total) / f64::from(count) * f64::from(span)).log2()
    };
    // By number of ranges and entries covered: the bits, and where the last range begins.
    let mut best = vec![vec![(f64::INFINITY, 0); entries.len() + 1]; MOST_RANGES + 1];
    best[0][0] = (0.0, 0);
    for count in 1..=MOST_RANGES {
        for end in 1..=entries.len() {
            let options =
                (0..end).map(|start| (best[count - 1][start].0 + bits(&entries[start..end]), start));
            best[count][end] =
                options.fold((f64::INFINITY, 0), |one, other| if other.0 < one.0 { other } else { one });
        }
    }
    let fewest = (1..=MOST_RANGES)
        .min_by(|one, other| best[*one][entries.len()].0.total_cmp(&best[*other][entries.len()].0));
    let mut bins = Vec::new();
    let mut end = entries.len();
    for count in (1..=fewest.unwrap_or(1)).rev() {
        let start = best[count][end].1;
        bins.push(&entries[start..end]);
        end = start;
    }
    bins.reverse();
    let range = |bin: &&[(i32, u32)]| Expr::between(bin[0].0, bin[bin.len() - 1].0);
    let weight = |bin: &&[(i32, u32)]| number(bin.iter().map(|(_, count)| *count as i32).sum());
    match bins.as_slice() {
        [only] => range(only),
        bins => Expr::Pick(bins.iter().map(|bin| (weight(bin), range(bin))).collect()),
    }
}

pub fn number(value: i32) -> Expr {
    Expr::number(f64::from(value))
}

pub fn minus(expr: Expr, by: i32) -> Expr {
    match by {
        0 => expr,
        by if by < 0 => Expr::binary(BinaryOp::Add, expr, number(-by)),
        by => Expr::binary(BinaryOp::Subtract, expr, number(by)),
    }
}
