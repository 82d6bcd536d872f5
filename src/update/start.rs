//! The sizes of the start scope.

use super::change::Change;
use super::demand::{Demands, Site};
use super::texts::{Edit, Program, Texts};
use super::layout::end_of_item;
use crate::grammar::Span;
use crate::grammar::ast::StartSize;
use crate::parse::{Laws, Parser};
use crate::score::Samples;
use crate::run::Library;
use crate::space::Cell;

/// The edits with which a run may start at a size, if the grammar says other sizes.
///
/// Where there is one line that says sizes it is widened, unless runs fail at sizes between then; else the size gets a
/// line of its own.
pub fn started(texts: &Texts, program: &Program, size: Cell, library: &Library) -> Option<(Texts, Vec<Change>)> {
    if Parser::new(&program.graph, Laws::AsWritten).starts(size) {
        return Some((texts.clone(), Vec::new()));
    }
    let sizes = &program.checked.grammar().sizes;
    let widened = match sizes.as_slice() {
        [only] => widened(program, only, size).map(|(edits, changes)| (texts.edited(&edits), changes)),
        _ => None,
    };
    let is_good = |texts: &Texts| {
        let failed = |program: &Program| Samples::draw(&program.graph, library, 0, SAMPLES).failed;
        texts.read().is_some_and(|after| failed(&after) <= failed(program))
    };
    match widened.filter(|(texts, _)| is_good(texts)) {
        Some(widened) => Some(widened),
        None => added(texts, program, size),
    }
}

/// So many runs are tried.
const SAMPLES: usize = 24;

fn widened(program: &Program, start: &StartSize, size: Cell) -> Option<(Vec<Edit>, Vec<Change>)> {
    let mut demands = Demands::new(program);
    for (length, wanted) in start.size.iter().zip(size.to_array()) {
        demands.ask(length, f64::from(wanted), "size", &Site::default())?;
    }
    demands.granted()
}

/// One more line behind the last that says sizes.
fn added(texts: &Texts, program: &Program, size: Cell) -> Option<(Texts, Vec<Change>)> {
    let last = program.checked.grammar().sizes.iter().max_by_key(|start| start.span.start)?;
    let [x, y, z] = size.to_array();
    let end = last.weight.as_ref().map_or(last.span.end, |weight| weight.span.end);
    let place = program.sources.place(Span::new(end, end));
    let at = end_of_item(place.text, place.span.end);
    let text = format!("\nsize({x}, {y}, {z})");
    let edit = Edit { file: place.name.to_owned(), span: Span::new(at, at), text };
    Some((texts.edited(&[edit]), vec![Change::Sized([x, y, z])]))
}
