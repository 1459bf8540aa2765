//! Captures: written, damaged, compared, and read by others.

mod compare;
mod damage;
mod file;
mod pass_timer;
mod python;
mod topics;

// The example that the documentation shows, to be run as it stands.
#[allow(dead_code)]
#[path = "../../../app/capture/examples/time_your_passes.rs"]
mod time_your_passes;
