use super::{
    BadBlockState, BadProperty, BlockState, Version, check, complete, counterpart, is_material, known,
    suggest, suggest_material, translated,
};
use std::str::FromStr;

/// What to put in the place of some blocks, as in `oak=spruce` or `oak_log[axis=y]=stripped_oak_log`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Replacement {
    /// Every block of a material by its counterpart.
    Material { from: String, to: String },
    /// A block by another, where it has these properties.
    Block { from: BlockState, to: BlockState },
}

/// Why a text is not a replacement.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum BadReplacement {
    #[error("`{0}` does not say what to replace by what: expected two names, as in oak=spruce")]
    NoPair(String),
    #[error(transparent)]
    State(#[from] BadBlockState),
    #[error(transparent)]
    Property(#[from] BadProperty),
    #[error("there is no block or material `{name}`{}", meant(.name))]
    Unknown { name: String },
    #[error(
        "`{from}` is a material, but `{to}` is a block of none: name the block to replace, as in {from}_planks={to}"
    )]
    NoMaterial { from: String, to: String },
    #[error(
        "`{from}` is a block, but `{to}` is a material: name the block to put in its place, as in {from}={to}_planks"
    )]
    NoBlock { from: String, to: String },
}

fn meant(name: &str) -> String {
    suggest(name)
        .or_else(|| suggest_material(name))
        .map_or(String::new(), |meant| format!(": did you mean `{meant}`?"))
}

impl Replacement {
    /// What stands in the place of `state`; `None` where it stays.
    pub fn apply(&self, state: &BlockState) -> Option<BlockState> {
        match self {
            Replacement::Material { from, to } => counterpart(state, from, to),
            Replacement::Block { from, to } => fits(from, state).then(|| with_shared(to, state)),
        }
    }

    /// Whether `state` is of the material to replace, which the other material may have no counterpart of.
    pub fn covers(&self, state: &BlockState) -> bool {
        match self {
            Replacement::Material { from, .. } => counterpart(state, from, from).is_some(),
            Replacement::Block { from, .. } => fits(from, state),
        }
    }

    /// What is to be replaced, as the user wrote it.
    pub fn from(&self) -> String {
        match self {
            Replacement::Material { from, .. } => from.clone(),
            Replacement::Block { from, .. } => from.short(),
        }
    }

    /// What is put in its place.
    pub fn to(&self) -> String {
        match self {
            Replacement::Material { to, .. } => to.clone(),
            Replacement::Block { to, .. } => to.short(),
        }
    }
}

/// Whether `state` is of the block of `pattern` and has all of its properties.
fn fits(pattern: &BlockState, state: &BlockState) -> bool {
    let full = || complete(state);
    pattern.name() == state.name()
        && (pattern.properties().len() == 0
            || pattern.properties().all(|(key, value)| full().get(key) == Some(value)))
}

/// `to` with those properties of `old` that it has as well and does not give itself.
fn with_shared(to: &BlockState, old: &BlockState) -> BlockState {
    let Some(known) = known(to.name()) else { return to.clone() };
    let shared = old.properties().filter(|(key, value)| {
        to.get(key).is_none() && known.property(key).is_some_and(|property| property.values.contains(value))
    });
    shared.fold(to.clone(), |state, (key, value)| state.with(key, value))
}

impl FromStr for Replacement {
    type Err = BadReplacement;

    fn from_str(text: &str) -> Result<Replacement, BadReplacement> {
        let (from, to) = pair(text).ok_or_else(|| BadReplacement::NoPair(text.to_owned()))?;
        if is_material(from) && is_material(to) {
            return Ok(Replacement::Material { from: from.to_owned(), to: to.to_owned() });
        }
        let (from_state, to_state) = (from.parse::<BlockState>()?, to.parse::<BlockState>()?);
        if is_material(to) && known(to).is_none() {
            return Err(not_of_material(&from_state, to));
        }
        require_legal(&from_state)?;
        require_known(&to_state)?;
        if is_material(from) && known(from).is_none() {
            return Err(BadReplacement::NoMaterial { from: from.to_owned(), to: to.to_owned() });
        }
        Ok(Replacement::Block { from: from_state, to: to_state })
    }
}

/// What is looked for must be a state that some version of the game has, or a mod.
fn require_legal(state: &BlockState) -> Result<(), BadReplacement> {
    let oldest = Version::all().next().unwrap_or(Version::newest());
    let raised = translated(state, oldest, Version::newest()).unwrap_or_else(|_| state.clone());
    Ok(check(state).or_else(|problem| check(&raised).map_err(|_| problem))?)
}

/// Why a material cannot stand in the place of `from`, which is none.
fn not_of_material(from: &BlockState, to: &str) -> BadReplacement {
    let name = from.short_name().to_owned();
    match known(&name) {
        None => BadReplacement::Unknown { name },
        Some(_) => BadReplacement::NoBlock { from: name, to: to.to_owned() },
    }
}

/// The two sides of the first `=` that does not belong to a property.
fn pair(text: &str) -> Option<(&str, &str)> {
    let mut open = false;
    let at = text.find(|c| {
        open = c == '[' || (open && c != ']');
        c == '=' && !open
    })?;
    let (from, to) = (text[..at].trim(), text[at + 1..].trim());
    (!from.is_empty() && !to.is_empty()).then_some((from, to))
}

/// What is put in must exist, unless it comes from a mod.
fn require_known(state: &BlockState) -> Result<(), BadReplacement> {
    let of_game = state.name().starts_with("minecraft:");
    match known(state.name()) {
        None if of_game => Err(BadReplacement::Unknown { name: state.short_name().to_owned() }),
        _ => Ok(check(state)?),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn replaced(rule: &str, state: &str) -> Option<String> {
        let rule: Replacement = rule.parse().unwrap();
        rule.apply(&state.parse().unwrap()).map(|state| state.short())
    }

    #[test]
    fn materials_blocks_and_states_are_replaced() {
        let cases = [
            ("oak=spruce", "oak_stairs[facing=east]", Some("spruce_stairs[facing=east]")),
            ("oak=spruce", "dark_oak_stairs[facing=east]", None),
            ("stone=andesite", "stone_slab[type=top]", Some("andesite_slab[type=top]")),
            ("oak_planks=stone", "oak_planks", Some("stone")),
            ("oak_planks=stone", "oak_stairs", None),
            ("oak_log[axis=y]=stripped_oak_log", "oak_log[axis=y]", Some("stripped_oak_log[axis=y]")),
            ("oak_log[axis=y]=stripped_oak_log", "oak_log", Some("stripped_oak_log")),
            ("oak_log[axis=y]=stripped_oak_log", "oak_log[axis=x]", None),
            (
                "oak_stairs=oak_slab",
                "oak_stairs[facing=east,waterlogged=true]",
                Some("oak_slab[waterlogged=true]"),
            ),
            ("oak_slab=oak_slab[type=top]", "oak_slab[type=bottom]", Some("oak_slab[type=top]")),
            ("mod:rock=stone", "mod:rock[a=b]", Some("stone")),
            ("stone=mod:rock[a=b]", "stone", Some("mod:rock[a=b]")),
        ];
        for (rule, state, expected) in cases {
            assert_eq!(replaced(rule, state).as_deref(), expected, "{rule} on {state}");
        }
    }

    #[test]
    fn wrong_replacements_say_what_was_expected() {
        let message = |text: &str| text.parse::<Replacement>().unwrap_err().to_string();
        let cases = [
            ("oak", "`oak` does not say what to replace by what: expected two names, as in oak=spruce"),
            (
                "oak_log[axis=y]",
                "`oak_log[axis=y]` does not say what to replace by what: expected two names, as in oak=spruce",
            ),
            ("stone=cobblestne", "there is no block or material `cobblestne`: did you mean `cobblestone`?"),
            (
                "oak=glass",
                "`oak` is a material, but `glass` is a block of none: name the block to replace, as in oak_planks=glass",
            ),
            ("stone=oak_log[axis=w]", "`oak_log` cannot have axis=w: axis is one of x, y, z"),
            ("oak_log[axis=w]=stone", "`oak_log` cannot have axis=w: axis is one of x, y, z"),
            ("sprce=oak", "there is no block or material `sprce`: did you mean `spruce`?"),
            ("oak=sprice", "there is no block or material `sprice`: did you mean `spruce`?"),
            ("nonsensical=spruce", "there is no block or material `nonsensical`"),
            (
                "oak_planks=spruce",
                "`oak_planks` is a block, but `spruce` is a material: name the block to put in its place, as in \
                 oak_planks=spruce_planks",
            ),
        ];
        for (text, expected) in cases {
            assert_eq!(message(text), expected);
        }
    }
}
