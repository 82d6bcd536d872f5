//! Where new text goes.

/// The end of the line on which an item ends, behind the comment that may stand there.
pub fn end_of_item(text: &str, end: usize) -> usize {
    let line = text[end..].find('\n').map_or(text.len(), |length| end + length);
    // A file from elsewhere may end its lines in two characters.
    if text[..line].ends_with('\r') { line - 1 } else { line }
}
