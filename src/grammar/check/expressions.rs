//! Expressions: that every name has a meaning, and one of the type that its place asks for.

use super::{Checker, Expected};
use crate::block::{self, BlockState};
use crate::grammar::ast::*;
use crate::grammar::names::{Name, Names, closest};
use crate::grammar::{Code, PRIMITIVES, Span, is_primitive};

impl Checker<'_> {
    pub(super) fn expr(&mut self, expr: &Expr, params: &[Ident], expected: Expected) {
        match &expr.kind {
            ExprKind::Name(name) => self.name(name, expr.span, params, expected),
            ExprKind::Block(text) if self.is_changed_name(text, params) => {
                self.is_of(Expected::Thing, expected, expr.span, "a block");
            }
            ExprKind::Block(text) => self.block(text, expr.span, expected),
            ExprKind::File(_) => self.is_of(Expected::Thing, expected, expr.span, "a file"),
            ExprKind::Number(_) | ExprKind::ScopeSize(_) | ExprKind::Share(_) => {
                self.is_of(Expected::Number, expected, expr.span, "a number");
            }
            ExprKind::Pick(parts) => {
                for (weight, value) in parts {
                    self.expr(weight, params, Expected::Number);
                    self.expr(value, params, expected);
                }
            }
            ExprKind::Mix(parts) => {
                self.is_of(Expected::Thing, expected, expr.span, "a mix of blocks");
                for (weight, block) in parts {
                    self.expr(weight, params, Expected::Number);
                    self.expr(block, params, Expected::Thing);
                }
            }
            ExprKind::Gradient(axis, blocks) => {
                self.is_of(Expected::Thing, expected, expr.span, "a gradient of blocks");
                self.expr(axis, params, Expected::Axis);
                blocks.iter().for_each(|block| self.expr(block, params, Expected::Thing));
            }
            ExprKind::Same(key, value) => {
                self.key(key, params);
                self.expr(value, params, expected);
            }
            ExprKind::Occlusion { against, distance } => {
                self.is_of(Expected::Number, expected, expr.span, "a number");
                distance.iter().for_each(|distance| self.expr(distance, params, Expected::Number));
                if let Against::Label(label) = against {
                    self.asked_label(label, expr.span);
                }
            }
            ExprKind::Visible(label) => {
                self.is_of(Expected::Number, expected, expr.span, "a number");
                self.asked_label(label, expr.span);
            }
            ExprKind::Unary(_, operand) => {
                self.is_of(Expected::Number, expected, expr.span, "a number");
                self.expr(operand, params, Expected::Number);
            }
            ExprKind::Binary(op, left, right) => {
                self.is_of(Expected::Number, expected, expr.span, "a number");
                // Anything can be compared for equality: `ax == y`.
                let operands = match op {
                    BinaryOp::Equal | BinaryOp::NotEqual => Expected::Any,
                    _ => Expected::Number,
                };
                self.expr(left, params, operands);
                self.expr(right, params, operands);
            }
            ExprKind::Call(_, args) => {
                self.is_of(Expected::Number, expected, expr.span, "a number");
                args.iter().for_each(|arg| self.expr(arg, params, Expected::Number));
            }
        }
    }

    /// A key is a word of its own, or any value.
    pub(super) fn key(&mut self, key: &Expr, params: &[Ident]) {
        if !matches!(key.kind, ExprKind::Name(_) | ExprKind::File(_)) {
            self.expr(key, params, Expected::Any);
        }
    }

    fn asked_label(&mut self, label: &str, span: Span) {
        if !self.rules.contains_key(label) && !self.broken.contains(label) {
            let near = closest(label, self.rules.keys().copied());
            let hint = near.map_or("ask for a label that has a rule".to_owned(), |near| {
                format!("did you mean `{near}`?")
            });
            let message = format!("there is no rule for `{label}`");
            self.tell(Code::UnknownLabel, span, message, "not defined", hint);
        }
    }

    fn is_of(&mut self, is: Expected, expected: Expected, span: Span, found: &str) {
        let wanted = match expected {
            Expected::Any => return,
            Expected::Number => "a number",
            Expected::Axis => "an axis: x, y or z",
            Expected::Thing => "a block or a primitive",
        };
        if is != expected {
            let hint = match expected {
                Expected::Number => "write a number, a parameter or an expression such as `scope.sx / 2`",
                Expected::Axis => "name the axis, as in `split(x){ ... }`",
                Expected::Thing | Expected::Any => "name what is placed, as in `I(stone)`",
            };
            let message = format!("expected {wanted}, found {found}");
            self.tell(Code::WrongType, span, message, "here", hint.to_owned());
        }
    }

    fn name(&mut self, name: &str, span: Span, params: &[Ident], expected: Expected) {
        match (Names { params, constants: &self.grammar.constants }).resolve(name) {
            Name::Param(_) => {}
            Name::Thing if self.broken.contains(name) => {}
            Name::Constant(at) => {
                let is = constant_type(&self.grammar.constants[at].value);
                if is != Expected::Any {
                    self.is_of(is, expected, span, &format!("the constant `{name}`"));
                }
            }
            Name::Axis(axis) => self.is_of(Expected::Axis, expected, span, &format!("the axis {axis}")),
            Name::Number(_) => self.is_of(Expected::Number, expected, span, "a number"),
            Name::Thing if matches!(expected, Expected::Number | Expected::Axis) => {
                let known = params.iter().chain(self.grammar.constants.iter().map(|c| &c.name));
                let hint = match closest(name, known.map(|ident| ident.name.as_str())) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None if expected == Expected::Axis => "the axes are x, y and z".to_owned(),
                    None => format!("define it: `{name} = 3`"),
                };
                let message = format!("`{name}` is no parameter and no constant");
                self.tell(Code::UnknownName, span, message, "not defined", hint);
            }
            Name::Thing if is_thing(name) => {}
            Name::Thing => {
                let hint = thing_hint(name);
                let message = format!("there is no block or primitive `{name}`");
                self.tell(Code::UnknownBlock, span, message, "not known", hint);
            }
        }
    }

    /// Whether a block state is the value of a name with other properties: `wall[facing=north]`.
    pub(super) fn is_changed_name(&self, text: &str, params: &[Ident]) -> bool {
        let name = text.split('[').next().unwrap_or(text);
        self.is_defined(name, params)
    }

    /// Whether a name is that of a parameter or a constant.
    pub(super) fn is_defined(&self, name: &str, params: &[Ident]) -> bool {
        let resolved = Names { params, constants: &self.grammar.constants }.resolve(name);
        matches!(resolved, Name::Param(_) | Name::Constant(_))
    }

    fn block(&mut self, text: &str, span: Span, expected: Expected) {
        self.is_of(Expected::Thing, expected, span, "a block");
        if is_thing(text) {
            return;
        }
        let state = match text.parse::<BlockState>() {
            Ok(state) => state,
            Err(error) => {
                let hint = "a block state reads `oak_log[axis=x]`".to_owned();
                return self.tell(Code::BadBlockState, span, error.to_string(), "here", hint);
            }
        };
        // Files of other versions and of mods hold blocks and properties that vox does not know.
        let is_bare = !text.split('[').next().unwrap_or(text).contains(':');
        if is_bare && block::known(state.name()).is_none() {
            let message = format!("there is no block `{}`", state.short_name());
            self.tell(Code::UnknownBlock, span, message, "not known", thing_hint(state.short_name()));
        } else if let Err(error) = block::check(&state) {
            let hint = "it is written as it stands, and the game may drop it".to_owned();
            self.tell(Code::UnknownProperty, span, error.to_string(), "not known", hint);
        }
    }
}

/// The type that a constant's own text shows; `Any` where it depends on what it is used for.
pub(super) fn constant_type(value: &Expr) -> Expected {
    match &value.kind {
        ExprKind::Name(_) | ExprKind::Pick(_) | ExprKind::Same(..) => Expected::Any,
        ExprKind::Block(_) | ExprKind::File(_) | ExprKind::Mix(_) | ExprKind::Gradient(..) => Expected::Thing,
        _ => Expected::Number,
    }
}

/// Whether a bare name can be placed: a primitive, a block of the game, or a family of blocks.
pub(super) fn is_thing(name: &str) -> bool {
    is_primitive(name) || block::known(name).is_some() || block::Family::of(name).is_some()
}

fn thing_hint(name: &str) -> String {
    let materials = block::all().iter().filter_map(|known| known.name().strip_suffix("_stairs"));
    let near = closest(name, PRIMITIVES.into_iter().chain(materials)).or_else(|| block::suggest(name));
    near.map_or_else(
        || format!("say what it is made of, as in `{name} = stone`; blocks of mods carry their namespace"),
        |near| format!("did you mean `{near}`? Or say what it is made of, as in `{name} = stone`"),
    )
}
