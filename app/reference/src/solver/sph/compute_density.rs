//! Density, pressure and the colour field's gradient. (Shader: `solver/sph/compute_density.compute`.)

use super::kernels::Kernel;
use crate::boundary::sample_boundary;
use crate::boundary::walls::DomainWalls;
use crate::params::Smoothing;
use crate::shared::lattice;
use brooklet_kernels::SphParams;
use glam::DVec3;

/// One term's kernel, scaled.
#[derive(Clone, Copy, Debug)]
pub struct Term {
    /// Which.
    pub kernel: Kernel,
    /// What its value is multiplied by.
    pub scale: f64,
}

impl Term {
    /// -W'/q times the offset, in h.
    fn along(&self, offset: DVec3) -> DVec3 {
        let q = offset.length();
        if q == 0.0 { DVec3::ZERO } else { -self.scale * self.kernel.slope(q) / q * offset }
    }
}

/// The kernels of density, pressure, viscosity and the colour field.
#[derive(Clone, Copy, Debug)]
pub struct Kernels {
    /// W: 1 over its sum on the lattice, the particle itself among it.
    pub density: Term,
    /// -W'/q: 1 over the sum of its q²/D.
    pub pressure: Term,
    /// The Laplacian's weight: 1 over the sum of its q²/(2D).
    pub viscosity: Term,
    /// -W'/q of poly6, as the pressure's.
    pub tension: Term,
}

impl Kernels {
    /// Scaled on the lattice of `dimensions` and `support_ratio` = h / spacing.
    pub fn new(dimensions: u32, support_ratio: f64, density: Kernel, pressure: Kernel, viscosity: Kernel) -> Self {
        let d = f64::from(dimensions);
        // But for the particle itself.
        let sum = |of: &dyn Fn(f64) -> f64| {
            lattice::sum(dimensions, support_ratio, |_, q| if q > 0.0 && q < 1.0 { of(q) } else { 0.0 })
        };
        let sloped = |kernel: Kernel| Term { kernel, scale: 1.0 / sum(&|q| -kernel.slope(q) * q / d) };
        Self {
            density: Term { kernel: density, scale: 1.0 / (density.w(0.0) + sum(&|q| density.w(q))) },
            pressure: sloped(pressure),
            tension: sloped(Kernel::Poly6),
            viscosity: Term { kernel: viscosity, scale: 1.0 / sum(&|q| viscosity.laplacian(q) * q * q / (2.0 * d)) },
        }
    }

    /// -W'/q of the pressure's kernel times the offset from j to i, in h: opposite for the two.
    pub fn push(&self, offset: DVec3) -> DVec3 {
        self.pressure.along(offset)
    }

    /// Likewise of the colour field's.
    pub fn draw(&self, offset: DVec3) -> DVec3 {
        self.tension.along(offset)
    }
}

/// The terms of the equation of motion.
#[derive(Clone, Copy, Debug)]
pub struct Terms {
    /// k, m²/s².
    pub stiffness_m2_s2: f64,
    /// γ.
    pub exponent: f64,
    /// Least pressure over the rest density, m²/s².
    pub least_pressure_m2_s2: f64,
    /// Kinematic viscosity, m²/s.
    pub viscosity_m2_s: f64,
    /// Surface tension over the rest density and over what a plane surface's layers sum up to, m³/s²; 0: none.
    pub tension_m3_s2: f64,
    /// Closer pairs, in h, part even below rest density.
    pub separation: f64,
    /// The pressure of a pair at one point, m²/s².
    pub separation_m2_s2: f64,
    /// 1 over the pressure from which on walls bear all of the fluid's weight, s²/m².
    pub supported_per_m2_s2: f64,
    /// Of what they bear.
    pub borne_scale: f64,
    /// What a free surface lacks of density, of the length of the colour field's gradient and its square; 0 without tension.
    pub completion: [f64; 2],
    /// Of that length, 1/h, what counts.
    pub most_normal: f64,
}

impl Terms {
    /// What shaders are given.
    pub fn of(params: &SphParams) -> Self {
        Self {
            stiffness_m2_s2: params.stiffness_m2_s2.into(),
            exponent: params.exponent.into(),
            least_pressure_m2_s2: params.least_pressure_m2_s2.into(),
            viscosity_m2_s: params.viscosity_m2_s.into(),
            tension_m3_s2: params.tension_m3_s2.into(),
            separation: params.separation.into(),
            separation_m2_s2: params.separation_m2_s2.into(),
            supported_per_m2_s2: params.supported_per_m2_s2.into(),
            borne_scale: params.borne_scale.into(),
            completion: [params.surface_linear, params.surface_square].map(f64::from),
            most_normal: params.most_normal.into(),
        }
    }
}

/// What pairs gather of a particle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// ρ/ρ0, with surface tension with what the surface lacks.
    pub density_ratio: f64,
    /// p / (ρ0 (ρ/ρ0)²), m²/s².
    pub pressure_m2_s2: f64,
    /// Gradient of the colour field, 1/h.
    pub normal: DVec3,
}

/// p/ρ0 of a density ratio (Becker & Teschner 2007, eq. 7; γ = 1: Müller, Charypar & Gross 2003, eq. 12), m²/s².
pub fn pressure_of(density_ratio: f64, terms: &Terms) -> f64 {
    let pressure = terms.stiffness_m2_s2 / terms.exponent * (density_ratio.powf(terms.exponent) - 1.0);
    pressure.max(terms.least_pressure_m2_s2)
}

/// The density ratio with what a free surface lacks, as the colour field's gradient tells it.
pub fn completed(density_ratio: f64, normal: DVec3, terms: &Terms) -> f64 {
    let length = normal.length().min(terms.most_normal);
    let [linear, square] = terms.completion;
    density_ratio + length * (linear + square * length)
}

/// Of particle `i`; `density_walls` counts the density's kernel beyond walls, `tension_walls` the colour field's.
#[expect(clippy::too_many_arguments)]
pub fn compute_density(
    i: usize,
    positions_m: &[DVec3],
    neighbours: &[usize],
    smoothing: &Smoothing,
    kernels: &Kernels,
    terms: &Terms,
    density_walls: Option<&DomainWalls>,
    tension_walls: Option<&DomainWalls>,
) -> State {
    let Term { kernel, scale } = kernels.density;
    let boundary = sample_boundary(positions_m[i], density_walls);
    let offsets = || neighbours.iter().map(|&j| smoothing.offset(positions_m[i], positions_m[j]));
    let inside = kernel.w(0.0) + offsets().map(|offset| kernel.w(offset.length())).sum::<f64>();
    let beyond = sample_boundary(positions_m[i], tension_walls).gradient;
    let normal = beyond - offsets().map(|offset| kernels.draw(offset)).sum::<DVec3>();
    let density_ratio = completed(scale * inside + boundary.density, normal, terms);
    State { density_ratio, pressure_m2_s2: pressure_of(density_ratio, terms) / density_ratio.powi(2), normal }
}
