//! How far a run is off another of the same scene.

use brooklet_fluid::{Scene, Stats};

use super::SHAKEN;
use super::course::Course;
use crate::Figure;

/// Name of what the ways are held against.
pub const FULL: &str = "full";

/// What is compared.
#[derive(Clone, Copy, Debug)]
pub struct Quantity {
    /// Its name.
    pub name: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// Whether only densities have it.
    pub of_density: bool,
    /// How far the second run is off the first.
    of: fn(&Scene, &Course, &Course) -> f64,
    /// What it may be, whatever the flow makes of a rounding; of which run's scale.
    rule: fn(&Scene, &Course) -> f64,
    why: &'static str,
}

/// What a way may be off by, in differences of a shaken run of `full`: two samples of one spread are not equal.
const OF_SHAKEN: f64 = 3.0;
/// Of a full run's compression: the study's own figures of error move by no more with f16 arithmetic.
const TENTH: f64 = 0.1;
/// Compression that is none, of a mean and of 99 of 100 particles.
const NO_COMPRESSION: [f64; 2] = [2e-4, 1e-3];

/// All of them, in the order of tables.
pub const QUANTITIES: [Quantity; 7] = [
    Quantity {
        name: "compression",
        unit: "",
        of_density: true,
        of: |_, full, other| (mean_of(other, |s| s.compression.mean) - mean_of(full, |s| s.compression.mean)).abs(),
        rule: |_, full| (TENTH * mean_of(full, |s| s.compression.mean)).max(NO_COMPRESSION[0]),
        why: "mean over particles and time; a tenth of full's, or of none",
    },
    Quantity {
        name: "compression p99",
        unit: "",
        of_density: true,
        of: |_, full, other| (mean_of(other, |s| s.compression.p99) - mean_of(full, |s| s.compression.p99)).abs(),
        rule: |_, full| (TENTH * mean_of(full, |s| s.compression.p99)).max(NO_COMPRESSION[1]),
        why: "of 99 of 100 particles, mean over time; a tenth of full's, or of none",
    },
    Quantity {
        name: "front",
        unit: "d",
        of_density: false,
        of: |scene, full, other| largest(full, other, |s| s.front_m) / scene.fitted_spacing_m(),
        rule: |_, _| 0.5,
        why: "largest x of the fluid, furthest off at any time; half a spacing",
    },
    Quantity {
        name: "middle",
        unit: "d",
        of_density: false,
        of: |scene, full, other| {
            let axes = [0, 1, 2].map(|axis| largest(full, other, |s| s.centre_of_mass_m[axis]));
            axes.into_iter().fold(0.0, larger) / scene.fitted_spacing_m()
        },
        rule: |_, _| 0.5,
        why: "centre of mass, furthest off along an axis at any time; half a spacing",
    },
    Quantity {
        name: "energy",
        unit: "",
        of_density: false,
        of: |scene, full, other| largest(full, other, |s| s.kinetic_j + s.potential_j) / at_play_j(scene, full),
        rule: |_, _| crate::energy::RISE,
        why: "furthest off at any time, over the energy at play; what energy may rise by",
    },
    Quantity {
        name: "picture, early",
        unit: "",
        of_density: false,
        of: |_, full, other| picture_difference(full.pictures.first(), other.pictures.first()),
        rule: |_, _| 0.01,
        why: "mean difference of a colour over its range, after a fifth of the run",
    },
    Quantity {
        name: "picture, last",
        unit: "",
        of_density: false,
        of: |_, full, other| picture_difference(full.pictures.last(), other.pictures.last()),
        rule: |_, _| 0.01,
        why: "the same at the end",
    },
];

fn quantities(scene: &Scene) -> impl Iterator<Item = &'static Quantity> {
    let has_density = scene.solver.method.interacts();
    QUANTITIES.iter().filter(move |quantity| has_density || !quantity.of_density)
}

impl Quantity {
    /// What it is, and what it may be.
    pub fn why(&self) -> &'static str {
        self.why
    }

    /// Name of a way's figure of it.
    pub fn figure_of(&self, way: &str) -> String {
        format!("{way}: {}", self.name)
    }
}

/// What `full` has, what shaken runs of it are off by at most, and, judged beside that, what those of the `ways` are that
/// were run.
pub fn figures(
    scene: &Scene,
    full: &Course,
    shaken: &[Course],
    ways: &[&str],
    others: &[Option<Course>],
) -> Vec<Figure> {
    let densities = [mean_of(full, |s| s.compression.mean), mean_of(full, |s| s.compression.p99)];
    let own = quantities(scene).filter(|quantity| quantity.of_density).zip(densities);
    let mut figures: Vec<Figure> =
        own.map(|(quantity, value)| Figure::told(&quantity.figure_of(FULL), value, "", "mean over time")).collect();
    for quantity in quantities(scene) {
        let chance = shaken.iter().map(|run| (quantity.of)(scene, full, run)).fold(0.0, larger);
        figures.push(Figure::told(&quantity.figure_of(SHAKEN), chance, quantity.unit, quantity.why));
        let limit = (OF_SHAKEN * chance).max((quantity.rule)(scene, full));
        let why = format!("{}, or three times what shaken starts are off by", quantity.why);
        figures.extend(ways.iter().zip(others).filter_map(|(way, other)| {
            let value = (quantity.of)(scene, full, other.as_ref()?);
            Some(Figure::judged(&quantity.figure_of(way), value, quantity.unit, limit, &why))
        }));
    }
    figures
}

fn mean_of(course: &Course, of: impl Fn(&Stats) -> f64) -> f64 {
    course.moments.iter().map(of).sum::<f64>() / course.moments.len() as f64
}

/// Largest difference of a measurement at the same time; not a number where the runs were not measured alike.
fn largest(full: &Course, other: &Course, of: impl Fn(&Stats) -> f64) -> f64 {
    if full.moments.len() != other.moments.len() || full.moments.is_empty() {
        return f64::NAN;
    }
    full.moments.iter().zip(&other.moments).map(|(a, b)| (of(a) - of(b)).abs()).fold(0.0, larger)
}

/// f64::max would drop what is not a number.
fn larger(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}

/// The largest kinetic energy, or that of falling a spacing where fluid is at rest.
fn at_play_j(scene: &Scene, full: &Course) -> f64 {
    let particles = full.moments.first().map_or(0, |stats| stats.particles);
    let g_m_s2 = scene.gravity_length_m_s2();
    let falls_j = f64::from(particles) * scene.particle_mass_kg() * g_m_s2 * scene.fitted_spacing_m();
    full.moments.iter().map(|stats| stats.kinetic_j).fold(falls_j, f64::max)
}

/// Mean difference of a colour over its range; not a number where sizes differ.
fn picture_difference(ours: Option<&Vec<u8>>, theirs: Option<&Vec<u8>>) -> f64 {
    let (Some(ours), Some(theirs)) = (ours, theirs) else { return f64::NAN };
    if ours.len() != theirs.len() || ours.is_empty() {
        return f64::NAN;
    }
    // Of four bytes the last is no colour.
    let colours = |rgba: &'_ [u8]| rgba.chunks_exact(4).flat_map(|p| [p[0], p[1], p[2]]).collect::<Vec<u8>>();
    let (ours, theirs) = (colours(ours), colours(theirs));
    let sum: f64 = ours.iter().zip(&theirs).map(|(a, b)| f64::from(a.abs_diff(*b))).sum();
    sum / (255.0 * ours.len() as f64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Verdict;
    use brooklet_fluid::measure::Summary;

    fn course(change: impl Fn(&mut Stats), grey: u8) -> Course {
        let mut stats =
            Stats { has_density: true, kinetic_j: 100.0, particles: 1000, front_m: 0.5, ..Stats::default() };
        stats.compression = Summary { mean: 0.01, p99: 0.03, max: 0.05 };
        change(&mut stats);
        Course { moments: vec![stats; 3], pictures: vec![vec![grey; 400]; 2] }
    }

    fn beyond(other: &Course, shaken: &Course) -> Vec<String> {
        let scene = Scene::load("dam-break", &[]).unwrap();
        let full = course(|_| {}, 100);
        let found = figures(&scene, &full, std::slice::from_ref(shaken), &["half"], &[Some(other.clone())]);
        assert_eq!(found.len(), 2 + 2 * QUANTITIES.len());
        found.into_iter().filter(|f| f.verdict() == Verdict::FallsShort).map(|f| f.name).collect()
    }

    #[test]
    fn what_stands_apart_is_found_and_each_by_its_own_figure() {
        let same = course(|_| {}, 100);
        assert!(beyond(&same, &same).is_empty());
        let d_m = Scene::load("dam-break", &[]).unwrap().fitted_spacing_m();
        assert_eq!(beyond(&course(|s| s.compression.mean = 0.0115, 100), &same), ["half: compression"]);
        assert_eq!(beyond(&course(|s| s.compression.p99 = 0.02, 100), &same), ["half: compression p99"]);
        assert_eq!(beyond(&course(|s| s.front_m += 0.6 * d_m, 100), &same), ["half: front"]);
        assert_eq!(beyond(&course(|s| s.centre_of_mass_m[1] -= 0.6 * d_m, 100), &same), ["half: middle"]);
        assert_eq!(beyond(&course(|s| s.potential_j = 1e4, 100), &same), ["half: energy"]);
        assert_eq!(beyond(&course(|_| {}, 104), &same).len(), 2);
        // What is not a number meets no limit, nor does what is missing.
        assert_eq!(beyond(&course(|s| s.front_m = f64::NAN, 100), &same), ["half: front"]);
        assert_eq!(beyond(&Course::default(), &same).len(), QUANTITIES.len());
    }

    #[test]
    fn what_a_flow_makes_of_a_rounding_is_allowed_to_it() {
        let d_m = Scene::load("dam-break", &[]).unwrap().fitted_spacing_m();
        let shaken = course(|s| s.front_m += d_m, 100);
        assert!(beyond(&course(|s| s.front_m -= 2.9 * d_m, 100), &shaken).is_empty());
        assert_eq!(beyond(&course(|s| s.front_m -= 3.1 * d_m, 100), &shaken), ["half: front"]);
    }
}
