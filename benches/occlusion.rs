//! How fast shapes learn what covers them and what they see, in a town of 100,000 of them.

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use smallvec::smallvec;
use std::hint::black_box;
use vox::run::context::{Against, Configuration, Label, ShapeId};
use vox::space::{Axis, Bounds, Cell};

const STREET: Label = Label(0);
const MASS: Label = Label(1);
const TILE: Label = Label(2);
const WINDOW: Label = Label(3);

/// Houses of two masses that meet, each with four walls of tiles, around streets; the tiles that ask.
fn town(houses: i32) -> (Configuration, Vec<ShapeId>) {
    let mut town = Configuration::default();
    let side = houses.isqrt();
    let root = town.add(None, None, smallvec![Bounds::of_size(Cell::new(side * 20, 12, side * 20))]);
    let mut tiles = Vec::new();
    for number in 0..side * side {
        let corner = Cell::new(number % side, 0, number / side) * 20;
        let at =
            |min: [i32; 3], max: [i32; 3]| Bounds::new(corner + Cell::from(min), corner + Cell::from(max));
        town.add(Some(root), Some(STREET), smallvec![at([0, 0, 17], [20, 1, 20])]);
        for mass in [at([2, 0, 2], [10, 12, 14]), at([6, 0, 5], [17, 8, 12])] {
            let id = town.add(Some(root), Some(MASS), smallvec![mass]);
            walls(&mut town, id, mass, &mut tiles);
        }
    }
    (town, tiles)
}

/// Walls along x in tiles of 2 x 4 blocks with a window in each.
fn walls(town: &mut Configuration, mass: ShapeId, bounds: Bounds, tiles: &mut Vec<ShapeId>) {
    town.replace(mass);
    for z in [bounds.min.z, bounds.max.z - 1] {
        let wall = bounds.slab(Axis::Z, z, z + 1);
        let id = town.add(Some(mass), None, smallvec![wall]);
        for cell in wall.cells().filter(|cell| (cell.x - wall.min.x) % 2 == 0 && cell.y % 4 == 0) {
            let tile = Bounds::new(cell, cell + Cell::new(2, 4, 1)).intersect(&wall);
            let tile_id = town.add(Some(id), Some(TILE), smallvec![tile]);
            let window = tile.slab(Axis::Y, cell.y + 1, cell.y + 3);
            town.add(Some(tile_id), Some(WINDOW), smallvec![window]);
            tiles.push(tile_id);
        }
    }
}

fn queries(c: &mut Criterion) {
    let (mut town, tiles) = town(1_225);
    let shapes = town.len();
    let tiles: Vec<ShapeId> = tiles.iter().copied().step_by(tiles.len() / 10_000).take(10_000).collect();
    assert!(shapes >= 100_000 && tiles.len() == 10_000, "{shapes} shapes, {} tiles", tiles.len());
    town.refresh();
    let town = town.view();
    let mut group = c.benchmark_group("10,000 questions");
    group.sample_size(10);
    for (name, against, distance) in [
        ("noparent", Against::NoParent, 0),
        ("noparent within 4", Against::NoParent, 4),
        ("active", Against::Active, 0),
        ("label", Against::Label(MASS), 0),
    ] {
        let ask = |tile: &ShapeId| town.occlusion(town.asker(*tile), against, distance);
        group.bench_function(name, |b| {
            b.iter(|| black_box(&tiles).iter().map(ask).map(|a| a as usize).sum::<usize>())
        });
    }
    let sees = |tile: &&ShapeId| town.visible(town.asker(**tile), STREET);
    group.bench_function("visible", |b| b.iter(|| black_box(&tiles).iter().filter(sees).count()));
    group.finish();
}

fn snapshots(c: &mut Criterion) {
    let mut group = c.benchmark_group("snapshot");
    group.sample_size(10);
    group.bench_function("100,000 shapes at once", |b| {
        b.iter_batched_ref(|| town(1_225).0, Configuration::refresh, BatchSize::PerIteration);
    });
    group.finish();
}

criterion_group!(benches, queries, snapshots);
criterion_main!(benches);
