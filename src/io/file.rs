use super::{Decoded, Limits, ReadError, decode};
use std::fs::{self, File, Permissions};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use tempfile::{Builder, NamedTempFile};

/// The content of the file at `path`, by what its bytes say it is.
pub fn read(path: &Path, limits: &Limits) -> Result<Decoded, ReadError> {
    decode(&read_bytes(File::open(path)?, limits.max_bytes)?, limits)
}

/// All bytes of `input`, which are not more than `most`.
pub fn read_bytes(input: impl Read, most: u64) -> Result<Vec<u8>, ReadError> {
    let mut bytes = Vec::new();
    input.take(most.saturating_add(1)).read_to_end(&mut bytes)?;
    match bytes.len() as u64 > most {
        true => Err(ReadError::LargeFile(most)),
        false => Ok(bytes),
    }
}

/// Makes `bytes` the content of the file at `path`: wholly, or not at all where something fails.
pub fn write_atomic(path: &Path, bytes: &[u8]) -> io::Result<()> {
    Staged::new(path, bytes)?.commit()
}

/// A file that is written but does not yet stand in its place. Dropped, it leaves nothing behind; so several
/// files can be written all or none.
#[derive(Debug)]
pub struct Staged<'a> {
    path: PathBuf,
    content: Content<'a>,
}

#[derive(Debug)]
enum Content<'a> {
    /// Beside its place, to be renamed.
    Beside(NamedTempFile),
    /// For what is no file (a pipe, `/dev/null`): it is written to and not replaced.
    Device(&'a [u8]),
}

impl Staged<'_> {
    /// Links stay links, and permissions stay as they are.
    pub fn new<'a>(path: &Path, bytes: &'a [u8]) -> io::Result<Staged<'a>> {
        let (path, permissions) = match fs::metadata(path) {
            Ok(old) if !old.is_file() => {
                fs::OpenOptions::new().write(true).open(path)?;
                return Ok(Staged { path: path.to_owned(), content: Content::Device(bytes) });
            }
            Ok(old) => (fs::canonicalize(path)?, Some(old.permissions())),
            Err(_) => (path.to_owned(), None),
        };
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
        let mut file = beside(folder.unwrap_or(Path::new(".")))?;
        file.write_all(bytes)?;
        if let Some(permissions) = permissions {
            file.as_file().set_permissions(permissions)?;
        }
        Ok(Staged { path, content: Content::Beside(file) })
    }

    /// Puts the file in its place.
    pub fn commit(self) -> io::Result<()> {
        match self.content {
            Content::Beside(file) => file.persist(&self.path).map(drop).map_err(io::Error::from),
            Content::Device(bytes) => fs::OpenOptions::new().write(true).open(&self.path)?.write_all(bytes),
        }
    }
}

/// A new file for a moment. Unlike other temporary files it ends as a file that others may read.
#[cfg(unix)]
fn beside(folder: &Path) -> io::Result<NamedTempFile> {
    use std::os::unix::fs::PermissionsExt;
    Builder::new().permissions(Permissions::from_mode(0o666)).tempfile_in(folder)
}

#[cfg(not(unix))]
fn beside(folder: &Path) -> io::Result<NamedTempFile> {
    Builder::new().tempfile_in(folder)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn replaces_and_leaves_nothing_beside() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("house.schem");
        write_atomic(&path, b"old and long").unwrap();
        write_atomic(&path, b"new").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn a_missing_folder_is_an_error() {
        let folder = tempfile::tempdir().unwrap();
        assert!(write_atomic(&folder.path().join("none/house.schem"), b"new").is_err());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    }

    #[cfg(unix)]
    #[test]
    fn links_and_permissions_stay() {
        use std::os::unix::fs::{PermissionsExt, symlink};
        let folder = tempfile::tempdir().unwrap();
        let (path, link) = (folder.path().join("house"), folder.path().join("link"));
        fs::write(&path, b"old").unwrap();
        fs::set_permissions(&path, Permissions::from_mode(0o640)).unwrap();
        symlink(&path, &link).unwrap();
        write_atomic(&link, b"new").unwrap();
        assert!(link.is_symlink());
        assert_eq!(fs::read(&path).unwrap(), b"new");
        assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o777, 0o640);
    }

    #[cfg(unix)]
    #[test]
    fn devices_are_not_replaced() {
        use std::os::unix::fs::FileTypeExt;
        write_atomic(Path::new("/dev/null"), b"new").unwrap();
        assert!(fs::metadata("/dev/null").unwrap().file_type().is_char_device());
    }
}
