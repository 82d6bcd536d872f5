//! Blocks of the time before Minecraft 1.13, told by numbers, and their block entities: in schematics of MCEdit and in
//! old chunks. They become states of today, and block entities take the form that they have beside those.

mod block_entities;
mod blocks;
mod halves;
mod ids;
mod owner;

pub(super) use block_entities::{holds_items, modern};
pub(super) use blocks::{Strangers, states};
pub(super) use halves::name_upper_halves;
pub(super) use ids::Ids;
