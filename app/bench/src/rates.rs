//! What the device can do at most, measured by the same means as the passes: move, gather, multiply, begin a dispatch.
//! (Shaders: `bench/{copy, gather_elements, multiply_add}.compute`.)

use brooklet_gpu::{Engine, Gpu, Plan, Recording, Resources, Timings};
use serde::Serialize;

use crate::{
    BenchError, Observer,
    kernels::{CopyElements, GatherElements, MultiplyAdd},
};

/// Size of either buffer of a copy: far more than a processor's caches, and no more than any tier binds.
const COPY_BYTES: u32 = 128 << 20;
/// Elements that are gathered from: as many as a million particles have.
const GATHER_ELEMENTS: u32 = 1 << 20;
/// Threads that multiply: more than any card has under way.
const MULTIPLY_THREADS: u32 = 1 << 20;
/// Dispatches of one thread, one after the other.
const LAUNCHES: u32 = 64;
const RUNS: u64 = 7;

/// Runs of neighbours that a thread of [`GatherElements`] reads.
pub const GATHER_RUNS: u32 = 8;
/// Elements of a run.
pub const GATHER_RUN: u32 = 4;
/// Elements from a run's start to the next one's.
pub const GATHER_ROW: u32 = 997;
/// Elements behind those of the last thread that it reads.
pub const GATHER_AHEAD: u32 = (GATHER_RUNS - 1) * GATHER_ROW + GATHER_RUN - 1;
/// Rounds of [`MultiplyAdd`], each of one multiplication and addition in each of eight chains.
pub const MULTIPLY_ADD_ROUNDS: u32 = 128;
/// Chains of a thread of [`MultiplyAdd`].
pub const MULTIPLY_ADD_CHAINS: u32 = 8;

/// What the device can do at most, each by the fastest of a few runs, launches by their median.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Rates {
    /// Bytes a second that a copy of a large buffer reads and writes.
    pub copy_bytes_per_s: f64,
    /// Elements of eight bytes a second, read as neighbours in a sorted fluid of a million particles are.
    pub gathers_per_s: f64,
    /// Multiplications with an addition a second, in f32.
    pub multiply_adds_per_s: f64,
    /// A dispatch of one thread that waits for the one before, s.
    pub launch_s: f64,
}

/// Measures them.
///
/// # Errors
/// [`BenchError::Stopped`] if the device stops or gives no times, [`BenchError::Interrupted`] if asked to end.
pub fn measure(gpu: &Gpu, observer: &dyn Observer) -> Result<Rates, BenchError> {
    let copy_s = fastest(gpu, observer, |resources, recording| {
        let from = resources.persistent("from_elements", COPY_BYTES / 16);
        let mut to = resources.persistent("to_elements", COPY_BYTES / 16);
        let elements = to.len;
        recording.dispatch(&CopyElements { from_elements: from.read(), to_elements: to.write() }, elements);
    })?;
    gpu.trim();
    let gather_s = fastest(gpu, observer, |resources, recording| {
        let from = resources.persistent("from_elements", GATHER_ELEMENTS + GATHER_AHEAD);
        let mut gathered = resources.persistent("gathered", GATHER_ELEMENTS);
        recording.dispatch(&GatherElements { from_elements: from.read(), gathered: gathered.write() }, GATHER_ELEMENTS);
    })?;
    let multiply_s = fastest(gpu, observer, |resources, recording| {
        let mut chain_sums = resources.persistent("chain_sums", MULTIPLY_THREADS);
        recording.dispatch(&MultiplyAdd { chain_sums: chain_sums.write() }, MULTIPLY_THREADS);
    })?;
    let launches_s = fastest(gpu, observer, |resources, recording| {
        let mut turns = [resources.persistent("even_element", 1), resources.persistent("odd_element", 1)];
        for turn in 0..LAUNCHES as usize {
            let (even, odd) = turns.split_at_mut(1);
            let (from, to) = if turn % 2 == 0 { (&even[0], &mut odd[0]) } else { (&odd[0], &mut even[0]) };
            recording.dispatch(&CopyElements { from_elements: from.read(), to_elements: to.write() }, 1);
        }
    })?;
    Ok(Rates {
        copy_bytes_per_s: 2.0 * f64::from(COPY_BYTES) / copy_s,
        gathers_per_s: f64::from(GATHER_ELEMENTS * GATHER_RUNS * GATHER_RUN) / gather_s,
        multiply_adds_per_s: f64::from(MULTIPLY_THREADS) * f64::from(MULTIPLY_ADD_ROUNDS * MULTIPLY_ADD_CHAINS)
            / multiply_s,
        launch_s: launches_s / f64::from(LAUNCHES),
    })
}

/// Seconds from the recording's first dispatch to the end of its last, in the fastest of a few runs; the median
/// where there are several.
fn fastest(
    gpu: &Gpu,
    observer: &dyn Observer,
    record: impl FnOnce(&mut Resources, &mut Recording),
) -> Result<f64, BenchError> {
    let mut resources = Resources::new();
    let mut recording = resources.recording("rates");
    record(&mut resources, &mut recording);
    let id = recording.id();
    let plan = Plan::sweep(resources, vec![recording], &[]).map_err(BenchError::stopped)?;
    let (stage, dispatches) = (plan.passes().first().map(|pass| pass.stage), plan.commands(id).len());
    let mut engine = Engine::new(gpu, plan).map_err(BenchError::input)?;
    let mut timings = Timings::new(1);
    for _ in 0..RUNS {
        observer.check()?;
        engine.run(&[id], &[]).map_err(BenchError::stopped)?;
    }
    engine.finish().map_err(BenchError::stopped)?.iter().for_each(|report| timings.add(report, id));
    // Of several dispatches the time between them counts.
    let least_ms = match dispatches {
        1 => stage.and_then(|stage| timings.least_ms(stage)),
        _ => timings.step_ms().map(|step| step.median),
    };
    let least_ms = least_ms.filter(|ms| *ms > 0.0);
    least_ms.map(|ms| ms * 1e-3).ok_or_else(|| BenchError::Stopped("the device gave no usable times".into()))
}
