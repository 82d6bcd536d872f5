//! Tables on standard output.

/// Prints lines of cells below one another, numbers to the right.
pub fn print(head: &[&str], lines: &[Vec<String>]) {
    let width = |column: usize| {
        let cells = lines.iter().map(|line| line[column].len());
        cells.chain([head[column].len()]).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..head.len()).map(width).collect();
    let line = |cells: &mut dyn Iterator<Item = &str>| {
        let padded = cells.zip(&widths).enumerate().map(|(at, (cell, width))| match at {
            0 => format!("{cell:<width$}"),
            _ => format!("{cell:>width$}"),
        });
        println!("{}", padded.collect::<Vec<String>>().join("  ").trim_end());
    };
    line(&mut head.iter().copied());
    for cells in lines {
        line(&mut cells.iter().map(String::as_str));
    }
}

/// The mean of numbers; zero of none.
pub fn mean(numbers: impl IntoIterator<Item = f64>) -> f64 {
    let (sum, count) = numbers.into_iter().fold((0.0, 0.0), |(sum, count), n| (sum + n, count + 1.0));
    if count == 0.0 { 0.0 } else { sum / count }
}
