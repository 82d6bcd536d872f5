//! What was explained already, what it was explained by, and what has to be explained anew.

use super::boxes::Boxes;
use super::explain::Search;
use super::plan::NodeId;
use rustc_hash::FxHashMap;

/// Boxes that were explained.
#[derive(Debug)]
struct Entry {
    boxes: Boxes,
    search: Search,
    /// `None` while it is being explained.
    node: Option<NodeId>,
    /// What was explained on the way to it, as far as it is part of it.
    uses: Vec<usize>,
    /// What it was explained on the way to.
    users: Vec<usize>,
}

/// What was explained, by boxes and search.
#[derive(Default, Debug)]
pub struct Memo {
    entries: Vec<Entry>,
    known: FxHashMap<(Boxes, Search), usize>,
    /// What is being explained, the innermost last.
    open: Vec<usize>,
}

impl Memo {
    /// The node of boxes that were explained, which is from now on part of what is being explained.
    pub fn get(&mut self, boxes: &Boxes, search: Search) -> Option<NodeId> {
        let entry = *self.known.get(&(boxes.clone(), search))?;
        self.link(entry);
        self.entries[entry].node
    }

    pub fn begin(&mut self, boxes: &Boxes, search: Search) {
        let entry = self.entries.len();
        let (uses, users) = (Vec::new(), Vec::new());
        self.entries.push(Entry { boxes: boxes.clone(), search, node: None, uses, users });
        self.link(entry);
        self.open.push(entry);
    }

    /// What was begun last is explained by that node.
    pub fn end(&mut self, node: NodeId) {
        if let Some(entry) = self.open.pop() {
            let own = &mut self.entries[entry];
            own.node = Some(node);
            self.known.insert((own.boxes.clone(), own.search), entry);
        }
    }

    /// What was explained so far on the way to what is being explained was only tried.
    pub fn drop_uses(&mut self) {
        if let Some(entry) = self.open.last() {
            self.entries[*entry].uses.clear();
        }
    }

    fn link(&mut self, entry: usize) {
        if let Some(&user) = self.open.last() {
            self.entries[user].uses.push(entry);
            if self.entries[entry].users.last() != Some(&user) {
                self.entries[entry].users.push(user);
            }
        }
    }

    /// Forgets how boxes were explained, and all that was explained by way of them.
    pub fn forget(&mut self, boxes: &Boxes) {
        let mut open: Vec<usize> =
            (0..self.entries.len()).filter(|entry| self.entries[*entry].boxes == *boxes).collect();
        while let Some(entry) = open.pop() {
            let own = &mut self.entries[entry];
            open.append(&mut own.users);
            let key = (own.boxes.clone(), own.search);
            if self.known.get(&key) == Some(&entry) {
                self.known.remove(&key);
            }
        }
    }

    /// All that is part of how boxes were explained, by its node.
    pub fn in_use(&self, boxes: &Boxes, search: Search) -> FxHashMap<NodeId, Vec<Boxes>> {
        let mut found: FxHashMap<NodeId, Vec<Boxes>> = FxHashMap::default();
        let mut seen = vec![false; self.entries.len()];
        let mut open: Vec<usize> = self.known.get(&(boxes.clone(), search)).copied().into_iter().collect();
        while let Some(at) = open.pop() {
            let entry = &self.entries[at];
            if let (false, Some(node)) = (std::mem::replace(&mut seen[at], true), entry.node) {
                found.entry(node).or_default().push(entry.boxes.clone());
                open.extend(entry.uses.iter().rev());
            }
        }
        found
    }
}
