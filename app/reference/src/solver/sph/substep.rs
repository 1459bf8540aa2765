//! A whole substep of SPH, in the order of the GPU's.

use super::accelerate::{Flow, accelerate};
use super::choose_time_step::{Left, Limits};
use super::compute_density::{Kernels, State, Terms, compute_density};
use super::find_fastest::find_fastest;
use crate::boundary::walls::DomainWalls;
use crate::grid::list_neighbours::list_by_cells;
use crate::params::{Smoothing, Step};
use crate::particles::advect::{Kicks, advect};
use crate::particles::predict::Particle;
use crate::shared::parallel;
use glam::DVec3;

/// The solver with everything that it is told.
#[derive(Clone, Debug)]
pub struct Sph {
    /// The distances that neighbours are of.
    pub smoothing: Smoothing,
    /// The kernels.
    pub kernels: Kernels,
    /// The terms.
    pub terms: Terms,
    /// The integrator.
    pub kicks: Kicks,
    /// What the density's kernel counts beyond walls.
    pub density_walls: Option<DomainWalls>,
    /// And the colour field's.
    pub tension_walls: Option<DomainWalls>,
    /// And what they answer to pressure.
    pub pressure_walls: Option<DomainWalls>,
    /// What limits substeps.
    pub limits: Limits,
    /// Whether they are chosen.
    pub adapts: bool,
    /// What is left of the step.
    pub left: Left,
    /// Fastest particle and largest acceleration of the last substep.
    pub maxima: [f64; 2],
    /// The neighbours that the last substep took.
    pub neighbours: Vec<Vec<usize>>,
    /// How far particles may have moved since they were listed, m; 0 where they were just then.
    pub drift_m: f64,
}

impl Sph {
    /// Advances by one substep, and says by how long, s; one that is left over does nothing.
    pub fn substep(&mut self, particles: &mut [Particle], step: &Step) -> f64 {
        let mut step = *step;
        let [speed_m_s, acceleration_m_s2] = self.maxima;
        let is_first = self.left.substeps == 0;
        self.left = if self.adapts {
            let chosen = self.limits.choose(self.limits.limit_s(speed_m_s, acceleration_m_s2), self.left);
            step.dt_s = chosen.dt_s;
            chosen.left
        } else {
            let substeps = if is_first { self.limits.substeps } else { self.left.substeps };
            Left { substeps: substeps - 1, ..self.left }
        };
        if step.dt_s == 0.0 {
            return 0.0;
        }
        self.drift_m = self.limits.drift_m(self.drift_m, step.dt_s, self.maxima, is_first);
        for particle in particles.iter_mut() {
            *particle = advect(*particle, &step, &self.kicks).particle;
        }
        if self.drift_m == 0.0 {
            self.neighbours = self.list(particles, &step);
        }
        let accelerations = self.accelerations(particles, &step);
        for (particle, acceleration_m_s2) in particles.iter_mut().zip(accelerations) {
            if !particle.is_simulated() {
                continue;
            }
            particle.acceleration_m_s2 = Some(acceleration_m_s2);
            let kicked_m_s = particle.velocity_m_s + acceleration_m_s2 * (self.kicks.end * step.dt_s);
            particle.velocity_m_s = step.slowed(kicked_m_s).0;
        }
        self.maxima = find_fastest(particles);
        step.dt_s
    }

    fn list(&self, particles: &[Particle], step: &Step) -> Vec<Vec<usize>> {
        let positions_m: Vec<DVec3> = particles.iter().map(|p| p.position_m).collect();
        let alone = |i: usize| {
            let inside_m = positions_m[i].clamp(DVec3::ZERO, step.domain_size_m);
            !particles[i].is_simulated() || inside_m != positions_m[i]
        };
        list_by_cells(&positions_m, alone, self.smoothing.support_m, step.period_m)
    }

    fn accelerations(&self, particles: &[Particle], step: &Step) -> Vec<DVec3> {
        let positions_m: Vec<DVec3> = particles.iter().map(|p| p.position_m).collect();
        let velocities_m_s: Vec<DVec3> = particles.iter().map(|p| p.velocity_m_s).collect();
        let neighbours = &self.neighbours;
        let states = parallel::map(particles.len(), |i| {
            let [walls, beyond] = [&self.density_walls, &self.tension_walls].map(Option::as_ref);
            let state = compute_density(
                i,
                &positions_m,
                &neighbours[i],
                &self.smoothing,
                &self.kernels,
                &self.terms,
                walls,
                beyond,
            );
            // Lists that are kept still have who was parked since.
            let pressure_m2_s2 = if particles[i].is_simulated() { state.pressure_m2_s2 } else { 0.0 };
            State { pressure_m2_s2, ..state }
        });
        let flow = Flow { positions_m: &positions_m, velocities_m_s: &velocities_m_s, states: &states };
        parallel::map(particles.len(), |i| {
            let (list, walls) = (&neighbours[i], self.pressure_walls.as_ref());
            let none = |_, _| DVec3::ZERO;
            accelerate(i, &flow, list, step, &self.smoothing, &self.kernels, &self.terms, walls, none)
        })
    }
}
