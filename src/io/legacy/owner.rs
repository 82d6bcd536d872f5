//! Whose head a skull is.

use crate::nbt::{Compound, Tag};

/// Brings `Owner` into the form of Minecraft 1.16 to 1.20.4: `SkullOwner`, with the player's number as four Ints.
pub fn modernise(data: &mut Compound) {
    let Some(mut owner) = data.remove("Owner") else { return };
    if let Tag::Compound(owner) = &mut owner
        && let Some(Tag::String(id)) = owner.get("Id")
        && let Some(number) = parse_uuid(id)
    {
        owner.insert("Id".to_owned(), Tag::IntArray(number));
    }
    data.insert("SkullOwner".to_owned(), owner);
}

/// Reads `069a79f4-44e9-4726-a5be-fca90e38aaf5`.
fn parse_uuid(text: &str) -> Option<Vec<i32>> {
    let digits: String = text.chars().filter(|&c| c != '-').collect();
    if digits.len() != 32 || !digits.is_ascii() {
        return None;
    }
    let part = |at: usize| u32::from_str_radix(&digits[at * 8..at * 8 + 8], 16).ok();
    (0..4).map(|at| part(at).map(u32::cast_signed)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_uuid_is_four_numbers() {
        let number = parse_uuid("069a79f4-44e9-4726-a5be-fca90e38aaf5");
        assert_eq!(number, Some(vec![0x069a_79f4, 0x44e9_4726, 0xa5be_fca9_u32.cast_signed(), 0x0e38_aaf5]));
        for text in
            ["", "069a79f4", "069a79f4-44e9-4726-a5be-fca90e38aaf5a", "é69a79f444e94726a5befca90e38aa5"]
        {
            assert_eq!(parse_uuid(text), None, "{text}");
        }
    }
}
