//! The lengths that the scopes of inner operations may have.

use super::numbers::Numbers;
use crate::grammar::ast::*;
use crate::space::Axis;

/// The lengths of a scope along its own axes: whole numbers.
pub type Lengths = [Numbers; 3];

/// A part of a split whose place in the text is in a group, or not.
struct Part<'g> {
    size: &'g Size,
    body: &'g Successor,
    is_grouped: bool,
}

/// What parts of a split take of a scope. Fractions of the scope are kept apart from blocks.
pub struct Need {
    pub blocks: Numbers,
    pub fraction: Numbers,
    pub floats: bool,
    pub groups: bool,
}

impl Need {
    /// What the parts outside of groups take along an axis.
    pub fn of(items: &[Item], numbers: &dyn Fn(&Expr) -> Numbers) -> Need {
        let mut parts = Vec::new();
        flatten(items, false, &mut parts);
        Need::of_parts(&parts, None, numbers)
    }

    /// As [`Need::of`], without one part.
    fn of_parts(parts: &[Part<'_>], but: Option<usize>, numbers: &dyn Fn(&Expr) -> Numbers) -> Need {
        let (blocks, fraction) = (Numbers::one(0.0), Numbers::one(0.0));
        let mut need = Need { blocks, fraction, floats: false, groups: false };
        for (at, part) in parts.iter().enumerate() {
            need.groups |= part.is_grouped;
            need.floats |= part.size.kind == SizeKind::Floating && Some(at) != but;
            let sum = match part.size.kind {
                _ if part.is_grouped || Some(at) == but => continue,
                SizeKind::Absolute => &mut need.blocks,
                SizeKind::Relative => &mut need.fraction,
                SizeKind::Floating => continue,
            };
            *sum = Numbers::binary(BinaryOp::Add, sum, &numbers(&part.size.value));
        }
        need
    }
}

fn flatten<'g>(items: &'g [Item], is_grouped: bool, out: &mut Vec<Part<'g>>) {
    for item in items {
        match item {
            Item::Part { size, body } => out.push(Part { size, body, is_grouped }),
            Item::Group { items, .. } => flatten(items, true, out),
        }
    }
}

/// The operations directly in another, each with the lengths that its scope may have.
pub fn of<'g>(
    op: &'g Op,
    lengths: &Lengths,
    up: Axis,
    numbers: &dyn Fn(&Expr) -> Numbers,
    axes: &dyn Fn(&Expr) -> [bool; 3],
) -> Vec<(&'g Successor, Lengths)> {
    match op {
        Op::Primitive { .. } | Op::Nil | Op::Call { .. } | Op::Snap { .. } => Vec::new(),
        Op::All(ops) => ops.iter().map(|op| (op, lengths.clone())).collect(),
        Op::Split { axis, items, snap } => split(items, snap.is_some(), lengths, axes(axis), numbers),
        Op::Repeat { axis, size, snap, body } => {
            let size = numbers(size);
            let share = |have: &Numbers| repeated(have, &size, snap.is_some());
            vec![(body, along(lengths, axes(axis), share))]
        }
        Op::RepeatN { axis, count, body } => {
            let count = numbers(count).rising(f64::round, true);
            vec![(body, along(lengths, axes(axis), |have| divided(have, &count)))]
        }
        Op::Carve { how, args, parts } => {
            let carved = carved(*how, args, lengths, numbers);
            parts.iter().map(|(_, body)| (body, carved.clone())).collect()
        }
        Op::Within { change, body } => vec![(body, changed(change, lengths, up, numbers))],
    }
}

/// The lengths where those along one of some axes become others.
fn along(lengths: &Lengths, axes: [bool; 3], length: impl Fn(&Numbers) -> Numbers) -> Lengths {
    let certain = axes.iter().filter(|is_possible| **is_possible).count() == 1;
    let mut out = lengths.clone();
    for axis in (0..3).filter(|axis| axes[*axis]) {
        let new = length(&lengths[axis]);
        out[axis] = if certain { new } else { new.join(&lengths[axis]) };
    }
    out
}

/// The least length of a part that runs: only parts of what is flat already may be so.
fn least(have: &Numbers) -> f64 {
    if have.low() < 1.0 { 0.0 } else { 1.0 }
}

fn split<'g>(
    items: &'g [Item],
    is_snapped: bool,
    lengths: &Lengths,
    axes: [bool; 3],
    numbers: &dyn Fn(&Expr) -> Numbers,
) -> Vec<(&'g Successor, Lengths)> {
    let mut parts = Vec::new();
    flatten(items, false, &mut parts);
    let length = |at: usize, have: &Numbers| match is_snapped {
        true => Numbers::whole(least(have), have.high()),
        false => part_length(&parts, at, have, numbers),
    };
    let lengths = |at: usize| along(lengths, axes, |have| length(at, have));
    parts.iter().enumerate().map(|(at, part)| (part.body, lengths(at))).collect()
}

/// The length of one part of a split of a scope of some length.
fn part_length(parts: &[Part<'_>], at: usize, have: &Numbers, numbers: &dyn Fn(&Expr) -> Numbers) -> Numbers {
    let part = &parts[at];
    let value = numbers(&part.size.value);
    match part.size.kind {
        SizeKind::Absolute => fixed(&value, have),
        SizeKind::Relative => fixed(&Numbers::binary(BinaryOp::Multiply, &value, have), have),
        SizeKind::Floating => {
            let others = Need::of_parts(parts, Some(at), numbers);
            let fractions = Numbers::binary(BinaryOp::Multiply, &others.fraction, have);
            let others_take = Numbers::binary(BinaryOp::Add, &others.blocks, &fractions);
            let rest = Numbers::binary(BinaryOp::Subtract, have, &others_take);
            let is_alone = !others.floats && !others.groups && value.low() > 0.0;
            match is_alone {
                true => fixed(&rest, have),
                false => Numbers::whole(least(have), have.high().min(rest.high().ceil() + 1.0)),
            }
        }
    }
}

/// Whole sizes stay as they are; others are rounded, together with those before them.
fn fixed(size: &Numbers, have: &Numbers) -> Numbers {
    let size = match size.is_whole() {
        true => size.clone(),
        false => Numbers::whole(size.low().floor() - 1.0, size.high().ceil() + 1.0),
    };
    size.clamped(least(have), have.high())
}

/// The shares of a repeat: none is longer than the size in whole blocks.
fn repeated(have: &Numbers, size: &Numbers, is_snapped: bool) -> Numbers {
    let (length, step) = (have.low(), size.low());
    let low = (length * step / (length + step)).floor();
    let low = if is_snapped || step <= 0.0 || low.is_nan() { 0.0 } else { low };
    Numbers::whole(low.max(least(have)), have.high().min(size.high().ceil()))
}

fn divided(have: &Numbers, count: &Numbers) -> Numbers {
    let low = (have.low() / count.high().max(1.0)).floor();
    let high = (have.high() / count.low().max(1.0)).ceil();
    let low = if low.is_nan() { 0.0 } else { low };
    let high = if high.is_nan() { f64::INFINITY } else { high };
    Numbers::whole(low.max(least(have)), high)
}

/// Carved parts lie anyhow: what is known is that they are no longer than the longest side, unless they reach out.
fn carved(how: Carving, args: &[Expr], lengths: &Lengths, numbers: &dyn Fn(&Expr) -> Numbers) -> Lengths {
    let is_thin =
        args.iter().any(|arg| numbers(arg).low() < 1.0) || lengths.iter().any(|have| have.low() < 1.0);
    let low = if is_thin { 0.0 } else { 1.0 };
    let longest = lengths.iter().map(Numbers::high).fold(0.0, f64::max);
    let high = if how == Carving::Offset { f64::INFINITY } else { longest };
    [0, 1, 2].map(|_| Numbers::whole(low, high))
}

fn changed(change: &Change, lengths: &Lengths, up: Axis, numbers: &dyn Fn(&Expr) -> Numbers) -> Lengths {
    match change {
        Change::Resize(sizes) => [0, 1, 2].map(|axis| resized(&sizes[axis], &lengths[axis], numbers)),
        Change::Rotate { angle, .. } => turned(lengths, &numbers(angle), up),
        Change::Translate(_) | Change::Local | Change::Same(_) | Change::Style(_) => lengths.clone(),
    }
}

fn resized(size: &Size, have: &Numbers, numbers: &dyn Fn(&Expr) -> Numbers) -> Numbers {
    let value = numbers(&size.value);
    let size = match size.kind {
        SizeKind::Relative => Numbers::binary(BinaryOp::Multiply, &value, have),
        SizeKind::Absolute | SizeKind::Floating => value,
    };
    size.rising(|size| (size + 0.5).floor(), true).clamped(least(have), f64::INFINITY)
}

/// A quarter turn exchanges the level axes.
fn turned(lengths: &Lengths, angle: &Numbers, up: Axis) -> Lengths {
    let exchanged = match Axis::ALL.map(|axis| axis == up) {
        [_, true, _] => [2, 1, 0],
        _ => [1, 0, 2],
    };
    let quarters = |unit: f64| {
        let quarters = angle.low() / unit;
        (angle.low() == angle.high() && (quarters - quarters.round()).abs() < 1e-6).then(|| quarters.round())
    };
    let known = quarters(std::f64::consts::FRAC_PI_2).or_else(|| quarters(90.0));
    [0, 1, 2].map(|axis| match known {
        Some(quarters) if quarters.rem_euclid(2.0) == 0.0 => lengths[axis].clone(),
        Some(_) => lengths[exchanged[axis]].clone(),
        None => lengths[axis].join(&lengths[exchanged[axis]]),
    })
}
