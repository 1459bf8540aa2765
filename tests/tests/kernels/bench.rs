//! The kernels that only `brooklet bench` runs, against the twins of those they are held against.

use brooklet_bench::kernels::{
    ConstrainDensityByIndex, CopyElements, CountCellsAggregated, GatherElements, ListNeighboursByIndex, MultiplyAdd,
    ReorderIndex, ScanGroupsDoubling, ScanGroupsDoublingVariant, ScanGroupsTree, ScanGroupsTreeVariant, ScanStep,
};
use brooklet_bench::rates::{GATHER_AHEAD, GATHER_ROW, GATHER_RUN, GATHER_RUNS, MULTIPLY_ADD_ROUNDS};
use brooklet_check::Wrong;
use brooklet_fluid::particles::is_simulated;
use brooklet_kernels::{Buffer, CellSlot, GridParams, Kernel, LIST_CHUNK, Position, PositionLambda, SCAN_ITEMS};
use brooklet_reference::grid::count_cells::cell_of;
use brooklet_reference::grid::list_neighbours::{check_list, list_neighbours};
use brooklet_reference::grid::reorder::{self as twin, reorder};
use brooklet_reference::grid::scan;
use brooklet_reference::params::Grid;
use brooklet_reference::shared::list;
use brooklet_reference::shared::quantized_position::Quantization;
use brooklet_reference::solver::pbf::constrain_density::constrain_density;
use brooklet_tests::cases::{
    LIST_CHUNKS, SUPPORT_M, fluid, grid_params, kernel_params, list_length, out_of_part, pbf_of, pbf_params, sizes,
    smoothing_of, step_state, vectors,
};
use brooklet_tests::compare::{ROUNDING, Worst, check_counted, check_exact, report_exact, vector};
use brooklet_tests::harness::Bench;
use brooklet_tests::rng;
use glam::DVec3;
use rand::seq::SliceRandom;
use rand::{Rng, RngExt};

#[test]
fn copy_elements_copies() {
    let device = &brooklet_tests::device();
    let mut rng = rng(61);
    let mut cases = 0;
    for size in sizes(device, CopyElements::GROUP_SIZE[0] as usize) {
        let elements: Vec<[f32; 4]> = (0..size).map(|_| [0; 4].map(|_| rng.random())).collect();
        let mut bench = Bench::new(device);
        let from = bench.input("from_elements", &elements);
        let mut to = bench.output("to_elements", size);
        bench.dispatch(&CopyElements { from_elements: from.read(), to_elements: to.write() }, size);
        assert_eq!(bench.run().read(&to, size), elements);
        cases += size;
    }
    report_exact(device, CopyElements::STAGE, cases);
}

#[test]
fn gather_elements_reads_every_run() {
    let device = &brooklet_tests::device();
    let mut rng = rng(66);
    let mut cases = 0;
    for size in sizes(device, GatherElements::GROUP_SIZE[0] as usize).into_iter().chain([20_000]) {
        let elements: Vec<[u32; 2]> = (0..size + GATHER_AHEAD as usize).map(|_| rng.random()).collect();
        let mut bench = Bench::new(device);
        let from = bench.input("from_elements", &elements);
        let mut gathered = bench.output("gathered", size);
        bench.dispatch(&GatherElements { from_elements: from.read(), gathered: gathered.write() }, size);
        let of = |i: usize| {
            let reads = (0..GATHER_RUNS).flat_map(|run| (0..GATHER_RUN).map(move |k| run * GATHER_ROW + k));
            reads.fold(0_u32, |result, ahead| {
                let [x, y] = elements[i + ahead as usize];
                result.rotate_left(1) ^ x ^ y
            })
        };
        check_exact(&bench.run().read(&gathered, size), &(0..size).map(of).collect::<Vec<_>>()).unwrap();
        cases += size;
    }
    report_exact(device, GatherElements::STAGE, cases);
}

#[test]
fn multiply_add_goes_along_eight_chains() {
    let device = &brooklet_tests::device();
    let mut rng = rng(67);
    // 128 rounds of two roundings, each shrunk by the factor (.875 at most) in the rounds behind it: 1/(1 - .875)
    // times two; then eight numbers are added.
    let mut worst = Worst::new(MultiplyAdd::STAGE, (2.0 * 8.0 + 8.0) * ROUNDING);
    for size in sizes(device, MultiplyAdd::GROUP_SIZE[0] as usize) {
        let starts: Vec<f32> = (0..size).map(|_| rng.random()).collect();
        let mut bench = Bench::new(device);
        let mut chain_sums = bench.input("chain_sums", &starts);
        bench.dispatch(&MultiplyAdd { chain_sums: chain_sums.write() }, size);
        for (got, start) in bench.run().read(&chain_sums, size).into_iter().zip(&starts) {
            let start = f64::from(*start);
            let chain = |k: i32| {
                (0..MULTIPLY_ADD_ROUNDS).fold(start + 0.125 * f64::from(k), |a, _| a * (0.75 + 0.125 * start) + start)
            };
            let expected: f64 = (0..8).map(chain).sum();
            worst.check(got, expected, expected.max(1.0)).unwrap();
        }
    }
    worst.report(device);
    assert!(Worst::new("wrong", 24.0 * ROUNDING).check(1.0001, 1.0, 1.0).is_err());
}

/// Particles along x, so that many of one cell follow each other; some outside or quarantined.
fn in_rows(rng: &mut impl Rng, count: usize, size_m: DVec3) -> Vec<Position> {
    (0..count)
        .map(|i| {
            let along = (i as f64 + rng.random::<f64>()) / count as f64;
            let beyond = if i % 11 == 3 { 1.1 } else { 1.0 };
            let place = DVec3::new(along * beyond, 0.3, 0.7) * size_m;
            let tag = i as u32 | out_of_part(i);
            Position { position_m: place.to_array().map(|x| x as f32), tag }
        })
        .collect()
}

fn check_count(positions: &[Position], grid: GridParams) -> Result<(), Wrong> {
    let device = &brooklet_tests::device();
    let mut bench = Bench::new(device);
    let at = bench.input("positions", positions);
    let mut counts = bench.output("cell_counts", grid.cell_count as usize + 2);
    let mut slots = bench.output("cell_slots", positions.len());
    let params = bench.uniform("grid", grid);
    let step_state = bench.uniform("step_state", step_state(positions.len(), 0.0));
    bench.dispatch(
        &CountCellsAggregated {
            positions: at.read(),
            cell_counts: counts.write(),
            cell_slots: slots.write(),
            step_state: step_state.uniform(),
            grid: params.uniform(),
        },
        positions.len(),
    );
    let mut done = bench.run();
    let counts = done.read(&counts, grid.cell_count as usize + 2);
    let slots: Vec<CellSlot> = done.read(&slots, positions.len());
    // Cells of a power of two: no rounding.
    check_counted(positions, &counts, &slots, &grid, 0.0)
}

#[test]
fn count_cells_aggregated_matches_the_twin_of_count_cells() {
    let device = &brooklet_tests::device();
    let mut rng = rng(62);
    let mut cases = 0;
    for size in sizes(device, CountCellsAggregated::GROUP_SIZE[0] as usize) {
        // Runs of all lengths: across groups, whole groups, and single particles.
        for size_m in [DVec3::new(0.02, 0.02, 0.02), DVec3::new(0.3, 0.2, 0.1), DVec3::new(30.0, 0.02, 0.02)] {
            check_count(&in_rows(&mut rng, size, size_m), grid_params(size_m, 1.0 / 64.0)).unwrap();
            cases += size;
        }
    }
    report_exact(device, CountCellsAggregated::STAGE, cases);
}

/// Where particles of `cells` go, as the counting sort has it, ranks from the last to the first:
/// any numbering is to be obeyed.
fn slots_of(cells: &[u32], cell_count: u32) -> (Vec<CellSlot>, Vec<u32>) {
    let mut filled = vec![0; cell_count as usize + 2];
    let mut slots = vec![CellSlot::default(); cells.len()];
    for (i, &cell) in cells.iter().enumerate().rev() {
        slots[i] = CellSlot { cell, rank: filled[cell as usize] };
        filled[cell as usize] += 1;
    }
    (slots, scan::scan(&filled))
}

/// Sorts an index of particles that are in `cells`; returns it, their quantized_positions, and the starts of
/// the cells.
fn run_reorder_index(
    positions: &[Position],
    cells: &[u32],
    grid: GridParams,
) -> (Vec<u32>, Vec<[u32; 2]>, Vec<u32>, Vec<CellSlot>) {
    let device = &brooklet_tests::device();
    let count = positions.len();
    let (slots, starts) = slots_of(cells, grid.cell_count);
    let mut bench = Bench::new(device);
    let at = bench.input("positions", positions);
    let cell_slots = bench.input("cell_slots", &slots);
    let cell_starts = bench.input("cell_starts", &starts);
    let mut sorted_indices = bench.output("sorted_indices", count);
    let mut quantized_positions = bench.output("quantized_positions", count);
    let params = bench.uniform("grid", grid);
    let step_state = bench.uniform("step_state", step_state(count, 0.0));
    bench.dispatch(
        &ReorderIndex {
            positions: at.read(),
            cell_slots: cell_slots.read(),
            cell_starts: cell_starts.read(),
            sorted_indices: sorted_indices.write(),
            quantized_positions: quantized_positions.write(),
            step_state: step_state.uniform(),
            grid: params.uniform(),
        },
        count,
    );
    let mut done = bench.run();
    (done.read(&sorted_indices, count), done.read(&quantized_positions, count), starts, slots)
}

#[test]
fn reorder_index_matches_the_twin_of_reorder() {
    let device = &brooklet_tests::device();
    let mut rng = rng(65);
    let mut cases = 0;
    for size in sizes(device, ReorderIndex::GROUP_SIZE[0] as usize) {
        let case = fluid(&mut rng, size);
        let grid = grid_params(case.size_m, SUPPORT_M / 2.0);
        let cells: Vec<u32> = (0..size).map(|_| rng.random_range(0..=grid.cell_count)).collect();
        let (indices, quantized_positions, starts, slots) = run_reorder_index(&case.positions, &cells, grid);
        let ranks: Vec<u32> = slots.iter().map(|slot| slot.rank).collect();
        let numbers: Vec<u32> = (0..size as u32).collect();
        check_exact(&indices, &reorder(&numbers, &twin::sorted_indices(&cells, &ranks, &starts))).unwrap();
        assert_eq!(quantized_positions, case.quantized_positions(Quantization::Full));
        cases += size;
    }
    report_exact(device, ReorderIndex::STAGE, cases);
}

/// Lists by index and compares with brute force over the particles where they lie.
fn check_list_by_index(positions: &[Position], size_m: DVec3) -> Result<usize, String> {
    let device = &brooklet_tests::device();
    let count = positions.len();
    let grid = GridParams { list_chunks: 32, ..grid_params(size_m, SUPPORT_M / 2.0) };
    let geometry =
        Grid { cells: grid.cells, domain_cells: grid.domain_cells, cell_size_m: SUPPORT_M / 2.0, support_m: SUPPORT_M };
    let cells: Vec<u32> = positions
        .iter()
        .map(|position| match is_simulated(position.tag) {
            true => cell_of(vector(position.position_m), &geometry),
            false => grid.cell_count,
        })
        .collect();
    let (indices, quantized_positions, starts, _) = run_reorder_index(positions, &cells, grid);
    let length = list_length(count, grid.list_chunks);
    let mut bench = Bench::new(device);
    let at = bench.input("positions", positions);
    let quantized_positions = bench.input("quantized_positions", &quantized_positions);
    let cell_starts = bench.input("cell_starts", &starts);
    let sorted_indices = bench.input("sorted_indices", &indices);
    let mut listed_indices = bench.output("listed_indices", length);
    let mut counts = bench.output("listed_counts", count);
    let params = bench.uniform("grid", grid);
    let step_state = bench.uniform("step_state", step_state(count, 0.0));
    bench.dispatch(
        &ListNeighboursByIndex {
            positions: at.read(),
            quantized_positions: quantized_positions.read(),
            cell_starts: cell_starts.read(),
            sorted_indices: sorted_indices.read(),
            listed_indices: listed_indices.write(),
            listed_counts: counts.write(),
            step_state: step_state.uniform(),
            grid: params.uniform(),
        },
        count,
    );
    let mut done = bench.run();
    let neighbours: Vec<[u32; 4]> = done.read(&listed_indices, length);
    let counts = done.read(&counts, count);
    let positions_m = vectors(positions);
    let expected = list_neighbours(&positions_m, |i| cells[i] == grid.cell_count, SUPPORT_M);
    // A distance rounds to steps of the two quantized_positions, and its square in the seventh digit.
    let doubt_m = (2.0 * Quantization::Full.step() + 1e-6) * SUPPORT_M;
    let mut listed = 0;
    for (i, expected) in expected.iter().enumerate() {
        let found: Vec<usize> = (0..counts[i] as usize)
            .map(|slot| {
                let (at, part) = list::entry_slot(i, slot, grid.list_chunks);
                neighbours[at][part] as usize
            })
            .collect();
        check_list(i, &found, expected, &positions_m, SUPPORT_M, DVec3::ZERO, doubt_m)?;
        listed += found.len();
    }
    Ok(listed)
}

#[test]
fn list_neighbours_by_index_matches_brute_force() {
    let device = &brooklet_tests::device();
    let mut rng = rng(66);
    let mut listed = 0;
    for size in sizes(device, ListNeighboursByIndex::GROUP_SIZE[0] as usize) {
        let case = fluid(&mut rng, size);
        listed += check_list_by_index(&case.positions, case.size_m).unwrap();
        // Some outside and some quarantined, in no order.
        let size_m = DVec3::splat(0.3);
        let mut positions = in_rows(&mut rng, size, size_m);
        for position in &mut positions {
            position.position_m[1] = rng.random::<f32>() * 0.3;
        }
        listed += check_list_by_index(&positions, size_m).unwrap();
    }
    report_exact(
        device,
        "list_neighbours_by_index (but for distances within the steps of quantized_positions of h)",
        listed,
    );
}

#[test]
fn constrain_density_by_index_matches_the_twin_of_constrain_density() {
    let device = &brooklet_tests::device();
    // The rounding of `constrain_density`: see `kernels_solver`.
    let mut worst = Worst::new(ConstrainDensityByIndex::STAGE, 64.0 * ROUNDING);
    let (smoothing, pbf) = (smoothing_of(&kernel_params()), pbf_of(&pbf_params()));
    let mut rng = rng(67);
    let mut compressed = 0;
    for size in sizes(device, ConstrainDensityByIndex::GROUP_SIZE[0] as usize) {
        let case = fluid(&mut rng, size);
        let mut indices = vec![[0_u32; 4]; list_length(size, LIST_CHUNKS)];
        for (i, neighbours) in case.neighbours.iter().enumerate() {
            // In no order, as they are found.
            let mut shuffled = neighbours.clone();
            shuffled.shuffle(&mut rng);
            for slot in 0..neighbours.len().next_multiple_of(LIST_CHUNK as usize) {
                let (at, part) = list::entry_slot(i, slot, LIST_CHUNKS);
                indices[at][part] = shuffled.get(slot).map_or(i, |&j| j) as u32;
            }
        }
        let counts: Vec<u32> = case.neighbours.iter().map(|list| list.len() as u32).collect();
        let mut bench = Bench::new(device);
        let start = case.quantized_positions(Quantization::Full);
        let quantized_positions = bench.input("quantized_positions", &start);
        let listed_indices = bench.input("listed_indices", &indices);
        let listed_counts = bench.input("listed_counts", &counts);
        let mut position_lambdas = bench.output::<PositionLambda>("position_lambdas", size);
        let step_params = bench.uniform("step_params", case.step_params());
        let kernel = bench.uniform("kernel", kernel_params());
        let pbf_params = bench.uniform("pbf", pbf_params());
        let step_state = bench.uniform("step_state", step_state(size, case.step_params().dt_s));
        bench.dispatch(
            &ConstrainDensityByIndex {
                quantized_positions: quantized_positions.read(),
                listed_indices: listed_indices.read(),
                listed_counts: listed_counts.read(),
                position_lambdas: position_lambdas.write(),
                step_state: step_state.uniform(),
                step_params: step_params.uniform(),
                kernel: kernel.uniform(),
                pbf: pbf_params.uniform(),
            },
            size,
        );
        let quantized_m = case.quantized_m(Quantization::Full);
        for (i, got) in bench.run().read(&position_lambdas, size).iter().enumerate() {
            let expected = constrain_density(i, &quantized_m, &case.neighbours[i], &smoothing, &pbf, None);
            compressed += usize::from(expected.lambda < 0.0);
            assert_eq!(got.quantized_position, start[i]);
            worst.check(got.lambda, expected.lambda, (1.0 + expected.constraint) / expected.denominator).unwrap();
        }
    }
    assert!(compressed > 100, "{compressed}");
    worst.report(device);
}

fn numbers(rng: &mut impl Rng, count: usize) -> Vec<u32> {
    (0..count).map(|_| rng.random()).collect()
}

fn run_step(values: &[u32], reach: u32) -> Vec<u32> {
    let device = &brooklet_tests::device();
    let mut bench = Bench::new(device);
    let input = bench.input("values", values);
    let reach = bench.input("reach", &[reach]);
    let mut scanned = bench.output("scanned", values.len());
    let kernel = ScanStep { values: input.read(), reach: reach.read(), scanned: scanned.write() };
    bench.dispatch(&kernel, values.len());
    bench.run().read(&scanned, values.len())
}

#[test]
fn scan_steps_make_the_twins_scan() {
    let device = &brooklet_tests::device();
    let mut rng = rng(63);
    let mut cases = 0;
    for size in [1, 2, 63, 64, 65, 1000] {
        let values = numbers(&mut rng, size);
        let mut steps = run_step(&values, 0);
        let mut reach = 1;
        while reach < size {
            steps = run_step(&steps, reach as u32);
            reach *= 2;
        }
        check_exact(&steps, &scan::scan(&values)).unwrap();
        cases += size;
    }
    report_exact(device, ScanStep::STAGE, cases);
}

/// Holds a way to scan groups of `group` values against the twin of the product's: `dispatch` records it, of values, the
/// groups' offsets if there are any, what is scanned, and the number of threads.
fn check_scan_groups(
    stage: &str,
    group: usize,
    seed: u64,
    dispatch: impl Fn(&mut Bench, &Buffer<u32>, Option<&Buffer<u32>>, &mut Buffer<u32>, usize),
) {
    let device = &brooklet_tests::device();
    let mut rng = rng(seed);
    let mut cases = 0;
    for size in [1, 3, 4, 5, group - 1, group, group + 1, 7 * group + 333] {
        let values = numbers(&mut rng, size);
        let offsets = numbers(&mut rng, size.div_ceil(group));
        for with_offsets in [false, true] {
            let mut bench = Bench::new(device);
            let input = bench.input("values", &values);
            let before = bench.input("group_offsets", &offsets);
            let mut scanned = bench.output("scanned", size);
            let threads = size.div_ceil(SCAN_ITEMS as usize);
            dispatch(&mut bench, &input, with_offsets.then_some(&before), &mut scanned, threads);
            let expected = scan::scan_groups(&values, group, with_offsets.then_some(&offsets[..]));
            check_exact(&bench.run().read(&scanned, size), &expected).unwrap();
            cases += size;
        }
    }
    report_exact(device, stage, cases);
}

#[test]
fn scan_groups_tree_matches_the_twin_of_scan_groups() {
    let group = (ScanGroupsTree::GROUP_SIZE[0] * SCAN_ITEMS) as usize;
    for padded in [false, true] {
        check_scan_groups(ScanGroupsTree::STAGE, group, 64, |bench, values, offsets, scanned, threads| {
            let variant = ScanGroupsTreeVariant { group_offsets: offsets.is_some(), padded };
            let group_offsets = offsets.map(Buffer::read);
            let kernel = ScanGroupsTree { variant, values: values.read(), group_offsets, scanned: scanned.write() };
            bench.dispatch(&kernel, threads);
        });
    }
}

#[test]
fn scan_groups_doubling_matches_the_twin_of_scan_groups() {
    let group = (ScanGroupsDoubling::GROUP_SIZE[0] * SCAN_ITEMS) as usize;
    check_scan_groups(ScanGroupsDoubling::STAGE, group, 65, |bench, values, offsets, scanned, threads| {
        let variant = ScanGroupsDoublingVariant { group_offsets: offsets.is_some() };
        let group_offsets = offsets.map(Buffer::read);
        let kernel = ScanGroupsDoubling { variant, values: values.read(), group_offsets, scanned: scanned.write() };
        bench.dispatch(&kernel, threads);
    });
}
