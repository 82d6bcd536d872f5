//! Comments: which item or operation each one belongs to.

use crate::grammar::ast::{Grammar, Rule, Successor, for_each_child, for_each_child_mut};
use crate::grammar::lex::Comment;

/// Deals out comments, in the order of the file.
pub struct Comments<'t> {
    pub text: &'t str,
    pub rest: &'t [Comment],
    /// Those of directives, which have no place of their own: they go to the next item.
    pending: Vec<String>,
}

/// How many items a grammar has of each sort that carries comments.
pub type Counts = [usize; 5];

/// The place of rules among the sorts.
const RULES: usize = 4;

pub fn counts(grammar: &Grammar) -> Counts {
    let Grammar { imports, sizes, constants, styles, rules, .. } = grammar;
    [imports.len(), sizes.len(), constants.len(), styles.len(), rules.len()]
}

impl<'t> Comments<'t> {
    pub fn new(text: &'t str, rest: &'t [Comment]) -> Comments<'t> {
        Comments { text, rest, pending: Vec::new() }
    }

    /// The comments at the head of the file that a blank line separates from the first item.
    pub fn preamble(&mut self, start: usize) -> Vec<String> {
        let mut preamble = Vec::new();
        let mut kept = 0;
        let mut end = start;
        for comment in self.rest {
            let gap = &self.text[end..comment.span.start];
            if !gap.trim().is_empty() {
                break;
            }
            preamble.push(comment.text.clone());
            end = comment.span.end;
            let below = &self.text[end..];
            let blank = below.find(|c: char| !c.is_whitespace()).unwrap_or(below.len());
            if below[..blank].matches('\n').count() >= 2 {
                kept = preamble.len();
                break;
            }
        }
        preamble.truncate(kept);
        self.rest = &self.rest[kept..];
        preamble
    }

    /// The comments up to a place, after those that have waited for it.
    pub fn above(&mut self, place: usize) -> Vec<String> {
        let mut above = std::mem::take(&mut self.pending);
        above.extend(texts(self.take(place)));
        above
    }

    fn take(&mut self, place: usize) -> &'t [Comment] {
        let count = self.rest.iter().take_while(|comment| comment.span.start < place).count();
        let (taken, rest) = self.rest.split_at(count);
        self.rest = rest;
        taken
    }

    /// Deals out the comments of the item that was just read and ends at `end`: those inside it, and the one behind it
    /// on its line. `before` says how many items there were without it. Directives have no place for comments: theirs
    /// go to the head of the file, or to the next item.
    pub fn inside(&mut self, grammar: &mut Grammar, before: Counts, above: Vec<String>, end: usize) {
        let line_end = self.text[end..].find('\n').map_or(self.text.len(), |length| end + length);
        let now = counts(grammar);
        if now[RULES] > before[RULES]
            && let Some(rule) = grammar.rules.last_mut()
        {
            self.inside_rule(rule, end);
        }
        match newest(grammar, before, now) {
            Some((comments, behind)) => {
                comments.extend(texts(self.take(end)));
                *behind = texts(self.take(line_end)).next();
            }
            None => {
                let is_head = now.iter().sum::<usize>() == 0;
                let behind = texts(self.take(line_end));
                let place = if is_head { &mut grammar.preamble } else { &mut self.pending };
                place.extend(above);
                place.extend(behind);
            }
        }
    }

    /// Those of a rule that ends at `end`. What stands beside its weight goes to the end of its operation.
    fn inside_rule(&mut self, rule: &mut Rule, end: usize) {
        let span = rule.successor.span;
        rule.comments.extend(texts(self.take(span.start)));
        self.deal(&mut rule.successor);
        let (mut has_parts, beside_weight) = (false, self.take(end));
        for_each_child(&rule.successor.op, &mut |_| has_parts = true);
        if has_parts && !beside_weight.is_empty() {
            rule.successor.notes_mut().last.extend(texts(beside_weight));
            return;
        }
        // An operation without parts has no lines inside it.
        if let Some(notes) = &mut rule.successor.notes
            && !notes.above.is_empty()
        {
            rule.comments.append(&mut notes.above);
        }
        rule.comments.extend(texts(beside_weight));
    }

    /// Deals out the comments inside an operation.
    fn deal(&mut self, successor: &mut Successor) {
        let end = successor.span.end;
        let mut children = Vec::new();
        for_each_child_mut(&mut successor.op, &mut |child| children.push(child));
        let mut open = None;
        for at in 0..children.len() {
            let (before, from) = children.split_at_mut(at);
            let taken = self.take(from[0].span.start);
            let taken = match (before.last_mut(), taken) {
                (Some(previous), [first, rest @ ..]) if self.is_behind(previous.span.end, first) => {
                    previous.notes_mut().behind = Some(first.text.clone());
                    rest
                }
                (None, [first, rest @ ..]) if !self.is_alone(first) => {
                    open = Some(first.text.clone());
                    rest
                }
                (_, taken) => taken,
            };
            if !taken.is_empty() {
                from[0].notes_mut().above.extend(texts(taken));
            }
            self.deal(from[0]);
        }
        let mut taken = self.take(end);
        let is_leaf = children.is_empty();
        if let (Some(last), [first, rest @ ..]) = (children.last_mut(), taken)
            && self.is_behind(last.span.end, first)
        {
            last.notes_mut().behind = Some(first.text.clone());
            taken = rest;
        }
        if open.is_some() {
            successor.notes_mut().open = open;
        }
        match is_leaf {
            _ if taken.is_empty() => {}
            true => successor.notes_mut().above.extend(texts(taken)),
            false => successor.notes_mut().last.extend(texts(taken)),
        }
    }

    /// Whether a comment stands on the line on which a part ends, or the rhythm group around it.
    fn is_behind(&self, end: usize, comment: &Comment) -> bool {
        let between = self.text.get(end..comment.span.start).unwrap_or("\n");
        let group = between.find(|c: char| !c.is_whitespace() && !"}*".contains(c)).unwrap_or(between.len());
        let closed = between[..group].rfind(['}', '*']).map_or(0, |at| at + 1);
        !between[closed..].contains('\n')
    }

    /// Whether a comment has a line of its own.
    fn is_alone(&self, comment: &Comment) -> bool {
        let before = &self.text[..comment.span.start];
        before[before.rfind('\n').map_or(0, |at| at + 1)..].trim().is_empty()
    }
}

fn texts(comments: &[Comment]) -> impl Iterator<Item = String> {
    comments.iter().map(|comment| comment.text.clone())
}

/// The place for comments of the item that a grammar has more than before.
fn newest(
    grammar: &mut Grammar,
    before: Counts,
    now: Counts,
) -> Option<(&mut Vec<String>, &mut Option<String>)> {
    let sort = (0..now.len()).find(|sort| now[*sort] > before[*sort])?;
    Some(match sort {
        0 => grammar.imports.last_mut().map(|item| (&mut item.comments, &mut item.behind))?,
        1 => grammar.sizes.last_mut().map(|item| (&mut item.comments, &mut item.behind))?,
        2 => grammar.constants.last_mut().map(|item| (&mut item.comments, &mut item.behind))?,
        3 => grammar.styles.last_mut().map(|item| (&mut item.comments, &mut item.behind))?,
        _ => grammar.rules.last_mut().map(|item| (&mut item.comments, &mut item.behind))?,
    })
}
