//! Words for an operation: what it is, where it stands, what it is made of.

use super::kinds::{Kind, Leaf};
use super::sights::{Along, Sight};
use crate::space::Axis;

/// The form of all places of an operation: what is one block thin, is thin wherever it stands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Form {
    Cell,
    Post,
    Row(Axis),
    Layer,
    /// Thin along the axis.
    Wall(Axis),
    Body,
}

impl Form {
    pub fn of(sight: &Sight) -> Form {
        match Axis::ALL.map(|axis| sight.is_thin(axis)) {
            [true, true, true] => Form::Cell,
            [true, false, true] => Form::Post,
            [false, true, true] => Form::Row(Axis::X),
            [true, true, false] => Form::Row(Axis::Z),
            [_, true, _] => Form::Layer,
            [true, ..] => Form::Wall(Axis::X),
            [.., true] => Form::Wall(Axis::Z),
            _ => Form::Body,
        }
    }

    /// What it is called where nothing else is known of it.
    fn plain(self) -> &'static str {
        match self {
            Form::Cell => "spot",
            Form::Post => "post",
            Form::Row(_) => "beam",
            Form::Layer => "floor",
            Form::Wall(_) => "wall",
            Form::Body => "body",
        }
    }
}

/// What an operation is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Noun {
    pub word: &'static str,
    pub says: Says,
}

/// How much a noun says alone.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Says {
    /// A doorway is a doorway, wherever it stands.
    All,
    /// Of a wall one wants to know which.
    Kind,
    /// A post of plants is called after the plants.
    Form,
}

/// What an operation is, from all of its places; `unit` is the axis that it is repeated on, `cut` the one that it is split
/// on.
pub fn noun(sight: &Sight, unit: Option<Axis>, cut: Option<Axis>) -> Noun {
    let form = Form::of(sight);
    let word = unit.and_then(|axis| unit_word(sight, form, axis)).or_else(|| feature_word(sight, form));
    if let Some(word) = word {
        return Noun { word, says: Says::All };
    }
    if sight.is_mostly(&[Kind::Other]) {
        return Noun { word: form.plain(), says: Says::Form };
    }
    match form {
        Form::Body => body_word(sight, cut),
        Form::Layer => Noun { word: layer_word(sight), says: Says::Kind },
        form => Noun { word: form.plain(), says: Says::Kind },
    }
}

fn layer_word(sight: &Sight) -> &'static str {
    match sight.lies(Axis::Y) {
        Some(Along::Low) => "foundation",
        Some(Along::High) => "top_layer",
        _ => "floor",
    }
}

/// A part that is repeated: upwards a storey, along a wall a bay.
fn unit_word(sight: &Sight, form: Form, axis: Axis) -> Option<&'static str> {
    match (axis, form) {
        (Axis::Y, Form::Wall(_) | Form::Body) => Some("storey"),
        (Axis::Y, _) | (_, Form::Cell) => None,
        _ if sight.cells(Kind::Window) > 0 => Some("window_bay"),
        _ => Some("bay"),
    }
}

/// What holds a door or glass, or is mostly fence, ground or roof.
fn feature_word(sight: &Sight, form: Form) -> Option<&'static str> {
    let is_mostly = |kind| sight.is_mostly(&[kind]);
    let has = |kind| sight.cells(kind) > 0;
    Some(match form {
        Form::Post if has(Kind::Door) => "doorway",
        Form::Wall(_) if has(Kind::Door) => "door_wall",
        Form::Row(_) | Form::Layer if is_mostly(Kind::Ground) => "ground",
        Form::Post if has(Kind::Window) => "window_post",
        Form::Row(_) if has(Kind::Window) => "window_row",
        Form::Wall(_) if has(Kind::Window) => "window_wall",
        Form::Post if is_mostly(Kind::Fence) => "fence_post",
        Form::Row(_) | Form::Layer if is_mostly(Kind::Fence) => "railing",
        Form::Wall(_) if is_mostly(Kind::Fence) => "fencing",
        Form::Row(_) if is_mostly(Kind::Sloped) => "eaves",
        Form::Layer if is_mostly(Kind::Sloped) => "roofing",
        Form::Wall(_) if is_mostly(Kind::Sloped) => "roof_slice",
        Form::Body if is_mostly(Kind::Sloped) => "roof_part",
        _ => return None,
    })
}

/// A body by what it takes of the house: all of it, a storey, a part from bottom to top, or less.
fn body_word(sight: &Sight, cut: Option<Axis>) -> Noun {
    let noun = |word| Noun { word, says: Says::Kind };
    let spans = |axis| sight.lies(axis) == Some(Along::Whole);
    if spans(Axis::X) && spans(Axis::Z) {
        return match sight.lies(Axis::Y) {
            Some(Along::Whole) => Noun { word: "house", says: Says::Form },
            Some(Along::Low) => noun("ground_floor"),
            Some(Along::High) => noun("top_floor"),
            Some(Along::Middle) => noun("main_floor"),
            None => noun("body"),
        };
    }
    let is_hollow = sight.filled() < 3 * sight.cells(Kind::Nothing);
    match (is_hollow, cut) {
        _ if spans(Axis::Y) => Noun { word: "part", says: Says::Form },
        (true, Some(Axis::X | Axis::Z)) => noun("walls"),
        (true, _) => noun("room"),
        (false, _) => Noun { word: "block", says: Says::Form },
    }
}

/// Where it stands in the house, seen from the front, which is its south side.
pub fn side(sight: &Sight) -> Option<&'static str> {
    match Form::of(sight) {
        Form::Wall(axis) if sight.lies(axis) == Some(Along::Middle) => Some("inner"),
        Form::Wall(axis) => across(sight, axis).or_else(|| is_beside(sight, axis).then_some("side")),
        _ => across(sight, Axis::Z).or_else(|| across(sight, Axis::X)),
    }
}

fn across(sight: &Sight, axis: Axis) -> Option<&'static str> {
    match (axis, sight.lies(axis)?) {
        (Axis::X, Along::Low) => Some("left"),
        (Axis::X, Along::High) => Some("right"),
        (Axis::Z, Along::Low) => Some("back"),
        (Axis::Z, Along::High) => Some("front"),
        _ => None,
    }
}

/// The other side, where it stands in a corner.
pub fn second_side(sight: &Sight) -> Option<&'static str> {
    across(sight, Axis::Z)
        .and_then(|_| across(sight, Axis::X))
        .filter(|_| !matches!(Form::of(sight), Form::Wall(_)))
}

/// Whether it stands on the left and on the right, and nowhere else.
fn is_beside(sight: &Sight, axis: Axis) -> bool {
    axis == Axis::X
        && sight.along[axis.index()].iter().all(|along| matches!(along, Along::Low | Along::High))
        && !sight.along[axis.index()].is_empty()
}

/// How high it stands.
pub fn height(sight: &Sight) -> Option<&'static str> {
    match sight.lies(Axis::Y)? {
        Along::Low => Some("lower"),
        Along::High => Some("upper"),
        _ => None,
    }
}

/// What it holds beside what most houses are of.
pub fn features(sight: &Sight) -> Vec<&'static str> {
    let all =
        [(Kind::Door, "door"), (Kind::Window, "window"), (Kind::Fence, "fence"), (Kind::Sloped, "roof")];
    all.into_iter().filter(|(kind, _)| sight.cells(*kind) > 0).map(|(_, word)| word).collect()
}

/// What an alternative is beside others in a place of that form.
pub fn alternative(leaf: Option<&Leaf>, sight: &Sight, form: Form) -> Alternative {
    let has = |kind| sight.cells(kind) > 0;
    let word = match leaf.map(|leaf| leaf.kind) {
        Some(Kind::Nothing) => return Alternative::Nothing,
        _ if form == Form::Body => return Alternative::Body,
        _ if has(Kind::Door) => "door",
        _ if has(Kind::Window) => "window",
        _ if sight.is_mostly(&[Kind::Fence]) => "railing",
        _ if sight.is_mostly(&[Kind::Sloped]) => "roof",
        _ if sight.is_mostly(&[Kind::Other]) => "furniture",
        _ if matches!(form, Form::Cell | Form::Row(_)) => "wall",
        _ => form.plain(),
    };
    Alternative::Word(word)
}

/// What may stand in a place.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Alternative {
    Word(&'static str),
    /// Too much for one word.
    Body,
    Nothing,
}
