//! The layout of grammars that people write: that of the printer, in the order of the file, with its blank lines.

use super::ast::*;
use super::print::{comment_lines, directives};
use super::{Diagnostic, parse::parse_items_at};

/// A grammar in the printer's layout. Its items keep their order, and the lines between them that are blank; its comments
/// stay beside what they stand beside. Imported files are not needed.
pub fn format(text: &str) -> Result<String, Vec<Diagnostic>> {
    let parsed = parse_items_at(text, 0);
    if !parsed.errors.is_empty() {
        return Err(parsed.errors);
    }
    let grammar = parsed.grammar;
    let mut items = items(&grammar);
    items.sort_by_key(|item| item.start);
    let mut out = Out { text: comment_lines(&grammar.preamble), priority: Rule::FIRST };
    out.block(&directives(&grammar), true);
    for item in items {
        out.item(&item, has_blank_above(text, item.start));
    }
    out.block(&comment_lines(&grammar.epilogue), has_blank_above(text, text.trim_end().len()));
    Ok(out.text)
}

/// Something that stands on lines of its own.
struct Printed {
    start: usize,
    text: String,
    priority: Option<u32>,
}

fn items(grammar: &Grammar) -> Vec<Printed> {
    let item = |start: usize, text: String| Printed { start, text: text + "\n", priority: None };
    let mut items = Vec::new();
    items.extend(grammar.imports.iter().map(|import| item(import.span.start, import.to_string())));
    items.extend(grammar.sizes.iter().map(|size| item(size.span.start, size.to_string())));
    items.extend(grammar.constants.iter().map(|known| item(known.name.span.start, known.to_string())));
    items.extend(grammar.styles.iter().map(|style| item(style.name.span.start, style.to_string())));
    items.extend(grammar.rules.iter().map(|rule| Printed {
        priority: Some(rule.priority),
        ..item(rule.label.span.start, rule.to_string())
    }));
    items
}

struct Out {
    text: String,
    priority: u32,
}

impl Out {
    fn block(&mut self, block: &str, has_blank: bool) {
        if has_blank && !self.text.is_empty() && !block.is_empty() {
            self.text.push('\n');
        }
        self.text += block;
    }

    fn item(&mut self, item: &Printed, has_blank: bool) {
        if let Some(priority) = item.priority.filter(|priority| *priority != self.priority) {
            self.priority = priority;
            self.block(&format!("priority {priority}\n"), true);
        }
        self.block(&item.text, has_blank);
    }
}

/// Whether a blank line stands above the line of a place, or among the comments above it.
fn has_blank_above(text: &str, place: usize) -> bool {
    let line_start = text[..place].rfind('\n').map_or(0, |at| at + 1);
    let above = text[..line_start].lines().rev().map(str::trim);
    let mut above =
        above.take_while(|line| line.is_empty() || line.starts_with(['#']) || line.starts_with("//"));
    above.any(str::is_empty)
}
