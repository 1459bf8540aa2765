//! What bounds the fluid.

mod walls;

pub use walls::{WallScales, beyond_wall, wall_kernel_fraction};
