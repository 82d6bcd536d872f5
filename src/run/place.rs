use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

/// A place in a derivation: the path of child numbers from the start, and the seed, in 64 bits.
///
/// Every operation draws from a stream of its own place. So choices do not depend on the order of
/// derivation, and a change to one rule leaves the choices in other subtrees as they were.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Place(u64);

impl Place {
    pub fn start(seed: u64) -> Place {
        Place(mix(seed))
    }

    pub fn child(self, number: usize) -> Place {
        self.step(number as u64 + 1)
    }

    fn step(self, bits: u64) -> Place {
        Place(mix(self.0 ^ mix(bits)))
    }

    /// The place of something that has a name rather than a number.
    pub fn named(self, name: &str) -> Place {
        // No child has this number, so that no name is a path.
        self.spelt(u64::MAX, name.as_bytes())
    }

    /// The place of a key of coherent draws.
    pub fn keyed(self, key: &[u8]) -> Place {
        self.spelt(u64::MAX - 1, key)
    }

    /// A number below 2^53 that the place alone determines.
    pub fn number(self) -> u64 {
        self.0 >> 11
    }

    fn spelt(self, kind: u64, bytes: &[u8]) -> Place {
        bytes.iter().fold(self.step(kind), |place, byte| place.child(usize::from(*byte)))
    }

    pub fn stream(self) -> Pcg64Mcg {
        Pcg64Mcg::seed_from_u64(self.0)
    }
}

/// The finaliser of SplitMix64 (Steele, Lea and Flood, 2014): every bit of the input reaches every bit.
fn mix(bits: u64) -> u64 {
    let bits = bits.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}
