//! A drop that its surface tension swings.

use std::f64::consts::PI;

use glam::DVec3;

use super::standing_wave::{crossings_s, decay_per_s};
use super::{Case, Converge, FLAT_SUPPORT_RATIO, Reference, setting};
use crate::{Figure, Sample, Series, Setup, SetupResult};

/// A disc that begins as an ellipse swings about its circle: ω² = n (n² - 1) σ / ρR³ with n = 2 in 2-D (Rayleigh 1879, and
/// 8 σ / ρR³ of a ball). Viscosity damps it by β = 2 n (n - 1) ν / R² and slows it to √(ω² - β²) (Lamb 1932, art. 355).
pub struct CapillaryDrop;

const RADIUS_M: f64 = 0.01;
const SPACING_M: f64 = RADIUS_M / 12.0;
const TENSION_N_M: f64 = 0.073;
const DENSITY_KG_M3: f64 = 1000.0;
/// Of the axes at the start: the period of a finite amplitude is longer by some of its square.
const STRETCH: f64 = 0.08;
/// From the middle to an edge of the domain, radii.
const HALF: f64 = 1.6;
/// Of the default spacing; it shrinks with the spacing.
const DT_S: f64 = 1.0e-3;
const PERIODS: f64 = 2.0;

impl CapillaryDrop {
    /// Of the closed form without viscosity, rad/s.
    fn frequency_per_s(setup: &Setup) -> f64 {
        let factor = if setup.scene.domain.dimensions == 2 { 6.0 } else { 8.0 };
        (factor * TENSION_N_M / (DENSITY_KG_M3 * RADIUS_M.powi(3))).sqrt()
    }

    /// What viscosity damps the amplitude by, 1/s.
    fn damping_per_s(setup: &Setup) -> f64 {
        let factor = if setup.scene.domain.dimensions == 2 { 4.0 } else { 5.0 };
        factor * setup.scene.sph_viscosity_m2_s() / RADIUS_M.powi(2)
    }

    /// Of the closed form with the scene's viscosity, s.
    fn period_s(setup: &Setup) -> f64 {
        2.0 * PI / (Self::frequency_per_s(setup).powi(2) - Self::damping_per_s(setup).powi(2)).sqrt()
    }
}

impl Case for CapillaryDrop {
    fn name(&self) -> &'static str {
        "capillary-drop"
    }

    fn summary(&self) -> &'static str {
        "a drop swings about its circle by its surface tension, in 2-D, without walls and gravity (Rayleigh 1879)"
    }

    fn reference(&self) -> Reference {
        Reference::Analytic
    }

    fn spacing_m(&self) -> f64 {
        SPACING_M
    }

    fn setup(&self, settings: &[String]) -> SetupResult {
        let spacing_m = setting(settings, "spacing_m", SPACING_M);
        let half_m = HALF * RADIUS_M;
        let flat = setting(settings, "domain.dimensions", 2.0) == 2.0;
        // A disc is a slice through the ball's middle.
        let [low_m, high_m, middle_m] = if flat { [0.0, spacing_m, 0.5 * spacing_m] } else { [-half_m, half_m, 0.0] };
        let text = format!(
            "spacing_m = {spacing_m}
            gravity_m_s2 = [0, 0, 0]
            [domain]
            min_m = [-{half_m}, -{half_m}, {low_m}]
            max_m = [{half_m}, {half_m}, {high_m}]
            walls = false
            dimensions = 2
            [[fluid]]
            sphere = {{ centre_m = [0, 0, {middle_m}], radius_m = {RADIUS_M} }}
            rest_density_kg_m3 = {DENSITY_KG_M3}
            [solver]
            method = \"sph\"
            support_ratio = {FLAT_SUPPORT_RATIO}
            dt_s = {}
            [solver.sph]
            surface_tension_n_m = {TENSION_N_M}
            artificial_viscosity = 0",
            DT_S * spacing_m / SPACING_M
        );
        let mut setup = Setup::new(self.name(), &text, settings, 1.0, 1)?;
        let end_s = PERIODS * Self::period_s(&setup);
        setup.sample_times_s = (1..=100).map(|k| end_s * f64::from(k) / 100.0).collect();
        setup.place(|at, _| {
            at.x = half_m + (at.x - half_m) * (1.0 + STRETCH);
            let narrower = if flat { 1.0 + STRETCH } else { (1.0 + STRETCH).sqrt() };
            at.y = half_m + (at.y - half_m) / narrower;
            at.z = if flat { at.z } else { half_m + (at.z - half_m) / narrower };
        });
        Ok(setup)
    }

    /// What its surface holds it gives back as motion: an energy that is not counted.
    fn energy_rise(&self) -> f64 {
        f64::MAX
    }

    fn figures(&self, setup: &Setup, samples: &[Sample], _: Converge<'_>) -> Option<Vec<Figure>> {
        let stretches: Vec<(f64, f64)> = samples.iter().map(|s| (s.time_s, stretch(s))).collect();
        let crossings = crossings_s(&stretches);
        let halves = crossings.len().saturating_sub(1);
        let period_s = match (crossings.first(), crossings.last()) {
            (Some(first), Some(last)) if halves > 0 => 2.0 * (last - first) / halves as f64,
            _ => f64::NAN,
        };
        let damping_per_s = decay_per_s(&stretches, &crossings);
        let tension = (2.0 * PI / period_s).powi(2) + damping_per_s.powi(2);
        let drift = samples.last()?.drift_m_s() / (RADIUS_M * Self::frequency_per_s(setup));
        Some(vec![
            Figure::judged(
                "period error",
                period_s / Self::period_s(setup) - 1.0,
                "",
                0.05,
                "of the damped closed form; two spacings of amplitude do not give more than some %",
            ),
            Figure::told(
                "damping over set viscosity's",
                damping_per_s / Self::damping_per_s(setup),
                "",
                "of the amplitude, from peak to peak",
            ),
            Figure::told(
                "effective tension over set",
                tension / Self::frequency_per_s(setup).powi(2),
                "",
                "that swings as fast with the damping that there is",
            ),
            Figure::judged("momentum drift", drift, "", 1.0e-4, "over R omega; no force acts from outside"),
        ])
    }

    fn series(&self, setup: &Setup, samples: &[Sample]) -> Vec<Series> {
        let (period_s, damping_per_s) = (Self::period_s(setup), Self::damping_per_s(setup));
        let exact = |t: f64| STRETCH * (-damping_per_s * t).exp() * (2.0 * PI * t / period_s).cos();
        let end_s = samples.last().map_or(0.0, |sample| sample.time_s);
        let times = (0..=200).map(|k| end_s * f64::from(k) / 200.0);
        vec![Series {
            name: "stretch".into(),
            x: "t, s".into(),
            y: "stretch of the axes".into(),
            computed: samples.iter().map(|s| (s.time_s, stretch(s))).collect(),
            reference: times.map(|t| (t, exact(t))).collect(),
            measured: false,
        }]
    }
}

/// ln of the axes' ratio over 2, from the second moments: 0 of a circle.
fn stretch(sample: &Sample) -> f64 {
    let middle_m = sample.middle_m();
    let moment = |axis: fn(DVec3) -> f64| sample.mean(|at, _| axis(at - middle_m).powi(2));
    0.25 * (moment(|r| r.x) / moment(|r| r.y)).ln()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A drop that swings with a period and a damping.
    fn swinging(setup: &Setup, period_s: f64, damping_per_s: f64) -> Vec<Sample> {
        let half_m = DVec3::new(HALF * RADIUS_M, HALF * RADIUS_M, 0.0);
        let start = setup.start().positions_m;
        let sample = |&time_s: &f64| {
            let a = STRETCH * (-damping_per_s * time_s).exp() * (2.0 * PI * time_s / period_s).cos();
            let scale = DVec3::new((a - STRETCH.ln_1p()).exp(), (STRETCH.ln_1p() - a).exp(), 1.0);
            let positions_m: Vec<DVec3> = start.iter().map(|at| half_m + (*at - half_m) * scale).collect();
            Sample { time_s, velocities_m_s: vec![DVec3::ZERO; start.len()], positions_m, ..Sample::default() }
        };
        setup.sample_times_s.iter().map(sample).collect()
    }

    #[test]
    fn a_drops_period_and_damping_are_found() {
        let setup = CapillaryDrop.setup(&[]).unwrap();
        let (period_s, damping_per_s) = (CapillaryDrop::period_s(&setup), CapillaryDrop::damping_per_s(&setup));
        for (factor, damping) in [(1.0, 1.0), (1.1, 1.0), (0.8, 1.3)] {
            let samples = swinging(&setup, factor * period_s, damping * damping_per_s);
            let figures = CapillaryDrop.figures(&setup, &samples, &|_| None).unwrap();
            assert!((figures[0].value.unwrap() - (factor - 1.0)).abs() < 0.005, "{factor}: {figures:?}");
            assert!((figures[1].value.unwrap() / damping - 1.0).abs() < 0.1, "{damping}: {figures:?}");
        }
        let still = swinging(&setup, 1e9, 0.0);
        assert_eq!(CapillaryDrop.figures(&setup, &still, &|_| None).unwrap()[0].value, None);
    }

    #[test]
    fn a_ball_of_water_would_swing_as_rayleigh_has_it() {
        let ball = CapillaryDrop.setup(&["domain.dimensions=3".into(), "spacing_m=0.0025".into()]).unwrap();
        let radius_m = (ball.count() as f64 * 3.0 / (4.0 * PI)).cbrt() * 0.0025;
        assert!((radius_m / RADIUS_M - 1.0).abs() < 0.05, "a ball: {radius_m}");
        // 8 sigma / rho R^3 of a centimetre of water.
        assert!((CapillaryDrop::frequency_per_s(&ball) - 584_000e-3_f64.sqrt()).abs() < 1e-9);
    }
}
