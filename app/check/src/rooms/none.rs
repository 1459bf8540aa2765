//! `solver/none/` against its twin.

use crate::bench::Bench;
use crate::cases::{Case, INACTIVE, fluid, out_of_part, sizes, step_of, step_state};
use crate::compare::{ROUNDING, Worst, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, Wrong, ensure, ensure_eq};
use brooklet_fluid::particles::id_of;
use brooklet_kernels::{
    BounceWalls, Counters, IntegrateParticles, IntegrateParticlesVariant, Kernel, NoneParams, Position, QUARANTINED,
    StepParams, Velocity,
};
use brooklet_reference::boundary::bounce_path;
use brooklet_reference::params::NonInteracting;
use brooklet_reference::particles::predict::Particle;
use brooklet_reference::solver::none::integrate_particles::integrate_particles;
use rand::{Rng, RngExt};

pub(super) const SETTINGS: NoneParams =
    NoneParams { lifetime_s: 1.0, lifetime_variation: 0.5, drag_per_s: 1.5, restitution: 0.625 };

pub(super) fn run(
    device: &Device,
    case: &Case,
    params: StepParams,
    settings: NoneParams,
    walls: bool,
) -> (Vec<Position>, Vec<Velocity>, Counters) {
    let count = case.positions.len();
    let mut bench = Bench::new(device);
    let mut positions = bench.input("positions", &case.positions);
    let mut velocities = bench.input("velocities", &case.velocities);
    let mut counters = bench.input("counters", &[Counters::default()]);
    let step_params = bench.uniform("step_params", params);
    let none = bench.uniform("none", settings);
    let step_state = bench.uniform("step_state", step_state(count, params.dt_s));
    bench.dispatch(
        &IntegrateParticles {
            variant: IntegrateParticlesVariant { walls, periodic: params.period_m != [0.0; 3] },
            positions: positions.write(),
            velocities: velocities.write(),
            counters: counters.write(),
            step_state: step_state.uniform(),
            step_params: step_params.uniform(),
            none: none.uniform(),
        },
        count,
    );
    let mut done = bench.run();
    let counted = done.read(&counters, 1)[0];
    (done.read(&positions, count), done.read(&velocities, count), counted)
}

pub(super) fn twin(settings: NoneParams) -> NonInteracting {
    NonInteracting {
        lifetime_s: f64::from(settings.lifetime_s),
        lifetime_variation: f64::from(settings.lifetime_variation),
        drag_per_s: f64::from(settings.drag_per_s),
        restitution: f64::from(settings.restitution),
    }
}

/// Particles of all ages that fly into all walls, some out of part.
fn case(rng: &mut impl Rng, size: usize) -> Case {
    let mut case = fluid(rng, size);
    for (i, (position, velocity)) in case.positions.iter_mut().zip(&mut case.velocities).enumerate() {
        position.tag |= out_of_part(i);
        velocity.velocity_m_s = velocity.velocity_m_s.map(|v| 20.0 * v);
        velocity.age_s = rng.random::<f32>();
    }
    case
}

/// The kernel's result against the twin's; how many were slowed, and how many went out.
///
/// A position is a sum of some ten roundings of the domain's size, a velocity a product with an exponential that
/// Vulkan promises to 3 + 2 |x| units.
fn check(
    case: &Case,
    (positions, velocities, counters): &(Vec<Position>, Vec<Velocity>, Counters),
    params: &StepParams,
    expected_of: NonInteracting,
    walls: bool,
) -> Result<(u32, usize), Wrong> {
    let step = step_of(params, walls);
    let mut worst = Worst::new(IntegrateParticles::STAGE, 24.0 * ROUNDING);
    let (mut slowed, mut ended) = (0, 0);
    for i in 0..positions.len() {
        let tag = case.positions[i].tag;
        let before = Particle::of(&case.positions[i], &case.velocities[i]);
        let expected = integrate_particles(id_of(tag), before, &step, &expected_of);
        slowed += u32::from(expected.slowed);
        let after = expected.particle;
        let out = [(after.quarantined, QUARANTINED), (after.inactive, INACTIVE)];
        let expected_tag = out.into_iter().filter(|(is_out, _)| *is_out).fold(tag, |tag, (_, bits)| tag | bits);
        if positions[i].tag != expected_tag {
            return Err(format!("particle {i} has the tag {:#x}, expected {expected_tag:#x}", positions[i].tag).into());
        }
        if !after.is_simulated() {
            ended += usize::from(before.is_simulated() && after.inactive);
            continue;
        }
        let speed = after.velocity_m_s.length().max(before.velocity_m_s.length());
        worst.check3(positions[i].position_m, after.position_m, step.domain_size_m.length() + speed * step.dt_s)?;
        worst.check3(velocities[i].velocity_m_s, after.velocity_m_s, speed)?;
        worst.check(velocities[i].age_s, after.age_s, 1.0)?;
    }
    match (counters.speed_clamps == slowed, counters.drained as usize == ended) {
        (true, true) => Ok((slowed, ended)),
        (false, _) => Err(format!("{} speeds clamped, expected {slowed}", counters.speed_clamps).into()),
        (_, false) => Err(format!("{} ended, expected {ended}", counters.drained).into()),
    }
}

pub(crate) fn integrate_particles_matches_its_twin(device: &Device) {
    let mut rng = rng(91);
    let (mut slowed, mut ended) = (0, 0);
    for size in sizes(device, IntegrateParticles::GROUP_SIZE[0] as usize) {
        for walls in [false, true] {
            let case = case(&mut rng, size);
            let params = StepParams { max_speed_m_s: 12.0, ..case.step_params() };
            let got = run(device, &case, params, SETTINGS, walls);
            let (more_slowed, more_ended) = check(&case, &got, &params, twin(SETTINGS), walls).or_raise();
            (slowed, ended) = (slowed + more_slowed, ended + more_ended);
        }
    }
    ensure!(slowed > 10 && ended > 10, "{slowed} slowed, {ended} ended");
}

pub(crate) fn a_wrong_setting_is_noticed(device: &Device) {
    let case = case(&mut rng(92), 500);
    // Nobody is slowed: what is does not show its drag.
    let params = StepParams { max_speed_m_s: 100.0, ..case.step_params() };
    let got = run(device, &case, params, SETTINGS, true);
    check(&case, &got, &params, twin(SETTINGS), true).or_raise();
    for wrong in [
        NoneParams { lifetime_s: 1.02, ..SETTINGS },
        NoneParams { lifetime_variation: 0.48, ..SETTINGS },
        NoneParams { drag_per_s: 1.51, ..SETTINGS },
        NoneParams { restitution: 0.63, ..SETTINGS },
    ] {
        check(&case, &got, &params, twin(wrong), true).unwrap_err();
    }
    check(&case, &got, &params, twin(SETTINGS), false).unwrap_err();
}

pub(crate) fn states_that_are_not_finite_are_quarantined(device: &Device) {
    let mut case = fluid(&mut rng(93), 70);
    case.positions[3].position_m[1] = f32::NAN;
    case.velocities[64].velocity_m_s[2] = f32::INFINITY;
    let params = case.step_params();
    let got = run(device, &case, params, SETTINGS, true);
    check(&case, &got, &params, twin(SETTINGS), true).or_raise();
    let parked: Vec<usize> = (0..70).filter(|&i| got.0[i].tag & QUARANTINED != 0).collect();
    ensure_eq!(parked, [3, 64]);
}

/// A position is clamped twice, a velocity turned or not: some eight roundings of the domain's size.
pub(crate) fn bounce_walls_matches_its_twin(device: &Device) {
    let mut rng = rng(76);
    let tolerance = 8.0 * ROUNDING;
    let mut worst = device.worst(BounceWalls::STAGE, tolerance);
    let mut bounced = 0;
    for size in sizes(device, BounceWalls::GROUP_SIZE[0] as usize) {
        let mut case = case(&mut rng, size);
        let size_m = case.size_m;
        // A third of them beyond a wall.
        case.positions.iter_mut().for_each(|at| {
            at.position_m = std::array::from_fn(|axis| ((1.4 * rng.random::<f64>() - 0.2) * size_m[axis]) as f32);
        });
        let (params, settings) = (case.step_params(), NoneParams { restitution: 0.625, ..NoneParams::default() });
        let mut bench = Bench::new(device);
        let mut positions = bench.input("positions", &case.positions);
        let mut velocities = bench.input("velocities", &case.velocities);
        let state = bench.uniform("step_state", step_state(size, params.dt_s));
        let step_params = bench.uniform("step_params", params);
        let none = bench.uniform("none", settings);
        bench.dispatch(
            &BounceWalls {
                positions: positions.write(),
                velocities: velocities.write(),
                step_state: state.uniform(),
                step_params: step_params.uniform(),
                none: none.uniform(),
            },
            size,
        );
        let mut done = bench.run();
        let (positions, velocities) = (done.read(&positions, size), done.read(&velocities, size));
        let step = step_of(&params, true);
        let mut refused = size < 60;
        for i in 0..size {
            let before = (vector(case.positions[i].position_m), vector(case.velocities[i].velocity_m_s));
            let takes_part = out_of_part(i) == 0;
            let bounce = |restitution: f64| match takes_part {
                true => bounce_path(before.0, before.1, restitution, &step),
                false => before,
            };
            let (at_m, velocity_m_s) = bounce(0.625);
            worst.check3(positions[i].position_m, at_m, size_m.length()).or_raise();
            worst.check3(velocities[i].velocity_m_s, velocity_m_s, before.1.length()).or_raise();
            bounced += usize::from(velocity_m_s != before.1);
            let mut wrong = Worst::new(BounceWalls::STAGE, tolerance);
            refused |= wrong.check3(positions[i].position_m, bounce(0.62).0, size_m.length()).is_err();
        }
        ensure!(refused, "another restitution");
    }
    ensure!(bounced > 100, "{bounced} bounced");
    worst.report(device);
}
