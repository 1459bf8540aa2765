//! The stages of the coarse correction against their twins: on grids past the edges of groups and tiles, with axes of
//! one cell, odd and even, and every kind of end.

use crate::bench::Bench;
use crate::cases::{
    STORAGES, fluid, kernel_params, out_of_part, pbf_params, precisions, quantization_of, scattered, sizes,
    smoothing_of, step_state, walls_of,
};
use crate::compare::{HALF_ROUNDING, ROUNDING, Worst, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, ensure, ensure_eq};
use brooklet_kernels::{
    COARSE_OPEN, COARSE_PERIODIC, COARSE_TILE, COARSE_WALL, CoarseCell, CoarseGridParams, CoarsenConstraint,
    ConstrainDensity, ConstrainDensityVariant, MomentumKeyword, PbfIteration, PositionLambda, PrecisionKeyword,
    ProlongMultiplier, ProlongMultiplierVariant, RelaxMultiplier, RelaxMultiplierVariant, SmoothingKernelParams,
};
use brooklet_reference::measure::density::density_ratio;
use brooklet_reference::solver::pbf::coarse_correction::{
    Cell, CoarseGrid, UNITS, coarsen_constraint, prolong_multiplier, relax_multiplier, restrict_constraint, share,
};
use glam::DVec3;
use half::f16;
use rand::{Rng, RngExt};

const W: u32 = COARSE_WALL;
const P: u32 = COARSE_PERIODIC;
const O: u32 = COARSE_OPEN;

/// Grids, finest cells and ends: of one cell, around a tile and a group, flat, long, and three tiles along an axis.
const GRIDS: [([u32; 3], [u32; 3]); 8] = [
    ([1, 1, 1], [W, W, W]),
    ([3, 1, 2], [P, P, O]),
    ([7, 8, 9], [P, W, P]),
    ([8, 8, 1], [O, P, W]),
    ([4, 4, 4], [W, O, P]),
    ([65, 1, 1], [W, W, W]),
    ([5, 13, 1], [P, O, W]),
    ([10, 17, 9], [P, W, O]),
];

pub(super) fn grids(device: &Device) -> impl Iterator<Item = ([u32; 3], [u32; 3])> {
    let small = device.small();
    GRIDS.into_iter().filter(move |(cells, _)| !small || cells.iter().product::<u32>() < 100)
}

/// A level of a grid with cells of a twentieth of a metre, 8 particles each.
pub(super) fn level_of(finest_cells: [u32; 3], ends: [u32; 3], halvings: u32) -> CoarseGridParams {
    CoarseGridParams {
        cells: finest_cells.map(|n| n.div_ceil(1 << halvings)),
        halvings,
        finest_cells,
        sweeps: 4 + halvings,
        inverse_cell_size_per_m: [20.0, 21.0, 22.0],
        mixing: 0.02,
        conductance: [0.25, 0.2, 0.15],
        particles_a_cell: 8.0,
        ends,
        most: 0.25,
        least: -0.002,
        ..CoarseGridParams::default()
    }
}

pub(super) fn twin_of(finest_cells: [u32; 3], ends: [u32; 3]) -> CoarseGrid {
    let levels: Vec<CoarseGridParams> = (0..6).map(|halvings| level_of(finest_cells, ends, halvings)).collect();
    CoarseGrid::of(&levels).or_raise()
}

/// Cells of which a third is empty or belongs to the surface.
fn random_cells(rng: &mut impl Rng, level: &CoarseGridParams) -> (Vec<CoarseCell>, Vec<Cell>) {
    let count = level.cells.iter().product::<u32>();
    let full = 8 << (3 * level.halvings);
    let cells: Vec<CoarseCell> = (0..count)
        .map(|_| {
            let particles = rng.random_range(0..=full);
            let mean = 0.06 * rng.random::<f64>() - 0.02;
            CoarseCell { constraint_sum: (f64::from(particles) * UNITS * mean) as i32, particles }
        })
        .collect();
    let twins = cells
        .iter()
        .map(|cell| Cell { constraint_sum: f64::from(cell.constraint_sum), particles: cell.particles })
        .collect();
    (cells, twins)
}

pub(crate) fn coarsen_constraint_is_exact(device: &Device) {
    let mut rng = rng(90);
    for (finest, ends) in grids(device).chain([([130, 2, 1], [W, W, W]), ([126, 1, 1], [W, W, W])]) {
        for halvings in [1, 2] {
            let (finer, level) = (level_of(finest, ends, halvings - 1), level_of(finest, ends, halvings));
            let (cells, twins) = random_cells(&mut rng, &finer);
            let count = level.cells.iter().product::<u32>() as usize;
            let mut bench = Bench::new(device);
            let finer_cells = bench.input("finer_cells", &cells);
            let mut coarse_cells = bench.output::<CoarseCell>("coarse_cells", count);
            let coarse = bench.uniform("coarse", level);
            bench.dispatch(
                &CoarsenConstraint {
                    finer_cells: finer_cells.read(),
                    coarse_cells: coarse_cells.write(),
                    coarse: coarse.uniform(),
                },
                count,
            );
            let got: Vec<CoarseCell> = bench.run().read(&coarse_cells, count);
            let expected = coarsen_constraint(&twin_of(finest, ends), halvings, &twins);
            for (got, expected) in got.iter().zip(&expected) {
                ensure_eq!(
                    (f64::from(got.constraint_sum), got.particles),
                    (expected.constraint_sum, expected.particles),
                    "{finest:?}"
                );
            }
        }
    }
}

/// Relaxes a level on the GPU, from above if there are multipliers of a coarser one.
fn relax(device: &Device, level: CoarseGridParams, cells: &[CoarseCell], coarser: Option<&[f32]>) -> Vec<f32> {
    let count = cells.len();
    let mut bench = Bench::new(device);
    let coarse_cells = bench.input("coarse_cells", cells);
    let coarser_multipliers = bench.input("coarser_multipliers", coarser.unwrap_or_default());
    let mut multipliers = bench.output::<f32>("multipliers", count);
    let params = bench.uniform("coarse", level);
    let (_, recording) = bench.parts();
    recording.dispatch_groups(
        &RelaxMultiplier {
            variant: RelaxMultiplierVariant { prolonged: coarser.is_some() },
            coarse_cells: coarse_cells.read(),
            multipliers: multipliers.write(),
            coarse: params.uniform(),
            coarser_multipliers: coarser.map(|_| coarser_multipliers.read()),
        },
        level.cells.map(|n| n.div_ceil(COARSE_TILE)),
    );
    bench.run().read(&multipliers, count)
}

/// A level's cells, and multipliers of the level above it if it is to have one.
fn relax_case(rng: &mut impl Rng, level: &CoarseGridParams) -> (Vec<CoarseCell>, Vec<Cell>, Option<Vec<f32>>) {
    let (cells, twins) = random_cells(rng, level);
    let coarser = (level.halvings < 2).then(|| {
        let count = level.finest_cells.map(|n| n.div_ceil(2 << level.halvings)).iter().product::<u32>();
        (0..count).map(|_| (rng.random::<f32>() - 0.3).max(0.0)).collect()
    });
    (cells, twins, coarser)
}

fn wide(values: &[f32]) -> Vec<f64> {
    values.iter().map(|&value| f64::from(value)).collect()
}

/// Of multipliers of 1: each is a mean of those around it with a rounding for each of its dozen operations, and mixing
/// and what is held around a tile forget older ones within some ten sweeps.
const RELAX: f64 = 256.0 * ROUNDING;

pub(crate) fn relax_multiplier_matches_its_twin(device: &Device) {
    let mut rng = rng(91);
    let mut worst = device.worst("relax_multiplier", RELAX);
    let mut positive = 0;
    for (finest, ends) in grids(device) {
        let twin = twin_of(finest, ends);
        for halvings in 0..3 {
            let level = level_of(finest, ends, halvings);
            // The coarsest level is one tile.
            if halvings == 2 && level.cells.iter().any(|&n| n > COARSE_TILE) {
                continue;
            }
            let (cells, twins, coarser) = relax_case(&mut rng, &level);
            let got = relax(device, level, &cells, coarser.as_deref());
            let expected = relax_multiplier(&twin, halvings, &twins, coarser.as_deref().map(wide).as_deref());
            for (got, expected) in got.iter().zip(&expected) {
                positive += usize::from(*expected > 0.0);
                worst.check(*got, *expected, 1.0).or_raise();
            }
        }
    }
    ensure!(positive > 100, "{positive}");
    worst.report(device);
}

pub(crate) fn a_wrong_end_mixing_conductance_or_sweep_is_told_apart(device: &Device) {
    let mut rng = rng(92);
    let (finest, ends) = ([7, 8, 9], [P, W, O]);
    let level = level_of(finest, ends, 0);
    let (cells, twins, coarser) = relax_case(&mut rng, &level);
    let got = relax(device, level, &cells, coarser.as_deref());
    let coarser = coarser.as_deref().map(wide);
    let check = |twin: &CoarseGrid| {
        let expected = relax_multiplier(twin, 0, &twins, coarser.as_deref());
        let mut worst = Worst::new("relax_multiplier", RELAX);
        got.iter().zip(&expected).try_for_each(|(got, expected)| worst.check(*got, *expected, 1.0))
    };
    let right = twin_of(finest, ends);
    check(&right).or_raise();
    let mut wrong = vec![twin_of(finest, [W, W, O]), twin_of(finest, [P, O, O]), twin_of(finest, [P, W, W])];
    wrong.push(CoarseGrid { mixing: 1.01 * right.mixing, ..right.clone() });
    wrong.push(CoarseGrid { conductance: DVec3::new(0.25, 0.2, 0.151), ..right.clone() });
    wrong.push(CoarseGrid { most: 0.26, ..right.clone() });
    wrong.push(CoarseGrid { least: 0.0, ..right.clone() });
    wrong.push(CoarseGrid { particles_a_cell: 9.0, ..right.clone() });
    wrong.push(CoarseGrid { sweeps: vec![5; 6], ..right });
    for wrong in &wrong {
        ensure!(check(wrong).is_err(), "{wrong:?}");
    }
}

pub(crate) fn prolong_multiplier_matches_its_twin(device: &Device) {
    let mut rng = rng(93);
    for precision in STORAGES {
        let packed = precision != PrecisionKeyword::Off;
        let rounding = if packed { HALF_ROUNDING } else { ROUNDING };
        let mut worst = device.worst(format!("prolong_multiplier {precision:?}"), 16.0 * rounding);
        for (finest, ends) in grids(device) {
            for count in sizes(device, 64) {
                let level = level_of(finest, ends, 0);
                let twin = twin_of(finest, ends);
                let size_m = twin.cell_m * DVec3::from_array(finest.map(f64::from));
                let positions = scattered(&mut rng, count, size_m);
                let multipliers: Vec<f32> = (0..finest.iter().product::<u32>()).map(|_| rng.random::<f32>()).collect();
                // Share and total of a warm start, as f16 in one word.
                let shares: Vec<[f16; 2]> =
                    (0..count).map(|_| [rng.random::<f32>(), -0.1 * rng.random::<f32>()].map(f16::from_f32)).collect();
                let word = |[share, total]: [f16; 2]| {
                    f32::from_bits(u32::from(share.to_bits()) | u32::from(total.to_bits()) << 16)
                };
                let share_words: Vec<f32> = shares.iter().map(|&pair| word(pair)).collect();
                // As f16 holds them; the bits of a position stand beside them.
                let before: Vec<f16> = (0..count).map(|_| f16::from_f32(-rng.random::<f32>())).collect();
                let quantized = |i: usize| [i as u32 * 0x1_0001, (i as u32) << 16];
                let full: Vec<PositionLambda> = (0..count)
                    .map(|i| PositionLambda {
                        quantized_position: quantized(i),
                        lambda: before[i].to_f32(),
                        total: share_words[i],
                    })
                    .collect();
                let words: Vec<[u32; 2]> =
                    (0..count).map(|i| [quantized(i)[0], quantized(i)[1] | u32::from(before[i].to_bits())]).collect();
                let mut bench = Bench::new(device);
                let sorted_positions = bench.input("sorted_positions", &positions);
                let finest_multipliers = bench.input("multipliers", &multipliers);
                let mut position_lambdas = bench.input("position_lambdas", &full);
                let mut packed_position_lambdas = bench.input("packed_position_lambdas", &words);
                let mut lambda_totals = bench.input("lambda_totals", &share_words);
                let state = bench.uniform("step_state", step_state(count, 0.0));
                let coarse = bench.uniform("coarse", level);
                bench.dispatch(
                    &ProlongMultiplier {
                        variant: ProlongMultiplierVariant { precision },
                        sorted_positions: sorted_positions.read(),
                        multipliers: finest_multipliers.read(),
                        step_state: state.uniform(),
                        coarse: coarse.uniform(),
                        position_lambdas: (!packed).then(|| position_lambdas.write()),
                        packed_position_lambdas: packed.then(|| packed_position_lambdas.write()),
                        lambda_totals: packed.then(|| lambda_totals.write()),
                    },
                    count,
                );
                let mut done = bench.run();
                let got: Vec<([u32; 2], f32)> = if packed {
                    let got: Vec<[u32; 2]> = done.read(&packed_position_lambdas, count);
                    let totals = done.read::<f32>(&lambda_totals, count);
                    ensure!(totals.iter().zip(&shares).all(|(&total, pair)| total == pair[1].to_f32()));
                    let unpacked = |[x_y, z]: [u32; 2]| ([x_y, z & 0xffff_0000], f16::from_bits(z as u16).to_f32());
                    got.into_iter().map(unpacked).collect()
                } else {
                    let got: Vec<PositionLambda> = done.read(&position_lambdas, count);
                    ensure!(got.iter().zip(&shares).all(|(lambda, pair)| lambda.total == pair[1].to_f32()));
                    got.into_iter().map(|lambda| (lambda.quantized_position, lambda.lambda)).collect()
                };
                let multipliers = wide(&multipliers);
                for (i, (position, lambda)) in got.into_iter().enumerate() {
                    ensure_eq!(position, quantized(i));
                    let added = match out_of_part(i) {
                        0 => prolong_multiplier(&twin, &multipliers, vector(positions[i].position_m)),
                        _ => 0.0,
                    };
                    // A place of up to 65 cells rounds by as many roundings of 1.
                    let scale = 2.0 + finest.iter().max().copied().map_or(0.0, f64::from) / 16.0;
                    worst
                        .check(lambda, f64::from(before[i].to_f32()) + f64::from(shares[i][0].to_f32()) * added, scale)
                        .or_raise();
                }
            }
        }
        worst.report(device);
    }
}

/// About at rest: see `constrain_density`.
const REST_WEIGHT: f32 = 0.76;

pub(crate) fn constraints_are_restricted_to_their_cells(device: &Device) {
    let mut rng = rng(94);
    let mut between = 0;
    let kernel = SmoothingKernelParams { weight: REST_WEIGHT * kernel_params().weight, ..kernel_params() };
    let variants = precisions(device).into_iter().flat_map(|(precision, _)| [(precision, false), (precision, true)]);
    let sizes = sizes(device, 64);
    for ((precision, walls), &count) in variants.flat_map(|variant| sizes.iter().map(move |count| (variant, count))) {
        let mut case = fluid(&mut rng, count);
        for (i, position) in case.positions.iter_mut().enumerate() {
            position.tag |= out_of_part(i);
        }
        // Half of the domain along x: what is behind it is in no cell.
        let finest = [2, 5, 3];
        let inverse = (DVec3::from_array(finest.map(f64::from)) / (case.size_m * DVec3::new(0.5, 1.0, 1.0))).as_vec3();
        let level = CoarseGridParams { inverse_cell_size_per_m: inverse.to_array(), ..level_of(finest, [O; 3], 0) };
        let quantization = quantization_of(precision);
        let packed = precision != PrecisionKeyword::Off;
        let mut bench = Bench::new(device);
        let quantized_positions = bench.input("quantized_positions", &case.quantized_positions(quantization));
        let sorted_positions = bench.input("sorted_positions", &case.positions);
        let (neighbours, list_heads) = case.upload_neighbours(&mut bench);
        let mut position_lambdas = bench.output::<PositionLambda>("position_lambdas", count);
        let mut packed_position_lambdas = bench.output::<[u32; 2]>("packed_position_lambdas", count);
        let mut lambda_totals = bench.output::<f32>("lambda_totals", count);
        let mut coarse_cells = bench.output::<CoarseCell>("coarse_cells", 30);
        let iteration = bench
            .uniform("iteration", PbfIteration { step: 0.6, guarded_step: 0.5, begins_cold: 1, ..Default::default() });
        let step_params = bench.uniform("step_params", case.step_params());
        let smoothing_kernel = bench.uniform("kernel", kernel);
        let pbf = bench.uniform("pbf", pbf_params());
        let state = bench.uniform("step_state", case.step_state());
        let coarse = bench.uniform("coarse", level);
        bench.dispatch(
            &ConstrainDensity {
                variant: ConstrainDensityVariant {
                    walls: walls.into(),
                    momentum: MomentumKeyword::RestrictedMomentum,
                    precision,
                },
                quantized_positions: quantized_positions.read(),
                sorted_positions: Some(sorted_positions.read()),
                neighbours: neighbours.read(),
                list_heads: list_heads.read(),
                solid_contacts: None,
                position_lambdas: (!packed).then(|| position_lambdas.write()),
                packed_position_lambdas: packed.then(|| packed_position_lambdas.write()),
                lambda_totals: packed.then(|| lambda_totals.write()),
                step_state: state.uniform(),
                step_params: step_params.uniform(),
                kernel: smoothing_kernel.uniform(),
                pbf: pbf.uniform(),
                coarse_cells: Some(coarse_cells.write()),
                coarse: Some(coarse.uniform()),
                iteration: Some(iteration.uniform()),
            },
            count,
        );
        let mut done = bench.run();
        let got: Vec<CoarseCell> = done.read(&coarse_cells, 30);
        let shares: Vec<f32> = match packed {
            true => done.read(&lambda_totals, count),
            false => done.read(&position_lambdas, count).iter().map(|lambda| lambda.total).collect(),
        };
        let (quantized_m, smoothing) = (case.quantized_m(quantization), smoothing_of(&kernel));
        let box_walls = walls_of(&kernel, vector(case.step_params().domain_size_m));
        let box_walls = walls.then_some(&box_walls);
        let constraint = |i: usize| density_ratio(i, &quantized_m, &case.neighbours[i], &smoothing, box_walls) - 1.0;
        for (i, word) in shares.into_iter().enumerate() {
            // Beside a total of 0.
            ensure!(word.to_bits() >> 16 == 0, "{word}");
            let got = f16::from_bits(word.to_bits() as u16).to_f32();
            let expected = share(constraint(i));
            between += usize::from(expected > 0.0 && expected < 1.0);
            // The ratio's roundings, over the width of 0.12 that shares fall in; and f16's own.
            let tolerance = if packed { 2e-2 } else { 6e-4 };
            ensure!((f64::from(got) - expected).abs() <= tolerance, "{i}: {got} {expected}");
        }
        let particles =
            (0..count).filter(|&i| out_of_part(i) == 0).map(|i| (vector(case.positions[i].position_m), constraint(i)));
        let expected = restrict_constraint(&CoarseGrid::of(&[level]).or_raise(), particles);
        let inside: u32 = expected.iter().map(|cell| cell.particles).sum();
        ensure!(count < 100 || (inside > 20 && (inside as usize) < count), "{inside} of {count}");
        for (got, expected) in got.iter().zip(&expected) {
            ensure_eq!(got.particles, expected.particles);
            // A ratio rounds by some 1e-5, or of f16 by 2e-3 at worst: below a unit, or 64.
            let tolerance = f64::from(got.particles) * if packed { 64.0 } else { 1.0 };
            let difference = (f64::from(got.constraint_sum) - expected.constraint_sum).abs();
            ensure!(difference <= tolerance, "{got:?} {expected:?}");
        }
    }
    ensure!(between > 20, "{between} shares are neither all nor nothing");
}
