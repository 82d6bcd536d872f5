//! Readers against damaged files: whatever the bytes, reading ends soon, in a grid or an error, and within its limits.
//!
//! Every run is made from its number alone, so a failure can be had again by its number. A short pass is part of the tests;
//! `VOX_FUZZ=1000000 cargo test --release --test fuzz` is a long one, and `VOX_FUZZ_FROM=4711 VOX_FUZZ=1` a single run.

#[path = "fuzz/bombs.rs"]
mod bombs;
#[path = "fuzz/bytes.rs"]
mod bytes;
#[path = "fuzz/memory.rs"]
mod memory;
#[path = "fuzz/seeds.rs"]
mod seeds;
#[path = "fuzz/tree.rs"]
mod tree;

use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg32;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};
use vox::io::{Content, Limits, SchemVersion, decode, encode_schem};

/// A test for every format, from the files that it starts with: a further format is a further line.
macro_rules! targets {
    ($($format:ident: $seeds:expr;)*) => {
        $(#[test]
        fn $format() {
            fuzz(stringify!($format), &$seeds);
        })*
    };
}

targets! {
    schem: seeds::schem();
    obj: seeds::obj();
}

/// Small, so that files of a few kilobytes reach them.
const LIMITS: Limits = Limits { max_bytes: 256 << 10, max_cells: 64 << 10 };

/// What reading may hold at a time: the file's tags and what becomes of them, blocks and biomes with room to grow,
/// and what gzip needs to unpack two layers.
const MEMORY: usize = 4 * LIMITS.max_bytes as usize + 8 * LIMITS.max_cells as usize + (512 << 10);
const TIME: Duration = Duration::from_secs(1);

const RUNS: u64 = 2_000;

fn number(variable: &str) -> Option<u64> {
    Some(std::env::var(variable).ok()?.parse().expect("a number"))
}

fn fuzz(format: &str, seeds: &[Vec<u8>]) {
    for seed in seeds {
        assert!(decode(seed, &LIMITS).is_ok(), "{format}: a seed cannot be read");
    }
    let from = number("VOX_FUZZ_FROM").unwrap_or(0);
    let (mut read, mut most_used) = (0, 0);
    for run in from..from + number("VOX_FUZZ").unwrap_or(RUNS) {
        let bytes = damaged(seeds, run);
        match catch_unwind(AssertUnwindSafe(|| check(&bytes))) {
            Ok(Ok(checked)) => {
                read += u64::from(checked.read);
                most_used = most_used.max(checked.used);
            }
            Ok(Err(problem)) => panic!("{format}, run {run}, {}: {problem}", kept(format, run, &bytes)),
            Err(_) => panic!("{format}, run {run}, {}: it panics", kept(format, run, &bytes)),
        }
    }
    println!(
        "{format}: {read} of the damaged files could be read; at most {most_used} of {MEMORY} bytes were used"
    );
}

/// The file of a run, put where it can be looked at.
fn kept(format: &str, run: u64, bytes: &[u8]) -> String {
    let path = std::env::temp_dir().join(format!("vox-fuzz-{format}-{run}"));
    std::fs::write(&path, bytes).map_or_else(|error| error.to_string(), |()| path.display().to_string())
}

/// One of `seeds`, damaged: on the face of it, beneath its packing, or in its tags, so that some of the damage
/// gets past each.
fn damaged(seeds: &[Vec<u8>], run: u64) -> Vec<u8> {
    let mut rng = Pcg32::seed_from_u64(run);
    let seed = seeds.choose(&mut rng).expect("seeds");
    let other = seeds.choose(&mut rng).expect("seeds");
    let (plain, other) = (bytes::unpacked(seed), bytes::unpacked(other));
    let damaged = match rng.random_range(0..8) {
        0 => return bytes::damage(seed.clone(), &other, &mut rng),
        1..=3 => bytes::damage(plain, &other, &mut rng),
        _ => tree::damage(&plain, &mut rng).unwrap_or_else(|| bytes::damage(plain, &other, &mut rng)),
    };
    if rng.random_range(0..8) == 0 { bytes::packed(&damaged) } else { damaged }
}

struct Checked {
    read: bool,
    /// The most memory that reading had in use.
    used: usize,
}

/// Reads `bytes`; the blocks that can be read are written and read again.
fn check(bytes: &[u8]) -> Result<Checked, String> {
    let start = Instant::now();
    let (decoded, used) = memory::most_used(|| decode(bytes, &LIMITS));
    if start.elapsed() > TIME {
        return Err(format!("reading takes {:?}", start.elapsed()));
    }
    if used > MEMORY {
        return Err(format!("reading takes {used} bytes of memory"));
    }
    let read = decoded.is_ok();
    if let Ok(Content::Grid(grid)) = decoded.map(|decoded| decoded.content) {
        for version in [SchemVersion::V2, SchemVersion::V3] {
            let encoded = encode_schem(&grid, version).map_err(|error| format!("writing: {error}"))?;
            decode(&encoded.bytes, &Limits::default()).map_err(|error| format!("reading again: {error}"))?;
        }
    }
    Ok(Checked { read, used })
}
