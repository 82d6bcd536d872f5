//! A set of shapes, the steps that it may take, and what each would cost.

use super::least::Least;
use super::piece::Piece;
use crate::shapes::alike::{self, Groups, Look};
use crate::shapes::building::{Block, Building};
use crate::shapes::layer::Layer;
use crate::shapes::price::{Price, Sum};
use crate::shapes::settings::Cost;
use crate::shapes::tally::Tally;
use crate::space::Axis;
use std::collections::{BTreeMap, BTreeSet};

/// The number of a piece. Later pieces have higher numbers, so that their order is that of the authors' list.
pub type Id = u32;

/// What a search is after.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Goal {
    /// Shapes as large as may be: any merge is taken.
    Largest,
    Cheapest(Price),
}

/// What a search may take.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Reach {
    /// Any step that is legal.
    Legal,
    /// Steps by which the cost does not rise.
    NotDearer,
}

/// A change of a set.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Step {
    Merge(Id, Id),
    /// A piece, the axis of the cut and the first layer of the second part.
    Split(Id, (Axis, i32)),
}

/// Whether a set is asked for splits, which take time to keep in mind.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Splits {
    Never,
    Wanted,
}

/// A set of shapes that is searched. What steps change is kept up to date, so that a step is found in logarithmic time.
#[derive(Debug)]
pub struct Set<'a> {
    building: &'a Building,
    goal: Goal,
    splits: Splits,
    /// Pieces by number; those that were taken apart or joined are gone.
    pieces: Vec<Option<Piece>>,
    /// The numbers of those that are there, in no order, and where each is in that list.
    alive: Vec<Id>,
    places: Vec<usize>,
    measures: Vec<f64>,
    /// What touches each piece in its layer, and how the measure would change if the two were one: infinitely where they
    /// may not.
    beside: Vec<BTreeMap<Id, f64>>,
    /// The least such change of each piece with a later one.
    merges: Least,
    /// The least change of the measure by a split of each piece.
    cuts: Least,
    /// By layer, which piece each block is in.
    owners: [Vec<Id>; Layer::COUNT],
    sum: Sum,
    groups: Groups,
    group_of: Vec<usize>,
}

const NOBODY: Id = Id::MAX;

impl<'a> Set<'a> {
    /// Every block in every layer by itself, in the given order.
    pub fn of_blocks(
        building: &'a Building,
        layers: &[Layer],
        order: &[Block],
        goal: Goal,
        splits: Splits,
    ) -> Set<'a> {
        let pieces = order.iter().flat_map(|block| layers.iter().map(|layer| (*layer, vec![*block])));
        Set::of(building, pieces, goal, splits)
    }

    /// Any set in which no block is in two pieces of one layer.
    pub fn of(
        building: &'a Building,
        shapes: impl Iterator<Item = (Layer, Vec<Block>)>,
        goal: Goal,
        splits: Splits,
    ) -> Set<'a> {
        let mut set = Set {
            building,
            goal,
            splits,
            pieces: Vec::new(),
            alive: Vec::new(),
            places: Vec::new(),
            measures: Vec::new(),
            beside: Vec::new(),
            merges: Least::default(),
            cuts: Least::default(),
            owners: std::array::from_fn(|_| Vec::new()),
            sum: Sum::default(),
            groups: Groups::default(),
            group_of: Vec::new(),
        };
        for (layer, blocks) in shapes {
            set.push(Piece::new(building, layer, blocks));
        }
        (0..set.pieces.len() as Id).for_each(|id| set.meet(id));
        set
    }

    pub fn into_pieces(self) -> Vec<Piece> {
        self.pieces.into_iter().flatten().collect()
    }

    /// The pieces that there are, the oldest first.
    pub fn ids(&self) -> impl Iterator<Item = Id> {
        (0..).zip(&self.pieces).filter(|(_, piece)| piece.is_some()).map(|(id, _)| id)
    }

    pub fn piece(&self, id: Id) -> &Piece {
        self.pieces[id as usize].as_ref().expect("steps name pieces that are there")
    }

    /// The pieces that there are, in the order of nothing: to draw from.
    pub fn alive(&self) -> &[Id] {
        &self.alive
    }

    /// Where a piece may be cut.
    pub fn legal_cuts(&self, id: Id) -> Vec<(Axis, i32)> {
        self.cuts_of(self.piece(id)).map(|(cut, _)| cut).collect()
    }

    /// What a piece may be joined with.
    pub fn partners(&self, id: Id) -> impl Iterator<Item = Id> {
        self.beside[id as usize].iter().filter(|(_, change)| change.is_finite()).map(|(other, _)| *other)
    }

    /// The first merge within reach, in the order of the authors' program, and how much the cost rises by it.
    pub fn first_merge(&mut self, reach: Reach) -> Option<(Step, f64)> {
        let room = match (self.goal, reach) {
            (Goal::Cheapest(price), Reach::NotDearer) if price.cost == Cost::Alike => {
                return self.first_alike_merge(price);
            }
            (Goal::Cheapest(price), Reach::NotDearer) => {
                price.room(self.sum, self.sum.count.saturating_sub(1))
            }
            _ => f64::MAX,
        };
        let one = self.merges.first_at_most(room)? as Id;
        let (&other, &change) =
            self.beside[one as usize].range(one + 1..).find(|(_, change)| **change <= room)?;
        Some((Step::Merge(one, other), self.rise(self.sum.count - 1, change)))
    }

    /// The first split within reach, and how much the cost rises by it.
    pub fn first_split(&mut self) -> Option<(Step, f64)> {
        let room = match self.goal {
            Goal::Cheapest(price) if price.cost == Cost::Alike => return self.first_alike_split(price),
            Goal::Cheapest(price) => price.room(self.sum, self.sum.count + 1),
            Goal::Largest => return None,
        };
        let id = self.cuts.first_at_most(room)? as Id;
        let piece = self.piece(id);
        let (cut, change) = self.cuts_of(piece).find(|(_, change)| *change <= room)?;
        Some((Step::Split(id, cut), self.rise(self.sum.count + 1, change)))
    }

    /// How much the cost rises by a step that is legal.
    pub fn rise_by(&mut self, step: Step) -> f64 {
        match (self.goal, step) {
            (Goal::Cheapest(price), _) if price.cost == Cost::Alike => self.alike_rise(price, step),
            (_, Step::Merge(one, other)) => self.rise(self.sum.count - 1, self.beside[one as usize][&other]),
            (_, Step::Split(id, cut)) => {
                let piece = self.piece(id);
                let change = self.change_by_cut(piece, &piece.parts(self.building, cut));
                self.rise(self.sum.count + 1, change)
            }
        }
    }

    fn rise(&self, count: usize, change: f64) -> f64 {
        match self.goal {
            Goal::Largest => count as f64 - self.sum.count as f64,
            Goal::Cheapest(price) => price.rise(self.sum, count, change),
        }
    }

    pub fn take(&mut self, step: Step) {
        match step {
            Step::Merge(one, other) => self.merge(one, other),
            Step::Split(id, cut) => self.split(id, cut),
        }
    }

    fn merge(&mut self, one: Id, other: Id) {
        let beside = [one, other].map(|id| &self.beside[id as usize]);
        let mut others: BTreeSet<Id> = beside.into_iter().flat_map(|beside| beside.keys().copied()).collect();
        others.remove(&one);
        others.remove(&other);
        let pieces = [one, other].map(|id| self.remove(id));
        let id = self.push(pieces[0].joined(&pieces[1]));
        self.link(id, others);
    }

    fn split(&mut self, id: Id, cut: (Axis, i32)) {
        let piece = self.remove(id);
        let parts = piece
            .parts(self.building, cut)
            .map(|part| self.push(Piece::new(self.building, piece.layer, part)));
        parts.into_iter().for_each(|part| self.meet(part));
    }

    fn push(&mut self, piece: Piece) -> Id {
        let id = self.pieces.len() as Id;
        let measure = self.measure(&piece);
        self.sum = Sum { count: self.sum.count + 1, measure: self.sum.measure + measure };
        let owners = &mut self.owners[piece.layer.index()];
        owners.resize(self.building.len(), NOBODY);
        piece.blocks.iter().for_each(|block| owners[*block as usize] = id);
        self.places.push(self.alive.len());
        self.alive.push(id);
        self.measures.push(measure);
        self.beside.push(BTreeMap::new());
        self.enter_group(&piece, measure);
        if self.splits == Splits::Wanted {
            let least = self.least_cut(&piece);
            self.cuts.set(id as usize, least);
        }
        self.pieces.push(Some(piece));
        id
    }

    fn remove(&mut self, id: Id) -> Piece {
        let piece = self.pieces[id as usize].take().expect("steps name pieces that are there");
        let place = self.places[id as usize];
        self.alive.swap_remove(place);
        if let Some(moved) = self.alive.get(place) {
            self.places[*moved as usize] = place;
        }
        let measure = self.measures[id as usize];
        self.sum = Sum { count: self.sum.count - 1, measure: self.sum.measure - measure };
        self.merges.set(id as usize, f64::INFINITY);
        if self.splits == Splits::Wanted {
            self.cuts.set(id as usize, f64::INFINITY);
        }
        if let Some(group) = self.group_of.get(id as usize) {
            self.groups.leave(*group);
        }
        for other in std::mem::take(&mut self.beside[id as usize]).into_keys() {
            self.beside[other as usize].remove(&id);
            if other < id {
                self.refresh(other);
            }
        }
        piece
    }

    /// Finds what a piece touches.
    fn meet(&mut self, id: Id) {
        let piece = self.piece(id);
        let owners = &self.owners[piece.layer.index()];
        let around = piece.blocks.iter().flat_map(|block| self.building.beside(*block, piece.layer.axes()));
        let others: BTreeSet<Id> = around
            .map(|block| owners[block as usize])
            .filter(|other| *other != id && *other != NOBODY)
            .collect();
        self.link(id, others);
    }

    fn link(&mut self, id: Id, others: BTreeSet<Id>) {
        for &other in &others {
            let change = self.change_by_merge(id, other);
            self.beside[id as usize].insert(other, change);
            self.beside[other as usize].insert(id, change);
            self.refresh(id.min(other));
        }
    }

    fn refresh(&mut self, id: Id) {
        let later = self.beside[id as usize].range(id + 1..);
        self.merges.set(id as usize, later.map(|(_, change)| *change).fold(f64::INFINITY, f64::min));
    }

    fn measure(&self, piece: &Piece) -> f64 {
        match self.goal {
            Goal::Largest => 0.0,
            Goal::Cheapest(price) => price.measure(&piece.tally),
        }
    }

    fn change_by_merge(&self, one: Id, other: Id) -> f64 {
        let [first, second] = [one, other].map(|id| self.piece(id));
        if !first.may_join(second) {
            return f64::INFINITY;
        }
        match self.goal {
            Goal::Largest => 0.0,
            Goal::Cheapest(price) => {
                let measures = self.measures[one as usize] + self.measures[other as usize];
                price.measure(&first.tally.plus(&second.tally)) - measures
            }
        }
    }

    /// The cuts of a piece, and how the measure changes by each.
    fn cuts_of<'b>(&'b self, piece: &'b Piece) -> impl Iterator<Item = ((Axis, i32), f64)> + 'b {
        let legal = piece.cuts().filter(|_| self.may_be_cut(piece));
        legal.filter_map(|cut| {
            let parts = piece.parts(self.building, cut);
            self.are_shapes(piece.layer, &parts).then(|| (cut, self.change_by_cut(piece, &parts)))
        })
    }

    /// The least change by a cut. A shape of one type has nothing to gain by any, unless shapes that are alike count once.
    fn least_cut(&self, piece: &Piece) -> f64 {
        if piece.tally.kinds() == 1 && !self.is_by_group() {
            return f64::INFINITY;
        }
        self.cuts_of(piece).map(|(_, change)| change).fold(f64::INFINITY, f64::min)
    }

    /// The authors' program splits rectangles of an even number of blocks only; seed 3 does not say so.
    fn may_be_cut(&self, piece: &Piece) -> bool {
        let is_paper = matches!(self.goal, Goal::Cheapest(price) if price.cost == Cost::Paper);
        is_paper || !piece.layer.is_rectangular() || piece.blocks.len().is_multiple_of(2)
    }

    fn are_shapes(&self, layer: Layer, parts: &[Vec<Block>; 2]) -> bool {
        parts.iter().all(|part| !part.is_empty())
            && (layer.is_rectangular() || parts.iter().all(|part| is_connected(self.building, part)))
    }

    fn change_by_cut(&self, piece: &Piece, [below, _]: &[Vec<Block>; 2]) -> f64 {
        let Goal::Cheapest(price) = self.goal else { return 0.0 };
        let part = Tally::of(below.iter().map(|block| self.building.kind(*block)));
        let parts = price.measure(&part) + price.measure(&piece.tally.minus(&part));
        parts - price.measure(&piece.tally)
    }

    fn is_by_group(&self) -> bool {
        matches!(self.goal, Goal::Cheapest(price) if price.cost == Cost::Alike)
    }

    fn look(&self, piece: &Piece) -> Look {
        alike::look(self.building, piece.layer, piece.bounds.min, piece.blocks.iter().copied())
    }

    fn enter_group(&mut self, piece: &Piece, measure: f64) {
        if self.is_by_group() {
            let group = self.groups.number(self.look(piece), measure);
            self.groups.enter(group);
            self.group_of.push(group);
        }
    }

    /// What a step costs depends on how many shapes are alike, so that every step is looked at in turn.
    fn first_alike_merge(&mut self, price: Price) -> Option<(Step, f64)> {
        let ids: Vec<Id> = self.ids().collect();
        ids.into_iter().find_map(|one| {
            let later: Vec<Id> = self.partners(one).filter(|other| *other > one).collect();
            later.into_iter().find_map(|other| self.if_not_dearer(price, Step::Merge(one, other)))
        })
    }

    fn first_alike_split(&mut self, price: Price) -> Option<(Step, f64)> {
        let ids: Vec<Id> = self.ids().collect();
        ids.into_iter().find_map(|id| {
            let cuts: Vec<_> = self.cuts_of(self.piece(id)).map(|(cut, _)| cut).collect();
            cuts.into_iter().find_map(|cut| self.if_not_dearer(price, Step::Split(id, cut)))
        })
    }

    fn if_not_dearer(&mut self, price: Price, step: Step) -> Option<(Step, f64)> {
        let rise = self.alike_rise(price, step);
        (rise <= 0.0).then_some((step, rise))
    }

    fn alike_rise(&mut self, price: Price, step: Step) -> f64 {
        let (leaving, made): (Vec<Id>, Vec<Piece>) = match step {
            Step::Merge(one, other) => (vec![one, other], vec![self.piece(one).joined(self.piece(other))]),
            Step::Split(id, cut) => {
                let piece = self.piece(id);
                let parts =
                    piece.parts(self.building, cut).map(|part| Piece::new(self.building, piece.layer, part));
                (vec![id], parts.into())
            }
        };
        let entering: Vec<usize> = made
            .iter()
            .map(|piece| {
                let look = self.look(piece);
                self.groups.number(look, price.measure(&piece.tally))
            })
            .collect();
        let leaving: Vec<usize> = leaving.into_iter().map(|id| self.group_of[id as usize]).collect();
        self.groups.rise(&leaving, &entering, price.per_shape())
    }
}

/// Whether every block can be reached from every other through blocks that touch.
fn is_connected(building: &Building, blocks: &[Block]) -> bool {
    let mut left: BTreeSet<Block> = blocks.iter().copied().collect();
    let mut open: Vec<Block> = left.pop_first().into_iter().collect();
    while let Some(block) = open.pop() {
        open.extend(building.beside(block, &Axis::ALL).filter(|other| left.remove(other)));
    }
    left.is_empty()
}
