//! Damaged files of every format are read or refused, and never anything else.

use super::{axiom, blueprint, mcedit, mcstructure};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::Index;
use vox::io::{Limits, decode};

fn examples() -> [Vec<u8>; 4] {
    [mcedit::example(), blueprint::example(), mcstructure::example(), axiom::example()]
}

#[test]
fn the_examples_are_sound() {
    for bytes in examples() {
        decode(&bytes, &Limits::default()).unwrap();
    }
}

proptest! {
    #[test]
    fn damaged_files_are_read_or_refused(which in 0..4usize, damage in vec((any::<Index>(), any::<u8>()), 1..6)) {
        let mut bytes = examples()[which].clone();
        for (at, byte) in damage {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        let limits = Limits { max_bytes: 1 << 20, max_cells: 1 << 20 };
        let _ = decode(&bytes, &limits);
    }
}
