use super::{BlockState, known};
use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::sync::OnceLock;

/// The state in Java Edition of a block of Bedrock Edition with its states there, without what depends on its
/// neighbours; `None` where the table does not know it. The name may carry the game's namespace.
pub fn bedrock_state(name: &str, states: &BTreeMap<String, String>) -> Option<BlockState> {
    let forms = table().get(name.strip_prefix("minecraft:").unwrap_or(name))?;
    forms.iter().find_map(|form| form.state(states))
}

/// How a block was once told; blocks have several forms where the states changed with the versions.
struct Form {
    /// Stands for `*` in names.
    stem: &'static str,
    rules: &'static [Rule],
}

/// How one property follows from Bedrock's states.
struct Rule {
    property: &'static str,
    /// The states that it follows from.
    keys: Vec<&'static str>,
    values: Values,
}

enum Values {
    Always(&'static str),
    /// As the state has it.
    Same,
    /// By the values of the states, joined with `+`.
    By(BTreeMap<&'static str, &'static str>),
}

const NAME: &str = "name";
const NONE: &str = "-";

/// Rules and the blocks that they are of.
type Group = (Vec<Rule>, Vec<&'static str>);

type Table = BTreeMap<&'static str, Vec<Form>>;

fn table() -> &'static Table {
    static RULES: OnceLock<Vec<Group>> = OnceLock::new();
    static TABLE: OnceLock<Table> = OnceLock::new();
    TABLE.get_or_init(|| collect(RULES.get_or_init(|| parse(include_str!("bedrock.txt")))))
}

fn parse(text: &'static str) -> Vec<Group> {
    let mut groups = Vec::new();
    for line in text.lines().filter(|line| !line.is_empty() && !line.starts_with('#')) {
        match (line.strip_prefix("  "), groups.last_mut()) {
            (None, _) => groups.push((line.split(' ').filter_map(rule).collect(), Vec::new())),
            (Some(blocks), Some((_, names))) => names.extend(blocks.split(' ')),
            (Some(_), None) => {}
        }
    }
    groups
}

/// Reads `half=upside_down_bit(0>bottom,1>top)`.
fn rule(word: &'static str) -> Option<Rule> {
    let (property, right) = word.split_once('=')?;
    let Some((keys, values)) = right.strip_suffix(')').and_then(|right| right.split_once('(')) else {
        return Some(Rule { property, keys: Vec::new(), values: Values::Always(right) });
    };
    let values = match values {
        "" => Values::Same,
        values => Values::By(values.split(',').filter_map(|pair| pair.split_once('>')).collect()),
    };
    Some(Rule { property, keys: keys.split('+').collect(), values })
}

/// The forms by the name of the block, those that need most states first.
fn collect(groups: &'static [Group]) -> Table {
    let mut table = Table::new();
    for (rules, blocks) in groups {
        for block in blocks {
            let (name, stem) = block.split_once('>').unwrap_or((block, block));
            table.entry(name).or_default().push(Form { stem, rules });
        }
    }
    table.values_mut().for_each(|forms| forms.sort_by_key(|form| Reverse(form.needs())));
    table
}

impl Form {
    /// How many different states the form takes.
    fn needs(&self) -> usize {
        let mut keys: Vec<&str> = self.rules.iter().flat_map(|rule| rule.keys.iter().copied()).collect();
        keys.sort_unstable();
        keys.dedup();
        keys.len()
    }

    /// `None` where a state is missing, or the name does not follow from them.
    fn state(&self, states: &BTreeMap<String, String>) -> Option<BlockState> {
        let has_keys = |rule: &Rule| rule.keys.iter().all(|&key| states.contains_key(key));
        if !self.rules.iter().all(has_keys) {
            return None;
        }
        let name = match self.rules.iter().find(|rule| rule.property == NAME) {
            None => self.stem.to_owned(),
            Some(rule) => rule.value(states)?.replace('*', self.stem),
        };
        let known = known(&name)?;
        let properties = self.rules.iter().filter_map(|rule| {
            let property = known.property(rule.property)?;
            let value = rule.value(states).filter(|value| property.values.contains(&value.as_str()))?;
            Some((property.key, value))
        });
        let bare = BlockState::known(known.name());
        Some(properties.fold(bare, |state, (key, value)| state.with(key, &value)))
    }
}

impl Rule {
    fn value(&self, states: &BTreeMap<String, String>) -> Option<String> {
        let of = |key: &&str| states.get(*key).map(String::as_str);
        match &self.values {
            Values::Always(value) => Some((*value).to_owned()),
            Values::Same => of(self.keys.first()?).map(str::to_owned),
            Values::By(values) => {
                let key = self.keys.iter().map(of).collect::<Option<Vec<_>>>()?.join("+");
                values.get(key.as_str()).filter(|&&value| value != NONE).map(|&value| value.to_owned())
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::block::check;

    type States<'a> = &'a [(&'a str, &'a str)];

    fn java(name: &str, states: States) -> Option<String> {
        let states = states.iter().map(|&(key, value)| (key.to_owned(), value.to_owned())).collect();
        bedrock_state(name, &states).map(|state| state.short())
    }

    #[test]
    fn names_and_states_of_all_times() {
        let cases: [(&str, States, &str); 10] = [
            ("minecraft:stone", &[], "stone"),
            ("minecraft:stone", &[("stone_type", "andesite")], "andesite"),
            (
                "oak_stairs",
                &[("weirdo_direction", "2"), ("upside_down_bit", "1")],
                "oak_stairs[facing=south,half=top]",
            ),
            (
                "stone_stairs",
                &[("weirdo_direction", "0"), ("upside_down_bit", "0")],
                "cobblestone_stairs[facing=east,half=bottom]",
            ),
            ("oak_log", &[("pillar_axis", "x")], "oak_log[axis=x]"),
            ("fence", &[("wood_type", "birch")], "birch_fence"),
            ("chest", &[("minecraft:cardinal_direction", "west")], "chest[facing=west]"),
            ("chest", &[("facing_direction", "4")], "chest[facing=west]"),
            ("torch", &[("torch_facing_direction", "top")], "torch"),
            ("torch", &[("torch_facing_direction", "west")], "wall_torch[facing=east]"),
        ];
        for (name, states, expected) in cases {
            assert_eq!(java(name, states).as_deref(), Some(expected), "{name} {states:?}");
        }
    }

    #[test]
    fn halves_of_doors_say_what_counts_in_them() {
        let door = |upper| {
            let states =
                [("direction", "1"), ("door_hinge_bit", "1"), ("open_bit", "1"), ("upper_block_bit", upper)];
            java("wooden_door", &states).unwrap()
        };
        assert_eq!(door("0"), "oak_door[facing=south,half=lower,open=true]");
        assert_eq!(door("1"), "oak_door[half=upper,hinge=right]");
    }

    #[test]
    fn what_is_not_in_the_table_has_no_state() {
        assert_eq!(java("mod:thing", &[]), None);
        assert_eq!(java("fence", &[]), None, "a state is missing");
        assert_eq!(java("torch", &[("torch_facing_direction", "up")]), None, "the name does not follow");
    }

    /// All that a form can be asked: each of its rules' listed values at once.
    fn questions(form: &Form) -> Vec<BTreeMap<String, String>> {
        let mut questions = vec![BTreeMap::new()];
        for rule in form.rules {
            let Values::By(values) = &rule.values else { continue };
            let answers = |question: &BTreeMap<String, String>| {
                let with = |value: &&str| {
                    let pairs = rule.keys.iter().map(|key| (*key).to_owned());
                    let mut more = question.clone();
                    pairs.zip(value.split('+')).for_each(|(key, value)| {
                        more.entry(key).or_insert_with(|| value.to_owned());
                    });
                    more
                };
                values.keys().map(with).collect::<Vec<_>>()
            };
            questions = questions.iter().flat_map(answers).collect();
            questions.sort();
            questions.dedup();
        }
        questions
    }

    #[test]
    fn every_state_of_the_table_is_legal() {
        let mut states = 0;
        for (name, forms) in table() {
            assert!(forms.iter().all(|form| !form.stem.is_empty() && form.stem != "-"), "{name}");
            for question in forms.iter().flat_map(questions) {
                if let Some(state) = bedrock_state(name, &question) {
                    assert_eq!(check(&state), Ok(()), "{name} {question:?}");
                    states += 1;
                }
            }
        }
        assert!(table().len() > 1000, "{} blocks", table().len());
        assert!(states > 5000, "{states} states");
    }
}
