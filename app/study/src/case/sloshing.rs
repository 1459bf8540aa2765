//! SPHERIC 10: a tank is rolled, and what runs along its floor hits a side; pressure at a gauge.

use std::f64::consts::TAU;
use std::fmt::Write as _;

use super::{Case, Converge, Reference, setting};
use crate::{Figure, Sample, Series, Setup, SetupResult};

/// Lateral impacts of water (SPHERIC test 10; Souto-Iglesias, Botia-Vera, Martín & Pérez-Arribas 2011): tank 900 × 508 ×
/// 62 mm, filled 93 mm deep, rolled about the middle of its floor. The gauge is on a side at the height of the water at rest.
/// Here a slice of [`SLICE`] spacings, and a gauge that is as wide as the slice and two spacings high.
pub struct Sloshing;

const LENGTH_M: f64 = 0.9;
const HEIGHT_M: f64 = 0.508;
const DEPTH_M: f64 = 0.093;
const SPACING_M: f64 = DEPTH_M / 10.0;
/// Spacings across.
const SLICE: f64 = 4.0;
const ROLL_DEG: f64 = 4.0;
/// .85 of the first sloshing period, 1.917 s.
const PERIOD_S: f64 = 0.85 * 1.917;
/// Keyframes of a period, between which it turns evenly: a 800th of the roll off at most.
const KEYFRAMES: u32 = 64;
const DT_S: f64 = 1.0 / 480.0;
/// What a pressure is averaged over, s: water at 2 m/s passes a spacing in it.
const WINDOW_S: f64 = 0.005;
/// Peaks over 100 repeats, mean and standard deviation, mbar.
const PEAKS_MBAR: [(f64, f64); 4] = [(37.1, 7.3), (48.2, 15.0), (46.9, 17.1), (46.4, 13.2)];
/// When the first of four impacts comes, about; the others follow a period apart.
const FIRST_S: f64 = 2.5;
const END_S: f64 = 7.9;

/// The roll at a time, degrees around z.
fn roll_deg(time_s: f64) -> f64 {
    ROLL_DEG * (TAU * time_s / PERIOD_S).sin()
}

/// A box that rolls with the tank: size and middle in the tank's frame, whose origin is the middle of its floor, m.
fn rolling(size_m: [f64; 3], [x, y, z]: [f64; 3], more: &str) -> String {
    let mut text = format!("[[solid]]\nbox = {{ size_m = {size_m:?} }}\nrepeat = true\n{more}");
    for k in 0..=KEYFRAMES {
        let time_s = PERIOD_S * f64::from(k) / f64::from(KEYFRAMES);
        let (sin, cos) = roll_deg(time_s).to_radians().sin_cos();
        let centre_m = [x * cos - y * sin, x * sin + y * cos, z];
        // A string is written without fail.
        let _ = writeln!(
            text,
            "[[solid.keyframe]]\ntime_s = {time_s:?}\ncentre_m = {centre_m:?}\nturned_deg = [0, 0, {:?}]",
            roll_deg(time_s)
        );
    }
    text
}

/// Time and pressure at the gauge, mbar: the force across it over its surface, averaged over [`WINDOW_S`].
fn pressures(setup: &Setup, samples: &[Sample]) -> Vec<(f64, f64)> {
    let spacing_m = setup.scene.spacing_m;
    let surface_m2 = 2.0 * spacing_m * SLICE * spacing_m;
    let each: Vec<(f64, f64)> = samples
        .iter()
        .flat_map(|sample| &sample.forces)
        .filter_map(|force| {
            let (sin, cos) = roll_deg(force.time_s).to_radians().sin_cos();
            // The gauge is where x is lowest: what pushes it does so towards lower x of the tank.
            let push_n = force.on_solids_n.first().map(|on| -(on.x * cos + on.y * sin))?;
            Some((force.time_s, push_n / surface_m2 / 100.0))
        })
        .collect();
    let steps = ((WINDOW_S / setup.scene.solver.dt_s).round() as usize).max(1);
    let mean = |window: &[(f64, f64)]| {
        let sum = window.iter().fold((0.0, 0.0), |sum, of| (sum.0 + of.0, sum.1 + of.1));
        (sum.0 / window.len() as f64, sum.1 / window.len() as f64)
    };
    each.windows(steps).map(mean).collect()
}

/// Time and pressure of each impact's peak: of each period around the first on, however weak one is beside the others.
fn peaks(pressures: &[(f64, f64)]) -> Vec<(f64, f64)> {
    (0..PEAKS_MBAR.len())
        .map_while(|k| {
            let from_s = FIRST_S + (k as f64 - 0.5) * PERIOD_S;
            let of = pressures.iter().filter(|at| (from_s..from_s + PERIOD_S).contains(&at.0));
            of.copied().max_by(|a, b| a.1.total_cmp(&b.1))
        })
        .collect()
}

impl Case for Sloshing {
    fn name(&self) -> &'static str {
        "spheric-10"
    }

    fn summary(&self) -> &'static str {
        "pressures where water in a tank that rolls hits its side (SPHERIC 10, lateral impacts)"
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
        let (half_m, wall_m, slice_m) = (0.5 * LENGTH_M, 4.0 * SPACING_M, SLICE * spacing_m);
        let (across_m, z) = (slice_m + 2.0 * wall_m, 0.5 * slice_m);
        let [low_m, high_m] = [DEPTH_M - spacing_m, DEPTH_M + spacing_m];
        let side = |from_m: f64, to_m: f64, x: f64, more: &str| {
            rolling([wall_m, to_m - from_m, across_m], [x, 0.5 * (from_m + to_m), z], more)
        };
        let (left_m, right_m) = (-half_m - 0.5 * wall_m, half_m + 0.5 * wall_m);
        let solids = [
            side(low_m, high_m, left_m, "measure_force = true\n"),
            side(0.0, low_m, left_m, ""),
            side(high_m, HEIGHT_M, left_m, ""),
            side(0.0, HEIGHT_M, right_m, ""),
            rolling([LENGTH_M + 2.0 * wall_m, wall_m, across_m], [0.0, -0.5 * wall_m, z], ""),
        ]
        .concat();
        let text = format!(
            "spacing_m = {spacing_m}
            [domain]
            min_m = [-0.56, -0.09, 0]
            max_m = [0.56, 0.56, {slice_m}]
            [[fluid]]
            block = {{ min_m = [-{half_m}, 0, 0], max_m = [{half_m}, {DEPTH_M}, {slice_m}] }}
            {solids}
            [solver]
            dt_s = {dt_s}"
        );
        Ok(Setup::new(self.name(), &text, settings, END_S, 40)?.relaxed())
    }

    fn figures(&self, setup: &Setup, samples: &[Sample], _: Converge<'_>) -> Option<Vec<Figure>> {
        let found = peaks(&pressures(setup, samples));
        let off = |((_, mbar), (mean, deviation)): (&(f64, f64), &(f64, f64))| (mbar - mean) / deviation;
        let offs: Vec<f64> = found.iter().zip(&PEAKS_MBAR).map(off).collect();
        let mean_square = || offs.iter().map(|off| off * off).sum::<f64>() / offs.len() as f64;
        let rms = if offs.len() == PEAKS_MBAR.len() { mean_square().sqrt() } else { f64::NAN };
        let judged = Figure::judged(
            "peaks off",
            rms,
            "",
            2.0,
            "root mean square of four, each over the deviation of 100 repeats: nobody's are nearer than one",
        );
        let told = found.iter().zip(&PEAKS_MBAR).enumerate().flat_map(|(k, (&(time_s, mbar), (mean, deviation)))| {
            let what = format!("the experiment's: {mean}, deviation {deviation}");
            [
                Figure::told(&format!("peak {}", k + 1), mbar, "mbar", &what),
                Figure::told(&format!("time of peak {}", k + 1), time_s, "s", "since the roll began"),
            ]
        });
        Some([judged].into_iter().chain(told).collect())
    }

    fn series(&self, setup: &Setup, samples: &[Sample]) -> Vec<Series> {
        let computed = pressures(setup, samples);
        let times_s = peaks(&computed);
        let reference = times_s.iter().zip(&PEAKS_MBAR).map(|(&(time_s, _), &(mean, _))| (time_s, mean)).collect();
        vec![Series {
            name: "gauge".into(),
            x: "t, s".into(),
            y: "pressure, mbar (points: mean peaks of 100 repeats)".into(),
            computed,
            reference,
            measured: true,
        }]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Force;
    use glam::DVec3;

    /// A run whose impacts last 20 ms and are as high as said.
    fn run(setup: &Setup, mbar: [f64; 4]) -> Vec<Sample> {
        let surface_m2 = 2.0 * SPACING_M * SLICE * SPACING_M;
        let force = |k: u64| {
            let time_s = k as f64 * DT_S;
            let since_s = (time_s - 2.4).rem_euclid(PERIOD_S);
            let number = ((time_s - 2.4) / PERIOD_S).floor();
            let mbar = if number >= 0.0 && since_s < 0.02 { mbar.get(number as usize).copied() } else { None };
            let (sin, cos) = roll_deg(time_s).to_radians().sin_cos();
            let push_n = mbar.unwrap_or(0.1) * 100.0 * surface_m2;
            Force { time_s, on_solids_n: vec![-push_n * DVec3::new(cos, sin, 0.0)] }
        };
        vec![Sample { forces: (1..setup.steps()).map(force).collect(), ..Sample::default() }]
    }

    #[test]
    fn the_experiments_peaks_are_not_off_and_others_are() {
        let setup = Sloshing.setup(&[]).unwrap();
        let off = |run: &[Sample]| Sloshing.figures(&setup, run, &|_| None).unwrap()[0].value;
        let means = PEAKS_MBAR.map(|(mean, _)| mean);
        assert!(off(&run(&setup, means)).unwrap() < 0.01);
        assert!(off(&run(&setup, means.map(|mbar| 2.0 * mbar))).unwrap() > 2.5);
        assert!(off(&run(&setup, means.map(|mbar| 0.1 * mbar))).unwrap() > 2.5);
        let first_is_weak = [0.1 * means[0], means[1], means[2], means[3]];
        assert!((off(&run(&setup, first_is_weak)).unwrap() - 0.5 * 0.9 * means[0] / PEAKS_MBAR[0].1).abs() < 0.1);
        let figures = Sloshing.figures(&setup, &run(&setup, means), &|_| None).unwrap();
        assert!((figures[2].value.unwrap() - 2.4).abs() < 0.03, "{:?}", figures[2]);
        assert_eq!(off(&[Sample::default()]), None, "no pressure at all is no agreement");
    }

    #[test]
    fn the_roll_is_that_of_the_tank() {
        assert!(roll_deg(0.0) == 0.0 && (roll_deg(0.25 * PERIOD_S) - ROLL_DEG).abs() < 1e-9);
        let setup = Sloshing.setup(&[]).unwrap();
        assert!(setup.scene.solids[0].measure_force && setup.scene.solids.len() == 5);
        let keyframe = setup.scene.solids[0].keyframes[16];
        // A quarter of a period, 4 degrees: what is left and up has come down and further left.
        let (sin, cos) = 4.0_f64.to_radians().sin_cos();
        let x = -0.5 * LENGTH_M - 2.0 * SPACING_M;
        assert!((keyframe.centre_m[0] - (x * cos - DEPTH_M * sin)).abs() < 1e-9, "{keyframe:?}");
        assert!((keyframe.centre_m[1] - (x * sin + DEPTH_M * cos)).abs() < 1e-9, "{keyframe:?}");
    }
}
