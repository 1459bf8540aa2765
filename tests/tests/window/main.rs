//! The window under a display of its own.

mod first_rung;
mod hands;
mod mesh_room;
mod person;
mod soak;
mod support;
