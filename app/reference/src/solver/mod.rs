//! Solvers: each an arm of [`Solver`] that moves particles by a substep of its own.

pub mod pbf;

use crate::boundary::walls::DomainWalls;
use crate::params::Step;
use crate::particles::predict::Particle;
use pbf::substep::Pbf;

/// What moves the particles of a substep.
#[derive(Clone, Debug)]
pub enum Solver {
    /// Position Based Fluids.
    Pbf(Pbf),
}

impl Solver {
    /// Advances `particles` by one substep.
    pub fn substep(&self, particles: &mut [Particle], step: &Step, walls: Option<&DomainWalls>) {
        match self {
            Self::Pbf(pbf) => pbf.substep(particles, step, walls),
        }
    }
}
