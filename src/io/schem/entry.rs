use crate::io::ReadError;
use crate::io::fields::{Fields, FromTag};
use crate::nbt::{Compound, Tag};

/// Where a schematic keeps its blocks, and the data of entities.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Layout {
    /// Versions 1 and 2: beside the sizes, beside `Id`.
    Flat,
    /// Version 3: in `Blocks`, in `Data`.
    Nested,
}

/// One entry of a list of entities or block entities, and where it stands.
pub(super) struct Entry<'a> {
    pub list: &'a str,
    pub index: usize,
    pub tags: Compound,
    pub layout: Layout,
}

impl Entry<'_> {
    /// The tag `name`; `None` where it is absent.
    fn find<'t, T: FromTag<'t>>(&'t self, name: &str) -> Result<Option<T>, ReadError> {
        match self.tags.get(name).map(T::from_tag) {
            // The path takes longer to make than the rest to read.
            Some(None) => Fields::new(self.path(), &self.tags).find(name),
            found => Ok(found.flatten()),
        }
    }

    pub fn get<'t, T: FromTag<'t>>(&'t self, name: &str) -> Result<T, ReadError> {
        match self.find(name)? {
            Some(value) => Ok(value),
            None => Fields::new(self.path(), &self.tags).get(name),
        }
    }

    fn path(&self) -> String {
        format!("{}[{}]", self.list, self.index)
    }

    /// The data in the game's form: with `id`, without a place.
    pub fn data(self) -> Result<Compound, ReadError> {
        let id = self.find::<&str>("Id")?.map(str::to_owned);
        let mut data = self.content();
        data.retain(|name, _| !["Id", "Pos", "ContentVersion"].contains(&name.as_str()));
        id.into_iter().for_each(|id| drop(data.insert("id", Tag::String(id))));
        Ok(data)
    }

    /// The game's data, with tags of the format where they stand among them. Some programs write version 3 without `Data`;
    /// in version 2 a tag of that name is the game's.
    fn content(mut self) -> Compound {
        match (self.layout, self.tags.get_mut("Data")) {
            (Layout::Nested, Some(Tag::Compound(data))) => std::mem::take(data),
            _ => self.tags,
        }
    }
}
