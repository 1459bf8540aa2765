//! Solids that the fluid flows around. (Shaders: `boundary/solids/`.)
//!
//! A substep moves them, marks which of them are near each block of the domain, and stops particles' paths at them. Each
//! particle is then told once what it needs to know while iterations move it: the half-space that adds as much density as
//! the solids near it, which counts as a wall does, and the plane of the nearest surface. So an iteration's cost does not
//! grow with the solids, and that of the rest only with the particles in blocks that one is near.

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{
    BodyState, Buf, BufMut, Buffer, CONTACT_REACH, CollideDiffuse, CollideSolids, CollideSolidsVariant,
    ConfineDisplacements, ConfineDisplacementsVariant, Counters, DiffuseParams, Keyframe, MarkSolids, MoveSolids,
    Position, PrecisionKeyword, SampleSolids, SmoothingKernelParams, Solid, SolidContact, SolidPose, SolidsParams,
    StepParams, Velocity,
};

use super::bodies::{Around, Bodies, BodyBuffers};
use crate::diffuse::slots::DiffuseSlots;
use crate::scene::{Scene, body_count, field_nodes, reaction_count, solids, surface_point_count};
use crate::slots::Slots;

/// Blocks along the longest side of the domain, at most.
const MOST_BLOCKS: f64 = 16.0;

/// The solids of a scene.
pub struct Solids {
    slots: Slots,
    step: Buffer<StepParams>,
    pub(crate) solids: Buffer<Solid>,
    keyframes: Buffer<Keyframe>,
    poses: Buffer<SolidPose>,
    pub(crate) fields: Buffer<[f32; 2]>,
    pub(crate) blocks: Buffer<[u32; 4]>,
    block_count: u32,
    contacts: Buffer<SolidContact>,
    bodies: Option<Bodies>,
    params: Buffer<SolidsParams>,
}

/// What one particle's change of velocity as fast as is allowed counts in a body's reaction.
const UNITS_OF_THE_FASTEST: f64 = 67_108_864.0;
/// Where nothing limits speeds: the units still hold thirty times as much.
const FAST_M_S: f64 = 100.0;

/// What the shaders are told of all of them.
pub fn solids_params(scene: &Scene) -> SolidsParams {
    let size_m = scene.domain.size_m();
    let longest_m = size_m.into_iter().fold(0.0, f64::max);
    let wanted_m = (longest_m / MOST_BLOCKS).max(2.0 * scene.support_m());
    let blocks = size_m.map(|side_m| (side_m / wanted_m).floor().max(1.0));
    let block_m: [f64; 3] = std::array::from_fn(|axis| size_m[axis] / blocks[axis]);
    // Whom a substep may bring to a surface, and whom its iterations may.
    let path_m = (scene.max_speed_m_s() * scene.substep_s()).min(2.0 * longest_m);
    let has_reactions = reaction_count(scene) > 0;
    SolidsParams {
        blocks: blocks.map(|blocks| blocks as u32),
        solid_count: scene.solids.len() as u32,
        inverse_block_per_m: block_m.map(|side_m| (1.0 / side_m) as f32),
        reach_m: (path_m.max(f64::from(CONTACT_REACH) * scene.support_m()) + scene.wall_offset_m()) as f32,
        block_m: block_m.map(|side_m| side_m as f32),
        stop_m: scene.wall_offset_m() as f32,
        body_count: body_count(scene),
        point_count: surface_point_count(scene),
        units_per_m_s: if has_reactions { units_per_m_s(scene) as f32 } else { 0.0 },
        unit_kg_m_s: unit_kg_m_s(scene) as f32,
    }
}

fn units_per_m_s(scene: &Scene) -> f64 {
    UNITS_OF_THE_FASTEST / scene.max_speed_m_s().min(FAST_M_S)
}

/// The impulse that is one of a reaction's units, kg m/s.
pub(crate) fn unit_kg_m_s(scene: &Scene) -> f64 {
    scene.particle_mass_kg() / units_per_m_s(scene)
}

impl Solids {
    /// Those around the particles in `slots`; none of a scene that has none.
    pub(crate) fn declare(
        resources: &mut Resources,
        scene: &Scene,
        slots: &Slots,
        step: &Buffer<StepParams>,
    ) -> Option<Self> {
        let (solids, keyframes) = solids(scene);
        if solids.is_empty() {
            return None;
        }
        let block_count = solids_params(scene).blocks.into_iter().product();
        Some(Self {
            slots: slots.alias(),
            step: step.alias(),
            solids: resources.persistent("solids", solids.len() as u32),
            keyframes: resources.persistent("keyframes", keyframes.len() as u32),
            poses: resources.persistent("solid_poses", solids.len() as u32),
            fields: resources.persistent("solid_fields", field_nodes(scene).len() as u32),
            blocks: resources.buffer("solid_blocks", block_count),
            block_count,
            contacts: resources.buffer("solid_contacts", slots.capacity),
            bodies: Bodies::declare(resources, scene),
            params: resources.persistent("solids_params", 1),
        })
    }

    /// Uploads them.
    pub(crate) fn record_init(&mut self, init: &mut Recording, scene: &Scene) {
        let (solids, keyframes) = solids(scene);
        init.upload(&mut self.solids, &solids);
        init.upload(&mut self.keyframes, &keyframes);
        init.upload(&mut self.fields, &field_nodes(scene));
        init.upload(&mut self.params, &[solids_params(scene)]);
        if let Some(bodies) = &mut self.bodies {
            bodies.record_init(init, scene);
        }
    }

    /// Moves those that the fluid moves to where they are at the substep's end.
    pub(crate) fn record_step(&mut self, recording: &mut Recording) {
        if let Some(bodies) = &mut self.bodies {
            let poses = &mut self.poses;
            let (solids, fields, params) = (&self.solids, &self.fields, &self.params);
            let (slots, step) = (&self.slots, &self.step);
            bodies.record_step(recording, Around { solids, poses, fields, slots, step, params });
        }
    }

    /// Gives them what iterations gave particles, which stand at `positions`.
    pub(crate) fn record_gather(&mut self, recording: &mut Recording, positions: &Buffer<Position>) {
        if let Some(bodies) = &mut self.bodies {
            bodies.record_gather(recording, &self.slots, positions, &self.contacts, &self.params);
        }
    }

    /// Moves the solids to where they are at the substep's end.
    pub(crate) fn record_move(&mut self, recording: &mut Recording) {
        let count = self.solids.len;
        recording.dispatch(
            &MoveSolids {
                solids: self.solids.read(),
                keyframes: self.keyframes.read(),
                solid_poses: self.poses.write(),
                step_state: self.slots.state.uniform(),
                solids_params: self.params.uniform(),
            },
            count,
        );
        self.mark(recording);
    }

    fn mark(&mut self, recording: &mut Recording) {
        recording.dispatch(
            &MarkSolids {
                solid_poses: self.poses.read(),
                solid_blocks: self.blocks.write(),
                solids_params: self.params.uniform(),
            },
            self.block_count,
        );
    }

    /// Stops the paths that particles took in the substep.
    pub(crate) fn record_collide(
        &mut self,
        recording: &mut Recording,
        positions: &mut Buffer<Position>,
        velocities: &mut Buffer<Velocity>,
    ) {
        let is_any_body = self.bodies.is_some();
        let (body_states, reactions) = bindings(self.bodies.as_mut());
        self.slots.dispatch(
            recording,
            &CollideSolids {
                variant: CollideSolidsVariant { bodies: is_any_body },
                solids: self.solids.read(),
                solid_poses: self.poses.read(),
                solid_fields: self.fields.read(),
                solid_blocks: self.blocks.read(),
                positions: positions.write(),
                velocities: velocities.write(),
                body_states,
                reactions,
                step_state: self.slots.state.uniform(),
                step_params: self.step.uniform(),
                solids_params: self.params.uniform(),
            },
        );
    }

    /// The same of particles at `positions` in another recording than the step's.
    pub(crate) fn record_sample_anew(
        &mut self,
        recording: &mut Recording,
        positions: &Buffer<Position>,
        kernel: &Buffer<SmoothingKernelParams>,
    ) {
        self.mark(recording);
        self.record_sample(recording, positions, kernel);
    }

    /// Tells particles at `positions` of the solids near them.
    pub(crate) fn record_sample(
        &mut self,
        recording: &mut Recording,
        positions: &Buffer<Position>,
        kernel: &Buffer<SmoothingKernelParams>,
    ) {
        self.slots.dispatch(
            recording,
            &SampleSolids {
                positions: positions.read(),
                solids: self.solids.read(),
                solid_poses: self.poses.read(),
                solid_fields: self.fields.read(),
                solid_blocks: self.blocks.read(),
                solid_contacts: self.contacts.write(),
                step_state: self.slots.state.uniform(),
                solids_params: self.params.uniform(),
                kernel: kernel.uniform(),
            },
        );
    }

    /// Holds the displacements of a substep's iterations to what solids let through. Bodies feel it if time passes.
    pub(crate) fn record_confine(
        &mut self,
        recording: &mut Recording,
        precision: PrecisionKeyword,
        sorted_positions: &Buffer<Position>,
        quantized_positions: &mut Buffer<[u32; 2]>,
        kernel: &Buffer<SmoothingKernelParams>,
        time_passes: bool,
    ) {
        let bodies = self.bodies.as_mut().filter(|_| time_passes);
        let is_any_body = bodies.is_some();
        let (body_states, reactions) = bindings(bodies);
        self.slots.dispatch(
            recording,
            &ConfineDisplacements {
                variant: ConfineDisplacementsVariant { bodies: is_any_body, precision },
                solids: self.solids.read(),
                solid_poses: self.poses.read(),
                solid_fields: self.fields.read(),
                solid_blocks: self.blocks.read(),
                sorted_positions: sorted_positions.read(),
                quantized_positions: quantized_positions.write(),
                body_states,
                reactions,
                step_state: self.slots.state.uniform(),
                step_params: self.step.uniform(),
                solids_params: self.params.uniform(),
                kernel: kernel.uniform(),
            },
        );
    }

    /// Stops the paths that diffuse particles took in the step. (Shader: `diffuse/collide_diffuse.compute`.)
    pub(crate) fn collide_diffuse<'a>(
        &'a self,
        slots: &'a mut DiffuseSlots,
        counters: &'a mut Buffer<Counters>,
        params: &'a Buffer<DiffuseParams>,
    ) -> CollideDiffuse<'a> {
        CollideDiffuse {
            solids: self.solids.read(),
            solid_poses: self.poses.read(),
            solid_fields: self.fields.read(),
            solid_blocks: self.blocks.read(),
            diffuse: slots.particles.write(),
            counters: counters.write(),
            diffuse_state: slots.state.uniform(),
            step_state: self.slots.state.uniform(),
            step_params: self.step.uniform(),
            solids_params: self.params.uniform(),
            diffuse_params: params.uniform(),
        }
    }

    /// What each particle knows of the solids near it.
    pub(crate) fn contacts(&self) -> &Buffer<SolidContact> {
        &self.contacts
    }

    /// The same, to remember in it what a body gives back.
    pub(crate) fn contacts_mut(&mut self) -> &mut Buffer<SolidContact> {
        &mut self.contacts
    }

    /// What lasts of those that the fluid moves, if there are any.
    pub(crate) fn bodies(&self) -> Option<&BodyBuffers> {
        self.bodies.as_ref().map(|bodies| &bodies.buffers)
    }

    /// What the shaders know of all of them.
    pub(crate) fn params(&self) -> &Buffer<SolidsParams> {
        &self.params
    }

    /// Where they are.
    pub(crate) fn poses(&self) -> &Buffer<SolidPose> {
        &self.poses
    }

    /// The same solids, for another owner.
    pub(crate) fn alias(&self) -> Self {
        Self {
            slots: self.slots.alias(),
            step: self.step.alias(),
            solids: self.solids.alias(),
            keyframes: self.keyframes.alias(),
            poses: self.poses.alias(),
            fields: self.fields.alias(),
            blocks: self.blocks.alias(),
            contacts: self.contacts.alias(),
            bodies: self.bodies.as_ref().map(Bodies::alias),
            params: self.params.alias(),
            ..*self
        }
    }
}

/// What the stages that stop paths give back to, if anything takes it.
fn bindings(bodies: Option<&mut Bodies>) -> (Option<Buf<'_, BodyState>>, Option<BufMut<'_, u32>>) {
    bodies.map(|bodies| (bodies.buffers.states.read(), bodies.buffers.reactions.write())).unzip()
}
