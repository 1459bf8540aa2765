//! The cases: what runs, against what it is held, and by which figures. The first figure of a case is
//! its error; a geometric height, length or area is always among them, for a density error alone can
//! pass a wrong fluid.

mod capillary_drop;
mod channel;
mod column_collapse;
mod dam_break;
mod elliptical_drop;
mod free_fall;
mod gauge;
mod hydrostatic;
mod sloshing;
mod square_patch;
mod standing_wave;
mod taylor_green;
mod wall_pressure;

pub use capillary_drop::CapillaryDrop;
pub use channel::{COUETTE, POISEUILLE};
pub use column_collapse::ColumnCollapse;
pub use dam_break::{MARTIN_MOYCE, SQUARE_COLUMN};
pub use elliptical_drop::EllipticalDrop;
pub use free_fall::FreeFall;
pub use gauge::Gauges;
pub(crate) use hydrostatic::bottom_compression;
pub use hydrostatic::{HYDROSTATIC, SHALLOW};
pub use sloshing::Sloshing;
pub use square_patch::SquarePatch;
pub use standing_wave::{STANDING_WAVE, StandingWave, VISCOUS_WAVE};
pub use taylor_green::{TAYLOR_GREEN, TAYLOR_GREEN_JITTERED, TAYLOR_GREEN_VISCOUS};
pub use wall_pressure::WallPressure;

use serde::{Deserialize, Serialize};

use crate::{Figure, Sample, Series, Setup, SetupResult, energy};

/// What a case is held against. Figures of different kinds are never merged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Reference {
    /// A closed form.
    Analytic,
    /// A published measurement.
    Experiment,
    /// An f64 run of the twins, finer in space, time and iterations.
    SelfConverged,
}

impl Reference {
    /// Every kind.
    pub const ALL: [Self; 3] = [Self::Analytic, Self::Experiment, Self::SelfConverged];

    /// As headings say it.
    pub fn title(self) -> &'static str {
        match self {
            Self::Analytic => "against closed forms",
            Self::Experiment => "against experiments",
            Self::SelfConverged => "against a converged run in f64",
        }
    }
}

/// Gives the samples of a reference run; none if it was stopped.
pub type Converge<'a> = &'a dyn Fn(&Setup) -> Option<Vec<Sample>>;

/// A case.
pub trait Case: Sync {
    /// Its name on the command line.
    fn name(&self) -> &'static str;

    /// What happens, and who published it.
    fn summary(&self) -> &'static str;

    /// What it is held against.
    fn reference(&self) -> Reference;

    /// The spacing it runs at when nobody says another, m.
    fn spacing_m(&self) -> f64;

    /// The case with settings (`path=value`) on top.
    ///
    /// # Errors
    /// If its scene does not allow one.
    fn setup(&self, settings: &[String]) -> SetupResult;

    /// What its energy may rise by, over that at play ([`crate::energy`]).
    fn energy_rise(&self) -> f64 {
        energy::RISE
    }

    /// What `samples` of a run of `setup` are judged by; none if its reference was stopped.
    fn figures(&self, setup: &Setup, samples: &[Sample], converge: Converge<'_>) -> Option<Vec<Figure>>;

    /// Courses in time that a plot shows.
    fn series(&self, _setup: &Setup, _samples: &[Sample]) -> Vec<Series> {
        Vec::new()
    }
}

/// h/d of the cases in two dimensions: 28 neighbours, about as many as three dimensions have at the
/// program's default of 2. There 2 gives 12, and a sum over 12 tells arrangements more than densities.
pub(crate) const FLAT_SUPPORT_RATIO: f64 = 3.0;

/// Every case that runs.
pub const CASES: &[&dyn Case] = &[
    &FreeFall,
    &HYDROSTATIC,
    &STANDING_WAVE,
    &EllipticalDrop,
    &SquarePatch,
    &TAYLOR_GREEN,
    &TAYLOR_GREEN_JITTERED,
    &MARTIN_MOYCE,
    &SQUARE_COLUMN,
    &Gauges,
    &Sloshing,
    &WallPressure,
    &ColumnCollapse,
];

/// Cases of a viscosity and a surface tension that are set, which SPH alone has.
pub const OF_SPH: &[&dyn Case] = &[&COUETTE, &POISEUILLE, &CapillaryDrop, &VISCOUS_WAVE, &TAYLOR_GREEN_VISCOUS];

/// Cases of maps alone.
const OF_MAPS: &[&dyn Case] = &[&SHALLOW];

/// The case of a name.
pub fn case(name: &str) -> Option<&'static dyn Case> {
    CASES.iter().chain(OF_SPH).chain(OF_MAPS).copied().find(|case| case.name() == name)
}

/// The setting's value in `settings` (the last of them counts), or `default`.
pub(crate) fn setting(settings: &[String], path: &str, default: f64) -> f64 {
    let of = |setting: &String| setting.strip_prefix(path)?.strip_prefix('=')?.parse().ok();
    settings.iter().rev().find_map(of).unwrap_or(default)
}

/// Speed of sound over the fastest particle: compression is about the inverse square.
const SOUND_RATIO: f64 = 10.0;

/// `settings` of a case whose particles are placed with velocities that its scene knows nothing of: an equation of state is
/// told how fast they are, unless it is told something else.
pub(crate) fn with_speed(speed_m_s: f64, settings: &[String]) -> Vec<String> {
    let chosen = settings.iter().rposition(|setting| setting.starts_with("solver.method="));
    let path = own_path(method_of(settings), "stiffness_m2_s2");
    let (Some(at), Some(path)) = (chosen, path) else { return settings.to_vec() };
    let mut all = settings.to_vec();
    all.insert(at + 1, format!("{path}={:?}", (SOUND_RATIO * speed_m_s).powi(2)));
    all
}

/// The solver that settings choose; cases are PBF's where none does.
pub(crate) fn method_of(settings: &[String]) -> &str {
    settings.iter().rev().find_map(|setting| setting.strip_prefix("solver.method=")).unwrap_or("pbf")
}

/// The path of a setting of a solver's own table, if it has it.
pub(crate) fn own_path(method: &str, name: &str) -> Option<&'static str> {
    let path = format!("solver.{method}.{name}");
    brooklet_fluid::scene::FIELDS.iter().map(|field| field.path).find(|known| *known == path)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_case_has_a_name_of_its_own_and_a_sound_setup() {
        let all = || CASES.iter().chain(OF_SPH);
        let mut names: Vec<&str> = all().map(|case| case.name()).collect();
        for case in all() {
            let setup = case.setup(&[]).unwrap_or_else(|error| panic!("{}: {error}", case.name()));
            assert!(setup.count() > 0 && setup.count() < 8_000, "{}: {}", case.name(), setup.count());
            assert!(setup.steps() > 0 && setup.sample_steps().len() > 1, "{}", case.name());
            assert_eq!(setup.scene.spacing_m, case.spacing_m());
            let finer = case.setup(&[format!("spacing_m={}", 0.5 * case.spacing_m())]).unwrap();
            assert!(case.name() == "free-fall" || finer.count() > setup.count() * 19 / 10, "{}", case.name());
        }
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), all().count());
        assert!(case("no such case").is_none());
    }

    #[test]
    fn an_equation_of_state_knows_how_fast_particles_are() {
        for name in ["elliptical-drop", "square-patch", "taylor-green"] {
            let with = |settings: &[&str]| {
                let settings: Vec<String> = settings.iter().map(|&setting| setting.into()).collect();
                case(name).unwrap().setup(&settings).unwrap()
            };
            let setup = with(&["solver.method=sph"]);
            let fastest_m_s = setup.start().max_speed_m_s();
            let sound_m_s = setup.scene.stiffness_m2_s2().sqrt();
            assert!((9.0..40.0).contains(&(sound_m_s / fastest_m_s)), "{name}: {sound_m_s} of {fastest_m_s}");
            let own = with(&["solver.method=sph", "solver.sph.stiffness_m2_s2=7"]);
            assert_eq!(own.scene.stiffness_m2_s2(), 7.0);
        }
        assert_eq!(with_speed(2.0, &["solver.method=pbf".into()]), ["solver.method=pbf"]);
        assert!(with_speed(2.0, &[]).is_empty());
    }

    #[test]
    fn the_last_setting_counts() {
        let settings = ["a=1", "ab=7", "a=2"].map(String::from);
        assert_eq!(setting(&settings, "a", 0.0), 2.0);
        assert_eq!(setting(&settings, "b", 0.5), 0.5);
    }
}
