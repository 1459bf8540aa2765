//! `grid/` against its twins: the neighbour list.

use super::grid::{FULL, Sorted, check_count, sort};
use crate::bench::{Bench, few_cases};
use crate::cases::{
    SLOTS, STORAGES, SUPPORT_M, fluid, grid_params, is_wrapped, list_length, period_m, periodic, quantization_of,
    scattered, sizes, step_state, vectors, wrapped,
};
use crate::compare::{ROUNDING, check_exact, report_exact, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, Wrong, ensure, ensure_eq};
use brooklet_fluid::grid::listed;
use brooklet_kernels::{
    Counters, GridParams, Kernel, LIST_CHUNK, LIST_ESCAPE, ListHead, ListNeighbours, ListNeighboursVariant, Position,
    PrecisionKeyword, Velocity,
};
use brooklet_reference::grid::list_neighbours::{Neighbours, check_list, list_images, list_neighbours};
use brooklet_reference::shared::list;
use glam::DVec3;
use rand::RngExt;

/// What a listing came to.
struct Listing {
    neighbours: usize,
    /// Gaps that took an entry of their own.
    escapes: usize,
    /// Neighbours without a slot.
    overflow: u32,
}

/// Lists the neighbours of sorted particles and compares with brute force.
fn check_neighbours(
    device: &Device,
    sorted: &Sorted,
    starts: &[u32],
    grid: GridParams,
    precision: PrecisionKeyword,
) -> Result<Listing, Wrong> {
    let first_outside = starts[grid.cell_count as usize] as usize;
    let support_m = f64::from(grid.support_m);
    let expected = list_neighbours(&vectors(&sorted.positions), |i| i >= first_outside, support_m);
    check_lists(device, sorted, starts, grid, precision, &expected)
}

fn check_lists(
    device: &Device,
    sorted: &Sorted,
    starts: &[u32],
    grid: GridParams,
    precision: PrecisionKeyword,
    expected: &Neighbours,
) -> Result<Listing, Wrong> {
    let count = sorted.positions.len();
    let mut bench = Bench::new(device);
    let positions = bench.input("sorted_positions", &sorted.positions);
    let quantized_positions = bench.input("quantized_positions", &sorted.quantized_positions);
    let starts_buffer = bench.input("cell_starts", starts);
    let mut neighbours = bench.output("neighbours", list_length(count, grid.list_chunks));
    let mut heads = bench.output("list_heads", count);
    let mut counters = bench.input("counters", &[Counters::default()]);
    let params = bench.uniform("grid", grid);
    let step_state = bench.uniform("step_state", step_state(count, 0.0));
    bench.dispatch(
        &ListNeighbours {
            variant: ListNeighboursVariant {
                wrapped: is_wrapped(&grid),
                periodic: period_m(&grid) != DVec3::ZERO,
                precision,
            },
            quantized_positions: quantized_positions.read(),
            sorted_positions: positions.read(),
            cell_starts: starts_buffer.read(),
            neighbours: neighbours.write(),
            list_heads: heads.write(),
            counters: counters.write(),
            step_state: step_state.uniform(),
            grid: params.uniform(),
        },
        count,
    );
    let mut done = bench.run();
    let neighbours: Vec<[u32; 2]> = done.read(&neighbours, list_length(count, grid.list_chunks));
    let heads: Vec<ListHead> = done.read(&heads, count);
    let overflow = done.read(&counters, 1)[0].neighbour_overflow;

    let positions_m = vectors(&sorted.positions);
    let support_m = f64::from(grid.support_m);
    let slots = grid.list_chunks * LIST_CHUNK;
    let entry = |i: usize, slot: usize| list::entry(i, slot, &neighbours, grid.list_chunks);
    // A distance rounds to steps of the two quantized positions, and its square in the seventh digit; one across a seam by
    // the period's own rounding.
    let period_m = period_m(&grid);
    let doubt_m =
        (2.0 * quantization_of(precision).step() + 1e-6) * support_m + 8.0 * ROUNDING * period_m.max_element();
    let (mut all, mut escapes, mut missing) = (0, 0, 0);
    for i in 0..count {
        let ListHead { entries, first } = heads[i];
        let deltas: Vec<u32> = (0..entries as usize).map(|slot| entry(i, slot)).collect();
        for slot in deltas.len()..deltas.len().next_multiple_of(LIST_CHUNK as usize) {
            check_exact(&[entry(i, slot)], &[LIST_ESCAPE])?;
        }
        let found = list::followed(first, &deltas);
        let host: Vec<usize> = listed(i as u32, heads[i], &neighbours, grid.list_chunks).map(|j| j as usize).collect();
        if host != found {
            return Err(format!("particle {i}: the host reads {host:?}, the twin {found:?}").into());
        }
        all += found.len();
        escapes += deltas.len() - found.len();
        if expected[i].len() > slots as usize {
            // Some are missing, which the counter owns up to; those listed are right.
            missing += (expected[i].len() - found.len()) as u32;
            check_exact(&[entries], &[slots])?;
            if let Some(j) = found.iter().find(|&&j| expected[i].binary_search(&j).is_err()) {
                return Err(format!("particle {i} lists {j}, which is no neighbour").into());
            }
        } else {
            check_list(i, &found, &expected[i], &positions_m, support_m, period_m, doubt_m)?;
        }
    }
    check_exact(&[overflow], &[missing])?;
    Ok(Listing { neighbours: all, escapes, overflow })
}

pub(crate) fn list_neighbours_matches_brute_force(device: &Device) {
    let mut rng = rng(25);
    let mut listed = 0;
    for size in sizes(device, ListNeighbours::GROUP_SIZE[0] as usize) {
        let case = fluid(&mut rng, size);
        let grid = grid_params(case.size_m, SUPPORT_M / 2.0);
        for precision in STORAGES {
            let (sorted, starts) = sort(device, &case.positions, &case.velocities, grid, precision);
            listed += check_neighbours(device, &sorted, &starts, grid, precision).or_raise().neighbours;
        }

        // Sparse, with some outside and quarantined, in a domain of few cells along one axis.
        let size_m = DVec3::new(0.6, 0.05, 0.13);
        let positions = scattered(&mut rng, size, size_m);
        let grid = grid_params(size_m, SUPPORT_M / 2.0);
        let (sorted, starts) = sort(device, &positions, &case.velocities, grid, FULL);
        listed += check_neighbours(device, &sorted, &starts, GridParams { list_chunks: 512, ..grid }, FULL)
            .or_raise()
            .neighbours;
    }
    report_exact(device, "list_neighbours (but for distances within two steps of h)", listed);
}

pub(crate) fn a_wrapped_grid_lists_what_a_dense_one_does(device: &Device) {
    // Case 15 of the extreme ones: blobs as many cells apart as the grid has, along one axis and
    // along all, share their cells, and quantized positions, which repeat every 8 cells, take them for near.
    let mut rng = rng(28);
    let mut compared = 0;
    for cells in [[64; 3], [8, 16, 32]] {
        let cell_m = SUPPORT_M / 2.0;
        let blob = fluid(&mut rng, 200);
        let across_m = DVec3::from_array(cells.map(f64::from)) * cell_m;
        let size_m = 2.6 * across_m;
        let mut positions = Vec::new();
        for shift in
            [[0.3, 0.3, 0.3], [1.3, 0.3, 0.3], [0.3, 1.3, 0.3], [0.3, 0.3, 1.3], [1.3, 1.3, 1.3], [2.3, 0.3, 1.3]]
        {
            let shift_m = DVec3::from_array(shift) * across_m;
            let moved = |position: &Position| vector(position.position_m) + shift_m;
            positions.extend(blob.positions.iter().map(moved));
        }
        // And some anywhere, where the grid wraps.
        positions.extend((0..600).map(|_| DVec3::new(rng.random(), rng.random(), rng.random()) * size_m));
        let positions: Vec<Position> = positions
            .iter()
            .enumerate()
            .map(|(i, at)| Position { position_m: at.to_array().map(|x| x as f32), tag: i as u32 })
            .collect();
        let velocities = vec![Velocity::default(); positions.len()];
        let grid = wrapped(grid_params(size_m, cell_m), cells);
        check_count(device, &positions, grid, 1e-5).or_raise();
        for precision in STORAGES {
            let (sorted, starts) = sort(device, &positions, &velocities, grid, precision);
            compared += check_neighbours(device, &sorted, &starts, grid, precision).or_raise().neighbours;
        }
    }
    ensure!(compared > 10_000, "{compared}");
    report_exact(device, "list_neighbours in a wrapped grid", compared);
}

pub(crate) fn periodic_lists_are_those_of_the_nearest_images(device: &Device) {
    let mut rng = rng(29);
    let mut compared = 0;
    let cells = [8, 16, 24];
    for (axes, onto) in [
        ([true, false, false], None),
        ([false, true, true], None),
        ([true; 3], None),
        ([false, false, true], Some([8, 16, 16])),
        ([true; 3], Some([8, 8, 8])),
    ] {
        let cell_m = SUPPORT_M / 2.0;
        let size_m = cell_m * DVec3::from_array(cells.map(f64::from));
        let grid = GridParams { list_chunks: 64, ..periodic(grid_params(size_m, cell_m), axes) };
        let grid = onto.map_or(grid, |onto| wrapped(grid, onto));
        // A blob around the domain's corner, so around all its seams, and as many anywhere.
        let blob = fluid(&mut rng, if device.small() { 150 } else { 400 });
        let positions: Vec<Position> = (0..2 * blob.count())
            .map(|i| {
                let middle_m = blob.size_m / 2.0;
                let mut at_m = match blob.positions.get(i) {
                    Some(position) => vector(position.position_m) - middle_m,
                    None => DVec3::new(rng.random(), rng.random(), rng.random()) * size_m,
                };
                for axis in (0..3).filter(|&axis| axes[axis]) {
                    at_m[axis] = at_m[axis].rem_euclid(size_m[axis]);
                }
                Position { position_m: at_m.to_array().map(|x| x as f32), tag: i as u32 }
            })
            .collect();
        let velocities = vec![Velocity::default(); positions.len()];
        check_count(device, &positions, grid, 1e-5).or_raise();
        for precision in STORAGES {
            let (sorted, starts) = sort(device, &positions, &velocities, grid, precision);
            let first_outside = starts[grid.cell_count as usize] as usize;
            let at_m = vectors(&sorted.positions);
            let images = list_images(&at_m, |i| i >= first_outside, SUPPORT_M, period_m(&grid));
            compared += check_lists(device, &sorted, &starts, grid, precision, &images).or_raise().neighbours;
            let open = list_neighbours(&at_m, |i| i >= first_outside, SUPPORT_M);
            ensure!(check_lists(device, &sorted, &starts, grid, precision, &open).is_err(), "without images: {axes:?}");
        }
    }
    ensure!(compared > 10_000, "{compared}");
    report_exact(device, "list_neighbours, periodic", compared);
}

pub(crate) fn neighbours_without_a_slot_are_counted(device: &Device) {
    let case = fluid(&mut rng(26), 300);
    let grid = GridParams { list_chunks: 5, ..grid_params(case.size_m, SUPPORT_M / 2.0) };
    let (sorted, starts) = sort(device, &case.positions, &case.velocities, grid, FULL);
    let overflow = check_neighbours(device, &sorted, &starts, grid, FULL).or_raise().overflow;
    ensure!(overflow > 0, "the case was meant to overflow");

    // All at one point: each sees all others.
    let positions = vec![Position { position_m: [0.1; 3], tag: 0 }; 130];
    let velocities = vec![Velocity::default(); 130];
    let grid = grid_params(DVec3::splat(0.2), SUPPORT_M / 2.0);
    let (sorted, starts) = sort(device, &positions, &velocities, grid, FULL);
    let overflow = check_neighbours(device, &sorted, &starts, grid, FULL).or_raise().overflow;
    ensure_eq!(overflow, 130 * (129 - SLOTS));
}

pub(crate) fn lists_reach_over_escapes(device: &Device) {
    // A layer of particles that see nobody, and a few above it: between one of those and what is below
    // lie so many sorted particles that the gap does not fit its 16 bits, once or twice over.
    const SIDE: usize = 400;
    let mut rng = rng(27);
    let size_m = DVec3::new(SIDE as f64, SIDE as f64, 2.0) * 1.01 * SUPPORT_M;
    let apart_m = 1.01 * SUPPORT_M;
    let mut positions: Vec<Position> = (0..SIDE * SIDE)
        .map(|i| DVec3::new((i % SIDE) as f64 + 0.5, (i / SIDE) as f64 + 0.5, 0.4) * apart_m)
        .chain((0..300).map(|_| {
            let at = DVec3::new(rng.random(), rng.random(), 0.0) * size_m;
            at.with_z((0.9 + 0.4 * rng.random::<f64>()) * apart_m)
        }))
        .enumerate()
        .map(|(i, at)| Position { position_m: at.to_array().map(|x| x as f32), tag: i as u32 })
        .collect();
    let last = positions.len() - 1;
    positions.swap(0, last);
    let velocities = vec![Velocity::default(); positions.len()];
    let grid = grid_params(size_m, SUPPORT_M / 2.0);
    let (sorted, starts) = sort(device, &positions, &velocities, grid, FULL);
    // Only pairs with one of the few can be near.
    let at_m = vectors(&sorted.positions);
    let mut expected = vec![Vec::new(); at_m.len()];
    let few = |i: usize| sorted.positions[i].tag >= (SIDE * SIDE) as u32;
    for i in (0..at_m.len()).filter(|&i| few(i)) {
        for j in (0..at_m.len()).filter(|&j| j != i && (at_m[i] - at_m[j]).length() < SUPPORT_M) {
            expected[i].push(j);
            if !few(j) {
                expected[j].push(i);
            }
        }
    }
    expected.iter_mut().for_each(|list| list.sort_unstable());
    let listing = check_lists(device, &sorted, &starts, grid, FULL, &expected).or_raise();
    ensure!(listing.neighbours > 300 && listing.escapes > 300, "{} deltas", listing.escapes);
    report_exact(device, "list_neighbours over wide deltas", listing.escapes);
    // A list that skips a wide gap is found out.
    expected[at_m.len() - 1].push(0);
    expected[at_m.len() - 1].sort_unstable();
    ensure!(check_lists(device, &sorted, &starts, grid, FULL, &expected).is_err());
}

pub(crate) fn list_equals_brute_force_anywhere(device: &Device) {
    for (round, mut rng) in few_cases(device).enumerate() {
        let count = rng.random_range(0..200);
        let cells = [24, 24, 9].map(|most| rng.random_range(1..most));
        let size_m = DVec3::from_array(cells.map(f64::from)) * (SUPPORT_M / 2.0);
        let positions = scattered(&mut rng, count, size_m);
        let velocities = vec![Velocity::default(); count];
        let grid = GridParams { list_chunks: 64, ..grid_params(size_m, SUPPORT_M / 2.0) };
        let grid = if round % 2 == 0 { grid } else { wrapped(grid, [8, 8, 8]) };
        let (sorted, starts) = sort(device, &positions, &velocities, grid, FULL);
        check_neighbours(device, &sorted, &starts, grid, FULL).or_raise();
    }
}
