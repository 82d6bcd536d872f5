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

/// Where a schematic keeps its blocks, and the data of entities.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Layout {
    /// Versions 1 and 2: beside the sizes, beside `Id`.
    Flat,
    /// Version 3: in `Blocks`, in `Data`.
    Nested,
}

/// One entry of a list, and where it stands.
pub(super) struct Entry {
    path: String,
    tags: Compound,
    layout: Layout,
}

impl Entry {
    pub fn fields(&self) -> Fields<'_> {
        Fields::new(self.path.as_str(), &self.tags)
    }

    /// The game's data, with tags of the format where they stand among them. Some programs write version 3 without `Data`;
    /// in version 2 a tag of that name is the game's.
    pub fn data(mut self) -> Compound {
        match self.tags.remove("Data") {
            Some(Tag::Compound(data)) if self.layout == Layout::Nested => data,
            other => {
                self.tags.extend(other.map(|tag| ("Data".to_owned(), tag)));
                self.tags
            }
        }
    }
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

    pub fn take_entities(&mut self) -> Result<Vec<Entry>, ReadError> {
        let layout = self.layout();
        take_list(&mut self.tags, self.path, "Entities", layout)
    }

    /// Those of version 1 have a name of their own, those of version 3 stand in `Blocks`.
    pub fn take_block_entities(&mut self) -> Result<Vec<Entry>, ReadError> {
        let layout = self.layout();
        let blocks_path = self.fields().path("Blocks");
        let (tags, path) = match self.tags.get_mut("Blocks") {
            Some(Tag::Compound(blocks)) => (blocks, &*blocks_path),
            _ => (&mut self.tags, self.path),
        };
        let mut entries = take_list(tags, path, "TileEntities", layout)?;
        entries.extend(take_list(tags, path, "BlockEntities", layout)?);
        Ok(entries)
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

fn take_list(tags: &mut Compound, path: &str, name: &str, layout: Layout) -> Result<Vec<Entry>, ReadError> {
    let paths: Vec<String> =
        Fields::new(path, tags).list(name)?.into_iter().map(|entry| entry.path).collect();
    let Some(Tag::List(entries)) = tags.remove(name) else { return Ok(Vec::new()) };
    let compounds = entries.into_iter().filter_map(|entry| match entry {
        Tag::Compound(tags) => Some(tags),
        _ => None,
    });
    Ok(paths.into_iter().zip(compounds).map(|(path, tags)| Entry { path, tags, layout }).collect())
}
