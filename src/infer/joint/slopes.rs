//! Courses over one another, each narrower than the one below by the same step, as in roofs of stairs: the same
//! operation on what is left of the box, until that is short.

use super::boxes::Boxes;
use super::corpus::{Class, Corpus, Place};
use crate::space::{Axis, Bounds, Cell};

/// What is taken from a box to get to the box of the next course.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Peel {
    /// The height of a course.
    pub rise: i32,
    /// By how much the next one is narrower at the low end and at the high end, along x and along z.
    pub runs: [(i32, i32); 2],
}

/// A slope ends where what is left is no longer than this along any of the axes.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum End {
    /// Along the axes on which courses get narrower.
    Run(i32),
    /// Along y.
    Rise(i32),
}

/// A slope that all boxes can be described by.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Slope {
    pub peel: Peel,
    pub end: End,
}

/// Courses over one another; fewer could be any two things of which one is narrower.
const FEWEST: i32 = 2;

impl Peel {
    /// Every way to peel: on one side, on two, and on all four; flat, even and steep.
    fn all() -> impl Iterator<Item = Peel> {
        let one = [(1, 1), (1, 0), (0, 1)].into_iter().flat_map(|run| [(1, run), (2, run)]);
        let one = one.chain([(1, (2, 2))]);
        let by_axis =
            one.flat_map(|(rise, run)| [[run, (0, 0)], [(0, 0), run]].map(|runs| Peel { rise, runs }));
        by_axis.chain([1, 2].map(|rise| Peel { rise, runs: [(1, 1); 2] }))
    }

    /// The axes on which courses get narrower, with by how much at both ends.
    pub fn runs(&self) -> impl Iterator<Item = (Axis, (i32, i32))> + Clone + use<> {
        [Axis::X, Axis::Z].into_iter().zip(self.runs).filter(|(_, run)| *run != (0, 0))
    }

    /// How much shorter the next box is.
    pub fn step(&self, axis: Axis) -> i32 {
        let [x, z] = self.runs.map(|(low, high)| low + high);
        axis.of(Cell::new(x, self.rise, z))
    }

    /// What is left of a box of that size behind so many courses.
    fn left(&self, size: Cell, courses: i32) -> Bounds {
        let [(west, east), (north, south)] = self.runs;
        Bounds::new(Cell::new(west, self.rise, north) * courses, size - Cell::new(east, 0, south) * courses)
    }

    /// What is left behind so many courses, before it gets narrower again: all above the course.
    fn above(&self, size: Cell, courses: i32) -> Bounds {
        let left = self.left(size, courses);
        left.slab(Axis::Y, left.min.y + self.rise, left.max.y)
    }

    fn course(&self, size: Cell, courses: i32) -> Bounds {
        let left = self.left(size, courses);
        left.slab(Axis::Y, left.min.y, left.min.y + self.rise)
    }

    /// How many courses a class has at the most: each reaches to its ends, above which there is air.
    fn most(&self, corpus: &Corpus, class: Class) -> i32 {
        let place = corpus.profile(class).place;
        let size = place.bounds.size();
        (0..).take_while(|courses| self.is_course(corpus, place, size, *courses)).count() as i32
    }

    fn is_course(&self, corpus: &Corpus, Place { example, bounds }: Place, size: Cell, courses: i32) -> bool {
        let next = self.left(size, courses + 1);
        if next.size().min_element() < 1 {
            return false;
        }
        let volume = corpus.volume(Place { example, bounds });
        let is_air = |cell: Cell| volume.get(bounds.min + cell) == corpus.air;
        let (course, above) = (self.course(size, courses), self.above(size, courses));
        let is_beside = |ends: Bounds| {
            let mut beside = ends.cells().filter(|cell| !next.contains(*cell));
            beside.all(is_air)
        };
        ends(self, course).all(|end| !end.cells().all(is_air))
            && ends(self, above).all(is_beside)
            && !volume.is_whole_across(bounds, Axis::Y, above.min.y)
    }
}

/// What is beside the next course at the ends of a box.
fn ends(peel: &Peel, bounds: Bounds) -> impl Iterator<Item = Bounds> {
    peel.runs().flat_map(move |(axis, (low, high))| {
        let (from, to) = (axis.of(bounds.min), axis.of(bounds.max));
        [(from, from + low), (to - high, to)]
            .into_iter()
            .filter(|(from, to)| from < to)
            .map(move |(from, to)| bounds.slab(axis, from, to))
    })
}

impl Slope {
    /// Every slope of the boxes.
    pub fn of(corpus: &mut Corpus, boxes: &Boxes) -> Vec<Slope> {
        let heights = boxes.classes().map(|class| corpus.profile(class).len(Axis::Y));
        if heights.max().unwrap_or(0) <= FEWEST {
            return Vec::new();
        }
        Peel::all().flat_map(|peel| peeled(corpus, boxes, peel)).collect()
    }

    /// How many courses there are in a box of that size.
    pub fn courses(&self, size: Cell) -> i32 {
        let left = |axis: Axis, most: i32| (axis.of(size) - most).max(0) as u32;
        let courses =
            |(axis, most): (Axis, i32)| left(axis, most).div_ceil(self.peel.step(axis) as u32) as i32;
        self.ends().map(courses).min().unwrap_or(0)
    }

    /// The lengths up to which nothing more is peeled off.
    pub fn ends(&self) -> impl Iterator<Item = (Axis, i32)> + use<> {
        let (rise, run) = match self.end {
            End::Run(most) => (None, Some(most)),
            End::Rise(most) => (Some((Axis::Y, most)), None),
        };
        let runs = self.peel.runs();
        rise.into_iter()
            .chain(run.into_iter().flat_map(move |most| runs.clone().map(move |(axis, _)| (axis, most))))
    }

    /// The courses of a box, from the lowest on.
    pub fn courses_of(&self, corpus: &mut Corpus, class: Class) -> Vec<Class> {
        let size = corpus.profile(class).size();
        (0..self.courses(size)).map(|number| corpus.inside(class, self.peel.course(size, number))).collect()
    }

    /// What is left of a box behind its last course.
    pub fn end_of(&self, corpus: &mut Corpus, class: Class) -> Class {
        let size = corpus.profile(class).size();
        corpus.inside(class, self.peel.left(size, self.courses(size)))
    }

    /// Each course with all above it.
    pub fn seams_of(&self, corpus: &mut Corpus, class: Class) -> Vec<[Class; 2]> {
        let size = corpus.profile(class).size();
        let seam = |number: i32| {
            [self.peel.course(size, number), self.peel.above(size, number)]
                .map(|part| corpus.inside(class, part))
        };
        (0..self.courses(size)).map(seam).collect()
    }

    /// The courses of all boxes, and what is left of each.
    pub fn parts(&self, corpus: &mut Corpus, boxes: &Boxes) -> [Boxes; 2] {
        let (mut courses, mut ends) = (Vec::new(), Vec::new());
        for (class, count) in boxes.iter() {
            courses.extend(self.courses_of(corpus, class).into_iter().map(|course| (course, count)));
            ends.push((self.end_of(corpus, class), count));
        }
        [courses, ends].map(Boxes::of)
    }
}

/// The slopes that peel in one way: as far up as all boxes go.
fn peeled(corpus: &mut Corpus, boxes: &Boxes, peel: Peel) -> Vec<Slope> {
    let mut all = Vec::with_capacity(boxes.kinds());
    for class in boxes.classes() {
        let most = corpus.peeled(class, peel, |corpus| peel.most(corpus, class));
        if most == 0 {
            return Vec::new();
        }
        all.push((corpus.profile(class).size(), most));
    }
    let mut slopes: Vec<Slope> = Vec::new();
    for end in [End::Run, End::Rise] {
        let slope = lowest(&all, peel, end);
        let is_other = |known: &Slope| {
            slope
                .is_some_and(|slope| all.iter().any(|(size, _)| slope.courses(*size) != known.courses(*size)))
        };
        if slopes.iter().all(is_other) {
            slopes.extend(slope);
        }
    }
    slopes
}

/// The slope that goes on for as long as all boxes do.
fn lowest(boxes: &[(Cell, i32)], peel: Peel, end: fn(i32) -> End) -> Option<Slope> {
    let steps = Slope { peel, end: end(0) }.ends().map(|(axis, _)| peel.step(axis));
    let least = steps.max().unwrap_or(1);
    let longest = boxes.iter().map(|(size, _)| size.max_element()).max().unwrap_or(0);
    let slopes = (least..longest).map(|most| Slope { peel, end: end(most) });
    let found =
        slopes.into_iter().find(|slope| boxes.iter().all(|(size, most)| slope.courses(*size) <= *most))?;
    let courses = || boxes.iter().map(|(size, _)| found.courses(*size));
    (courses().all(|courses| courses > 0) && courses().any(|courses| courses >= FEWEST)).then_some(found)
}
