//! `particles/` against its twin.

use crate::bench::Bench;
use crate::cases::{INACTIVE, fluid, sizes, step_of, step_state};
use crate::compare::{ROUNDING, Worst};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, Wrong, ensure, ensure_eq, note, skip};
use brooklet_kernels::{Counters, Kernel, Position, Predict, PredictVariant, StepParams, Velocity};
use brooklet_reference::particles::predict::Particle;
use brooklet_reference::particles::predict::predict;
use rand::RngExt;

const QUARANTINED: u32 = brooklet_kernels::QUARANTINED;

pub(super) struct Output {
    pub(super) positions: Vec<Position>,
    pub(super) velocities: Vec<Velocity>,
    counters: Counters,
}

pub(super) fn run(
    device: &Device,
    positions: &[Position],
    velocities: &[Velocity],
    params: StepParams,
    walls: bool,
) -> Output {
    let count = positions.len();
    let mut bench = Bench::new(device);
    let mut positions = bench.input("positions", positions);
    let mut velocities = bench.input("velocities", velocities);
    let mut counters = bench.input("counters", &[Counters::default()]);
    let step_params = bench.uniform("step_params", params);
    let step_state = bench.uniform("step_state", step_state(count, params.dt_s));
    bench.dispatch(
        &Predict {
            variant: PredictVariant { walls, periodic: params.period_m != [0.0; 3] },
            positions: positions.write(),
            velocities: velocities.write(),
            counters: counters.write(),
            step_state: step_state.uniform(),
            step_params: step_params.uniform(),
        },
        count,
    );
    let mut done = bench.run();
    Output {
        positions: done.read(&positions, count),
        velocities: done.read(&velocities, count),
        counters: done.read(&counters, 1)[0],
    }
}

/// Runs one case and checks every particle. Returns how many the speed limit slowed.
fn check(
    device: &Device,
    worst: &mut Worst,
    positions: &[Position],
    velocities: &[Velocity],
    params: StepParams,
    walls: bool,
) -> Result<u32, Wrong> {
    let output = run(device, positions, velocities, params, walls);
    let step = step_of(&params, walls);
    let mut slowed = 0;
    for i in 0..positions.len() {
        let before = Particle::of(&positions[i], &velocities[i]);
        let expected = predict(before, &step);
        slowed += u32::from(expected.slowed);
        let tag = output.positions[i].tag;
        let expected_tag = match expected.particle.quarantined {
            true => positions[i].tag | QUARANTINED,
            false => positions[i].tag,
        };
        if tag != expected_tag {
            return Err(format!("particle {i}: tag {tag:#x}, not {expected_tag:#x}").into());
        }
        // A contact's velocity is a difference of positions over dt.
        let size = step.domain_size_m.length();
        let speed = params.max_speed_m_s as f64 + if walls { size / step.dt_s } else { 0.0 };
        worst.check3(output.positions[i].position_m, expected.particle.position_m, size)?;
        worst.check3(output.velocities[i].velocity_m_s, expected.particle.velocity_m_s, speed)?;
    }
    if output.counters.speed_clamps != slowed {
        let clamps = output.counters.speed_clamps;
        return Err(format!("{clamps} speed clamps counted, expected {slowed}").into());
    }
    Ok(slowed)
}

pub(crate) fn predict_matches_its_twin(device: &Device) {
    // At most eight roundings, three of them in the speed limit's square root and quotient, which
    // Vulkan allows 3 and 2.5 units in the last place: 8 + 6 + 5.
    let mut worst = device.worst(Predict::STAGE, 20.0 * ROUNDING);
    let mut rng = rng(11);
    let mut slowed = 0;
    for walls in [false, true] {
        for size in sizes(device, Predict::GROUP_SIZE[0] as usize) {
            let case = fluid(&mut rng, size);
            slowed +=
                check(device, &mut worst, &case.positions, &case.velocities, case.step_params(), walls).or_raise();
        }
    }
    ensure!(slowed > 0, "no case met the speed limit");
    worst.report(device);
}

pub(crate) fn states_that_are_not_finite_are_quarantined(device: &Device) {
    let mut worst = Worst::new(Predict::STAGE, 20.0 * ROUNDING);
    let mut case = fluid(&mut rng(12), 64);
    for (i, bad) in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY].into_iter().enumerate() {
        case.positions[3 * i].position_m[i] = bad;
        case.velocities[3 * i + 1].velocity_m_s[2 - i] = bad;
    }
    case.positions[40].tag |= QUARANTINED;
    case.positions[41].tag |= INACTIVE;
    case.positions[41].position_m = [-7.0, 9.0, 2.5];
    // A signalling NaN and one with a sign: tested by the bits.
    case.velocities[50].velocity_m_s[0] = f32::from_bits(0x7f80_0001);
    case.velocities[51].velocity_m_s[0] = f32::from_bits(0xffc0_0000);
    let params = case.step_params();
    check(device, &mut worst, &case.positions, &case.velocities, params, true).or_raise();
    let output = run(device, &case.positions, &case.velocities, params, true);
    let parked = |p: &&Position| p.tag & QUARANTINED != 0;
    ensure_eq!(output.positions.iter().filter(parked).count(), 9);
}

pub(crate) fn free_fall_is_exact_to_rounding(device: &Device) {
    // The same operations in f32 on the CPU, with and without a fused multiply-add: the only
    // freedom that a shader compiler has.
    let mut case = fluid(&mut rng(13), 2);
    let params = StepParams { gravity_m_s2: [0.0, -9.81, 0.0], ..case.step_params() };
    // Of products and sums that the two give otherwise, those that came out fused, and those rounded twice.
    let mut ways = [0, 0];
    for _ in 0..20 {
        let output = run(device, &case.positions, &case.velocities, params, false);
        for i in 0..2 {
            for axis in 0..3 {
                let [x, v] = [case.positions[i].position_m, case.velocities[i].velocity_m_s].map(|a| a[axis]);
                let [x1, v1] = [output.positions[i].position_m, output.velocities[i].velocity_m_s].map(|a| a[axis]);
                let (g, dt) = (params.gravity_m_s2[axis], params.dt_s);
                for (got, of, [fused, twice]) in
                    [(v1, v, [g.mul_add(dt, v), v + g * dt]), (x1, x, [v1.mul_add(dt, x), x + v1 * dt])]
                {
                    ensure!(got == fused || got == twice, "{of} to {got}, not {fused} or {twice}");
                    if fused != twice {
                        ways[usize::from(got == twice)] += 1;
                    }
                }
            }
        }
        case.positions = output.positions;
        case.velocities = output.velocities;
    }
    note!(device, "a * b + c: {} fused, {} rounded twice", ways[0], ways[1]);
}

pub(crate) fn rows_of_groups_fold(device: &Device) {
    if device.small() {
        skip("4 million elements take minutes on a driver that interprets its shaders");
    }
    // More groups than a dispatch may have along one axis (65,535, of Vulkan's least): rows of 32,768, and one particle.
    let count = 2 * 32_768 * Predict::GROUP_SIZE[0] as usize + 1;
    let mut rng = rng(14);
    let positions = vec![Position { position_m: [0.5; 3], tag: 0 }; count];
    let velocities: Vec<Velocity> =
        (0..count).map(|_| Velocity { velocity_m_s: [rng.random(), 0.0, 0.0], age_s: 0.0 }).collect();
    let params = StepParams { dt_s: 0.25, domain_size_m: [2.0; 3], max_speed_m_s: 2.0, ..StepParams::default() };
    let output = run(device, &positions, &velocities, params, false);
    let moved = |i: usize| output.positions[i].position_m[0] == 0.5 + 0.25 * velocities[i].velocity_m_s[0];
    ensure_eq!((0..count).find(|&i| !moved(i)), None);
}
