//! Component splits, setbacks and footprints: operations that carve named parts out of a scope.

use super::cursor::{Parse, Parser};
use crate::grammar::ast::*;
use crate::grammar::lex::Kind;
use crate::grammar::names::closest;
use crate::grammar::{Code, Diagnostic, Span};

impl Parser<'_> {
    /// `comp`, up to its kind; the rest is that of every carving.
    pub(super) fn component(&mut self) -> Parse<Op> {
        self.expect("(", "after `comp`, as in `comp(f){ side : wall | top : roof }`")?;
        let kind = self.ident("`f` for faces, `e` for edges or `v` for vertices")?;
        let how = match kind.name.as_str() {
            "f" => Carving::Faces,
            "e" => Carving::Edges,
            "v" => Carving::Vertices,
            _ => {
                let message = format!("`{}` is no kind of component", kind.name);
                let error = Diagnostic::new(Code::UnknownComponent, kind.span, message);
                return Err(Box::new(
                    error.hint("a scope has faces, `comp(f)`, edges, `comp(e)`, and vertices, `comp(v)`"),
                ));
            }
        };
        let args = match self.accept(",") {
            Some(_) => self.list(")", |parser| parser.expr())?,
            None => {
                self.expect(")", "after the kind of component")?;
                Vec::new()
            }
        };
        self.carved(how, args, kind.span)
    }

    pub(super) fn carve(&mut self, how: Carving) -> Parse<Op> {
        let word = Span::new(self.previous_end() + 1 - how.head().len(), self.previous_end());
        self.expect(
            "(",
            &format!("after `{}`: it takes {}", how.head().trim_end_matches('('), how.takes().1),
        )?;
        let args = self.list(")", |parser| parser.expr())?;
        self.carved(how, args, word)
    }

    fn carved(&mut self, how: Carving, args: Vec<Expr>, word: Span) -> Parse<Op> {
        let (counts, takes) = how.takes();
        if !counts.contains(&args.len()) {
            let plural = if args.len() == 1 { "" } else { "s" };
            let message = format!("`{}` cannot take {} argument{plural}", word_of(how), args.len());
            let error = Diagnostic::new(Code::CarvingArguments, word, message);
            return Err(Box::new(error.hint(format!("it takes {takes}"))));
        }
        self.expect("{", "before the parts")?;
        let mut parts = Vec::new();
        loop {
            let selector = self.selector(how)?;
            self.expect(":", "between the name of a part and its operation")?;
            parts.push((selector, self.successor()?));
            if self.accept("|").is_none() {
                self.expect("}", "or `|` after a part")?;
                return Ok(Op::Carve { how, args, parts });
            }
        }
    }

    fn selector(&mut self, how: Carving) -> Parse<Selector> {
        let start = self.peek().span;
        let selector = match self.peek().kind {
            Kind::Number => Selector::Index(self.index()?),
            _ => self.named_selector(how)?,
        };
        let span = start.to(Span::new(0, self.previous_end()));
        match selector.suits(how) {
            true => Ok(selector),
            false => {
                let message = format!("`{}` has no part `{}`", word_of(how), &self.text[span.range()]);
                let error = Diagnostic::new(Code::UnknownPart, span, message);
                Err(Box::new(error.label("here").hint(parts_of(how))))
            }
        }
    }

    fn index(&mut self) -> Parse<u32> {
        let token = self.next();
        self.word(token).parse().map_err(|_| {
            let error = Diagnostic::new(Code::UnknownPart, token.span, "this is no number of a part");
            Box::new(error.hint("parts are numbered from 0"))
        })
    }

    fn named_selector(&mut self, how: Carving) -> Parse<Selector> {
        let first = self.ident("the name of a part")?;
        if let Some((_, selector)) = Selector::NAMES.iter().find(|(name, _)| *name == first.name) {
            return Ok(selector.clone());
        }
        let mut faces = vec![face(&first, how)?];
        while self.accept(".").is_some() {
            let next = self.ident("a face")?;
            faces.push(face(&next, how)?);
        }
        Ok(Selector::On(faces))
    }
}

fn face(ident: &Ident, how: Carving) -> Parse<Face> {
    let face = Face::NAMES.iter().find(|(name, _)| *name == ident.name);
    face.map(|(_, face)| *face).ok_or_else(|| {
        let near = closest(&ident.name, Face::NAMES.iter().map(|(name, _)| *name));
        let hint = near.map_or_else(|| parts_of(how), |near| format!("did you mean `{near}`?"));
        let message = format!("there is no part `{}`", ident.name);
        Box::new(Diagnostic::new(Code::UnknownPart, ident.span, message).hint(hint))
    })
}

/// What messages call an operation: `comp(f)`, `offset`.
fn word_of(how: Carving) -> String {
    match how.is_component() {
        true => format!("{})", how.head()),
        false => how.head().trim_end_matches('(').to_owned(),
    }
}

/// What parts an operation carves, in words.
fn parts_of(how: Carving) -> String {
    let faces: Vec<&str> = Face::NAMES.iter().map(|(name, _)| *name).collect();
    let faces = faces.join(", ");
    match how {
        Carving::Faces => format!("the faces are {faces}; what is left is `inside`"),
        Carving::Edges => format!("edges lie on one face or two, as `top.front`; the faces are {faces}"),
        Carving::Vertices => format!("vertices lie on up to three faces, as `top.front.left`: {faces}"),
        Carving::Setback => {
            "the strips are front, back, left, right, side, north, east, south and west; what is left is `inside`".to_owned()
        },
        Carving::Offset => "its parts are `border` and `inside`".to_owned(),
        _ => "its parts are `shape` and `remainder`".to_owned(),
    }
}
