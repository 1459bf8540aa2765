//! `brooklet bench`: the time of every pass, of one scene or of one workload at rising sizes.

mod bandwidth;
mod figures;
mod plot;
mod report;
mod scaling;
mod single;
mod sorting;
mod stepping;
mod targets;
mod traffic;
mod workload;

use brooklet_gpu::Gpu;

use crate::{
    cli::{BenchOptions, BenchStudy, DeviceOptions},
    failure::Failure,
    job,
};

/// Runs and prints the benchmark that is asked for.
pub fn bench(options: &BenchOptions) -> Result<(), Failure> {
    match (&options.study, &options.scene) {
        (Some(BenchStudy::Sorting(options)), _) => sorting::bench(options),
        (None, Some(scene)) => single::bench(scene, options),
        (None, None) => scaling::bench(options),
    }
}

/// Opens a device that gives GPU times.
fn open(options: &DeviceOptions) -> Result<Gpu, Failure> {
    let gpu = job::open(options, true)?;
    if gpu.timing().is_measured() {
        Ok(gpu)
    } else {
        Err(Failure::Input(format!("{} gives no GPU times, and a benchmark is made of them", gpu.info().name)))
    }
}
