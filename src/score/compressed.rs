//! What zlib makes of the examples: the measure for the length of a grammar.

use super::cells::Cells;
use flate2::Compression;
use flate2::write::ZlibEncoder;
use std::io::Write;

/// The bits of the cells of all buildings as zlib's best effort: one after the other, each cell a byte, or two
/// where there are more than 256 states. Neither the states' names nor the buildings' sizes are counted.
pub fn zlib_bits(buildings: &[Cells]) -> f64 {
    let most = buildings.iter().flat_map(|cells| cells.iter().copied()).max().unwrap_or(0);
    let bytes: Vec<u8> = buildings
        .iter()
        .flat_map(|cells| cells.iter())
        .flat_map(|cell| cell.to_be_bytes().into_iter().skip(if most < 256 { 3 } else { 2 }))
        .collect();
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::best());
    let packed = encoder.write_all(&bytes).and_then(|()| encoder.finish());
    // Writing to memory does not fail; what is not packed counts as it is.
    8.0 * packed.map_or(bytes.len(), |packed| packed.len()) as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use ndarray::Array3;

    #[test]
    fn order_packs_better_than_disorder() {
        let plain = Array3::from_elem((10, 10, 10), 1);
        let mut cell = 1u32;
        let mixed = plain.mapv(|_| {
            cell = cell.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            cell >> 30
        });
        let (plain, mixed) = (zlib_bits(&[plain]), zlib_bits(&[mixed]));
        assert!(plain < 200.0, "{plain}");
        assert!((2000.0..4000.0).contains(&mixed), "two bits a cell and some: {mixed}");
    }

    #[test]
    fn many_states_take_two_bytes() {
        let few = zlib_bits(&[Array3::from_shape_fn((1, 1, 256), |(_, _, x)| x as u32)]);
        let many = zlib_bits(&[Array3::from_shape_fn((1, 1, 512), |(_, _, x)| x as u32)]);
        assert!(many > 2.0 * few, "{many} for {few}");
    }
}
