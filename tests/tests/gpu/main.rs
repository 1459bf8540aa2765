//! Devices, plans, engines and the ears for the validation layers.

mod cache;
mod draw;
mod engine;
mod running;
mod sharing;
mod support;
mod validation;
