//! Inference: from grids and boxes to split trees. Knows nothing of running grammars or of files.
//!
//! ```text
//! Grid --cuboids--> boxes of one block state --split_boxes--> Tree
//! ```

pub mod boxes;
pub mod cuboids;
pub mod tree;

pub use boxes::{BadBoxes, split_boxes};
pub use cuboids::cuboids;
pub use tree::{Node, NodeId, Part, Tree, TreeBuilder};
