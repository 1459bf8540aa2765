//! Starts the session of a plan, or says how much of the scene the device has room for.

use brooklet_fluid::scene::SurfaceMethod;
use brooklet_fluid::{Scene, Session, SessionPlan};
use brooklet_gpu::{Engine, Gpu, GpuError, tier_name};

use crate::ScenePlan;

/// Why a session does not start.
#[derive(Debug, thiserror::Error)]
pub enum StartError {
    /// The device has no room for the scene, or lacks a format that its picture needs.
    #[error("scene {scene}: does not fit {device} as {tier}: {error}: {advice}")]
    Misfit {
        /// The scene's name.
        scene: String,
        /// The device's name.
        device: String,
        /// What the device is used as.
        tier: &'static str,
        /// What the device refused.
        error: Box<GpuError>,
        /// What would fit.
        advice: String,
    },
    /// Anything else that the device says.
    #[error(transparent)]
    Gpu(GpuError),
}

impl StartError {
    /// What the device says.
    pub fn gpu_error(&self) -> &GpuError {
        match self {
            Self::Misfit { error, .. } => error,
            Self::Gpu(error) => error,
        }
    }
}

/// Starts a session of `planned`.
///
/// # Errors
/// Every [`StartError`]: what would fit is found by planning the scene again, with less.
pub fn start(gpu: &Gpu, planned: SessionPlan) -> Result<Session, StartError> {
    let (scene, particles, bytes) = (planned.scene.clone(), planned.slot_count(), planned.plan.bytes());
    Session::start(gpu, planned).map_err(|error| {
        let advice = match &error {
            GpuError::BufferTooLarge { .. } => within_limits(gpu, &scene, particles),
            GpuError::OutOfMemory { allocated, .. } => within_memory(&scene, particles, bytes, *allocated),
            GpuError::MissingFormat { .. } => without_format(gpu, &scene, particles),
            GpuError::TextureTooLarge { .. } => "lower outputs.width_px and outputs.height_px".into(),
            _ => return StartError::Gpu(error),
        };
        let device = gpu.info().name.clone();
        StartError::Misfit { scene: scene.name, device, tier: tier_name(gpu.tier()), error: Box::new(error), advice }
    })
}

/// What of the scene the device's limits allow, found by planning it for less.
fn within_limits(gpu: &Gpu, scene: &Scene, particles: u32) -> String {
    let allows = |scene: &Scene, particles: u32| {
        ScenePlan::of_count(scene, particles, gpu.tier())
            .is_ok_and(|other| Engine::check_sizes(gpu, other.plan()).is_ok())
    };
    if !allows(scene, 0) {
        return "its grid or its pictures are too large by themselves; make spacing_m larger, or the domain or the \
                pictures smaller"
            .into();
    }
    let most = largest(particles, |particles| allows(scene, particles));
    let slots = largest(scene.neighbour_slots(), |slots| {
        let mut other = scene.clone();
        other.solver.neighbour_slots = Some(slots);
        allows(&other, particles)
    });
    let fewer_slots = match slots {
        0 => String::new(),
        slots => format!(", or all {particles} with solver.neighbour_slots = {slots}"),
    };
    format!("{most} of {particles} particles fit, as with {}{fewer_slots}", wider(scene, particles, most))
}

/// What is drawn without the format that the device lacks, found by planning it.
fn without_format(gpu: &Gpu, scene: &Scene, particles: u32) -> String {
    let works = |(name, method): &(&'static str, SurfaceMethod)| {
        let mut other = scene.clone();
        other.surface.method = *method;
        let planned = ScenePlan::of_count(&other, particles, gpu.tier());
        planned.is_ok_and(|other| Engine::check_sizes(gpu, other.plan()).is_ok()).then_some(*name)
    };
    let methods = [("points", SurfaceMethod::Points), ("none", SurfaceMethod::None)];
    match methods.iter().find_map(works) {
        Some(name) => format!("surface.method = \"{name}\" does without"),
        None => "outputs.images = 0 does without".into(),
    }
}

/// What of the scene the device's memory may hold: as much as it gave before it refused.
fn within_memory(scene: &Scene, particles: u32, bytes: u64, allocated: u64) -> String {
    let most = (f64::from(particles) * allocated as f64 / bytes.max(1) as f64) as u32;
    let slots = scene.neighbour_slots();
    format!(
        "the scene takes {bytes} bytes; about {most} of {particles} particles fit, as with {}; fewer than {slots} \
         solver.neighbour_slots save memory too",
        wider(scene, particles, most)
    )
}

/// The spacing at which a scene of `particles` has `most`.
fn wider(scene: &Scene, particles: u32, most: u32) -> String {
    let ratio = (f64::from(particles) / f64::from(most.max(1))).powf(1.0 / f64::from(scene.domain.dimensions));
    // A hundredth more: lattices end where they end.
    format!("spacing_m = {:.3e}", 1.01 * ratio * scene.spacing_m)
}

/// The largest number up to `most` for which `holds`, which holds for 0 and for none above that.
pub(crate) fn largest(most: u32, holds: impl Fn(u32) -> bool) -> u32 {
    let (mut low, mut high) = (0, most);
    while low < high {
        let middle = low + (high - low).div_ceil(2);
        if holds(middle) {
            low = middle;
        } else {
            high = middle - 1;
        }
    }
    low
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_that_holds_is_found() {
        for most in [0, 1, 2, 7, u32::MAX] {
            for limit in [0, 1, 2, 5, 7, 1 << 24, u32::MAX] {
                assert_eq!(largest(most, |number| number <= limit), limit.min(most));
            }
        }
    }

    #[test]
    fn what_memory_holds_is_said_in_particles() {
        let scene = Scene::load("dam-break", &[]).unwrap();
        let text = within_memory(&scene, 8000, 4_000_000, 500_000);
        assert!(text.contains("about 1000 of 8000 particles") && text.contains("spacing_m = 4.040e-2"), "{text}");
    }
}
