//! Which part of a building is meant.

use super::failure::Failure;
use crate::grid::Grid;
use crate::space::{Bounds, Cell};
use std::str::FromStr;

/// A box on the command line: `0,0,0,8,6,11`, two corners that are both inside.
#[derive(Clone, Copy, Debug)]
pub struct BoxArg(pub Bounds);

impl FromStr for BoxArg {
    type Err = String;

    fn from_str(text: &str) -> Result<BoxArg, String> {
        let numbers: Option<Vec<i32>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
        let Some(&[x, y, z, x2, y2, z2]) = numbers.as_deref() else {
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
    /// Take the box between two corners, which are both inside, counted from the low corner of the building
    #[arg(long = "box", value_name = "X,Y,Z,X,Y,Z", allow_hyphen_values = true)]
    bounds: Option<BoxArg>,
}

impl Part {
    /// The part of `grid` that is asked for. `name` is that of the file it came from.
    pub fn of(&self, name: &str, grid: Grid) -> Result<Grid, Failure> {
        let grid = match &self.region {
            None => grid,
            Some(region) => grid.cropped(region_bounds(name, &grid, region)?),
        };
        match self.bounds {
            None => Ok(grid),
            Some(BoxArg(bounds)) => boxed(name, &grid, bounds),
        }
    }
}

/// The part of `grid` inside of `bounds`, some of which must be in the grid.
pub fn boxed(name: &str, grid: &Grid, bounds: Bounds) -> Result<Grid, Failure> {
    if grid.bounds().intersect(&bounds).is_empty() {
        let last = grid.size() - Cell::ONE;
        let failure = Failure::of_file(name, "the box lies outside of the building");
        return Err(failure.hint(format!("the building goes from 0,0,0 to {},{},{}", last.x, last.y, last.z)));
    }
    Ok(grid.cropped(bounds))
}

fn region_bounds(name: &str, grid: &Grid, region: &str) -> Result<Bounds, Failure> {
    let regions = &grid.metadata.regions;
    if let Some(found) = regions.iter().find(|known| known.name == region) {
        return Ok(found.bounds);
    }
    let names: Vec<String> = regions.iter().map(|region| format!("`{}`", region.name)).collect();
    let failure = Failure::of_file(name, format!("there is no region `{region}`"));
    Err(failure.hint(match names.is_empty() {
        true => "this file is one whole".to_owned(),
        false => format!("its regions are {}", names.join(", ")),
    }))
}
