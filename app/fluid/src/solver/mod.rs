//! What moves the particles of a substep. A solver is an arm of [`Solver`] that records its own substep out of the
//! shared stages (`predict`, `sort`, `list`, `forces`) and its own.

pub mod dfsph;
pub mod none;
pub mod pbf;
pub mod sph;

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{Buffer, PbfParams, WarmStart};

use crate::grid::NeighbourSearch;
use crate::particles::buffers::Particles;
use crate::scene::{Method, Scene};
use crate::step_context::StepContext;
use dfsph::Dfsph;
use none::NonInteracting;
use pbf::Pbf;
use sph::Sph;

/// The solver of a scene.
pub enum Solver {
    /// Position Based Fluids.
    Pbf(Box<Pbf>),
    /// Smoothed particle hydrodynamics with an equation of state.
    Sph(Box<Sph>),
    /// Divergence-free SPH.
    Dfsph(Box<Dfsph>),
    /// None: particles that do not interact.
    None(NonInteracting),
}

impl Solver {
    /// Declares the buffers of the solver that `scene` chooses.
    pub fn declare(resources: &mut Resources, scene: &Scene, capacity: u32) -> Self {
        match scene.solver.method {
            Method::Pbf => Self::Pbf(Box::new(Pbf::declare(resources, scene, capacity))),
            Method::Sph => Self::Sph(Box::new(Sph::declare(resources, scene, capacity))),
            Method::Dfsph => Self::Dfsph(Box::new(Dfsph::declare(resources, scene, capacity))),
            Method::None => Self::None(NonInteracting::declare(resources)),
        }
    }

    /// Uploads its settings.
    pub fn record_init(&mut self, init: &mut Recording, scene: &Scene) {
        match self {
            Self::Pbf(pbf) => pbf.record_init(init, scene),
            Self::Sph(sph) => sph.record_init(init, scene),
            Self::Dfsph(dfsph) => dfsph.record_init(init, scene),
            Self::None(none) => none.record_init(init, scene),
        }
    }

    /// Records what opens a substep.
    pub fn begin_substep(&mut self, recording: &mut Recording, context: &mut StepContext) {
        match self {
            Self::Sph(sph) => sph.begin_substep(recording, context),
            Self::Pbf(_) | Self::Dfsph(_) | Self::None(_) => context.slots.begin_substep(recording, &context.step),
        }
    }

    /// Records one substep of `particles`.
    pub fn record_substep(&mut self, recording: &mut Recording, context: &mut StepContext, particles: &mut Particles) {
        match self {
            Self::Pbf(pbf) => pbf.record_substep(recording, context, particles),
            Self::Sph(sph) => sph.record_substep(recording, context, particles),
            Self::Dfsph(dfsph) => dfsph.record_substep(recording, context, particles),
            Self::None(none) => none.record_substep(recording, context, particles),
        }
    }

    /// Records what lists the neighbours of `particles` where they are, and what takes out some of their compression
    /// while time stands; nothing of particles that do not interact.
    pub fn record_relaxation(
        &mut self,
        [list, relax]: [&mut Recording; 2],
        context: &mut StepContext,
        particles: &mut Particles,
    ) {
        if let Self::Pbf(pbf) = self {
            pbf.record_list(list, context, particles);
            pbf.record_relaxation(relax, context, particles);
        }
    }

    /// What the next substep begins with of the last one's pressure; none of what begins cold.
    pub fn warm_starts(&self) -> Option<&Buffer<WarmStart>> {
        match self {
            Self::Pbf(pbf) => pbf.warm_starts(),
            Self::Sph(_) | Self::Dfsph(_) | Self::None(_) => None,
        }
    }

    /// With which pressures the next substep's solves begin, by slot; none of what has no such solves, or begins cold.
    pub fn pressures(&self) -> Vec<Buffer<f32>> {
        match self {
            Self::Dfsph(dfsph) => dfsph.pressures(),
            Self::Pbf(_) | Self::Sph(_) | Self::None(_) => Vec::new(),
        }
    }

    /// What the next substep takes of the last one's acceleration, by slot; none of solvers that keep none.
    pub fn accelerations(&self) -> Option<&Buffer<[f32; 4]>> {
        match self {
            Self::Sph(sph) => Some(sph.accelerations()),
            Self::Pbf(_) | Self::Dfsph(_) | Self::None(_) => None,
        }
    }

    /// What the density constraint's shaders are told, if that is the solver.
    pub fn pbf_params(&self) -> Option<&Buffer<PbfParams>> {
        match self {
            Self::Pbf(pbf) => Some(pbf.params()),
            Self::Sph(_) | Self::Dfsph(_) | Self::None(_) => None,
        }
    }

    /// Neighbours as the last substep listed them; `None` of particles that do not interact.
    pub fn search(&self) -> Option<&NeighbourSearch> {
        match self {
            Self::Pbf(pbf) => Some(&pbf.search),
            Self::Sph(sph) => Some(&sph.search),
            Self::Dfsph(dfsph) => Some(&dfsph.search),
            Self::None(_) => None,
        }
    }
}
