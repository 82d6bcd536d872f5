use crate::space::Cell;
use std::str::FromStr;

/// A size on the command line: `9x7x12`, along x, y and z.
#[derive(Clone, Copy, Debug)]
pub struct SizeArg(pub Cell);

impl FromStr for SizeArg {
    type Err = String;

    fn from_str(text: &str) -> Result<SizeArg, String> {
        let lengths: Option<Vec<i32>> =
            text.split(['x', 'X']).map(|length| length.trim().parse().ok()).collect();
        match lengths.as_deref() {
            Some(&[x, y, z]) if x > 0 && y > 0 && z > 0 => Ok(SizeArg(Cell::new(x, y, z))),
            _ => Err("expected three lengths of 1 or more, as in 9x7x12".to_owned()),
        }
    }
}
