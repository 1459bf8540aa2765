//! What the desktop window and the phone share: a running scene, its camera, what stands round the
//! picture, the quality ladder, and the capture of all of it.
//!
//! The program around it owns the window and its surface. Each time something is to be painted it hands
//! [`Viewer::frame`] what the user did (egui's input) and where to paint, and does what comes back.
//!
//! A frame is one submission: a drag if somebody drags, as many steps as time asks for and the budget holds, a
//! measurement and samples if they are due, a picture. At most two are under way; what comes back is taken when it is
//! there. The panels are painted over the last picture, and only when something is new.
//!
//! A scene, its plan and its engine are made on a thread of their own beside those that run, and take their state over
//! on the GPU: every buffer that both have by name and size, but those that the first recordings fill. The ladder's
//! other spacings are the same fluid sampled on another lattice. Whether a setting is taken at once is asked of the
//! plans: if two differ at most in what they upload, the numbers are written.
//!
//! A capture goes over all of these. Its frames are numbered and timed by the window's clock, and what the panels cost
//! (`overlay`) is a span of the frame that they were painted over.

pub mod action;
mod clock;
pub mod device_speed;
mod drag;
mod error;
mod files;
mod flow;
pub mod governor;
mod grip;
mod handle_action;
mod hands;
mod history;
mod in_flight;
mod jobs;
pub mod ladder;
pub mod loading;
pub mod marks;
mod messages;
mod orbit;
mod outside;
pub mod panels;
mod pick;
mod place;
mod playback;
mod pointer;
mod presenter;
mod quality;
mod reach;
mod recorder;
mod reload;
pub mod style;
pub mod surface;
mod thumbnail;
mod times;
mod viewer;
pub mod viewer_scene;

pub use error::ViewerError;
pub use flow::Flow;
pub use history::{History, Quantiles};
pub use messages::{Kind, Message, Messages};
pub use orbit::{Orbit, Ray, ray};
pub use place::Place;
pub use pointer::{Pointing, Strokes};
pub use presenter::Target;
pub use reload::{NewModule, NewModules};
pub use times::{PassTimes, Times};
pub use viewer::{Painted, Settings, Viewer};
