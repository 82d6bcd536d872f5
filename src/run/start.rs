use super::error::{Kind, RunError};
use super::eval::{Around, Env, Things, World};
use super::place::Place;
use crate::graph::OpGraph;
use crate::space::Cell;

/// The size of the start scope that a grammar states, in its own axes; one drawn by weight of several.
pub fn start_size(graph: &OpGraph, seed: u64) -> Result<Cell, RunError> {
    if graph.sizes.is_empty() {
        return Err(RunError::anywhere(Kind::NoSize));
    }
    draw_size(graph, seed).map_err(RunError::anywhere)
}

fn draw_size(graph: &OpGraph, seed: u64) -> Result<Cell, Kind> {
    let things = Things::default();
    let world = World::new(graph, &things, seed)?;
    let around = Around::start(seed);
    let mut env = Env::new(&world, &around, None, Place::start(seed).named("size"));
    let mut weights = Vec::with_capacity(graph.sizes.len());
    for start in &graph.sizes {
        weights.push(env.number(&start.weight)?);
    }
    let chosen = &graph.sizes[weighted(&weights, env.draw())?].size;
    let mut size = Cell::ZERO;
    for (at, length) in chosen.iter().enumerate() {
        size[at] = env.number(length)?.round() as i32;
    }
    Ok(size)
}

/// The index of a weight, drawn in proportion by a number from 0 up to 1.
pub fn weighted(weights: &[f64], draw: f64) -> Result<usize, Kind> {
    if let Some(&bad) = weights.iter().find(|weight| **weight < 0.0) {
        return Err(Kind::Weight(bad));
    }
    let total: f64 = weights.iter().sum();
    if total <= 0.0 {
        return Err(Kind::Weight(total));
    }
    let mut left = draw * total;
    for (at, weight) in weights.iter().enumerate() {
        left -= weight;
        if left < 0.0 {
            return Ok(at);
        }
    }
    // The draw was within rounding of the total: the last weight that is not zero has it.
    Ok(weights.iter().rposition(|weight| *weight > 0.0).unwrap_or(0))
}
