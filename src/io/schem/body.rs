use super::entry::{Entry, Layout};
use super::placed::{Lists, Placed};
use super::{KNOWN, KNOWN_IN_BLOCKS};
use crate::grid::{Dialect, Own};
use crate::io::ReadError;
use crate::io::fields::{Fields, wrong_type};
use crate::nbt::{Compound, Tag};

/// The tags of a schematic, at the root of its file or in `Schematic`. What is long is taken out of them, not copied.
pub(super) struct Body {
    path: &'static str,
    tags: Compound,
    /// What stands beside `Schematic`.
    beside: Compound,
}

impl Body {
    pub fn of(mut root: Compound) -> Result<Body, ReadError> {
        match root.remove("Schematic") {
            None => Ok(Body { path: "", tags: root, beside: Compound::new() }),
            Some(Tag::Compound(tags)) => Ok(Body { path: "Schematic", tags, beside: root }),
            Some(other) => Err(wrong_type::<&Compound>("Schematic".to_owned(), &other)),
        }
    }

    pub fn fields(&self) -> Fields<'_> {
        Fields::new(self.path, &self.tags)
    }

    pub fn layout(&self) -> Layout {
        if self.tags.contains_key("Blocks") { Layout::Nested } else { Layout::Flat }
    }

    /// What `read` makes of the entities, which are then gone.
    pub fn take_entities<T>(&mut self, read: Read<T>) -> Result<Vec<T>, ReadError> {
        let layout = self.layout();
        take_list(&mut self.tags, self.path, "Entities", layout, read)
    }

    /// Those of version 1 have a name of their own, those of version 3 stand in `Blocks`.
    pub fn take_block_entities(&mut self, streamed: &mut Lists) -> Result<[Vec<Placed>; 2], ReadError> {
        let layout = self.layout();
        let blocks_path = self.fields().path("Blocks");
        let (tags, path) = match self.tags.get_mut("Blocks") {
            Some(Tag::Compound(blocks)) => (blocks, &*blocks_path),
            _ => (&mut self.tags, self.path),
        };
        let old = take_list(tags, path, "TileEntities", layout, Placed::read)?;
        Ok([old, streamed.find(&Fields::new(path, tags), "BlockEntities")?])
    }

    /// What no version of the format knows.
    pub fn own(mut self) -> Option<Own> {
        let mut tags = self.beside;
        if let Some(Tag::Compound(mut blocks)) = self.tags.remove("Blocks") {
            blocks.retain(|name, _| !KNOWN_IN_BLOCKS.contains(&name.as_str()));
            if !blocks.is_empty() {
                tags.insert("Blocks".to_owned(), Tag::Compound(blocks));
            }
        }
        tags.extend(self.tags.into_iter().filter(|(name, _)| !KNOWN.contains(&name.as_str())));
        (!tags.is_empty()).then_some(Own { dialect: Dialect::Sponge, tags })
    }
}

/// What is made of an entry of a list.
type Read<T> = fn(Entry) -> Result<T, ReadError>;

fn take_list<T>(
    tags: &mut Compound,
    path: &str,
    name: &str,
    layout: Layout,
    read: Read<T>,
) -> Result<Vec<T>, ReadError> {
    let fields = Fields::new(path, tags);
    fields.list(name)?;
    let list = fields.path(name);
    let Some(Tag::List(entries)) = tags.remove(name) else { return Ok(Vec::new()) };
    let compounds = entries.into_iter().filter_map(|entry| match entry {
        Tag::Compound(tags) => Some(tags),
        _ => None,
    });
    let entries = compounds.enumerate().map(|(index, tags)| Entry { list: &list, index, tags, layout });
    entries.map(read).collect()
}
