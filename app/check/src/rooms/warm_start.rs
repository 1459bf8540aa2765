//! A warm start's two kernels against their twins.

use crate::bench::Bench;
use crate::cases::{
    Case, STORAGES, SUPPORT_M, fluid, kernel_params, out_of_part, pbf_of, pbf_params, quantization_of, sizes, step_of,
    step_state,
};
use crate::compare::{ROUNDING, Worst, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, ensure};
use brooklet_kernels::{
    CellSlot, KeepPressure, KeepPressureVariant, Kernel, PbfParams, PositionLambda, PrecisionKeyword, StartWarm,
    StartWarmVariant, WarmStart,
};
use brooklet_reference::particles::predict::Pressure;
use brooklet_reference::shared::quantized_position::Quantization;
use brooklet_reference::solver::pbf::warm_start::{keep_pressure, start_warm};
use glam::DVec3;
use half::f16;
use rand::seq::SliceRandom;
use rand::{Rng, RngExt};

fn params() -> PbfParams {
    PbfParams { warm_start: 0.3, ..pbf_params() }
}

/// A fluid of which some take no part.
fn case_of(rng: &mut impl Rng, size: usize) -> Case {
    let mut case = fluid(rng, size);
    case.positions.iter_mut().enumerate().for_each(|(i, position)| position.tag = i as u32 | out_of_part(i));
    case
}

/// As large that every third is cut.
fn random_warm_starts(rng: &mut impl Rng, size: usize, dt_s: f32) -> Vec<WarmStart> {
    let most = 3.0 * params().max_correction_m / (params().warm_start * dt_s * dt_s);
    let mut number = || rng.random::<f32>() - 0.5;
    (0..size)
        .map(|_| WarmStart {
            acceleration_m_s2: [0; 3].map(|_| most * number()),
            multiplier_per_s2: 1.0e3 * (number() - 0.5),
        })
        .collect()
}

fn check_start(
    device: &Device,
    worst: &mut [Worst; 2],
    rng: &mut impl Rng,
    size: usize,
    precision: PrecisionKeyword,
    walls: bool,
) {
    let quantization = quantization_of(precision);
    let case = case_of(rng, size);
    let (step, pbf) = (case.step_params(), params());
    let warm_starts = random_warm_starts(rng, size, step.dt_s);
    // A cell a particle, in any order.
    let mut sorted: Vec<u32> = (0..size as u32).collect();
    sorted.shuffle(rng);
    let slots: Vec<CellSlot> = sorted.iter().map(|&cell| CellSlot { cell, rank: 0 }).collect();
    let starts: Vec<u32> = (0..=size as u32).collect();
    let unsorted = case.quantized_positions(quantization);
    let mut quantized = unsorted.clone();
    sorted.iter().zip(&unsorted).for_each(|(&to, &from)| quantized[to as usize] = from);

    let is_packed = quantization == Quantization::Packed;
    let mut bench = Bench::new(device);
    let positions = bench.input("positions", &case.positions);
    let warm = bench.input("warm_starts", &warm_starts);
    let cell_slots = bench.input("cell_slots", &slots);
    let cell_starts = bench.input("cell_starts", &starts);
    let mut quantized_positions = bench.input("quantized_positions", &quantized);
    // What stands there is another iteration's.
    let garbage = PositionLambda { lambda: 3.0, total: 4.0, ..PositionLambda::default() };
    let mut lambdas = bench.input("position_lambdas", &vec![garbage; size]);
    let mut packed = bench.input("packed_position_lambdas", &vec![[7_u32, 7]; size]);
    let mut totals = bench.input("lambda_totals", &vec![5.0_f32; size]);
    let state = bench.uniform("step_state", step_state(size, step.dt_s));
    let step_params = bench.uniform("step_params", step);
    let kernel = bench.uniform("kernel", kernel_params());
    let pbf_buffer = bench.uniform("pbf", pbf);
    bench.dispatch(
        &StartWarm {
            variant: StartWarmVariant { walls, precision },
            positions: positions.read(),
            warm_starts: warm.read(),
            cell_slots: cell_slots.read(),
            cell_starts: cell_starts.read(),
            quantized_positions: quantized_positions.write(),
            position_lambdas: (!is_packed).then(|| lambdas.write()),
            packed_position_lambdas: is_packed.then(|| packed.write()),
            lambda_totals: is_packed.then(|| totals.write()),
            step_state: state.uniform(),
            step_params: walls.then(|| step_params.uniform()),
            kernel: kernel.uniform(),
            pbf: pbf_buffer.uniform(),
        },
        size,
    );
    let mut done = bench.run();
    let moved = done.read(&quantized_positions, size);
    let (got_lambdas, got_totals): (Vec<f32>, Vec<f32>) = match is_packed {
        true => {
            let lambdas = done.read(&packed, size);
            (lambdas.iter().map(|l| (l[0] | l[1]) as f32).collect(), done.read(&totals, size))
        }
        false => done.read(&lambdas, size).iter().map(|l| (l.lambda, l.total)).unzip(),
    };
    ensure!(got_lambdas.iter().all(|&lambda| lambda == 0.0), "no lambda stands before the first");
    for (i, &to) in sorted.iter().enumerate() {
        let to = to as usize;
        let predicted_m = vector(case.positions[i].position_m);
        let pressure = Pressure {
            acceleration_m_s2: vector(warm_starts[i].acceleration_m_s2),
            multiplier_per_s2: f64::from(warm_starts[i].multiplier_per_s2),
        };
        let (start_m, total) = match out_of_part(i) {
            0 => start_warm(predicted_m, &pressure, &step_of(&step, walls), &pbf_of(&pbf)),
            _ => (predicted_m, 0.0),
        };
        let displacement = quantization.offset(moved[to], quantized[to]);
        let expected = (start_m - predicted_m) / SUPPORT_M;
        worst[0].check3(displacement.to_array().map(|x| x as f32), expected, 1.0).or_raise();
        worst[1].check(got_totals[to], total, total.abs().max(1e-3)).or_raise();
    }
}

pub(crate) fn start_warm_matches_its_twin(device: &Device) {
    for precision in STORAGES {
        // Rounded to a step along three axes; from positions of up to 100 h in f32.
        let step_h = quantization_of(precision).step();
        let moved = device.worst(format!("{} {precision:?}, moved", StartWarm::STAGE), step_h + 200.0 * ROUNDING);
        let sums = device.worst(format!("{} {precision:?}, sums", StartWarm::STAGE), 16.0 * ROUNDING);
        let mut worst = [moved, sums];
        let mut rng = rng(95);
        for size in sizes(device, StartWarm::GROUP_SIZE[0] as usize) {
            for walls in [false, true] {
                check_start(device, &mut worst, &mut rng, size, precision, walls);
            }
        }
        worst.iter_mut().for_each(|worst| worst.report(device));
        ensure!(worst[0].check3([0.001, 0.0, 0.0], DVec3::ZERO, 1.0).is_err());
    }
}

pub(crate) fn keep_pressure_matches_its_twin(device: &Device) {
    for precision in STORAGES {
        let quantization = quantization_of(precision);
        let is_packed = quantization == Quantization::Packed;
        let mut worst = device.worst(format!("{} {precision:?}", KeepPressure::STAGE), 64.0 * ROUNDING);
        let mut rng = rng(96);
        for size in sizes(device, KeepPressure::GROUP_SIZE[0] as usize) {
            let case = case_of(&mut rng, size);
            let dt_s = case.step_params().dt_s;
            let starts = case.quantized_positions(quantization);
            // Up to half a support along each axis.
            let steps = (0.5 / quantization.step()) as i32;
            let quantized: Vec<[u32; 2]> = starts
                .iter()
                .map(|&start| {
                    let coordinates = quantization.coordinates(start);
                    let unit = 1_u32 << (32 - quantization.bits());
                    let moved = coordinates
                        .map(|c| c.wrapping_add((rng.random_range(-steps..=steps) as u32).wrapping_mul(unit)));
                    quantization.pack(moved)
                })
                .collect();
            let lambdas: Vec<[f32; 2]> = (0..size)
                .map(|_| [f16::from_f32(0.02 * rng.random::<f32>() - 0.01).to_f32(), -0.1 * rng.random::<f32>()])
                .collect();
            let mut bench = Bench::new(device);
            let quantized_positions = bench.input("quantized_positions", &quantized);
            let sorted_positions = bench.input("sorted_positions", &case.positions);
            let full: Vec<PositionLambda> = lambdas
                .iter()
                .map(|&[lambda, total]| PositionLambda { lambda, total, ..PositionLambda::default() })
                .collect();
            let full = bench.input("position_lambdas", &full);
            let packed: Vec<[u32; 2]> =
                lambdas.iter().map(|&[lambda, _]| [0, u32::from(f16::from_f32(lambda).to_bits())]).collect();
            let packed = bench.input("packed_position_lambdas", &packed);
            let totals = bench.input("lambda_totals", &lambdas.iter().map(|l| l[1]).collect::<Vec<_>>());
            let mut warm_starts = bench.output::<WarmStart>("warm_starts", size);
            let state = bench.uniform("step_state", step_state(size, dt_s));
            let kernel = bench.uniform("kernel", kernel_params());
            bench.dispatch(
                &KeepPressure {
                    variant: KeepPressureVariant { precision },
                    quantized_positions: quantized_positions.read(),
                    sorted_positions: sorted_positions.read(),
                    position_lambdas: (!is_packed).then(|| full.read()),
                    packed_position_lambdas: is_packed.then(|| packed.read()),
                    lambda_totals: is_packed.then(|| totals.read()),
                    warm_starts: warm_starts.write(),
                    step_state: state.uniform(),
                    kernel: kernel.uniform(),
                },
                size,
            );
            for (i, got) in bench.run().read(&warm_starts, size).iter().enumerate() {
                let moved_m = SUPPORT_M * quantization.offset(quantized[i], starts[i]);
                let total = f64::from(lambdas[i][0]) + f64::from(lambdas[i][1]);
                let expected = match out_of_part(i) {
                    0 => keep_pressure(DVec3::ZERO, moved_m, total, f64::from(dt_s)),
                    _ => Pressure::default(),
                };
                let per_s2 = f64::from(dt_s).powi(-2);
                worst.check3(got.acceleration_m_s2, expected.acceleration_m_s2, SUPPORT_M * per_s2).or_raise();
                worst.check(got.multiplier_per_s2, expected.multiplier_per_s2, 0.1 * per_s2).or_raise();
            }
        }
        worst.report(device);
        ensure!(worst.check(1.0001, 1.0, 1.0).is_err());
    }
}
