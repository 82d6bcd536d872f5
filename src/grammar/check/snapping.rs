//! Snap planes: that what is marked is heeded, and what is heeded is marked.

use super::Checker;
use crate::grammar::ast::*;
use crate::grammar::names::closest;
use crate::grammar::{Code, Span};

/// What a grammar does with snap planes, each with its label and its place.
#[derive(Default)]
struct Planes<'g> {
    marked: Vec<(Option<&'g str>, Span)>,
    heeded: Vec<(Option<&'g str>, Span)>,
}

impl<'g> Planes<'g> {
    fn collect(&mut self, successor: &'g Successor) {
        match &successor.op {
            Op::Snap { label, .. } => {
                let label = label.as_ref();
                let span = label.map_or(successor.span, |label| label.span);
                self.marked.push((label.map(|label| label.name.as_str()), span));
            }
            Op::Split { snap: Some(snap), .. } | Op::Repeat { snap: Some(snap), .. } => {
                self.heeded.push((snap.label.as_deref(), successor.span));
            }
            _ => {}
        }
        for_each_child(&successor.op, &mut |child| self.collect(child));
    }
}

impl Checker<'_> {
    pub(super) fn snap_planes(&mut self) {
        let mut planes = Planes::default();
        self.grammar.rules.iter().for_each(|rule| planes.collect(&rule.successor));
        for (label, span) in &planes.heeded {
            let is_marked = planes.marked.iter().any(|(marked, _)| label.is_none() || marked == label);
            if !is_marked {
                self.unmarked(*label, *span, &planes);
            }
        }
        for (label, span) in &planes.marked {
            let is_heeded = planes.heeded.iter().any(|(heeded, _)| heeded.is_none() || heeded == label);
            if !is_heeded {
                self.unheeded(*label, *span);
            }
        }
    }

    fn unmarked(&mut self, label: Option<&str>, span: Span, planes: &Planes<'_>) {
        let message = match label {
            Some(label) => format!("nothing marks the snap planes `{label}`"),
            None => "nothing marks a snap plane".to_owned(),
        };
        let marked = planes.marked.iter().filter_map(|(marked, _)| *marked);
        let near = label.and_then(|label| closest(label, marked));
        let hint = near.map_or_else(
            || "mark them where they come from: `snap(y, label)` beside an operation".to_owned(),
            |near| format!("did you mean `snap({near})`?"),
        );
        self.tell(Code::SnapUnmarked, span, message, "splits as if it had no `snap`", hint);
    }

    fn unheeded(&mut self, label: Option<&str>, span: Span) {
        let (message, heed) = match label {
            Some(label) => (format!("nothing heeds the snap planes `{label}`"), format!("snap({label})")),
            None => ("nothing heeds these snap planes".to_owned(), "snap".to_owned()),
        };
        let hint = format!("let a split heed them: `split(x, {heed}){{ ... }}`");
        self.tell(Code::SnapUnheeded, span, message, "does nothing", hint);
    }
}
