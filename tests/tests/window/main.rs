//! The window under a display of its own.

mod mesh_room;
mod person;
mod soak;
mod support;
