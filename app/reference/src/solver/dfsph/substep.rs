//! A whole substep of divergence-free SPH, in the order of the GPU's.

use super::correct_pressure::PressureSolve;
use super::factor_pressure::{factor_pressure, separation};
use super::solve::{Fluid, Solved};
use crate::boundary::confine_position;
use crate::boundary::mirror::Mirrors;
use crate::boundary::walls::DomainWalls;
use crate::forces;
use crate::grid::list_neighbours::{Neighbours, list_by_cells};
use crate::measure::density::mirrored_density_ratio;
use crate::params::{Forces, Smoothing, Step};
use crate::particles::predict::{Particle, predict};
use crate::solver::pbf::coarse_correction::CoarseGrid;
use glam::DVec3;

/// The solver with everything that it is told.
#[derive(Clone, Debug)]
pub struct Dfsph {
    /// The smoothing kernel.
    pub smoothing: Smoothing,
    /// The divergence solve.
    pub divergence: PressureSolve,
    /// The density solve; none where it does no iterations.
    pub density: Option<PressureSolve>,
    /// The grid that corrects the divergence solve, if there is one.
    pub coarse_grid: Option<Box<CoarseGrid>>,
    /// What acts on velocities alone.
    pub forces: Forces,
    /// Whether particles outside the domain have no neighbours, being outside the grid.
    pub grid_ends_at_domain: bool,
}

impl Dfsph {
    /// Advances by one substep; how the divergence and the density solve ended.
    pub fn substep(&self, particles: &mut [Particle], step: &Step, walls: Option<&DomainWalls>) -> [Solved; 2] {
        // Velocities are already those of the move.
        let moving = Step { gravity_m_s2: DVec3::ZERO, ..*step };
        for particle in particles.iter_mut() {
            *particle = predict(*particle, &moving).particle;
        }
        let positions_m: Vec<DVec3> = particles.iter().map(|p| p.position_m).collect();
        let neighbours = self.neighbours(particles, step);
        let factor = |(i, particle): (usize, &Particle)| {
            let mirrors = Mirrors::at(positions_m[i], walls);
            factor_pressure(i, &positions_m, &neighbours[i], &self.smoothing, mirrors, particle.is_simulated())
        };
        let factors: Vec<_> = particles.iter().enumerate().map(factor).collect();
        let fluid = Fluid {
            positions_m: &positions_m,
            neighbours: &neighbours,
            factors: &factors,
            step,
            smoothing: &self.smoothing,
        };
        let begin = |which: usize, solve: &PressureSolve| -> Vec<f64> {
            let of = |p: &Particle| if p.is_simulated() { solve.warm_share * p.multipliers[which] } else { 0.0 };
            particles.iter().map(of).collect()
        };
        let mut pressures = begin(0, &self.divergence);
        let mut velocities_m_s: Vec<DVec3> = particles.iter().map(|p| p.velocity_m_s).collect();
        let falling = velocities_m_s.iter_mut().zip(particles.iter()).filter(|(_, particle)| particle.is_simulated());
        falling.for_each(|(velocity, _)| *velocity += step.gravity_m_s2 * step.dt_s);
        let mut velocities_m_s =
            forces::apply(&positions_m, velocities_m_s, &neighbours, step, &self.smoothing, &self.forces);
        let divergence =
            fluid.solve(&mut velocities_m_s, &mut pressures, &self.divergence, self.coarse_grid.as_deref());
        // Which way two at one point part is drawn from the order of the GPU's sort.
        let parting = |i: usize| match particles[i].is_simulated() {
            true => separation(i, &positions_m, &neighbours[i], &self.smoothing, |_, _| DVec3::ZERO),
            false => DVec3::ZERO,
        };
        let speed_m_s = self.smoothing.support_m / step.dt_s;
        let mut shifts_m_s: Vec<DVec3> = (0..particles.len()).map(|i| parting(i) * speed_m_s).collect();
        let mut shifting = vec![0.0; particles.len()];
        let density = match &self.density {
            Some(solve) => {
                shifting = begin(1, solve);
                fluid.solve(&mut shifts_m_s, &mut shifting, solve, None)
            }
            None => Solved::default(),
        };
        for (i, particle) in particles.iter_mut().enumerate() {
            particle.velocity_m_s = match particle.is_simulated() {
                true => step.slowed(velocities_m_s[i]).0,
                false => velocities_m_s[i],
            };
            particle.multipliers = [pressures[i], shifting[i]];
            if particle.is_simulated() {
                particle.position_m = shift_position(particle.position_m, shifts_m_s[i], step);
            }
        }
        [divergence, density]
    }

    /// The neighbour lists of the particles' positions.
    pub fn neighbours(&self, particles: &[Particle], step: &Step) -> Neighbours {
        let alone = |i: usize| {
            let particle = particles[i];
            let inside_m = particle.position_m.clamp(DVec3::ZERO, step.domain_size_m);
            !particle.is_simulated() || (self.grid_ends_at_domain && inside_m != particle.position_m)
        };
        let positions_m: Vec<DVec3> = particles.iter().map(|p| p.position_m).collect();
        list_by_cells(&positions_m, alone, self.smoothing.support_m, step.period_m)
    }

    /// Density ratios of the particles where they are.
    pub fn density_ratios(&self, particles: &[Particle], step: &Step, walls: Option<&DomainWalls>) -> Vec<f64> {
        let positions_m: Vec<DVec3> = particles.iter().map(|p| p.position_m).collect();
        let neighbours = self.neighbours(particles, step);
        let ratio = |i: usize| mirrored_density_ratio(i, &positions_m, &neighbours[i], &self.smoothing, walls);
        (0..positions_m.len()).map(ratio).collect()
    }
}

/// Where a density solve moves a particle, whose displacement is that over dt.
pub fn shift_position(position_m: DVec3, shift_m_s: DVec3, step: &Step) -> DVec3 {
    let moved_m = confine_position(position_m + shift_m_s.clamp_length_max(step.max_speed_m_s) * step.dt_s, step);
    step.wrapped(moved_m)
}
