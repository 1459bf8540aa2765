//! The stages that every solver of interacting particles shares: sort, then list.

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{Buffer, SmoothingKernelParams};

use super::{Grid, Neighbours, Sorted, params};
use crate::scene::Scene;
use crate::smoothing_kernel_params::smoothing_kernel_params;
use crate::step_context::{Particles, StepContext};

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
    /// Declares the buffers of `particle_count` particles.
    pub fn declare(resources: &mut Resources, scene: &Scene, particle_count: u32) -> Self {
        let grid_params = params(scene, particle_count);
        Self {
            grid: Grid::declare(resources, scene, &grid_params),
            neighbours: Neighbours::declare(resources, &grid_params),
            sorted: Sorted::declare(resources, scene, particle_count),
            smoothing_kernel: resources.persistent("smoothing_kernel_params", 1),
        }
    }

    /// Uploads the settings; lists begin empty.
    pub fn record_init(&mut self, init: &mut Recording, scene: &Scene, particle_count: u32) {
        init.upload(&mut self.grid.params, &[params(scene, particle_count)]);
        init.upload(&mut self.smoothing_kernel, &[smoothing_kernel_params(scene)]);
        init.clear(&mut self.neighbours.heads);
    }

    /// Sorts the particles by cell.
    pub fn sort(&mut self, recording: &mut Recording, particles: &Particles) {
        self.grid.record_sort(recording, &particles.positions, &particles.velocities, &mut self.sorted);
    }

    /// Lists the sorted particles' neighbours.
    pub fn list(&mut self, recording: &mut Recording, context: &mut StepContext) {
        self.neighbours.record(recording, &self.grid, &self.sorted, &mut context.counters);
    }
}
