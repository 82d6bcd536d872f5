//! Damage to the tags of a file, which stays well-formed NBT and so reaches the reader of its format.

use rand::RngExt;
use rand::seq::IndexedRandom;
use rand_pcg::Pcg32;
use vox::nbt::{Compound, Endian, Limits, Tag, read_as, write_as};

/// One to four changes to the tags of `plain`; `None` where it is no NBT.
pub fn damage(plain: &[u8], rng: &mut Pcg32) -> Option<Vec<u8>> {
    let orders = [Endian::Big, Endian::Little].into_iter();
    let mut trees =
        orders.filter_map(|endian| Some((endian, read_as(endian, plain, &Limits::default()).ok()?)));
    let (endian, (name, mut root)) = trees.next()?;
    let mut values = Vec::new();
    collect(&root, &mut values);
    for _ in 0..rng.random_range(1..=4) {
        change(&mut root, &values, rng);
    }
    write_as(endian, &name, &root).ok()
}

/// All values of a tree, to be put where others stood.
fn collect(tags: &Compound, values: &mut Vec<Tag>) {
    for tag in tags.values() {
        values.push(tag.clone());
        if let Tag::Compound(tags) = tag {
            collect(tags, values);
        }
    }
}

/// Changes one tag, mostly deep within.
fn change(tags: &mut Compound, values: &[Tag], rng: &mut Pcg32) {
    let names: Vec<String> = tags.keys().map(String::from).collect();
    let Some(name) = names.choose(rng) else { return };
    match rng.random_range(0..12) {
        0 => drop(tags.remove(name)),
        1 => {
            let other = names.choose(rng).cloned().unwrap_or_default();
            let tag = tags.remove(name);
            tags.extend(tag.map(|tag| (other, tag)));
        }
        2 => drop(tags.insert(name.clone(), values.choose(rng).cloned().unwrap_or(Tag::Byte(0)))),
        3 => drop(tags.insert(format!("{name}{}", rng.random_range(0..3)), tags[name].clone())),
        _ => tags.get_mut(name).into_iter().for_each(|tag| change_value(tag, values, rng)),
    }
}

fn change_value(tag: &mut Tag, values: &[Tag], rng: &mut Pcg32) {
    match tag {
        Tag::Compound(tags) => change(tags, values, rng),
        Tag::List(entries) => change_list(entries, values, rng),
        Tag::Byte(n) => *n = telling(rng) as i8,
        Tag::Short(n) => *n = telling(rng) as i16,
        Tag::Int(n) => *n = telling(rng) as i32,
        Tag::Long(n) => *n = telling(rng),
        Tag::Float(n) => *n = f32::from_bits(telling(rng) as u32),
        Tag::Double(n) => *n = f64::from_bits(telling(rng) as u64),
        Tag::ByteArray(numbers) => change_array(numbers, |number| number as i8, rng),
        Tag::IntArray(numbers) => change_array(numbers, |number| number as i32, rng),
        Tag::LongArray(numbers) => change_array(numbers, |number| number, rng),
        Tag::String(text) => match rng.random_range(0..3) {
            0 => text.clear(),
            1 => text.extend(["é", "[", "=", ":", "minecraft:stone", "😀"].choose(rng).copied()),
            _ => *text = text.repeat(rng.random_range(0..100)),
        },
    }
}

fn change_list(entries: &mut Vec<Tag>, values: &[Tag], rng: &mut Pcg32) {
    let at = rng.random_range(0..=entries.len());
    match rng.random_range(0..6) {
        0 => entries.truncate(at),
        1 => *entries = vec![entries.clone(); rng.random_range(0..20)].concat(),
        2 => *entries = values.choose(rng).cloned().into_iter().collect(),
        _ => entries.get_mut(at).into_iter().for_each(|entry| change_value(entry, values, rng)),
    }
}

fn change_array<T: Copy>(numbers: &mut Vec<T>, number: impl Fn(i64) -> T, rng: &mut Pcg32) {
    let at = rng.random_range(0..=numbers.len());
    match rng.random_range(0..4) {
        0 => numbers.truncate(at),
        1 => numbers.extend([number(telling(rng))].repeat(rng.random_range(0..300))),
        _ => numbers[at..].iter_mut().take(3).for_each(|n| *n = number(telling(rng))),
    }
}

/// Numbers at which something ends.
fn telling(rng: &mut Pcg32) -> i64 {
    let bits = rng.random_range(0..=64u32);
    let power = 1i64.checked_shl(bits).unwrap_or(0);
    let near = power.wrapping_add(rng.random_range(-2..=2));
    if rng.random() { near } else { near.wrapping_neg() }
}
