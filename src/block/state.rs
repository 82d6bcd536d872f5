use std::borrow::Cow;
use std::fmt;
use std::str::FromStr;

/// A block with its properties, as in `minecraft:oak_stairs[facing=east,half=bottom]`.
///
/// The name always carries its namespace, the properties are sorted by key and no key stands twice:
/// equal states are equal values. Absent properties mean the block's default.
#[derive(Clone, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct BlockState {
    name: Box<str>,
    properties: Vec<(Box<str>, Box<str>)>,
}

/// Why a text is not a block state.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum BadBlockState {
    #[error("a block name is missing")]
    NoName,
    #[error(
        "`{0}` is not a block name: letters a-z, digits, `_`, `-`, `.` and `/`, with one `:` after the namespace"
    )]
    Name(String),
    #[error("the properties of `{0}` are not closed by `]`")]
    Unclosed(String),
    #[error("`{0}` is not a property: expected key=value")]
    Property(String),
    #[error("the property `{0}` is given twice")]
    Twice(String),
}

impl BlockState {
    /// The state of `name` with every property at its default. A bare name is a block of the game.
    pub fn new(name: &str) -> Result<BlockState, BadBlockState> {
        Ok(BlockState { name: full_name(name)?, properties: Vec::new() })
    }

    pub fn air() -> BlockState {
        BlockState { name: "minecraft:air".into(), properties: Vec::new() }
    }

    /// What stands in a build for cells that are to be left alone where it is placed.
    pub fn structure_void() -> BlockState {
        BlockState { name: "minecraft:structure_void".into(), properties: Vec::new() }
    }

    /// The state of a block whose name comes from the table of known blocks, so is legal.
    pub(super) fn known(name: &'static str) -> BlockState {
        BlockState { name: format!("minecraft:{name}").into(), properties: Vec::new() }
    }

    /// The name with its namespace.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The name as people write it: blocks of the game go without their namespace.
    pub fn short_name(&self) -> &str {
        self.name.strip_prefix("minecraft:").unwrap_or(&self.name)
    }

    pub fn is_air(&self) -> bool {
        &*self.name == "minecraft:air"
    }

    /// Whether no block stands here: air of any kind, or a cell that is left alone.
    pub fn is_nothing(&self) -> bool {
        matches!(self.short_name(), "air" | "cave_air" | "void_air" | "structure_void")
    }

    /// The properties, sorted by key.
    pub fn properties(&self) -> impl ExactSizeIterator<Item = (&str, &str)> {
        self.properties.iter().map(|(key, value)| (&**key, &**value))
    }

    pub fn get(&self, key: &str) -> Option<&str> {
        let at = self.position(key).ok()?;
        Some(&self.properties[at].1)
    }

    /// This state with `key` set to `value`.
    pub fn with(mut self, key: &str, value: &str) -> BlockState {
        match self.position(key) {
            Ok(at) => self.properties[at].1 = value.into(),
            Err(at) => self.properties.insert(at, (key.into(), value.into())),
        }
        self
    }

    /// A block of the game with the properties of this one.
    pub(super) fn renamed(&self, name: &str) -> BlockState {
        BlockState { name: format!("minecraft:{name}").into(), properties: self.properties.clone() }
    }

    /// This state without a property of that key.
    pub fn without(mut self, key: &str) -> BlockState {
        if let Ok(at) = self.position(key) {
            self.properties.remove(at);
        }
        self
    }

    /// This state with every property replaced by what `change` makes of its key and value.
    pub(super) fn map(
        &self,
        change: impl for<'a> Fn(&'a str, &'a str) -> (&'a str, Cow<'a, str>),
    ) -> BlockState {
        let bare = BlockState { name: self.name.clone(), properties: Vec::new() };
        self.properties().fold(bare, |state, (key, value)| {
            let (key, value) = change(key, value);
            state.with(key, &value)
        })
    }

    fn position(&self, key: &str) -> Result<usize, usize> {
        self.properties.binary_search_by(|(k, _)| (**k).cmp(key))
    }

    /// The state in its short form: `oak_stairs[facing=east]`.
    pub fn short(&self) -> String {
        let full = self.to_string();
        full.strip_prefix("minecraft:").map_or_else(|| full.clone(), str::to_owned)
    }
}

fn full_name(name: &str) -> Result<Box<str>, BadBlockState> {
    let legal = |part: &str| {
        !part.is_empty()
            && part.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b"_-./".contains(&b))
    };
    match name.split_once(':') {
        _ if name.is_empty() => Err(BadBlockState::NoName),
        None if legal(name) => Ok(format!("minecraft:{name}").into()),
        Some((space, path)) if legal(space) && legal(path) => Ok(name.into()),
        _ => Err(BadBlockState::Name(name.to_owned())),
    }
}

impl FromStr for BlockState {
    type Err = BadBlockState;

    fn from_str(text: &str) -> Result<BlockState, BadBlockState> {
        let Some((name, rest)) = text.split_once('[') else { return BlockState::new(text) };
        let inner = rest.strip_suffix(']').ok_or_else(|| BadBlockState::Unclosed(text.to_owned()))?;
        let mut state = BlockState::new(name)?;
        for pair in inner.split(',').filter(|_| !inner.is_empty()) {
            let (key, value) = property(pair)?;
            match state.position(key) {
                Ok(_) => return Err(BadBlockState::Twice(key.to_owned())),
                Err(at) => state.properties.insert(at, (key.into(), value.into())),
            }
        }
        Ok(state)
    }
}

fn property(pair: &str) -> Result<(&str, &str), BadBlockState> {
    let is_word = |word: &str| {
        !word.is_empty()
            && !word.contains(|c: char| c.is_whitespace() || c.is_control() || "[]=\"#".contains(c))
    };
    pair.split_once('=')
        .map(|(key, value)| (key.trim(), value.trim()))
        .filter(|(key, value)| is_word(key) && is_word(value) && !pair.contains("//"))
        .ok_or_else(|| BadBlockState::Property(pair.to_owned()))
}

impl fmt::Display for BlockState {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.name)?;
        for (i, (key, value)) in self.properties.iter().enumerate() {
            write!(f, "{}{key}={value}", if i == 0 { "[" } else { "," })?;
        }
        f.write_str(if self.properties.is_empty() { "" } else { "]" })
    }
}
