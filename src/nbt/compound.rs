use super::Tag;
use ecow::{EcoString, EcoVec};
use std::cmp::Ordering;
use std::fmt;

/// The name of a tag. Those of up to 15 bytes take no memory of their own.
pub type Name = EcoString;

/// The tags of a compound by name. Sorted, so that the same tree always gives the same bytes.
///
/// One sorted array without room to spare: most compounds have a handful of tags, and there can be millions of them.
/// Clones share it until one of them is changed.
#[derive(Clone, Default)]
pub struct Compound(EcoVec<(Name, Tag)>);

impl Compound {
    pub fn new() -> Compound {
        Compound::default()
    }

    /// Takes the tags from `start` on out of `tags`, in any order. Of equal names the last one counts.
    pub(super) fn split_off(tags: &mut Vec<(Name, Tag)>, start: usize) -> Compound {
        tags[start..].sort_by(|a, b| a.0.cmp(&b.0));
        let mut sorted: EcoVec<(Name, Tag)> = EcoVec::with_capacity(tags.len() - start);
        for tag in tags.drain(start..) {
            if sorted.last().is_some_and(|last| last.0 == tag.0) {
                sorted.pop();
            }
            sorted.push(tag);
        }
        Compound(sorted)
    }

    pub fn len(&self) -> usize {
        self.0.len()
    }

    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    fn find(&self, name: &str) -> Result<usize, usize> {
        self.0.binary_search_by(|(other, _)| other.as_str().cmp(name))
    }

    pub fn get(&self, name: &str) -> Option<&Tag> {
        self.find(name).ok().map(|at| &self.0[at].1)
    }

    pub fn get_mut(&mut self, name: &str) -> Option<&mut Tag> {
        let at = self.find(name).ok()?;
        Some(&mut self.0.make_mut()[at].1)
    }

    pub fn contains_key(&self, name: &str) -> bool {
        self.find(name).is_ok()
    }

    /// The tag that had the name before. Takes as long as there are tags: many are collected or extended with instead.
    pub fn insert(&mut self, name: impl Into<Name>, tag: Tag) -> Option<Tag> {
        let name = name.into();
        match self.find(&name) {
            Ok(at) => Some(std::mem::replace(&mut self.0.make_mut()[at].1, tag)),
            Err(at) => {
                self.0.insert(at, (name, tag));
                None
            }
        }
    }

    /// Inserts the tag where there is none of the name.
    pub fn insert_missing(&mut self, name: &str, tag: impl FnOnce() -> Tag) {
        if let Err(at) = self.find(name) {
            self.0.insert(at, (name.into(), tag()));
        }
    }

    pub fn remove(&mut self, name: &str) -> Option<Tag> {
        self.find(name).ok().map(|at| self.0.remove(at).1)
    }

    pub fn retain(&mut self, mut keep: impl FnMut(&Name, &mut Tag) -> bool) {
        self.0.retain(|(name, tag)| keep(name, tag));
    }

    pub fn iter(&self) -> Iter<'_> {
        self.0.iter().map(|(name, tag)| (name, tag))
    }

    pub fn keys(&self) -> impl Iterator<Item = &Name> {
        self.0.iter().map(|(name, _)| name)
    }

    pub fn values(&self) -> impl Iterator<Item = &Tag> {
        self.0.iter().map(|(_, tag)| tag)
    }

    pub fn values_mut(&mut self) -> impl Iterator<Item = &mut Tag> {
        self.0.make_mut().iter_mut().map(|(_, tag)| tag)
    }

    pub fn into_keys(self) -> impl Iterator<Item = Name> {
        self.0.into_iter().map(|(name, _)| name)
    }

    pub fn clear(&mut self) {
        *self = Compound::new();
    }
}

/// Those that share their memory are equal at once.
impl Ord for Compound {
    fn cmp(&self, other: &Compound) -> Ordering {
        let is_shared = std::ptr::eq(self.0.as_slice(), other.0.as_slice());
        if is_shared { Ordering::Equal } else { self.0.cmp(&other.0) }
    }
}

impl PartialOrd for Compound {
    fn partial_cmp(&self, other: &Compound) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Eq for Compound {}

impl PartialEq for Compound {
    fn eq(&self, other: &Compound) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

/// The tags of a compound, by name.
pub type Iter<'a> = std::iter::Map<std::slice::Iter<'a, (Name, Tag)>, fn(&(Name, Tag)) -> (&Name, &Tag)>;

impl<'a> IntoIterator for &'a Compound {
    type Item = (&'a Name, &'a Tag);
    type IntoIter = Iter<'a>;

    fn into_iter(self) -> Iter<'a> {
        self.iter()
    }
}

impl IntoIterator for Compound {
    type Item = (Name, Tag);
    type IntoIter = ecow::vec::IntoIter<(Name, Tag)>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

impl<N: Into<Name>> Extend<(N, Tag)> for Compound {
    fn extend<I: IntoIterator<Item = (N, Tag)>>(&mut self, tags: I) {
        let mut tags = tags.into_iter().map(|(name, tag)| (name.into(), tag)).peekable();
        if tags.peek().is_some() {
            let mut all: Vec<(Name, Tag)> = std::mem::take(self).into_iter().chain(tags).collect();
            *self = Compound::split_off(&mut all, 0);
        }
    }
}

impl<N: Into<Name>> FromIterator<(N, Tag)> for Compound {
    fn from_iter<I: IntoIterator<Item = (N, Tag)>>(tags: I) -> Compound {
        let mut compound = Compound::new();
        compound.extend(tags);
        compound
    }
}

impl<N: Into<Name>, const LEN: usize> From<[(N, Tag); LEN]> for Compound {
    fn from(tags: [(N, Tag); LEN]) -> Compound {
        tags.into_iter().collect()
    }
}

impl std::ops::Index<&str> for Compound {
    type Output = Tag;

    fn index(&self, name: &str) -> &Tag {
        self.get(name).unwrap_or_else(|| panic!("there is no tag `{name}`"))
    }
}

impl fmt::Debug for Compound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_map().entries(self).finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::BTreeMap;

    #[derive(Clone, Debug)]
    enum Change {
        Insert(String, i32),
        InsertMissing(String, i32),
        Remove(String),
        Set(String, i32),
        Extend(Vec<(String, i32)>),
        KeepBelow(String),
    }

    fn change() -> impl Strategy<Value = Change> {
        let name = || "[a-d]{0,2}|[a-b]{20}";
        prop_oneof![
            (name(), any::<i32>()).prop_map(|(name, n)| Change::Insert(name, n)),
            (name(), any::<i32>()).prop_map(|(name, n)| Change::InsertMissing(name, n)),
            name().prop_map(Change::Remove),
            (name(), any::<i32>()).prop_map(|(name, n)| Change::Set(name, n)),
            proptest::collection::vec((name(), any::<i32>()), 0..30).prop_map(Change::Extend),
            name().prop_map(Change::KeepBelow),
        ]
    }

    fn model(model: &mut BTreeMap<String, Tag>, change: Change) -> Option<Tag> {
        match change {
            Change::Insert(name, n) => return model.insert(name, Tag::Int(n)),
            Change::InsertMissing(name, n) => {
                model.entry(name).or_insert(Tag::Int(n));
            }
            Change::Remove(name) => return model.remove(&name),
            Change::Set(name, n) => model.get_mut(&name).into_iter().for_each(|tag| *tag = Tag::Int(n)),
            Change::Extend(tags) => model.extend(tags.into_iter().map(|(name, n)| (name, Tag::Int(n)))),
            Change::KeepBelow(name) => model.retain(|other, _| *other < name),
        }
        None
    }

    fn compound(compound: &mut Compound, change: Change) -> Option<Tag> {
        match change {
            Change::Insert(name, n) => return compound.insert(name, Tag::Int(n)),
            Change::InsertMissing(name, n) => compound.insert_missing(&name, || Tag::Int(n)),
            Change::Remove(name) => return compound.remove(&name),
            Change::Set(name, n) => compound.get_mut(&name).into_iter().for_each(|tag| *tag = Tag::Int(n)),
            Change::Extend(tags) => compound.extend(tags.into_iter().map(|(name, n)| (name, Tag::Int(n)))),
            Change::KeepBelow(name) => compound.retain(|other, _| other.as_str() < name.as_str()),
        }
        None
    }

    proptest! {
        #[test]
        fn it_is_a_sorted_map(changes in proptest::collection::vec(change(), 0..20)) {
            let (mut map, mut tags) = (BTreeMap::new(), Compound::new());
            for change in changes {
                let (before, kept) = (tags.clone(), map.clone());
                prop_assert_eq!(compound(&mut tags, change.clone()), model(&mut map, change));
                prop_assert!(tags.iter().map(|(name, tag)| (name.as_str(), tag)).eq(map.iter().map(|(name, tag)| (name.as_str(), tag))));
                prop_assert_eq!(before, Compound::from_iter(kept), "clones stay as they were");
            }
            prop_assert!(map.iter().all(|(name, tag)| tags.get(name) == Some(tag)));
        }
    }

    #[test]
    fn equal_tags_have_equal_bytes() {
        assert_eq!(Tag::Double(f64::NAN), Tag::Double(f64::NAN));
        assert_ne!(Tag::Double(0.0), Tag::Double(-0.0));
        assert_eq!(Tag::List(Vec::new()).cmp(&Tag::Compound(Compound::new())), Ordering::Less);
    }
}
