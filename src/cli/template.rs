use super::failure::Failure;
use super::input::{is_stdio, name};
use std::path::{Path, PathBuf};

/// A path with places for what differs between files, as in `out/house-{seed}.schem`.
#[derive(Clone, Debug)]
pub struct Template(String);

impl Template {
    /// The paths for these seeds, which must all differ.
    pub fn of_seeds(&self, seeds: &[u64]) -> Result<Vec<PathBuf>, Failure> {
        self.require_one_of(&["{seed}", "{number}"], seeds.len(), "-o 'out/house-{seed}.schem'")?;
        Ok(self.numbered(seeds.iter().map(|seed| self.0.replace("{seed}", &seed.to_string()))))
    }

    /// The paths for what is made of these inputs, which must all differ. `{name}` is the name of an input without
    /// its ending.
    pub fn of_inputs(&self, inputs: &[PathBuf]) -> Result<Vec<PathBuf>, Failure> {
        self.require_one_of(&["{name}", "{number}"], inputs.len(), "'out/{name}.schem'")?;
        let paths = self.numbered(inputs.iter().map(|input| self.0.replace("{name}", &stem(input))));
        match twice(&paths) {
            None => Ok(paths),
            Some([first, second]) => {
                let names = [first, second].map(|at| name(&inputs[at])).join(" and ");
                let shown = paths[first].display().to_string();
                let failure = Failure::of_file(&shown, format!("{names} would both become this file"));
                Err(failure.hint("write {number} into the name of the output as well"))
            }
        }
    }

    fn require_one_of(&self, places: &[&str], count: usize, example: &str) -> Result<(), Failure> {
        self.refuse_others(places)?;
        if count < 2 || places.iter().any(|place| self.0.contains(place)) {
            return Ok(());
        }
        let failure = Failure::of_file(&self.0, format!("{count} files cannot all have this name"));
        Err(failure.hint(format!("write {} where they differ: {example}", places.join(" or "))))
    }

    /// A slip in the name of a place would become the name of a file.
    fn refuse_others(&self, places: &[&str]) -> Result<(), Failure> {
        let words =
            self.0.match_indices('{').filter_map(|(at, _)| Some(&self.0[at..=at + self.0[at..].find('}')?]));
        match words.into_iter().find(|word| !places.contains(word)) {
            None => Ok(()),
            Some(word) => {
                let failure = Failure::of_file(&self.0, format!("`{word}` stands for nothing here"));
                Err(failure.hint(format!("the name of an output may hold {}", places.join(" and "))))
            }
        }
    }

    /// The paths with `{number}` in the width that all need.
    fn numbered(&self, paths: impl ExactSizeIterator<Item = String>) -> Vec<PathBuf> {
        let width = paths.len().to_string().len();
        let number = |number: usize| format!("{:0width$}", number + 1);
        paths.enumerate().map(|(at, path)| PathBuf::from(path.replace("{number}", &number(at)))).collect()
    }
}

impl From<&str> for Template {
    fn from(text: &str) -> Template {
        Template(text.to_owned())
    }
}

fn stem(input: &Path) -> String {
    match is_stdio(input) {
        true => "stdin".to_owned(),
        false => input.file_stem().unwrap_or_default().to_string_lossy().into_owned(),
    }
}

/// Where the first path stands that is there twice.
fn twice(paths: &[PathBuf]) -> Option<[usize; 2]> {
    let mut order: Vec<usize> = (0..paths.len()).collect();
    order.sort_by_key(|at| (&paths[*at], *at));
    let pairs = order.windows(2).filter(|pair| paths[pair[0]] == paths[pair[1]]);
    pairs.map(|pair| [pair[0], pair[1]]).min()
}
