//! The texts of a grammar and all that it imports, as they are edited.

use crate::grammar::ast::{Rule, Successor, for_each_child};
use crate::grammar::{Checked, Sources, Span, load};
use crate::graph::{OpGraph, lower};
use std::collections::BTreeMap;

/// The texts by the names of their files.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Texts {
    root: String,
    files: BTreeMap<String, String>,
}

/// A part of a file that another text takes the place of.
#[derive(Clone, Debug)]
pub struct Edit {
    pub file: String,
    /// In the file.
    pub span: Span,
    pub text: String,
}

/// What texts say.
#[derive(Debug)]
pub struct Program {
    pub sources: Sources,
    pub checked: Checked,
    pub graph: OpGraph,
}

/// Operations by their places in the text, with their rules.
pub struct Operations<'p>(BTreeMap<(usize, usize), (&'p Rule, &'p Successor)>);

impl Texts {
    pub fn of(sources: &Sources) -> Texts {
        let files = sources.texts().map(|(name, text)| (name.to_owned(), text.to_owned()));
        Texts { root: sources.root().to_owned(), files: files.collect() }
    }

    pub fn root(&self) -> &str {
        &self.root
    }

    /// The files whose text is another one than in `before`.
    pub fn changed<'t>(&'t self, before: &'t Texts) -> impl Iterator<Item = (&'t str, &'t str)> {
        let files = self.files.iter().filter(|(name, text)| before.files.get(*name) != Some(*text));
        files.map(|(name, text)| (name.as_str(), text.as_str()))
    }

    /// The text of a file.
    pub fn get(&self, file: &str) -> &str {
        self.files.get(file).map_or("", String::as_str)
    }

    /// What the texts say; `None` where that is no grammar.
    pub fn read(&self) -> Option<Program> {
        let mut fetch =
            |name: &str| self.files.get(name).cloned().ok_or_else(|| "it was not read".to_owned());
        let loaded = load(&self.root, self.get(&self.root), &mut fetch);
        let checked = loaded.checked.ok()?;
        let graph = lower(&checked, None).ok()?;
        Some(Program { sources: loaded.sources, checked, graph })
    }

    /// With these edits, of which no two overlap. Of those in one place the first stands first.
    pub fn edited(&self, edits: &[Edit]) -> Texts {
        let mut texts = self.clone();
        let mut order: Vec<&Edit> = edits.iter().collect();
        order.sort_by_key(|edit| edit.span.start);
        for edit in order.into_iter().rev() {
            if let Some(text) = texts.files.get_mut(&edit.file) {
                // Lines end as they do in the rest of the file.
                let new =
                    if text.contains("\r\n") { edit.text.replace('\n', "\r\n") } else { edit.text.clone() };
                text.replace_range(edit.span.range(), &new);
            }
        }
        texts
    }

    /// With every file laid out that was laid out before.
    pub fn laid_out_as(self, before: &Texts) -> Texts {
        let files = self.files.into_iter().map(|(name, text)| {
            let was = before.get(&name);
            let is_laid_out = || crate::grammar::format(was).is_ok_and(|laid_out| laid_out == was);
            match text != was && is_laid_out() {
                true => (name, crate::grammar::format(&text).unwrap_or(text)),
                false => (name, text),
            }
        });
        Texts { root: self.root, files: files.collect() }
    }
}

impl Program {
    /// The edit of a place in any of the files.
    pub fn edit(&self, span: Span, text: String) -> Edit {
        let place = self.sources.place(span);
        Edit { file: place.name.to_owned(), span: place.span, text }
    }

    /// The words of a place.
    pub fn words(&self, span: Span) -> &str {
        let place = self.sources.place(span);
        &place.text[place.span.range()]
    }

    pub fn operations(&self) -> Operations<'_> {
        let mut all = BTreeMap::new();
        for rule in &self.checked.grammar().rules {
            let mut open = vec![&rule.successor];
            while let Some(successor) = open.pop() {
                all.insert((successor.span.start, successor.span.end), (rule, successor));
                for_each_child(&successor.op, &mut |child| open.push(child));
            }
        }
        Operations(all)
    }
}

impl<'p> Operations<'p> {
    pub fn at(&self, span: Span) -> Option<(&'p Rule, &'p Successor)> {
        self.0.get(&(span.start, span.end)).copied()
    }
}
