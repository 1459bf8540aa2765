//! A whole substep of Position Based Fluids, in the order of the GPU's.

use super::constrain_density::constrain_density;
use super::correct_positions::correct_positions;
use super::update_velocity::update_velocity;
use crate::boundary::walls::DomainWalls;
use crate::forces;
use crate::grid::list_neighbours::{Neighbours, list_by_cells};
use crate::measure::density::density_ratio;
use crate::params::{self, Forces, Smoothing, Step};
use crate::particles::predict::{Particle, predict};
use crate::shared::parallel;
use glam::DVec3;

/// The solver with everything that it is told.
#[derive(Clone, Debug)]
pub struct Pbf {
    /// The smoothing kernel.
    pub smoothing: Smoothing,
    /// The constraint's settings.
    pub params: params::Pbf,
    /// Iterations a substep.
    pub iterations: u32,
    /// What acts on velocities alone.
    pub forces: Forces,
    /// Whether particles outside the domain have no neighbours, being outside the grid.
    pub grid_ends_at_domain: bool,
}

impl Pbf {
    /// Advances by one substep.
    pub fn substep(&self, particles: &mut [Particle], step: &Step, walls: Option<&DomainWalls>) {
        for particle in particles.iter_mut() {
            *particle = predict(*particle, step).particle;
        }
        let predicted_m = positions_m(particles);
        let neighbours = self.neighbours(particles, step);
        let mut corrected_m = predicted_m.clone();
        for _ in 0..self.iterations {
            corrected_m = self.iterate(&predicted_m, &corrected_m, &neighbours, step, walls);
        }
        for (i, particle) in particles.iter_mut().enumerate() {
            if particle.is_simulated() {
                let (velocity_m_s, _) = update_velocity(predicted_m[i], corrected_m[i], particle.velocity_m_s, step);
                particle.velocity_m_s = velocity_m_s;
                particle.position_m = step.wrapped(corrected_m[i]);
            }
        }
        let velocities_m_s = particles.iter().map(|p| p.velocity_m_s).collect();
        let forced =
            forces::apply(&positions_m(particles), velocities_m_s, &neighbours, step, &self.smoothing, &self.forces);
        for (particle, velocity_m_s) in particles.iter_mut().zip(forced) {
            particle.velocity_m_s = velocity_m_s;
        }
    }

    /// The neighbour lists of the particles' positions.
    pub fn neighbours(&self, particles: &[Particle], step: &Step) -> Neighbours {
        let alone = |i: usize| {
            let particle = particles[i];
            let inside_m = particle.position_m.clamp(DVec3::ZERO, step.domain_size_m);
            !particle.is_simulated() || (self.grid_ends_at_domain && inside_m != particle.position_m)
        };
        list_by_cells(&positions_m(particles), alone, self.smoothing.support_m, step.period_m)
    }

    /// Density ratios of the particles where they are.
    pub fn density_ratios(&self, particles: &[Particle], step: &Step, walls: Option<&DomainWalls>) -> Vec<f64> {
        let positions_m = positions_m(particles);
        let neighbours = self.neighbours(particles, step);
        (0..positions_m.len()).map(|i| density_ratio(i, &positions_m, &neighbours[i], &self.smoothing, walls)).collect()
    }

    fn iterate(
        &self,
        predicted_m: &[DVec3],
        positions_m: &[DVec3],
        neighbours: &Neighbours,
        step: &Step,
        walls: Option<&DomainWalls>,
    ) -> Vec<DVec3> {
        let (smoothing, pbf) = (&self.smoothing, &self.params);
        let count = positions_m.len();
        let lambdas =
            parallel::map(count, |i| constrain_density(i, positions_m, &neighbours[i], smoothing, pbf, walls).lambda);
        parallel::map(count, |i| {
            let none = |_, _| DVec3::ZERO;
            let (start_m, list) = (predicted_m[i], &neighbours[i]);
            correct_positions(i, positions_m, start_m, &lambdas, list, step, smoothing, pbf, walls, none).position_m
        })
    }
}

fn positions_m(particles: &[Particle]) -> Vec<DVec3> {
    particles.iter().map(|p| p.position_m).collect()
}
