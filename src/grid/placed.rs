use super::Entity;
use crate::nbt::{Compound, Tag};

/// Entities that players put down, and the items.
const ITEMS: [(&str, &str); 12] = [
    ("armor_stand", "armor_stand"),
    ("chest_minecart", "chest_minecart"),
    ("command_block_minecart", "command_block_minecart"),
    ("end_crystal", "end_crystal"),
    ("furnace_minecart", "furnace_minecart"),
    ("glow_item_frame", "glow_item_frame"),
    ("hopper_minecart", "hopper_minecart"),
    ("item_frame", "item_frame"),
    ("leash_knot", "lead"),
    ("minecart", "minecart"),
    ("painting", "painting"),
    ("tnt_minecart", "tnt_minecart"),
];

/// Lists of what an entity wears and holds.
const WORN: [&str; 2] = ["ArmorItems", "HandItems"];

impl Entity {
    /// The items that putting it down takes, each with how many: itself, and what it shows, wears and holds. `None` for
    /// what no item puts down.
    pub fn items(&self) -> Option<Vec<(String, u64)>> {
        let kind = plain(self.data.get("id")?)?;
        let (_, own) = ITEMS.iter().find(|(name, _)| *name == kind)?;
        let lists = WORN.iter().filter_map(|name| match self.data.get(name) {
            Some(Tag::List(items)) => Some(items.iter()),
            _ => None,
        });
        let worn = match self.data.get("equipment") {
            Some(Tag::Compound(slots)) => slots.values().collect(),
            _ => Vec::new(),
        };
        let held = self.data.get("Item").into_iter().chain(lists.flatten()).chain(worn);
        let held = held.filter_map(|tag| if let Tag::Compound(item) = tag { stack(item) } else { None });
        Some(std::iter::once(((*own).to_owned(), 1)).chain(held).collect())
    }
}

/// An item and how many of it there are, in the form of any version.
fn stack(item: &Compound) -> Option<(String, u64)> {
    let count = match item.get("count").or(item.get("Count")) {
        Some(Tag::Int(count)) => u64::try_from(*count).ok()?,
        Some(Tag::Byte(count)) => u64::try_from(*count).ok()?,
        _ => 1,
    };
    let id = plain(item.get("id")?)?;
    (count > 0 && id != "air").then(|| (id.to_owned(), count))
}

/// An id without the game's namespace.
fn plain(id: &Tag) -> Option<&str> {
    match id {
        Tag::String(id) => Some(id.strip_prefix("minecraft:").unwrap_or(id)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(text: &str) -> Tag {
        Tag::String(text.to_owned())
    }

    fn compound<const N: usize>(tags: [(&str, Tag); N]) -> Compound {
        tags.into_iter().map(|(name, tag)| (name.to_owned(), tag)).collect()
    }

    fn items(data: Compound) -> Option<Vec<(String, u64)>> {
        Entity { place: [0.0; 3], block: None, data }.items()
    }

    #[test]
    fn what_entities_hold_counts_in_every_form() {
        let boots = compound([("id", text("minecraft:iron_boots")), ("Count", Tag::Byte(1))]);
        let torch = compound([("id", text("torch")), ("count", Tag::Int(3))]);
        let owned = |name: &str, count| (name.to_owned(), count);
        let worn = vec![Tag::Compound(boots.clone()), Tag::Compound(Compound::new())];
        let stand = compound([("id", text("minecraft:armor_stand")), ("ArmorItems", Tag::List(worn))]);
        assert_eq!(items(stand), Some(vec![owned("armor_stand", 1), owned("iron_boots", 1)]));
        let slots = compound([("feet", Tag::Compound(boots))]);
        let stand = compound([("id", text("armor_stand")), ("equipment", Tag::Compound(slots))]);
        assert_eq!(items(stand), Some(vec![owned("armor_stand", 1), owned("iron_boots", 1)]));
        let frame = compound([("id", text("minecraft:item_frame")), ("Item", Tag::Compound(torch))]);
        assert_eq!(items(frame), Some(vec![owned("item_frame", 1), owned("torch", 3)]));
        assert_eq!(items(compound([("id", text("minecraft:cow"))])), None);
        assert_eq!(items(Compound::new()), None);
    }
}
