//! Solvers beside PBF: what is turned of each, and the table that says where one is worth a run. A new solver is its rungs
//! and its lines of the table.

use brooklet_fluid::scene::{Method, SphSettings};
use brooklet_fluid::{Scene, SceneError};

/// A setting of another solver.
#[derive(Clone, Copy, Debug)]
pub struct Rung {
    /// The solver.
    pub method: &'static str,
    /// What is turned, in words.
    pub name: &'static str,
    /// The settings, given the scene by that solver.
    settings: fn(&Scene) -> Vec<String>,
}

impl PartialEq for Rung {
    fn eq(&self, other: &Self) -> bool {
        (self.method, self.name) == (other.method, other.name)
    }
}

impl Eq for Rung {}

/// Cheapest first: an equation of state's compression falls with its stiffness, its step with the square root of that.
pub const RUNGS: &[Rung] = &[
    Rung { method: "sph", name: "stiffness / 4", settings: |scene| stiffness(scene, 0.25) },
    Rung { method: "sph", name: "stiffness x 1", settings: |scene| stiffness(scene, 1.0) },
    Rung { method: "sph", name: "stiffness x 4", settings: |scene| stiffness(scene, 4.0) },
    Rung { method: "sph", name: "stiffness x 16", settings: |scene| stiffness(scene, 16.0) },
    Rung { method: "dfsph", name: "2 + 1 iterations", settings: |_| fixed() },
    Rung { method: "dfsph", name: "tolerance x 3", settings: |scene| tolerances(scene, 3.0) },
    Rung { method: "dfsph", name: "tolerance x 1", settings: |scene| tolerances(scene, 1.0) },
    Rung { method: "dfsph", name: "tolerance / 3", settings: |scene| tolerances(scene, 1.0 / 3.0) },
    Rung { method: "dfsph", name: "tolerance / 10", settings: |scene| tolerances(scene, 0.1) },
];

fn stiffness(scene: &Scene, times: f64) -> Vec<String> {
    vec![format!("solver.sph.stiffness_m2_s2={:?}", times * scene.stiffness_m2_s2())]
}

fn fixed() -> Vec<String> {
    ["fixed_iterations=true", "max_divergence_iterations=2", "max_density_iterations=1"]
        .map(|setting| format!("solver.dfsph.{setting}"))
        .to_vec()
}

fn tolerances(scene: &Scene, times: f64) -> Vec<String> {
    let dfsph = &scene.solver.dfsph;
    [("divergence", dfsph.divergence_tolerance), ("density", dfsph.density_tolerance)]
        .map(|(solve, tolerance)| format!("solver.dfsph.{solve}_tolerance={:?}", times * tolerance))
        .to_vec()
}

impl Rung {
    /// The scene with this setting.
    ///
    /// # Errors
    /// If the scene does not allow it.
    pub fn apply(&self, scene: &Scene) -> Result<Scene, Box<SceneError>> {
        let method = format!("solver.method={}", self.method);
        let with = |settings: &[String]| Scene::from_toml(&scene.to_toml(), &scene.name, settings).map_err(Box::new);
        let by = with(std::slice::from_ref(&method))?;
        with(&[&[method][..], &(self.settings)(&by)].concat())
    }
}

/// A line of the table.
#[derive(Clone, Copy, Debug)]
struct Known {
    method: &'static str,
    /// Compression of 99 of 100 particles, mean over the run.
    error: f64,
    /// Time of a step over that of PBF with 1 substep of 4 iterations.
    time: f64,
}

const fn known(method: &'static str, error: f64, time: f64) -> Known {
    Known { method, error, time }
}

/// Error against time as `tune` measures both, on the dam break of 1,872 particles (spacing .05 m, .5 s) on lavapipe,
/// two quiet CPU cores: `brooklet tune dam-break --set spacing_m=0.05 --max-error 0.0005 --methods NAME`.
const TABLE: &[Known] = &[
    known("pbf", 0.0111, 0.75),
    known("pbf", 0.0048, 0.8),
    known("pbf", 0.0023, 1.0),
    known("pbf", 0.0012, 1.15),
    known("pbf", 0.00077, 2.0),
    known("pbf", 0.00018, 3.5),
    known("sph", 0.0269, 2.3),
    known("sph", 0.0065, 3.8),
    known("sph", 0.0017, 5.8),
    known("sph", 0.00045, 10.3),
    known("dfsph", 0.0103, 1.25),
    known("dfsph", 0.0052, 4.4),
    known("dfsph", 0.0039, 4.8),
];

/// What a step by a solver takes at an error, by the table: between its lines and beyond them straight in logarithms.
fn time_at(method: &str, error: f64) -> Option<f64> {
    let lines: Vec<(f64, f64)> =
        TABLE.iter().filter(|known| known.method == method).map(|known| (known.error.ln(), known.time.ln())).collect();
    let at = error.max(1e-6).ln();
    let pair = lines.windows(2).find(|pair| at >= pair[1].0).or(lines.windows(2).last())?;
    let slope = (pair[1].1 - pair[0].1) / (pair[1].0 - pair[0].0);
    Some((pair[0].1 + slope * (at - pair[0].0)).exp())
}

/// How many times as long as PBF a solver takes for an error, by the table; none where the table has not heard of it.
pub fn times_of_pbf(method: &str, error: f64) -> Option<f64> {
    Some(time_at(method, error)? / time_at("pbf", error)?)
}

/// The solvers that may move a scene: its own alone where it sets a term that others have not, and no other where its
/// particles do not interact.
pub fn solvers_of(scene: &Scene) -> Vec<&'static str> {
    let (own, sph, default) = (scene.solver.method, &scene.solver.sph, SphSettings::default());
    let bound = match own {
        Method::Sph => sph.surface_tension_n_m > 0.0 || sph.viscosity_m2_s != default.viscosity_m2_s,
        _ => !own.interacts(),
    };
    if bound {
        return vec![own.name()];
    }
    crate::method::METHODS.iter().map(|method| method.name).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::METHODS;

    #[test]
    fn every_solver_has_its_lines_and_falls_in_error_as_it_rises_in_time() {
        for method in METHODS {
            let lines: Vec<&Known> = TABLE.iter().filter(|known| known.method == method.name).collect();
            assert!(lines.len() > 1, "{}", method.name);
            assert!(lines.windows(2).all(|pair| pair[0].error > pair[1].error && pair[0].time < pair[1].time));
            assert!(method.name == "pbf" || RUNGS.iter().any(|rung| rung.method == method.name));
            let [middle, first] =
                [lines[1], lines[0]].map(|known| time_at(method.name, known.error).unwrap() / known.time);
            assert!((middle - 1.0).abs() < 1e-9 && (first - 1.0).abs() < 1e-9);
            assert!(time_at(method.name, 1e-5) > time_at(method.name, 1e-3));
        }
        assert_eq!(times_of_pbf("no such solver", 0.01), None);
    }

    #[test]
    fn rungs_are_scenes_that_are_allowed() {
        let scene = Scene::load("dam-break", &["spacing_m=0.05".into()]).unwrap();
        let of = |method: &'static str| {
            RUNGS.iter().filter(move |rung| rung.method == method).map(|rung| rung.apply(&scene).unwrap())
        };
        let stiffnesses: Vec<f64> = of("sph").map(|scene| scene.stiffness_m2_s2()).collect();
        assert!(stiffnesses.windows(2).all(|pair| (pair[1] / pair[0] - 4.0).abs() < 1e-9), "{stiffnesses:?}");
        let tolerances: Vec<f64> = of("dfsph").skip(1).map(|scene| scene.solver.dfsph.density_tolerance).collect();
        assert!(tolerances.windows(2).all(|pair| pair[1] < 0.5 * pair[0]), "{tolerances:?}");
    }

    #[test]
    fn a_term_that_one_solver_has_binds_a_scene_to_it() {
        let solvers = |settings: &[&str]| {
            let settings: Vec<String> = settings.iter().map(|&setting| setting.into()).collect();
            solvers_of(&Scene::load("dam-break", &settings).unwrap()).len()
        };
        assert_eq!(solvers(&[]), METHODS.len());
        assert_eq!(solvers(&["solver.method=sph"]), METHODS.len());
        assert_eq!(solvers(&["solver.method=sph", "solver.sph.viscosity_m2_s=0.01"]), 1);
        assert_eq!(solvers(&["solver.method=none"]), 1);
    }
}
