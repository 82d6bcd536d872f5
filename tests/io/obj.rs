use super::read;
use proptest::collection::vec;
use proptest::prelude::*;
use std::fs;
use std::path::{Path, PathBuf};
use vox::grid::{LabelledBox, LabelledBoxes};
use vox::io::{Content, Scale, decode_obj_boxes, encode_obj_boxes};
use vox::space::{Bounds, Cell};

fn labelled_box() -> impl Strategy<Value = LabelledBox> {
    let corner = [-1000..1000i32, -1000..1000i32, -1000..1000i32];
    let size = [1..50i32, 1..50i32, 1..50i32];
    ("[a-z_][a-z0-9_.:]{0,9}", corner, size).prop_map(|(label, min, size)| {
        let min = Cell::from_array(min);
        LabelledBox { label, bounds: Bounds::new(min, min + Cell::from_array(size)) }
    })
}

proptest! {
    #[test]
    fn boxes_come_back(boxes in vec(labelled_box(), 1..9)) {
        let text = encode_obj_boxes(&boxes);
        let back = decode_obj_boxes(text.as_bytes(), Scale::default()).unwrap();
        prop_assert_eq!(Some(back), LabelledBoxes::new(boxes));
    }

    #[test]
    fn any_text_is_read_or_refused(text in "([vfog] [-0-9./ e]{0,9}\r?\n?){0,9}") {
        let _ = decode_obj_boxes(text.as_bytes(), Scale::default());
    }

    #[test]
    fn any_bytes_are_read_or_refused(bytes: Vec<u8>) {
        let _ = decode_obj_boxes(&bytes, Scale::default());
    }
}

fn cases(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/obj").join(folder);
    let mut cases: Vec<PathBuf> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    cases.retain(|path| path.extension().is_some_and(|extension| extension == "obj"));
    cases.sort();
    assert!(!cases.is_empty());
    cases
}

/// A case says its scale in its name: `thesis.x3.obj`.
fn scale(path: &Path) -> Scale {
    let stem = path.file_stem().unwrap().to_str().unwrap();
    let scale = stem.rsplit_once(".x").map_or(1.0, |(_, scale)| scale.parse().unwrap());
    Scale::new(scale).unwrap()
}

fn describe(boxes: &LabelledBoxes) -> String {
    let line = |labelled: &LabelledBox| {
        let Bounds { min, max } = labelled.bounds;
        format!("{} {min} {max}\n", labelled.label)
    };
    boxes.boxes.iter().map(line).collect()
}

#[test]
fn files_of_boxes_are_read() {
    for path in cases("ok") {
        let boxes = decode_obj_boxes(&fs::read(&path).unwrap(), scale(&path))
            .unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let expected = fs::read_to_string(path.with_extension("txt")).unwrap();
        assert_eq!(describe(&boxes), expected, "{}", path.display());
    }
}

#[test]
fn refusals_name_the_line() {
    for path in cases("err") {
        let expected = fs::read_to_string(path.with_extension("txt")).unwrap();
        match decode_obj_boxes(&fs::read(&path).unwrap(), scale(&path)) {
            Ok(_) => panic!("{} is taken", path.display()),
            Err(error) => assert_eq!(error.to_string(), expected.trim_end(), "{}", path.display()),
        }
    }
}

#[test]
fn boxes_are_known_by_content() {
    let boxes = [LabelledBox { label: "wall".into(), bounds: Bounds::of_size(Cell::new(3, 2, 1)) }];
    match read(encode_obj_boxes(&boxes).as_bytes()).unwrap().content {
        Content::Boxes(found) => assert_eq!(found.boxes, boxes),
        Content::Grid(_) => panic!("expected boxes"),
    }
}

#[test]
fn labels_stay_on_their_line() {
    let labelled = LabelledBox { label: "my #1\nwall".into(), bounds: Bounds::of_size(Cell::ONE) };
    let back = decode_obj_boxes(encode_obj_boxes(&[labelled]).as_bytes(), Scale::default()).unwrap();
    assert_eq!(back.boxes[0].label, "my__1_wall");
}
