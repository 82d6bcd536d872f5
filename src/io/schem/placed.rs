//! Block entities as they stand in a file: tens of thousands in some, and mostly like each other but for their place.

use super::entry::{Entry, Layout};
use crate::io::ReadError;
use crate::io::fields::Fields;
use crate::nbt::{Compound, Kept, Seen, Sink};
use crate::space::Cell;
use std::collections::BTreeMap;

/// Where the lists stand, within `Schematic` or at the root. Those of version 1 have the name of those of MCEdit, which stay in
/// the tree.
const PATHS: [(&str, Layout); 2] =
    [("BlockEntities", Layout::Flat), ("Blocks.BlockEntities", Layout::Nested)];

/// A block entity where its file says it is.
pub(super) struct Placed {
    pub place: Cell,
    /// The game's data. What is wrong with them does not matter outside of the build.
    pub data: Result<Compound, Box<ReadError>>,
}

impl Placed {
    pub fn read(entry: Entry) -> Result<Placed, ReadError> {
        let place = Cell::from_array(entry.get("Pos")?);
        Ok(Placed { place, data: entry.data().map_err(Box::new) })
    }
}

/// Takes the block entities of a schematic as its file streams by.
pub(super) struct Lists {
    lists: BTreeMap<String, List>,
    /// The path of the list that is coming in.
    current: String,
    seen: Seen,
}

struct List {
    layout: Layout,
    placed: Vec<Placed>,
    /// Of the first entry without a place; those after it do not count.
    problem: Option<ReadError>,
}

impl Lists {
    pub fn new() -> Lists {
        Lists { lists: BTreeMap::new(), current: String::new(), seen: Seen::of(usize::MAX) }
    }

    /// The entries of the list `name`; none where it is absent.
    pub fn find(&mut self, fields: &Fields, name: &str) -> Result<Vec<Placed>, ReadError> {
        // What is no list of compounds stayed in the tree.
        fields.list(name)?;
        let list = self.lists.remove(&fields.path(name)).filter(|_| fields.tags.contains_key(name));
        let Some(List { placed, problem, .. }) = list else { return Ok(Vec::new()) };
        problem.map_or(Ok(placed), Err)
    }
}

impl Sink for Lists {
    fn wants_list(&mut self, path: &str) -> bool {
        let within = path.strip_prefix("Schematic.").unwrap_or(path);
        let Some(&(_, layout)) = PATHS.iter().find(|(known, _)| *known == within) else { return false };
        path.clone_into(&mut self.current);
        self.lists.insert(path.to_owned(), List { layout, placed: Vec::new(), problem: None });
        true
    }

    fn entry(&mut self, index: usize, tags: Compound) -> Kept {
        let Some(list) = self.lists.get_mut(&self.current) else { return Kept::Nothing };
        if list.problem.is_some() {
            return Kept::Nothing;
        }
        match Placed::read(Entry { list: &self.current, index, tags, layout: list.layout }) {
            Err(problem) => {
                list.problem = Some(problem);
                Kept::Nothing
            }
            Ok(Placed { place, data }) => {
                let shared = data.map(|data| self.seen.share(data));
                let kept = shared.as_ref().map_or(Kept::All, |(_, kept)| *kept);
                list.placed.push(Placed { place, data: shared.map(|(data, _)| data) });
                kept
            }
        }
    }
}
