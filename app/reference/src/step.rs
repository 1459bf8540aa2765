//! A whole substep, in the order of the GPU's.

use crate::boundary::walls::DomainWalls;
use crate::grid::list_neighbours::{Neighbours, list_by_cells};
use crate::params::{Pbf, Smoothing, Step};
use crate::particles::predict::{Particle, predict};
use crate::shared::parallel;
use crate::solver::pbf::confine_vorticity::confine_vorticity;
use crate::solver::pbf::constrain_density::constrain_density;
use crate::solver::pbf::correct_positions::correct_positions;
use crate::solver::pbf::curl::curl;
use crate::solver::pbf::density_ratio;
use crate::solver::pbf::update_velocity::update_velocity;
use crate::solver::pbf::viscosity::viscosity;
use glam::DVec3;

/// A fluid and everything that moves it.
pub struct Fluid {
    /// The particles; they keep their order.
    pub particles: Vec<Particle>,
    /// The substep.
    pub step: Step,
    /// The smoothing kernel.
    pub smoothing: Smoothing,
    /// The solver.
    pub pbf: Pbf,
    /// Iterations a substep.
    pub iterations: u32,
    /// What walls add to the density; `None` without walls.
    pub walls: Option<DomainWalls>,
    /// Whether particles outside the domain have no neighbours, being outside the grid.
    pub grid_ends_at_domain: bool,
}

impl Fluid {
    /// Advances by one substep.
    pub fn substep(&mut self) {
        for particle in &mut self.particles {
            *particle = predict(*particle, &self.step).particle;
        }
        let predicted_m = self.positions_m();
        let neighbours = self.neighbours();
        let mut positions_m = predicted_m.clone();
        for _ in 0..self.iterations {
            positions_m = self.iterate(&predicted_m, &positions_m, &neighbours);
        }
        for (i, particle) in self.particles.iter_mut().enumerate() {
            if !particle.quarantined {
                let (velocity_m_s, _) =
                    update_velocity(predicted_m[i], positions_m[i], particle.velocity_m_s, &self.step);
                particle.velocity_m_s = velocity_m_s;
                particle.position_m = self.step.wrapped(positions_m[i]);
            }
        }
        self.confine_vorticity(&neighbours);
        self.xsph(&neighbours);
    }

    /// The neighbour lists of the present positions.
    pub fn neighbours(&self) -> Neighbours {
        let alone = |i: usize| {
            let particle = self.particles[i];
            let inside_m = particle.position_m.clamp(DVec3::ZERO, self.step.domain_size_m);
            particle.quarantined || (self.grid_ends_at_domain && inside_m != particle.position_m)
        };
        list_by_cells(&self.positions_m(), alone, self.smoothing.support_m, self.step.period_m)
    }

    /// Density ratios of the present positions.
    pub fn density_ratios(&self) -> Vec<f64> {
        let positions_m = self.positions_m();
        let neighbours = self.neighbours();
        (0..positions_m.len())
            .map(|i| density_ratio(i, &positions_m, &neighbours[i], &self.smoothing, self.walls.as_ref()))
            .collect()
    }

    fn positions_m(&self) -> Vec<DVec3> {
        self.particles.iter().map(|p| p.position_m).collect()
    }

    fn velocities_m_s(&self) -> Vec<DVec3> {
        self.particles.iter().map(|p| p.velocity_m_s).collect()
    }

    fn iterate(&self, predicted_m: &[DVec3], positions_m: &[DVec3], neighbours: &Neighbours) -> Vec<DVec3> {
        let walls = self.walls.as_ref();
        let (smoothing, pbf) = (&self.smoothing, &self.pbf);
        let count = positions_m.len();
        let lambdas =
            parallel::map(count, |i| constrain_density(i, positions_m, &neighbours[i], smoothing, pbf, walls).lambda);
        parallel::map(count, |i| {
            let none = |_, _| DVec3::ZERO;
            let (start_m, list) = (predicted_m[i], &neighbours[i]);
            correct_positions(i, positions_m, start_m, &lambdas, list, &self.step, smoothing, pbf, walls, none)
                .position_m
        })
    }

    fn confine_vorticity(&mut self, neighbours: &Neighbours) {
        if self.pbf.vorticity == 0.0 {
            return;
        }
        let (positions_m, velocities_m_s) = (self.positions_m(), self.velocities_m_s());
        let swirls: Vec<DVec3> = (0..positions_m.len())
            .map(|i| curl(i, &positions_m, &velocities_m_s, &neighbours[i], &self.smoothing))
            .collect();
        for (i, particle) in self.particles.iter_mut().enumerate() {
            particle.velocity_m_s = confine_vorticity(
                i,
                &positions_m,
                velocities_m_s[i],
                &swirls,
                &neighbours[i],
                &self.step,
                &self.smoothing,
                &self.pbf,
            )
            .velocity_m_s;
        }
    }

    fn xsph(&mut self, neighbours: &Neighbours) {
        if self.pbf.xsph == 0.0 {
            return;
        }
        let (positions_m, velocities_m_s) = (self.positions_m(), self.velocities_m_s());
        for (i, particle) in self.particles.iter_mut().enumerate() {
            particle.velocity_m_s =
                viscosity(i, &positions_m, &velocities_m_s, &neighbours[i], &self.smoothing, &self.pbf);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::boundary::walls::WallScales;
    use crate::shared::lattice;
    use glam::BVec3;

    const SPACING: f64 = 0.02;

    fn fluid(positions_m: &[DVec3], gravity: f64) -> Fluid {
        Fluid {
            particles: positions_m
                .iter()
                .map(|&position_m| Particle { position_m, velocity_m_s: DVec3::ZERO, quarantined: false })
                .collect(),
            step: Step {
                gravity_m_s2: DVec3::new(0.0, -gravity, 0.0),
                dt_s: 1.0 / 240.0,
                domain_size_m: DVec3::splat(0.4),
                walls: BVec3::FALSE,
                period_m: DVec3::ZERO,
                wall_offset_m: SPACING / 4.0,
                max_speed_m_s: 10.0,
            },
            smoothing: Smoothing::new(2.0 * SPACING, lattice::weight(3, 2.0)),
            pbf: Pbf {
                relaxation: 0.5,
                cfm: 1e-4,
                s_corr_k: 0.0,
                s_corr_inverse_w: 0.0,
                xsph: 0.05,
                vorticity: 1e-3,
                max_correction_m: SPACING,
                separation: 0.0,
            },
            iterations: 4,
            walls: None,
            grid_ends_at_domain: false,
        }
    }

    #[test]
    fn free_space_keeps_momentum() {
        let points: Vec<DVec3> =
            lattice::points([6, 5, 4], 0.8 * SPACING).iter().map(|p| *p + DVec3::splat(0.1)).collect();
        let mut fluid = fluid(&points, 0.0);
        fluid.pbf.vorticity = 0.0;
        for _ in 0..10 {
            fluid.substep();
        }
        let momentum: DVec3 = fluid.velocities_m_s().iter().sum();
        let speed = fluid.velocities_m_s().iter().map(|v| v.length()).sum::<f64>();
        assert!(speed > 1.0, "a compressed block expands: {speed}");
        assert!(momentum.length() < 1e-11 * speed, "{momentum}");
    }

    #[test]
    fn a_full_box_stays_at_rest() {
        // The lattice has density ratio 1 at walls, edges and corners, so nothing pushes it.
        let points = lattice::points([5, 4, 3], SPACING);
        let mut fluid = fluid(&points, 0.0);
        fluid.step.walls = BVec3::TRUE;
        fluid.step.domain_size_m = DVec3::new(5.0, 4.0, 3.0) * SPACING;
        fluid.walls = Some(DomainWalls {
            dimensions: 3,
            axes: BVec3::TRUE,
            scales: WallScales::new(3, 2.0),
            domain_size_m: fluid.step.domain_size_m,
            support_m: fluid.smoothing.support_m,
        });
        // The second layer still sees a trace of the wall's integral, where the lattice sees none.
        let ratios = fluid.density_ratios();
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
