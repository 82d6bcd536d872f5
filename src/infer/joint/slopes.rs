//! Courses over one another, each narrower than the one below by the same step, as in roofs of stairs: the same
//! operation on what is left of the box, until that is short.

use super::boxes::Boxes;
use super::corpus::{Class, Corpus, Place};
use super::peel::Peel;
use crate::space::{Axis, Bounds, Cell};

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
    /// How high what is left behind the last course is, if there may be air above it or none.
    pub cap: Option<i32>,
}

/// Courses over one another; fewer could be any two things of which one is narrower.
const FEWEST: i32 = 2;

/// How many courses a class has at the most: each reaches to its ends, above which there is air.
fn most(corpus: &Corpus, class: Class, peel: &Peel) -> i32 {
    (0..).take_while(|courses| is_course(corpus, class, peel, *courses)).count() as i32
}

fn is_course(corpus: &Corpus, class: Class, peel: &Peel, courses: i32) -> bool {
    let place = corpus.profile(class).place;
    let size = place.bounds.size();
    let next = peel.left(size, courses + 1);
    if next.size().min_element() < 1 {
        return false;
    }
    let volume = corpus.volume(place);
    let is_air = |cell: Cell| volume.get(place.bounds.min + cell) == corpus.air;
    let (course, above) = (peel.course(size, courses), peel.above(size, courses));
    let is_beside = |ends: Bounds| {
        let mut beside = ends.cells().filter(|cell| !next.contains(*cell));
        beside.all(is_air)
    };
    ends(peel, course).all(|end| !end.cells().all(is_air))
        && ends(peel, above).all(is_beside)
        && !corpus.is_whole_across(class, Axis::Y, above.min.y)
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
        let left = self.peel.left(size, self.courses(size));
        let high = self.cap.map_or(left.max.y, |cap| left.min.y + cap);
        corpus.inside(class, left.slab(Axis::Y, left.min.y, high))
    }

    /// The slope with a cap, if there is as much below the air behind each last course and air at all.
    fn capped(self, corpus: &mut Corpus, boxes: &Boxes) -> Slope {
        let End::Run(_) = self.end else { return self };
        let ends: Vec<Class> = boxes.classes().map(|class| self.end_of(corpus, class)).collect();
        let filled = |class: &Class| {
            let Place { bounds, .. } = corpus.profile(*class).place;
            let volume = corpus.volume(corpus.profile(*class).place);
            let filled = bounds.cells().filter(|cell| volume.get(*cell) != corpus.air);
            filled.map(|cell| cell.y + 1 - bounds.min.y).max().unwrap_or(0)
        };
        let mut heights = ends.iter().map(filled);
        let cap = heights.next().filter(|first| *first > 0 && heights.all(|height| height == *first));
        let is_higher = |cap: &i32| ends.iter().any(|class| corpus.profile(*class).len(Axis::Y) > *cap);
        Slope { cap: cap.filter(is_higher), ..self }
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
        let most = corpus.peeled(class, peel, |corpus| most(corpus, class, &peel));
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
    slopes.into_iter().map(|slope| slope.capped(corpus, boxes)).collect()
}

/// The slope that goes on for as long as all boxes do.
fn lowest(boxes: &[(Cell, i32)], peel: Peel, end: fn(i32) -> End) -> Option<Slope> {
    let steps = Slope { peel, end: end(0), cap: None }.ends().map(|(axis, _)| peel.step(axis));
    let least = steps.max().unwrap_or(1);
    let longest = boxes.iter().map(|(size, _)| size.max_element()).max().unwrap_or(0);
    let slopes = (least..longest).map(|most| Slope { peel, end: end(most), cap: None });
    let found =
        slopes.into_iter().find(|slope| boxes.iter().all(|(size, most)| slope.courses(*size) <= *most))?;
    let courses = || boxes.iter().map(|(size, _)| found.courses(*size));
    (courses().all(|courses| courses > 0) && courses().any(|courses| courses >= FEWEST)).then_some(found)
}

#[cfg(test)]
mod tests {
    use super::super::volume::Volume;
    use super::*;
    use ndarray::Array3;

    const AIR: u32 = 0;

    /// Houses three blocks wide as they are seen from the side, and their boxes.
    fn seen(houses: &[&[&str]]) -> (Corpus, Boxes) {
        let volume = |house: &&[&str]| {
            let cell = |(y, z, _): (usize, usize, usize)| match house[house.len() - 1 - y].as_bytes()[z] {
                b'.' => AIR,
                block => u32::from(block),
            };
            Volume::new(Array3::from_shape_fn((house.len(), house[0].len(), 3), cell), &[])
        };
        let mut corpus = Corpus::new(houses.iter().map(volume).collect(), AIR);
        let places = corpus.examples();
        let boxes = Boxes::of(places.into_iter().map(|place| (corpus.class(place), 1)));
        (corpus, boxes)
    }

    fn along_z(rise: i32, low: i32, high: i32) -> Peel {
        Peel { rise, runs: [(0, 0), (low, high)] }
    }

    #[test]
    fn roofs_of_any_width_are_one_slope() {
        let (mut corpus, boxes) = seen(&[
            &[".....", "..=..", "./#>.", "/###>"],
            &["..==..", "./##>.", "/####>"],
            &["...=...", "../#>..", "./###>.", "/#####>"],
        ]);
        let slope = Slope { peel: along_z(1, 1, 1), end: End::Run(2), cap: Some(1) };
        assert!(Slope::of(&mut corpus, &boxes).contains(&slope));
        let [courses, ends] = slope.parts(&mut corpus, &boxes);
        assert_eq!((courses.count(), ends.count(), ends.kinds()), (7, 3, 2));
        assert!(ends.classes().all(|class| corpus.profile(class).is_uniform()));
    }

    #[test]
    fn a_slope_may_end_below_its_ridge() {
        let low: &[&str] = &["../##>..", "./####>.", "/######>"];
        let high: &[&str] = &[".../>...", "../##>..", "./####>.", "/######>"];
        let (mut corpus, boxes) = seen(&[low, high]);
        let slopes = Slope::of(&mut corpus, &boxes).into_iter();
        let ends: Vec<End> =
            slopes.filter(|slope| slope.peel == along_z(1, 1, 1)).map(|slope| slope.end).collect();
        assert_eq!(ends, [End::Run(4), End::Rise(1)]);
    }

    #[test]
    fn lean_tos_and_flat_roofs_have_steps_of_their_own() {
        let cases: [(&[&str], Option<Peel>); 3] = [
            (&["/...", "#/..", "##/.", "###/"], Some(along_z(1, 0, 1))),
            (&["....==....", "..==##==..", "==######=="], Some(along_z(1, 2, 2))),
            (&["####", "#..#", "#..#", "####"], None),
        ];
        for (house, peel) in cases {
            let (mut corpus, boxes) = seen(&[house]);
            let found: Vec<Peel> =
                Slope::of(&mut corpus, &boxes).into_iter().map(|slope| slope.peel).collect();
            assert!(peel.map_or(found.is_empty(), |peel| found.contains(&peel)), "{house:?}: {found:?}");
        }
    }
}
