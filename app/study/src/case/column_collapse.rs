//! A column that begins to collapse, against the same fluid computed far finer in f64.

use brooklet_reference::dam_break::{Sample as Point, interpolate};

use super::{Case, Converge, FLAT_SUPPORT_RATIO, Reference, setting};
use crate::{Figure, Sample, Setup, SetupResult};

/// A column of .5 × 1 m in a tank, in 2-D, until its front has run one base: before anything meets
/// anything, so that runs of different spacings still show the same flow.
pub struct ColumnCollapse;

const SPACING_M: f64 = 1.0 / 32.0;
const DT_S: f64 = 1.0 / 240.0;
const BASE_M: f64 = 0.5;
const HEIGHT_M: f64 = 1.0;
const END_S: f64 = 0.3;
/// Of the converged run.
const FINE_SPACING_M: f64 = 1.0 / 64.0;
const FINE_SUBSTEPS: u32 = 2;
const FINE_ITERATIONS: u32 = 24;

impl ColumnCollapse {
    /// The converged run's setup, with its own solver settings whatever is studied.
    ///
    /// # Errors
    /// None that its own scene does not have.
    pub fn fine() -> SetupResult {
        let settings = [
            format!("spacing_m={FINE_SPACING_M}"),
            format!("solver.substeps={FINE_SUBSTEPS}"),
            format!("solver.pbf.iterations={FINE_ITERATIONS}"),
        ];
        Self.setup(&settings)
    }
}

impl Case for ColumnCollapse {
    fn name(&self) -> &'static str {
        "column-collapse"
    }

    fn summary(&self) -> &'static str {
        "a column begins to collapse, in 2-D; an f64 run of half the spacing, a quarter of the substep and six times the iterations"
    }

    fn reference(&self) -> Reference {
        Reference::SelfConverged
    }

    fn spacing_m(&self) -> f64 {
        SPACING_M
    }

    fn setup(&self, settings: &[String]) -> SetupResult {
        let spacing_m = setting(settings, "spacing_m", SPACING_M);
        let dt_s = DT_S * spacing_m / SPACING_M;
        let text = format!(
            "spacing_m = {spacing_m}
            [domain]
            min_m = [0, 0, 0]
            max_m = [2, 1.5, {spacing_m}]
            dimensions = 2
            [[fluid]]
            block = {{ min_m = [0, 0, 0], max_m = [{BASE_M}, {HEIGHT_M}, {spacing_m}] }}
            [solver]
            support_ratio = {FLAT_SUPPORT_RATIO}
            dt_s = {dt_s}"
        );
        Ok(Setup::new(self.name(), &text, settings, END_S, 12)?.relaxed())
    }

    fn figures(&self, setup: &Setup, samples: &[Sample], converge: Converge<'_>) -> Option<Vec<Figure>> {
        let fine = Self::fine().ok()?;
        let converged = converge(&fine)?;
        let compared = |of: &dyn Fn(&Setup, &Sample) -> f64| {
            let series: Vec<Point> = converged.iter().map(|s| (s.time_s, of(&fine, s))).collect();
            // Steps of different lengths end at slightly different times.
            let inside = |s: &&Sample| s.time_s <= END_S && s.time_s >= series[0].0;
            let offs: Vec<f64> = samples
                .iter()
                .filter(inside)
                .filter_map(|s| Some(of(setup, s) - interpolate(&series, s.time_s)?))
                .collect();
            (offs.iter().map(|off| off * off).sum::<f64>() / offs.len() as f64).sqrt()
        };
        let front = compared(&|setup, s| s.front_m(setup.scene.spacing_m));
        let middle = compared(&|_, s| s.middle_m().y);
        let energy = compared(&|_, s| s.kinetic_m2_s2());
        Some(vec![
            Figure::told("front error", front / BASE_M, "", "root mean square over the base"),
            Figure::told(
                "height error",
                middle / (0.5 * HEIGHT_M),
                "",
                "of the centre of mass, over its own at the start",
            ),
            Figure::told(
                "energy error",
                energy / (9.81 * 0.5 * HEIGHT_M),
                "",
                "kinetic, over the potential energy at the start",
            ),
        ])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_agrees_with_itself_and_a_still_one_does_not() {
        let setup = ColumnCollapse::fine().unwrap();
        let at: Vec<glam::DVec3> = setup.particles.positions.iter().map(crate::setup::position_m).collect();
        let run = |pace: f64| -> Vec<Sample> {
            let times = setup.sample_times_s.iter();
            times
                .map(|&time_s| Sample {
                    time_s,
                    positions_m: at
                        .iter()
                        .map(|p| *p * glam::DVec3::new(1.0 + pace * time_s, 1.0 - 0.5 * pace * time_s, 1.0))
                        .collect(),
                    velocities_m_s: vec![glam::DVec3::new(pace, 0.0, 0.0); at.len()],
                    ..Sample::default()
                })
                .collect()
        };
        let figures = |pace: f64| -> Vec<f64> {
            let converged = run(1.0);
            let found = ColumnCollapse.figures(&setup, &run(pace), &|_| Some(converged.clone())).unwrap();
            found.iter().map(|figure| figure.value.unwrap()).collect()
        };
        assert!(figures(1.0).iter().all(|error| *error < 1e-12));
        assert!(figures(0.0).iter().all(|error| *error > 0.05), "{:?}", figures(0.0));
        assert!(ColumnCollapse.figures(&setup, &run(1.0), &|_| None).is_none(), "a stopped reference is no result");
    }
}
