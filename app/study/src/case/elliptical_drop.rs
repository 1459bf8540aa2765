//! A drop stretched by its own motion, without walls and gravity.

use glam::DVec3;

use super::{Case, Converge, FLAT_SUPPORT_RATIO, Reference, setting, with_speed};
use crate::{Figure, Sample, Series, Setup, SetupResult};

/// A disc with velocity (−A x, A y) becomes an ellipse of axes a and 1/a (Monaghan 1994):
/// ȧ = −a A, Ȧ = A² (a⁴ − 1) / (a⁴ + 1), with R = 1 and A₀ = 1.
pub struct EllipticalDrop;

const SPACING_M: f64 = 1.0 / 16.0;
const END_S: f64 = 1.0;
/// Of the fastest particle: Ȧ falls while a falls.
const SPEED_M_S: f64 = 1.0;
/// A fifth of a spacing a step for what moves at 2 m/s.
const COURANT: f64 = 0.1;
/// From the middle to an edge of the domain.
const HALF_M: f64 = 4.0;

impl Case for EllipticalDrop {
    fn name(&self) -> &'static str {
        "elliptical-drop"
    }

    fn summary(&self) -> &'static str {
        "a disc stretches into an ellipse, in 2-D, without walls and gravity (Monaghan 1994)"
    }

    fn reference(&self) -> Reference {
        Reference::Analytic
    }

    fn spacing_m(&self) -> f64 {
        SPACING_M
    }

    fn setup(&self, settings: &[String]) -> SetupResult {
        let spacing_m = setting(settings, "spacing_m", SPACING_M);
        let text = format!(
            "spacing_m = {spacing_m}
            gravity_m_s2 = [0, 0, 0]
            [domain]
            min_m = [-{HALF_M}, -{HALF_M}, 0]
            max_m = [{HALF_M}, {HALF_M}, {spacing_m}]
            walls = false
            dimensions = 2
            [[fluid]]
            sphere = {{ centre_m = [0, 0, {0}], radius_m = 1.0 }}
            [solver]
            support_ratio = {FLAT_SUPPORT_RATIO}
            dt_s = {1}
            [forces]
            xsph = 0",
            0.5 * spacing_m,
            COURANT * spacing_m
        );
        // At the ends of the long axis.
        let settings = with_speed(SPEED_M_S, settings);
        let mut setup = Setup::new(self.name(), &text, &settings, END_S, 20)?;
        setup.place(|at, velocity| *velocity = DVec3::new(HALF_M - at.x, at.y - HALF_M, 0.0));
        Ok(setup.relaxed())
    }

    /// Kinetic energy is all there is, and constant.
    fn energy_rise(&self) -> f64 {
        1.0e-3
    }

    fn figures(&self, setup: &Setup, samples: &[Sample], _: Converge<'_>) -> Option<Vec<Figure>> {
        let start = setup.start();
        let axes_then_m = axes_m(&start);
        let (mut squares, mut area, mut off_axes) = (0.0, 0.0_f64, glam::DVec2::ZERO);
        for sample in samples {
            let (a, _) = exact(sample.time_s);
            let ratio = axes_m(sample) / axes_then_m;
            squares += 0.5 * ((ratio.x / a - 1.0).powi(2) + (ratio.y * a - 1.0).powi(2));
            let off = ratio.x * ratio.y - 1.0;
            area = if off.abs() > area.abs() { off } else { area };
            off_axes = glam::DVec2::new(ratio.x / a - 1.0, ratio.y * a - 1.0);
        }
        let drift = samples.last()?.drift_m_s();
        Some(vec![
            Figure::judged(
                "axis error",
                (squares / samples.len() as f64).sqrt(),
                "",
                0.05,
                "both semi-axes, root mean square over 20 times until A t = 1; a spacing is 6 % of the radius",
            ),
            Figure::judged(
                "area error",
                area,
                "",
                0.05,
                "largest, positive of a drop that swells; from the second moments",
            ),
            Figure::told("short axis error", off_axes.x, "", "at the end"),
            Figure::told("long axis error", off_axes.y, "", "at the end"),
            Figure::judged("momentum drift", drift, "m/s", 1.0e-4, "no force acts from outside"),
        ])
    }

    fn series(&self, setup: &Setup, samples: &[Sample]) -> Vec<Series> {
        let then_m = axes_m(&setup.start());
        let computed = |axis: usize| samples.iter().map(|s| (s.time_s, axes_m(s)[axis] / then_m[axis])).collect();
        let exactly = |of: fn(f64) -> f64| {
            let times = (0..=50).map(|k| END_S * f64::from(k) / 50.0);
            times.map(|time_s| (time_s, of(exact(time_s).0))).collect()
        };
        let one = |name: &str, computed, reference| Series {
            name: name.into(),
            x: "A t".into(),
            y: name.into(),
            computed,
            reference,
            measured: false,
        };
        vec![
            one("short axis / R", computed(0), exactly(|a| a)),
            one("long axis / R", computed(1), exactly(|a| 1.0 / a)),
        ]
    }
}

/// Semi-axes along x and y, up to one constant factor: roots of the second moments.
fn axes_m(sample: &Sample) -> glam::DVec2 {
    let middle_m = sample.middle_m();
    let spread = |axis: usize| sample.mean(|at, _| (at[axis] - middle_m[axis]).powi(2)).sqrt();
    glam::DVec2::new(spread(0), spread(1))
}

/// a and A at a time, by Runge-Kutta in a thousand steps.
fn exact(time_s: f64) -> (f64, f64) {
    let slope = |a: f64, rate: f64| (-a * rate, rate * rate * (a.powi(4) - 1.0) / (a.powi(4) + 1.0));
    let steps = 1000;
    let dt = time_s / f64::from(steps);
    (0..steps).fold((1.0, 1.0), |(a, rate), _| {
        let (a1, r1) = slope(a, rate);
        let (a2, r2) = slope(a + 0.5 * dt * a1, rate + 0.5 * dt * r1);
        let (a3, r3) = slope(a + 0.5 * dt * a2, rate + 0.5 * dt * r2);
        let (a4, r4) = slope(a + dt * a3, rate + dt * r3);
        (a + dt / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4), rate + dt / 6.0 * (r1 + 2.0 * r2 + 2.0 * r3 + r4))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_closed_form_has_its_published_values() {
        for (time_s, a) in [(0.5, 0.62705), (0.76, 0.51427), (1.0, 0.43946), (2.0, 0.27181)] {
            assert!((exact(time_s).0 - a).abs() < 5e-6, "{time_s}: {}", exact(time_s).0);
        }
    }

    #[test]
    fn a_drop_that_moves_as_it_should_has_no_error_and_one_that_does_not_has() {
        let setup = EllipticalDrop.setup(&[]).unwrap();
        let middle = DVec3::new(HALF_M, HALF_M, 0.0);
        let moved = |stretch: f64| -> Vec<Sample> {
            setup
                .sample_times_s
                .iter()
                .map(|&time_s| {
                    let (a, rate) = exact(time_s);
                    let a = a * stretch;
                    let at = |p: &brooklet_kernels::Position| {
                        let from = crate::setup::position_m(p) - middle;
                        middle + DVec3::new(from.x * a, from.y / a, from.z)
                    };
                    let positions_m: Vec<DVec3> = setup.particles.positions.iter().map(at).collect();
                    let velocity = |at: &DVec3| DVec3::new(-(at.x - middle.x), at.y - middle.y, 0.0) * rate;
                    let velocities_m_s = positions_m.iter().map(velocity).collect();
                    Sample { time_s, positions_m, velocities_m_s, ..Sample::default() }
                })
                .collect()
        };
        let figures = |stretch| EllipticalDrop.figures(&setup, &moved(stretch), &|_| None).unwrap();
        assert!(figures(1.0)[0].value.unwrap() < 1e-6, "{:?}", figures(1.0));
        assert!((figures(1.1)[0].value.unwrap() - 0.1).abs() < 0.01);
    }
}
