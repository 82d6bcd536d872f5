use super::batch::{Batch, OUTPUT};
use super::failure::Failure;
use super::input::Limit;
use super::output::Writing;
use super::report;
use super::summary::counted;
use super::template::Template;
use crate::block::{self, BlockState, Replacement};
use crate::grid::Replaced;
use crate::neighbours::{follow, settle};
use std::path::PathBuf;

/// Replace blocks by others: whole materials, single blocks or states
///
/// What both blocks have stays: which way stairs face, which half of a door it is, whether it stands in water. Each block
/// is replaced once, by the first replacement that it fits.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  vox replace house.schem spruce-house.schem oak=spruce stone=andesite
  vox replace house.schem new.schem 'oak_log[axis=y]=stripped_oak_log' glass=white_stained_glass
  vox replace '*.schem' 'out/{name}.schem' white=red

A word that blocks are made of (oak, stone, white) stands for all of them: planks, stairs, doors, signs.
The name of a block stands for that block only, with properties for those states only.")]
pub struct Args {
    /// What to read: a file, a pattern in quotes, or - for standard input
    input: PathBuf,
    #[arg(help = OUTPUT)]
    output: Template,
    /// What to replace by what: oak=spruce
    #[arg(required = true, value_name = "FROM=TO")]
    replacements: Vec<Replacement>,
    #[command(flatten)]
    limit: Limit,
    #[command(flatten)]
    writing: Writing,
}

pub fn execute(args: Args) -> Result<(), Failure> {
    let Args { input, output, replacements, limit, writing } = args;
    let batch = Batch { inputs: vec![input], output, limit, writing };
    batch.each_grid(|name, mut grid| {
        let old = grid.clone();
        let before: Vec<BlockState> = old.counts().into_iter().map(|(state, _)| state.clone()).collect();
        let replaced = grid.replace(&replacements).map_err(|error| Failure::of_file(name, error))?;
        if replaced.blocks.iter().all(|count| *count == 0) {
            return Err(missed(name, &before, &replacements[0]));
        }
        // What the old blocks could not say of the new ones their neighbours do, and the other way round.
        settle(&mut grid)
            .and_then(|()| follow(&old, &mut grid))
            .map_err(|error| Failure::of_file(name, error))?;
        tell(name, &before, &replacements, &replaced);
        Ok(grid)
    })
}

fn tell(name: &str, before: &[BlockState], replacements: &[Replacement], replaced: &Replaced) {
    for (rule, count) in replacements.iter().zip(&replaced.blocks) {
        match count {
            0 => {
                report::warning(&format!("{name}: nothing here is `{}`: {}", rule.from(), hint(before, rule)))
            }
            count => report::note(&format!(
                "{name}: replaced {} of {} by {}",
                counted(*count, "block", "blocks"),
                rule.from(),
                rule.to()
            )),
        }
    }
    if !replaced.left.is_empty() {
        let left: Vec<&str> = replaced.left.iter().map(String::as_str).collect();
        report::warning(&format!("{name}: left as they are, for want of a counterpart: {}", left.join(", ")));
    }
    if replaced.block_entities > 0 {
        let count = counted(replaced.block_entities as u64, "block", "blocks");
        report::warning(&format!("{name}: what was in {count} is gone with them"));
    }
}

fn missed(name: &str, before: &[BlockState], rule: &Replacement) -> Failure {
    let covered: Vec<&str> =
        before.iter().filter(|state| rule.covers(state)).map(BlockState::short_name).collect();
    let Some(first) = covered.first() else {
        return Failure::of_file(name, format!("nothing here is `{}`", rule.from())).hint(hint(before, rule));
    };
    let failure = Failure::of_file(name, format!("`{}` has no counterpart of {first}", rule.to()));
    failure.hint(format!("name what to put in its place: {first}={}", rule.to()))
}

/// What may have been meant: a block that there is, or one that is there.
fn hint(before: &[BlockState], rule: &Replacement) -> String {
    const ALIKE: f64 = 0.85;
    let from = rule.from();
    let is_slip = !block::is_material(&from) && block::known(&from).is_none();
    let there = before.iter().map(BlockState::short_name);
    let alike =
        there.map(|name| (strsim::jaro_winkler(&from, name), name)).filter(|(alike, _)| *alike > ALIKE);
    let nearest = || alike.max_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(a.1))).map(|(_, name)| name);
    match is_slip.then(|| block::suggest(&from).or_else(nearest)).flatten() {
        Some(name) => format!("did you mean `{name}`?"),
        None => "`vox info` lists the blocks of a file".to_owned(),
    }
}
