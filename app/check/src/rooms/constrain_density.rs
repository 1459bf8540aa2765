//! `solver/pbf/constrain_density.compute` against its twin, plain and with momentum.
//!
//! Tolerances are those of sums over pairs (`tolerance_of_pairs`).

use super::pairs::{FULL, Pairs, all_pairs, case_for};
use crate::bench::Bench;
use crate::cases::{Around, Case, fluid, kernel_params, pbf_of, pbf_params, smoothing_of, step_of, walls_of};
use crate::compare::{HALF_ROUNDING, ROUNDING, Worst, tolerance_of_pairs};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, Wrong, ensure, ensure_eq};
use brooklet_kernels::{
    ConstrainDensity, ConstrainDensityVariant, Kernel, MomentumKeyword, PbfIteration, PbfParams, PositionLambda,
    SmoothingKernelParams,
};
use brooklet_reference::solver::pbf::constrain_density::constrain_density;
use brooklet_reference::solver::pbf::momentum::{GUARD, Weights, accumulated_lambda, momentum_lambda};
use half::f16;
use rand::RngExt;

/// Roundings of f16 that a lambda may be off by: 2.7 are measured.
const CONSTRAIN_HALF: f64 = 8.0;

/// An iteration with momentum.
struct Momentum {
    accumulates: bool,
    iteration: PbfIteration,
    /// What stands in the particles' slots: of the iteration before, of all before that one.
    lambdas: Vec<f32>,
    totals: Vec<f32>,
}

fn run_constrain(device: &Device, case: &Case, pbf: PbfParams, walls: Around, pairs: Pairs) -> Vec<PositionLambda> {
    run_iteration(device, case, kernel_params(), pbf, walls, pairs, None)
}

/// With momentum after other iterations; a packed total comes back in its place as any other.
fn run_iteration(
    device: &Device,
    case: &Case,
    kernel: SmoothingKernelParams,
    pbf: PbfParams,
    walls: Around,
    pairs: Pairs,
    momentum: Option<&Momentum>,
) -> Vec<PositionLambda> {
    let mut bench = Bench::new(device);
    let start = case.quantized_positions(pairs.quantization);
    let quantized_positions = bench.input("quantized_positions", &start);
    let sorted_positions = bench.input("sorted_positions", &case.positions);
    let (neighbours, list_heads) = case.upload_neighbours(&mut bench);
    let keyword = match momentum {
        None => MomentumKeyword::Off,
        Some(Momentum { accumulates: false, .. }) => MomentumKeyword::Momentum,
        Some(_) => MomentumKeyword::AccumulatedMomentum,
    };
    let accumulates = keyword == MomentumKeyword::AccumulatedMomentum;
    // Lambdas are in the places of the iteration before; the positions there are not read.
    let nowhere = [0; 2];
    let full: Vec<PositionLambda> = match momentum {
        None => vec![PositionLambda::default(); case.count()],
        Some(before) => {
            let pairs = before.lambdas.iter().zip(&before.totals);
            pairs.map(|(&lambda, &total)| PositionLambda { quantized_position: nowhere, lambda, total }).collect()
        }
    };
    let packed: Vec<[u32; 2]> = full.iter().map(|l| [0, u32::from(f16::from_f32(l.lambda).to_bits())]).collect();
    let totals: Vec<f32> = full.iter().map(|l| l.total).collect();
    let mut position_lambdas = bench.input("position_lambdas", &full);
    let mut packed_position_lambdas = bench.input("packed_position_lambdas", &packed);
    let mut lambda_totals = bench.input("lambda_totals", &totals);
    let iteration = bench.uniform("iteration", momentum.map(|m| m.iteration).unwrap_or_default());
    let step_params = bench.uniform("step_params", case.step_params());
    let kernel = bench.uniform("kernel", kernel);
    let pbf = bench.uniform("pbf", pbf);
    let step_state = bench.uniform("step_state", case.step_state());
    bench.dispatch(
        &ConstrainDensity {
            variant: ConstrainDensityVariant {
                walls: walls.has_walls().into(),
                momentum: keyword,
                precision: pairs.precision,
            },
            quantized_positions: quantized_positions.read(),
            sorted_positions: walls.has_walls().then(|| sorted_positions.read()),
            neighbours: neighbours.read(),
            list_heads: list_heads.read(),
            solid_contacts: None,
            position_lambdas: (!pairs.packed()).then(|| position_lambdas.write()),
            packed_position_lambdas: pairs.packed().then(|| packed_position_lambdas.write()),
            lambda_totals: (accumulates && pairs.packed()).then(|| lambda_totals.write()),
            step_state: step_state.uniform(),
            step_params: step_params.uniform(),
            kernel: kernel.uniform(),
            pbf: pbf.uniform(),
            coarse_cells: None,
            coarse: None,
            iteration: momentum.is_some().then(|| iteration.uniform()),
        },
        case.count(),
    );
    let mut done = bench.run();
    if !pairs.packed() {
        return done.read(&position_lambdas, case.count());
    }
    let packed: Vec<[u32; 2]> = done.read(&packed_position_lambdas, case.count());
    let totals: Vec<f32> = if accumulates { done.read(&lambda_totals, case.count()) } else { vec![0.0; packed.len()] };
    let unpacked = |([x_y, z_lambda], total): ([u32; 2], f32)| PositionLambda {
        quantized_position: [x_y, z_lambda & 0xffff_0000],
        lambda: f16::from_bits(z_lambda as u16).to_f32(),
        total,
    };
    packed.into_iter().zip(totals).map(unpacked).collect()
}

pub(crate) fn constrain_density_matches_its_twin(device: &Device) {
    let (smoothing, pbf) = (smoothing_of(&kernel_params()), pbf_of(&pbf_params()));
    for (pairs, rounding) in all_pairs(device) {
        // A packed lambda is rounded to f16 at the end.
        let last = if pairs.packed() { HALF_ROUNDING } else { 0.0 };
        let mut worst =
            device.worst(pairs.name(ConstrainDensity::STAGE), tolerance_of_pairs(rounding, CONSTRAIN_HALF) + last);
        let mut rng = rng(31);
        let mut compressed = 0;
        for walls in Around::ALL {
            for size in pairs.sizes(device) {
                let case = case_for(&mut rng, size, walls);
                let got = run_constrain(device, &case, pbf_params(), walls, pairs);
                let step = step_of(&case.step_params(), walls.has_walls());
                let box_walls = walls_of(&kernel_params(), step.domain_size_m);
                let box_walls = walls.has_walls().then_some(&box_walls);
                let quantized_m = case.quantized_m(pairs.quantization);
                let start = case.quantized_positions(pairs.quantization);
                for (i, got) in got.iter().enumerate() {
                    // The GPU asks the walls at the position, which a packed one rounds.
                    let expected = constrain_density(i, &quantized_m, &case.neighbours[i], &smoothing, &pbf, box_walls);
                    compressed += usize::from(expected.lambda < 0.0);
                    ensure_eq!(got.quantized_position, pairs.quantization.of_pairs(start[i]));
                    // lambda = C / D: an error of C is divided by D, and one of D counts C times.
                    let scale = (1.0 + expected.constraint) / expected.denominator;
                    worst.check(got.lambda, expected.lambda, scale).or_raise();
                }
            }
        }
        ensure!(compressed > if pairs == FULL { 1000 } else { 100 } || device.small(), "{compressed} compressed");
        worst.report(device);
    }
}

pub(crate) fn without_mixing_a_lone_particle_is_no_fault(device: &Device) {
    // Nothing to divide by: no neighbours, no walls, cfm = 0.
    let case = fluid(&mut rng(32), 1);
    let pbf = PbfParams { cfm: 0.0, ..pbf_params() };
    let got = run_constrain(device, &case, pbf, Around::Nothing, FULL);
    ensure_eq!(got[0].lambda.abs(), 0.0);
}

/// Of the lattice's weight: fluids of the tests, squeezed to a third above rest density, are then about at rest, on
/// both sides of it and of the guard.
const REST_WEIGHT: f32 = 0.76;

/// An iteration of random lambdas before it.
fn random_momentum(rng: &mut impl rand::Rng, count: usize, accumulates: bool, first: bool) -> Momentum {
    let iteration = PbfIteration {
        step: 0.976,
        momentum: if first { 0.0 } else { 0.577 },
        guarded_step: 0.5,
        begins_cold: u32::from(first),
    };
    // As f16 holds them; of the first iteration what should not be read.
    let mut random = |least: f32| match first {
        true => f32::NAN,
        false => f16::from_f32(least * rng.random::<f32>()).to_f32(),
    };
    let lambdas = (0..count).map(|_| random(-0.05)).collect();
    let totals = (0..count).map(|_| random(-0.1)).collect();
    Momentum { accumulates, iteration, lambdas, totals }
}

/// Compares an iteration with momentum to its twin, whose weights may be others; how many particles were below rest,
/// inside the guard and above it.
fn check_momentum(
    device: &Device,
    case: &Case,
    walls: Around,
    pairs: Pairs,
    momentum: &Momentum,
    weights: &Weights,
    worst: &mut Worst,
) -> Result<[usize; 3], Wrong> {
    let kernel = SmoothingKernelParams { weight: REST_WEIGHT * kernel_params().weight, ..kernel_params() };
    let (smoothing, pbf) = (smoothing_of(&kernel), pbf_of(&pbf_params()));
    let got = run_iteration(device, case, kernel, pbf_params(), walls, pairs, Some(momentum));
    let step = step_of(&case.step_params(), walls.has_walls());
    let box_walls = walls_of(&kernel, step.domain_size_m);
    let box_walls = walls.has_walls().then_some(&box_walls);
    let quantized_m = case.quantized_m(pairs.quantization);
    let start = case.quantized_positions(pairs.quantization);
    let first = momentum.iteration.momentum == 0.0;
    let mut counts = [0; 3];
    for (i, got) in got.iter().enumerate() {
        let constraint = constrain_density(i, &quantized_m, &case.neighbours[i], &smoothing, &pbf, box_walls);
        let [before, earlier] =
            [&momentum.lambdas, &momentum.totals].map(|of| if first { 0.0 } else { f64::from(of[i]) });
        let total = earlier + before;
        let expected = match momentum.accumulates {
            true => accumulated_lambda(&constraint, weights, before, total),
            false => momentum_lambda(&constraint, weights, before),
        };
        ensure_eq!(got.quantized_position, pairs.quantization.of_pairs(start[i]));
        let excess = constraint.excess;
        counts[if excess < GUARD[0] { usize::from(excess > 0.0) } else { 2 }] += 1;
        // On which side of rest density it is, rounding may decide, and with it all of the momentum.
        if !momentum.accumulates && excess.abs() < worst.tolerance() * (1.0 + excess) {
            continue;
        }
        if momentum.accumulates && (f64::from(got.total) - total).abs() > 1e-6 {
            return Err(format!("total of particle {i}: {}, expected {total}", got.total).into());
        }
        // lambda = C / D: an error of C is divided by D, and one of D counts C times. In the guard it counts once
        // more, over the guard's width, as far as the guard changes lambda.
        let density = 1.0 + excess;
        let moved = weights.step * excess.abs() / constraint.denominator + before.abs();
        let scale = density * (1.0 / constraint.denominator + moved / (GUARD[1] - GUARD[0])) + total.abs();
        worst.check(got.lambda, expected, scale)?;
    }
    Ok(counts)
}

pub(crate) fn momentum_matches_its_twin(device: &Device) {
    for (pairs, rounding) in all_pairs(device) {
        let last = if pairs.packed() { HALF_ROUNDING } else { 0.0 };
        let tolerance = tolerance_of_pairs(rounding, CONSTRAIN_HALF) + last;
        let mut worst = device.worst(pairs.name("constrain_density with momentum"), tolerance);
        let mut rng = rng(37);
        let mut counts = [0; 3];
        for (accumulates, first) in [(false, false), (true, false), (false, true), (true, true)] {
            for walls in Around::ALL {
                for size in pairs.sizes(device) {
                    let case = case_for(&mut rng, size, walls);
                    let momentum = random_momentum(&mut rng, size, accumulates, first);
                    let weights = weights_of(&momentum.iteration);
                    let here = check_momentum(device, &case, walls, pairs, &momentum, &weights, &mut worst);
                    here.or_raise().iter().zip(&mut counts).for_each(|(here, count)| *count += here);
                }
            }
        }
        ensure!(device.small() || counts.iter().all(|&count| count > 100), "{counts:?}");
        worst.report(device);
    }
}

pub(crate) fn a_wrong_weight_of_an_iteration_is_told_apart(device: &Device) {
    let mut rng = rng(38);
    let case = case_for(&mut rng, 333, Around::Walls);
    for accumulates in [false, true] {
        let momentum = random_momentum(&mut rng, 333, accumulates, false);
        let right = weights_of(&momentum.iteration);
        let tolerance = tolerance_of_pairs(ROUNDING, CONSTRAIN_HALF);
        let check = |weights: &Weights| {
            let mut worst = Worst::new("constrain_density with momentum", tolerance);
            check_momentum(device, &case, Around::Walls, FULL, &momentum, weights, &mut worst)
        };
        check(&right).or_raise();
        for wrong in [
            Weights { step: 1.01 * right.step, ..right },
            Weights { momentum: 1.01 * right.momentum, ..right },
            Weights { guarded_step: 1.01 * right.guarded_step, ..right },
        ] {
            ensure!(check(&wrong).is_err(), "{wrong:?}");
        }
    }
}

fn weights_of(iteration: &PbfIteration) -> Weights {
    let [step, momentum, guarded_step] = [iteration.step, iteration.momentum, iteration.guarded_step].map(f64::from);
    Weights { step, momentum, guarded_step }
}
