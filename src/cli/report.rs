//! Messages to the user, on standard error.

use crate::grammar::{Code, Diagnostic, Severity, Span};
use annotate_snippets::renderer::DecorStyle;
use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};

/// A named text, for messages that show its lines.
pub struct Source {
    pub name: String,
    pub text: String,
}

pub fn error(text: &str, hint: Option<&str>) {
    message(Level::ERROR, None, text, hint);
}

/// An error of a kind that `vox explain` tells more of, without a place in a text.
pub fn coded_error(code: Code, text: &str, hint: Option<&str>) {
    message(Level::ERROR, Some(code), text, hint);
}

pub fn warning(text: &str) {
    message(Level::WARNING, None, text, None);
}

/// A line on what was done.
pub fn note(text: &str) {
    anstream::eprintln!("{text}");
}

fn message(level: Level<'_>, code: Option<Code>, text: &str, hint: Option<&str>) {
    let title = level.primary_title(text);
    let mut group = Group::with_title(match code {
        Some(code) => title.id(code.id()),
        None => title,
    });
    if let Some(hint) = hint {
        group = group.element(Level::HELP.message(hint));
    }
    anstream::eprintln!("{}", renderer().render(&[group]));
}

/// A finding with the place in the text that it is about.
pub fn diagnostic(source: &Source, diagnostic: &Diagnostic) {
    anstream::eprintln!("{}\n", rendered(source, diagnostic));
}

/// The text of a finding, with colours.
fn rendered(source: &Source, diagnostic: &Diagnostic) -> String {
    let level = match diagnostic.severity() {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
    };
    let span = shown(&source.text, diagnostic.span);
    let place = AnnotationKind::Primary.span(span).label(diagnostic.label.as_str());
    let snippet = Snippet::source(source.text.as_str()).path(source.name.as_str()).annotation(place);
    let mut group =
        level.primary_title(diagnostic.message.as_str()).id(diagnostic.code.id()).element(snippet);
    if let Some(hint) = &diagnostic.hint {
        group = group.element(Level::HELP.message(hint.as_str()));
    }
    renderer().render(&[group])
}

/// The part of a place that fits under one line: a rule may span many.
fn shown(text: &str, span: Span) -> std::ops::Range<usize> {
    let start = span.start.min(text.len());
    let end = span.end.clamp(start, text.len());
    let line = text[start..end].find('\n').map_or(end, |length| start + length);
    start..line
}

fn renderer() -> Renderer {
    Renderer::styled().decor_style(DecorStyle::Ascii)
}

/// Line and column of a place, both from 1.
pub fn line_column(text: &str, span: Span) -> (usize, usize) {
    let before = &text[..span.start.min(text.len())];
    let line_start = before.rfind('\n').map_or(0, |at| at + 1);
    (before.matches('\n').count() + 1, before[line_start..].chars().count() + 1)
}
