//! Patterns of banners have names and not letters since Minecraft 1.20.5, and so have their colours.

use super::tags::{self, compounds, put, text};
use super::{Kept, Way};
use crate::block::DYES;
use crate::nbt::{Compound, Tag};

/// By letters and by name.
const PATTERNS: [(&str, &str); 41] = [
    ("b", "base"),
    ("bl", "square_bottom_left"),
    ("bo", "border"),
    ("br", "square_bottom_right"),
    ("bri", "bricks"),
    ("bs", "stripe_bottom"),
    ("bt", "triangle_bottom"),
    ("bts", "triangles_bottom"),
    ("cbo", "curly_border"),
    ("cr", "cross"),
    ("cre", "creeper"),
    ("cs", "stripe_center"),
    ("dls", "stripe_downleft"),
    ("drs", "stripe_downright"),
    ("flo", "flower"),
    ("glb", "globe"),
    ("gra", "gradient"),
    ("gru", "gradient_up"),
    ("hh", "half_horizontal"),
    ("hhb", "half_horizontal_bottom"),
    ("ld", "diagonal_left"),
    ("ls", "stripe_left"),
    ("lud", "diagonal_up_left"),
    ("mc", "circle"),
    ("moj", "mojang"),
    ("mr", "rhombus"),
    ("ms", "stripe_middle"),
    ("pig", "piglin"),
    ("rd", "diagonal_right"),
    ("rs", "stripe_right"),
    ("rud", "diagonal_up_right"),
    ("sc", "straight_cross"),
    ("sku", "skull"),
    ("ss", "small_stripes"),
    ("tl", "square_top_left"),
    ("tr", "square_top_right"),
    ("ts", "stripe_top"),
    ("tt", "triangle_top"),
    ("tts", "triangles_top"),
    ("vh", "half_vertical"),
    ("vhr", "half_vertical_right"),
];

pub fn change(data: &mut Compound, way: Way, kept: &mut Kept) {
    if tags::kind(data) != "banner" {
        return;
    }
    let list = if way == Way::Up { "Patterns" } else { "patterns" };
    for pattern in compounds(data, list) {
        let known = match way {
            Way::Up => raised(pattern),
            Way::Down => lowered(pattern),
        };
        match known {
            Some(new) => *pattern = new,
            None => kept.add("banner pattern"),
        }
    }
}

fn raised(pattern: &Compound) -> Option<Compound> {
    let Some(Tag::String(letters)) = pattern.get("Pattern") else { return None };
    let (_, name) = PATTERNS.iter().find(|(old, _)| old == letters)?;
    let number = usize::try_from(tags::int(pattern.get("Color")?)?).ok()?;
    let mut new = Compound::new();
    put(&mut new, "pattern", text(&format!("minecraft:{name}")));
    put(&mut new, "color", text(DYES.get(number)?));
    Some(new)
}

fn lowered(pattern: &Compound) -> Option<Compound> {
    let (Some(Tag::String(name)), Some(Tag::String(dye))) = (pattern.get("pattern"), pattern.get("color"))
    else {
        return None;
    };
    let name = name.strip_prefix("minecraft:").unwrap_or(name);
    let (letters, _) = PATTERNS.iter().find(|(_, new)| *new == name)?;
    let number = DYES.iter().position(|other| other == dye)?;
    let mut old = Compound::new();
    put(&mut old, "Pattern", text(letters));
    put(&mut old, "Color", Tag::Int(number as i32));
    Some(old)
}
