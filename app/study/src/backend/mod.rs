//! Who moves the particles: the product on a GPU, or its f64 twin.

mod counted;
mod gpu;
mod reference;

pub use counted::Counted;
pub use gpu::{GpuRun, Measured, Options, run};
pub use reference::{Cache, Origin, converged, reference_fluid, run_reference};
