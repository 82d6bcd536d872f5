//! Files that are read as part of a world.

use super::LIMITS;
use super::examples::region;
use std::fs;
use tempfile::TempDir;
use vox::io::{Content, ReadError, read_world};

thread_local! {
    static WITH_CHUNK: TempDir = world(BESIDE_UNPACKED);
    static WITH_ENTITIES: TempDir = world(UNPACKED);
}

/// How the only chunk of the world is kept.
const UNPACKED: u8 = 3;
const BESIDE_UNPACKED: u8 = 128 | UNPACKED;

fn world(kind: u8) -> TempDir {
    let folder = TempDir::new().unwrap();
    for name in ["region", "entities"] {
        fs::create_dir(folder.path().join(name)).unwrap();
    }
    let mut region = region::region(&[([0, 0], &region::chunk_1_16([0, 0]))], UNPACKED);
    region[8196] = kind;
    fs::write(folder.path().join("region/r.0.0.mca"), region).unwrap();
    folder
}

/// The blocks of a world whose only chunk is `bytes`, in a file of its own.
pub fn with_chunk(bytes: &[u8]) -> Result<Content, ReadError> {
    WITH_CHUNK.with(|world| read(world, "region/c.0.0.mcc", bytes))
}

/// The blocks of a world with the entities of the region `bytes`.
pub fn with_entities(bytes: &[u8]) -> Result<Content, ReadError> {
    WITH_ENTITIES.with(|world| read(world, "entities/r.0.0.mca", bytes))
}

fn read(world: &TempDir, name: &str, bytes: &[u8]) -> Result<Content, ReadError> {
    fs::write(world.path().join(name), bytes).unwrap();
    Ok(read_world(world.path(), None, &LIMITS)?.content)
}
