//! What begins, ends and is carried between the solves of `solver/dfsph/`: exact, or a few roundings off where it is added.

use super::dfsph::solve;
use crate::bench::Bench;
use crate::cases::{fluid, out_of_part, sizes, step_of, step_state};
use crate::compare::{ROUNDING, Worst, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, ensure, ensure_eq};
use brooklet_kernels::{
    ApplyGravity, BeginSolve, CarryPressure, CellSlot, Counters, EndIteration, Kernel, PressureSolve, SolveState,
};
use glam::DVec3;
use rand::RngExt;
use rand::seq::SliceRandom;

pub(crate) fn carry_pressure_and_apply_gravity_are_exact(device: &Device) {
    let mut rng = rng(98);
    let mut worst = device.worst(ApplyGravity::STAGE, 4.0 * ROUNDING);
    for size in sizes(device, CarryPressure::GROUP_SIZE[0] as usize) {
        let mut case = fluid(&mut rng, size);
        case.positions.iter_mut().enumerate().for_each(|(i, at)| at.tag = i as u32 | out_of_part(i));
        let kept: Vec<f32> = (0..size).map(|_| rng.random()).collect();
        let mut to: Vec<u32> = (0..size as u32).collect();
        to.shuffle(&mut rng);
        // Cells of two.
        let slots: Vec<CellSlot> = to.iter().map(|&to| CellSlot { cell: to / 2, rank: to % 2 }).collect();
        let starts: Vec<u32> = (0..size as u32).map(|cell| 2 * cell).collect();
        let mut bench = Bench::new(device);
        let positions = bench.input("positions", &case.positions);
        let cell_slots = bench.input("cell_slots", &slots);
        let cell_starts = bench.input("cell_starts", &starts);
        let pressures = bench.input("pressures", &kept);
        let mut carried = bench.output::<f32>("carried_pressures", size);
        let mut velocities = bench.input("velocities", &case.velocities);
        let step_state = bench.uniform("step_state", step_state(size, case.step_params().dt_s));
        let step_params = bench.uniform("step_params", case.step_params());
        let solve = bench.uniform("solve", solve());
        bench.dispatch(
            &CarryPressure {
                positions: positions.read(),
                cell_slots: cell_slots.read(),
                cell_starts: cell_starts.read(),
                pressures: pressures.read(),
                carried_pressures: carried.write(),
                step_state: step_state.uniform(),
                solve: solve.uniform(),
            },
            size,
        );
        bench.dispatch(
            &ApplyGravity {
                positions: positions.read(),
                velocities: velocities.write(),
                step_state: step_state.uniform(),
                step_params: step_params.uniform(),
            },
            size,
        );
        let mut done = bench.run();
        let mut expected = vec![0.0; size];
        (0..size).for_each(|i| expected[to[i] as usize] = if out_of_part(i) == 0 { 0.875 * kept[i] } else { 0.0 });
        ensure_eq!(done.read(&carried, size), expected);
        let step = step_of(&case.step_params(), false);
        let mut wrong = Worst::new(ApplyGravity::STAGE, 4.0 * ROUNDING);
        let mut refused = size == 0;
        for (i, got) in done.read(&velocities, size).iter().enumerate() {
            let before = vector(case.velocities[i].velocity_m_s);
            let gain = if out_of_part(i) == 0 { step.gravity_m_s2 * step.dt_s } else { DVec3::ZERO };
            worst.check3(got.velocity_m_s, before + gain, before.length() + gain.length()).or_raise();
            refused |= wrong.check3(got.velocity_m_s, before + 1.01 * gain, before.length() + gain.length()).is_err();
        }
        ensure!(refused, "one per cent more gravity");
    }
    worst.report(device);
}

pub(crate) fn solves_end_when_little_is_left_or_nothing_is_left_to_try(device: &Device) {
    for (particles, residual, done_before, least_iterations, expected) in [
        (65_usize, 0.5e-3_f32, 0_u32, 0, [0, 0, 0]),
        (1000, 2.0e-3, 3, 0, [1, 4, 0]),
        (1000, 2.0e-3, 7, 0, [0, 7, 1]),
        (1000, 0.5e-3, 7, 0, [0, 7, 0]),
        (70_001, 2.0e-3, 0, 0, [1, 1, 0]),
        // However little is left, so many.
        (1000, 0.5e-3, 2, 3, [1, 3, 0]),
        (1000, 0.5e-3, 3, 3, [0, 3, 0]),
    ] {
        for excess_share in [0.0, 1.0] {
            let groups = particles.div_ceil(64);
            // So much of each particle, in sums of groups.
            let sums: Vec<f32> = (0..groups).map(|g| residual * (particles - 64 * g).min(64) as f32).collect();
            let mut bench = Bench::new(device);
            let group_residuals = bench.input("group_residuals", &sums);
            let before = SolveState { iterations: done_before, ..SolveState::default() };
            let mut solve_state = bench.input("solve_state", &[before]);
            let mut counters = bench.input("counters", &[Counters::default()]);
            let step_state = bench.uniform("step_state", step_state(particles, 1e-3));
            let solve = bench.uniform("solve", PressureSolve { excess_share, least_iterations, ..solve() });
            if done_before == 0 {
                bench.dispatch(&BeginSolve { solve_state: solve_state.write(), step_state: step_state.uniform() }, 1);
            } else {
                let state = SolveState { groups: [groups as u32, 1, 1], ..before };
                let (_, recording) = bench.parts();
                recording.upload(&mut solve_state, &[state]);
            }
            // Once more, it has ended or not.
            bench.dispatch(
                &EndIteration {
                    group_residuals: group_residuals.read(),
                    solve_state: solve_state.write(),
                    counters: counters.write(),
                    step_state: step_state.uniform(),
                    solve: solve.uniform(),
                },
                1,
            );
            let mut done = bench.run();
            let state = done.read(&solve_state, 1)[0];
            let counters: Counters = done.read(&counters, 1)[0];
            let [goes_on, iterations, unsolved] = expected;
            let wanted = if goes_on == 1 { [groups as u32, 1, 1] } else { [0; 3] };
            ensure_eq!((state.groups, state.iterations, counters.unsolved), (wanted, iterations, unsolved));
            let counted = [counters.divergence_iterations, counters.density_iterations];
            ensure_eq!(counted, if excess_share > 0.0 { [0, goes_on] } else { [goes_on, 0] });
            let mut worst = device.worst("mean residual", 70.0 * ROUNDING);
            worst.check(state.residual, f64::from(residual), f64::from(residual)).or_raise();
            let mut wrong = Worst::new("mean residual", 70.0 * ROUNDING);
            ensure!(wrong.check(state.residual, 1.001 * f64::from(residual), f64::from(residual)).is_err());
        }
    }
}
