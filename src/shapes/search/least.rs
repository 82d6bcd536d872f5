//! A list of numbers, asked for the first that is small enough.

/// Numbers by index, all infinite at first.
#[derive(Debug, Default)]
pub struct Least {
    /// A complete binary tree: the leaves are the numbers, every other node is the least of its two children.
    tree: Vec<f64>,
    leaves: usize,
}

impl Least {
    pub fn set(&mut self, index: usize, value: f64) {
        if index >= self.leaves {
            self.grow(index + 1);
        }
        let mut node = self.leaves + index;
        self.tree[node] = value;
        while node > 1 {
            node /= 2;
            let least = self.tree[2 * node].min(self.tree[2 * node + 1]);
            if self.tree[node] == least {
                break;
            }
            self.tree[node] = least;
        }
    }

    /// The lowest index of a finite number that is at most `most`.
    pub fn first_at_most(&self, most: f64) -> Option<usize> {
        let is_in = |node: usize| self.tree[node].is_finite() && self.tree[node] <= most;
        if self.leaves == 0 || !is_in(1) {
            return None;
        }
        let mut node = 1;
        while node < self.leaves {
            node = if is_in(2 * node) { 2 * node } else { 2 * node + 1 };
        }
        Some(node - self.leaves)
    }

    fn grow(&mut self, needed: usize) {
        let leaves = needed.next_power_of_two().max(2);
        let mut tree = vec![f64::INFINITY; 2 * leaves];
        tree[leaves..leaves + self.leaves].copy_from_slice(&self.tree[self.leaves..]);
        for node in (1..leaves).rev() {
            tree[node] = tree[2 * node].min(tree[2 * node + 1]);
        }
        *self = Least { tree, leaves };
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_first_is_that_of_a_scan(changes in prop::collection::vec((0usize..40, -5i32..5), 0..80), most in -5i32..5) {
            let (mut least, mut list) = (Least::default(), vec![f64::INFINITY; 40]);
            for (index, value) in changes {
                let value = if value == 4 { f64::INFINITY } else { f64::from(value) };
                least.set(index, value);
                list[index] = value;
            }
            let scanned = list.iter().position(|value| value.is_finite() && *value <= f64::from(most));
            prop_assert_eq!(least.first_at_most(f64::from(most)), scanned);
        }
    }
}
