use crate::facade::Place;

/// Why a layout cannot be read.
#[derive(Clone, PartialEq, Debug, thiserror::Error)]
pub enum LayoutError {
    #[error("this is no well-formed XML: {0}")]
    Xml(String),
    #[error("this XML holds no layout: expected an element `MainShape` or `SerializableShape`")]
    NoShape,
    #[error("{place}: `{within}` has no element `{name}`")]
    Missing { place: Place, within: String, name: &'static str },
    #[error("{place}: `{name}` is `{text}`, which is no number")]
    Number { place: Place, name: &'static str, text: String },
    #[error("{place}: the label is empty")]
    NoLabel { place: Place },
    #[error("{place}: this shape reaches out of the one around it")]
    Outside { place: Place },
    #[error("{place}: shapes stand in one another more than {most} deep")]
    Deep { place: Place, most: usize },
}
