//! A whole substep of Position Based Fluids, in the order of the GPU's.

use super::coarse_correction::{CoarseGrid, coarse_multipliers, prolong_multiplier, share};
use super::constrain_density::constrain_density;
use super::correct_positions::correct_positions;
use super::momentum::{Weights, accumulated_lambda, momentum_lambda};
use super::update_velocity::update_velocity;
use super::warm_start::{keep_pressure, start_warm};
use crate::boundary::walls::DomainWalls;
use crate::forces;
use crate::grid::list_neighbours::{Neighbours, list_by_cells};
use crate::measure::density::density_ratio;
use crate::params::{self, Forces, Smoothing, Step};
use crate::particles::predict::{Particle, Pressure, predict};
use crate::shared::parallel;
use glam::DVec3;

/// The solver with everything that it is told.
#[derive(Clone, Debug)]
pub struct Pbf {
    /// The smoothing kernel.
    pub smoothing: Smoothing,
    /// The constraint's settings.
    pub params: params::Pbf,
    /// What a substep iterates.
    pub iterations: Iterations,
    /// What corrects the first of them on a coarse grid, if anything does.
    pub coarse_grid: Option<Box<CoarseGrid>>,
    /// What acts on velocities alone.
    pub forces: Forces,
    /// Whether particles outside the domain have no neighbours, being outside the grid.
    pub grid_ends_at_domain: bool,
    /// Whether walls that count in the density push, too.
    pub walls_push: bool,
}

/// The iterations of a substep.
#[derive(Clone, Debug)]
pub enum Iterations {
    /// So many of Jacobi's.
    Plain(u32),
    /// Each with its weights, lambdas with momentum.
    Momentum(Vec<Weights>),
    /// The same, lambdas held against the sum of those before.
    AccumulatedMomentum(Vec<Weights>),
}

impl Iterations {
    fn count(&self) -> usize {
        match self {
            Self::Plain(count) => *count as usize,
            Self::Momentum(weights) | Self::AccumulatedMomentum(weights) => weights.len(),
        }
    }
}

/// What a substep's iterations have left of the lambdas.
struct Lambdas {
    /// Of the last iteration.
    last: Vec<f64>,
    /// Of all.
    totals: Vec<f64>,
}

impl Pbf {
    /// Advances by one substep.
    pub fn substep(&self, particles: &mut [Particle], step: &Step, walls: Option<&DomainWalls>) {
        for particle in particles.iter_mut() {
            *particle = predict(*particle, step).particle;
        }
        let predicted_m = positions_m(particles);
        let neighbours = self.neighbours(particles, step);
        let starts: Vec<(DVec3, f64)> = particles
            .iter()
            .map(|particle| match particle.is_simulated() {
                true => start_warm(particle.position_m, &particle.pressure, step, &self.params),
                false => (particle.position_m, 0.0),
            })
            .collect();
        let (corrected_m, totals) = self.iterate(particles, &starts, &neighbours, step, walls);
        for (i, particle) in particles.iter_mut().enumerate() {
            particle.pressure = Pressure::default();
            if particle.is_simulated() {
                particle.pressure = keep_pressure(predicted_m[i], corrected_m[i], totals[i], step.dt_s);
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

    /// Takes out compression while time stands: moves particles by a substep's iterations and leaves velocities
    /// alone. Without artificial pressure, which would push on for ever.
    pub fn relax(&self, particles: &mut [Particle], step: &Step, walls: Option<&DomainWalls>) {
        let without = Self { params: params::Pbf { s_corr_k: 0.0, ..self.params }, ..self.clone() };
        let neighbours = without.neighbours(particles, step);
        let starts: Vec<(DVec3, f64)> = particles.iter().map(|particle| (particle.position_m, 0.0)).collect();
        let (relaxed_m, _) = without.iterate(particles, &starts, &neighbours, step, walls);
        for (particle, relaxed_m) in particles.iter_mut().zip(relaxed_m).filter(|(particle, _)| particle.is_simulated())
        {
            particle.position_m = step.wrapped(relaxed_m);
        }
    }

    /// Where the iterations move particles from where they start, with a sum of lambdas before them, and those sums then.
    fn iterate(
        &self,
        particles: &[Particle],
        starts: &[(DVec3, f64)],
        neighbours: &Neighbours,
        step: &Step,
        walls: Option<&DomainWalls>,
    ) -> (Vec<DVec3>, Vec<f64>) {
        let predicted_m = positions_m(particles);
        let (mut corrected_m, totals): (Vec<_>, Vec<_>) = starts.iter().copied().unzip();
        let mut lambdas = Lambdas { last: vec![0.0; totals.len()], totals };
        for iteration in 0..self.iterations.count() {
            lambdas.last = self.lambdas(iteration, &lambdas, &corrected_m, neighbours, walls);
            if let (0, Some(grid)) = (iteration, &self.coarse_grid) {
                self.correct_coarsely(grid, particles, &corrected_m, &mut lambdas.last, neighbours, walls);
            }
            lambdas.totals.iter_mut().zip(&lambdas.last).for_each(|(total, lambda)| *total += lambda);
            corrected_m = self.correct(&predicted_m, &corrected_m, &lambdas.last, neighbours, step, walls);
        }
        (corrected_m, lambdas.totals)
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

    fn lambdas(
        &self,
        iteration: usize,
        before: &Lambdas,
        positions_m: &[DVec3],
        neighbours: &Neighbours,
        walls: Option<&DomainWalls>,
    ) -> Vec<f64> {
        let (smoothing, pbf) = (&self.smoothing, &self.params);
        parallel::map(positions_m.len(), |i| {
            let constraint = constrain_density(i, positions_m, &neighbours[i], smoothing, pbf, walls);
            let (last, total) = (before.last[i], before.totals[i]);
            match &self.iterations {
                Iterations::Plain(_) => constraint.lambda,
                Iterations::Momentum(weights) => momentum_lambda(&constraint, &weights[iteration], last),
                Iterations::AccumulatedMomentum(weights) => {
                    accumulated_lambda(&constraint, &weights[iteration], last, total)
                }
            }
        })
    }

    /// Adds the coarse grid's multiplier, in which particles are where they were predicted, to the lambdas of where they
    /// start.
    fn correct_coarsely(
        &self,
        grid: &CoarseGrid,
        particles: &[Particle],
        starts_m: &[DVec3],
        lambdas: &mut [f64],
        neighbours: &Neighbours,
        walls: Option<&DomainWalls>,
    ) {
        let predicted_m = positions_m(particles);
        let excesses = parallel::map(predicted_m.len(), |i| {
            constrain_density(i, starts_m, &neighbours[i], &self.smoothing, &self.params, walls).excess
        });
        let simulated = || (0..predicted_m.len()).filter(|&i| particles[i].is_simulated());
        let multipliers = coarse_multipliers(grid, simulated().map(|i| (predicted_m[i], excesses[i])));
        for i in simulated() {
            lambdas[i] += share(excesses[i]) * prolong_multiplier(grid, &multipliers, predicted_m[i]);
        }
    }

    fn correct(
        &self,
        predicted_m: &[DVec3],
        positions_m: &[DVec3],
        lambdas: &[f64],
        neighbours: &Neighbours,
        step: &Step,
        walls: Option<&DomainWalls>,
    ) -> Vec<DVec3> {
        let (smoothing, pbf) = (&self.smoothing, &self.params);
        parallel::map(positions_m.len(), |i| {
            let none = |_, _| DVec3::ZERO;
            let (start_m, list) = (predicted_m[i], &neighbours[i]);
            let walls = walls.filter(|_| self.walls_push);
            correct_positions(i, positions_m, start_m, lambdas, list, step, smoothing, pbf, walls, none).position_m
        })
    }
}

fn positions_m(particles: &[Particle]) -> Vec<DVec3> {
    particles.iter().map(|p| p.position_m).collect()
}
