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
        self.sizes.iter().for_each(|size| head += &format!("{size}\n"));
        self.constants.iter().for_each(|constant| head += &format!("{constant}\n"));
        if !head.is_empty() {
            blocks.push(head);
        }
        let mut previous: Option<&Rule> = None;
        for rule in &self.rules {
            let text = format!("{rule}\n");
            let continues = previous.is_some_and(|previous| previous.label == rule.label);
            match blocks.last_mut().filter(|_| continues) {
                Some(block) => *block += &text,
                None => blocks.push(text),
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
        write!(f, "{}{} = {}", comment_lines(&self.comments), self.name.name, self.value)
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
        let parts = Layout::of(&self.op);
        match parts.children.is_empty() {
            true => f.write_str(&parts.head),
            false => {
                let children: Vec<String> = parts.children.iter().map(Child::flat).collect();
                write!(f, "{}{{ {} }}", parts.head, children.join(" | "))
            }
        }
    }
}

/// An operation as its head and the parts in its braces.
struct Layout<'a> {
    head: String,
    children: Vec<Child<'a>>,
}

enum Child<'a> {
    Op { prefix: String, body: &'a Successor },
    Group(Vec<Child<'a>>),
}

impl<'a> Layout<'a> {
    fn of(op: &'a Op) -> Layout<'a> {
        let single = |head: String, body: &'a Successor| Layout {
            head,
            children: vec![Child::Op { prefix: String::new(), body }],
        };
        let leaf = |head: String| Layout { head, children: Vec::new() };
        match op {
            Op::Nil => leaf("nil".to_owned()),
            Op::Primitive { name, material: None } => leaf(format!("I({name})")),
            Op::Primitive { name, material: Some(material) } => leaf(format!("I({name}, {material})")),
            Op::Call { label, args } if args.is_empty() => leaf(label.name.clone()),
            Op::Call { label, args } => leaf(format!("{}({})", label.name, list(args))),
            Op::Split { axis, items } => Layout {
                head: format!("split({axis})"),
                children: items.iter().map(Child::of_item).collect(),
            },
            Op::Repeat { axis, size, body } => single(format!("repeat({axis}, {size})"), body),
            Op::RepeatN { axis, count, body } => single(format!("repeatN({axis}, {count})"), body),
            Op::Translate { delta, body } => single(format!("T({})", list(delta)), body),
            Op::Resize { size, body } => single(format!("S({})", list(size)), body),
            Op::Rotate { axis, angle, body } => single(format!("R({axis}, {angle})"), body),
            Op::Comp { parts } => Layout {
                head: "comp(f)".to_owned(),
                children: parts
                    .iter()
                    .map(|(face, body)| Child::Op { prefix: format!("{} : ", face.name()), body })
                    .collect(),
            },
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
    let Layout { head, children } = Layout::of(&successor.op);
    match children.is_empty() {
        true => head,
        false => format!("{head}{{{}}}", lines(&children, indent)),
    }
}

fn lines(children: &[Child<'_>], indent: &str) -> String {
    let inner = format!("{indent}{INDENT}");
    let lines: Vec<String> =
        children.iter().map(|child| format!("\n{inner}{}", child.layout(&inner))).collect();
    format!("{}\n{indent}", lines.join(" |"))
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
