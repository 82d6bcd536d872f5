//! The text front end: tokens, parser, syntax tree, printer and static checks.
//! Knows nothing of graphs or grids.

pub mod ast;
mod check;
mod code;
mod diagnostic;
mod lex;
mod names;
mod parse;
mod print;

pub use ast::Grammar;
pub use check::{Checked, check, is_reserved, read};
pub use code::{Code, Explanation};
pub use diagnostic::{Diagnostic, Severity, Span};
pub use names::{Name, Names, PRIMITIVES, is_primitive};
pub use parse::parse;
