//! Damage that knows nothing of formats.

use flate2::Compression;
use flate2::bufread::MultiGzDecoder;
use flate2::write::GzEncoder;
use rand::RngExt;
use rand::seq::IndexedRandom;
use rand_pcg::Pcg32;
use std::io::{Read, Write};

pub fn packed(plain: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::fast());
    encoder.write_all(plain).unwrap();
    encoder.finish().unwrap()
}

/// What `bytes` hold; themselves where they are not packed.
pub fn unpacked(bytes: &[u8]) -> Vec<u8> {
    let mut plain = Vec::new();
    match MultiGzDecoder::new(bytes).read_to_end(&mut plain) {
        Ok(_) => plain,
        Err(_) => bytes.to_vec(),
    }
}

/// One to four changes to `bytes`, some with bytes of `other`.
pub fn damage(mut bytes: Vec<u8>, other: &[u8], rng: &mut Pcg32) -> Vec<u8> {
    for _ in 0..rng.random_range(1..=4) {
        change(&mut bytes, other, rng);
    }
    bytes
}

fn change(bytes: &mut Vec<u8>, other: &[u8], rng: &mut Pcg32) {
    let at = rng.random_range(0..=bytes.len());
    let end = (at + rng.random_range(1..=16)).min(bytes.len());
    match rng.random_range(0..8) {
        0 => bytes.truncate(at),
        1 => drop(bytes.drain(at..end)),
        2 => {
            let again = bytes[at..end].repeat(rng.random_range(1..=64));
            bytes.splice(at..at, again);
        }
        3 => {
            let (from, len) = (rng.random_range(0..=other.len()), rng.random_range(0..=256));
            let piece = other[from..].iter().copied().take(len);
            bytes.splice(at..end, piece);
        }
        4 => bytes[at..end].fill(rng.random()),
        5 if at < end => bytes[at] ^= 1 << rng.random_range(0..8),
        _ => overwrite(&mut bytes[at..], rng),
    }
}

/// A number as lengths and sizes are written, in either order of bytes.
fn overwrite(bytes: &mut [u8], rng: &mut Pcg32) {
    const TELLING: [u64; 12] =
        [0, 1, 2, 127, 128, 255, 256, 32_767, 32_768, 65_535, i32::MAX as u64, u32::MAX as u64];
    let number = TELLING.choose(rng).copied().unwrap_or_default();
    let width = [1, 2, 4, 8].choose(rng).copied().unwrap_or(1).min(bytes.len());
    match rng.random() {
        true => bytes[..width].copy_from_slice(&number.to_be_bytes()[8 - width..]),
        false => bytes[..width].copy_from_slice(&number.to_le_bytes()[..width]),
    }
}
