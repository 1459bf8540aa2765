//! The simulation and its engine together, for a program that only simulates.

use brooklet_gpu::{Engine, Gpu, GpuError, Plan, PlanError, RecordingId, Resources};
use brooklet_kernels::{Buffer, Position, ResourceId, Velocity};
use thiserror::Error;

use crate::measure::Stats;
use crate::scene::Scene;
use crate::step::record;

/// A scene running on a GPU.
pub struct Simulation {
    engine: Engine,
    scene: Scene,
    positions: Buffer<Position>,
    velocities: Buffer<Velocity>,
    step: RecordingId,
    measure: Option<(RecordingId, ResourceId)>,
    latest: Option<Stats>,
    /// Frames since reports were last taken from the engine, which keeps each one until then.
    frames_kept: usize,
}

/// Frames after which reports are taken from the engine even if nobody asks.
const MOST_FRAMES_KEPT: usize = 64;

/// Why a simulation cannot start or go on.
#[derive(Debug, Error)]
pub enum SimulationError {
    /// The device.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// The recordings (a fault of this program).
    #[error(transparent)]
    Plan(#[from] PlanError),
}

impl Simulation {
    /// Plans the scene, allocates what the plan keeps, and uploads the particles.
    ///
    /// # Errors
    /// If the device lacks memory or limits for the scene.
    pub fn new(gpu: &Gpu, scene: &Scene) -> Result<Self, SimulationError> {
        let mut resources = Resources::new();
        let recorded = record(&mut resources, scene);
        let measure = recorded.measure.as_ref().map(|measure| (measure.recording.id(), measure.output.id));
        let plan = Plan::sweep(resources, recorded.recordings(), recorded.measure_id().as_slice())?;
        let mut engine = Engine::new(gpu, plan)?;
        engine.run(&[recorded.init.id()], &[])?;
        Ok(Self {
            engine,
            scene: scene.clone(),
            positions: recorded.positions,
            velocities: recorded.velocities,
            step: recorded.step.id(),
            measure,
            latest: None,
            frames_kept: 0,
        })
    }

    /// Advances by the scene's `dt_s`. Returns before the GPU is done.
    ///
    /// # Errors
    /// If the device is lost.
    pub fn step(&mut self) -> Result<(), SimulationError> {
        self.run(self.step, &[])
    }

    fn run(&mut self, recording: RecordingId, readbacks: &[ResourceId]) -> Result<(), SimulationError> {
        self.engine.run(&[recording], readbacks)?;
        self.frames_kept += 1;
        if self.frames_kept >= MOST_FRAMES_KEPT {
            self.stats();
        }
        Ok(())
    }

    /// Measures the state; the result arrives a frame or two later in [`Simulation::stats`].
    ///
    /// # Errors
    /// If the device is lost.
    pub fn measure(&mut self) -> Result<(), SimulationError> {
        if let Some((recording, output)) = self.measure {
            self.run(recording, &[output])?;
        }
        Ok(())
    }

    /// The newest measurement that has arrived.
    pub fn stats(&mut self) -> Option<Stats> {
        self.frames_kept = 0;
        for report in self.engine.reports() {
            self.keep(&report);
        }
        self.latest
    }

    /// Waits for all that was asked for; returns the newest measurement.
    ///
    /// # Errors
    /// If the device is lost.
    pub fn finish(&mut self) -> Result<Option<Stats>, SimulationError> {
        self.frames_kept = 0;
        for report in self.engine.finish()? {
            self.keep(&report);
        }
        Ok(self.latest)
    }

    fn keep(&mut self, report: &brooklet_gpu::FrameReport) {
        for (id, bytes) in &report.readbacks {
            if self.measure.is_some_and(|(_, output)| *id == output) {
                self.latest = Some(Stats::new(bytes, &self.scene));
            }
        }
    }

    /// Waits, and copies the particles to the host, in cell order.
    ///
    /// # Errors
    /// If the device is lost.
    pub fn particles(&mut self) -> Result<(Vec<Position>, Vec<Velocity>), SimulationError> {
        Ok((self.engine.read(&self.positions)?, self.engine.read(&self.velocities)?))
    }

    /// Replaces the particles; as many as there are.
    pub fn set_particles(&mut self, positions: &[Position], velocities: &[Velocity]) {
        self.engine.write(&self.positions, positions);
        self.engine.write(&self.velocities, velocities);
    }

    /// The positions' buffer on the GPU, for drawing without a copy.
    pub fn positions(&self) -> &Buffer<Position> {
        &self.positions
    }

    /// What runs the simulation. Its reports of GPU times are for whoever takes them within 64
    /// steps: the simulation takes them too, for the measurements in them, so that they do not pile up.
    pub fn engine(&mut self) -> &mut Engine {
        &mut self.engine
    }

    /// The scene.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }
}
