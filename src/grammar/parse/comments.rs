//! Comments: which item each one belongs to.

use crate::grammar::lex::Comment;

/// Deals out comments to the items below them.
pub struct Comments<'t> {
    pub text: &'t str,
    pub rest: &'t [Comment],
}

impl Comments<'_> {
    /// The comments at the head of the file that a blank line separates from the first item.
    pub fn preamble(&mut self) -> Vec<String> {
        let mut preamble = Vec::new();
        let mut kept = 0;
        let mut end = 0;
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

    pub fn before(&mut self, place: usize) -> Vec<String> {
        let count = self.rest.iter().take_while(|comment| comment.span.start < place).count();
        let (taken, rest) = self.rest.split_at(count);
        self.rest = rest;
        taken.iter().map(|comment| comment.text.clone()).collect()
    }

    /// Drops the comments inside an item and behind it on its last line.
    pub fn skip_inside(&mut self, end: usize) {
        let line_end = self.text[end..].find('\n').map_or(self.text.len(), |length| end + length);
        let _ = self.before(line_end);
    }
}
