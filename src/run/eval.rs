use super::body::Body;
use super::error::Kind;
use super::known::Known;
use super::place::Place;
use super::start::weighted;
use crate::grammar::ast::{BinaryOp, Function, Share, UnaryOp};
use crate::graph::{Expr, Number, OpGraph, Thing};
use crate::space::{Axis, Footprint, Scope};
use elsa::index_set::FrozenIndexSet;
use rand::RngExt;
use rand_pcg::Pcg64Mcg;
use std::rc::Rc;

/// What an expression evaluates to. Conditions are numbers: zero is false, all else true.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Value<'g> {
    Number(f64),
    Axis(Axis),
    Thing(&'g Thing),
}

impl Value<'_> {
    pub fn describe(self) -> String {
        match self {
            Value::Number(number) => format!("the number {number}"),
            Value::Axis(axis) => format!("the axis {axis}"),
            Value::Thing(thing) => format!("`{}`", thing.text()),
        }
    }
}

/// Blocks that a run makes out of others, mixes and changed states, each kept once.
#[derive(Default)]
pub struct Things(FrozenIndexSet<Box<Thing>>);

impl Things {
    fn keep(&self, thing: Thing) -> &Thing {
        self.0.insert(Box::new(thing))
    }
}

/// What is the same all over a run.
pub struct World<'g> {
    things: &'g Things,
    seed: u64,
    /// The values of the constants: those of the file, then those of each style.
    constants: Vec<Vec<Value<'g>>>,
}

impl<'g> World<'g> {
    /// Draws the constants, each from a stream of its own name.
    pub fn new(graph: &'g OpGraph, things: &'g Things, seed: u64) -> Result<World<'g>, Kind> {
        let mut world = World { things, seed, constants: Vec::new() };
        for style in 0..=graph.styles.len() {
            world.constants.push(Vec::with_capacity(graph.constants.len()));
            for at in 0..graph.constants.len() {
                let value = world.constant(graph, style, at)?;
                world.constants[style].push(value);
            }
        }
        Ok(world)
    }

    /// Keeps a block for as long as the run lasts.
    pub fn keep(&self, thing: Thing) -> &'g Thing {
        self.things.keep(thing)
    }

    fn constant(&self, graph: &'g OpGraph, style: usize, at: usize) -> Result<Value<'g>, Kind> {
        let constant = &graph.constants[at];
        let styled = style.checked_sub(1).and_then(|style| {
            graph.styles[style].values.iter().find(|(styled, _)| *styled == at).map(|(_, value)| value)
        });
        let place = Place::start(self.seed).named(&constant.name);
        let around = Around { style, ..Around::start(self.seed) };
        let mut env = Env::new(self, &around, None, place);
        let value = env.value(styled.unwrap_or(&constant.value))?;
        if let Some([low, high]) = constant.attribute.as_ref().and_then(|attribute| attribute.range.as_ref())
        {
            in_range(&constant.name, value, [env.number(low)?, env.number(high)?])?;
        }
        Ok(value)
    }
}

fn in_range(name: &str, value: Value<'_>, range: [f64; 2]) -> Result<(), Kind> {
    match value {
        Value::Number(value) if range[0] <= value && value <= range[1] => Ok(()),
        Value::Number(value) => Err(Kind::OutOfRange { name: name.to_owned(), value, range }),
        other => {
            Err(Kind::Type { expected: "a number, as the attribute has a range", found: other.describe() })
        }
    }
}

/// What an operation inherits from those around it.
#[derive(Clone)]
pub struct Around<'g> {
    pub params: Rc<[Value<'g>]>,
    /// The constants' table: 0, or the number of the style and one.
    pub style: usize,
    /// The place from which coherent draws start.
    pub local: Place,
    /// The cells of the world's plan that are there; `None` is all of them.
    pub footprint: Option<Rc<Footprint>>,
}

impl Around<'_> {
    pub fn start(seed: u64) -> Self {
        Around { params: Rc::from([]), style: 0, local: Place::start(seed), footprint: None }
    }
}

/// A scope and where it stands among those of the split or repeat around it.
#[derive(Clone, Copy, Debug)]
pub struct Site {
    pub scope: Scope,
    pub index: u32,
    pub total: u32,
}

/// What the expressions of one operation can see, and the random stream of its place.
pub struct Env<'a, 'g> {
    world: &'a World<'g>,
    around: &'a Around<'g>,
    site: Option<&'a Site>,
    known: Option<&'a Known<'g>>,
    stream: Stream,
}

/// A stream that is set up at the first draw: most operations draw nothing.
enum Stream {
    At(Place),
    Open(Pcg64Mcg),
}

/// Errors are boxed: values are handed on far more often, and should travel in registers.
pub type Eval<T> = Result<T, Box<Kind>>;

impl<'a, 'g> Env<'a, 'g> {
    pub fn new(world: &'a World<'g>, around: &'a Around<'g>, site: Option<&'a Site>, place: Place) -> Self {
        Env { world, around, site, known: None, stream: Stream::At(place) }
    }

    /// With answers about other shapes.
    pub fn knowing(self, known: Option<&'a Known<'g>>) -> Self {
        Env { known, ..self }
    }

    pub fn number(&mut self, expr: &'g Expr) -> Eval<f64> {
        // The common case, without a detour.
        if let Expr::Number(number) = expr {
            return Ok(number.0);
        }
        match self.value(expr)? {
            Value::Number(number) if number.is_finite() => Ok(number),
            Value::Number(_) => Err(Box::new(Kind::NotANumber)),
            found => Err(Box::new(Kind::Type { expected: "a number", found: found.describe() })),
        }
    }

    pub fn axis(&mut self, expr: &'g Expr) -> Eval<Axis> {
        match self.value(expr)? {
            Value::Axis(axis) => Ok(axis),
            found => Err(Box::new(Kind::Type { expected: "an axis", found: found.describe() })),
        }
    }

    pub fn thing(&mut self, expr: &'g Expr) -> Eval<&'g Thing> {
        match self.value(expr)? {
            Value::Thing(thing) => Ok(thing),
            found => {
                Err(Box::new(Kind::Type { expected: "a block or a primitive", found: found.describe() }))
            }
        }
    }

    pub fn truth(&mut self, expr: &'g Expr) -> Eval<bool> {
        Ok(self.number(expr)? != 0.0)
    }

    pub fn value(&mut self, expr: &'g Expr) -> Eval<Value<'g>> {
        Ok(match expr {
            Expr::Number(number) => Value::Number(number.0),
            Expr::Axis(axis) => Value::Axis(*axis),
            Expr::Thing(thing) => Value::Thing(thing),
            Expr::Param(at) => self.around.params[*at],
            Expr::Constant(at) => self.world.constants[self.around.style][*at],
            Expr::ScopeSize(axis) => {
                Value::Number(self.site.map_or(0.0, |site| f64::from(site.scope.len(*axis))))
            }
            Expr::Share(share) => Value::Number(self.site.map_or(0.0, |site| match share {
                Share::Index => f64::from(site.index),
                Share::Total => f64::from(site.total),
            })),
            Expr::Unary(UnaryOp::Negate, operand) => Value::Number(-self.number(operand)?),
            Expr::Unary(UnaryOp::Not, operand) => truth(!self.truth(operand)?),
            Expr::Binary(op, left, right) => self.binary(*op, left, right)?,
            Expr::Call(function, args) => Value::Number(self.call(*function, args)?),
            Expr::Pick(parts) => self.pick(parts)?,
            Expr::Mix(parts) => {
                let parts = self.weighted(parts)?;
                Value::Thing(self.world.things.keep(Thing::Mix(parts)))
            }
            Expr::Gradient(axis, blocks) => {
                let axis = self.axis(axis)?;
                let blocks = blocks.iter().map(|block| self.thing(block).cloned()).collect::<Eval<_>>()?;
                Value::Thing(self.world.things.keep(Thing::Gradient(axis, blocks)))
            }
            Expr::State(base, properties) => {
                let changed = self.thing(base)?.with(properties);
                Value::Thing(self.world.things.keep(changed))
            }
            Expr::Same(key, value) => {
                let place = self.keyed(key)?;
                Env::new(self.world, self.around, self.site, place).knowing(self.known).value(value)?
            }
            Expr::Occlusion { against, distance } => {
                let distance = distance.as_deref().map_or(Ok(0.0), |distance| self.number(distance))?;
                Value::Number(self.ask(|known, body| known.occlusion(body, against, distance)))
            }
            Expr::Visible(label) => Value::Number(self.ask(|known, body| known.visible(body, label))),
        })
    }

    /// An answer about other shapes. Where there are none, as for constants, nothing is found.
    fn ask(&self, ask: impl FnOnce(&Known<'g>, &Body) -> f64) -> f64 {
        let body = self.site.and_then(|site| Body::within(site.scope, self.around.footprint.as_ref()));
        self.known.zip(body).map_or(0.0, |(known, body)| ask(known, &body))
    }

    /// The place that a key stands for.
    pub fn keyed(&mut self, key: &'g Expr) -> Eval<Place> {
        let local = self.around.local;
        Ok(match self.value(key)? {
            Value::Number(number) => local.keyed(&number.to_bits().to_le_bytes()),
            Value::Axis(axis) => local.keyed(axis.to_string().as_bytes()),
            Value::Thing(thing) => local.keyed(thing.text().as_bytes()),
        })
    }

    fn pick(&mut self, parts: &'g [(Expr, Expr)]) -> Eval<Value<'g>> {
        let mut weights = Vec::with_capacity(parts.len());
        for (weight, _) in parts {
            weights.push(self.number(weight)?);
        }
        let draw = self.draw();
        let at = weighted(&weights, draw).map_err(Box::new)?;
        self.value(&parts[at].1)
    }

    fn weighted(&mut self, parts: &'g [(Expr, Expr)]) -> Eval<Vec<(Number, Thing)>> {
        let mut out = Vec::with_capacity(parts.len());
        for (weight, thing) in parts {
            let weight = self.number(weight)?;
            if weight < 0.0 {
                return Err(Box::new(Kind::Weight(weight)));
            }
            out.push((Number(weight), self.thing(thing)?.clone()));
        }
        Ok(out)
    }

    fn binary(&mut self, op: BinaryOp, left: &'g Expr, right: &'g Expr) -> Eval<Value<'g>> {
        match op {
            BinaryOp::And => return Ok(truth(self.truth(left)? && self.truth(right)?)),
            BinaryOp::Or => return Ok(truth(self.truth(left)? || self.truth(right)?)),
            BinaryOp::Equal => return Ok(truth(self.value(left)? == self.value(right)?)),
            BinaryOp::NotEqual => return Ok(truth(self.value(left)? != self.value(right)?)),
            _ => {}
        }
        let (left, right) = (self.number(left)?, self.number(right)?);
        Ok(match op {
            BinaryOp::Less => truth(left < right),
            BinaryOp::LessEqual => truth(left <= right),
            BinaryOp::Greater => truth(left > right),
            BinaryOp::GreaterEqual => truth(left >= right),
            BinaryOp::Add => Value::Number(left + right),
            BinaryOp::Subtract => Value::Number(left - right),
            BinaryOp::Multiply => Value::Number(left * right),
            BinaryOp::Divide => Value::Number(left / right),
            // The sign of the divisor, so that `n % 2` alternates below zero as well.
            _ => Value::Number(left - right * (left / right).floor()),
        })
    }

    fn call(&mut self, function: Function, args: &'g [Expr]) -> Eval<f64> {
        let mut numbers = Vec::with_capacity(args.len());
        for arg in args {
            numbers.push(self.number(arg)?);
        }
        Ok(match (function, numbers.as_slice()) {
            (Function::Rand, &[low, high]) => low + (high - low) * self.draw(),
            (Function::Rand, _) => self.draw(),
            (Function::Randint, &[low, high]) => self.integer(low, high)?,
            (Function::Gauss, &[mean, deviation]) => mean + deviation * self.normal(),
            (Function::Triangular, &[low, mode, high]) => self.triangular(low, mode, high),
            (Function::Min, numbers) => numbers.iter().copied().fold(f64::INFINITY, f64::min),
            (Function::Max, numbers) => numbers.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            (Function::Abs, &[number]) => number.abs(),
            (Function::Floor, &[number]) => number.floor(),
            (Function::Ceil, &[number]) => number.ceil(),
            (Function::Round, &[number]) => number.round(),
            _ => return Err(Box::new(Kind::NotANumber)),
        })
    }

    /// A number from 0 up to 1.
    pub fn draw(&mut self) -> f64 {
        self.stream().random()
    }

    /// A number of the standard normal distribution, by the method of Box and Muller (1958). The logarithm and the
    /// cosine are those of a library, so that every machine draws the same.
    fn normal(&mut self) -> f64 {
        let (radius, angle) = (1.0 - self.draw(), self.draw());
        libm::sqrt(-2.0 * libm::log(radius)) * libm::cos(std::f64::consts::TAU * angle)
    }

    /// A number of the triangular distribution, from a draw of its inverse.
    fn triangular(&mut self, low: f64, mode: f64, high: f64) -> f64 {
        let (low, high) = (low.min(high), low.max(high));
        let mode = mode.clamp(low, high);
        let (width, draw) = (high - low, self.draw());
        match draw * width < mode - low {
            true => low + libm::sqrt(draw * width * (mode - low)),
            false => high - libm::sqrt((1.0 - draw) * width * (high - mode)),
        }
    }

    /// A whole number from `low` to `high`, both included, whichever way round they are.
    fn integer(&mut self, low: f64, high: f64) -> Eval<f64> {
        const EXACT: f64 = 9e15;
        let (low, high) = (low.min(high).ceil(), low.max(high).floor());
        if low > high || low < -EXACT || high > EXACT {
            return Err(Box::new(Kind::NotANumber));
        }
        Ok(self.stream().random_range(low as i64..=high as i64) as f64)
    }

    fn stream(&mut self) -> &mut Pcg64Mcg {
        if let Stream::At(place) = self.stream {
            self.stream = Stream::Open(place.stream());
        }
        match &mut self.stream {
            Stream::Open(stream) => stream,
            Stream::At(_) => unreachable!("the stream was just opened"),
        }
    }
}

fn truth<'g>(truth: bool) -> Value<'g> {
    Value::Number(f64::from(u8::from(truth)))
}
