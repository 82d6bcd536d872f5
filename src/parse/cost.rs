use std::cmp::Ordering;

/// What a derivation costs. What comes first counts before all that follows.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Cost {
    /// Cells that are other than the derivation says.
    pub lost: u64,
    /// Those of them that it says nothing of: where one says another block, it is likelier to be meant.
    pub bare: u64,
    /// Blocks that are left to what stands behind, where something does.
    pub left: u64,
    /// What the draws take to say.
    pub bits: f64,
    /// Operations: of two derivations that cost the same the shorter one, so that none runs in rings.
    pub steps: u64,
}

impl Cost {
    pub const NONE: Cost = Cost { lost: 0, bare: 0, left: 0, bits: 0.0, steps: 0 };

    pub fn of_bits(bits: f64) -> Cost {
        Cost { bits, ..Cost::NONE }
    }

    /// The cost of something that comes out with a chance.
    pub fn of_chance(chance: f64) -> Cost {
        Cost::of_bits(if chance < 1.0 { -chance.log2() } else { 0.0 })
    }

    pub fn of_lost(lost: u64) -> Cost {
        Cost { lost, ..Cost::NONE }
    }

    pub fn of_bare(lost: u64) -> Cost {
        Cost { lost, bare: lost, ..Cost::NONE }
    }

    pub fn plus(self, other: Cost) -> Cost {
        Cost {
            lost: self.lost + other.lost,
            bare: self.bare + other.bare,
            left: self.left + other.left,
            bits: self.bits + other.bits,
            steps: self.steps + other.steps,
        }
    }

    pub fn is_less(self, other: Cost) -> bool {
        let whole = (self.lost, self.bare, self.left).cmp(&(other.lost, other.bare, other.left));
        let bits = whole.then_with(|| self.bits.total_cmp(&other.bits));
        bits.then_with(|| self.steps.cmp(&other.steps)) == Ordering::Less
    }
}
