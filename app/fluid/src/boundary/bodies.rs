//! Solids that the fluid moves, and that move it. (Shaders: `boundary/bodies/`.)
//!
//! What a solid does to particles it does whether it is a body or not. A body gets all of it back: what stops paths adds to
//! its reaction at once, what iterations do is remembered in each particle's contact and gathered behind them. The next
//! substep begins with moving bodies by that. What pushes a solid that moves as it is told may be summed likewise, and is read
//! by whoever measures.

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{
    BodyContact, BodyState, Buffer, CONTACTS_PER_POINT, FindContacts, GatherReactions, Position, REACTION_WORDS,
    RigidBody, Solid, SolidContact, SolidPose, SolidsParams, StepBodies, StepParams, SurfacePoint,
};

use crate::scene::{Scene, bodies, body_count, reaction_count, surface_point_count, surface_points};
use crate::slots::Slots;

/// The bodies of a scene, and its solids whose force is measured.
pub struct Bodies {
    points: Buffer<SurfacePoint>,
    contacts: Buffer<BodyContact>,
    /// What lasts of them from step to step.
    pub buffers: BodyBuffers,
}

/// What lasts of bodies from step to step, and what they weigh.
pub struct BodyBuffers {
    /// How many there are. Behind them in `states` and `reactions` come the solids whose force is measured.
    pub count: u32,
    /// Their inertia.
    pub inertia: Buffer<RigidBody>,
    /// How they move.
    pub states: Buffer<BodyState>,
    /// What particles gave back: bodies since the last substep, others since the session began.
    pub reactions: Buffer<u32>,
}

impl BodyBuffers {
    /// How many solids there are whose force is measured.
    pub(crate) fn measured(&self) -> u32 {
        self.states.len - self.count
    }

    /// The same, for another owner.
    pub(crate) fn alias(&self) -> Self {
        Self {
            count: self.count,
            inertia: self.inertia.alias(),
            states: self.states.alias(),
            reactions: self.reactions.alias(),
        }
    }
}

/// What of a solid's buffers bodies are moved among.
pub(super) struct Around<'a> {
    pub solids: &'a Buffer<Solid>,
    pub poses: &'a mut Buffer<SolidPose>,
    pub fields: &'a Buffer<[f32; 2]>,
    pub slots: &'a Slots,
    pub step: &'a Buffer<StepParams>,
    pub params: &'a Buffer<SolidsParams>,
}

impl Bodies {
    /// Those of a scene; none of one that has none.
    pub(super) fn declare(resources: &mut Resources, scene: &Scene) -> Option<Self> {
        let (count, reactions) = (body_count(scene), reaction_count(scene));
        // Without bodies nobody binds these, and they are not allocated.
        let points = surface_point_count(scene).max(1);
        (reactions > 0).then(|| Self {
            points: resources.persistent("surface_points", points),
            contacts: resources.buffer("body_contacts", CONTACTS_PER_POINT * points),
            buffers: BodyBuffers {
                count,
                inertia: resources.persistent("bodies", count.max(1)),
                states: resources.persistent("body_states", reactions),
                reactions: resources.persistent("reactions", REACTION_WORDS * reactions),
            },
        })
    }

    pub(super) fn record_init(&mut self, init: &mut Recording, scene: &Scene) {
        init.upload(&mut self.buffers.inertia, &bodies(scene));
        init.upload(&mut self.points, &surface_points(scene));
    }

    /// Moves them by what the last substep's particles gave, gravity, and what they touch.
    pub(super) fn record_step(&mut self, recording: &mut Recording, around: Around<'_>) {
        if self.buffers.count == 0 {
            return;
        }
        let Around { solids, poses, fields, slots, step, params } = around;
        recording.dispatch(
            &FindContacts {
                surface_points: self.points.read(),
                bodies: self.buffers.inertia.read(),
                body_states: self.buffers.states.read(),
                solids: solids.read(),
                solid_poses: poses.read(),
                solid_fields: fields.read(),
                body_contacts: self.contacts.write(),
                step_state: slots.state.uniform(),
                step_params: step.uniform(),
                solids_params: params.uniform(),
            },
            self.points.len,
        );
        recording.dispatch_groups(
            &StepBodies {
                bodies: self.buffers.inertia.read(),
                body_contacts: self.contacts.read(),
                body_states: self.buffers.states.write(),
                reactions: self.buffers.reactions.write(),
                solid_poses: poses.write(),
                step_state: slots.state.uniform(),
                step_params: step.uniform(),
                solids_params: params.uniform(),
            },
            [1; 3],
        );
    }

    /// Adds what iterations gave particles for bodies.
    pub(super) fn record_gather(
        &mut self,
        recording: &mut Recording,
        slots: &Slots,
        positions: &Buffer<Position>,
        contacts: &Buffer<SolidContact>,
        params: &Buffer<SolidsParams>,
    ) {
        slots.dispatch(
            recording,
            &GatherReactions {
                sorted_positions: positions.read(),
                solid_contacts: contacts.read(),
                body_states: self.buffers.states.read(),
                reactions: self.buffers.reactions.write(),
                step_state: slots.state.uniform(),
                solids_params: params.uniform(),
            },
        );
    }

    /// The same bodies, for another owner.
    pub(super) fn alias(&self) -> Self {
        Self { points: self.points.alias(), contacts: self.contacts.alias(), buffers: self.buffers.alias() }
    }
}
