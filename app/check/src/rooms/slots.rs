//! What is counted and timed on the GPU alone, against its twins: `particles/begin_substep`, `grid/count_active`,
//! `particles/activate`, `particles/deactivate`.
//!
//! Counts are exact. An activated position is one product and one sum of f32: two roundings.

use crate::bench::Bench;
use crate::cases::{INACTIVE, fluid, grid_params, out_of_part, sizes, step_state};
use crate::compare::{ROUNDING, Worst, check_exact, report_exact, vector};
use crate::device::Device;
use crate::numbers::{edge_sizes, rng};
use crate::wrong::{OrRaise as _, Wrong, ensure, ensure_eq};
use brooklet_fluid::particles::{fluid_of, id_of, is_inactive, is_quarantined};
use brooklet_fluid::{DrainBox, ParticleBlock, activate_params, deactivate_params, visit_slots};
use brooklet_kernels::{
    ActivateParticles, BeginSubstep, ClaimSlots, CountActive, Counters, DeactivateParticles, GROUPS_PER_ROW, Kernel,
    Position, StepParams, StepState, Velocity,
};
use brooklet_reference::particles::activate::{Block, activate_particles, claim_slots};
use brooklet_reference::particles::begin_substep::{self as twin, begin_substep, slot_groups};
use brooklet_reference::particles::deactivate::deactivates;
use glam::{DVec3, UVec3};
use rand::RngExt;

const GROUP: u32 = DeactivateParticles::GROUP_SIZE[0];

/// `substeps` substeps of `dt_s` from `start` on.
fn run_begin(device: &Device, start: StepState, dt_s: f32, substeps: usize) -> StepState {
    let mut bench = Bench::new(device);
    let mut state = bench.input("step_state", &[start]);
    let params = bench.uniform("step_params", StepParams { dt_s, ..StepParams::default() });
    for _ in 0..substeps {
        bench.dispatch(&BeginSubstep { step_state: state.write(), step_params: params.uniform() }, 1);
    }
    bench.run().read(&state, 1)[0]
}

fn of_twin(state: &StepState) -> twin::StepState {
    twin::StepState {
        slot_count: state.slot_count,
        active_count: state.active_count,
        dt_s: state.dt_s.into(),
        time_s: state.time_s.into(),
    }
}

pub(crate) fn begin_substep_matches_its_twin(device: &Device) {
    let many = GROUP * GROUPS_PER_ROW;
    let counts = edge_sizes(GROUP as usize).into_iter().map(|n| n as u32).chain([many - 1, many, many + 1]);
    let mut cases = 0;
    for count in counts {
        let start = StepState { active_count: count, time_s: 0.25, ..visit_slots(count / 2) };
        let got = run_begin(device, start, 0.125, 1);
        ensure_eq!(of_twin(&got), begin_substep(&of_twin(&start), 0.125), "{count} slots");
        ensure_eq!(got.slot_groups, slot_groups(count, GROUP, GROUPS_PER_ROW));
        // What the host begins with is what the GPU would.
        let begun = StepState { dt_s: 0.125, time_s: 0.375, ..visit_slots(count) };
        ensure_eq!(got, begun);
        cases += 1;
    }
    report_exact(device, BeginSubstep::STAGE, cases);
}

pub(crate) fn time_is_summed_without_losing_any(device: &Device) {
    let substeps = if device.small() { 300 } else { 20_000 };
    let dt_s = 0.001_f32;
    let got = run_begin(device, visit_slots(1), dt_s, substeps);
    let expected_s = f64::from(dt_s) * substeps as f64;
    let off = |time_s: f32| (f64::from(time_s) / expected_s - 1.0).abs();
    // A compensated sum is off by two roundings, however many terms it has (Higham 1993, eq. 3.11).
    ensure!(off(got.time_s) < 2.0 * ROUNDING, "{} s", got.time_s);
    let plain_s = (0..substeps).fold(0.0_f32, |sum_s, _| sum_s + dt_s);
    ensure!(device.small() || off(plain_s) > 20.0 * ROUNDING, "a plain sum loses more: {plain_s} s");
}

pub(crate) fn count_active_matches_its_twin(device: &Device) {
    for active in [0, 1, 63, 64, 65, 1_000_003] {
        let grid = grid_params(DVec3::splat(0.1), 1.0 / 64.0);
        let mut bench = Bench::new(device);
        let mut starts = vec![u32::MAX; grid.cell_count as usize + 2];
        starts[grid.cell_count as usize + 1] = active;
        let cell_starts = bench.input("cell_starts", &starts);
        let start = StepState { active_count: 7, time_s: 2.0, ..visit_slots(9) };
        let mut state = bench.input("step_state", &[start]);
        let params = bench.uniform("grid", grid);
        let kernel = CountActive { cell_starts: cell_starts.read(), step_state: state.write(), grid: params.uniform() };
        bench.dispatch(&kernel, 1);
        let got: StepState = bench.run().read(&state, 1)[0];
        ensure_eq!(got, StepState { active_count: active, ..start }, "and nothing else");
    }
    report_exact(device, CountActive::STAGE, 6);
}

/// `capacity` slots after a sort: `active` particles, then inactive slots with the other ids.
fn slots(active: usize, capacity: usize) -> (Vec<Position>, Vec<Velocity>) {
    let mut case = fluid(&mut rng(91), capacity);
    for (i, position) in case.positions.iter_mut().enumerate() {
        position.tag = (capacity - 1 - i) as u32 | if i < active { 0 } else { INACTIVE };
    }
    (case.positions, case.velocities)
}

struct Activated {
    positions: Vec<Position>,
    velocities: Vec<Velocity>,
    state: StepState,
    overflow: u32,
}

fn run_activate(
    device: &Device,
    positions: &[Position],
    velocities: &[Velocity],
    active: usize,
    block: &ParticleBlock,
) -> Activated {
    let capacity = positions.len();
    let mut bench = Bench::new(device);
    let mut at = bench.input("positions", positions);
    let mut moving = bench.input("velocities", velocities);
    let mut counters = bench.input("counters", &[Counters::default()]);
    let mut state = bench.input("step_state", &[step_state(active, 0.0)]);
    let params = bench.uniform("activate", activate_params(block, capacity as u32));
    bench.dispatch(
        &ActivateParticles {
            positions: at.write(),
            velocities: moving.write(),
            step_state: state.uniform(),
            activate: params.uniform(),
        },
        block.counts.iter().product::<u32>() as usize,
    );
    let claim = ClaimSlots { counters: counters.write(), claimed_state: state.write(), activate: params.uniform() };
    bench.dispatch(&claim, 1);
    let mut done = bench.run();
    Activated {
        positions: done.read(&at, capacity),
        velocities: done.read(&moving, capacity),
        state: done.read(&state, 1)[0],
        overflow: done.read(&counters, 1)[0].capacity_overflow,
    }
}

fn check_activated(got: &Activated, before: &[Position], active: u32, block: &ParticleBlock) -> Result<(), Wrong> {
    let twin = Block {
        first_m: DVec3::from_array(block.first_m),
        spacing_m: block.spacing_m,
        counts: UVec3::from_array(block.counts),
    };
    let capacity = before.len() as u32;
    let (claimed, overflow) = claim_slots(&twin, active, capacity);
    check_exact(&[got.overflow, got.state.active_count, got.state.slot_count], &[overflow, active + claimed, active])?;
    let mut worst = Worst::new(ActivateParticles::STAGE, 2.0 * ROUNDING);
    let mut others = before.to_vec();
    for (slot, expected_m) in activate_particles(&twin, active, capacity) {
        let position = got.positions[slot as usize];
        // Roundings of the largest coordinate there is: corner and block are within 4 m.
        for axis in 0..3 {
            worst.check(position.position_m[axis], expected_m[axis], 4.0)?;
        }
        let id = id_of(before[slot as usize].tag);
        check_exact(&[id_of(position.tag), fluid_of(position.tag)], &[id, block.fluid])?;
        let velocity = got.velocities[slot as usize];
        let expected = Velocity { velocity_m_s: block.velocity_m_s.map(|v| v as f32), age_s: 0.0 };
        check_exact(words(&[velocity]), words(&[expected]))?;
        others[slot as usize] = position;
    }
    check_exact(words(&got.positions), words(&others))
}

fn words<T: bytemuck::Pod>(values: &[T]) -> &[u32] {
    bytemuck::cast_slice(values)
}

pub(crate) fn activate_particles_and_claim_slots_match_their_twins(device: &Device) {
    let mut cases = 0;
    for size in sizes(device, GROUP as usize) {
        let counts = [size.min(7) as u32, size.div_ceil(7) as u32, 1];
        let count = (counts[0] * counts[1]) as usize;
        let block = ParticleBlock {
            first_m: [0.5, -1.0, 0.25],
            spacing_m: 0.01,
            counts,
            velocity_m_s: [1.0, -2.5, 0.5],
            fluid: 3,
        };
        // Room for all, for all but one, for none.
        for capacity in [count + 9, (count + 8).max(10) - 1, 9] {
            let (positions, velocities) = slots(9, capacity);
            let got = run_activate(device, &positions, &velocities, 9, &block);
            check_activated(&got, &positions, 9, &block).or_raise();
            cases += count;
        }
    }
    report_exact(device, ClaimSlots::STAGE, cases);
    let block =
        ParticleBlock { first_m: [0.0; 3], spacing_m: 0.1, counts: [2, 2, 2], velocity_m_s: [0.0; 3], fluid: 0 };
    let (positions, velocities) = slots(9, 20);
    let got = run_activate(device, &positions, &velocities, 9, &block);
    let elsewhere = ParticleBlock { spacing_m: 0.101, ..block };
    ensure!(check_activated(&got, &positions, 9, &elsewhere).is_err(), "the comparator sees another block");
    ensure!(check_activated(&got, &positions, 10, &block).is_err(), "and other slots");
}

pub(crate) fn deactivate_particles_matches_its_twin(device: &Device) {
    let mut cases = 0;
    for size in sizes(device, GROUP as usize) {
        let mut rng = rng(92);
        let mut case = fluid(&mut rng, size);
        for (i, position) in case.positions.iter_mut().enumerate() {
            position.tag |= out_of_part(i);
        }
        let min_m = DVec3::splat(0.2) * case.size_m;
        let max_m = min_m + DVec3::from_array([0; 3].map(|_| 0.3 + 0.4 * rng.random::<f64>())) * case.size_m;
        let drain = DrainBox { min_m: min_m.to_array(), max_m: max_m.to_array() };
        let params = deactivate_params(&drain);
        let mut bench = Bench::new(device);
        let mut positions = bench.input("positions", &case.positions);
        let mut velocities = bench.input("velocities", &case.velocities);
        let (state, box_params) = (bench.uniform("step_state", step_state(size, 0.0)), bench.uniform("drain", params));
        bench.dispatch(
            &DeactivateParticles {
                positions: positions.write(),
                velocities: velocities.write(),
                step_state: state.uniform(),
                deactivate: box_params.uniform(),
            },
            size,
        );
        let mut done = bench.run();
        let (after, moving) = (done.read(&positions, size), done.read(&velocities, size));
        let mut drained = 0;
        for (i, before) in case.positions.iter().enumerate() {
            let takes_part = !is_quarantined(before.tag) && !is_inactive(before.tag);
            // The box as the GPU has it, so that its faces are exact.
            let inside = deactivates(vector(before.position_m), vector(params.min_m), vector(params.max_m));
            let drains = takes_part && inside;
            ensure_eq!(after[i].position_m, before.position_m);
            ensure_eq!(after[i].tag, if drains { before.tag | INACTIVE } else { before.tag }, "particle {i} of {size}");
            ensure_eq!(moving[i], if drains { Velocity::default() } else { case.velocities[i] });
            drained += usize::from(drains);
        }
        ensure!(size < 300 || (20..size - 20).contains(&drained), "{drained} of {size}");
        cases += size;
    }
    report_exact(device, DeactivateParticles::STAGE, cases);
}
