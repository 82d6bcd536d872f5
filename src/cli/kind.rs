use super::failure::Failure;
use super::input::is_stdio;
use clap::ValueEnum;
use std::path::Path;

/// The kinds of files that are written, by their endings, in help texts.
macro_rules! written {
    () => {
        ".schem, .litematic, .nbt, .vox, .obj or .png"
    };
}
pub(super) use written;

/// What kinds of files are written, told by their endings.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum Kind {
    /// Sponge schematic
    Schem,
    /// Litematica schematic
    Litematic,
    /// Structure of the game
    #[value(name = "nbt")]
    Structure,
    /// MagicaVoxel model, coloured voxels only
    Vox,
    /// Region files of a world; the output is its folder
    Mca,
    /// Wavefront OBJ
    Obj,
    /// Picture
    Png,
}

impl Kind {
    /// The kind of a file by the ending of its name.
    fn of_ending(ending: &str) -> Option<Kind> {
        match ending {
            "schem" => Some(Kind::Schem),
            "litematic" => Some(Kind::Litematic),
            "nbt" => Some(Kind::Structure),
            "vox" => Some(Kind::Vox),
            "obj" => Some(Kind::Obj),
            "png" => Some(Kind::Png),
            _ => None,
        }
    }

    /// The kind of a file by its name; without an ending, standard output is a schematic and a folder a world.
    pub fn of_path(path: &Path) -> Result<Kind, Failure> {
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or("").to_ascii_lowercase();
        match Kind::of_ending(&ending) {
            Some(kind) => Ok(kind),
            None if is_stdio(path) => Ok(Kind::Schem),
            None if path.is_dir() || path.to_string_lossy().ends_with('/') => Ok(Kind::Mca),
            None => Err(unknown_kind(path, &ending)),
        }
    }

    /// Whether such files say a version of the game.
    pub fn says_version(self) -> bool {
        !matches!(self, Kind::Vox | Kind::Obj | Kind::Png)
    }
}

fn unknown_kind(path: &Path, ending: &str) -> Failure {
    let name = path.display().to_string();
    match ending {
        "mca" => Failure::of_file(&name, "region files are written into the folder of a world")
            .hint("name its folder with a `/` at the end, and say where: new-world/ --at 100,64,-20"),
        _ => Failure::of_file(&name, "vox cannot write this kind of file").hint(concat!(
            "name it ",
            written!(),
            ", or say `--format schem`"
        )),
    }
}
