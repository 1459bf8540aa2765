//! The slowest wave of a tank.

use std::f64::consts::PI;

use super::{Case, Converge, FLAT_SUPPORT_RATIO, Reference, setting};
use crate::{Figure, Sample, Series, Setup, SetupResult};

/// η = a cos(kx) cos(ωt) between walls, k = π/L, ω² = g k tanh(k depth) (Airy), in 2-D: L = 1 m,
/// depth = .5 m, so T = 1.1818 s. Viscosity damps it by 2 ν k² (Lamb 1932, art. 348), walls that it slips along by nothing.
pub struct StandingWave {
    name: &'static str,
    summary: &'static str,
    /// Of a method that has one, m²/s; 0 leaves the scene without.
    viscosity_m2_s: f64,
}

/// Without viscosity.
pub const STANDING_WAVE: StandingWave = StandingWave {
    name: "standing-wave",
    summary: "the slowest standing wave of a tank, in 2-D (Airy's linear theory)",
    viscosity_m2_s: 0.0,
};

/// With a viscosity that leaves half of it after two and a half periods.
pub const VISCOUS_WAVE: StandingWave = StandingWave {
    name: "standing-wave-viscous",
    summary: "the same of a viscous fluid, whose amplitude decays (Lamb 1932)",
    viscosity_m2_s: 0.01,
};

const LENGTH_M: f64 = 1.0;
const DEPTH_M: f64 = 0.5;
/// Small against the depth, large against a spacing.
const AMPLITUDE_M: f64 = 0.05;
const SPACING_M: f64 = 1.0 / 40.0;
/// Of the default spacing; it shrinks with the spacing.
const DT_S: f64 = 1.0 / 240.0;
const PERIODS: f64 = 2.5;

impl StandingWave {
    fn wave_number_per_m() -> f64 {
        PI / LENGTH_M
    }

    /// Of the closed form, s.
    pub fn period_s() -> f64 {
        let k = Self::wave_number_per_m();
        2.0 * PI / (9.81 * k * (k * DEPTH_M).tanh()).sqrt()
    }

    /// Of the amplitude, by the viscosity.
    fn exact_decay_per_s(&self) -> f64 {
        2.0 * self.viscosity_m2_s * Self::wave_number_per_m().powi(2)
    }

    /// The amplitude of the closed form, m.
    fn exact_m(&self, time_s: f64) -> f64 {
        let phase = 2.0 * PI * time_s / Self::period_s();
        AMPLITUDE_M * (-self.exact_decay_per_s() * time_s).exp() * phase.cos()
    }

    /// Of a series against the closed form, over the amplitude.
    fn amplitude_error(&self, series: &[(f64, f64)]) -> f64 {
        let squares: f64 = series.iter().map(|&(t, a)| (a - self.exact_m(t)).powi(2)).sum();
        (squares / series.len() as f64).sqrt() / AMPLITUDE_M
    }

    fn decay(&self, measured_per_s: f64) -> Figure {
        if self.viscosity_m2_s == 0.0 {
            return Figure::told("decay", measured_per_s, "1/s", "of the amplitude, from peak to peak");
        }
        let off = measured_per_s / self.exact_decay_per_s() - 1.0;
        Figure::judged("decay error", off, "", 0.1, "of 2 nu k²; twice what a channel may be off, which has no surface")
    }
}

impl Case for StandingWave {
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
        let dt_s = DT_S * spacing_m / SPACING_M;
        let damping = match self.viscosity_m2_s {
            0.0 => "[forces]\nxsph = 0".into(),
            viscosity => format!(
                "method = \"sph\"
                [solver.sph]
                viscosity_m2_s = {viscosity}
                artificial_viscosity = 0"
            ),
        };
        let text = format!(
            "spacing_m = {spacing_m}
            [domain]
            min_m = [0, 0, 0]
            max_m = [{LENGTH_M}, {}, {spacing_m}]
            dimensions = 2
            [[fluid]]
            block = {{ min_m = [0, 0, 0], max_m = [{LENGTH_M}, {DEPTH_M}, {spacing_m}] }}
            [solver]
            support_ratio = {FLAT_SUPPORT_RATIO}
            dt_s = {dt_s}
            {damping}",
            2.0 * DEPTH_M
        );
        let mut setup = Setup::new(self.name(), &text, settings, PERIODS * Self::period_s(), 100)?;
        // The displacement of linear theory; it has no divergence, so the density stays.
        let k = Self::wave_number_per_m();
        setup.place(|at, _| {
            let scale = AMPLITUDE_M / (k * DEPTH_M).sinh();
            let (x, y) = (at.x, at.y);
            at.x -= scale * (k * x).sin() * (k * y).cosh();
            at.y += scale * (k * x).cos() * (k * y).sinh();
        });
        Ok(setup.relaxed())
    }

    fn figures(&self, setup: &Setup, samples: &[Sample], _: Converge<'_>) -> Option<Vec<Figure>> {
        let amplitudes: Vec<(f64, f64)> = samples.iter().map(|s| (s.time_s, amplitude_m(s))).collect();
        let crossings = crossings_s(&amplitudes);
        let halves = crossings.len().saturating_sub(1);
        let period_s = match (crossings.first(), crossings.last()) {
            (Some(first), Some(last)) if halves > 0 => 2.0 * (last - first) / halves as f64,
            _ => f64::NAN,
        };
        let decay_per_s = decay_per_s(&amplitudes, &crossings);
        let k = Self::wave_number_per_m();
        let level_m = samples.iter().map(|s| 2.0 * s.middle_m().y).sum::<f64>() / samples.len() as f64;
        let start_m = 2.0 * setup.particles.positions.iter().map(|p| f64::from(p.position_m[1])).sum::<f64>()
            / setup.count().max(1) as f64;
        Some(vec![
            Figure::told(
                "amplitude error",
                self.amplitude_error(&amplitudes),
                "",
                "root mean square over the amplitude: period and damping together",
            ),
            Figure::judged(
                "period error",
                period_s / Self::period_s() - 1.0,
                "",
                0.03,
                "of T = 1.1818 s; the finite amplitude makes .1 %",
            ),
            self.decay(decay_per_s),
            Figure::told(
                "viscosity",
                decay_per_s / (2.0 * k * k),
                "m²/s",
                "that would damp as much: decay is 2 nu k² in the bulk",
            ),
            Figure::judged("level loss", 1.0 - level_m / start_m, "", 0.03, "mean height against the start's: volume"),
        ])
    }

    fn series(&self, _: &Setup, samples: &[Sample]) -> Vec<Series> {
        let wave = |time_s: f64| (time_s, 100.0 * self.exact_m(time_s));
        vec![Series {
            name: "amplitude".into(),
            x: "t, s".into(),
            y: "amplitude, cm".into(),
            computed: samples.iter().map(|s| (s.time_s, 100.0 * amplitude_m(s))).collect(),
            reference: (0..=200).map(|k| wave(PERIODS * Self::period_s() * f64::from(k) / 200.0)).collect(),
            measured: false,
        }]
    }
}

/// Of the mode: ∫ η cos(kx) dx 2/L, which the particles' cosines sum to without a surface being found.
fn amplitude_m(sample: &Sample) -> f64 {
    2.0 * DEPTH_M * sample.mean(|at, _| (StandingWave::wave_number_per_m() * at.x).cos())
}

/// When a series passes zero, linear between its samples.
pub(super) fn crossings_s(series: &[(f64, f64)]) -> Vec<f64> {
    let pairs = series.windows(2).filter(|pair| pair[0].1 * pair[1].1 < 0.0);
    pairs.map(|pair| pair[0].0 + (pair[1].0 - pair[0].0) * pair[0].1 / (pair[0].1 - pair[1].1)).collect()
}

/// From the largest size between each two crossings: the slope of its logarithm. NaN without two.
pub(super) fn decay_per_s(series: &[(f64, f64)], crossings_s: &[f64]) -> f64 {
    let peak = |pair: &[f64]| {
        let inside = series.iter().filter(|(t, _)| (pair[0]..pair[1]).contains(t));
        inside.map(|&(t, a)| (t, a.abs())).max_by(|a, b| a.1.total_cmp(&b.1))
    };
    let peaks: Vec<(f64, f64)> = crossings_s.windows(2).filter_map(peak).collect();
    match (peaks.first(), peaks.last()) {
        (Some(first), Some(last)) if last.0 > first.0 => (first.1 / last.1).ln() / (last.0 - first.0),
        _ => f64::NAN,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Verdict;
    use glam::DVec3;

    /// Particles of a wave with a period and a decay.
    fn wave(setup: &Setup, period_s: f64, decay_per_s: f64) -> Vec<Sample> {
        let k = StandingWave::wave_number_per_m();
        setup
            .sample_times_s
            .iter()
            .map(|&time_s| {
                let a = AMPLITUDE_M * (-decay_per_s * time_s).exp() * (2.0 * PI * time_s / period_s).cos();
                let scale = a / (k * DEPTH_M).sinh();
                let places = (0..800).map(|i| (f64::from(i % 40) + 0.5, f64::from(i / 40) + 0.5));
                let positions_m: Vec<DVec3> = places
                    .map(|(x, y)| (x / 40.0, y / 40.0))
                    .map(|(x, y)| {
                        let dx = -scale * (k * x).sin() * (k * y).cosh();
                        DVec3::new(x + dx, y + scale * (k * x).cos() * (k * y).sinh(), 0.0)
                    })
                    .collect();
                Sample { time_s, velocities_m_s: vec![DVec3::ZERO; 800], positions_m, ..Sample::default() }
            })
            .collect()
    }

    #[test]
    fn the_closed_form_has_its_published_period() {
        assert!((StandingWave::period_s() - 1.1818).abs() < 5e-5);
    }

    #[test]
    fn a_waves_period_and_decay_are_found() {
        let setup = STANDING_WAVE.setup(&[]).unwrap();
        let right = StandingWave::period_s();
        for (factor, decay) in [(1.0, 0.0), (1.1, 0.3), (0.8, 0.1)] {
            let figures = STANDING_WAVE.figures(&setup, &wave(&setup, factor * right, decay), &|_| None).unwrap();
            let error = figures[1].value.unwrap();
            assert!((error - (factor - 1.0)).abs() < 0.003, "{factor}: {error}");
            assert!((figures[2].value.unwrap() - decay).abs() < 0.02, "{figures:?}");
            let amplitude = figures[0].value.unwrap();
            assert!(if factor == 1.0 { amplitude < 0.01 } else { amplitude > 0.2 }, "{amplitude}");
        }
        let exact_per_s = VISCOUS_WAVE.exact_decay_per_s();
        for factor in [1.0, 1.3] {
            let samples = wave(&setup, right, factor * exact_per_s);
            let figures = VISCOUS_WAVE.figures(&setup, &samples, &|_| None).unwrap();
            assert_eq!(figures[2].verdict() == Verdict::Meets, factor == 1.0, "{figures:?}");
            assert_eq!(figures[0].value.unwrap() < 0.01, factor == 1.0, "{figures:?}");
        }
        let still = wave(&setup, 1e9, 0.0);
        assert_eq!(STANDING_WAVE.figures(&setup, &still, &|_| None).unwrap()[1].value, None);
    }
}
