//! Names as the whole grammar has them.

use super::space::Sort;
use crate::grammar::ast::*;
use crate::grammar::is_primitive;

/// What the names of a file stand for in the whole grammar.
pub trait Naming {
    /// The name of a definition that a name of this file means.
    fn defined(&self, sort: Sort, name: &str) -> Option<String>;
    /// What a label is called that has no rule here: never that of another file.
    fn missing(&self, label: &str) -> String;
    /// Whether a name that means no constant of this file would mean one in the whole grammar.
    fn is_captured(&self, name: &str) -> bool;
    /// A file that this file names, seen from the root's folder.
    fn file(&self, file: &str) -> String;
}

/// Renames a definition and all that it uses.
pub struct Renaming<'n, N> {
    pub naming: &'n N,
    /// Names that are parameters here.
    pub params: Vec<String>,
}

impl<N: Naming> Renaming<'_, N> {
    pub fn rule(&self, rule: &mut Rule) {
        self.label(&mut rule.label.name);
        rule.condition.iter_mut().chain(&mut rule.weight).for_each(|expr| self.expr(expr));
        self.successor(&mut rule.successor);
    }

    pub fn constant(&self, constant: &mut Constant) {
        self.name(Sort::Constant, &mut constant.name.name);
        self.expr(&mut constant.value);
        let range = constant.attribute.iter_mut().flat_map(|attribute| attribute.range.iter_mut().flatten());
        range.for_each(|bound| self.expr(bound));
    }

    pub fn style(&self, style: &mut Style) {
        self.name(Sort::Style, &mut style.name.name);
        for (constant, value) in &mut style.values {
            self.name(Sort::Constant, &mut constant.name);
            self.expr(value);
        }
    }

    pub fn start_size(&self, start: &mut StartSize) {
        start.size.iter_mut().chain(&mut start.weight).for_each(|expr| self.expr(expr));
    }

    fn name(&self, sort: Sort, name: &mut String) {
        if let Some(defined) = self.naming.defined(sort, name) {
            *name = defined;
        }
    }

    fn label(&self, label: &mut String) {
        *label = self.naming.defined(Sort::Label, label).unwrap_or_else(|| self.naming.missing(label));
    }

    fn successor(&self, successor: &mut Successor) {
        match &mut successor.op {
            Op::Nil => {}
            Op::Primitive { name, material, options } => self.primitive(name, material, options),
            Op::Call { label, args } => {
                self.label(&mut label.name);
                self.exprs(args);
            }
            Op::All(ops) => ops.iter_mut().for_each(|op| self.successor(op)),
            Op::Split { axis, items, .. } => {
                self.expr(axis);
                items.iter_mut().for_each(|item| self.item(item));
            }
            Op::Repeat { axis, size: number, body, .. } | Op::RepeatN { axis, count: number, body } => {
                self.expr(axis);
                self.expr(number);
                self.successor(body);
            }
            Op::Carve { args, parts, .. } => {
                self.exprs(args);
                parts.iter_mut().for_each(|(_, body)| self.successor(body));
            }
            Op::Within { change, body } => {
                self.change(change);
                self.successor(body);
            }
            Op::Snap { axis, .. } => self.expr(axis),
        }
    }

    /// A constant with the name of a shape says what the shape is made of, and has another name now.
    fn primitive(&self, name: &mut Expr, material: &mut Option<Expr>, options: &mut [(Ident, Expr)]) {
        material.iter_mut().for_each(|material| self.expr(material));
        options.iter_mut().for_each(|(_, value)| self.expr(value));
        let shape = match &name.kind {
            ExprKind::Name(text) if is_primitive(text) && !self.params.contains(text) => text.clone(),
            _ => return self.expr(name),
        };
        match self.naming.defined(Sort::Constant, &shape) {
            Some(made_of) if made_of != shape => {
                material.get_or_insert(Expr { kind: ExprKind::Name(made_of), span: name.span });
                name.kind = ExprKind::Block(shape);
            }
            _ => self.expr(name),
        }
    }

    fn item(&self, item: &mut Item) {
        match item {
            Item::Part { size, body } => {
                self.expr(&mut size.value);
                self.successor(body);
            }
            Item::Group { items, .. } => items.iter_mut().for_each(|item| self.item(item)),
        }
    }

    fn change(&self, change: &mut Change) {
        match change {
            Change::Translate(sizes) | Change::Resize(sizes) => {
                sizes.iter_mut().for_each(|size| self.expr(&mut size.value));
            }
            Change::Rotate { axis, angle } => {
                self.expr(axis);
                self.expr(angle);
            }
            Change::Same(key) => self.key(key),
            Change::Style(name) => self.name(Sort::Style, &mut name.name),
            Change::Local => {}
        }
    }

    fn exprs(&self, exprs: &mut [Expr]) {
        exprs.iter_mut().for_each(|expr| self.expr(expr));
    }

    /// A key is any value, or a word of its own.
    fn key(&self, key: &mut Expr) {
        match &mut key.kind {
            ExprKind::Name(name) if !self.params.contains(name) => self.name(Sort::Constant, name),
            ExprKind::File(_) => {}
            _ => self.expr(key),
        }
    }

    fn expr(&self, expr: &mut Expr) {
        match &mut expr.kind {
            ExprKind::Name(name) if self.params.contains(name) => {}
            ExprKind::Name(name) => match self.naming.defined(Sort::Constant, name) {
                Some(defined) => *name = defined,
                None if self.naming.is_captured(name) => expr.kind = literal(name),
                None => {}
            },
            ExprKind::Block(text) => self.block(text),
            ExprKind::File(file) => *file = self.naming.file(file),
            ExprKind::Unary(_, operand) => self.expr(operand),
            ExprKind::Binary(_, left, right) => {
                self.expr(left);
                self.expr(right);
            }
            ExprKind::Same(key, value) => {
                self.key(key);
                self.expr(value);
            }
            ExprKind::Call(_, args) => self.exprs(args),
            ExprKind::Pick(parts) | ExprKind::Mix(parts) => parts.iter_mut().for_each(|(weight, value)| {
                self.expr(weight);
                self.expr(value);
            }),
            ExprKind::Gradient(axis, blocks) => {
                self.expr(axis);
                self.exprs(blocks);
            }
            ExprKind::Occlusion { against, distance } => {
                if let Against::Label(label) = against {
                    self.label(label);
                }
                distance.iter_mut().for_each(|distance| self.expr(distance));
            }
            ExprKind::Visible(label) => self.label(label),
            ExprKind::Number(_) | ExprKind::ScopeSize(_) | ExprKind::Share(_) => {}
        }
    }

    /// A block state that may be the value of a name with other properties: `wall[facing=north]`.
    fn block(&self, text: &mut String) {
        let Some((name, properties)) = text.split_once('[') else { return };
        if self.params.iter().any(|param| param == name) {
            return;
        }
        match self.naming.defined(Sort::Constant, name) {
            Some(defined) => *text = format!("{defined}[{properties}"),
            None if self.naming.is_captured(name) => *text = format!("minecraft:{text}"),
            None => {}
        }
    }
}

/// What a name means that no constant hides.
fn literal(name: &str) -> ExprKind {
    match name {
        "none" => ExprKind::Number(0.0),
        "part" => ExprKind::Number(1.0),
        "full" => ExprKind::Number(2.0),
        block => ExprKind::Block(block.to_owned()),
    }
}
