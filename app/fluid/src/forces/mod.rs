//! What acts on velocities alone, whichever solver made them. Each is a pass of its own, and not there where its
//! coefficient is 0.

mod apply_fields;
mod vorticity;
mod xsph;

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{Buffer, ForceParams, Velocity};

use crate::grid::NeighbourSearch;
use crate::scene::Scene;
use crate::step_context::StepContext;
pub use apply_fields::{BodyForces, force_fields};
use vorticity::VorticityConfinement;

/// The forces of a scene.
pub struct Forces {
    pub(crate) params: Buffer<ForceParams>,
    vorticity: Option<VorticityConfinement>,
    xsph: bool,
}

/// What the shaders are given.
pub fn params(scene: &Scene) -> ForceParams {
    ForceParams {
        xsph: scene.forces.xsph as f32,
        vorticity_m_s: scene.forces.vorticity_m_s as f32,
        ..ForceParams::default()
    }
}

impl Forces {
    /// Declares the buffers of the forces that `scene` has.
    pub fn declare(resources: &mut Resources, scene: &Scene, capacity: u32) -> Self {
        Self {
            params: resources.persistent("force_params", 1),
            vorticity: (scene.forces.vorticity_m_s > 0.0).then(|| VorticityConfinement::declare(resources, capacity)),
            xsph: scene.forces.xsph > 0.0,
        }
    }

    /// Uploads the coefficients.
    pub fn record_init(&mut self, init: &mut Recording, scene: &Scene) {
        init.upload(&mut self.params, &[params(scene)]);
    }

    /// Whether [`Forces::record`] begins with velocities where the sort left them, and not with the particles' own.
    pub fn smooth(&self) -> bool {
        self.xsph
    }

    /// From what the solver left, in the search's order, to `velocities`.
    pub fn record(
        &mut self,
        recording: &mut Recording,
        context: &StepContext,
        search: &NeighbourSearch,
        velocities: &mut Buffer<Velocity>,
    ) {
        let mut unsmoothed = self.xsph.then(|| search.sorted.velocities.alias());
        if let Some(vorticity) = &mut self.vorticity {
            let input = unsmoothed.as_mut().unwrap_or(&mut *velocities);
            vorticity.record(recording, &self.params, context, search, input);
        }
        if let Some(unsmoothed) = &unsmoothed {
            xsph::xsph(recording, &self.params, context, search, unsmoothed, velocities);
        }
    }
}
