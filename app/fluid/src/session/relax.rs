//! Takes out compression while time stands.
//!
//! A solver that makes velocities of corrections makes them of any compression that it finds, the more the shorter
//! the substep: what a start or a change of settings leaves over has to go before time goes on. Not in substeps: fluid
//! at rest is compressed, and that is its pressure.

use std::collections::HashMap;

use brooklet_gpu::{Gpu, GpuError, PlanError, RecordingId};

use super::{ParticleSource, Session, SessionError, SessionPlan, SessionRecorder};
use crate::measure::{Stats, Summary};
use crate::particles::{ParticleSet, id_of};
use crate::scene::Scene;
use crate::solver::pbf::IterationWeights;

/// Compression that is none. Of a block of lattice between walls, whose integral stands for a lattice's sum, it is at
/// most 1.2e-4 (mean), 8.7e-4 (99 of 100) and 1.3e-3 (largest) in the shipped scenes.
pub const NO_COMPRESSION: Summary = Summary { mean: 2.0e-4, p99: 1.0e-3, max: 2.0e-3 };
/// Rounds at most. A round spreads compression as a substep does: it takes a column of n layers some n²/10.
pub const MOST_ROUNDS: u32 = 256;
/// Rounds from one measurement to the next at most, from one on doubled each time.
const MOST_UNMEASURED: u32 = 16;
/// Of compression, left after so many rounds: what goes no faster would take thousands, or is held between walls.
const NO_LESS: f64 = 0.99;

/// What [`Session::relax`] did.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Relaxation {
    /// Rounds of a substep's iterations; 0 where there was nothing to take out.
    pub rounds: u32,
    /// Compression before and after.
    pub compression: [Summary; 2],
}

impl Summary {
    /// Whether none of its values is larger than that of `limit`.
    pub fn is_within(&self, limit: &Self) -> bool {
        self.mean <= limit.mean && self.p99 <= limit.p99 && self.max <= limit.max
    }

    /// The larger of each two values.
    fn or(&self, other: &Self) -> Self {
        Self { mean: self.mean.max(other.mean), p99: self.p99.max(other.p99), max: self.max.max(other.max) }
    }

    /// Whether one of its values is less than before.
    fn is_less(&self, before: &Self) -> bool {
        let pairs = [(self.mean, before.mean), (self.p99, before.p99), (self.max, before.max)];
        pairs.iter().any(|(now, before)| *now < NO_LESS * before)
    }
}

/// Takes out the compression of particles that nobody simulated yet, with a plan of its own, which is gone when this
/// returns: what then runs has no pass and no buffer of it. Particles stay in their order, and are the same bit for bit
/// where there was nothing to take out. None where they do not interact.
///
/// # Errors
/// If the device lacks memory or limits for the scene, or is lost.
pub fn relax_particles(
    gpu: &Gpu,
    scene: &Scene,
    particles: &mut ParticleSet,
) -> Result<Option<Relaxation>, SessionError> {
    match plan_relaxation(scene, particles.positions.len() as u32)? {
        Some(planned) => Ok(run_relaxation(gpu, planned, particles)?),
        None => Ok(None),
    }
}

/// What takes out the compression of so many particles; none where they do not interact or are none.
pub(super) fn plan_relaxation(scene: &Scene, count: u32) -> Result<Option<SessionPlan>, PlanError> {
    if !scene.solver.method.relaxes() || count == 0 {
        return Ok(None);
    }
    let mut scene = scene.clone();
    scene.outputs.measure_every_steps = 1;
    SessionRecorder::new(&scene, ParticleSource::Count(count)).with_relaxation().sweep().map(Some)
}

pub(super) fn run_relaxation(
    gpu: &Gpu,
    planned: SessionPlan,
    particles: &mut ParticleSet,
) -> Result<Option<Relaxation>, GpuError> {
    let mut session = Session::start(gpu, planned)?;
    session.write_particles(particles);
    let done = session.relax_start()?;
    if done.is_some_and(|done| done.rounds > 0) {
        let moved = session.read_particles()?;
        let at_m: HashMap<u32, [f32; 3]> = moved.positions.iter().map(|at| (id_of(at.tag), at.position_m)).collect();
        for position in &mut particles.positions {
            position.position_m = at_m.get(&id_of(position.tag)).copied().unwrap_or(position.position_m);
        }
    }
    Ok(done)
}

impl Session {
    /// Takes out compression until it is within `limit` or [`NO_COMPRESSION`], or some rounds took out no more. No
    /// particle gets faster and time stands. Nothing if the session was recorded without relaxation or does not
    /// measure, or its particles do not interact. Waits for the GPU.
    ///
    /// # Errors
    /// If the device is lost.
    pub fn relax(&mut self, limit: &Summary) -> Result<Option<Relaxation>, GpuError> {
        self.relax_to(|_| *limit)
    }

    /// As [`Session::relax`], to a limit that follows from the compression before.
    fn relax_to(&mut self, limit: impl FnOnce(&Summary) -> Summary) -> Result<Option<Relaxation>, GpuError> {
        if !self.relaxes || self.recorded.measure.is_none() || !self.scene.solver.method.relaxes() {
            return Ok(None);
        }
        let list = self.recorded.relaxation.list.id();
        let relax = self.recorded.relaxation.relax.id();
        let Some(before) = self.measure_now(&[list])? else { return Ok(None) };
        let limit = limit(&before.compression).or(&NO_COMPRESSION);
        let is_enough = |now: &Summary| now.is_within(&limit);
        let (mut after, mut rounds, mut next) = (before.compression, 0, 1);
        while !is_enough(&after) && rounds < MOST_ROUNDS {
            let now = vec![relax; next as usize];
            let Some(stats) = self.measure_now(&[&now[..], &[list]].concat())? else { break };
            let stands = next == MOST_UNMEASURED && !stats.compression.is_less(&after);
            after = stats.compression;
            rounds += next;
            if stands {
                break;
            }
            next = (2 * next).min(MOST_UNMEASURED).min(MOST_ROUNDS - rounds);
        }
        Ok(Some(Relaxation { rounds, compression: [before.compression, after] }))
    }

    /// Takes out all compression: of particles that nobody simulated yet.
    ///
    /// # Errors
    /// If the device is lost.
    pub fn relax_start(&mut self) -> Result<Option<Relaxation>, GpuError> {
        self.relax(&NO_COMPRESSION)
    }

    /// Takes out what the scene's settings do not leave of the compression under those of `before`.
    pub(super) fn relax_after(&mut self, before: &Scene) -> Result<(), GpuError> {
        let left = share_left(before, &self.scene);
        if left >= 1.0 {
            return Ok(());
        }
        self.relax_to(|&Summary { mean, p99, max }| Summary { mean: left * mean, p99: left * p99, max: left * max })
            .map(drop)
    }

    /// Runs recordings and measures, and waits for it.
    fn measure_now(&mut self, recordings: &[RecordingId]) -> Result<Option<Stats>, GpuError> {
        let Some(measure) = &self.recorded.measure else { return Ok(None) };
        let (run, output) = (measure.recording.id(), measure.output.id);
        let frame = self.engine.run(&[recordings, &[run]].concat(), &[output])?;
        let reports = self.engine.finish()?;
        let mine = reports.iter().find(|report| report.frame == frame);
        let stats = mine.and_then(|report| report.readback(output)).map(|bytes| Stats::new(bytes, &self.scene));
        self.keep(reports);
        Ok(stats)
    }
}

/// Compression of fluid at rest under the settings of `after` over that under those of `before`: by the column law it
/// goes with g dt² over what a substep's iterations do. None of it where they weigh neighbours otherwise.
fn share_left(before: &Scene, after: &Scene) -> f64 {
    let weighs = |scene: &Scene| (scene.solver.method, scene.solver.support_ratio, scene.domain.dimensions);
    if weighs(before) != weighs(after) || before.spacing_m != after.spacing_m {
        return 0.0;
    }
    let law = |scene: &Scene| {
        let g_m_s2 = scene.gravity_length_m_s2();
        // Without gravity it is an impact's, which is left as it is.
        g_m_s2.max(f64::MIN_POSITIVE) * scene.substep_s().powi(2) / IterationWeights::of(scene).response
    };
    law(after) / law(before)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shorter_substeps_more_iterations_and_less_gravity_leave_less() {
        let scene = Scene::load("calm-pool", &["solver.substeps=1".into()]).unwrap();
        let left = |setting: &str| share_left(&scene, &scene.with_setting(setting).unwrap());
        assert!((left("solver.substeps=8") * 64.0 - 1.0).abs() < 1e-9, "{}", left("solver.substeps=8"));
        assert!(left("solver.pbf.iterations=8") < 0.5);
        assert!(left("gravity_m_s2=[0, -1, 0]") < 0.11 && left("gravity_m_s2=[9.81, 0, 0]") > 0.99);
        assert_eq!(left("solver.support_ratio=2.5"), 0.0);
        assert!(left("solver.pbf.iterations=2") > 1.0 && left("forces.xsph=0.2") == 1.0);
    }
}
