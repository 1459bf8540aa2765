//! What processors' drivers do not show and a GPU may: the order of atomics, numbers too small to be normal, coordinates
//! that are rounded onto a face, dispatches that last, a device that is lost.

use std::time::Instant;

use crate::bench::run_scan;
use crate::cases::{SUPPORT_M, grid_params, list_length, scattered, step_state};
use crate::compare::check_same;
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, ensure, ensure_eq, note};
use brooklet_fluid::particles::id_of;
use brooklet_gpu::{Engine, Gpu, GpuError, GpuOptions, Plan, RecordingId, Resources};
use brooklet_kernels::{
    CellSlot, Counters, GridParams, Kernel as _, LIST_CHUNK, ListHead, ListNeighbours, ListNeighboursVariant,
    MAX_CANDIDATES, Position, ReduceGroups, SCAN_ITEMS, StepParams, Velocity,
};
use brooklet_reference::shared::quantized_position::Quantization;
use glam::DVec3;
use rand::RngExt as _;
use rand::seq::SliceRandom as _;

use super::grid::{FULL, run_count, run_rank, run_reorder};
use super::particles;

/// Atomics number the particles of a cell in an order of their own; what ranks them by their ids gives one answer.
pub(crate) fn the_order_of_atomics_changes_no_sorted_result(device: &Device) {
    let size_m = DVec3::new(0.2, 0.2, 0.2);
    let count = if device.small() { 4000 } else { 60_000 };
    let mut rng = rng(61);
    let mut positions = scattered(&mut rng, count, size_m);
    // Ids in no order, as they are after a sort.
    positions.shuffle(&mut rng);
    // Some 64 or 1,000 particles a cell: fewer than are ranked at most.
    let grid = grid_params(size_m, 0.05);
    let (counts, first) = run_count(device, &positions, grid);
    let starts = run_scan(device, &counts);
    let ranked = run_rank(device, &positions, &first, &starts, grid);
    // Another order, whatever the device does: from the last of each cell to the first.
    let reversed: Vec<CellSlot> =
        first.iter().map(|slot| CellSlot { rank: counts[slot.cell as usize] - 1 - slot.rank, ..*slot }).collect();
    let (again, second) = run_count(device, &positions, grid);
    check_same(&again, &counts).or_raise();
    let moved = first.iter().zip(&second).filter(|(a, b)| a.rank != b.rank).count();
    note!(device, "atomics: {moved} of {count} numbered otherwise by a second run");
    // Slots that are not simulated are not ranked: nobody asks for their order.
    let inside = |slots: Vec<CellSlot>| -> Vec<CellSlot> {
        slots.into_iter().filter(|slot| slot.cell < grid.cell_count).collect()
    };
    let ranked = inside(ranked);
    for other in [reversed, second] {
        check_same(&inside(run_rank(device, &positions, &other, &starts, grid)), &ranked).or_raise();
    }
    ensure!(check_same(&inside(first), &ranked).is_err(), "atomics gave the order of the ids: nothing was ranked");
}

/// f32 numbers below the least normal one: a device may take them for 0 where it computes, and keeps them where it moves.
pub(crate) fn numbers_too_small_to_be_normal_do_no_harm(device: &Device) {
    let tiny = |i: usize| {
        let bits = [1, 0x3c00, 0x0001_3c00, 0x0040_0000, 0x007f_ffff][i % 5];
        f32::from_bits(bits | if i.is_multiple_of(2) { 0 } else { 1 << 31 })
    };
    let positions: Vec<Position> =
        (0..65).map(|i| Position { position_m: [tiny(i), tiny(i + 1), 0.5], tag: i as u32 }).collect();
    let velocities: Vec<Velocity> = (0..65)
        .map(|i| Velocity { velocity_m_s: [tiny(i + 2), if i % 3 == 0 { 1.0 } else { 0.0 }, tiny(i)], age_s: tiny(i) })
        .collect();
    // Words of two halves are kept in f32 too: their bits are to stand.
    let grid = grid_params(DVec3::ONE, SUPPORT_M / 2.0);
    let slots: Vec<CellSlot> = (0..65).map(|i| CellSlot { cell: 0, rank: 64 - i }).collect();
    let mut starts = vec![65; grid.cell_count as usize + 2];
    starts[0] = 0;
    let sorted = run_reorder(device, &positions, &velocities, &slots, &starts, grid, FULL);
    let bits = |v: &Velocity| [v.velocity_m_s[0], v.velocity_m_s[1], v.velocity_m_s[2], v.age_s].map(f32::to_bits);
    let at = |p: &Position| p.position_m.map(f32::to_bits);
    let reversed = |i: usize| 64 - i;
    let expected: Vec<_> = (0..65).map(reversed).map(|i| (at(&positions[i]), bits(&velocities[i]))).collect();
    let got: Vec<_> = sorted.positions.iter().map(at).zip(sorted.velocities.iter().map(bits)).collect();
    check_same(&got, &expected).map_err(|wrong| wrong.of("reorder").named("numbers that were only moved")).or_raise();

    let params = StepParams { dt_s: 1.0, domain_size_m: [2.0; 3], max_speed_m_s: 9.0, ..StepParams::default() };
    let moved = particles::run(device, &positions, &velocities, params, false);
    let mut kept = 0;
    for (i, (position, velocity)) in moved.positions.iter().zip(&moved.velocities).enumerate() {
        for axis in 0..3 {
            let [x, v] = [positions[i].position_m[axis], velocities[i].velocity_m_s[axis]];
            let (got_x, got_v) = (position.position_m[axis], velocity.velocity_m_s[axis]);
            // Written so that a NaN is wrong.
            let near = |got: f32, exact: f32| (got - exact).abs() <= 4.0 * f32::MIN_POSITIVE;
            ensure!(near(got_x, x + v) && near(got_v, v), "particle {i}: {x} + {v} gave {got_x}, {got_v}");
            kept += usize::from(got_v == v && v.is_subnormal());
        }
    }
    note!(device, "numbers too small to be normal: {}", if kept > 0 { "kept" } else { "taken for 0" });
}

/// Coordinates within three steps of f32 of the faces between cells: products are rounded once, as the host rounds them,
/// whatever else a compiler fuses; one kernel's cell would not be another's otherwise.
pub(crate) fn coordinates_at_faces_are_rounded_as_on_the_host(device: &Device) {
    let size_m = DVec3::splat(0.62);
    let grid = grid_params(size_m, SUPPORT_M / 2.0);
    let mut rng = rng(62);
    let count = if device.small() { 1000 } else { 20_000 };
    let mut at_face = || {
        let face = rng.random_range(1..grid.cells[0]) as f32 * grid.cell_size_m;
        f32::from_bits((face.to_bits() as i32 + rng.random_range(-3..=3)) as u32)
    };
    let positions: Vec<Position> =
        (0..count).map(|i| Position { position_m: [0; 3].map(|_| at_face()), tag: i as u32 }).collect();
    let (counts, slots) = run_count(device, &positions, grid);
    let cell_of = |position: &Position| {
        let [x, y, z] = position.position_m.map(|x| (x * grid.inverse_cell_size_per_m).floor() as u32);
        (z * grid.cells[1] + y) * grid.cells[0] + x
    };
    let cells: Vec<u32> = slots.iter().map(|slot| slot.cell).collect();
    let expected: Vec<u32> = positions.iter().map(cell_of).collect();
    check_same(&cells, &expected).map_err(|wrong| wrong.of("count_cells")).or_raise();

    let starts = run_scan(device, &counts);
    let velocities = vec![Velocity::default(); count];
    let sorted = run_reorder(device, &positions, &velocities, &slots, &starts, grid, FULL);
    let quantized = |p: &Position| Quantization::Full.quantize(p.position_m.map(|x| x * grid.inverse_support_per_m));
    let expected: Vec<[u32; 2]> = sorted.positions.iter().map(quantized).collect();
    check_same(&sorted.quantized_positions, &expected).map_err(|wrong| wrong.of("reorder")).or_raise();
    let mut ids: Vec<u32> = sorted.positions.iter().map(|p| id_of(p.tag)).collect();
    ids.sort_unstable();
    ensure_eq!(ids, (0..count as u32).collect::<Vec<_>>());
}

/// A dispatch is let grow until it lasts so long, s: longer than Brooklet's longest on any device, and a quarter of the
/// time after which Windows takes a device for hung (2 s).
const LONG_S: f64 = 0.25;
/// At most so many crowds, the positions of which fit the smallest binding there is, and so many dispatches.
const MOST_CROWDS: usize = 2048;
const MOST_DISPATCHES: usize = 256;

/// Crowds of as many particles as a search looks at, each in one cell and far from the others: every particle tests all of
/// its crowd, and finds all of them near. Returns how long the device took, s.
fn run_crowds(device: &Device, crowds: usize, dispatches: usize) -> f64 {
    let size = MAX_CANDIDATES as usize;
    let count = crowds * size;
    let cell_m = SUPPORT_M / 2.0;
    let size_m = cell_m * DVec3::new(8.0 * crowds as f64, 1.0, 1.0);
    let grid = GridParams { list_chunks: 1, ..grid_params(size_m, cell_m) };
    let at = |i: usize| [(cell_m * (8.0 * (i / size) as f64 + 0.5)) as f32, 0.01, 0.01];
    let positions: Vec<Position> = (0..count).map(|i| Position { position_m: at(i), tag: i as u32 }).collect();
    let quantize = |p: &Position| Quantization::Full.quantize(p.position_m.map(|x| x * grid.inverse_support_per_m));
    let quantized: Vec<[u32; 2]> = positions.iter().map(quantize).collect();
    let starts: Vec<u32> = (0..=grid.cell_count as usize + 1).map(|cell| (cell.div_ceil(8) * size) as u32).collect();
    let mut resources = Resources::new();
    let mut init = resources.recording("init");
    let mut sorted_positions = resources.persistent("sorted_positions", count as u32);
    let mut quantized_positions = resources.persistent("quantized_positions", count as u32);
    let mut cell_starts = resources.persistent("cell_starts", starts.len() as u32);
    let mut params = resources.persistent("grid", 1);
    let mut state = resources.persistent("step_state", 1);
    init.upload(&mut sorted_positions, &positions);
    init.upload(&mut quantized_positions, &quantized);
    init.upload(&mut cell_starts, &starts);
    init.upload(&mut params, &[grid]);
    init.upload(&mut state, &[step_state(count, 0.0)]);
    let mut neighbours = resources.persistent("neighbours", list_length(count, 1) as u32);
    let mut list_heads = resources.persistent::<ListHead>("list_heads", count as u32);
    let mut counters = resources.persistent::<Counters>("counters", 1);
    let mut list = resources.recording("list");
    list.clear(&mut counters);
    for _ in 0..dispatches {
        let kernel = ListNeighbours {
            variant: ListNeighboursVariant { wrapped: false, periodic: false, precision: FULL },
            quantized_positions: quantized_positions.read(),
            sorted_positions: sorted_positions.read(),
            cell_starts: cell_starts.read(),
            neighbours: neighbours.write(),
            list_heads: list_heads.write(),
            counters: counters.write(),
            step_state: state.uniform(),
            grid: params.uniform(),
        };
        list.dispatch(&kernel, count as u32);
    }
    let ids = [init.id(), list.id()];
    let plan = Plan::sweep(resources, vec![init, list], &[list_heads.id, counters.id]).or_raise();
    let mut engine = device.engine(plan);
    engine.run(&ids[..1], &[]).or_raise();
    engine.finish().or_raise();
    let started = Instant::now();
    engine.run(&ids[1..], &[]).or_raise();
    engine.finish().or_raise();
    let wall_s = started.elapsed().as_secs_f64();
    let counted = engine.read(&counters).or_raise()[0];
    let missing = ((dispatches * count) as u32).wrapping_mul(MAX_CANDIDATES - 1 - LIST_CHUNK);
    ensure_eq!((counted.neighbour_overflow, counted.crowded), (missing, 0));
    let entries: Vec<u32> = engine.read(&list_heads).or_raise().iter().map(|head| head.entries).collect();
    check_same(&entries, &vec![LIST_CHUNK; count]).or_raise();
    wall_s
}

pub(crate) fn a_long_dispatch_is_not_cut_short(device: &Device) {
    let (mut crowds, mut dispatches) = (1, 1);
    loop {
        let wall_s = run_crowds(device, crowds, dispatches);
        let is_most = crowds == MOST_CROWDS && dispatches == MOST_DISPATCHES;
        if wall_s >= LONG_S || is_most {
            note!(
                device,
                "watchdog: {dispatches} dispatches of {crowds} groups of {MAX_CANDIDATES} particles in one submission took {wall_s:.2} s"
            );
            return;
        }
        // No more than eight times as long: a second or two at the most.
        let longer = ((1.3 * LONG_S / wall_s) as usize).clamp(2, 8);
        match crowds < MOST_CROWDS {
            true => crowds = (crowds * longer).min(MOST_CROWDS),
            false => dispatches = (dispatches * longer).min(MOST_DISPATCHES),
        }
    }
}

/// Values that a group sums.
const GROUP_ITEMS: u32 = ReduceGroups::GROUP_SIZE[0] * SCAN_ITEMS;

/// Sums of groups on `gpu`, and what runs them.
fn sums(gpu: &Gpu, device: &Device) -> (Engine, RecordingId, brooklet_kernels::Buffer<u32>) {
    let count = 4 * GROUP_ITEMS;
    let mut resources = Resources::new();
    let mut values = resources.persistent::<u32>("values", count);
    let mut group_sums = resources.persistent::<u32>("group_sums", 4);
    let mut recording = resources.recording("sums");
    recording.upload(&mut values, &vec![3; count as usize]);
    let kernel = ReduceGroups { values: values.read(), group_sums: group_sums.write() };
    recording.dispatch(&kernel, count.div_ceil(SCAN_ITEMS));
    let id = recording.id();
    let plan = device.plan(Plan::sweep(resources, vec![recording], &[group_sums.id]).or_raise());
    (Engine::new(gpu, plan).or_raise(), id, group_sums)
}

/// A second device of the same name is lost on purpose: its work ends with an error that says so, and this one goes on.
pub(crate) fn a_lost_device_is_told_and_another_goes_on(device: &Device) {
    let gpu = device.gpu();
    let options =
        GpuOptions { device_name: Some(gpu.info().name.clone()), tier: Some(gpu.tier()), ..GpuOptions::default() };
    let other = Gpu::open(&options).or_raise();
    let (mut engine, id, group_sums) = sums(&other, device);
    let runs = |engine: &mut Engine| -> Result<Vec<u32>, GpuError> {
        engine.run(&[id], &[])?;
        engine.read(&group_sums)
    };
    let expected = vec![3 * GROUP_ITEMS; 4];
    ensure_eq!(runs(&mut engine).or_raise(), expected);
    other.device().destroy();
    // What was handed over in the same instant may still be taken.
    let error = (0..10).find_map(|_| runs(&mut engine).err());
    let said = error.as_ref().map_or("nothing".to_owned(), ToString::to_string);
    ensure!(matches!(error, Some(GpuError::DeviceLost { .. })), "a lost device said: {said}");
    ensure!(other.is_lost().is_some() && gpu.is_lost().is_none(), "another device was lost");
    let (mut engine, id, group_sums) = sums(gpu, device);
    engine.run(&[id], &[]).or_raise();
    ensure_eq!(engine.read(&group_sums).or_raise(), expected);
    note!(device, "a device that was lost on purpose said: {said}");
}
