//! The window under a display of its own.

mod person;
mod soak;
mod support;
