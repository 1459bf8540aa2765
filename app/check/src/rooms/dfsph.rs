//! `solver/dfsph/` against its twins. Tolerances are those of sums over pairs (`tolerance_of_pairs`), relative to the sum of
//! the terms' lengths.

use super::pairs::{FULL, Pairs, all_pairs, case_for};
use crate::bench::Bench;
use crate::cases::{Around, Case, fluid, kernel_params, out_of_part, smoothing_of, step_of, walls_of};
use crate::compare::{ROUNDING, Worst, tolerance_of_pairs, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, Wrong, ensure, ensure_eq, note};
use brooklet_kernels::{
    ApplyPressure, ApplyPressureVariant, CorrectPressure, CorrectPressureVariant, FactorPressure,
    FactorPressureVariant, Kernel, Position, PressureFactors, PressureSolve, Velocity,
};
use brooklet_reference::boundary::mirror::Mirrors;
use brooklet_reference::params::Smoothing;
use brooklet_reference::shared::wendland;
use brooklet_reference::solver::dfsph::apply_pressure::apply_pressure;
use brooklet_reference::solver::dfsph::correct_pressure::{self as twin, GUARD, correct_pressure, density_change};
use brooklet_reference::solver::dfsph::factor_pressure::{
    self, SEPARATION, SEPARATION_SHIFT, factor_pressure, separation,
};
use glam::DVec3;
use rand::{Rng, RngExt};

/// Roundings of f16 that a factor may be off by, and a change of pressure, and a push.
const FACTOR_HALF: f64 = 8.0;
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

/// Factors of every kind, and as the twin has them. Walls, if there are any, are near or far from each, whatever stands around
/// it: what a pair sees of them is one's own.
pub(super) fn random_factors(
    rng: &mut impl Rng,
    case: &Case,
    walls: bool,
) -> (Vec<PressureFactors>, Vec<factor_pressure::PressureFactors>) {
    let of = |i: usize| {
        let mut number = || rng.random::<f32>() - 0.5;
        let gpu = PressureFactors {
            from_walls: if walls { std::array::from_fn(|_| 3.0 * number()) } else { [2.0; 3] },
            excess: 0.3 * number(),
            inverse_stiffness: if out_of_part(i) == 0 { 1.0 + number() } else { 0.0 },
            ..PressureFactors::default()
        };
        let twin = factor_pressure::PressureFactors {
            mirrors: Mirrors { from_walls: vector(gpu.from_walls) },
            excess: f64::from(gpu.excess),
            stiffness: 1.0 / f64::from(gpu.inverse_stiffness).max(f64::MIN_POSITIVE),
            is_simulated: out_of_part(i) == 0,
        };
        (gpu, twin)
    };
    (0..case.count()).map(of).unzip()
}

pub(crate) fn factor_pressure_matches_its_twin(device: &Device) {
    for (pairs, rounding) in all_pairs(device) {
        let tolerance = tolerance_of_pairs(rounding, FACTOR_HALF);
        let mut worst = device.worst(pairs.name(FactorPressure::STAGE), tolerance);
        let mut rng = rng(91);
        for walls in Around::ALL {
            for size in pairs.sizes(device) {
                let mut case = case_for(&mut rng, size, walls);
                case.positions.iter_mut().enumerate().for_each(|(i, at)| at.tag = i as u32 | out_of_part(i));
                let smoothing = smoothing_of(&kernel_params());
                check_factors(device, &case, walls, pairs, smoothing.weight, &mut worst).or_raise();
            }
        }
        worst.report(device);
    }
    let case = case_for(&mut rng(92), 333, Around::Walls);
    let check = |weight: f64| {
        let mut worst = Worst::new(FactorPressure::STAGE, tolerance_of_pairs(ROUNDING, FACTOR_HALF));
        check_factors(device, &case, Around::Walls, FULL, weight, &mut worst)
    };
    let weight = smoothing_of(&kernel_params()).weight;
    check(weight).or_raise();
    ensure!(check(1.001 * weight).is_err(), "another weight of neighbours");
}

/// What the kernel leaves: particles' positions, factors and partings.
fn run_factors(
    device: &Device,
    case: &Case,
    walls: bool,
    pairs: Pairs,
) -> (Vec<Position>, Vec<PressureFactors>, Vec<Velocity>) {
    let mut bench = Bench::new(device);
    let quantized_positions = bench.input("quantized_positions", &case.quantized_positions(pairs.quantization));
    let sorted_positions = bench.input("sorted_positions", &case.positions);
    let (neighbours, list_heads) = case.upload_neighbours(&mut bench);
    let mut positions = bench.output("positions", case.count());
    let mut pressure_factors = bench.output::<PressureFactors>("pressure_factors", case.count());
    let mut shifts = bench.output::<Velocity>("shifts", case.count());
    let step_state = bench.uniform("step_state", case.step_state());
    let step_params = bench.uniform("step_params", case.step_params());
    let kernel = bench.uniform("kernel", kernel_params());
    bench.dispatch(
        &FactorPressure {
            variant: FactorPressureVariant { walls, precision: pairs.precision },
            quantized_positions: quantized_positions.read(),
            sorted_positions: sorted_positions.read(),
            neighbours: neighbours.read(),
            list_heads: list_heads.read(),
            positions: positions.write(),
            pressure_factors: pressure_factors.write(),
            shifts: shifts.write(),
            step_state: step_state.uniform(),
            step_params: step_params.uniform(),
            kernel: kernel.uniform(),
        },
        case.count(),
    );
    let mut done = bench.run();
    (done.read(&positions, case.count()), done.read(&pressure_factors, case.count()), done.read(&shifts, case.count()))
}

fn check_factors(
    device: &Device,
    case: &Case,
    walls: Around,
    pairs: Pairs,
    weight: f64,
    worst: &mut Worst,
) -> Result<(), Wrong> {
    let (positions, got, parting) = run_factors(device, case, walls.has_walls(), pairs);
    ensure_eq!(positions, case.positions);
    let step = step_of(&case.step_params(), walls.has_walls());
    let box_walls = walls_of(&kernel_params(), step.domain_size_m);
    let box_walls = walls.has_walls().then_some(&box_walls);
    let smoothing = Smoothing { weight, ..smoothing_of(&kernel_params()) };
    let (at_m, exact_m) = (case.quantized_m(pairs.quantization), case.positions_m());
    for (i, got) in got.iter().enumerate() {
        // Pairs are of quantized positions, walls are seen from the particle's own.
        let mirrors = Mirrors::at(exact_m[i], box_walls);
        worst.check3(got.from_walls, mirrors.from_walls, 2.0)?;
        let is_simulated = out_of_part(i) == 0 || case.positions[i].tag == i as u32;
        let expected = factor_pressure(i, &at_m, &case.neighbours[i], &smoothing, mirrors, is_simulated);
        worst.check(got.excess, expected.excess, 2.0 + expected.excess)?;
        let inverse = if is_simulated { 1.0 / expected.stiffness } else { 0.0 };
        // Terms of the gradient's sum cancel.
        let lengths = slopes(i, &at_m, &case.neighbours[i], &smoothing, &mirrors);
        let scale = if is_simulated { inverse * (1.0 + lengths * lengths / expected.stiffness) } else { 1.0 };
        worst.check(got.inverse_stiffness, inverse, scale)?;
        // Who is at one point with another parts in a direction of the GPU's own: see below.
        let shift = separation(i, &at_m, &case.neighbours[i], &smoothing, |_, _| DVec3::ZERO);
        let shift_m_s = if is_simulated { shift * smoothing.support_m / step.dt_s } else { DVec3::ZERO };
        worst.check3(parting[i].velocity_m_s, shift_m_s, smoothing.support_m / step.dt_s)?;
    }
    Ok(())
}

/// What two particles so far apart, h, are parted by, in h.
fn parted(device: &Device, apart: f64, pairs: Pairs) -> ([DVec3; 2], [DVec3; 2]) {
    let mut case = case_for(&mut rng(98), 2, Around::Nothing);
    let smoothing = smoothing_of(&kernel_params());
    let to_m = apart * smoothing.support_m;
    case.positions[1] = Position { tag: 1, ..case.positions[0] };
    case.positions[1].position_m[1] += to_m as f32;
    case.neighbours = vec![vec![1], vec![0]];
    let (_, _, got) = run_factors(device, &case, false, pairs);
    let per_h = f64::from(case.step_params().dt_s) / smoothing.support_m;
    let at_m = case.quantized_m(pairs.quantization);
    let twin = |i: usize| separation(i, &at_m, &case.neighbours[i], &smoothing, |_, _| DVec3::ZERO);
    ([0, 1].map(|i| vector(got[i].velocity_m_s) * per_h), [twin(0), twin(1)])
}

pub(crate) fn pairs_that_are_too_close_part_oppositely(device: &Device) {
    for (pairs, rounding) in all_pairs(device) {
        // At one point it is as far as pairs may move, whatever direction is drawn.
        let ([one, other], _) = parted(device, 0.0, pairs);
        ensure!((one.length() / SEPARATION_SHIFT - 1.0).abs() < 1e-3, "{one}");
        ensure_eq!(one, -other, "{}", pairs.name("pairs"));
        let mut worst = device.worst(pairs.name("separation"), tolerance_of_pairs(rounding, FACTOR_HALF));
        for share in [0.1, 0.5, 0.9] {
            let (got, expected) = parted(device, share * SEPARATION, pairs);
            let scale = SEPARATION_SHIFT / SEPARATION;
            for (got, expected) in got.iter().zip(expected) {
                ensure!(expected.length() > 0.05 * SEPARATION_SHIFT);
                worst.check3(got.as_vec3().to_array(), expected, scale).or_raise();
                let mut wrong = Worst::new("separation", tolerance_of_pairs(rounding, FACTOR_HALF));
                let twice = wrong.check3(got.as_vec3().to_array(), 2.0 * expected, scale);
                ensure!(twice.is_err() || rounding > ROUNDING, "twice as far");
            }
        }
        worst.report(device);
        let (got, _) = parted(device, 1.1 * SEPARATION, pairs);
        ensure_eq!(got, [DVec3::ZERO; 2]);
    }
}

/// The sum of the lengths of the kernel's slopes of all that particle `i` sees.
fn slopes(i: usize, at_m: &[DVec3], list: &[usize], smoothing: &Smoothing, mirrors: &Mirrors) -> f64 {
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
    walls: bool,
}

fn random_iteration(rng: &mut impl Rng, size: usize, walls: bool) -> Iteration {
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
        let (mut change, mut terms) = density_change(i, &at_m, &v_m_s, list, own, &step, &smoothing);
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
        for (solve, measured, walls) in
            [(solve(), true, true), (first, true, false), (solve(), false, true), (solve(), false, false)]
        {
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
    let of = random_iteration(&mut rng(94), 333, true);
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
    let step_state = bench.uniform("step_state", case.step_state());
    let step_params = bench.uniform("step_params", case.step_params());
    let kernel = bench.uniform("kernel", kernel_params());
    bench.dispatch(
        &ApplyPressure {
            variant: ApplyPressureVariant { walls: *walls, precision: pairs.precision },
            quantized_positions: quantized_positions.read(),
            neighbours: neighbours.read(),
            list_heads: list_heads.read(),
            pressure_factors: walls.then(|| pressure_factors.read()),
            pressure_changes: pressure_changes.read(),
            pressures: pressure_buffer.write(),
            velocities: velocities.write(),
            step_state: step_state.uniform(),
            step_params: step_params.uniform(),
            kernel: kernel.uniform(),
        },
        count,
    );
    let mut done = bench.run();
    let got = done.read(&velocities, count);
    let totals = done.read(&pressure_buffer, count);
    let step = step_of(&case.step_params(), false);
    let smoothing = smoothing_of(&kernel_params());
    let at_m = case.quantized_m(pairs.quantization);
    let twin_changes: Vec<f64> = changes.iter().map(|&change| share * f64::from(change)).collect();
    for i in 0..count {
        let list = &case.neighbours[i];
        let (gain_m_s, terms_m_s) = apply_pressure(i, &at_m, &twin_changes, list, &twins[i], &step, &smoothing);
        let before_m_s = vector(case.velocities[i].velocity_m_s);
        worst.check3(got[i].velocity_m_s, before_m_s + gain_m_s, terms_m_s + before_m_s.length())?;
        ensure_eq!(totals[i], pressures[i] + changes[i]);
    }
    Ok(got.iter().zip(&case.velocities).map(|(a, b)| vector(a.velocity_m_s) - vector(b.velocity_m_s)).collect())
}

pub(crate) fn apply_pressure_matches_its_twin(device: &Device) {
    for (pairs, rounding) in all_pairs(device) {
        let mut worst = device.worst(pairs.name(ApplyPressure::STAGE), tolerance_of_pairs(rounding, APPLY_HALF));
        let mut rng = rng(95);
        for walls in [true, false] {
            for size in pairs.sizes(device) {
                let of = random_iteration(&mut rng, size, walls);
                check_apply(device, &of, pairs, 1.0, &mut worst).or_raise();
            }
        }
        worst.report(device);
    }
    let of = random_iteration(&mut rng(96), 333, true);
    let mut worst = Worst::new(ApplyPressure::STAGE, tolerance_of_pairs(ROUNDING, APPLY_HALF));
    ensure!(check_apply(device, &of, FULL, 1.001, &mut worst).is_err(), "other changes");
}

pub(crate) fn pressure_keeps_momentum_in_free_space(device: &Device) {
    let of = random_iteration(&mut rng(97), if device.small() { 333 } else { 2049 }, false);
    let mut worst = device.worst("momentum of a push", tolerance_of_pairs(ROUNDING, APPLY_HALF));
    let gains = check_apply(device, &of, FULL, 1.0, &mut worst).or_raise();
    let sum: DVec3 = gains.iter().sum();
    let lengths: f64 = gains.iter().map(|gain| gain.length()).sum();
    note!(device, "momentum of a push: {:.1e} of {lengths:.1e} m/s", sum.length());
    ensure!(lengths > 1.0 && sum.length() < 1e-6 * lengths, "{sum} of {lengths}");
}
