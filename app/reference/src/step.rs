//! A whole substep of whichever solver there is.

use crate::boundary::drag_walls::{WallFaces, drag_walls};
use crate::boundary::repel_walls::{RepelWalls, repel_walls};
use crate::boundary::walls::DomainWalls;
use crate::params::Step;
use crate::particles::predict::Particle;
use crate::solver::Solver;

/// A fluid and everything that moves it.
pub struct Fluid {
    /// The particles; they keep their order.
    pub particles: Vec<Particle>,
    /// The substep.
    pub step: Step,
    /// What walls add to the density; `None` without walls.
    pub walls: Option<DomainWalls>,
    /// How walls keep the fluid, if more than pressure does.
    pub repel_walls: Option<RepelWalls>,
    /// How walls drag along them; `None` where none does.
    pub faces: Option<WallFaces>,
    /// What moves the particles.
    pub solver: Solver,
}

impl Fluid {
    /// Advances by one substep.
    pub fn substep(&mut self) {
        let dt_s = self.solver.substep(&mut self.particles, &self.step, self.walls.as_ref());
        if let Some(walls) = self.repel_walls.filter(|_| dt_s > 0.0) {
            for particle in self.particles.iter_mut().filter(|particle| particle.is_simulated()) {
                let velocity_m_s = &mut particle.velocity_m_s;
                *velocity_m_s = repel_walls(particle.position_m, *velocity_m_s, dt_s, &self.step, &walls);
            }
        }
        let (Some(walls), Some(faces)) = (&self.walls, &self.faces) else { return };
        for particle in self.particles.iter_mut().filter(|particle| particle.is_simulated()) {
            let least_m = self.step.wall_offset_m;
            particle.velocity_m_s = drag_walls(particle.position_m, particle.velocity_m_s, dt_s, least_m, walls, faces);
        }
    }

    /// Takes out compression while time stands.
    pub fn relax(&mut self) {
        self.solver.relax(&mut self.particles, &self.step, self.walls.as_ref());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::boundary::walls::WallScales;
    use crate::params::{self, Forces, Smoothing};
    use crate::shared::lattice;
    use crate::solver::pbf::substep::{Iterations, Pbf};
    use glam::{BVec3, DVec3};

    const SPACING: f64 = 0.02;

    fn fluid(positions_m: &[DVec3], gravity: f64, vorticity_m_s: f64) -> Fluid {
        Fluid {
            particles: positions_m.iter().map(|&position_m| Particle { position_m, ..Particle::default() }).collect(),
            step: Step {
                gravity_m_s2: DVec3::new(0.0, -gravity, 0.0),
                dt_s: 1.0 / 240.0,
                domain_size_m: DVec3::splat(0.4),
                walls: BVec3::FALSE,
                period_m: DVec3::ZERO,
                wall_offset_m: SPACING / 4.0,
                max_speed_m_s: 10.0,
            },
            solver: Solver::Pbf(Pbf {
                smoothing: Smoothing::new(2.0 * SPACING, lattice::weight(3, 2.0)),
                params: params::Pbf {
                    relaxation: 0.5,
                    cfm: 1e-4,
                    s_corr_k: 0.0,
                    s_corr_inverse_w: 0.0,
                    max_correction_m: SPACING,
                    separation: 0.0,
                    separation_lambda: 0.0,
                    warm_start: 0.0,
                },
                iterations: Iterations::Plain(4),
                coarse_grid: None,
                forces: Forces { xsph: 0.05, vorticity_m_s },
                grid_ends_at_domain: false,
                walls_push: true,
            }),
            walls: None,
            repel_walls: None,
            faces: None,
        }
    }

    #[test]
    fn free_space_keeps_momentum() {
        let points: Vec<DVec3> =
            lattice::points([6, 5, 4], 0.8 * SPACING).iter().map(|p| *p + DVec3::splat(0.1)).collect();
        let mut fluid = fluid(&points, 0.0, 0.0);
        for _ in 0..10 {
            fluid.substep();
        }
        let momentum: DVec3 = fluid.particles.iter().map(|p| p.velocity_m_s).sum();
        let speed = fluid.particles.iter().map(|p| p.velocity_m_s.length()).sum::<f64>();
        assert!(speed > 1.0, "a compressed block expands: {speed}");
        assert!(momentum.length() < 1e-11 * speed, "{momentum}");
    }

    #[test]
    fn a_full_box_stays_at_rest() {
        // The lattice has density ratio 1 at walls, edges and corners, so nothing pushes it.
        let points = lattice::points([5, 4, 3], SPACING);
        let mut fluid = fluid(&points, 0.0, 1e-3);
        fluid.step.walls = BVec3::TRUE;
        fluid.step.domain_size_m = DVec3::new(5.0, 4.0, 3.0) * SPACING;
        fluid.walls = Some(DomainWalls {
            dimensions: 3,
            axes: BVec3::TRUE,
            scales: WallScales::new(3, 2.0),
            domain_size_m: fluid.step.domain_size_m,
            support_m: 2.0 * SPACING,
        });
        // The second layer still sees a trace of the wall's integral, where the lattice sees none.
        let Solver::Pbf(pbf) = &fluid.solver else { panic!("PBF") };
        let ratios = pbf.density_ratios(&fluid.particles, &fluid.step, fluid.walls.as_ref());
        let largest = ratios.iter().fold(0.0_f64, |m, r| m.max((r - 1.0).abs()));
        println!("largest density error of a full box: {largest:.1e}");
        assert!(largest < 0.02, "{largest}");
        for _ in 0..10 {
            fluid.substep();
        }
        for (particle, start) in fluid.particles.iter().zip(&points) {
            assert!((particle.position_m - *start).length() < 0.02 * SPACING);
        }
    }
}
