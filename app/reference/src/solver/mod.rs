//! Solvers: each an arm of [`Solver`] that moves particles by a substep of its own.

pub mod dfsph;
pub mod none;
pub mod pbf;
pub mod sph;

use crate::boundary::walls::DomainWalls;
use crate::params::{NonInteracting, Step};
use crate::particles::predict::Particle;
use dfsph::substep::Dfsph;
use none::integrate_particles::integrate_particles;
use pbf::substep::Pbf;
use sph::substep::Sph;

/// What moves the particles of a substep.
#[derive(Clone, Debug)]
pub enum Solver {
    /// Position Based Fluids.
    Pbf(Pbf),
    /// Smoothed particle hydrodynamics.
    Sph(Box<Sph>),
    /// Divergence-free SPH.
    Dfsph(Dfsph),
    /// Particles that do not interact; their ids are their indices.
    None(NonInteracting),
}

impl Solver {
    /// Advances `particles` by one substep, and says by how long, s.
    pub fn substep(&mut self, particles: &mut [Particle], step: &Step, walls: Option<&DomainWalls>) -> f64 {
        match self {
            Self::Pbf(pbf) => pbf.substep(particles, step, walls),
            Self::Sph(sph) => return sph.substep(particles, step),
            Self::Dfsph(dfsph) => {
                dfsph.substep(particles, step, walls);
            }
            Self::None(settings) => {
                for (id, particle) in particles.iter_mut().enumerate() {
                    *particle = integrate_particles(id as u32, *particle, step, settings).particle;
                }
            }
        }
        step.dt_s
    }

    /// Takes out compression while time stands; nothing of particles that do not interact.
    pub fn relax(&self, particles: &mut [Particle], step: &Step, walls: Option<&DomainWalls>) {
        if let Self::Pbf(pbf) = self {
            pbf.relax(particles, step, walls);
        }
    }
}
