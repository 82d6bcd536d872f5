use super::suggest::distance;
use std::cmp::Reverse;
use std::fmt;
use std::sync::OnceLock;

/// A release of Minecraft: Java Edition since 1.13. Later ones are greater.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct Version(u8);

/// What is known of one version: its name and data version, and what came with it.
pub(super) struct Release {
    name: &'static str,
    data_version: i32,
    pub(super) changes: Vec<Change>,
}

/// Something that came with a version.
pub(super) enum Change {
    Blocks(Vec<&'static str>),
    /// A property of these blocks, or only these values of it.
    Property {
        key: &'static str,
        values: Option<Vec<&'static str>>,
        blocks: Vec<&'static str>,
    },
    Renamed {
        old: Pattern,
        new: Pattern,
        ways: Ways,
    },
}

/// Which way a state is translated.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Ways {
    Both,
    DownOnly,
}

/// A block name, where `*` stands for any text, and properties.
pub(super) struct Pattern {
    pub(super) name: &'static str,
    pub(super) properties: Vec<(&'static str, &'static str)>,
}

impl Version {
    /// The version of that name, such as `1.20.1`.
    pub fn named(name: &str) -> Option<Version> {
        Version::all().find(|version| version.name() == name)
    }

    /// The versions whose names are most like `name`, as `1.20.1`, `1.20.2` and so on are like `1.20.9`.
    pub fn like(name: &str) -> Vec<Version> {
        const SHOWN: usize = 3;
        let mut all: Vec<Version> = Version::all().rev().collect();
        all.sort_by_key(|version| (distance(name, version.name()), Reverse(shared(name, version.name()))));
        all.truncate(SHOWN);
        all
    }

    /// The latest version that is not newer than a data version; `None` before 1.13.
    pub fn of_data(data_version: i32) -> Option<Version> {
        Version::all().take_while(|version| version.data_version() <= data_version).last()
    }

    /// The first version that names blocks as all later ones do.
    pub fn oldest() -> Version {
        Version(0)
    }

    /// The newest version there is anything known of.
    pub fn newest() -> Version {
        Version(releases().len() as u8 - 1)
    }

    /// All versions, the oldest first.
    pub fn all() -> impl DoubleEndedIterator<Item = Version> {
        (0..releases().len() as u8).map(Version)
    }

    pub fn name(self) -> &'static str {
        self.release().name
    }

    pub fn data_version(self) -> i32 {
        self.release().data_version
    }

    pub(super) fn changes(self) -> &'static [Change] {
        &self.release().changes
    }

    fn release(self) -> &'static Release {
        &releases()[usize::from(self.0)]
    }
}

impl fmt::Display for Version {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// How many bytes two texts begin with alike.
fn shared(a: &str, b: &str) -> usize {
    a.bytes().zip(b.bytes()).take_while(|(a, b)| a == b).count()
}

fn releases() -> &'static [Release] {
    static RELEASES: OnceLock<Vec<Release>> = OnceLock::new();
    RELEASES.get_or_init(|| parse(include_str!("versions.txt")))
}

fn parse(text: &'static str) -> Vec<Release> {
    let mut releases: Vec<Release> = Vec::new();
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        if let Some(change) = line.strip_prefix("  ") {
            if let Some(release) = releases.last_mut() {
                release.changes.extend(parse_change(change));
            }
        } else if let Some((name, data_version)) = line.split_once(' ')
            && let Ok(data_version) = data_version.parse()
        {
            releases.push(Release { name, data_version, changes: Vec::new() });
        }
    }
    releases
}

fn parse_change(line: &'static str) -> Option<Change> {
    let words = |text: &'static str| text.split_whitespace().collect();
    let Some(added) = line.strip_prefix("+ ") else { return renamed(line) };
    let Some((property, blocks)) = added.split_once(" : ") else { return Some(Change::Blocks(words(added))) };
    let (key, values) = match property.split_once('=') {
        Some((key, values)) => (key, Some(values.split('|').collect())),
        None => (property, None),
    };
    Some(Change::Property { key, values, blocks: words(blocks) })
}

fn renamed(line: &'static str) -> Option<Change> {
    let both = line.split_once(" => ").map(|(old, new)| (old, new, Ways::Both));
    let (old, new, ways) =
        both.or_else(|| line.split_once(" <= ").map(|(old, new)| (old, new, Ways::DownOnly)))?;
    Some(Change::Renamed { old: pattern(old), new: pattern(new), ways })
}

fn pattern(text: &'static str) -> Pattern {
    let (name, properties) = text.split_once('[').unwrap_or((text, ""));
    let properties = properties.trim_end_matches(']').split(',').filter_map(|pair| pair.split_once('='));
    Pattern { name, properties: properties.collect() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_have_names_and_data_versions_in_order() {
        let data: Vec<i32> = Version::all().map(Version::data_version).collect();
        assert!(data.is_sorted() && data.len() > 50, "{data:?}");
        for version in Version::all() {
            assert_eq!(Version::named(version.name()), Some(version));
            assert_eq!(Version::of_data(version.data_version()), Some(version));
        }
        let named = |data| Version::of_data(data).map(Version::name);
        assert_eq!(named(1518), None);
        assert_eq!(named(3465), Some("1.20.1"));
        assert_eq!(named(3464), Some("1.20"));
        assert_eq!(named(i32::MAX), Some(Version::newest().name()));
        assert_eq!(Version::named("1.12.2"), None);
        assert!(Version::named("1.21.11") > Version::named("1.9").or(Version::named("1.21.9")));
    }

    #[test]
    fn every_line_is_read() {
        let lines =
            include_str!("versions.txt").lines().filter(|line| !line.is_empty() && !line.starts_with('#'));
        let changes: usize = Version::all().map(|version| version.changes().len()).sum();
        assert_eq!(lines.count(), Version::all().count() + changes);
    }
}
