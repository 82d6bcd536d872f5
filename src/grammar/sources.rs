use super::Span;

/// The texts of a grammar and of all that it imports, one behind the other: a [`Span`] is a place in one of them.
#[derive(Clone, Debug, Default)]
pub struct Sources {
    text: String,
    files: Vec<File>,
}

#[derive(Clone, Debug)]
struct File {
    name: String,
    span: Span,
}

/// A file, and a place in it.
#[derive(Clone, Copy, Debug)]
pub struct Place<'s> {
    pub name: &'s str,
    pub text: &'s str,
    pub span: Span,
}

impl Place<'_> {
    /// Line and column, both from 1.
    pub fn line_column(&self) -> (usize, usize) {
        let before = &self.text[..self.span.start];
        let line_start = before.rfind('\n').map_or(0, |at| at + 1);
        (before.matches('\n').count() + 1, before[line_start..].chars().count() + 1)
    }
}

impl Sources {
    /// A text that stands alone.
    pub fn of(name: impl Into<String>, text: &str) -> Sources {
        let mut sources = Sources::default();
        sources.add(name.into(), text);
        sources
    }

    /// Puts a text behind the others.
    pub(super) fn add(&mut self, name: String, text: &str) -> Span {
        let start = self.text.len();
        self.text += text;
        let span = Span::new(start, self.text.len());
        // The end of a text is not the start of the next.
        self.text.push('\n');
        self.files.push(File { name, span });
        span
    }

    /// All texts up to a place.
    pub(super) fn up_to(&self, end: usize) -> &str {
        &self.text[..end]
    }

    /// The name of the file that imports all others.
    pub fn root(&self) -> &str {
        self.files.first().map_or("", |file| &file.name)
    }

    /// The names of all files, that of the root first.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.files.iter().map(|file| file.name.as_str())
    }

    /// All files by name, with their texts.
    pub fn texts(&self) -> impl Iterator<Item = (&str, &str)> {
        self.files.iter().map(|file| (file.name.as_str(), &self.text[file.span.range()]))
    }

    /// The file that a span lies in, and where in it.
    pub fn place(&self, span: Span) -> Place<'_> {
        let after = self.files.partition_point(|file| file.span.start <= span.start);
        let Some(File { name, span: whole }) = self.files.get(after.saturating_sub(1)) else {
            return Place { name: "", text: "", span: Span::default() };
        };
        let local = |at: usize| at.clamp(whole.start, whole.end) - whole.start;
        let span = Span::new(local(span.start), local(span.end.max(span.start)));
        Place { name, text: &self.text[whole.range()], span }
    }
}
