//! Models of MagicaVoxel.

pub fn chunk(name: &str, content: &[u8]) -> Vec<u8> {
    [name.as_bytes(), &(content.len() as u32).to_le_bytes(), &[0; 4], content].concat()
}

pub fn file(chunks: &[Vec<u8>]) -> Vec<u8> {
    let content = chunks.concat();
    let head = [&b"VOX \x96\0\0\0MAIN\0\0\0\0"[..], &(content.len() as u32).to_le_bytes()].concat();
    [head, content].concat()
}

pub fn numbers(numbers: &[i32]) -> Vec<u8> {
    numbers.iter().flat_map(|n| n.to_le_bytes()).collect()
}

pub fn dictionary(entries: &[(&str, &str)]) -> Vec<u8> {
    let text = |text: &str| [&numbers(&[text.len() as i32])[..], text.as_bytes()].concat();
    let words = entries.iter().flat_map(|(key, value)| [text(key), text(value)]);
    std::iter::once(numbers(&[entries.len() as i32])).chain(words).collect::<Vec<_>>().concat()
}

pub fn model(size: [i32; 3], voxels: &[[u8; 4]]) -> Vec<u8> {
    let content = [&numbers(&[voxels.len() as i32])[..], &voxels.concat()].concat();
    [chunk("SIZE", &numbers(&size)), chunk("XYZI", &content)].concat()
}

pub fn transform(node: i32, attributes: &[(&str, &str)], frame: &[(&str, &str)]) -> Vec<u8> {
    let content =
        [numbers(&[node]), dictionary(attributes), numbers(&[node + 1, -1, 0, 1]), dictionary(frame)]
            .concat();
    chunk("nTRN", &content)
}

pub fn group(node: i32, children: &[i32]) -> Vec<u8> {
    chunk("nGRP", &[numbers(&[node, 0, children.len() as i32]), numbers(children)].concat())
}

pub fn shape(node: i32, model: i32) -> Vec<u8> {
    chunk("nSHP", &numbers(&[node, 0, 1, model, 0]))
}

pub fn colors(colors: &[[u8; 3]]) -> Vec<u8> {
    let mut entries: Vec<u8> = colors.iter().flat_map(|&[r, g, b]| [r, g, b, 255]).collect();
    entries.resize(1024, 0);
    chunk("RGBA", &entries)
}

pub const WHITE: [u8; 3] = [0xeb; 3];
pub const GOLD: [u8; 3] = [0xf7, 0xd2, 0x3f];

/// A block, and beside it a bar that is turned from x to y.
pub fn scene() -> Vec<u8> {
    file(&[
        model([1, 1, 1], &[[0, 0, 0, 1]]),
        model([3, 1, 1], &[[0, 0, 0, 2], [1, 0, 0, 1], [2, 0, 0, 1]]),
        transform(0, &[], &[]),
        group(1, &[2, 4, 6]),
        transform(2, &[("_name", "block")], &[]),
        shape(3, 0),
        transform(4, &[], &[("_r", "17"), ("_t", "10 0 0")]),
        shape(5, 1),
        transform(6, &[("_hidden", "1")], &[("_t", "99 99 99")]),
        shape(7, 1),
        chunk("NOTE", b"whatever"),
        colors(&[WHITE, GOLD]),
    ])
}
