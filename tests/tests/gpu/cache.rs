//! The pipeline cache: kept between runs, and never believed when it is damaged.

use crate::support::{Increment, options};
use brooklet_gpu::{CacheStatus, Engine, Gpu, GpuOptions, Plan, Resources};
use std::path::{Path, PathBuf};

fn open(folder: &Path) -> Gpu {
    Gpu::open(&GpuOptions { pipeline_cache: Some(folder.to_owned()), ..options() }).expect("a device")
}

/// Builds and runs a kernel, so that there is something to keep.
fn run(gpu: &Gpu) {
    let mut resources = Resources::new();
    let mut values = resources.persistent::<u32>("values", 100);
    let mut step = resources.recording("step");
    step.dispatch(&Increment { values: values.write() }, 100);
    let step_id = step.id();
    let plan = Plan::sweep(resources, vec![step], &[]).expect("a plan");
    let mut engine = Engine::new(gpu, plan).expect("an engine");
    engine.run(&[step_id], &[]).expect("it runs");
    assert_eq!(engine.read(&values).expect("values"), [1; 100]);
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("the folder");
    entries.map(|entry| entry.expect("an entry").path()).collect()
}

#[test]
fn it_is_written_whole_read_again_and_replaced_when_damaged() {
    let folder = std::env::temp_dir().join(format!("brooklet-cache-{}", std::process::id()));
    let folder = folder.join("made on demand");
    let gpu = open(&folder);
    if gpu.pipeline_cache() == CacheStatus::Unsupported {
        return;
    }
    assert_eq!(gpu.pipeline_cache(), CacheStatus::Fresh);
    run(&gpu);
    let written = files(&folder);
    assert_eq!(written.len(), 1, "one file and no temporary one: {written:?}");
    let good = std::fs::read(&written[0]).expect("the file");

    let gpu = open(&folder);
    assert!(matches!(gpu.pipeline_cache(), CacheStatus::Loaded { bytes } if bytes > 0));
    run(&gpu);

    let mut flipped = good.clone();
    let middle = flipped.len() / 2;
    flipped[middle] ^= 1;
    for damaged in [flipped, good[..good.len() / 2].to_vec(), vec![0; 1000], Vec::new()] {
        std::fs::write(&written[0], &damaged).expect("written");
        let gpu = open(&folder);
        assert!(
            matches!(gpu.pipeline_cache(), CacheStatus::Rejected { .. }),
            "{:?} for {} bytes",
            gpu.pipeline_cache(),
            damaged.len()
        );
        run(&gpu);
        let gpu = open(&folder);
        assert!(matches!(gpu.pipeline_cache(), CacheStatus::Loaded { .. }), "replaced");
    }
    std::fs::remove_dir_all(folder.parent().expect("its parent")).expect("removed");
}

#[test]
fn without_a_folder_there_is_none() {
    let gpu = Gpu::open(&options()).expect("a device");
    assert_eq!(gpu.pipeline_cache(), CacheStatus::Off);
    run(&gpu);
}

#[test]
fn a_folder_that_cannot_be_written_costs_nothing_but_time() {
    let gpu = open(Path::new("/proc/no such folder"));
    run(&gpu);
}
