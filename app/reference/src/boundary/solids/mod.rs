//! Solids that the fluid flows around. (Shaders: `boundary/solids/`.)

pub mod collide;
pub mod contact;
pub mod field;
pub mod motion;
pub mod shapes;

pub use field::Field;
pub use motion::Pose;
pub use shapes::{Shape, Solid};
