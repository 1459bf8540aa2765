//! The kernels of SPH's terms as polynomials of 1 - q and 1 - 2 q, each scaled on the scene's lattice. (Shader:
//! `solver/sph/kernels.hlsli`.)

use std::sync::OnceLock;

use brooklet_kernels::{SmoothingKernelParams, SphKernels};

use crate::boundary::{WallScales, fitted_wall_kernel_fraction, share, share_slope};
use crate::scene::{Scene, SmoothingKernel};
use crate::smoothing_kernel::for_lattice;
use crate::smoothing_kernel_params::{params_with_walls, with_walls_if};

/// W over a factor: coefficients of t³ to t⁶ and of s³, t = 1 - q and s = 1 - 2q where they are not negative.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shape {
    powers: [f64; 4],
    spline: f64,
}

/// A weight of pairs: coefficients of t to t⁴, of t²/q and of s²/q.
#[derive(Clone, Copy, Debug)]
pub(super) struct PairShape {
    powers: [f64; 4],
    inverse: f64,
    spline: f64,
}

impl Shape {
    pub(super) fn at(&self, q: f64) -> f64 {
        let (t, s) = ((1.0 - q).max(0.0), (1.0 - 2.0 * q).max(0.0));
        let [c3, c4, c5, c6] = self.powers;
        t.powi(3) * (c3 + t * (c4 + t * (c5 + t * c6))) + self.spline * s.powi(3)
    }

    fn scaled(&self, by: f64) -> Self {
        Self { powers: self.powers.map(|c| by * c), spline: by * self.spline }
    }
}

impl PairShape {
    pub(super) fn at(&self, q: f64) -> f64 {
        let (t, s) = ((1.0 - q).max(0.0), (1.0 - 2.0 * q).max(0.0));
        let [c1, c2, c3, c4] = self.powers;
        t * (c1 + t * (c2 + t * (c3 + t * c4))) + (self.inverse * t * t + self.spline * s * s) / q
    }

    fn scaled(&self, by: f64) -> Self {
        Self { powers: self.powers.map(|c| by * c), inverse: by * self.inverse, spline: by * self.spline }
    }
}

/// W(q), but for a factor. The viscosity kernel is infinite at 0, and has no density: scenes refuse it.
fn shape(kernel: SmoothingKernel) -> Shape {
    let (powers, spline) = match kernel {
        SmoothingKernel::Poly6 => ([8.0, -12.0, 6.0, -1.0], 0.0),
        SmoothingKernel::Spiky | SmoothingKernel::Viscosity => ([1.0, 0.0, 0.0, 0.0], 0.0),
        SmoothingKernel::CubicSpline => ([1.0, 0.0, 0.0, 0.0], -0.5),
        SmoothingKernel::Wendland => ([0.0, 5.0, -4.0, 0.0], 0.0),
    };
    Shape { powers, spline }
}

/// -W'(q)/q of the same.
fn slope(kernel: SmoothingKernel) -> PairShape {
    let (powers, inverse, spline) = match kernel {
        SmoothingKernel::Poly6 => ([0.0, 24.0, -24.0, 6.0], 0.0, 0.0),
        SmoothingKernel::Spiky | SmoothingKernel::Viscosity => ([0.0; 4], 3.0, 0.0),
        SmoothingKernel::CubicSpline => ([0.0; 4], 3.0, -3.0),
        SmoothingKernel::Wendland => ([0.0, 0.0, 20.0, 0.0], 0.0, 0.0),
    };
    PairShape { powers, inverse, spline }
}

/// What a difference of velocities counts: the viscosity kernel's own Laplacian, 45/π (1 - q) (Müller, Charypar & Gross
/// 2003), of others -2 W'/q (Brookshaw 1985), which is positive everywhere, as their Laplacians are not.
fn laplacian(kernel: SmoothingKernel) -> PairShape {
    match kernel {
        SmoothingKernel::Viscosity => PairShape { powers: [1.0, 0.0, 0.0, 0.0], inverse: 0.0, spline: 0.0 },
        kernel => slope(kernel),
    }
}

/// Sums over a lattice's points, but for the middle one: as steps along the axes and q.
pub(super) fn sum(scene: &Scene, mut of: impl FnMut([i32; 3], f64) -> f64) -> f64 {
    let mut sum = 0.0;
    for_lattice(scene.domain.dimensions, scene.solver.support_ratio, |step, q| {
        if q > 0.0 {
            sum += of(step, q);
        }
    });
    sum
}

/// A slope is its own on the lattice: Σ (-W'/q) q²/D = 1.
fn gradient(scene: &Scene, kernel: SmoothingKernel) -> PairShape {
    let shape = slope(kernel);
    let d = f64::from(scene.domain.dimensions);
    shape.scaled(1.0 / sum(scene, |_, q| shape.at(q) * q * q / d))
}

/// The colour field's kernel.
pub(super) const TENSION_KERNEL: SmoothingKernel = SmoothingKernel::Poly6;

/// Of the colour field's kernel.
pub(super) fn tension(scene: &Scene) -> PairShape {
    gradient(scene, TENSION_KERNEL)
}

/// The density of the lattice is 1: Σ W = 1, the particle itself among it.
pub(super) fn density(scene: &Scene) -> Shape {
    let shape = shape(scene.solver.sph.density_kernel);
    shape.scaled(1.0 / (shape.at(0.0) + sum(scene, |_, q| shape.at(q))))
}

/// A parabola of velocities has its own Laplacian on the lattice: Σ w q²/(2D) = 1.
fn viscosity(scene: &Scene) -> PairShape {
    let shape = laplacian(scene.solver.sph.viscosity_kernel);
    let d = f64::from(scene.domain.dimensions);
    shape.scaled(1.0 / sum(scene, |_, q| shape.at(q) * q * q / (2.0 * d)))
}

/// Whether all terms have Wendland's kernel, which has a variant of its own.
pub(super) fn are_chosen(scene: &Scene) -> bool {
    let sph = &scene.solver.sph;
    [sph.density_kernel, sph.pressure_kernel, sph.viscosity_kernel] != [SmoothingKernel::Wendland; 3]
}

/// What the shaders are given.
pub fn sph_kernels(scene: &Scene) -> SphKernels {
    let density = density(scene);
    let (pressure, viscosity) = (gradient(scene, scene.solver.sph.pressure_kernel), viscosity(scene));
    // What (1 - q^2)^2 is multiplied by: its value at 0.
    let tension: f64 = tension(scene).powers.iter().sum();
    SphKernels {
        density: density.powers.map(|c| c as f32),
        pressure: pressure.powers.map(|c| c as f32),
        viscosity: viscosity.powers.map(|c| c as f32),
        density_spline: density.spline as f32,
        density_self: density.at(0.0) as f32,
        pressure_inverse: pressure.inverse as f32,
        pressure_spline: pressure.spline as f32,
        viscosity_inverse: viscosity.inverse as f32,
        viscosity_spline: viscosity.spline as f32,
        tension: tension as f32,
        ..SphKernels::default()
    }
}

/// What walls count in the density: as fluid beyond them would with its kernel.
pub fn density_walls(scene: &Scene) -> SmoothingKernelParams {
    with_walls_if(scene.domain.wall.model.counts_in_density(), walls_of(scene, scene.solver.sph.density_kernel))
}

/// What walls count in the colour field: likewise.
pub fn tension_walls(scene: &Scene) -> SmoothingKernelParams {
    with_walls_if(scene.domain.wall.model.counts_in_density(), walls_of(scene, TENSION_KERNEL))
}

/// What walls answer to pressure: likewise. Not scaled until even pressure leaves the lattice's first layer where it is,
/// which would be 1.4 times as much at h = 2 d: fluid is no lattice for long, and such walls drove a pool about for ever.
pub fn pressure_walls(scene: &Scene) -> SmoothingKernelParams {
    with_walls_if(scene.domain.wall.model.answers_pressure(), walls_of(scene, scene.solver.sph.pressure_kernel))
}

/// Half a spacing in h: where the lattice's first layer is.
fn wall_distance(scene: &Scene) -> f64 {
    0.5 / scene.solver.support_ratio
}

/// What makes a wall bear the half of a first layer's weight that the fluid above leaves to it.
pub(super) fn borne_scale(scene: &Scene) -> f64 {
    let walls = walls_of(scene, scene.solver.sph.pressure_kernel);
    let s = wall_distance(scene);
    let fraction = walls.wall_kernel_fraction.map(f64::from);
    0.5 / (f64::from(walls.wall_plane) * (share(fraction, s) + s * share_slope(fraction, s)))
}

/// What the neighbours that the lattice's first layer lacks beyond a wall weigh in its Laplacian, 1/h², over the difference
/// to the wall's velocity: a linear profile goes on through the wall.
pub(crate) fn shear_beyond(scene: &Scene) -> f64 {
    let viscosity = viscosity(scene);
    sum(scene, |step, q| if step[1] > 0 { viscosity.at(q) * 2.0 * f64::from(step[1]) } else { 0.0 })
}

/// [`fitted_wall_kernel_fraction`] of a kernel, fitted once: every plan asks for it, and it takes a million values of W.
fn wall_fraction(dimensions: u32, kernel: SmoothingKernel) -> [f64; 4] {
    const KERNELS: usize = SmoothingKernel::Wendland as usize + 1;
    static FITTED: [[OnceLock<[f64; 4]>; KERNELS]; 2] = [const { [const { OnceLock::new() }; KERNELS] }; 2];
    let of = &FITTED[usize::from(dimensions == 2)][kernel as usize];
    *of.get_or_init(|| fitted_wall_kernel_fraction(dimensions, |q| shape(kernel).at(q)))
}

fn walls_of(scene: &Scene, kernel: SmoothingKernel) -> SmoothingKernelParams {
    let wendland = params_with_walls(scene);
    if kernel == SmoothingKernel::Wendland {
        return wendland;
    }
    let shape = shape(kernel);
    let fraction = wall_fraction(scene.domain.dimensions, kernel);
    let scales = WallScales::of(scene.domain.dimensions, scene.solver.support_ratio, |q| shape.at(q), fraction);
    SmoothingKernelParams {
        wall_plane: scales.plane as f32,
        wall_edge: scales.edge as f32,
        wall_corner: scales.corner as f32,
        wall_kernel_fraction: fraction.map(|c| c as f32),
        ..wendland
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene(settings: &[&str]) -> Scene {
        let settings: Vec<String> = settings.iter().map(|&s| s.into()).collect();
        Scene::load("dam-break", &settings).unwrap()
    }

    const FINITE: [SmoothingKernel; 4] =
        [SmoothingKernel::Poly6, SmoothingKernel::Spiky, SmoothingKernel::CubicSpline, SmoothingKernel::Wendland];

    #[test]
    fn slopes_are_the_derivatives() {
        for kernel in FINITE {
            let (w, g) = (shape(kernel), slope(kernel));
            for i in 1..40 {
                let (q, e) = (f64::from(i) / 40.0 - 0.003, 1e-6);
                let expected = (w.at(q - e) - w.at(q + e)) / (2.0 * e) / q;
                assert!((g.at(q) - expected).abs() < 1e-6, "{kernel:?} at {q}: {} and {expected}", g.at(q));
            }
            assert!(w.at(1.0).abs() < 1e-15 && g.at(1.0).abs() < 1e-15, "{kernel:?}");
        }
    }

    #[test]
    fn kernels_integrate_to_what_their_papers_say() {
        // Müller, Charypar & Gross 2003, eq. 20-22, W(0) being 1 here; Monaghan & Lattanzio's 8/pi h^3; Wendland's 21/2pi.
        let pi = std::f64::consts::PI;
        let factors = [315.0 / (64.0 * pi), 15.0 / pi, 16.0 / pi, 21.0 / (2.0 * pi)];
        for (kernel, factor) in FINITE.into_iter().zip(factors) {
            let n = 20_000;
            let volume: f64 = (0..n)
                .map(|i| {
                    let q = (f64::from(i) + 0.5) / f64::from(n);
                    4.0 * pi * q * q * shape(kernel).at(q) / f64::from(n)
                })
                .sum();
            assert!((factor * volume - 1.0).abs() < 1e-6, "{kernel:?}: {}", factor * volume);
        }
    }

    #[test]
    fn the_lattice_at_rest_has_its_density_and_walls_make_up_for_what_is_beyond_them() {
        for name in SmoothingKernel::FINITE_NAMES {
            let setting = format!("solver.sph.density_kernel={name}");
            let scene = scene(&["solver.method=sph", &setting]);
            let walls = density_walls(&scene);
            let shape = shape(scene.solver.sph.density_kernel);
            let weight = f64::from(sph_kernels(&scene).density_self) / shape.at(0.0);
            let inside = weight * (shape.at(0.0) + sum(&scene, |step, q| if step[1] <= 0 { shape.at(q) } else { 0.0 }));
            let fraction = walls.wall_kernel_fraction.map(f64::from);
            let beyond = f64::from(walls.wall_plane) * share(fraction, wall_distance(&scene));
            assert!((inside + beyond - 1.0).abs() < 1e-5, "{name}: {inside} + {beyond}");
        }
    }
}
