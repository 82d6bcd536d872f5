//! Every sample of our grammars has a derivation.

mod grammar_files;
#[path = "common/real.rs"]
mod real;

use grammar_files::{GrammarFile, all_in, root};
use vox::grid::Grid;
use vox::infer::{Example, Freedom, Method, infer};
use vox::io::{Content, Limits, SchemVersion, decode, encode_schem};
use vox::parse::{Laws, Parser};
use vox::run::{Library, Options, run};
use vox::space::Cell;

/// Grammars with what parsing does not follow, and what that is.
const NOT_FOLLOWED: [(&str, &str); 5] = [
    ("grammars/family-home.grammar", "roofs and trees reach out of their scopes"),
    ("grammars/office.grammar", "snap planes move the ends of parts"),
    ("grammars/simple-building.grammar", "roofs reach out of their scopes"),
    ("grammars/small/move-and-resize.grammar", "beams are moved out of their scope"),
    ("grammars/village.grammar", "roofs reach out of their scopes"),
];

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
        let failed = (0..3).filter(|&seed| !parser.derives(&file.run(None, seed).made)).count();
        let is_followed = NOT_FOLLOWED.iter().all(|(other, _)| *other != name);
        if (failed == 0) != is_followed {
            wrong.push(format!("{name}: {failed} of 3 samples without a derivation"));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn what_is_written_and_read_back_has_the_same_derivation() {
    for name in ["cottage", "garage"] {
        let file = GrammarFile::read(root().join("grammars").join(name).with_extension("grammar"));
        let graph = file.graph();
        for seed in 0..4 {
            let made = file.run(None, seed).made;
            let bytes = encode_schem(&made, SchemVersion::V2).unwrap().bytes;
            let Content::Grid(read) = decode(&bytes, &Limits::default()).unwrap().content else {
                unreachable!()
            };
            let parsed = [&made, &read].map(|grid| Parser::new(&graph, Laws::AsWritten).parse(grid).unwrap());
            assert_eq!(parsed[0], parsed[1], "{name} {seed}");
        }
    }
}

/// Under the rules of another village: a nearest derivation is found in bounded time, and says what it explains.
#[test]
fn real_houses_are_covered_in_part_by_the_rules_of_their_neighbours() {
    let Some(data) = real::folder() else { return };
    let folder = data.join("houses/village-oak");
    let mut paths: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "schem"));
    paths.sort();
    let houses: Vec<Grid> = paths.iter().map(|path| grammar_files::grid(path)).collect();
    let (left_out, others) = houses.split_first().unwrap();
    let examples: Vec<Example> = others.iter().cloned().map(Example::Blocks).collect();
    let graph = infer(&examples, Method::default(), Freedom::default()).unwrap().graph;
    let unexplained = Parser::new(&graph, Laws::AsWritten).parse(left_out).unwrap_err();
    assert!(unexplained.explained < unexplained.cells, "{unexplained:?}");
    assert!(left_out.bounds().contains_box(&unexplained.region));
}

#[test]
fn blocks_that_gained_properties_later_are_derived_as_they_were() {
    for state in ["barrier", "skeleton_skull[rotation=3]", "player_wall_head[facing=east]"] {
        let mut house = Grid::new(Cell::new(2, 1, 1));
        for (x, name) in [state, "stone"].into_iter().enumerate() {
            let id = house.intern(&name.parse().unwrap()).unwrap();
            house.set(Cell::new(x as i32, 0, 0), id);
        }
        house.metadata.data_version = Some(3120);
        let example = Example::Blocks(house.clone());
        let learnt = infer(&[example], Method::Boxes, Freedom::Seen).unwrap();
        assert!(Parser::new(&learnt.graph, Laws::AsWritten).derives(&house), "{state}");
        let made = run(&learnt.graph, &Library::new(), &Options::default()).unwrap().made;
        assert!(made.same_blocks(&house), "{state}");
    }
}
