//! What stops paths gives to bodies what it takes of particles: `collide_solids` and `confine_displacements` with bodies.

use super::bodies::sums_of;
use super::solids::{Case, DT_S, STOP_M, TIMES_S, case, is_fickle, near_solids, paths, single, walls};
use crate::bench::{Bench, Done};
use crate::cases::{SUPPORT_M, kernel_params, sizes, step_state};
use crate::compare::{Worst, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, ensure};
use brooklet_kernels::{
    BodyState, Buffer, CollideSolids, CollideSolidsVariant, ConfineDisplacements, ConfineDisplacementsVariant,
    Kernel as _, Position, PrecisionKeyword, QUARANTINED, REACTION_WORDS, Solid, SolidPose, SolidsParams, StepParams,
    StepState, Velocity,
};
use brooklet_reference::boundary::solids::collide::{Moving, path_among_solids};
use brooklet_reference::shared::quantized_position::Quantization;
use glam::DVec3;

/// Impulses are rounded to one unit a push, and the particle's own path to some roundings of a metre.
const TOLERANCE: f64 = 2e-3;
const UNITS_PER_M_S: f32 = 1e6;
/// A later push moves the arm of an earlier one by less than this share of it.
const ARM: f64 = 0.1;

/// Particles' paths, nowhere at a wall. Of a jammed particle, which stays where it was, bodies feel what they first gave it:
/// it takes no part, nor does one that a rounding would jam.
struct Paths {
    starts_m: Vec<DVec3>,
    ends_m: Vec<DVec3>,
    tags: Vec<u32>,
    moving: Vec<Moving>,
}

fn free_paths(rng: &mut impl rand::Rng, size: usize, most_m: f64, stands: bool) -> (Case, Paths) {
    let case = case();
    let moved = case.moving(TIMES_S[size % TIMES_S.len()]);
    let moving: Vec<Moving> = match stands {
        true => moved.iter().map(|(solid, _, pose)| (solid.clone(), *pose, *pose)).collect(),
        false => moved,
    };
    let starts_m = near_solids(rng, size, &moving);
    let ends_m = paths(rng, &starts_m, most_m);
    let path = |start_m: DVec3, end_m: DVec3| path_among_solids(start_m, end_m, &moving, STOP_M, |at_m| at_m);
    let tags = starts_m
        .iter()
        .zip(&ends_m)
        .enumerate()
        .map(|(i, (&start_m, &end_m))| {
            let jams = path(start_m, end_m).distance(start_m) < 1e-4 || is_fickle(start_m, end_m, path);
            i as u32 | if jams { QUARANTINED } else { 0 }
        })
        .collect();
    (case, Paths { starts_m, ends_m, tags, moving })
}

/// What both stages are given: all solids are bodies, whose centres of mass are where their frames are.
struct Among {
    solids: Buffer<Solid>,
    poses: Buffer<SolidPose>,
    fields: Buffer<[f32; 2]>,
    blocks: Buffer<[u32; 4]>,
    states: Vec<BodyState>,
    body_states: Buffer<BodyState>,
    reactions: Buffer<u32>,
    state: Buffer<StepState>,
    step: Buffer<StepParams>,
    params: Buffer<SolidsParams>,
}

fn among(bench: &mut Bench, case: &Case, moving: &[Moving], size: usize) -> Among {
    let solids: Vec<Solid> =
        case.solids.iter().enumerate().map(|(s, solid)| Solid { body: s as u32, ..*solid }).collect();
    let poses = case.poses(moving);
    let states: Vec<BodyState> =
        poses.iter().map(|pose| BodyState { position_m: pose.position_m, ..BodyState::default() }).collect();
    Among {
        solids: bench.input("solids", &solids),
        poses: bench.input("solid_poses", &poses),
        fields: bench.input("solid_fields", &case.fields),
        blocks: bench.input("solid_blocks", &case.blocks(moving)),
        body_states: bench.input("body_states", &states),
        reactions: bench.input("reactions", &vec![0_u32; states.len() * REACTION_WORDS as usize]),
        states,
        state: bench.uniform("step_state", step_state(size, DT_S)),
        step: bench.uniform("step_params", open()),
        params: bench.uniform("solids_params", SolidsParams { units_per_m_s: UNITS_PER_M_S, ..case.params }),
    }
}

impl Among {
    /// Impulse and moment about the domain's corner of all bodies, in m/s of a particle.
    fn given(&self, done: &mut Done) -> (DVec3, DVec3) {
        let words = done.read(&self.reactions, self.states.len() * REACTION_WORDS as usize);
        let (mut impulse, mut moment) = (DVec3::ZERO, DVec3::ZERO);
        for (words, state) in words.chunks_exact(REACTION_WORDS as usize).zip(&self.states) {
            let (sums, _) = sums_of(words);
            let three =
                |at: usize| DVec3::from_array(std::array::from_fn(|k| sums[at + k] as f64 / f64::from(UNITS_PER_M_S)));
            impulse += three(0);
            moment += three(3) + vector(state.position_m).cross(three(0));
        }
        (impulse, moment)
    }
}

/// That bodies have got what particles lost: changes of velocity, and where.
fn check(worst: &mut Worst, got: (DVec3, DVec3), taken_m_s: &[(DVec3, DVec3)]) -> bool {
    let lost: DVec3 = taken_m_s.iter().map(|(taken, _)| -*taken).sum();
    let turned: DVec3 = taken_m_s.iter().map(|(taken, at_m)| -at_m.cross(*taken)).sum();
    let all: f64 = taken_m_s.iter().map(|(taken, _)| taken.length()).sum::<f64>() + 1e-3;
    let arms: f64 = taken_m_s.iter().map(|(taken, at_m)| taken.length() * at_m.length()).sum::<f64>() + 1e-3;
    worst.check3(single(got.0), lost, all).or_raise();
    ensure!(got.1.distance(turned) < ARM * arms, "{} and {turned} of {arms}", got.1);
    let mut other = Worst::new("another impulse", TOLERANCE);
    other.check3(single(got.0), 1.05 * lost, all).is_err()
}

pub(crate) fn bodies_take_back_what_stops_paths(device: &Device) {
    let mut rng = rng(224);
    let mut worst = device.worst(CollideSolids::STAGE, TOLERANCE);
    let mut refused = 0;
    for size in sizes(device, CollideSolids::GROUP_SIZE[0] as usize) {
        let (case, Paths { starts_m, ends_m, tags, moving }) = free_paths(&mut rng, size, 6.0 / 240.0, false);
        let positions: Vec<Position> =
            (0..size).map(|i| Position { position_m: single(ends_m[i]), tag: tags[i] }).collect();
        let velocities: Vec<Velocity> = (0..size)
            .map(|i| Velocity { velocity_m_s: single((ends_m[i] - starts_m[i]) / f64::from(DT_S)), age_s: 0.0 })
            .collect();
        let mut bench = Bench::new(device);
        let mut among = among(&mut bench, &case, &moving, size);
        let mut position_buffer = bench.input("positions", &positions);
        let mut velocity_buffer = bench.input("velocities", &velocities);
        bench.dispatch(
            &CollideSolids {
                variant: CollideSolidsVariant { bodies: true },
                solids: among.solids.read(),
                solid_poses: among.poses.read(),
                solid_fields: among.fields.read(),
                solid_blocks: among.blocks.read(),
                positions: position_buffer.write(),
                velocities: velocity_buffer.write(),
                body_states: Some(among.body_states.read()),
                reactions: Some(among.reactions.write()),
                step_state: among.state.uniform(),
                step_params: among.step.uniform(),
                solids_params: among.params.uniform(),
            },
            size,
        );
        let mut done = bench.run();
        let got = done.read(&position_buffer, size);
        let taken: Vec<(DVec3, DVec3)> = got
            .iter()
            .zip(&positions)
            .map(|(got, was)| (vector(got.position_m), vector(got.position_m) - vector(was.position_m)))
            .map(|(at_m, moved_m)| (moved_m / f64::from(DT_S), at_m))
            .collect();
        refused += usize::from(check(&mut worst, among.given(&mut done), &taken));
    }
    ensure!(refused > 1, "{refused} sums would tell a twentieth more apart");
    worst.report(device);
}

pub(crate) fn bodies_take_back_what_confines_displacements(device: &Device) {
    let mut rng = rng(225);
    // A quantized position is off by half a step of 4 h / 2^16.
    let mut worst = device.worst(ConfineDisplacements::STAGE, 5.0 * TOLERANCE);
    let mut refused = 0;
    for size in sizes(device, ConfineDisplacements::GROUP_SIZE[0] as usize) {
        let (case, Paths { starts_m, ends_m, tags, moving }) = free_paths(&mut rng, size, 0.5 * SUPPORT_M, true);
        let sorted: Vec<Position> =
            (0..size).map(|i| Position { position_m: single(starts_m[i]), tag: tags[i] }).collect();
        let quantized: Vec<[u32; 2]> =
            ends_m.iter().map(|end_m| Quantization::Full.quantize(single(*end_m / SUPPORT_M))).collect();
        let mut bench = Bench::new(device);
        let mut among = among(&mut bench, &case, &moving, size);
        let sorted_positions = bench.input("sorted_positions", &sorted);
        let mut quantized_positions = bench.input("quantized_positions", &quantized);
        let kernel = bench.uniform("kernel", kernel_params());
        bench.dispatch(
            &ConfineDisplacements {
                variant: ConfineDisplacementsVariant { bodies: true, precision: PrecisionKeyword::default() },
                solids: among.solids.read(),
                solid_poses: among.poses.read(),
                solid_fields: among.fields.read(),
                solid_blocks: among.blocks.read(),
                sorted_positions: sorted_positions.read(),
                quantized_positions: quantized_positions.write(),
                body_states: Some(among.body_states.read()),
                reactions: Some(among.reactions.write()),
                step_state: among.state.uniform(),
                step_params: among.step.uniform(),
                solids_params: among.params.uniform(),
                kernel: kernel.uniform(),
            },
            size,
        );
        let mut done = bench.run();
        let got = done.read(&quantized_positions, size);
        let at_m = |quantized, near_m: DVec3| Quantization::Full.near(quantized, near_m / SUPPORT_M) * SUPPORT_M;
        let taken: Vec<(DVec3, DVec3)> = (0..size)
            .map(|i| (at_m(got[i], starts_m[i]), at_m(quantized[i], starts_m[i])))
            .map(|(now_m, was_m)| ((now_m - was_m) / f64::from(DT_S), now_m))
            .collect();
        refused += usize::from(check(&mut worst, among.given(&mut done), &taken));
    }
    ensure!(refused > 1, "{refused} sums would tell a twentieth more apart");
    worst.report(device);
}

/// Without walls, and without a limit of speed that matters.
fn open() -> StepParams {
    StepParams { wall_min_m: [-9.0; 3], wall_max_m: [9.0; 3], max_speed_m_s: 1e3, ..walls() }
}
