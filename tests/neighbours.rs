//! What blocks take from their neighbours.

#[path = "common/real.rs"]
mod real;

#[path = "neighbours/cases.rs"]
mod cases;
#[path = "neighbours/houses.rs"]
mod houses;
#[path = "neighbours/laws.rs"]
mod laws;
#[path = "neighbours/mend.rs"]
mod mend;
