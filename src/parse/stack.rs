//! Recursion as deep as trees and derivations are.

/// Stack that is left when more is taken, and how much more, in bytes.
const RED_ZONE: usize = 128 << 10;
const STACK: usize = 4 << 20;

/// Runs something on a stack with room for more.
pub fn stacked<T>(run: impl FnOnce() -> T) -> T {
    stacker::maybe_grow(RED_ZONE, STACK, run)
}
