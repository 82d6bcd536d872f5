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
        let mut head = String::new();
        if self.up == Up::Z {
            head += "up z\n";
        }
        if let Some(version) = self.data_version {
            head += &format!("data_version {version}\n");
        }
        self.imports.iter().for_each(|import| head += &format!("{import}\n"));
        self.sizes.iter().for_each(|size| head += &format!("{size}\n"));
        self.constants.iter().for_each(|constant| head += &format!("{constant}\n"));
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
        f.write_str(&blocks.join("\n"))
    }
}

fn comment_lines(comments: &[String]) -> String {
    comments.iter().map(|line| format!("# {line}").trim_end().to_owned() + "\n").collect()
}

impl Display for StartSize {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let [x, y, z] = &self.size;
        write!(f, "{}size({x}, {y}, {z}){}", comment_lines(&self.comments), Weight(&self.weight))
    }
}

impl Display for Constant {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let comments = comment_lines(&self.comments);
        let Some(attribute) = &self.attribute else {
            return write!(f, "{comments}{} = {}", self.name.name, self.value);
        };
        write!(f, "{comments}attr {} = {}{attribute}", self.name.name, self.value)
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
        self.prefix.as_ref().map_or(Ok(()), |prefix| write!(f, " as {}", prefix.name))
    }
}

impl Display for Style {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}style {} {{", comment_lines(&self.comments), self.name.name)?;
        for (name, value) in &self.values {
            writeln!(f, "{INDENT}{} = {value}", name.name)?;
        }
        f.write_str("}")
    }
}

impl Display for Rule {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let mut head = comment_lines(&self.comments);
        let label_start = head.len();
        head += &self.label.name;
        if !self.params.is_empty() {
            let names: Vec<&str> = self.params.iter().map(|param| param.name.as_str()).collect();
            head += &format!("({})", names.join(", "));
        }
        if let Some(condition) = &self.condition {
            head += &format!(" : {condition}");
        }
        head += " --> ";
        let weight = Weight(&self.weight).to_string();
        let column = head.len() - label_start;
        write!(f, "{head}{}{weight}", layout(&self.successor, "", column + weight.len()))
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

    fn layout(&self, indent: &str) -> String {
        match self {
            Child::Op { prefix, body } => {
                format!("{prefix}{}", layout(body, indent, indent.len() + prefix.len() + 2))
            }
            Child::Group(_) if self.flat().len() + indent.len() + 2 <= WIDTH => self.flat(),
            Child::Group(children) => format!("{{{}}}*", lines(children, indent)),
        }
    }
}

/// An operation on one line where it fits behind `column`, else with each part on a line of its own.
fn layout(successor: &Successor, indent: &str, column: usize) -> String {
    let flat = successor.to_string();
    if column + flat.len() <= WIDTH {
        return flat;
    }
    match Layout::of(&successor.op) {
        Layout::Leaf(text) => text,
        Layout::Braces { head, children } => format!("{head}{{{}}}", lines(&children, indent)),
        Layout::All(ops) => {
            let inner = format!("{indent}{INDENT}");
            let lines: Vec<String> =
                ops.iter().map(|op| format!("\n{inner}{}", bracketed(op, &inner))).collect();
            format!("[{}\n{indent}]", lines.concat())
        }
    }
}

/// One of several operations that share a scope, on lines of its own.
fn bracketed(op: &Successor, indent: &str) -> String {
    let flat = op.to_string();
    match op.op {
        Op::All(_) if indent.len() + flat.len() <= WIDTH => format!("[ {flat} ]"),
        _ => layout(op, indent, indent.len()),
    }
}

fn lines(children: &[Child<'_>], indent: &str) -> String {
    let inner = format!("{indent}{INDENT}");
    let lines: Vec<String> =
        children.iter().map(|child| format!("\n{inner}{}", child.layout(&inner))).collect();
    format!("{}\n{indent}", lines.join(" |"))
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

impl Display for Operand<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let binding = match &self.0.kind {
            ExprKind::Binary(op, ..) => op.binding(),
            // `not` reaches as far right as it can, so it never stands bare beside an operator.
            ExprKind::Unary(UnaryOp::Not, _) => 0,
            _ => u8::MAX,
        };
        if binding < self.1 { write!(f, "({})", self.0) } else { write!(f, "{}", self.0) }
    }
}
