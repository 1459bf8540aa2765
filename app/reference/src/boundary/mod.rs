//! What the domain's walls add to the fluid.

pub mod wall_integrals;
pub mod walls;
