use super::input::is_stdio;
use super::report;
use crate::grid::Grid;
use std::path::{Path, PathBuf};

/// What a command has written, for the one line that tells of it. Standard output is not told of: who reads it knows.
#[derive(Debug, Default)]
pub struct Summary {
    files: Vec<(PathBuf, String)>,
}

impl Summary {
    pub fn add(&mut self, path: &Path, what: String) {
        if !is_stdio(path) {
            self.files.push((path.to_owned(), what));
        }
    }

    pub fn tell(&self) {
        match self.files.as_slice() {
            [] => {}
            [(path, what)] => report::note(&format!("wrote {}: {what}", path.display())),
            [(first, _), .., (last, _)] => {
                let count = self.files.len();
                report::note(&format!("wrote {count} files, {} to {}", first.display(), last.display()));
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
