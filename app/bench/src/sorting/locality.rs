//! Locality: everything known of a particle moves to cell order, or its index alone.

use brooklet_fluid::{
    Particles, Scene, StepContext,
    grid::{Grid, Neighbours, Scan, Sorted, list_length, listed, params},
    smoothing_kernel_params,
    solver::pbf::{self, IterationWeights},
    step_params, visit_slots,
};
use brooklet_gpu::{Engine, Recording, Resources};
use brooklet_kernels::{
    Buffer, ConstrainDensity, ConstrainDensityVariant, CountCells, CountCellsVariant, GridParams, PbfParams, Position,
    PositionLambda, PrecisionKeyword, SmoothingKernelParams,
};

use super::contest::{Names, Outcome, Ring, Ways};
use crate::{
    BenchError,
    kernels::{ConstrainDensityByIndex, ListNeighboursByIndex, ReorderIndex},
};

/// What both ways are given.
struct Settings {
    context: StepContext,
    kernel: Buffer<SmoothingKernelParams>,
    pbf: Buffer<PbfParams>,
    iterations: u32,
}

/// One way: from particles to their neighbours and their lambdas.
struct Way {
    particles: Particles,
    grid: Grid,
    position_lambdas: Buffer<PositionLambda>,
}

impl Way {
    fn declare(resources: &mut Resources, scene: &Scene, params: &GridParams, count: u32) -> Self {
        Self {
            particles: Particles::declare(resources, count),
            grid: Grid::declare(resources, scene, params, count),
            position_lambdas: resources.persistent("position_lambdas", count),
        }
    }

    fn upload(&mut self, init: &mut Recording, params: &GridParams, positions: &[Position]) {
        init.upload(&mut self.particles.positions, positions);
        init.upload(&mut self.grid.params, &[*params]);
    }
}

/// Sorts, lists and finds the lambdas of a step's iterations, without walls. The product's way
/// begins with the particles in the order in which its last step leaves them, `in_order`; the other
/// never moves them from where they `lie`, so that its lists hold 32 bits a neighbour.
pub fn locality(
    ring: &Ring<'_>,
    case: String,
    scene: &Scene,
    in_order: &[Position],
    lie: &[Position],
) -> Result<Outcome, BenchError> {
    let count = lie.len() as u32;
    let params = params(scene, count);
    let mut resources = Resources::new();
    let mut settings = Settings {
        context: StepContext::declare(&mut resources, scene, count),
        kernel: resources.persistent("smoothing_kernel_params", 1),
        pbf: resources.persistent("pbf_params", 1),
        iterations: scene.solver.pbf.iterations,
    };
    let mut product = Way::declare(&mut resources, scene, &params, count);
    let mut by_index = Way::declare(&mut resources, scene, &params, count);
    let Ways { mut init, mut baseline, mut alternative } = Ways::declare(&mut resources);
    init.upload(&mut settings.context.step, &[step_params(scene)]);
    init.upload(&mut settings.context.slots.state, &[visit_slots(count)]);
    init.upload(&mut settings.kernel, &[smoothing_kernel_params(scene)]);
    init.upload(&mut settings.pbf, &[pbf::params(scene, &IterationWeights::of(scene))]);
    product.upload(&mut init, &params, in_order);
    by_index.upload(&mut init, &params, lie);

    let mut neighbours = Neighbours::declare(&mut resources, count, params.list_chunks);
    let mut sorted = Sorted {
        positions: resources.persistent("sorted_positions", count),
        velocities: resources.persistent("sorted_velocities", count),
        quantized_positions: resources.buffer("quantized_positions", count),
        precision: PrecisionKeyword::Off,
    };
    reorder_everything(&mut baseline, &mut settings, &mut product, &mut sorted, &mut neighbours);

    let mut listed_counts = resources.persistent("listed_counts", count);
    reorder_index(&mut alternative, &mut resources, &settings, &mut by_index, &params, &mut listed_counts);

    let names =
        Names { optimisation: "locality", case, baseline: "reorder everything", alternative: "reorder an index" };
    ring.compare(names, resources, Ways { init, baseline, alternative }, |engine| {
        let sorted = engine.read(&sorted.positions).map_err(BenchError::stopped)?;
        let product = neighbours_by_id(engine, &neighbours, &sorted, params.list_chunks)?;
        let counts = engine.read(&listed_counts).map_err(BenchError::stopped)?;
        super::equal("neighbours", product, by_id(lie.iter().zip(counts), lie.len()))
    })
}

/// How many neighbours each particle has, by its id.
fn neighbours_by_id(
    engine: &mut Engine,
    neighbours: &Neighbours,
    sorted: &[Position],
    list_chunks: u32,
) -> Result<Vec<u32>, BenchError> {
    let heads = engine.read(&neighbours.heads).map_err(BenchError::stopped)?;
    let deltas = engine.read(&neighbours.deltas).map_err(BenchError::stopped)?;
    let counts = heads.iter().enumerate().map(|(i, &head)| listed(i as u32, head, &deltas, list_chunks).count() as u32);
    Ok(by_id(sorted.iter().zip(counts), sorted.len()))
}

fn by_id<'a>(counts: impl Iterator<Item = (&'a Position, u32)>, particles: usize) -> Vec<u32> {
    let mut by_id = vec![0; particles];
    for (position, count) in counts {
        by_id[position.tag as usize] = count;
    }
    by_id
}

fn reorder_everything(
    recording: &mut Recording,
    settings: &mut Settings,
    way: &mut Way,
    sorted: &mut Sorted,
    neighbours: &mut Neighbours,
) {
    way.grid.record_sort(recording, &mut settings.context.slots, &way.particles, sorted);
    neighbours.record(recording, &mut settings.context, &way.grid, sorted);
    for _ in 0..settings.iterations {
        recording.dispatch(
            &ConstrainDensity {
                variant: ConstrainDensityVariant::default(),
                quantized_positions: sorted.quantized_positions.read(),
                sorted_positions: None,
                neighbours: neighbours.deltas.read(),
                list_heads: neighbours.heads.read(),
                solid_contacts: None,
                position_lambdas: Some(way.position_lambdas.write()),
                packed_position_lambdas: None,
                lambda_totals: None,
                step_state: settings.context.slots.state.uniform(),
                step_params: settings.context.step.uniform(),
                kernel: settings.kernel.uniform(),
                pbf: settings.pbf.uniform(),
                coarse_cells: None,
                coarse: None,
                iteration: None,
            },
            way.particles.positions.len,
        );
    }
}

fn reorder_index(
    recording: &mut Recording,
    resources: &mut Resources,
    settings: &Settings,
    way: &mut Way,
    params: &GridParams,
    listed_counts: &mut Buffer<u32>,
) {
    let count = way.particles.positions.len;
    let mut sorted_indices = resources.buffer("sorted_indices", count);
    let mut quantized_positions = resources.buffer("unsorted_quantized_positions", count);
    let mut listed_indices: Buffer<[u32; 4]> =
        resources.buffer("listed_indices", list_length(count, params.list_chunks));
    sort_index(recording, resources, settings, way, &mut sorted_indices, &mut quantized_positions);
    recording.dispatch(
        &ListNeighboursByIndex {
            positions: way.particles.positions.read(),
            quantized_positions: quantized_positions.read(),
            cell_starts: way.grid.cell_starts.read(),
            sorted_indices: sorted_indices.read(),
            listed_indices: listed_indices.write(),
            listed_counts: listed_counts.write(),
            step_state: settings.context.slots.state.uniform(),
            grid: way.grid.params.uniform(),
        },
        count,
    );
    for _ in 0..settings.iterations {
        recording.dispatch(
            &ConstrainDensityByIndex {
                quantized_positions: quantized_positions.read(),
                listed_indices: listed_indices.read(),
                listed_counts: listed_counts.read(),
                position_lambdas: way.position_lambdas.write(),
                step_state: settings.context.slots.state.uniform(),
                step_params: settings.context.step.uniform(),
                kernel: settings.kernel.uniform(),
                pbf: settings.pbf.uniform(),
            },
            count,
        );
    }
}

fn sort_index(
    recording: &mut Recording,
    resources: &mut Resources,
    settings: &Settings,
    way: &mut Way,
    sorted_indices: &mut Buffer<u32>,
    quantized_positions: &mut Buffer<[u32; 2]>,
) {
    let Way { particles, grid, .. } = way;
    let (positions, step_state) = (&particles.positions, settings.context.slots.state.uniform());
    let mut scan = Scan::declare(resources, "index", grid.cell_counts.len);
    recording.clear(&mut grid.cell_counts);
    recording.dispatch(
        &CountCells {
            variant: CountCellsVariant::default(),
            positions: positions.read(),
            cell_counts: grid.cell_counts.write(),
            cell_slots: grid.cell_slots.write(),
            step_state,
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
            quantized_positions: quantized_positions.write(),
            step_state,
            grid: grid.params.uniform(),
        },
        positions.len,
    );
}
