//! SPHERIC 2: a dam breaks over a box, and gauges tell how high the water stands.

use brooklet_reference::dam_break::{Sample as Point, interpolate};

use super::{Case, Converge, Reference, setting};
use crate::{Figure, Sample, Series, Setup, SetupResult};

/// Kleefsman's dam break (SPHERIC test 2): tank 3.22 × 1 × 1 m, water .55 m deep in x 1.992 to 3.22 m, a box of
/// .161 × .161 × .403 m on the floor. Gauge H2 is between the two, H4 in the reservoir.
pub struct Gauges;

const SPACING_M: f64 = 0.05;
const DT_S: f64 = 1.0 / 240.0;
const DEPTH_M: f64 = 0.55;
const END_S: f64 = 6.0;
const SAMPLES: u32 = 120;
const TRACES: &str = include_str!("../../data/spheric2_gauges.csv");
/// Above that water has arrived at a gauge over a dry floor, in spacings.
const ARRIVED: f64 = 1.5;

/// A gauge.
#[derive(Clone, Copy)]
struct Gauge {
    name: &'static str,
    x_m: f64,
    /// Of the data.
    column: usize,
}

const H2: Gauge = Gauge { name: "H2", x_m: 0.992, column: 2 };
const H4: Gauge = Gauge { name: "H4", x_m: 2.638, column: 4 };

impl Gauge {
    /// Time and level, m.
    fn measured(self) -> Vec<Point> {
        let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(TRACES.as_bytes());
        let row = |row: csv::StringRecord| Some((row.get(0)?.parse().ok()?, row.get(self.column)?.parse().ok()?));
        reader.records().filter_map(|found| row(found.ok()?)).collect()
    }

    /// Time and level, m: how much of a wire there is wet, by layers of a spacing. What flies over it adds what it is thick.
    fn levels(self, setup: &Setup, samples: &[Sample]) -> Vec<Point> {
        let spacing_m = setup.scene.spacing_m;
        let level_m = |sample: &Sample| {
            let near = |at: &&glam::DVec3| (at.x - self.x_m).abs() < spacing_m && (at.z - 0.5).abs() < 2.0 * spacing_m;
            let mut layers: Vec<u32> =
                sample.positions_m.iter().filter(near).map(|at| (at.y / spacing_m) as u32).collect();
            layers.sort_unstable();
            layers.dedup();
            layers.len() as f64 * spacing_m
        };
        samples.iter().map(|s| (s.time_s, level_m(s))).collect()
    }

    /// Root mean square of what levels are off by, over the depth.
    fn error(self, levels: &[Point], until_s: f64) -> f64 {
        let rows = self.measured().into_iter().filter(|&(t, _)| t <= until_s);
        let offs: Vec<f64> = rows.filter_map(|(t, h)| Some((interpolate(levels, t)? - h) / DEPTH_M)).collect();
        (offs.iter().map(|off| off * off).sum::<f64>() / offs.len() as f64).sqrt()
    }
}

impl Case for Gauges {
    fn name(&self) -> &'static str {
        "spheric-2"
    }

    fn summary(&self) -> &'static str {
        "water levels of a dam that breaks over a box (SPHERIC 2, gauges H2 and H4)"
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
            [[solid]]
            box = {{ size_m = [0.161, 0.161, 0.403] }}
            centre_m = [0.744, 0.0805, 0.497]
            [solver]
            dt_s = {dt_s}"
        );
        Ok(Setup::new(self.name(), &text, settings, END_S, SAMPLES)?.relaxed())
    }

    fn figures(&self, setup: &Setup, samples: &[Sample], _: Converge<'_>) -> Option<Vec<Figure>> {
        let [h2, h4] = [H2, H4].map(|gauge| gauge.levels(setup, samples));
        let why = "root mean square over the depth; a spacing is 9 % of it";
        let dry_m = ARRIVED * setup.scene.spacing_m;
        let arrival_s = h2.iter().find(|(_, level_m)| *level_m > dry_m).map_or(f64::NAN, |(time_s, _)| *time_s);
        // The first row has 5.6 cm there.
        Some(vec![
            Figure::judged("level error at H2", H2.error(&h2, END_S), "", 0.15, why),
            Figure::judged("level error at H4", H4.error(&h4, END_S), "", 0.15, why),
            Figure::judged("level error at H4 until 1 s", H4.error(&h4, 1.0), "", 0.1, why),
            Figure::told("arrival at H2", arrival_s, "s", "the experiment's is before .415 s, when it has 5.6 cm"),
            Figure::told("H2 at the end", h2.last()?.1, "m", "the experiment's is .214"),
            Figure::told("H4 at the end", h4.last()?.1, "m", "the experiment's is .186"),
        ])
    }

    fn series(&self, setup: &Setup, samples: &[Sample]) -> Vec<Series> {
        let of = |gauge: Gauge| Series {
            name: gauge.name.into(),
            x: "t, s".into(),
            y: format!("level at {}, m", gauge.name),
            computed: gauge.levels(setup, samples),
            reference: gauge.measured(),
            measured: true,
        };
        vec![of(H2), of(H4)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn traces_agree_with_themselves_and_a_still_reservoir_does_not() {
        assert_eq!(H4.measured()[..3], [(0.415, 0.454), (0.49, 0.431), (1.0, 0.279)]);
        assert_eq!(H2.measured()[5], (6.0, 0.214));
        let setup = Gauges.setup(&[]).unwrap();
        // Layers of two centimetres, so that a level is told as exactly.
        let setup = Setup { scene: setup.scene.with_setting("spacing_m=0.02").unwrap(), ..setup };
        let run = |level_m: &dyn Fn(Gauge, f64) -> f64| -> Vec<Sample> {
            setup
                .sample_times_s
                .iter()
                .map(|&time_s| {
                    let of = |gauge: Gauge| {
                        let layers = (level_m(gauge, time_s) / 0.02).round() as u32;
                        (0..layers).map(move |k| DVec3::new(gauge.x_m, 0.02 * (f64::from(k) + 0.5), 0.5))
                    };
                    let positions_m: Vec<DVec3> = of(H2).chain(of(H4)).collect();
                    Sample {
                        time_s,
                        velocities_m_s: vec![DVec3::ZERO; positions_m.len()],
                        positions_m,
                        ..Sample::default()
                    }
                })
                .collect()
        };
        let errors = |run: &[Sample]| -> Vec<f64> {
            let figures = Gauges.figures(&setup, run, &|_| None).unwrap();
            figures[..3].iter().map(|figure| figure.value.unwrap()).collect()
        };
        let traced = |gauge: Gauge, t: f64| {
            let trace = gauge.measured();
            interpolate(&trace, t).unwrap_or(trace[0].1)
        };
        let right = errors(&run(&traced));
        assert!(right.iter().all(|&error| error < 0.03), "{right:?}");
        let still = errors(&run(&|gauge, _| if gauge.column == 4 { DEPTH_M } else { 0.0 }));
        assert!(still.iter().all(|&error| error > 0.25), "{still:?}");
    }
}
