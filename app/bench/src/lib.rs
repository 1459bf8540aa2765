//! What is timed against what, on GPU times alone: the passes of a scene and of its pictures ([`single`]), one
//! workload at rising numbers of particles ([`scaling`]), the papers' rows by every solver ([`papers`]), ways to sort ([`sorting`]), ways to smooth ([`surfaces`]).
//!
//! A benchmark is a function of a device, some options and an [`Observer`]; what it gives is plain data.

pub mod bodies;
pub mod bounds;
mod error;
pub mod figures;
mod generated;
mod observer;
pub mod papers;
pub mod pictures;
mod plot;
pub mod rates;
pub mod scaling;
mod scene_options;
pub mod single;
pub mod sorting;
mod stepping;
pub mod submissions;
pub mod surfaces;
mod targets;
mod traffic;
pub mod workload;

/// The kernels that only a comparison needs (`shaders/hlsl/bench`), with typed bindings; nothing shipped holds them.
pub mod kernels {
    pub use crate::generated::*;
}

pub use error::BenchError;
pub use observer::Observer;
