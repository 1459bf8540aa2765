//! The neighbour grid: counting sort into cells of h/2 with full reorder, and neighbour lists.
//!
//! Cells are dense over the domain. Where it has far more of them than the fluid fills, they are wrapped onto powers of
//! two, not hashed: rows stay runs of memory, neighbours stay in order, and only the list has to tell particles a whole
//! grid apart (`grid/search_wrapped.hlsli`).
//!
//! A search looks at `MAX_CANDIDATES` at most and counts whom it cut short: 100,000 particles in one cell would be
//! 10^10 pairs.

mod list;
mod neighbour_search;
mod scan;

pub use list::{Neighbours, list_chunks, list_length, listed};
pub use neighbour_search::NeighbourSearch;
pub(crate) use scan::scan_groups;
pub use scan::{SCAN_GROUP, Scan};

use std::mem::offset_of;

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{
    Buffer, CellSlot, CountActive, CountCells, CountCellsVariant, GridParams, KeepOrder, KeepOrderVariant, Kernel,
    OnlyKeyword, Position, PrecisionKeyword, RankById, Reorder, ReorderVariant, ScatterCellMembers, SearchGroups,
    Velocity,
};

use crate::particles::buffers::Particles;
use crate::scene::{Precision, Scene};
use crate::slots::Slots;

/// Cells of the domain along each axis. Half the support wide: rows of cells then fit the support sphere so
/// closely that about half as many candidates are looked at as with cells of h.
pub fn cells(scene: &Scene) -> [u64; 3] {
    let cell_m = 0.5 * scene.support_m();
    let (size_m, period_m) = (scene.domain.size_m(), scene.period_m());
    std::array::from_fn(|axis| match scene.domain.periodic[axis] {
        // A multiple of eight: a search, which is narrower, meets no cell twice.
        true => (period_m[axis] / cell_m).round() as u64,
        false => (size_m[axis] / cell_m).ceil().max(1.0) as u64,
    })
}

/// Cells of the grid for each particle, beyond which it is wrapped: a dense fluid fills a cell with
/// each particle, so that few cells are shared by chance.
const CELLS_A_PARTICLE: u64 = 16;
/// A grid of so many cells is small however few particles there are.
const FEW_CELLS: u64 = 1 << 16;
/// Fewest cells that an axis is wrapped onto: no search meets a cell twice, and quantized positions, which repeat
/// every 4 h, repeat with it. An axis of fewer keeps them.
const LEAST_WRAPPED: u64 = 8;

/// The grid's cells in a domain of `domain_cells`, powers of two onto which they are wrapped, if a
/// cell for each would be far more than particles in so many `slots` fill.
pub fn wrapped(domain_cells: [u64; 3], slots: u32) -> Option<[u32; 3]> {
    let most = (u64::from(slots) * CELLS_A_PARTICLE).max(FEW_CELLS);
    let count = |cells: [u64; 3]| cells.iter().map(|&n| u128::from(n)).product::<u128>();
    if count(domain_cells) <= u128::from(most) {
        return None;
    }
    let mut cells = domain_cells.map(u64::next_power_of_two);
    while count(cells) > u128::from(most) {
        let longest = (0..3).max_by_key(|&axis| cells[axis]).unwrap_or(0);
        if cells[longest] <= LEAST_WRAPPED {
            break;
        }
        cells[longest] /= 2;
    }
    Some(cells.map(|n| n as u32))
}

/// What the shaders are given.
pub fn params(scene: &Scene, capacity: u32) -> GridParams {
    let domain_cells = cells(scene);
    let cells = wrapped(domain_cells, capacity).unwrap_or(domain_cells.map(|n| n as u32));
    let cell_m = 0.5 * scene.support_m();
    GridParams {
        cells,
        cell_count: cells.iter().product(),
        cell_size_m: cell_m as f32,
        inverse_cell_size_per_m: (1.0 / cell_m) as f32,
        support_m: scene.support_m() as f32,
        inverse_support_per_m: (1.0 / scene.support_m()) as f32,
        domain_cells: domain_cells.map(|n| n as u32),
        list_chunks: list_chunks(scene),
        seam_cells: std::array::from_fn(|axis| match scene.domain.periodic[axis] {
            true => domain_cells[axis] as u32,
            false => NO_SEAM,
        }),
        reserved: 0,
    }
}

/// Where the seam of an axis that is not periodic is: beyond all cells, and exact in f32.
pub const NO_SEAM: u32 = 1 << 24;

/// The grid's buffers.
pub struct Grid {
    /// Sizes and scales.
    pub params: Buffer<GridParams>,
    /// Particles a cell; the last but one counts what lies outside, the last inactive slots, so that
    /// `cell_starts` ends with the number of particles.
    pub cell_counts: Buffer<u32>,
    /// First sorted particle of each cell.
    pub cell_starts: Buffer<u32>,
    /// Where each unsorted particle goes.
    pub cell_slots: Buffer<CellSlot>,
    /// The unsorted particles of each cell, if their order is to be that of their ids.
    members: Option<Buffer<u32>>,
    scan: Scan,
    /// Whether the domain's cells are wrapped onto fewer.
    pub wrapped: bool,
    /// Whether cells on either side of the domain lie side by side.
    pub periodic: bool,
    /// Whether positions may stand where velocities stood.
    saves_memory: bool,
}

impl Grid {
    /// Declares the buffers of a grid with `params` for so many slots.
    pub fn declare(resources: &mut Resources, scene: &Scene, params: &GridParams, capacity: u32) -> Self {
        let starts = params.cell_count + 2;
        Self {
            params: resources.persistent("grid_params", 1),
            cell_counts: resources.buffer("cell_counts", starts),
            cell_starts: resources.buffer("cell_starts", starts),
            cell_slots: resources.buffer("cell_slots", capacity),
            members: scene.solver.deterministic.then(|| resources.buffer("cell_members", capacity)),
            scan: Scan::declare(resources, "cell_starts", starts),
            wrapped: params.cells != params.domain_cells,
            periodic: scene.domain.is_periodic(),
            saves_memory: resources.saves_memory(),
        }
    }

    /// Sorts `particles` by cell into `sorted`, inactive slots behind all of them.
    pub fn record_sort(
        &mut self,
        recording: &mut Recording,
        slots: &mut Slots,
        particles: &Particles,
        sorted: &mut Sorted,
    ) {
        self.record_slots(recording, slots, &particles.positions, None);
        self.record_reorder(recording, slots, particles, sorted, OnlyKeyword::Off, None);
    }

    /// The same in substeps that the GPU says; in others particles keep the order that they have.
    pub(super) fn record_sort_if_due(
        &mut self,
        recording: &mut Recording,
        slots: &mut Slots,
        particles: &Particles,
        sorted: &mut Sorted,
        due: &Buffer<SearchGroups>,
    ) {
        self.record_slots(recording, slots, &particles.positions, Some(due));
        self.record_reorder(recording, slots, particles, sorted, OnlyKeyword::Off, Some(due));
        let kernel = KeepOrder {
            variant: KeepOrderVariant { precision: sorted.precision },
            positions: particles.positions.read(),
            velocities: particles.velocities.read(),
            sorted_positions: sorted.positions.write(),
            sorted_velocities: sorted.velocities.write(),
            quantized_positions: sorted.quantized_positions.write(),
            step_state: slots.state.uniform(),
            grid: self.params.uniform(),
        };
        recording.dispatch_indirect(&kernel, due, offset_of!(SearchGroups, kept_slots) as u32, slots.capacity);
    }

    /// The same where velocities are not read until all of them are written anew: with a pass more and a buffer less, if
    /// memory is to be saved.
    pub fn record_sort_forgetting(
        &mut self,
        recording: &mut Recording,
        slots: &mut Slots,
        particles: &Particles,
        sorted: &mut Sorted,
    ) {
        if !self.saves_memory || !slots.are_all_visited() {
            return self.record_sort(recording, slots, particles, sorted);
        }
        self.record_slots(recording, slots, &particles.positions, None);
        self.record_reorder(recording, slots, particles, sorted, OnlyKeyword::VelocitiesOnly, None);
        recording.forget(&particles.velocities);
        self.record_reorder(recording, slots, particles, sorted, OnlyKeyword::PositionsOnly, None);
    }

    /// Finds where each particle goes.
    fn record_slots(
        &mut self,
        recording: &mut Recording,
        slots: &mut Slots,
        positions: &Buffer<Position>,
        due: Option<&Buffer<SearchGroups>>,
    ) {
        recording.clear(&mut self.cell_counts);
        dispatch_if_due(
            recording,
            slots,
            due,
            &CountCells {
                variant: CountCellsVariant { wrapped: self.wrapped, periodic: self.periodic },
                positions: positions.read(),
                cell_counts: self.cell_counts.write(),
                cell_slots: self.cell_slots.write(),
                step_state: slots.state.uniform(),
                grid: self.params.uniform(),
            },
        );
        self.scan.record_if_due(recording, &self.cell_counts, &mut self.cell_starts, due);
        if slots.counts_vary {
            let kernel = CountActive {
                cell_starts: self.cell_starts.read(),
                step_state: slots.state.write(),
                grid: self.params.uniform(),
            };
            recording.dispatch_groups(&kernel, [1; 3]);
        }
        if let Some(members) = &mut self.members {
            dispatch_if_due(
                recording,
                slots,
                due,
                &ScatterCellMembers {
                    cell_slots: self.cell_slots.read(),
                    cell_starts: self.cell_starts.read(),
                    cell_members: members.write(),
                    step_state: slots.state.uniform(),
                },
            );
            dispatch_if_due(
                recording,
                slots,
                due,
                &RankById {
                    positions: positions.read(),
                    cell_starts: self.cell_starts.read(),
                    cell_members: members.read(),
                    cell_slots: self.cell_slots.write(),
                    step_state: slots.state.uniform(),
                    grid: self.params.uniform(),
                },
            );
        }
    }

    /// Moves the particles there, or their velocities or positions alone.
    fn record_reorder(
        &self,
        recording: &mut Recording,
        slots: &Slots,
        particles: &Particles,
        sorted: &mut Sorted,
        only: OnlyKeyword,
        due: Option<&Buffer<SearchGroups>>,
    ) {
        let (moves_positions, moves_velocities) =
            (only != OnlyKeyword::VelocitiesOnly, only != OnlyKeyword::PositionsOnly);
        dispatch_if_due(
            recording,
            slots,
            due,
            &Reorder {
                variant: ReorderVariant { precision: sorted.precision, only },
                positions: moves_positions.then(|| particles.positions.read()),
                velocities: moves_velocities.then(|| particles.velocities.read()),
                cell_slots: self.cell_slots.read(),
                cell_starts: self.cell_starts.read(),
                sorted_positions: moves_positions.then(|| sorted.positions.write()),
                sorted_velocities: moves_velocities.then(|| sorted.velocities.write()),
                quantized_positions: moves_positions.then(|| sorted.quantized_positions.write()),
                step_state: slots.state.uniform(),
                grid: moves_positions.then(|| self.params.uniform()),
            },
        );
    }
}

/// Runs `kernel` with a thread for each slot, where the GPU says so in substeps that it says.
fn dispatch_if_due<K: Kernel>(
    recording: &mut Recording,
    slots: &Slots,
    due: Option<&Buffer<SearchGroups>>,
    kernel: &K,
) {
    match due {
        Some(due) => recording.dispatch_indirect(kernel, due, offset_of!(SearchGroups, slots) as u32, slots.capacity),
        None => slots.dispatch(recording, kernel),
    }
}

/// The particles in cell order, as they were predicted.
pub struct Sorted {
    /// Predicted positions.
    pub positions: Buffer<Position>,
    /// Predicted velocities.
    pub velocities: Buffer<Velocity>,
    /// The same positions in fixed point, for the iterations to change (`shared/quantized_position.hlsli`). Modulo
    /// 4 h, not relative to a cell: no cell is stored or compared, and the 8 bytes of three unorm16 hold 21 bits an
    /// axis.
    pub quantized_positions: Buffer<[u32; 2]>,
    /// What all kernels compute with that read `quantized_positions`: with both lower precisions they are packed, 16
    /// bits an axis.
    pub precision: PrecisionKeyword,
}

impl Sorted {
    /// Declares the buffers of `capacity` slots.
    pub fn declare(resources: &mut Resources, scene: &Scene, capacity: u32) -> Self {
        Self {
            positions: resources.buffer("sorted_positions", capacity),
            velocities: resources.buffer("sorted_velocities", capacity),
            quantized_positions: resources.buffer("quantized_positions", capacity),
            precision: match scene.solver.precision {
                Precision::Full => PrecisionKeyword::Off,
                Precision::Relaxed => PrecisionKeyword::RelaxedPrecision,
                Precision::Half => PrecisionKeyword::HalfPrecision,
            },
        }
    }
}
