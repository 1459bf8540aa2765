//! A scene running on a GPU: what every program that steps one goes through.

mod bodies;
mod plan;
mod relax;
mod state;

pub use plan::{ParticleSource, SessionPlan, SessionRecorder};
use relax::run_relaxation;
pub use relax::{MOST_ROUNDS, NO_COMPRESSION, Relaxation, relax_particles};

use std::collections::VecDeque;

use brooklet_gpu::{Engine, FrameReport, Gpu, GpuError, Plan, PlanError, RecordingId, ResourceId};
use brooklet_kernels::{Buffer, Position, WarmStart};
use thiserror::Error;

use crate::boundary::solids::solids_params;
use crate::drag::{Drag, DragPass};
use crate::drag_body::{BodyDrag, BodyDragPass};
use crate::measure::{Sample, Stats};
use crate::particles::ParticleSet;
use crate::scene::{Scene, Update, emitter_states};
use crate::slot_changes::{DrainBox, ParticleBlock, SlotChanges};
use crate::solid_forces::SolidForces;
use crate::solver::pbf::{self, IterationWeights};
use crate::step::Recorded;
use crate::step_params::step_params;

/// Why a session cannot start.
#[derive(Debug, Error)]
pub enum SessionError {
    /// The device.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// The recordings (a fault of the program).
    #[error(transparent)]
    Plan(#[from] PlanError),
}

/// What one frame does, in this order; by default nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct FrameRequest<'a> {
    /// Draws the fluid along before the steps, if the session was recorded with drag.
    pub drag: Option<&'a Drag>,
    /// Draws a body to a place likewise, if the scene has bodies.
    pub drag_body: Option<&'a BodyDrag>,
    /// Deactivates the particles in a box, if the session was recorded with changes of slots.
    pub deactivate: Option<&'a DrainBox>,
    /// Activates a block of particles, likewise. Those for which no slot is free are counted
    /// (`Counters::capacity_overflow`).
    pub activate: Option<&'a ParticleBlock>,
    /// Steps of the scene's `dt_s`.
    pub steps: u32,
    /// Measures after the steps, if the scene measures.
    pub measure: bool,
    /// Reads what pushes solids whose force is measured, after the steps; a measurement does so as well.
    pub forces: bool,
    /// Other recordings of the session's plan, after that.
    pub then: &'a [RecordingId],
    /// Samples the particles, if the session was recorded with samples.
    pub sample: bool,
    /// Buffers and textures whose content comes back with the frame's report, besides measurement and samples.
    pub readbacks: &'a [ResourceId],
}

/// A frame that the GPU is done with.
#[derive(Clone, Debug)]
pub struct SessionReport {
    /// Its number, GPU times and readbacks.
    pub report: FrameReport,
    /// Steps done at its end.
    pub steps: u64,
    /// Simulated time at its end, s.
    pub simulated_s: f64,
    /// Its measurement, if it measured.
    pub stats: Option<Stats>,
    /// The mean force of the fluid on each solid whose force is measured, N, since they were last read; none if this frame did
    /// not read them.
    pub forces_n: Vec<[f64; 3]>,
}

/// A frame handed to the GPU.
#[derive(Clone, Copy, Debug)]
struct InFlightFrame {
    frame: u64,
    steps: u64,
    simulated_s: f64,
}

/// From when on time is counted: with steps of one length it is their number times it, without a sum's rounding.
#[derive(Clone, Copy, Debug, Default)]
struct TimeBase {
    steps: u64,
    simulated_s: f64,
}

/// So many reports wait for whoever takes them; of more, the oldest go.
const MOST_KEPT: usize = 64;

/// A scene running on a GPU.
pub struct Session {
    engine: Engine,
    scene: Scene,
    recorded: Recorded,
    drag: Option<DragPass>,
    drag_body: Option<BodyDragPass>,
    slot_changes: Option<SlotChanges>,
    sample: Option<Sample>,
    relaxes: bool,
    start_relaxation: Option<Relaxation>,
    init: Vec<RecordingId>,
    steps: u64,
    since: TimeBase,
    stats: Option<Stats>,
    forces: Option<SolidForces>,
    in_flight: VecDeque<InFlightFrame>,
    kept: VecDeque<SessionReport>,
    // A frame's, kept for their memory.
    order: Vec<RecordingId>,
    readbacks: Vec<ResourceId>,
}

impl Session {
    /// Plans and starts a scene with its own particles.
    ///
    /// # Errors
    /// If the device lacks memory or limits for the scene.
    pub fn new(gpu: &Gpu, scene: &Scene) -> Result<Self, SessionError> {
        Ok(Self::start(gpu, SessionRecorder::new(scene, ParticleSource::Scene).sweep()?)?)
    }

    /// Takes the compression out of a scene's own particles, allocates what the plan keeps, fills it with them and runs
    /// the first recordings, each a frame of its own.
    ///
    /// # Errors
    /// If the device lacks memory or limits for the plan.
    pub fn start(gpu: &Gpu, planned: SessionPlan) -> Result<Self, GpuError> {
        Self::start_with_progress(gpu, planned, &mut |_, _, _| ())
    }

    /// [`Session::start`], saying how far it is, as [`Engine::new_with_progress`] does.
    ///
    /// # Errors
    /// As [`Session::start`].
    pub fn start_with_progress(
        gpu: &Gpu,
        planned: SessionPlan,
        progress: &mut dyn FnMut(usize, usize, &str),
    ) -> Result<Self, GpuError> {
        let SessionPlan {
            plan,
            recorded,
            scene,
            mut particles,
            bodies,
            diffuse,
            drag,
            drag_body,
            slot_changes,
            sample,
            relaxes,
            relaxation,
            init,
            start,
        } = planned;
        let start_relaxation = match (relaxation, &mut particles) {
            (Some(relaxation), Some(particles)) => run_relaxation(gpu, *relaxation, particles)?,
            _ => None,
        };
        let forces = SolidForces::of(recorded.bodies.as_ref(), start.simulated_s);
        let mut session = Self {
            engine: Engine::new_with_progress(gpu, plan, progress)?,
            scene,
            recorded,
            drag,
            drag_body,
            slot_changes,
            sample,
            relaxes,
            start_relaxation,
            init,
            steps: start.steps,
            since: start,
            stats: None,
            forces,
            in_flight: VecDeque::new(),
            kept: VecDeque::new(),
            order: Vec::new(),
            readbacks: Vec::new(),
        };
        if let Some(particles) = particles {
            session.write_particles(&particles);
        }
        session.write_bodies(&bodies);
        for recording in &session.init {
            session.engine.run(&[*recording], &[])?;
        }
        // Those clear them.
        session.write_emitter_states();
        if !diffuse.particles.is_empty() {
            session.write_diffuse(&diffuse);
        }
        Ok(session)
    }

    /// Hands a frame to the GPU; returns its number. Waits for nothing, unless
    /// [`brooklet_gpu::FRAMES_IN_FLIGHT`] are under way: then for the oldest.
    ///
    /// # Errors
    /// If the device is lost, what the request names is not in the plan, or a block cannot be activated.
    pub fn submit(&mut self, request: &FrameRequest<'_>) -> Result<u64, GpuError> {
        self.order.clear();
        self.readbacks.clear();
        if let (Some(pass), Some(drag)) = (&self.drag, request.drag) {
            pass.write(&mut self.engine, &self.scene, drag);
            self.order.push(pass.recording.id());
        }
        if let (Some(pass), Some(drag)) = (&self.drag_body, request.drag_body) {
            pass.write(&mut self.engine, &self.scene, drag);
            self.order.push(pass.recording.id());
        }
        if let (Some(changes), Some(drain)) = (&self.slot_changes, request.deactivate) {
            changes.write_drain(&mut self.engine, drain);
            self.order.push(changes.deactivate.id());
        }
        if let (Some(changes), Some(block)) = (&self.slot_changes, request.activate) {
            changes.write_block(&mut self.engine, block)?;
            self.order.push(changes.activate.id());
        }
        self.order.extend(std::iter::repeat_n(self.recorded.step.id(), request.steps as usize));
        if let Some(measure) = self.recorded.measure.as_ref().filter(|_| request.measure) {
            self.order.push(measure.recording.id());
            self.readbacks.push(measure.output.id);
        }
        if let Some(forces) = self.forces.as_ref().filter(|_| request.forces || request.measure) {
            self.readbacks.push(forces.reactions);
        }
        self.order.extend_from_slice(request.then);
        if let Some(sample) = self.sample.as_ref().filter(|_| request.sample) {
            self.order.push(sample.recording.id());
            self.readbacks.push(sample.samples.id);
        }
        self.readbacks.extend_from_slice(request.readbacks);
        let frame = self.engine.run(&self.order, &self.readbacks)?;
        self.steps += u64::from(request.steps);
        self.in_flight.push_back(InFlightFrame { frame, steps: self.steps, simulated_s: self.simulated_s() });
        if self.in_flight.len() >= MOST_KEPT {
            let reports = self.engine.reports();
            self.keep(reports);
        }
        Ok(frame)
    }

    /// One step, as a frame of its own.
    ///
    /// # Errors
    /// If the device is lost.
    pub fn step(&mut self) -> Result<(), GpuError> {
        self.submit(&FrameRequest { steps: 1, ..FrameRequest::default() }).map(drop)
    }

    /// One measurement, as a frame of its own: comes a frame or two later with [`Session::reports`] and
    /// [`Session::stats`]. A scene that does not measure has none.
    ///
    /// # Errors
    /// If the device is lost.
    pub fn measure(&mut self) -> Result<(), GpuError> {
        self.submit(&FrameRequest { measure: true, ..FrameRequest::default() }).map(drop)
    }

    /// Frames that came back since the last call, in order; of more than 64, the newest.
    pub fn reports(&mut self) -> Vec<SessionReport> {
        let reports = self.engine.reports();
        self.keep(reports);
        self.kept.drain(..).collect()
    }

    /// Waits for every frame in flight; returns the reports since the last call.
    ///
    /// # Errors
    /// If the device is lost; what came back before is still [`Session::reports`]'.
    pub fn finish(&mut self) -> Result<Vec<SessionReport>, GpuError> {
        let reports = self.engine.finish()?;
        self.keep(reports);
        Ok(self.kept.drain(..).collect())
    }

    fn keep(&mut self, reports: Vec<FrameReport>) {
        let measure = self.recorded.measure_id();
        for report in reports {
            // Frames that no request made, the first ones, are nobody's.
            while self.in_flight.pop_front_if(|handed| handed.frame < report.frame).is_some() {}
            let Some(handed) = self.in_flight.pop_front_if(|handed| handed.frame == report.frame) else { continue };
            let stats = measure.and_then(|id| report.readback(id)).map(|bytes| Stats::new(bytes, &self.scene));
            self.stats = stats.or(self.stats);
            let InFlightFrame { steps, simulated_s, .. } = handed;
            let forces_n = self
                .forces
                .as_mut()
                .and_then(|forces| Some(forces.take(report.readback(forces.reactions)?, &self.scene, simulated_s)))
                .unwrap_or_default();
            self.kept.push_back(SessionReport { report, steps, simulated_s, stats, forces_n });
        }
        self.kept.drain(..self.kept.len().saturating_sub(MOST_KEPT));
    }

    /// The newest measurement that has come back.
    pub fn stats(&mut self) -> Option<Stats> {
        let reports = self.engine.reports();
        self.keep(reports);
        self.stats
    }

    /// Waits, and copies the particles to the host, in cell order.
    ///
    /// # Errors
    /// If the device is lost.
    pub fn read_particles(&mut self) -> Result<ParticleSet, GpuError> {
        self.recorded.particles(&mut self.engine)
    }

    /// Replaces the particles by as many others, before the next frame. More are an error of the next frame.
    pub fn write_particles(&mut self, particles: &ParticleSet) {
        let slots = &self.recorded.slots;
        self.engine.write(&slots.state, &[slots.state_of(particles, self.simulated_s())]);
        self.engine.write(&self.recorded.positions, &particles.positions);
        self.engine.write(&self.recorded.velocities, &particles.velocities);
        // Whose pressure it was is another's now.
        self.begin_cold();
    }

    /// Emitters go on as if they had run until now.
    fn write_emitter_states(&mut self) {
        if let Some(states) = &self.recorded.emitter_states {
            self.engine.write(states, &emitter_states(&self.scene, self.simulated_s()));
        }
    }

    /// Leaves behind what does not fit the scene's settings of what those of `before` left.
    fn go_on_after(&mut self, before: &Scene) -> Result<(), GpuError> {
        if before.solver != self.scene.solver {
            // Pressure that balanced other substeps, or came of another kernel.
            self.begin_cold();
        }
        self.relax_after(before)
    }

    /// The next substep begins with nothing of the last one's pressure and forces.
    fn begin_cold(&mut self) {
        if let Some(warm_starts) = &self.recorded.warm_starts {
            self.engine.write(warm_starts, &vec![WarmStart::default(); warm_starts.len as usize]);
        }
        for pressures in &self.recorded.pressures {
            self.engine.write(pressures, &vec![0.0; pressures.len as usize]);
        }
        if let Some(accelerations) = &self.recorded.accelerations {
            self.engine.write(accelerations, &vec![[0.0; 4]; accelerations.len as usize]);
        }
    }

    /// Goes on as `planned`, which was made as this session's plan was, of another scene: from the next frame on,
    /// if only numbers are another. False if it needs a session of its own, which may [`Session::adopt`] this
    /// one's particles; nothing is changed then. What was added to the plan beside the scene is compared as well.
    ///
    /// # Errors
    /// If the device is lost.
    pub fn apply(&mut self, planned: &SessionPlan) -> Result<bool, GpuError> {
        let resets = self.scene.change_to(&planned.scene).update == Update::Reset;
        if resets || !self.engine.take_uploads(&planned.plan, &self.init)? {
            return Ok(false);
        }
        self.since = TimeBase { steps: self.steps, simulated_s: self.simulated_s() };
        let before = std::mem::replace(&mut self.scene, planned.scene.clone());
        self.go_on_after(&before)?;
        Ok(true)
    }

    /// Other gravity from the next frame on, m/s², of a domain of two dimensions its part in their plane: as if the scene had
    /// been planned with it, without a plan. Values that are no numbers change nothing.
    pub fn set_gravity(&mut self, mut gravity_m_s2: [f64; 3]) {
        if self.scene.domain.dimensions == 2 {
            gravity_m_s2[2] = 0.0;
        }
        if gravity_m_s2 == self.scene.gravity_m_s2 || !gravity_m_s2.iter().all(|g| g.is_finite()) {
            return;
        }
        let before = pbf::separation_lambda(&self.scene);
        self.scene.gravity_m_s2 = gravity_m_s2;
        self.engine.write_uploaded(&self.recorded.step_params, &[step_params(&self.scene)]);
        if let Some(params) = &self.recorded.solids_params {
            self.engine.write_uploaded(params, &[solids_params(&self.scene)]);
        }
        if let Some(params) = &self.recorded.pbf_params
            && before != pbf::separation_lambda(&self.scene)
        {
            let weights = IterationWeights::of(&self.scene);
            self.engine.write_uploaded(params, &[pbf::params(&self.scene, &weights)]);
        }
    }

    /// Takes over the state of `old`, the same particles in another plan, without a way over the host: every
    /// buffer that both have by name and size, but those that the first recordings fill; and its time.
    ///
    /// # Errors
    /// If the device is lost.
    pub fn adopt(&mut self, old: &Session) -> Result<(), GpuError> {
        self.engine.adopt(&old.engine, &self.init)?;
        if let Some(forces) = &mut self.forces {
            forces.begin_anew();
        }
        self.steps = old.steps;
        self.since = TimeBase { steps: old.steps, simulated_s: old.simulated_s() };
        if old.scene.emitters != self.scene.emitters {
            self.write_emitter_states();
        }
        self.go_on_after(&old.scene)
    }

    /// Runs with other modules from the next frame on: `plan` is this session's with some of them exchanged
    /// ([`Plan::with_modules`]).
    ///
    /// # Errors
    /// If the driver refuses one; what ran before then goes on.
    pub fn swap_modules(&mut self, plan: Plan) -> Result<(), GpuError> {
        self.engine.swap_modules(plan)
    }

    /// The scene.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// What was taken out of the scene's particles before time began; none of particles from elsewhere.
    pub fn start_relaxation(&self) -> Option<Relaxation> {
        self.start_relaxation
    }

    /// Steps done.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Simulated time, s.
    pub fn simulated_s(&self) -> f64 {
        self.since.simulated_s + (self.steps - self.since.steps) as f64 * self.scene.solver.dt_s
    }

    /// Number of slots: of particles, where a scene says no capacity.
    pub fn slot_count(&self) -> u32 {
        self.recorded.slots.capacity
    }

    /// The positions' buffer on the GPU, for drawing without a copy.
    pub fn positions(&self) -> &Buffer<Position> {
        &self.recorded.positions
    }

    /// The simulation's recordings and buffers.
    pub fn recorded(&self) -> &Recorded {
        &self.recorded
    }

    /// A step's recording, which names its spans.
    pub fn step_id(&self) -> RecordingId {
        self.recorded.step.id()
    }

    /// The samples among a report's readbacks, if the session was recorded with samples.
    pub fn samples_id(&self) -> Option<ResourceId> {
        self.sample.as_ref().map(|sample| sample.samples.id)
    }

    /// What runs it.
    pub fn engine(&self) -> &Engine {
        &self.engine
    }

    /// What runs it, to read and write what was added to the plan. Reports are taken from the session.
    pub fn engine_mut(&mut self) -> &mut Engine {
        &mut self.engine
    }
}
