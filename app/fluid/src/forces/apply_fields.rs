//! Body forces of place and time. (Shader: `forces/apply_fields.compute`.)

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{ApplyFields, Buffer, ForceField, ForceFieldCount};

use crate::particles::buffers::Particles;
use crate::scene::Scene;
use crate::step_context::StepContext;

/// The fields of a scene.
pub struct BodyForces {
    fields: Buffer<ForceField>,
    count: Buffer<ForceFieldCount>,
}

/// What the shader is given.
pub fn force_fields(scene: &Scene) -> Vec<ForceField> {
    let of = |field: &crate::scene::FieldSettings| ForceField {
        acceleration_m_s2: field.acceleration_m_s2.map(|a| a as f32),
        frequency_hz: field.frequency_hz as f32,
        swirl_per_s2: field.swirl_per_s2.map(|s| s as f32),
        begin_s: field.begin_s as f32,
        centre_m: std::array::from_fn(|axis| (field.centre_m[axis] - scene.domain.min_m[axis]) as f32),
        end_s: field.end_s.unwrap_or(f64::from(f32::MAX)) as f32,
    };
    scene.forces.fields.iter().map(of).collect()
}

impl BodyForces {
    /// None of a scene that has no field.
    pub fn declare(resources: &mut Resources, scene: &Scene) -> Option<Self> {
        let count = scene.forces.fields.len() as u32;
        (count > 0).then(|| Self {
            fields: resources.persistent("force_fields", count),
            count: resources.persistent("force_field_count", 1),
        })
    }

    /// Uploads them.
    pub fn record_init(&mut self, init: &mut Recording, scene: &Scene) {
        let fields = force_fields(scene);
        init.upload(&mut self.count, &[ForceFieldCount { fields: fields.len() as u32, ..ForceFieldCount::default() }]);
        init.upload(&mut self.fields, &fields);
    }

    /// Records what velocities take of them in a substep.
    pub fn record(&self, recording: &mut Recording, context: &StepContext, particles: &mut Particles) {
        context.slots.dispatch(
            recording,
            &ApplyFields {
                positions: particles.positions.read(),
                fields: self.fields.read(),
                velocities: particles.velocities.write(),
                step_state: context.slots.state.uniform(),
                field_count: self.count.uniform(),
            },
        );
    }
}
