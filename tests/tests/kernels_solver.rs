//! `solver/pbf/` against its twins: the constraint and its corrections.
//!
//! A sum has some 30 terms, each of a handful of roundings; they add up to a tolerance of 64
//! roundings, relative to the sum of the terms' lengths.

use brooklet_fluid::boundary::wall_weights;
use brooklet_kernels::{
    ConstrainDensity, ConstrainDensityVariant, CorrectPositions, CorrectPositionsVariant, Counters, Iterate, Kernel,
    PbfParams, StepParams, UpdateVelocity, Velocity, WallsKeyword,
};
use brooklet_reference::boundary::walls::DomainWalls;
use brooklet_reference::solver::pbf::constrain_density::constrain_density;
use brooklet_reference::solver::pbf::correct_positions::correct_positions;
use brooklet_reference::solver::pbf::update_velocity::update_velocity;
use brooklet_tests::cases::{
    Case, SUPPORT_M, SUPPORT_RATIO, fluid, kernel_params, pbf_of, pbf_params, sizes, smoothing_of, step_of, wall_table,
};
use brooklet_tests::compare::{ROUNDING, Worst, vector};
use brooklet_tests::harness::Bench;
use brooklet_tests::rng;
use glam::DVec3;
use rand::RngExt;

/// See the head of this file.
const TOLERANCE: f64 = 64.0 * ROUNDING;

const ALL_WALLS: [WallsKeyword; 3] = [WallsKeyword::Off, WallsKeyword::Walls, WallsKeyword::NarrowWalls];

/// A case whose domain has opposite walls in reach of one particle, if the variant is for that.
fn case_for(rng: &mut impl rand::Rng, size: usize, walls: WallsKeyword) -> Case {
    let mut case = fluid(rng, size);
    if walls == WallsKeyword::NarrowWalls {
        case.size_m = case.size_m.min(DVec3::new(1.4 * SUPPORT_M, 9.0, 1.1 * SUPPORT_M));
    }
    case
}

fn run_constrain(case: &Case, pbf: PbfParams, walls: WallsKeyword) -> Vec<Iterate> {
    let mut bench = Bench::new();
    let iterates = bench.input("iterates", &case.iterates(&[]));
    let (neighbours, neighbour_counts) = case.upload_neighbours(&mut bench);
    let mut constrained = bench.output("constrained", case.count());
    let weights = bench.input("wall_weights", &wall_weights(SUPPORT_RATIO));
    let step_params = bench.uniform("step_params", case.step_params());
    let kernel = bench.uniform("kernel", kernel_params());
    let pbf = bench.uniform("pbf", pbf);
    bench.dispatch(
        &ConstrainDensity {
            variant: ConstrainDensityVariant { walls },
            iterates: iterates.read(),
            neighbours: neighbours.read(),
            neighbour_counts: neighbour_counts.read(),
            constrained: constrained.write(),
            wall_weights: (walls != WallsKeyword::Off).then(|| weights.read()),
            step_params: step_params.uniform(),
            kernel: kernel.uniform(),
            pbf: pbf.uniform(),
        },
        case.count(),
    );
    bench.run().read(&constrained, case.count())
}

#[test]
fn constrain_density_matches_its_twin() {
    let mut worst = Worst::new(ConstrainDensity::STAGE, TOLERANCE);
    let mut rng = rng(31);
    let table = wall_table(&wall_weights(SUPPORT_RATIO));
    let (smoothing, pbf) = (smoothing_of(&kernel_params()), pbf_of(&pbf_params()));
    let mut compressed = 0;
    for walls in ALL_WALLS {
        for size in sizes(ConstrainDensity::GROUP_SIZE[0] as usize) {
            let case = case_for(&mut rng, size, walls);
            let got = run_constrain(&case, pbf_params(), walls);
            let step = step_of(&case.step_params(), walls != WallsKeyword::Off);
            let box_walls =
                DomainWalls { weight: &table, domain_size_m: step.domain_size_m, support_m: smoothing.support_m };
            let box_walls = (walls != WallsKeyword::Off).then_some(&box_walls);
            let positions_m = case.positions_m();
            for (i, got) in got.iter().enumerate() {
                let expected = constrain_density(i, &positions_m, &case.neighbours[i], &smoothing, &pbf, box_walls);
                compressed += usize::from(expected.lambda < 0.0);
                assert_eq!(got.position_m, case.positions[i].position_m);
                // lambda = C / D: an error of C is divided by D, and one of D counts C times.
                let scale = (1.0 + expected.constraint) / expected.denominator;
                worst.check(got.lambda, expected.lambda, scale).unwrap();
            }
        }
    }
    assert!(compressed > 1000 || brooklet_tests::harness::small(), "{compressed} compressed");
    worst.report();
}

#[test]
fn without_mixing_a_lone_particle_is_no_fault() {
    // Nothing to divide by: no neighbours, no walls, cfm = 0.
    let case = fluid(&mut rng(32), 1);
    let pbf = PbfParams { cfm: 0.0, ..pbf_params() };
    let got = run_constrain(&case, pbf, WallsKeyword::Off);
    assert_eq!(got[0].lambda.abs(), 0.0);
}

struct Corrected {
    iterates: Vec<Iterate>,
    clamps: u32,
}

fn run_correct(case: &Case, lambdas: &[f32], pbf: PbfParams, walls: WallsKeyword, s_corr: bool) -> Corrected {
    let mut bench = Bench::new();
    let constrained = bench.input("constrained", &case.iterates(lambdas));
    let (neighbours, neighbour_counts) = case.upload_neighbours(&mut bench);
    let mut iterates = bench.output("iterates", case.count());
    let mut counters = bench.input("counters", &[Counters::default()]);
    let weights = bench.input("wall_weights", &wall_weights(SUPPORT_RATIO));
    let step_params = bench.uniform("step_params", case.step_params());
    let kernel = bench.uniform("kernel", kernel_params());
    let pbf = bench.uniform("pbf", pbf);
    bench.dispatch(
        &CorrectPositions {
            variant: CorrectPositionsVariant { walls, s_corr },
            constrained: constrained.read(),
            neighbours: neighbours.read(),
            neighbour_counts: neighbour_counts.read(),
            iterates: iterates.write(),
            counters: counters.write(),
            wall_weights: (walls != WallsKeyword::Off).then(|| weights.read()),
            step_params: step_params.uniform(),
            kernel: kernel.uniform(),
            pbf: pbf.uniform(),
        },
        case.count(),
    );
    let mut done = bench.run();
    Corrected { iterates: done.read(&iterates, case.count()), clamps: done.read(&counters, 1)[0].correction_clamps }
}

#[test]
fn correct_positions_matches_its_twin() {
    let mut worst = Worst::new(CorrectPositions::STAGE, TOLERANCE);
    let mut rng = rng(33);
    let table = wall_table(&wall_weights(SUPPORT_RATIO));
    let smoothing = smoothing_of(&kernel_params());
    let mut all_clamps = 0;
    for walls in ALL_WALLS {
        for s_corr in [false, true] {
            let params = match s_corr {
                true => pbf_params(),
                false => PbfParams { s_corr_k: 0.0, ..pbf_params() },
            };
            let pbf = pbf_of(&params);
            for size in sizes(CorrectPositions::GROUP_SIZE[0] as usize) {
                let case = case_for(&mut rng, size, walls);
                let lambdas: Vec<f32> = (0..size).map(|_| -rng.random::<f32>()).collect();
                let got = run_correct(&case, &lambdas, params, walls, s_corr);
                let step = step_of(&case.step_params(), walls != WallsKeyword::Off);
                let box_walls =
                    DomainWalls { weight: &table, domain_size_m: step.domain_size_m, support_m: smoothing.support_m };
                let box_walls = (walls != WallsKeyword::Off).then_some(&box_walls);
                let positions_m = case.positions_m();
                let lambdas: Vec<f64> = lambdas.iter().map(|&l| f64::from(l)).collect();
                let (mut clamps, mut doubtful) = (0, 0);
                for i in 0..size {
                    let expected = correct_positions(
                        i,
                        &positions_m,
                        &lambdas,
                        &case.neighbours[i],
                        &step,
                        &smoothing,
                        &pbf,
                        box_walls,
                        |_, _| DVec3::ZERO,
                    );
                    clamps += u32::from(expected.clamped);
                    let near = (expected.asked_m / pbf.max_correction_m - 1.0).abs() < 1e-4;
                    doubtful += u32::from(near);
                    assert_eq!(got.iterates[i].lambda, 0.0);
                    let scale = expected.terms_m + positions_m[i].length();
                    worst.check3(got.iterates[i].position_m, expected.position_m, scale).unwrap();
                }
                let counted = got.clamps.abs_diff(clamps) <= doubtful;
                assert!(counted, "{} clamps, expected {clamps} but for {doubtful}", got.clamps);
                all_clamps += clamps;
            }
        }
    }
    assert!(all_clamps > 0, "no case met the limit of a correction");
    worst.report();
}

#[test]
fn corrections_keep_momentum_in_free_space() {
    let mut rng = rng(34);
    let size = if brooklet_tests::harness::small() { 333 } else { 2049 };
    let case = fluid(&mut rng, size);
    let lambdas: Vec<f32> = (0..size).map(|_| -0.02 * rng.random::<f32>()).collect();
    // A shortened correction would have no opposite.
    let pbf = PbfParams { max_correction_m: 1.0, ..pbf_params() };
    let got = run_correct(&case, &lambdas, pbf, WallsKeyword::Off, true);
    assert_eq!(got.clamps, 0);
    let (mut sum, mut lengths) = (DVec3::ZERO, 0.0);
    for (after, before) in got.iterates.iter().zip(&case.positions) {
        let moved = vector(after.position_m) - vector(before.position_m);
        sum += moved;
        lengths += moved.length();
    }
    // Each position rounds once, by at most half its last place: less than 1.6e-8 m below 0.5 m.
    let bound = 1.6e-8 * size as f64 * 3.0_f64.sqrt() + 1e-6 * lengths;
    println!("momentum of a correction: {:.1e} of {lengths:.1e} m", sum.length());
    assert!(lengths > 1e-3 && sum.length() < bound, "{sum} of {lengths}");
}

#[test]
fn particles_at_one_point_part_oppositely() {
    let mut case = fluid(&mut rng(35), 2);
    case.positions[1].position_m = case.positions[0].position_m;
    case.neighbours = vec![vec![1], vec![0]];
    let got = run_correct(&case, &[-1.0, -1.0], pbf_params(), WallsKeyword::Off, false);
    let start = vector(case.positions[0].position_m);
    let moved = [0, 1].map(|i| vector(got.iterates[i].position_m) - start);
    let distance_m = moved[0].length();
    assert!(distance_m > 1e-6, "{distance_m}");
    assert!((moved[0] + moved[1]).length() < 1e-8, "{moved:?}");
}

#[test]
fn update_velocity_matches_its_twin() {
    // A difference of positions, exact for near ones, a quotient and a sum; then the speed limit.
    let mut worst = Worst::new(UpdateVelocity::STAGE, 20.0 * ROUNDING);
    let mut rng = rng(36);
    let mut slowed = 0;
    for size in sizes(UpdateVelocity::GROUP_SIZE[0] as usize) {
        let mut case = fluid(&mut rng, size);
        for position in case.positions.iter_mut().step_by(7) {
            position.tag |= 1 << 31;
        }
        let corrected: Vec<Iterate> = case
            .positions
            .iter()
            .map(|p| Iterate { position_m: p.position_m.map(|x| x + 0.005 * (rng.random::<f32>() - 0.5)), lambda: 0.0 })
            .collect();
        let params = case.step_params();
        let (positions, velocities, counters) = run_update(&case, &corrected, params);
        let step = step_of(&params, false);
        let mut clamps = 0;
        for i in 0..size {
            assert_eq!(positions[i].tag, case.positions[i].tag);
            if case.positions[i].tag >> 31 == 1 {
                assert_eq!(positions[i], case.positions[i], "quarantined particles stay");
                assert_eq!(velocities[i], case.velocities[i], "quarantined particles stay");
                continue;
            }
            assert_eq!(positions[i].position_m, corrected[i].position_m);
            let [from, to] = [case.positions[i].position_m, corrected[i].position_m].map(vector);
            let before = vector(case.velocities[i].velocity_m_s);
            let (expected, fast) = update_velocity(from, to, before, &step);
            clamps += u32::from(fast);
            let scale = before.length() + (to - from).length() / step.dt_s;
            worst.check3(velocities[i].velocity_m_s, expected, scale).unwrap();
        }
        assert_eq!(counters.speed_clamps, clamps);
        slowed += clamps;
    }
    assert!(slowed > 0, "no case met the speed limit");
    worst.report();
}

fn run_update(
    case: &Case,
    corrected: &[Iterate],
    params: StepParams,
) -> (Vec<brooklet_kernels::Position>, Vec<Velocity>, Counters) {
    let mut bench = Bench::new();
    let iterates = bench.input("iterates", corrected);
    let sorted_positions = bench.input("sorted_positions", &case.positions);
    let sorted_velocities = bench.input("sorted_velocities", &case.velocities);
    let mut positions = bench.output("positions", case.count());
    let mut velocities = bench.output("velocities", case.count());
    let mut counters = bench.input("counters", &[Counters::default()]);
    let step_params = bench.uniform("step_params", params);
    bench.dispatch(
        &UpdateVelocity {
            iterates: iterates.read(),
            sorted_positions: sorted_positions.read(),
            sorted_velocities: sorted_velocities.read(),
            positions: positions.write(),
            velocities: velocities.write(),
            counters: counters.write(),
            step_params: step_params.uniform(),
        },
        case.count(),
    );
    let mut done = bench.run();
    (done.read(&positions, case.count()), done.read(&velocities, case.count()), done.read(&counters, 1)[0])
}
