//! How long it takes to learn facades, and how short their rules are: of the layouts of seed 4 beside the rules that its
//! tool derived, and of random and regular ones of growing size.
//!
//!     cargo bench --bench facades
//!
//! Bits are of splits and repeats before they learn to stretch, the same for all (`facade/rules.rs`).

mod common {
    pub mod table;
}
#[path = "../tests/common/layouts.rs"]
mod layouts;
#[path = "../tests/common/real.rs"]
mod real;
#[path = "../tests/common/seed4.rs"]
mod seed4;

use common::table::{self, mean};
use std::fs;
use std::path::Path;
use std::time::Instant;
use vox::facade::{Drawing, Facade, Method, Options, infer};
use vox::io::{Limits, decode_layout};

/// Layouts and the rules that the tool of seed 4 derived of them.
const REAL: [(&str, Option<&str>); 4] = [
    ("Layout", Some("Layout.txt")),
    ("NR07031_basic", Some("NR07031.txt")),
    ("LayoutCut", None),
    ("high_rise", None),
];
const LEAVES: [usize; 5] = [50, 100, 200, 400, 800];
const ROWS: [[usize; 2]; 4] = [[4, 4], [8, 8], [16, 16], [32, 32]];

fn main() {
    real_layouts();
    let random = LEAVES.map(|leaves| (format!("random {leaves}"), layouts::layout(leaves, 1)));
    let rows = ROWS.map(|[across, up]| (format!("{across} x {up} windows"), layouts::rows(across, up)));
    let lines = random.into_iter().chain(rows).map(|(name, drawing)| line(name, &drawing, None));
    table::print(&HEAD, &lines.collect::<Vec<_>>());
    let ratio = |seed| {
        let drawing = layouts::layout(100, seed);
        learnt(&drawing, Method::Searched).rules.length() / learnt(&drawing, Method::Greedy).rules.length()
    };
    println!("\nsearched to greedy, bits of 20 random layouts: {:.3}", mean((1..=20).map(ratio)));
}

fn learnt(drawing: &Drawing, method: Method) -> Facade {
    let options = Options { method, ..Options::default() };
    infer(std::slice::from_ref(drawing), &options).unwrap().facades.remove(0)
}

const HEAD: [&str; 10] =
    ["layout", "leaves", "names", "structures", "groups", "greedy", "searched", "seed 4", "bits", "ms"];

fn real_layouts() {
    // It says so where there are none.
    let Some(folder) = real::folder().map(|folder| folder.join("facades")) else { return };
    let line = |(name, theirs): &(&str, Option<&str>)| {
        let bytes = fs::read(folder.join(format!("{name}.xml"))).unwrap();
        let drawing = decode_layout(&bytes, None, &|_| false, &Limits::default()).unwrap();
        line((*name).to_owned(), &drawing, theirs.map(|theirs| folder.join(theirs)).as_deref())
    };
    table::print(&HEAD, &REAL.iter().map(line).collect::<Vec<_>>());
    println!();
}

fn line(name: String, drawing: &Drawing, theirs: Option<&Path>) -> Vec<String> {
    let greedy = learnt(drawing, Method::Greedy);
    let start = Instant::now();
    let searched = learnt(drawing, Method::Searched);
    let time = start.elapsed();
    let theirs = theirs.map(|path| seed4::rules(&fs::read_to_string(path).unwrap()));
    let rules = |facade: &Facade| facade.rules.list.len().to_string();
    let length = |facade: &Facade| format!("{:.0}", facade.rules.length());
    let other = |told: &dyn Fn(&vox::facade::Rules) -> String| theirs.as_ref().map_or("-".to_owned(), told);
    vec![
        name,
        drawing.areas.len().to_string(),
        searched.layout.labels().len().to_string(),
        searched.counts.structures.to_string(),
        searched.counts.groups.to_string(),
        rules(&greedy),
        rules(&searched),
        other(&|rules| rules.list.len().to_string()),
        format!(
            "{} {} {}",
            length(&greedy),
            length(&searched),
            other(&|rules| format!("{:.0}", rules.length()))
        ),
        format!("{:.0}", time.as_secs_f64() * 1000.0),
    ]
}
