use super::BlockState;
use std::sync::{Arc, OnceLock};

/// A block of the game: its name and the properties it takes.
#[derive(Debug)]
pub struct Known {
    name: &'static str,
    properties: Arc<[Property]>,
}

/// One property of a block with its legal values.
#[derive(Debug)]
pub struct Property {
    pub key: &'static str,
    pub values: Vec<&'static str>,
    pub default: &'static str,
}

/// Why a known block cannot be in a state.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum BadProperty {
    #[error("`{block}` has no property `{key}`: {}", having(legal))]
    Key { block: &'static str, key: String, legal: Vec<&'static str> },
    #[error("`{block}` cannot have {key}={value}: {key} is one of {}", legal.join(", "))]
    Value { block: &'static str, key: &'static str, value: String, legal: Vec<&'static str> },
}

fn having(keys: &[&str]) -> String {
    if keys.is_empty() { "it takes none".to_owned() } else { format!("it takes {}", keys.join(", ")) }
}

impl Known {
    /// The name without its namespace.
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// The properties, sorted by key.
    pub fn properties(&self) -> &[Property] {
        &self.properties
    }

    pub fn property(&self, key: &str) -> Option<&Property> {
        self.properties.iter().find(|property| property.key == key)
    }

    /// The state that placing the block by command gives, with all properties written out.
    pub fn default_state(&self) -> BlockState {
        self.properties.iter().fold(BlockState::known(self.name), |state, p| state.with(p.key, p.default))
    }

    fn check(&self, key: &str, value: &str) -> Result<(), BadProperty> {
        let block = self.name;
        let Some(property) = self.property(key) else {
            let legal = self.properties.iter().map(|p| p.key).collect();
            return Err(BadProperty::Key { block, key: key.to_owned(), legal });
        };
        if property.values.contains(&value) {
            return Ok(());
        }
        let (value, legal) = (value.to_owned(), property.values.clone());
        Err(BadProperty::Value { block, key: property.key, value, legal })
    }
}

/// The block of the game called `name`, which may carry the game's namespace.
pub fn known(name: &str) -> Option<&'static Known> {
    let name = name.strip_prefix("minecraft:").unwrap_or(name);
    let at = all().binary_search_by(|known| known.name.cmp(name)).ok()?;
    Some(&all()[at])
}

/// All blocks of the game, sorted by name.
pub fn all() -> &'static [Known] {
    static TABLE: OnceLock<Vec<Known>> = OnceLock::new();
    TABLE.get_or_init(|| parse(include_str!("blocks.txt")))
}

/// `state` with its absent properties at their defaults. Blocks that are not of the game stay as they are.
pub fn complete(state: &BlockState) -> BlockState {
    let properties = known(state.name()).map_or(&[][..], Known::properties);
    let absent = properties.iter().filter(|property| state.get(property.key).is_none());
    absent.fold(state.clone(), |state, property| state.with(property.key, property.default))
}

/// Whether the block can be in this state. Nothing can be said of blocks that are not of the game.
pub fn check(state: &BlockState) -> Result<(), BadProperty> {
    let Some(known) = known(state.name()) else { return Ok(()) };
    state.properties().try_for_each(|(key, value)| known.check(key, value))
}

fn parse(text: &'static str) -> Vec<Known> {
    let mut table = Vec::new();
    let mut properties: Arc<[Property]> = Arc::new([]);
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        if line.starts_with(' ') {
            let names = line.split_whitespace();
            table.extend(names.map(|name| Known { name, properties: Arc::clone(&properties) }));
        } else {
            properties = line.split(' ').filter_map(property).collect();
        }
    }
    table.sort_by_key(|known| known.name);
    table
}

/// Reads `half=top|bottom*`.
fn property(text: &'static str) -> Option<Property> {
    let (key, values) = text.split_once('=')?;
    let default = values.split('|').find_map(|value| value.strip_suffix('*'))?;
    Some(Property { key, values: values.split('|').map(|v| v.trim_end_matches('*')).collect(), default })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn state(text: &str) -> BlockState {
        text.parse().unwrap()
    }

    #[test]
    fn every_entry_of_the_table_is_read() {
        let entries = include_str!("blocks.txt").lines().filter(|line| line.starts_with(' '));
        let names: Vec<&str> = entries.flat_map(str::split_whitespace).collect();
        assert!(names.len() > 1000);
        assert_eq!(names.len(), all().len());
        assert!(names.iter().all(|name| known(name).is_some()));
        assert!(all().windows(2).all(|pair| pair[0].name < pair[1].name), "no block stands twice");
    }

    #[test]
    fn the_default_state_is_written_out_and_legal() {
        let stairs = known("minecraft:oak_stairs").unwrap().default_state();
        assert_eq!(stairs.short(), "oak_stairs[facing=north,half=bottom,shape=straight,waterlogged=false]");
        for known in all() {
            assert_eq!(check(&known.default_state()), Ok(()), "{}", known.name);
            assert_eq!(known.properties().len(), known.default_state().properties().len());
        }
    }

    #[test]
    fn complete_keeps_what_is_given_and_passes_strangers_through() {
        let full = complete(&state("oak_slab[type=top]"));
        assert_eq!(full.short(), "oak_slab[type=top,waterlogged=false]");
        let stranger = state("mod:thing[a=b]");
        assert_eq!(complete(&stranger), stranger);
    }

    #[test]
    fn a_bad_property_names_the_legal_ones() {
        let message = |text: &str| check(&state(text)).unwrap_err().to_string();
        assert_eq!(
            message("oak_slab[type=left]"),
            "`oak_slab` cannot have type=left: type is one of top, bottom, double"
        );
        assert_eq!(message("stone[lit=true]"), "`stone` has no property `lit`: it takes none");
        assert_eq!(
            message("oak_slab[half=top]"),
            "`oak_slab` has no property `half`: it takes type, waterlogged"
        );
        assert_eq!(check(&state("mod:stone[lit=true]")), Ok(()));
    }
}
