use super::options::ViewOptions;
use super::text::{LETTER, shorten, write};
use image::{Rgba, RgbaImage, imageops};

/// Space around tiles, in pixels.
const GAP: u32 = 16;
/// Narrower tiles would leave no room for a caption.
const NARROWEST: u32 = 12 * LETTER;
const CAPTION: u32 = LETTER + GAP;
const INK: Rgba<u8> = Rgba([0x3a, 0x38, 0x34, 255]);
const MOUNT: Rgba<u8> = Rgba([0xd9, 0xd6, 0xcd, 255]);

/// One picture of all the pictures, each with its caption below it, in rows from left to right.
pub fn sheet(tiles: &[(String, RgbaImage)]) -> RgbaImage {
    let largest = |side: fn(&RgbaImage) -> u32| tiles.iter().map(|(_, image)| side(image)).max().unwrap_or(0);
    let tile = [largest(RgbaImage::width).max(NARROWEST), largest(RgbaImage::height) + CAPTION];
    let columns = columns(tiles.len() as u32, tile);
    let rows = (tiles.len() as u32).div_ceil(columns);
    let [width, height] = [columns * (tile[0] + GAP) + GAP, rows * (tile[1] + GAP) + GAP];
    let mut sheet = RgbaImage::from_pixel(width, height, MOUNT);
    for (at, (caption, image)) in (0..).zip(tiles) {
        let corner = [at % columns * (tile[0] + GAP) + GAP, at / columns * (tile[1] + GAP) + GAP];
        place(&mut sheet, caption, image, corner, tile);
    }
    sheet
}

/// The number of columns that brings the sheet closest to four to three.
fn columns(tiles: u32, [width, height]: [u32; 2]) -> u32 {
    let skew = |columns: u32| {
        let across = f64::from(3 * columns * (width + GAP));
        let down = f64::from(4 * tiles.div_ceil(columns) * (height + GAP));
        across.max(down) / across.min(down)
    };
    (1..=tiles).min_by(|&a, &b| skew(a).total_cmp(&skew(b))).unwrap_or(1)
}

/// Puts a picture in the middle of its tile, and the caption under it.
fn place(
    sheet: &mut RgbaImage,
    caption: &str,
    image: &RgbaImage,
    [x, y]: [u32; 2],
    [width, height]: [u32; 2],
) {
    let paper = RgbaImage::from_pixel(width, height, Rgba(ViewOptions::PAPER.0));
    imageops::replace(sheet, &paper, x.into(), y.into());
    let [left, top] = [x + (width - image.width()) / 2, y + (height - CAPTION - image.height()) / 2];
    imageops::overlay(sheet, image, left.into(), top.into());
    let caption = shorten(caption, (width / LETTER) as usize);
    let indent = (width - LETTER * caption.chars().count() as u32) / 2;
    write(sheet, &caption, [x + indent, y + height - CAPTION + GAP / 4], INK);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tile(caption: &str, width: u32, height: u32) -> (String, RgbaImage) {
        (caption.to_owned(), RgbaImage::from_pixel(width, height, Rgba([200, 0, 0, 255])))
    }

    #[test]
    fn the_sheet_holds_every_picture_whole() {
        let tiles =
            [tile("one", 300, 200), tile("two with a name that is far too long", 100, 250), tile("", 1, 1)];
        let sheet = sheet(&tiles);
        let red = sheet.pixels().filter(|pixel| pixel.0 == [200, 0, 0, 255]).count();
        assert_eq!(red, 300 * 200 + 100 * 250 + 1);
        assert_eq!(sheet.dimensions(), (2 * 316 + 16, 2 * (250 + CAPTION + GAP) + 16));
    }

    #[test]
    fn a_sheet_of_nothing_is_a_small_picture() {
        assert_eq!(sheet(&[]).dimensions(), (NARROWEST + 2 * GAP, GAP));
    }
}
