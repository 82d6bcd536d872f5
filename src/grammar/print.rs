//! The printer: the one layout that vox writes grammars in. What it prints parses to an equal tree.

use super::ast::*;
use crate::space::Up;
use std::fmt::{self, Display, Formatter};

/// Lines are broken where they would pass this column.
const WIDTH: usize = 100;
const INDENT: &str = "    ";

impl Display for Grammar {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let mut blocks = Vec::new();
        if !self.preamble.is_empty() {
            blocks.push(comment_lines(&self.preamble));
        }
        let mut head = directives(self);
        self.imports.iter().for_each(|import| head += &format!("{import}\n"));
        let sizes = self.sizes.iter().map(|size| (&size.comments, size.to_string()));
        let constants = self.constants.iter().map(|constant| (&constant.comments, constant.to_string()));
        for (comments, text) in sizes.chain(constants) {
            // A comment is the heading of what follows.
            if !comments.is_empty() && !head.is_empty() {
                blocks.push(std::mem::take(&mut head));
            }
            head += &format!("{text}\n");
        }
        if !head.is_empty() {
            blocks.push(head);
        }
        self.styles.iter().for_each(|style| blocks.push(format!("{style}\n")));
        let mut previous: Option<&Rule> = None;
        let mut priority = Rule::FIRST;
        for rule in &self.rules {
            let text = format!("{rule}\n");
            let continues = previous.is_some_and(|previous| previous.label == rule.label);
            if std::mem::replace(&mut priority, rule.priority) != rule.priority {
                blocks.push(format!("priority {priority}\n"));
                blocks.push(text);
            } else {
                match blocks.last_mut().filter(|_| continues) {
                    Some(block) => *block += &text,
                    None => blocks.push(text),
                }
            }
            previous = Some(rule);
        }
        if !self.epilogue.is_empty() {
            blocks.push(comment_lines(&self.epilogue));
        }
        f.write_str(&blocks.join("\n"))
    }
}

/// What a grammar says of all that follows.
pub fn directives(grammar: &Grammar) -> String {
    let mut text = String::new();
    if grammar.up == Up::Z {
        text += "up z\n";
    }
    if let Some(version) = grammar.data_version {
        text += &format!("data_version {version}\n");
    }
    text
}

pub fn comment_lines(comments: &[String]) -> String {
    comments.iter().map(|line| comment(line) + "\n").collect()
}

fn comment(line: &str) -> String {
    format!("# {line}").trim_end().to_owned()
}

/// A comment behind something on its line, if there is one.
struct Behind<'a>(Option<&'a String>);

impl Display for Behind<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.0.map_or(Ok(()), |line| write!(f, " {}", comment(line)))
    }
}

impl Display for StartSize {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let [x, y, z] = &self.size;
        let (comments, behind) = (comment_lines(&self.comments), Behind(self.behind.as_ref()));
        write!(f, "{comments}size({x}, {y}, {z}){}{behind}", Weight(&self.weight))
    }
}

impl Display for Constant {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let (comments, behind) = (comment_lines(&self.comments), Behind(self.behind.as_ref()));
        let Some(attribute) = &self.attribute else {
            let value = match self.name.name.len() + " = ".len() + self.value.to_string().len() <= WIDTH {
                true => self.value.to_string(),
                false => long(&self.value, ""),
            };
            return write!(f, "{comments}{} = {value}{behind}", self.name.name);
        };
        write!(f, "{comments}attr {} = {}{attribute}{behind}", self.name.name, self.value)
    }
}

impl Display for Attribute {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        if let Some([low, high]) = &self.range {
            write!(f, " range({low}, {high})")?;
        }
        if let Some(group) = &self.group {
            write!(f, " group(\"{group}\")")?;
        }
        self.about.as_ref().map_or(Ok(()), |about| write!(f, " about(\"{about}\")"))
    }
}

impl Display for Import {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{}import \"{}\"", comment_lines(&self.comments), self.file)?;
        self.prefix.as_ref().map_or(Ok(()), |prefix| write!(f, " as {}", prefix.name))?;
        write!(f, "{}", Behind(self.behind.as_ref()))
    }
}

impl Display for Style {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}style {} {{", comment_lines(&self.comments), self.name.name)?;
        for (name, value) in &self.values {
            writeln!(f, "{INDENT}{} = {value}", name.name)?;
        }
        write!(f, "}}{}", Behind(self.behind.as_ref()))
    }
}

impl Display for Rule {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let mut head = self.label.name.clone();
        if !self.params.is_empty() {
            let names: Vec<&str> = self.params.iter().map(|param| param.name.as_str()).collect();
            head += &format!("({})", names.join(", "));
        }
        if let Some(condition) = &self.condition {
            head += &format!(" : {}", broken(condition, head.len() + 3, INDENT));
        }
        head += " --> ";
        let weight = Weight(&self.weight).to_string();
        let column = head.len() - head.rfind('\n').map_or(0, |at| at + 1);
        let successor = layout(&self.successor, "", column + weight.len());
        write!(
            f,
            "{}{head}{successor}{weight}{}",
            comment_lines(&self.comments),
            Behind(self.behind.as_ref())
        )
    }
}

/// A condition behind `column`, on several lines where it is too long for one: each ends with its `and` or `or`.
fn broken(condition: &Expr, column: usize, indent: &str) -> String {
    let flat = condition.to_string();
    match &condition.kind {
        ExprKind::Binary(op @ (BinaryOp::And | BinaryOp::Or), left, right)
            if column + flat.len() + " -->".len() > WIDTH =>
        {
            let left = match Operand(left, op.binding()).needs_brackets() {
                true => format!("({left})"),
                false => broken(left, column, indent),
            };
            format!("{left} {}\n{indent}{}", op.symbol(), Operand(right, op.binding() + 1))
        }
        _ => flat,
    }
}

/// An optional ` : weight`.
struct Weight<'a>(&'a Option<Expr>);

impl Display for Weight<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.0.as_ref().map_or(Ok(()), |weight| write!(f, " : {weight}"))
    }
}

impl Display for Successor {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match Layout::of(&self.op) {
            Layout::Leaf(text) => f.write_str(&text),
            Layout::Braces { head, children } => {
                let children: Vec<String> = children.iter().map(Child::flat).collect();
                write!(f, "{head}{{ {} }}", children.join(" | "))
            }
            Layout::All(ops) => f.write_str(&beside(ops)),
        }
    }
}

/// Operations that share a scope, on one line. Those that do so themselves stand in brackets.
fn beside(ops: &[Successor]) -> String {
    let flat = |op: &Successor| match &op.op {
        Op::All(_) => format!("[ {op} ]"),
        _ => op.to_string(),
    };
    ops.iter().map(flat).collect::<Vec<_>>().join(" ")
}

/// How an operation is laid out.
enum Layout<'a> {
    Leaf(String),
    /// A head and the parts in its braces.
    Braces {
        head: String,
        children: Vec<Child<'a>>,
    },
    /// Operations that share a scope.
    All(&'a [Successor]),
}

enum Child<'a> {
    Op { prefix: String, body: &'a Successor },
    Group(Vec<Child<'a>>),
}

impl<'a> Layout<'a> {
    fn of(op: &'a Op) -> Layout<'a> {
        let single = |head, body: &'a Successor| Layout::Braces {
            head,
            children: vec![Child::Op { prefix: String::new(), body }],
        };
        match op {
            Op::Nil => Layout::Leaf("nil".to_owned()),
            Op::Primitive { name, material, options } => {
                let mut args = vec![name.to_string()];
                args.extend(material.as_ref().map(Expr::to_string));
                args.extend(options.iter().map(|(option, value)| format!("{} = {value}", option.name)));
                Layout::Leaf(format!("I({})", args.join(", ")))
            }
            Op::Call { label, args } if args.is_empty() => Layout::Leaf(label.name.clone()),
            Op::Call { label, args } => Layout::Leaf(format!("{}({})", label.name, list(args))),
            Op::Snap { axis, label: None } => Layout::Leaf(format!("snap({axis})")),
            Op::Snap { axis, label: Some(label) } => Layout::Leaf(format!("snap({axis}, {})", label.name)),
            Op::All(ops) => Layout::All(ops),
            Op::Split { axis, snap, items } => Layout::Braces {
                head: format!("split({axis}{})", Snaps(snap)),
                children: items.iter().map(Child::of_item).collect(),
            },
            Op::Repeat { axis, size, snap, body } => {
                single(format!("repeat({axis}, {size}{})", Snaps(snap)), body)
            }
            Op::RepeatN { axis, count, body } => single(format!("repeatN({axis}, {count})"), body),
            Op::Carve { how, args, parts } => Layout::Braces {
                head: carving(*how, args),
                children: parts
                    .iter()
                    .map(|(selector, body)| Child::Op { prefix: format!("{selector} : "), body })
                    .collect(),
            },
            Op::Within { change, body } => single(change.to_string(), body),
        }
    }
}

fn carving(how: Carving, args: &[Expr]) -> String {
    let comma = if how.is_component() && !args.is_empty() { ", " } else { "" };
    format!("{}{comma}{})", how.head(), list(args))
}

/// What a split says of snap planes, behind its other arguments.
struct Snaps<'a>(&'a Option<Snap>);

impl Display for Snaps<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self.0 {
            None => Ok(()),
            Some(Snap { label: None }) => f.write_str(", snap"),
            Some(Snap { label: Some(label) }) => write!(f, ", snap({label})"),
        }
    }
}

impl Display for Change {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Change::Translate(delta) => write!(f, "T({})", list(delta)),
            Change::Resize(size) => write!(f, "S({})", list(size)),
            Change::Rotate { axis, angle } => write!(f, "R({axis}, {angle})"),
            Change::Local => f.write_str("local"),
            Change::Same(key) => write!(f, "same({key})"),
            Change::Style(name) => write!(f, "style({})", name.name),
        }
    }
}

impl Display for Selector {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Selector::On(faces) => {
                f.write_str(&faces.iter().map(|face| face.name()).collect::<Vec<_>>().join("."))
            }
            Selector::Index(number) => write!(f, "{number}"),
            named => f.write_str(named.name()),
        }
    }
}

impl<'a> Child<'a> {
    fn of_item(item: &'a Item) -> Child<'a> {
        match item {
            Item::Part { size, body } => Child::Op { prefix: format!("{size} : "), body },
            Item::Group { items, .. } => Child::Group(items.iter().map(Child::of_item).collect()),
        }
    }

    fn flat(&self) -> String {
        match self {
            Child::Op { prefix, body } => format!("{prefix}{body}"),
            Child::Group(children) => {
                let children: Vec<String> = children.iter().map(Child::flat).collect();
                format!("{{ {} }}*", children.join(" | "))
            }
        }
    }

    /// Whether a comment stands in it or beside it.
    fn is_noted(&self) -> bool {
        match self {
            Child::Op { body, .. } => body.notes.is_some() || is_noted(body),
            Child::Group(children) => children.iter().any(Child::is_noted),
        }
    }

    /// The comments beside it.
    fn notes(&self) -> Option<&Notes> {
        match self {
            Child::Op { body, .. } => body.notes.as_deref(),
            Child::Group(_) => None,
        }
    }

    fn layout(&self, indent: &str) -> String {
        match self {
            Child::Op { prefix, body } => {
                format!("{prefix}{}", layout(body, indent, indent.len() + prefix.len() + 2))
            }
            Child::Group(_) if !self.is_noted() && self.flat().len() + indent.len() + 2 <= WIDTH => {
                self.flat()
            }
            Child::Group(children) => format!("{{{}}}*", lines(children, None, indent)),
        }
    }
}

/// Whether comments stand inside an operation, which then needs lines of its own.
fn is_noted(successor: &Successor) -> bool {
    let inside = |notes: &Notes| notes.open.is_some() || !notes.last.is_empty();
    let mut noted = successor.notes.as_deref().is_some_and(inside);
    for_each_child(&successor.op, &mut |child| noted |= child.notes.is_some() || is_noted(child));
    noted
}

/// An operation on one line where it fits behind `column`, else with each part on a line of its own.
fn layout(successor: &Successor, indent: &str, column: usize) -> String {
    if !is_noted(successor) {
        let flat = successor.to_string();
        if column + flat.len() <= WIDTH {
            return flat;
        }
    }
    let notes = successor.notes.as_deref();
    match Layout::of(&successor.op) {
        Layout::Leaf(text) => leaf(&successor.op, indent).unwrap_or(text),
        Layout::Braces { head, children } => format!("{head}{{{}}}", lines(&children, notes, indent)),
        Layout::All(ops) => {
            let inner = format!("{indent}{INDENT}");
            let line = |op: &Successor| {
                let behind = Behind(op.notes.as_deref().and_then(|notes| notes.behind.as_ref()));
                format!("{}\n{inner}{}{behind}", above(op.notes.as_deref(), &inner), bracketed(op, &inner))
            };
            let lines: String = ops.iter().map(line).collect();
            format!("[{}{lines}{}\n{indent}]", open(notes), last(notes, &inner))
        }
    }
}

/// An operation without parts that is too long for one line: its long arguments have lines of their own.
fn leaf(op: &Op, indent: &str) -> Option<String> {
    let long = |expr: &Expr| long(expr, indent);
    match op {
        Op::Primitive { name, material, options } => {
            let mut args = vec![long(name)];
            args.extend(material.as_ref().map(long));
            args.extend(options.iter().map(|(option, value)| format!("{} = {}", option.name, long(value))));
            Some(format!("I({})", args.join(", ")))
        }
        Op::Call { label, args } if !args.is_empty() => {
            let args: Vec<String> = args.iter().map(long).collect();
            Some(format!("{}({})", label.name, args.join(", ")))
        }
        _ => None,
    }
}

/// An expression in a line that is too long: a list of values that takes more than half of it gets a line for each.
fn long(expr: &Expr, indent: &str) -> String {
    let flat = expr.to_string();
    if flat.len() <= WIDTH / 2 {
        return flat;
    }
    let inner = format!("{indent}{INDENT}");
    let listed = |head: &str, parts: Vec<String>| {
        format!("{head}{{\n{inner}{}\n{indent}}}", parts.join(&format!(" |\n{inner}")))
    };
    let weighted = |parts: &[(Expr, Expr)]| {
        parts.iter().map(|(weight, value)| format!("{weight} : {}", long(value, &inner))).collect()
    };
    match &expr.kind {
        ExprKind::Pick(parts) => listed("pick", weighted(parts)),
        ExprKind::Mix(parts) => listed("mix", weighted(parts)),
        ExprKind::Gradient(axis, blocks) => {
            listed(&format!("gradient({axis})"), blocks.iter().map(|block| long(block, &inner)).collect())
        }
        _ => flat,
    }
}

/// The comment behind an opening bracket.
fn open(notes: Option<&Notes>) -> Behind<'_> {
    Behind(notes.and_then(|notes| notes.open.as_ref()))
}

/// The comment lines above a part, each behind its line break.
fn above(notes: Option<&Notes>, indent: &str) -> String {
    noted_lines(notes.map_or(&[], |notes| &notes.above), indent)
}

/// The comment lines below the last part.
fn last(notes: Option<&Notes>, indent: &str) -> String {
    noted_lines(notes.map_or(&[], |notes| &notes.last), indent)
}

fn noted_lines(comments: &[String], indent: &str) -> String {
    comments.iter().map(|line| format!("\n{indent}{}", comment(line))).collect()
}

/// One of several operations that share a scope, on lines of its own.
fn bracketed(op: &Successor, indent: &str) -> String {
    let flat = op.to_string();
    match op.op {
        Op::All(_) if indent.len() + flat.len() <= WIDTH => format!("[ {flat} ]"),
        _ => layout(op, indent, indent.len()),
    }
}

/// The parts of an operation on lines of their own, with the comments beside them and those of the whole.
fn lines(children: &[Child<'_>], notes: Option<&Notes>, indent: &str) -> String {
    let inner = format!("{indent}{INDENT}");
    let mut text = open(notes).to_string();
    for (number, child) in children.iter().enumerate() {
        let bar = if number + 1 < children.len() { " |" } else { "" };
        let behind = Behind(child.notes().and_then(|notes| notes.behind.as_ref()));
        text += &format!("{}\n{inner}{}{bar}{behind}", above(child.notes(), &inner), child.layout(&inner));
    }
    text + &last(notes, &inner) + "\n" + indent
}

fn weighted(parts: &[(Expr, Expr)]) -> String {
    parts.iter().map(|(weight, value)| format!("{weight} : {value}")).collect::<Vec<_>>().join(" | ")
}

fn list<T: Display>(elements: &[T]) -> String {
    let elements: Vec<String> = elements.iter().map(T::to_string).collect();
    elements.join(", ")
}

impl Display for Size {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let sign = match self.kind {
            SizeKind::Absolute => "",
            SizeKind::Floating => "~",
            SizeKind::Relative => "'",
        };
        write!(f, "{sign}{}", self.value)
    }
}

impl Display for Expr {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match &self.kind {
            ExprKind::Number(value) => write!(f, "{value}"),
            ExprKind::Name(name) | ExprKind::Block(name) => f.write_str(name),
            ExprKind::File(name) => write!(f, "\"{name}\""),
            ExprKind::ScopeSize(axis) => write!(f, "scope.s{axis}"),
            ExprKind::Share(Share::Index) => f.write_str("split.index"),
            ExprKind::Share(Share::Total) => f.write_str("split.total"),
            ExprKind::Pick(parts) => write!(f, "pick{{ {} }}", weighted(parts)),
            ExprKind::Mix(parts) => write!(f, "mix{{ {} }}", weighted(parts)),
            ExprKind::Gradient(axis, blocks) => {
                let blocks: Vec<String> = blocks.iter().map(Expr::to_string).collect();
                write!(f, "gradient({axis}){{ {} }}", blocks.join(" | "))
            }
            ExprKind::Same(key, value) => write!(f, "same({key}, {value})"),
            ExprKind::Occlusion { against, distance: None } => write!(f, "occ({})", against.name()),
            ExprKind::Occlusion { against, distance: Some(distance) } => {
                write!(f, "occ({}, {distance})", against.name())
            }
            ExprKind::Visible(label) => write!(f, "visible({label})"),
            ExprKind::Unary(UnaryOp::Negate, operand) => write!(f, "-{}", Operand(operand, 6)),
            ExprKind::Unary(UnaryOp::Not, operand) => write!(f, "not {}", Operand(operand, 2)),
            ExprKind::Binary(op, left, right) => {
                let binding = op.binding();
                let (left, right) = (Operand(left, binding), Operand(right, binding + 1));
                write!(f, "{left} {} {right}", op.symbol())
            }
            ExprKind::Call(function, args) if args.is_empty() => f.write_str(function.name()),
            ExprKind::Call(function, args) => write!(f, "{}({})", function.name(), list(args)),
        }
    }
}

/// An operand, in brackets where it binds less tightly than its place asks.
struct Operand<'a>(&'a Expr, u8);

impl Operand<'_> {
    fn needs_brackets(&self) -> bool {
        let binding = match &self.0.kind {
            ExprKind::Binary(op, ..) => op.binding(),
            // `not` reaches as far right as it can, so it never stands bare beside an operator.
            ExprKind::Unary(UnaryOp::Not, _) => 0,
            _ => u8::MAX,
        };
        binding < self.1
    }
}

impl Display for Operand<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        if self.needs_brackets() { write!(f, "({})", self.0) } else { write!(f, "{}", self.0) }
    }
}
