//! `vox infer --update`: a grammar comes to derive further buildings.

use super::failure::Failure;
use super::input::{self, Program, Reading, is_stdio};
use super::output::{self, Output};
use super::report;
use super::settings::Settings;
use crate::graph::dot;
use crate::update::{Change, TRIALS, Texts, Updated, update};
use serde_json::json;
use std::path::{Path, PathBuf};

/// What the command line asks for.
pub struct Task<'a> {
    pub grammar: &'a Path,
    pub houses: &'a [PathBuf],
    pub output: &'a Path,
    pub dot: Option<&'a Path>,
    pub reading: Reading,
    pub json: bool,
}

pub fn execute(task: &Task<'_>) -> Result<(), Failure> {
    let Program { sources, graph, .. } = input::program(task.grammar, None, &Settings::default())?;
    let library = input::library(&graph, task.grammar)?;
    let before = Texts::of(&sources);
    let paths = input::paths(task.houses)?;
    let (mut texts, mut changes) = (before.clone(), Vec::new());
    for path in &paths {
        let house = input::grid(path, &task.reading)?;
        let updated = update(&texts, &house, &library);
        let Updated { texts: next, changes: more, failures } =
            updated.map_err(|error| Failure::of_file(&input::name(path), error))?;
        if failures > 0 {
            report::warning(&format!(
                "{}: of {TRIALS} runs of the updated grammar {failures} more than before end in an error: \
                 some of its rules do not fit together any more",
                input::name(path)
            ));
        }
        texts = next;
        changes.push(more);
    }
    let texts = texts.laid_out_as(&before);
    let outputs = outputs(task, &before, &texts)?;
    output::write(&outputs, &paths)?;
    tell(task, &paths, &changes)
}

/// The files to write: those that changed, and a new one in any case.
fn outputs(task: &Task<'_>, before: &Texts, texts: &Texts) -> Result<Vec<Output>, Failure> {
    let is_elsewhere = task.output != task.grammar || is_stdio(task.output);
    let mut outputs = Vec::new();
    for (name, text) in texts.changed(before).filter(|(name, _)| *name != texts.root()) {
        if is_elsewhere {
            let failure = Failure::of_file(name, "this imported file has to change as well");
            return Err(failure.hint("without `-o`, all files of the grammar are changed in place"));
        }
        outputs.push(Output::new(Path::new(name), text));
    }
    let root = texts.get(texts.root());
    if is_elsewhere || root != before.get(before.root()) {
        outputs.push(Output::new(task.output, root));
    }
    if let Some(path) = task.dot {
        let graph = texts.read().map(|program| program.graph);
        outputs.extend(graph.map(|graph| Output::new(path, dot(&graph))));
    }
    Ok(outputs)
}

fn tell(task: &Task<'_>, paths: &[PathBuf], changes: &[Vec<Change>]) -> Result<(), Failure> {
    if task.json {
        let houses = paths.iter().zip(changes).map(|(path, changes)| {
            let changes: Vec<String> = changes.iter().map(Change::to_string).collect();
            json!({ "file": input::name(path), "changes": changes })
        });
        return output::json(&json!({ "houses": houses.collect::<Vec<serde_json::Value>>() }));
    }
    for (path, changes) in paths.iter().zip(changes) {
        let name = input::name(path);
        match changes.is_empty() {
            true => report::note(&format!("{name}: the grammar derives it already")),
            false => changes.iter().for_each(|change| report::note(&format!("{name}: {change}"))),
        }
    }
    Ok(())
}
