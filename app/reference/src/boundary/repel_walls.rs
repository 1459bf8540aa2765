//! Walls that keep the fluid by what they do to velocities across them at a substep's end. (Shader:
//! `boundary/repel_walls.compute`.)

use brooklet_kernels::{RepelParams, WALLS_BY_DEFLECTION};
use glam::DVec3;

use crate::params::Step;

/// By what, and how hard.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RepelModel {
    /// A spring and a damper (Tang, Wu & Zhou, eq. 9).
    Penalty {
        /// k_s over the mass.
        stiffness_per_s2: f64,
        /// k_d over the mass.
        damping_per_s: f64,
    },
    /// The velocity is turned round (Müller, Charypar & Gross 2003).
    Deflection {
        /// What it keeps.
        restitution: f64,
    },
}

/// Walls that repel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RepelWalls {
    /// By what.
    pub model: RepelModel,
    /// Where they begin, m from them.
    pub reach_m: f64,
}

impl RepelWalls {
    /// What shaders are given.
    pub fn of(params: &RepelParams) -> Self {
        let model = match params.model {
            WALLS_BY_DEFLECTION => RepelModel::Deflection { restitution: params.restitution.into() },
            _ => RepelModel::Penalty {
                stiffness_per_s2: params.stiffness_per_s2.into(),
                damping_per_s: params.damping_per_s.into(),
            },
        };
        Self { model, reach_m: params.reach_m.into() }
    }

    /// The speed away from a wall after a substep that ends at a distance from it.
    fn repelled_m_s(&self, distance_m: f64, away_m_s: f64, dt_s: f64) -> f64 {
        let missing_m = self.reach_m - distance_m;
        match self.model {
            RepelModel::Deflection { restitution } if missing_m > away_m_s * dt_s && away_m_s < 0.0 => {
                -restitution * away_m_s
            }
            RepelModel::Penalty { stiffness_per_s2: k, damping_per_s: c } if missing_m > 0.0 => {
                // Backward Euler of u' = k (missing - u dt) - c u.
                let pushed_m_s = (away_m_s + dt_s * k * missing_m) / (1.0 + dt_s * c + dt_s * dt_s * k);
                pushed_m_s.max(away_m_s)
            }
            _ => away_m_s,
        }
    }
}

/// The velocity after a substep of `dt_s` that ended at a position.
pub fn repel_walls(position_m: DVec3, velocity_m_s: DVec3, dt_s: f64, step: &Step, walls: &RepelWalls) -> DVec3 {
    let mut repelled_m_s = velocity_m_s;
    for axis in (0..3).filter(|&axis| step.walls.test(axis)) {
        let from_high_m = step.domain_size_m[axis] - position_m[axis];
        let of_low_m_s = walls.repelled_m_s(position_m[axis], repelled_m_s[axis], dt_s);
        repelled_m_s[axis] = -walls.repelled_m_s(from_high_m, -of_low_m_s, dt_s);
    }
    repelled_m_s.clamp(DVec3::splat(-step.max_speed_m_s), DVec3::splat(step.max_speed_m_s))
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::BVec3;

    const DT_S: f64 = 0.005;

    fn step() -> Step {
        Step {
            gravity_m_s2: DVec3::ZERO,
            dt_s: DT_S,
            domain_size_m: DVec3::splat(1.0),
            walls: BVec3::new(true, true, false),
            period_m: DVec3::ZERO,
            wall_offset_m: 0.001,
            max_speed_m_s: 100.0,
        }
    }

    /// A particle's way along x, walls acting after each step.
    fn way(model: RepelModel, mut x_m: f64, mut u_m_s: f64, steps: u32) -> [f64; 2] {
        let walls = RepelWalls { model, reach_m: 0.01 };
        for _ in 0..steps {
            let v = repel_walls(DVec3::new(x_m, 0.5, 0.0), DVec3::X * u_m_s, DT_S, &step(), &walls);
            assert_eq!([v.y, v.z], [0.0; 2], "no wall is near along y, and none stands across z");
            (x_m, u_m_s) = (x_m + v.x * DT_S, v.x);
        }
        [x_m, u_m_s]
    }

    #[test]
    fn penalty_takes_energy_at_any_stiffness() {
        for stiffness_per_s2 in [1e2, 1e5, 1e12] {
            let damping_per_s = 2.0 * f64::sqrt(stiffness_per_s2);
            let [_, u_m_s] = way(RepelModel::Penalty { stiffness_per_s2, damping_per_s }, 0.009, -1.0, 200);
            assert!((0.0..1.0).contains(&u_m_s), "k {stiffness_per_s2}: {u_m_s}");
        }
        let none = RepelModel::Penalty { stiffness_per_s2: 1e5, damping_per_s: 1e3 };
        assert_eq!(way(none, 0.009, 3.0, 1)[1], 3.0, "a wall holds nobody back");
    }

    #[test]
    fn deflection_turns_round_whoever_comes() {
        let model = RepelModel::Deflection { restitution: 0.5 };
        assert_eq!(way(model, 0.011, -1.0, 1)[1], 0.5);
        assert_eq!(way(model, 0.009, 1.0, 1)[1], 1.0);
        assert_eq!(way(model, 0.5, -1.0, 1)[1], -1.0);
    }
}
