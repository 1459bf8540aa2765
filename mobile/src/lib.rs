//! The phone's app, but for the phone: what touches, sensors, heat and the back key do, what the screen shows, and what
//! becomes of device, surface and capture when the app comes and goes.
//!
//! A program of the phone's system owns an [`App`]: it hands it a window ([`App::resume`]) and takes it away
//! ([`App::suspend`]), tells it what happens, and calls [`App::frame`] as often as that asks for. Nothing of it panics for
//! what a phone does: what keeps it from showing anything is [`App::failure`], in words for a screen of text.
//!
//! The same runs on a desktop (`examples/desktop.rs`), with a mouse for a finger, and without any window, on a texture.

mod app;
mod app_paths;
mod canvas;
mod gravity;
mod heat;
mod kept;
mod open;
mod report;
mod screen;
pub mod script;
mod self_check;
mod touch;
mod worker;

pub use app::{App, Wake};
pub use app_paths::AppPaths;
pub use canvas::{Picture, WindowSource};
pub use self_check::{Asked, Checked, WrongAnswer};
pub use touch::{Acceleration, TouchEvent, TouchPhase};
