//! Vortices in a periodic square.

use std::f64::consts::PI;

use glam::DVec3;

use super::hydrostatic::periodic_side_m;
use super::{Case, Converge, FLAT_SUPPORT_RATIO, Reference, setting, with_speed};
use crate::{Figure, Sample, Setup, SetupResult};

/// u = −cos(2πx/L) sin(2πy/L), v = sin(2πx/L) cos(2πy/L) (Taylor & Green 1937). Without viscosity it
/// stays as it is; with it it decays by exp(−8π² t/Re). PBF and DFSPH have no term of a known viscosity, so they are
/// held against what is inviscid, and the Reynolds number that their own damping amounts to is told.
pub struct TaylorGreen {
    name: &'static str,
    summary: &'static str,
    /// Of each coordinate, over the spacing, either way.
    jitter: f64,
    /// U L/ν of a method that has a viscosity; infinite without.
    reynolds: f64,
    end_s: f64,
}

/// From a square lattice, whose rows have to slip past each other.
pub const TAYLOR_GREEN: TaylorGreen = TaylorGreen {
    name: "taylor-green",
    summary: "vortices in a periodic square from a square lattice, in 2-D, without viscosity (Taylor & Green 1937)",
    jitter: 0.0,
    reynolds: f64::INFINITY,
    end_s: HALF_TURN_S,
};

/// From a lattice jittered and relaxed: no order is in its way.
pub const TAYLOR_GREEN_JITTERED: TaylorGreen = TaylorGreen {
    name: "taylor-green-jittered",
    summary: "the same from a lattice that was jittered and relaxed",
    jitter: 0.3,
    reynolds: f64::INFINITY,
    end_s: HALF_TURN_S,
};

/// With the viscosity of a Reynolds number of 100, until speeds have fallen to .454.
pub const TAYLOR_GREEN_VISCOUS: TaylorGreen = TaylorGreen {
    name: "taylor-green-viscous",
    summary: "the same, jittered, of a viscous fluid at Re = 100, whose speeds decay by exp(-8 pi² t/Re)",
    jitter: 0.3,
    reynolds: 100.0,
    end_s: 1.0,
};

const SEED: u64 = 1937;

/// Three times 4 h on a side.
const SPACING_M: f64 = 1.0 / 36.0;
const SPEED_M_S: f64 = 1.0;
/// Half a turn of the inner vortex.
const HALF_TURN_S: f64 = 0.5;
const COURANT: f64 = 0.1;

impl TaylorGreen {
    /// What viscosity has left of a speed of the closed form.
    fn kept(&self, time_s: f64, side_m: f64) -> f64 {
        (-8.0 * PI * PI * time_s * SPEED_M_S / side_m / self.reynolds).exp()
    }

    /// Judged where the fluid has a viscosity: the Reynolds number that its damping amounts to over its own.
    fn damping(&self, reynolds: f64) -> Figure {
        if self.reynolds.is_infinite() {
            return Figure::told("Reynolds number", reynolds, "", "that would damp as much");
        }
        let why = "that would damp as much, over Re; twice what a channel's viscosity may be off";
        Figure::judged("Reynolds number's error", reynolds / self.reynolds - 1.0, "", 0.1, why)
    }
}

impl Case for TaylorGreen {
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
        let side_m = periodic_side_m(spacing_m, setting(settings, "solver.support_ratio", FLAT_SUPPORT_RATIO), 1.0);
        let damping = if self.reynolds.is_finite() {
            format!(
                "method = \"sph\"
                [solver.sph]
                viscosity_m2_s = {}
                artificial_viscosity = 0
                stiffness_m2_s2 = 100
                clamp_pressure = false",
                SPEED_M_S * side_m / self.reynolds
            )
        } else {
            "[forces]\nxsph = 0".into()
        };
        let text = format!(
            "spacing_m = {spacing_m}
            gravity_m_s2 = [0, 0, 0]
            [domain]
            min_m = [0, 0, 0]
            max_m = [{side_m}, {side_m}, {spacing_m}]
            walls = false
            dimensions = 2
            periodic = [true, true, false]
            [[fluid]]
            block = {{ min_m = [0, 0, 0], max_m = [{side_m}, {side_m}, {spacing_m}] }}
            [solver]
            support_ratio = {FLAT_SUPPORT_RATIO}
            dt_s = {}
            {damping}",
            COURANT * spacing_m
        );
        let settings = with_speed(SPEED_M_S, settings);
        let mut setup = Setup::new(self.name(), &text, &settings, self.end_s, 10)?;
        let mut random = fastrand::Rng::with_seed(SEED);
        setup.place(|at, velocity| {
            // Inside of the square: half a spacing is to its edge.
            let mut moved = || self.jitter * spacing_m * (2.0 * random.f64() - 1.0);
            *at += DVec3::new(moved(), moved(), 0.0);
            *velocity = exact_m_s(*at, side_m);
        });
        Ok(setup.relaxed())
    }

    fn figures(&self, setup: &Setup, samples: &[Sample], _: Converge<'_>) -> Option<Vec<Figure>> {
        let side_m = setup.scene.domain.size_m()[0];
        let last = samples.last()?;
        let left = self.kept(last.time_s, side_m);
        let off = |at: DVec3, v: DVec3| (v - left * exact_m_s(at, side_m)).length() / SPEED_M_S;
        let mean = last.mean(off);
        let largest = last.positions_m.iter().zip(&last.velocities_m_s).map(|(&at, &v)| off(at, v)).fold(0.0, f64::max);
        // Kinetic energy over mass is 1/4 U², and decays twice as fast as a speed.
        let kept = last.kinetic_m2_s2() / (0.25 * SPEED_M_S * SPEED_M_S);
        let reynolds = -16.0 * PI * PI * last.time_s * SPEED_M_S / side_m / kept.ln();
        let momentum = last.drift_m_s();
        Some(vec![
            Figure::judged("velocity error", mean, "", 0.1, "mean, over U, at the end; an even tenth"),
            Figure::told("largest velocity error", largest, "", "over U"),
            Figure::told("energy kept", kept, "", "of the start's"),
            self.damping(reynolds),
            Figure::judged("momentum drift", momentum / SPEED_M_S, "", 1.0e-3, "over U; no force acts from outside"),
        ])
    }
}

fn exact_m_s(at: DVec3, side_m: f64) -> DVec3 {
    let (x, y) = (2.0 * PI * at.x / side_m, 2.0 * PI * at.y / side_m);
    SPEED_M_S * DVec3::new(-x.cos() * y.sin(), x.sin() * y.cos(), 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_start_is_right_and_half_as_fast_is_not() {
        let setup = TAYLOR_GREEN.setup(&[]).unwrap();
        let positions_m: Vec<DVec3> = setup.particles.positions.iter().map(crate::setup::position_m).collect();
        let of = |factor: f64| {
            let velocities_m_s =
                setup.particles.velocities.iter().map(|v| factor * crate::setup::velocity_m_s(v)).collect();
            let sample =
                Sample { time_s: HALF_TURN_S, positions_m: positions_m.clone(), velocities_m_s, ..Sample::default() };
            let figures = TAYLOR_GREEN.figures(&setup, &[sample], &|_| None).unwrap();
            (figures[0].value.unwrap(), figures[2].value.unwrap())
        };
        assert!(of(1.0).0 < 1e-6 && (of(1.0).1 - 1.0).abs() < 1e-6, "{:?}", of(1.0));
        assert!(of(0.5).0 > 0.2 && (of(0.5).1 - 0.25).abs() < 1e-6);
    }
}
