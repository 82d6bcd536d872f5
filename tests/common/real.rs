//! Real inputs: the houses and builds beside the repository.

use std::path::{Path, PathBuf};

/// The folder of real inputs; `None`, with a word, where it is missing. It must be there where VOX_DATA_REQUIRED is set.
pub fn folder() -> Option<PathBuf> {
    let beside = || Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data");
    let folder = std::env::var_os("VOX_DATA").map_or_else(beside, PathBuf::from);
    if folder.is_dir() {
        return Some(folder);
    }
    assert!(std::env::var_os("VOX_DATA_REQUIRED").is_none(), "{} is missing", folder.display());
    eprintln!("skipped: {} is missing", folder.display());
    None
}
