//! What smoothed particle hydrodynamics takes.

use serde::{Deserialize, Serialize};

use super::{Fluid, Method, Scene, Solver, body_count};

/// A smoothing kernel of one of its terms. q = r/h, 0 beyond h.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum SmoothingKernel {
    /// (1-q²)³ (Müller, Charypar & Gross 2003, eq. 20): cheap, and its gradient fades where particles meet.
    Poly6,
    /// (1-q)³ (eq. 21): its gradient is largest where they meet.
    Spiky,
    /// The one of eq. 22, whose Laplacian is positive everywhere: of viscosity alone, being infinite at q = 0.
    Viscosity,
    /// The cubic spline of Monaghan & Lattanzio 1985.
    CubicSpline,
    /// Wendland's C2: particles do not pair.
    #[default]
    Wendland,
}

impl SmoothingKernel {
    /// Every kernel by its name.
    pub const NAMES: &[&str] = &["poly6", "spiky", "viscosity", "cubic-spline", "wendland"];
    /// Those that a density or a pressure may have: finite at q = 0.
    pub const FINITE_NAMES: &[&str] = &["poly6", "spiky", "cubic-spline", "wendland"];
}

/// How an acceleration becomes motion.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Integrator {
    /// Leap-frog, kick-drift-kick (Müller, Charypar & Gross 2003): second order.
    #[default]
    LeapFrog,
    /// Velocity first, position with the new one.
    SymplecticEuler,
    /// Both from the old state (Harada, Koshizuka & Kawaguchi 2007).
    Euler,
}

impl Integrator {
    /// Every integrator by its name.
    pub const NAMES: &[&str] = &["leap-frog", "symplectic-euler", "euler"];

    /// Shares of dt that velocities take of an acceleration before the next move, after it, and at once.
    pub fn kicks(self) -> [f64; 3] {
        match self {
            Self::LeapFrog => [0.5, 0.0, 0.5],
            Self::SymplecticEuler => [1.0, 0.0, 0.0],
            Self::Euler => [0.0, 1.0, 0.0],
        }
    }
}

/// Settings of `method = "sph"`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct SphSettings {
    /// Stiffness k of p = k (ρ - ρ0), m²/s²: the square of the speed of sound, which limits the substep to .2 h / √k.
    /// Default: that of a sound ten times as fast as the fluid may fall or is thrown, so that it is compressed by about 1 %.
    pub stiffness_m2_s2: Option<f64>,
    /// γ of Tait's equation p = k ρ0 / γ ((ρ/ρ0)^γ - 1) (Becker & Teschner 2007); 1: p = k (ρ - ρ0).
    pub exponent: f64,
    /// Whether pressure is clamped at 0: fluid then does not pull, and splashes part.
    pub clamp_pressure: bool,
    /// Kinematic viscosity ν, m²/s; water's is 1e-6.
    pub viscosity_m2_s: f64,
    /// Monaghan's α, a viscosity of α √k h / (4 (D + 2)) that explicit pressure needs to stay calm, D the dimensions.
    pub artificial_viscosity: f64,
    /// Surface tension σ, N/m; water's is 0.073. 0 leaves its term out.
    pub surface_tension_n_m: f64,
    /// The kernel of the density.
    pub density_kernel: SmoothingKernel,
    /// The kernel of the pressure's gradient.
    pub pressure_kernel: SmoothingKernel,
    /// The kernel of the viscosity.
    pub viscosity_kernel: SmoothingKernel,
    /// How an acceleration becomes motion.
    pub integrator: Integrator,
    /// Whether the GPU chooses the substeps of a step: as few as its limits allow (CFL, viscosity, force, surface tension).
    /// If not, `solver.substeps` is honoured, and substeps above their limit are counted.
    pub adaptive_substeps: bool,
}

impl Default for SphSettings {
    fn default() -> Self {
        Self {
            stiffness_m2_s2: None,
            exponent: 7.0,
            clamp_pressure: true,
            viscosity_m2_s: 1.0e-6,
            artificial_viscosity: 0.1,
            surface_tension_n_m: 0.0,
            density_kernel: SmoothingKernel::Wendland,
            pressure_kernel: SmoothingKernel::Wendland,
            viscosity_kernel: SmoothingKernel::Wendland,
            integrator: Integrator::LeapFrog,
            adaptive_substeps: true,
        }
    }
}

/// Speed of sound over the speed that the fluid may reach: it is compressed by about the inverse square.
const SOUND_RATIO: f64 = 10.0;
/// No slower than this over the time of falling through a support, where nothing says how fast fluid may be.
const LEAST_SPEED_M_S: f64 = 1.0e-3;
/// Least viscosity with surface tension, over √(σ d / ρ): with half of it a swinging drop of 1,789 particles gains energy from the
/// noise of its normals.
const TENSION_VISCOSITY: f64 = 0.2;
/// Room for substeps beyond those that sound, viscosity and tension ask for: for fast particles and hard hits.
const SPARE_SUBSTEPS: f64 = 1.5;

/// h/d of SPH where bodies move, if a scene says none.
const BODIES_SUPPORT_RATIO: f64 = 2.5;
/// The field of h/d.
pub(super) const SUPPORT_RATIO: &str = "solver.support_ratio";

impl Scene {
    /// h/d where a scene says none.
    pub(super) fn default_support_ratio(&self) -> f64 {
        let holds_bodies = self.solver.method == Method::Sph && body_count(self) > 0;
        if holds_bodies { BODIES_SUPPORT_RATIO } else { Solver::default().support_ratio }
    }

    /// Stiffness of SPH's pressure, m²/s²: what the scene says, or ten times the fastest speed that it may come to, squared.
    pub fn stiffness_m2_s2(&self) -> f64 {
        self.solver.sph.stiffness_m2_s2.unwrap_or_else(|| (SOUND_RATIO * self.expected_speed_m_s()).powi(2))
    }

    /// The speed of a fall over the fluid's height in the domain, or of the fastest body at the start.
    pub(super) fn expected_speed_m_s(&self) -> f64 {
        let g_m_s2 = self.gravity_m_s2;
        let length = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
        let size = self.gravity_length_m_s2();
        // How far the fluid reaches against gravity.
        let fall_m = (0..3)
            .filter(|_| size > 0.0)
            .map(|axis| {
                let down = g_m_s2[axis] / size;
                let reach = |(min_m, max_m): ([f64; 3], [f64; 3])| match down <= 0.0 {
                    true => max_m[axis] - self.domain.min_m[axis],
                    false => self.domain.max_m[axis] - min_m[axis],
                };
                down.abs() * self.fluids.iter().map(Fluid::bounds_m).map(reach).fold(0.0, f64::max)
            })
            .sum::<f64>();
        let thrown_m_s = self.fluids.iter().map(|fluid| length(fluid.velocity_m_s)).fold(0.0, f64::max);
        let tension_m_s = (self.solver.sph.surface_tension_n_m / (self.rest_density_kg_m3() * self.support_m())).sqrt();
        (2.0 * size * fall_m).sqrt().max(thrown_m_s).max(tension_m_s).max(LEAST_SPEED_M_S)
    }

    /// Kinematic viscosity of SPH, its artificial part too, m²/s.
    pub fn sph_viscosity_m2_s(&self) -> f64 {
        let sph = &self.solver.sph;
        let [d, h_m] = [f64::from(self.domain.dimensions), self.support_m()];
        let viscosity_m2_s =
            sph.viscosity_m2_s + sph.artificial_viscosity * self.stiffness_m2_s2().sqrt() * h_m / (4.0 * (d + 2.0));
        let tension_m3_s2 = sph.surface_tension_n_m / self.rest_density_kg_m3();
        viscosity_m2_s.max(TENSION_VISCOSITY * (tension_m3_s2 * self.fitted_spacing_m()).sqrt())
    }

    /// Longest substep that SPH's speed of sound alone allows, s: .4 (h/2) / c.
    pub fn sound_limit_s(&self) -> f64 {
        0.2 * self.support_m() / self.stiffness_m2_s2().sqrt()
    }

    /// Longest substep that SPH's viscosity and surface tension allow, s: .125 (h/2)² / ν and .25 √(ρ (h/2)³ / 2πσ).
    pub fn steady_limit_s(&self) -> f64 {
        let half_m = 0.5 * self.support_m();
        let viscous_s = 0.125 * half_m.powi(2) / self.sph_viscosity_m2_s();
        let tension = 2.0 * std::f64::consts::PI * self.solver.sph.surface_tension_n_m;
        let tension_s = 0.25 * (self.rest_density_kg_m3() * half_m.powi(3) / tension).sqrt();
        viscous_s.min(tension_s).min(f64::from(f32::MAX))
    }

    /// Most substeps that the GPU may take of a step where it chooses them.
    pub(super) fn most_substeps(&self) -> f64 {
        let limit_s = self.sound_limit_s().min(self.steady_limit_s());
        (SPARE_SUBSTEPS * self.solver.dt_s / limit_s).ceil().max(f64::from(self.solver.substeps))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bodies_have_more_neighbours_around_them_unless_a_scene_says_how_many() {
        let text = "spacing_m = 0.1\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [1, 1, 1]\n\
            [[fluid]]\nblock = { min_m = [0, 0, 0], max_m = [1, 0.5, 1] }\n\
            [[solid]]\nsphere = { radius_m = 0.2 }\ncentre_m = [0.5, 0.7, 0.5]\n";
        let ratio = |settings: &[&str]| {
            let settings: Vec<String> = settings.iter().map(ToString::to_string).collect();
            Scene::from_toml(text, "ball", &settings).unwrap().solver.support_ratio
        };
        let (sph, body) = ("solver.method=sph", "solid.0.density_kg_m3=500");
        assert_eq!(ratio(&[sph]), 2.0, "it stands");
        assert_eq!(ratio(&[body]), 2.0, "PBF");
        assert_eq!(ratio(&[sph, body]), 2.5);
        assert_eq!(ratio(&[sph, body, "solver.support_ratio=2"]), 2.0);
        let scene = Scene::from_toml(text, "ball", &[sph.into(), body.into()]).unwrap();
        assert_eq!(Scene::from_toml(&scene.to_toml(), "ball", &[]).unwrap().solver.support_ratio, 2.5);
        let other = scene.with_setting("solver.method=pbf").unwrap();
        assert_eq!(other.solver.support_ratio, 2.0, "another method has its own default");
        assert_eq!(other.with_setting(sph).unwrap().solver.support_ratio, 2.5);
        let standing = Scene::from_toml(text, "ball", &[sph.into()]).unwrap();
        assert_eq!(standing.with_setting(body).unwrap().solver.support_ratio, 2.5, "it moves now");
        let own = scene.with_setting("solver.support_ratio=3").unwrap().with_setting("solver.method=pbf").unwrap();
        assert_eq!(own.solver.support_ratio, 3.0, "which somebody chose");
    }
}
