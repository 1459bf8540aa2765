//! What holds for whole runs, whatever the kernels: one hash twice, frames in flight, the clock.

use std::hash::{DefaultHasher, Hash as _, Hasher as _};

use brooklet_fluid::particles::ParticleSet;
use brooklet_fluid::{ParticleSource, Scene, Session, SessionRecorder, visit_slots};
use brooklet_gpu::{FRAMES_IN_FLIGHT, FrameReport, Plan, Resources, SpanFlag, TimingStatus};
use brooklet_kernels::{BeginSubstep, ReduceGroups, SCAN_ITEMS, StepParams, StepState};

use crate::device::Device;
use crate::wrong::{OrRaise as _, Wrong, ensure, ensure_eq, note, skip};

const SCENE: &str = "
spacing_m = 0.05
[domain]
min_m = [0, 0, 0]
max_m = [1.2, 0.8, 0.5]
[[fluid]]
block = { min_m = [0, 0, 0], max_m = [0.4, 0.6, 0.5] }
[solver]
deterministic = true
[solver.pbf]
iterations = 3
[forces]
xsph = 0.02
vorticity_m_s = 0.02
";

pub(crate) fn two_deterministic_runs_have_one_hash(device: &Device) {
    let scene = Scene::from_toml(SCENE, "runs", &[]).or_raise();
    let hashes = [0; 2].map(|_| {
        let mut planned = SessionRecorder::new(&scene, ParticleSource::Scene).sweep().or_raise();
        planned.plan = device.plan(planned.plan);
        let mut session = Session::start(device.gpu(), planned).or_raise();
        for _ in 0..40 {
            session.step().or_raise();
        }
        let ParticleSet { positions, velocities } = session.read_particles().or_raise();
        let mut both: Vec<_> = positions.into_iter().zip(velocities).collect();
        both.sort_by_key(|(position, _)| position.tag);
        let mut hasher = DefaultHasher::new();
        for (position, velocity) in &both {
            bytemuck::bytes_of(position).hash(&mut hasher);
            bytemuck::bytes_of(velocity).hash(&mut hasher);
        }
        hasher.finish()
    });
    note!(device, "hash of 40 deterministic steps: {:016x}", hashes[0]);
    ensure_eq!(format!("{:016x}", hashes[1]), format!("{:016x}", hashes[0]), "hash of a second deterministic run");
}

pub(crate) fn frames_in_flight_read_back_their_own_values(device: &Device) {
    const FRAMES: usize = 6 * FRAMES_IN_FLIGHT;
    let mut resources = Resources::new();
    let mut state = resources.persistent::<StepState>("step_state", 1);
    let mut params = resources.persistent("step_params", 1);
    let mut init = resources.recording("init");
    init.upload(&mut state, &[StepState { time_s: 0.0, ..visit_slots(1) }]);
    let mut step = resources.recording("step");
    step.upload(&mut params, &[StepParams { dt_s: 0.125, ..StepParams::default() }]);
    step.dispatch(&BeginSubstep { step_state: state.write(), step_params: params.uniform() }, 1);
    let ids = [init.id(), step.id()];
    let plan = Plan::sweep(resources, vec![init, step], &[state.id]).or_raise();
    let mut engine = device.engine(plan);
    engine.run(&ids[..1], &[]).or_raise();
    for _ in 0..FRAMES {
        engine.run(&ids[1..], &[state.id]).or_raise();
    }
    let reports = engine.finish().or_raise();
    let times: Vec<Option<f32>> = reports.iter().skip(1).map(|report| report.first(&state).map(|s| s.time_s)).collect();
    let expected: Vec<Option<f32>> = (1..=FRAMES).map(|frame| Some(0.125 * frame as f32)).collect();
    crate::compare::check_same(&times, &expected).or_raise();
}

/// Frames of a few dispatches that take long enough for any clock.
fn timed_frames(device: &Device) -> Vec<FrameReport> {
    let count: u32 = if device.small() { 1 << 16 } else { 1 << 20 };
    let mut resources = Resources::new();
    let mut values = resources.persistent::<u32>("values", count);
    let mut sums = resources.persistent("group_sums", count.div_ceil(SCAN_ITEMS));
    let mut recording = resources.recording("timed");
    recording.clear(&mut values);
    for _ in 0..4 {
        let kernel = ReduceGroups { values: values.read(), group_sums: sums.write() };
        recording.dispatch(&kernel, count.div_ceil(SCAN_ITEMS));
    }
    let id = recording.id();
    let plan = Plan::sweep(resources, vec![recording], &[sums.id]).or_raise();
    let mut engine = device.engine(plan);
    for _ in 0..5 {
        engine.run(&[id], &[]).or_raise();
    }
    engine.finish().or_raise()
}

/// Whether ticks may be believed: how many of their bits were seen, in a line.
///
/// # Errors
/// If a tick lasts no time or has more bits than count, a span ends before it begins, none takes any time, or a frame lies
/// before another.
fn believed(reports: &[FrameReport], valid_bits: u32) -> Result<String, Wrong> {
    let (mut last, mut zero, mut all) = (0, 0, 0);
    for (frame, report) in reports.iter().enumerate() {
        let period_ns = report.timestamp_period_ns;
        if !(period_ns > 0.0 && period_ns < 1e6) {
            return Err(Wrong::new(format!("a tick lasts {period_ns} ns")));
        }
        if report.dropped_spans > 0 || report.spans.is_empty() {
            return Err(Wrong::new(format!("frame {frame}: {} timestamps did not come", report.dropped_spans)));
        }
        for span in &report.spans {
            all += 1;
            zero += usize::from(span.flag == SpanFlag::Zero);
            if span.end_ticks.checked_shr(valid_bits).is_some_and(|beyond| beyond > 0) {
                let text = format!("{} ticks, of {valid_bits} bits that count", span.end_ticks);
                return Err(Wrong::new(format!("frame {frame}: {text}")));
            }
            if span.flag == SpanFlag::Negative || span.begin_ticks < last {
                let text = format!("from {} to {}, after {last}", span.begin_ticks, span.end_ticks);
                return Err(Wrong::new(format!("frame {frame}: ticks run back, or wrapped: {text}")));
            }
        }
        last = report.spans.iter().map(|span| span.end_ticks).max().unwrap_or(last);
    }
    if zero == all {
        return Err(Wrong::new(format!("none of {all} spans takes any time")));
    }
    let period_ns = reports.first().map_or(0.0, |report| report.timestamp_period_ns);
    let wraps_s = 2f64.powi(valid_bits as i32) * period_ns * 1e-9;
    Ok(format!(
        "clock: a tick is {period_ns} ns, {valid_bits} bits count, {} seen, wraps after {wraps_s:.0} s, {zero} of {all} spans of no time",
        64 - last.leading_zeros()
    ))
}

pub(crate) fn the_clock_runs_forward(device: &Device) {
    match device.gpu().timing() {
        TimingStatus::Unsupported => skip("the device has no timestamps: nothing can be timed on it"),
        TimingStatus::Off => skip("timestamps were not asked for"),
        _ => {}
    }
    let reports = timed_frames(device);
    ensure!(reports.len() == 5, "{} reports of 5 frames", reports.len());
    note!(device, "{}", believed(&reports, device.gpu().driver_facts().timestamp_bits).or_raise());
}

#[cfg(test)]
mod tests {
    use brooklet_gpu::Span;

    use super::*;

    fn report(ticks: &[[u64; 2]], timestamp_period_ns: f64) -> FrameReport {
        let recording = Resources::new().recording("timed").id();
        let mut last = None;
        let mut spans = Vec::new();
        for &[begin_ticks, end_ticks] in ticks {
            let flag = SpanFlag::of(begin_ticks, end_ticks, last, u64::MAX);
            spans.push(Span { recording, stage: "reduce_groups", begin_ticks, end_ticks, flag });
            last = Some(end_ticks);
        }
        let timing = TimingStatus::InsidePasses;
        FrameReport {
            frame: 0,
            wall_ns: 0,
            spans,
            dropped_spans: 0,
            readbacks: Vec::new(),
            timing,
            timestamp_period_ns,
        }
    }

    #[test]
    fn clocks_that_cannot_be_believed_are_not() {
        let good = || report(&[[100, 110], [110, 130]], 1.0);
        assert!(believed(&[good(), report(&[[140, 150]], 1.0)], 64).unwrap().contains("64 bits count, 8 seen"));
        let wrong = |reports: &[FrameReport]| believed(reports, 36).unwrap_err().note.clone();
        assert!(wrong(&[report(&[[100, 110]], 0.0)]).contains("lasts 0 ns"));
        assert!(wrong(&[report(&[[100, 90]], 1.0)]).contains("run back"));
        assert!(wrong(&[good(), report(&[[3, 9]], 1.0)]).contains("wrapped"));
        assert!(wrong(&[report(&[[7, 7], [7, 7]], 1.0)]).contains("any time"));
        assert!(wrong(&[report(&[[1 << 36, 1 << 37]], 1.0)]).contains("of 36 bits"));
        assert!(wrong(&[report(&[], 1.0)]).contains("did not come"));
        assert!(wrong(&[FrameReport { dropped_spans: 2, ..good() }]).contains("2 timestamps"));
    }
}
