//! Whether a device computes what it should: small known inputs for every kernel, and the f64 twin's answers.
//!
//! The same cases are the project's tests of its kernels and what `brooklet doctor --check` runs on a user's device.

pub mod bench;
pub mod cases;
pub mod compare;
mod cost;
mod device;
mod drawn;
pub mod numbers;
mod registry;
mod report;
mod rooms;
mod wrong;

pub use device::{Device, KnownAnswer, ModuleRun, Outcome, Verdict};
pub use registry::KNOWN_ANSWERS;
pub use report::{CheckedModule, ModuleVerdict, Progress, Report, Wanted, run};
pub use wrong::{Found, Wrong};
