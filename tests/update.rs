//! Known grammars, learnt from a few samples and edited by hand, take in further samples.

mod grammar_files;

use grammar_files::{GrammarFile, root};
use vox::grammar::{Sources, read};
use vox::graph::{OpGraph, lower, raise};
use vox::grid::Grid;
use vox::infer::{Example, Freedom, Method, infer};
use vox::parse::{Laws, Parser};
use vox::run::Library;
use vox::score::Samples;
use vox::update::{Change, Texts, Updated, update};

fn graph(text: &str) -> OpGraph {
    lower(&read(text).unwrap(), None).unwrap()
}

fn derives(text: &str, houses: &[Grid]) -> Vec<bool> {
    let graph = graph(text);
    let parser = Parser::new(&graph, Laws::AsWritten);
    houses.iter().map(|house| parser.derives(house)).collect()
}

/// What people do to a learnt grammar: other names, a comment on every rule, another layout.
fn edited(learnt: &str) -> String {
    let lines = learnt.lines().map(|line| match line.contains(" --> ") {
        true => format!("// Ada: see below\n{}   # by hand\n", line.replace(" --> ", "  -->  ")),
        false => format!("{line}\n"),
    });
    lines.collect::<String>().replace("house", "cabin").replace("_body", "_hall")
}

#[test]
fn edits_survive_further_houses() {
    for name in ["garage", "cottage", "tower", "wing", "walls-by-axis"] {
        let file = GrammarFile::read(root().join(format!("tests/truth/{name}.grammar")));
        let houses = Samples::draw(&file.graph(), &Library::new(), 100, 7).made;
        let (known, new) = houses.split_at(5);
        let examples: Vec<Example> = known.iter().cloned().map(Example::Blocks).collect();
        let learnt = infer(&examples, Method::Joint, Freedom::Seen).unwrap().graph;
        let before = edited(&raise(&learnt).to_string());
        let mut texts = Texts::of(&Sources::of("a.grammar", &before));
        let mut widened = 0;
        for house in new {
            let Updated { texts: next, changes, .. } = update(&texts, house, &Library::new()).unwrap();
            texts = next;
            widened += changes.iter().filter(|change| matches!(change, Change::Widened { .. })).count();
        }
        let after = texts.get("a.grammar");
        assert_eq!(derives(after, &houses), [true; 7], "{name}:\n{after}");
        let (kept, all) = (lines_kept(&before, after), before.lines().count());
        assert!(
            kept + widened >= all,
            "{name}: {kept} of {all} lines are left, {widened} numbers wider\n{after}"
        );
        assert_eq!(before.matches("Ada").count(), after.matches("Ada").count());
    }
}

/// How many lines of a text are in another one, in that order.
fn lines_kept(before: &str, after: &str) -> usize {
    let mut rest = after.lines();
    before
        .lines()
        .filter(|line| rest.clone().any(|other| other == *line) && rest.any(|other| other == *line))
        .count()
}
