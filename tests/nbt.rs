//! Laws of the NBT reader and writer, with `fastnbt` as an independent second opinion.

use proptest::collection::{btree_map, vec};
use proptest::prelude::*;
use std::collections::HashMap;
use std::io::{self, BufReader, Write};
use vox::nbt::{self, Compound, Endian, Limits, NbtProblem, Sink, Source, Tag, WriteError};

fn number() -> impl Strategy<Value = Tag> {
    prop_oneof![
        any::<i8>().prop_map(Tag::Byte),
        any::<i16>().prop_map(Tag::Short),
        any::<i32>().prop_map(Tag::Int),
        any::<i64>().prop_map(Tag::Long),
        (-1e9f32..1e9).prop_map(Tag::Float),
        (-1e9..1e9).prop_map(Tag::Double),
    ]
}

fn leaf() -> impl Strategy<Value = Tag> {
    prop_oneof![
        number(),
        any::<String>().prop_map(Tag::String),
        any::<Vec<i8>>().prop_map(Tag::ByteArray),
        any::<Vec<i32>>().prop_map(Tag::IntArray),
        any::<Vec<i64>>().prop_map(Tag::LongArray),
    ]
}

/// Lists hold one type.
fn uniform(entries: Vec<Tag>) -> Tag {
    let kind = entries.first().map(Tag::kind);
    Tag::List(entries.into_iter().filter(|tag| Some(tag.kind()) == kind).collect())
}

fn tag() -> impl Strategy<Value = Tag> {
    leaf().prop_recursive(4, 40, 5, |inner| {
        prop_oneof![
            vec(inner.clone(), 0..5).prop_map(uniform),
            btree_map(any::<String>(), inner, 0..5)
                .prop_map(|tags| Tag::Compound(tags.into_iter().collect())),
        ]
    })
}

fn compound() -> impl Strategy<Value = Compound> {
    btree_map(any::<String>(), tag(), 0..6).prop_map(Compound::from_iter)
}

fn second_opinion(tag: &Tag) -> fastnbt::Value {
    use fastnbt::Value;
    match tag.clone() {
        Tag::Byte(n) => Value::Byte(n),
        Tag::Short(n) => Value::Short(n),
        Tag::Int(n) => Value::Int(n),
        Tag::Long(n) => Value::Long(n),
        Tag::Float(n) => Value::Float(n),
        Tag::Double(n) => Value::Double(n),
        Tag::String(text) => Value::String(text),
        Tag::ByteArray(numbers) => Value::ByteArray(fastnbt::ByteArray::new(numbers)),
        Tag::IntArray(numbers) => Value::IntArray(fastnbt::IntArray::new(numbers)),
        Tag::LongArray(numbers) => Value::LongArray(fastnbt::LongArray::new(numbers)),
        Tag::List(entries) => Value::List(entries.iter().map(second_opinion).collect()),
        Tag::Compound(tags) => Value::Compound(second_opinions(&tags)),
    }
}

fn second_opinions(tags: &Compound) -> HashMap<String, fastnbt::Value> {
    tags.iter().map(|(name, tag)| (name.to_string(), second_opinion(tag))).collect()
}

fn read(bytes: &[u8]) -> Result<(String, Compound), nbt::NbtError> {
    nbt::read(bytes, &Limits::default())
}

proptest! {
    #[test]
    fn what_is_written_is_read(name: String, tags in compound()) {
        for endian in [Endian::Big, Endian::Little] {
            let bytes = nbt::write_as(endian, &name, &tags).unwrap();
            let back = nbt::read_as(endian, &bytes, &Limits::default()).unwrap();
            prop_assert_eq!(back, (name.clone(), tags.clone()));
        }
    }

    #[test]
    fn bytes_come_in_pieces_of_any_size(tags in compound(), size in 1..40usize) {
        let bytes = nbt::write("", &tags).unwrap();
        let pieces = BufReader::with_capacity(size, &bytes[..]);
        let (_, back, end) = nbt::read_from(pieces, Endian::Big, &Limits::default(), &mut ()).unwrap();
        prop_assert_eq!((back, end), (tags, bytes.len() as u64));
    }

    #[test]
    fn compounds_that_come_again_are_read_again(
        kinds in vec(compound(), 1..4),
        lists in vec(vec(any::<prop::sample::Index>(), 0..9), 0..9),
        size in 1..400usize,
    ) {
        let list = |list: &Vec<prop::sample::Index>| {
            Tag::List(list.iter().map(|at| Tag::Compound(at.get(&kinds).clone())).collect())
        };
        let tags: Compound = lists.iter().enumerate().map(|(at, each)| (at.to_string(), list(each))).collect();
        let bytes = nbt::write("", &tags).unwrap();
        let pieces = BufReader::with_capacity(size, &bytes[..]);
        let (_, back, end) = nbt::read_from(pieces, Endian::Big, &Limits::default(), &mut ()).unwrap();
        prop_assert_eq!((back, end), (tags, bytes.len() as u64));
    }

    #[test]
    fn fastnbt_reads_the_same(tags in compound()) {
        let bytes = nbt::write("root", &tags).unwrap();
        let found: HashMap<String, fastnbt::Value> = fastnbt::from_bytes(&bytes).unwrap();
        prop_assert_eq!(found, second_opinions(&tags));
    }

    #[test]
    fn what_fastnbt_writes_is_read(tags in compound()) {
        let bytes = fastnbt::to_bytes(&second_opinions(&tags)).unwrap();
        prop_assert_eq!(read(&bytes).unwrap().1, tags);
    }

    #[test]
    fn any_bytes_are_read_or_refused(bytes: Vec<u8>) {
        let _ = read(&bytes);
        let _ = read(&[&[10, 0, 0], &bytes[..]].concat());
    }

    #[test]
    fn damaged_bytes_are_read_or_refused(tags in compound(), at: prop::sample::Index, byte: u8) {
        let mut bytes = nbt::write("", &tags).unwrap();
        let at = at.index(bytes.len());
        bytes[at] = byte;
        let _ = read(&bytes);
    }

    #[test]
    fn every_truncation_is_refused(tags in compound()) {
        let bytes = nbt::write("", &tags).unwrap();
        for len in 0..bytes.len() {
            prop_assert!(read(&bytes[..len]).is_err());
        }
    }
}

/// Bytes after the head of a nameless root, the path of the broken tag, and the message.
const REFUSED: [(&str, &[u8], &str); 10] = [
    ("root list", &[9, 0, 0], "byte 0: expected a compound (tag type 10) at the root, found tag type 9"),
    ("no tag type", &[10, 0, 0, 13, 0, 1, b'a'], "byte 7, in `a`: there is no tag type 13: expected 1 to 12"),
    ("no entry type", &[10, 0, 0, 9, 0, 1, b'a', 99, 0, 0, 0, 1], "byte 8, in `a`: there is no tag type 99"),
    (
        "untyped list",
        &[10, 0, 0, 9, 0, 1, b'a', 0, 0, 0, 0, 9],
        "byte 12, in `a`: a list of 9 entries has no entry type",
    ),
    (
        "negative length",
        &[10, 0, 0, 7, 0, 1, b'a', 0xff, 0xff, 0xff, 0xff],
        "byte 11, in `a`: a Byte Array has the negative length -1",
    ),
    (
        "huge array",
        &[10, 0, 0, 12, 0, 1, b'a', 0x7f, 0xff, 0xff, 0xff],
        "byte 11, in `a`: a Long Array takes 17179869176 bytes, but only 0 are left",
    ),
    (
        "huge list",
        &[10, 0, 0, 9, 0, 1, b'a', 10, 0x7f, 0xff, 0xff, 0xff, 0],
        "byte 13, in `a[1]`: a Compound takes 1 bytes, but only 0 are left",
    ),
    (
        "within a list",
        &[10, 0, 0, 9, 0, 1, b'a', 10, 0, 0, 0, 2, 0, 1, 0, 1, b'b'],
        "byte 17, in `a[1].b`: a Byte takes 1 bytes, but only 0 are left",
    ),
    (
        "no text",
        &[10, 0, 0, 8, 0, 1, b'a', 0, 1, 0xff, 0],
        "byte 7, in `a`: the text is not UTF-8, neither plain nor in the modified form of Java",
    ),
    ("trailing", &[10, 0, 0, 0, 7, 7], "byte 4: 2 bytes follow after the end of the root compound"),
];

#[test]
fn refusals_say_what_and_where() {
    for (name, bytes, message) in REFUSED {
        let found = read(bytes).unwrap_err().to_string();
        assert!(found.starts_with(&format!("broken NBT at {message}")), "{name}: {found}");
    }
}

#[test]
fn deep_nesting_is_refused_and_not_followed() {
    let lists = [9, 0, 0, 0, 1].repeat(20_000);
    let bytes = [&[10, 0, 0, 9, 0, 1, b'a'], &lists[..]].concat();
    assert!(matches!(read(&bytes).unwrap_err().problem, NbtProblem::TooDeep(512)));
}

#[test]
fn as_deep_as_the_game_goes() {
    let deep = (1..512).fold(Compound::new(), |inner, _| Compound::from([("a", Tag::Compound(inner))]));
    let bytes = nbt::write("", &deep).unwrap();
    assert_eq!(read(&bytes).unwrap().1, deep);
    let deeper = nbt::write("", &Compound::from([("a", Tag::Compound(deep))])).unwrap();
    assert!(matches!(read(&deeper).unwrap_err().problem, NbtProblem::TooDeep(512)));
}

#[test]
fn what_came_before_is_refused_where_it_stands_too_deep() {
    let item = || Tag::List(vec![Tag::Compound(Compound::from([("Slot", Tag::Byte(1))]))]);
    let inner = Tag::Compound(Compound::from([("Items", item())]));
    let tags = Compound::from([("a", item()), ("b", inner)]);
    let bytes = nbt::write("", &tags).unwrap();
    let within = |max_depth| nbt::read(&bytes, &Limits { max_depth, ..Limits::default() });
    assert_eq!(within(4).unwrap().1, tags);
    assert!(matches!(within(3).unwrap_err().problem, NbtProblem::TooDeep(3)));
}

#[test]
fn memory_is_bounded_where_compounds_come_again() {
    let item = Tag::Compound(Compound::from([("Slot", Tag::Byte(1))]));
    let bytes = nbt::write("", &Compound::from([("Items", Tag::List(vec![item; 1000]))])).unwrap();
    let limits = Limits { max_memory: 100_000, ..Limits::default() };
    assert!(matches!(nbt::read(&bytes, &limits).unwrap_err().problem, NbtProblem::TooLarge(100_000)));
}

#[test]
fn memory_is_bounded_where_tags_outgrow_their_bytes() {
    let tags = Compound::from([("a", Tag::List(vec![Tag::Byte(0); 10_000]))]);
    let bytes = nbt::write("", &tags).unwrap();
    let limits = Limits { max_memory: 100_000, ..Limits::default() };
    let error = nbt::read(&bytes, &limits).unwrap_err();
    assert!(matches!(error.problem, NbtProblem::TooLarge(100_000)), "{error}");
    assert!(read(&bytes).is_ok());
}

#[test]
fn texts_in_either_form_of_utf8() {
    let java = [10, 0, 0, 8, 0, 1, b'a', 0, 6, 0xed, 0xa0, 0xbd, 0xed, 0xb8, 0x80, 0];
    let plain = [10, 0, 0, 8, 0, 1, b'a', 0, 4, 0xf0, 0x9f, 0x98, 0x80, 0];
    let smile = Compound::from([("a", Tag::String("😀".into()))]);
    assert_eq!(read(&java).unwrap().1, smile);
    assert_eq!(read(&plain).unwrap().1, smile);
    assert_eq!(nbt::write("", &smile).unwrap(), java);
}

#[test]
fn trees_without_a_binary_form() {
    let cases = [
        (Tag::String("a".repeat(65_536)), "a text of 65536 bytes is too long for NBT: at most 65,535"),
        (
            Tag::List(vec![Tag::Byte(0), Tag::Int(0)]),
            "a list holds both a Byte and an Int: NBT lists hold one type",
        ),
    ];
    for (tag, expected) in cases {
        let error = nbt::write("", &Compound::from([("a", tag)])).unwrap_err();
        assert_eq!(error.to_string(), expected);
    }
}

/// Takes the arrays of some paths, and gives them.
#[derive(Default, PartialEq, Debug)]
struct Arrays(Vec<(String, Vec<u8>)>);

impl Sink for Arrays {
    fn wants(&mut self, path: &str, _: usize) -> bool {
        let wanted = path == "Blocks.Data";
        if wanted {
            self.0.push((path.to_owned(), Vec::new()));
        }
        wanted
    }

    fn take(&mut self, bytes: &[u8]) {
        self.0.last_mut().unwrap().1.extend(bytes);
    }
}

impl Source for Arrays {
    fn len(&self, path: &str) -> Option<usize> {
        self.0.iter().find(|(name, _)| name == path).map(|(_, bytes)| bytes.len())
    }

    fn write(&self, path: &str, out: &mut dyn Write) -> io::Result<()> {
        self.0.iter().filter(|(name, _)| name == path).try_for_each(|(_, bytes)| out.write_all(bytes))
    }
}

fn nested(data: Vec<i8>) -> Compound {
    let tags = |tags: Vec<(&str, Tag)>| tags.into_iter().map(|(name, tag)| (name.to_owned(), tag)).collect();
    let list = vec![Tag::Compound(tags(vec![("Data", Tag::ByteArray(vec![7]))]))];
    let blocks = tags(vec![("Data", Tag::ByteArray(data)), ("Other", Tag::ByteArray(vec![8]))]);
    tags(vec![("Blocks", Tag::Compound(blocks)), ("x.Data", Tag::Int(1)), ("List", Tag::List(list))])
}

#[test]
fn long_arrays_pass_by_the_tree() {
    let bytes = nbt::write("", &nested(vec![1; 20_000])).unwrap();
    let mut arrays = Arrays::default();
    let limits = Limits { max_memory: 9_000, ..Limits::default() };
    let (_, root, _) = nbt::read_from(&bytes[..], Endian::Big, &limits, &mut arrays).unwrap();
    assert_eq!(root, nested(Vec::new()), "an empty array in its place");
    assert_eq!(arrays, Arrays(vec![("Blocks.Data".to_owned(), vec![1; 20_000])]));
    let mut back = Vec::new();
    nbt::write_to(&mut back, Endian::Big, "", &root, &arrays).unwrap();
    assert_eq!(back, bytes);
}

#[test]
fn arrays_that_break_off_say_so() {
    let bytes = nbt::write("", &nested(vec![1; 20_000])).unwrap();
    let error = nbt::read_from(&bytes[..10_000], Endian::Big, &Limits::default(), &mut Arrays::default());
    let message =
        "broken NBT at byte 23, in `Blocks.Data`: a Byte Array takes 20000 bytes, but only 9977 are left";
    assert_eq!(error.unwrap_err().to_string(), message);
    assert_eq!(read(&bytes[..10_000]).unwrap_err().to_string(), message);
}

#[test]
fn names_that_look_like_paths_are_quoted() {
    let bytes = [10, 0, 0, 1, 0, 3, b'a', b'.', b'b'];
    let message = "broken NBT at byte 9, in `\"a.b\"`: a Byte takes 1 bytes, but only 0 are left";
    assert_eq!(read(&bytes).unwrap_err().to_string(), message);
}

#[test]
fn sources_keep_to_what_they_announce() {
    struct Short;
    impl Source for Short {
        fn len(&self, path: &str) -> Option<usize> {
            (path == "Blocks.Data").then_some(3)
        }

        fn write(&self, _: &str, out: &mut dyn Write) -> io::Result<()> {
            out.write_all(&[1, 2])
        }
    }
    let error = nbt::write_to(Vec::new(), Endian::Big, "", &nested(Vec::new()), &Short).unwrap_err();
    assert!(matches!(error, WriteError::Announced { said: 3, found: 2, .. }), "{error}");
}
