//! The items of a file: directives, constants and rules.

use super::cursor::{Parse, Parser};
use crate::grammar::ast::*;
use crate::grammar::lex::{Kind, Place};
use crate::grammar::{Code, Diagnostic, Span};
use crate::space::Up;

impl Parser<'_> {
    pub(super) fn item(&mut self, grammar: &mut Grammar, comments: Vec<String>) -> Parse<()> {
        self.start_item();
        if self.at() > 0 && self.peek().place == Place::Inner && !self.is_followed_by_definition() {
            return Err(self.left_over());
        }
        let second = self.peek_after(1);
        if self.is_word("up") && second.kind == Kind::Ident {
            return self.up(grammar);
        }
        if self.is_word("data_version") && second.kind == Kind::Number {
            return self.data_version(grammar);
        }
        if self.is_word("size") && matches!(second.kind, Kind::Symbol("(")) {
            grammar.sizes.push(self.start_size(comments)?);
            return Ok(());
        }
        if self.is_word("priority") && second.kind == Kind::Number {
            return self.set_priority();
        }
        if self.is_word("import") && second.kind == Kind::Text {
            grammar.imports.push(self.import(comments)?);
            return Ok(());
        }
        if second.kind == Kind::Ident && second.place == Place::Inner {
            self.refuse_unfinished()?;
        }
        if self.is_word("style") && second.kind == Kind::Ident {
            grammar.styles.push(self.style(comments)?);
            return Ok(());
        }
        if self.is_word("attr") && second.kind == Kind::Ident {
            self.next();
            let name = self.ident("the name of the attribute")?;
            self.expect("=", "and what it is unless a run sets it")?;
            let value = self.argument()?;
            let attribute = Some(self.attribute()?);
            grammar.constants.push(Constant { comments, behind: None, name, value, attribute });
            return Ok(());
        }
        let name = self.ident("a rule or a constant")?;
        if self.accept("=").is_some() {
            let value = self.argument()?;
            grammar.constants.push(Constant { comments, behind: None, name, value, attribute: None });
        } else {
            grammar.rules.push(self.rule(name, comments)?);
        }
        Ok(())
    }

    /// Refuses a directive whose second word is of the wrong kind: nothing else begins with two words.
    fn refuse_unfinished(&mut self) -> Parse<()> {
        let (code, expected, hint) = match self.word(self.peek()) {
            "import" => {
                (Code::Unexpected, "the name of a file in quotes", "as in `import \"walls.grammar\"`")
            }
            "priority" => (Code::BadPriority, "a priority", "it is a whole number from 1: `priority 2`"),
            _ => return Ok(()),
        };
        self.next();
        Err(self.unexpected_with(code, &format!("expected {expected}"), hint))
    }

    /// `priority 2`: that of the rules which follow.
    fn set_priority(&mut self) -> Parse<()> {
        self.next();
        let number = self.next();
        match self.word(number).parse().ok().filter(|priority| *priority > 0) {
            Some(priority) => self.priority = priority,
            None => {
                let error = Diagnostic::new(Code::BadPriority, number.span, "this is no priority");
                return Err(Box::new(error.hint("it is a whole number from 1: `priority 2`")));
            }
        }
        Ok(())
    }

    fn import(&mut self, comments: Vec<String>) -> Parse<Import> {
        let start = self.next().span;
        let file = self.next();
        let prefix = match self.is_word("as") {
            true => {
                self.next();
                let prefix = "what its names begin with, after `as`";
                if self.peek().place != Place::Inner {
                    return Err(self.unexpected(&format!("expected {prefix}")));
                }
                Some(self.ident(prefix)?)
            }
            false => None,
        };
        let span = start.to(Span::new(0, self.previous_end()));
        Ok(Import {
            comments,
            behind: None,
            file: self.word(file).trim_matches('"').to_owned(),
            prefix,
            span,
        })
    }

    fn style(&mut self, comments: Vec<String>) -> Parse<Style> {
        self.next();
        let name = self.ident("the name of the style")?;
        self.expect("{", "before its values, as in `style spruce { wall = spruce_planks }`")?;
        let mut values = Vec::new();
        while self.accept("}").is_none() {
            let constant = self.dotted("the name of a constant, or `}`")?;
            if self.accept("=").is_none() {
                let expected = "expected `=` between a constant and its value";
                let hint = "a style reads `style spruce { wall = spruce_planks, post = spruce_log }`";
                return Err(self.unexpected_with(Code::Unexpected, expected, hint));
            }
            values.push((constant, self.argument()?));
            let _ = self.accept(",");
        }
        Ok(Style { comments, behind: None, name, values })
    }

    /// What may follow the value of an attribute, each once at the most.
    fn attribute(&mut self) -> Parse<Attribute> {
        let mut attribute = Attribute::default();
        while self.peek().kind == Kind::Ident && self.peek().place == Place::Inner {
            let word = self.ident("`range`, `group` or `about`")?;
            self.expect("(", &format!("after `{}`", word.name))?;
            match word.name.as_str() {
                "range" => {
                    let low = self.expr()?;
                    self.expect(",", "between the least and the most")?;
                    attribute.range = Some([low, self.expr()?]);
                }
                "group" => attribute.group = Some(self.text("the name of the group in quotes")?),
                "about" => attribute.about = Some(self.text("a description in quotes")?),
                _ => {
                    let message = format!("an attribute has no `{}`", word.name);
                    let error = Diagnostic::new(Code::UnknownNote, word.span, message);
                    return Err(Box::new(error.hint(
                        "it may have range(1, 9), group(\"Massing\") and about(\"the number of storeys\")",
                    )));
                }
            }
            self.expect(")", &format!("after what `{}` says", word.name))?;
        }
        Ok(attribute)
    }

    fn text(&mut self, what: &str) -> Parse<String> {
        let token = self.peek();
        if token.kind != Kind::Text {
            return Err(self.unexpected(&format!("expected {what}")));
        }
        self.next();
        Ok(self.word(token).trim_matches('"').to_owned())
    }

    pub(super) fn up(&mut self, grammar: &mut Grammar) -> Parse<()> {
        self.next();
        let axis = self.ident("an axis after `up`")?;
        grammar.up = match axis.name.as_str() {
            "y" => Up::Y,
            "z" => Up::Z,
            _ => {
                let error = Diagnostic::new(Code::BadUp, axis.span, "only y or z can be up");
                return Err(Box::new(error.hint("write `up z` or `up y`")));
            }
        };
        Ok(())
    }

    pub(super) fn data_version(&mut self, grammar: &mut Grammar) -> Parse<()> {
        self.next();
        let number = self.next();
        grammar.data_version = self.word(number).parse().ok();
        match grammar.data_version {
            Some(_) => Ok(()),
            None => {
                let message = "this is no data version of the game";
                let error = Diagnostic::new(Code::BadDataVersion, number.span, message);
                Err(Box::new(error.hint("it is a whole number, as in `data_version 3465` for 1.20.1")))
            }
        }
    }

    pub(super) fn start_size(&mut self, comments: Vec<String>) -> Parse<StartSize> {
        let keyword = self.next();
        self.expect("(", "after `size`")?;
        let size = self.three(|parser| parser.expr())?;
        let end = self.expect(")", "after the three lengths")?;
        let weight = self.weight()?;
        Ok(StartSize { comments, behind: None, size, weight, span: keyword.span.to(end.span) })
    }

    pub(super) fn rule(&mut self, label: Ident, comments: Vec<String>) -> Parse<Rule> {
        let params = if self.accept("(").is_some() {
            self.list(")", |parser| parser.ident("the name of a parameter"))?
        } else {
            Vec::new()
        };
        let condition = if self.accept(":").is_some() { Some(self.expr()?) } else { None };
        if self.peek().kind != Kind::Arrow {
            let hint = match self.is_symbol("-") {
                true => "the arrow has two dashes: `-->`",
                false => "a rule reads `label --> operation`, a constant `name = value`",
            };
            return Err(self.unexpected_with(
                Code::NoArrow,
                &format!("expected `-->` after `{}`", label.name),
                hint,
            ));
        }
        self.next();
        let successor = self.successor()?;
        let weight = self.weight()?;
        Ok(Rule {
            comments,
            behind: None,
            label,
            params,
            condition,
            successor,
            weight,
            priority: self.priority,
        })
    }

    pub(super) fn weight(&mut self) -> Parse<Option<Expr>> {
        if self.accept(":").is_some() { self.expr().map(Some) } else { Ok(None) }
    }
}
