//! What the sites of examples can hold, as kinds of operations.

use super::BadBoxes;
use super::combine::{Chance, Kinds, Slab, combine};
use super::example::{Example, Terminals};
use super::swaps::Site;
use super::tree::Tree;
use crate::space::Bounds;
use std::collections::BTreeSet;

/// The sites of all examples; those that hold the same are one.
#[derive(Debug)]
pub struct Held {
    /// The first of each.
    pub sites: Vec<Site>,
    /// What they can hold, one root for each content of each site in order.
    pub kinds: Kinds,
    /// By example, the boxes of its sites with their labels: those after the terminals.
    boxes: Vec<Vec<(Bounds, u32)>>,
    /// The label of the first site.
    first: u32,
}

impl Held {
    /// `plain` are, by example, further boxes of one block each with its terminal; it may end early.
    pub fn new(
        all: Vec<Vec<Site>>,
        plain: Vec<Vec<(Bounds, u32)>>,
        chance: Chance,
        terminals: &mut Terminals,
    ) -> Held {
        let first = terminals.list.len() as u32;
        let (mut sites, mut boxes): (Vec<Site>, _) = (Vec::new(), Vec::new());
        for own in all {
            let labelled = own.into_iter().map(|site| {
                let known = sites.iter().position(|known| known.contents == site.contents);
                let bounds = site.bounds;
                let number = known.unwrap_or_else(|| {
                    sites.push(site);
                    sites.len() - 1
                });
                (bounds, first + number as u32)
            });
            boxes.push(labelled.collect::<Vec<_>>());
        }
        boxes.iter_mut().zip(plain).for_each(|(boxes, plain)| boxes.extend(plain));
        let slabs: Vec<Slab> = sites.iter().flat_map(|site| contents(site, terminals)).collect();
        let kinds = combine(&slabs, chance, BTreeSet::new());
        Held { sites, kinds, boxes, first }
    }

    /// The labels of the sites.
    pub fn labels(&self) -> BTreeSet<u32> {
        (self.first..self.first + self.sites.len() as u32).collect()
    }

    /// The split trees of the slabs of an example. A site that a plane of them would cut is left out.
    pub fn trees(
        &self,
        number: usize,
        example: &Example,
        slabs: &[Bounds],
        terminals: &mut Terminals,
    ) -> Result<Vec<Tree>, BadBoxes> {
        let mut own = self.boxes.get(number).cloned().unwrap_or_default();
        loop {
            let boxes = example.boxes(terminals, &own);
            let trees: Vec<Tree> =
                slabs.iter().map(|slab| example.tree(*slab, &boxes)).collect::<Result<_, _>>()?;
            let leaves: Vec<(Bounds, u32)> =
                trees.iter().zip(slabs).flat_map(|(tree, slab)| tree.leaves(*slab)).collect();
            let count = own.len();
            own.retain(|site| leaves.contains(site));
            if own.len() == count {
                return Ok(trees);
            }
        }
    }
}

/// What a site can hold, as trees.
fn contents(site: &Site, terminals: &mut Terminals) -> Vec<Slab> {
    let bounds = Bounds::of_size(site.bounds.size());
    let trees = site.contents.iter().filter_map(|(content, _)| {
        let example = Example::Blocks(terminals.grid(content));
        let boxes = example.boxes(terminals, &[]);
        // Cuboids lie in their grid and do not overlap.
        example.tree(bounds, &boxes).ok()
    });
    trees.map(|tree| Slab { bounds: site.bounds, tree }).collect()
}
