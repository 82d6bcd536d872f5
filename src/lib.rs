//! vox learns split grammars from Minecraft houses and grows new houses from grammars.
//!
//! ```text
//! text --parse--> Grammar --lower--> OpGraph --run--> Grid --write--> .schem .obj .png
//! files --read--> Grid --infer--> OpGraph --raise--> Grammar --print--> text, .dot
//! ```
//!
//! The modules are listed from the bottom up: each one uses only those above it in this file.

pub mod space;

pub mod nbt;

pub mod block;

pub mod grid;

pub mod neighbours;

pub mod grammar;

pub mod graph;

pub mod run;

pub mod parse;

pub mod shapes;

pub mod infer;

pub mod score;

pub mod update;

pub mod facade;

pub mod io;

pub mod view;

pub mod cli;
