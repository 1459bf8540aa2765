//! Takes out compression while time stands.
//!
//! A solver that makes velocities of corrections makes them of any compression that it finds, the more the shorter
//! the substep: what a start or a change of settings leaves over has to go before time goes on. Not in substeps: fluid
//! at rest is compressed, and that is its pressure.

use brooklet_gpu::{GpuError, RecordingId};

use super::Session;
use crate::measure::{Stats, Summary};
use crate::scene::{Method, Scene};
use crate::solver::pbf::IterationWeights;

/// Mean compression that is none: of a block of lattice between walls, whose integral stands for a lattice's sum, it is
/// 5e-5 to 1.2e-4 in the shipped scenes.
pub const NO_COMPRESSION: f64 = 2.0e-4;
/// Rounds at most. A round spreads compression as a substep does: it takes a column of n layers some n²/10.
pub const MOST_ROUNDS: u32 = 256;
/// Rounds from one measurement to the next at most, from one on doubled each time.
const MOST_UNMEASURED: u32 = 16;

/// What [`Session::relax`] did.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Relaxation {
    /// Rounds of a substep's iterations; 0 where there was nothing to take out.
    pub rounds: u32,
    /// Compression before and after.
    pub compression: [Summary; 2],
}

impl Session {
    /// Takes out compression until its mean is at most `mean`, or [`NO_COMPRESSION`], or many rounds took out no
    /// more. No particle gets faster and time stands. Nothing if the session was recorded without relaxation or does
    /// not measure, or its particles do not interact. Waits for the GPU.
    ///
    /// # Errors
    /// If the device is lost.
    pub fn relax(&mut self, mean: f64) -> Result<Option<Relaxation>, GpuError> {
        if !self.relaxes || self.recorded.measure.is_none() || self.scene.solver.method == Method::None {
            return Ok(None);
        }
        let list = self.recorded.relaxation.list.id();
        let relax = self.recorded.relaxation.relax.id();
        let Some(before) = self.measure_now(&[list])? else { return Ok(None) };
        let enough = mean.max(NO_COMPRESSION);
        let (mut after, mut rounds, mut next) = (before, 0, 1);
        while after.compression.mean > enough && rounds < MOST_ROUNDS {
            let now = vec![relax; next as usize];
            let Some(stats) = self.measure_now(&[&now[..], &[list]].concat())? else { break };
            after = stats;
            rounds += next;
            next = (2 * next).min(MOST_UNMEASURED).min(MOST_ROUNDS - rounds);
        }
        Ok(Some(Relaxation { rounds, compression: [before.compression, after.compression] }))
    }

    /// Takes out all compression: of particles that nobody simulated yet.
    ///
    /// # Errors
    /// If the device is lost.
    pub fn relax_start(&mut self) -> Result<Option<Relaxation>, GpuError> {
        self.relax(NO_COMPRESSION)
    }

    /// Takes out what the scene's settings do not leave of the compression under those of `before`.
    pub(super) fn relax_after(&mut self, before: &Scene) -> Result<(), GpuError> {
        let left = share_left(before, &self.scene);
        if left >= 1.0 || !self.relaxes {
            return Ok(());
        }
        let list = self.recorded.relaxation.list.id();
        if let Some(stats) = self.measure_now(&[list])? {
            self.relax(left * stats.compression.mean)?;
        }
        Ok(())
    }

    /// Runs recordings and measures, and waits for it.
    fn measure_now(&mut self, recordings: &[RecordingId]) -> Result<Option<Stats>, GpuError> {
        let Some(measure) = &self.recorded.measure else { return Ok(None) };
        let (run, output) = (measure.recording.id(), measure.output.id);
        let frame = self.engine.run(&[recordings, &[run]].concat(), &[output])?;
        let reports = self.engine.finish()?;
        let mine = reports.iter().find(|report| report.frame == frame);
        let bytes = mine.and_then(|report| report.readbacks.iter().find(|(id, _)| *id == output));
        let stats = bytes.map(|(_, bytes)| Stats::new(bytes, &self.scene));
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
        let g_m_s2 = scene.gravity_m_s2.iter().map(|g| g * g).sum::<f64>().sqrt();
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
