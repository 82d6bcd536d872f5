//! The grammars that the tool of seed 4 derived, to be measured as our own are.

use std::collections::BTreeMap;
use vox::facade::{Length, Rule, RuleItem, Rules, Side, Symbol};

/// How many steps a unit has: only whether lengths are equal matters.
const STEPS: f64 = 1000.0;

/// The rules of a text: each line has a name, the axis (0 for x), whether it repeats, the number of parts, and for each
/// part its size, a colour, whether it is a terminal, and its name.
pub fn rules(text: &str) -> Rules {
    let lines: Vec<Vec<&str>> = text.lines().map(|line| line.split_whitespace().collect()).collect();
    let lines: Vec<&Vec<&str>> = lines.iter().filter(|words| words.len() > 4).collect();
    let names: BTreeMap<&str, usize> = lines.iter().enumerate().map(|(at, words)| (words[0], at)).collect();
    let mut labels: Vec<&str> = Vec::new();
    let mut list = Vec::new();
    for words in &lines {
        let axis = if words[1] == "0" { Side::X } else { Side::Y };
        let parts: Vec<(Length, Symbol)> = words[4..]
            .chunks_exact(9)
            .map(|part| {
                let length: f64 = part[axis.index()].parse().unwrap();
                let symbol = match part[7] {
                    "0" => Symbol::Rule(names[part[8]]),
                    _ => {
                        Symbol::Label(labels.iter().position(|label| *label == part[8]).unwrap_or_else(|| {
                            labels.push(part[8]);
                            labels.len() - 1
                        }) as u32)
                    }
                };
                (Length::Blocks((length * STEPS).round() as u32), symbol)
            })
            .collect();
        let items = match words[2] {
            "1" => vec![RuleItem { times: 2, parts }],
            _ => parts.into_iter().map(|part| RuleItem { times: 1, parts: vec![part] }).collect(),
        };
        list.push(Rule { axis, items });
    }
    Rules { list, labels: labels.len(), of: Vec::new() }
}
