use super::known::all;

/// The block of the game whose name is closest to `name`, if one is close enough to have been meant.
pub fn suggest(name: &str) -> Option<&'static str> {
    let name = name.strip_prefix("minecraft:").unwrap_or(name);
    closest(name, all().iter().map(|known| known.name()))
}

/// The one of the sorted `names` that is closest to `name`, if it is close enough to have been meant.
pub(super) fn closest(name: &str, names: impl Iterator<Item = &'static str>) -> Option<&'static str> {
    let most = name.len().div_ceil(4).max(1);
    let distances = names.map(|other| (distance(name, other), other));
    // Names are sorted, and `min_by_key` keeps the first of equals: the answer is always the same.
    distances.filter(|&(d, _)| d <= most).min_by_key(|&(d, _)| d).map(|(_, name)| name)
}

/// The Levenshtein distance: how many bytes must be put in, taken out or replaced to make `a` into `b`.
pub(super) fn distance(a: &str, b: &str) -> usize {
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.bytes().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, y) in b.bytes().enumerate() {
            let replaced = diagonal + usize::from(x != y);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances() {
        assert_eq!(distance("kitten", "sitting"), 3);
        assert_eq!(distance("", "abc"), 3);
        assert_eq!(distance("stone", "stone"), 0);
    }

    #[test]
    fn slips_find_the_block_that_was_meant() {
        assert_eq!(suggest("oak_plank"), Some("oak_planks"));
        assert_eq!(suggest("minecraft:cobblestne"), Some("cobblestone"));
        assert_eq!(suggest("stone_brick"), Some("stone_bricks"));
        assert_eq!(suggest("house"), None);
        assert_eq!(suggest(""), None);
    }
}
