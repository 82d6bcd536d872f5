//! Which straight lines cut a region and no leaf in it, and which regions have one structure.

use super::{FacadeError, Layout, Region, Side};
use rustc_hash::FxHashMap;

/// The lines of a layout, numbered, and what lies between them. Regions of it are of numbers of lines, not of blocks.
pub struct Cutter {
    /// Where the lines across x and across y stand.
    lines: [Vec<u32>; 2],
    labels: Vec<u32>,
    /// The leaf at each cell between lines, row by row from below.
    owners: Vec<u32>,
    /// The regions of the leaves.
    leaves: Vec<Region>,
    /// For lines across x and across y: how far from the low end each is the edge of leaves, as sums.
    edges: [Vec<u32>; 2],
}

/// More cells between lines than this take too much memory.
const MOST_CELLS: usize = 1 << 24;

impl Cutter {
    /// # Errors
    ///
    /// Where there are too many lines.
    pub fn new(layout: &Layout) -> Result<Cutter, FacadeError> {
        let lines = Side::ALL.map(|axis| {
            let ends = layout.leaves().iter().flat_map(|leaf| leaf.region.sides[axis.index()]);
            let mut lines: Vec<u32> = ends.collect();
            lines.sort_unstable();
            lines.dedup();
            lines
        });
        let [columns, rows] = [lines[0].len() - 1, lines[1].len() - 1];
        if columns.saturating_mul(rows) > MOST_CELLS {
            return Err(FacadeError::TooManyLines { lines: [columns + 1, rows + 1] });
        }
        let number = |axis: usize, at: u32| lines[axis].partition_point(|line| *line < at) as u32;
        let numbered = |region: &Region| Region {
            sides: [0, 1].map(|axis| region.sides[axis].map(|at| number(axis, at))),
        };
        let leaves: Vec<Region> = layout.leaves().iter().map(|leaf| numbered(&leaf.region)).collect();
        let mut owners = vec![0; columns * rows];
        for (number, leaf) in leaves.iter().enumerate() {
            let [[left, right], [bottom, top]] = leaf.sides.map(|ends| ends.map(|end| end as usize));
            for row in bottom..top {
                owners[row * columns + left..row * columns + right].fill(number as u32);
            }
        }
        let labels = layout.leaves().iter().map(|leaf| leaf.label).collect();
        let mut cutter = Cutter { lines, labels, owners, leaves, edges: [Vec::new(), Vec::new()] };
        cutter.edges = Side::ALL.map(|axis| cutter.edges_across(axis));
        Ok(cutter)
    }

    fn counts(&self) -> [usize; 2] {
        [self.lines[0].len() - 1, self.lines[1].len() - 1]
    }

    fn owner(&self, column: usize, row: usize) -> u32 {
        self.owners[row * self.counts()[0] + column]
    }

    fn edges_across(&self, axis: Side) -> Vec<u32> {
        let along = self.counts()[axis.other().index()];
        let mut sums = Vec::with_capacity(self.lines[axis.index()].len() * (along + 1));
        for line in 0..self.lines[axis.index()].len() {
            let mut sum = 0;
            sums.push(0);
            for at in 0..along {
                let owner = |before: usize| match axis {
                    Side::X => self.owner(line - before, at),
                    Side::Y => self.owner(at, line - before),
                };
                let is_inner = line > 0 && line < self.counts()[axis.index()];
                sum += u32::from(!is_inner || owner(0) != owner(1));
                sums.push(sum);
            }
        }
        sums
    }

    pub fn whole(&self) -> Region {
        Region { sides: self.counts().map(|count| [0, count as u32]) }
    }

    pub fn leaves(&self) -> &[Region] {
        &self.leaves
    }

    /// The length of a region in blocks.
    pub fn length(&self, region: &Region, axis: Side) -> u32 {
        let [low, high] = region.sides[axis.index()];
        let lines = &self.lines[axis.index()];
        lines[high as usize] - lines[low as usize]
    }

    /// A place in blocks.
    pub fn place(&self, axis: Side, line: u32) -> u32 {
        self.lines[axis.index()][line as usize]
    }

    /// The number of the only leaf of a region.
    pub fn only_leaf(&self, region: &Region) -> Option<usize> {
        let corner = self.owner(region.sides[0][0] as usize, region.sides[1][0] as usize) as usize;
        (self.leaves[corner] == *region).then_some(corner)
    }

    pub fn label(&self, leaf: usize) -> u32 {
        self.labels[leaf]
    }

    /// Whether a line across `axis` cuts no leaf of a region.
    fn is_clean(&self, region: &Region, axis: Side, line: u32) -> bool {
        let [low, high] = region.sides[axis.other().index()].map(|end| end as usize);
        let width = self.counts()[axis.other().index()] + 1;
        let sums = &self.edges[axis.index()][line as usize * width..];
        sums[high] - sums[low] == (high - low) as u32
    }

    /// The lines inside a region that cut it across `axis`, and no leaf.
    pub fn cuts(&self, region: &Region, axis: Side) -> Vec<u32> {
        let [low, high] = region.sides[axis.index()];
        (low + 1..high).filter(|line| self.is_clean(region, axis, *line)).collect()
    }

    /// The leaves that a line across a region cuts.
    pub fn cut_leaves(&self, region: &Region, axis: Side, line: u32) -> Vec<usize> {
        let [low, high] = region.sides[axis.other().index()].map(|end| end as usize);
        let line = line as usize;
        let sides = (low..high).map(|at| match axis {
            Side::X => (self.owner(line - 1, at), self.owner(line, at)),
            Side::Y => (self.owner(at, line - 1), self.owner(at, line)),
        });
        let mut cut: Vec<usize> = sides.filter(|(a, b)| a == b).map(|(a, _)| a as usize).collect();
        cut.dedup();
        cut
    }

    /// The parts of a region between lines across `axis`.
    pub fn parts<'c>(
        &self,
        region: &Region,
        axis: Side,
        cuts: &'c [u32],
    ) -> impl Iterator<Item = Region> + use<'c> {
        let [low, high] = region.sides[axis.index()];
        let region = *region;
        let lows = std::iter::once(low).chain(cuts.iter().copied());
        let highs = cuts.iter().copied().chain(std::iter::once(high));
        lows.zip(highs).map(move |(low, high)| region.part(axis, low, high))
    }
}

/// A structure: what a region holds in which order, whatever its size.
pub type StructureId = u32;

/// The structures of regions. Two regions have one if they can be cut by as many lines into parts of the same
/// structures, along both axes (seed 4, section 5.0.4: a group is its subgroups and their arrangement, not its size).
#[derive(Default)]
pub struct Structures {
    known: FxHashMap<Form, StructureId>,
    of: FxHashMap<Region, StructureId>,
    forms: Vec<Form>,
}

/// Why a region has no structure.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Stuck {
    /// No straight line cuts this part of it.
    NoCut(Region),
    /// Cuts stand in cuts more than [`MOST_DEEP`] deep.
    Deep,
}

/// Grammars have no more levels than about twice as many.
const MOST_DEEP: usize = 100;

#[derive(Clone, PartialEq, Eq, Hash, Debug)]
enum Form {
    Leaf(u32),
    /// The parts between all lines across x, and between all lines across y; none where there is no line.
    Cut([Vec<StructureId>; 2]),
}

impl Structures {
    /// # Errors
    ///
    /// Where no straight line cuts a region, or they cut it too deep.
    pub fn of(&mut self, cutter: &Cutter, region: &Region) -> Result<StructureId, Stuck> {
        self.within(cutter, region, 0)
    }

    fn within(&mut self, cutter: &Cutter, region: &Region, depth: usize) -> Result<StructureId, Stuck> {
        if depth > MOST_DEEP {
            return Err(Stuck::Deep);
        }
        if let Some(known) = self.of.get(region) {
            return Ok(*known);
        }
        let form = match cutter.only_leaf(region) {
            Some(leaf) => Form::Leaf(cutter.label(leaf)),
            None => {
                let mut parts = [Vec::new(), Vec::new()];
                for axis in Side::ALL {
                    let cuts = cutter.cuts(region, axis);
                    if !cuts.is_empty() {
                        let parts_of = cutter
                            .parts(region, axis, &cuts)
                            .map(|part| self.within(cutter, &part, depth + 1));
                        parts[axis.index()] = parts_of.collect::<Result<_, _>>()?;
                    }
                }
                if parts.iter().all(Vec::is_empty) {
                    return Err(Stuck::NoCut(*region));
                }
                Form::Cut(parts)
            }
        };
        let next = self.forms.len() as StructureId;
        let id = *self.known.entry(form.clone()).or_insert(next);
        if id == next {
            self.forms.push(form);
        }
        self.of.insert(*region, id);
        Ok(id)
    }

    /// How many structures there are.
    pub fn count(&self) -> usize {
        self.forms.len()
    }
}

/// The layout with lines through leaves of `soft` labels where nothing else can be cut: a wall that reaches round a
/// window as the sails of a mill do is two walls then.
///
/// # Errors
///
/// Where only hard leaves are in the way.
pub fn made_cuttable(layout: Layout, soft: &[bool]) -> Result<Layout, FacadeError> {
    let mut layout = layout;
    for _ in 0..=MOST_DIVIDED {
        let cutter = Cutter::new(&layout)?;
        let stuck = match Structures::default().of(&cutter, &cutter.whole()) {
            Ok(_) => return Ok(layout),
            Err(Stuck::Deep) => return Err(FacadeError::Deep { most: MOST_DEEP }),
            Err(Stuck::NoCut(region)) => region,
        };
        let lines = Side::ALL.into_iter().flat_map(|axis| {
            let [low, high] = stuck.sides[axis.index()];
            (low + 1..high).map(move |line| (axis, line))
        });
        let cut = lines.map(|(axis, line)| (cutter.cut_leaves(&stuck, axis, line), axis, line));
        let is_soft = |leaf: &usize| soft[cutter.label(*leaf) as usize];
        let best =
            cut.filter(|(leaves, ..)| leaves.iter().all(is_soft)).min_by_key(|(leaves, ..)| leaves.len());
        let Some((leaves, axis, line)) = best else {
            let [from, to] =
                [0, 1].map(|end| Side::ALL.map(|axis| cutter.place(axis, stuck.sides[axis.index()][end])));
            return Err(FacadeError::NoCut { from, to });
        };
        layout = layout.divided(&leaves, axis, cutter.place(axis, line));
    }
    Err(FacadeError::NoCut { from: [0, 0], to: layout.size() })
}

/// So many lines through leaves are enough for any facade.
const MOST_DIVIDED: usize = 1000;
