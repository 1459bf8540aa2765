//! Spray, foam and bubbles (Ihmsen, Akinci, Akinci & Teschner 2012, "Unified spray, foam and bubbles for particle-based fluids").
//! (Shaders: `diffuse/`.)
//!
//! Once a step, behind its last substep, as in the paper: those that there are move with the fluid as it now is, then the fluid
//! spawns others. Where the GPU chooses the substeps it is once a substep, as nobody knows which is the last. Slots are a ring;
//! a scan of what each fluid particle spawns gives everyone a slot, so that a deterministic scene stays so. Nothing is read back, and
//! nothing of it is in the plan of a scene without `[diffuse]`.

mod set;
pub(crate) mod slots;

use std::mem::offset_of;

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{
    AdvectDiffuse, AdvectDiffuseVariant, Buffer, CountSpawned, CrestNormals, DiffuseParams, DiffuseState,
    SettleDiffuse, SpawnDiffuse,
};

use crate::grid::{NeighbourSearch, Scan};
use crate::particles::buffers::Particles;
use crate::scene::{DiffuseSettings, Scene};
use crate::step_context::StepContext;

pub use set::DiffuseSet;
pub use slots::DiffuseSlots;

/// The diffuse particles of a scene.
pub struct Diffuse {
    slots: DiffuseSlots,
    params: Buffer<DiffuseParams>,
    normals: Buffer<[f32; 4]>,
    counts: Buffer<u32>,
    offsets: Buffer<u32>,
    scan: Scan,
    capacity: u32,
    /// Whether it is recorded behind every substep.
    pub(crate) each_substep: bool,
}

/// What the shaders are told.
pub fn diffuse_params(scene: &Scene, diffuse: &DiffuseSettings) -> DiffuseParams {
    let range = |[min, max]: [f64; 2]| [min as f32, (1.0 / (max - min)) as f32];
    let [trapped_air_least_m_s, trapped_air_inverse_range_s_m] = range(scene.trapped_air_limits_m_s(diffuse));
    let [wave_crest_least, wave_crest_inverse_range] = range([diffuse.wave_crest_min, diffuse.wave_crest_max]);
    let [energy_least_j_kg, energy_inverse_range_kg_j] = range(scene.energy_limits_j_kg(diffuse));
    let [neighbours, weight] = scene.neighbours_all_around();
    DiffuseParams {
        capacity: diffuse.max_particles,
        trapped_air_per_s: diffuse.trapped_air_per_s as f32,
        wave_crest_per_s: diffuse.wave_crest_per_s as f32,
        lifetime_s: diffuse.lifetime_s as f32,
        trapped_air_least_m_s,
        trapped_air_inverse_range_s_m,
        wave_crest_least,
        wave_crest_inverse_range,
        energy_least_j_kg,
        energy_inverse_range_kg_j,
        buoyancy: diffuse.buoyancy as f32,
        drag: diffuse.drag as f32,
        inverse_neighbours: (1.0 / neighbours) as f32,
        inverse_weight: (1.0 / weight) as f32,
        inverse_normal: (1.0 / scene.flat_normal()) as f32,
        spread_m: scene.wall_offset_m() as f32,
        substeps: if scene.adapts_substeps() { 1 } else { scene.substeps() },
        along_z: if scene.domain.is_flat() { 0.0 } else { 1.0 },
        ..DiffuseParams::default()
    }
}

impl Diffuse {
    /// None of a scene without.
    pub(crate) fn declare(resources: &mut Resources, scene: &Scene, capacity: u32) -> Option<Self> {
        let slots = scene.diffuse_particles()?.max_particles;
        Some(Self {
            slots: DiffuseSlots {
                particles: resources.persistent("diffuse", slots),
                state: resources.persistent("diffuse_state", 1),
            },
            params: resources.persistent("diffuse_params", 1),
            normals: resources.buffer("crest_normals", capacity),
            counts: resources.buffer("spawn_counts", capacity),
            offsets: resources.buffer("spawn_offsets", capacity),
            scan: Scan::declare(resources, "spawn_offsets", capacity),
            capacity,
            each_substep: scene.adapts_substeps(),
        })
    }

    pub(crate) fn record_init(&mut self, init: &mut Recording, scene: &Scene) {
        if let Some(diffuse) = scene.diffuse_particles() {
            init.upload(&mut self.params, &[diffuse_params(scene, diffuse)]);
            init.clear(&mut self.slots.particles);
            init.clear(&mut self.slots.state);
        }
    }

    /// Moves those that there are, then spawns others.
    pub(crate) fn record(
        &mut self,
        recording: &mut Recording,
        context: &mut StepContext,
        search: &NeighbourSearch,
        particles: &Particles,
    ) {
        self.advect(recording, context, search, particles);
        self.spawn(recording, context, search, particles);
    }

    fn advect(
        &mut self,
        recording: &mut Recording,
        context: &mut StepContext,
        search: &NeighbourSearch,
        particles: &Particles,
    ) {
        let grid = &search.grid;
        let groups = offset_of!(DiffuseState, groups) as u32;
        let slots = self.slots.particles.len;
        recording.dispatch_indirect(
            &AdvectDiffuse {
                variant: AdvectDiffuseVariant { walls: context.walls, cell_by_cell: grid.wrapped || grid.periodic },
                positions: particles.positions.read(),
                velocities: particles.velocities.read(),
                cell_starts: grid.cell_starts.read(),
                diffuse: self.slots.particles.write(),
                counters: context.counters.write(),
                diffuse_state: self.slots.state.uniform(),
                step_state: context.slots.state.uniform(),
                step_params: context.step.uniform(),
                grid: grid.params.uniform(),
                diffuse_params: self.params.uniform(),
            },
            &self.slots.state,
            groups,
            slots,
        );
        if let Some(solids) = &context.solids {
            let state = self.slots.state.alias();
            let kernel = solids.collide_diffuse(&mut self.slots, &mut context.counters, &self.params);
            recording.dispatch_indirect(&kernel, &state, groups, slots);
        }
    }

    fn spawn(
        &mut self,
        recording: &mut Recording,
        context: &mut StepContext,
        search: &NeighbourSearch,
        particles: &Particles,
    ) {
        let lists = &search.neighbours;
        context.slots.dispatch(
            recording,
            &CrestNormals {
                positions: particles.positions.read(),
                neighbours: lists.deltas.read(),
                list_heads: lists.heads.read(),
                crest_normals: self.normals.write(),
                step_state: context.slots.state.uniform(),
                step_params: context.step.uniform(),
                kernel: search.smoothing_kernel.uniform(),
                diffuse_params: self.params.uniform(),
            },
        );
        recording.dispatch(
            &CountSpawned {
                positions: particles.positions.read(),
                velocities: particles.velocities.read(),
                neighbours: lists.deltas.read(),
                list_heads: lists.heads.read(),
                crest_normals: self.normals.read(),
                spawn_counts: self.counts.write(),
                counters: context.counters.write(),
                step_state: context.slots.state.uniform(),
                step_params: context.step.uniform(),
                kernel: search.smoothing_kernel.uniform(),
                diffuse_params: self.params.uniform(),
            },
            self.capacity,
        );
        self.scan.record(recording, &self.counts, &mut self.offsets);
        context.slots.dispatch(
            recording,
            &SpawnDiffuse {
                positions: particles.positions.read(),
                velocities: particles.velocities.read(),
                list_heads: lists.heads.read(),
                spawn_counts: self.counts.read(),
                spawn_offsets: self.offsets.read(),
                diffuse: self.slots.particles.write(),
                counters: context.counters.write(),
                diffuse_state: self.slots.state.uniform(),
                step_state: context.slots.state.uniform(),
                diffuse_params: self.params.uniform(),
            },
        );
        recording.dispatch_groups(
            &SettleDiffuse {
                spawn_counts: self.counts.read(),
                spawn_offsets: self.offsets.read(),
                settled_state: self.slots.state.write(),
                counters: context.counters.write(),
                diffuse_params: self.params.uniform(),
            },
            [1; 3],
        );
    }

    /// Their slots.
    pub(crate) fn slots(&self) -> &DiffuseSlots {
        &self.slots
    }
}
