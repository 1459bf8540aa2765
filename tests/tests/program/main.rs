//! The `brooklet` program as its users call it.

mod bad_input;
mod bad_meshes;
mod bench;
mod capture_cli;
mod cli;
mod cli_surfaces;
mod doctor_check;
mod ended_early;
mod mesh;
#[cfg(feature = "report")]
mod report;
mod stepping_down;
mod study;
