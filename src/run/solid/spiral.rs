use crate::block::{BlockState, Family};
use crate::space::{Cell, Rect, Scope, Spot, View};

/// How many blocks the stair rises in one turn: a step, and the room to stand on it.
const RISE: i32 = 4;

/// Steps around a post in the middle, half a block each where there are slabs. They start at the front on the left
/// and go to the right; the last one is level with the top of the scope.
pub fn spiral_stair(family: &Family, scope: &Scope, put: &mut dyn FnMut(Cell, &BlockState)) {
    let view = View::of(Rect::under(&scope.bounds), scope.frame);
    let post = post(view.lengths());
    let round = around(post);
    let (low, height) = (scope.bounds.min.y, scope.bounds.size().y);
    for place in Rect::new(Spot::ZERO, view.lengths()).spots() {
        let spot = view.spot(place);
        let mut put = |level: i32, state: &BlockState| put(Cell::new(spot.x, low + level, spot.y), state);
        // The steps next to the post reach out to the edge.
        let inner = place.clamp(post.min - 1, post.max);
        match round.iter().position(|&step| step == inner) {
            None => (0..height).for_each(|level| put(level, family.log.as_ref().unwrap_or(&family.full))),
            Some(number) => steps(number, round.len(), family, height, &mut put),
        }
    }
}

/// All steps over one another at one place of a round.
fn steps(number: usize, round: usize, family: &Family, height: i32, put: &mut dyn FnMut(i32, &BlockState)) {
    let parts = if family.slab.is_some() { 2 } else { 1 };
    let first = (RISE as usize * parts * number / round) as i32 + 1;
    let tops = (first..=height * parts as i32).step_by(RISE as usize * parts);
    for top in tops {
        match &family.slab {
            None => put(top - 1, &family.full),
            Some(slab) if top % 2 == 1 => put(top / 2, &slab.clone().with("type", "bottom")),
            Some(slab) => put(top / 2 - 1, &slab.clone().with("type", "top")),
        }
    }
}

/// The post: as thin as leaves flights of the same width all around.
fn post(lengths: Spot) -> Rect {
    let flight = (lengths.min_element() - 1) / 2;
    Rect::new(Spot::splat(flight), lengths - flight)
}

/// The places next to the post in the order of the steps, from the front left corner to the right.
fn around(post: Rect) -> Vec<Spot> {
    let (low, high) = (post.min - 1, post.max);
    let front = (low.x..high.x).map(|u| Spot::new(u, low.y));
    let right = (low.y..high.y).map(|v| Spot::new(high.x, v));
    let back = (low.x + 1..=high.x).rev().map(|u| Spot::new(u, high.y));
    let left = (low.y + 1..=high.y).rev().map(|v| Spot::new(low.x, v));
    front.chain(right).chain(back).chain(left).collect()
}
