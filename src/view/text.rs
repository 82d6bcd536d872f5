use font8x8::{
    BASIC_FONTS, BLOCK_FONTS, BOX_FONTS, GREEK_FONTS, HIRAGANA_FONTS, LATIN_FONTS, MISC_FONTS, UnicodeFonts,
};
use image::{Rgba, RgbaImage};

/// The size of a letter in pixels: the font has eight by eight dots, drawn two by two.
pub(super) const LETTER: u32 = 8 * DOT;
const DOT: u32 = 2;
const ELLIPSIS: &str = "..";

/// Writes `text` with its upper left corner at the given place; what does not fit is left out.
pub(super) fn write(image: &mut RgbaImage, text: &str, [x, y]: [u32; 2], ink: Rgba<u8>) {
    for (letter, left) in text.chars().zip((x..).step_by(LETTER as usize)) {
        for (at_x, at_y) in dots(letter) {
            if let Some(pixel) = image.get_pixel_mut_checked(left + at_x, y + at_y) {
                *pixel = ink;
            }
        }
    }
}

/// The pixels of a letter.
fn dots(letter: char) -> impl Iterator<Item = (u32, u32)> {
    let rows = glyph(letter);
    let places = (0..LETTER).flat_map(|y| (0..LETTER).map(move |x| (x, y)));
    places.filter(move |(x, y)| rows[(y / DOT) as usize] >> (x / DOT) & 1 == 1)
}

/// The rows of a letter, lowest bit left; letters that no font has become question marks.
fn glyph(letter: char) -> [u8; 8] {
    let fonts: [&dyn UnicodeFonts; 7] =
        [&BASIC_FONTS, &LATIN_FONTS, &GREEK_FONTS, &BLOCK_FONTS, &BOX_FONTS, &HIRAGANA_FONTS, &MISC_FONTS];
    let find = |letter: char| fonts.iter().find_map(|font| font.get(letter));
    find(letter).or_else(|| find('?')).unwrap_or_default()
}

/// `text` in at most `letters` letters, without its middle if need be: names of files differ at the end.
pub(super) fn shorten(text: &str, letters: usize) -> String {
    let all: Vec<char> = text.chars().collect();
    if all.len() <= letters {
        return text.to_owned();
    }
    let kept = letters.saturating_sub(ELLIPSIS.len());
    let (head, tail) = (kept.div_ceil(2), kept / 2);
    all[..head].iter().chain(&ELLIPSIS.chars().collect::<Vec<_>>()).chain(&all[all.len() - tail..]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_texts_lose_their_middle() {
        assert_eq!(shorten("house-12.schem", 14), "house-12.schem");
        assert_eq!(shorten("village-house-12.schem", 12), "villa..schem");
        assert_eq!(shorten("häuser", 4), "h..r");
        assert_eq!(shorten("abc", 0), "..");
    }

    #[test]
    fn letters_are_drawn_or_stand_in() {
        assert_ne!(glyph('a'), glyph('?'));
        assert_ne!(glyph('ä'), glyph('?'));
        assert_eq!(glyph('\u{1f600}'), glyph('?'));
        assert_ne!(glyph('?'), [0; 8]);
    }
}
