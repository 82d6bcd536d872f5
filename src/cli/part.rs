//! Which part of a building is meant.

use super::failure::Failure;
use super::input::Reading;
use super::report;
use crate::grid::Grid;
use crate::io::Options;
use crate::space::{Bounds, Cell};
use std::str::FromStr;

/// A place on the command line: `100,64,-20`.
#[derive(Clone, Copy, Debug)]
pub struct CellArg(pub Cell);

impl FromStr for CellArg {
    type Err = String;

    fn from_str(text: &str) -> Result<CellArg, String> {
        match numbers(text).as_deref() {
            Some(&[x, y, z]) => Ok(CellArg(Cell::new(x, y, z))),
            _ => Err("expected a place, as in 100,64,-20".to_owned()),
        }
    }
}

fn numbers(text: &str) -> Option<Vec<i32>> {
    text.split(',').map(|number| number.trim().parse().ok()).collect()
}

/// A box on the command line: `0,0,0,8,6,11`, two corners that are both inside.
#[derive(Clone, Copy, Debug)]
pub struct BoxArg(pub Bounds);

impl FromStr for BoxArg {
    type Err = String;

    fn from_str(text: &str) -> Result<BoxArg, String> {
        let Some(&[x, y, z, x2, y2, z2]) = numbers(text).as_deref() else {
            return Err("expected two corners, as in 0,0,0,8,6,11".to_owned());
        };
        let (a, b) = (Cell::new(x, y, z), Cell::new(x2, y2, z2));
        Ok(BoxArg(Bounds::new(a.min(b), a.max(b).saturating_add(Cell::ONE))))
    }
}

/// Which part of a building to take.
#[derive(Clone, Debug, Default, clap::Args)]
pub struct Part {
    /// Take one region of a file that has several, by its name
    #[arg(long, value_name = "NAME")]
    region: Option<String>,
    /// Take the box between two corners, which are both inside, counted from the low corner of the building; in a
    /// world, by its own coordinates
    #[arg(long = "box", value_name = "X,Y,Z,X,Y,Z", allow_hyphen_values = true)]
    bounds: Option<BoxArg>,
}

impl Part {
    /// Adds what is asked for to `reading`.
    pub fn read_by(&self, reading: Reading) -> Reading {
        let options = Options { region: self.region.clone(), ..reading.options };
        Reading { options, part: self.bounds.map(|bounds| bounds.0), ..reading }
    }
}

/// The part of `grid` inside of `bounds`, some of which must be in the grid.
pub fn boxed(name: &str, grid: &Grid, bounds: Bounds) -> Result<Grid, Failure> {
    if grid.bounds().intersect(&bounds).is_empty() {
        let last = grid.size() - Cell::ONE;
        let failure = Failure::of_file(name, "the box lies outside of the building");
        return Err(failure.hint(format!("the building goes from 0,0,0 to {},{},{}", last.x, last.y, last.z)));
    }
    if !grid.bounds().contains_box(&bounds) {
        let Cell { x, y, z } = grid.bounds().intersect(&bounds).size();
        report::warning(&format!(
            "{name}: the box reaches out of the building: {x} x {y} x {z} of it are there"
        ));
    }
    Ok(grid.cropped(bounds))
}
