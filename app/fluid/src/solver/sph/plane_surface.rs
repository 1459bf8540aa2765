//! A plane surface of the scene's lattice: what its layers lack of density, and what their stress sums up to.

use brooklet_kernels::ISOTROPIC;

use super::kernels::{PairShape, Shape, density, sum, tension};
use crate::scene::Scene;

/// What a swinging drop's tension has over that of a plane at rest: its period in two dimensions and three, at 6 to 24 particles a
/// radius, is Rayleigh's with 1.04 (f64 trials; without it 2 to 5 % too long).
const MOVING: f64 = 1.04;
/// Over the gradient at a plane surface: a particle at a corner counts as little more.
const MOST_NORMAL: f64 = 1.15;

/// What surface tension takes of the lattice; all 0 is none.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct PlaneSurface {
    /// Of the length n of the colour field's gradient, 1/h, and its square: their sum is what the two outer layers lack of
    /// density.
    pub completion: [f64; 2],
    /// The largest n that counts.
    pub most_normal: f64,
    /// 1 over what the tension of the layers' stress n (1.25 - n̂n̂) sums up to, 1/h.
    pub tension_scale: f64,
}

impl PlaneSurface {
    pub(super) fn of(scene: &Scene) -> Self {
        let layers = Layer::all(scene);
        let [first, second] = [layers[0], layers[1]].map(|layer| (layer.normal, layer.lacks / layer.normal));
        let square = (first.1 - second.1) / (first.0 - second.0);
        let tension: f64 = layers.iter().map(|layer| layer.normal * layer.passed_on).sum();
        Self {
            completion: [first.1 - square * first.0, square],
            most_normal: MOST_NORMAL * first.0,
            tension_scale: MOVING * scene.solver.support_ratio / tension,
        }
    }
}

/// One of a lattice whose upper half is empty, counted from the surface.
#[derive(Clone, Copy, Debug)]
struct Layer {
    /// Length of the colour field's gradient, 1/h.
    normal: f64,
    /// Of the density ratio.
    lacks: f64,
    /// What a stress along the surface passes on to those that are there, h, less what goes across it.
    passed_on: f64,
}

impl Layer {
    /// Those that lack neighbours.
    fn all(scene: &Scene) -> Vec<Self> {
        let (density, tension) = (density(scene), tension(scene));
        (0..scene.solver.support_ratio.ceil() as i32).map(|k| Self::of(scene, &density, &tension, k)).collect()
    }

    fn of(scene: &Scene, density: &Shape, tension: &PairShape, layer: i32) -> Self {
        let (isotropic, ratio) = (f64::from(ISOTROPIC), scene.solver.support_ratio);
        let (mut normal, mut lacks, mut passed_on) = (0.0, 0.0, 0.0);
        sum(scene, |step, q| {
            let [along, across] = [0, 1].map(|axis| f64::from(step[axis]) / ratio);
            if step[1] > layer {
                lacks += density.at(q);
            } else {
                normal -= tension.at(q) * across;
                passed_on += tension.at(q) * (isotropic * along * along - (isotropic - 1.0) * across * across);
            }
            0.0
        });
        Self { normal, lacks, passed_on }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene(dimensions: u32) -> Scene {
        let settings = ["solver.method=sph", "solver.support_ratio=3", "solver.sph.surface_tension_n_m=1"];
        let mut settings: Vec<String> = settings.iter().map(|&setting| setting.into()).collect();
        settings.push(format!("domain.dimensions={dimensions}"));
        Scene::load("dam-break", &settings).unwrap()
    }

    /// The two outer layers of a lattice have the density of those inside, and the third nearly.
    #[test]
    fn a_plane_surface_is_as_dense_as_the_fluid_below() {
        for dimensions in [2, 3] {
            let scene = scene(dimensions);
            let surface = PlaneSurface::of(&scene);
            let layers = Layer::all(&scene);
            for (k, (layer, off)) in layers.iter().zip([1e-12, 1e-12, 0.01]).enumerate() {
                let n = layer.normal.min(surface.most_normal);
                let completed = 1.0 - layer.lacks + n * (surface.completion[0] + n * surface.completion[1]);
                assert!((completed - 1.0).abs() < off, "{dimensions}-D, layer {k}: {completed}");
            }
            assert!(layers.len() == 3 && layers[0].lacks > 0.2, "something is lacking");
        }
    }

    /// As a program of its own has it, whose volumes are not scaled on the lattice.
    #[test]
    fn the_tension_of_a_plane_is_that_of_its_layers() {
        for (dimensions, expected) in [(2, 2.55), (3, 2.49)] {
            let scale = PlaneSurface::of(&scene(dimensions)).tension_scale;
            assert!((scale / expected - 1.0).abs() < 0.03, "{dimensions}-D: {scale}");
        }
    }
}
