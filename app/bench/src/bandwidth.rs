//! What the device can move, measured by the same means as the passes. (Shader: `bench/copy.compute`.)

use brooklet_gpu::{Engine, Gpu, Plan, Resources, Timings};

use crate::{BenchError, Observer, kernels::CopyElements};

/// Size of either buffer: far more than a processor's caches, and no more than any tier binds.
const BYTES: u32 = 128 << 20;
const RUNS: u64 = 7;

/// Bytes a second that a copy of a large buffer reads and writes, by the fastest of a few runs.
pub fn copy_bytes_per_s(gpu: &Gpu, observer: &dyn Observer) -> Result<f64, BenchError> {
    let mut resources = Resources::new();
    let from = resources.persistent("from_elements", BYTES / 16);
    let mut to = resources.persistent("to_elements", BYTES / 16);
    let mut copy = resources.recording("copy");
    let elements = to.len;
    copy.dispatch(&CopyElements { from_elements: from.read(), to_elements: to.write() }, elements);
    let copy_id = copy.id();
    let plan = Plan::sweep(resources, vec![copy], &[]).map_err(BenchError::stopped)?;
    let mut engine = Engine::new(gpu, plan).map_err(BenchError::input)?;
    let mut timings = Timings::new(1);
    for _ in 0..RUNS {
        observer.check()?;
        engine.run(&[copy_id], &[]).map_err(BenchError::stopped)?;
    }
    engine.finish().map_err(BenchError::stopped)?.iter().for_each(|report| timings.add(report, copy_id));
    let least_ms = timings.least_ms("copy_elements");
    let least_ms = least_ms.ok_or_else(|| BenchError::Stopped("the device gave no usable time of a copy".into()))?;
    Ok(2.0 * f64::from(BYTES) / (least_ms * 1e-3))
}
