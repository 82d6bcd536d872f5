use crate::grammar::ast::Carving;
use crate::space::{Corner, Footprint, Frame, Rect, Spot, Turn, View, Wall};
use smallvec::{SmallVec, smallvec};

/// Whether a component lies on top or at the bottom.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Level {
    Top,
    Bottom,
}

/// The faces that a component lies on.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Sides {
    pub level: Option<Level>,
    /// Where the upright ones look: what turns the south there. The first is that of the component's axes.
    pub walls: SmallVec<[Turn; 2]>,
}

impl Sides {
    pub fn level(level: Level) -> Sides {
        Sides { level: Some(level), walls: SmallVec::new() }
    }

    pub fn wall(turn: Turn) -> Sides {
        Sides { level: None, walls: smallvec![turn] }
    }

    fn at(&self, level: Level) -> Sides {
        Sides { level: Some(level), ..self.clone() }
    }
}

/// A face, an edge or a vertex: what it lies on, and its cells in the plan.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Component {
    pub sides: Sides,
    pub plan: Rect,
}

/// The order of the upright faces of a frame that is not turned: front, back, left, right.
pub const UPRIGHT: [i32; 4] = [0, 2, 3, 1];

/// All components of a kind, in order: those on top, those at the bottom, upright ones. Among these, walls
/// stand front, back, left, right, those of each face from the front left on, then the steps likewise; corners stand
/// from the front left to the back right.
pub fn components(how: Carving, footprint: &Footprint, frame: Frame, depth: i32) -> Vec<Component> {
    let walls = walls(footprint, frame, depth);
    let strips = || walls.iter().map(|wall| strip(wall, depth)).collect();
    let corners = || corners(&walls, footprint, frame, depth);
    match how {
        Carving::Faces => {
            let all = |level| Component { sides: Sides::level(level), plan: footprint.area() };
            [vec![all(Level::Top), all(Level::Bottom)], strips()].concat()
        }
        Carving::Edges => [levelled(&strips()), corners()].concat(),
        Carving::Vertices => levelled(&corners()),
        _ => strips(),
    }
}

/// Upright components where they meet the top, then where they meet the bottom.
fn levelled(upright: &[Component]) -> Vec<Component> {
    let at = |level| upright.iter().map(move |one| Component { sides: one.sides.at(level), plan: one.plan });
    at(Level::Top).chain(at(Level::Bottom)).collect()
}

fn walls(footprint: &Footprint, frame: Frame, depth: i32) -> Vec<Wall> {
    let view = View::of(footprint.area(), frame);
    let mut walls = footprint.walls();
    walls.sort_by_key(|wall| {
        let [a, b] = [view.place(wall.cells.min), view.place(wall.cells.max - 1)];
        let nearest = a.min(b);
        (is_step(wall, depth), rank(wall.turn, frame), nearest.y, nearest.x)
    });
    walls
}

/// Whether a wall is a step of a slanting or a round edge, and no longer than it is thick: it yields its only post to
/// the wall around the corner.
fn is_step(wall: &Wall, depth: i32) -> bool {
    wall.len() <= depth.max(1) && wall.ends[0] != wall.ends[1]
}

/// The place of a face in their order.
fn rank(turn: Turn, frame: Frame) -> Option<usize> {
    UPRIGHT.iter().position(|quarters| frame.turn + Turn::quarters(*quarters) == turn)
}

/// The cells along a wall, so many deep; of no depth, the line in front of them.
fn strip(wall: &Wall, depth: i32) -> Component {
    let outward = wall.outward();
    let more = -outward * (depth - 1);
    let plan = Rect::new(wall.cells.min + more.min(Spot::ZERO), wall.cells.max + more.max(Spot::ZERO));
    Component { sides: Sides::wall(wall.turn), plan: if depth > 0 { plan } else { line(wall) } }
}

/// The line between a wall and what lies in front of it.
fn line(wall: &Wall) -> Rect {
    let Rect { min, max } = wall.cells;
    let outward = wall.outward();
    let from = Spot::select(outward.cmpgt(Spot::ZERO), max, min);
    let to = Spot::select(outward.cmplt(Spot::ZERO), min, max);
    Rect::new(from, to)
}

/// Where walls meet. Every corner is at the right end of one wall.
fn corners(walls: &[Wall], footprint: &Footprint, frame: Frame, depth: i32) -> Vec<Component> {
    let view = View::of(footprint.area(), frame);
    let mut walls: Vec<&Wall> = walls.iter().collect();
    walls.sort_by_key(|wall| {
        let place = view.place(corner(wall, frame, 1).plan.min);
        (place.y, place.x)
    });
    walls.into_iter().map(|wall| corner(wall, frame, depth)).collect()
}

/// The post at the right end of a wall: at its end where the edge turns away, behind the other wall where the edge
/// turns towards who looks at it.
fn corner(wall: &Wall, frame: Frame, depth: i32) -> Component {
    let (next, beyond) = match wall.ends[1] {
        Corner::Convex => (Turn::quarters(1), 0),
        Corner::Reflex => (Turn::quarters(3), depth),
    };
    let (outward, right) = (wall.outward(), wall.right());
    let mut faces: SmallVec<[Turn; 2]> = smallvec![wall.turn, wall.turn + next];
    faces.sort_by_key(|turn| rank(*turn, frame));
    // The point of the plan between four cells.
    let vertex = Spot::select((outward + right).cmpgt(Spot::ZERO), wall.cells.max, wall.cells.min);
    let inner = vertex - outward * depth + right * (beyond - depth);
    let outer = vertex + right * beyond;
    Component {
        sides: Sides { level: None, walls: faces },
        plan: Rect::new(inner.min(outer), inner.max(outer)),
    }
}
