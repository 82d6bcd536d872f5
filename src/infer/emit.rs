//! From kinds of operations to an op graph.

use super::combine::{Content, Item, Kind, KindId, Kinds};
use super::example::{Example, Terminal, Terminals};
use super::exchange::Exchange;
use super::fold::Piece;
use super::held::Held;
use super::law::Law;
use super::{Labels, Learnt, Method, Notes};
use crate::block::{self, BlockState, Version};
use crate::grammar::ast::BinaryOp;
use crate::grammar::{is_primitive, is_reserved};
use crate::graph::{
    Alternative, Arg, Builder, Constant, Expr, NodeIndex, Op, OpGraph, Size, StartSize, Thing,
};
use crate::neighbours::decided;
use crate::space::{Axis, Cell, Up};
use std::collections::BTreeMap;

/// The op graph of all kinds, with what the sites in them can hold. Its root chooses between the examples that no
/// rule could join.
pub fn emit(
    kinds: &Kinds,
    sites: &Held,
    exchanges: &[Exchange],
    terminals: &Terminals,
    examples: &[Example],
) -> Learnt {
    let mut emitter = Emitter {
        builder: Builder::default(),
        primitives: Primitives::default(),
        nodes: Vec::new(),
        sites: Vec::new(),
        known: BTreeMap::new(),
    };
    emitter.kinds(&sites.kinds, terminals);
    emitter.sites(sites);
    emitter.kinds(kinds, terminals);
    let root = emitter.root(&slab_nodes(kinds, exchanges, &emitter.nodes), exchanges, examples);
    let Emitter { builder, primitives, .. } = emitter;
    let (mut graph, _) = builder.finish(root);
    let labels = primitives.place_in(&mut graph);
    graph.sizes = sizes(examples);
    graph.data_version = data_version(examples);
    Learnt { graph, labels, by: Method::Boxes, is_proved: false, notes: Notes::default() }
}

struct Emitter {
    builder: Builder,
    primitives: Primitives,
    /// The node of each kind.
    nodes: Vec<NodeIndex>,
    /// The node of each site.
    sites: Vec<NodeIndex>,
    /// What was made of a slab of these members: each class past a plane comes back for every member before it.
    known: BTreeMap<(usize, Vec<usize>), NodeIndex>,
}

impl Emitter {
    fn kinds(&mut self, kinds: &Kinds, terminals: &Terminals) {
        self.nodes.clear();
        for kind in &kinds.list {
            let node = self.kind(kind, terminals);
            self.nodes.push(node);
        }
    }

    /// The choices of all sites, from the nodes of what they can hold. Their labels come after those of the terminals.
    fn sites(&mut self, held: &Held) {
        let mut roots = held.kinds.roots.iter().map(|kind| self.nodes[kind.0 as usize]);
        for site in &held.sites {
            let held: Vec<(f64, NodeIndex)> =
                site.contents.iter().map(|(_, count)| f64::from(*count)).zip(roots.by_ref()).collect();
            let node = self.builder.choose(held);
            self.sites.push(node);
        }
    }

    fn kind(&mut self, kind: &Kind, terminals: &Terminals) -> NodeIndex {
        match kind {
            Kind::Nil => self.builder.nil(),
            Kind::Leaf(label) => match terminals.list.get(*label as usize) {
                Some(Terminal::Block(state)) => self.builder.primitive(block_expr(state)),
                Some(Terminal::Label(label)) => self.primitives.labelled(&mut self.builder, label),
                None => self.sites[*label as usize - terminals.list.len()],
            },
            Kind::Split { axis, items } => {
                let parts = items.iter().map(|item| self.item(*axis, item)).collect();
                self.builder.split(Expr::Axis(*axis), parts)
            }
        }
    }

    fn item(&mut self, axis: Axis, item: &Item) -> (Size, NodeIndex) {
        let size = match item.law {
            Law::Const(length) => Size::absolute(Expr::number(f64::from(length))),
            Law::Float => Size::floating(1.0),
            Law::Range { low, high, step: 1 } => Size::absolute(Expr::between(low, high)),
            Law::Range { low, high, step } => Size::absolute(Expr::Binary(
                BinaryOp::Multiply,
                Box::new(Expr::number(f64::from(step))),
                Box::new(Expr::between(low / step, high / step)),
            )),
        };
        let child = match &item.content {
            Content::One(kind) => self.node(*kind),
            Content::Repeat(unit) => self.repeat(axis, unit),
        };
        (size, child)
    }

    fn node(&self, kind: KindId) -> NodeIndex {
        self.nodes[kind.0 as usize]
    }

    fn repeat(&mut self, axis: Axis, unit: &[Piece<KindId>]) -> NodeIndex {
        let period: i32 = unit.iter().map(|(len, _)| len).sum();
        let size = |len: i32| Size::absolute(Expr::number(f64::from(len)));
        let parts = unit.iter().map(|(len, kind)| (size(*len), self.node(*kind))).collect();
        let body = self.builder.split(Expr::Axis(axis), parts);
        let op = Op::Repeat { axis: Expr::Axis(axis), size: Expr::number(f64::from(period)), snap: None };
        self.builder.node(op, vec![(Arg::None, body)])
    }

    /// The choice between examples of different sizes. Each is bound to its own size: at others it would be
    /// stretched out of shape.
    fn root(&mut self, slabs: &[Vec<NodeIndex>], exchanges: &[Exchange], examples: &[Example]) -> NodeIndex {
        let size = |group: &Exchange| examples[group.members[0]].bounds().size();
        let varying: Vec<Axis> = Axis::ALL
            .into_iter()
            .filter(|axis| exchanges.iter().any(|group| axis.of(size(group)) != axis.of(size(&exchanges[0]))))
            .collect();
        let mut seen: Vec<(NodeIndex, Vec<Cell>, f64)> = Vec::new();
        for group in exchanges {
            let node = self.slabs_on(group, slabs, 0, &group.members);
            let weight = group.members.len() as f64;
            match seen.iter_mut().find(|(known, ..)| *known == node) {
                Some((_, sizes, sum)) => {
                    sizes.push(size(group));
                    *sum += weight;
                }
                None => seen.push((node, vec![size(group)], weight)),
            }
        }
        if let [(only, ..)] = seen.as_slice() {
            return *only;
        }
        let alternatives = seen.into_iter().map(|(node, sizes, weight)| {
            let condition = size_condition(&varying, &sizes);
            (Arg::Alternative(Alternative { condition, ..Alternative::plain(Expr::number(weight)) }), node)
        });
        let alternatives = alternatives.collect();
        self.builder.node(Op::Choose, alternatives)
    }

    /// Slab number `slab` of any of `members`, and past it what can stand there.
    fn slabs_on(
        &mut self,
        group: &Exchange,
        slabs: &[Vec<NodeIndex>],
        slab: usize,
        members: &[usize],
    ) -> NodeIndex {
        // Every member before a plane leads to the same members past it.
        let key = (slab, members.to_vec());
        if let Some(&known) = self.known.get(&key) {
            return known;
        }
        let mut alternatives = Vec::new();
        for member in members {
            let node = slabs[*member][slab];
            let node = match group.planes.get(slab) {
                None => node,
                Some(plane) => {
                    let low = slab.checked_sub(1).map_or(0, |before| group.planes[before].at);
                    let length = Size::absolute(Expr::number(f64::from(plane.at - low)));
                    let past = group.exchangeable(plane, *member);
                    let rest = self.slabs_on(group, slabs, slab + 1, &past);
                    let parts = vec![(length, node), (Size::floating(1.0), rest)];
                    self.builder.split(Expr::Axis(group.axis), parts)
                }
            };
            alternatives.push((1.0, node));
        }
        let node = self.builder.choose(alternatives);
        self.known.insert(key, node);
        node
    }
}

/// The primitives of labels, and the constants for those that the language does not know.
#[derive(Default)]
pub struct Primitives {
    constants: Vec<Constant>,
    /// The labels that the constants stand for.
    labels: Vec<String>,
}

impl Primitives {
    /// Gives a graph the constants; returns the labels that they stand for.
    pub fn place_in(self, graph: &mut OpGraph) -> Labels {
        let names = self.constants.iter().map(|known| known.name.clone());
        let labels = names.zip(self.labels).collect();
        graph.constants = self.constants;
        labels
    }

    /// A labelled primitive. `corner@90` is a corner turned by 90 degrees; a label that is no primitive of
    /// the language becomes a constant, which says what it is made of.
    pub fn labelled(&mut self, builder: &mut Builder, label: &str) -> NodeIndex {
        let (name, turn) = turned_label(label);
        let expr = match is_primitive(name) || block::known(name).is_some() {
            true => Expr::name(name),
            false => self.constant(name),
        };
        let primitive = builder.primitive(expr);
        match turn {
            0 => primitive,
            turn => {
                let angle = Expr::number(90.0 * f64::from(turn));
                let op = Op::Rotate { axis: Expr::Axis(Up::Y.axis()), angle };
                builder.node(op, vec![(Arg::None, primitive)])
            }
        }
    }

    /// The constant for a label, with a material that stands in for what the label means.
    fn constant(&mut self, label: &str) -> Expr {
        let at = self.labels.iter().position(|known| known == label).unwrap_or_else(|| {
            let color = COLOURS[self.constants.len() % COLOURS.len()];
            let name = self.free_name(label);
            let value = Expr::name(format!("{color}_concrete"));
            self.constants.push(Constant { name, value, attribute: None });
            self.labels.push(label.to_owned());
            self.labels.len() - 1
        });
        Expr::Constant(at)
    }

    /// The label as a name that means nothing else yet.
    fn free_name(&self, label: &str) -> String {
        let name = identifier(label);
        let is_free = |name: &String| {
            !is_reserved(name)
                && block::known(name).is_none()
                && self.constants.iter().all(|known| known.name != *name)
        };
        let numbered = (2..).map(|number| format!("{name}_{number}"));
        std::iter::once(name.clone()).chain(numbered).find(is_free).unwrap_or_default()
    }
}

/// The nodes of the slabs of each example, from the low end up.
fn slab_nodes(kinds: &Kinds, exchanges: &[Exchange], nodes: &[NodeIndex]) -> Vec<Vec<NodeIndex>> {
    let mut roots = kinds.roots.iter().map(|kind| nodes[kind.0 as usize]);
    let count: usize = exchanges.iter().map(|group| group.members.len()).sum();
    let planes = |example: usize| {
        let group = exchanges.iter().find(|group| group.members.contains(&example));
        group.map_or(0, |group| group.planes.len())
    };
    (0..count).map(|example| roots.by_ref().take(planes(example) + 1).collect()).collect()
}

/// That the scope has one of `sizes` along the axes that tell examples apart.
fn size_condition(varying: &[Axis], sizes: &[Cell]) -> Option<Expr> {
    let mut known: Vec<Vec<i32>> = Vec::new();
    for size in sizes {
        let lengths = varying.iter().map(|axis| axis.of(*size)).collect();
        if !known.contains(&lengths) {
            known.push(lengths);
        }
    }
    let binary = |op| move |left, right| Expr::Binary(op, Box::new(left), Box::new(right));
    let is_length = |(axis, length): (&Axis, i32)| {
        binary(BinaryOp::Equal)(Expr::ScopeSize(*axis), Expr::number(f64::from(length)))
    };
    let is_size =
        |lengths: Vec<i32>| varying.iter().zip(lengths).map(is_length).reduce(binary(BinaryOp::And));
    known.into_iter().filter_map(is_size).reduce(binary(BinaryOp::Or))
}

/// The oldest data version among the examples, or the first one after it that has all of their blocks: the game
/// brings older blocks up to date, never newer ones down.
pub fn data_version(examples: &[Example]) -> Option<i32> {
    let grids = || {
        examples.iter().filter_map(|example| match example {
            Example::Blocks(grid) => Some(grid),
            Example::Boxes(_) => None,
        })
    };
    let oldest = grids().filter_map(|grid| grid.metadata.data_version).min()?;
    let Some(least) = Version::of_data(oldest) else { return Some(oldest) };
    let needed = grids().fold(least, |least, grid| grid.least_version(least));
    Some(if needed == least { oldest } else { needed.data_version() })
}

/// The sizes of the examples, each with how often it was seen, in order of first sight.
pub fn sizes(examples: &[Example]) -> Vec<StartSize> {
    let mut seen: Vec<(Cell, u32)> = Vec::new();
    for example in examples {
        let size = example.bounds().size();
        match seen.iter_mut().find(|(known, _)| *known == size) {
            Some((_, count)) => *count += 1,
            None => seen.push((size, 1)),
        }
    }
    let is_alone = seen.len() == 1;
    let weight = |count: u32| Expr::number(if is_alone { 1.0 } else { f64::from(count) });
    let start = |(size, count): (Cell, u32)| StartSize {
        size: size.to_array().map(|length| Expr::number(f64::from(length))),
        weight: weight(count),
    };
    seen.into_iter().map(start).collect()
}

/// The expression for a block. Of blocks of the game only the properties that differ from the defaults are
/// written: a run fills in the others.
pub fn block_expr(state: &BlockState) -> Expr {
    let Some(known) = block::known(state.name()) else {
        return Expr::Thing(Thing::Block(state.to_string()));
    };
    let default = known.default_state();
    let differs = |key: &str| default.get(key) != state.get(key);
    // What neighbours decide has to be said where it is not left to them.
    let decided = decided(state);
    let is_said = decided.iter().any(|key| state.get(key).is_some() && differs(key));
    let said = decided.first().filter(|_| !is_said);
    let shown = state.properties().filter(|(key, _)| differs(key) || said == Some(key));
    let text: Vec<String> = shown.map(|(key, value)| format!("{key}={value}")).collect();
    match text.is_empty() {
        true => Expr::name(state.short_name()),
        false => Expr::Thing(Thing::Block(format!("{}[{}]", state.short_name(), text.join(",")))),
    }
}

/// The colours of concrete that stand in for unknown materials.
const COLOURS: [&str; 8] = ["white", "light_gray", "cyan", "yellow", "lime", "orange", "light_blue", "brown"];

/// A label and its number of quarter turns.
pub fn turned_label(label: &str) -> (&str, u8) {
    match label.rsplit_once('@') {
        Some((name, "90")) => (name, 1),
        Some((name, "180")) => (name, 2),
        Some((name, "270")) => (name, 3),
        _ => (label, 0),
    }
}

/// A label as a name of the language.
pub fn identifier(label: &str) -> String {
    let mut name: String = label.chars().map(|c| if c.is_alphanumeric() { c } else { '_' }).collect();
    if !name.starts_with(|c: char| c.is_alphabetic() || c == '_') {
        name.insert(0, '_');
    }
    name
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::block::{all, complete};
    use crate::neighbours::{bare, opened};

    /// Every value of every block of the game, the other properties at their defaults.
    fn states() -> impl Iterator<Item = BlockState> {
        all().iter().flat_map(|known| {
            let values = known.properties().iter().flat_map(|p| p.values.iter().map(|v| (p.key, *v)));
            let changed = values.map(|(key, value)| known.default_state().with(key, value));
            std::iter::once(known.default_state()).chain(changed)
        })
    }

    #[test]
    fn what_is_written_of_a_block_is_read_as_that_block() {
        for state in states().flat_map(|state| [bare(&state), state]) {
            assert_eq!(opened(&state), state);
            let Expr::Thing(thing) = block_expr(&state) else { panic!("{state} is no thing") };
            assert_eq!(thing.block(), Some(state), "{thing:?}");
        }
    }

    #[test]
    fn what_neighbours_decide_is_said_where_it_is_not_left_to_them() {
        let cases = [
            ("oak_fence", "oak_fence"),
            ("oak_fence[east=true]", "oak_fence[east=true]"),
            ("oak_fence[east=false]", "oak_fence[east=false]"),
            ("oak_stairs[facing=east,shape=straight]", "oak_stairs[facing=east,shape=straight]"),
            ("oak_door[half=lower,hinge=right]", "oak_door[half=lower,hinge=right]"),
        ];
        for (text, expected) in cases {
            let state: BlockState = text.parse().unwrap();
            let Expr::Thing(thing) = block_expr(&opened(&state)) else { panic!("{text}") };
            assert_eq!(thing.text(), expected);
            assert_eq!(complete(&thing.block().unwrap()), complete(&state));
        }
    }
}
