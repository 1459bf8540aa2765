//! `boundary/solids/`: where solids are, whom they stop and what particles know of them, against their twins.

use crate::bench::Bench;
use crate::cases::{SPACING_M, STORAGES, SUPPORT_M, kernel_params, out_of_part, quantization_of, sizes, step_state};
use crate::compare::{ROUNDING, Worst, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, ensure, ensure_eq};
use brooklet_fluid::Scene;
use brooklet_fluid::boundary::solids::solids_params;
use brooklet_fluid::scene::{field_nodes, solids};
use brooklet_kernels::{
    CollideSolids, CollideSolidsVariant, ConfineDisplacements, ConfineDisplacementsVariant, Kernel as _, Keyframe,
    MarkSolids, MoveSolids, Position, SampleSolids, Solid, SolidContact, SolidPose, SolidsParams, StepParams,
    StepState, Velocity,
};
use brooklet_reference::boundary::solids::collide::{Moving, path_among_solids};
use brooklet_reference::boundary::solids::contact::contact;
use brooklet_reference::boundary::solids::motion::{block_touches, box_around, pose_at};
use brooklet_reference::boundary::solids::shapes::BeyondPlane;
use brooklet_reference::boundary::solids::{Pose, Solid as TwinSolid};
use glam::{DQuat, DVec3, UVec3};
use rand::{Rng, RngExt};

const SIZE_M: f64 = 1.0;
pub(super) const DT_S: f32 = 1.0 / 240.0;
pub(super) const STOP_M: f64 = 0.5 * SPACING_M;

/// One solid of each kind, some of them hollow, standing and moving, two of which overlap; two are fields.
const SCENE: &str = include_str!("solids.toml");

pub(super) struct Case {
    pub(super) solids: Vec<Solid>,
    keyframes: Vec<Keyframe>,
    pub(super) fields: Vec<[f32; 2]>,
    pub(super) params: SolidsParams,
}

pub(super) fn case() -> Case {
    let scene = Scene::from_toml(SCENE, "solids", &[]).or_raise();
    let (solids, keyframes) = solids(&scene);
    let params = SolidsParams { stop_m: STOP_M as f32, reach_m: (2.0 * SUPPORT_M) as f32, ..solids_params(&scene) };
    Case { solids, keyframes, fields: field_nodes(&scene), params }
}

impl Case {
    fn keyframes_of(&self, solid: &Solid) -> &[Keyframe] {
        let first = solid.first_keyframe as usize;
        &self.keyframes[first..first + solid.keyframe_count as usize]
    }

    /// Each solid, and where it is when the substep begins and when it ends.
    pub(super) fn moving(&self, time_s: f64) -> Vec<Moving> {
        let at = |solid: &Solid, time_s: f64| pose_at(self.keyframes_of(solid), solid.period_s.into(), time_s);
        let dt_s = f64::from(DT_S);
        self.solids
            .iter()
            .map(|solid| (TwinSolid::of(solid, &self.fields), at(solid, time_s - dt_s), at(solid, time_s)))
            .collect()
    }

    fn reach_m(&self) -> f64 {
        self.params.reach_m.into()
    }

    pub(super) fn poses(&self, moving: &[Moving]) -> Vec<SolidPose> {
        let pose = |(solid, before, after): &Moving| {
            let [min_m, max_m] = box_around(solid, [*before, *after], self.reach_m());
            SolidPose {
                position_m: single(after.position_m),
                rotation: after.rotation.as_quat().to_array(),
                before_m: single(before.position_m),
                rotation_before: before.rotation.as_quat().to_array(),
                min_m: single(min_m),
                max_m: single(max_m),
                ..SolidPose::default()
            }
        };
        moving.iter().map(pose).collect()
    }

    /// The masks of all blocks.
    pub(super) fn blocks(&self, moving: &[Moving]) -> Vec<[u32; 4]> {
        let blocks = UVec3::from_array(self.params.blocks);
        let block_m = vector(self.params.block_m);
        let boxes: Vec<_> =
            moving.iter().map(|(solid, before, after)| box_around(solid, [*before, *after], self.reach_m())).collect();
        (0..blocks.element_product())
            .map(|index| {
                let block = UVec3::new(index % blocks.x, index / blocks.x % blocks.y, index / (blocks.x * blocks.y));
                let mut mask = [0; 4];
                for (s, around_m) in boxes.iter().enumerate() {
                    mask[s / 32] |= u32::from(block_touches(block, blocks, block_m, *around_m)) << (s % 32);
                }
                mask
            })
            .collect()
    }
}

pub(super) fn single(v: DVec3) -> [f32; 3] {
    v.as_vec3().to_array()
}

pub(super) fn walls() -> StepParams {
    StepParams {
        dt_s: DT_S,
        domain_size_m: [SIZE_M as f32; 3],
        wall_max_m: [SIZE_M as f32; 3],
        wall_offset_m: STOP_M as f32,
        max_speed_m_s: 6.0,
        ..StepParams::default()
    }
}

pub(super) fn confined(position_m: DVec3) -> DVec3 {
    position_m.clamp(DVec3::splat(STOP_M), DVec3::splat(SIZE_M - STOP_M))
}

/// Times before the first keyframe, between two and behind the last, and when a motion has begun again.
pub(super) const TIMES_S: [f64; 4] = [0.2, 0.75, 1.2, 20.3];

fn run_move(device: &Device, case: &Case, time_s: f64) -> Vec<SolidPose> {
    let mut bench = Bench::new(device);
    let solids = bench.input("solids", &case.solids);
    let keyframes = bench.input("keyframes", &case.keyframes);
    let mut poses = bench.output::<SolidPose>("solid_poses", case.solids.len());
    let state = StepState { time_s: time_s as f32, ..step_state(1, DT_S) };
    let state = bench.uniform("step_state", state);
    let params = bench.uniform("solids_params", case.params);
    bench.dispatch(
        &MoveSolids {
            solids: solids.read(),
            keyframes: keyframes.read(),
            solid_poses: poses.write(),
            step_state: state.uniform(),
            solids_params: params.uniform(),
        },
        case.solids.len(),
    );
    bench.run().read(&poses, case.solids.len())
}

/// Compares poses and boxes. A time in f32 is off by a rounding, more behind whole periods; a place moves at up to .6 m/s and
/// turns at 2 rad/s over an extent of .2 m, and a rotation is a normalized sum of products: some 64 roundings of a metre.
fn compare_poses(worst: &mut Worst, got: &[SolidPose], expected: &[SolidPose]) -> Result<(), crate::wrong::Wrong> {
    for (got, expected) in got.iter().zip(expected) {
        for (got, expected) in [
            (got.position_m, expected.position_m),
            (got.before_m, expected.before_m),
            (got.min_m, expected.min_m),
            (got.max_m, expected.max_m),
        ] {
            worst.check3(got, vector(expected), 1.0)?;
        }
        for (got, expected) in [(got.rotation, expected.rotation), (got.rotation_before, expected.rotation_before)] {
            let [got, expected] = [got, expected].map(|q| DQuat::from_array(q.map(f64::from)));
            // Two quaternions of opposite sign turn alike.
            let axes = DVec3::new(1.0, 2.0, -0.5);
            worst.check3(single(got * axes), expected * axes, 1.0)?;
        }
    }
    Ok(())
}

pub(crate) fn move_solids_matches_its_twin(device: &Device) {
    let case = case();
    let mut worst = device.worst(MoveSolids::STAGE, 512.0 * ROUNDING);
    for time_s in TIMES_S {
        let got = run_move(device, &case, time_s);
        // As exact as the shader is told the time.
        let expected = case.poses(&case.moving(f64::from(time_s as f32)));
        compare_poses(&mut worst, &got, &expected).or_raise();
        let mut wrong = Worst::new(MoveSolids::STAGE, 512.0 * ROUNDING);
        let later = case.poses(&case.moving(time_s + 0.001));
        ensure!(compare_poses(&mut wrong, &got, &later).is_err(), "a millisecond later");
    }
    worst.report(device);
}

pub(crate) fn mark_solids_is_exact(device: &Device) {
    let case = case();
    for time_s in TIMES_S {
        let moving = case.moving(time_s);
        let blocks = case.blocks(&moving);
        let mut bench = Bench::new(device);
        let poses = bench.input("solid_poses", &case.poses(&moving));
        let mut masks = bench.output::<[u32; 4]>("solid_blocks", blocks.len());
        let params = bench.uniform("solids_params", case.params);
        bench.dispatch(
            &MarkSolids { solid_poses: poses.read(), solid_blocks: masks.write(), solids_params: params.uniform() },
            blocks.len(),
        );
        let got = bench.run().read(&masks, blocks.len());
        ensure_eq!(got, blocks);
        let marked = blocks.iter().filter(|mask| mask[0] != 0).count();
        ensure!(marked > 20 && marked < blocks.len(), "{marked} of {} blocks", blocks.len());
    }
}

/// Where particles are that mostly have a solid near: on a shell around one of them.
pub(super) fn near_solids(rng: &mut impl Rng, count: usize, moving: &[Moving]) -> Vec<DVec3> {
    (0..count)
        .map(|i| {
            let (solid, _, pose) = &moving[i % moving.len()];
            let place_m =
                DVec3::from_array(std::array::from_fn(|_| rng.random::<f64>() * 2.0 - 1.0)) * (solid.extent_m + 0.05);
            let (distance_m, out) = solid.surface(place_m);
            let wanted_m = STOP_M + 1.5 * SUPPORT_M * rng.random::<f64>();
            confined(pose.from_frame(place_m + out * (wanted_m - distance_m)))
        })
        .collect()
}

/// A path of a random length, up to what a substep allows, and where it ends.
pub(super) fn paths(rng: &mut impl Rng, starts_m: &[DVec3], most_m: f64) -> Vec<DVec3> {
    let mut one = || rng.random::<f64>() * 2.0 - 1.0;
    starts_m.iter().map(|start_m| *start_m + DVec3::new(one(), one(), one()) * most_m / 3.0_f64.sqrt()).collect()
}

/// Whether a path ends elsewhere when it begins or ends a rounding away: one that grazes an edge, or that two solids jam.
pub(super) fn is_fickle(start_m: DVec3, end_m: DVec3, of: impl Fn(DVec3, DVec3) -> DVec3) -> bool {
    const NUDGES: [DVec3; 6] = [DVec3::X, DVec3::Y, DVec3::Z, DVec3::NEG_X, DVec3::NEG_Y, DVec3::NEG_Z];
    let at_m = of(start_m, end_m);
    NUDGES.iter().any(|nudge| {
        let nudge_m = *nudge * 1e-5;
        [of(start_m + nudge_m, end_m), of(start_m, end_m + nudge_m)]
            .into_iter()
            .any(|other_m| other_m.distance(at_m) > 0.01 * STOP_M)
    })
}

/// Shares of what particles keep from surfaces. Steps along a path begin to slide anywhere within a fiftieth of it from the
/// surface, so rounding may turn one of them a step earlier; a path on a round surface then ends as much elsewhere.
pub(super) const PATH_TOLERANCE: f64 = 0.05;

pub(crate) fn collide_solids_matches_its_twin(device: &Device) {
    let case = case();
    let mut rng = rng(191);
    let mut worst = device.worst(CollideSolids::STAGE, PATH_TOLERANCE);
    let (mut stopped, mut fickle, mut refused, mut all) = (0, 0, 0, 0);
    for size in sizes(device, CollideSolids::GROUP_SIZE[0] as usize) {
        let time_s = TIMES_S[size % TIMES_S.len()];
        let moving = case.moving(time_s);
        let starts_m = near_solids(&mut rng, size, &moving);
        let ends_m: Vec<DVec3> = paths(&mut rng, &starts_m, 6.0 / 240.0).into_iter().map(confined).collect();
        let of = |i: usize| (starts_m[i], ends_m[i]);
        let positions: Vec<Position> =
            (0..size).map(|i| Position { position_m: single(ends_m[i]), tag: i as u32 | out_of_part(i) }).collect();
        let velocities: Vec<Velocity> = (0..size)
            .map(|i| Velocity { velocity_m_s: single((ends_m[i] - starts_m[i]) / f64::from(DT_S)), age_s: 0.0 })
            .collect();
        let mut bench = Bench::new(device);
        let solids = bench.input("solids", &case.solids);
        let poses = bench.input("solid_poses", &case.poses(&moving));
        let fields = bench.input("solid_fields", &case.fields);
        let blocks = bench.input("solid_blocks", &case.blocks(&moving));
        let mut positions_buffer = bench.input("positions", &positions);
        let mut velocities_buffer = bench.input("velocities", &velocities);
        let state = bench.uniform("step_state", step_state(size, DT_S));
        let step_params = bench.uniform("step_params", walls());
        let params = bench.uniform("solids_params", case.params);
        bench.dispatch(
            &CollideSolids {
                variant: CollideSolidsVariant { bodies: false },
                solids: solids.read(),
                solid_poses: poses.read(),
                solid_fields: fields.read(),
                solid_blocks: blocks.read(),
                positions: positions_buffer.write(),
                velocities: velocities_buffer.write(),
                body_states: None,
                reactions: None,
                step_state: state.uniform(),
                step_params: step_params.uniform(),
                solids_params: params.uniform(),
            },
            size,
        );
        let mut done = bench.run();
        let got = done.read(&positions_buffer, size);
        let got_velocities = done.read(&velocities_buffer, size);
        let path = |start_m: DVec3, end_m: DVec3| path_among_solids(start_m, end_m, &moving, STOP_M, confined);
        for i in 0..size {
            let (start_m, end_m) = of(i);
            if out_of_part(i) != 0 {
                ensure_eq!(got[i].position_m, positions[i].position_m);
                continue;
            }
            all += 1;
            if is_fickle(start_m, end_m, path) {
                fickle += 1;
                continue;
            }
            let expected_m = path(start_m, end_m);
            worst.check3(got[i].position_m, expected_m, STOP_M).or_raise();
            let dt_s = f64::from(DT_S);
            let expected_m_s = (vector(velocities[i].velocity_m_s) + (expected_m - end_m) / dt_s).clamp_length_max(6.0);
            worst.check3(got_velocities[i].velocity_m_s, expected_m_s, STOP_M / dt_s).or_raise();
            let is_stopped = expected_m.distance(end_m) > 0.1 * STOP_M;
            stopped += usize::from(is_stopped);
            let mut wrong = Worst::new(CollideSolids::STAGE, PATH_TOLERANCE);
            let thicker_m = path_among_solids(start_m, end_m, &moving, 1.2 * STOP_M, confined);
            refused += usize::from(is_stopped && wrong.check3(got[i].position_m, thicker_m, STOP_M).is_err());
        }
    }
    ensure!(stopped * 20 > all && fickle * 20 < all, "{stopped} of {all} stopped, {fickle} left out");
    ensure!(5 * refused > stopped, "{refused} of {stopped} would tell a distance a fifth larger apart");
    worst.report(device);
}

/// A quantized position is off by half a step of 4 h / 2^16 at most: 3e-5 h, 1.3e-4 of what particles keep from surfaces.
pub(crate) fn confine_displacements_matches_its_twin(device: &Device) {
    let case = case();
    let mut rng = rng(192);
    let mut worst = device.worst(ConfineDisplacements::STAGE, PATH_TOLERANCE);
    let (mut stopped, mut fickle, mut all) = (0, 0, 0);
    let group = ConfineDisplacements::GROUP_SIZE[0] as usize;
    let cases = STORAGES.map(|precision| sizes(device, group).into_iter().map(move |size| (precision, size)));
    for (precision, size) in cases.into_iter().flatten() {
        let moving = case.moving(TIMES_S[size % TIMES_S.len()]);
        let standing: Vec<Moving> = moving.iter().map(|(solid, _, pose)| (solid.clone(), *pose, *pose)).collect();
        let quantization = quantization_of(precision);
        let starts_m = near_solids(&mut rng, size, &moving);
        let ends_m: Vec<DVec3> = paths(&mut rng, &starts_m, 0.9 * SUPPORT_M).into_iter().map(confined).collect();
        let sorted: Vec<Position> =
            (0..size).map(|i| Position { position_m: single(starts_m[i]), tag: i as u32 | out_of_part(i) }).collect();
        let quantized: Vec<[u32; 2]> =
            ends_m.iter().map(|end_m| quantization.quantize(single(*end_m / SUPPORT_M))).collect();
        let mut bench = Bench::new(device);
        let solids = bench.input("solids", &case.solids);
        let poses = bench.input("solid_poses", &case.poses(&moving));
        let fields = bench.input("solid_fields", &case.fields);
        let blocks = bench.input("solid_blocks", &case.blocks(&moving));
        let sorted_positions = bench.input("sorted_positions", &sorted);
        let mut quantized_positions = bench.input("quantized_positions", &quantized);
        let state = bench.uniform("step_state", step_state(size, DT_S));
        let step_params = bench.uniform("step_params", walls());
        let params = bench.uniform("solids_params", case.params);
        let kernel = bench.uniform("kernel", kernel_params());
        bench.dispatch(
            &ConfineDisplacements {
                variant: ConfineDisplacementsVariant { bodies: false, precision },
                solids: solids.read(),
                solid_poses: poses.read(),
                solid_fields: fields.read(),
                solid_blocks: blocks.read(),
                sorted_positions: sorted_positions.read(),
                quantized_positions: quantized_positions.write(),
                body_states: None,
                reactions: None,
                step_state: state.uniform(),
                step_params: step_params.uniform(),
                solids_params: params.uniform(),
                kernel: kernel.uniform(),
            },
            size,
        );
        let got = bench.run().read(&quantized_positions, size);
        let path = |start_m: DVec3, end_m: DVec3| path_among_solids(start_m, end_m, &standing, STOP_M, confined);
        for i in 0..size {
            if out_of_part(i) != 0 {
                ensure_eq!(got[i], quantized[i]);
                continue;
            }
            all += 1;
            if is_fickle(starts_m[i], ends_m[i], path) {
                fickle += 1;
                continue;
            }
            let expected_m = path(starts_m[i], ends_m[i]);
            let got_m = quantization.near(got[i], starts_m[i] / SUPPORT_M) * SUPPORT_M;
            worst.check3(single(got_m), expected_m, STOP_M).or_raise();
            stopped += usize::from(expected_m.distance(ends_m[i]) > 0.1 * STOP_M);
        }
    }
    ensure!(stopped * 20 > all && fickle * 10 < all, "{stopped} of {all} stopped, {fickle} left out");
    worst.report(device);
}

/// What a half-space says at the particle: its share and the direction in which it grows.
pub(crate) fn sample_solids_matches_its_twin(device: &Device) {
    let case = case();
    let mut rng = rng(193);
    // A distance is a difference of places of up to a metre, over h: 25 times some 16 roundings, and a share has a slope of 2.5.
    let tolerance = 1024.0 * ROUNDING;
    let mut worst = device.worst(SampleSolids::STAGE, tolerance);
    let plane = BeyondPlane::of(&kernel_params());
    let (mut felt, mut refused, mut moves) = (0, 0, 0);
    for size in sizes(device, SampleSolids::GROUP_SIZE[0] as usize) {
        let moving = case.moving(TIMES_S[size % TIMES_S.len()]);
        let standing: Vec<(TwinSolid, Pose)> = moving.iter().map(|(solid, _, pose)| (solid.clone(), *pose)).collect();
        let places_m = near_solids(&mut rng, size, &moving);
        let positions: Vec<Position> =
            (0..size).map(|i| Position { position_m: single(places_m[i]), tag: i as u32 | out_of_part(i) }).collect();
        let mut bench = Bench::new(device);
        let solids = bench.input("solids", &case.solids);
        let poses = bench.input("solid_poses", &case.poses(&moving));
        let fields = bench.input("solid_fields", &case.fields);
        let blocks = bench.input("solid_blocks", &case.blocks(&moving));
        let positions_buffer = bench.input("positions", &positions);
        let mut contacts = bench.output::<SolidContact>("solid_contacts", size);
        let state = bench.uniform("step_state", step_state(size, DT_S));
        let params = bench.uniform("solids_params", case.params);
        let kernel = bench.uniform("kernel", kernel_params());
        bench.dispatch(
            &SampleSolids {
                positions: positions_buffer.read(),
                solids: solids.read(),
                solid_poses: poses.read(),
                solid_fields: fields.read(),
                solid_blocks: blocks.read(),
                solid_contacts: contacts.write(),
                step_state: state.uniform(),
                solids_params: params.uniform(),
                kernel: kernel.uniform(),
            },
            size,
        );
        let got = bench.run().read(&contacts, size);
        for (i, got) in got.iter().enumerate() {
            let position_m = vector(positions[i].position_m);
            let expected = contact(position_m, &standing, SUPPORT_M, &plane).filter(|_| out_of_part(i) == 0);
            let Some(expected) = expected else {
                ensure!(got.normal == [0.0; 3] && got.stop_normal == [0.0; 3], "a contact with nobody");
                continue;
            };
            // As near to two of them either will do.
            let ties = expected.lead_m < 1e-5;
            if !ties {
                ensure_eq!(got.solid as usize, expected.solid);
                let distance_m = |normal: DVec3, offset_m: f64| normal.dot(position_m) - offset_m;
                let got_m = distance_m(vector(got.stop_normal), got.stop_offset_m.into());
                let expected_m = distance_m(expected.stop_normal, expected.stop_offset_m);
                worst.check((got_m / SUPPORT_M) as f32, expected_m / SUPPORT_M, 1.0).or_raise();
            }
            // A normal is a slope over its length: as uncertain as that is short.
            let steepness = expected.slope.length();
            if steepness > 2e-4 {
                felt += 1;
                worst.check3(got.normal, expected.normal, 1.0 / steepness.min(1.0)).or_raise();
                let distance = (vector(got.normal).dot(position_m) - f64::from(got.offset_m)) / SUPPORT_M;
                let (share, _) = plane.at(distance);
                if !ties {
                    // The difference of two places of up to a metre over dt: a hundred roundings.
                    let (_, before, after) = &moving[expected.solid];
                    let moved_m = position_m - before.from_frame(after.in_frame(position_m));
                    let speed_m_s = vector(got.normal).dot(moved_m) / f64::from(DT_S);
                    worst.check(got.speed_m_s, speed_m_s, 0.1 / f64::from(DT_S)).or_raise();
                    moves += usize::from(speed_m_s.abs() > 0.01);
                }
                worst.check(share as f32, expected.share, 1.0).or_raise();
                let mut wrong = Worst::new(SampleSolids::STAGE, tolerance);
                refused += usize::from(wrong.check(share as f32, 1.01 * expected.share, 1.0).is_err());
            }
        }
    }
    ensure!(felt > 100 && 3 * refused > felt, "{felt} feel a solid, {refused} of them a share a hundredth larger");
    ensure!(5 * moves > felt, "{moves} of {felt} near one that moves");
    worst.report(device);
}
