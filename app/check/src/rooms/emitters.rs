//! Nozzles and fills against their twins: `emitters/open_emitters`, `emitters/emit_particles`,
//! `emitters/guide_particles`.
//!
//! Counts are exact. A nozzle is a place and a quaternion between two keyframes: off by as much as
//! solids' poses are.
//! A velocity has the difference of two places of the nozzle over dt in it, whose roundings it divides by dt.

use crate::bench::Bench;
use crate::cases::{INACTIVE, fluid, out_of_part, step_state};
use crate::compare::{ROUNDING, Worst, check_exact, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, Wrong, ensure, ensure_eq};
use brooklet_fluid::Scene;
use brooklet_fluid::emitters::emission_params;
use brooklet_fluid::particles::{fluid_of, id_of, is_simulated};
use brooklet_fluid::scene::{EmitterTables, emitters};
use brooklet_kernels::{
    Counters, Emission, EmissionParams, EmitParticles, Emitter, EmitterFlow, EmitterState, GROUPS_PER_ROW,
    GuideParticles, Kernel as _, OpenEmitters, Position, StepState, Velocity,
};
use brooklet_reference::emitters::emit_particles::{Nozzle, emit_particle};
use brooklet_reference::emitters::guide_particles::{Channel, guided_m_s};
use brooklet_reference::emitters::open_emitters::{self as twin, first_particles, open_emitter};
use brooklet_reference::particles::begin_substep::slot_groups;
use glam::{DQuat, DVec3};
use rand::RngExt;

const DT_S: f32 = 1.0 / 128.0;
const POSE_TOLERANCE: f64 = 512.0 * ROUNDING;

/// One that stands, one that is carried and turned, one that spins, one that ended, one that has not begun, and two fills.
const SCENE: &str = r#"spacing_m = 0.05
[domain]
min_m = [-0.5, 0, 0]
max_m = [1.5, 2, 2]
[[emitter]]
radius_m = 0.12
centre_m = [0.2, 1.5, 0.8]
direction = [1, -2, 0.5]
speed_m_s = 3.1
fluid = 2
[[emitter]]
width_m = 0.2
height_m = 0.1
direction = [0, 0, 1]
speed_m_s = 5.6
lifetime_s = 0.75
[[emitter.keyframe]]
time_s = 0.1
centre_m = [0.4, 0.4, 0.9]
[[emitter.keyframe]]
time_s = 1.1
centre_m = [0.9, 0.6, 1.2]
turned_deg = [0, 120, 40]
[[emitter]]
radius_m = 0.05
centre_m = [0.9, 0.9, 1]
direction = [1, 0.5, 0]
speed_m_s = 0.4
spin_deg_s = [0, 90, 0]
fluid = 1
[[emitter]]
radius_m = 0.2
centre_m = [1.0, 0.9, 1]
speed_m_s = 2
end_s = 0.25
[[emitter]]
radius_m = 0.2
centre_m = [1.0, 0.9, 1]
speed_m_s = 2
start_s = 50
[[emitter]]
block = { min_m = [0, 0.2, 0.1], max_m = [0.2, 0.5, 0.3] }
start_s = 0.5
speed_m_s = 1.5
[[emitter]]
sphere = { centre_m = [1, 1.5, 1], radius_m = 0.12 }
start_s = 60
[solver]
method = "none"
dt_s = 0.0078125
"#;

struct Case {
    tables: EmitterTables,
    twins: Vec<twin::Emitter>,
    params: EmissionParams,
}

fn case(settings: &[&str], capacity: u32) -> Case {
    let settings: Vec<String> = settings.iter().map(|&setting| setting.into()).collect();
    let scene = Scene::from_toml(SCENE, "emitters", &settings).or_raise();
    let tables = emitters(&scene);
    let of = |emitter: &Emitter| {
        let first = emitter.first_keyframe as usize;
        twin::Emitter {
            keyframes: tables.keyframes[first..first + emitter.keyframe_count as usize].to_vec(),
            period_s: emitter.period_s.into(),
            speed_m_s: emitter.speed_m_s.into(),
            spacing_m: (emitter.layers_per_m > 0.0).then(|| 1.0 / f64::from(emitter.layers_per_m)),
            start_s: emitter.start_s.into(),
            end_s: emitter.end_s.into(),
            most_layers: emitter.most_layers,
            points: emitter.points,
        }
    };
    let twins = tables.emitters.iter().map(of).collect();
    let params = emission_params(&scene, capacity);
    Case { tables, twins, params }
}

/// Flows that are not a hair from a layer: whether it is due then a rounding says.
fn states(case: &Case, seed: u64) -> Vec<EmitterState> {
    let mut rng = rng(seed);
    let state = |_| EmitterState {
        moved: rng.random_range(-49..=150) as f32 / 100.0,
        layers: rng.random_range(0..2),
        ..EmitterState::default()
    };
    case.tables.emitters.iter().map(state).collect()
}

struct Opened {
    flows: Vec<EmitterFlow>,
    states: Vec<EmitterState>,
    emission: Emission,
    state: StepState,
    counters: Counters,
}

/// `idles`: the time is that of the substep before.
fn run_open(device: &Device, case: &Case, states: &[EmitterState], start: StepState, idles: bool) -> Opened {
    let mut bench = Bench::new(device);
    let count = case.tables.emitters.len();
    let tables = bench.input("emitters", &case.tables.emitters);
    let keyframes = bench.input("keyframes", &case.tables.keyframes);
    let mut own = bench.input("emitter_states", states);
    let mut flows = bench.output::<EmitterFlow>("emitter_flows", count);
    let time_s = if idles { start.time_s } else { start.time_s - start.dt_s };
    let mut emission = bench.input("emission", &[Emission { time_s, ..Emission::default() }]);
    let mut state = bench.input("step_state", &[start]);
    let mut counters = bench.input("counters", &[Counters::default()]);
    let params = bench.uniform("emission_params", case.params);
    bench.dispatch(
        &OpenEmitters {
            emitters: tables.read(),
            keyframes: keyframes.read(),
            emitter_states: own.write(),
            emitter_flows: flows.write(),
            emission: emission.write(),
            step_state: state.write(),
            counters: counters.write(),
            emission_params: params.uniform(),
        },
        1,
    );
    let mut done = bench.run();
    Opened {
        flows: done.read(&flows, count),
        states: done.read(&own, count),
        emission: done.read(&emission, 1)[0],
        state: done.read(&state, 1)[0],
        counters: done.read(&counters, 1)[0],
    }
}

fn flows_of(case: &Case, states: &[EmitterState], start: &StepState) -> (Vec<twin::Flow>, Vec<twin::State>) {
    let end_s = f64::from(start.time_s);
    let of = |(emitter, state): (&twin::Emitter, &EmitterState)| {
        let state = twin::State { moved: state.moved.into(), layers: state.layers };
        open_emitter(emitter, state, end_s - f64::from(start.dt_s), end_s)
    };
    case.twins.iter().zip(states).map(of).unzip()
}

fn check_opened(
    worst: &mut Worst,
    case: &Case,
    before: &[EmitterState],
    start: &StepState,
    got: &Opened,
) -> Result<(), Wrong> {
    let (flows, states) = flows_of(case, before, start);
    let (firsts, wanted) = first_particles(&case.twins, &flows);
    let claimed = wanted.min(case.params.capacity - start.active_count);
    check_exact(
        &[got.emission.claimed, got.emission.first_slot, got.state.active_count, got.state.slot_count],
        &[claimed, start.active_count, start.active_count + claimed, start.active_count + claimed],
    )?;
    check_exact(&[got.counters.emitted, got.counters.capacity_overflow], &[claimed, wanted - claimed])?;
    check_exact(&got.emission.groups, &slot_groups(claimed, 64, GROUPS_PER_ROW))?;
    for (e, (got, expected)) in got.flows.iter().zip(&flows).enumerate() {
        check_exact(&[got.layers, got.layer, got.first], &[expected.layers, expected.layer, firsts[e]])
            .map_err(|wrong| wrong.named(format_args!("emitter {e}")))?;
        worst.check(got.ahead_m, expected.ahead_m, 1.0)?;
        for (position_m, rotation, pose) in
            [(got.position_m, got.rotation, expected.poses[0]), (got.after_m, got.rotation_after, expected.poses[1])]
        {
            worst.check3(position_m, pose.position_m, 1.0)?;
            let axes = DVec3::new(1.0, 2.0, -0.5);
            let turned = DQuat::from_array(rotation.map(f64::from)) * axes;
            worst.check3(turned.as_vec3().to_array(), pose.rotation * axes, 1.0)?;
        }
    }
    for (got, expected) in got.states.iter().zip(&states) {
        check_exact(&[got.layers], &[expected.layers])?;
        worst.check(got.moved, expected.moved, 1.0)?;
    }
    Ok(())
}

fn start(active: u32, time_s: f32) -> StepState {
    StepState { time_s, ..step_state(active as usize, DT_S) }
}

pub(crate) fn open_emitters_matches_its_twin(device: &Device) {
    let mut worst = device.worst(OpenEmitters::STAGE, POSE_TOLERANCE);
    for (seed, time_s) in [DT_S, 0.25, 0.5, 0.75, 1.25, 9.0].into_iter().enumerate() {
        // Room for all, for some, for none.
        for capacity in [100_000, 140, 100] {
            let case = case(&[], capacity);
            let (states, start) = (states(&case, 400 + seed as u64), start(100, time_s));
            let got = run_open(device, &case, &states, start, false);
            check_opened(&mut worst, &case, &states, &start, &got).or_raise();
        }
    }
    worst.report(device);

    let case = case(&[], 1000);
    let (states, start) = (states(&case, 407), start(100, 0.75));
    let got = run_open(device, &case, &states, start, true);
    let nothing = got.emission.claimed == 0 && got.state == start && got.counters == Counters::default();
    ensure!(nothing && got.states == states, "no time, no flow");
    let got = run_open(device, &case, &states, start, false);
    let mut worst = Worst::new(OpenEmitters::STAGE, POSE_TOLERANCE);
    for wrong in ["emitter.0.speed_m_s=3.2", "emitter.1.keyframe.1.time_s=1.2", "emitter.5.start_s=2"] {
        let other = Case { twins: self::case(&[wrong], 1000).twins, ..self::case(&[], 1000) };
        let states: Vec<EmitterState> = states.iter().map(|state| EmitterState { layers: 0, ..*state }).collect();
        let got = run_open(device, &case, &states, start, false);
        ensure!(check_opened(&mut worst, &other, &states, &start, &got).is_err(), "the comparator sees {wrong}");
    }
    let more = Case { params: EmissionParams { capacity: 105, ..case.params }, ..self::case(&[], 1000) };
    ensure!(check_opened(&mut worst, &more, &states, &start, &got).is_err(), "and another capacity");
}

type Slots = (Vec<Position>, Vec<Velocity>);

/// `capacity` slots, the first `active` of them taken.
fn slots(active: usize, capacity: usize) -> Slots {
    let mut case = fluid(&mut rng(401), capacity);
    for (i, position) in case.positions.iter_mut().enumerate() {
        position.tag = (capacity - 1 - i) as u32 | if i < active { 0 } else { INACTIVE };
    }
    (case.positions, case.velocities)
}

fn run_emit(device: &Device, case: &Case, opened: &Opened, before: &Slots) -> Slots {
    let mut bench = Bench::new(device);
    let tables = bench.input("emitters", &case.tables.emitters);
    let points = bench.input("emitter_points", &case.tables.points);
    let flows = bench.input("emitter_flows", &opened.flows);
    let emission = bench.input("emission", &[opened.emission]);
    let mut positions = bench.input("positions", &before.0);
    let mut velocities = bench.input("velocities", &before.1);
    let state = bench.uniform("step_state", opened.state);
    let params = bench.uniform("emission_params", case.params);
    bench.dispatch(
        &EmitParticles {
            emitters: tables.read(),
            emitter_points: points.read(),
            emitter_flows: flows.read(),
            emission: emission.read(),
            positions: positions.write(),
            velocities: velocities.write(),
            step_state: state.uniform(),
            emission_params: params.uniform(),
        },
        opened.emission.claimed as usize + 70,
    );
    let mut done = bench.run();
    (done.read(&positions, before.0.len()), done.read(&velocities, before.0.len()))
}

fn check_emitted(
    worst: &mut Worst,
    case: &Case,
    flows: &[twin::Flow],
    opened: &Opened,
    before: &Slots,
    got: &Slots,
) -> Result<(), Wrong> {
    let mut expected = Vec::new();
    for (e, (emitter, flow)) in case.tables.emitters.iter().zip(flows).enumerate() {
        let jitter_m = DVec3::new(1.0, 1.0, case.params.along_z.into()) * f64::from(emitter.jitter_m);
        let nozzle = Nozzle {
            number: e as u32,
            direction: vector(emitter.direction),
            speed_m_s: emitter.speed_m_s.into(),
            spacing_m: case.params.spacing_m.into(),
            jitter_m,
            lifetime_s: emitter.lifetime_s.into(),
        };
        for layer in 0..flow.layers {
            for point in 0..emitter.points {
                let place_m = vector(case.tables.points[(emitter.first_point + point) as usize].place_m);
                let emitted = emit_particle(&nozzle, flow, place_m, layer, point, opened.state.dt_s.into());
                expected.push((emitted, emitter.fluid));
            }
        }
    }
    let first = opened.emission.first_slot as usize;
    let end = first + opened.emission.claimed as usize;
    for slot in 0..before.0.len() {
        let (position, velocity) = (got.0[slot], got.1[slot]);
        if !(first..end).contains(&slot) {
            let words = |p: Position| [p.position_m.map(f32::to_bits)[0], p.tag];
            check_exact(&words(position), &words(before.0[slot]))?;
            continue;
        }
        let (emitted, fluid) = expected[slot - first];
        check_exact(&[id_of(position.tag), fluid_of(position.tag)], &[id_of(before.0[slot].tag), fluid])?;
        worst.check3(position.position_m, emitted.position_m, 1.0)?;
        // Roundings of the nozzle's places, over dt.
        worst.check3(velocity.velocity_m_s, emitted.velocity_m_s, 1.0 / f64::from(DT_S))?;
        check_exact(&[velocity.age_s.to_bits()], &[(emitted.age_s as f32).to_bits()])?;
    }
    Ok(())
}

pub(crate) fn emit_particles_matches_its_twin(device: &Device) {
    let mut worst = device.worst(EmitParticles::STAGE, POSE_TOLERANCE);
    let before = slots(100, 1000);
    let emit = |capacity: u32, time_s: f32, states: Vec<EmitterState>| {
        let case = case(&[], capacity);
        let start = start(100, time_s);
        let opened = run_open(device, &case, &states, start, false);
        let (flows, _) = flows_of(&case, &states, &start);
        let got = run_emit(device, &case, &opened, &before);
        (case, flows, opened, got)
    };
    for (seed, time_s) in [DT_S, 0.5, 0.75, 9.0].into_iter().enumerate() {
        for capacity in [1000, 133] {
            let (case, flows, opened, got) = emit(capacity, time_s, states(&case(&[], capacity), 410 + seed as u64));
            ensure!(opened.emission.claimed > 20, "{} particles", opened.emission.claimed);
            check_emitted(&mut worst, &case, &flows, &opened, &before, &got).or_raise();
        }
    }
    worst.report(device);

    let one_due = EmitterState { moved: 0.75, layers: 1, ..EmitterState::default() };
    let (case, flows, opened, got) = emit(1000, 0.75, vec![one_due; case(&[], 1000).tables.emitters.len()]);
    let mut worst = Worst::new(EmitParticles::STAGE, POSE_TOLERANCE);
    let mut later = flows.clone();
    later.iter_mut().for_each(|flow| flow.layer += 1);
    ensure!(check_emitted(&mut worst, &case, &later, &opened, &before, &got).is_err(), "other layers lie elsewhere");
    for wrong in ["emitter.0.direction=[1, -2, 0.51]", "emitter.1.lifetime_s=0.8", "emitter.0.fluid=3"] {
        let tables = self::case(&[wrong], 1000).tables;
        let other = Case { tables, ..self::case(&[], 1000) };
        ensure!(check_emitted(&mut worst, &other, &flows, &opened, &before, &got).is_err(), "it sees {wrong}");
    }
}

fn channel(case: &Case, e: usize) -> Channel {
    let emitter = &case.tables.emitters[e];
    let margin_m = 0.5 * f64::from(case.params.spacing_m);
    let half_m = |half_m: f32| f64::from(half_m) + margin_m;
    Channel {
        direction: vector(emitter.direction),
        speed_m_s: emitter.speed_m_s.into(),
        along_m: [-f64::from(case.params.spacing_m), case.params.guide_m.into()],
        axes: [vector(emitter.across), vector(emitter.up)],
        half_m: [
            Some(half_m(emitter.half_width_m)),
            (emitter.half_height_m > 0.0).then(|| half_m(emitter.half_height_m)),
        ],
    }
}

fn run_guide(device: &Device, case: &Case, opened: &Opened, positions: &[Position], at: &[Velocity]) -> Vec<Velocity> {
    let mut bench = Bench::new(device);
    let tables = bench.input("emitters", &case.tables.emitters);
    let flows = bench.input("emitter_flows", &opened.flows);
    let input = bench.input("positions", positions);
    let mut velocities = bench.input("velocities", at);
    let state = bench.uniform("step_state", step_state(positions.len(), DT_S));
    let params = bench.uniform("emission_params", case.params);
    bench.dispatch(
        &GuideParticles {
            emitters: tables.read(),
            emitter_flows: flows.read(),
            positions: input.read(),
            velocities: velocities.write(),
            step_state: state.uniform(),
            emission_params: params.uniform(),
        },
        positions.len(),
    );
    bench.run().read(&velocities, positions.len())
}

/// Compares velocities; returns how many were led.
fn check_guided(
    worst: &mut Worst,
    case: &Case,
    flows: &[twin::Flow],
    opened: &Opened,
    positions: &[Position],
    [before, got]: [&[Velocity]; 2],
) -> Result<usize, Wrong> {
    let mut led = 0;
    for (i, position) in positions.iter().enumerate() {
        let at_m = vector(position.position_m);
        let flowing = (0..flows.len()).filter(|&e| opened.flows[e].flows != 0);
        let depths_m: Vec<(usize, f64)> =
            flowing.map(|e| (e, channel(case, e).depth_m(flows[e].poses[0].in_frame(at_m)))).collect();
        if depths_m.iter().any(|(_, depth_m)| depth_m.abs() < 1e-5) {
            continue;
        }
        let leads = depths_m.iter().find(|(_, depth_m)| *depth_m > 0.0).filter(|_| is_simulated(position.tag));
        let Some(&(e, _)) = leads else {
            let bits = |velocity: &Velocity| velocity.velocity_m_s.map(f32::to_bits);
            check_exact(&bits(&got[i]), &bits(&before[i]))?;
            continue;
        };
        let expected_m_s = guided_m_s(&channel(case, e), &flows[e], at_m, DT_S.into());
        worst.check3(got[i].velocity_m_s, expected_m_s, 1.0 / f64::from(DT_S))?;
        led += 1;
    }
    Ok(led)
}

pub(crate) fn guide_particles_matches_its_twin(device: &Device) {
    let mut worst = device.worst(GuideParticles::STAGE, POSE_TOLERANCE);
    let guide = |time_s: f32| {
        let case = case(&[], 100_000);
        let (states, start) = (states(&case, 420), start(100, time_s));
        let opened = run_open(device, &case, &states, start, false);
        let (flows, _) = flows_of(&case, &states, &start);
        // Around each nozzle some.
        let mut rng = rng(421);
        let count = if device.small() { 600 } else { 3000 };
        let mut around = |i: usize| {
            let pose = flows[i % flows.len()].poses[0];
            let off_m: DVec3 = [0; 3].map(|_| 0.4 * rng.random::<f64>() - 0.2).into();
            let tag = i as u32 | out_of_part(i);
            Position { position_m: pose.from_frame(off_m).as_vec3().to_array(), tag }
        };
        let positions: Vec<Position> = (0..count).map(&mut around).collect();
        let before = vec![Velocity { velocity_m_s: [9.0, 8.0, 7.0], age_s: -1.0 }; count];
        let got = run_guide(device, &case, &opened, &positions, &before);
        (case, flows, opened, positions, before, got)
    };
    for time_s in [DT_S, 0.75, 9.0] {
        let (case, flows, opened, positions, before, got) = guide(time_s);
        let led = check_guided(&mut worst, &case, &flows, &opened, &positions, [&before, &got]).or_raise();
        ensure!(led > positions.len() / 60 && led < positions.len() / 2, "{led} of {}", positions.len());
        ensure_eq!(got.iter().filter(|velocity| velocity.age_s == -1.0).count(), got.len(), "nobody is older");
    }
    worst.report(device);

    let (_, flows, opened, positions, before, got) = guide(0.75);
    let mut worst = Worst::new(GuideParticles::STAGE, POSE_TOLERANCE);
    for wrong in ["emitter.0.speed_m_s=3.2", "emitter.0.radius_m=0.15", "emitter.1.height_m=0.16"] {
        let other = self::case(&[wrong], 1000);
        let checked = check_guided(&mut worst, &other, &flows, &opened, &positions, [&before, &got]);
        ensure!(checked.is_err(), "the comparator sees {wrong}");
    }
}
