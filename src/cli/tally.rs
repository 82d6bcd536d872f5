//! The report of a run: how often each label was derived, and what stands there.

use crate::grid::{Grid, LabelledBox};
use crate::run::Labels;
use serde_json::{Value, json};
use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::fmt::Write;

/// Counts over one building or several.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    labels: BTreeMap<String, u64>,
    placed: BTreeMap<String, u64>,
}

impl Tally {
    pub fn labels(&mut self, labels: &Labels<'_>) {
        labels.counts().into_iter().for_each(|(label, times)| add(&mut self.labels, label.to_owned(), times));
    }

    pub fn blocks(&mut self, grid: &Grid) {
        for (state, count) in grid.counts().into_iter().filter(|(state, _)| !state.is_nothing()) {
            add(&mut self.placed, state.short_name().to_owned(), count);
        }
    }

    pub fn boxes(&mut self, boxes: &[LabelledBox]) {
        boxes.iter().for_each(|labelled| add(&mut self.placed, labelled.label.clone(), 1));
    }

    /// With the counts of another.
    pub fn join(&mut self, other: Tally) {
        other.labels.into_iter().for_each(|(label, times)| add(&mut self.labels, label, times));
        other.placed.into_iter().for_each(|(name, count)| add(&mut self.placed, name, count));
    }

    pub fn as_json(&self) -> Value {
        json!({ "labels": self.labels, "placed": self.placed })
    }

    pub fn text(&self) -> String {
        table("derived", &self.labels) + &table("placed", &self.placed)
    }
}

fn add(counts: &mut BTreeMap<String, u64>, name: String, count: u64) {
    *counts.entry(name).or_insert(0) += count;
}

/// The most frequent first.
fn table(verb: &str, counts: &BTreeMap<String, u64>) -> String {
    let mut rows: Vec<(&String, &u64)> = counts.iter().collect();
    // The sort keeps the order of names among equals.
    rows.sort_by_key(|(_, count)| Reverse(**count));
    let mut text = format!("{verb}:\n");
    for (name, count) in rows {
        let _ = writeln!(text, "{count:>10}  {name}");
    }
    text
}
