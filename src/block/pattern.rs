//! Tables of name patterns, as the data files of this module are written.

/// Reads lines of `patterns = value`: each pattern with the value of its line, in order.
pub(super) fn table(text: &'static str) -> impl Iterator<Item = (&'static str, &'static str)> {
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    let rules = lines.filter_map(|line| line.split_once('='));
    rules.flat_map(|(patterns, value)| patterns.split_whitespace().map(move |p| (p, value.trim())))
}

/// Whether `name` fits `pattern`, in which a `*` stands for any text, also none.
pub(super) fn fits(pattern: &str, name: &str) -> bool {
    let Some((head, rest)) = pattern.split_once('*') else { return pattern == name };
    let Some(name) = name.strip_prefix(head) else { return false };
    (0..=name.len()).any(|skip| fits(rest, &name[skip..]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_star_stands_for_any_text() {
        for (pattern, name) in [("*_wall", "stone_wall"), ("a*c*", "abc"), ("*", ""), ("a", "a")] {
            assert!(fits(pattern, name), "{pattern} {name}");
        }
        for (pattern, name) in [("*_wall", "wall"), ("a*c", "abcd"), ("a", "ab"), ("", "a")] {
            assert!(!fits(pattern, name), "{pattern} {name}");
        }
    }
}
