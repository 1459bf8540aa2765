//! What solids add to density and acceleration. (Shaders: `solver/sph/add_solid_density.compute`,
//! `add_solid_acceleration.compute`.)

use brooklet_gpu::Recording;
use brooklet_kernels::{
    AddSolidAcceleration, AddSolidAccelerationVariant, AddSolidDensity, AddSolidDensityVariant, Buffer, StepParams,
};

use super::{Gathered, Sph};
use crate::boundary::solids::Solids;
use crate::particles::buffers::Particles;
use crate::slots::Slots;
use crate::step_context::StepContext;

/// To what `compute_density` left.
pub(super) fn add_solid_density(recording: &mut Recording, sph: &mut Sph, solids: &Solids, context: &StepContext) {
    let (velocity_pressures, velocity_pressure_normals, tension_walls) = match &mut sph.gathered {
        Gathered::Flow(flow) => (Some(flow.write()), None, None),
        Gathered::FlowAndSurface { both, walls } => (None, Some(both.write()), Some(walls.uniform())),
    };
    context.slots.dispatch(
        recording,
        &AddSolidDensity {
            variant: AddSolidDensityVariant { surface_tension: velocity_pressure_normals.is_some() },
            sorted_positions: sph.search.sorted.positions.read(),
            solid_contacts: solids.contacts().read(),
            velocity_pressures,
            velocity_pressure_normals,
            step_state: context.slots.state.uniform(),
            step_params: context.step.uniform(),
            density_walls: sph.density_walls.uniform(),
            tension_walls,
            sph: sph.params.uniform(),
        },
    );
}

/// To what `accelerate` left.
pub(super) fn add_solid_acceleration(
    recording: &mut Recording,
    sph: &mut Sph,
    solids: &mut Solids,
    (slots, step): (&Slots, &Buffer<StepParams>),
    particles: &mut Particles,
) {
    let (velocity_pressures, velocity_pressure_normals) = match &sph.gathered {
        Gathered::Flow(flow) => (Some(flow.read()), None),
        Gathered::FlowAndSurface { both, .. } => (None, Some(both.read())),
    };
    slots.dispatch(
        recording,
        &AddSolidAcceleration {
            variant: AddSolidAccelerationVariant { surface_tension: velocity_pressure_normals.is_some() },
            sorted_positions: sph.search.sorted.positions.read(),
            solid_contacts: solids.contacts_mut().write(),
            velocity_pressures,
            velocity_pressure_normals,
            velocities: particles.velocities.write(),
            accelerations: sph.accelerations.write(),
            step_state: slots.state.uniform(),
            step_params: step.uniform(),
            pressure_walls: sph.pressure_walls.uniform(),
            sph: sph.params.uniform(),
        },
    );
}
