//! Particles in cell order with their neighbours, as a step leaves them.

use brooklet_fluid::{
    Scene,
    grid::{self, Grid, Neighbours, Sorted},
};
use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{Buffer, Position, Velocity};

/// Sorted particles and their lists.
pub struct Listed {
    pub positions: Buffer<Position>,
    pub velocities: Buffer<Velocity>,
    pub neighbours: Neighbours,
}

impl Listed {
    /// Records how `positions` are sorted and listed, by the product's own passes.
    pub fn record(resources: &mut Resources, recording: &mut Recording, scene: &Scene, positions: &[Position]) -> Self {
        let count = positions.len() as u32;
        let params = grid::params(scene, count);
        let mut unsorted = resources.persistent("unsorted_positions", count);
        let mut at_rest = resources.persistent::<Velocity>("unsorted_velocities", count);
        let mut grid = Grid::declare(resources, scene, &params);
        let mut neighbours = Neighbours::declare(resources, &params);
        // What is drawn stays from the recording that sorts to those that draw.
        let mut sorted = Sorted {
            positions: resources.persistent("positions", count),
            velocities: resources.persistent("velocities", count),
            ..Sorted::declare(resources, scene, count)
        };
        let mut counters = resources.persistent("counters", 1);
        recording.upload(&mut unsorted, positions);
        recording.clear(&mut at_rest);
        recording.clear(&mut counters);
        recording.upload(&mut grid.params, &[params]);
        grid.record_sort(recording, &unsorted, &at_rest, &mut sorted);
        neighbours.record(recording, &grid, &sorted, &mut counters);
        Self { positions: sorted.positions, velocities: sorted.velocities, neighbours }
    }
}
