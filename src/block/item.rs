use super::pattern::{fits, table};
use super::{BlockState, complete};
use std::sync::OnceLock;

/// The items that placing a block takes, each with how many. Of blocks of mods, the item of the same name.
pub fn items(state: &BlockState) -> Vec<(String, u64)> {
    let state = complete(state);
    let rule = rules().iter().find_map(|rule| Some((rule, rule.matched(&state)?)));
    let mut items = match rule {
        Some((rule, star)) => rule.items.iter().map(|item| item.of(&state, star)).collect(),
        None => vec![(state.short_name().to_owned(), 1)],
    };
    if state.get("waterlogged") == Some("true") {
        items.push(("water_bucket".to_owned(), 1));
    }
    items
}

/// How many of an item make a stack.
pub fn stack(item: &str) -> u64 {
    let stacks = table(include_str!("stacks.txt")).find(|(pattern, _)| fits(pattern, item));
    stacks.and_then(|(_, size)| size.parse().ok()).unwrap_or(64)
}

/// A line of the table for one pattern.
struct Rule {
    /// The name before and after the `*`; all of the name where there is none.
    name: (&'static str, Option<&'static str>),
    properties: Vec<(&'static str, &'static str)>,
    items: Vec<Item>,
}

struct Item {
    count: Count,
    name: &'static str,
}

enum Count {
    Number(u64),
    Property(&'static str),
    Sides,
}

impl Rule {
    /// The text that the `*` stands for, where the rule is for `state`.
    fn matched<'s>(&self, state: &'s BlockState) -> Option<&'s str> {
        let has_all = self.properties.iter().all(|(key, value)| state.get(key) == Some(value));
        let star = match self.name {
            (head, Some(tail)) => state.short_name().strip_prefix(head)?.strip_suffix(tail)?,
            (name, None) => state.short_name().strip_prefix(name).filter(|rest| rest.is_empty())?,
        };
        has_all.then_some(star)
    }
}

impl Item {
    fn of(&self, state: &BlockState, star: &str) -> (String, u64) {
        let number = |key| state.get(key).and_then(|value| value.parse().ok()).unwrap_or(1);
        let count = match self.count {
            Count::Number(number) => number,
            Count::Property(key) => number(key),
            Count::Sides => state.properties().filter(|(_, value)| *value == "true").count().max(1) as u64,
        };
        (self.name.replace('@', state.short_name()).replace('*', star), count)
    }
}

fn rules() -> &'static [Rule] {
    static RULES: OnceLock<Vec<Rule>> = OnceLock::new();
    RULES.get_or_init(|| {
        let lines = include_str!("items.txt").lines().filter(|line| !line.starts_with('#'));
        let rules = lines.filter_map(|line| line.split_once(" = "));
        rules.flat_map(|(names, items)| names.split_whitespace().map(move |name| rule(name, items))).collect()
    })
}

/// Reads `*_door[half=upper]` and what it is placed with.
fn rule(pattern: &'static str, value: &'static str) -> Rule {
    let (name, properties) = pattern.split_once('[').unwrap_or((pattern, ""));
    let properties = properties.trim_end_matches(']').split(',').filter_map(|pair| pair.split_once('='));
    let name = name.split_once('*').map_or((name, None), |(head, tail)| (head, Some(tail)));
    let items = value.split(" + ").filter(|item| *item != "-").map(item).collect();
    Rule { name, properties: properties.collect(), items }
}

/// Reads `2 @` or `[candles] @`.
fn item(text: &'static str) -> Item {
    let (count, name) = text.rsplit_once(' ').unwrap_or(("1", text));
    let property = count.trim_start_matches('[').trim_end_matches(']');
    let count = match count.parse() {
        Ok(number) => Count::Number(number),
        Err(_) if property == "sides" => Count::Sides,
        Err(_) => Count::Property(property),
    };
    Item { count, name }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::block::all;

    fn text(state: &str) -> String {
        let items = items(&state.parse().unwrap());
        let items: Vec<String> = items.iter().map(|(item, count)| format!("{count} {item}")).collect();
        items.join(" + ")
    }

    #[test]
    fn blocks_are_placed_with_their_items() {
        let cases = [
            ("stone", "1 stone"),
            ("air", ""),
            ("mod:thing[a=b]", "1 mod:thing"),
            ("oak_door[half=lower]", "1 oak_door"),
            ("oak_door[half=upper]", ""),
            ("red_bed[part=head]", ""),
            ("lilac[half=upper]", ""),
            ("lilac[half=lower]", "1 lilac"),
            ("oak_stairs[half=top]", "1 oak_stairs"),
            ("oak_slab[type=double]", "2 oak_slab"),
            ("oak_slab[type=top,waterlogged=true]", "1 oak_slab + 1 water_bucket"),
            ("red_candle[candles=3]", "3 red_candle"),
            ("red_candle_cake", "1 cake + 1 red_candle"),
            ("candle_cake", "1 cake + 1 candle"),
            ("wall_torch", "1 torch"),
            ("soul_wall_torch", "1 soul_torch"),
            ("oak_wall_sign", "1 oak_sign"),
            ("oak_wall_hanging_sign", "1 oak_hanging_sign"),
            ("player_wall_head", "1 player_head"),
            ("water[level=0]", "1 water_bucket"),
            ("water[level=3]", ""),
            ("wheat[age=3]", "1 wheat_seeds"),
            ("potted_poppy", "1 flower_pot + 1 poppy"),
            ("potted_azalea_bush", "1 flower_pot + 1 azalea"),
            ("vine[north=true,east=true]", "2 vine"),
            ("pink_petals[flower_amount=4]", "4 pink_petals"),
            ("redstone_wire", "1 redstone"),
        ];
        for (state, expected) in cases {
            assert_eq!(text(state), expected, "{state}");
        }
    }

    #[test]
    fn every_rule_is_for_a_block_that_no_earlier_rule_takes() {
        let states: Vec<BlockState> = all()
            .iter()
            .flat_map(|known| {
                let each = known.properties().iter().flat_map(|p| p.values.iter().map(|v| (p.key, *v)));
                let states = each.map(|(key, value)| known.default_state().with(key, value));
                std::iter::once(known.default_state()).chain(states).collect::<Vec<_>>()
            })
            .collect();
        for (at, rule) in rules().iter().enumerate() {
            let first = |state: &BlockState| rules().iter().position(|rule| rule.matched(state).is_some());
            assert!(
                states.iter().any(|state| first(state) == Some(at)),
                "{:?} {:?}",
                rule.name,
                rule.properties
            );
        }
    }

    #[test]
    fn counting_properties_exist() {
        for known in all() {
            let state = known.default_state();
            let rule = rules().iter().find(|rule| rule.matched(&state).is_some());
            for item in rule.map_or(&[][..], |rule| &rule.items) {
                if let Count::Property(key) = item.count {
                    assert!(known.property(key).is_some(), "{} has no {key}", known.name());
                }
            }
        }
    }

    #[test]
    fn stacks_are_those_of_the_game() {
        for (item, size) in [
            ("stone", 64),
            ("oak_sign", 16),
            ("oak_hanging_sign", 16),
            ("red_bed", 1),
            ("shulker_box", 1),
            ("bucket", 16),
            ("water_bucket", 1),
            ("oak_door", 64),
        ] {
            assert_eq!(stack(item), size, "{item}");
        }
    }
}
