//! What Position Based Fluids takes (Macklin & Müller 2013, the paper's equations).

use serde::{Deserialize, Serialize};

use super::{Method, Scene};
use crate::spectrum::lambda_max;

/// What makes iterations converge faster.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum Acceleration {
    /// Nothing: under-relaxed Jacobi.
    None,
    /// Chebyshev's semi-iteration: weights and momentum made for the kernel's spectrum. Where the fluid is more than
    /// 4 to 8 % compressed it goes over into plain Jacobi.
    Chebyshev,
}

impl Acceleration {
    /// Every acceleration by its name.
    pub const NAMES: &[&str] = &["none", "chebyshev"];

    /// Its name in scenes.
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Chebyshev => "chebyshev",
        }
    }
}

/// Settings of `method = "pbf"`. A coefficient of 0 leaves its term out: no pass, no buffer, no code.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct PbfSettings {
    /// Jacobi iterations a substep.
    pub iterations: u32,
    /// What makes them converge faster. A single iteration has nothing to accelerate, and is plain Jacobi.
    pub acceleration: Acceleration,
    /// Whether what varies slowly in the density is corrected on a coarse grid first, cells of 2 h over the domain: deep
    /// fluid then is hardly more compressed than shallow fluid. It needs iterations with momentum, and a domain that is no
    /// narrower than a cell. Default: on where it can be, but not in a closed domain that begins full of fluid.
    pub coarse_correction: Option<bool>,
    /// Share of the last substep's pressure that a substep begins with, 0 to 0.3: less compression for the same work, and
    /// less damping of waves; fluid at rest is less calm. It needs iterations with momentum, and 16 bytes a particle.
    pub warm_start: f64,
    /// Jacobi under-relaxation ω. With an acceleration it is the weight of what that leaves plain: very compressed
    /// fluid, close pairs that part, the artificial pressure. Jacobi is stable below 2/λmax of the kernel's spectrum,
    /// 0.77 at h = 2 d and 0.61 at h = 3 d in two dimensions; an odd number of iterations a substep below
    /// (1 + 3^(-1/n))/λmax, 0.52 and 0.40 for one. Default: 0.5, or 0.95 of that limit if it is less.
    pub relaxation: Option<f64>,
    /// Constraint force mixing ε (Macklin & Müller 2013, eq. 11) over the lattice's |∇C|².
    pub cfm: f64,
    /// Artificial pressure k (eq. 13), no unit; 0 leaves it out. Wendland's kernel does not
    /// pair particles, so it is not needed for stability.
    pub s_corr_k: f64,
    /// Distance at which the artificial pressure is k, over h.
    pub s_corr_distance_ratio: f64,
}

impl Default for PbfSettings {
    fn default() -> Self {
        Self {
            iterations: 4,
            acceleration: Acceleration::Chebyshev,
            coarse_correction: None,
            warm_start: 0.0,
            relaxation: None,
            cfm: 0.01,
            s_corr_k: 0.0,
            s_corr_distance_ratio: 0.2,
        }
    }
}

/// ω of a scene that gives none, where it is stable.
const RELAXATION: f64 = 0.5;
/// What is used of the range that is stable on the lattice: fluid that is compressed has less.
const STABLE_SHARE: f64 = 0.95;

impl Scene {
    /// The under-relaxation ω of plain iterations: the scene's, or its default.
    pub fn relaxation(&self) -> f64 {
        self.relaxation_below(|| self.relaxation_limit())
    }

    /// As [`Scene::relaxation`], of the kernel's `lambda_max` on the lattice, where that is known.
    pub(crate) fn relaxation_at(&self, lambda_max: f64) -> f64 {
        self.relaxation_below(|| self.relaxation_limit_at(lambda_max))
    }

    fn relaxation_below(&self, limit: impl FnOnce() -> f64) -> f64 {
        self.solver.pbf.relaxation.unwrap_or_else(|| RELAXATION.min(STABLE_SHARE * limit()))
    }

    /// Below which ω plain iterations are stable on the lattice. A mode of eigenvalue μ obeys
    /// z² − 2 (1 − a) z + (1 − a) = 0 from substep to substep with a = 1 − (1 − ω μ)^n, which is stable for a
    /// below 4/3.
    pub fn relaxation_limit(&self) -> f64 {
        let Method::Pbf = self.solver.method else { return 1.0 };
        self.relaxation_limit_at(lambda_max(self.domain.dimensions, self.solver.support_ratio, self.solver.pbf.cfm))
    }

    fn relaxation_limit_at(&self, lambda_max: f64) -> f64 {
        let iterations = self.solver.pbf.iterations;
        let odd = iterations % 2 == 1;
        let most = if odd { 1.0 + 3f64.powf(-1.0 / f64::from(iterations)) } else { 2.0 };
        most / lambda_max
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const COLUMN: &str = "spacing_m = 0.1\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [1, 1, 1]\n[[fluid]]\n\
        block = { min_m = [0, 0, 0], max_m = [0.3, 0.2, 1] }\n";

    fn load(settings: &[&str]) -> Result<Scene, String> {
        let settings: Vec<String> = settings.iter().map(|&s| s.into()).collect();
        Scene::from_toml(COLUMN, "column.toml", &settings).map_err(|error| error.to_string())
    }

    #[test]
    fn a_scene_without_relaxation_has_one_that_is_stable() {
        let of = |settings: &[&str]| {
            let scene = load(settings).unwrap();
            (scene.relaxation(), scene.relaxation_limit())
        };
        let flat = ["domain.dimensions=2", "solver.support_ratio=3"];
        assert_eq!(of(&[]).0, 0.5);
        assert_eq!(of(&["solver.pbf.relaxation=0.3"]).0, 0.3);
        // Limits of one iteration a substep: 4/(3 lambda_max).
        for (settings, limit) in [(vec![], 0.517), (flat.to_vec(), 0.404)] {
            let (relaxation, found) = of(&[&settings[..], &["solver.pbf.iterations=1"]].concat());
            assert!((found / limit - 1.0).abs() < 5e-3 && relaxation == 0.95 * found, "{found} {relaxation}");
            let three = of(&[&settings[..], &["solver.pbf.iterations=3"]].concat()).1;
            let four = of(&settings).1;
            assert!((four / found - 1.5).abs() < 1e-12 && found < three && three < four, "{found} {three} {four}");
        }
        // Plain Jacobi of ω = 0.5 is unstable here.
        let (relaxation, limit) = of(&["solver.support_ratio=3"]);
        assert!(limit < 0.35 && relaxation < limit, "{limit}");
    }

    #[test]
    fn a_relaxation_that_is_not_stable_is_refused_with_the_theory_that_bounds_it() {
        let chebyshev = "solver.pbf.acceleration=chebyshev";
        let flat = ["domain.dimensions=2", "solver.support_ratio=3"];
        for (settings, words) in [
            (
                &["solver.pbf.relaxation=0.8"][..],
                "column.toml: solver.pbf.relaxation = 0.8: must be below 0.775 with solver.pbf.acceleration = \
                 \"chebyshev\": Jacobi with solver.pbf.iterations = 4 is stable below 2/lambda_max, of the kernel's \
                 spectrum on the lattice at solver.support_ratio = 2 in 3 dimensions",
            ),
            (&["solver.pbf.relaxation=0.52", "solver.pbf.iterations=1"], "below 4/(3 lambda_max), of the kernel's"),
            (&["solver.pbf.relaxation=0.7", "solver.pbf.iterations=3"], "below (1 + 3^(-1/3))/lambda_max, of"),
            (&[flat[0], flat[1], "solver.pbf.relaxation=0.65"], "at solver.support_ratio = 3 in 2 dimensions"),
        ] {
            let message = load(&[settings, &[chebyshev]].concat()).unwrap_err();
            assert!(message.contains(words), "{message}");
            // Plain Jacobi may be asked for what it does not bear: where it breaks is worth a look.
            assert!(load(&[settings, &["solver.pbf.acceleration=none"]].concat()).is_ok(), "{settings:?}");
        }
        assert!(load(&["solver.pbf.relaxation=0.77", chebyshev]).is_ok());
        assert!(load(&["solver.pbf.relaxation=0.8"]).is_err(), "the default is accelerated");
        let message = load(&["solver.pbf.acceleration=anderson"]).unwrap_err();
        assert!(message.contains("solver.pbf.acceleration") && message.contains("\"chebyshev\""), "{message}");
    }

    #[test]
    fn a_warm_start_that_cannot_be_is_refused_with_its_reason() {
        assert_eq!(load(&["solver.pbf.warm_start=0.3"]).unwrap().solver.pbf.warm_start, 0.3);
        for (settings, what, reason) in [
            (&["solver.pbf.warm_start=0.4"][..], "0.4", "at most 0.3: energy was measured to rise at 0.4"),
            (
                &["solver.pbf.warm_start=0.2", "solver.pbf.acceleration=none"],
                "0.2",
                "it needs iterations with momentum",
            ),
            (&["solver.pbf.warm_start=0.2", "solver.pbf.iterations=1"], "0.2", "it needs iterations with momentum"),
        ] {
            let error = load(settings).unwrap_err();
            let start = format!("column.toml: solver.pbf.warm_start = {what}: ");
            assert!(error.contains(&start) && error.contains(reason), "{error}");
        }
    }

    #[test]
    fn a_coarse_correction_that_cannot_be_is_refused_with_its_reason() {
        let on = "solver.pbf.coarse_correction=true";
        assert!(load(&[on]).is_ok());
        let flat = ["domain.dimensions=2", "solver.support_ratio=3"];
        for (settings, words) in [
            (&["solver.pbf.acceleration=none"][..], "not with solver.pbf.acceleration = \"none\" and"),
            (&["solver.pbf.iterations=1"], "solver.pbf.iterations = 1: it needs iterations with momentum"),
            (&[flat[0], flat[1], "solver.pbf.iterations=2"], "three in two dimensions"),
            (&["domain.max_m.0=0.3"], "the domain is narrower along x than a cell of 2 h = 0.4 m"),
            (&["domain.max_m=[60, 60, 60]"], "150 x 150 x 150 cells of 2 h = 0.4 m, and 2097152 fit"),
        ] {
            let message = load(&[settings, &[on]].concat()).unwrap_err();
            let start = "column.toml: solver.pbf.coarse_correction = true: ";
            assert!(message.contains(start) && message.contains(words), "{message}");
        }
    }
}
