//! Messages to the user, on standard error.

use crate::grammar::{Code, Diagnostic, Severity, Sources, Span};
use annotate_snippets::renderer::DecorStyle;
use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};

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
pub fn diagnostic(sources: &Sources, diagnostic: &Diagnostic) {
    anstream::eprintln!("{}\n", rendered(sources, diagnostic));
}

/// The text of a finding, with colours.
fn rendered(sources: &Sources, diagnostic: &Diagnostic) -> String {
    let level = match diagnostic.severity() {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
    };
    let place = sources.place(diagnostic.span);
    let mark = AnnotationKind::Primary.span(shown(place.text, place.span)).label(diagnostic.label.as_str());
    let snippet = Snippet::source(place.text).path(place.name).annotation(mark);
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
