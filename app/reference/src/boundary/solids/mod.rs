//! Solids that the fluid flows around. (Shaders: `boundary/solids/`.)

pub mod collide;
pub mod contact;
pub mod motion;
pub mod shapes;

pub use motion::Pose;
pub use shapes::{Shape, Solid};
