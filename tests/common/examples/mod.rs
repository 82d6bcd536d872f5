//! Small files made by hand, of what is read and not written.

#![allow(dead_code, reason = "no program of tests uses all of them")]

pub mod axiom;
pub mod blueprint;
pub mod magica;
pub mod mcedit;
pub mod mcstructure;
pub mod region;

use vox::nbt::{Compound, Tag};

pub fn tags<const N: usize>(tags: [(&str, Tag); N]) -> Compound {
    tags.map(|(name, tag)| (name.to_owned(), tag)).into()
}
