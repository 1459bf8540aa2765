//! `solver/pbf/` against its twins: corrections and velocities. `constrain_density.rs` has the constraint.
//!
//! Tolerances are those of sums over pairs (`tolerance_of_pairs`).

use super::pairs::{FULL, Pairs, all_pairs, case_for};
use crate::bench::Bench;
use crate::cases::{
    Around, Case, STORAGES, fluid, kernel_params, pbf_of, pbf_params, quantization_of, sizes, smoothing_of, step_of,
    step_state, walls_of,
};
use crate::compare::{ROUNDING, tolerance_of_pairs, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, ensure, ensure_eq, note};
use brooklet_kernels::{
    CorrectPositions, CorrectPositionsVariant, Counters, Kernel, PbfParams, Position, PositionLambda, PrecisionKeyword,
    StepParams, UpdateVelocity, UpdateVelocityVariant, Velocity, VelocityKeyword,
};
use brooklet_reference::shared::quantized_position::Quantization;
use brooklet_reference::solver::pbf::correct_positions::{MAX_DISPLACEMENT, correct_positions};
use brooklet_reference::solver::pbf::update_velocity::update_velocity;
use glam::DVec3;
use half::f16;
use rand::RngExt;

/// Roundings of f16 that a correction may be off by: 1.2 are measured.
const CORRECT_HALF: f64 = 4.0;

struct Corrected {
    after: Vec<[u32; 2]>,
    /// How far each particle went, in h, if that is less than two along each axis.
    moved: Vec<DVec3>,
    clamps: u32,
    held: u32,
}

fn run_correct(
    device: &Device,
    case: &Case,
    lambdas: &[f32],
    pbf: PbfParams,
    walls: Around,
    s_corr: bool,
    pairs: Pairs,
) -> Corrected {
    run_correct_from(device, (&case.positions, case), lambdas, pbf, walls, s_corr, pairs)
}

/// As [`run_correct`], of particles that earlier iterations have moved to where they are from `predicted`.
fn run_correct_from(
    device: &Device,
    (predicted, case): (&[Position], &Case),
    lambdas: &[f32],
    pbf: PbfParams,
    walls: Around,
    s_corr: bool,
    pairs: Pairs,
) -> Corrected {
    let mut bench = Bench::new(device);
    let start = case.quantized_positions(pairs.quantization);
    let with_lambdas = || start.iter().zip(lambdas);
    let full: Vec<PositionLambda> = with_lambdas()
        .map(|(&quantized_position, &lambda)| PositionLambda { quantized_position, lambda, total: 0.0 })
        .collect();
    let packed: Vec<[u32; 2]> = with_lambdas()
        .map(|(&quantized, &lambda)| {
            let [x_y, z] = pairs.quantization.of_pairs(quantized);
            [x_y, z | u32::from(f16::from_f32(lambda).to_bits())]
        })
        .collect();
    let position_lambdas = bench.input("position_lambdas", &full);
    let packed_position_lambdas = bench.input("packed_position_lambdas", &packed);
    let sorted_positions = bench.input("sorted_positions", predicted);
    let (neighbours, list_heads) = case.upload_neighbours(&mut bench);
    let mut quantized_positions = bench.input("quantized_positions", &start);
    let mut counters = bench.input("counters", &[Counters::default()]);
    let step_params = bench.uniform("step_params", case.step_params());
    let kernel = bench.uniform("kernel", kernel_params());
    let pbf = bench.uniform("pbf", pbf);
    let step_state = bench.uniform("step_state", case.step_state());
    bench.dispatch(
        &CorrectPositions {
            variant: CorrectPositionsVariant { walls: walls.has_walls().into(), s_corr, precision: pairs.precision },
            position_lambdas: (!pairs.packed()).then(|| position_lambdas.read()),
            packed_position_lambdas: pairs.packed().then(|| packed_position_lambdas.read()),
            sorted_positions: sorted_positions.read(),
            neighbours: neighbours.read(),
            list_heads: list_heads.read(),
            solid_contacts: None,
            quantized_positions: quantized_positions.write(),
            counters: counters.write(),
            step_state: step_state.uniform(),
            step_params: step_params.uniform(),
            kernel: kernel.uniform(),
            pbf: pbf.uniform(),
            solids_params: None,
        },
        case.count(),
    );
    let mut done = bench.run();
    let after: Vec<[u32; 2]> = done.read(&quantized_positions, case.count());
    let moved = start.iter().zip(&after).map(|(&before, &after)| pairs.quantization.offset(after, before)).collect();
    let counters = done.read(&counters, 1)[0];
    Corrected { after, moved, clamps: counters.correction_clamps, held: counters.displacement_clamps }
}

pub(crate) fn correct_positions_matches_its_twin(device: &Device) {
    let smoothing = smoothing_of(&kernel_params());
    for (pairs, rounding) in all_pairs(device) {
        let tolerance = tolerance_of_pairs(rounding, CORRECT_HALF);
        let mut worst = device.worst(pairs.name(CorrectPositions::STAGE), tolerance);
        let mut rng = rng(33);
        let mut all_clamps = 0;
        for (walls, s_corr) in Around::ALL.into_iter().flat_map(|walls| [(walls, false), (walls, true)]) {
            let params = match s_corr {
                true => pbf_params(),
                false => PbfParams { s_corr_k: 0.0, ..pbf_params() },
            };
            let pbf = pbf_of(&params);
            for size in pairs.sizes(device) {
                let case = case_for(&mut rng, size, walls);
                // Lambdas that an f16 holds exactly, so that packing them loses nothing.
                let lambdas: Vec<f32> = (0..size).map(|_| -(rng.random_range(0..1024) as f32) / 1024.0).collect();
                let got = run_correct(device, &case, &lambdas, params, walls, s_corr, pairs);
                let step = step_of(&case.step_params(), walls.has_walls());
                let box_walls = walls_of(&kernel_params(), step.domain_size_m);
                let box_walls = walls.has_walls().then_some(&box_walls);
                let quantized_m = case.quantized_m(pairs.quantization);
                let lambdas: Vec<f64> = lambdas.iter().map(|&l| f64::from(l)).collect();
                let (mut clamps, mut doubtful) = (0, 0);
                for i in 0..size {
                    let expected = correct_positions(
                        i,
                        &quantized_m,
                        quantized_m[i],
                        &lambdas,
                        &case.neighbours[i],
                        &step,
                        &smoothing,
                        &pbf,
                        box_walls,
                        |_, _| DVec3::ZERO,
                    );
                    clamps += u32::from(expected.clamped);
                    let doubt = (1e-4_f64).max(tolerance * expected.terms_m / pbf.max_correction_m);
                    let near = (expected.asked_m / pbf.max_correction_m - 1.0).abs() < doubt;
                    doubtful += u32::from(near);
                    // The GPU's walls are at the position's own distance, which the quantized one rounds by
                    // up to half a step an axis; so does the move that is stored.
                    let steps_m = 2.0 * pairs.quantization.step() * smoothing.support_m;
                    let scale = expected.terms_m + quantized_m[i].length() + steps_m / tolerance;
                    // A case outside narrow walls is moved in by more than a quantized position can tell: the
                    // position meant is the nearest to the expected one.
                    let got_m = pairs.quantization.near(got.after[i], expected.position_m / smoothing.support_m);
                    let error_m = got_m * smoothing.support_m - expected.position_m;
                    worst.check3(error_m.to_array().map(|x| x as f32), DVec3::ZERO, scale).or_raise();
                }
                let counted = got.clamps.abs_diff(clamps) <= doubtful;
                ensure!(counted, "{} clamps, expected {clamps} but for {doubtful}", got.clamps);
                all_clamps += clamps;
            }
        }
        ensure!(all_clamps > 0, "no case met the limit of a correction");
        worst.report(device);
    }
}

pub(crate) fn corrections_hold_the_whole_displacement_below_the_support(device: &Device) {
    let (smoothing, pbf) = (smoothing_of(&kernel_params()), pbf_of(&pbf_params()));
    for (pairs, rounding) in all_pairs(device) {
        let tolerance = tolerance_of_pairs(rounding, CORRECT_HALF);
        let mut worst = device.worst(format!("{}, held", pairs.name(CorrectPositions::STAGE)), tolerance);
        let mut rng = rng(35);
        let mut held = 0;
        for size in pairs.sizes(device) {
            let case = case_for(&mut rng, size, Around::Nothing);
            let lambdas: Vec<f32> = (0..size).map(|_| -(rng.random_range(0..1024) as f32) / 1024.0).collect();
            // Where they were predicted: up to a support away, a third of them all but that.
            let predicted: Vec<Position> = case
                .positions
                .iter()
                .map(|position| {
                    let share: f64 = rng.random::<f64>().max(if rng.random_range(0..3) == 0 { 0.998 } else { 0.0 });
                    let way: DVec3 =
                        DVec3::from_array([0; 3].map(|_| rng.random::<f64>() - 0.5)).normalize_or(DVec3::X);
                    let at_m = vector(position.position_m) + 0.998 * share * smoothing.support_m * way;
                    Position { position_m: at_m.to_array().map(|x| x as f32), tag: position.tag }
                })
                .collect();
            let got =
                run_correct_from(device, (&predicted, &case), &lambdas, pbf_params(), Around::Nothing, true, pairs);
            let from =
                Case { positions: predicted, velocities: Vec::new(), neighbours: Vec::new(), size_m: case.size_m };
            let (predicted_m, quantized_m) =
                (from.quantized_m(pairs.quantization), case.quantized_m(pairs.quantization));
            let step = step_of(&case.step_params(), false);
            let lambdas: Vec<f64> = lambdas.iter().map(|&l| f64::from(l)).collect();
            let (mut expected_held, mut doubtful) = (0, 0);
            for i in 0..size {
                let none = |_, _| DVec3::ZERO;
                let list = &case.neighbours[i];
                let expected = correct_positions(
                    i,
                    &quantized_m,
                    predicted_m[i],
                    &lambdas,
                    list,
                    &step,
                    &smoothing,
                    &pbf,
                    None,
                    none,
                );
                expected_held += u32::from(expected.held);
                let rounded = tolerance * expected.terms_m / smoothing.support_m + 2.0 * pairs.quantization.step();
                doubtful += u32::from((expected.displacement - MAX_DISPLACEMENT).abs() < rounded.max(1e-5));
                let steps_m = 2.0 * pairs.quantization.step() * smoothing.support_m;
                let scale = expected.terms_m + quantized_m[i].length() + steps_m / tolerance;
                let got_m = pairs.quantization.near(got.after[i], expected.position_m / smoothing.support_m);
                let error_m = got_m * smoothing.support_m - expected.position_m;
                worst.check3(error_m.to_array().map(|x| x as f32), DVec3::ZERO, scale).or_raise();
            }
            ensure!(
                got.held.abs_diff(expected_held) <= doubtful,
                "{} held, expected {expected_held} but for {doubtful}",
                got.held
            );
            held += expected_held;
        }
        ensure!(held > 0, "no case met the limit");
        worst.report(device);
    }
}

pub(crate) fn corrections_keep_momentum_in_free_space(device: &Device) {
    let mut rng = rng(34);
    let size = if device.small() { 333 } else { 2049 };
    let case = fluid(&mut rng, size);
    let lambdas: Vec<f32> = (0..size).map(|_| -0.02 * rng.random::<f32>()).collect();
    // A shortened correction would have no opposite.
    let pbf = PbfParams { max_correction_m: 1.0, ..pbf_params() };
    let got = run_correct(device, &case, &lambdas, pbf, Around::Nothing, true, FULL);
    ensure_eq!(got.clamps, 0);
    let sum: DVec3 = got.moved.iter().sum();
    let lengths: f64 = got.moved.iter().map(|moved| moved.length()).sum();
    // Each move rounds by at most half a step an axis.
    let bound = 0.5 * Quantization::Full.step() * size as f64 * 3.0_f64.sqrt() + 1e-6 * lengths;
    note!(device, "momentum of a correction: {:.1e} of {lengths:.1e} h", sum.length());
    ensure!(lengths > 0.1 && sum.length() < bound, "{sum} of {lengths}");
}

pub(crate) fn particles_at_one_point_part_oppositely(device: &Device) {
    let mut case = fluid(&mut rng(35), 2);
    case.positions[1].position_m = case.positions[0].position_m;
    case.neighbours = vec![vec![1], vec![0]];
    for (pairs, _) in all_pairs(device) {
        let got = run_correct(device, &case, &[-1.0, -1.0], pbf_params(), Around::Nothing, false, pairs);
        ensure!(got.moved[0].length() > 1e-5, "{:?}", got.moved);
        ensure_eq!(got.moved[0], -got.moved[1], "{}", pairs.name("pairs"));
    }
}

pub(crate) fn update_velocity_matches_its_twin(device: &Device) {
    let mut slowed = 0;
    for precision in STORAGES {
        let quantization = quantization_of(precision);
        // A difference of quantized positions, exact, a product, a quotient and a sum; then the speed limit.
        let mut worst = device.worst(UpdateVelocity::STAGE, 20.0 * ROUNDING);
        let mut moves = device.worst("update_velocity, positions", 4.0 * ROUNDING);
        let mut rng = rng(36);
        for size in sizes(device, UpdateVelocity::GROUP_SIZE[0] as usize) {
            let mut case = fluid(&mut rng, size);
            for position in case.positions.iter_mut().step_by(7) {
                position.tag |= 1 << 31;
            }
            let start = case.quantized_positions(quantization);
            let mut moved_h = || quantization.fixed_point(0.125 * (rng.random::<f64>() - 0.5));
            let corrected: Vec<[u32; 2]> = start
                .iter()
                .map(|&at| quantization.pack(quantization.coordinates(at).map(|c| c.wrapping_add(moved_h()))))
                .collect();
            let params = case.step_params();
            let (positions, velocities, counters) =
                run_update(device, &case, &corrected, params, precision, VelocityKeyword::Off);
            let step = step_of(&params, false);
            let mut clamps = 0;
            for i in 0..size {
                ensure_eq!(positions[i].tag, case.positions[i].tag);
                if case.positions[i].tag >> 31 == 1 {
                    ensure_eq!(positions[i], case.positions[i], "quarantined particles stay");
                    ensure_eq!(velocities[i], case.velocities[i], "quarantined particles stay");
                    continue;
                }
                let from = vector(case.positions[i].position_m);
                let to = from + quantization.offset(corrected[i], start[i]) * f64::from(kernel_params().support_m);
                moves.check3(positions[i].position_m, to, to.length()).or_raise();
                let before = vector(case.velocities[i].velocity_m_s);
                let (expected, fast) = update_velocity(from, to, before, &step);
                clamps += u32::from(fast);
                let scale = before.length() + (to - from).length() / step.dt_s;
                worst.check3(velocities[i].velocity_m_s, expected, scale).or_raise();
            }
            ensure_eq!(counters.speed_clamps, clamps);
            slowed += clamps;
            // Where velocities stand already it is the same, bit for bit.
            let in_place = VelocityKeyword::InPlaceVelocity;
            let (moved, updated, counters) = run_update(device, &case, &corrected, params, precision, in_place);
            ensure!(moved == positions && updated == velocities);
            ensure_eq!(counters.speed_clamps, clamps);
            // Positions are those of the other variant, whatever velocities are.
            let keep = VelocityKeyword::KeepVelocity;
            let (moved, kept, counters) = run_update(device, &case, &corrected, params, precision, keep);
            ensure!(moved == positions && kept == case.velocities);
            ensure_eq!(counters.speed_clamps, 0);
        }
        worst.report(device);
        moves.report(device);
    }
    ensure!(slowed > 0, "no case met the speed limit");
}

fn run_update(
    device: &Device,
    case: &Case,
    corrected: &[[u32; 2]],
    params: StepParams,
    precision: PrecisionKeyword,
    velocity: VelocityKeyword,
) -> (Vec<brooklet_kernels::Position>, Vec<Velocity>, Counters) {
    let mut bench = Bench::new(device);
    let corrected = bench.input("quantized_positions", corrected);
    let kernel = bench.uniform("kernel", kernel_params());
    let sorted_positions = bench.input("sorted_positions", &case.positions);
    let sorted_velocities = bench.input("sorted_velocities", &case.velocities);
    let mut positions = bench.output("positions", case.count());
    let (takes, in_place) = (velocity != VelocityKeyword::KeepVelocity, velocity == VelocityKeyword::InPlaceVelocity);
    let mut velocities = match in_place {
        true => bench.input("velocities", &case.velocities),
        false => bench.output("velocities", case.count()),
    };
    let mut counters = bench.input("counters", &[Counters::default()]);
    let step_params = bench.uniform("step_params", params);
    let step_state = bench.uniform("step_state", step_state(case.count(), params.dt_s));
    let periodic = params.period_m != [0.0; 3];
    bench.dispatch(
        &UpdateVelocity {
            variant: UpdateVelocityVariant { precision, periodic, velocity },
            quantized_positions: corrected.read(),
            step_state: step_state.uniform(),
            kernel: kernel.uniform(),
            sorted_positions: sorted_positions.read(),
            sorted_velocities: (!in_place).then(|| sorted_velocities.read()),
            positions: positions.write(),
            velocities: velocities.write(),
            counters: takes.then(|| counters.write()),
            step_params: (takes || periodic).then(|| step_params.uniform()),
        },
        case.count(),
    );
    let mut done = bench.run();
    (done.read(&positions, case.count()), done.read(&velocities, case.count()), done.read(&counters, 1)[0])
}
