//! Block entities. What Java Edition holds in the state moves there, and signs keep their words. The rest stays as
//! Bedrock Edition writes it, under the id that Java Edition has for it.

use crate::block::{BlockState, Facing};
use crate::grid::Grid;
use crate::io::fields::{Fields, FromTag};
use crate::io::{ReadError, kinds, text, volume};
use crate::nbt::{Compound, Tag};
use crate::space::Cell;

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

/// Puts the block entities into `grid`. How many lie outside, and how many stay in Bedrock's form.
pub(super) fn read(default: &Fields, grid: &mut Grid) -> Result<(usize, usize), ReadError> {
    let (mut outside, mut foreign) = (0, 0);
    let Some(places) = default.inner("block_position_data")? else { return Ok((0, 0)) };
    for key in places.tags.keys() {
        let Some(fields) =
            places.inner(key)?.map(|data| data.inner("block_entity_data")).transpose()?.flatten()
        else {
            continue;
        };
        let Some(place) = key.parse().ok().and_then(|index| cell_at(index, grid.size())) else {
            outside += 1;
            continue;
        };
        foreign += usize::from(put(grid, place, &fields)?);
    }
    Ok((outside, foreign))
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

/// Since Bedrock 1.20 each side has a compound of its own.
fn sign(data: &mut Compound) {
    let side = |name: &str| match data.get(name) {
        Some(Tag::Compound(side)) => string(side, "Text"),
        _ => None,
    };
    let front = side("FrontText").or_else(|| string(data, "Text")).unwrap_or_default();
    let back = side("BackText").unwrap_or_default();
    data.clear();
    text::set_sign(data, text::plain_lines(&front), text::plain_lines(&back));
}

fn string(data: &Compound, name: &str) -> Option<String> {
    match data.get(name) {
        Some(Tag::String(text)) => Some(text.clone()),
        _ => None,
    }
}
