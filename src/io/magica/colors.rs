//! Colours and palettes of them.

use std::collections::BTreeMap;

/// The colour number 0 is no voxel, so a palette has room for so many.
pub(super) const MOST_COLORS: usize = 255;

/// How different two colours look: the distance in red, green and blue, where red counts more between light colours
/// and blue between dark ones.
fn difference(a: [u8; 3], b: [u8; 3]) -> i32 {
    let [red, green, blue] = [0, 1, 2].map(|i| i32::from(a[i]) - i32::from(b[i]));
    let mean = (i32::from(a[0]) + i32::from(b[0])) / 2;
    ((512 + mean) * red * red + 1024 * green * green + (767 - mean) * blue * blue) / 256
}

/// The place of the colour nearest to `rgb`, the first of equally near ones.
pub(super) fn nearest(rgb: [u8; 3], colors: &[[u8; 3]]) -> Option<usize> {
    (0..colors.len()).min_by_key(|&at| difference(rgb, colors[at]))
}

/// The colours of a palette, and the place in it for each of `counts`, which says how often each is used: as many as a
/// palette holds, the most used ones if need be.
pub(super) fn reduce(counts: &BTreeMap<[u8; 4], usize>) -> (Vec<[u8; 4]>, BTreeMap<[u8; 4], usize>) {
    let mut colors: Vec<[u8; 4]> = counts.keys().copied().collect();
    if colors.len() > MOST_COLORS {
        colors.sort_by_key(|color| std::cmp::Reverse(counts[color]));
        colors.truncate(MOST_COLORS);
        colors.sort_unstable();
    }
    let opaque: Vec<[u8; 3]> = colors.iter().map(|&color| without_alpha(color)).collect();
    let place = |color: &[u8; 4]| {
        colors
            .binary_search(color)
            .ok()
            .or_else(|| nearest(without_alpha(*color), &opaque))
            .unwrap_or_default()
    };
    let places = counts.keys().map(|color| (*color, place(color))).collect();
    (colors, places)
}

pub(super) fn without_alpha([red, green, blue, _]: [u8; 4]) -> [u8; 3] {
    [red, green, blue]
}

/// The palette of files that have none: a cube of six steps along red, green and blue, and then ten steps
/// each of red, green, blue and gray.
pub(super) fn default_palette() -> Vec<[u8; 4]> {
    let step = |n: usize| 0xff - 0x33 * n as u8;
    let cube = (0..215).map(|n| [step(n / 36), step(n / 6 % 6), step(n % 6), 0xff]);
    let ramp = [0xee, 0xdd, 0xbb, 0xaa, 0x88, 0x77, 0x55, 0x44, 0x22, 0x11];
    let ramps = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]];
    let ramps = ramps.into_iter().flat_map(|[red, green, blue]| {
        ramp.into_iter().map(move |light| [red * light, green * light, blue * light, 0xff])
    });
    cube.chain(ramps).collect()
}
