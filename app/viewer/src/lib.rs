//! What the desktop window and the phone share: a running scene, its camera, what stands round the
//! picture, the quality ladder, and the capture of all of it.
//!
//! The program around it owns the window and its surface. Each time something is to be painted it hands
//! [`Viewer::frame`] what the user did (egui's input) and where to paint, and does what comes back.

mod acting;
pub mod action;
mod clock;
mod error;
mod files;
mod flight;
mod hand;
mod history;
mod jobs;
pub mod ladder;
pub mod loading;
pub mod marks;
mod messages;
mod orbit;
mod panels;
mod pointer;
mod presenter;
mod recorder;
mod reload;
mod running;
mod style;
mod thumbnail;
mod times;
mod viewer;
pub mod world;

pub use error::WorldError;
pub use history::{History, Quantiles};
pub use messages::Kind;
pub use orbit::{Orbit, Ray, ray};
pub use presenter::Target;
pub use reload::{NewModule, NewModules};
pub use viewer::{Painted, Settings, Viewer};
