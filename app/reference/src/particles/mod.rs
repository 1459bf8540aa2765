//! Particles on their own, before they meet.

pub mod predict;
pub mod push;
