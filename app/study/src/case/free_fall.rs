//! Two particles that fall: the integrator's own closed form.

use glam::DVec3;

use super::{Case, Converge, Reference};
use crate::{Figure, Sample, Setup, SetupResult};

/// Symplectic Euler gives x = x0 + n v0 dt + g dt² n (n + 1) / 2 after n substeps, exactly.
pub struct FreeFall;

const START_M_S: [f64; 3] = [0.5, 1.0, -0.25];

impl Case for FreeFall {
    fn name(&self) -> &'static str {
        "free-fall"
    }

    fn summary(&self) -> &'static str {
        "two particles fall; the integrator's own closed form"
    }

    fn reference(&self) -> Reference {
        Reference::Analytic
    }

    fn spacing_m(&self) -> f64 {
        0.05
    }

    fn setup(&self, settings: &[String]) -> SetupResult {
        let text = "
            spacing_m = 0.05
            [domain]
            min_m = [0, -1, 0]
            max_m = [2, 3, 2]
            [[fluid]]
            block = { min_m = [0.2, 1.5, 1.0], max_m = [0.3, 1.55, 1.05] }
            velocity_m_s = [0.5, 1.0, -0.25]";
        Setup::new(self.name(), text, settings, 0.5, 4)
    }

    fn figures(&self, setup: &Setup, samples: &[Sample], _: Converge<'_>) -> Option<Vec<Figure>> {
        let dt_s = setup.scene.substep_s();
        let (gravity, start) = (DVec3::from_array(setup.scene.gravity_m_s2), DVec3::from_array(START_M_S));
        let (mut off_m, mut most) = (0.0_f64, 0.0_f64);
        for sample in samples {
            let n = (sample.time_s / dt_s).round();
            for (at, from) in sample.positions_m.iter().zip(&setup.particles.positions) {
                let expected =
                    crate::setup::position_m(from) + n * dt_s * start + 0.5 * n * (n + 1.0) * dt_s * dt_s * gravity;
                off_m = off_m.max((*at - expected).abs().max_element());
            }
            most = most.max(n);
        }
        // Each substep rounds a position below 4 m, and what is added to it.
        let limit_m = 2.0 * most * 4.0 * 2.0_f64.powi(-24);
        let why = "each substep rounds a coordinate below 4 m twice, in f32";
        let kinetic = samples.last()?.kinetic_m2_s2();
        Some(vec![
            Figure::judged("position error", off_m, "m", limit_m, why),
            Figure::told("kinetic energy", kinetic, "m²/s²", "over mass, at the end"),
        ])
    }
}
