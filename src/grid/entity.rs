//! How animals, paintings and item frames go along when a build is moved.

use super::Entity;
use crate::block::{Facing, Motion};
use crate::nbt::{Compound, Tag};
use crate::space::Cell;
use glam::{DVec3, I64Vec3};

impl Entity {
    /// The cell that it belongs to: the one it hangs in, or else the one that it is in.
    pub fn home(&self) -> Cell {
        self.block.unwrap_or_else(|| self.seat())
    }

    /// The cell that it belongs to by where it is. A painting's middle may lie on the line between two cells.
    pub fn seat(&self) -> Cell {
        let place = DVec3::from_array(self.place);
        let middle = match is_painting(&self.data).then(|| facing(&self.data, self.place)).flatten() {
            Some(facing) => place - overhang(place, facing),
            None => place,
        };
        middle.floor().as_ivec3()
    }
}

/// How far a painting's middle lies from the middle of its home cell, along the wall and upwards: paintings of even
/// width reach one cell further to the left of where they look, those of even height one cell further up.
fn overhang(place: DVec3, facing: Facing) -> DVec3 {
    let left = facing.left().step().as_dvec3();
    let along = (place * left.abs()).element_sum();
    [(along, left), (place.y, DVec3::Y)]
        .into_iter()
        .filter(|(at, _)| is_between_cells(*at))
        .map(|(_, step)| step / 2.0)
        .sum()
}

fn is_between_cells(at: f64) -> bool {
    (at - at.round()).abs() < 0.25
}

/// The entity in a build that is moved; `corner` is where the low corner of the build goes about the origin.
pub(super) fn moved(entity: &Entity, motion: Motion, corner: Cell) -> Entity {
    let middle = (DVec3::from_array(entity.place) - 0.5).to_array();
    let place = DVec3::from_array(motion.apply(middle)) + 0.5 - corner.as_dvec3();
    let data = moved_data(&entity.data, entity.place, motion);
    let mut moved = Entity { place: place.to_array(), block: None, data };
    moved.block = entity.block.map(|block| moved.seat().wrapping_add(off_seat(entity, block, motion)));
    moved
}

/// How far the block of a moved entity lies from its seat, which a mirror changes for paintings of even width. Mostly it is
/// there; before 1.8 paintings named the block behind them.
fn off_seat(old: &Entity, block: Cell, motion: Motion) -> Cell {
    let off = block.as_i64vec3() - old.seat().as_i64vec3();
    I64Vec3::from_array(motion.apply(off.to_array())).as_ivec3()
}

/// The entity as seen from another low corner.
pub(super) fn shifted(entity: &Entity, by: Cell) -> Entity {
    let place = DVec3::from_array(entity.place) + by.as_dvec3();
    let block = entity.block.map(|block| block.wrapping_add(by));
    Entity { place: place.to_array(), block, data: entity.data.clone() }
}

fn moved_data(data: &Compound, place: [f64; 3], motion: Motion) -> Compound {
    let each = data.iter().map(|(name, tag)| {
        let moved = match (name.as_str(), tag) {
            ("Rotation", Tag::List(angles)) => Tag::List(moved_angles(angles, motion)),
            ("Motion" | "power", Tag::List(vector)) => Tag::List(moved_vector(vector, motion)),
            ("Passengers", Tag::List(riders)) => Tag::List(moved_riders(riders, place, motion)),
            (key, Tag::Byte(number)) => Tag::Byte(moved_side(data, place, key, *number, motion)),
            _ => tag.clone(),
        };
        (name.clone(), moved)
    });
    each.collect()
}

fn moved_riders(riders: &[Tag], place: [f64; 3], motion: Motion) -> Vec<Tag> {
    let rider = |tag: &Tag| match tag {
        Tag::Compound(data) => Tag::Compound(moved_data(data, place, motion)),
        other => other.clone(),
    };
    riders.iter().map(rider).collect()
}

/// Yaw and pitch, of which only the yaw turns.
fn moved_angles(angles: &[Tag], motion: Motion) -> Vec<Tag> {
    let mut angles = angles.to_vec();
    if let Some(Tag::Float(yaw)) = angles.first_mut() {
        *yaw = half_circle(motion.angle(f64::from(*yaw))) as f32;
    }
    angles
}

/// The same angle from -180 up to 180.
fn half_circle(degrees: f64) -> f64 {
    (degrees + 180.0).rem_euclid(360.0) - 180.0
}

fn moved_vector(vector: &[Tag], motion: Motion) -> Vec<Tag> {
    match vector {
        [Tag::Double(x), Tag::Double(y), Tag::Double(z)] => {
            motion.apply([*x, *y, *z]).map(|n| Tag::Double(n + 0.0)).to_vec()
        }
        other => other.to_vec(),
    }
}

/// The orders in which numbers of sides have been counted.
type Order = &'static [Facing];

const BLOCK_SIDES: Order =
    &[Facing::Down, Facing::Up, Facing::North, Facing::South, Facing::West, Facing::East];
const WALL_SIDES: Order = &[Facing::South, Facing::West, Facing::North, Facing::East];
const OLD_WALL_SIDES: Order = &[Facing::North, Facing::West, Facing::South, Facing::East];

fn moved_side(data: &Compound, place: [f64; 3], key: &str, number: i8, motion: Motion) -> i8 {
    let Some(order) = order(data, place, key) else { return number };
    let side = side(order, number).map(|side| motion.facing(side));
    let moved = side.and_then(|side| order.iter().position(|other| *other == side));
    moved.map_or(number, |at| at as i8)
}

/// In which order the sides are counted under `key`; `None` where it holds no side.
fn order(data: &Compound, place: [f64; 3], key: &str) -> Option<Order> {
    match key {
        "Facing" | "facing" if is_frame(data) => Some(frame_order(data, place)),
        "Direction" if is_frame(data) => Some(WALL_SIDES),
        "Facing" | "facing" | "Direction" if is_painting(data) => Some(WALL_SIDES),
        "Dir" if is_painting(data) || is_frame(data) => Some(OLD_WALL_SIDES),
        "AttachFace" => Some(BLOCK_SIDES),
        _ => None,
    }
}

/// Before 1.13 item frames hung on walls only, and counted like paintings. Where one hangs tells which it is.
fn frame_order(data: &Compound, place: [f64; 3]) -> Order {
    let number = ["Facing", "facing"].into_iter().find_map(|key| byte(data, key));
    let fits = |order: &&Order| number.and_then(|number| side(order, number)) == wall_behind(place);
    [BLOCK_SIDES, WALL_SIDES].iter().find(fits).copied().unwrap_or(BLOCK_SIDES)
}

/// Where something flat looks: away from the side of its cell that it lies close to.
fn wall_behind(place: [f64; 3]) -> Option<Facing> {
    let middle = DVec3::from_array(place).fract_gl() - 0.5;
    Facing::ALL.into_iter().find(|facing| middle.dot(facing.step().as_dvec3()) < -0.4)
}

/// Where an entity looks that hangs on a wall.
fn facing(data: &Compound, place: [f64; 3]) -> Option<Facing> {
    let keys = ["facing", "Facing", "Direction", "Dir"];
    keys.into_iter().find_map(|key| side(order(data, place, key)?, byte(data, key)?))
}

fn side(order: Order, number: i8) -> Option<Facing> {
    order.get(usize::try_from(number).ok()?).copied()
}

fn byte(data: &Compound, key: &str) -> Option<i8> {
    match data.get(key) {
        Some(Tag::Byte(number)) => Some(*number),
        _ => None,
    }
}

/// `minecraft:item_frame`, `minecraft:glow_item_frame`, once `ItemFrame`.
fn is_frame(data: &Compound) -> bool {
    id(data).is_some_and(|id| id.ends_with("item_frame") || id == "ItemFrame")
}

/// `minecraft:painting`, once `Painting`.
fn is_painting(data: &Compound) -> bool {
    id(data).is_some_and(|id| id.ends_with("painting") || id == "Painting")
}

fn id(data: &Compound) -> Option<&str> {
    match data.get("id") {
        Some(Tag::String(id)) => Some(id),
        _ => None,
    }
}
