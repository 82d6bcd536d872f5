//! The blocks of a structure, each of which is a compound: a tree of them would take a hundred times their memory.

use crate::io::ReadError;
use crate::io::fields::{self, Fields, FromTag};
use crate::nbt::{Compound, Kept, Sink, Tag};
use crate::space::Cell;

/// Where the list of the blocks stands.
const PATH: &str = "blocks";

/// Takes the blocks as their file streams by.
#[derive(Default)]
pub struct Incoming {
    blocks: Vec<Placed>,
    /// Of the first block that is none; those after it do not count.
    problem: Option<ReadError>,
}

/// A block of the list.
pub(super) struct Placed {
    pub place: Cell,
    pub state: u32,
    pub nbt: Option<Box<Compound>>,
}

impl Incoming {
    /// The blocks of the structure `root`, in the order of the file.
    pub(super) fn finish(self, root: &Fields) -> Result<Vec<Placed>, ReadError> {
        let left = root.get::<&[Tag]>(PATH)?;
        // What is no list of compounds stayed in the tree.
        fields::values::<&Compound>(&root.path(PATH), left).try_for_each(|entry| entry.map(drop))?;
        self.problem.map_or(Ok(self.blocks), Err)
    }
}

impl Sink for Incoming {
    fn wants_list(&mut self, path: &str) -> bool {
        if path == PATH {
            *self = Incoming::default();
        }
        path == PATH
    }

    fn entry(&mut self, index: usize, block: Compound) -> Kept {
        if self.problem.is_some() {
            return Kept::Nothing;
        }
        match Placed::read(index, block) {
            Ok(block) => {
                let kept = if block.nbt.is_some() { Kept::All } else { Kept::Nothing };
                self.blocks.push(block);
                kept
            }
            Err(problem) => {
                self.problem = Some(problem);
                Kept::Nothing
            }
        }
    }
}

impl Placed {
    fn read(index: usize, mut block: Compound) -> Result<Placed, ReadError> {
        let fields = || Fields::new(path(index), &block);
        let place = match block.get("pos").and_then(<[i32; 3]>::from_tag) {
            Some(place) => Cell::from_array(place),
            None => Cell::from_array(fields().get("pos")?),
        };
        let state = match block.get("state").and_then(i32::from_tag) {
            Some(state) => state,
            None => fields().get("state")?,
        };
        let state = u32::try_from(state).map_err(|_| ReadError::WrongType {
            path: fields().path("state"),
            expected: "an index of the palette",
            found: state.to_string(),
        })?;
        fields().find::<&Compound>("nbt")?;
        let nbt = match block.remove("nbt") {
            Some(Tag::Compound(nbt)) => Some(Box::new(nbt)),
            _ => None,
        };
        Ok(Placed { place, state, nbt })
    }
}

/// The path of the block `index`.
pub(super) fn path(index: usize) -> String {
    format!("{PATH}[{index}]")
}
