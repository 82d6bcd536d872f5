use crate::facade::Place;

/// Why a layout cannot be read.
#[derive(Clone, PartialEq, Debug, thiserror::Error)]
pub enum LayoutError {
    #[error("this is no layout: expected the XML of a facade, or a PNG with one colour for each label")]
    NoLayout,
    #[error("this is no well-formed XML: {0}")]
    Xml(String),
    #[error("byte {0} is not UTF-8, which the XML of a layout has to be")]
    NotUtf8(usize),
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
    #[error("the layout has {leaves} leaves, more than {most}, the limit")]
    TooManyLeaves { leaves: usize, most: usize },

    #[error("the labels of a picture are its colours: a text has to name them")]
    NoColours,
    #[error("the picture cannot be read: {0}")]
    Picture(String),
    #[error("the picture has {width} x {height} pixels, more than {most} in all, the limit")]
    LargePicture { width: u32, height: u32, most: u64 },
    #[error("{place}: the colour {colour} has no label{}", like(nearest))]
    Colour { place: Place, colour: String, nearest: Option<(String, String)> },
    #[error("{place}: the `{label}` that begins here is no rectangle")]
    NoRectangle { place: Place, label: String },
}

fn like(nearest: &Option<(String, String)>) -> String {
    let told = |(colour, label): &(String, String)| format!(": the nearest is {colour}, `{label}`");
    nearest.as_ref().map_or_else(String::new, told)
}
