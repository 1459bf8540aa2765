//! What a device cannot do is done without: a pipeline that its driver does not build, a module that computes wrongly there,
//! a format that it lacks and no other of the texture's can stand for. The scene's settings are gone through, what is least
//! seen first, for one whose plan the device can run; what no setting leaves out is an error.

use brooklet_fluid::Scene;
use brooklet_gpu::{Engine, Gpu, GpuError, OtherFormat, Plan};

/// What was changed, and what for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Concession {
    /// A setting, as `--set` takes it, or the format that a texture has instead: `thickness in Rg16Float`.
    pub setting: String,
    /// What the device could not do.
    pub reason: String,
}

impl std::fmt::Display for Concession {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}; so {}", self.reason, self.setting)
    }
}

/// No spray, foam and bubbles; nothing to a scene that has none.
const NO_DIFFUSE: &str = "diffuse.max_particles=0";

/// Settings that do without something, what is least seen first.
const CONCESSIONS: [&str; 30] = [
    "solver.precision=full",
    "surface.caustics=false",
    "surface.self_shadow=false",
    "surface.anisotropic=false",
    "surface.mesh.anisotropic=false",
    "surface.mesh.smooth_normals=0",
    "surface.mesh.subdivide=1",
    "surface.mesh.dense_cells=0",
    NO_DIFFUSE,
    "surface.smoothing=bilateral",
    "surface.smoothing=gaussian",
    "surface.smoothing=none",
    "solver.pbf.warm_start=0",
    "solver.pbf.coarse_correction=false",
    "solver.pbf.acceleration=none",
    "forces.vorticity_m_s=0",
    "forces.xsph=0",
    "solver.pbf.s_corr_k=0",
    "solver.dfsph.fixed_iterations=true",
    "solver.sph.density_kernel=wendland",
    "solver.sph.pressure_kernel=wendland",
    "solver.sph.viscosity_kernel=wendland",
    "solver.sph.surface_tension_n_m=0",
    "solver.deterministic=false",
    "surface.method=screen-space",
    "surface.method=marching-cubes",
    "surface.color_by=speed",
    "surface.method=points",
    "surface.method=none",
    "outputs.measure_every_steps=0",
];

/// The scene with the first setting that does without what the device could not do, or without several where one is not enough;
/// none if `error` is of another kind, or nothing helps. `plan` makes a scene's plan.
pub fn step_down(
    gpu: &Gpu,
    scene: &Scene,
    error: &GpuError,
    plan: &dyn Fn(&Scene) -> Option<Plan>,
) -> Option<(Scene, Vec<Concession>)> {
    let failing = match error {
        GpuError::Pipeline { module, .. }
        | GpuError::ModuleRefused { module, .. }
        | GpuError::ModuleAboveTier { module, .. }
        | GpuError::ModuleLimit { module, .. } => Some(*module),
        GpuError::MissingFormat { .. } => None,
        _ => return None,
    };
    let refused = gpu.refused();
    let runs = |scene: &Scene| {
        plan(scene).is_some_and(|plan| {
            let is_refused = |name: &str| Some(name) == failing || refused.iter().any(|(refused, _)| refused == name);
            !plan.modules().any(|module| is_refused(module.name)) && Engine::check_sizes(gpu, &plan).is_ok()
        })
    };
    let with = |scene: &Scene, setting: &str| {
        let says_something = setting != NO_DIFFUSE || scene.diffuse_particles().is_some();
        scene.with_setting(setting).ok().filter(|other| says_something && other != scene)
    };
    let concession = |setting: &str| Concession { setting: setting.to_owned(), reason: error.to_string() };
    for setting in CONCESSIONS {
        if let Some(other) = with(scene, setting).filter(runs) {
            return Some((other, vec![concession(setting)]));
        }
    }
    // Several modules are refused, or one is of several terms: one after the other, as far as is needed.
    let (mut other, mut list) = (scene.clone(), Vec::new());
    for setting in CONCESSIONS {
        if let Some(next) = with(&other, setting) {
            other = next;
            list.push(concession(setting));
            if runs(&other) {
                return Some((other, list));
            }
        }
    }
    None
}

/// Textures of the scene's plan that the device draws in another format than on others.
fn other_formats(gpu: &Gpu, scene: &Scene, plan: &dyn Fn(&Scene) -> Option<Plan>) -> Vec<Concession> {
    if !gpu.lacks_formats() {
        return Vec::new();
    }
    let Some(plan) = plan(scene).map(|plan| plan.with_formats_of(gpu)) else { return Vec::new() };
    let device = &gpu.info().name;
    let concession = |other: &OtherFormat| Concession {
        setting: format!("{} in {:?}", other.label, other.format),
        reason: format!("{device} cannot use {:?} as texture {} is: {}", other.lacking, other.label, other.used_as),
    };
    plan.other_formats().iter().map(concession).collect()
}

/// Starts `scene`, and steps it down as long as the device cannot do something of it that can be done without. Returns what
/// `start` made, the scene as it runs, and what it does without.
///
/// # Errors
/// That of `start`, where nothing helps.
pub fn start_stepping_down<T, E>(
    gpu: &Gpu,
    scene: &Scene,
    plan: &dyn Fn(&Scene) -> Option<Plan>,
    mut start: impl FnMut(&Scene) -> Result<T, E>,
    cause: impl Fn(&E) -> Option<GpuError>,
) -> Result<(T, Scene, Vec<Concession>), E> {
    let (mut scene, mut made) = (scene.clone(), Vec::new());
    loop {
        let error = match start(&scene) {
            Ok(started) => {
                made.extend(other_formats(gpu, &scene, plan));
                return Ok((started, scene, made));
            }
            Err(error) => error,
        };
        // A device that went with it has to be opened again before anything else is tried.
        if gpu.is_lost().is_some() {
            return Err(error);
        }
        let Some(cause) = cause(&error) else { return Err(error) };
        match (step_down(gpu, &scene, &cause, plan), cause) {
            (Some((other, concessions)), _) => {
                scene = other;
                made.extend(concessions);
            }
            // What cannot be done without is tried again: it may have been killed with the program.
            (None, GpuError::ModuleRefused { module, .. }) if gpu.trust(module) => {}
            (None, _) => return Err(error),
        }
    }
}
