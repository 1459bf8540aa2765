//! `brooklet bench`: the time of every pass, of one scene or of one workload at rising sizes.

#[path = "../../../bench/src/bandwidth.rs"]
mod bandwidth;
#[path = "../../../bench/src/figures.rs"]
mod figures;
#[path = "../../../bench/src/pictures.rs"]
mod pictures;
#[path = "../../../bench/src/plot.rs"]
mod plot;
mod report;
#[path = "../../../bench/src/scaling.rs"]
mod scaling;
#[path = "../../../bench/src/single.rs"]
mod single;
#[path = "../../../bench/src/sorting/mod.rs"]
mod sorting;
#[path = "../../../bench/src/stepping.rs"]
mod stepping;
#[path = "../../../bench/src/surfaces/mod.rs"]
mod surfaces;
#[path = "../../../bench/src/targets.rs"]
mod targets;
#[path = "../../../bench/src/traffic.rs"]
mod traffic;
#[cfg(feature = "window")]
mod window;
#[path = "../../../bench/src/workload.rs"]
mod workload;

use std::path::Path;

use brooklet_gpu::Gpu;

use crate::{
    bench_options::{BenchOptions, BenchStudy},
    failure::Failure,
    job,
    shared_options::DeviceOptions,
};

/// Runs and prints the benchmark that is asked for.
pub fn bench(options: &BenchOptions) -> Result<(), Failure> {
    match (&options.study, &options.scene) {
        (Some(BenchStudy::Sorting(options)), _) => sorting::bench(options),
        (Some(BenchStudy::Surfaces(options)), _) => surfaces::bench(options),
        #[cfg(feature = "window")]
        (Some(BenchStudy::Window(options)), _) => window::bench(options),
        (None, Some(scene)) => single::bench(scene, options),
        (None, None) => scaling::bench(options),
    }
}

/// Minutes of measuring would be lost on a folder that cannot be written to.
fn check_folder(option: &str, file: &Path) -> Result<(), Failure> {
    let folder = file.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    match tempfile::tempfile_in(folder) {
        Ok(_) => Ok(()),
        Err(error) => Err(Failure::Input(format!("{option} {}: cannot be written: {error}", file.display()))),
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
