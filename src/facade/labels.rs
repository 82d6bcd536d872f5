//! What labels stand for: blocks, files and shapes, how deep they lie and whether they may stretch.

use super::{Layout, Side};
use crate::block;
use crate::grammar::{closest, is_primitive};
use crate::graph::Thing;

/// What a label stands for.
#[derive(Clone, PartialEq, Debug)]
pub struct Meaning {
    pub what: What,
    /// Blocks before the plane of the walls; behind it where below zero.
    pub offset: i32,
    pub stretch: Stretch,
}

/// Whether leaves of a label may have other lengths than they were drawn with.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Stretch {
    /// Walls: what room is left over is theirs.
    Soft,
    /// Bands: as long as their wall, and as high as they were drawn.
    Band,
    /// Windows, doors and all else that has to stay whole.
    Hard,
}

#[derive(Clone, PartialEq, Debug)]
pub enum What {
    /// A block, a schematic, or a mix of blocks.
    Thing(Thing),
    /// A primitive of the language, of a material.
    Shape {
        name: String,
        material: Option<Thing>,
    },
    /// A door that stands whole in the middle of its leaf, in a frame.
    Door {
        wood: String,
    },
    /// An OBJ mesh that fills the leaf; where blocks are written, the block stands for it.
    Mesh {
        file: String,
        block: Thing,
    },
    Nothing,
}

/// What a user says of labels: the lines of a text.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Meanings {
    list: Vec<Said>,
}

#[derive(Clone, PartialEq, Debug)]
struct Said {
    line: usize,
    /// A label; with `*` at its end, all that begin with it.
    label: String,
    what: What,
    offset: Option<i32>,
    stretch: Option<Stretch>,
}

/// Why a text on labels cannot be read.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[error("line {line}: {problem}")]
pub struct LabelsError {
    /// From 1.
    pub line: usize,
    pub problem: LabelsProblem,
}

#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum LabelsProblem {
    #[error("expected a line such as `window = glass, back 1`")]
    NoLine,
    #[error("`{name}` is no block, and no shape either{}", hint(close))]
    NoThing { name: String, close: Option<String> },
    #[error("`{0}` says nothing that vox knows: expected `back 1`, `out 1`, `stretch`, `band` or `whole`")]
    NoProperty(String),
    #[error("the layout has no label `{label}`{}", hint(close))]
    NoLabel { label: String, close: Option<String> },
    #[error("the label `{0}` has a line already: line {1}")]
    Twice(String, usize),
}

fn hint(close: &Option<String>) -> String {
    close.as_ref().map_or_else(String::new, |close| format!(": did you mean `{close}`?"))
}

/// The farthest that a label may lie before or behind the walls.
const FARTHEST: i32 = 16;

impl std::str::FromStr for Meanings {
    type Err = LabelsError;

    fn from_str(text: &str) -> Result<Meanings, LabelsError> {
        let mut meanings = Meanings::default();
        for (number, line) in (1..).zip(text.trim_start_matches('\u{feff}').lines()) {
            let line = without_comment(line).trim();
            if line.is_empty() {
                continue;
            }
            let at = |problem| LabelsError { line: number, problem };
            let said = said(line, number).map_err(at)?;
            if let Some(before) = meanings.list.iter().find(|before| before.label == said.label) {
                return Err(at(LabelsProblem::Twice(said.label, before.line)));
            }
            meanings.list.push(said);
        }
        Ok(meanings)
    }
}

/// A comment begins with a `#` at the beginning of a word.
fn without_comment(line: &str) -> &str {
    let begins = |at: usize| line[..at].chars().next_back().is_none_or(char::is_whitespace);
    line.match_indices('#').find(|(at, _)| begins(*at)).map_or(line, |(at, _)| &line[..at])
}

fn said(line: &str, number: usize) -> Result<Said, LabelsProblem> {
    let (label, rest) = line.split_once('=').ok_or(LabelsProblem::NoLine)?;
    let label = label.trim().trim_matches('"').to_owned();
    if label.is_empty() {
        return Err(LabelsProblem::NoLine);
    }
    let mut fields = fields(rest).into_iter();
    let what = what(fields.next().ok_or(LabelsProblem::NoLine)?)?;
    let mut said = Said { line: number, label, what, offset: None, stretch: None };
    for field in fields {
        let blocks =
            |text: &str| text.trim().parse().ok().filter(|blocks: &i32| (0..=FARTHEST).contains(blocks));
        let unknown = || LabelsProblem::NoProperty(field.to_owned());
        match field.split_once(' ').unwrap_or((field, "")) {
            ("back", text) => said.offset = Some(-blocks(text).ok_or_else(unknown)?),
            ("out", text) => said.offset = Some(blocks(text).ok_or_else(unknown)?),
            ("stretch", "") => said.stretch = Some(Stretch::Soft),
            ("band", "") => said.stretch = Some(Stretch::Band),
            ("whole", "") => said.stretch = Some(Stretch::Hard),
            _ => return Err(unknown()),
        }
    }
    Ok(said)
}

/// The text between commas that stand outside of quotes and brackets.
fn fields(text: &str) -> Vec<&str> {
    let (mut fields, mut start, mut depth, mut is_quoted) = (Vec::new(), 0, 0, false);
    for (at, c) in text.char_indices() {
        match c {
            '"' => is_quoted = !is_quoted,
            '(' | '[' if !is_quoted => depth += 1,
            ')' | ']' if !is_quoted => depth -= 1,
            ',' if !is_quoted && depth <= 0 => {
                fields.push(text[start..at].trim());
                start = at + 1;
            }
            _ => {}
        }
    }
    fields.push(text[start..].trim());
    fields
}

/// `glass`, `"door.schem"`, `"ledge.obj"(smooth_stone)`, `cylinder(quartz_block)` or `nil`.
fn what(text: &str) -> Result<What, LabelsProblem> {
    let (head, material) = match text.strip_suffix(')').and_then(|text| text.split_once('(')) {
        Some((head, material)) => (head.trim(), Some(thing(material.trim())?)),
        None => (text, None),
    };
    if let Some(file) = head.strip_prefix('"').and_then(|head| head.strip_suffix('"')) {
        let is_mesh = file.to_ascii_lowercase().ends_with(".obj");
        return Ok(match is_mesh {
            true => What::Mesh {
                file: file.to_owned(),
                block: material.unwrap_or_else(|| Thing::Name("smooth_stone".to_owned())),
            },
            false => What::Thing(Thing::File(file.to_owned())),
        });
    }
    match head {
        "nil" | "air" => Ok(What::Nothing),
        "door" => Ok(What::Door {
            wood: material.map_or_else(|| "oak".to_owned(), |thing| thing.text().to_owned()),
        }),
        _ if is_primitive(head) => Ok(What::Shape { name: head.to_owned(), material }),
        _ => Ok(What::Thing(thing(head)?)),
    }
}

fn thing(text: &str) -> Result<Thing, LabelsProblem> {
    let thing = match text.contains(['[', ':']) {
        true => Thing::Block(text.to_owned()),
        false => Thing::Name(text.to_owned()),
    };
    let is_known = thing.block().is_some_and(|state| block::known(state.name()).is_some());
    match is_known {
        true => Ok(thing),
        false => {
            let names = block::all().iter().map(|known| known.default_state().short_name().to_owned());
            let names: Vec<String> = names.collect();
            let close = closest(text, names.iter().map(String::as_str)).map(str::to_owned);
            Err(LabelsProblem::NoThing { name: text.to_owned(), close })
        }
    }
}

impl Meanings {
    /// Every label that the text names is one of the layout.
    ///
    /// # Errors
    ///
    /// The first line about a label that the layout does not have, with the nearest that it has.
    pub fn check(&self, labels: &[String]) -> Result<(), LabelsError> {
        let is_there = |said: &&Said| labels.iter().any(|label| said.is_about(label));
        match self.list.iter().find(|said| !is_there(said)) {
            None => Ok(()),
            Some(said) => {
                let close = closest(&said.label, labels.iter().map(String::as_str)).map(str::to_owned);
                Err(LabelsError {
                    line: said.line,
                    problem: LabelsProblem::NoLabel { label: said.label.clone(), close },
                })
            }
        }
    }

    fn of(&self, label: &str) -> Option<&Said> {
        let exact = self.list.iter().find(|said| said.label == label);
        exact.or_else(|| self.list.iter().find(|said| said.is_about(label)))
    }
}

/// Whether a label is wall by what is said of it, or else by its name.
pub fn is_wall(label: &str, said: &Meanings) -> bool {
    let own = said.of(label).and_then(|said| said.stretch);
    own.or_else(|| word(label).map(|word| word.3)).is_some_and(|stretch| stretch == Stretch::Soft)
}

fn word(label: &str) -> Option<Word> {
    let label = label.to_lowercase();
    WORDS.iter().find(|(word, ..)| label.contains(word)).copied()
}

impl Said {
    fn is_about(&self, label: &str) -> bool {
        self.label.strip_suffix('*').map_or(self.label == label, |start| label.starts_with(start))
    }
}

/// What all labels of a layout mean.
#[derive(Clone, PartialEq, Debug)]
pub struct Meant {
    /// By the number of the label.
    pub list: Vec<Meaning>,
    /// The labels that neither the user nor their names explain, by number.
    pub guessed: Vec<usize>,
}

/// A word in the names of labels, the blocks that they are made of, one after the other for further labels, how far
/// they stand before the wall, and whether they stretch. The first word that fits counts.
type Word = (&'static str, &'static [&'static str], i32, Stretch);

const WORDS: [Word; 23] = [
    ("frame", &["smooth_quartz", "white_concrete", "polished_diorite", "birch_planks"], 0, Stretch::Hard),
    ("door", &["oak", "spruce", "dark_oak", "birch"], -1, Stretch::Hard),
    ("window", &GLASS, -1, Stretch::Hard),
    ("glass", &GLASS, -1, Stretch::Hard),
    ("shop", &["glass", "light_blue_stained_glass"], -1, Stretch::Hard),
    ("shutter", &["dark_oak_planks", "spruce_planks"], 0, Stretch::Hard),
    ("blind", &["dark_oak_planks", "spruce_planks"], 0, Stretch::Hard),
    ("balcony", &["spruce_planks", "oak_planks", "dark_oak_planks"], 1, Stretch::Hard),
    ("sill", &["smooth_stone", "polished_andesite"], 1, Stretch::Hard),
    ("column", &["quartz_pillar", "polished_diorite"], 1, Stretch::Hard),
    ("pillar", &["quartz_pillar", "polished_diorite"], 1, Stretch::Hard),
    ("cornice", &["smooth_stone", "polished_andesite"], 1, Stretch::Band),
    ("ledge", &["smooth_stone", "polished_andesite"], 1, Stretch::Band),
    ("molding", &["smooth_stone", "polished_andesite"], 1, Stretch::Band),
    ("deco", &["chiseled_stone_bricks", "chiseled_quartz_block"], 1, Stretch::Hard),
    ("ornament", &["chiseled_stone_bricks", "chiseled_quartz_block"], 1, Stretch::Hard),
    ("roof", &["deepslate_tiles", "dark_oak_planks"], 0, Stretch::Soft),
    ("brick", &["bricks", "stone_bricks", "mud_bricks"], 0, Stretch::Soft),
    (
        "wall",
        &[
            "bricks",
            "stone_bricks",
            "smooth_sandstone",
            "white_terracotta",
            "mud_bricks",
            "polished_andesite",
        ],
        0,
        Stretch::Soft,
    ),
    ("facade", &["bricks", "stone_bricks"], 0, Stretch::Soft),
    ("background", &["bricks", "stone_bricks"], 0, Stretch::Soft),
    ("plaster", &["white_terracotta", "smooth_sandstone"], 0, Stretch::Soft),
    ("sky", &["light_blue_concrete"], 0, Stretch::Soft),
];

const GLASS: [&str; 6] = [
    "glass",
    "light_blue_stained_glass",
    "cyan_stained_glass",
    "light_gray_stained_glass",
    "blue_stained_glass",
    "gray_stained_glass",
];

/// What labels are made of that no word explains.
const OTHERS: [&str; 10] = [
    "white_concrete",
    "light_gray_concrete",
    "cyan_concrete",
    "yellow_concrete",
    "lime_concrete",
    "orange_concrete",
    "light_blue_concrete",
    "brown_concrete",
    "pink_concrete",
    "gray_concrete",
];

/// Deeper steps in a drawing are so many blocks in the building.
const DEEPEST: i32 = 3;

/// What the labels of layouts mean, which have one list of them: what the user says, else what their names say, else something told apart.
/// `steps` says how many blocks before the walls the drawing puts each label, if it does.
///
/// Where no label is soft, the one with the largest area is: something has to take the room that is left over.
pub fn meant(layouts: &[Layout], said: &Meanings, steps: &[Option<i32>]) -> Meant {
    let labels = layouts.first().map_or([].as_slice(), Layout::labels);
    let mut taken: Vec<(&[&str], usize)> = Vec::new();
    let mut meant = Meant { list: Vec::new(), guessed: Vec::new() };
    for (number, label) in labels.iter().enumerate() {
        let word = word(label);
        let unexplained =
            if layouts.iter().any(|layout| spans(layout, number)) { Stretch::Band } else { Stretch::Hard };
        let (_, names, offset, stretch) = word.unwrap_or(("", &OTHERS, 0, unexplained));
        let next = match taken.iter_mut().find(|(list, _)| *list == names) {
            Some((_, next)) => next,
            None => {
                taken.push((names, 0));
                &mut taken.last_mut().expect("it was just put there").1
            }
        };
        let name = names[*next % names.len()].to_owned();
        *next += 1;
        let own = said.of(label);
        if own.is_none() && word.is_none() {
            meant.guessed.push(number);
        }
        let by_name = || match word {
            Some(("door", ..)) => What::Door { wood: name.clone() },
            _ => What::Thing(Thing::Name(name.clone())),
        };
        let drawn = steps.get(number).copied().flatten().map(|step| step.clamp(-DEEPEST, DEEPEST));
        meant.list.push(Meaning {
            what: own.map_or_else(by_name, |own| own.what.clone()),
            offset: own.and_then(|own| own.offset).or(drawn).unwrap_or(offset),
            stretch: own.and_then(|own| own.stretch).unwrap_or(stretch),
        });
    }
    if meant.list.iter().all(|meaning| meaning.stretch != Stretch::Soft)
        && let Some(wall) = (0..meant.list.len())
            .max_by_key(|label| layouts.iter().map(|layout| area(layout, *label)).sum::<u64>())
    {
        meant.list[wall].stretch = Stretch::Soft;
    }
    meant
}

/// Whether a leaf of a label reaches from side to side, long and low: it is no window then, whatever it is.
fn spans(layout: &Layout, label: usize) -> bool {
    const LONG: u32 = 4;
    let mut own = layout.leaves().iter().filter(|leaf| leaf.label as usize == label);
    own.any(|leaf| {
        let [width, height] = Side::ALL.map(|axis| leaf.region.len(axis));
        width == layout.size()[0] && width >= LONG * height
    })
}

/// The blocks that a label covers.
pub fn area(layout: &Layout, label: usize) -> u64 {
    let own = layout.leaves().iter().filter(|leaf| leaf.label as usize == label);
    own.map(|leaf| leaf.region.sides.iter().map(|[low, high]| u64::from(high - low)).product::<u64>()).sum()
}
