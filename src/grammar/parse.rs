//! The parser: recursive descent over tokens. An error ends its item; parsing goes on at the next one,
//! so that one run tells of every item that is wrong.

use super::ast::*;
use super::lex::{Comment, Kind, Place, Token, lex};
use super::names::closest;
use super::{Diagnostic, Span};
use crate::space::{Axis, Up};
use std::collections::BTreeSet;
use std::str::FromStr;

/// Parses a grammar file. Every error of the file is reported.
pub fn parse(text: &str) -> Result<Grammar, Vec<Diagnostic>> {
    let Parsed { grammar, errors, .. } = parse_items(text);
    if errors.is_empty() { Ok(grammar) } else { Err(errors) }
}

/// What could be read of a file.
pub struct Parsed {
    /// The items without errors.
    pub grammar: Grammar,
    /// In the order of their places.
    pub errors: Vec<Diagnostic>,
    /// The first word of each item with an error: the label or constant that it would define.
    pub broken: BTreeSet<String>,
}

/// Parses all items of a file that can be parsed.
pub fn parse_items(text: &str) -> Parsed {
    let lexed = lex(text);
    let mut parser = Parser { text, tokens: &lexed.tokens, at: 0, depth: 0, operators: 0 };
    let mut grammar = Grammar::default();
    let mut errors = lexed.errors;
    let mut broken = BTreeSet::new();
    let mut comments = Comments { text, rest: &lexed.comments };
    grammar.preamble = comments.preamble();
    while parser.peek().kind != Kind::End {
        let start = parser.at;
        let above = comments.before(parser.peek().span.start);
        if let Err(error) = parser.item(&mut grammar, above) {
            broken.insert(parser.word(parser.tokens[start]).to_owned());
            // One error a place: what the lexer refused is not refused again for what is missing there.
            if !errors.iter().any(|known| known.span.start == error.span.start) {
                errors.push(*error);
            }
            parser.recover(start);
        }
        comments.skip_inside(parser.previous_end());
    }
    if grammar.rules.is_empty() && errors.is_empty() {
        let message = "a grammar needs a rule";
        errors.push(Diagnostic::error(Span::new(0, 0), message).hint("for example `house --> I(stone)`"));
    }
    errors.sort_by_key(|error| error.span.start);
    Parsed { grammar, errors, broken }
}

/// For a word with braces behind it that is none of the operations.
fn no_operation(word: &Ident) -> Box<Diagnostic> {
    const OPERATIONS: [&str; 7] = ["split", "repeat", "repeatN", "T", "S", "R", "comp"];
    let near = closest(&word.name, OPERATIONS.into_iter());
    let hint = near.map_or(format!("the operations with braces are {}", OPERATIONS.join(", ")), |near| {
        format!("did you mean `{near}`?")
    });
    Box::new(Diagnostic::error(word.span, format!("there is no operation `{}`", word.name)).hint(hint))
}

impl FromStr for Grammar {
    type Err = Vec<Diagnostic>;

    fn from_str(text: &str) -> Result<Grammar, Vec<Diagnostic>> {
        parse(text)
    }
}

/// Deals out comments to the items below them.
struct Comments<'t> {
    text: &'t str,
    rest: &'t [Comment],
}

impl Comments<'_> {
    /// The comments at the head of the file that a blank line separates from the first item.
    fn preamble(&mut self) -> Vec<String> {
        let mut preamble = Vec::new();
        let mut kept = 0;
        let mut end = 0;
        for comment in self.rest {
            let gap = &self.text[end..comment.span.start];
            if !gap.trim().is_empty() {
                break;
            }
            preamble.push(comment.text.clone());
            end = comment.span.end;
            let below = &self.text[end..];
            let blank = below.find(|c: char| !c.is_whitespace()).unwrap_or(below.len());
            if below[..blank].matches('\n').count() >= 2 {
                kept = preamble.len();
                break;
            }
        }
        preamble.truncate(kept);
        self.rest = &self.rest[kept..];
        preamble
    }

    fn before(&mut self, place: usize) -> Vec<String> {
        let count = self.rest.iter().take_while(|comment| comment.span.start < place).count();
        let (taken, rest) = self.rest.split_at(count);
        self.rest = rest;
        taken.iter().map(|comment| comment.text.clone()).collect()
    }

    /// Drops the comments inside an item and behind it on its last line.
    fn skip_inside(&mut self, end: usize) {
        let line_end = self.text[end..].find('\n').map_or(self.text.len(), |length| end + length);
        let _ = self.before(line_end);
    }
}

/// Operations and brackets nested deeper than this are refused, so that no text overflows the stack.
const MAX_DEPTH: usize = 200;

/// Expressions with more operators than this are refused: each may lie below the one before it in the tree,
/// and the sums in nested brackets add up.
const MAX_OPERATORS: usize = 200;

struct Parser<'t> {
    text: &'t str,
    tokens: &'t [Token],
    at: usize,
    depth: usize,
    /// Operators between two operands in the expression so far.
    operators: usize,
}

type Parse<T> = Result<T, Box<Diagnostic>>;

impl<'t> Parser<'t> {
    // Tokens

    fn peek(&self) -> Token {
        self.tokens[self.at]
    }

    fn peek_after(&self, count: usize) -> Token {
        self.tokens[(self.at + count).min(self.tokens.len() - 1)]
    }

    fn word(&self, token: Token) -> &'t str {
        &self.text[token.span.range()]
    }

    fn next(&mut self) -> Token {
        let token = self.peek();
        self.at = (self.at + 1).min(self.tokens.len() - 1);
        token
    }

    fn previous_end(&self) -> usize {
        self.tokens[self.at.saturating_sub(1)].span.end
    }

    fn is_symbol(&self, symbol: &str) -> bool {
        matches!(self.peek().kind, Kind::Symbol(found) if found == symbol)
    }

    fn is_word(&self, word: &str) -> bool {
        self.peek().kind == Kind::Ident && self.word(self.peek()) == word
    }

    fn accept(&mut self, symbol: &str) -> Option<Token> {
        self.is_symbol(symbol).then(|| self.next())
    }

    fn expect(&mut self, symbol: &str, why: &str) -> Parse<Token> {
        match self.accept(symbol) {
            Some(token) => Ok(token),
            None => Err(self.unexpected(&format!("expected `{symbol}` {why}"))),
        }
    }

    fn ident(&mut self, what: &str) -> Parse<Ident> {
        let token = self.peek();
        if token.kind != Kind::Ident {
            return Err(self.unexpected(&format!("expected {what}")));
        }
        self.next();
        Ok(Ident { name: self.word(token).to_owned(), span: token.span })
    }

    /// What is missing at the end of a line is told there, not at the first word of the next.
    fn unexpected(&self, expected: &str) -> Box<Diagnostic> {
        let token = self.peek();
        let (span, found) = match (token.kind, token.place) {
            (Kind::End, _) => (self.after_previous(), "the end of the file".to_owned()),
            (_, Place::Inner) => (token.span, format!("`{}`", self.word(token))),
            _ => (self.after_previous(), format!("`{}` on the next line", self.word(token))),
        };
        Box::new(Diagnostic::error(span, format!("{expected}, found {found}")).label("here"))
    }

    /// As [`Parser::unexpected`], with what to write instead.
    fn unexpected_with(&self, expected: &str, hint: &str) -> Box<Diagnostic> {
        Box::new(self.unexpected(expected).hint(hint))
    }

    /// Refuses what would overflow the stack.
    fn too_much(&self, message: &str) -> Box<Diagnostic> {
        let error = Diagnostic::error(self.peek().span, message).label("from here on");
        Box::new(error.hint("give the inner parts rules or constants of their own"))
    }

    fn after_previous(&self) -> Span {
        match self.at {
            0 => self.peek().span,
            _ => Span::new(self.previous_end(), self.previous_end()),
        }
    }

    /// Goes on to the next token that can start an item.
    fn recover(&mut self, start: usize) {
        if self.at == start {
            self.next();
        }
        while self.peek().kind != Kind::End && !self.starts_item() {
            self.next();
        }
    }

    fn is_followed_by_definition(&self) -> bool {
        matches!(self.peek_after(1).kind, Kind::Arrow | Kind::Symbol("="))
    }

    /// For what stands behind an item on its line.
    fn left_over(&self) -> Box<Diagnostic> {
        let hint = match self.is_word("if") || self.is_word("when") {
            true => "a condition stands before the arrow: `label : condition --> operation`",
            false => "a rule ends with its line, unless one of its brackets is open",
        };
        self.unexpected_with("expected the next rule on a line of its own", hint)
    }

    fn starts_item(&self) -> bool {
        let defines = self.is_followed_by_definition();
        match self.peek().place {
            _ if self.peek().kind != Kind::Ident => false,
            Place::FirstAtMargin => true,
            Place::FirstIndented => defines,
            Place::Inner => false,
        }
    }

    // Items

    fn item(&mut self, grammar: &mut Grammar, comments: Vec<String>) -> Parse<()> {
        self.depth = 0;
        if self.at > 0 && self.peek().place == Place::Inner && !self.is_followed_by_definition() {
            return Err(self.left_over());
        }
        let second = self.peek_after(1);
        if self.is_word("up") && second.kind == Kind::Ident {
            return self.up(grammar);
        }
        if self.is_word("size") && matches!(second.kind, Kind::Symbol("(")) {
            grammar.sizes.push(self.start_size(comments)?);
            return Ok(());
        }
        let name = self.ident("a rule or a constant")?;
        if self.accept("=").is_some() {
            let value = self.argument()?;
            grammar.constants.push(Constant { comments, name, value });
        } else {
            grammar.rules.push(self.rule(name, comments)?);
        }
        Ok(())
    }

    fn up(&mut self, grammar: &mut Grammar) -> Parse<()> {
        self.next();
        let axis = self.ident("an axis after `up`")?;
        grammar.up = match axis.name.as_str() {
            "y" => Up::Y,
            "z" => Up::Z,
            _ => {
                let error = Diagnostic::error(axis.span, "only y or z can be up");
                return Err(Box::new(error.hint("write `up z` or `up y`")));
            }
        };
        Ok(())
    }

    fn start_size(&mut self, comments: Vec<String>) -> Parse<StartSize> {
        let keyword = self.next();
        self.expect("(", "after `size`")?;
        let size = self.three(|parser| parser.expr())?;
        let end = self.expect(")", "after the three lengths")?;
        let weight = self.weight()?;
        Ok(StartSize { comments, size, weight, span: keyword.span.to(end.span) })
    }

    fn rule(&mut self, label: Ident, comments: Vec<String>) -> Parse<Rule> {
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
            return Err(self.unexpected_with(&format!("expected `-->` after `{}`", label.name), hint));
        }
        self.next();
        let successor = self.successor()?;
        let weight = self.weight()?;
        Ok(Rule { comments, label, params, condition, successor, weight })
    }

    fn weight(&mut self) -> Parse<Option<Expr>> {
        if self.accept(":").is_some() { self.expr().map(Some) } else { Ok(None) }
    }

    // Operations

    fn successor(&mut self) -> Parse<Successor> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return Err(self.too_much("operations are nested too deeply"));
        }
        let start = self.peek().span;
        let op = self.op()?;
        self.depth -= 1;
        Ok(Successor { op, span: start.to(Span::new(0, self.previous_end())) })
    }

    fn op(&mut self) -> Parse<Op> {
        if self.starts_item() && self.is_followed_by_definition() {
            return Err(self.unexpected("expected an operation or a label"));
        }
        let label = self.ident("an operation or a label")?;
        match label.name.as_str() {
            "nil" => Ok(Op::Nil),
            "I" => self.primitive(),
            "split" => self.split(),
            "repeat" => self.repeat(),
            "repeatN" => self.repeat_n(),
            "T" => {
                let delta = self.sizes()?;
                Ok(Op::Translate { delta, body: self.body()? })
            }
            "S" => {
                let size = self.sizes()?;
                Ok(Op::Resize { size, body: self.body()? })
            }
            "R" => self.rotate(),
            "comp" => self.comp(),
            _ => {
                let args = if self.accept("(").is_some() {
                    self.list(")", |parser| parser.argument())?
                } else {
                    Vec::new()
                };
                match self.is_symbol("{") {
                    true => Err(no_operation(&label)),
                    false => Ok(Op::Call { label, args }),
                }
            }
        }
    }

    fn primitive(&mut self) -> Parse<Op> {
        self.expect("(", "after `I`: it names a primitive, as in `I(stone)`")?;
        let name = self.argument()?;
        let material = if self.accept(",").is_some() { Some(self.argument()?) } else { None };
        self.expect(")", "after the primitive")?;
        Ok(Op::Primitive { name, material })
    }

    fn split(&mut self) -> Parse<Op> {
        self.expect("(", "after `split`: it names an axis, as in `split(x){ ~1 : a | ~1 : b }`")?;
        let axis = self.expr()?;
        self.expect(")", "after the axis")?;
        self.expect("{", "before the parts")?;
        Ok(Op::Split { axis, items: self.items()? })
    }

    /// The items up to the closing brace.
    fn items(&mut self) -> Parse<Vec<Item>> {
        let mut items = Vec::new();
        loop {
            items.push(self.part_or_group()?);
            if self.accept("|").is_none() {
                self.expect("}", "or `|` after a part")?;
                return Ok(items);
            }
        }
    }

    fn part_or_group(&mut self) -> Parse<Item> {
        if let Some(open) = self.accept("{") {
            let items = self.items()?;
            let star = self.expect("*", "after a group: it is repeated as often as it fits")?;
            return Ok(Item::Group { items, span: open.span.to(star.span) });
        }
        const HINT: &str = "a part reads `size : operation`, as in `~1 : wall`";
        if self.is_symbol("}") || self.is_symbol("|") {
            return Err(self.unexpected_with("expected a part", HINT));
        }
        let size = self.size()?;
        if !self.is_symbol(":") {
            return Err(
                self.unexpected_with("expected `:` between the size of a part and its operation", HINT)
            );
        }
        self.next();
        Ok(Item::Part { size, body: self.successor()? })
    }

    fn repeat(&mut self) -> Parse<Op> {
        self.expect("(", "after `repeat`: it names an axis and a size, as in `repeat(x, 2){ window }`")?;
        let axis = self.expr()?;
        let size = if self.accept(",").is_some() { Some(self.expr()?) } else { None };
        self.expect(")", "after the axis and the size")?;
        self.expect("{", "before the operation to repeat")?;
        let size = match size {
            Some(size) => size,
            None => {
                let size = self.expr()?;
                self.expect(":", "after the size in `repeat(axis){ size : operation }`")?;
                size
            }
        };
        let body = Box::new(self.successor()?);
        self.expect("}", "after the operation to repeat")?;
        Ok(Op::Repeat { axis, size, body })
    }

    fn repeat_n(&mut self) -> Parse<Op> {
        self.expect("(", "after `repeatN`: it names an axis and a count, as in `repeatN(x, 3){ window }`")?;
        let axis = self.expr()?;
        self.expect(",", "between the axis and the count")?;
        let count = self.expr()?;
        self.expect(")", "after the count")?;
        Ok(Op::RepeatN { axis, count, body: self.body()? })
    }

    fn rotate(&mut self) -> Parse<Op> {
        self.expect("(", "after `R`: it names an axis and an angle, as in `R(y, pi/2){ roof }`")?;
        let axis = self.expr()?;
        self.expect(",", "between the axis and the angle")?;
        let angle = self.expr()?;
        self.expect(")", "after the angle")?;
        Ok(Op::Rotate { axis, angle, body: self.body()? })
    }

    fn comp(&mut self) -> Parse<Op> {
        self.expect("(", "after `comp`, as in `comp(f){ side : wall | top : roof }`")?;
        let kind = self.ident("`f`, for faces")?;
        if kind.name != "f" {
            let error = Diagnostic::error(kind.span, format!("`{}` is no kind of component", kind.name));
            return Err(Box::new(error.hint("write `comp(f)`: a scope is taken apart into its faces")));
        }
        self.expect(")", "after `f`")?;
        self.expect("{", "before the faces")?;
        let mut parts = Vec::new();
        loop {
            let face = self.face()?;
            self.expect(":", "between a face and its operation")?;
            parts.push((face, self.successor()?));
            if self.accept("|").is_none() {
                self.expect("}", "or `|` after a face")?;
                return Ok(Op::Comp { parts });
            }
        }
    }

    fn face(&mut self) -> Parse<Face> {
        let ident = self.ident("a face")?;
        let face = Face::NAMES.iter().find(|(name, _)| *name == ident.name);
        face.map(|(_, face)| *face).ok_or_else(|| {
            let names: Vec<&str> = Face::NAMES.iter().map(|(name, _)| *name).collect();
            let error = Diagnostic::error(ident.span, format!("there is no face `{}`", ident.name));
            Box::new(error.hint(format!("the faces are {}", names.join(", "))))
        })
    }

    fn sizes(&mut self) -> Parse<[Size; 3]> {
        self.expect("(", "and three lengths")?;
        let sizes = self.three(|parser| parser.size())?;
        self.expect(")", "after the three lengths")?;
        Ok(sizes)
    }

    fn body(&mut self) -> Parse<Box<Successor>> {
        self.expect("{", "before the operation")?;
        let body = self.successor()?;
        self.expect("}", "after the operation")?;
        Ok(Box::new(body))
    }

    fn size(&mut self) -> Parse<Size> {
        let kind = if self.accept("~").is_some() {
            SizeKind::Floating
        } else if self.accept("'").is_some() {
            SizeKind::Relative
        } else {
            SizeKind::Absolute
        };
        Ok(Size { kind, value: self.expr()? })
    }

    fn three<T>(&mut self, mut element: impl FnMut(&mut Self) -> Parse<T>) -> Parse<[T; 3]> {
        let x = element(self)?;
        self.expect(",", "between the lengths: there are three")?;
        let y = element(self)?;
        self.expect(",", "between the lengths: there are three")?;
        Ok([x, y, element(self)?])
    }

    /// A list with commas up to `close`, which may be empty.
    fn list<T>(&mut self, close: &str, mut element: impl FnMut(&mut Self) -> Parse<T>) -> Parse<Vec<T>> {
        let mut list = Vec::new();
        if self.accept(close).is_some() {
            return Ok(list);
        }
        loop {
            list.push(element(self)?);
            if self.accept(",").is_none() {
                self.expect(close, "or `,`")?;
                return Ok(list);
            }
        }
    }

    // Expressions

    /// An expression where a block with a namespace may stand as well.
    fn argument(&mut self) -> Parse<Expr> {
        let name = self.peek();
        let is_word = matches!(name.kind, Kind::Ident | Kind::Number);
        match is_word && has_namespace(&self.text[name.span.start..]) {
            true => self.block(name),
            false => self.expr(),
        }
    }

    /// A block state from its first token: a name, its namespace, path and properties, without gaps.
    fn block(&mut self, first: Token) -> Parse<Expr> {
        let rest = &self.text[first.span.start..];
        let name_end =
            rest.find(|c: char| !(c.is_ascii_alphanumeric() || "_:/.-".contains(c))).unwrap_or(rest.len());
        let end = match rest[name_end..].starts_with('[') {
            true => rest.find(']').map(|end| end + 1),
            false => Some(name_end),
        };
        let Some(end) = end else {
            let error = Diagnostic::error(first.span, "the properties of this block are not closed by `]`");
            return Err(Box::new(error));
        };
        let span = Span::new(first.span.start, first.span.start + end);
        while self.peek().kind != Kind::End && self.peek().span.start < span.end {
            self.next();
        }
        let text: String = self.text[span.range()].chars().filter(|c| !c.is_whitespace()).collect();
        Ok(Expr { kind: ExprKind::Block(text), span })
    }

    fn expr(&mut self) -> Parse<Expr> {
        self.operators = 0;
        self.inner_expr()
    }

    /// An expression that is part of another.
    fn inner_expr(&mut self) -> Parse<Expr> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return Err(self.too_much("an expression is nested too deeply"));
        }
        let expr = self.binary(0);
        self.depth -= 1;
        expr
    }

    /// Operators that bind at least as tightly as `least`, by precedence climbing.
    fn binary(&mut self, least: u8) -> Parse<Expr> {
        let mut left = self.unary()?;
        while let Some(op) = self.binary_op().filter(|op| op.binding() >= least) {
            self.operators += 1;
            if self.operators > MAX_OPERATORS {
                return Err(self.too_much("an expression has too many operators"));
            }
            self.next();
            let right = self.binary(op.binding() + 1)?;
            let span = left.span.to(right.span);
            left = Expr { kind: ExprKind::Binary(op, Box::new(left), Box::new(right)), span };
        }
        Ok(left)
    }

    fn binary_op(&self) -> Option<BinaryOp> {
        let token = self.peek();
        // A new line that starts with a name is the next item, never the rest of an expression.
        let text = match token.kind {
            Kind::Symbol(symbol) => symbol,
            Kind::Ident if token.place == Place::Inner => self.word(token),
            _ => return None,
        };
        BinaryOp::ALL.into_iter().find(|op| op.symbol() == text)
    }

    fn unary(&mut self) -> Parse<Expr> {
        let start = self.peek().span;
        let (op, binding) = if self.accept("-").is_some() {
            (UnaryOp::Negate, 6)
        } else if self.is_word("not") {
            self.next();
            (UnaryOp::Not, 2)
        } else {
            return self.primary();
        };
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return Err(self.too_much("an expression is nested too deeply"));
        }
        let operand = self.binary(binding)?;
        self.depth -= 1;
        let span = start.to(operand.span);
        Ok(Expr { kind: ExprKind::Unary(op, Box::new(operand)), span })
    }

    fn primary(&mut self) -> Parse<Expr> {
        let token = self.peek();
        match token.kind {
            Kind::Number => self.number(),
            Kind::Text => {
                self.next();
                let name = self.word(token).trim_matches('"').to_owned();
                Ok(Expr { kind: ExprKind::File(name), span: token.span })
            }
            Kind::Symbol("(") => {
                self.next();
                let inner = self.inner_expr()?;
                let close = self.expect(")", "to close the bracket")?;
                Ok(Expr { span: token.span.to(close.span), ..inner })
            }
            Kind::Ident => self.named(),
            _ => Err(self.unexpected("expected a number, a name or an expression")),
        }
    }

    fn number(&mut self) -> Parse<Expr> {
        let token = self.next();
        let value = self.word(token).parse().unwrap_or(f64::INFINITY);
        if !f64::is_finite(value) {
            return Err(Box::new(Diagnostic::error(token.span, "this number is too large")));
        }
        Ok(Expr { kind: ExprKind::Number(value), span: token.span })
    }

    fn named(&mut self) -> Parse<Expr> {
        let token = self.peek();
        let name = self.word(token);
        let after = self.peek_after(1);
        if after.kind == Kind::Symbol("[") && after.span.start == token.span.end {
            return self.block(token);
        }
        self.next();
        if name == "scope" && self.accept(".").is_some() {
            return self.scope_size(token.span);
        }
        // Only `rand` is a function without brackets; the others may be names: `floor = 4`.
        let is_called = name == Function::Rand.name() || self.is_symbol("(");
        let Some(function) = Function::of_name(name).filter(|_| is_called) else {
            return Ok(Expr { kind: ExprKind::Name(name.to_owned()), span: token.span });
        };
        let args = match self.accept("(") {
            Some(_) => self.list(")", |parser| parser.inner_expr())?,
            None => Vec::new(),
        };
        let span = token.span.to(Span::new(0, self.previous_end()));
        function.takes(args.len()).map_err(|expected| {
            let plural = if args.len() == 1 { "" } else { "s" };
            let message = format!("`{name}` cannot take {} argument{plural}", args.len());
            Box::new(Diagnostic::error(span, message).hint(format!("it takes {expected}")))
        })?;
        Ok(Expr { kind: ExprKind::Call(function, args), span })
    }

    fn scope_size(&mut self, start: Span) -> Parse<Expr> {
        let field = self.ident("`sx`, `sy` or `sz` after `scope.`")?;
        let axis = match field.name.as_str() {
            "sx" => Axis::X,
            "sy" => Axis::Y,
            "sz" => Axis::Z,
            _ => {
                let error = Diagnostic::error(field.span, format!("a scope has no `{}`", field.name));
                return Err(Box::new(error.hint("it has scope.sx, scope.sy and scope.sz: its lengths")));
            }
        };
        Ok(Expr { kind: ExprKind::ScopeSize(axis), span: start.to(field.span) })
    }
}

/// Whether a text begins with a name in a namespace, as in `create:brass_casing`.
fn has_namespace(text: &str) -> bool {
    let rest = text.trim_start_matches(is_block_char);
    rest.strip_prefix(':').is_some_and(|path| path.starts_with(is_block_char))
}

fn is_block_char(c: char) -> bool {
    c.is_ascii_alphanumeric() || "_/.-".contains(c)
}
