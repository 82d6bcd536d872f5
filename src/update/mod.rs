//! Updates: a grammar comes to derive further houses, and what people wrote in it stays. Knows nothing of files on disk.
//!
//! Edits are made on the text, so that all they leave alone stays byte for byte.

mod alternative;
mod bound;
mod change;
mod condition;
mod demand;
mod extend;
mod fills;
mod graft;
mod growth;
mod layout;
mod learnt;
mod lengths;
mod names;
mod reuse;
mod start;
mod texts;
mod trial;
mod version;
mod weight;

use crate::grid::Grid;
use crate::infer::Example;
use crate::parse::{Laws, Parser};
use crate::run::Library;
use crate::space::{Axis, Cell, Frame, Scope, Turn};
use start::{Manner, started};
use trial::failures;
use version::raised;

pub use change::Change;
pub use texts::{Edit, Program, Texts};
pub use trial::TRIALS;

/// A grammar that derives a house.
#[derive(Clone, Debug)]
pub struct Updated {
    pub texts: Texts,
    /// Nothing where the grammar derived the house before.
    pub changes: Vec<Change>,
    /// Of [`TRIALS`] runs, how many more than before end in an error.
    pub failures: usize,
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

/// Operations that the search for wider numbers may look at.
const STRETCHING_STEPS: u64 = 1 << 20;

/// A house to be derived.
struct Task<'h> {
    house: &'h Grid,
    /// The same without what the neighbours of its blocks decide.
    open: Grid,
    library: &'h Library,
}

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
    task.updated(texts, &program).ok_or(UpdateError::NotFound)
}

impl Task<'_> {
    /// The first way with which no more runs fail than before, or the one with which fewest do.
    fn updated(&self, texts: &Texts, program: &Program) -> Option<Updated> {
        if self.is_derived(program) {
            return self.started(texts, Vec::new(), program, Manner::Widened);
        }
        let started = |(texts, changes, manner): (Texts, Vec<Change>, Manner)| {
            self.started(&texts, changes, program, manner)
        };
        let widened = self.widened(texts, program).map(|(texts, changes)| (texts, changes, Manner::Widened));
        let widened = widened.and_then(started);
        if widened.as_ref().is_some_and(|updated| updated.failures == 0) {
            return widened;
        }
        let extended = self.extended(texts, program).into_iter().filter_map(started);
        extended.chain(widened).min_by_key(|updated| updated.failures)
    }

    /// With a start scope of the house's size, if the grammar then derives the house.
    fn started(
        &self,
        texts: &Texts,
        mut changes: Vec<Change>,
        before: &Program,
        manner: Manner,
    ) -> Option<Updated> {
        let size = self.size(before);
        let (mut texts, sized) = started(texts, size, manner, self.library)?;
        changes.extend(sized);
        if changes.is_empty() {
            return Some(Updated { texts, changes, failures: 0 });
        }
        let program = texts.read()?;
        if let Some((raised, change)) = raised(&texts, &program, self.house) {
            texts = raised;
            changes.push(change);
        }
        let [now, before] = [&program, before].map(|program| failures(program, size, self.library));
        let updated = Updated { texts, changes, failures: now.saturating_sub(before) };
        self.is_derived(&program).then_some(updated)
    }

    /// The size of the house in the grammar's axes.
    fn size(&self, program: &Program) -> Cell {
        let frame = Frame { up: program.graph.up, turn: Turn::NONE };
        let scope = Scope { bounds: self.house.bounds(), frame };
        Cell::from(Axis::ALL.map(|axis| scope.len(axis)))
    }

    fn parser<'p>(&'p self, program: &'p Program, laws: Laws) -> Parser<'p> {
        Parser::new(&program.graph, laws).with_library(self.library)
    }

    fn is_derived(&self, program: &Program) -> bool {
        self.parser(program, Laws::AsWritten).derives(self.house)
    }

    /// With wider numbers, where no more is needed.
    fn widened(&self, texts: &Texts, program: &Program) -> Option<(Texts, Vec<Change>)> {
        let parser = self.parser(program, Laws::Stretched).with_steps(STRETCHING_STEPS);
        let derivation = parser.parse(self.house).ok()?;
        let (edits, changes) = lengths::widened(program, &derivation)?;
        let texts = texts.edited(&edits);
        self.is_derived(&texts.read()?).then_some((texts, changes))
    }
}
