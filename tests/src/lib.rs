//! Shared helpers of the integration tests: the device, single kernels, the built program, captures, seeded
//! random numbers, sizes around block edges.

pub mod afloat;
pub mod captures;
pub mod column;
mod device;
pub mod extreme;
pub mod full_disk;
pub mod mesh_files;
pub mod peers;
pub mod phones;
pub mod pool;
pub mod program;
pub mod python;
pub mod solids;
pub mod splishsplash;
pub mod states;
pub mod twin;
pub mod validation;

pub use brooklet_check::numbers::{edge_sizes, rng};
pub use brooklet_check::{bench as harness, cases, compare};
pub use device::{device, gpu, gpu_of_long_run, small};

use std::path::{Path, PathBuf};

/// The repository's top.
pub fn top() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}
