//! Which numbers a derivation asks for that the grammar does not give.

use super::change::Change;
use super::condition::relaxed;
use super::demand::{Demands, Site};
use super::texts::{Edit, Operations, Program};
use crate::grammar::ast::{Expr, ExprKind, Item, Op, Rule, Size, SizeKind, Successor};
use crate::grammar::{Name, Names};
use crate::graph;
use crate::parse::{Choice, Derivation, Step};
use crate::space::Axis;
use std::collections::BTreeMap;
use std::rc::Rc;

/// The edits with which a derivation keeps to the lengths that the grammar says; `None` where there are none.
pub fn widened(program: &Program, derivation: &Derivation) -> Option<(Vec<Edit>, Vec<Change>)> {
    let operations = program.operations();
    let mut demands = Demands::new(program);
    for (at, step) in derivation.steps.iter().enumerate() {
        if matches!(step.choice, Choice::Stretched(_) | Choice::StretchedTimes(_)) {
            let site = site(program, &operations, &derivation.steps, &path(&derivation.steps, at))?;
            let (rule, successor) = operations.at(program.graph.origin(step.node)?.span)?;
            ask(&mut demands, step, successor, rule, &site)?;
        }
    }
    let (mut edits, mut changes) = demands.granted()?;
    let (more_edits, more_changes) = conditions(program, derivation)?;
    edits.extend(more_edits);
    changes.extend(more_changes);
    Some((edits, changes))
}

/// The same for rules that are taken where their conditions do not hold.
fn conditions(program: &Program, derivation: &Derivation) -> Option<(Vec<Edit>, Vec<Change>)> {
    let mut asked: BTreeMap<usize, (&Rule, Vec<[i32; 3]>)> = BTreeMap::new();
    for step in &derivation.steps {
        if let Choice::StretchedAlternative(number) = step.choice {
            let label = &program.graph.origin(step.node)?.label;
            let rule = closed_rule(program, label, number as usize)?;
            let (_, sizes) = asked.entry(rule.label.span.start).or_insert((rule, Vec::new()));
            sizes.push(Axis::ALL.map(|axis| step.scope.len(axis)));
        }
    }
    let edits = asked.into_values().map(|(rule, mut sizes)| {
        sizes.sort_unstable();
        sizes.dedup();
        let condition = rule.condition.as_ref()?;
        let to = relaxed(program, condition, &sizes)?;
        let from = program.words(condition.span).to_owned();
        let what = format!("when `{}` applies", rule.label.name);
        Some((program.edit(condition.span, to.clone()), Change::Widened { what, from, to }))
    });
    edits.collect::<Option<Vec<(Edit, Change)>>>().map(|list| list.into_iter().unzip())
}

/// A rule of a label by its number. Where rules have priorities, one that applies more often hides others.
fn closed_rule<'p>(program: &'p Program, label: &str, number: usize) -> Option<&'p Rule> {
    let first = program.checked.rules_of(label).next()?.priority;
    let is_level = program.checked.rules_of(label).all(|rule| rule.priority == first);
    program.checked.rules_of(label).nth(number).filter(|_| is_level)
}

/// The steps that one is inside of, from the root down, and itself.
pub fn path(steps: &[Step], at: usize) -> Vec<usize> {
    let mut path = vec![at];
    let mut depth = steps[at].depth;
    for (above, step) in steps[..at].iter().enumerate().rev() {
        if step.depth < depth {
            path.push(above);
            depth = step.depth;
        }
    }
    path.reverse();
    path
}

/// The sizes of a split's parts, those in groups among them, and the parts.
pub fn parts(items: &[Item]) -> Vec<(&Size, &Successor)> {
    let mut all = Vec::new();
    for item in items {
        match item {
            Item::Part { size, body } => all.push((size, body)),
            Item::Group { items, .. } => all.extend(parts(items)),
        }
    }
    all
}

/// Where the expressions of the last step of a path stand.
fn site<'p>(
    program: &Program,
    operations: &Operations<'p>,
    steps: &[Step],
    path: &[usize],
) -> Option<Site<'p>> {
    let (&last, above) = path.split_last()?;
    let origin = |at: usize| program.graph.origin(steps[at].node).map(|origin| origin.span);
    let (rule, _) = operations.at(origin(last)?)?;
    let is_call = |at: &usize| matches!(program.graph.op(steps[above[*at]].node), graph::Op::Call(_));
    let call = match (0..above.len()).rev().find(is_call) {
        None => None,
        Some(at) => {
            let (_, successor) = operations.at(origin(above[at])?)?;
            let Op::Call { args, .. } = &successor.op else { return None };
            Some((args.as_slice(), Rc::new(site(program, operations, steps, &path[..=at])?)))
        }
    };
    Some(Site { rule: Some(rule), scope: Some(steps[last].scope), call })
}

/// Asks for what one step needs.
fn ask<'p>(
    demands: &mut Demands<'p>,
    step: &Step,
    successor: &'p Successor,
    rule: &'p Rule,
    site: &Site<'p>,
) -> Option<()> {
    let what = |body: &Successor| match called(body) {
        Some(label) => format!("`{label}` in `{}`", rule.label.name),
        None => format!("`{}`", rule.label.name),
    };
    match (&successor.op, &step.choice) {
        (Op::Split { items, .. }, Choice::Stretched(lengths)) => {
            let parts = parts(items);
            let floating = newly_floating(items, lengths);
            lengths.iter().try_for_each(|(number, length)| {
                let (size, body) = parts.get(*number as usize)?;
                match size.kind {
                    _ if floating == Some(*number) => demands.float(&size.value, &what(body)),
                    SizeKind::Floating => Some(()),
                    SizeKind::Absolute => demands.ask(&size.value, f64::from(*length), &what(body), site),
                    SizeKind::Relative => None,
                }
            })
        }
        (Op::RepeatN { count, body, .. }, Choice::StretchedTimes(times)) => {
            demands.ask(count, f64::from(*times), &what(body), site)
        }
        (Op::Repeat { axis, size, body, .. }, Choice::StretchedTimes(times)) => {
            let total = step.scope.len(plain_axis(axis)?);
            let each = f64::from(total) / f64::from(*times);
            demands.ask(size, each, &what(body), site)
        }
        _ => None,
    }
}

/// The part that is to float so that a split of plain lengths fills its scope: the one that is longest of those which
/// are of another length now. In scopes that the split filled before it is as long as it was.
fn newly_floating(items: &[Item], lengths: &[(u32, i32)]) -> Option<u32> {
    let plain = items.iter().map(|item| match item {
        Item::Part { size: Size { kind: SizeKind::Absolute, value }, .. } => match value.kind {
            ExprKind::Number(length) => Some(length),
            _ => None,
        },
        _ => None,
    });
    let plain = plain.collect::<Option<Vec<f64>>>()?;
    let changed =
        lengths.iter().filter(|(number, length)| plain.get(*number as usize) != Some(&f64::from(*length)));
    changed.max_by_key(|(number, length)| (*length, std::cmp::Reverse(*number))).map(|(number, _)| *number)
}

fn called(body: &Successor) -> Option<&str> {
    match &body.op {
        Op::Call { label, .. } => Some(&label.name),
        _ => None,
    }
}

/// An axis that is written as one.
pub fn plain_axis(expr: &Expr) -> Option<Axis> {
    let ExprKind::Name(name) = &expr.kind else { return None };
    match (Names { params: &[], constants: &[] }).resolve(name) {
        Name::Axis(axis) => Some(axis),
        _ => None,
    }
}
