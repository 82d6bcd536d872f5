//! Top-down, by cost (seed 4, section 6.3): approximate dynamic programming over which lines cut each structure.
//!
//! A structure has one rule, which is used wherever it stands. What a rule costs is its description; what it makes
//! necessary is estimated by a value for each structure, which trials correct: each trial decides from the top down,
//! the likelier the cheaper, and what it came to is what the next trials expect. The best trial is then changed one
//! decision at a time as long as that makes it shorter.

use super::cuts::{Cutter, StructureId, Structures};
use super::fold::{Folding, folded};
use super::greedy;
use super::groups::{Group, Groups};
use super::plan::{Decision, Plan};
use super::rules::Rules;
use super::{Region, Side};
use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg32;
use rustc_hash::FxHashMap;

/// How rules are looked for.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Method {
    /// As seed 4's tool does: all lines at once, and the first repeat.
    Greedy,
    /// The shortest description that a search finds.
    #[default]
    Searched,
}

/// A plan and its rules.
#[derive(Clone, Debug)]
pub struct Parsed {
    pub plan: Plan,
    pub rules: Rules,
}

impl Parsed {
    fn new(plan: Plan, labels: usize) -> Parsed {
        let rules = Rules::of(&plan, labels);
        Parsed { plan, rules }
    }
}

/// The rules of a layout that straight lines cut into its leaves.
pub fn parse(
    cutter: &Cutter,
    structures: &mut Structures,
    groups: &Groups,
    labels: usize,
    method: Method,
) -> Parsed {
    let mut search = Search {
        cutter,
        structures,
        labels,
        repeated: groups.repeated().copied().collect(),
        options: FxHashMap::default(),
        values: FxHashMap::default(),
    };
    let greedy = search.greedy();
    match method {
        Method::Greedy => greedy,
        Method::Searched => {
            let searched = search.run();
            if searched.rules.length() <= greedy.rules.length() { searched } else { greedy }
        }
    }
}

/// Work that a search may do: trials times leaves.
const WORK: usize = 120_000;
/// Trials are at least and at most so many.
const TRIALS: [usize; 2] = [8, 300];
/// What a trial adds to what is expected.
const STEP: f64 = 0.3;
/// How many bits more make a decision e times less likely, at the first trial; none at the last.
const WARMTH: f64 = 24.0;
/// Bits for each leaf of a repeated group that a line cuts, once for all that share the line.
const CUT: f64 = 0.02;
/// So many random sets of lines are looked at for each axis.
const RANDOM_SETS: usize = 6;
const LARGEST_SET: usize = 5;
/// Of more structures than this all lines are taken at once: sets of lines make ever new structures.
const MOST_STRUCTURES: usize = 2_000;
/// Repeated groups of a layout that lines are asked about.
const MOST_ASKED: usize = 4_000;

/// A way to cut a structure.
#[derive(Clone, Debug)]
struct Choice {
    decision: Decision,
    /// The bits of its rule and of the groups that its lines cut.
    cost: f64,
    /// The structures that need rules then, each once.
    needs: Vec<StructureId>,
}

type Decisions = FxHashMap<StructureId, Decision>;

struct Search<'c> {
    cutter: &'c Cutter,
    structures: &'c mut Structures,
    labels: usize,
    repeated: Vec<Group>,
    options: FxHashMap<StructureId, Vec<Choice>>,
    /// The bits that a structure is expected to take with all that it needs.
    values: FxHashMap<StructureId, f64>,
}

impl Search<'_> {
    fn structure(&mut self, region: &Region) -> StructureId {
        // Every region that lines of a cuttable layout make is cuttable.
        self.structures.of(self.cutter, region).unwrap_or(0)
    }

    fn greedy(&mut self) -> Parsed {
        let (cutter, structures) = (self.cutter, &mut *self.structures);
        let mut known = Decisions::default();
        let shared = std::cell::RefCell::new(structures);
        let mut structure = |region: &Region| shared.borrow_mut().of(cutter, region).unwrap_or(0);
        let mut again = structure;
        let mut decision = |id: StructureId, region: &Region| {
            known.entry(id).or_insert_with(|| greedy::decision(cutter, region, &mut again)).clone()
        };
        let plan = Plan::of(cutter, Folding::Greedy, &mut structure, &mut decision);
        Parsed::new(plan, self.labels)
    }

    fn run(&mut self) -> Parsed {
        self.value(&self.cutter.whole());
        let trials = (WORK / self.cutter.leaves().len().max(1)).clamp(TRIALS[0], TRIALS[1]);
        let mut rng = Pcg32::seed_from_u64(0);
        let (mut decisions, mut best) = self.trial(0.0, &mut rng);
        for trial in 1..trials {
            let warmth = WARMTH * (1.0 - trial as f64 / trials as f64);
            let (other, parsed) = self.trial(warmth, &mut rng);
            if parsed.rules.length() < best.rules.length() {
                (decisions, best) = (other, parsed);
            }
        }
        self.polished(decisions, best, trials)
    }

    /// What a structure takes if all that it needs is needed by nothing else: dynamic programming from below.
    fn value(&mut self, region: &Region) -> f64 {
        if self.cutter.only_leaf(region).is_some() {
            return 0.0;
        }
        let id = self.structure(region);
        if let Some(known) = self.values.get(&id) {
            return *known;
        }
        // A structure never needs itself, as what it needs is smaller.
        let (choices, regions) = self.choices(id, region);
        self.options.insert(id, choices);
        for region in regions {
            self.value(&region);
        }
        let value =
            self.options[&id].iter().map(|choice| self.expected(choice, None)).fold(f64::INFINITY, f64::min);
        self.values.insert(id, value);
        value
    }

    /// The bits of a choice and of what it needs that has no rule yet.
    fn expected(&self, choice: &Choice, known: Option<&Decisions>) -> f64 {
        let is_new = |id: &&StructureId| known.is_none_or(|known| !known.contains_key(*id));
        let needs = choice.needs.iter().filter(is_new).filter_map(|id| self.values.get(id));
        choice.cost + needs.sum::<f64>()
    }

    /// The ways to cut a structure, and a region of each structure that they make.
    fn choices(&mut self, id: StructureId, region: &Region) -> (Vec<Choice>, Vec<Region>) {
        let mut decisions = Vec::new();
        for axis in Side::ALL {
            let cuts = self.cutter.cuts(region, axis);
            if !cuts.is_empty() {
                decisions.extend(
                    self.sets(id, region, axis, &cuts).into_iter().map(|lines| Decision { axis, lines }),
                );
            }
        }
        decisions.sort();
        decisions.dedup();
        let mut regions: FxHashMap<StructureId, Region> = FxHashMap::default();
        let choices =
            decisions.into_iter().map(|decision| self.choice(decision, region, &mut regions)).collect();
        let mut regions: Vec<(StructureId, Region)> = regions.into_iter().collect();
        regions.sort();
        (choices, regions.into_iter().map(|(_, region)| region).collect())
    }

    fn choice(
        &mut self,
        decision: Decision,
        region: &Region,
        regions: &mut FxHashMap<StructureId, Region>,
    ) -> Choice {
        let cuts = decision.cuts(self.cutter, region);
        let mut parts = Vec::with_capacity(cuts.len() + 1);
        let mut needs = Vec::new();
        for part in self.cutter.parts(region, decision.axis, &cuts) {
            let id = self.structure(&part);
            parts.push((self.cutter.length(&part, decision.axis), id));
            if self.cutter.only_leaf(&part).is_none() {
                regions.entry(id).or_insert(part);
                needs.push(id);
            }
        }
        needs.sort_unstable();
        needs.dedup();
        let cut = self.cut_leaves(region, decision.axis, &cuts);
        Choice { cost: described(&parts) + CUT * cut as f64, decision, needs }
    }

    /// The leaves in all repeated groups that lines cut (seed 4, section 5.0.5).
    fn cut_leaves(&self, region: &Region, axis: Side, cuts: &[u32]) -> u32 {
        let is_cut = |group: &&Group| {
            let [low, high] = group.region.sides[axis.index()];
            region.contains(&group.region)
                && cuts.get(cuts.partition_point(|cut| *cut <= low)).is_some_and(|cut| *cut < high)
        };
        self.repeated.iter().take(MOST_ASKED).filter(is_cut).map(|group| group.leaves).sum()
    }

    /// Sets of lines to cut a region by, of a layout with many structures all lines only. Else: all; those between repeats, and between what repeats and what does not; the one that
    /// cuts least; and some that are drawn, the likelier the less they cut.
    fn sets(&mut self, id: StructureId, region: &Region, axis: Side, cuts: &[u32]) -> Vec<Vec<u16>> {
        let all: Vec<u16> = (0..cuts.len() as u16).collect();
        let regions: Vec<Region> = self.cutter.parts(region, axis, cuts).collect();
        let ids: Vec<StructureId> = regions.iter().map(|part| self.structure(part)).collect();
        if self.options.len() >= MOST_STRUCTURES {
            return vec![all];
        }
        let mut sets = vec![all];
        for folding in [Folding::Shortest, Folding::Greedy] {
            let (mut units, mut ends, mut at) = (Vec::new(), Vec::new(), 0);
            for run in folded(&ids, folding) {
                for _ in 0..run.times {
                    at += run.unit.len();
                    units.push(at as u16 - 1);
                }
                ends.push(at as u16 - 1);
            }
            units.pop();
            ends.pop();
            sets.extend([units, ends]);
        }
        if cuts.len() > 1 {
            let costs: Vec<f64> =
                cuts.iter().map(|cut| f64::from(self.cut_leaves(region, axis, &[*cut]))).collect();
            let least = (0..cuts.len()).min_by(|a, b| costs[*a].total_cmp(&costs[*b]));
            sets.extend(least.map(|line| vec![line as u16]));
            let seed = (u64::from(id) << 1) | axis.index() as u64;
            let mut rng = Pcg32::seed_from_u64(seed);
            sets.extend((0..RANDOM_SETS).map(|_| drawn_set(&costs, &mut rng)));
        }
        sets.retain(|set| !set.is_empty());
        sets
    }

    /// One derivation from the top down, and what it comes to.
    fn trial(&mut self, warmth: f64, rng: &mut Pcg32) -> (Decisions, Parsed) {
        let mut decisions = Decisions::default();
        let mut order = Vec::new();
        let whole = self.cutter.whole();
        let mut open = vec![whole];
        while let Some(region) = open.pop() {
            let id = self.structure(&region);
            if self.cutter.only_leaf(&region).is_some() || decisions.contains_key(&id) {
                continue;
            }
            self.value(&region);
            let choice = self.drawn(id, warmth, &decisions, rng);
            let cuts = choice.decision.cuts(self.cutter, &region);
            open.extend(self.cutter.parts(&region, choice.decision.axis, &cuts));
            decisions.insert(id, choice.decision.clone());
            order.push((id, choice));
        }
        self.learn(&order);
        let parsed = self.parsed(&decisions);
        (decisions, parsed)
    }

    fn drawn(&self, id: StructureId, warmth: f64, known: &Decisions, rng: &mut Pcg32) -> Choice {
        let choices = &self.options[&id];
        let costs: Vec<f64> = choices.iter().map(|choice| self.expected(choice, Some(known))).collect();
        let least = costs.iter().copied().fold(f64::INFINITY, f64::min);
        let weight = |cost: &f64| {
            if warmth > 0.0 { (-(cost - least) / warmth).exp() } else { f64::from(u8::from(*cost == least)) }
        };
        let weights: Vec<f64> = costs.iter().map(weight).collect();
        choices[drawn(&weights, rng)].clone()
    }

    /// Corrects what structures are expected to take by what a trial came to.
    fn learn(&mut self, order: &[(StructureId, Choice)]) {
        let places: FxHashMap<StructureId, usize> =
            order.iter().enumerate().map(|(at, (id, _))| (*id, at)).collect();
        let mut seen = vec![usize::MAX; order.len()];
        for at in (0..order.len()).rev() {
            let (mut sum, mut open) = (0.0, vec![at]);
            while let Some(next) = open.pop() {
                if std::mem::replace(&mut seen[next], at) != at {
                    sum += order[next].1.cost;
                    open.extend(order[next].1.needs.iter().filter_map(|id| places.get(id)));
                }
            }
            if let Some(value) = self.values.get_mut(&order[at].0) {
                *value += STEP * (sum - *value);
            }
        }
    }

    /// The plan of decisions; what they leave open is done as expected to be shortest.
    fn parsed(&mut self, decisions: &Decisions) -> Parsed {
        let cutter = self.cutter;
        let shared = std::cell::RefCell::new(&mut *self);
        let mut structure = |region: &Region| shared.borrow_mut().structure(region);
        let mut decision = |id: StructureId, region: &Region| {
            decisions.get(&id).cloned().unwrap_or_else(|| shared.borrow_mut().likeliest(id, region))
        };
        let plan = Plan::of(cutter, Folding::Shortest, &mut structure, &mut decision);
        Parsed::new(plan, self.labels)
    }

    fn likeliest(&mut self, id: StructureId, region: &Region) -> Decision {
        self.value(region);
        let choices = self.options[&id].iter().map(|choice| (self.expected(choice, None), choice));
        let best = choices.min_by(|(a, _), (b, _)| a.total_cmp(b));
        best.map_or(Decision { axis: Side::X, lines: vec![0] }, |(_, choice)| choice.decision.clone())
    }

    /// Changes one decision at a time.
    fn polished(&mut self, mut decisions: Decisions, mut best: Parsed, trials: usize) -> Parsed {
        let mut left = 4 * trials;
        loop {
            let before = best.rules.length();
            let mut ids: Vec<StructureId> = decisions.keys().copied().collect();
            ids.sort_unstable_by(|a, b| b.cmp(a));
            for id in ids {
                for choice in self.options.get(&id).cloned().unwrap_or_default() {
                    if left == 0 {
                        return best;
                    }
                    if decisions[&id] == choice.decision {
                        continue;
                    }
                    left -= 1;
                    let old = decisions.insert(id, choice.decision);
                    let parsed = self.parsed(&decisions);
                    match parsed.rules.length() < best.rules.length() - 1e-9 {
                        true => best = parsed,
                        false => decisions.extend(old.map(|old| (id, old))),
                    }
                }
            }
            if best.rules.length() > before - 1e-9 {
                return best;
            }
        }
    }
}

/// The bits of a rule with these parts, as far as they can be told before all rules are known.
fn described(parts: &[(u32, StructureId)]) -> f64 {
    const PART: f64 = 12.0;
    const HEAD: f64 = 8.0;
    const REPEAT: f64 = 4.0;
    let runs = folded(parts, Folding::Shortest);
    let is_symmetric = runs.len() > 2 && runs.iter().eq(runs.iter().rev());
    let said = if is_symmetric { runs.len().div_ceil(2) } else { runs.len() };
    let run = |run: &super::fold::Run<(u32, StructureId)>| {
        PART * run.unit.len() as f64 + if run.times > 1 { REPEAT } else { 0.0 }
    };
    HEAD + runs[..said].iter().map(run).sum::<f64>() + (runs.len() - said) as f64
}

/// A set of lines, the likelier the less they cut.
fn drawn_set(costs: &[f64], rng: &mut impl Rng) -> Vec<u16> {
    let size = rng.random_range(1..=LARGEST_SET.min(costs.len()));
    let largest = costs.iter().copied().fold(1.0, f64::max);
    let mut weights: Vec<f64> = costs.iter().map(|cost| (-4.0 * cost / largest).exp()).collect();
    let mut set: Vec<u16> = (0..size)
        .map(|_| {
            let line = drawn(&weights, rng);
            weights[line] = 0.0;
            line as u16
        })
        .collect();
    set.sort_unstable();
    set.dedup();
    set
}

/// A place by weight; the first where all weigh nothing.
fn drawn(weights: &[f64], rng: &mut impl Rng) -> usize {
    let mut left = rng.random::<f64>() * weights.iter().sum::<f64>();
    let found = weights.iter().position(|weight| {
        left -= weight;
        left < 0.0 && *weight > 0.0
    });
    found.or_else(|| weights.iter().position(|weight| *weight > 0.0)).unwrap_or(0)
}
