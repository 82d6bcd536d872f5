//! The shell of any body: its faces, edges or vertices take cells in their order, so that a cell that lies on several
//! belongs to the first of those that are named.

use super::component::{Component, Level, components};
use super::level::{Slab, Story, stacked, stories};
use super::{Body, Piece, Selection};
use crate::grammar::ast::{Carving, Selector};
use crate::space::Scope;

/// A component that a selector names.
struct Named<'c> {
    number: usize,
    chosen: usize,
    component: &'c Component,
}

/// The named components of a body, `depth` blocks thick, and what is left within.
pub fn shell(how: Carving, depth: i32, body: &Body, selection: &Selection) -> Vec<Piece> {
    let components = components(how, &body.ground(), body.scope.frame, depth);
    let named = named(&components, selection);
    let height = |level| {
        let is_named = named.iter().any(|one| one.component.sides.level == Some(level));
        if is_named { depth } else { 0 }
    };
    let mut stories = stories(body, height(Level::Bottom), height(Level::Top));
    let every = components.len() + 1;
    let mut pieces = Vec::new();
    for Named { number, chosen, component } in named {
        let scope = Scope { frame: selection.frame(&component.sides, body.scope.frame), ..body.scope };
        let bodies = match depth {
            0 => vec![flat(component, body, scope)],
            _ => stacked(taken(&mut stories, component), &scope),
        };
        pieces.extend(numbered(bodies, chosen, number, every));
    }
    if let Some(chosen) = selection.of(&Selector::Inside) {
        let bodies = stacked(stories.iter().map(Story::rest), &body.scope);
        pieces.extend(numbered(bodies, chosen, components.len(), every));
    }
    pieces
}

fn named<'c>(components: &'c [Component], selection: &Selection) -> Vec<Named<'c>> {
    let numbered = components.iter().enumerate();
    let named = numbered.filter_map(|(number, component)| {
        let chosen = selection.chosen(number, &component.sides)?;
        Some(Named { number, chosen, component })
    });
    named.collect()
}

/// What a component takes of what is left.
fn taken(stories: &mut [Story], one: &Component) -> impl Iterator<Item = Slab> {
    let level = one.sides.level;
    let mine = stories.iter_mut().filter(move |story| level.is_none() || story.level == level);
    mine.map(|story| story.take(one.plan))
}

/// Pieces of one part: the first has the part's number, and no two of a carving have the same.
fn numbered(bodies: Vec<Body>, chosen: usize, number: usize, every: usize) -> impl Iterator<Item = Piece> {
    let numbers = (number..).step_by(every);
    bodies.into_iter().zip(numbers).map(move |(body, number)| Piece { chosen, number, body })
}

/// A component of no thickness, in the boundary of the body.
fn flat(one: &Component, body: &Body, scope: Scope) -> Body {
    let [low, high] = body.levels();
    let [low, high] = match one.sides.level {
        None => [low, high],
        Some(Level::Top) => [high, high],
        Some(Level::Bottom) => [low, low],
    };
    let footprint = if one.sides.walls.is_empty() { body.footprint.clone() } else { None };
    Body { scope: Scope { bounds: one.plan.between(low, high), ..scope }, footprint }
}
