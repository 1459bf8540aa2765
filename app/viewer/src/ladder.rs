//! The quality ladder: what is given up, rung by rung, for a frame in time; by hand or by itself ([`crate::Governor`]).

use brooklet_fluid::Scene;
use brooklet_fluid::scene::{Precision, Solver};
use brooklet_render::FrameOptions;
use brooklet_render::surface::SurfaceOptions;

/// What is given up on a rung; each includes all above it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rung {
    /// What is new on it.
    pub name: &'static str,
    /// One of so many particles is left, about: the spacing grows by its root.
    pub(crate) fewer_particles: u32,
    /// Whether what is only seen through the water, or as its shadow, is half as fine.
    coarse_fields: bool,
    /// Drawn pixels a side of a picture's pixel.
    supersample: u32,
    /// Picture pixels over the window's, a side.
    scale: f64,
    /// Whether the water has no caustics and no shade of its own, its spheres are not stretched, and smoothing reaches less far.
    plain_water: bool,
    /// Whether pairs of particles are rounded more.
    lower_precision: bool,
    /// Whether a step has half as many substeps; of one, half the iterations.
    fewer_substeps: bool,
    /// Whether the particles are drawn instead of the water's surface.
    points: bool,
}

const BEST: Rung = Rung {
    name: "everything",
    fewer_particles: 1,
    coarse_fields: false,
    supersample: 2,
    scale: 1.0,
    plain_water: false,
    lower_precision: false,
    fewer_substeps: false,
    points: false,
};
const COARSE: Rung = Rung { name: "coarser light and thickness", coarse_fields: true, ..BEST };
const SINGLE: Rung = Rung { name: "no supersampling", supersample: 1, ..COARSE };
const HALF: Rung = Rung { name: "half the particles", fewer_particles: 2, ..SINGLE };
const SMALL: Rung = Rung { name: "picture at 3/4", scale: 0.75, ..HALF };
const QUARTER: Rung = Rung { name: "a quarter of the particles", fewer_particles: 4, ..SMALL };
const PLAIN: Rung = Rung { name: "plainer water", plain_water: true, ..QUARTER };
const SMALLER: Rung = Rung { name: "picture at 1/2", scale: 0.5, ..PLAIN };
const ROUGH: Rung = Rung { name: "lower precision", lower_precision: true, ..SMALLER };
const FEWER: Rung = Rung { name: "fewer substeps", fewer_substeps: true, ..ROUGH };
const EIGHTH: Rung = Rung { name: "an eighth of the particles", fewer_particles: 8, ..FEWER };
const SIXTEENTH: Rung = Rung { name: "a sixteenth of the particles", fewer_particles: 16, ..EIGHTH };
const SMALLEST: Rung = Rung { name: "picture at 1/3", scale: 1.0 / 3.0, ..SIXTEENTH };
const POINTS: Rung = Rung { name: "particles instead of water", points: true, ..SMALLEST };

/// From all there is to the least.
pub const RUNGS: [Rung; 14] =
    [BEST, COARSE, SINGLE, HALF, SMALL, QUARTER, PLAIN, SMALLER, ROUGH, FEWER, EIGHTH, SIXTEENTH, SMALLEST, POINTS];

/// Smoothing of plainer water reaches so many drawn pixels at most.
const PLAIN_REACH_PX: u32 = 16;
/// Fewer particles than these are no fluid any more.
const LEAST_PARTICLES: f64 = 600.0;

impl Rung {
    /// One of how many particles of `scene` is left: none are given up that a small scene needs.
    pub(crate) fn fewer_particles_of(&self, scene: &Scene) -> f64 {
        if self.fewer_particles == 1 {
            return 1.0;
        }
        let slots = scene.slot_capacity().map_or(0, u64::from);
        let most = scene.particle_count().max(slots) as f64 / LEAST_PARTICLES;
        f64::from(self.fewer_particles).min(most).max(1.0)
    }

    /// The scene as it is simulated on this rung.
    pub fn scene(&self, scene: &Scene) -> Scene {
        let mut scene = scene.clone();
        let fewer = self.fewer_particles_of(&scene);
        if fewer > 1.0 {
            scene.spacing_m *= fewer.powf(1.0 / f64::from(scene.domain.dimensions));
            if let Some(slots) = scene.capacity {
                let least = scene.particle_count() as u32;
                scene.capacity = Some(((f64::from(slots) / fewer).ceil() as u32).max(least));
            }
        }
        if self.lower_precision && scene.solver.precision == Precision::Full {
            scene.solver.precision = Precision::Relaxed;
        }
        if self.fewer_substeps {
            let solver = &mut scene.solver;
            let halved = if solver.substeps > 1 { &mut solver.substeps } else { &mut solver.pbf.iterations };
            *halved = halved.div_ceil(2);
        }
        scene
    }

    /// What is drawn on this rung.
    pub fn options(&self, mut options: FrameOptions) -> FrameOptions {
        options.supersample = options.supersample.min(self.supersample);
        if self.coarse_fields {
            options.shadow_texels /= 2;
            if let Some(water) = options.surface.water_mut() {
                water.thickness_divisor = (2 * water.thickness_divisor).min(8);
                water.photons /= 2;
            }
        }
        if self.plain_water
            && let Some(water) = options.surface.water_mut()
        {
            (water.photons, water.self_shadow, water.anisotropic) = (0, false, false);
            water.most_reach_px = water.most_reach_px.min(PLAIN_REACH_PX);
        }
        if self.plain_water
            && let Some(mesh) = options.surface.mesh_mut()
        {
            mesh.anisotropic = false;
            mesh.refine.smooth_normals = mesh.refine.smooth_normals.min(1);
            mesh.refine.parts = 1;
        }
        if self.points && options.surface != SurfaceOptions::None {
            options.surface = SurfaceOptions::Points;
        }
        options
    }

    /// Size of the picture for a window's, pixels.
    pub fn picture_px(&self, window_px: [u32; 2]) -> [u32; 2] {
        window_px.map(|side| ((f64::from(side) * self.scale).round() as u32).max(1))
    }

    /// All that is given up of `scene` on this rung, in words; empty on the first.
    pub fn given_up(&self, scene: &Scene) -> String {
        let mut list = Vec::new();
        let fewer = self.fewer_particles_of(scene);
        if fewer > 1.05 {
            list.push(format!("1/{:.2} of the particles", fewer).replace(".00 ", " "));
        }
        let mut add = |is_given_up: bool, words: &str| list.extend(is_given_up.then(|| words.to_owned()));
        add(self.points, "particles instead of water");
        add(self.plain_water && !self.points, "plainer water");
        add(self.coarse_fields && !self.points && !self.plain_water, "coarser light and thickness");
        add(self.supersample < BEST.supersample, "no supersampling");
        // Not every solver has pairs, iterations or substeps of its own choice, and a scene may have none to spare.
        let (run, whole) = (&self.scene(scene).solver, &scene.solver);
        let rounds = |solver: &Solver| (solver.substeps, solver.iterations());
        add(run.method.interacts() && run.precision != whole.precision, "lower precision");
        add(rounds(run) != rounds(whole), "half the substeps or iterations");
        if self.scale < 1.0 {
            list.push(format!("picture at {:.0} %", 100.0 * self.scale));
        }
        list.join(", ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::device_speed::{Crowd, Work};
    use brooklet_gpu::Tier;

    fn scene() -> Scene {
        Scene::load("dam-break", &[]).unwrap()
    }

    #[test]
    fn each_rung_asks_for_less() {
        let scene = scene();
        let options = FrameOptions::for_scene(&scene, Tier::Desktop);
        let work = |rung: &Rung| Work::of(rung, &scene, Crowd::of(&scene), Tier::Desktop, [1000, 1000]);
        for pair in RUNGS.windows(2) {
            let ([more, less], [above, below]) = ([work(&pair[0]), work(&pair[1])], [&pair[0], &pair[1]]);
            let is_less =
                less.step < more.step || less.draw < more.draw || below.lower_precision && !above.lower_precision;
            let is_no_more = less.step <= more.step && less.draw <= more.draw;
            assert!(is_less && is_no_more, "{} after {}: {less:?} after {more:?}", below.name, above.name);
        }
        let half = RUNGS[3].scene(&scene).particle_count() as f64;
        let all = scene.particle_count() as f64;
        assert!((0.4..0.6).contains(&(half / all)), "{}", half / all);
        assert_eq!(RUNGS[0].scene(&scene), scene);
        assert_eq!(RUNGS[0].options(options), options);
    }

    #[test]
    fn what_is_given_up_is_said() {
        let scene = Scene::load("dam-break", &[]).unwrap();
        assert_eq!(RUNGS[0].given_up(&scene), "");
        let mut said: Vec<String> = RUNGS.iter().map(|rung| rung.given_up(&scene)).collect();
        assert!(said[2].contains("no supersampling") && said[13].contains("1/16 of the particles"), "{said:?}");
        said.sort_unstable();
        said.dedup();
        assert_eq!(said.len(), RUNGS.len(), "two rungs say the same");
    }

    #[test]
    fn what_a_solver_does_not_have_is_not_given_up() {
        let last = |method: &str| {
            let scene = Scene::load("dam-break", &[format!("solver.method={method}")]).unwrap();
            RUNGS[RUNGS.len() - 1].given_up(&scene)
        };
        let [pbf, sph, none] = ["pbf", "sph", "none"].map(last);
        let has = |said: &str| ["lower precision", "half the substeps"].map(|words| said.contains(words));
        assert_eq!([has(&pbf), has(&sph), has(&none)], [[true, true], [true, false], [false, false]]);
    }
}
