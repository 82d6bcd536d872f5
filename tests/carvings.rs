//! Buildings of carved scopes, layer by layer: each `*.grammar` in `carvings` makes what the `*.layers` beside it shows.
//! `SNAPSHOTS=overwrite cargo test --test carvings` writes them anew: read them.

mod grammar_files;

use grammar_files::all_in;
use snapbox::{Assert, Data};
use std::fmt::Write;
use vox::grid::Grid;
use vox::space::Cell;

/// The layers of a building from the ground up, north at the head of each; equal ones that follow one another are shown
/// once. Blocks have letters, in the order in which they come.
fn layers(grid: &Grid) -> String {
    let size = grid.bounds().size();
    let mut names: Vec<String> = Vec::new();
    let mut letter = |cell: Cell| {
        let state = grid.get(cell);
        if state.is_air() {
            return '.';
        }
        let name = state.short_name().to_owned();
        let at = names.iter().position(|known| *known == name).unwrap_or_else(|| {
            names.push(name);
            names.len() - 1
        });
        (b'a' + at as u8) as char
    };
    let mut layers: Vec<(i32, String)> = Vec::new();
    for y in 0..size.y {
        let row = |z| (0..size.x).map(|x| letter(Cell::new(x, y, z))).chain(['\n']).collect::<String>();
        let layer: String = (0..size.z).map(row).collect();
        match layers.last_mut() {
            Some((last, same)) if *same == layer => *last = y,
            _ => layers.push((y, layer)),
        }
    }
    let legend = names.iter().zip('a'..).map(|(name, letter)| format!("{letter} {name}\n"));
    layers.iter().fold(legend.collect(), |mut text: String, (last, layer)| {
        let _ = write!(text, "\nup to {last}\n{layer}");
        text
    })
}

#[test]
fn carved_buildings_are_as_shown() {
    for file in all_in("tests/carvings") {
        let made = file.run(None, 0);
        assert!(made.warnings.is_empty(), "{}: {:?}", file.name(), made.warnings);
        let shown = file.path.with_extension("layers");
        Assert::new().action_env("SNAPSHOTS").eq(layers(&made.made), Data::read_from(&shown, None).raw());
    }
}
