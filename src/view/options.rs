use crate::block::Rgba;
use crate::space::Turn;

/// How a picture is taken.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ViewOptions {
    /// Where the camera stands.
    pub corner: Corner,
    pub scale: Scale,
    /// The color behind the building; may be transparent.
    pub background: Rgba,
}

/// The corner of the building that is nearest to the camera.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub enum Corner {
    #[default]
    SouthEast,
    SouthWest,
    NorthWest,
    NorthEast,
}

#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub enum Scale {
    /// Large for small buildings, and small enough that large ones fit in 2,000 pixels.
    #[default]
    Fit,
    /// The width of one block in pixels. Pictures never exceed 8,000 pixels.
    BlockWidth(u16),
}

impl ViewOptions {
    pub const PAPER: Rgba = Rgba::rgb(0xec, 0xea, 0xe4);
    pub const CLEAR: Rgba = Rgba([0xec, 0xea, 0xe4, 0]);
}

impl Default for ViewOptions {
    fn default() -> ViewOptions {
        ViewOptions { corner: Corner::default(), scale: Scale::default(), background: ViewOptions::PAPER }
    }
}

impl Corner {
    pub const ALL: [Corner; 4] = [Corner::SouthEast, Corner::SouthWest, Corner::NorthWest, Corner::NorthEast];

    /// The turn that brings this corner to the south-east, where the camera always stands.
    pub(super) fn turn(self) -> Turn {
        Turn::ALL[self as usize]
    }
}
