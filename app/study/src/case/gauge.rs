//! SPHERIC 2's gauge in the reservoir, while nothing that is missing here can be felt there.

use brooklet_reference::dam_break::{Sample as Point, interpolate};

use super::{Case, Converge, Reference, setting};
use crate::{Figure, Sample, Series, Setup, SetupResult};

/// Kleefsman's dam break (SPHERIC test 2): tank 3.22 × 1 × 1 m, water .55 m deep in x 1.992 to 3.22 m.
/// The box that stands in the tank cannot be expressed yet; the flow reaches it after .4 s, and what it
/// changes needs over a second to run back up to gauge H4. Until 1 s H4 is the same without it.
pub struct ReservoirGauge;

const SPACING_M: f64 = 0.05;
const DT_S: f64 = 1.0 / 240.0;
const GAUGE_M: f64 = 2.638;
const DEPTH_M: f64 = 0.55;
const END_S: f64 = 1.0;
const TRACES: &str = include_str!("../../data/spheric2_gauges.csv");

/// Time and H4.
fn measured() -> Vec<Point> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(TRACES.as_bytes());
    let row = |row: csv::StringRecord| Some((row.get(0)?.parse().ok()?, row.get(4)?.parse().ok()?));
    reader.records().filter_map(|found| row(found.ok()?)).filter(|(t, _): &Point| *t <= END_S).collect()
}

/// Time and water level at the gauge, m: the highest particle there and half a spacing.
fn levels(setup: &Setup, samples: &[Sample]) -> Vec<Point> {
    let spacing_m = setup.scene.spacing_m;
    let level_m = |sample: &Sample| {
        let near = |at: &&glam::DVec3| (at.x - GAUGE_M).abs() < spacing_m && (at.z - 0.5).abs() < 2.0 * spacing_m;
        sample.positions_m.iter().filter(near).map(|at| at.y).fold(0.0, f64::max) + 0.5 * spacing_m
    };
    samples.iter().map(|s| (s.time_s, level_m(s))).collect()
}

impl Case for ReservoirGauge {
    fn name(&self) -> &'static str {
        "spheric-2-h4"
    }

    fn summary(&self) -> &'static str {
        "water level in the reservoir of a dam break, until 1 s (SPHERIC 2, gauge H4; without the box)"
    }

    fn reference(&self) -> Reference {
        Reference::Experiment
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
            max_m = [3.22, 1, 1]
            [[fluid]]
            block = {{ min_m = [1.992, 0, 0], max_m = [3.22, {DEPTH_M}, 1] }}
            [solver]
            dt_s = {dt_s}"
        );
        Ok(Setup::new(self.name(), &text, settings, END_S, 40)?.relaxed())
    }

    fn figures(&self, setup: &Setup, samples: &[Sample], _: Converge<'_>) -> Option<Vec<Figure>> {
        let levels = levels(setup, samples);
        let offs: Vec<f64> =
            measured().iter().filter_map(|&(t, h)| Some((interpolate(&levels, t)? - h) / DEPTH_M)).collect();
        let error = (offs.iter().map(|off| off * off).sum::<f64>() / offs.len() as f64).sqrt();
        let why = "root mean square over the depth; a spacing is 9 % of it";
        Some(vec![
            Figure::judged("level error", error, "", 0.1, why),
            Figure::told("level at the end", levels.last()?.1, "m", "the experiment's is .279"),
        ])
    }

    fn series(&self, setup: &Setup, samples: &[Sample]) -> Vec<Series> {
        vec![Series {
            name: "level".into(),
            x: "t, s".into(),
            y: "level at H4, m".into(),
            computed: levels(setup, samples),
            reference: measured(),
            measured: true,
        }]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn the_trace_agrees_with_itself_and_a_still_reservoir_does_not() {
        assert_eq!(measured(), [(0.415, 0.454), (0.49, 0.431), (1.0, 0.279)]);
        let setup = ReservoirGauge.setup(&[]).unwrap();
        let run = |level_m: &dyn Fn(f64) -> f64| -> Vec<Sample> {
            setup
                .sample_times_s
                .iter()
                .map(|&time_s| Sample {
                    time_s,
                    positions_m: vec![DVec3::new(GAUGE_M, level_m(time_s) - 0.025, 0.5)],
                    velocities_m_s: vec![DVec3::ZERO],
                    unsound: 0,
                })
                .collect()
        };
        let error = |run: &[Sample]| ReservoirGauge.figures(&setup, run, &|_| None).unwrap()[0].value.unwrap();
        let trace = measured();
        assert!(error(&run(&|t| interpolate(&trace, t).unwrap_or(0.454))) < 0.01);
        assert!(error(&run(&|_| DEPTH_M)) > 0.25);
    }
}
