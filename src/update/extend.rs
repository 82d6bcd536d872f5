//! Alternatives, one after the other, until a grammar derives a house.

use super::Task;
use super::alternative::{Candidate, anew, candidates};
use super::bound::bound;
use super::change::Change;
use super::lengths;
use super::start::Manner;
use super::texts::{Program, Texts};
use crate::parse::{Derivation, Laws};
use crate::score::model_bits;

/// Alternatives that are written for one house, at the most.
const MOST_ROUNDS: usize = 12;
/// Operations that one search may look at: many searches are made.
const STEPS: u64 = 1 << 15;
/// What a cell costs that no rule explains: about what it takes to say which block it is, and where.
const BITS_A_CELL: f64 = 12.0;

/// A grammar on its way, and how much of the house it explains at what length.
struct Way {
    texts: Texts,
    changes: Vec<Change>,
    program: Program,
    nearest: Derivation,
    lost: u64,
    bits: f64,
}

impl Task<'_> {
    /// With further alternatives, and wider numbers beside them; and with all of the house as one alternative. The
    /// shorter comes first.
    pub fn extended(&self, texts: &Texts, program: &Program) -> Vec<(Texts, Vec<Change>, Manner)> {
        let parts = self.way(texts.clone(), Vec::new()).and_then(|start| self.by_parts(start));
        let parts = parts.map(|way| (way, Manner::Widened));
        let anew = self.anew(texts, program).map(|way| (way, Manner::Apart));
        let mut all: Vec<(Way, Manner)> = parts.into_iter().chain(anew).collect();
        all.sort_by(|(one, _), (other, _)| one.bits.total_cmp(&other.bits));
        all.into_iter().map(|(way, manner)| (way.texts, way.changes, manner)).collect()
    }

    fn by_parts(&self, start: Way) -> Option<Way> {
        let mut way = start;
        for _ in 0..MOST_ROUNDS {
            way = self.next(&way)?;
            if way.lost == 0 && self.is_derived(&way.program) {
                return Some(way);
            }
        }
        None
    }

    /// The shortest of all that explain more by one change.
    fn next(&self, way: &Way) -> Option<Way> {
        let mut tried = candidates(&way.program, &way.nearest, &self.open);
        tried.extend(self.widening(&way.program));
        let ways = tried.into_iter().filter_map(|Candidate { edits, changes }| {
            let changes = way.changes.iter().cloned().chain(changes).collect();
            self.way(way.texts.edited(&edits), changes)
        });
        ways.filter(|next| next.lost < way.lost).min_by(|one, other| one.bits.total_cmp(&other.bits))
    }

    /// Wider numbers, where they explain more.
    fn widening(&self, program: &Program) -> Option<Candidate> {
        let nearest = self.parser(program, Laws::Stretched).with_steps(STEPS).nearest(self.house)?;
        let (edits, changes) = lengths::widened(program, &nearest)?;
        (!edits.is_empty()).then_some(Candidate { edits, changes })
    }

    fn way(&self, texts: Texts, changes: Vec<Change>) -> Option<Way> {
        let program = texts.read()?;
        let nearest = self.parser(&program, Laws::AsWritten).with_steps(STEPS).nearest(self.house)?;
        let lost = nearest.lost();
        let bits = model_bits(&program.graph) + nearest.bits + BITS_A_CELL * lost as f64;
        Some(Way { texts, changes, program, nearest, lost, bits })
    }

    /// All of the house as one alternative of the rule that a run starts with.
    fn anew(&self, texts: &Texts, program: &Program) -> Option<Way> {
        let (texts, mut changes) =
            bound(texts, program, self.size(program), self.library).unwrap_or((texts.clone(), Vec::new()));
        let program = texts.read()?;
        let Candidate { edits, changes: more } = anew(&program, &self.open)?;
        changes.extend(more);
        let texts = texts.edited(&edits);
        let program = texts.read()?;
        // A large house takes more steps than each of many searches may.
        let nearest = self.parser(&program, Laws::AsWritten).parse(self.house).ok()?;
        let bits = model_bits(&program.graph) + nearest.bits;
        Some(Way { texts, changes, program, nearest, lost: 0, bits })
    }
}
