//! Particles that come and go while a scene runs: a block is put into inactive slots, a box is emptied. Nothing is
//! read back. (Shaders: `particles/activate.compute`, `particles/deactivate.compute`.)

use brooklet_gpu::{Engine, GpuError, Recording, Resources};
use brooklet_kernels::{
    ActivateParams, ActivateParticles, Buffer, ClaimSlots, DeactivateParams, DeactivateParticles, INACTIVE_FLUID,
};

use crate::step::Recorded;

/// Particles to activate, on a cubic lattice. They take part from the next substep on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParticleBlock {
    /// The particle at the lowest corner, relative to the domain's lowest corner, m.
    pub first_m: [f64; 3],
    /// From one to the next, m.
    pub spacing_m: f64,
    /// Particles along each axis.
    pub counts: [u32; 3],
    /// Their velocity, m/s.
    pub velocity_m_s: [f64; 3],
    /// The number of their fluid, below 127.
    pub fluid: u32,
}

/// A box whose particles are deactivated: those on its faces, too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrainBox {
    /// Its lowest corner, relative to the domain's lowest corner, m.
    pub min_m: [f64; 3],
    /// Its highest corner, m.
    pub max_m: [f64; 3],
}

/// What activates and deactivates.
pub struct SlotChanges {
    /// Empties a box; to be run before [`SlotChanges::activate`] and the steps of a frame.
    pub deactivate: Recording,
    /// Fills a block; to be run before the steps of a frame.
    pub activate: Recording,
    activate_params: Buffer<ActivateParams>,
    deactivate_params: Buffer<DeactivateParams>,
    most_activated: u32,
    capacity: u32,
}

/// Records both beside a scene's other recordings, for blocks of at most `most_activated` particles. A solver that
/// sorts makes room: the slots of what was deactivated are free after the next substep. One that does not
/// (`none`) has only the slots that its scene began without.
pub fn record_slot_changes(resources: &mut Resources, recorded: &mut Recorded, most_activated: u32) -> SlotChanges {
    let activate_params = resources.persistent("activate_params", 1);
    let deactivate_params = resources.persistent("deactivate_params", 1);
    let mut deactivate = resources.recording("deactivate");
    recorded.slots.dispatch(
        &mut deactivate,
        &DeactivateParticles {
            positions: recorded.positions.write(),
            velocities: recorded.velocities.write(),
            step_state: recorded.slots.state.uniform(),
            deactivate: deactivate_params.uniform(),
        },
    );
    let mut activate = resources.recording("activate");
    activate.dispatch(
        &ActivateParticles {
            positions: recorded.positions.write(),
            velocities: recorded.velocities.write(),
            step_state: recorded.slots.state.uniform(),
            activate: activate_params.uniform(),
        },
        most_activated,
    );
    activate.dispatch_groups(
        &ClaimSlots {
            counters: recorded.counters.write(),
            claimed_state: recorded.slots.state.write(),
            activate: activate_params.uniform(),
        },
        [1; 3],
    );
    let capacity = recorded.slots.capacity;
    SlotChanges { deactivate, activate, activate_params, deactivate_params, most_activated, capacity }
}

impl SlotChanges {
    /// Sets what the next run of [`SlotChanges::activate`] does.
    ///
    /// # Errors
    /// If the block has more particles than were recorded for, or what is no number, no length or no fluid.
    pub fn write_block(&self, engine: &mut Engine, block: &ParticleBlock) -> Result<(), GpuError> {
        let count = block.counts.iter().map(|&n| u128::from(n)).product::<u128>();
        let finite = block.first_m.iter().chain(&block.velocity_m_s).all(|&x| (x as f32).is_finite());
        let problem = match () {
            () if count > self.most_activated.into() => {
                format!("it has {count} particles; it was recorded for {} at most", self.most_activated)
            }
            () if !finite => "its corner and velocity must be finite".to_owned(),
            () if !(block.spacing_m > 0.0 && (block.spacing_m as f32).is_finite()) => {
                format!("its spacing is {} m; it must be above 0 and finite", block.spacing_m)
            }
            () if block.fluid >= INACTIVE_FLUID => {
                format!("its fluid is {}; it must be below {INACTIVE_FLUID}", block.fluid)
            }
            () => {
                engine.write(&self.activate_params, &[activate_params(block, self.capacity)]);
                return Ok(());
            }
        };
        Err(GpuError::Refused { reason: format!("a block of particles cannot be activated: {problem}") })
    }

    /// Sets what the next run of [`SlotChanges::deactivate`] does. A box with what is no number empties nothing.
    pub fn write_drain(&self, engine: &mut Engine, drain: &DrainBox) {
        engine.write(&self.deactivate_params, &[deactivate_params(drain)]);
    }
}

/// What the shader is given where there are `capacity` slots.
pub fn activate_params(block: &ParticleBlock, capacity: u32) -> ActivateParams {
    ActivateParams {
        first_m: block.first_m.map(|x| x as f32),
        spacing_m: block.spacing_m as f32,
        velocity_m_s: block.velocity_m_s.map(|v| v as f32),
        fluid: block.fluid,
        counts: block.counts,
        capacity,
    }
}

/// What the shader is given.
pub fn deactivate_params(drain: &DrainBox) -> DeactivateParams {
    DeactivateParams {
        min_m: drain.min_m.map(|x| x as f32),
        max_m: drain.max_m.map(|x| x as f32),
        ..DeactivateParams::default()
    }
}
