use super::input::is_stdio;
use super::report;
use crate::grid::Grid;
use std::path::{Path, PathBuf};

/// What a command has written, for the one line that tells of it. Standard output is not told of: who reads it knows.
#[derive(Debug, Default)]
pub struct Summary {
    written: Vec<Written>,
}

/// A building in its files.
#[derive(Debug)]
struct Written {
    files: usize,
    first: PathBuf,
    last: PathBuf,
    what: String,
}

impl Summary {
    /// Adds a building with the files it was written to: more than one where it is in pieces.
    pub fn add(&mut self, paths: &[&Path], what: String) {
        let (Some(first), Some(last)) = (paths.first(), paths.last()) else { return };
        if !is_stdio(first) {
            let (first, last) = (first.to_path_buf(), last.to_path_buf());
            self.written.push(Written { files: paths.len(), first, last, what });
        }
    }

    pub fn tell(&self) {
        let count: usize = self.written.iter().map(|written| written.files).sum();
        match self.written.as_slice() {
            [] => {}
            [Written { files: 1, first, what, .. }] => {
                report::note(&format!("wrote {}: {what}", first.display()))
            }
            [Written { first, last, what, .. }] => {
                report::note(&format!("wrote {} to {}: {what}", first.display(), last.display()));
            }
            [first, .., last] => {
                let (first, last) = (first.first.display(), last.last.display());
                report::note(&format!("wrote {count} files, {first} to {last}"));
            }
        }
    }
}

/// A building in a few words: `9 x 7 x 12, 412 blocks`. `edge` is that of the pieces it comes in.
pub fn building(grid: &Grid, edge: Option<u16>) -> String {
    let (size, blocks) = (grid.size(), grid.blocks());
    let pieces = edge.map_or(String::new(), |edge| {
        format!(", in {}", counted(grid.boxes(edge).count() as u64, "piece", "pieces"))
    });
    format!("{} x {} x {}, {}{pieces}", size.x, size.y, size.z, counted(blocks, "block", "blocks"))
}

pub fn boxes(count: usize) -> String {
    counted(count as u64, "labelled box", "labelled boxes")
}

/// A number with its noun.
pub fn counted(number: u64, one: &str, many: &str) -> String {
    format!("{number} {}", if number == 1 { one } else { many })
}
