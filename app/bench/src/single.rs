//! One scene, without measurements; and what its pictures cost, if asked.

use brooklet_fluid::{FrameRequest, Scene};
use brooklet_gpu::{Gpu, PassTimes, Passes, Quantiles, TimingStatus, Timings, stages, tier_name};
use serde::{Serialize, Serializer};

pub use crate::scene_options::Options;
use crate::{
    BenchError, Observer,
    pictures::{PictureCost, picture_cost},
    scene_options::plan,
    stepping::Stepping,
};

/// What a scene costs.
#[derive(Clone, Debug, Serialize)]
pub struct SceneCost {
    /// The scene's name.
    pub scene: String,
    /// Number of its particles.
    pub particles: u32,
    /// All iterations of a step.
    #[serde(skip)]
    pub iterations: u32,
    /// Steps that were timed.
    pub steps: u64,
    /// Steps before them.
    pub warm_up_steps: u64,
    /// From the first pass of a step to the end of its last, ms.
    pub gpu_ms_per_step: Option<Quantiles>,
    /// Particles times iterations a second.
    pub particle_iterations_per_s: Option<f64>,
    /// Times by pass.
    pub passes: Passes<PassTimes>,
    /// What a picture costs, if it was asked for and the scene draws anything.
    pub picture: Option<PictureCost>,
    /// Of GPU memory, without pictures.
    pub bytes: u64,
    /// The same over the particles.
    pub bytes_per_particle: Option<f64>,
    /// How times were taken.
    #[serde(serialize_with = "by_name")]
    pub timing: TimingStatus,
    /// Spans that cannot be right.
    pub flagged_spans: u64,
    /// What it ran on.
    pub device: Device,
}

/// A device and what it is used as.
#[derive(Clone, Debug, Serialize)]
pub struct Device {
    /// Its name.
    pub name: String,
    /// `cpu` of a driver that runs on the processor.
    pub device_type: String,
    /// The tier.
    pub tier: &'static str,
}

fn by_name<S: Serializer>(timing: &TimingStatus, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(timing.name())
}

/// Times `scene`, as it is but for its outputs.
///
/// # Errors
/// Every [`BenchError`].
pub fn run(gpu: &Gpu, scene: &Scene, options: Options, observer: &dyn Observer) -> Result<SceneCost, BenchError> {
    let mut scene = scene.clone();
    scene.outputs.images = 0;
    scene.outputs.measure_every_steps = 0;
    let planned = plan(gpu, &scene)?;
    let bytes_per_particle = planned.session.recorded.bytes_per_particle(planned.plan());
    let (bytes, stages) = (planned.plan().bytes(), stages(planned.plan().passes()));
    let particles = planned.session.slot_count();
    let mut session = brooklet_render::start(gpu, planned.session).map_err(BenchError::input)?;
    let mut timings = Timings::new(options.warm_up);
    session.finish().map_err(BenchError::stopped)?;

    let steps = options.warm_up + options.steps;
    observer.begin(steps);
    let request = FrameRequest { steps: 1, ..FrameRequest::default() };
    let mut stepping = Stepping { session: &mut session, request, observer };
    stepping.run(steps, &mut timings, || observer.advance())?;

    let picture = picture_cost(gpu, &scene, options, observer)?;
    let iterations = scene.iterations_a_step();
    let work = f64::from(particles) * f64::from(iterations);
    let info = gpu.info();
    Ok(SceneCost {
        scene: scene.name,
        particles,
        iterations,
        steps: options.steps,
        warm_up_steps: options.warm_up,
        gpu_ms_per_step: timings.step_ms(),
        particle_iterations_per_s: timings.step_ms().map(|step| work / (step.median * 1e-3)),
        passes: timings.passes(&stages),
        picture,
        bytes,
        bytes_per_particle,
        timing: timings.status(),
        flagged_spans: timings.flagged_spans(),
        device: Device { name: info.name.clone(), device_type: info.device_type.clone(), tier: tier_name(gpu.tier()) },
    })
}
