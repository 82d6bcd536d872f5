use crate::space::{Bounds, Turn};

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

impl LabelledBox {
    /// The label without the angle that it ends in, and the turn that this stands for: `corner@90`.
    pub fn turned(&self) -> (&str, Turn) {
        let angles = Turn::ALL.into_iter().skip(1).zip(["90", "180", "270"]);
        let split = self.label.rsplit_once('@');
        let named = split.and_then(|(name, angle)| {
            angles.into_iter().find(|(_, text)| *text == angle).map(|(turn, _)| (name, turn))
        });
        named.unwrap_or((&self.label, Turn::NONE))
    }
}

impl LabelledBoxes {
    /// `None` where there is no box.
    pub fn new(boxes: Vec<LabelledBox>) -> Option<LabelledBoxes> {
        let container = boxes.iter().map(|b| b.bounds).reduce(|all, next| all.union(&next))?;
        Some(LabelledBoxes { boxes, container })
    }
}
