//! The text front end: tokens, parser, syntax tree, printer and static checks.
//! Knows nothing of graphs or grids.

pub mod ast;
mod check;
mod code;
mod diagnostic;
mod format;
mod lex;
mod load;
mod names;
mod parse;
mod print;
mod sources;

pub use ast::Grammar;
pub use check::{Checked, check, read, value};
pub use code::{Code, Explanation};
pub use diagnostic::{Diagnostic, Severity, Span};
pub use format::format;
pub use load::{Loaded, load};
pub use names::{Name, Names, PRIMITIVES, closest, is_mesh, is_primitive, is_reserved, reserved};
pub use parse::parse;
pub use sources::{Place, Sources};
