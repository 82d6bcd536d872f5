//! The search: one operation for all boxes of a rule, and the same again for what it makes of them.

use super::alternation::{Alternation, units_and_separators};
use super::boxes::Boxes;
use super::corpus::{Class, Corpus};
use super::dependence;
use super::estimate::{ALTERNATION, ALTERNATIVE, Estimates, REPEAT, SLOPE, choice, of_row};
use super::groups::groupings;
use super::laws::{Law, Seen, fitted};
use super::memo::Memo;
use super::plan::{self, Form, How, NodeId, Plan};
use super::planes::{Plane, Stands, planes};
use super::recolour::{ARGUMENT, CALL, Recoloured, Recolouring};
use super::repeats::Period;
use super::rows::Row;
use super::sides::Sides;
use super::slopes::Slope;
use super::stretch;
use crate::space::Axis;
use rustc_hash::{FxHashMap, FxHashSet};
use smallvec::SmallVec;

/// What is known while examples are explained.
pub struct Explainer<'c> {
    pub corpus: &'c mut Corpus,
    pub plan: Plan,
    estimates: &'c mut Estimates,
    memo: Memo,
    recolourings: FxHashMap<Boxes, Option<Recolouring>>,
    /// Boxes that are mixed with no other: they are told apart from them, and keep their sizes.
    kept: FxHashSet<Boxes>,
    /// Boxes that are told apart before anything else is tried, and by which choice, from the best estimate on.
    first: Option<(Boxes, usize)>,
    /// How much all searches together may look at.
    most_asked: u64,
}

/// How many steps to look ahead: where it is none, what is estimated best is taken; else the steps that are
/// estimated best are tried and the one is taken whose whole description is shortest.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Search(pub u8);

/// So many cuts and repeats are tried, and so many choices.
const CUTS: usize = 4;
const CHOICES: usize = 3;
/// So many steps that draw nothing apart are looked for.
const SURE: usize = 8;
/// Steps are tried whose estimate is so near to the best.
const SLACK: f64 = 30.0;
const SLACK_SHARE: f64 = 0.2;

/// Bits of taking two parts for one rule, which is right where they share more than a few slices.
const SHARED: f64 = 40.0;

/// Boxes that are looked at before the search is cut short: a few seconds of work.
const MOST_ASKED: u64 = 6_000_000;
/// The same for each example, where there are many; and whatever there are.
const MOST_ASKED_EACH: u64 = 1_600_000;
const MOST_ASKED_EVER: u64 = 32_000_000;
/// Looking one step ahead, with repairs and pooling, takes at least so many times as much as taking what is estimated best.
const AHEAD_TAKES: u64 = 3;

/// What stands for all that is not searched for any more.
const UNKNOWN: u32 = u32::MAX;

/// Where the parts of a split start, but for the first.
type Starts = SmallVec<[i32; 4]>;

/// One way to explain boxes.
#[derive(Clone, Debug)]
enum Step {
    Cut(Plane),
    Sides(Sides),
    Repeat(Period),
    Row(Row),
    Slope(Slope),
    Alternate(Alternation),
    Choose(Vec<Boxes>),
    /// Each material of its own, of one description with parameters.
    Call(Recolouring),
}

impl<'c> Explainer<'c> {
    /// Begins a search. What was found out of the boxes before, by other searches, is known.
    pub fn new(corpus: &'c mut Corpus, estimates: &'c mut Estimates) -> Explainer<'c> {
        let (plan, memo, recolourings, kept) = Default::default();
        let of_all = MOST_ASKED_EACH * corpus.examples().len() as u64;
        let most_asked = of_all.clamp(MOST_ASKED, MOST_ASKED_EVER);
        corpus.begin(most_asked / AHEAD_TAKES);
        Explainer { corpus, plan, estimates, memo, recolourings, kept, first: None, most_asked }
    }

    /// Whether a node is a choice in which most boxes share nothing with any other.
    pub fn tells_most_apart(&self, node: NodeId, boxes: &Boxes) -> bool {
        let node = self.plan.node(node);
        let Form::Choose(children) = &node.form else { return false };
        let mut classes = vec![0; children.len()];
        let chosen = boxes.classes().filter_map(|class| match node.how.get(&class) {
            Some(How::Choose(number)) => Some(*number),
            _ => None,
        });
        chosen.for_each(|number| classes[number] += 1);
        let is_call = |child: &NodeId| matches!(self.plan.node(*child).form, Form::Call { .. });
        let alone = children.iter().zip(classes).filter(|(child, count)| *count == 1 && !is_call(child));
        2 * alone.count() > boxes.kinds()
    }

    /// Whether so much was looked at that the search was cut short: then its nodes describe nothing.
    pub fn is_spent(&self) -> bool {
        self.corpus.is_spent()
    }

    /// From now on there is enough left to look ahead, but for what was `used` by other searches.
    pub fn look_ahead(&mut self, used: u64) {
        self.corpus.most_asked = self.most_asked.saturating_sub(used);
    }

    /// Tells boxes apart before anything else is tried, by the choice of that number from the best estimate on; whether
    /// there is such.
    pub fn tell_apart_first(&mut self, boxes: &Boxes, choice: usize) -> bool {
        self.first = Some((boxes.clone(), choice));
        self.first_choice(boxes).is_some()
    }

    fn first_choice(&mut self, boxes: &Boxes) -> Option<Step> {
        let choice = self.first.as_ref().filter(|(first, _)| first == boxes).map(|(_, choice)| *choice)?;
        let mut steps = self.steps(boxes);
        // Boxes each by itself share nothing.
        steps.retain(|(_, step)| matches!(step, Step::Choose(groups) if groups.len() < boxes.kinds()));
        steps.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        steps.into_iter().nth(choice).map(|(_, step)| step)
    }

    /// Mixes these boxes with no other any more, once they are explained again; whether that is new.
    pub fn keep(&mut self, boxes: &Boxes) -> bool {
        let is_new = self.kept.insert(boxes.clone());
        if is_new {
            self.memo.forget(boxes);
        }
        is_new
    }

    /// Boxes that end in `last` never stand before boxes that begin with `first` any more, once all is explained again;
    /// whether that is new.
    pub fn tear(&mut self, last: Class, first: Class, axis: Axis) -> bool {
        let is_new = self.corpus.tear(last, first, axis);
        if is_new {
            self.memo = Memo::default();
        }
        is_new
    }

    /// All that was explained on the way to `boxes` and is part of how they are described, by its node.
    pub fn in_use(&mut self, boxes: &Boxes, search: Search) -> FxHashMap<NodeId, Vec<Boxes>> {
        let mut all = self.memo.in_use(boxes, search);
        if let Some(recolouring) = self.recolouring(boxes) {
            let called = self.memo.in_use(&recolouring.boxes(), search);
            called.into_iter().for_each(|(node, boxes)| all.entry(node).or_default().extend(boxes));
        }
        all
    }

    fn is_kept(&self, boxes: &Boxes) -> bool {
        self.kept.contains(boxes)
    }

    /// The bits of one description of all boxes, before it is searched for.
    pub fn estimate(&mut self, boxes: &Boxes) -> f64 {
        self.estimates.bits(self.corpus, boxes)
    }

    /// How boxes that may be mixed are one description in several materials, if they are.
    pub fn recolouring(&mut self, boxes: &Boxes) -> Option<Recolouring> {
        if boxes.kinds() < 2 || self.is_kept(boxes) {
            return None;
        }
        if let Some(known) = self.recolourings.get(boxes) {
            return known.clone();
        }
        let found = Recolouring::of(self.corpus, boxes);
        self.recolourings.insert(boxes.clone(), found.clone());
        found
    }

    /// The bits of one description in several materials, before it is searched for.
    pub fn estimate_calls(&mut self, recolouring: &Recolouring) -> f64 {
        let counts: Vec<u32> = recolouring.groups.iter().map(Recoloured::count).collect();
        let call = CALL + ARGUMENT * recolouring.parameters.len() as f64;
        let calls = (ALTERNATIVE + call) * counts.len() as f64 + choice(counts.iter());
        calls + self.estimate(&recolouring.boxes())
    }

    /// The node that describes whole examples: as they are, or with parameters for their materials where that is
    /// shorter.
    pub fn explain_examples(&mut self, boxes: &Boxes, search: Search) -> NodeId {
        let plain = self.explain(boxes, search);
        let Some(recolouring) = self.recolouring(boxes) else { return plain };
        let calls = self.calls(&recolouring, search);
        let called = self.called(&recolouring, &calls, boxes);
        let bits = [plain, called].map(|node| plan::bits(&self.plan, self.corpus, node, boxes));
        if bits[1] < bits[0] { called } else { plain }
    }

    /// Calls of one description with the materials of each group.
    pub fn calls(&mut self, recolouring: &Recolouring, search: Search) -> Vec<NodeId> {
        let child = self.explain(&recolouring.boxes(), search);
        let call = |(number, group): (usize, &Recoloured)| {
            let (parameters, arguments) = (recolouring.parameters.clone(), group.arguments.clone());
            let described = recolouring.described(self.corpus, number);
            let how = described.into_iter().map(|(class, other)| (class, How::Call(other)));
            self.plan.add(Form::Call { parameters, arguments, child }, how)
        };
        recolouring.groups.iter().enumerate().map(call).collect()
    }

    /// The choice between calls that describes `boxes`.
    pub fn called(&mut self, recolouring: &Recolouring, calls: &[NodeId], boxes: &Boxes) -> NodeId {
        let shared_out = recolouring.shared_out(self.corpus, boxes);
        self.plan.choose(shared_out.into_iter().map(|(class, number)| (class, calls[number])).collect())
    }

    /// The node that describes all `boxes`; any, once the search is cut short.
    pub fn explain(&mut self, boxes: &Boxes, search: Search) -> NodeId {
        if self.is_spent() {
            return self.plan.add(Form::Fill(UNKNOWN), []);
        }
        if let Some(known) = self.memo.get(boxes, search) {
            return known;
        }
        self.memo.begin(boxes, search);
        let node = match boxes.fill(self.corpus) {
            Some(terminal) => {
                let how = boxes.classes().map(|class| (class, How::Fill));
                self.plan.add(Form::Fill(terminal), how)
            }
            None => {
                let step = self.best(boxes, search);
                self.memo.drop_uses();
                self.take(boxes, &step, search)
            }
        };
        self.memo.end(node);
        node
    }

    fn take(&mut self, boxes: &Boxes, step: &Step, search: Search) -> NodeId {
        match step {
            Step::Cut(plane) => self.cut(boxes, plane, search),
            Step::Sides(sides) => self.sides(boxes, sides, search),
            Step::Repeat(period) => self.repeat(boxes, *period, search),
            Step::Row(row) => self.row(boxes, row, search),
            Step::Slope(slope) => self.slope(boxes, *slope, search),
            Step::Alternate(alternation) => self.alternate(boxes, *alternation, search),
            Step::Choose(groups) => self.choose(groups, search),
            Step::Call(recolouring) => {
                let calls = self.calls(recolouring, search);
                self.called(recolouring, &calls, boxes)
            }
        }
    }

    /// The best step by the estimate, or of the best ones by what comes of each.
    fn best(&mut self, boxes: &Boxes, search: Search) -> Step {
        if let Some(first) = self.first_choice(boxes) {
            return first;
        }
        let steps = self.steps_in_order(boxes);
        let mut tried: Vec<Step> = match search.0 == 0 {
            true => steps.into_iter().map(|(_, step)| step).take(1).collect(),
            false => worth_trying(steps),
        };
        if tried.len() > 1 {
            let bits: Vec<f64> = tried.iter().map(|step| self.bits(boxes, step, search)).collect();
            let best = (0..tried.len()).min_by(|a, b| bits[*a].total_cmp(&bits[*b]));
            tried.swap(0, best.unwrap_or(0));
        }
        // Every set of boxes that is not of one block can be cut or told apart.
        tried.into_iter().next().unwrap_or_else(|| Step::Choose(boxes.each()))
    }

    /// The bits of all that comes of a step, looking one step less ahead.
    fn bits(&mut self, boxes: &Boxes, step: &Step, search: Search) -> f64 {
        let node = self.take(boxes, step, Search(search.0 - 1));
        plan::bits(&self.plan, self.corpus, node, boxes)
    }

    /// The steps from the best estimate on. Whether parts go together is asked of the first ones only: it takes
    /// longer than the rest.
    fn steps_in_order(&mut self, boxes: &Boxes) -> Vec<(f64, Step)> {
        let mut steps = self.steps(boxes);
        steps.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        let mut sure = 0;
        let mut told: Vec<(f64, Step)> = Vec::with_capacity(steps.len());
        for (bits, step) in steps {
            if sure >= SURE || self.is_spent() {
                break;
            }
            let apart = self.apart(boxes, &step);
            sure += usize::from(apart == 0.0);
            told.push((bits + apart, step));
        }
        told.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        told
    }

    /// The bits of drawing apart what a step parts.
    fn apart(&mut self, boxes: &Boxes, step: &Step) -> f64 {
        match step {
            Step::Cut(plane) => {
                let rows = dependence::halves(self.corpus, boxes, plane.axis, &plane.at);
                let placed = match plane.stands {
                    Stands::Freely => dependence::placed(self.corpus, &rows, plane.axis),
                    Stands::ByLaw => 0.0,
                };
                placed + dependence::dependence(self.corpus, &rows, plane.axis)
            }
            Step::Sides(sides) => {
                let rows = sides.rows(self.corpus, boxes);
                dependence::dependence(self.corpus, &rows, sides.axis)
            }
            Step::Repeat(period) => {
                let units = dependence::units(self.corpus, boxes, *period);
                dependence::of_units(self.corpus, &units, period.axis)
            }
            Step::Row(row) => {
                let cells = |(class, count)| (self.corpus.row(class, row.axis).to_vec(), count);
                let rows: Vec<(Vec<Class>, u32)> = boxes.iter().map(cells).collect();
                dependence::of_cells(self.corpus, &rows, row.axis)
            }
            Step::Slope(slope) => dependence::of_courses(self.corpus, boxes, slope),
            Step::Alternate(alternation) => {
                let rows = alternation.rows(self.corpus, boxes);
                dependence::of_alternation(self.corpus, &rows, alternation.axis)
            }
            Step::Call(recolouring) => dependence::of_calls(self.corpus, &recolouring.called()),
            Step::Choose(_) => 0.0,
        }
    }

    fn steps(&mut self, boxes: &Boxes) -> Vec<(f64, Step)> {
        let mut steps = Vec::new();
        for groups in groupings(self.corpus, boxes) {
            let bits = self.estimates.alternatives(self.corpus, &groups);
            steps.push((bits, Step::Choose(groups)));
        }
        if boxes.kinds() > 1 && self.is_kept(boxes) {
            return steps;
        }
        for plane in planes(self.corpus, boxes) {
            if self.is_spent() {
                break;
            }
            let [left, right] = plane.halves(self.corpus, boxes);
            let halves = self.halves(&left, &right, plane.axis);
            steps.push((plane.bits + halves, Step::Cut(plane)));
        }
        for sides in Sides::of(self.corpus, boxes) {
            let parts = sides.parts(self.corpus, boxes);
            let bits = sides.bits + parts.iter().map(|part| self.estimate(part)).sum::<f64>();
            steps.push((bits, Step::Sides(sides)));
        }
        for period in Period::of(self.corpus, boxes) {
            if period.before == 0 && period.behind == 0 {
                let units = period.units(self.corpus, boxes);
                if units.kinds() > 1 && self.is_kept(boxes) {
                    continue;
                }
                steps.push((REPEAT + self.estimates.bits(self.corpus, &units), Step::Repeat(period)));
            }
        }
        if let Some(row) = Row::of(self.corpus, boxes).filter(|_| !self.is_kept(boxes)) {
            steps.push((of_row(&row), Step::Row(row)));
        }
        for slope in Slope::of(self.corpus, boxes) {
            let [courses, ends] = slope.parts(self.corpus, boxes);
            if !self.is_kept(boxes) {
                let bits = SLOPE + self.estimate(&courses) + self.estimate(&ends);
                steps.push((bits, Step::Slope(slope)));
            }
        }
        for alternation in Alternation::of(self.corpus, boxes) {
            if let Some(bits) = self.alternating(boxes, alternation) {
                steps.push((bits, Step::Alternate(alternation)));
            }
        }
        if let Some(recolouring) = self.recolouring(boxes) {
            steps.push((self.estimate_calls(&recolouring), Step::Call(recolouring)));
        }
        steps
    }

    /// The estimate of an alternation, unless it would mix what is kept apart.
    fn alternating(&mut self, boxes: &Boxes, alternation: Alternation) -> Option<f64> {
        let rows = alternation.rows(self.corpus, boxes);
        let parts = units_and_separators(&rows);
        let is_mixed = parts.iter().any(|part| part.kinds() > 1 && self.is_kept(part));
        let bits = parts.iter().map(|part| self.estimates.bits(self.corpus, part)).sum::<f64>();
        (!is_mixed).then_some(ALTERNATION + bits)
    }

    /// The estimate of what is on both sides of a plane, by itself or as one rule.
    fn halves(&mut self, left: &Boxes, right: &Boxes, axis: Axis) -> f64 {
        let [one, other] = [left, right].map(|half| self.estimate(half));
        let beside = [(one, left, right), (other, right, left)].map(|(bits, half, rest)| {
            if half.is_slice(self.corpus, axis) {
                bits + self.estimates.beside(self.corpus, rest, half, axis)
            } else {
                f64::INFINITY
            }
        });
        let apart = beside.into_iter().fold(one + other, f64::min);
        // Both together take as much as the dearer of them.
        match one.min(other) <= SHARED {
            true => apart,
            false => apart.min(SHARED + self.estimate(&Boxes::of(left.iter().chain(right.iter())))),
        }
    }

    fn cut(&mut self, boxes: &Boxes, plane: &Plane, search: Search) -> NodeId {
        let halves = plane.halves(self.corpus, boxes).map(|half| self.explain(&half, search));
        let at = plane.at.iter().map(|at| SmallVec::from_slice(&[*at])).collect();
        self.joined(boxes, plane.axis, &halves, at)
    }

    fn sides(&mut self, boxes: &Boxes, sides: &Sides, search: Search) -> NodeId {
        let [side, middle] = sides.parts(self.corpus, boxes).map(|part| self.explain(&part, search));
        let at = sides.middles.iter().map(|middle| SmallVec::from_slice(middle)).collect();
        self.joined(boxes, sides.axis, &[side, middle, side], at)
    }

    /// One split into what stands between planes, given for each class: what splits on the same axis is taken apart, and
    /// blocks that are equal on both sides of a plane are one part.
    fn joined(&mut self, boxes: &Boxes, axis: Axis, nodes: &[NodeId], at: Vec<Starts>) -> NodeId {
        let mut starts: Vec<(Class, u32, Starts)> = Vec::new();
        for ((class, count), planes) in boxes.iter().zip(at) {
            let spans = plan::spans(&planes, self.corpus.profile(class).len(axis));
            let mut own = Starts::new();
            for ((low, high), node) in spans.zip(nodes) {
                let part = self.corpus.part(class, axis, low, high);
                own.extend((low > 0).then_some(low));
                own.extend(self.starts(*node, axis, part).iter().map(|start| start + low));
            }
            starts.push((class, count, own));
        }
        let mut children: Vec<NodeId> = nodes.iter().flat_map(|node| self.parts(*node, axis)).collect();
        for at in (1..children.len()).rev() {
            if self.is_one_fill(children[at - 1], children[at]) {
                children.remove(at);
                starts.iter_mut().for_each(|(.., own)| {
                    own.remove(at - 1);
                });
            }
        }
        self.split(boxes, axis, &children, starts)
    }

    /// The parts that a node splits into across an axis; itself if it does not.
    fn parts(&self, node: NodeId, across: Axis) -> Vec<NodeId> {
        match &self.plan.node(node).form {
            Form::Split { axis, parts } if *axis == across => parts.iter().map(|(_, child)| *child).collect(),
            _ => vec![node],
        }
    }

    fn starts(&self, node: NodeId, across: Axis, class: Class) -> Starts {
        let node = self.plan.node(node);
        match (&node.form, node.how.get(&class)) {
            (Form::Split { axis, .. }, Some(How::Split(starts))) if *axis == across => starts.clone(),
            _ => Starts::new(),
        }
    }

    fn is_one_fill(&self, left: NodeId, right: NodeId) -> bool {
        left == right && matches!(self.plan.node(left).form, Form::Fill(_))
    }

    fn split(
        &mut self,
        boxes: &Boxes,
        axis: Axis,
        children: &[NodeId],
        starts: Vec<(Class, u32, Starts)>,
    ) -> NodeId {
        if let [only] = children {
            return *only;
        }
        let seen: Vec<Seen> = starts
            .iter()
            .map(|(class, count, starts)| {
                let spans = plan::spans(starts, self.corpus.profile(*class).len(axis));
                (spans.map(|(low, high)| high - low).collect(), *count)
            })
            .collect();
        let parts = stretch::parts(&self.plan, children, axis);
        let laws = match self.is_kept(boxes) {
            true => seen[0].0.iter().map(|len| Law::Const(*len)).collect(),
            false => fitted(&seen, &parts),
        };
        let parts = laws.into_iter().zip(children.iter().copied()).collect();
        let how = starts.into_iter().map(|(class, _, starts)| (class, How::Split(starts)));
        self.plan.add(Form::Split { axis, parts }, how)
    }

    fn repeat(&mut self, boxes: &Boxes, period: Period, search: Search) -> NodeId {
        let units = period.units(self.corpus, boxes);
        let child = self.explain(&units, search);
        let how = boxes.classes().map(|class| (class, How::Repeat));
        self.plan.add(Form::Repeat { axis: period.axis, unit: period.unit, child }, how)
    }

    fn row(&mut self, boxes: &Boxes, row: &Row, search: Search) -> NodeId {
        let mut kinds: Vec<Vec<(Class, u32)>> = vec![Vec::new(); row.kinds.len()];
        for (class, count) in boxes.iter() {
            for cell in self.corpus.row(class, row.axis).iter() {
                let kind = row.kind(self.corpus.terminal(*cell));
                kind.into_iter().for_each(|kind| kinds[kind].push((*cell, count)));
            }
        }
        let cells = kinds.into_iter().map(|cells| self.explain(&Boxes::of(cells), search)).collect();
        let how = boxes.classes().map(|class| (class, How::Row));
        self.plan.add(Form::Row { row: row.clone(), cells }, how)
    }

    fn slope(&mut self, boxes: &Boxes, slope: Slope, search: Search) -> NodeId {
        let [courses, ends] = slope.parts(self.corpus, boxes);
        let [course, end] = [courses, ends].map(|part| self.explain(&part, search));
        let how = boxes.classes().map(|class| (class, How::Slope));
        self.plan.add(Form::Slope { slope, course, end }, how)
    }

    /// Units and separators each as one rule: as parts of one split where all boxes have as many, else as a repeat of
    /// both with the last unit behind it.
    fn alternate(&mut self, boxes: &Boxes, alternation: Alternation, search: Search) -> NodeId {
        let rows = alternation.rows(self.corpus, boxes);
        let children = units_and_separators(&rows).map(|part| self.explain(&part, search));
        let Alternation { axis, unit, .. } = alternation;
        let len = |explainer: &Self, class| explainer.corpus.profile(class).len(axis);
        let parts = rows[0].0.len();
        if rows.iter().all(|(row, _)| row.len() == parts) {
            let children: Vec<NodeId> = (0..parts).map(|part| children[part % 2]).collect();
            let starts = boxes
                .iter()
                .map(|(class, count)| (class, count, alternation.planes(len(self, class)).collect()));
            return self.split(boxes, axis, &children, starts.collect());
        }
        let repeated =
            boxes.parts(self.corpus, axis, |corpus, class| (0, corpus.profile(class).len(axis) - unit));
        let repeat = self.repeat_of(&repeated, alternation, children, search);
        let starts = boxes
            .iter()
            .map(|(class, count)| (class, count, SmallVec::from_slice(&[len(self, class) - unit])));
        self.split(boxes, axis, &[repeat, children[0]], starts.collect())
    }

    /// Units with a separator behind each.
    fn repeat_of(
        &mut self,
        boxes: &Boxes,
        alternation: Alternation,
        children: [NodeId; 2],
        search: Search,
    ) -> NodeId {
        let Alternation { axis, unit, .. } = alternation;
        let period = Period { axis, before: 0, behind: 0, unit: alternation.period() };
        let units = period.units(self.corpus, boxes);
        self.memo.begin(boxes, search);
        self.memo.begin(&units, search);
        let starts = units.iter().map(|(class, count)| (class, count, SmallVec::from_slice(&[unit])));
        let child = self.split(&units, axis, &children, starts.collect());
        self.memo.end(child);
        let how = boxes.classes().map(|class| (class, How::Repeat));
        let node = self.plan.add(Form::Repeat { axis, unit: period.unit, child }, how);
        self.memo.end(node);
        node
    }

    fn choose(&mut self, groups: &[Boxes], search: Search) -> NodeId {
        let mut of = Vec::new();
        for group in groups {
            let child = self.explain(group, search);
            of.extend(group.classes().map(|class| (class, child)));
        }
        self.plan.choose(of)
    }
}

/// Of steps from the best estimate on, those that are near to it: some cuts and repeats, then some choices.
fn worth_trying(steps: Vec<(f64, Step)>) -> Vec<Step> {
    let least = steps.first().map_or(0.0, |(bits, _)| *bits);
    let worst = least + SLACK + SLACK_SHARE * least;
    let near = steps.into_iter().filter(|(bits, _)| *bits <= worst).map(|(_, step)| step);
    let is_choice = |step: &Step| matches!(step, Step::Choose(_) | Step::Call(_));
    let (choices, cuts): (Vec<Step>, Vec<Step>) = near.partition(is_choice);
    cuts.into_iter().take(CUTS).chain(choices.into_iter().take(CHOICES)).collect()
}

#[cfg(test)]
mod tests {
    use super::super::volume::Volume;
    use super::*;
    use ndarray::Array3;
    use proptest::prelude::*;

    /// Blocks at random: nothing describes them but they themselves.
    fn noise(size: usize, seed: u32) -> Volume {
        let mut state = seed;
        let mut next = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            state >> 29
        };
        Volume::new(Array3::from_shape_simple_fn((size, size, size), &mut next), &[])
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4))]

        /// However much there is to look at, the search stops soon behind its limit, at the same place each time.
        #[test]
        fn the_search_stops(seed in 0u32..1000, size in 24usize..32) {
            let asked = [(); 2].map(|()| {
                let volumes = vec![noise(size, seed), noise(size, seed + 1)];
                let mut corpus = Corpus::new(volumes, 0);
                let places = corpus.examples();
                let boxes = Boxes::of(places.into_iter().map(|place| (corpus.class(place), 1)));
                let mut estimates = Estimates::default();
                let mut explainer = Explainer::new(&mut corpus, &mut estimates);
                explainer.explain(&boxes, Search(0));
                assert!(explainer.is_spent());
                explainer.corpus.asked
            });
            prop_assert_eq!(asked[0], asked[1]);
            prop_assert!(asked[0] < MOST_ASKED);
        }
    }
}
