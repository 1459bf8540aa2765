//! `particles/advect`, and how SPH's substeps are chosen, against their twins.

use std::iter::zip;

use crate::bench::Bench;
use crate::cases::{Case, fluid, out_of_part, sizes, step_of, step_state};
use crate::compare::{ROUNDING, Worst, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, ensure, ensure_eq};
use brooklet_fluid::particles::id_of;
use brooklet_fluid::visit_slots;
use brooklet_kernels::{
    Advect, AdvectVariant, ChooseTimeStep, ChooseTimeStepVariant, Counters, EndStep, FindFastest, GROUPS_PER_ROW,
    Kernel as _, KickParams, Position, QUARANTINED, SearchGroups, SphLimits, SphTimeStep, StepParams, StepState,
    Velocity,
};
use brooklet_reference::particles::advect::{Kicks, advect};
use brooklet_reference::particles::predict::Particle;
use brooklet_reference::solver::sph::choose_time_step::{Left, Limits, is_long};
use brooklet_reference::solver::sph::find_fastest::find_fastest;
use rand::RngExt;

fn run_advect(
    device: &Device,
    case: &Case,
    params: StepParams,
    accelerated: Option<(&[[f32; 4]], KickParams)>,
    walls: bool,
) -> (Vec<Position>, Vec<Velocity>, Counters) {
    let count = case.count();
    let mut bench = Bench::new(device);
    let mut positions = bench.input("positions", &case.positions);
    let mut velocities = bench.input("velocities", &case.velocities);
    let mut counters = bench.input("counters", &[Counters::default()]);
    let accelerations = bench.input("accelerations", accelerated.map_or(&[][..], |(all, _)| all));
    let kicks = bench.uniform("kicks", accelerated.map(|(_, kicks)| kicks).unwrap_or_default());
    let step_params = bench.uniform("step_params", params);
    let step_state = bench.uniform("step_state", step_state(count, params.dt_s));
    bench.dispatch(
        &Advect {
            variant: AdvectVariant { accelerated: accelerated.is_some(), walls, periodic: params.period_m != [0.0; 3] },
            positions: positions.write(),
            velocities: velocities.write(),
            accelerations: accelerated.map(|_| accelerations.read()),
            counters: counters.write(),
            step_state: step_state.uniform(),
            step_params: step_params.uniform(),
            kicks: accelerated.map(|_| kicks.uniform()),
        },
        count,
    );
    let mut done = bench.run();
    let counted = done.read(&counters, 1)[0];
    (done.read(&positions, count), done.read(&velocities, count), counted)
}

/// A position is a sum of some ten roundings of the domain's size and of the way, a velocity of its own and the kick's.
pub(crate) fn advect_matches_its_twin(device: &Device) {
    let mut rng = rng(114);
    let mut worst = device.worst(Advect::STAGE, 24.0 * ROUNDING);
    let mut slowed = 0;
    let kicks = [None, Some([0.5, 0.0]), Some([1.0, 0.0]), Some([0.0, 1.0])];
    for size in sizes(device, Advect::GROUP_SIZE[0] as usize) {
        for (walls, kicks) in [false, true].into_iter().flat_map(|walls| kicks.map(|kicks| (walls, kicks))) {
            let mut case = fluid(&mut rng, size);
            for (i, position) in case.positions.iter_mut().enumerate() {
                position.tag |= out_of_part(i);
            }
            if size > 40 {
                case.velocities[33].velocity_m_s[1] = f32::NAN;
            }
            // Every fifth had none yet, and falls freely.
            let accelerations: Vec<[f32; 4]> = (0..size)
                .map(|i| {
                    let mut one = || rng.random::<f32>() * 400.0 - 200.0;
                    [one(), one(), one(), f32::from(u8::from(i % 5 != 0))]
                })
                .collect();
            let params = case.step_params();
            let accelerated = kicks
                .map(|[before, after]| (&accelerations[..], KickParams { before, after, ..KickParams::default() }));
            let (positions, velocities, counters) = run_advect(device, &case, params, accelerated, walls);
            let step = step_of(&params, walls);
            let mut clamps = 0;
            for i in 0..size {
                let mut before = Particle::of(&case.positions[i], &case.velocities[i]);
                let [x, y, z, was_computed] = accelerations[i];
                let twin_kicks = kicks.map_or(Kicks::default(), |[before, after]| Kicks {
                    before: before.into(),
                    after: after.into(),
                    end: 0.0,
                });
                before.acceleration_m_s2 = (was_computed > 0.0).then(|| vector([x, y, z]));
                let expected = advect(before, &step, &twin_kicks);
                clamps += u32::from(expected.slowed);
                let after = expected.particle;
                ensure_eq!(id_of(positions[i].tag), if after.quarantined { id_of(positions[i].tag) } else { i as u32 });
                ensure_eq!(positions[i].tag & QUARANTINED != 0, after.quarantined);
                if !after.is_simulated() {
                    continue;
                }
                let speed = after.velocity_m_s.length().max(before.velocity_m_s.length()) + 350.0 * step.dt_s;
                let scale_m = step.domain_size_m.length() + speed * step.dt_s;
                worst.check3(positions[i].position_m, after.position_m, scale_m).or_raise();
                // What a wall takes is a difference of positions over dt.
                let taken = if walls { scale_m / step.dt_s } else { 0.0 };
                worst.check3(velocities[i].velocity_m_s, after.velocity_m_s, speed + taken).or_raise();
            }
            ensure_eq!(counters.speed_clamps, clamps);
            slowed += clamps;
        }
    }
    ensure!(slowed > 10, "{slowed} slowed");
    worst.report(device);
}

fn run_choose(
    device: &Device,
    before: SphTimeStep,
    limits: SphLimits,
    dt_s: f32,
    adaptive: bool,
    substeps: usize,
) -> Vec<(StepState, SphTimeStep, Counters)> {
    let mut done = Vec::new();
    for count in 1..=substeps {
        let mut bench = Bench::new(device);
        let mut state = bench.input("step_state", &[visit_slots(100)]);
        let mut time_step = bench.input("time_step", &[before]);
        let mut counters = bench.input("counters", &[Counters::default()]);
        let params = bench.uniform("step_params", StepParams { dt_s, ..StepParams::default() });
        let limits = bench.uniform("limits", limits);
        for _ in 0..count {
            bench.dispatch(
                &ChooseTimeStep {
                    variant: ChooseTimeStepVariant { adaptive, keeps_lists: false },
                    step_state: state.write(),
                    time_step: time_step.write(),
                    counters: counters.write(),
                    search_groups: None,
                    step_params: (!adaptive).then(|| params.uniform()),
                    limits: limits.uniform(),
                },
                1,
            );
        }
        let mut run = bench.run();
        done.push((run.read(&state, 1)[0], run.read(&time_step, 1)[0], run.read(&counters, 1)[0]));
    }
    done
}

const LIMITS: SphLimits = SphLimits {
    cfl_m: 0.008,
    sound_m_s: 30.0,
    force_m: 0.00125,
    steady_s: 1.0,
    step_s: 1.0 / 240.0,
    substeps: 12,
    list_reach_m: 0.002,
    scan_groups: [70_000, 18, 1],
    reserved0: 0,
    reserved1: 0,
};

/// Every number is a handful of roundings of the step.
pub(crate) fn choose_time_step_matches_its_twin(device: &Device) {
    let mut worst = device.worst(ChooseTimeStep::STAGE, 16.0 * ROUNDING);
    let cases = [
        (2.0_f32, 100.0_f32, LIMITS),
        (0.0, 0.0, LIMITS),
        (5.0, 1.0e6, SphLimits { substeps: 3, ..LIMITS }),
        (0.0, 0.0, SphLimits { steady_s: 3.0e-4, substeps: 20, ..LIMITS }),
        (0.0, 0.0, SphLimits { sound_m_s: 1.0, ..LIMITS }),
    ];
    for (speed, acceleration, limits) in cases {
        let before = SphTimeStep {
            max_speed_bits: speed.to_bits(),
            max_acceleration_bits: acceleration.to_bits(),
            ..SphTimeStep::default()
        };
        let substeps = limits.substeps as usize + 1;
        let got = run_choose(device, before, limits, 0.0, true, substeps);
        let (mut left, mut time_s, mut long) = (Left::default(), 0.0, 0);
        for (nth, (state, time_step, counters)) in got.iter().enumerate() {
            // The first substep's maxima are taken; nobody makes new ones here.
            let maxima = if nth == 0 { [speed.into(), acceleration.into()] } else { [0.0; 2] };
            let limit_s = Limits::of(&limits).limit_s(maxima[0], maxima[1]);
            let chosen = Limits::of(&limits).choose(limit_s, left);
            (left, time_s, long) = (chosen.left, time_s + chosen.dt_s, long + u32::from(chosen.is_long));
            worst.check(time_step.limit_s, limit_s, limit_s).or_raise();
            worst.check(state.time_s, time_s, f64::from(limits.step_s)).or_raise();
            worst.check(state.dt_s, chosen.dt_s, f64::from(limits.step_s)).or_raise();
            ensure!(chosen.dt_s > 0.0 || state.dt_s == 0.0, "substep {nth} takes {} s and none", state.dt_s);
            worst.check(time_step.left_s, left.left_s, f64::from(limits.step_s)).or_raise();
            ensure_eq!(time_step.substeps_left, left.substeps);
            ensure_eq!(state.slot_count, if chosen.dt_s > 0.0 { 100 } else { 0 });
            ensure_eq!(counters.long_substeps, long, "substep {nth}");
            ensure_eq!([time_step.max_speed_bits, time_step.max_acceleration_bits], [0, 0]);
        }
        // A substep that is left over leaves them to the next step's first.
        let left_over = SphTimeStep { substeps_left: 2, ..before };
        let (state, time_step, _) = run_choose(device, left_over, limits, 0.0, true, 1)[0];
        ensure_eq!((state.slot_count, time_step.substeps_left), (0, 1));
        ensure_eq!(
            [time_step.max_speed_bits, time_step.max_acceleration_bits].map(f32::from_bits),
            [speed, acceleration]
        );
        // A dt of the host's own is taken, and counted where it is above the limit.
        for dt_s in [1.0e-4_f32, 1.0e-2] {
            let (state, time_step, counters) = run_choose(device, before, limits, dt_s, false, 1)[0];
            ensure_eq!((state.dt_s, state.slot_count), (dt_s, 100));
            let limit_s = Limits::of(&limits).limit_s(speed.into(), acceleration.into());
            worst.check(time_step.limit_s, limit_s, limit_s).or_raise();
            ensure_eq!(counters.long_substeps, u32::from(is_long(dt_s.into(), limit_s)));
        }
    }
    worst.report(device);
}

/// One substep that may keep lists, of `slots` slots.
fn run_keep(
    device: &Device,
    before: SphTimeStep,
    limits: SphLimits,
    slots: u32,
) -> (StepState, SphTimeStep, SearchGroups) {
    let mut bench = Bench::new(device);
    let mut state = bench.input("step_state", &[visit_slots(slots)]);
    let mut time_step = bench.input("time_step", &[before]);
    let mut counters = bench.input("counters", &[Counters::default()]);
    let mut groups = bench.output("search_groups", 1);
    let limits = bench.uniform("limits", limits);
    bench.dispatch(
        &ChooseTimeStep {
            variant: ChooseTimeStepVariant { adaptive: true, keeps_lists: true },
            step_state: state.write(),
            time_step: time_step.write(),
            counters: counters.write(),
            search_groups: Some(groups.write()),
            step_params: None,
            limits: limits.uniform(),
        },
        1,
    );
    let mut run = bench.run();
    (run.read(&state, 1)[0], run.read(&time_step, 1)[0], run.read(&groups, 1)[0])
}

/// Of a step's first substep, one that keeps its lists, one that would drift too far, one that drifts nobody knows how far, and
/// one that is left over.
pub(crate) fn lists_are_kept_until_particles_have_moved_too_far(device: &Device) {
    let mut worst = device.worst(ChooseTimeStep::STAGE, 16.0 * ROUNDING);
    let maxima = [2.0_f32, 100.0];
    let [max_speed_bits, max_acceleration_bits] = maxima.map(f32::to_bits);
    let within = SphTimeStep {
        max_speed_bits,
        max_acceleration_bits,
        left_s: 2.0e-3,
        substeps_left: 9,
        ..SphTimeStep::default()
    };
    // More slots and cells than a row of groups has.
    let slots = 64 * 40_000;
    let folded = |groups: u32| [groups.min(GROUPS_PER_ROW), groups.div_ceil(GROUPS_PER_ROW), 1];
    for (before, visits, lists) in [
        (SphTimeStep { substeps_left: 0, drift_m: 1.0e-4, ..within }, true, true),
        (SphTimeStep { drift_m: 1.0e-4, ..within }, true, false),
        (SphTimeStep { drift_m: 1.9e-3, ..within }, true, true),
        (SphTimeStep { drift_m: f32::NAN, ..within }, true, true),
        (SphTimeStep { drift_m: 1.0e-4, left_s: 0.0, ..within }, false, false),
    ] {
        let (state, after, groups) = run_keep(device, before, LIMITS, slots);
        let twin = Limits::of(&LIMITS);
        let is_first = before.substeps_left == 0;
        let maxima = maxima.map(f64::from);
        let expected_m = twin.drift_m(before.drift_m.into(), state.dt_s.into(), maxima, is_first);
        worst.check(after.drift_m, expected_m, LIMITS.list_reach_m.into()).or_raise();
        ensure_eq!(expected_m == 0.0, lists, "{before:?}");
        ensure_eq!(state.slot_count, if visits { slots } else { 0 });
        let visited = visit_slots(state.slot_count).slot_groups;
        let due = if lists { [visited, [0; 3]] } else { [[0; 3], visited] };
        ensure_eq!([groups.slots, groups.kept_slots], due, "{before:?}");
        let scans = LIMITS.scan_groups.map(|groups| folded(if lists { groups } else { 0 }));
        ensure_eq!([groups.cells, groups.sums, groups.sums_of_sums], scans, "{before:?}");
    }
    worst.report(device);
}

fn run_find_fastest(device: &Device, case: &Case, accelerations: &[[f32; 4]]) -> [f32; 2] {
    let mut bench = Bench::new(device);
    let velocities = bench.input("velocities", &case.velocities);
    let accelerations = bench.input("accelerations", accelerations);
    let mut time_step = bench.input("time_step", &[SphTimeStep::default()]);
    let state = bench.uniform("step_state", case.step_state());
    bench.dispatch(
        &FindFastest {
            velocities: velocities.read(),
            accelerations: accelerations.read(),
            time_step: time_step.write(),
            step_state: state.uniform(),
        },
        case.count(),
    );
    let found = bench.run().read(&time_step, 1)[0];
    [found.max_speed_bits, found.max_acceleration_bits].map(f32::from_bits)
}

/// A length is the root of a sum of three squares: some four roundings.
pub(crate) fn find_fastest_matches_its_twin(device: &Device) {
    let mut rng = rng(186);
    let mut worst = device.worst(FindFastest::STAGE, 4.0 * ROUNDING);
    for size in sizes(device, FindFastest::GROUP_SIZE[0] as usize) {
        let case = fluid(&mut rng, size);
        let accelerations: Vec<[f32; 4]> = (0..size)
            .map(|i| {
                let mut one = || rng.random::<f32>() * 400.0 - 200.0;
                [one(), one(), one(), f32::from(u8::from(i % 5 != 0))]
            })
            .collect();
        let particles: Vec<Particle> = (0..size)
            .map(|i| {
                let [x, y, z, was_computed] = accelerations[i];
                Particle {
                    acceleration_m_s2: (was_computed > 0.0).then(|| vector([x, y, z])),
                    ..Particle::of(&case.positions[i], &case.velocities[i])
                }
            })
            .collect();
        let found = run_find_fastest(device, &case, &accelerations);
        let expected = find_fastest(&particles);
        for (found, expected) in zip(found, expected) {
            worst.check(found, expected, expected.max(1.0)).or_raise();
        }
        // Whom it must not overlook, and whom it must.
        let of_all = find_fastest(&particles[..size.saturating_sub(1)]);
        let told = zip(found, of_all).any(|(found, expected)| {
            Worst::new(FindFastest::STAGE, 4.0 * ROUNDING).check(found, expected, expected.max(1.0)).is_err()
        });
        let last_leads = size > 0 && of_all != expected;
        ensure_eq!(told, last_leads, "{size} particles");
    }
    worst.report(device);
}

pub(crate) fn end_step_visits_all_again(device: &Device) {
    let mut bench = Bench::new(device);
    let idle = StepState { active_count: 777, ..visit_slots(0) };
    let mut state = bench.input("step_state", &[idle]);
    bench.dispatch(&EndStep { step_state: state.write() }, 1);
    ensure_eq!(bench.run().read(&state, 1)[0], visit_slots(777));
}
