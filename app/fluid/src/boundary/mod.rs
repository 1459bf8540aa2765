//! What bounds the fluid.

mod walls;

pub use walls::{WALL_NODES, wall_weights};
