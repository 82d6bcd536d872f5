/// Where a tag stands, by the names from the root: `Schematic.BlockEntities[3].Pos`. The root's own name is left out.
/// Names that could be taken for more than one step are quoted.
#[derive(Default)]
pub(super) struct Path(String);

/// The length of a path before a step was added.
pub(super) struct Mark(pub usize);

impl Path {
    pub fn as_str(&self) -> &str {
        &self.0
    }

    pub fn enter_tag(&mut self, name: &str) -> Mark {
        let mark = Mark(self.0.len());
        if !self.0.is_empty() {
            self.0.push('.');
        }
        match name.is_empty() || name.bytes().any(|byte| matches!(byte, b'.' | b'[' | b'"')) {
            true => self.0 += &format!("{name:?}"),
            false => self.0 += name,
        }
        mark
    }

    /// The number of the entry is told by errors alone: lists are long.
    pub fn enter_list(&mut self) -> Mark {
        let mark = Mark(self.0.len());
        self.0 += "[]";
        mark
    }

    pub fn leave(&mut self, mark: &Mark) {
        self.0.truncate(mark.0);
    }
}
