//! Columns of water let go, in 2-D, against experiments: front and height.

use brooklet_reference::dam_break::{Sample as Point, best_shift, interpolate, mean_slope, parse_series, rmse};

use super::{Case, Converge, FLAT_SUPPORT_RATIO, Reference, setting};
use crate::{Figure, Sample, Series, Setup, SetupResult};

/// A column of base a and a height of some bases. The front is the largest x of any particle and half a
/// spacing, thin spray ahead included; the height that of the highest particle within two spacings of the
/// wall it leans on, and half a spacing.
pub struct DamBreak {
    name: &'static str,
    summary: &'static str,
    /// a, m.
    base_m: f64,
    /// Height over base.
    bases_high: f64,
    /// T = t √(this g / a).
    clock: f64,
    front: &'static str,
    height: &'static str,
    /// Where the front's slope is even, in T.
    slope_span: (f64, f64),
}

/// n² = 2, a = 57 mm.
pub const MARTIN_MOYCE: DamBreak = DamBreak {
    name: "martin-moyce",
    summary: "front and height of a collapsing column twice as high as wide (Martin & Moyce 1952)",
    base_m: 0.05715,
    bases_high: 2.0,
    clock: 2.0,
    front: include_str!("../../data/martin_moyce_n2_2_front.csv"),
    height: include_str!("../../data/martin_moyce_n2_2_height.csv"),
    slope_span: (2.5, 9.25),
};

/// n² = 1.
pub const SQUARE_COLUMN: DamBreak = DamBreak {
    name: "square-column",
    summary: "front and height of a collapsing square column (series of two sources, see the data)",
    base_m: 0.1,
    bases_high: 1.0,
    clock: 1.0,
    front: include_str!("../../data/square_column_n2_1_front.csv"),
    height: include_str!("../../data/square_column_n2_1_height.csv"),
    slope_span: (3.9, 9.55),
};

const G_M_S2: f64 = 9.81;
/// Spacings a base, unless another spacing is asked for.
const SPACINGS_A_BASE: f64 = 20.0;
/// A step over a √(d/g): what falls from rest moves so many spacings in it.
const DT_RATIO: f64 = 0.06;
/// The simulated clock may be set so far ahead or back, in T: the gate takes time to release.
const SHIFT: f64 = 0.2;

impl DamBreak {
    fn per_t_s(&self) -> f64 {
        (self.clock * G_M_S2 / self.base_m).sqrt()
    }

    fn data(text: &str) -> Vec<Point> {
        // Part of the program, and read by a test.
        parse_series(text).unwrap_or_default()
    }

    /// Front over base against T.
    fn fronts(&self, setup: &Setup, samples: &[Sample]) -> Vec<Point> {
        let spacing_m = setup.scene.spacing_m;
        samples.iter().map(|s| (s.time_s * self.per_t_s(), s.front_m(spacing_m) / self.base_m)).collect()
    }

    /// Height over the column's against t √(g/a), as both data sets have it.
    fn heights(&self, setup: &Setup, samples: &[Sample]) -> Vec<Point> {
        let spacing_m = setup.scene.spacing_m;
        let height_m = |sample: &Sample| {
            let beside = sample.positions_m.iter().filter(|at| at.x < 2.0 * spacing_m);
            beside.map(|at| at.y).fold(0.0, f64::max) + 0.5 * spacing_m
        };
        let per_s = (G_M_S2 / self.base_m).sqrt();
        samples.iter().map(|s| (s.time_s * per_s, height_m(s) / (self.bases_high * self.base_m))).collect()
    }
}

impl Case for DamBreak {
    fn name(&self) -> &'static str {
        self.name
    }

    fn summary(&self) -> &'static str {
        self.summary
    }

    fn reference(&self) -> Reference {
        Reference::Experiment
    }

    fn spacing_m(&self) -> f64 {
        self.base_m / SPACINGS_A_BASE
    }

    fn setup(&self, settings: &[String]) -> SetupResult {
        let spacing_m = setting(settings, "spacing_m", self.spacing_m());
        let dt_s = DT_RATIO * (self.spacing_m() / G_M_S2).sqrt() * spacing_m / self.spacing_m();
        let end_s = self.slope_span.1 / self.per_t_s();
        // The front runs 15 bases, and must not meet the far wall.
        let (length_m, height_m) = (20.0 * self.base_m, self.bases_high * self.base_m);
        let text = format!(
            "spacing_m = {spacing_m}
            [domain]
            min_m = [0, 0, 0]
            max_m = [{length_m}, {}, {spacing_m}]
            dimensions = 2
            [[fluid]]
            block = {{ min_m = [0, 0, 0], max_m = [{}, {height_m}, {spacing_m}] }}
            [solver]
            support_ratio = {FLAT_SUPPORT_RATIO}
            dt_s = {dt_s}",
            1.5 * height_m,
            self.base_m,
        );
        Ok(Setup::new(self.name, &text, settings, end_s, 60)?.relaxed())
    }

    fn figures(&self, setup: &Setup, samples: &[Sample], _: Converge<'_>) -> Option<Vec<Figure>> {
        let (front, height) = (Self::data(self.front), Self::data(self.height));
        let (fronts, heights) = (self.fronts(setup, samples), self.heights(setup, samples));
        let plain = rmse(&fronts, &front, 0.0).unwrap_or(f64::NAN);
        let (shift, shifted) = best_shift(&fronts, &front, SHIFT).unwrap_or((f64::NAN, f64::NAN));
        let (from, to) = self.slope_span;
        let slope = |series: &[Point]| mean_slope(series, from, to).unwrap_or(f64::NAN);
        let level: Vec<f64> =
            height.iter().filter_map(|&(t, h)| Some((interpolate(&heights, t)? - h).powi(2))).collect();
        let height_error = (level.iter().sum::<f64>() / level.len() as f64).sqrt();
        Some(vec![
            Figure::judged(
                "front error",
                shifted,
                "a",
                0.3,
                "root mean square after one shift of the clock, 2 % of the way; the data agree among themselves within .06; walls have no friction yet",
            ),
            Figure::told("front error unshifted", plain, "a", "root mean square on the clock as it is"),
            Figure::told("shift", shift, "T", "of at most .2: the gate's release"),
            Figure::judged(
                "slope error",
                slope(&fronts) / slope(&front) - 1.0,
                "",
                0.1,
                "mean dZ/dT, which needs no clock; Ritter's inviscid front is 20 % above it; walls have no friction yet",
            ),
            Figure::judged(
                "height error",
                height_error,
                "",
                0.06,
                "root mean square over the column's height; a spacing is 2.5 to 5 % of it",
            ),
        ])
    }

    fn series(&self, setup: &Setup, samples: &[Sample]) -> Vec<Series> {
        let tau = "t √(g/a)".to_string();
        let x = if self.clock == 1.0 { tau.clone() } else { format!("T = t √({} g/a)", self.clock) };
        vec![
            Series {
                name: "front".into(),
                x,
                y: "front / a (walls without friction)".into(),
                computed: self.fronts(setup, samples),
                reference: Self::data(self.front),
                measured: true,
            },
            Series {
                name: "height".into(),
                x: tau,
                y: "height / column's".into(),
                computed: self.heights(setup, samples),
                reference: Self::data(self.height),
                measured: true,
            },
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn every_series_is_read() {
        for case in [MARTIN_MOYCE, SQUARE_COLUMN] {
            for text in [case.front, case.height] {
                assert!(parse_series(text).unwrap().len() > 8, "{}", case.name);
            }
        }
    }

    #[test]
    fn the_experiment_agrees_with_itself_and_a_slow_one_does_not() {
        for case in [MARTIN_MOYCE, SQUARE_COLUMN] {
            let setup = case.setup(&[]).unwrap();
            let half_m = 0.5 * setup.scene.spacing_m;
            let (front, height) = (DamBreak::data(case.front), DamBreak::data(case.height));
            // A series knows nothing of the time before its first row.
            let value = |series: &[Point], t: f64| {
                let (first, last) = (series[0], series[series.len() - 1]);
                interpolate(series, t).unwrap_or(if t < first.0 { first.1 } else { last.1 })
            };
            let run = |pace: f64| -> Vec<Sample> {
                (1..=400)
                    .map(|k| f64::from(k) / 400.0 * setup.end_s())
                    .map(|time_s| {
                        let t = pace * time_s * case.per_t_s();
                        let tau = pace * time_s * (G_M_S2 / case.base_m).sqrt();
                        let x = value(&front, t) * case.base_m - half_m;
                        let y = value(&height, tau) * case.base_m * case.bases_high - half_m;
                        let positions_m = vec![DVec3::new(x, 0.0, 0.0), DVec3::new(0.0, y, 0.0)];
                        Sample { time_s, positions_m, velocities_m_s: vec![DVec3::ZERO; 2], ..Sample::default() }
                    })
                    .collect()
            };
            let verdicts = |pace| case.figures(&setup, &run(pace), &|_| None).unwrap();
            let shown = |figures: &[Figure]| figures.iter().map(|f| f.value.unwrap()).collect::<Vec<_>>();
            let right = shown(&verdicts(1.0));
            assert!(right[0] < 0.02 && right[3].abs() < 0.02 && right[4] < 0.01, "{right:?}");
            let slow = shown(&verdicts(0.7));
            assert!(slow[0] > 0.3 && slow[3] < -0.1, "{slow:?}");
        }
    }
}
