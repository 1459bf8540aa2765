//! Particles in cell order with their neighbours, as a step leaves them.

use brooklet_fluid::{
    Particles, Scene, Slots, StepContext,
    grid::{self, Grid, Neighbours, Sorted},
    visit_slots,
};
use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{Buffer, Position, Velocity};

/// Sorted particles and their lists.
pub struct Listed {
    pub positions: Buffer<Position>,
    pub velocities: Buffer<Velocity>,
    pub neighbours: Neighbours,
    pub slots: Slots,
}

impl Listed {
    /// Records how `positions` are sorted and listed, by the product's own passes.
    pub fn record(resources: &mut Resources, recording: &mut Recording, scene: &Scene, positions: &[Position]) -> Self {
        let count = positions.len() as u32;
        let params = grid::params(scene, count);
        let mut unsorted = Particles {
            positions: resources.persistent("unsorted_positions", count),
            velocities: resources.persistent("unsorted_velocities", count),
        };
        let mut grid = Grid::declare(resources, scene, &params, count);
        let mut neighbours = Neighbours::declare(resources, count, params.list_chunks);
        // What is drawn stays from the recording that sorts to those that draw.
        let mut sorted = Sorted {
            positions: resources.persistent("positions", count),
            velocities: resources.persistent("velocities", count),
            ..Sorted::declare(resources, scene, count)
        };
        let mut context = StepContext::declare(resources, scene, count);
        recording.upload(&mut unsorted.positions, positions);
        recording.clear(&mut unsorted.velocities);
        recording.clear(&mut context.counters);
        recording.upload(&mut context.slots.state, &[visit_slots(count)]);
        recording.upload(&mut grid.params, &[params]);
        grid.record_sort(recording, &mut context.slots, &unsorted, &mut sorted);
        neighbours.record(recording, &mut context, &grid, &sorted);
        Self { positions: sorted.positions, velocities: sorted.velocities, neighbours, slots: context.slots }
    }
}
