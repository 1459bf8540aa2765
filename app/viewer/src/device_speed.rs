//! How fast a device is, in work of rungs: guessed from its kind, then learned from its frames.

use brooklet_fluid::Scene;
use brooklet_fluid::scene::Method;
use brooklet_gpu::{Gpu, Tier};
use brooklet_render::FrameOptions;
use brooklet_render::surface::SurfaceOptions;

use crate::ladder::{RUNGS, Rung};

/// What one step and one picture of a scene come to on a rung. Only ratios between rungs of one scene count.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Work {
    /// Of a step: particles times rounds over their neighbours.
    pub step: f64,
    /// Of a picture: drawn pixels of water, and what else takes as long as one.
    pub draw: f64,
}

/// What sorting, listing and the velocities take, in iterations.
const OTHER_ROUNDS: f64 = 4.0;
/// Particles times rounds that take as long as a step of no particles: its dispatches.
const DISPATCHES: f64 = 15.0e3;
/// Drawn pixels of water that take as long (lavapipe, two cores; about): a pixel of the window's panels, a drawn pixel of the
/// particles' picture, a particle drawn as a ball or as a sphere, its ellipsoid, its part in the sun's volume, a particle
/// of a mesh, a photon, and a texel of thickness.
const PANELS_PX: f64 = 0.07;
const POINTS_PX: f64 = 0.5;
const SPHERE_PX: f64 = 4.0;
const ELLIPSOID_PX: f64 = 3.0;
const SUN_VOLUME_PX: f64 = 2.0;
const MESHED_PX: f64 = 30.0;
const PHOTON_PX: f64 = 1.0;
const THICKNESS_PX: f64 = 0.5;

/// Iterations of both of DFSPH's solves that a substep ends with, as dam breaks have them.
const DFSPH_ROUNDS: f64 = 6.0;

/// How many particles a scene has at any spacing, from those that it has on the last rung: to count them where a mesh stands
/// takes the mesh's distance field at that spacing, seconds of it for what may never be run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crowd {
    particles: f64,
    spacing_m: f64,
}

impl Crowd {
    /// Of `scene` as it was chosen.
    pub fn of(scene: &Scene) -> Self {
        let coarsest = RUNGS[RUNGS.len() - 1].scene(scene);
        Self { particles: coarsest.particle_count().max(1) as f64, spacing_m: coarsest.spacing_m }
    }

    fn in_scene(&self, run: &Scene) -> f64 {
        self.particles * (self.spacing_m / run.spacing_m).powi(run.domain.dimensions as i32)
    }
}

impl Work {
    /// Of `scene` as it was chosen, with its `crowd`, in a window of `window_px`, on `rung`.
    pub fn of(rung: &Rung, scene: &Scene, crowd: Crowd, tier: Tier, window_px: [u32; 2]) -> Self {
        let run = rung.scene(scene);
        let mut options = rung.options(FrameOptions::for_scene(&run, tier));
        let particles = crowd.in_scene(&run);
        let rounds = match run.solver.method {
            Method::None => 1.0,
            Method::Dfsph => DFSPH_ROUNDS + OTHER_ROUNDS,
            _ => f64::from(run.solver.iterations().unwrap_or(1)) + OTHER_ROUNDS,
        };
        let picture_px: f64 = rung.picture_px(window_px).into_iter().map(f64::from).product();
        let drawn_px = picture_px * f64::from(options.supersample).powi(2);
        let meshed = matches!(options.surface, SurfaceOptions::MarchingCubes(..));
        let draw = match options.surface.water_mut() {
            None => POINTS_PX * drawn_px + SPHERE_PX * particles,
            Some(water) => {
                let shape = match (meshed, water.anisotropic) {
                    (true, _) => MESHED_PX,
                    (false, true) => SPHERE_PX + ELLIPSOID_PX,
                    (false, false) => SPHERE_PX,
                };
                let sun = if water.self_shadow { SUN_VOLUME_PX } else { 0.0 };
                let texels = picture_px / f64::from(water.thickness_divisor).powi(2);
                drawn_px
                    + THICKNESS_PX * texels
                    + (shape + sun) * particles
                    + PHOTON_PX * f64::from(water.photons).powi(2)
            }
        };
        let window_px: f64 = window_px.into_iter().map(f64::from).product();
        Self { step: f64::from(run.substeps()) * (DISPATCHES + particles * rounds), draw: draw + PANELS_PX * window_px }
    }
}

/// What a device does in a millisecond, in the units of [`Work`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DeviceSpeed {
    /// Particles times rounds.
    pub steps: f64,
    /// Drawn pixels.
    pub draws: f64,
}

impl DeviceSpeed {
    /// Before anything ran: orders of magnitude, so that the first frame is neither a still nor a blur. That of processors
    /// is measured on two cores; those of GPUs are guesses, which the first frames put right.
    pub fn of_kind(device_type: &str, tier: Tier) -> Self {
        let (steps, draws) = match (device_type, tier) {
            ("cpu", _) => (7.0e3, 3.5e3),
            (_, Tier::Mobile | Tier::Floor) => (6.0e4, 1.0e5),
            ("discrete", _) => (2.0e6, 4.0e6),
            _ => (2.0e5, 4.0e5),
        };
        Self { steps, draws }
    }

    /// From the median times of frames that did `work`, ms; a part without a time stays as it was.
    pub fn learn(&mut self, work: &Work, step_ms: f64, draw_ms: f64) {
        let rate = |known: &mut f64, work: f64, ms: f64| {
            if ms > 0.0 && work > 0.0 && (work / ms).is_finite() {
                *known = work / ms;
            }
        };
        rate(&mut self.steps, work.step, step_ms);
        rate(&mut self.draws, work.draw, draw_ms);
    }

    /// A step and a picture, ms.
    pub fn costs_ms(&self, work: &Work) -> (f64, f64) {
        (work.step / self.steps, work.draw / self.draws)
    }
}

/// What a frame may take where nobody said: a processor's pictures shall move at all, a phone's shall not heat it.
pub fn default_budget_ms(gpu: &Gpu) -> f64 {
    match (gpu.info().device_type.as_str(), gpu.tier()) {
        ("cpu", _) => 80.0,
        (_, Tier::Mobile | Tier::Floor) => 32.0,
        _ => 16.0,
    }
}
