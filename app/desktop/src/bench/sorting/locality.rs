//! Locality: everything known of a particle moves to cell order, or its index alone.

use brooklet_fluid::{
    Scene,
    grid::{Grid, Neighbours, Scan, Sorted, params},
    kernel,
    solver::pbf::{self, Pbf, Shared},
    step_params,
};
use brooklet_gpu::{Engine, Recording, Resources};
use brooklet_kernels::{
    Buffer, CountCells, GridParams, ListNeighboursByIndex, Position, PrecisionKeyword, ReorderIndex, Velocity,
};

use super::contest::{ALTERNATIVE, BASELINE, INIT, Names, Outcome, Ring};
use crate::failure::Failure;

/// One way: from particles to their neighbours and through the solver.
struct Way {
    positions: Buffer<Position>,
    velocities: Buffer<Velocity>,
    grid: Grid,
    neighbours: Neighbours,
    pbf: Pbf,
    solved_positions: Buffer<Position>,
    solved_velocities: Buffer<Velocity>,
}

impl Way {
    fn declare(resources: &mut Resources, scene: &Scene, params: &GridParams) -> Self {
        let count = params.particle_count;
        Self {
            positions: resources.state("positions", count),
            velocities: resources.state("velocities", count),
            grid: Grid::declare(resources, scene, params),
            neighbours: Neighbours::declare(resources, params),
            pbf: Pbf::declare(resources, scene, count),
            solved_positions: resources.state("solved_positions", count),
            solved_velocities: resources.state("solved_velocities", count),
        }
    }

    fn upload(&mut self, init: &mut Recording, scene: &Scene, params: &GridParams, positions: &[Position]) {
        init.upload(&mut self.positions, positions);
        init.upload(&mut self.grid.params, &[*params]);
        init.upload(&mut self.pbf.params, &[pbf::params(scene)]);
    }

    fn solve(&mut self, recording: &mut Recording, shared: &mut Shared, sorted: &mut Sorted) {
        let (positions, velocities) = (&mut self.solved_positions, &mut self.solved_velocities);
        self.pbf.record(recording, shared, &self.neighbours, sorted, positions, velocities);
    }

    /// How many neighbours each particle has, by its id.
    fn neighbours_by_id(&self, engine: &mut Engine) -> Result<Vec<u32>, Failure> {
        let positions = engine.read(&self.solved_positions).map_err(Failure::stopped)?;
        let counts = engine.read(&self.neighbours.counts).map_err(Failure::stopped)?;
        let mut by_id = vec![0; counts.len()];
        for (position, count) in positions.iter().zip(counts) {
            by_id[position.tag as usize] = count;
        }
        Ok(by_id)
    }
}

fn shared(resources: &mut Resources) -> Shared {
    Shared {
        step: resources.state("step_params", 1),
        kernel: resources.state("kernel_params", 1),
        walls: true,
        precision: PrecisionKeyword::Off,
        counters: resources.state("counters", 1),
    }
}

/// Sorts, lists and solves a step. The product's way begins with the particles in the order in
/// which its last step leaves them, `in_order`; the other never moves them from where they `lie`.
pub fn locality(
    ring: &Ring<'_>,
    case: String,
    scene: &Scene,
    in_order: &[Position],
    lie: &[Position],
) -> Result<Outcome, Failure> {
    let count = lie.len() as u32;
    let params = params(scene, count);
    let mut resources = Resources::new();
    let mut shared = shared(&mut resources);
    let mut product = Way::declare(&mut resources, scene, &params);
    let mut by_index = Way::declare(&mut resources, scene, &params);
    let mut init = Recording::new(INIT);
    init.upload(&mut shared.step, &[step_params(scene, count)]);
    init.upload(&mut shared.kernel, &[kernel::params(scene)]);
    product.upload(&mut init, scene, &params, in_order);
    by_index.upload(&mut init, scene, &params, lie);

    let mut baseline = Recording::new(BASELINE);
    let mut sorted = Sorted::declare(&mut resources, scene, count);
    product.grid.record_sort(&mut baseline, &product.positions, &product.velocities, &mut sorted);
    product.neighbours.record(&mut baseline, &product.grid, &sorted, &mut shared.counters);
    product.solve(&mut baseline, &mut shared, &mut sorted);

    let mut alternative = Recording::new(ALTERNATIVE);
    let mut sorted_indices = resources.buffer("sorted_indices", count);
    let mut unsorted = Sorted {
        positions: by_index.positions.alias(),
        velocities: by_index.velocities.alias(),
        places: resources.buffer("unsorted_places", count),
        packed: false,
    };
    sort_index(&mut alternative, &mut resources, &mut by_index, &mut sorted_indices, &mut unsorted);
    alternative.dispatch(
        &ListNeighboursByIndex {
            positions: by_index.positions.read(),
            places: unsorted.places.read(),
            cell_starts: by_index.grid.cell_starts.read(),
            sorted_indices: sorted_indices.read(),
            neighbours: by_index.neighbours.indices.write(),
            neighbour_counts: by_index.neighbours.counts.write(),
            counters: shared.counters.write(),
            grid: by_index.grid.params.uniform(),
        },
        count,
    );
    by_index.solve(&mut alternative, &mut shared, &mut unsorted);
    let names =
        Names { optimisation: "locality", case, baseline: "reorder everything", alternative: "reorder an index" };
    ring.compare(names, resources, [init, baseline, alternative], |engine| {
        let found = [product.neighbours_by_id(engine)?, by_index.neighbours_by_id(engine)?];
        let [a, b] = found;
        super::equal("neighbours", a, b)
    })
}

fn sort_index(
    recording: &mut Recording,
    resources: &mut Resources,
    way: &mut Way,
    sorted_indices: &mut Buffer<u32>,
    unsorted: &mut Sorted,
) {
    let Way { positions, grid, .. } = way;
    let mut scan = Scan::declare(resources, "index", grid.cell_counts.len);
    recording.clear(&mut grid.cell_counts);
    recording.dispatch(
        &CountCells {
            positions: positions.read(),
            cell_counts: grid.cell_counts.write(),
            cell_slots: grid.cell_slots.write(),
            grid: grid.params.uniform(),
        },
        positions.len,
    );
    scan.record(recording, &grid.cell_counts, &mut grid.cell_starts);
    recording.dispatch(
        &ReorderIndex {
            positions: positions.read(),
            cell_slots: grid.cell_slots.read(),
            cell_starts: grid.cell_starts.read(),
            sorted_indices: sorted_indices.write(),
            places: unsorted.places.write(),
            grid: grid.params.uniform(),
        },
        positions.len,
    );
}
