//! All scores of one grammar beside its examples.

use super::cells::{Alphabet, Cells};
use super::distance::distance;
use super::explained::Explained;
use super::length::Length;
use super::novelty::{Novelty, novelty};
use super::odd::Lengths;
use super::patterns::{Seams, Surroundings};
use super::rooms::Rooms;
use super::samples::Samples;
use super::seams::unseen_seams;
use super::soundness::Soundness;
use super::template::template_share;
use crate::graph::OpGraph;
use crate::grid::Grid;
use crate::parse::{Laws, Parser};
use crate::run::Library;

/// A score of the examples and the same of the samples.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Beside<T> {
    pub examples: T,
    pub samples: T,
}

/// How good a grammar is.
#[derive(Clone, PartialEq, Debug)]
pub struct Scores {
    pub examples: usize,
    /// Examples that the grammar derives, block for block.
    pub reproduced: usize,
    /// The share of the examples' blocks that it explains.
    pub coverage: f64,
    /// `None` where not every example is reproduced.
    pub length: Option<Length>,
    /// The share of the reproduced examples' blocks that is learnt by heart; `None` where there are none.
    pub template: Option<f64>,
    pub samples: usize,
    /// Runs that ended in an error.
    pub failed: usize,
    pub novelty: Novelty,
    /// Unseen neighbourhoods of 2 x 2 x 2 for each 1,000 cells.
    pub seams: f64,
    /// Between neighbourhoods of samples and examples: of 2 x 2 x 2 cells, and of 3 x 3 x 3.
    pub distances: [f64; 2],
    /// Parts of a sample, on average, that are far longer or shorter than their like.
    pub odd: f64,
    pub rooms: Beside<Rooms>,
    /// The worst of each.
    pub faults: Beside<Soundness>,
    /// The share of samples with no more faults than some example has.
    pub sound: f64,
}

/// Scores `count` samples of a grammar from a seed on beside the examples.
pub fn scores(
    graph: &OpGraph,
    library: &Library,
    examples: &[Grid],
    first_seed: u64,
    count: usize,
) -> Scores {
    let graph = &graph.unified();
    let parser = Parser::new(graph, Laws::AsWritten).with_library(library);
    let explained = Explained::of(&parser, examples);
    let drawn = Samples::draw(graph, library, first_seed, count);
    let samples = &drawn.made;
    let (seams, distances) = neighbourhoods(samples, examples);
    let faults = |buildings: &[Grid]| buildings.iter().map(Soundness::of).collect::<Vec<Soundness>>();
    let (own, theirs) = (faults(samples), faults(examples));
    let worst = Soundness::worst(theirs.iter().copied());
    let sound = own.iter().filter(|faults| faults.is_no_worse_than(worst)).count();
    Scores {
        examples: examples.len(),
        reproduced: explained.reproduced(),
        coverage: explained.coverage(),
        length: Length::of(graph, &explained, examples),
        template: template_share(graph, &explained.derivations().collect::<Vec<_>>()),
        samples: samples.len(),
        failed: drawn.failed,
        novelty: novelty(samples, examples),
        seams,
        distances,
        odd: odd_parts(graph, &parser, &explained, samples),
        rooms: Beside {
            examples: Rooms::sum(examples.iter().map(Rooms::of)),
            samples: Rooms::sum(samples.iter().map(Rooms::of)),
        },
        faults: Beside { examples: worst, samples: Soundness::worst(own.iter().copied()) },
        sound: sound as f64 / drawn.len().max(1) as f64,
    }
}

fn neighbourhoods(samples: &[Grid], examples: &[Grid]) -> (f64, [f64; 2]) {
    let mut alphabet = Alphabet::default();
    let (samples, examples): (Vec<Cells>, Vec<Cells>) = (alphabet.all(samples), alphabet.all(examples));
    let seams = Seams::of(&examples);
    let near = distance(&Seams::of(&samples), &seams);
    let far = distance(&Surroundings::of(&samples), &Surroundings::of(&examples));
    (unseen_seams(&samples, &seams), [near, far])
}

fn odd_parts(graph: &OpGraph, parser: &Parser<'_>, explained: &Explained, samples: &[Grid]) -> f64 {
    let known = Lengths::of(graph, explained.derivations());
    let derivations = samples.iter().filter_map(|sample| parser.parse(sample).ok());
    let odd: usize = derivations.map(|derivation| known.odd(graph, &derivation)).sum();
    odd as f64 / samples.len().max(1) as f64
}

/// The few scores that say at a glance whether learning went well.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Outline {
    pub length: Option<Length>,
    /// The share of samples that are equal to no example.
    pub novelty: f64,
    /// Unseen neighbourhoods of 2 x 2 x 2 for each 1,000 cells.
    pub seams: f64,
    /// The share of samples with no more faults than some example has.
    pub sound: f64,
}

/// As [`scores`], of the few that take little time.
pub fn outline(graph: &OpGraph, explained: &Explained, examples: &[Grid], count: usize) -> Outline {
    let drawn = Samples::draw(graph, &Library::new(), 0, count);
    let mut alphabet = Alphabet::default();
    let (samples, shown) = (alphabet.all(&drawn.made), alphabet.all(examples));
    let worst = Soundness::worst(examples.iter().map(Soundness::of));
    let sound = drawn.made.iter().filter(|sample| Soundness::of(sample).is_no_worse_than(worst)).count();
    Outline {
        length: Length::of(graph, explained, examples),
        novelty: novelty(&drawn.made, examples).novelty,
        seams: unseen_seams(&samples, &Seams::of(&shown)),
        sound: sound as f64 / drawn.len().max(1) as f64,
    }
}
