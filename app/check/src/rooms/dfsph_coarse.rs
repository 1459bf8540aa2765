//! The two ends of a divergence solve's coarse correction, `solver/dfsph/coarse_pressure`, against their twins.

use super::coarse_correction::{grids, level_of, twin_of};
use super::dfsph::{random_factors, solve};
use crate::bench::Bench;
use crate::cases::{fluid, out_of_part, scattered, sizes, step_state};
use crate::compare::{ROUNDING, Worst, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, ensure, ensure_eq};
use brooklet_kernels::{CoarseCell, ProlongPressure, RestrictPressure, WallsKeyword};
use brooklet_reference::solver::pbf::coarse_correction::{prolong_multiplier, restrict_constraint};
use glam::DVec3;
use rand::RngExt;

pub(crate) fn what_is_left_over_goes_to_cells_and_pressure_comes_back(device: &Device) {
    let mut rng = rng(140);
    let mut worst = device.worst("prolong_pressure", 16.0 * ROUNDING);
    let mut taken_away = 0;
    for (finest, ends) in grids(device) {
        for count in sizes(device, 64) {
            let level = level_of(finest, ends, 0);
            let twin = twin_of(finest, ends);
            // A third of them is behind the grid.
            let size_m = twin.cell_m * DVec3::from_array(finest.map(f64::from)) * DVec3::new(1.5, 1.0, 1.0);
            let mut positions = scattered(&mut rng, count, size_m);
            positions.iter_mut().enumerate().for_each(|(i, at)| at.tag = i as u32 | out_of_part(i));
            let of = fluid(&mut rng, count);
            let (factors, twins) = random_factors(&mut rng, &of, WallsKeyword::Off);
            let pressures: Vec<f32> =
                (0..count).map(|i| if i % 3 == 0 { 0.0 } else { 0.1 * rng.random::<f32>() }).collect();
            let changes: Vec<f32> =
                pressures.iter().map(|&total| (0.2 * rng.random::<f32>() - 0.1).max(-total)).collect();
            let multipliers: Vec<f32> =
                (0..finest.iter().product::<u32>()).map(|_| 0.4 * rng.random::<f32>() - 0.2).collect();
            let mut bench = Bench::new(device);
            let position_buffer = bench.input("positions", &positions);
            let factor_buffer = bench.input("pressure_factors", &factors);
            let pressure_buffer = bench.input("pressures", &pressures);
            let multiplier_buffer = bench.input("multipliers", &multipliers);
            let mut change_buffer = bench.input("pressure_changes", &changes);
            let mut cells = bench.output::<CoarseCell>("coarse_cells", multipliers.len());
            let state = bench.uniform("step_state", step_state(count, 1e-3));
            let solve_buffer = bench.uniform("solve", solve());
            let coarse = bench.uniform("coarse", level);
            bench.dispatch(
                &RestrictPressure {
                    positions: position_buffer.read(),
                    pressure_factors: factor_buffer.read(),
                    pressure_changes: change_buffer.write(),
                    coarse_cells: cells.write(),
                    step_state: state.uniform(),
                    solve: solve_buffer.uniform(),
                    coarse: coarse.uniform(),
                },
                count,
            );
            bench.dispatch(
                &ProlongPressure {
                    positions: position_buffer.read(),
                    pressures: pressure_buffer.read(),
                    multipliers: multiplier_buffer.read(),
                    pressure_changes: change_buffer.write(),
                    step_state: state.uniform(),
                    coarse: coarse.uniform(),
                },
                count,
            );
            let mut done = bench.run();
            let got: Vec<f32> = done.read(&change_buffer, count);
            let got_cells: Vec<CoarseCell> = done.read(&cells, multipliers.len());
            let at_m = |i: usize| vector(positions[i].position_m);
            let left = |i: usize| f64::from(changes[i]) * twins[i].stiffness / f64::from(solve().step);
            let simulated = || (0..count).filter(|&i| out_of_part(i) == 0);
            let expected = restrict_constraint(&twin, simulated().map(|i| (at_m(i), left(i))));
            for (got, expected) in got_cells.iter().zip(&expected) {
                ensure_eq!(got.particles, expected.particles);
                // A quotient of some .1 rounds by less than a unit, of 1/32768.
                let difference = (f64::from(got.constraint_sum) - expected.constraint_sum).abs();
                ensure!(difference <= f64::from(got.particles), "{got:?} {expected:?}");
            }
            let wide: Vec<f64> = multipliers.iter().map(|&value| f64::from(value)).collect();
            let mut refused = count < 64;
            for i in 0..count {
                let [total, change] = [pressures[i], changes[i]].map(f64::from);
                let added = if out_of_part(i) == 0 { -prolong_multiplier(&twin, &wide, at_m(i)) } else { 0.0 };
                let of = |added: f64| if added == 0.0 { change } else { (total + change + added).max(0.0) - total };
                taken_away += usize::from(added < 0.0 && of(added) > -total);
                let scale = 1.0 + finest.iter().max().copied().map_or(0.0, f64::from) / 16.0;
                worst.check(got[i], of(added), scale).or_raise();
                let mut wrong = Worst::new("prolong_pressure", 16.0 * ROUNDING);
                refused |= added != 0.0 && wrong.check(got[i], of(1.1 * added), scale).is_err();
            }
            ensure!(refused, "a tenth more");
        }
    }
    ensure!(taken_away > 20 || device.small(), "{taken_away} have less and not nothing");
    worst.report(device);
}
