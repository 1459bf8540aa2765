//! A square of fluid that turns, without walls and gravity.

use brooklet_reference::norms::cloud_distance;
use glam::DVec3;

use super::{Case, Converge, FLAT_SUPPORT_RATIO, Reference, setting, with_speed};
use crate::{Figure, Sample, Setup, SetupResult};

/// v = ω (y, −x) on a square (Colagrossi 2005): angular momentum stays, and so does the fourfold
/// symmetry. The closed form has negative pressure in the middle, which a solver that only pushes cannot
/// give: a cavity opens instead, and its size is told.
pub struct SquarePatch;

const SIDE_M: f64 = 1.0;
const SPACING_M: f64 = 1.0 / 32.0;
const OMEGA_PER_S: f64 = 1.0;
const END_S: f64 = 1.0;
const COURANT: f64 = 0.1;
const HALF_M: f64 = 2.0;

impl Case for SquarePatch {
    fn name(&self) -> &'static str {
        "square-patch"
    }

    fn summary(&self) -> &'static str {
        "a turning square of fluid, in 2-D, without walls and gravity (Colagrossi 2005)"
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
            block = {{ min_m = [-{0}, -{0}, 0], max_m = [{0}, {0}, {spacing_m}] }}
            [solver]
            support_ratio = {FLAT_SUPPORT_RATIO}
            dt_s = {1}
            [forces]
            xsph = 0",
            0.5 * SIDE_M,
            COURANT * spacing_m
        );
        // Of its corners.
        let settings = with_speed(OMEGA_PER_S * SIDE_M / 2.0_f64.sqrt(), settings);
        let mut setup = Setup::new(self.name(), &text, &settings, END_S, 10)?;
        setup.place(|at, velocity| *velocity = OMEGA_PER_S * DVec3::new(at.y - HALF_M, HALF_M - at.x, 0.0));
        Ok(setup.relaxed())
    }

    fn figures(&self, setup: &Setup, samples: &[Sample], _: Converge<'_>) -> Option<Vec<Figure>> {
        let start = setup.start().mean(|at, _| OMEGA_PER_S * ((at.x - HALF_M).powi(2) + (at.y - HALF_M).powi(2)));
        let drift = samples.iter().map(|s| (angular_m2_s(s) / start - 1.0).abs()).fold(0.0, f64::max);
        let last = samples.last()?;
        let middle_m = DVec3::new(HALF_M, HALF_M, 0.5 * setup.scene.spacing_m);
        let turned: Vec<DVec3> = last.positions_m.iter().map(|at| middle_m + (*at - middle_m).rotated()).collect();
        let apart = cloud_distance(&last.positions_m, &turned, setup.scene.spacing_m);
        let cavity = last.positions_m.iter().map(|at| (*at - middle_m).length()).fold(f64::INFINITY, f64::min);
        Some(vec![
            Figure::judged(
                "angular momentum",
                drift,
                "",
                0.02,
                "largest drift over 10 times; no force acts from outside",
            ),
            Figure::judged(
                "asymmetry",
                apart.map_or(f64::NAN, |distance| distance.chamfer),
                "d",
                0.5,
                "mean distance to the patch turned by 90°, at the end: below half a spacing only the lattice differs",
            ),
            Figure::told(
                "cavity",
                cavity / setup.scene.spacing_m,
                "d",
                "from the middle to the nearest particle; .7 at the start",
            ),
        ])
    }
}

trait Rotated {
    fn rotated(self) -> Self;
}

impl Rotated for DVec3 {
    /// By 90° about z.
    fn rotated(self) -> Self {
        Self::new(-self.y, self.x, self.z)
    }
}

/// About the patch's middle, over mass, clockwise.
fn angular_m2_s(sample: &Sample) -> f64 {
    sample.mean(|at, v| (at.y - HALF_M) * v.x - (at.x - HALF_M) * v.y)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_turns_is_right_and_what_slows_or_leans_is_not() {
        let setup = SquarePatch.setup(&[]).unwrap();
        let positions_m: Vec<DVec3> = setup.particles.positions.iter().map(crate::setup::position_m).collect();
        let velocities_m_s: Vec<DVec3> = setup.particles.velocities.iter().map(crate::setup::velocity_m_s).collect();
        let right = Sample { time_s: 1.0, positions_m, velocities_m_s, ..Sample::default() };
        let of = |sample: &Sample| -> Vec<f64> {
            let figures = SquarePatch.figures(&setup, std::slice::from_ref(sample), &|_| None).unwrap();
            figures.iter().map(|figure| figure.value.unwrap()).collect()
        };
        let figures = of(&right);
        assert!(figures[0] < 1e-6 && figures[1] < 1e-6 && (figures[2] - 0.5_f64.sqrt()).abs() < 1e-3, "{figures:?}");
        let mut slower = right.clone();
        slower.velocities_m_s.iter_mut().for_each(|v| *v *= 0.9);
        assert!((of(&slower)[0] - 0.1).abs() < 1e-6);
        let mut leaning = right;
        leaning.positions_m.iter_mut().for_each(|at| at.x = HALF_M + 2.0 * (at.x - HALF_M));
        assert!(of(&leaning)[1] > 0.5);
    }
}
