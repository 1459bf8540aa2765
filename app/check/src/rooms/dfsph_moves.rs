//! `solver/dfsph/shift_positions` and `particles/limit_velocity` against their twins.

use crate::bench::Bench;
use crate::cases::{fluid, out_of_part, sizes, step_of, step_state};
use crate::compare::{ROUNDING, Worst, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, ensure, ensure_eq};
use brooklet_kernels::{Counters, Kernel, LimitVelocity, ShiftPositions, ShiftPositionsVariant, StepParams, Velocity};
use brooklet_reference::solver::dfsph::substep::shift_position;
use glam::DVec3;
use rand::RngExt;

/// A position is a sum of some ten roundings of the domain's size and of the way.
pub(crate) fn shift_positions_matches_its_twin(device: &Device) {
    let mut rng = rng(131);
    let mut worst = device.worst(ShiftPositions::STAGE, 12.0 * ROUNDING);
    for (walls, periodic) in [(false, false), (true, false), (false, true)] {
        for size in sizes(device, ShiftPositions::GROUP_SIZE[0] as usize) {
            let mut case = fluid(&mut rng, size);
            case.positions.iter_mut().enumerate().for_each(|(i, at)| at.tag = i as u32 | out_of_part(i));
            // As far as a support, a third of them further than is allowed.
            let mut one = || 8.0 * rng.random::<f32>() - 4.0;
            let shifts: Vec<Velocity> =
                (0..size).map(|_| Velocity { velocity_m_s: [one(), one(), one()], age_s: 0.0 }).collect();
            let mut params = case.step_params();
            if periodic {
                params.period_m = params.domain_size_m;
                params.inverse_period_per_m = params.domain_size_m.map(|size_m| 1.0 / size_m);
            }
            let mut bench = Bench::new(device);
            let mut positions = bench.input("positions", &case.positions);
            let shifts_buffer = bench.input("shifts", &shifts);
            let mut counters = bench.input("counters", &[Counters::default()]);
            let state = bench.uniform("step_state", step_state(size, params.dt_s));
            let step_params = bench.uniform("step_params", params);
            bench.dispatch(
                &ShiftPositions {
                    variant: ShiftPositionsVariant { walls: walls.into(), periodic },
                    positions: positions.write(),
                    shifts: shifts_buffer.read(),
                    counters: counters.write(),
                    solids: None,
                    solid_poses: None,
                    solid_fields: None,
                    solid_blocks: None,
                    step_state: state.uniform(),
                    step_params: step_params.uniform(),
                    solids_params: None,
                },
                size,
            );
            let mut done = bench.run();
            let got = done.read(&positions, size);
            let mut step = step_of(&params, walls);
            step.period_m = vector(params.period_m);
            let mut wrong = Worst::new(ShiftPositions::STAGE, 12.0 * ROUNDING);
            let mut refused = size < 64;
            let mut clamps = 0;
            for (i, got) in got.iter().enumerate() {
                ensure_eq!(got.tag, case.positions[i].tag);
                let before_m = vector(case.positions[i].position_m);
                let shift_m_s = vector(shifts[i].velocity_m_s);
                let takes_part = out_of_part(i) == 0;
                clamps += u32::from(takes_part && step.slowed(shift_m_s).1);
                let expected = if takes_part { shift_position(before_m, shift_m_s, &step) } else { before_m };
                let scale_m = step.domain_size_m.length() + shift_m_s.length() * step.dt_s;
                worst.check3(got.position_m, expected, scale_m).or_raise();
                let other = shift_position(before_m, 1.01 * shift_m_s, &step);
                refused |= takes_part && wrong.check3(got.position_m, other, scale_m).is_err();
            }
            ensure_eq!(done.read(&counters, 1)[0].speed_clamps, clamps);
            ensure!(size < 64 || clamps > 10, "{clamps} slowed");
            ensure!(refused, "one per cent further");
        }
    }
    worst.report(device);
}

/// Exact where nothing is slowed; a square root, a quotient and a product else.
pub(crate) fn limit_velocity_matches_its_twin(device: &Device) {
    let mut rng = rng(132);
    let mut worst = device.worst(LimitVelocity::STAGE, 6.0 * ROUNDING);
    for size in sizes(device, LimitVelocity::GROUP_SIZE[0] as usize) {
        let mut case = fluid(&mut rng, size);
        case.positions.iter_mut().enumerate().for_each(|(i, at)| at.tag = i as u32 | out_of_part(i));
        let mut one = || 6.0 * rng.random::<f32>() - 3.0;
        case.velocities.iter_mut().for_each(|velocity| velocity.velocity_m_s = [one(), one(), one()]);
        let params: StepParams = case.step_params();
        let mut bench = Bench::new(device);
        let positions = bench.input("positions", &case.positions);
        let mut velocities = bench.input("velocities", &case.velocities);
        let mut counters = bench.input("counters", &[Counters::default()]);
        let state = bench.uniform("step_state", step_state(size, params.dt_s));
        let step_params = bench.uniform("step_params", params);
        bench.dispatch(
            &LimitVelocity {
                positions: positions.read(),
                velocities: velocities.write(),
                counters: counters.write(),
                step_state: state.uniform(),
                step_params: step_params.uniform(),
            },
            size,
        );
        // Who was slowed once is not counted again.
        bench.dispatch(
            &LimitVelocity {
                positions: positions.read(),
                velocities: velocities.write(),
                counters: counters.write(),
                step_state: state.uniform(),
                step_params: step_params.uniform(),
            },
            size,
        );
        let mut done = bench.run();
        let step = step_of(&params, false);
        let mut clamps = 0;
        for (i, got) in done.read(&velocities, size).iter().enumerate() {
            let before_m_s = vector(case.velocities[i].velocity_m_s);
            let (slowed_m_s, is_slowed) = step.slowed(before_m_s);
            let slows = is_slowed && out_of_part(i) == 0;
            clamps += u32::from(slows);
            let expected: DVec3 = if slows { slowed_m_s } else { before_m_s };
            worst.check3(got.velocity_m_s, expected, before_m_s.length()).or_raise();
            let mut wrong = Worst::new(LimitVelocity::STAGE, 6.0 * ROUNDING);
            ensure!(
                wrong.check3(got.velocity_m_s, 1.01 * expected, before_m_s.length()).is_err(),
                "faster by a hundredth"
            );
        }
        ensure_eq!(done.read(&counters, 1)[0].speed_clamps, clamps);
        ensure!(size < 64 || clamps > 10, "{clamps} slowed");
    }
    worst.report(device);
}
