//! A scene as recordings: its start, one step of its solver's substeps, and its measurement.

use brooklet_gpu::{Engine, GpuError, Plan, Recording, RecordingId, Resources};
use brooklet_kernels::{
    Buffer, Counters, EmitterState, Measure, PbfParams, Position, ResourceId, SolidPose, SolidsParams, StepParams,
    Velocity, WarmStart,
};

use crate::body_motion::BodyMotion;
use crate::boundary::bodies::BodyBuffers;
use crate::diffuse::{Diffuse, DiffuseSlots};
use crate::forces::BodyForces;
use crate::grid::Neighbours;
use crate::measure::{Densities, Measuring};
use crate::particles::buffers::Particles;
use crate::particles::{ParticleSet, sample_lattice};
use crate::scene::{Scene, poses_before};
use crate::slots::Slots;
use crate::solver::Solver;
use crate::step_context::StepContext;
use crate::step_params::step_params;

/// A scene as recordings, and the buffers others read.
pub struct Recorded {
    /// The slots that its particles stand in.
    pub slots: Slots,
    /// Uploads the scene; to be run once, first.
    pub init: Recording,
    /// One step.
    pub step: Recording,
    /// A measurement, if the scene measures.
    pub measure: Option<RecordedMeasure>,
    /// What takes out compression while time stands. In a plan only where it is asked for
    /// ([`crate::SessionRecorder::with_relaxation`]); it has no buffers of its own.
    pub relaxation: RecordedRelaxation,
    /// Where the particles are after a step, relative to the domain's lowest corner; in cell
    /// order, named by the ids in their tags.
    pub positions: Buffer<Position>,
    /// Their velocities, in the same order.
    pub velocities: Buffer<Velocity>,
    /// Their neighbours, as the last step listed them; `None` of particles that do not interact.
    pub neighbours: Option<Neighbours>,
    /// What a substep begins with of the last one's pressure; none of scenes that begin cold.
    pub warm_starts: Option<Buffer<WarmStart>>,
    /// With which pressures a substep's solves begin; none of solvers that begin cold.
    pub pressures: Vec<Buffer<f32>>,
    /// What a substep takes of the last one's acceleration; none of solvers that keep none.
    pub accelerations: Option<Buffer<[f32; 4]>>,
    /// What lasts of emitters from substep to substep; none of scenes without.
    pub emitter_states: Option<Buffer<EmitterState>>,
    /// What the shaders are told of a step, gravity among it.
    pub step_params: Buffer<StepParams>,
    /// What the solids' are told, if there are any.
    pub solids_params: Option<Buffer<SolidsParams>>,
    /// Where solids are.
    pub solid_poses: Option<Buffer<SolidPose>>,
    /// What lasts of those that the fluid moves, if there are any.
    pub bodies: Option<BodyBuffers>,
    /// What the density constraint's are told, if that is the solver.
    pub pbf_params: Option<Buffer<PbfParams>>,
    /// Spray, foam and bubbles, if there are any.
    pub diffuse: Option<DiffuseSlots>,
    /// Events since the last measurement.
    pub counters: Buffer<Counters>,
    /// What their density ratios are computed from, if they have neighbours.
    pub densities: Option<Densities>,
}

/// What measures a scene.
pub struct RecordedMeasure {
    /// To be run after the steps of a frame.
    pub recording: Recording,
    /// What it writes, and a frame reads back ([`crate::Stats::new`]).
    pub output: Buffer<Measure>,
}

/// What takes out compression while time stands.
pub struct RecordedRelaxation {
    /// Lists the particles' neighbours where they are, so that they can be measured.
    pub list: Recording,
    /// Moves them by a substep's iterations; leaves velocities and time alone.
    pub relax: Recording,
}

impl Recorded {
    /// All of its recordings, for a plan.
    pub fn recordings(&self) -> Vec<Recording> {
        let measure = self.measure.as_ref().map(|measure| measure.recording.clone());
        [self.init.clone(), self.step.clone()].into_iter().chain(measure).collect()
    }

    /// The handles of all of its recordings.
    pub fn ids(&self) -> Vec<RecordingId> {
        let measure = self.measure.as_ref().map(|measure| measure.recording.id());
        [self.init.id(), self.step.id()].into_iter().chain(measure).collect()
    }

    /// Bytes of GPU memory that all of its recordings take in `plan`, over the particles; none without particles.
    /// What is drawn grows with pixels, not with particles, and does not count.
    pub fn bytes_per_particle(&self, plan: &Plan) -> Option<f64> {
        let particles = self.slots.capacity;
        (particles > 0).then(|| plan.bytes_of(&self.ids()) as f64 / f64::from(particles))
    }

    /// As [`Recorded::bytes_per_particle`], but for what stands in memory that others of the plan, its pictures, need in any
    /// case.
    pub fn own_bytes_per_particle(&self, plan: &Plan) -> Option<f64> {
        let particles = self.slots.capacity;
        (particles > 0).then(|| plan.own_bytes_of(&self.ids()) as f64 / f64::from(particles))
    }

    /// What a measurement is read back from, if the scene measures.
    pub fn measure_id(&self) -> Option<ResourceId> {
        self.measure.as_ref().map(|measure| measure.output.id)
    }

    /// What is read back of a scene: its measurement, and the reactions of solids whose force is measured.
    pub fn measured_ids(&self) -> Vec<ResourceId> {
        let forces = self.bodies.as_ref().filter(|bodies| bodies.measured() > 0);
        self.measure_id().into_iter().chain(forces.map(|of| of.reactions.id)).collect()
    }

    /// Waits, and copies the particles to the host, in cell order: to save them, or to carry them over
    /// to another plan with [`record_particles`].
    ///
    /// # Errors
    /// If the device is lost.
    pub fn particles(&self, engine: &mut Engine) -> Result<ParticleSet, GpuError> {
        Ok(ParticleSet { positions: engine.read(&self.positions)?, velocities: engine.read(&self.velocities)? })
    }
}

/// Declares the scene's buffers in `resources` and records its chain.
pub fn record(resources: &mut Resources, scene: &Scene) -> Recorded {
    record_particles(resources, scene, sample_lattice(scene))
}

/// As [`record`], with particles of the caller's instead of the scene's fluids.
pub fn record_particles(resources: &mut Resources, scene: &Scene, mut particles: ParticleSet) -> Recorded {
    particles.fill_slots(scene.slot_capacity().unwrap_or_default());
    let mut recorded = record_count(resources, scene, particles.positions.len() as u32);
    let state = recorded.slots.state_of(&particles, 0.0);
    recorded.init.upload(&mut recorded.slots.state, &[state]);
    recorded.init.upload(&mut recorded.positions, &particles.positions);
    recorded.init.upload(&mut recorded.velocities, &particles.velocities);
    let motion = BodyMotion::first(scene);
    if let Some(poses) = &mut recorded.solid_poses {
        recorded.init.upload(poses, &poses_before(scene, &motion.states));
    }
    if let Some(bodies) = &mut recorded.bodies {
        recorded.init.upload(&mut bodies.states, &motion.states);
        recorded.init.upload(&mut bodies.reactions, &motion.reactions);
    }
    recorded
}

/// As [`record`], for so many slots that nobody uploads: what a plan is like, at a cost that does not grow with
/// them. None is visited until `Engine::write` has given particles and a [`Slots::state_of`].
pub fn record_count(resources: &mut Resources, scene: &Scene, capacity: u32) -> Recorded {
    let mut context = StepContext::declare(resources, scene, capacity);
    let mut diffuse = Diffuse::declare(resources, scene, capacity);
    let mut particles = Particles::declare(resources, capacity);
    let mut body_forces = BodyForces::declare(resources, scene);
    let mut solver = Solver::declare(resources, scene, capacity);

    let mut init = resources.recording("init");
    init.upload(&mut context.step, &[step_params(scene)]);
    init.clear(&mut context.counters);
    if let Some(body_forces) = &mut body_forces {
        body_forces.record_init(&mut init, scene);
    }
    if let Some(repel_walls) = &mut context.repel_walls {
        repel_walls.record_init(&mut init, scene);
    }
    if let Some(drag_walls) = &mut context.drag_walls {
        drag_walls.record_init(&mut init, scene);
    }
    if let Some(solids) = &mut context.solids {
        solids.record_init(&mut init, scene);
    }
    if let Some(diffuse) = &mut diffuse {
        diffuse.record_init(&mut init, scene);
    }
    if let Some(sources) = &mut context.sources {
        sources.record_init(&mut init, scene, capacity);
    }
    solver.record_init(&mut init, scene);

    let mut step = resources.recording("step");
    for substep in 1..=scene.substeps() {
        solver.begin_substep(&mut step, &mut context);
        if let Some(sources) = &mut context.sources {
            sources.record(&mut step, &mut context.slots, &mut context.counters, &mut particles);
        }
        if let Some(solids) = &mut context.solids {
            solids.record_step(&mut step);
            solids.record_move(&mut step);
        }
        if let Some(body_forces) = &body_forces {
            body_forces.record(&mut step, &context, &mut particles);
        }
        solver.record_substep(&mut step, &mut context, &mut particles);
        if let Some(repel_walls) = &context.repel_walls {
            repel_walls.record(&mut step, &context, &mut particles);
        }
        if let (Some(drag_walls), Some(search)) = (&context.drag_walls, solver.search()) {
            drag_walls.record(&mut step, &context, search, &mut particles);
        }
        let is_last = substep == scene.substeps();
        let due = diffuse.as_mut().filter(|diffuse| diffuse.each_substep || is_last);
        if let (Some(diffuse), Some(search)) = (due, solver.search()) {
            diffuse.record(&mut step, &mut context, search, &particles);
        }
        // Nothing but particles and their slots lasts from one to the next.
        step.forget_transients();
    }
    context.slots.end_step(&mut step);

    let mut relaxation = RecordedRelaxation { list: resources.recording("list"), relax: resources.recording("relax") };
    let RecordedRelaxation { list, relax } = &mut relaxation;
    solver.record_relaxation([list, relax], &mut context, &mut particles);

    let measure = (scene.outputs.measure_every_steps > 0).then(|| {
        let mut measuring = Measuring::declare(resources, capacity);
        let mut recording = resources.recording("measure");
        measuring.record(&mut recording, &mut context, solver.search(), &particles);
        RecordedMeasure { recording, output: measuring.measure }
    });
    Recorded {
        init,
        step,
        measure,
        relaxation,
        neighbours: solver.search().map(|search| search.neighbours.alias()),
        warm_starts: solver.warm_starts().map(Buffer::alias),
        pressures: solver.pressures(),
        accelerations: solver.accelerations().map(Buffer::alias),
        densities: solver.search().map(|search| Densities::of(&context, search)),
        solids_params: context.solids.as_ref().map(|solids| solids.params().alias()),
        solid_poses: context.solids.as_ref().map(|solids| solids.poses().alias()),
        bodies: context.solids.as_ref().and_then(|solids| solids.bodies().map(BodyBuffers::alias)),
        emitter_states: context.sources.as_ref().and_then(|sources| sources.emitter_states()).map(Buffer::alias),
        diffuse: diffuse.as_ref().map(|diffuse| diffuse.slots().alias()),
        step_params: context.step.alias(),
        pbf_params: solver.pbf_params().map(Buffer::alias),
        slots: context.slots,
        counters: context.counters,
        positions: particles.positions,
        velocities: particles.velocities,
    }
}
