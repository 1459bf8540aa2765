//! The stages that every solver of interacting particles shares: sort, then list.

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{Buffer, SearchGroups, SmoothingKernelParams};

use super::{Grid, Neighbours, Sorted, params};
use crate::particles::buffers::Particles;
use crate::scene::Scene;
use crate::smoothing_kernel_params::smoothing_kernel_params;
use crate::step_context::StepContext;

/// The grid, the particles in its order, their lists, and the kernel that weighs neighbours.
pub struct NeighbourSearch {
    /// Cells and the counting sort.
    pub grid: Grid,
    /// The particles as the last sort left them.
    pub sorted: Sorted,
    /// Their neighbours.
    pub neighbours: Neighbours,
    /// The smoothing kernel over them.
    pub smoothing_kernel: Buffer<SmoothingKernelParams>,
}

impl NeighbourSearch {
    /// Declares the buffers of `capacity` slots.
    pub fn declare(resources: &mut Resources, scene: &Scene, capacity: u32) -> Self {
        let grid_params = params(scene, capacity);
        Self {
            grid: Grid::declare(resources, scene, &grid_params, capacity),
            neighbours: Neighbours::declare(resources, capacity, grid_params.list_chunks),
            sorted: Sorted::declare(resources, scene, capacity),
            smoothing_kernel: resources.persistent("smoothing_kernel_params", 1),
        }
    }

    /// Uploads the settings; lists begin empty.
    pub fn record_init(&mut self, init: &mut Recording, scene: &Scene) {
        init.upload(&mut self.grid.params, &[params(scene, self.sorted.positions.len)]);
        init.upload(&mut self.smoothing_kernel, &[smoothing_kernel_params(scene)]);
        init.clear(&mut self.neighbours.heads);
    }

    /// Sorts the particles by cell. Lists of their order before have no reader then.
    pub fn sort(&mut self, recording: &mut Recording, context: &mut StepContext, particles: &Particles) {
        self.neighbours.forget(recording, &context.slots);
        self.grid.record_sort(recording, &mut context.slots, particles, &mut self.sorted);
    }

    /// Sorts the particles and lists their neighbours in substeps that the GPU says; in others they keep order and lists.
    pub(crate) fn sort_and_list_if_due(
        &mut self,
        recording: &mut Recording,
        context: &mut StepContext,
        particles: &Particles,
        due: &Buffer<SearchGroups>,
    ) {
        let Self { grid, sorted, neighbours, .. } = self;
        grid.record_sort_if_due(recording, &mut context.slots, particles, sorted, due);
        neighbours.record_if_due(recording, context, grid, sorted, Some(due));
    }

    /// The same where neither positions nor velocities are read until all of them are written anew.
    pub fn sort_forgetting(&mut self, recording: &mut Recording, context: &mut StepContext, particles: &Particles) {
        self.neighbours.forget(recording, &context.slots);
        self.grid.record_sort_forgetting(recording, &mut context.slots, particles, &mut self.sorted);
    }

    /// Lists the sorted particles' neighbours.
    pub fn list(&mut self, recording: &mut Recording, context: &mut StepContext) {
        self.neighbours.record(recording, context, &self.grid, &self.sorted);
    }
}
