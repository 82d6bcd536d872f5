//! The long arrays of a schematic, which no tree holds: one varint for every block, or for its biome.

use crate::io::fields::Fields;
use crate::io::varint::{self, Decoder, Varints};
use crate::io::{Limits, ReadError};
use crate::nbt::Sink;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::io::{self, Write};

/// Where the arrays stand in the layouts of the format, within `Schematic` or at the root.
const PATHS: [&str; 4] = ["BlockData", "Blocks.Data", "BiomeData", "Biomes.Data"];

/// Decodes the arrays of a schematic as its file streams by, whatever their order.
pub(super) struct Arrays {
    arrays: BTreeMap<String, Decoder>,
    /// The path of the array that is coming in.
    current: String,
    max_numbers: usize,
    /// The longest array that can be there.
    believed: usize,
}

impl Arrays {
    /// For a file that unpacks to at most `believed` bytes.
    pub fn new(believed: usize, limits: &Limits) -> Arrays {
        let max_numbers = usize::try_from(limits.max_cells).unwrap_or(usize::MAX);
        Arrays { arrays: BTreeMap::new(), current: String::new(), max_numbers, believed }
    }

    /// The numbers of the Byte Array `name`; `None` where it is absent.
    pub fn find(&mut self, fields: &Fields, name: &str) -> Result<Option<Varints>, ReadError> {
        let Some(bytes) = fields.find::<&[i8]>(name)? else { return Ok(None) };
        let decoder = self.arrays.remove(&fields.path(name)).unwrap_or_else(|| {
            let mut decoder = Decoder::new(bytes.len(), bytes.len(), self.max_numbers);
            let bytes: Vec<u8> = bytes.iter().map(|byte| byte.cast_unsigned()).collect();
            decoder.push(&bytes);
            decoder
        });
        Ok(Some(decoder.finish()))
    }
}

impl Sink for Arrays {
    fn wants(&mut self, path: &str, len: usize) -> bool {
        let wanted = PATHS.contains(&path.strip_prefix("Schematic.").unwrap_or(path));
        if wanted {
            path.clone_into(&mut self.current);
            self.arrays.insert(path.to_owned(), Decoder::new(len, self.believed, self.max_numbers));
        }
        wanted
    }

    fn take(&mut self, bytes: &[u8]) {
        if let Some(decoder) = self.arrays.get_mut(&self.current) {
            decoder.push(bytes);
        }
    }
}

/// Numbers to be written as varints.
pub(super) struct Outgoing<'a> {
    numbers: Cow<'a, [u16]>,
    /// What is written for each number.
    table: Vec<u16>,
    /// How often they are written, one time after the other.
    times: usize,
    len: usize,
}

impl<'a> Outgoing<'a> {
    /// `times` over what `table` makes of `numbers`, each of which it holds.
    pub fn new(numbers: Cow<'a, [u16]>, table: Vec<u16>, times: usize) -> Outgoing<'a> {
        let len = match table.iter().all(|&number| varint::width(number) == 1) {
            true => numbers.len(),
            false => numbers.iter().map(|&number| varint::width(table[usize::from(number)])).sum(),
        };
        Outgoing { len: times * len, numbers, table, times }
    }

    pub fn len(&self) -> usize {
        self.len
    }

    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        (0..self.times).try_for_each(|_| self.write_once(out))
    }

    fn write_once(&self, out: &mut dyn Write) -> io::Result<()> {
        const STEP: usize = 16 << 10;
        let single = self.len == self.numbers.len() * self.times;
        let mut buffer = Vec::with_capacity(3 * STEP);
        for step in self.numbers.chunks(STEP) {
            buffer.clear();
            match single {
                true => self.push_single(&mut buffer, step),
                false => step.iter().for_each(|&number| varint::push(&mut buffer, self.to_write(number))),
            }
            out.write_all(&buffer)?;
        }
        Ok(())
    }

    fn to_write(&self, number: u16) -> u16 {
        self.table[usize::from(number)]
    }

    /// As bytes, where no number needs more than one.
    fn push_single(&self, buffer: &mut Vec<u8>, numbers: &[u16]) {
        let (runs, rest) = numbers.as_chunks::<RUN>();
        for run in runs {
            match uniform(run) {
                Some(number) => buffer.extend([self.to_write(number) as u8; RUN]),
                None => buffer.extend(run.iter().map(|&number| self.to_write(number) as u8)),
            }
        }
        buffer.extend(rest.iter().map(|&number| self.to_write(number) as u8));
    }
}

/// Builds are mostly runs of one block, which can be dealt with so many at a time.
pub(super) const RUN: usize = 32;

/// The number that all of these are.
pub(super) fn uniform(run: &[u16; RUN]) -> Option<u16> {
    let differences = run.iter().fold(0, |differences, number| differences | (number ^ run[0]));
    (differences == 0).then_some(run[0])
}
