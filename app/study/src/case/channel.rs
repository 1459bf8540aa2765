//! Flow between two plates that fluid sticks to, from rest.

use std::f64::consts::PI;

use glam::DVec3;

use super::{Case, Converge, FLAT_SUPPORT_RATIO, Reference, setting};
use crate::{Figure, Sample, Series, Setup, SetupResult};

/// A channel of height 1 m, periodic along x, in 2-D: full, so without a surface. Of methods with a viscosity.
pub struct Channel {
    name: &'static str,
    summary: &'static str,
    drive: Drive,
}

#[derive(Clone, Copy)]
enum Drive {
    /// The upper plate moves.
    Lid,
    /// A force along the channel.
    Force,
}

/// Couette's flow as it starts.
pub const COUETTE: Channel = Channel {
    name: "couette",
    summary: "the start of flow between a resting and a moving plate, in 2-D (Couette; Morris, Fox & Zhu 1997)",
    drive: Drive::Lid,
};

/// Poiseuille's.
pub const POISEUILLE: Channel = Channel {
    name: "poiseuille",
    summary: "the start of flow along a channel under a force, in 2-D (Poiseuille; Morris, Fox & Zhu 1997)",
    drive: Drive::Force,
};

const SPACING_M: f64 = 1.0 / 20.0;
const HEIGHT_M: f64 = 1.0;
const VISCOSITY_M2_S: f64 = 0.1;
/// Of the lid, and in the middle of the channel in the end: a Reynolds number of 4.
const SPEED_M_S: f64 = 0.4;
/// Of a sound eleven times as fast.
const STIFFNESS_M2_S2: f64 = 20.0;
const DT_S: f64 = 0.0125;
/// ν t/H² of the samples; the profile is steady within 1 % at the last.
const TIMES: [f64; 4] = [0.05, 0.1, 0.2, 0.5];
/// Terms of a series: from the first sample on their sizes fall below 1e-16 before.
const TERMS: i32 = 40;

impl Channel {
    /// The velocity along x of the closed form at a height over H and a time, with a viscosity.
    fn exact_m_s(&self, y: f64, time_s: f64, viscosity_m2_s: f64) -> f64 {
        let tau = viscosity_m2_s * time_s / HEIGHT_M.powi(2);
        let terms = (1..TERMS).map(f64::from);
        let decay = |n: f64| (-(n * PI).powi(2) * tau).exp();
        match self.drive {
            Drive::Lid => {
                let sign = |n: f64| if n % 2.0 == 0.0 { 1.0 } else { -1.0 };
                let sum: f64 = terms.map(|n| sign(n) * (n * PI * y).sin() * decay(n) / n).sum();
                SPEED_M_S * (y + 2.0 / PI * sum)
            }
            Drive::Force => {
                let odd = terms.filter(|n| n % 2.0 == 1.0);
                let sum: f64 = odd.map(|k| (k * PI * y).sin() * decay(k) / k.powi(3)).sum();
                let steady_m_s = force_m_s2() * HEIGHT_M.powi(2) / (8.0 * viscosity_m2_s);
                steady_m_s * (4.0 * y * (1.0 - y) - 32.0 / PI.powi(3) * sum)
            }
        }
    }

    /// Root mean square of what `samples` are off the closed form with a viscosity, over the speed.
    fn off(&self, samples: &[Sample], viscosity_m2_s: f64) -> f64 {
        let squares = |sample: &Sample| {
            sample.mean(|at, v| (v.x - self.exact_m_s(at.y / HEIGHT_M, sample.time_s, viscosity_m2_s)).powi(2))
        };
        (samples.iter().map(squares).sum::<f64>() / samples.len() as f64).sqrt() / SPEED_M_S
    }

    /// The viscosity whose closed form is closest, m²/s: by golden sections, from a third to three times the set one.
    fn fitted_m2_s(&self, samples: &[Sample]) -> f64 {
        let [mut low, mut high] = [VISCOSITY_M2_S / 3.0, VISCOSITY_M2_S * 3.0].map(f64::ln);
        let section = 0.5 * (5f64.sqrt() - 1.0);
        for _ in 0..40 {
            let [a, b] = [high - section * (high - low), low + section * (high - low)];
            if self.off(samples, a.exp()) < self.off(samples, b.exp()) { high = b } else { low = a }
        }
        (0.5 * (low + high)).exp()
    }
}

/// What drives the channel, m/s².
fn force_m_s2() -> f64 {
    8.0 * VISCOSITY_M2_S * SPEED_M_S / HEIGHT_M.powi(2)
}

impl Case for Channel {
    fn name(&self) -> &'static str {
        self.name
    }

    fn summary(&self) -> &'static str {
        self.summary
    }

    fn reference(&self) -> Reference {
        Reference::Analytic
    }

    fn spacing_m(&self) -> f64 {
        SPACING_M
    }

    fn setup(&self, settings: &[String]) -> SetupResult {
        let spacing_m = setting(settings, "spacing_m", SPACING_M);
        let length_m = 4.0 * spacing_m * setting(settings, "solver.support_ratio", FLAT_SUPPORT_RATIO);
        let (lid_m_s, force_m_s2) = match self.drive {
            Drive::Lid => (SPEED_M_S, 0.0),
            Drive::Force => (0.0, force_m_s2()),
        };
        let text = format!(
            "spacing_m = {spacing_m}
            gravity_m_s2 = [{force_m_s2}, 0, 0]
            [domain]
            min_m = [0, 0, 0]
            max_m = [{length_m}, {HEIGHT_M}, {spacing_m}]
            dimensions = 2
            periodic = [true, false, false]
            [domain.faces]
            y_min = {{ slip = \"no-slip\" }}
            y_max = {{ slip = \"no-slip\", velocity_m_s = [{lid_m_s}, 0, 0] }}
            [[fluid]]
            block = {{ min_m = [0, 0, 0], max_m = [{length_m}, {HEIGHT_M}, {spacing_m}] }}
            [solver]
            method = \"sph\"
            support_ratio = {FLAT_SUPPORT_RATIO}
            dt_s = {DT_S}
            [solver.sph]
            viscosity_m2_s = {VISCOSITY_M2_S}
            artificial_viscosity = 0
            stiffness_m2_s2 = {STIFFNESS_M2_S2}"
        );
        let end_s = HEIGHT_M.powi(2) / VISCOSITY_M2_S;
        let mut setup = Setup::new(self.name(), &text, settings, end_s, 1)?;
        setup.sample_times_s = TIMES.map(|tau| tau * end_s).to_vec();
        Ok(setup)
    }

    /// The drive does work without end.
    fn energy_rise(&self) -> f64 {
        f64::MAX
    }

    fn figures(&self, _: &Setup, samples: &[Sample], _: Converge<'_>) -> Option<Vec<Figure>> {
        let last = samples.last()?;
        let across = last.mean(|_, v| v.y.abs()) / SPEED_M_S;
        let fitted = self.fitted_m2_s(samples) / VISCOSITY_M2_S - 1.0;
        Some(vec![
            Figure::judged(
                "velocity error",
                self.off(samples, VISCOSITY_M2_S),
                "",
                0.05,
                "root mean square over U, of four times; an even twentieth",
            ),
            Figure::judged(
                "viscosity error",
                fitted,
                "",
                0.05,
                "of the viscosity that the profiles are fitted best with",
            ),
            Figure::told("velocity across", across, "", "mean, over U, in the end"),
        ])
    }

    fn series(&self, _: &Setup, samples: &[Sample]) -> Vec<Series> {
        let middle = |sample: &Sample| {
            let near = |at: &DVec3| (at.y / HEIGHT_M - 0.5).abs() < 0.1;
            let speeds = sample.positions_m.iter().zip(&sample.velocities_m_s).filter(|(at, _)| near(at));
            let speeds: Vec<f64> = speeds.map(|(_, v)| v.x).collect();
            (sample.time_s, speeds.iter().sum::<f64>() / speeds.len().max(1) as f64)
        };
        let end_s = samples.last().map_or(0.0, |sample| sample.time_s);
        let times = (1..=100).map(|k| end_s * f64::from(k) / 100.0);
        vec![Series {
            name: "middle".into(),
            x: "t, s".into(),
            y: "velocity in the middle, m/s".into(),
            computed: samples.iter().map(middle).collect(),
            reference: times.map(|t| (t, self.exact_m_s(0.5, t, VISCOSITY_M2_S))).collect(),
            measured: false,
        }]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The closed form of a viscosity at the lattice's points.
    fn exact(channel: &Channel, viscosity_m2_s: f64) -> (Setup, Vec<Sample>) {
        let setup = channel.setup(&[]).unwrap();
        let positions_m = setup.start().positions_m;
        let sample = |&time_s: &f64| Sample {
            time_s,
            velocities_m_s: positions_m
                .iter()
                .map(|at| DVec3::X * channel.exact_m_s(at.y / HEIGHT_M, time_s, viscosity_m2_s))
                .collect(),
            positions_m: positions_m.clone(),
            ..Sample::default()
        };
        let samples = setup.sample_times_s.iter().map(sample).collect();
        (setup, samples)
    }

    #[test]
    fn the_closed_forms_have_their_published_values() {
        for (channel, values) in
            [(COUETTE, [0.11384, 0.26276, 0.41157, 0.49542]), (POISEUILLE, [0.37039, 0.61535, 0.85664, 0.99258])]
        {
            for (tau, value) in TIMES.into_iter().zip(values) {
                let got = channel.exact_m_s(0.5, tau / VISCOSITY_M2_S, VISCOSITY_M2_S) / SPEED_M_S;
                assert!((got - value).abs() < 1e-5, "{} at {tau}: {got}", channel.name);
            }
        }
    }

    #[test]
    fn a_viscosity_is_found_and_a_wrong_one_is_an_error() {
        for channel in [COUETTE, POISEUILLE] {
            for factor in [1.0, 1.1, 0.7] {
                let (setup, samples) = exact(&channel, factor * VISCOSITY_M2_S);
                let figures = channel.figures(&setup, &samples, &|_| None).unwrap();
                assert!((figures[1].value.unwrap() - (factor - 1.0)).abs() < 1e-6, "{}: {figures:?}", channel.name);
                assert_eq!(figures[0].value.unwrap() < 1e-9, factor == 1.0, "{figures:?}");
            }
        }
    }
}
