//! Where particles come from and go to while a scene runs. (Shaders: `emitters/`.)

pub mod compact;
pub mod drain_particles;
pub mod emit_particles;
pub mod guide_particles;
pub mod limit_drain;
pub mod open_emitters;
