//! How settling a high build grows with the palette: each layer takes the same, however many states there are.

use criterion::{BatchSize, BenchmarkId, Criterion, criterion_group, criterion_main};
use vox::block::BlockState;
use vox::grid::Grid;
use vox::neighbours::settle;
use vox::space::Cell;

const HEIGHT: i32 = 65_535;
const STATES: [i32; 3] = [1_000, 8_000, 65_000];

/// A column of as many states of a mod, with open stairs at its foot.
fn column(states: i32) -> Grid {
    let mut grid = Grid::new(Cell::new(1, HEIGHT, 1));
    for y in 0..states {
        let name = if y == 0 { "oak_stairs".to_owned() } else { format!("mod:block_{y}") };
        let id = grid.intern(&BlockState::new(&name).expect("a legal name")).expect("room in the palette");
        grid.set(Cell::new(0, y, 0), id);
    }
    grid
}

fn high(c: &mut Criterion) {
    let mut group = c.benchmark_group("settle/high");
    group.sample_size(10);
    for states in STATES {
        let grid = column(states);
        group.bench_with_input(BenchmarkId::from_parameter(states), &grid, |b, grid| {
            b.iter_batched_ref(|| grid.clone(), settle, BatchSize::PerIteration);
        });
    }
    group.finish();
}

criterion_group!(benches, high);
criterion_main!(benches);
