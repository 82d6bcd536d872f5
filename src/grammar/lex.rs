use super::{Code, Diagnostic, Span};

/// What a piece of text is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    Ident,
    Number,
    /// A text in double quotes.
    Text,
    /// `-->`
    Arrow,
    /// `==`, `<=` and the like, and single characters.
    Symbol(&'static str),
    /// What has been told to have no meaning.
    Unknown,
    End,
}

#[derive(Clone, Copy, Debug)]
pub struct Token {
    pub kind: Kind,
    pub span: Span,
    /// Whether only white space stands before it on its line.
    pub place: Place,
}

/// Where a token stands on its line. Items of a file start at the beginning of one.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Place {
    FirstAtMargin,
    FirstIndented,
    Inner,
}

/// A comment without its marker, and where it stands.
#[derive(Clone, Debug)]
pub struct Comment {
    pub text: String,
    pub span: Span,
}

pub struct Lexed {
    /// Ends with one token of kind `End`.
    pub tokens: Vec<Token>,
    pub comments: Vec<Comment>,
    pub errors: Vec<Diagnostic>,
}

/// Longer symbols first: the first that fits is taken. The alternatives are those of printed mathematics.
const SYMBOLS: [(&str, &str); 29] = [
    ("==", "=="),
    ("!=", "!="),
    ("<=", "<="),
    (">=", ">="),
    ("≤", "<="),
    ("≥", ">="),
    ("≠", "!="),
    ("−", "-"),
    ("∼", "~"),
    ("=", "="),
    ("<", "<"),
    (">", ">"),
    ("+", "+"),
    ("-", "-"),
    ("*", "*"),
    ("/", "/"),
    ("%", "%"),
    ("(", "("),
    (")", ")"),
    ("{", "{"),
    ("}", "}"),
    ("[", "["),
    ("]", "]"),
    ("|", "|"),
    (":", ":"),
    (",", ","),
    (".", "."),
    ("~", "~"),
    ("'", "'"),
];

const ARROWS: [&str; 4] = ["-->", "→", "⟶", "−→"];

/// The tokens of the file that `text` holds from `start` on.
pub fn lex(text: &str, start: usize) -> Lexed {
    let mut lexed = Lexed { tokens: Vec::new(), comments: Vec::new(), errors: Vec::new() };
    let mut at = start;
    let mut line_start = start;
    let mut is_line_empty = true;
    while let Some(first) = text[at..].chars().next() {
        let rest = &text[at..];
        if first == '\n' {
            at += 1;
            (line_start, is_line_empty) = (at, true);
        } else if first.is_whitespace() || first == '\u{feff}' {
            at += first.len_utf8();
        } else if first == '#' || rest.starts_with("//") {
            let comment = comment(text, at);
            at = comment.span.end;
            lexed.comments.push(comment);
        } else {
            let place = match (is_line_empty, at == line_start) {
                (true, true) => Place::FirstAtMargin,
                (true, false) => Place::FirstIndented,
                (false, _) => Place::Inner,
            };
            is_line_empty = false;
            let (kind, length) = token(rest).unwrap_or_else(|(length, code, message)| {
                lexed.errors.push(Diagnostic::new(code, Span::new(at, at + length), message).label("here"));
                (Kind::Unknown, length)
            });
            lexed.tokens.push(Token { kind, span: Span::new(at, at + length), place });
            at += length;
        }
    }
    let end = text.trim_end().len().max(start);
    let span = Span::new(end, end);
    lexed.tokens.push(Token { kind: Kind::End, span, place: Place::FirstAtMargin });
    lexed
}

/// What is no token: how long it is, and what to say of it.
type Refused = (usize, Code, String);

fn comment(text: &str, at: usize) -> Comment {
    let rest = &text[at..];
    let line = rest.lines().next().unwrap_or("");
    let body = line.strip_prefix("//").or_else(|| line.strip_prefix('#')).unwrap_or(line);
    let text = body.strip_prefix(' ').unwrap_or(body).trim_end().to_owned();
    Comment { text, span: Span::new(at, at + line.len()) }
}

fn token(rest: &str) -> Result<(Kind, usize), Refused> {
    let first = rest.chars().next().unwrap_or(' ');
    if let Some(arrow) = ARROWS.iter().find(|arrow| rest.starts_with(**arrow)) {
        return Ok((Kind::Arrow, arrow.len()));
    }
    if first == '"' {
        return quoted(rest);
    }
    if first.is_ascii_digit() || (first == '.' && rest[1..].starts_with(|c: char| c.is_ascii_digit())) {
        return Ok((Kind::Number, number_length(rest)));
    }
    if first.is_alphabetic() || first == '_' {
        let length = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
        return Ok((Kind::Ident, length));
    }
    match SYMBOLS.iter().find(|(spelling, _)| rest.starts_with(spelling)) {
        Some((spelling, symbol)) => Ok((Kind::Symbol(symbol), spelling.len())),
        None => {
            let message = format!("the character `{first}` has no meaning in a grammar");
            Err((first.len_utf8(), Code::UnknownCharacter, message))
        }
    }
}

fn quoted(rest: &str) -> Result<(Kind, usize), Refused> {
    match rest[1..].find(['"', '\n']) {
        Some(end) if rest[1 + end..].starts_with('"') => Ok((Kind::Text, end + 2)),
        end => {
            let length = 1 + end.unwrap_or(rest.len() - 1);
            Err((length, Code::OpenText, "this text is not closed by `\"`".to_owned()))
        }
    }
}

fn number_length(rest: &str) -> usize {
    let digits = |from: usize| {
        rest[from..].find(|c: char| !c.is_ascii_digit()).map_or(rest.len(), |length| from + length)
    };
    let whole = digits(0);
    if rest[whole..].starts_with('.') { digits(whole + 1) } else { whole }
}
