//! A scene on the GPU, as the window shows it: simulated, measured, drawn, step by step.

use std::collections::BTreeSet;

use brooklet_fluid::interact::{Drag, Push, record_push};
use brooklet_fluid::measure::{Sample, record_sample};
use brooklet_fluid::particles::{ParticleSet, resample, sample_lattice};
use brooklet_fluid::{Recorded, Scene, record_count};
use brooklet_gpu::{Command, Engine, Gpu, Plan, RecordingId, ResourceId, Resources};
use brooklet_kernels::{Position, Velocity};
use brooklet_render::frame::FrameValues;
use brooklet_render::left_out::{self, Absent};
use brooklet_render::{Camera, FrameOptions, FramePasses, ScenePlan, View};

use crate::WorldError;
use crate::ladder::Rung;
use crate::reload::NewModules;

/// What a world is made from.
#[derive(Clone, Debug)]
pub struct Order {
    /// The scene as it was chosen, before the ladder.
    pub scene: Scene,
    /// What the ladder gives up.
    pub rung: Rung,
    /// Size of the window, pixels.
    pub window_px: [u32; 2],
    /// From where it is seen.
    pub camera: Camera,
    /// Where its particles come from.
    pub start: Start,
    /// Shaders that were compiled anew.
    pub modules: NewModules,
    /// Why it is made, for captures.
    pub why: String,
}

/// Where a world's particles come from.
#[derive(Clone, Debug)]
pub enum Start {
    /// The scene's fluids.
    Scene,
    /// The world before it, which has so many: [`World::adopt`] brings them.
    Carry(u32),
    /// Those of a scene of another spacing: the same fluid, on another lattice.
    Resampled {
        /// The scene they are of.
        from: Box<Scene>,
        /// Relative to the domain's lowest corner.
        particles: ParticleSet,
        /// Steps done.
        steps: u64,
        /// Simulated time, s.
        simulated_s: f64,
    },
    /// These, after so many steps and so much simulated time.
    Particles {
        /// Relative to the domain's lowest corner.
        particles: ParticleSet,
        /// Steps done.
        steps: u64,
        /// Simulated time, s.
        simulated_s: f64,
    },
}

/// What one drawn frame does.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Doing {
    /// Steps.
    pub steps: u32,
    /// Whether the state is measured after them.
    pub measures: bool,
    /// Whether a picture is drawn.
    pub draws: bool,
    /// Whether the fluid is pushed before the steps, as [`World::push`] said.
    pub pushes: bool,
    /// Whether the picture comes back to the host as a screenshot.
    pub screenshot: bool,
    /// Whether picture and points come back to the host for a capture.
    pub records: bool,
}

/// Points that a capture has of the fluid.
const MOST_POINTS: u32 = 1000;

/// A running scene.
pub struct World {
    /// The scene as it was chosen.
    pub scene: Scene,
    /// The scene as it is simulated, after the ladder.
    pub simulated: Scene,
    /// Its engine.
    pub engine: Engine,
    /// Number of particles.
    pub particles: u32,
    /// Steps done.
    pub steps: u64,
    /// Simulated time, s.
    pub simulated_s: f64,
    /// What its plan does without.
    pub left_out: Vec<Absent>,
    view: View,
    options: FrameOptions,
    recorded: Recorded,
    passes: FramePasses,
    push: Push,
    sample: Sample,
}

impl World {
    /// Plans the order and builds it; `progress` is told of each part that is done.
    ///
    /// # Errors
    /// If the scene has no plan, or the device no room for it.
    pub fn build(gpu: &Gpu, order: Order, progress: &mut dyn FnMut(usize, usize, &str)) -> Result<World, WorldError> {
        let simulated = order.rung.scene(&order.scene);
        progress(0, 0, "filling the scene with particles");
        let (emitted, particles, steps, simulated_s) = match order.start {
            Start::Scene => {
                let emitted = sample_lattice(&simulated);
                let count = emitted.positions.len() as u32;
                (Some(emitted), count, 0, 0.0)
            }
            Start::Carry(count) => (None, count, 0, 0.0),
            Start::Resampled { from, particles, steps, simulated_s } => {
                let particles = resample(&from, &particles, &simulated);
                let count = particles.positions.len() as u32;
                (Some(particles), count, steps, simulated_s)
            }
            Start::Particles { particles, steps, simulated_s } => {
                let count = particles.positions.len() as u32;
                (Some(particles), count, steps, simulated_s)
            }
        };
        let view = View {
            camera: order.camera,
            size_px: order.rung.picture_px(order.window_px),
            ..View::of_scene(&simulated)
        };
        let options = order.rung.options(FrameOptions::for_scene(&simulated, gpu.tier()));
        let (planned, push, sample) = plan(&simulated, particles, view, options)?;
        let left_out =
            left_out::list(&simulated, gpu.tier(), &planned, &left_out::Recorded::default()).unwrap_or_default();
        let ScenePlan { plan, recorded, passes } = planned;
        let passes = passes.ok_or(WorldError::NoPicture)?;
        let plan = order.modules.put_into(plan).map_err(WorldError::Shader)?;
        let mut engine = Engine::new_with_progress(gpu, plan, progress)?;
        if let Some(emitted) = emitted {
            engine.write(&recorded.positions, &emitted.positions);
            engine.write(&recorded.velocities, &emitted.velocities);
        }
        engine.run(&[recorded.init.id(), passes.init.id()], &[])?;
        Ok(World {
            scene: order.scene,
            simulated,
            engine,
            particles,
            steps,
            simulated_s,
            left_out,
            view,
            options,
            recorded,
            passes,
            push,
            sample,
        })
    }

    /// Takes over the state of `old`, the same particles in another plan: every buffer that both have in
    /// the same size, without a way over the host.
    pub fn adopt(&mut self, old: &World) {
        let kept = self.engine.plan().buffers();
        let fresh = uploaded(self.engine.plan(), &self.init_ids());
        let others = old.engine.plan().buffers();
        let gpu = self.engine.gpu().clone();
        let mut encoder = gpu.device().create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        for buffer in kept.iter().filter(|buffer| !fresh.contains(&buffer.id)) {
            let same = others.iter().find(|other| other.label == buffer.label && other.bytes == buffer.bytes);
            let from = same.and_then(|other| old.engine.wgpu_buffer(other.id));
            if let (Some(from), Some(to)) = (from, self.engine.wgpu_buffer(buffer.id)) {
                encoder.copy_buffer_to_buffer(from, 0, to, 0, buffer.bytes.next_multiple_of(4));
            }
        }
        gpu.queue().submit([encoder.finish()]);
        self.steps = old.steps;
        self.simulated_s = old.simulated_s;
    }

    /// Applies another scene to the running one if only numbers of its plan change; false if it needs a
    /// plan of its own, and then nothing was changed.
    ///
    /// # Errors
    /// If the scene has no plan.
    pub fn apply_live(&mut self, scene: &Scene, rung: &Rung) -> Result<bool, WorldError> {
        let simulated = rung.scene(scene);
        if needs_reset(&self.simulated, &simulated) {
            return Ok(false);
        }
        let options = rung.options(FrameOptions::for_scene(&simulated, self.engine.gpu().tier()));
        let (other, ..) = plan(&simulated, self.particles, self.view, options)?;
        if !self.engine.take_uploads(&other.plan, &self.init_ids())? {
            return Ok(false);
        }
        (self.scene, self.simulated, self.options) = (scene.clone(), simulated, options);
        Ok(true)
    }

    /// Runs with shaders that were compiled anew, from the next frame on.
    ///
    /// # Errors
    /// If the driver refuses one; what ran before then goes on.
    pub fn exchange(&mut self, modules: &NewModules) -> Result<(), WorldError> {
        let plan = modules.put_into(self.engine.plan().clone()).map_err(WorldError::Shader)?;
        Ok(self.engine.exchange(plan)?)
    }

    /// From where it is seen, from the next picture on.
    ///
    /// # Errors
    /// If nothing could be seen from there.
    pub fn look_from(&mut self, camera: Camera) -> Result<(), WorldError> {
        self.view.camera = camera;
        let values = FrameValues::new(&self.view, &self.options)?;
        let uniforms = &self.passes.uniforms;
        self.engine.write(&uniforms.view, &[values.view]);
        self.engine.write(&uniforms.style, &[values.style]);
        Ok(())
    }

    /// From where it is seen.
    pub fn view(&self) -> &View {
        &self.view
    }

    /// Hands a frame to the GPU; returns its number, and waits for nothing.
    ///
    /// # Errors
    /// If the device is lost.
    pub fn run(&mut self, doing: Doing) -> Result<u64, WorldError> {
        let mut recordings = Vec::with_capacity(doing.steps as usize + 4);
        let mut readbacks: Vec<ResourceId> = Vec::new();
        if doing.pushes {
            recordings.push(self.push.recording.id());
        }
        recordings.extend(std::iter::repeat_n(self.step_id(), doing.steps as usize));
        if doing.measures
            && let Some(measure) = &self.recorded.measure
        {
            recordings.push(measure.recording.id());
            readbacks.push(measure.output.id);
        }
        if doing.draws {
            recordings.push(self.passes.draw.id());
        }
        if doing.records {
            recordings.push(self.sample.recording.id());
            readbacks.push(self.sample.samples.id);
        }
        if doing.records || doing.screenshot {
            readbacks.push(self.passes.color.id);
        }
        let frame = self.engine.run(&recordings, &readbacks)?;
        self.steps += u64::from(doing.steps);
        self.simulated_s += f64::from(doing.steps) * self.simulated.solver.dt_s;
        Ok(frame)
    }

    /// The picture's texture.
    pub fn picture(&self) -> Option<&wgpu::TextureView> {
        self.engine.wgpu_view(self.passes.color.id)
    }

    /// The picture among a report's readbacks.
    pub fn picture_id(&self) -> ResourceId {
        self.passes.color.id
    }

    /// Points of the fluid among a report's readbacks.
    pub fn points_id(&self) -> ResourceId {
        self.sample.samples.id
    }

    /// What the next frame that pushes does.
    pub fn push(&mut self, drag: &Drag) {
        self.push.write(&mut self.engine, &self.simulated, drag);
    }

    /// A measurement among a report's readbacks.
    pub fn measure_id(&self) -> Option<ResourceId> {
        self.recorded.measure_id()
    }

    /// A step's recording.
    pub fn step_id(&self) -> RecordingId {
        self.recorded.step.id()
    }

    /// What frames run, in the order of their passes' times: steps, measurements, pictures.
    pub fn frame_recordings(&self) -> Vec<RecordingId> {
        let measure = self.recorded.measure.as_ref().map(|measure| measure.recording.id());
        [self.step_id()].into_iter().chain(measure).chain([self.passes.draw.id()]).collect()
    }

    fn init_ids(&self) -> [RecordingId; 2] {
        [self.recorded.init.id(), self.passes.init.id()]
    }

    /// Waits, and copies the particles to the host, in cell order.
    ///
    /// # Errors
    /// If the device is lost.
    pub fn read_particles(&mut self) -> Result<(Vec<Position>, Vec<Velocity>), WorldError> {
        Ok((self.engine.read(&self.recorded.positions)?, self.engine.read(&self.recorded.velocities)?))
    }
}

type Planned = (ScenePlan, Push, Sample);

fn plan(scene: &Scene, particles: u32, view: View, options: FrameOptions) -> Result<Planned, WorldError> {
    let mut resources = Resources::new();
    let mut recorded = record_count(&mut resources, scene, particles);
    let push = record_push(&mut resources, &mut recorded);
    let sample = record_sample(&mut resources, &recorded, MOST_POINTS);
    let others = vec![push.recording.clone(), sample.recording.clone()];
    let also = (others, &[sample.samples.id][..]);
    Ok((ScenePlan::sweep(scene, resources, recorded, Some((view, options)), also)?, push, sample))
}

/// Whether the particles of one scene mean nothing in the other.
pub fn needs_reset(running: &Scene, other: &Scene) -> bool {
    running.spacing_m != other.spacing_m || running.domain != other.domain || running.fluids != other.fluids
}

/// What a plan's first recordings fill: its own parameters.
fn uploaded(plan: &Plan, init: &[RecordingId]) -> BTreeSet<ResourceId> {
    let first = init.iter().flat_map(|recording| plan.commands(*recording));
    first.filter_map(|command| if let Command::Upload { to, .. } = command { Some(*to) } else { None }).collect()
}
