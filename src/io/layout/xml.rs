//! The layouts of seed 4: nested `SerializableShape`s with bounding boxes and labels. Those without children are the
//! leaves.

use super::LayoutError;
use crate::facade::{Area, Drawing, Place};
use roxmltree::{Document, Node, ParsingOptions};

/// More nodes than this are no facade.
const MOST_NODES: u32 = 4_000_000;
/// Shapes in one another.
const MOST_DEEP: usize = 256;
/// Bounding boxes carry noise of about 1e-6; a child reaches no further out of its parent than this part of its size.
const NOISE: f64 = 1e-4;

/// The leaves of a layout.
///
/// # Errors
///
/// Where the text is no XML, holds no shape, or a shape says no box, no label or no number, with its line.
pub fn decode(text: &str) -> Result<Drawing, LayoutError> {
    let options = ParsingOptions { nodes_limit: MOST_NODES, ..ParsingOptions::default() };
    let document =
        Document::parse_with_options(text, options).map_err(|error| LayoutError::Xml(error.to_string()))?;
    let is_shape = |node: &Node| node.has_tag_name("MainShape") || node.has_tag_name("SerializableShape");
    let main = document.descendants().find(is_shape).ok_or(LayoutError::NoShape)?;
    let reader = Reader { document: &document };
    let mut drawing = Drawing::default();
    // Shapes to be read, with the box of what they stand in and how deep they are.
    let mut open: Vec<(Node, Option<Sides>, usize)> = vec![(main, None, 0)];
    while let Some((shape, around, depth)) = open.pop() {
        let place = reader.place(&shape);
        let (sides, front) = reader.bounds(&shape)?;
        if depth > MOST_DEEP {
            return Err(LayoutError::Deep { place, most: MOST_DEEP });
        }
        if around.is_some_and(|around| reaches_out(&sides, &around)) {
            return Err(LayoutError::Outside { place });
        }
        let children: Vec<Node> =
            child(&shape, "Children").iter().flat_map(Node::children).filter(is_shape).collect();
        if children.is_empty() {
            let label = reader.label(&shape)?;
            drawing.areas.push(Area { label, sides, front: Some(front), place });
        }
        open.extend(children.into_iter().rev().map(|child| (child, Some(sides), depth + 1)));
    }
    Ok(drawing)
}

type Sides = [[f64; 2]; 2];

fn reaches_out(sides: &Sides, around: &Sides) -> bool {
    sides.iter().zip(around).any(|(own, outer)| {
        let noise = NOISE * (outer[1] - outer[0]).abs();
        own[0] < outer[0] - noise || own[1] > outer[1] + noise
    })
}

struct Reader<'d> {
    document: &'d Document<'d>,
}

impl Reader<'_> {
    fn place(&self, node: &Node) -> Place {
        Place::Line(self.document.text_pos_at(node.range().start).row as usize)
    }

    /// The sides of a shape along x and y, and how far it reaches along z.
    fn bounds(&self, shape: &Node) -> Result<(Sides, f64), LayoutError> {
        let bounds = self.required(shape, "BBox")?;
        let [min, max] = [self.required(&bounds, "Min")?, self.required(&bounds, "Max")?];
        let side = |axis| Ok([self.number(&min, axis)?, self.number(&max, axis)?]);
        let front = child(&max, "Z").map_or(Ok(0.0), |_| self.number(&max, "Z"));
        Ok(([side("X")?, side("Y")?], front?))
    }

    fn label(&self, shape: &Node) -> Result<String, LayoutError> {
        let label = self.required(&self.required(shape, "Label")?, "LabelName")?;
        let text = label.text().unwrap_or("").trim();
        match text.is_empty() {
            true => Err(LayoutError::NoLabel { place: self.place(&label) }),
            false => Ok(text.to_owned()),
        }
    }

    fn number(&self, node: &Node, name: &'static str) -> Result<f64, LayoutError> {
        let element = self.required(node, name)?;
        let text = element.text().unwrap_or("").trim();
        let number = text.parse().ok().filter(|number: &f64| number.is_finite() && number.abs() < FARTHEST);
        number.ok_or_else(|| LayoutError::Number { place: self.place(&element), name, text: shortened(text) })
    }

    fn required<'n>(&self, node: &Node<'n, 'n>, name: &'static str) -> Result<Node<'n, 'n>, LayoutError> {
        child(node, name).ok_or_else(|| LayoutError::Missing {
            place: self.place(node),
            within: node.tag_name().name().to_owned(),
            name,
        })
    }
}

/// Coordinates beyond this are a slip.
const FARTHEST: f64 = 1e12;

fn child<'n>(node: &Node<'n, 'n>, name: &str) -> Option<Node<'n, 'n>> {
    node.children().find(|child| child.has_tag_name(name))
}

/// As much of a text as a message can show.
fn shortened(text: &str) -> String {
    const SHOWN: usize = 40;
    match text.char_indices().nth(SHOWN) {
        Some((end, _)) => format!("{}..", &text[..end]),
        None => text.to_owned(),
    }
}
