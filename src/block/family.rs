use super::{BlockState, Shape, known, shape};

/// The blocks of one material: the full block and what is cut from it. States are written out in full.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Family {
    pub full: BlockState,
    pub stairs: Option<BlockState>,
    pub slab: Option<BlockState>,
    pub wall: Option<BlockState>,
    pub fence: Option<BlockState>,
    pub fence_gate: Option<BlockState>,
    pub door: Option<BlockState>,
    pub trapdoor: Option<BlockState>,
    pub log: Option<BlockState>,
}

/// What the name of a member adds to the name of its material, longest first.
const MEMBERS: [&str; 11] = [
    "_fence_gate",
    "_trapdoor",
    "_planks",
    "_stairs",
    "_fence",
    "_block",
    "_slab",
    "_wall",
    "_door",
    "_stem",
    "_log",
];

impl Family {
    /// The family of a member (`oak_planks`, `stone_brick_stairs`) or of a material (`oak`, `quartz`).
    /// A full block that nothing is cut from is a family of its own; `None` where no full block is found.
    pub fn of(name: &str) -> Option<Family> {
        let name = name.strip_prefix("minecraft:").unwrap_or(name);
        let families = materials(name).filter_map(Family::of_material);
        let mut families = families.filter(|family| family.holds(name));
        families.next().or_else(|| Family::alone(name))
    }

    pub(super) fn of_material(material: &str) -> Option<Family> {
        let find = |suffix: &str| known(&format!("{material}{suffix}"));
        let member = |suffix: &str| Some(find(suffix)?.default_state());
        let planks = member("_planks");
        let wooden = planks.is_some();
        // Stone has its bricks and tiles in the plural, metals and quartz come as blocks.
        let full = planks.or_else(|| ["s", "_block", ""].into_iter().find_map(member).filter(is_full))?;
        let log = || ["_log", "_stem", "_block"].into_iter().find_map(member);
        Some(Family {
            full,
            stairs: member("_stairs"),
            slab: member("_slab"),
            wall: member("_wall"),
            fence: member("_fence"),
            fence_gate: member("_fence_gate"),
            door: member("_door"),
            trapdoor: member("_trapdoor"),
            log: if wooden { log() } else { None },
        })
    }

    fn alone(name: &str) -> Option<Family> {
        let full = known(name)?.default_state();
        let (stairs, slab, wall, fence) = (None, None, None, None);
        let (fence_gate, door, trapdoor, log) = (None, None, None, None);
        is_full(&full).then_some(Family { full, stairs, slab, wall, fence, fence_gate, door, trapdoor, log })
    }

    /// All members there are, the full block first.
    pub fn members(&self) -> impl Iterator<Item = &BlockState> {
        self.roles().into_iter().flatten()
    }

    /// The members in the order of the fields.
    pub(super) fn roles(&self) -> [Option<&BlockState>; 9] {
        let Family { full, stairs, slab, wall, fence, fence_gate, door, trapdoor, log } = self;
        let [stairs, slab, wall, fence] = [stairs, slab, wall, fence].map(Option::as_ref);
        let [fence_gate, door, trapdoor, log] = [fence_gate, door, trapdoor, log].map(Option::as_ref);
        [Some(full), stairs, slab, wall, fence, fence_gate, door, trapdoor, log]
    }

    /// Whether `name` is a member, or no block at all but a material that something is cut from: a full block
    /// without its last letter is a slip, not a material.
    fn holds(&self, name: &str) -> bool {
        let is_material = || known(name).is_none() && self.members().nth(1).is_some();
        self.members().any(|member| member.short_name() == name) || is_material()
    }
}

fn is_full(state: &BlockState) -> bool {
    shape(state) == Shape::Full
}

/// The materials that a block of this name can be a member of.
pub(super) fn materials(name: &str) -> impl Iterator<Item = &str> {
    let suffixes = MEMBERS.into_iter().chain(["s", ""]);
    suffixes.filter_map(move |suffix| name.strip_suffix(suffix)).filter(|material| !material.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::block::all;

    fn names(name: &str) -> Vec<String> {
        let family = Family::of(name).unwrap_or_else(|| panic!("{name} has no family"));
        family.members().map(|member| member.short_name().to_owned()).collect()
    }

    #[test]
    fn families_are_found_from_materials_and_members() {
        let oak = names("oak");
        assert_eq!(oak[..3], ["oak_planks", "oak_stairs", "oak_slab"]);
        assert_eq!(oak.len(), 8, "{oak:?}");
        for name in ["oak_planks", "oak_stairs", "oak_door", "minecraft:oak_fence_gate", "oak_log"] {
            assert_eq!(names(name), oak);
        }
        let cases = [
            ("stone", "stone", "stone_stairs"),
            ("stone_bricks", "stone_bricks", "stone_brick_stairs"),
            ("stone_brick_wall", "stone_bricks", "stone_brick_stairs"),
            ("deepslate_tiles", "deepslate_tiles", "deepslate_tile_stairs"),
            ("cobblestone", "cobblestone", "cobblestone_stairs"),
            ("quartz_block", "quartz_block", "quartz_stairs"),
            ("quartz", "quartz_block", "quartz_stairs"),
            ("purpur_pillar", "purpur_pillar", ""),
            ("purpur_block", "purpur_block", "purpur_stairs"),
            ("prismarine_bricks", "prismarine_bricks", "prismarine_brick_stairs"),
            ("prismarine", "prismarine", "prismarine_stairs"),
            ("sandstone", "sandstone", "sandstone_stairs"),
            ("bricks", "bricks", "brick_stairs"),
            ("crimson_stem", "crimson_planks", "crimson_stairs"),
            ("bamboo_block", "bamboo_planks", "bamboo_stairs"),
            ("bamboo_mosaic", "bamboo_mosaic", "bamboo_mosaic_stairs"),
            ("white_wool", "white_wool", ""),
        ];
        for (name, full, stairs) in cases {
            let found = names(name);
            assert_eq!(found[0], full, "{name}");
            assert_eq!(found.get(1).map_or("", String::as_str), stairs, "{name}");
        }
    }

    #[test]
    fn all_stairs_belong_to_a_full_block() {
        for stairs in all().iter().filter(|known| known.name().ends_with("_stairs")) {
            let family = Family::of(stairs.name()).unwrap_or_else(|| panic!("{}", stairs.name()));
            assert_eq!(family.stairs, Some(stairs.default_state()));
            assert_eq!(Family::of(family.full.name()), Some(family));
        }
    }

    #[test]
    fn what_is_neither_material_nor_solid_has_no_family() {
        for name in ["poppy", "torch", "mod:planks", "nonsense", "glas", "oak_plank", "oak_stair", ""] {
            assert_eq!(Family::of(name), None, "{name}");
        }
    }
}
