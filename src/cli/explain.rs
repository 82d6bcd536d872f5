use super::failure::Failure;
use super::output;
use crate::grammar::{Code, Explanation};

/// Explain a code of an error or a warning: what is wrong, and how to put it right
#[derive(clap::Args)]
#[command(after_help = "Example:\n  vox explain E0101")]
pub struct Args {
    /// The code as a report shows it; without one, all are listed
    code: Option<String>,
}

pub fn execute(args: &Args) -> Result<(), Failure> {
    let text = match &args.code {
        None => list(),
        Some(id) => explained(Code::of_id(id).ok_or_else(|| unknown(id))?.explanation()),
    };
    output::stdout(text.as_bytes())
}

fn list() -> String {
    let lines = Code::ALL.iter().map(|code| format!("{}  {}\n", code.id(), code.explanation().title));
    lines.collect()
}

fn explained(explanation: &Explanation) -> String {
    let Explanation { id, title, text, wrong, right } = explanation;
    let mut out = format!("{id}: {title}\n\n{text}\n");
    for (word, example) in [("Wrong", wrong), ("Right", right)] {
        if !example.is_empty() {
            out += &format!("\n{word}:\n\n");
            example.lines().for_each(|line| out += &format!("    {line}\n"));
        }
    }
    out
}

fn unknown(id: &str) -> Failure {
    Failure::new(format!("there is no code `{id}`")).hint("`vox explain` lists them")
}
