//! `measure/` against its twins.

use crate::bench::Bench;
use crate::cases::{
    Around, Case, LIST_CHUNKS, SUPPORT_M, fluid, kernel_params, sizes, smoothing_of, step_state, walls_of,
};
use crate::compare::{ROUNDING, Worst, check_exact, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, Wrong, ensure, ensure_eq};
use brooklet_kernels::{
    Counters, DensityRatios, DensityRatiosVariant, Kernel, ListHead, Measure, MeasureParticles,
    MeasureParticlesVariant, MeasureSums, MeasureTotals, StepParams,
};
use brooklet_reference::boundary::walls::DomainWalls;
use brooklet_reference::measure::density::density_ratio;
use brooklet_reference::measure::density_ratios::density_ratios as density_ratios_twin;
use brooklet_reference::measure::measure_particles::{Sample, Sums, measure_particles};
use brooklet_reference::measure::measure_totals::{measure_totals, percentile_99};
use brooklet_reference::shared::list;
use glam::DVec3;
use rand::{Rng, RngExt};

/// Bins of one histogram.
const BINS: usize = brooklet_kernels::HISTOGRAM_BINS as usize;
const GROUP: usize = MeasureParticles::GROUP_SIZE[0] as usize;

/// A density is a sum of some 30 terms of a handful of roundings each (64 in all); a mean of 64 of
/// them adds six more, and a mean of thousands of sums a dozen.
const TOLERANCE: f64 = 80.0 * ROUNDING;

/// Group sums and histograms; without `density`, which particles without neighbours have none of, the histograms stay empty.
fn run_particles(
    device: &Device,
    case: &Case,
    params: StepParams,
    (density, walls): (bool, Around),
) -> (Vec<MeasureSums>, Vec<u32>) {
    let groups = case.count().div_ceil(GROUP);
    let mut bench = Bench::new(device);
    let positions = bench.input("positions", &case.positions);
    let velocities = bench.input("velocities", &case.velocities);
    let (neighbours, list_heads) = case.upload_neighbours(&mut bench);
    let mut group_measures = bench.output("group_measures", groups);
    let mut histograms = bench.output("histograms", 2 * BINS);
    let step_params = bench.uniform("step_params", params);
    let kernel = bench.uniform("kernel", kernel_params());
    let step_state = bench.uniform("step_state", step_state(case.count(), params.dt_s));
    bench.dispatch(
        &MeasureParticles {
            variant: MeasureParticlesVariant { density, walls: walls.has_walls().into(), periodic: false },
            positions: positions.read(),
            velocities: velocities.read(),
            neighbours: density.then(|| neighbours.read()),
            list_heads: density.then(|| list_heads.read()),
            solid_contacts: None,
            group_measures: group_measures.write(),
            histograms: density.then(|| histograms.write()),
            step_state: step_state.uniform(),
            step_params: step_params.uniform(),
            kernel: density.then(|| kernel.uniform()),
        },
        case.count(),
    );
    let mut done = bench.run();
    (done.read(&group_measures, groups), done.read(&histograms, 2 * BINS))
}

fn run_totals(
    device: &Device,
    groups: &[MeasureSums],
    histograms: &[u32],
    counters: Counters,
    particles: usize,
) -> Measure {
    let mut bench = Bench::new(device);
    let group_measures = bench.input("group_measures", groups);
    let histograms = bench.input("histograms", histograms);
    let counters = bench.input("counters", &[counters]);
    let mut measure = bench.output("measure", 1);
    let step_state = bench.uniform("step_state", step_state(particles, 0.0));
    bench.dispatch(
        &MeasureTotals {
            group_measures: group_measures.read(),
            histograms: histograms.read(),
            counters: counters.read(),
            measure: measure.write(),
            step_state: step_state.uniform(),
        },
        1,
    );
    bench.run().read(&measure, 1)[0]
}

/// Compares sums, each relative to the number of particles times the size of one's share.
fn check_sums(worst: &mut Worst, got: &MeasureSums, expected: &Sums, size_m: f64) -> Result<(), Wrong> {
    let count = f64::from(expected.particles.max(1));
    let error = 1.0 + expected.density_error_max;
    let speed = expected.speed_max_m_s.max(1e-3);
    worst.check(got.density_error_sum, expected.density_error_sum, count * error)?;
    worst.check(got.density_error_max, expected.density_error_max, error)?;
    worst.check(got.compression_sum, expected.compression_sum, count * error)?;
    worst.check(got.compression_max, expected.compression_max, error)?;
    worst.check3(got.position_sum_m, expected.position_sum_m, count * size_m)?;
    worst.check3(got.velocity_sum_m_s, expected.velocity_sum_m_s, count * speed)?;
    worst.check(got.speed_max_m_s, expected.speed_max_m_s, speed)?;
    worst.check(got.speed_squared_sum_m2_s2, expected.speed_squared_sum_m2_s2, count * speed * speed)?;
    if expected.particles > 0 {
        worst.check(got.front_m, expected.front_m, size_m)?;
    }
    check_exact(
        &[got.particles, got.quarantined, got.escaped],
        &[expected.particles, expected.quarantined, expected.escaped],
    )
}

/// Particles with some quarantined, without any neighbours then, and some outside.
fn disturbed(rng: &mut impl Rng, size: usize) -> Case {
    let mut case = fluid(rng, size);
    for i in (0..size).step_by(9) {
        case.positions[i].tag |= 1 << 31;
    }
    for i in (4..size).step_by(10) {
        case.positions[i].position_m[i % 3] += if i % 4 == 0 { -1.0 } else { 2.0 };
    }
    let positions_m = case.positions_m();
    let alone = |i: usize| case.positions[i].tag >> 31 == 1;
    case.neighbours = brooklet_reference::grid::list_neighbours::list_neighbours(&positions_m, alone, SUPPORT_M);
    case
}

fn samples(case: &Case, walls: Option<&DomainWalls>) -> Vec<Sample> {
    let smoothing = smoothing_of(&kernel_params());
    let (positions_m, velocities_m_s) = (case.positions_m(), case.velocities_m_s());
    (0..case.count())
        .map(|i| Sample {
            position_m: positions_m[i],
            velocity_m_s: velocities_m_s[i],
            density_ratio: density_ratio(i, &positions_m, &case.neighbours[i], &smoothing, walls),
            quarantined: case.positions[i].tag >> 31 == 1,
        })
        .collect()
}

pub(crate) fn density_ratios_are_their_twins(device: &Device) {
    let mut worst = device.worst(DensityRatios::STAGE, TOLERANCE);
    let mut rng = rng(53);
    for (walls, mirrors) in [(Around::Nothing, 0), (Around::Walls, 0), (Around::NarrowWalls, 0), (Around::Walls, 1)] {
        for size in sizes(device, GROUP) {
            let case = disturbed(&mut rng, size);
            let mut bench = Bench::new(device);
            let positions = bench.input("positions", &case.positions);
            let (lists, mut heads) = list::encoded(&case.neighbours, LIST_CHUNKS);
            // As a step leaves the list of nobody; one that no step has made is all zero.
            heads.iter_mut().filter(|head| head.entries == 0).for_each(|head| head.first = u32::MAX);
            if size > GROUP {
                heads[1] = ListHead::default();
            }
            let (neighbours, list_heads) = (bench.input("neighbours", &lists), bench.input("list_heads", &heads));
            let mut density_ratios = bench.output("density_ratios", size);
            let step_params = bench.uniform("step_params", StepParams { mirrors, ..case.step_params() });
            let kernel = bench.uniform("kernel", kernel_params());
            let step_state = bench.uniform("step_state", step_state(size, case.step_params().dt_s));
            bench.dispatch(
                &DensityRatios {
                    variant: DensityRatiosVariant { walls: walls.has_walls().into(), periodic: false },
                    positions: positions.read(),
                    neighbours: neighbours.read(),
                    list_heads: list_heads.read(),
                    solid_contacts: None,
                    density_ratios: density_ratios.write(),
                    step_state: step_state.uniform(),
                    step_params: step_params.uniform(),
                    kernel: kernel.uniform(),
                },
                size,
            );
            let got: Vec<f32> = bench.run().read(&density_ratios, size);
            let box_walls = walls_of(&kernel_params(), vector(case.step_params().domain_size_m));
            let smoothing = smoothing_of(&kernel_params());
            let twin = |walls: Option<&DomainWalls>| {
                let quarantined = |i: usize| case.positions[i].tag >> 31 == 1;
                density_ratios_twin(&case.positions_m(), &case.neighbours, quarantined, &smoothing, walls, mirrors == 1)
            };
            let expected = twin(walls.has_walls().then_some(&box_walls));
            for (i, (&got, &expected)) in got.iter().zip(&expected).enumerate() {
                let is_unlisted = size > GROUP && i == 1;
                worst.check(got, if is_unlisted { 1.0 } else { expected }, 1.0 + expected).or_raise();
            }
            // Fed the twin with walls where there are none, and the other way round, it fails.
            if size > GROUP {
                let wrong = twin((!walls.has_walls()).then_some(&box_walls));
                let mut fails = Worst::new(DensityRatios::STAGE, TOLERANCE);
                let differs =
                    got.iter().zip(&wrong).any(|(&got, &wrong)| fails.check(got, wrong, 1.0 + wrong).is_err());
                ensure!(differs, "a wrong density must differ");
            }
        }
    }
    worst.report(device);
}

pub(crate) fn measures_match_their_twins(device: &Device) {
    let mut particles = device.worst(MeasureParticles::STAGE, TOLERANCE);
    let mut totals = device.worst(MeasureTotals::STAGE, TOLERANCE);
    let mut rng = rng(51);
    for walls in Around::ALL {
        for size in sizes(device, GROUP) {
            let mut case = disturbed(&mut rng, size);
            if walls == Around::NarrowWalls {
                case.size_m = case.size_m.min(DVec3::new(9.0, 1.3 * SUPPORT_M, 1.7 * SUPPORT_M));
            }
            let params = case.step_params();
            let (groups, histograms) = run_particles(device, &case, params, (true, walls));
            let box_walls = walls_of(&kernel_params(), vector(params.domain_size_m));
            let samples = samples(&case, walls.has_walls().then_some(&box_walls));
            let expected: Vec<Sums> =
                samples.chunks(GROUP).map(|group| measure_particles(group, box_walls.domain_size_m)).collect();
            for (got, expected) in groups.iter().zip(&expected) {
                check_sums(&mut particles, got, expected, 3.0).or_raise();
            }
            if walls == Around::Nothing {
                let (groups, _) = run_particles(device, &case, params, (false, walls));
                for (got, expected) in groups.iter().zip(&expected) {
                    let expected = Sums {
                        density_error_sum: 0.0,
                        density_error_max: 0.0,
                        compression_sum: 0.0,
                        compression_max: 0.0,
                        ..*expected
                    };
                    check_sums(&mut particles, got, &expected, 3.0).or_raise();
                }
            }
            let total = measure_totals(&expected);
            for histogram in [&histograms[..BINS], &histograms[BINS..]] {
                ensure_eq!(histogram.iter().sum::<u32>(), total.particles);
            }
            if groups.is_empty() {
                continue;
            }
            let counters = Counters { speed_clamps: 3, correction_clamps: 5, ..Counters::default() };
            let measure = run_totals(device, &groups, &histograms, counters, case.count());
            check_sums(&mut totals, &measure.sums, &total, 3.0).or_raise();
            ensure_eq!(measure.counters, counters);
            let errors: Vec<f64> = samples.iter().filter(|s| !s.quarantined).map(|s| s.density_ratio - 1.0).collect();
            let sizes: Vec<f64> = errors.iter().map(|e| e.abs()).collect();
            let positive: Vec<f64> = errors.iter().map(|e| e.max(0.0)).collect();
            check_percentile(measure.density_error_p99, percentile_99(&sizes)).or_raise();
            check_percentile(measure.compression_p99, percentile_99(&positive)).or_raise();
        }
    }
    particles.report(device);
    totals.report(device);
}

/// Bins are 1/32 of their value wide at most, and what is told is their middle; the first reaches
/// up to 2^-14 and tells 0.
fn check_percentile(got: f32, expected: f64) -> Result<(), Wrong> {
    let smallest = 2.0_f64.powi(-14);
    let tolerance = expected / 64.0 + TOLERANCE;
    let below = got == 0.0 && expected < smallest + TOLERANCE;
    if below || (f64::from(got) - expected).abs() <= tolerance {
        return Ok(());
    }
    Err(format!("99th percentile {got}, expected {expected}").into())
}

pub(crate) fn percentiles_are_those_of_a_walk_from_the_highest_bin_down(device: &Device) {
    // The middle of a bin, as `measure/histogram.hlsli` has it.
    let value =
        |bin: usize| if bin == 0 { 0.0 } else { f32::from_bits(((0x3880_0000 >> 18) + bin as u32) << 18 | 1 << 17) };
    let walked = |histogram: &[u32], particles: u32| {
        let mut passed = 0;
        (1..BINS).rev().find(|&bin| {
            passed += histogram[bin];
            passed > particles / 100
        })
    };
    let mut rng = rng(44);
    let one = |fill: &mut dyn FnMut(&mut [u32])| {
        let mut histograms = vec![0; 2 * BINS];
        fill(&mut histograms[..BINS]);
        // The other histogram has them the other way round.
        let reversed: Vec<u32> = histograms[..BINS].iter().rev().copied().collect();
        histograms[BINS..].copy_from_slice(&reversed);
        let particles: u32 = histograms[..BINS].iter().sum();
        let group = MeasureSums { particles, ..MeasureSums::default() };
        let groups = (particles as usize).div_ceil(MeasureParticles::GROUP_SIZE[0] as usize).max(1);
        let mut groups = vec![MeasureSums::default(); groups];
        groups[0] = group;
        let measure = run_totals(device, &groups, &histograms, Counters::default(), particles as usize);
        for (got, histogram) in
            [(measure.density_error_p99, &histograms[..BINS]), (measure.compression_p99, &histograms[BINS..])]
        {
            ensure_eq!(got, value(walked(histogram, particles).unwrap_or(0)), "{particles} particles");
        }
    };
    one(&mut |_| {});
    for bin in [0, 1, 7, 8, 9, 255, 256, 503, 504, 510, 511] {
        one(&mut |bins| bins[bin] = 1000);
        // One particle in a hundred lies above: not one more.
        one(&mut |bins| (bins[bin / 2], bins[bin]) = (99 * 5, bins[bin] + 5));
        one(&mut |bins| (bins[bin / 2], bins[bin]) = (99 * 5, bins[bin] + 6));
    }
    for _ in 0..8 {
        one(&mut |bins| bins.iter_mut().for_each(|count| *count = rng.random_range(0..20)));
    }
}

pub(crate) fn totals_add_up_any_number_of_groups(device: &Device) {
    let mut worst = device.worst(MeasureTotals::STAGE, TOLERANCE);
    let mut rng = rng(52);
    for count in [0, 1, GROUP - 1, GROUP, GROUP + 1, 5 * GROUP + 7, 4097] {
        let groups: Vec<MeasureSums> = (0..count)
            .map(|_| MeasureSums {
                density_error_sum: 64.0 * rng.random::<f32>(),
                density_error_max: rng.random(),
                compression_sum: 64.0 * rng.random::<f32>(),
                compression_max: rng.random(),
                position_sum_m: [0; 3].map(|_| 64.0 * rng.random::<f32>()),
                front_m: rng.random(),
                velocity_sum_m_s: [0; 3].map(|_| 64.0 * (rng.random::<f32>() - 0.5)),
                speed_max_m_s: rng.random(),
                speed_squared_sum_m2_s2: 64.0 * rng.random::<f32>(),
                particles: rng.random_range(0..=64),
                quarantined: rng.random_range(0..9),
                escaped: rng.random_range(0..9),
            })
            .collect();
        let parts: Vec<Sums> = groups.iter().map(sums_of).collect();
        let measure = run_totals(device, &groups, &vec![0; 2 * BINS], Counters::default(), count * GROUP);
        let mut expected = measure_totals(&parts);
        expected.speed_max_m_s = expected.speed_max_m_s.max(0.0);
        check_sums(&mut worst, &measure.sums, &expected, 2.0).or_raise();
        ensure_eq!((measure.density_error_p99, measure.compression_p99), (0.0, 0.0));
    }
    worst.report(device);
}

fn sums_of(sums: &MeasureSums) -> Sums {
    Sums {
        density_error_sum: sums.density_error_sum.into(),
        density_error_max: sums.density_error_max.into(),
        compression_sum: sums.compression_sum.into(),
        compression_max: sums.compression_max.into(),
        position_sum_m: vector(sums.position_sum_m),
        front_m: sums.front_m.into(),
        velocity_sum_m_s: vector(sums.velocity_sum_m_s),
        speed_max_m_s: sums.speed_max_m_s.into(),
        speed_squared_sum_m2_s2: sums.speed_squared_sum_m2_s2.into(),
        particles: sums.particles,
        quarantined: sums.quarantined,
        escaped: sums.escaped,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percentile_comparator_fails() {
        assert!(check_percentile(0.1, 0.1).is_ok());
        assert!(check_percentile(0.103, 0.1).is_err());
        assert!(check_percentile(0.0, 1e-3).is_err());
        assert!(check_percentile(f32::NAN, 0.1).is_err());
        assert!(check_percentile(0.0, 1e-5).is_ok());
    }
}
