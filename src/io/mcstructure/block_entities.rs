//! Block entities. What Java Edition holds in the state moves there, and signs keep their words. The rest stays as
//! Bedrock Edition writes it, under the id that Java Edition has for it.

use crate::block::{BlockState, Facing};
use crate::grid::Grid;
use crate::io::fields::{Fields, FromTag};
use crate::io::{ReadError, kinds, text, volume};
use crate::nbt::{Compound, Tag};
use crate::space::Cell;
use std::collections::BTreeSet;

/// Ids that are not the Java ones in another spelling.
const IDS: [(&str, &str); 5] = [
    ("EnchantTable", "enchanting_table"),
    ("JigsawBlock", "jigsaw"),
    ("PistonArm", "piston"),
    ("RecordPlayer", "jukebox"),
    ("ChiseledBookshelf", "chiseled_bookshelf"),
];

/// Bedrock Edition's own tags of every block entity.
const PLACE: [&str; 4] = ["x", "y", "z", "isMovable"];

/// The data of a place that vox reads or counts.
const KNOWN: [&str; 2] = ["block_entity_data", "tick_queue_data"];

/// What of the data of places does not come into the grid as it is.
#[derive(Default)]
pub(super) struct Found {
    /// Block entities outside of the structure.
    pub outside: usize,
    /// Block entities that stay in Bedrock's form.
    pub foreign: usize,
    /// Ticks that blocks wait for.
    pub ticks: usize,
    /// Tags that nothing is known of, whatever their place.
    pub unknown: BTreeSet<String>,
}

/// Puts the block entities into `grid`.
pub(super) fn read(default: &Fields, grid: &mut Grid) -> Result<Found, ReadError> {
    let mut found = Found::default();
    let Some(places) = default.inner("block_position_data")? else { return Ok(found) };
    for key in places.tags.keys() {
        let Some(data) = places.inner(key)? else { continue };
        let unknown = data.tags.keys().filter(|name| !KNOWN.contains(&name.as_str()));
        found.unknown.extend(unknown.map(|name| places.path(&format!("<cell>.{name}"))));
        found.ticks += data.list("tick_queue_data")?.len();
        let Some(fields) = data.inner("block_entity_data")? else { continue };
        match key.parse().ok().and_then(|index| cell_at(index, grid.size())) {
            Some(place) => found.foreign += usize::from(put(grid, place, &fields)?),
            None => found.outside += 1,
        }
    }
    Ok(found)
}

/// The place of the cell `index` in the order of the file: z fastest, then y, then x.
fn cell_at(index: usize, size: Cell) -> Option<Cell> {
    let [width, height, length] = size.to_array().map(|n| n as usize);
    let cell = [index / length / height, index / length % height, index % length];
    (cell[0] < width).then(|| Cell::from_array(cell.map(|n| n as i32)))
}

/// Whether the block entity stays in Bedrock's form.
fn put(grid: &mut Grid, place: Cell, fields: &Fields) -> Result<bool, ReadError> {
    let old = grid.get(place).clone();
    let kind = kind(fields.find::<&str>("id")?.unwrap_or_default(), &old);
    let mut data = fields.tags.clone();
    data.retain(|name, _| !PLACE.contains(&name.as_str()));
    let (state, whole) = understood(&old, &kind, &mut data);
    let id = grid.intern(&state).map_err(volume::full("block_position_data"))?;
    grid.set(place, id);
    if !["flower_pot", "music"].contains(&kind.as_str()) {
        data.insert("id".to_owned(), Tag::String(format!("minecraft:{kind}")));
        grid.block_entities.insert(place.to_array(), data);
    }
    Ok(!whole)
}

/// The id in Java's spelling, without its namespace: `ShulkerBox` is `shulker_box`.
fn kind(id: &str, state: &BlockState) -> String {
    let known = IDS.iter().find(|(bedrock, _)| *bedrock == id).map(|(_, java)| (*java).to_owned());
    match known.unwrap_or_else(|| snake_case(id)).as_str() {
        "chest" if state.short_name() == "trapped_chest" => "trapped_chest".to_owned(),
        kind => kind.to_owned(),
    }
}

fn snake_case(id: &str) -> String {
    let mut snake = String::new();
    for c in id.chars() {
        if c.is_ascii_uppercase() && !snake.is_empty() {
            snake.push('_');
        }
        snake.push(c.to_ascii_lowercase());
    }
    snake
}

/// The state with what the data say of it, and whether nothing is left in the data that only Bedrock Edition knows.
fn understood(state: &BlockState, kind: &str, data: &mut Compound) -> (BlockState, bool) {
    let state = match kind {
        "bed" => kinds::bed(state, take(data, "color").unwrap_or(0)),
        "banner" => kinds::banner(state, take(data, "Base").unwrap_or(0)),
        "skull" => kinds::skull(state, take(data, "SkullType").unwrap_or(0), sixteenths(data)),
        "flower_pot" => kinds::pot(state, plant(data).unwrap_or_default()),
        "music" => kinds::note_block(state, take(data, "note").unwrap_or(0)),
        "shulker_box" => facing_box(state, take(data, "facing").unwrap_or(1)),
        _ => state.clone(),
    };
    let whole = match kind {
        "bed" | "skull" | "flower_pot" | "music" => true,
        "banner" => !has_entries(data, "Patterns"),
        "shulker_box" => !has_entries(data, "Items"),
        "sign" | "hanging_sign" => {
            sign(data);
            return (state, true);
        }
        _ => data.keys().all(|name| name == "id"),
    };
    if whole {
        data.clear();
    }
    (state, whole)
}

fn has_entries(data: &Compound, list: &str) -> bool {
    matches!(data.get(list), Some(Tag::List(entries)) if !entries.is_empty())
}

fn take(data: &mut Compound, name: &str) -> Option<usize> {
    data.remove(name).and_then(|tag| usize::try_from(i32::from_tag(&tag)?).ok())
}

/// How a skull is turned. Degrees count clockwise from the south, as Java Edition's sixteenths do.
fn sixteenths(data: &mut Compound) -> usize {
    match data.get("Rotation") {
        Some(Tag::Float(degrees)) if degrees.is_finite() => {
            (degrees.rem_euclid(360.0) / 22.5).round() as usize % 16
        }
        _ => take(data, "Rot").unwrap_or(0),
    }
}

/// The name of the block in a pot.
fn plant(data: &Compound) -> Option<&str> {
    match data.get("PlantBlock") {
        Some(Tag::Compound(plant)) => match plant.get("name") {
            Some(Tag::String(name)) => Some(name.strip_prefix("minecraft:").unwrap_or(name)),
            _ => None,
        },
        _ => None,
    }
}

fn facing_box(state: &BlockState, facing: usize) -> BlockState {
    const ORDER: [Facing; 6] =
        [Facing::Down, Facing::Up, Facing::North, Facing::South, Facing::West, Facing::East];
    match ORDER.get(facing).filter(|_| state.short_name().ends_with("shulker_box")) {
        Some(facing) => state.clone().with("facing", facing.name()),
        None => state.clone(),
    }
}

/// Since Bedrock 1.20 each side has a compound of its own; before there is one side, in the sign itself.
fn sign(data: &mut Compound) {
    let side = |name: &str| match data.get(name) {
        Some(Tag::Compound(side)) => Some(side),
        _ => None,
    };
    let front = written(side("FrontText").unwrap_or(data));
    let back = side("BackText").map(written).unwrap_or_default();
    let waxed = matches!(data.get("IsWaxed"), Some(Tag::Byte(1..)));
    data.clear();
    text::set_sides(data, front, back);
    data.insert("is_waxed".to_owned(), Tag::Byte(i8::from(waxed)));
}

/// What stands on one side of a sign.
fn written(side: &Compound) -> text::Side {
    text::Side {
        lines: text::plain_lines(&string(side, "Text").unwrap_or_default()),
        color: color(side).unwrap_or("black"),
        glows: matches!(side.get("IgnoreLighting"), Some(Tag::Byte(1..))),
    }
}

/// The dye that the game's colour of a text, as 0xAARRGGBB, is nearest to.
fn color(side: &Compound) -> Option<&'static str> {
    let Some(Tag::Int(argb)) = side.get("SignTextColor") else { return None };
    let channels = |rgb: i32| [16, 8, 0].map(|shift| (rgb >> shift) & 0xff);
    let apart = |rgb: i32| -> i32 {
        channels(rgb).iter().zip(channels(*argb)).map(|(own, other)| (own - other).pow(2)).sum()
    };
    TEXT_COLORS.iter().min_by_key(|(_, rgb)| apart(*rgb)).map(|(name, _)| *name)
}

/// The colours of texts on signs, by the dye they are made with.
const TEXT_COLORS: [(&str, i32); 16] = [
    ("black", 0x000000),
    ("white", 0xf0f0f0),
    ("orange", 0xf9801d),
    ("magenta", 0xc74ebd),
    ("light_blue", 0x3ab3da),
    ("yellow", 0xfed83d),
    ("lime", 0x80c71f),
    ("pink", 0xf38baa),
    ("gray", 0x474f52),
    ("light_gray", 0x9d9d97),
    ("cyan", 0x169c9c),
    ("purple", 0x8932b8),
    ("blue", 0x3c44aa),
    ("brown", 0x835432),
    ("green", 0x5e7c16),
    ("red", 0xb02e26),
];

fn string(data: &Compound, name: &str) -> Option<String> {
    match data.get(name) {
        Some(Tag::String(text)) => Some(text.clone()),
        _ => None,
    }
}
