//! A setup on the GPU: every step a frame of its own, so that what measures and what is read back is
//! outside the times.

use brooklet_fluid::particles::{id_of, is_quarantined};
use brooklet_fluid::{
    FrameRequest, ParticleSource, Session, SessionError, SessionRecorder, SessionReport, Stats, relax_particles,
};
use brooklet_gpu::{Gpu, Plan, RecordingId};
use brooklet_kernels::{Position, Velocity};
use glam::DVec3;

use super::Counted;
use crate::setup::{position_m, velocity_m_s};
use crate::{Cost, Force, Sample, Setup};

/// How a run goes.
pub struct Options<'a> {
    /// Whether it is to end now, with what there is.
    pub stop: &'a dyn Fn() -> bool,
    /// Changes the plan before it runs: a test's way to put a fault in.
    pub edit: Option<&'a dyn Fn(Plan) -> Plan>,
    /// Told the steps done.
    pub progress: &'a dyn Fn(u64),
}

impl Default for Options<'_> {
    fn default() -> Self {
        Self { stop: &|| false, edit: None, progress: &|_| {} }
    }
}

/// What a run gave.
#[derive(Clone, Debug, Default)]
pub struct GpuRun {
    /// Before the first step, relaxed if the setup is.
    pub start: Sample,
    /// At the times asked for, as far as it came.
    pub samples: Vec<Sample>,
    /// The program's own measurement at the same times.
    pub measured: Vec<Measured>,
    /// GPU time of every step, ms; the host's where the GPU has no clock.
    pub step_ms: Vec<f64>,
    /// Whether the GPU's clock was used.
    pub gpu_clock: bool,
    /// Bytes that the plan keeps for a step.
    pub bytes: u64,
    /// Whether it was stopped early.
    pub stopped: bool,
}

/// A measurement, and when.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// Since the start, s.
    pub time_s: f64,
    /// What the program told; its counters are since the measurement before.
    pub stats: Stats,
}

/// Runs `setup` to its end.
///
/// # Errors
/// If the device lacks memory or limits for it, or is lost.
pub fn run(gpu: &Gpu, setup: &Setup, options: &Options<'_>) -> Result<GpuRun, SessionError> {
    let mut scene = setup.scene.clone();
    // Measured when sampled, not in between: the scene must have the stage at all.
    scene.outputs.measure_every_steps = 1;
    let mut particles = setup.particles.clone();
    if setup.relaxes {
        relax_particles(gpu, &scene, &mut particles)?;
    }
    let start = sample(0.0, &particles.positions, &particles.velocities, setup.count());
    let mut planned = SessionRecorder::new(&scene, ParticleSource::Given(particles)).sweep()?;
    if let Some(edit) = options.edit {
        planned.plan = edit(planned.plan);
    }
    let (init, step) = (planned.recorded.init.id(), planned.recorded.step.id());
    let mut run = GpuRun { bytes: planned.plan.bytes_of(&[init, step]), gpu_clock: true, ..GpuRun::default() };
    run.start = start;
    let mut session = Session::start(gpu, planned)?;
    session.finish()?;
    let (count, dt_s) = (setup.count(), scene.solver.dt_s);
    let (mut done, mut forces) = (0, Vec::new());
    for due in setup.sample_steps() {
        while done < due {
            if (options.stop)() {
                run.stopped = true;
                return Ok(run);
            }
            let begun = std::time::Instant::now();
            session.submit(&FrameRequest { steps: 1, forces: true, ..FrameRequest::default() })?;
            if gpu.timing().is_measured() {
                let reports = session.reports();
                forces.extend(reports.iter().filter_map(force));
                run.keep(&reports, step);
            } else {
                forces.extend(session.finish()?.iter().filter_map(force));
                run.gpu_clock = false;
                run.step_ms.push(begun.elapsed().as_secs_f64() * 1e3);
            }
            done += 1;
            (options.progress)(done);
        }
        let reports = session.finish()?;
        forces.extend(reports.iter().filter_map(force));
        run.keep(&reports, step);
        session.measure()?;
        let time_s = due as f64 * dt_s;
        let measured = session.finish()?.into_iter().filter_map(|frame| frame.stats);
        run.measured.extend(measured.map(|stats| Measured { time_s, stats }));
        let particles = session.read_particles()?;
        let found = sample(time_s, &particles.positions, &particles.velocities, count);
        run.samples.push(Sample { forces: std::mem::take(&mut forces), ..found });
    }
    Ok(run)
}

impl GpuRun {
    fn keep(&mut self, reports: &[SessionReport], step: RecordingId) {
        for SessionReport { report, .. } in reports {
            let spans = || report.spans.iter().filter(|span| span.recording == step);
            let begin = spans().map(|span| span.begin_ticks).min();
            let end = spans().map(|span| span.end_ticks).max();
            if let (Some(begin), Some(end)) = (begin, end)
                && end > begin
            {
                self.step_ms.push((end - begin) as f64 * report.timestamp_period_ns * 1e-6);
            }
        }
    }

    /// Median and 95th percentile of the steps behind the first `warm_up`, of these runs together.
    pub fn cost(runs: &[GpuRun], warm_up: usize, dt_s: f64) -> Option<Cost> {
        let mut ms: Vec<f64> = runs.iter().flat_map(|run| run.step_ms.iter().skip(warm_up).copied()).collect();
        ms.sort_unstable_by(f64::total_cmp);
        let last = ms.len().checked_sub(1)?;
        let at = |share: f64| ms[((share * ms.len() as f64).ceil() as usize).saturating_sub(1).min(last)];
        Some(Cost {
            median_s_per_s: at(0.5) * 1e-3 / dt_s,
            p95_s_per_s: at(0.95) * 1e-3 / dt_s,
            timed_steps: ms.len() as u64,
            gpu_clock: runs.iter().all(|run| run.gpu_clock),
            bytes: runs.first()?.bytes,
        })
    }

    /// Events that were counted over the whole run.
    pub fn counted(&self) -> Counted {
        self.measured.iter().fold(Counted::default(), |sum, measured| sum.and(&measured.stats.counters))
    }
}

/// What pushed solids in a step; none of a frame that read nothing of it.
fn force(report: &SessionReport) -> Option<Force> {
    let on_solids_n: Vec<DVec3> = report.forces_n.iter().copied().map(DVec3::from_array).collect();
    (!on_solids_n.is_empty()).then_some(Force { time_s: report.simulated_s, on_solids_n })
}

/// Sorts what the GPU gave by id, and counts what is not as it should be.
fn sample(time_s: f64, positions: &[Position], velocities: &[Velocity], count: usize) -> Sample {
    let mut found = Sample {
        time_s,
        positions_m: vec![DVec3::NAN; count],
        velocities_m_s: vec![DVec3::NAN; count],
        unsound: positions.len().abs_diff(count),
        ..Sample::default()
    };
    for (position, velocity) in positions.iter().zip(velocities) {
        let id = id_of(position.tag) as usize;
        let twice = found.positions_m.get(id).is_none_or(|at| !at.is_nan());
        if twice {
            found.unsound += 1;
            continue;
        }
        found.positions_m[id] = position_m(position);
        found.velocities_m_s[id] = velocity_m_s(velocity);
        let finite = found.positions_m[id].is_finite() && found.velocities_m_s[id].is_finite();
        found.unsound += usize::from(!finite || is_quarantined(position.tag));
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use brooklet_kernels::QUARANTINED;

    #[test]
    fn samples_are_by_id_and_what_is_wrong_is_counted() {
        let position = |x: f32, tag| Position { position_m: [x, 0.0, 0.0], tag };
        let still = [Velocity::default(); 2];
        let sound = sample(1.0, &[position(2.0, 1), position(1.0, 0)], &still, 2);
        assert_eq!((sound.positions_m[0].x, sound.positions_m[1].x, sound.unsound), (1.0, 2.0, 0));
        let wrong = [
            vec![position(2.0, 1), position(1.0, 1)],
            vec![position(2.0, 1), position(1.0, 5)],
            vec![position(2.0, 1), position(f32::NAN, 0)],
            vec![position(2.0, 1), position(1.0, QUARANTINED)],
            vec![position(2.0, 1)],
        ];
        for positions in wrong {
            assert!(!sample(1.0, &positions, &still, 2).is_sound(), "{positions:?}");
        }
    }

    #[test]
    fn costs_leave_the_warm_up_out() {
        let run = GpuRun { step_ms: vec![100.0, 2.0, 1.0, 3.0], gpu_clock: true, ..GpuRun::default() };
        let cost = GpuRun::cost(&[run], 1, 0.01).unwrap();
        assert!((cost.median_s_per_s - 0.2).abs() < 1e-12 && (cost.p95_s_per_s - 0.3).abs() < 1e-12);
        assert_eq!(cost.timed_steps, 3);
        assert!(GpuRun::cost(&[], 0, 0.01).is_none());
    }
}
