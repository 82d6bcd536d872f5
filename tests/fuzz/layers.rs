//! Damage beneath what a format wraps around its content: lengths and packing stay right, so the content is reached.

use super::examples::region::{KINDS, pack};
use super::{bytes, tree};
use flate2::read::{MultiGzDecoder, ZlibDecoder};
use rand::RngExt;
use rand::seq::IndexedRandom;
use rand_pcg::Pcg32;
use std::io::Read;

/// `plain` with damage to what it holds, or on the face of it where it wraps nothing.
pub fn damage(plain: &[u8], other: &[u8], rng: &mut Pcg32) -> Vec<u8> {
    let within = match plain {
        [0x0a, 0xe5, 0xbb, 0x36, rest @ ..] => axiom(rest, rng),
        [b'V', b'O', b'X', b' ', ..] => magica(plain, other, rng),
        _ => tree::damage(plain, rng).or_else(|| region(plain, other, rng)),
    };
    within.unwrap_or_else(|| bytes::damage(plain.to_vec(), other, rng))
}

/// Three parts behind their lengths, of which the first and the last are NBT.
fn axiom(rest: &[u8], rng: &mut Pcg32) -> Option<Vec<u8>> {
    let (header, rest) = part(rest)?;
    let (picture, rest) = part(rest)?;
    let (blocks, _) = part(rest)?;
    let (mut header, mut blocks) = (header.to_vec(), bytes::unpacked(blocks));
    let damaged = if rng.random_range(0..4) == 0 { &mut header } else { &mut blocks };
    *damaged = tree::damage(damaged, rng)?;
    if rng.random() {
        blocks = bytes::packed(&blocks);
    }
    let behind_length = |part: &[u8]| [&(part.len() as u32).to_be_bytes(), part].concat();
    let parts = [&header[..], picture, &blocks].map(behind_length);
    Some([vec![0x0a, 0xe5, 0xbb, 0x36], parts.concat()].concat())
}

fn part(bytes: &[u8]) -> Option<(&[u8], &[u8])> {
    let (length, rest) = bytes.split_first_chunk::<4>()?;
    rest.split_at_checked(u32::from_be_bytes(*length) as usize)
}

/// A name and what it holds.
type Chunk = ([u8; 4], Vec<u8>);

fn magica(plain: &[u8], other: &[u8], rng: &mut Pcg32) -> Option<Vec<u8>> {
    const HEAD: usize = 20;
    let (head, mut rest) = plain.split_at_checked(HEAD)?;
    let mut chunks = Vec::new();
    while let Some((chunk, after)) = chunk(rest) {
        chunks.push(chunk);
        rest = after;
    }
    for _ in 0..rng.random_range(1..=4) {
        change(&mut chunks, other, rng);
    }
    let whole = |(name, content): &Chunk| {
        [&name[..], &(content.len() as u32).to_le_bytes(), &[0; 4], content].concat()
    };
    Some([head.to_vec(), chunks.iter().flat_map(whole).collect()].concat())
}

fn chunk(bytes: &[u8]) -> Option<(Chunk, &[u8])> {
    let (name, rest) = bytes.split_first_chunk::<4>()?;
    let (length, rest) = rest.split_first_chunk::<4>()?;
    let (content, rest) = rest.get(4..)?.split_at_checked(u32::from_le_bytes(*length) as usize)?;
    Some(((*name, content.to_vec()), rest))
}

fn change(chunks: &mut Vec<Chunk>, other: &[u8], rng: &mut Pcg32) {
    let Some(one) = chunks.choose(rng).cloned() else { return };
    let at = rng.random_range(0..chunks.len());
    match rng.random_range(0..6) {
        0 => drop(chunks.remove(at)),
        1 => chunks.insert(at, one),
        2 => chunks[at].1 = one.1,
        _ => chunks[at].1 = bytes::damage(one.1, other, rng),
    }
}

const SECTOR: usize = 4096;

/// A region whose table has another chunk in the place of one: one whose packing or whose content is damaged.
fn region(plain: &[u8], other: &[u8], rng: &mut Pcg32) -> Option<Vec<u8>> {
    let (table, _) = plain.get(..SECTOR)?.as_chunks::<4>();
    let used: Vec<usize> = (0..table.len()).filter(|&at| table[at] != [0; 4]).collect();
    let &at = used.choose(rng)?;
    let sector = (u32::from_be_bytes(table[at]) >> 8) as usize;
    let (stored, _) = part(plain.get(sector * SECTOR..)?)?;
    let (&kind, packed) = stored.split_first()?;
    let &new_kind = KINDS.choose(rng)?;
    let chunk = match rng.random_range(0..4) {
        0 => bytes::damage(stored.to_vec(), other, rng),
        1 => bytes::damage([vec![new_kind], pack(&unpack(packed, kind)?, new_kind)].concat(), other, rng),
        _ => [vec![new_kind], pack(&tree::damage(&unpack(packed, kind)?, rng)?, new_kind)].concat(),
    };
    Some(with_chunk(plain.to_vec(), at, &chunk))
}

fn with_chunk(mut region: Vec<u8>, at: usize, chunk: &[u8]) -> Vec<u8> {
    region.resize(region.len().next_multiple_of(SECTOR), 0);
    let place = ((region.len() / SECTOR) as u32) << 8 | 1;
    region[4 * at..4 * at + 4].copy_from_slice(&place.to_be_bytes());
    region.extend((chunk.len() as u32).to_be_bytes());
    region.extend(chunk);
    region
}

fn unpack(packed: &[u8], kind: u8) -> Option<Vec<u8>> {
    let mut plain = Vec::new();
    match kind {
        1 => MultiGzDecoder::new(packed).read_to_end(&mut plain),
        2 => ZlibDecoder::new(packed).read_to_end(&mut plain),
        3 => return Some(packed.to_vec()),
        _ => lz4_java_wrc::Lz4BlockInput::new(packed).read_to_end(&mut plain),
    }
    .ok()?;
    Some(plain)
}
