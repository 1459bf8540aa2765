//! `solver/dfsph/shift_positions` among solids, against its twin.

use super::solids::{
    DT_S, PATH_TOLERANCE, STOP_M, TIMES_S, case, confined, is_fickle, near_solids, paths, single, walls,
};
use crate::bench::Bench;
use crate::cases::{out_of_part, sizes, step_state};
use crate::compare::Worst;
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, ensure, ensure_eq};
use brooklet_kernels::{
    Counters, Kernel as _, Position, ShiftPositions, ShiftPositionsVariant, StepParams, Velocity, WallsKeyword,
};
use brooklet_reference::boundary::solids::collide::{Moving, path_among_solids};
use glam::DVec3;

/// Solids stand where they are at the substep's end; whoever is stopped ends as far from where the twin stops it as
/// `collide_solids` leaves it.
pub(crate) fn shifts_end_at_solids(device: &Device) {
    let case = case();
    let mut rng = rng(133);
    let mut worst = device.worst(ShiftPositions::STAGE, PATH_TOLERANCE);
    let (mut stopped, mut fickle, mut refused, mut all) = (0, 0, 0, 0);
    for size in sizes(device, ShiftPositions::GROUP_SIZE[0] as usize) {
        let moving = case.moving(TIMES_S[size % TIMES_S.len()]);
        let standing: Vec<Moving> = moving.iter().map(|(solid, _, pose)| (solid.clone(), *pose, *pose)).collect();
        let starts_m = near_solids(&mut rng, size, &moving);
        let ends_m: Vec<DVec3> = paths(&mut rng, &starts_m, 5.0 / 240.0);
        let positions: Vec<Position> =
            (0..size).map(|i| Position { position_m: single(starts_m[i]), tag: i as u32 | out_of_part(i) }).collect();
        let shift = |i: usize| (ends_m[i] - starts_m[i]) / f64::from(DT_S);
        let shifts: Vec<Velocity> =
            (0..size).map(|i| Velocity { velocity_m_s: single(shift(i)), age_s: 0.0 }).collect();
        let mut bench = Bench::new(device);
        let solids = bench.input("solids", &case.solids);
        let poses = bench.input("solid_poses", &case.poses(&moving));
        let fields = bench.input("solid_fields", &case.fields);
        let blocks = bench.input("solid_blocks", &case.blocks(&moving));
        let mut positions_buffer = bench.input("positions", &positions);
        let shifts_buffer = bench.input("shifts", &shifts);
        let mut counters = bench.input("counters", &[Counters::default()]);
        let state = bench.uniform("step_state", step_state(size, DT_S));
        let step_params = bench.uniform("step_params", StepParams { max_speed_m_s: 1e3, ..walls() });
        let params = bench.uniform("solids_params", case.params);
        bench.dispatch(
            &ShiftPositions {
                variant: ShiftPositionsVariant { walls: WallsKeyword::SolidWalls, periodic: false },
                positions: positions_buffer.write(),
                shifts: shifts_buffer.read(),
                counters: counters.write(),
                solids: Some(solids.read()),
                solid_poses: Some(poses.read()),
                solid_fields: Some(fields.read()),
                solid_blocks: Some(blocks.read()),
                step_state: state.uniform(),
                step_params: step_params.uniform(),
                solids_params: Some(params.uniform()),
            },
            size,
        );
        let got = bench.run().read(&positions_buffer, size);
        let path = |start_m: DVec3, end_m: DVec3| path_among_solids(start_m, end_m, &standing, STOP_M, confined);
        for i in 0..size {
            if out_of_part(i) != 0 {
                ensure_eq!(got[i].position_m, positions[i].position_m);
                continue;
            }
            all += 1;
            let (start_m, end_m) = (starts_m[i], confined(ends_m[i]));
            if is_fickle(start_m, end_m, path) {
                fickle += 1;
                continue;
            }
            let expected_m = path(start_m, end_m);
            worst.check3(got[i].position_m, expected_m, STOP_M).or_raise();
            let is_stopped = expected_m.distance(end_m) > 0.1 * STOP_M;
            stopped += usize::from(is_stopped);
            let mut wrong = Worst::new(ShiftPositions::STAGE, PATH_TOLERANCE);
            refused += usize::from(is_stopped && wrong.check3(got[i].position_m, end_m, STOP_M).is_err());
        }
    }
    ensure!(stopped * 20 > all && fickle * 20 < all, "{stopped} of {all} stopped, {fickle} left out");
    ensure!(refused == stopped, "{refused} of {stopped} would tell a path that is not stopped apart");
    worst.report(device);
}
