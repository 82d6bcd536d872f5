//! Layouts of facades: the XML of seed 4, and pictures with one colour a label.

mod colours;
mod error;
mod picture;
mod xml;

use super::Limits;
use crate::facade::Drawing;

pub use colours::{Colours, ColoursError, ColoursProblem};
pub use error::LayoutError;

/// More leaves than this are no facade, and take too long.
const MOST_LEAVES: usize = 20_000;

/// Whether a file that begins so holds a layout, if vox can read it.
pub fn is_layout(head: &[u8]) -> bool {
    is_picture(head) || is_xml(head)
}

fn is_picture(head: &[u8]) -> bool {
    head.starts_with(b"\x89PNG")
}

fn is_xml(head: &[u8]) -> bool {
    let text = head.strip_prefix(b"\xef\xbb\xbf").unwrap_or(head);
    text.trim_ascii_start().starts_with(b"<")
}

/// The labelled rectangles of a layout. A picture needs to be told which colour is which label, and what of it is
/// wall: walls may reach around windows, all else has to be rectangular.
///
/// # Errors
///
/// Where the bytes are no layout, or say something wrong: with the line or the pixel.
pub fn decode_layout(
    bytes: &[u8],
    colours: Option<&Colours>,
    is_wall: &dyn Fn(&str) -> bool,
    limits: &Limits,
) -> Result<Drawing, LayoutError> {
    let drawing = match bytes {
        _ if is_picture(bytes) => {
            picture::decode(bytes, colours.ok_or(LayoutError::NoColours)?, is_wall, limits)?
        }
        _ if is_xml(bytes) => xml::decode(
            std::str::from_utf8(bytes).map_err(|error| LayoutError::NotUtf8(error.valid_up_to()))?,
        )?,
        _ => return Err(LayoutError::NoLayout),
    };
    match drawing.areas.len() > MOST_LEAVES {
        true => Err(LayoutError::TooManyLeaves { leaves: drawing.areas.len(), most: MOST_LEAVES }),
        false => Ok(drawing),
    }
}
