//! The sizes of the start scope.

use super::change::Change;
use super::demand::{Demands, Site};
use super::layout::end_of_item;
use super::texts::{Edit, Program, Texts};
use super::trial::failures;
use crate::grammar::Span;
use crate::grammar::ast::StartSize;
use crate::parse::{Laws, Parser};
use crate::run::Library;
use crate::space::Cell;

/// How a grammar comes to say one more size.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Manner {
    /// By the line that there is, unless there are several or runs fail at the sizes between.
    Widened,
    /// By a line of its own.
    Apart,
}

/// The texts with which a run may start at a size, if the grammar says other sizes.
pub fn started(texts: &Texts, size: Cell, manner: Manner, library: &Library) -> Option<(Texts, Vec<Change>)> {
    let program = texts.read()?;
    if Parser::new(&program.graph, Laws::AsWritten).starts(size) {
        return Some((texts.clone(), Vec::new()));
    }
    let widened = match (manner, program.checked.grammar().sizes.as_slice()) {
        (Manner::Widened, [only]) => widened(texts, &program, only, size),
        _ => None,
    };
    let failed = failures(&program, size, library);
    let is_good =
        |texts: &Texts| texts.read().is_some_and(|widened| failures(&widened, size, library) <= failed);
    widened.filter(|(texts, _)| is_good(texts)).or_else(|| apart(texts, &program, size))
}

fn widened(texts: &Texts, program: &Program, start: &StartSize, size: Cell) -> Option<(Texts, Vec<Change>)> {
    let mut demands = Demands::new(program);
    for (length, wanted) in start.size.iter().zip(size.to_array()) {
        demands.ask(length, f64::from(wanted), "the size", &Site::default())?;
    }
    let (edits, changes) = demands.granted()?;
    Some((texts.edited(&edits), changes))
}

/// One more line behind the last that says sizes.
fn apart(texts: &Texts, program: &Program, size: Cell) -> Option<(Texts, Vec<Change>)> {
    let last = program.checked.grammar().sizes.iter().max_by_key(|start| start.span.start)?;
    let end = last.weight.as_ref().map_or(last.span.end, |weight| weight.span.end);
    let place = program.sources.place(Span::new(end, end));
    let at = end_of_item(place.text, place.span.end);
    let [x, y, z] = size.to_array();
    let text = format!("\nsize({x}, {y}, {z})");
    let edit = Edit { file: place.name.to_owned(), span: Span::new(at, at), text };
    Some((texts.edited(&[edit]), vec![Change::Sized([x, y, z])]))
}
