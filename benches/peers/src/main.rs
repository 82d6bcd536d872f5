//! vox beside nucleation, and beside gzip alone as the limit: cells a second and memory a cell, from one run.
//!
//! `cargo run --release --manifest-path benches/peers/Cargo.toml -- FILE.schem ..`

mod memory;

use flate2::Compression;
use flate2::bufread::MultiGzDecoder;
use flate2::write::GzEncoder;
use memory::Counting;
use std::io::{Read, Write};
use std::time::{Duration, Instant};

#[global_allocator]
static MEMORY: Counting = Counting::new();

/// The best of so many runs is told: other programs share the machine.
const RUNS: usize = 7;

struct Measured {
    time: Duration,
    /// The most bytes in use at a time, beyond those before.
    peak: usize,
}

fn measure<T>(mut work: impl FnMut() -> T) -> (T, Measured) {
    let run = |work: &mut dyn FnMut() -> T| {
        let before = MEMORY.restart();
        let start = Instant::now();
        let made = work();
        (made, start.elapsed(), MEMORY.peak() - before)
    };
    let (mut made, mut time, peak) = run(&mut work);
    for _ in 1..RUNS {
        drop(made);
        let (again, next, _) = run(&mut work);
        made = again;
        time = time.min(next);
    }
    (made, Measured { time, peak })
}

fn tell(what: &str, cells: usize, measured: &Measured) {
    let rate = cells as f64 / measured.time.as_secs_f64() / 1e6;
    let each = measured.peak as f64 / cells as f64;
    let time = measured.time.as_secs_f64() * 1e3;
    println!("  {what:<24} {rate:>8.1} million cells/s {time:>9.1} ms {each:>8.3} bytes a cell at peak");
}

fn gzip(packed: &[u8], cells: usize) {
    let unpack = || {
        let mut buffer = vec![0; 64 << 10];
        let mut stream = MultiGzDecoder::new(packed);
        let mut total = 0;
        while let Ok(len @ 1..) = stream.read(&mut buffer) {
            total += len;
        }
        total
    };
    tell("gzip alone, reading", cells, &measure(unpack).1);
    let mut plain = Vec::new();
    MultiGzDecoder::new(packed).read_to_end(&mut plain).expect("gzip");
    let pack = || {
        let mut encoder = GzEncoder::new(Vec::new(), Compression::new(4));
        plain.chunks(64 << 10).for_each(|chunk| encoder.write_all(chunk).expect("memory"));
        encoder.finish().expect("memory")
    };
    tell("gzip alone, writing", cells, &measure(pack).1);
}

fn vox(packed: &[u8]) -> usize {
    use vox::io::{Content, Limits, SchemVersion, decode, encode_schem};
    let read = || match decode(packed, &Limits::default()).expect("a schematic").content {
        Content::Grid(grid) => grid,
        Content::Boxes(_) => unreachable!("schematics hold no boxes"),
    };
    let (grid, measured) = measure(read);
    let cells = grid.cells().len();
    tell("vox, reading", cells, &measured);
    let (encoded, measured) = measure(|| encode_schem(&grid, SchemVersion::V3).expect("it has a schematic"));
    tell("vox, writing", cells, &measured);
    println!(
        "  {:<24} {} bytes, block entities: {}",
        "vox, written",
        encoded.bytes.len(),
        grid.block_entities.len()
    );
    cells
}

fn nucleation(packed: &[u8], cells: usize) {
    use nucleation::formats::schematic::{from_schematic, to_schematic};
    let (schematic, measured) = measure(|| from_schematic(packed).expect("a schematic"));
    tell("nucleation, reading", cells, &measured);
    let (bytes, measured) = measure(|| to_schematic(&schematic).expect("it has a schematic"));
    tell("nucleation, writing", cells, &measured);
    println!("  {:<24} {} bytes", "nucleation, written", bytes.len());
}

fn main() -> std::io::Result<()> {
    for path in std::env::args().skip(1) {
        println!("{path}");
        let packed = std::fs::read(&path)?;
        let cells = vox(&packed);
        nucleation(&packed, cells);
        gzip(&packed, cells);
    }
    Ok(())
}
