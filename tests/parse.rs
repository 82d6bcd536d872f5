//! Every sample of our grammars has a derivation.

#[path = "grammar_files/mod.rs"]
mod grammar_files;

use grammar_files::{GrammarFile, all_in};
use vox::parse::{Laws, Parser};
use vox::run::Library;

/// Grammars with what parsing does not follow, and what that is.
const NOT_FOLLOWED: [(&str, &str); 0] = [];

fn library(file: &GrammarFile) -> Library {
    let folder = file.path.parent().unwrap();
    let graph = file.graph();
    graph.files().into_iter().map(|name| (name.to_owned(), grammar_files::grid(&folder.join(name)))).collect()
}

#[test]
fn every_sample_of_our_grammars_has_a_derivation() {
    let mut wrong = Vec::new();
    for file in all_in("grammars") {
        let name = file.name();
        let (graph, library) = (file.graph(), library(&file));
        let parser = Parser::new(&graph, Laws::AsWritten).with_library(&library);
        let failed = (0..6).filter(|&seed| !parser.derives(&file.run(None, seed).made)).count();
        let is_followed = NOT_FOLLOWED.iter().all(|(other, _)| *other != name);
        if (failed == 0) != is_followed {
            wrong.push(format!("{name}: {failed} of 6 samples without a derivation"));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
