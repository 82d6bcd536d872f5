//! Running a grammar again whenever one of its files changes.

use super::failure::Failure;
use super::input;
use super::report;
use super::run::{self, Args};
use super::summary::counted;
use crate::grid::{Diff, Grid};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

/// How long a change may stay unseen. The few files of a grammar are looked at again and again: that sees editors which
/// write anew, rename or delete, on every kind of disk.
const PAUSE: Duration = Duration::from_millis(200);

/// What was made last, by the file that it was written to.
type Buildings = BTreeMap<PathBuf, Grid>;

/// Runs again and again; `rounds` bounds how often.
pub fn watch(args: &Args, rounds: Option<u32>) -> Result<(), Failure> {
    if input::is_stdio(args.grammar()) {
        return Err(Failure::new("standard input cannot be watched: name the grammar's file"));
    }
    let mut buildings = Buildings::new();
    let mut schematics = Vec::new();
    for round in 1.. {
        let mut files = input::files_of(args.grammar());
        files.extend_from_slice(&schematics);
        // Taken before anything is read, so that a change while it runs is seen as well.
        let stamps = stamps(&files);
        match run(args, &mut buildings) {
            Ok(named) => schematics = named,
            Err(Failure::Pipe) => return Err(Failure::Pipe),
            Err(failure) => {
                failure.report();
            }
        }
        if round == 1 {
            report::note(&format!("watching {}; Ctrl+C ends", counted(files.len() as u64, "file", "files")));
        }
        if rounds == Some(round) {
            break;
        }
        // A schematic that was named just now is looked at from the next round on.
        while self::stamps(&files) == stamps {
            std::thread::sleep(PAUSE);
        }
    }
    Ok(())
}

/// Runs once, and tells what has changed since the last time. Gives back the schematics that the grammar names.
fn run(args: &Args, buildings: &mut Buildings) -> Result<Vec<PathBuf>, Failure> {
    let ready = run::ready(args)?;
    let folder = args.grammar().parent().unwrap_or(Path::new(""));
    let schematics = ready.files().into_iter().map(|file| folder.join(file)).collect();
    let mut changes = Changes::default();
    run::build(args, &ready, &mut |path, grid| {
        if let Some(old) = buildings.insert(path.to_owned(), grid.clone()) {
            changes.add(&Diff::of(&old, grid));
        }
    })?;
    if changes.compared > 0 {
        report::note(&changes.text());
    }
    Ok(schematics)
}

/// When a file was changed last, and its length; `None` where it is not there.
fn stamps(files: &[PathBuf]) -> Vec<Option<(SystemTime, u64)>> {
    let stamp = |path: &PathBuf| {
        let data = std::fs::metadata(path).ok()?;
        Some((data.modified().ok()?, data.len()))
    };
    files.iter().map(stamp).collect()
}

/// How many blocks came, went and became others, over all buildings of a round.
#[derive(Debug, Default)]
struct Changes {
    compared: u64,
    added: u64,
    removed: u64,
    changed: u64,
}

impl Changes {
    fn add(&mut self, diff: &Diff) {
        self.compared += 1;
        for block in &diff.blocks {
            let [from, to] = block.states.each_ref().map(|state| state.is_nothing());
            let count = match (from, to) {
                (true, false) => &mut self.added,
                (false, true) => &mut self.removed,
                _ => &mut self.changed,
            };
            *count += block.count;
        }
    }

    fn text(&self) -> String {
        match self.added + self.removed + self.changed {
            0 => "no block is different".to_owned(),
            _ => format!("{} added, {} removed, {} changed", self.added, self.removed, self.changed),
        }
    }
}
