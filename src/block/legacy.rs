use super::BlockState;
use std::collections::BTreeMap;
use std::sync::OnceLock;

/// The game version whose block names the table speaks: 1.20.4. It is the first with all of them.
pub const LEGACY_DATA_VERSION: i32 = 3700;

/// The dyes, in the order of the data values of wool.
pub const DYES: [&str; 16] = [
    "white",
    "orange",
    "magenta",
    "light_blue",
    "yellow",
    "lime",
    "pink",
    "gray",
    "light_gray",
    "cyan",
    "purple",
    "blue",
    "brown",
    "green",
    "red",
    "black",
];

/// The state of a numeric id of Minecraft 1.12 with its data (0 to 15), without the properties that depend on
/// its neighbours; `None` where the game has no such block.
pub fn legacy_state(id: u8, data: u8) -> Option<&'static BlockState> {
    let of_id = &table().states[usize::from(id) * DATA..][..DATA];
    of_id.get(usize::from(data))?.as_ref()
}

/// The numeric id of a block by its name in Minecraft 1.12, which may carry the game's namespace.
pub fn legacy_id(name: &str) -> Option<u8> {
    table().ids.get(name.strip_prefix("minecraft:").unwrap_or(name)).copied()
}

/// Data values of an id.
const DATA: usize = 16;

struct Table {
    /// By id times 16 plus data.
    states: Vec<Option<BlockState>>,
    ids: BTreeMap<&'static str, u8>,
}

fn table() -> &'static Table {
    static TABLE: OnceLock<Table> = OnceLock::new();
    TABLE.get_or_init(|| parse(include_str!("legacy.txt")))
}

/// The words of a reading by its name.
type Readings = BTreeMap<&'static str, &'static str>;

fn parse(text: &'static str) -> Table {
    let lines = || text.lines().filter(|line| !line.is_empty() && !line.starts_with('#'));
    let readings: Readings = lines().filter_map(|line| line.split_once(": ")).collect();
    let mut table = Table { states: vec![None; 256 * DATA], ids: BTreeMap::new() };
    for line in lines().filter(|line| line.starts_with(|c: char| c.is_ascii_digit())) {
        let mut words = line.split(' ');
        let Some((id, from)) = words.next().and_then(id_and_data) else { continue };
        if from == 0 {
            table.ids.extend(words.next().map(|name| (name, id)));
        }
        let fields = fields(words, &readings);
        let start = usize::from(id) * DATA;
        for data in from..DATA {
            table.states[start + data] = state(&fields, data);
        }
    }
    table
}

/// Reads `17` or `17:12`.
fn id_and_data(word: &str) -> Option<(u8, usize)> {
    let (id, data) = word.split_once(':').unwrap_or((word, "0"));
    Some((id.parse().ok()?, data.parse().ok()?))
}

/// What some bits of the data say.
struct Field {
    /// `None` where they say nothing; `name` for the name of the block.
    key: Option<&'static str>,
    mask: usize,
    values: Vec<String>,
}

const NAME: &str = "name";

/// The fields of a block: its names come first, where they are not one of the fields.
fn fields(mut words: std::str::Split<'static, char>, readings: &Readings) -> Vec<Field> {
    let mut fields = Vec::new();
    let names = words.next().unwrap_or_default();
    match is_field(names) {
        true => fields.push(field(names)),
        false => fields.push(name(names)),
    }
    words.for_each(|word| push(&mut fields, word, readings));
    fields
}

fn is_field(word: &str) -> bool {
    word.contains(['=', '&'])
}

/// Adds the field that `word` is, or those of the reading that it names.
fn push(fields: &mut Vec<Field>, word: &'static str, readings: &Readings) {
    match readings.get(word) {
        Some(words) => words.split(' ').for_each(|word| push(fields, word, readings)),
        None => fields.push(field(word)),
    }
}

/// Reads `key&mask=value|value`, `key=value` or `&mask`.
fn field(word: &'static str) -> Field {
    let (left, values) = word.split_once('=').unwrap_or((word, ""));
    let (key, mask) = left.split_once('&').unwrap_or((left, "0"));
    Field {
        key: (!key.is_empty()).then_some(key),
        mask: mask.parse().unwrap_or(0),
        values: values.split('|').map(str::to_owned).collect(),
    }
}

/// Reads `oak_log|spruce_log`: the low bits of the data choose.
fn name(names: &str) -> Field {
    let values: Vec<String> = match names.split_once("{colour}") {
        Some((before, after)) => DYES.map(|dye| format!("{before}{dye}{after}")).to_vec(),
        None => names.split('|').map(str::to_owned).collect(),
    };
    Field { key: Some(NAME), mask: values.len().next_power_of_two() - 1, values }
}

impl Field {
    /// What the field says of `data`.
    fn value(&self, data: usize) -> Option<&str> {
        let at = (data & self.mask) >> self.mask.trailing_zeros().min(usize::BITS - 1);
        self.values.get(at).map(String::as_str).filter(|value| *value != "-")
    }
}

/// The state that the fields make of `data`; `None` where they have no value for it, or bits are left that none reads.
fn state(fields: &[Field], data: usize) -> Option<BlockState> {
    let read = fields.iter().fold(0, |bits, field| bits | field.mask);
    if data & !read != 0 {
        return None;
    }
    let name = fields.iter().find(|field| field.key == Some(NAME))?.value(data)?;
    let properties = fields.iter().filter_map(|field| Some((field.key.filter(|&key| key != NAME)?, field)));
    properties
        .map(|(key, field)| Some((key, field.value(data)?)))
        .try_fold(BlockState::new(name).ok()?, |state, property| property.map(|(k, v)| state.with(k, v)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::block::{check, known};

    fn short(id: u8, data: u8) -> Option<String> {
        legacy_state(id, data).map(BlockState::short)
    }

    #[test]
    fn every_state_of_the_table_is_legal() {
        let states: Vec<&BlockState> = table().states.iter().flatten().collect();
        for state in &states {
            assert!(known(state.name()).is_some(), "{state}");
            assert_eq!(check(state), Ok(()), "{state}");
        }
        assert!(states.len() > 1500, "{}", states.len());
    }

    #[test]
    fn every_id_has_a_name_and_a_block_for_data_of_0() {
        for id in (0..=252).chain([255]) {
            assert!(legacy_state(id, 0).is_some(), "{id}");
            assert!(table().ids.values().any(|&named| named == id), "{id}");
        }
        assert_eq!(table().ids.len(), 254);
        assert_eq!([short(253, 0), short(254, 0)], [None, None]);
    }

    #[test]
    fn data_are_read_bit_by_bit() {
        for (id, data, expected) in [
            (17, 13, "spruce_wood[axis=y]"),
            (162, 5, "dark_oak_log[axis=x]"),
            (43, 9, "smooth_sandstone"),
            (44, 11, "cobblestone_slab[type=top]"),
            (53, 7, "oak_stairs[facing=north,half=top]"),
            (64, 1, "oak_door[facing=south,half=lower,open=false]"),
            (64, 9, "oak_door[half=upper,hinge=right,powered=false]"),
            (50, 5, "torch"),
            (76, 4, "redstone_wall_torch[facing=north,lit=true]"),
            (69, 14, "lever[face=floor,facing=west,powered=true]"),
            (95, 8, "light_gray_stained_glass"),
            (99, 3, "brown_mushroom_block[down=false,east=true,north=true,south=false,up=true,west=false]"),
            (100, 15, "mushroom_stem[down=true,east=true,north=true,south=true,up=true,west=true]"),
            (118, 0, "cauldron"),
            (118, 2, "water_cauldron[level=2]"),
            (145, 6, "chipped_anvil[facing=north]"),
            (144, 11, "skeleton_wall_skull[facing=south]"),
            (155, 3, "quartz_pillar[axis=x]"),
        ] {
            assert_eq!(short(id, data).as_deref(), Some(expected), "{id}:{data}");
        }
    }

    #[test]
    fn data_that_do_not_occur_have_no_state() {
        for (id, data) in [(1, 7), (4, 1), (5, 6), (35, 16), (99, 12), (43, 16), (154, 1), (162, 2)] {
            assert_eq!(short(id, data), None, "{id}:{data}");
        }
    }

    #[test]
    fn ids_are_known_by_their_old_names() {
        assert_eq!(legacy_id("minecraft:grass"), Some(2));
        assert_eq!(legacy_id("planks"), Some(5));
        assert_eq!(legacy_id("oak_planks"), None);
    }
}
