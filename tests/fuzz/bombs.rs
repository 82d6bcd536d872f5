//! Files that ask for more than they have.

use super::examples::{axiom, magica, mcedit, region, tags};
use super::{bytes, check, read};
use vox::nbt::{self, Compound, Tag};

fn compound(tags: Vec<(&str, Tag)>) -> Compound {
    tags.into_iter().map(|(name, tag)| (name.to_owned(), tag)).collect()
}

fn text(text: &str) -> Tag {
    Tag::String(text.to_owned())
}

fn ints<const N: usize>(numbers: [i32; N]) -> Tag {
    Tag::List(numbers.map(Tag::Int).to_vec())
}

fn state(name: &str) -> Tag {
    Tag::Compound(tags([("Name", text(name))]))
}

/// A schematic of one block with `tags` beside.
fn schem(tags: Vec<(&str, Tag)>) -> Vec<u8> {
    let palette = compound(vec![("air", Tag::Int(0))]);
    let mut root = compound(vec![
        ("Width", Tag::Short(1)),
        ("Height", Tag::Short(1)),
        ("Length", Tag::Short(1)),
        ("Palette", Tag::Compound(palette)),
        ("BlockData", Tag::ByteArray(vec![0])),
    ]);
    root.extend(compound(tags));
    nbt::write("Schematic", &root).unwrap()
}

/// A schematic that breaks off within an array that announces all that can be announced.
fn announcing(kind: u8, name: &str) -> Vec<u8> {
    let mut bytes = schem(vec![]);
    bytes.pop();
    bytes.extend([kind, 0, name.len() as u8]);
    bytes.extend(name.bytes());
    bytes.extend(if kind == 9 { vec![10] } else { vec![] });
    bytes.extend(i32::MAX.to_be_bytes());
    bytes.extend([0; 99]);
    bytes
}

fn schem_cases() -> Vec<(&'static str, Vec<u8>)> {
    let list = |entry: Tag, count| schem(vec![("List", Tag::List(vec![entry; count]))]);
    let one = || compound(vec![("", Tag::Byte(0))]);
    let chest = || compound(vec![("Pos", Tag::IntArray(vec![0, 0, 0])), ("id", Tag::String(String::new()))]);
    let properties: Vec<String> = (0..7_000).map(|n| format!("{n}=")).collect();
    let states = (0..3).map(|n| (format!("a{n}[{}]", properties.join(",")), Tag::Int(n)));
    let long = |len| schem(vec![("Width", Tag::Short(-1)), ("BlockData", Tag::ByteArray(vec![0; len]))]);
    vec![
        ("a long array", long(1 << 18)),
        ("an endless array", bytes::packed(&long(1 << 24))),
        ("zeros", bytes::packed(&bytes::packed(&vec![0; 1 << 26]))),
        ("lists", list(Tag::List(vec![]), 1 << 15)),
        ("bytes in a list", list(Tag::Byte(0), 1 << 17)),
        ("compounds", list(Tag::Compound(one()), 1 << 15)),
        ("block entities", schem(vec![("BlockEntities", Tag::List(vec![Tag::Compound(chest()); 300]))])),
        ("long states", schem(vec![("Palette", Tag::Compound(states.collect()))])),
        ("many blocks announced", announcing(7, "BlockData")),
        ("many bytes announced", announcing(7, "Bytes")),
        ("many numbers announced", announcing(12, "Longs")),
        ("many compounds announced", announcing(9, "List")),
    ]
}

/// A structure of one block, or of `size`, with data and `palettes` of one state each.
fn structure(size: [i32; 3], data: Compound, palettes: usize) -> Vec<u8> {
    let block = tags([("pos", ints([0; 3])), ("state", Tag::Int(0)), ("nbt", Tag::Compound(data))]);
    let palette = Tag::List(vec![state("stone")]);
    let root = tags([
        ("size", ints(size)),
        ("palettes", Tag::List(vec![palette; palettes])),
        ("blocks", Tag::List(vec![Tag::Compound(block)])),
    ]);
    nbt::write("", &root).unwrap()
}

fn structure_cases() -> Vec<(&'static str, Vec<u8>)> {
    let none = Compound::new;
    vec![
        ("a structure of a large size", structure([i32::MAX; 3], none(), 1)),
        ("a structure of as many cells as allowed", structure([1 << 16, 1, 1], none(), 1)),
        ("many palettes of many cells", structure([1 << 10, 1, 1], none(), 65)),
        (
            "many palettes of a block with long data",
            structure([1; 3], tags([("a", Tag::ByteArray(vec![0; 99_999]))]), 99),
        ),
        ("many palettes of a block with many data", {
            let data = Tag::List(vec![Tag::Compound(tags([("", Tag::Byte(0))])); 99]);
            structure([1; 3], tags([("a", data)]), 99)
        }),
    ]
}

/// A region of a litematic, of one block of stone.
fn part(place: i32, size: [i32; 3], words: usize, more: Vec<(&str, Tag)>) -> Tag {
    let place = tags(["x", "y", "z"].map(|axis| (axis, Tag::Int(place))));
    let size = ["x", "y", "z"].into_iter().zip(size.map(Tag::Int)).collect();
    let mut part = tags([
        ("Position", Tag::Compound(place)),
        ("Size", Tag::Compound(compound(size))),
        ("BlockStatePalette", Tag::List(vec![state("minecraft:air"), state("minecraft:stone")])),
        ("BlockStates", Tag::LongArray(vec![1; words])),
    ]);
    part.extend(compound(more));
    Tag::Compound(part)
}

fn litematic(parts: Vec<(&str, Tag)>) -> Vec<u8> {
    let root = tags([("Version", Tag::Int(6)), ("Regions", Tag::Compound(compound(parts)))]);
    nbt::write("", &root).unwrap()
}

fn litematic_cases() -> Vec<(&'static str, Vec<u8>)> {
    let one = |place| part(place, [1; 3], 1, vec![]);
    let whole = || part(0, [1 << 6, 1 << 5, 1 << 5], 1 << 11, vec![]);
    let names: Vec<String> = (0..10).map(|n| n.to_string()).collect();
    let long = "n".repeat(50_000);
    let empty = || Tag::List(vec![Tag::Compound(Compound::new()); 999]);
    vec![
        ("regions far apart", litematic(vec![("a", one(0)), ("b", one(i32::MAX - 1))])),
        ("a region of a large size", litematic(vec![("a", part(0, [i32::MAX; 3], 9, vec![]))])),
        ("regions that overlap", litematic(names.iter().map(|name| (name.as_str(), whole())).collect())),
        (
            "a region with a long name",
            litematic(vec![(&long, part(0, [1; 3], 1, vec![("TileEntities", empty())]))]),
        ),
    ]
}

/// A chunk of `count` sections, whose numbers take eight times their bytes.
fn chunk(count: usize) -> Compound {
    let states = tags([("palette", Tag::List(vec![state("stone")])), ("data", Tag::LongArray(vec![0; 256]))]);
    let section = tags([("Y", Tag::Byte(0)), ("block_states", Tag::Compound(states))]);
    tags([
        ("xPos", Tag::Int(0)),
        ("zPos", Tag::Int(0)),
        ("sections", Tag::List(vec![Tag::Compound(section); count])),
    ])
}

/// A region all of whose entries point to the same chunk.
fn shared(kind: u8, chunk: &Compound) -> Vec<u8> {
    let mut bytes = region::region(&[([0, 0], chunk)], kind);
    (1..1024).for_each(|slot| bytes.copy_within(0..4, 4 * slot));
    bytes
}

/// A block of LZ4 that says it unpacks to `plain` bytes.
fn lz4(plain: u32) -> Vec<u8> {
    let packed = [0xff; 2000];
    let numbers = [packed.len() as u32, plain, 0].map(u32::to_le_bytes).concat();
    let content = [&[4], &b"LZ4Block\x20"[..], &numbers, &packed].concat();
    let mut bytes = region::region(&[([0, 0], &chunk(1))], 3);
    bytes.splice(8192.., [&(content.len() as u32).to_be_bytes(), &content[..]].concat());
    bytes
}

fn region_cases() -> Vec<(&'static str, Vec<u8>)> {
    let zeros = || chunk(1).into_iter().chain(tags([("a", Tag::ByteArray(vec![0; 1 << 24]))])).collect();
    vec![
        ("chunks that share their sectors", shared(2, &chunk(1))),
        ("a chunk of the same section many times", region::region(&[([0, 0], &chunk(50))], 2)),
        ("zeros in gzip", shared(1, &zeros())),
        ("zeros in zlib", shared(2, &zeros())),
        ("zeros in LZ4", shared(4, &zeros())),
        ("LZ4 of a large size", lz4(u32::MAX)),
        ("LZ4 of as large a size as its bytes make", lz4(500_000)),
    ]
}

/// A scene of 2 to the `depth` times the same model.
fn doubled(depth: i32) -> Vec<u8> {
    let pair =
        |n: i32| [magica::transform(2 * n, &[], &[]), magica::group(2 * n + 1, &[2 * n + 2; 2])].concat();
    let mut chunks = vec![magica::model([1; 3], &[[0, 0, 0, 1]])];
    chunks.extend((0..depth).map(pair));
    chunks.extend([magica::transform(2 * depth, &[], &[]), magica::shape(2 * depth + 1, 0)]);
    magica::file(&chunks)
}

fn magica_cases() -> Vec<(&'static str, Vec<u8>)> {
    let one = || magica::model([1; 3], &[[0, 0, 0, 1]]);
    let apart = |by| magica::transform(0, &[], &[("_t", by)]);
    let cases = [
        ("models of a large size", vec![magica::model([i32::MAX; 3], &[])]),
        ("the largest model", vec![magica::model([256; 3], &[])]),
        ("a scene that holds itself", vec![one(), magica::group(0, &[0])]),
        ("a scene that holds itself often", vec![one(), magica::group(0, &[0; 9999])]),
        (
            "a group of the same model many times",
            vec![one(), magica::group(0, &[1; 60_000]), magica::shape(1, 0)],
        ),
        ("a model far away", vec![one(), apart("2147483647 0 0"), magica::shape(1, 0)]),
        ("many nodes with attributes of no bytes", {
            let node = |n| magica::transform(n, &[("", "")], &[("", "")]);
            std::iter::once(one()).chain((0..3500).map(node)).collect()
        }),
    ];
    let mut files: Vec<_> = cases.map(|(name, chunks)| (name, magica::file(&chunks))).into();
    files.extend([("a scene that doubles", doubled(12)), ("a scene that doubles too often", doubled(40))]);
    files
}

fn other_cases() -> Vec<(&'static str, Vec<u8>)> {
    let sections = |count| {
        let section = axiom::section([0; 3], &["minecraft:stone"], &[]);
        axiom::file(&axiom::header(), b"", &axiom::blocks(vec![section; count]))
    };
    let wide = mcedit::with(
        mcedit::row(&[(1, 0)]),
        ["Width", "Height", "Length"].map(|side| (side, Tag::Short(-1))),
    );
    vec![
        ("as many sections as allowed", sections(16)),
        ("more sections than allowed", sections(99)),
        ("a schematic of numbers, of a large size", mcedit::file(&wide)),
    ]
}

#[test]
fn bombs_keep_to_the_limits() {
    let cases =
        [schem_cases(), structure_cases(), litematic_cases(), region_cases(), magica_cases(), other_cases()];
    for (name, file) in cases.concat() {
        for file in [bytes::packed(&file), file] {
            match check(&file, read) {
                Ok(checked) => {
                    println!("{name}: {} bytes of memory, {:.1?}", checked.used, checked.time);
                }
                Err(problem) => panic!("{name}: {problem}"),
            }
        }
    }
}
