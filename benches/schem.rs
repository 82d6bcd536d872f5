//! How fast schematics are read and written, beside gzip alone as the limit.

#[path = "../tests/common/real.rs"]
mod real;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use flate2::Compression;
use flate2::bufread::MultiGzDecoder;
use flate2::write::GzEncoder;
use std::hint::black_box;
use std::io::{self, Read, Write};
use vox::block::BlockState;
use vox::grid::Grid;
use vox::io::{Content, Limits, SchemVersion, decode, encode_schem};
use vox::space::{Bounds, Cell};

/// Of the real builds: a stadium of one byte a block, and a machine of 617 states with 42,010 block entities.
const BUILDS: [&str; 2] = ["olympiastadion_21Mcells", "large_schematic"];

fn grid(bytes: &[u8]) -> Grid {
    match decode(bytes, &Limits::default()).expect("a schematic").content {
        Content::Grid(grid) => grid,
        Content::Boxes(_) => panic!("a schematic holds no boxes"),
    }
}

/// 64 x 96 x 64 blocks in layers of two kinds.
fn generated() -> Grid {
    let mut grid = Grid::new(Cell::new(64, 96, 64));
    let ids = ["smooth_stone", "bricks"].map(|name| {
        let state = BlockState::new(name).expect("a name");
        grid.intern(&state).expect("two states")
    });
    for y in 0..96 {
        let layer = Bounds::new(Cell::new(0, y, 0), Cell::new(64, y + 1, 64));
        grid.fill(layer, ids[usize::from(y % 4 != 0)]);
    }
    grid
}

fn measure(c: &mut Criterion, name: &str, packed: &[u8]) {
    let grid = grid(packed);
    let mut plain = Vec::new();
    MultiGzDecoder::new(packed).read_to_end(&mut plain).expect("gzip");
    let mut group = c.benchmark_group(format!("schem/{name}"));
    group.sample_size(10).throughput(Throughput::Elements(grid.cells().len() as u64));
    group.bench_function("read", |b| b.iter(|| decode(black_box(packed), &Limits::default())));
    group.bench_function("read, gzip alone", |b| b.iter(|| unpack(black_box(packed))));
    group.bench_function("write", |b| b.iter(|| encode_schem(black_box(&grid), SchemVersion::V3)));
    group.bench_function("write, gzip alone", |b| b.iter(|| pack(black_box(&plain))));
    group.finish();
}

fn unpack(packed: &[u8]) -> io::Result<u64> {
    io::copy(&mut MultiGzDecoder::new(packed), &mut io::sink())
}

fn pack(plain: &[u8]) -> io::Result<Vec<u8>> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::new(4));
    plain.chunks(64 << 10).try_for_each(|chunk| encoder.write_all(chunk))?;
    encoder.finish()
}

fn schem(c: &mut Criterion) {
    let encoded = encode_schem(&generated(), SchemVersion::V3).expect("it has a schematic");
    measure(c, "generated", &encoded.bytes);
    let Some(folder) = real::folder() else { return };
    for name in BUILDS {
        let path = folder.join("builds").join(name).with_extension("schem");
        match std::fs::read(&path) {
            Ok(packed) => measure(c, name, &packed),
            Err(error) => eprintln!("skipped: {}: {error}", path.display()),
        }
    }
}

criterion_group!(benches, schem);
criterion_main!(benches);
