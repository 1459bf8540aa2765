//! What the domain's walls add to the fluid.

pub mod walls;
