//! Surfaces and pictures of the fluid.
//!
//! [`View`] says from where a scene is seen, [`frame::record`] records how it is drawn (on any
//! engine of `brooklet-gpu`, beside the simulation's recordings), and [`png::save`] writes the
//! picture.

pub mod camera;
pub mod diffuse;
mod diffuse_look;
pub mod error;
pub mod formats;
pub mod frame;
pub mod left_out;
pub mod png;
mod scene_plan;
pub mod solids;
mod start;
pub mod step_down;
pub mod surface;

pub use camera::{Camera, View};
pub use error::RenderError;
pub use frame::{Coloring, FrameOptions, FramePasses, FrameUniforms, record, record_with_solids};
pub use scene_plan::{ScenePlan, ScenePlanError};
pub use solids::Solids;
pub use start::{StartError, start};
pub use step_down::{Concession, start_stepping_down};
pub use surface::{MarchingCubesOptions, Particles, ScreenSpaceOptions, SmoothedSurface, SurfaceOptions};
