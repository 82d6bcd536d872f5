use super::BlockState;
use super::pattern::{fits, table};
use std::sync::OnceLock;

/// A color; an alpha of 255 is opaque.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Rgba(pub [u8; 4]);

impl Rgba {
    pub const fn rgb(red: u8, green: u8, blue: u8) -> Rgba {
        Rgba([red, green, blue, 255])
    }

    /// Reads `#rrggbb` or `#rrggbbaa`.
    pub fn parse(text: &str) -> Option<Rgba> {
        let digits = text.strip_prefix('#').filter(|digits| digits.bytes().all(|b| b.is_ascii_hexdigit()))?;
        let number = u32::from_str_radix(digits, 16).ok()?;
        match digits.len() {
            6 => Some(Rgba((number << 8 | 255).to_be_bytes())),
            8 => Some(Rgba(number.to_be_bytes())),
            _ => None,
        }
    }

    pub fn is_opaque(self) -> bool {
        self.0[3] == 255
    }
}

/// The color of a block, all sides alike. Blocks that no rule knows get a color of their own by their name.
pub fn color(state: &BlockState) -> Rgba {
    let (_, name) = state.name().split_once(':').unwrap_or(("", state.name()));
    ruled(name).unwrap_or_else(|| hashed(state.name()))
}

fn ruled(name: &str) -> Option<Rgba> {
    static RULES: OnceLock<Vec<(&str, Rgba)>> = OnceLock::new();
    let rules = RULES.get_or_init(|| {
        table(include_str!("colors.txt")).filter_map(|(p, value)| Some((p, Rgba::parse(value)?))).collect()
    });
    rules.iter().find(|(pattern, _)| fits(pattern, name)).map(|&(_, color)| color)
}

/// A color of medium light and strength whose hue depends on the name alone.
fn hashed(name: &str) -> Rgba {
    // FNV-1a: the color must not change with the version of a library.
    let hash = name.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    });
    let hue = (hash >> 32) % 360;
    let wave = |shift: u64| {
        // A triangle wave over the circle of hues: 60 degrees up, 120 on top, 60 down, 120 below.
        let at = ((hue + shift) % 360) as i64;
        let height = (120 - (at - 180).abs()).clamp(0, 60) as u8;
        95 + height * 3 / 2
    };
    Rgba::rgb(wave(180), wave(60), wave(300))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::block::all;
    use std::collections::BTreeSet;

    #[test]
    fn every_known_block_has_a_rule() {
        let lost: Vec<_> =
            all().iter().map(|known| known.name()).filter(|name| ruled(name).is_none()).collect();
        assert_eq!(lost, [""; 0]);
    }

    #[test]
    fn every_rule_is_legible_and_some_block_needs_it() {
        let rules: Vec<_> = table(include_str!("colors.txt")).collect();
        assert!(rules.iter().all(|(_, value)| Rgba::parse(value).is_some()));
        let first = |name: &str| rules.iter().position(|(pattern, _)| fits(pattern, name));
        let used: BTreeSet<_> = all().iter().filter_map(|known| first(known.name())).collect();
        let unused: Vec<_> = (0..rules.len()).filter(|at| !used.contains(at)).map(|at| rules[at].0).collect();
        assert_eq!(unused, [""; 0]);
    }

    #[test]
    fn only_glass_ice_and_fluids_can_be_seen_through() {
        let color_of = |name: &str| color(&name.parse().unwrap());
        for name in ["glass", "red_stained_glass_pane", "water", "ice"] {
            assert!(!color_of(name).is_opaque(), "{name}");
        }
        for name in ["stone", "red_wool", "oak_planks", "mod:thing"] {
            assert!(color_of(name).is_opaque(), "{name}");
        }
    }

    #[test]
    fn strangers_keep_their_color() {
        let color_of = |name: &str| color(&name.parse().unwrap());
        assert_eq!(color_of("mod:thing"), color_of("mod:thing"));
        assert_ne!(color_of("mod:thing"), color_of("mod:other"));
        assert_eq!(color_of("mod:oak_planks"), color_of("oak_planks"));
    }

    #[test]
    fn colors_are_read_with_and_without_alpha() {
        assert_eq!(Rgba::parse("#102030"), Some(Rgba([16, 32, 48, 255])));
        assert_eq!(Rgba::parse("#10203040"), Some(Rgba([16, 32, 48, 64])));
        for bad in ["102030", "#12", "#+12345", "#gg0000", ""] {
            assert_eq!(Rgba::parse(bad), None, "{bad}");
        }
    }
}
