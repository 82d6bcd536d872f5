use super::component::{Level, Sides};
use crate::grammar::ast::{Carving, Face, Selector};
use crate::space::{Frame, Turn};

/// Which of the selectors of a carving names a part.
///
/// A part that several name belongs to the one that says most: a number, then most faces, then most of them
/// by name rather than as `side` or `all`; else to the first.
pub struct Selection<'g> {
    how: Carving,
    /// How the scope lies in the world.
    turn: Turn,
    selectors: Vec<&'g Selector>,
}

impl<'g> Selection<'g> {
    pub fn new(how: Carving, turn: Turn, selectors: impl Iterator<Item = &'g Selector>) -> Selection<'g> {
        Selection { how, turn, selectors: selectors.collect() }
    }

    /// The axes of a component: those of its first upright face, unless strips are cut off, which keep their scope's.
    pub fn frame(&self, sides: &Sides, frame: Frame) -> Frame {
        match sides.walls.first() {
            Some(&turn) if self.how != Carving::Setback => Frame { turn, ..frame },
            _ => frame,
        }
    }

    /// Whether a carving has parts on top and at the bottom.
    pub fn has_levels(&self) -> bool {
        self.how != Carving::Setback
    }

    /// The selector of a part that has a word of its own.
    pub fn of(&self, part: &Selector) -> Option<usize> {
        self.selectors.iter().position(|selector| *selector == part)
    }

    /// The selector of a component.
    pub fn chosen(&self, number: usize, sides: &Sides) -> Option<usize> {
        let ranked = self.selectors.iter().enumerate().rev();
        let matching = ranked.filter_map(|(at, selector)| Some((self.rank(selector, number, sides)?, at)));
        matching.max_by_key(|(rank, _)| *rank).map(|(_, at)| at)
    }

    /// How much a selector says of a component; `None` if it does not name it.
    fn rank(&self, selector: &Selector, number: usize, sides: &Sides) -> Option<[usize; 3]> {
        match selector {
            Selector::Index(at) => (*at as usize == number).then_some([1, 0, 0]),
            Selector::On(faces) => {
                let count = |like: fn(&Face) -> bool| faces.iter().filter(|face| like(face)).count();
                let sided = count(|face| *face == Face::Side);
                let precise = count(|face| !matches!(face, Face::Side | Face::All));
                let holds = faces.iter().all(|face| self.lies_on(sides, *face, faces.len()));
                holds.then_some([0, precise, sided])
            }
            _ => None,
        }
    }

    fn lies_on(&self, sides: &Sides, face: Face, named: usize) -> bool {
        let faces = |turn: Turn| sides.walls.contains(&turn);
        let quarters = |quarters| self.turn + Turn::quarters(quarters);
        match face {
            Face::Top => sides.level == Some(Level::Top),
            Face::Bottom => sides.level == Some(Level::Bottom),
            Face::Front => faces(quarters(0)),
            Face::Right => faces(quarters(1)),
            Face::Back => faces(quarters(2)),
            Face::Left => faces(quarters(3)),
            Face::South => faces(Turn::quarters(0)),
            Face::East => faces(Turn::quarters(1)),
            Face::North => faces(Turn::quarters(2)),
            Face::West => faces(Turn::quarters(3)),
            // Every edge lies on a side: alone it names the upright ones.
            Face::Side if self.how == Carving::Edges && named == 1 => sides.level.is_none(),
            Face::Side => !sides.walls.is_empty(),
            Face::All => true,
        }
    }
}
