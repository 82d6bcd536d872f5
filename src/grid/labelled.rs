use crate::space::Bounds;

/// A box with the name of what it holds: an example building drawn with boxes instead of blocks.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct LabelledBox {
    pub label: String,
    pub bounds: Bounds,
}

/// The labelled boxes of one building. Boxes of one label are the same primitive.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct LabelledBoxes {
    pub boxes: Vec<LabelledBox>,
    /// The smallest box around them all.
    pub container: Bounds,
}

impl LabelledBoxes {
    /// `None` where there is no box.
    pub fn new(boxes: Vec<LabelledBox>) -> Option<LabelledBoxes> {
        let container = boxes.iter().map(|b| b.bounds).reduce(|all, next| all.union(&next))?;
        Some(LabelledBoxes { boxes, container })
    }
}
