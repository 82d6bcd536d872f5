//! Primitives: what a name and a material put into a scope.

use super::Library;
use super::derive::Placement;
use super::error::Kind;
use super::place::Place;
use super::settings;
use super::{roof, solid};
use crate::block::{self, BlockState, Facing, Family, Shape};
use crate::grammar::{is_mesh, is_primitive};
use crate::graph::Thing;
use crate::grid::Grid;
use crate::space::{Axis, Bounds, Cell, Scope, Turn};
use glam::Vec3Swizzles;
use rustc_hash::FxHashMap;

/// What a primitive is made of and how it fills its scope.
pub enum Brush<'l> {
    /// One block state everywhere.
    Fill(BlockState),
    /// A block by weight for each cell; the weights are sums up to each.
    Mix(Vec<(f64, BlockState)>),
    /// Blocks that pass into one another along an axis of the scope.
    Gradient(Axis, Vec<BlockState>),
    Roof(roof::Kind, Box<Family>),
    Solid(solid::Kind, Box<Family>),
    /// Doors side by side.
    Door(BlockState),
    /// A schematic file.
    Stamp(&'l Grid),
}

/// The brushes of one run, made at their first use.
pub struct Brushes<'l, 'g> {
    library: &'l Library,
    brushes: Vec<Brush<'l>>,
    known: FxHashMap<(&'g Thing, Option<&'g Thing>), usize>,
    /// Palette numbers of filled blocks, by brush and turn.
    fills: FxHashMap<(usize, Turn), u16>,
    /// From which the cells of mixes draw.
    place: Place,
}

impl<'l, 'g> Brushes<'l, 'g> {
    pub fn new(library: &'l Library, seed: u64) -> Brushes<'l, 'g> {
        let (known, fills) = (FxHashMap::default(), FxHashMap::default());
        Brushes { library, brushes: Vec::new(), known, fills, place: Place::start(seed).named("mix") }
    }

    /// Puts a primitive into the grid. Its scope lies inside; what reaches out of it is cut off at the grid's ends.
    pub fn place(&mut self, grid: &mut Grid, placement: &Placement<'g>) -> Result<(), Kind> {
        let number = self.number(placement.name, placement.material)?;
        let scope = &placement.scope;
        let footprint = placement.footprint.as_deref();
        if !matches!(self.brushes[number], Brush::Roof(..) | Brush::Solid(..)) {
            settings::none(&placement.options)?;
        }
        match &self.brushes[number] {
            Brush::Fill(state) => {
                let turn = scope.frame.turn;
                let id = match self.fills.get(&(number, turn)) {
                    Some(&id) => id,
                    None => {
                        let id = intern(grid, &state.turned(turn))?;
                        self.fills.insert((number, turn), id);
                        id
                    }
                };
                match footprint {
                    None => grid.fill(scope.bounds, id),
                    Some(_) => boxes(placement).for_each(|bounds| grid.fill(bounds, id)),
                }
                Ok(())
            }
            Brush::Mix(parts) => {
                let ids = interned(grid, parts.iter().map(|(_, state)| state), scope)?;
                let total = parts.last().map_or(0.0, |(sum, _)| *sum);
                for cell in boxes(placement).flat_map(Bounds::cells) {
                    let draw = noise(self.place, cell) * total;
                    grid.set(cell, ids[parts.partition_point(|(sum, _)| *sum <= draw).min(ids.len() - 1)]);
                }
                Ok(())
            }
            Brush::Gradient(axis, blocks) => {
                let ids = interned(grid, blocks.iter(), scope)?;
                for cell in boxes(placement).flat_map(Bounds::cells) {
                    let step = (ids.len() - 1) as f64 * scope.along(*axis, cell) + noise(self.place, cell);
                    grid.set(cell, ids[(step as usize).min(ids.len() - 1)]);
                }
                Ok(())
            }
            Brush::Roof(kind, family) => {
                let options = settings::settings(&placement.options)?;
                put_all(grid, |put| roof::build(*kind, family, &options, (scope, footprint), put))
            }
            Brush::Solid(kind, family) => {
                let options = settings::settings(&placement.options)?;
                put_all(grid, |put| solid::build(*kind, family, &options, (scope, footprint), put))
            }
            Brush::Door(door) => build_door(grid, door, placement),
            Brush::Stamp(file) => stamp(grid, file, placement),
        }
    }

    fn number(&mut self, name: &'g Thing, material: Option<&'g Thing>) -> Result<usize, Kind> {
        if let Some(&number) = self.known.get(&(name, material)) {
            return Ok(number);
        }
        let brush = Brush::of(self.library, name, material)?;
        self.brushes.push(brush);
        self.known.insert((name, material), self.brushes.len() - 1);
        Ok(self.brushes.len() - 1)
    }
}

impl<'l> Brush<'l> {
    pub fn of(library: &'l Library, name: &Thing, material: Option<&Thing>) -> Result<Brush<'l>, Kind> {
        match (name, material) {
            // A mesh is no blocks: what it is made of stands for it.
            (Thing::File(file), material) if is_mesh(file) => {
                let stone = Thing::Name("smooth_stone".to_owned());
                block_of(material.unwrap_or(&stone)).map(Brush::Fill)
            }
            (Thing::File(file), _) | (_, Some(Thing::File(file))) => {
                library.get(file).map(Brush::Stamp).ok_or_else(|| Kind::NoFile(file.clone()))
            }
            (Thing::Name(name), material) if is_primitive(name) => shape_brush(name, material),
            (Thing::Mix(_) | Thing::Gradient(..), None) => blend(name),
            (thing, None) => block_of(thing).map(Brush::Fill),
            // A second argument to anything but a shape is what it is made of.
            (_, Some(material)) => block_of(material).map(Brush::Fill),
        }
    }
}

/// The boxes that a placement fills.
pub fn boxes(placement: &Placement<'_>) -> impl Iterator<Item = Bounds> + use<> {
    let bounds = placement.scope.bounds;
    let whole = placement.footprint.is_none().then_some(bounds);
    let rectangles = placement.footprint.iter().flat_map(|footprint| footprint.rectangles());
    let parts: Vec<Bounds> = rectangles.map(|rect| rect.between(bounds.min.y, bounds.max.y)).collect();
    whole.into_iter().chain(parts)
}

/// Whether a cell is in the footprint of a placement.
fn is_there(placement: &Placement<'_>, cell: Cell) -> bool {
    placement.footprint.as_ref().is_none_or(|footprint| footprint.contains(cell.xz()))
}

fn intern(grid: &mut Grid, state: &BlockState) -> Result<u16, Kind> {
    grid.intern(state).map_err(|_| Kind::PaletteFull)
}

/// A primitive of the language. Without a material it is made of something plain.
fn shape_brush<'l>(name: &str, material: Option<&Thing>) -> Result<Brush<'l>, Kind> {
    let base = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let family = |fallback| family_of(material, fallback).map(Box::new);
    if let Some(kind) = roof_named(base) {
        return Ok(Brush::Roof(kind, family("dark_oak")?));
    }
    if let Some(kind) = solid_named(base) {
        return Ok(Brush::Solid(kind, family("stone_bricks")?));
    }
    let fallback = match base {
        "door" => return door_of(material).map(Brush::Door),
        "window" => "glass",
        _ => "stone_bricks",
    };
    let fallback = Thing::Name(fallback.to_owned());
    match material.unwrap_or(&fallback) {
        blended @ (Thing::Mix(_) | Thing::Gradient(..)) => blend(blended),
        plain => block_of(plain).map(Brush::Fill),
    }
}

fn roof_named(name: &str) -> Option<roof::Kind> {
    Some(match name {
        "gable" | "roof" | "triangle" => roof::Kind::Gable,
        "right_angle_triangle" => roof::Kind::RightAngleTriangle,
        "corner" => roof::Kind::Corner,
        "trough" => roof::Kind::Trough,
        "hip" => roof::Kind::Hip,
        "pyramid" => roof::Kind::Pyramid,
        "gambrel" => roof::Kind::Gambrel,
        "mansard" => roof::Kind::Mansard,
        "crossgable" => roof::Kind::CrossGable,
        "ridge" => roof::Kind::Ridge,
        "shed" => roof::Kind::Shed,
        "cone" => roof::Kind::Cone,
        "dome" => roof::Kind::Dome,
        _ => return None,
    })
}

fn solid_named(name: &str) -> Option<solid::Kind> {
    Some(match name {
        "cylinder" => solid::Kind::Cylinder,
        "sphere" => solid::Kind::Sphere,
        "arch" => solid::Kind::Arch,
        "spiral_stair" => solid::Kind::SpiralStair,
        _ => return None,
    })
}

/// A brush of several blocks.
fn blend<'l>(thing: &Thing) -> Result<Brush<'l>, Kind> {
    Ok(match thing {
        Thing::Mix(parts) => {
            let mut sum = 0.0;
            let mut sums = Vec::with_capacity(parts.len());
            for (weight, thing) in parts {
                sum += weight.0;
                sums.push((sum, block_of(thing)?));
            }
            match sum > 0.0 {
                true => Brush::Mix(sums),
                false => return Err(Kind::Weight(sum)),
            }
        }
        Thing::Gradient(axis, parts) => {
            Brush::Gradient(*axis, parts.iter().map(block_of).collect::<Result<_, _>>()?)
        }
        thing => Brush::Fill(block_of(thing)?),
    })
}

/// A number from 0 up to 1 that a cell has in every run of one seed.
fn noise(place: Place, cell: Cell) -> f64 {
    let [x, y, z] = cell.to_array().map(|length| length as usize);
    place.child(x).child(y).child(z).number() as f64 / (1u64 << 53) as f64
}

/// The palette numbers of blocks as they are turned in a scope.
fn interned<'b>(
    grid: &mut Grid,
    blocks: impl Iterator<Item = &'b BlockState>,
    scope: &Scope,
) -> Result<Vec<u16>, Kind> {
    blocks.map(|state| intern(grid, &state.turned(scope.frame.turn))).collect()
}

pub(super) fn block_of(thing: &Thing) -> Result<BlockState, Kind> {
    thing.block().ok_or_else(|| match thing {
        Thing::Name(name) | Thing::Block(name) => Kind::NoThing(name.clone()),
        Thing::File(file) => Kind::NoFile(file.clone()),
        Thing::Mix(_) | Thing::Gradient(..) => Kind::NoThing(thing.text().to_owned()),
    })
}

fn family_of(material: Option<&Thing>, fallback: &str) -> Result<Family, Kind> {
    let name = match material {
        None => fallback.to_owned(),
        Some(Thing::Block(text)) => text.split('[').next().unwrap_or(text).to_owned(),
        Some(thing) => thing.text().to_owned(),
    };
    Family::of(&name).ok_or(Kind::NoThing(name))
}

fn door_of(material: Option<&Thing>) -> Result<BlockState, Kind> {
    let given = material.map(block_of).transpose()?;
    if let Some(door) = given.filter(|state| matches!(block::shape(state), Shape::Door(_))) {
        return Ok(door);
    }
    let family = family_of(material, "oak")?;
    family.door.ok_or_else(|| Kind::NoThing(format!("{}_door", material.map_or("oak", Thing::text))))
}

/// Puts what `build` makes into the grid, as far as it lies inside.
fn put_all(grid: &mut Grid, build: impl FnOnce(&mut dyn FnMut(Cell, &BlockState))) -> Result<(), Kind> {
    let mut ids: FxHashMap<BlockState, u16> = FxHashMap::default();
    let mut failed = None;
    let bounds = grid.bounds();
    let mut put = |cell: Cell, state: &BlockState| {
        let id = match ids.get(state) {
            Some(&id) => Ok(id),
            None => intern(grid, state).inspect(|&id| {
                let _ = ids.insert(state.clone(), id);
            }),
        };
        match id {
            Ok(id) if bounds.contains(cell) => grid.set(cell, id),
            Ok(_) => {}
            Err(kind) => failed = Some(kind),
        }
    };
    build(&mut put);
    failed.map_or(Ok(()), Err)
}

/// Doors stand on the floor of their scope, in the middle of its depth, and open to the front. Two side by
/// side are hinged on their outer sides.
fn build_door(grid: &mut Grid, door: &BlockState, placement: &Placement<'_>) -> Result<(), Kind> {
    let scope = &placement.scope;
    let size = scope.bounds.size();
    if size.y < 2 {
        return Err(Kind::NoRoomForDoor);
    }
    let [right, away] = scope.frame.plan();
    let facing = Facing::HORIZONTAL.into_iter().find(|facing| facing.step() == away).unwrap_or(Facing::North);
    let along = (right * size).element_sum().abs();
    let depth = (away * size).element_sum().abs();
    let middle = scope.bounds.min + away.abs() * (depth / 2);
    for number in 0..along {
        // The number counts to the right as seen from the front.
        let from_min = if right.min_element() < 0 { along - 1 - number } else { number };
        let foot = middle + right.abs() * from_min;
        if !is_there(placement, foot) {
            continue;
        }
        let hinge = if number % 2 == 0 { "left" } else { "right" };
        let lower = door.clone().with("facing", facing.name()).with("hinge", hinge);
        for (height, half) in ["lower", "upper"].into_iter().enumerate() {
            let id = intern(grid, &lower.clone().with("half", half))?;
            grid.set(foot + Cell::Y * height as i32, id);
        }
    }
    Ok(())
}

/// A file stands at the front left foot of its scope, turned with it and cut off at its ends. Its air is
/// left out. Where a footprint has not room for all of it, nothing stands.
fn stamp(grid: &mut Grid, file: &Grid, placement: &Placement<'_>) -> Result<(), Kind> {
    let scope = &placement.scope;
    let turn = scope.frame.turn;
    let mut ids = Vec::with_capacity(file.palette().states().len());
    for state in file.palette().states() {
        ids.push(intern(grid, &state.turned(turn))?);
    }
    let turned = turned_bounds(file.bounds(), turn);
    let [right, away] = scope.frame.plan();
    let mut shift = scope.bounds.min - turned.min;
    for direction in [right, away] {
        for axis in [0, 2] {
            if direction[axis] < 0 {
                shift[axis] = scope.bounds.max[axis] - turned.max[axis];
            }
        }
    }
    let place = |cell: Cell| {
        let target = turn.apply(cell) + shift;
        scope.bounds.contains(target).then_some(target)
    };
    let solid = || file.bounds().cells().filter(|cell| !file.get(*cell).is_air());
    if !solid().filter_map(place).all(|target| is_there(placement, target)) {
        return Ok(());
    }
    for cell in solid() {
        if let Some(target) = place(cell) {
            grid.set(target, ids[usize::from(file.id(cell))]);
        }
    }
    for (at, tags) in &file.block_entities {
        if let Some(target) = place(Cell::from(*at)) {
            grid.block_entities.insert(target.to_array(), tags.clone());
        }
    }
    Ok(())
}

fn turned_bounds(bounds: Bounds, turn: Turn) -> Bounds {
    let corners = [turn.apply(bounds.min), turn.apply(bounds.max - Cell::ONE)];
    Bounds::new(corners[0].min(corners[1]), corners[0].max(corners[1]) + Cell::ONE)
}
