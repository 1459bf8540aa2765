//! What `run`, `plan` and `bench` share: the scene with its changes, its plan, the device.

use brooklet_fluid::Scene;
use brooklet_gpu::{Gpu, GpuOptions, Tier};
use brooklet_render::{ScenePlan, ScenePlanError};

use crate::{
    cli::{LengthOptions, OutputOptions},
    failure::Failure,
    shared_options::{DeviceOptions, MOST_STEPS, SceneOptions},
};

/// Reads the scene and changes what the command line changes.
pub fn scene(options: &SceneOptions, outputs: Option<&OutputOptions>) -> Result<Scene, Failure> {
    let mut scene = load(&options.scene, &options.settings)?;
    if let Some(images) = outputs.and_then(|outputs| outputs.images) {
        scene.outputs.images = images;
    }
    Ok(scene)
}

/// Reads a scene with settings changed.
pub fn load(name_or_path: &str, settings: &[String]) -> Result<Scene, Failure> {
    Scene::load(name_or_path, settings).map_err(Failure::input)
}

/// How many steps a run has.
pub fn steps(scene: &Scene, length: &LengthOptions) -> Result<u64, Failure> {
    let dt_s = scene.solver.dt_s;
    let steps = match (length.steps, length.seconds) {
        (Some(steps), _) => steps as f64,
        (None, seconds) => (seconds.unwrap_or(scene.outputs.seconds) / dt_s).round(),
    };
    const MOST: f64 = MOST_STEPS as f64;
    if (1.0..=MOST).contains(&steps) {
        Ok(steps as u64)
    } else {
        let shown = if steps < 1e15 { format!("{steps:.0}") } else { format!("{steps:.3e}") };
        Err(Failure::Input(format!(
            "{}: the run would have {shown} steps of {dt_s} s; 1 to {MOST:.0} are possible \
             (--seconds, --steps, or outputs.seconds in the scene)",
            scene.name
        )))
    }
}

/// Plans the scene for a device of `tier`: what its outputs do not need is not in the plan.
pub fn plan(scene: &Scene, tier: Tier) -> Result<ScenePlan, Failure> {
    ScenePlan::new(scene, tier).map_err(refused)
}

/// As [`plan`] for so many particles, which are not made: for what is only looked at.
pub fn plan_for(scene: &Scene, particles: u32, tier: Tier) -> Result<ScenePlan, Failure> {
    ScenePlan::of_count(scene, particles, tier).map_err(refused)
}

/// A picture's fault is the scene's; a mistake in a recording is the program's.
pub fn refused(error: ScenePlanError) -> Failure {
    match error {
        ScenePlanError::Render { .. } => Failure::input(error),
        ScenePlanError::Plan(_) => Failure::stopped(error),
    }
}

/// Opens the device; `timing` false makes no timestamp query.
pub fn open(options: &DeviceOptions, timing: bool) -> Result<Gpu, Failure> {
    Gpu::open(&GpuOptions {
        device_name: options.device.clone(),
        tier: options.tier.map(Into::into),
        pipeline_cache: dirs::cache_dir().map(|folder| folder.join("brooklet")),
        timing,
        watch_builds: options.careful,
        ..GpuOptions::default()
    })
    .map_err(Failure::input)
}
