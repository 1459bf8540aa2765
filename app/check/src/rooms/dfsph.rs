//! `solver/dfsph/` against its twins. Tolerances are those of sums over pairs (`tolerance_of_pairs`), relative to the sum of
//! the terms' lengths.

use super::pairs::{FULL, Pairs, all_pairs};
use crate::bench::Bench;
use crate::cases::{Case, fluid, kernel_params, out_of_part, smoothing_of, step_of};
use crate::compare::{ROUNDING, Worst, tolerance_of_pairs, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, Wrong, ensure, ensure_eq, note};
use brooklet_kernels::{
    ApplyPressure, ApplyPressureVariant, CorrectPressure, CorrectPressureVariant, Kernel, PressureFactors,
    PressureSolve, SolidContact,
    WallsKeyword::{self, Off, SolidWalls, Walls},
};
use brooklet_reference::boundary::mirror::{Mirrors, SolidMirror, pack_direction, unpack_direction};
use brooklet_reference::params::Smoothing;
use brooklet_reference::shared::wendland;
use brooklet_reference::solver::dfsph::apply_pressure::{Gain, apply_pressure};
use brooklet_reference::solver::dfsph::correct_pressure::{self as twin, GUARD, correct_pressure, density_change};
use brooklet_reference::solver::dfsph::factor_pressure;
use glam::DVec3;
use rand::{Rng, RngExt};

/// Roundings of f16 that a change of pressure may be off by, and a push.
const CORRECT_HALF: f64 = 8.0;
const APPLY_HALF: f64 = 8.0;

/// An iteration after others, with shares that neither solve has.
pub(super) fn solve() -> PressureSolve {
    PressureSolve {
        tolerance: 1e-3,
        step: 0.6,
        momentum: 0.3,
        guarded_step: 0.5,
        room_share: 0.75,
        solids_move: 1.0,
        excess_share: 0.5,
        warm_share: 0.875,
        most_iterations: 7,
        ..PressureSolve::default()
    }
}

fn solve_of(solve: &PressureSolve) -> twin::PressureSolve {
    twin::PressureSolve {
        tolerance: f64::from(solve.tolerance),
        first_step: f64::from(solve.step),
        step: f64::from(solve.step),
        momentum: f64::from(solve.momentum),
        guarded_step: f64::from(solve.guarded_step),
        room_share: f64::from(solve.room_share),
        excess_share: f64::from(solve.excess_share),
        warm_share: f64::from(solve.warm_share),
        most_iterations: solve.most_iterations as usize,
        least_iterations: solve.least_iterations as usize,
        is_fixed: false,
    }
}

/// The half-space that a particle's factors name.
pub(super) fn solids_of(factors: &PressureFactors) -> SolidMirror {
    SolidMirror {
        normal: unpack_direction(factors.solid_normal),
        distance: factors.from_solids.into(),
        speed_m_s: factors.solid_speed_m_s.into(),
    }
}

/// Factors of every kind, and as the twin has them. Walls, if there are any, are near or far from each, whatever stands around
/// it: what a pair sees of them is one's own.
pub(super) fn random_factors(
    rng: &mut impl Rng,
    case: &Case,
    walls: WallsKeyword,
) -> (Vec<PressureFactors>, Vec<factor_pressure::PressureFactors>) {
    let of = |i: usize| {
        let mut number = || rng.random::<f32>() - 0.5;
        let gpu = PressureFactors {
            from_walls: if walls == WallsKeyword::Off { [2.0; 3] } else { std::array::from_fn(|_| 3.0 * number()) },
            solid_normal: pack_direction(DVec3::new(number().into(), number().into(), 0.6).normalize()),
            from_solids: if walls == WallsKeyword::SolidWalls { 3.0 * number() } else { 2.0 },
            solid_speed_m_s: 2.0 * number(),
            excess: 0.3 * number(),
            inverse_stiffness: if out_of_part(i) == 0 { 1.0 + number() } else { 0.0 },
        };
        let twin = factor_pressure::PressureFactors {
            mirrors: Mirrors { from_walls: vector(gpu.from_walls), solids: Some(solids_of(&gpu)) },
            excess: f64::from(gpu.excess),
            stiffness: 1.0 / f64::from(gpu.inverse_stiffness).max(f64::MIN_POSITIVE),
            is_simulated: out_of_part(i) == 0,
        };
        (gpu, twin)
    };
    (0..case.count()).map(of).unzip()
}

/// The sum of the lengths of the kernel's slopes of all that particle `i` sees.
pub(super) fn slopes(i: usize, at_m: &[DVec3], list: &[usize], smoothing: &Smoothing, mirrors: &Mirrors) -> f64 {
    let of = |seen: DVec3| (wendland::gradient(seen) * smoothing.weight).length();
    let own: f64 = mirrors.images().skip(1).map(|image| 2.0 * of(mirrors.offset(DVec3::ZERO, image))).sum();
    let others = list.iter().map(|&j| smoothing.offset(at_m[i], at_m[j]));
    own + others.map(|to| mirrors.images().map(|image| of(mirrors.offset(to, image))).sum::<f64>()).sum::<f64>()
}

/// What one iteration has at hand.
struct Iteration {
    case: Case,
    factors: Vec<PressureFactors>,
    twins: Vec<factor_pressure::PressureFactors>,
    pressures: Vec<f32>,
    changes: Vec<f32>,
    walls: WallsKeyword,
}

fn random_iteration(rng: &mut impl Rng, size: usize, walls: WallsKeyword) -> Iteration {
    let case = fluid(rng, size);
    let (factors, twins) = random_factors(rng, &case, walls);
    let pressures = (0..size).map(|i| if i % 3 == 0 { 0.0 } else { 0.2 * rng.random::<f32>() }).collect();
    let changes = (0..size).map(|_| 0.1 * (rng.random::<f32>() - 0.5)).collect();
    Iteration { case, factors, twins, pressures, changes, walls }
}

/// Corrects pressures and compares them with the twin's, whose settings may be others; how many were inside the guard.
fn check_correct(
    device: &Device,
    of: &Iteration,
    pairs: Pairs,
    [gpu, expected]: [&PressureSolve; 2],
    measured: bool,
    worst: &mut Worst,
) -> Result<usize, Wrong> {
    let Iteration { case, factors, twins, pressures, changes, walls } = of;
    let count = case.count();
    let groups = count.div_ceil(64);
    let mut bench = Bench::new(device);
    let quantized_positions = bench.input("quantized_positions", &case.quantized_positions(pairs.quantization));
    let velocities = bench.input("velocities", &case.velocities);
    let (neighbours, list_heads) = case.upload_neighbours(&mut bench);
    let pressure_factors = bench.input("pressure_factors", factors);
    let pressure_buffer = bench.input("pressures", pressures);
    let mut pressure_changes = bench.input("pressure_changes", changes);
    let mut group_residuals = bench.output::<f32>("group_residuals", groups);
    let step_state = bench.uniform("step_state", case.step_state());
    let step_params = bench.uniform("step_params", case.step_params());
    let kernel = bench.uniform("kernel", kernel_params());
    let solve = bench.uniform("solve", *gpu);
    bench.dispatch(
        &CorrectPressure {
            variant: CorrectPressureVariant { walls: *walls, measured, precision: pairs.precision },
            quantized_positions: quantized_positions.read(),
            velocities: velocities.read(),
            neighbours: neighbours.read(),
            list_heads: list_heads.read(),
            pressure_factors: pressure_factors.read(),
            pressures: pressure_buffer.read(),
            pressure_changes: pressure_changes.write(),
            group_residuals: measured.then(|| group_residuals.write()),
            step_state: step_state.uniform(),
            step_params: step_params.uniform(),
            kernel: kernel.uniform(),
            solve: solve.uniform(),
        },
        count,
    );
    let mut done = bench.run();
    let got = done.read(&pressure_changes, count);
    let got_residuals = done.read(&group_residuals, groups);
    let step = step_of(&case.step_params(), false);
    let smoothing = smoothing_of(&kernel_params());
    let (at_m, v_m_s) = (case.quantized_m(pairs.quantization), case.velocities_m_s());
    let mut residuals = vec![(0.0, 0.0); groups];
    let mut guarded = 0;
    for i in 0..count {
        let (list, own) = (&case.neighbours[i], &twins[i]);
        let mut seen = *own;
        if let Some(solids) = &mut seen.mirrors.solids {
            solids.speed_m_s *= f64::from(expected.solids_move);
        }
        let (mut change, mut terms) = density_change(i, &at_m, &v_m_s, list, &seen, &step, &smoothing);
        terms += own.excess.abs();
        if !own.is_simulated {
            (change, terms) = (0.0, 0.0);
        }
        let [total, before] = [pressures[i], changes[i]].map(f64::from);
        let mut correction = correct_pressure(own, change, total, before, false, &solve_of(expected));
        if !own.is_simulated {
            // Without a stiffness only momentum is left: of a particle that takes no part both are 0 in a run.
            let guard = ((own.excess - GUARD[0]) / (GUARD[1] - GUARD[0])).clamp(0.0, 1.0);
            let fast = (1.0 - guard) * f64::from(expected.momentum) * before;
            correction = twin::Correction { change: (total + fast).max(0.0) - total, ..correction };
        }
        let inverse = f64::from(factors[i].inverse_stiffness);
        guarded += usize::from(own.excess > GUARD[0]);
        worst.check(got[i], correction.change, 2.0 * terms * inverse + total + before.abs())?;
        residuals[i / 64].0 += correction.residual;
        residuals[i / 64].1 += terms + total / inverse.max(0.4);
    }
    if measured {
        for (got, (expected, scale)) in got_residuals.iter().zip(residuals) {
            worst.check(*got, expected, scale)?;
        }
    }
    Ok(guarded)
}

pub(crate) fn correct_pressure_matches_its_twin(device: &Device) {
    for (pairs, rounding) in all_pairs(device) {
        let mut worst = device.worst(pairs.name(CorrectPressure::STAGE), tolerance_of_pairs(rounding, CORRECT_HALF));
        let mut rng = rng(93);
        let mut guarded = 0;
        let first = PressureSolve { excess_share: 0.0, momentum: 0.0, ..solve() };
        let still = PressureSolve { solids_move: 0.0, ..solve() };
        for (solve, measured, walls) in [
            (solve(), true, Walls),
            (first, true, Off),
            (solve(), false, SolidWalls),
            (solve(), false, Off),
            (still, true, SolidWalls),
        ] {
            for size in pairs.sizes(device) {
                let of = random_iteration(&mut rng, size, walls);
                guarded += check_correct(device, &of, pairs, [&solve; 2], measured, &mut worst).or_raise();
            }
        }
        ensure!(guarded > 20 || device.small(), "{guarded} inside the guard");
        worst.report(device);
    }
}

pub(crate) fn a_wrong_setting_of_a_solve_is_told_apart(device: &Device) {
    let of = random_iteration(&mut rng(94), 333, SolidWalls);
    let check = |expected: &PressureSolve| {
        let mut worst = Worst::new(CorrectPressure::STAGE, tolerance_of_pairs(ROUNDING, CORRECT_HALF));
        check_correct(device, &of, FULL, [&solve(), expected], true, &mut worst)
    };
    check(&solve()).or_raise();
    for wrong in [
        PressureSolve { step: 0.601, ..solve() },
        PressureSolve { momentum: 0.301, ..solve() },
        PressureSolve { guarded_step: 0.501, ..solve() },
        PressureSolve { excess_share: 0.501, ..solve() },
        PressureSolve { room_share: 0.751, ..solve() },
        PressureSolve { solids_move: 0.99, ..solve() },
    ] {
        ensure!(check(&wrong).is_err(), "{wrong:?}");
    }
}

/// Applies changes; the velocities gained, checked against the twin, which is given `changes` times `share`.
fn check_apply(
    device: &Device,
    of: &Iteration,
    pairs: Pairs,
    share: f64,
    worst: &mut Worst,
) -> Result<Vec<DVec3>, Wrong> {
    let Iteration { case, factors, twins, pressures, changes, walls } = of;
    let count = case.count();
    let mut bench = Bench::new(device);
    let quantized_positions = bench.input("quantized_positions", &case.quantized_positions(pairs.quantization));
    let (neighbours, list_heads) = case.upload_neighbours(&mut bench);
    let pressure_factors = bench.input("pressure_factors", factors);
    let pressure_changes = bench.input("pressure_changes", changes);
    let mut pressure_buffer = bench.input("pressures", pressures);
    let mut velocities = bench.input("velocities", &case.velocities);
    let had = SolidContact { taken_m_s: [0.5, -0.25, 0.0], ..SolidContact::default() };
    let mut contacts = bench.input("solid_contacts", &vec![had; count]);
    let step_state = bench.uniform("step_state", case.step_state());
    let step_params = bench.uniform("step_params", case.step_params());
    let kernel = bench.uniform("kernel", kernel_params());
    // Of every other case a body takes nothing back: as if it were displacements.
    let gives_back = count % 2 == 1;
    let solve = bench.uniform("solve", PressureSolve { solids_move: f32::from(u8::from(gives_back)), ..solve() });
    let has_solids = *walls == SolidWalls;
    bench.dispatch(
        &ApplyPressure {
            variant: ApplyPressureVariant { walls: *walls, precision: pairs.precision },
            quantized_positions: quantized_positions.read(),
            neighbours: neighbours.read(),
            list_heads: list_heads.read(),
            pressure_factors: (*walls != Off).then(|| pressure_factors.read()),
            pressure_changes: pressure_changes.read(),
            pressures: pressure_buffer.write(),
            velocities: velocities.write(),
            solid_contacts: has_solids.then(|| contacts.write()),
            step_state: step_state.uniform(),
            step_params: step_params.uniform(),
            kernel: kernel.uniform(),
            solve: has_solids.then(|| solve.uniform()),
        },
        count,
    );
    let mut done = bench.run();
    let got = done.read(&velocities, count);
    let taken = done.read(&contacts, count);
    let totals = done.read(&pressure_buffer, count);
    let step = step_of(&case.step_params(), false);
    let smoothing = smoothing_of(&kernel_params());
    let at_m = case.quantized_m(pairs.quantization);
    let twin_changes: Vec<f64> = changes.iter().map(|&change| share * f64::from(change)).collect();
    for i in 0..count {
        let list = &case.neighbours[i];
        let Gain { gain_m_s, of_solids_m_s, terms_m_s } =
            apply_pressure(i, &at_m, &twin_changes, list, &twins[i], &step, &smoothing);
        let before_m_s = vector(case.velocities[i].velocity_m_s);
        worst.check3(got[i].velocity_m_s, before_m_s + gain_m_s, terms_m_s + before_m_s.length())?;
        let given_m_s = if has_solids && gives_back { of_solids_m_s } else { DVec3::ZERO };
        worst.check3(
            taken[i].taken_m_s,
            vector(had.taken_m_s) + given_m_s,
            terms_m_s + vector(had.taken_m_s).length(),
        )?;
        ensure_eq!(totals[i], pressures[i] + changes[i]);
    }
    Ok(got.iter().zip(&case.velocities).map(|(a, b)| vector(a.velocity_m_s) - vector(b.velocity_m_s)).collect())
}

pub(crate) fn apply_pressure_matches_its_twin(device: &Device) {
    for (pairs, rounding) in all_pairs(device) {
        let mut worst = device.worst(pairs.name(ApplyPressure::STAGE), tolerance_of_pairs(rounding, APPLY_HALF));
        let mut rng = rng(95);
        for walls in [Walls, SolidWalls, Off] {
            for size in pairs.sizes(device) {
                let of = random_iteration(&mut rng, size, walls);
                check_apply(device, &of, pairs, 1.0, &mut worst).or_raise();
            }
        }
        worst.report(device);
    }
    let of = random_iteration(&mut rng(96), 333, SolidWalls);
    let mut worst = Worst::new(ApplyPressure::STAGE, tolerance_of_pairs(ROUNDING, APPLY_HALF));
    ensure!(check_apply(device, &of, FULL, 1.001, &mut worst).is_err(), "other changes");
}

pub(crate) fn pressure_keeps_momentum_in_free_space(device: &Device) {
    let of = random_iteration(&mut rng(97), if device.small() { 333 } else { 2049 }, Off);
    let mut worst = device.worst("momentum of a push", tolerance_of_pairs(ROUNDING, APPLY_HALF));
    let gains = check_apply(device, &of, FULL, 1.0, &mut worst).or_raise();
    let sum: DVec3 = gains.iter().sum();
    let lengths: f64 = gains.iter().map(|gain| gain.length()).sum();
    note!(device, "momentum of a push: {:.1e} of {lengths:.1e} m/s", sum.length());
    ensure!(lengths > 1.0 && sum.length() < 1e-6 * lengths, "{sum} of {lengths}");
}
