use crate::grid::Grid;
use crate::io::fields::Fields;
use crate::io::legacy::{holds_items, modern};
use crate::io::{ReadError, Warning, volume};
use crate::space::Cell;

/// Puts the block entities of a schematic into `grid`.
pub(super) fn read(root: &Fields, grid: &mut Grid) -> Result<Vec<Warning>, ReadError> {
    let (mut outside, mut with_items) = (0, 0);
    for fields in root.list("TileEntities")? {
        let place = Cell::new(fields.get("x")?, fields.get("y")?, fields.get("z")?);
        if !grid.bounds().contains(place) {
            outside += 1;
            continue;
        }
        let (state, data) = modern(grid.get(place), &fields)?;
        let id = grid.intern(&state).map_err(volume::full("TileEntities"))?;
        grid.set(place, id);
        with_items += usize::from(data.as_ref().is_some_and(holds_items));
        grid.block_entities.extend(data.map(|data| (place.to_array(), data)));
    }
    let warnings = [
        (outside > 0).then_some(Warning::BlockEntitiesOutside(outside)),
        (with_items > 0).then_some(Warning::OldItems(with_items)),
    ];
    Ok(warnings.into_iter().flatten().collect())
}
