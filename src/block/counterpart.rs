use super::family::materials;
use super::suggest::closest;
use super::{BlockState, DYES, Family, all, known};
use std::collections::BTreeSet;
use std::sync::OnceLock;

/// What the same part is called where it is of another material.
const OTHER_NAMES: [[&str; 2]; 4] =
    [["_log", "_stem"], ["_log", "_block"], ["_wood", "_hyphae"], ["_sapling", "_propagule"]];

/// The block that is to material `to` what `state` is to material `from`, with every property that both
/// have: `stripped_oak_log[axis=x]` from `oak` to `spruce` is `stripped_spruce_log[axis=x]`. A material is
/// given by its own name or by that of its full block. `None` where `state` is not of `from`, so `dark_oak`
/// is not `oak`, or where `to` has no such block.
pub fn counterpart(state: &BlockState, from: &str, to: &str) -> Option<BlockState> {
    let (from, to) = (material(from)?, material(to)?);
    let name = same_member(state, from, to).or_else(|| renamed(state.short_name(), from, to))?;
    let known = known(&name)?;
    let kept = state
        .properties()
        .filter(|(key, value)| known.property(key).is_some_and(|property| property.values.contains(value)));
    Some(kept.fold(BlockState::known(known.name()), |new, (key, value)| new.with(key, value)))
}

/// Whether `name` is that of a material, as `oak` and `stone` are: there is more than one block of it.
pub fn is_material(name: &str) -> bool {
    all_materials().contains(name)
}

/// The material whose name is closest to `name`, if one is close enough to have been meant.
pub(super) fn suggest_material(name: &str) -> Option<&'static str> {
    closest(name, all_materials().iter().copied())
}

/// The material that is called `name`, or whose member is.
fn material(name: &str) -> Option<&str> {
    let name = name.strip_prefix("minecraft:").unwrap_or(name);
    let is_material = |name: &&str| all_materials().contains(*name);
    is_material(&name).then_some(name).or_else(|| materials(name).find(is_material))
}

/// The names of all materials that there is more than one block of.
fn all_materials() -> &'static BTreeSet<&'static str> {
    static ALL: OnceLock<BTreeSet<&str>> = OnceLock::new();
    ALL.get_or_init(|| {
        let named = all().iter().flat_map(|known| materials(known.name()));
        let is_material = |name: &&str| Family::of_material(name).is_some_and(|f| f.members().count() > 1);
        // Colours are materials as well: wool, carpets, beds and glass come in them.
        named.filter(is_material).chain(DYES).collect()
    })
}

/// The same member of the other family: full blocks and logs have names of their own.
fn same_member(state: &BlockState, from: &str, to: &str) -> Option<String> {
    let (from, to) = (Family::of_material(from)?, Family::of_material(to)?);
    let at = from.roles().into_iter().position(|own| own.is_some_and(|own| own.name() == state.name()))?;
    Some(to.roles()[at]?.short_name().to_owned())
}

/// The name with the one material in the place of the other.
fn renamed(name: &str, from: &str, to: &str) -> Option<String> {
    let (before, after) = around(name, from)?;
    let plain = format!("{before}{to}{after}");
    let named_otherwise = OTHER_NAMES.iter().flat_map(|[one, other]| [(one, other), (other, one)]);
    let others =
        named_otherwise.filter_map(|(one, other)| Some(format!("{}{other}", plain.strip_suffix(one)?)));
    std::iter::once(plain.clone()).chain(others).find(|name| known(name).is_some())
}

/// What stands before and after `material` in `name`, where it stands as whole words and is not itself a
/// part of a longer material.
fn around<'n>(name: &'n str, material: &str) -> Option<(&'n str, &'n str)> {
    let longer = |other: &&&str| other.len() > material.len() && other.contains(material);
    let is_of_longer = all_materials().iter().filter(longer).any(|other| words(name, other).is_some());
    words(name, material).filter(|_| !is_of_longer)
}

fn words<'n>(name: &'n str, material: &str) -> Option<(&'n str, &'n str)> {
    name.match_indices(material).map(|(at, found)| (&name[..at], &name[at + found.len()..])).find(
        |(before, after)| {
            let starts = before.is_empty() || before.ends_with('_');
            starts && (after.is_empty() || after.starts_with('_') || *after == "s")
        },
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str, from: &str, to: &str) -> Option<String> {
        counterpart(&text.parse().unwrap(), from, to).map(|state| state.short())
    }

    #[test]
    fn every_block_of_a_material_has_its_counterpart() {
        let cases = [
            ("oak_planks", "oak", "spruce", "spruce_planks"),
            (
                "oak_stairs[facing=east,waterlogged=true]",
                "oak",
                "spruce",
                "spruce_stairs[facing=east,waterlogged=true]",
            ),
            ("stripped_oak_log[axis=x]", "oak", "spruce", "stripped_spruce_log[axis=x]"),
            ("oak_wall_hanging_sign[facing=east]", "oak", "birch", "birch_wall_hanging_sign[facing=east]"),
            ("potted_oak_sapling", "oak", "birch", "potted_birch_sapling"),
            ("oak_log[axis=z]", "oak", "crimson", "crimson_stem[axis=z]"),
            ("stripped_oak_wood[axis=z]", "oak", "warped", "stripped_warped_hyphae[axis=z]"),
            ("oak_log[axis=z]", "oak", "bamboo", "bamboo_block[axis=z]"),
            ("oak_planks", "oak", "stone_bricks", "stone_bricks"),
            ("oak_slab[type=top]", "oak_planks", "quartz", "quartz_slab[type=top]"),
            (
                "stone_brick_wall[up=false]",
                "stone_bricks",
                "deepslate_bricks",
                "deepslate_brick_wall[up=false]",
            ),
            ("cracked_stone_bricks", "stone_bricks", "deepslate_bricks", "cracked_deepslate_bricks"),
            ("stone_button[face=floor]", "stone", "oak", "oak_button[face=floor]"),
            ("light_blue_bed[part=head]", "light_blue", "red", "red_bed[part=head]"),
            ("dark_oak_leaves[persistent=true]", "dark_oak", "oak", "oak_leaves[persistent=true]"),
        ];
        for (text, from, to, expected) in cases {
            assert_eq!(of(text, from, to).as_deref(), Some(expected), "{text}");
        }
    }

    #[test]
    fn other_materials_are_left_alone() {
        let cases = [
            ("dark_oak_planks", "oak", "spruce"),
            ("pale_oak_wall_sign", "oak", "spruce"),
            ("stone_brick_stairs", "stone", "andesite"),
            ("cobblestone", "stone", "andesite"),
            ("light_blue_wool", "blue", "red"),
            ("oak_boat", "oak", "spruce"),
            ("oak_fence", "oak", "stone"),
            ("mod:oak_planks", "oak", "spruce"),
            ("oak_planks", "oak", "nonsense"),
        ];
        for (text, from, to) in cases {
            assert_eq!(of(text, from, to), None, "{text}");
        }
    }

    /// The woods that have every part that oak has.
    const WOODS: [&str; 7] = ["spruce", "birch", "jungle", "acacia", "dark_oak", "pale_oak", "cherry"];

    #[test]
    fn all_of_a_wood_goes_to_another_wood_and_back() {
        let oak = |name: &str| around(name, "oak").is_some() && name != "petrified_oak_slab";
        let states: Vec<BlockState> =
            all().iter().filter(|known| oak(known.name())).map(|known| known.default_state()).collect();
        assert!(states.len() > 20, "{states:?}");
        for (state, wood) in states.iter().flat_map(|state| WOODS.map(|wood| (state, wood))) {
            let there = counterpart(state, "oak", wood).unwrap_or_else(|| panic!("{state} of {wood}"));
            assert_eq!(counterpart(&there, wood, "oak").as_ref(), Some(state));
        }
    }
}
