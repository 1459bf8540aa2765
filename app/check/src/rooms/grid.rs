//! `grid/` against its twins: the counting sort.

use crate::bench::{Bench, few_cases, run_scan};
use crate::cases::{
    STORAGES, SUPPORT_M, fluid, grid_params, is_wrapped, period_m, quantization_of, scattered, sizes, step_state,
};
use crate::compare::{check_counted, report_exact, slot_state, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, Wrong, ensure, ensure_eq, skip};
use brooklet_fluid::particles::id_of;
use brooklet_kernels::{
    CellSlot, CountCells, CountCellsVariant, GROUPS_PER_ROW, GridParams, KeepOrder, KeepOrderVariant, Kernel,
    OnlyKeyword, Position, PrecisionKeyword, RankById, Reorder, ReorderVariant, ScatterCellMembers, Velocity,
};
use brooklet_reference::grid::rank_by_id::rank_by_id;
use brooklet_reference::grid::reorder::{reorder, sorted_indices};
use brooklet_reference::grid::scan;
use glam::DVec3;
use rand::RngExt;

pub(crate) const FULL: PrecisionKeyword = PrecisionKeyword::Off;

pub(super) fn run_count(device: &Device, positions: &[Position], grid: GridParams) -> (Vec<u32>, Vec<CellSlot>) {
    let mut bench = Bench::new(device);
    let at = bench.input("positions", positions);
    let mut counts = bench.output("cell_counts", grid.cell_count as usize + 2);
    let mut slots = bench.output("cell_slots", positions.len());
    let params = bench.uniform("grid", grid);
    let step_state = bench.uniform("step_state", step_state(positions.len(), 0.0));
    bench.dispatch(
        &CountCells {
            variant: CountCellsVariant { wrapped: is_wrapped(&grid), periodic: period_m(&grid) != DVec3::ZERO },
            positions: at.read(),
            cell_counts: counts.write(),
            cell_slots: slots.write(),
            step_state: step_state.uniform(),
            grid: params.uniform(),
        },
        positions.len(),
    );
    let mut done = bench.run();
    (done.read(&counts, grid.cell_count as usize + 2), done.read(&slots, positions.len()))
}

pub(crate) fn check_count(device: &Device, positions: &[Position], grid: GridParams, doubt: f64) -> Result<(), Wrong> {
    let (counts, slots) = run_count(device, positions, grid);
    check_counted(positions, &counts, &slots, &grid, doubt)
}

pub(crate) fn count_cells_matches_its_twin(device: &Device) {
    let mut rng = rng(21);
    let mut cases = 0;
    for size in sizes(device, CountCells::GROUP_SIZE[0] as usize) {
        // A power of two scales exactly, so each cell is; of another size coordinates within a
        // rounding of a face may fall on either side of it.
        for (cell_m, doubt) in [(1.0 / 64.0, 0.0), (0.02, 1e-5)] {
            let size_m = DVec3::new(0.31, 0.2, 0.17);
            let positions = scattered(&mut rng, size, size_m);
            check_count(device, &positions, grid_params(size_m, cell_m), doubt).or_raise();
            cases += size;
        }
    }
    // All in one cell: every atomic meets every other.
    let positions = vec![Position { position_m: [0.1; 3], tag: 0 }; 1000];
    check_count(device, &positions, grid_params(DVec3::splat(0.3), 0.02), 0.0).or_raise();
    report_exact(device, CountCells::STAGE, cases + 1000);
}

pub(crate) fn a_dispatch_longer_than_a_row_of_groups_reaches_all(device: &Device) {
    if device.small() {
        skip("4 million elements take minutes on a driver that interprets its shaders");
    }
    let count = (GROUPS_PER_ROW * CountCells::GROUP_SIZE[0]) as usize + 65;
    let mut rng = rng(27);
    let size_m = DVec3::new(0.31, 0.2, 0.17);
    let positions = scattered(&mut rng, count, size_m);
    check_count(device, &positions, grid_params(size_m, 1.0 / 64.0), 0.0).or_raise();
}

pub(crate) fn positions_far_outside_have_no_cell(device: &Device) {
    let far = [1e9, -1e9, 1e30, -1e30, f32::MAX, 3e9, -0.0];
    let positions: Vec<Position> = far.iter().map(|&x| Position { position_m: [x, 0.1, 0.1], tag: 0 }).collect();
    let grid = grid_params(DVec3::splat(0.3), 1.0 / 64.0);
    check_count(device, &positions, grid, 0.0).or_raise();
}

pub(crate) struct Sorted {
    pub positions: Vec<Position>,
    pub velocities: Vec<Velocity>,
    pub quantized_positions: Vec<[u32; 2]>,
}

pub(super) fn run_reorder(
    device: &Device,
    positions: &[Position],
    velocities: &[Velocity],
    slots: &[CellSlot],
    starts: &[u32],
    grid: GridParams,
    precision: PrecisionKeyword,
) -> Sorted {
    run_reorders(device, positions, velocities, (slots, starts), grid, precision, &[OnlyKeyword::Off])
}

/// In as many dispatches as there are `parts`.
fn run_reorders(
    device: &Device,
    positions: &[Position],
    velocities: &[Velocity],
    (slots, starts): (&[CellSlot], &[u32]),
    grid: GridParams,
    precision: PrecisionKeyword,
    parts: &[OnlyKeyword],
) -> Sorted {
    let count = positions.len();
    let mut bench = Bench::new(device);
    let at = bench.input("positions", positions);
    let moving = bench.input("velocities", velocities);
    let slots = bench.input("cell_slots", slots);
    let starts = bench.input("cell_starts", starts);
    let mut sorted_positions = bench.output("sorted_positions", count);
    let mut sorted_velocities = bench.output("sorted_velocities", count);
    let mut quantized_positions = bench.output("quantized_positions", count);
    let params = bench.uniform("grid", grid);
    let step_state = bench.uniform("step_state", step_state(count, 0.0));
    for &only in parts {
        let (at_all, moving_at_all) = (only != OnlyKeyword::VelocitiesOnly, only != OnlyKeyword::PositionsOnly);
        bench.dispatch(
            &Reorder {
                variant: ReorderVariant { precision, only },
                positions: at_all.then(|| at.read()),
                velocities: moving_at_all.then(|| moving.read()),
                cell_slots: slots.read(),
                cell_starts: starts.read(),
                sorted_positions: at_all.then(|| sorted_positions.write()),
                sorted_velocities: moving_at_all.then(|| sorted_velocities.write()),
                quantized_positions: at_all.then(|| quantized_positions.write()),
                step_state: step_state.uniform(),
                grid: at_all.then(|| params.uniform()),
            },
            count,
        );
    }
    let mut done = bench.run();
    Sorted {
        positions: done.read(&sorted_positions, count),
        velocities: done.read(&sorted_velocities, count),
        quantized_positions: done.read(&quantized_positions, count),
    }
}

pub(crate) fn reorder_matches_its_twin(device: &Device) {
    let mut rng = rng(24);
    let mut cases = 0;
    for size in sizes(device, Reorder::GROUP_SIZE[0] as usize) {
        let case = fluid(&mut rng, size);
        let grid = grid_params(case.size_m, SUPPORT_M / 2.0);
        let cells: Vec<u32> = (0..size).map(|_| rng.random_range(0..=grid.cell_count + 1)).collect();
        let mut filled = vec![0; grid.cell_count as usize + 2];
        // Ranks from the last particle to the first: any numbering is to be obeyed.
        let mut ranks = vec![0; size];
        for i in (0..size).rev() {
            ranks[i] = filled[cells[i] as usize];
            filled[cells[i] as usize] += 1;
        }
        let starts = scan::scan(&filled);
        let slots: Vec<CellSlot> = cells.iter().zip(&ranks).map(|(&cell, &rank)| CellSlot { cell, rank }).collect();
        let sorted_indices = sorted_indices(&cells, &ranks, &starts);
        let in_two = [OnlyKeyword::VelocitiesOnly, OnlyKeyword::PositionsOnly];
        for (precision, parts) in
            STORAGES.iter().flat_map(|&precision| [(precision, &[OnlyKeyword::Off][..]), (precision, &in_two)])
        {
            let (positions, velocities) = (&case.positions, &case.velocities);
            let sorted = run_reorders(device, positions, velocities, (&slots, &starts), grid, precision, parts);
            ensure_eq!(sorted.positions, reorder(&case.positions, &sorted_indices));
            ensure_eq!(sorted.velocities, reorder(&case.velocities, &sorted_indices));
            ensure_eq!(
                sorted.quantized_positions,
                reorder(&case.quantized_positions(quantization_of(precision)), &sorted_indices)
            );
        }
        cases += size;
    }
    report_exact(device, Reorder::STAGE, cases);
}

/// Whoever stays in order is where it is, as exactly as a sort would have it.
pub(crate) fn keep_order_matches_its_twin(device: &Device) {
    let mut rng = rng(25);
    let mut cases = 0;
    for size in sizes(device, KeepOrder::GROUP_SIZE[0] as usize) {
        let case = fluid(&mut rng, size);
        for precision in STORAGES {
            let mut bench = Bench::new(device);
            let at = bench.input("positions", &case.positions);
            let moving = bench.input("velocities", &case.velocities);
            let mut sorted_positions = bench.output("sorted_positions", size);
            let mut sorted_velocities = bench.output("sorted_velocities", size);
            let mut quantized_positions = bench.output("quantized_positions", size);
            let params = bench.uniform("grid", grid_params(case.size_m, SUPPORT_M / 2.0));
            let step_state = bench.uniform("step_state", step_state(size, 0.0));
            bench.dispatch(
                &KeepOrder {
                    variant: KeepOrderVariant { precision },
                    positions: at.read(),
                    velocities: moving.read(),
                    sorted_positions: sorted_positions.write(),
                    sorted_velocities: sorted_velocities.write(),
                    quantized_positions: quantized_positions.write(),
                    step_state: step_state.uniform(),
                    grid: params.uniform(),
                },
                size,
            );
            let mut done = bench.run();
            let all: Vec<usize> = (0..size).collect();
            ensure_eq!(done.read(&sorted_positions, size), reorder(&case.positions, &all));
            ensure_eq!(done.read(&sorted_velocities, size), reorder(&case.velocities, &all));
            let quantized = reorder(&case.quantized_positions(quantization_of(precision)), &all);
            ensure_eq!(done.read(&quantized_positions, size), quantized);
        }
        cases += size;
    }
    report_exact(device, KeepOrder::STAGE, cases);
}

pub(super) fn run_rank(
    device: &Device,
    positions: &[Position],
    slots: &[CellSlot],
    starts: &[u32],
    grid: GridParams,
) -> Vec<CellSlot> {
    let mut bench = Bench::new(device);
    let at = bench.input("positions", positions);
    let mut slots = bench.input("cell_slots", slots);
    let starts = bench.input("cell_starts", starts);
    let mut members = bench.output("cell_members", positions.len());
    let params = bench.uniform("grid", grid);
    let step_state = bench.uniform("step_state", step_state(positions.len(), 0.0));
    bench.dispatch(
        &ScatterCellMembers {
            cell_slots: slots.read(),
            cell_starts: starts.read(),
            cell_members: members.write(),
            step_state: step_state.uniform(),
        },
        positions.len(),
    );
    bench.dispatch(
        &RankById {
            positions: at.read(),
            cell_starts: starts.read(),
            cell_members: members.read(),
            cell_slots: slots.write(),
            step_state: step_state.uniform(),
            grid: params.uniform(),
        },
        positions.len(),
    );
    bench.run().read(&slots, positions.len())
}

pub(crate) fn rank_members_matches_its_twin(device: &Device) {
    let mut rng = rng(28);
    let mut cases = 0;
    for size in sizes(device, RankById::GROUP_SIZE[0] as usize) {
        let size_m = DVec3::new(0.31, 0.2, 0.17);
        let mut positions = scattered(&mut rng, size, size_m);
        // Ids in no order, as they are after a sort.
        for i in (1..size).rev() {
            let other = rng.random_range(0..=i);
            let (a, b) = (positions[i].tag, positions[other].tag);
            (positions[i].tag, positions[other].tag) = (b, a);
        }
        // Cells of a fifth of the domain hold many.
        for cell_m in [0.06, 1.0 / 64.0] {
            let grid = grid_params(size_m, cell_m);
            let (counts, slots) = run_count(device, &positions, grid);
            let ranked = run_rank(device, &positions, &slots, &run_scan(device, &counts), grid);
            let cells: Vec<u32> = slots.iter().map(|slot| slot.cell).collect();
            let ids: Vec<u32> = positions.iter().map(|p| id_of(p.tag)).collect();
            let expected = rank_by_id(&cells, &ids, grid.cell_count);
            for (i, slot) in ranked.iter().enumerate() {
                ensure_eq!(slot.cell, cells[i]);
                ensure_eq!(slot.rank, expected[i].unwrap_or(slots[i].rank), "particle {i} of {size}");
            }
        }
        cases += 2 * size;
    }
    report_exact(device, ScatterCellMembers::STAGE, cases);
    report_exact(device, RankById::STAGE, cases);
}

/// The whole counting sort: counted, scanned, reordered.
pub(crate) fn sort(
    device: &Device,
    positions: &[Position],
    velocities: &[Velocity],
    grid: GridParams,
    precision: PrecisionKeyword,
) -> (Sorted, Vec<u32>) {
    let (counts, slots) = run_count(device, positions, grid);
    let starts = run_scan(device, &counts);
    (run_reorder(device, positions, velocities, &slots, &starts, grid, precision), starts)
}

pub(crate) fn sort_is_a_permutation_in_order_of_cells(device: &Device) {
    for mut rng in few_cases(device) {
        let (count, cells) = (rng.random_range(0..400), rng.random_range(1..12_u32));
        let size_m = DVec3::new(f64::from(cells), 3.0, 2.0) / 64.0;
        let positions = scattered(&mut rng, count, size_m);
        let velocities: Vec<Velocity> =
            (0..count).map(|i| Velocity { velocity_m_s: [i as f32, 0.0, 0.0], age_s: 0.0 }).collect();
        let grid = grid_params(size_m, 1.0 / 64.0);
        let (sorted, _) = sort(device, &positions, &velocities, grid, FULL);
        let mut seen = vec![false; count];
        let mut last_cell = 0;
        for (position, velocity) in sorted.positions.iter().zip(&sorted.velocities) {
            let id = id_of(position.tag) as usize;
            ensure!(!std::mem::replace(&mut seen[id], true), "particle {} twice", id);
            ensure_eq!(*position, positions[id]);
            ensure_eq!(*velocity, velocities[id]);
            let cell = brooklet_reference::grid::count_cells::cell_of_slot(
                vector(position.position_m),
                slot_state(position.tag),
                &brooklet_reference::params::Grid {
                    cells: grid.cells,
                    domain_cells: grid.domain_cells,
                    cell_size_m: 1.0 / 64.0,
                    support_m: SUPPORT_M,
                },
            );
            ensure!(cell >= last_cell, "cell {} after {}", cell, last_cell);
            last_cell = cell;
        }
    }
}
