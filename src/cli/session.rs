//! A session in which a designer chooses every rule (seed 3, "Production of Similar Structures": co-creation).

use super::failure::Failure;
use super::output;
use super::picture;
use super::summary::counted;
use crate::shapes::{self, Application, Derivation, Growth, Placed, Production, ShapeGrammar};
use crate::space::Cell;
use std::fmt::Write;
use std::io::BufRead;

/// So many rules are offered at a time.
const PAGE: usize = 6;

const HELP: &str = "\
  1, 2, ...  apply that rule       more, back  other rules
  undo       take the last back    random      apply any of the rules
  look       draw the building     done        write it; `quit` writes nothing
";

/// What the designer says.
enum Answer {
    Apply(usize),
    More,
    Back,
    Undo,
    Random,
    Look,
    Done,
    Quit,
    Unknown(String),
}

impl Answer {
    fn of(line: &str) -> Answer {
        match line.trim() {
            "more" | "m" => Answer::More,
            "back" | "b" => Answer::Back,
            "undo" | "u" => Answer::Undo,
            "random" | "r" => Answer::Random,
            "look" | "l" => Answer::Look,
            "done" | "d" => Answer::Done,
            "quit" | "q" => Answer::Quit,
            other => other.parse().map_or_else(|_| Answer::Unknown(other.to_owned()), Answer::Apply),
        }
    }
}

/// Asks for one rule after the other, on standard input, and gives what was chosen. The seed says which shape is first.
pub fn run(grammar: &ShapeGrammar, growth: &Growth) -> Result<Derivation, Failure> {
    let first = Growth { steps: 0, ..*growth };
    let mut derivation = shapes::grow(grammar, &first);
    let mut page = 0;
    say(&format!("{HELP}\n"))?;
    let mut lines = std::io::stdin().lock().lines();
    loop {
        let production = derivation.production_as_chosen(grammar).map_err(Failure::new)?;
        let offers = offers(grammar, &production, growth.most);
        page = page.min(offers.len().saturating_sub(1) / PAGE);
        say(&offered(grammar, &production, &offers, page))?;
        // The end of the input ends the session.
        let line = lines.next().transpose().map_err(|error| Failure::of_file("standard input", error))?;
        match line.map_or(Answer::Done, |line| Answer::of(&line)) {
            Answer::Apply(number) => match offers.get(number.wrapping_sub(1)) {
                Some((step, _)) => derivation.steps.push(*step),
                None => say(&format!("there is no rule {number}\n"))?,
            },
            Answer::Random => derivation.steps.extend(drawn(&offers, growth.seed, derivation.steps.len())),
            Answer::More => page += 1,
            Answer::Back => page = page.saturating_sub(1),
            Answer::Undo if derivation.steps.pop().is_none() => say("there is nothing to undo\n")?,
            Answer::Undo => {}
            Answer::Look => say(&picture::building(grammar, &production))?,
            Answer::Done => return Ok(derivation),
            Answer::Quit => return Err(Failure::new("the session was left: nothing is written")),
            Answer::Unknown(word) => say(&format!("`{word}` is none of these:\n{HELP}"))?,
        }
    }
}

fn say(text: &str) -> Result<(), Failure> {
    output::stdout(text.as_bytes())
}

/// The rules that fit, each with the shape that it gives; those that give the same are one.
fn offers(grammar: &ShapeGrammar, production: &Production<'_>, most: Cell) -> Vec<(Application, Placed)> {
    let mut offers: Vec<(Application, Placed)> = Vec::new();
    for (shape, left) in production.placed().iter().enumerate() {
        for (rule, found) in grammar.rules_of(left.form) {
            let placed = grammar.right(found, left);
            let is_new = offers
                .iter()
                .all(|(_, other)| (other.form, other.placement) != (placed.form, placed.placement));
            if is_new && production.fits(&placed) && shapes::is_within(production, &placed, most) {
                offers.push((Application { shape, rule }, placed));
            }
        }
    }
    offers
}

/// A choice that is the same each time.
fn drawn(offers: &[(Application, Placed)], seed: u64, step: usize) -> Option<Application> {
    let mixed = (seed ^ (step as u64 + 1)).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 33;
    let index = (mixed as usize).checked_rem(offers.len())?;
    Some(offers[index].0)
}

fn offered(
    grammar: &ShapeGrammar,
    production: &Production<'_>,
    offers: &[(Application, Placed)],
    page: usize,
) -> String {
    let mut text = String::new();
    let shapes = counted(production.placed().len() as u64, "shape", "shapes");
    let _ = writeln!(text, "{shapes}, {} to choose from", counted(offers.len() as u64, "rule", "rules"));
    let shown = offers.iter().enumerate().skip(page * PAGE).take(PAGE);
    for (number, (step, placed)) in shown {
        let _ = writeln!(
            text,
            "\n{:>3}  {}, beside shape {}",
            number + 1,
            picture::words(grammar, placed),
            step.shape + 1
        );
        text += &picture::shape(grammar, production, placed);
    }
    let left = offers.len().saturating_sub((page + 1) * PAGE);
    if left > 0 {
        let _ = writeln!(text, "\n     {left} more");
    }
    text + "> "
}
