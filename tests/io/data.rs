//! Real files: the houses and builds beside the repository.

use super::real::folder;
use super::round_trip::complete;
use super::{read, read_grid};
use std::path::{Path, PathBuf};

use vox::io::{Content, SchemVersion, encode_schem};

fn schematics(folder: &Path) -> Vec<PathBuf> {
    let patterns = ["houses/*/*.schem", "builds/*.schem"];
    let pattern = |pattern| glob::glob(&folder.join(pattern).to_string_lossy()).unwrap();
    patterns.into_iter().flat_map(pattern).map(Result::unwrap).collect()
}

/// The one that holds no block although its size is 1 x 1 x 1.
const WITHOUT_BLOCKS: &str = "fawe_sponge1.schem";

#[test]
fn every_schematic_is_read_and_written_back() {
    let Some(folder) = folder() else { return };
    let mut count = 0;
    for path in schematics(&folder) {
        let bytes = std::fs::read(&path).unwrap();
        if path.ends_with(WITHOUT_BLOCKS) {
            let error = read(&bytes).unwrap_err().to_string();
            assert_eq!(error, "the size 1 x 1 x 1 makes 1 blocks, but `BlockData` holds only 0 bytes");
            continue;
        }
        let decoded = read(&bytes).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let Content::Grid(grid) = decoded.content else { panic!("{}: no grid", path.display()) };
        for version in [SchemVersion::V2, SchemVersion::V3] {
            let back = read_grid(&encode_schem(&grid, version).unwrap().bytes);
            assert!(back.same_blocks(&complete(grid.clone())), "{}", path.display());
            assert_eq!(back.block_entities, grid.block_entities, "{}", path.display());
            assert_eq!(back.metadata.offset, grid.metadata.offset, "{}", path.display());
            assert_eq!(back.metadata.tags, grid.metadata.tags, "{}", path.display());
            if grid.metadata.data_version.is_some() {
                assert_eq!(back.metadata.data_version, grid.metadata.data_version, "{}", path.display());
            }
        }
        count += 1;
    }
    assert!(count > 0, "no schematics in {}", folder.display());
}
