//! `solver/dfsph/factor_pressure` against its twin. Tolerances are those of sums over pairs, as in `dfsph`.

use super::dfsph::{slopes, solids_of};
use super::pairs::{FULL, Pairs, all_pairs, case_for};
use crate::bench::Bench;
use crate::cases::{Around, Case, SUPPORT_M, kernel_params, out_of_part, smoothing_of, step_of, walls_of};
use crate::compare::{ROUNDING, Worst, tolerance_of_pairs, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, Wrong, ensure, ensure_eq};
use brooklet_kernels::{
    FactorPressure, FactorPressureVariant, Kernel, Position, PressureFactors, SolidContact, Velocity,
    WallsKeyword::{self, SolidWalls},
};
use brooklet_reference::boundary::mirror::{Mirrors, pack_direction, unpack_direction};
use brooklet_reference::params::Smoothing;
use brooklet_reference::solver::dfsph::factor_pressure::{SEPARATION, SEPARATION_SHIFT, factor_pressure, separation};
use glam::DVec3;
use rand::RngExt;

/// Roundings of f16 that a factor may be off by.
const FACTOR_HALF: f64 = 8.0;

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
                for solids in [false, true] {
                    check_factors(device, &case, (walls, solids), pairs, smoothing.weight, &mut worst).or_raise();
                }
            }
        }
        worst.report(device);
    }
    let case = case_for(&mut rng(92), 333, Around::Walls);
    let check = |weight: f64| {
        let mut worst = Worst::new(FactorPressure::STAGE, tolerance_of_pairs(ROUNDING, FACTOR_HALF));
        check_factors(device, &case, (Around::Walls, true), FULL, weight, &mut worst)
    };
    let weight = smoothing_of(&kernel_params()).weight;
    check(weight).or_raise();
    ensure!(check(1.001 * weight).is_err(), "another weight of neighbours");
}

/// A half-space near each particle.
fn contacts(case: &Case) -> Vec<SolidContact> {
    let mut rng = rng(90);
    let of = |at: &Position| {
        let mut number = || rng.random::<f64>() - 0.5;
        let normal = DVec3::new(number(), number(), number()).normalize();
        let away_m = 1.6 * SUPPORT_M * (number() + 0.4);
        SolidContact {
            normal: normal.as_vec3().to_array(),
            offset_m: (normal.dot(vector(at.position_m)) - away_m) as f32,
            speed_m_s: number() as f32,
            ..SolidContact::default()
        }
    };
    case.positions.iter().map(of).collect()
}

/// What the kernel leaves: particles' positions, factors and partings.
fn run_factors(
    device: &Device,
    case: &Case,
    walls: WallsKeyword,
    pairs: Pairs,
) -> (Vec<Position>, Vec<PressureFactors>, Vec<Velocity>) {
    let mut bench = Bench::new(device);
    let quantized_positions = bench.input("quantized_positions", &case.quantized_positions(pairs.quantization));
    let sorted_positions = bench.input("sorted_positions", &case.positions);
    let (neighbours, list_heads) = case.upload_neighbours(&mut bench);
    let solid_contacts = bench.input("solid_contacts", &contacts(case));
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
            solid_contacts: (walls == SolidWalls).then(|| solid_contacts.read()),
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
    (walls, solids): (Around, bool),
    pairs: Pairs,
    weight: f64,
    worst: &mut Worst,
) -> Result<(), Wrong> {
    // With solids walls are there in any case, far away where there are none.
    let keyword = if solids { WallsKeyword::SolidWalls } else { walls.has_walls().into() };
    let walled = solids || walls.has_walls();
    let contacts = contacts(case);
    let (positions, got, parting) = run_factors(device, case, keyword, pairs);
    ensure_eq!(positions, case.positions);
    let step = step_of(&case.step_params(), walled);
    let box_walls = walls_of(&kernel_params(), step.domain_size_m);
    let box_walls = walled.then_some(&box_walls);
    let smoothing = Smoothing { weight, ..smoothing_of(&kernel_params()) };
    let (at_m, exact_m) = (case.quantized_m(pairs.quantization), case.positions_m());
    for (i, got) in got.iter().enumerate() {
        // Pairs are of quantized positions, walls are seen from the particle's own.
        let mut mirrors = Mirrors::at(exact_m[i], box_walls);
        if solids {
            let contact = &contacts[i];
            let away_m = vector(contact.normal).dot(exact_m[i]) - f64::from(contact.offset_m);
            worst.check(got.from_solids, away_m / smoothing.support_m, 30.0)?;
            worst.check3(
                unpack_direction(got.solid_normal).as_vec3().to_array(),
                unpack_direction(pack_direction(vector(contact.normal))),
                // Rounding may decide between two of the 65,536 steps: 5e-5 of a direction, of a tolerance of sums of pairs.
                32.0,
            )?;
            ensure_eq!(got.solid_speed_m_s, contact.speed_m_s);
            mirrors.solids = Some(solids_of(got));
        }
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
    let (_, _, got) = run_factors(device, &case, WallsKeyword::Off, pairs);
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
