//! Who goes, and what becomes of slots: `emitters/drain_particles`, `emitters/limit_drain`, `emitters/compact`. All exact.

use crate::bench::Bench;
use crate::cases::{Case, INACTIVE, fluid, out_of_part, sizes, step_state};
use crate::compare::{report_exact, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{ensure, ensure_eq};
use brooklet_fluid::emitters::Compaction;
use brooklet_fluid::grid::Scan;
use brooklet_fluid::particles::{id_of, is_inactive, is_simulated};
use brooklet_fluid::{Particles, Slots};
use brooklet_kernels::{
    Buffer, CountCompacted, Counters, DRAIN_BOX, DRAIN_OUTSIDE, DRAIN_SPHERE, Drain, DrainParams, DrainParticles,
    DrainState, FillHoles, Kernel, ListMovers, MarkActive, MarkDrained, Position, SettleDrain, StepState, TakeDrained,
    Velocity,
};
use brooklet_reference::emitters::compact::compact;
use brooklet_reference::emitters::drain_particles::{Region, drains, is_over};
use brooklet_reference::emitters::limit_drain::{settle_drain, take_drained};
use glam::DVec3;
use rand::RngExt;

const GROUP: usize = DrainParticles::GROUP_SIZE[0] as usize;
const DT_S: f32 = 0.125;

/// Particles of which some are out of part already, and some have a lifetime.
fn case(size: usize, seed: u64) -> Case {
    let mut rng = rng(seed);
    let mut case = fluid(&mut rng, size);
    for (i, position) in case.positions.iter_mut().enumerate() {
        position.tag |= out_of_part(i);
        case.velocities[i].age_s = if rng.random_bool(0.5) { 0.25 - rng.random::<f32>() } else { 0.0 };
    }
    case
}

/// A region of each kind over some of a case; the ball's radius is no particle's distance to a rounding.
fn regions(size_m: DVec3) -> Vec<Drain> {
    let at = |share: f64| (share * size_m).as_vec3().to_array();
    let of = |shape, min_m, max_m| Drain { shape, min_m, max_m, particles_per_s: 0.0 };
    vec![
        of(DRAIN_BOX, at(0.1), at(0.45)),
        of(DRAIN_SPHERE, at(0.6), [0.2 * size_m.x as f32; 3]),
        of(DRAIN_OUTSIDE, at(0.05), at(0.8)),
    ]
}

fn region(drain: &Drain) -> Region {
    let (min_m, max_m) = (vector(drain.min_m), vector(drain.max_m));
    match drain.shape {
        DRAIN_BOX => Region::Box(min_m, max_m),
        DRAIN_SPHERE => Region::Sphere(min_m, max_m.x),
        _ => Region::Outside(min_m, max_m),
    }
}

fn emptied(position: &Position) -> Position {
    Position { tag: position.tag | INACTIVE, ..*position }
}

type Drained = (Vec<Position>, Vec<Velocity>, u32);

fn run_drains(device: &Device, case: &Case, regions: &[Drain], counts_ages: u32) -> Drained {
    let mut bench = Bench::new(device);
    let size = case.count();
    let tables = bench.input("drains", regions);
    let mut positions = bench.input("positions", &case.positions);
    let mut velocities = bench.input("velocities", &case.velocities);
    let mut counters = bench.input("counters", &[Counters { drained: 7, ..Counters::default() }]);
    let state = bench.uniform("step_state", step_state(size, DT_S));
    let params = DrainParams { drains: regions.len() as u32, counts_ages, ..DrainParams::default() };
    let params = bench.uniform("drain_params", params);
    bench.dispatch(
        &DrainParticles {
            drains: tables.read(),
            positions: positions.write(),
            velocities: velocities.write(),
            counters: counters.write(),
            step_state: state.uniform(),
            drain_params: params.uniform(),
        },
        size,
    );
    let mut done = bench.run();
    let counted: Counters = done.read(&counters, 1)[0];
    (done.read(&positions, size), done.read(&velocities, size), counted.drained - 7)
}

fn drained_by_twin(case: &Case, regions: &[Drain], counts_ages: u32) -> Drained {
    let mut drained = (case.positions.clone(), case.velocities.clone(), 0);
    for (position, velocity) in drained.0.iter_mut().zip(&mut drained.1).filter(|(p, _)| is_simulated(p.tag)) {
        let is_in = |drain: &Drain| drain.particles_per_s == 0.0 && drains(&region(drain), vector(position.position_m));
        if is_over(velocity.age_s.into(), DT_S.into()) || regions.iter().any(is_in) {
            (*position, *velocity) = (emptied(position), Velocity::default());
            drained.2 += 1;
        } else if velocity.age_s < 0.0 && counts_ages != 0 {
            velocity.age_s += DT_S;
        }
    }
    drained
}

pub(crate) fn drain_particles_matches_its_twin(device: &Device) {
    let mut cases = 0;
    for (seed, size) in sizes(device, GROUP).into_iter().enumerate() {
        let case = case(size, 430 + seed as u64);
        let all = regions(case.size_m);
        for (regions, counts_ages) in [(&all[..1], 1), (&all[1..2], 0), (&all[2..], 1), (&all[..], 1), (&all[..0], 1)] {
            let got = run_drains(device, &case, regions, counts_ages);
            let expected = drained_by_twin(&case, regions, counts_ages);
            ensure_eq!(got, expected, "{size} particles, {} drains", regions.len());
            ensure!(size < 300 || (5..size as u32 - 5).contains(&got.2), "{} of {size}", got.2);
            cases += size;
        }
    }
    report_exact(device, DrainParticles::STAGE, cases);
    let case = case(300, 439);
    let all = regions(case.size_m);
    let got = run_drains(device, &case, &all[..2], 1);
    ensure!(got != drained_by_twin(&case, &all[1..], 1), "other regions take others");
    ensure!(got != drained_by_twin(&case, &all[..2], 0), "and ages count");
    let limited: Vec<Drain> = all.iter().map(|drain| Drain { particles_per_s: 1.0, ..*drain }).collect();
    let none = run_drains(device, &case, &limited, 1);
    ensure_eq!(none, drained_by_twin(&case, &[], 1), "those with a limit are not this stage's");
}

pub(crate) fn limited_drains_match_their_twins(device: &Device) {
    let mut cases = 0;
    for (seed, size) in sizes(device, GROUP).into_iter().enumerate().filter(|(_, size)| *size > 0) {
        let case = case(size, 440 + seed as u64);
        // Some slots behind those that are visited.
        let visited = size - size / 5;
        for (drain, credit) in regions(case.size_m).into_iter().zip([2.75_f32, 0.5, 1e6]) {
            let drain = Drain { particles_per_s: 37.0, ..drain };
            let mut bench = Bench::new(device);
            let mut positions = bench.input("positions", &case.positions);
            let mut velocities = bench.input("velocities", &case.velocities);
            let mut counters = bench.input("counters", &[Counters::default()]);
            let mut state = bench.input("drain_state", &[DrainState { credit, ..DrainState::default() }]);
            let mut marks: Buffer<u32> = bench.output("drain_marks", size);
            let mut ranks: Buffer<u32> = bench.output("drain_ranks", size);
            let step = bench.uniform("step_state", step_state(visited, DT_S));
            let params = bench.uniform("drain", drain);
            let mark = MarkDrained {
                drain_marks: marks.write(),
                drained_positions: positions.read(),
                step_state: step.uniform(),
                drain: params.uniform(),
            };
            bench.dispatch(&mark, size);
            let (resources, recording) = bench.parts();
            Scan::declare(resources, "drain_ranks", size as u32).record(recording, &marks, &mut ranks);
            bench.dispatch(
                &TakeDrained {
                    marked_drains: marks.read(),
                    drain_ranks: ranks.read(),
                    positions: positions.write(),
                    velocities: velocities.write(),
                    drain_state: state.read(),
                    step_state: step.uniform(),
                },
                size,
            );
            let settle = SettleDrain {
                marked_drains: marks.read(),
                drain_ranks: ranks.read(),
                settled_drain: state.write(),
                counters: counters.write(),
                step_state: step.uniform(),
                drain: params.uniform(),
            };
            bench.dispatch(&settle, 1);
            let mut done = bench.run();

            let is_in = |(i, position): (usize, &Position)| {
                i < visited && is_simulated(position.tag) && drains(&region(&drain), vector(position.position_m))
            };
            let is_in: Vec<bool> = case.positions.iter().enumerate().map(is_in).collect();
            ensure_eq!(done.read(&marks, size), is_in.iter().map(|&is_in| u32::from(is_in)).collect::<Vec<_>>());
            let taken = take_drained(&is_in, credit.into());
            let expected = |i: usize| if taken[i] { emptied(&case.positions[i]) } else { case.positions[i] };
            ensure_eq!(done.read(&positions, size), (0..size).map(expected).collect::<Vec<_>>(), "{size}, {credit}");
            let expected = |i: usize| if taken[i] { Velocity::default() } else { case.velocities[i] };
            ensure_eq!(done.read(&velocities, size), (0..size).map(expected).collect::<Vec<_>>());
            let left: DrainState = done.read(&state, 1)[0];
            ensure_eq!(f64::from(left.credit), settle_drain(credit.into(), 37.0, DT_S.into()));
            let count = taken.iter().filter(|taken| **taken).count();
            let counted: Counters = done.read(&counters, 1)[0];
            ensure_eq!(counted.drained as usize, count);
            let more = take_drained(&is_in, f64::from(credit) + 1.0);
            ensure!(size < 300 || credit > 1e3 || more != taken, "the comparator sees another credit");
            cases += size;
        }
    }
    for stage in [MarkDrained::STAGE, TakeDrained::STAGE, SettleDrain::STAGE] {
        report_exact(device, stage, cases);
    }
}

pub(crate) fn compaction_matches_its_twin(device: &Device) {
    let mut cases = 0;
    for (seed, size) in sizes(device, GROUP).into_iter().enumerate().filter(|(_, size)| *size > 0) {
        for share in [0.0, 0.2, 0.9, 1.0] {
            let mut rng = rng(450 + seed as u64);
            let mut case = case(size, 450 + seed as u64);
            let visited = size - size / 5;
            for (i, position) in case.positions.iter_mut().enumerate() {
                position.tag |= if i >= visited || rng.random_bool(share) { INACTIVE } else { 0 };
            }
            let mut bench = Bench::new(device);
            let mut particles = Particles {
                positions: bench.input("positions", &case.positions),
                velocities: bench.input("velocities", &case.velocities),
            };
            let start = StepState { time_s: 3.0, ..step_state(visited, DT_S) };
            let state = bench.input("step_state", &[start]);
            let mut slots = Slots { state, capacity: size as u32, counts_vary: true, substeps_vary: false };
            let (resources, recording) = bench.parts();
            Compaction::declare(resources, size as u32).record(recording, &mut slots, &mut particles);
            let mut done = bench.run();

            let is_active: Vec<bool> = case.positions.iter().map(|position| !is_inactive(position.tag)).collect();
            let (moves, active) = compact(&is_active[..visited]);
            let (mut positions, mut velocities) = (case.positions.clone(), case.velocities.clone());
            for [from, to] in &moves {
                positions.swap(*from, *to);
                velocities[*to] = std::mem::take(&mut velocities[*from]);
            }
            let got = done.read(&particles.positions, size);
            ensure_eq!(got, positions, "{size} slots, {share} of them empty");
            ensure_eq!(done.read(&particles.velocities, size), velocities);
            let expected = StepState { time_s: 3.0, ..step_state(active, DT_S) };
            ensure_eq!(done.read(&slots.state, 1)[0], expected);
            let mut ids: Vec<u32> = got.iter().map(|position| id_of(position.tag)).collect();
            ids.sort_unstable();
            ensure!(ids.into_iter().eq(0..size as u32), "each id once");
            ensure!(moves.is_empty() || got != case.positions, "the comparator sees what did not move");
            cases += size;
        }
    }
    for stage in [MarkActive::STAGE, ListMovers::STAGE, FillHoles::STAGE, CountCompacted::STAGE] {
        report_exact(device, stage, cases);
    }
}
