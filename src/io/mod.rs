//! Files <-> grids and labelled boxes, one folder per format. Knows nothing of grammars.
//!
//! ```text
//! bytes --gzip--> stream --nbt--> tags, arrays --schem, litematic, ..--> Grid
//!                        --all--> bytes ---------region, magica, ..-----> Grid
//!                                       ---------obj--------------------> LabelledBoxes
//! ```
//!
//! What a file is, its content says: names and extensions are never asked.

mod about;
mod axiom;
mod blueprint;
mod decode;
mod encoded;
mod entities;
mod error;
mod fields;
mod file;
mod format;
mod gzip;
mod kinds;
mod layout;
mod legacy;
mod limits;
mod litematic;
mod lost;
mod magica;
mod mcedit;
mod mcstructure;
mod obj;
mod options;
mod region;
mod schem;
mod states;
mod structure;
mod text;
mod varint;
mod volume;
mod warning;

pub use crate::grid::DEFAULT_DATA_VERSION;
pub use about::About;
pub use decode::{Content, Decoded, decode, decode_with, sniff};
pub use encoded::Encoded;
pub use error::{ReadError, WriteError};
pub use file::{Staged, read, read_bytes, write_atomic};
pub use format::{Format, is_region};
pub use gzip::GzipError;
pub use layout::{Colours, ColoursError, ColoursProblem, LayoutError, decode_layout, is_layout};
pub use limits::Limits;
pub use litematic::{LitematicVersion, encode_litematic};
pub use lost::Lost;
pub use magica::{MagicaError, encode_vox};
pub use obj::{
    ObjError, ObjMesh, ObjModel, ObjProblem, PlacedModel, Scale, decode_obj_boxes, decode_obj_model,
    encode_obj_boxes, encode_obj_mesh, encode_obj_models,
};
pub use options::{Jigsaws, Options};
pub use region::{ChunkProblem, EncodedRegions, encode_regions, read_world};
pub use schem::{SchemVersion, encode_schem};
pub use structure::encode_structure;
pub use varint::VarintProblem;
pub use warning::Warning;
