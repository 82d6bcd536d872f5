//! Readers against damaged files: whatever the bytes, reading ends soon, in a grid or an error, and within its limits.
//!
//! Every run is made from its number alone, so a failure can be had again by its number. A short pass is part of the tests;
//! `VOX_FUZZ=1000000 cargo test --release --test fuzz` is a long one, and `VOX_FUZZ_FROM=4711 VOX_FUZZ=1` a single run.
//! With `-- --exact litematic --nocapture` behind, it is one of a single target, with its figures.

#[path = "fuzz/bombs.rs"]
mod bombs;
#[path = "fuzz/bytes.rs"]
mod bytes;
#[path = "common/examples/mod.rs"]
mod examples;
#[path = "fuzz/layers.rs"]
mod layers;
#[path = "fuzz/memory.rs"]
mod memory;
#[path = "fuzz/seeds.rs"]
mod seeds;
#[path = "fuzz/tree.rs"]
mod tree;
#[path = "fuzz/worlds.rs"]
mod worlds;

use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg32;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};
use vox::block::color;
use vox::grid::Grid;
use vox::io::{
    Content, Encoded, Limits, LitematicVersion, ReadError, SchemVersion, WriteError, decode,
    encode_litematic, encode_obj_mesh, encode_regions, encode_schem, encode_structure, encode_vox,
};
use vox::space::Cell;

/// A test for every format, from how many runs there are, the files that they start with and how those are read: a further format is a further line.
macro_rules! targets {
    ($($format:ident: $runs:expr, $seeds:expr, $read:expr;)*) => {
        $(#[test]
        fn $format() {
            fuzz(stringify!($format), $runs, &$seeds, $read);
        })*
    };
}

targets! {
    schem: RUNS, seeds::schem(), read;
    obj: RUNS, seeds::obj(), read;
    litematic: RUNS, seeds::litematic(), read;
    structure: RUNS, seeds::structure(), read;
    mcedit: RUNS, seeds::mcedit(), read;
    blueprint: RUNS, seeds::blueprint(), read;
    mcstructure: RUNS, seeds::mcstructure(), read;
    axiom: RUNS, seeds::axiom(), read;
    vox: RUNS, seeds::vox(), read;
    region: RUNS, seeds::region(), read;
    chunk: RUNS_ON_DISK, seeds::chunks(), worlds::with_chunk;
    entities: RUNS_ON_DISK, seeds::entities(), worlds::with_entities;
    anything: RUNS, seeds::anything(), read;
}

type Reader = fn(&[u8]) -> Result<Content, ReadError>;

fn read(bytes: &[u8]) -> Result<Content, ReadError> {
    Ok(decode(bytes, &LIMITS)?.content)
}

/// Small, so that files of a few kilobytes reach them.
const LIMITS: Limits = Limits { max_bytes: 256 << 10, max_cells: 64 << 10 };

/// What reading may hold at a time: the file's tags and what becomes of them, blocks and biomes with room to grow,
/// and what gzip needs to unpack two layers.
const MEMORY: usize = 4 * LIMITS.max_bytes as usize + 8 * LIMITS.max_cells as usize + (512 << 10);
const TIME: Duration = Duration::from_secs(1);

const RUNS: u64 = 2_000;
const RUNS_ON_DISK: u64 = 300;

fn number(variable: &str) -> Option<u64> {
    Some(std::env::var(variable).ok()?.parse().expect("a number"))
}

fn fuzz(format: &str, runs: u64, seeds: &[Vec<u8>], read: Reader) {
    for seed in seeds {
        let problem = read(seed).err();
        assert!(problem.is_none(), "{format}: a seed cannot be read: {problem:?}");
    }
    let from = number("VOX_FUZZ_FROM").unwrap_or(0);
    let start = Instant::now();
    let (mut good, mut most_used, mut longest) = (0, 0, Duration::ZERO);
    for run in from..from + number("VOX_FUZZ").unwrap_or(runs) {
        let bytes = damaged(seeds, run);
        match catch_unwind(AssertUnwindSafe(|| check(&bytes, read))) {
            Ok(Ok(checked)) => {
                good += u64::from(checked.read);
                most_used = most_used.max(checked.used);
                longest = longest.max(checked.time);
            }
            Ok(Err(problem)) => panic!("{format}, run {run}, {}: {problem}", kept(format, run, &bytes)),
            Err(_) => panic!("{format}, run {run}, {}: it panics", kept(format, run, &bytes)),
        }
    }
    println!(
        "{format}: {good} of the damaged files could be read, the longest in {longest:.1?}; at most {most_used} of \
         {MEMORY} bytes were used; {:.0?} in all",
        start.elapsed()
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
        _ => layers::damage(&plain, &other, &mut rng),
    };
    if rng.random_range(0..8) == 0 { bytes::packed(&damaged) } else { damaged }
}

struct Checked {
    read: bool,
    /// What reading took.
    time: Duration,
    /// The most memory that reading had in use.
    used: usize,
}

/// Reads `bytes`; the blocks that can be read are written and read again.
fn check(bytes: &[u8], read: Reader) -> Result<Checked, String> {
    let start = Instant::now();
    let (content, used) = memory::most_used(|| read(bytes));
    let time = start.elapsed();
    if time > TIME {
        return Err(format!("reading takes {time:?}"));
    }
    if used > MEMORY {
        return Err(format!("reading takes {used} bytes of memory"));
    }
    let checked = Checked { read: content.is_ok(), time, used };
    if let Ok(Content::Grid(grid)) = content {
        write(&grid, bytes.len())?;
    }
    Ok(checked)
}

/// Writes `grid` in one format or another. Formats that hold whatever is in a grid read it again.
fn write(grid: &Grid, which: usize) -> Result<(), String> {
    match which % 7 {
        0 => written_and_read("schem 2", encode_schem(grid, SchemVersion::V2))?,
        1 => written_and_read("schem 3", encode_schem(grid, SchemVersion::V3))?,
        2 => written_and_read("litematic", encode_litematic(grid, LitematicVersion::V7))?,
        3 => written_and_read("structure", encode_structure(grid))?,
        4 => drop(encode_vox(grid, color)),
        5 => drop(encode_regions(grid, Cell::ZERO)),
        _ => drop(encode_obj_mesh(grid, "house.mtl", color)),
    }
    Ok(())
}

/// Some grids are too large for a format.
fn written_and_read(format: &str, written: Result<Encoded, WriteError>) -> Result<(), String> {
    let Ok(written) = written else { return Ok(()) };
    let read = decode(&written.bytes, &Limits::default());
    read.map(drop).map_err(|error| format!("reading it again as {format}: {error}"))
}
