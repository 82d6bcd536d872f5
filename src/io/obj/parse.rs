use super::{ObjError, ObjProblem};

/// The lines of an OBJ file that say where objects are.
#[derive(Default)]
pub(super) struct Model {
    pub vertices: Vec<Vertex>,
    pub objects: Vec<Object>,
}

pub(super) struct Vertex {
    pub at: [f64; 3],
    pub line: usize,
}

/// What stands under one `o` or `g` line.
pub(super) struct Object {
    pub label: String,
    pub line: usize,
    /// The first of its own vertices, which go on to those of the next object.
    pub first: usize,
    /// The vertices of its faces, as numbers in the file: from 1, or from -1 backwards.
    references: Vec<Reference>,
}

struct Reference {
    number: i64,
    /// How many vertices stand above it, which negative numbers count from.
    above: usize,
    line: usize,
}

/// Lines that vox has no use for are left alone: other tools write many of their own.
pub(super) fn parse(text: &str) -> Result<Model, ObjError> {
    let mut model = Model::default();
    for (index, line) in text.trim_start_matches('\u{feff}').lines().enumerate() {
        let number = index + 1;
        model.line(line, number).map_err(|problem| ObjError { line: number, problem })?;
    }
    Ok(model)
}

impl Model {
    fn line(&mut self, line: &str, number: usize) -> Result<(), ObjProblem> {
        let (keyword, rest) = split(without_comment(line));
        match keyword {
            "v" => self.vertices.push(Vertex { at: coordinates(rest)?, line: number }),
            "o" | "g" => self.begin(rest, number),
            "f" => self.face(rest, number)?,
            _ => {}
        }
        Ok(())
    }

    fn begin(&mut self, label: &str, line: usize) {
        let label = if label.is_empty() { "default" } else { label }.to_owned();
        self.objects.push(Object { label, line, first: self.vertices.len(), references: Vec::new() });
    }

    fn face(&mut self, corners: &str, line: usize) -> Result<(), ObjProblem> {
        let above = self.vertices.len();
        let Some(object) = self.objects.last_mut() else { return Ok(()) };
        for corner in corners.split_whitespace() {
            // Numbers of textures and normals follow after slashes.
            let vertex = corner.split('/').next().unwrap_or_default();
            let number = vertex.parse().map_err(|_| ObjProblem::Number(corner.to_owned()))?;
            object.references.push(Reference { number, above, line });
        }
        Ok(())
    }

    /// The numbers of the vertices of object `index`, from 0: those of its faces, else those below
    /// its name.
    ///
    /// Some tools count the vertices of each object from 1. Faces that use none of the object's own
    /// vertices give them away, and then these are taken.
    pub fn vertices_of(&self, index: usize) -> Result<Vec<usize>, ObjError> {
        let object = &self.objects[index];
        let end = self.objects.get(index + 1).map_or(self.vertices.len(), |next| next.first);
        let own: Vec<usize> = (object.first..end).collect();
        let used = object.references.iter().map(|reference| self.resolve(reference));
        let used = used.collect::<Result<Vec<usize>, ObjError>>()?;
        let stray = !own.is_empty() && !used.iter().any(|vertex| (object.first..end).contains(vertex));
        Ok(if used.is_empty() || stray { own } else { used })
    }

    fn resolve(&self, reference: &Reference) -> Result<usize, ObjError> {
        let count = self.vertices.len();
        let vertex = match reference.number {
            number if number > 0 => usize::try_from(number - 1).ok(),
            number => usize::try_from(reference.above as i64 + number).ok(),
        };
        vertex.filter(|&vertex| vertex < count && reference.number != 0).ok_or_else(|| ObjError {
            line: reference.line,
            problem: ObjProblem::Vertex(reference.number.to_string(), count),
        })
    }
}

/// A comment starts at a `#` that begins a word: labels may hold one.
pub(super) fn without_comment(line: &str) -> &str {
    let begins = |at: usize| line[..at].chars().next_back().is_none_or(char::is_whitespace);
    let comment = line.match_indices('#').find(|(at, _)| begins(*at));
    comment.map_or(line, |(at, _)| &line[..at])
}

pub(super) fn split(line: &str) -> (&str, &str) {
    let line = line.trim();
    line.split_once(char::is_whitespace).map_or((line, ""), |(keyword, rest)| (keyword, rest.trim()))
}

/// The first three numbers; a weight and a colour may follow.
pub(super) fn coordinates(rest: &str) -> Result<[f64; 3], ObjProblem> {
    let words: Vec<&str> = rest.split_whitespace().collect();
    let [x, y, z] = *words.first_chunk::<3>().ok_or(ObjProblem::Coordinates(words.len()))?;
    Ok([coordinate(x)?, coordinate(y)?, coordinate(z)?])
}

fn coordinate(word: &str) -> Result<f64, ObjProblem> {
    let number = word.parse().ok().filter(|number: &f64| number.is_finite());
    number.ok_or_else(|| ObjProblem::Number(word.to_owned()))
}
