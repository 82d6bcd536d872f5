/// What reading a file had to put right or leave out.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum Warning {
    #[error("{0} block entities lie outside of the schematic and are left out")]
    BlockEntitiesOutside(usize),
    #[error("{0} entities without an `Id` are left out")]
    EntitiesUnnamed(usize),
    #[error("PaletteMax is {said}, but the palette holds {found} entries: the palette is believed")]
    PaletteMax { said: i32, found: usize },
}
