//! In which order the axes are cut, and whether rows have groups: as it is the shortest to explain.

use super::explain::explain;
use super::forest::Forest;
use super::form::Key;
use super::groups::grouped;
use super::padding::padded_inwards;
use super::role::RoleId;
use super::{PRICE, merged};
use crate::infer::boxes::{PLAN_FIRST, Succession, Turns, UPRIGHT_FIRST, split_boxes_by};
use crate::infer::tree::Tree;
use crate::space::Axis::{X, Y, Z};
use crate::space::Bounds;

/// The labelled boxes of an example, in its box.
pub type Boxed = (Bounds, Vec<(Bounds, u32)>);

/// An order of cuts.
type Cuts = (Turns, Succession);

/// The orders that are tried: any axis first, and those of other methods.
const ALL: [Cuts; 8] = [
    (PLAN_FIRST, Succession::InTurn),
    (UPRIGHT_FIRST, Succession::InTurn),
    ([X, Z, Y], Succession::Afresh),
    ([Z, X, Y], Succession::Afresh),
    ([Y, X, Z], Succession::Afresh),
    ([Y, Z, X], Succession::Afresh),
    ([X, Y, Z], Succession::Afresh),
    ([Z, Y, X], Succession::Afresh),
];

/// The order is chosen by the first examples of so many boxes in all.
const MOST_WEIGHED: usize = 3000;

/// The trees of all examples in the order that is the shortest; `None` where boxes cannot be cut.
pub fn shortest(all: &[Boxed]) -> Option<Forest> {
    let mut left = MOST_WEIGHED;
    let few = all.iter().take_while(|(_, boxes)| {
        let is_weighed = left > 0;
        left = left.saturating_sub(boxes.len());
        is_weighed
    });
    let few: Vec<&Boxed> = few.collect();
    let cuts = ALL.iter().filter_map(|cuts| {
        let forest = planted(few.iter().copied(), *cuts)?;
        let (roles, root) = explain(&forest, PRICE);
        Some((roles.bits(root), *cuts, forest))
    });
    let (_, cuts, forest) = cuts.min_by(|one, other| one.0.total_cmp(&other.0))?;
    let all = planted(all.iter(), cuts)?;
    let rows = merged_bits(&forest);
    let groups = grouped(&forest);
    Some(if merged_bits(&groups) < rows { grouped(&all) } else { all })
}

/// The bits of all rules once roles are merged.
fn merged_bits(forest: &Forest) -> f64 {
    let (roles, root) = merged(forest);
    let forms = |id: &RoleId| {
        let forms = roles.role(*id).forms.keys();
        forms.map(|key| if matches!(key, Key::List(_)) { 2.0 } else { 1.0 }).sum::<f64>()
    };
    let rules: f64 =
        roles.reached(root).iter().filter(|id| roles.role(**id).leaf().is_none()).map(forms).sum();
    // At one price, whatever the roles were merged at.
    roles.bits(root) - (roles.price - PRICE) * rules
}

fn planted<'b>(all: impl Iterator<Item = &'b Boxed>, (turns, succession): Cuts) -> Option<Forest> {
    let tree = |(bounds, boxes): &Boxed| {
        split_boxes_by(*bounds, boxes, turns, succession).ok().map(|tree| (tree, *bounds))
    };
    let trees: Vec<(Tree, Bounds)> = all.map(tree).collect::<Option<_>>()?;
    let forest = Forest::plant(trees.iter().map(|(tree, bounds)| (tree, *bounds)));
    Some(padded_inwards(&forest))
}
