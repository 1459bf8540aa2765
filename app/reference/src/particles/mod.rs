//! Particles on their own, before they meet.

pub mod activate;
pub mod advect;
pub mod begin_substep;
pub mod deactivate;
pub mod drag;
pub mod predict;
