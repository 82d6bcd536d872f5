//! Updates: a grammar comes to derive further houses, and what people wrote in it stays. Knows nothing of files on disk.
//!
//! Edits are made on the text, so that all they leave alone stays byte for byte.

mod alternative;
mod change;
mod demand;
mod fills;
mod graft;
mod growth;
mod layout;
mod learnt;
mod lengths;
mod names;
mod start;
mod texts;
mod weight;

use crate::grid::Grid;
use crate::infer::Example;
use crate::parse::{Derivation, Laws, Parser};
use crate::run::Library;
use crate::score::model_bits;
use crate::space::{Axis, Cell, Frame, Scope, Turn};
use alternative::{Candidate, candidates};

pub use change::Change;
pub use texts::{Program, Texts};

/// A grammar that derives a house.
#[derive(Clone, Debug)]
pub struct Updated {
    pub texts: Texts,
    /// Nothing where the grammar derived the house before.
    pub changes: Vec<Change>,
}

/// Why a grammar stays as it is.
#[derive(Clone, Copy, PartialEq, Eq, Debug, thiserror::Error)]
pub enum UpdateError {
    #[error("the house is empty: it holds nothing but air")]
    Empty,
    #[error("no change to the grammar was found with which it derives this house")]
    NotFound,
    #[error("the grammar does not read")]
    Unread,
}

/// Alternatives that are written for one house, at the most.
const MOST_ROUNDS: usize = 12;
/// Operations that one search may look at: many are made.
const STEPS: u64 = 1 << 18;
/// What a cell costs that no rule explains: about what it takes to say which block it is, and where.
const BITS_A_CELL: f64 = 8.0;

/// Changes a grammar as little as may be so that it derives a house.
///
/// First numbers are widened, if that is enough. Else alternatives are added, those with which grammar and house are
/// shortest to describe.
pub fn update(texts: &Texts, house: &Grid, library: &Library) -> Result<Updated, UpdateError> {
    let program = texts.read().ok_or(UpdateError::Unread)?;
    if house.occupied().is_none() {
        return Err(UpdateError::Empty);
    }
    let open = Example::Blocks(house.clone()).open().into_grid().unwrap_or_else(|| house.clone());
    let task = Task { house, open, library };
    let (texts, mut changes) = if task.is_derived(&program) {
        (texts.clone(), Vec::new())
    } else if let Some(widened) = task.widened(texts, &program) {
        widened
    } else {
        task.extended(texts).ok_or(UpdateError::NotFound)?
    };
    let (texts, sized) = task.started(&texts).ok_or(UpdateError::NotFound)?;
    changes.extend(sized);
    Ok(Updated { texts, changes })
}

/// A house to be derived.
struct Task<'h> {
    house: &'h Grid,
    /// The same without what the neighbours of its blocks decide.
    open: Grid,
    library: &'h Library,
}

/// How much of a house a grammar explains, and at what length.
struct Standing {
    nearest: Derivation,
    lost: u64,
    bits: f64,
}

impl Task<'_> {
    fn is_derived(&self, program: &Program) -> bool {
        Parser::new(&program.graph, Laws::AsWritten).with_library(self.library).derives(self.house)
    }

    /// With wider numbers, where no more is needed.
    fn widened(&self, texts: &Texts, program: &Program) -> Option<(Texts, Vec<Change>)> {
        let parser = Parser::new(&program.graph, Laws::Stretched).with_library(self.library);
        let derivation = parser.parse(self.house).ok()?;
        let (edits, changes) = lengths::widened(program, &derivation)?;
        let texts = texts.edited(&edits);
        let program = texts.read()?;
        self.is_derived(&program).then_some((texts, changes))
    }

    /// With further alternatives, and wider numbers beside them.
    fn extended(&self, texts: &Texts) -> Option<(Texts, Vec<Change>)> {
        let (mut texts, mut changes) = (texts.clone(), Vec::new());
        let mut program = texts.read()?;
        let mut standing = self.standing(&program)?;
        for _ in 0..MOST_ROUNDS {
            let tried = self.tried(&texts, &program, &standing);
            let best = tried.into_iter().min_by(|one, other| one.2.bits.total_cmp(&other.2.bits))?;
            let (edited, more, next) = best;
            if next.bits >= standing.bits {
                return None;
            }
            texts = edited;
            changes.extend(more);
            program = texts.read()?;
            standing = next;
            if standing.lost == 0 && self.is_derived(&program) {
                return Some((texts, changes));
            }
        }
        None
    }

    /// All single changes, and what each comes to.
    fn tried(
        &self,
        texts: &Texts,
        program: &Program,
        standing: &Standing,
    ) -> Vec<(Texts, Vec<Change>, Standing)> {
        let mut all = candidates(program, &standing.nearest, &self.open);
        all.extend(self.widening(program));
        let judged = all.into_iter().filter_map(|Candidate { edits, changes }| {
            let edited = texts.edited(&edits);
            let standing = self.standing(&edited.read()?)?;
            Some((edited, changes, standing))
        });
        judged.collect()
    }

    /// Wider numbers, where they explain more.
    fn widening(&self, program: &Program) -> Option<Candidate> {
        let parser = Parser::new(&program.graph, Laws::Stretched).with_library(self.library).with_steps(STEPS);
        let (edits, changes) = lengths::widened(program, &parser.nearest(self.house)?)?;
        (!edits.is_empty()).then_some(Candidate { edits, changes })
    }

    fn standing(&self, program: &Program) -> Option<Standing> {
        let parser = Parser::new(&program.graph, Laws::AsWritten).with_library(self.library).with_steps(STEPS);
        let nearest = parser.nearest(self.house)?;
        let lost = nearest.lost();
        let bits = model_bits(&program.graph) + nearest.bits + BITS_A_CELL * lost as f64;
        Some(Standing { nearest, lost, bits })
    }

    /// With a start scope of the house's size.
    fn started(&self, texts: &Texts) -> Option<(Texts, Vec<Change>)> {
        let program = texts.read()?;
        let scope = Scope { bounds: self.house.bounds(), frame: Frame { up: program.graph.up, turn: Turn::NONE } };
        let size = Cell::from(Axis::ALL.map(|axis| scope.len(axis)));
        start::started(texts, &program, size, self.library)
    }
}
