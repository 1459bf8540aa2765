//! Kernels in a domain with periodic axes, against their twins: those of a step and of a measurement
//! whose code such a domain changes. Lists are in `list`.

use super::none;
use crate::bench::Bench;
use crate::cases::{
    Case, STORAGES, SUPPORT_M, fluid, kernel_params, quantization_of, sizes, smoothing_of, step_of, step_state,
    walls_of,
};
use crate::compare::{ROUNDING, Worst, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, ensure, ensure_eq};
use brooklet_kernels::{
    Counters, DensityRatios, DensityRatiosVariant, IntegrateParticles, Kernel, MeasureParticles,
    MeasureParticlesVariant, MeasureSums, Position, Predict, PredictVariant, StepParams, UpdateVelocity,
    UpdateVelocityVariant, Velocity, VelocityKeyword,
};
use brooklet_reference::boundary::walls::DomainWalls;
use brooklet_reference::grid::list_neighbours::{list_images, list_neighbours};
use brooklet_reference::measure::density::density_ratio;
use brooklet_reference::params::{Smoothing, nearest_image};
use brooklet_reference::particles::predict::{Particle, predict};
use brooklet_reference::solver::none::integrate_particles::integrate_particles;
use brooklet_reference::solver::pbf::update_velocity::update_velocity;
use glam::{BVec3, DVec3};
use rand::RngExt;

const AXES: [[bool; 3]; 3] = [[true, false, false], [false, true, true], [true; 3]];

/// A fluid whose domain is as large as it is, and periodic along `axes`.
fn case_for(rng: &mut impl rand::Rng, size: usize, axes: [bool; 3]) -> (Case, StepParams) {
    let mut case = fluid(rng, size);
    // A multiple of 4 h over which the lattice is spread, so that particles meet across the seam.
    let unit_m = 4.0 * SUPPORT_M;
    let side_m = (case.size_m.x / unit_m).ceil() * unit_m;
    let stretch = side_m / case.size_m.x;
    case.size_m = DVec3::splat(side_m);
    let period_m = case.size_m.to_array().map(|x| x as f32);
    for position in &mut case.positions {
        for axis in 0..3 {
            let at = position.position_m[axis] * stretch as f32;
            // As a step leaves them: inside.
            position.position_m[axis] = if axes[axis] { at.rem_euclid(period_m[axis]) } else { at };
            if position.position_m[axis] >= period_m[axis] && axes[axis] {
                position.position_m[axis] = 0.0;
            }
        }
    }
    let params = StepParams {
        period_m: std::array::from_fn(|axis| if axes[axis] { period_m[axis] } else { 0.0 }),
        inverse_period_per_m: std::array::from_fn(|axis| if axes[axis] { 1.0 / period_m[axis] } else { 0.0 }),
        wall_min_m: axes.map(|is_periodic| if is_periodic { -1e30 } else { 0.0 }),
        wall_max_m: std::array::from_fn(|axis| if axes[axis] { 1e30 } else { period_m[axis] }),
        max_speed_m_s: 25.0,
        ..case.step_params()
    };
    (case, params)
}

/// A GPU's position against the twin's or the image of it that is nearest: a rounding decides on which
/// side of the seam it is. And it is inside along periodic axes.
fn check_image(worst: &mut Worst, got: [f32; 3], expected: DVec3, params: &StepParams, scale: f64) {
    let apart = nearest_image(expected - vector(got), vector(params.period_m));
    worst.check3(got, vector(got) + apart, scale).or_raise();
    for axis in 0..3 {
        let side_m = params.period_m[axis];
        ensure!(side_m == 0.0 || (0.0..side_m).contains(&got[axis]), "{got:?} is outside along axis {axis}");
    }
}

fn run_predict(device: &Device, case: &Case, params: StepParams, walls: bool) -> (Vec<Position>, Vec<Velocity>) {
    let count = case.count();
    let mut bench = Bench::new(device);
    let mut positions = bench.input("positions", &case.positions);
    let mut velocities = bench.input("velocities", &case.velocities);
    let mut counters = bench.input("counters", &[Counters::default()]);
    let step_params = bench.uniform("step_params", params);
    let step_state = bench.uniform("step_state", step_state(count, params.dt_s));
    bench.dispatch(
        &Predict {
            variant: PredictVariant { walls, periodic: true },
            positions: positions.write(),
            velocities: velocities.write(),
            counters: counters.write(),
            step_state: step_state.uniform(),
            step_params: step_params.uniform(),
        },
        count,
    );
    let mut done = bench.run();
    (done.read(&positions, count), done.read(&velocities, count))
}

pub(crate) fn predict_matches_its_twin(device: &Device) {
    // As without periods: the shift is exact or one rounding more.
    let mut worst = device.worst("predict, periodic", 21.0 * ROUNDING);
    let mut rng = rng(81);
    let mut crossed = 0;
    for (axes, walls) in AXES.into_iter().flat_map(|axes| [(axes, false), (axes, true)]) {
        for size in sizes(device, Predict::GROUP_SIZE[0] as usize) {
            let (mut case, params) = case_for(&mut rng, size, axes);
            case.velocities.iter_mut().for_each(|v| v.velocity_m_s = v.velocity_m_s.map(|v| 5.0 * v));
            let (positions, velocities) = run_predict(device, &case, params, walls);
            let step = step_of(&params, walls);
            for i in 0..size {
                let before = Particle {
                    position_m: vector(case.positions[i].position_m),
                    velocity_m_s: vector(case.velocities[i].velocity_m_s),
                    ..Particle::default()
                };
                let expected = predict(before, &step).particle;
                let size_m = step.domain_size_m.length();
                check_image(&mut worst, positions[i].position_m, expected.position_m, &params, size_m);
                let speed = f64::from(params.max_speed_m_s) + if walls { size_m / step.dt_s } else { 0.0 };
                worst.check3(velocities[i].velocity_m_s, expected.velocity_m_s, speed).or_raise();
                let path_m = expected.position_m - before.position_m;
                crossed += u32::from(path_m.abs().max_element() > 0.5 * step.domain_size_m.x);
            }
        }
    }
    ensure!(crossed > 100, "{crossed} particles crossed a seam");
    worst.report(device);
}

pub(crate) fn integrate_particles_matches_its_twin(device: &Device) {
    // As without periods: see `none`.
    let mut worst = device.worst("integrate_particles, periodic", 25.0 * ROUNDING);
    let mut rng = rng(84);
    let mut crossed = 0;
    for (axes, walls) in AXES.into_iter().flat_map(|axes| [(axes, false), (axes, true)]) {
        for size in sizes(device, IntegrateParticles::GROUP_SIZE[0] as usize) {
            let (mut case, params) = case_for(&mut rng, size, axes);
            case.velocities.iter_mut().for_each(|v| v.velocity_m_s = v.velocity_m_s.map(|v| 5.0 * v));
            let (positions, velocities, _) = none::run(device, &case, params, none::SETTINGS, walls);
            let step = step_of(&params, walls);
            for i in 0..size {
                let before = Particle::of(&case.positions[i], &case.velocities[i]);
                let expected = integrate_particles(i as u32, before, &step, &none::twin(none::SETTINGS)).particle;
                let speed = before.velocity_m_s.length().max(expected.velocity_m_s.length());
                let reach_m = step.domain_size_m.length() + speed * step.dt_s;
                check_image(&mut worst, positions[i].position_m, expected.position_m, &params, reach_m);
                worst.check3(velocities[i].velocity_m_s, expected.velocity_m_s, speed).or_raise();
                crossed += u32::from(
                    (expected.position_m - before.position_m).abs().max_element() > 0.5 * step.domain_size_m.x,
                );
            }
        }
    }
    ensure!(crossed > 100, "{crossed} particles crossed a seam");
    worst.report(device);
}

pub(crate) fn update_velocity_matches_its_twin(device: &Device) {
    let mut rng = rng(82);
    let mut crossed = 0;
    for precision in STORAGES {
        let quantization = quantization_of(precision);
        let mut worst = device.worst("update_velocity, periodic", 20.0 * ROUNDING);
        for axes in AXES {
            for size in sizes(device, UpdateVelocity::GROUP_SIZE[0] as usize) {
                let (case, params) = case_for(&mut rng, size, axes);
                let start = case.quantized_positions(quantization);
                let mut moved_h = || quantization.fixed_point(0.8 * (rng.random::<f64>() - 0.5));
                let corrected: Vec<[u32; 2]> = start
                    .iter()
                    .map(|&at| quantization.pack(quantization.coordinates(at).map(|c| c.wrapping_add(moved_h()))))
                    .collect();
                let mut bench = Bench::new(device);
                let at = bench.input("quantized_positions", &corrected);
                let kernel = bench.uniform("kernel", kernel_params());
                let sorted_positions = bench.input("sorted_positions", &case.positions);
                let sorted_velocities = bench.input("sorted_velocities", &case.velocities);
                let mut positions = bench.output("positions", size);
                let mut velocities = bench.output("velocities", size);
                let mut counters = bench.input("counters", &[Counters::default()]);
                let step_params = bench.uniform("step_params", params);
                let step_state = bench.uniform("step_state", step_state(size, params.dt_s));
                let mut kept_positions = bench.output("kept_positions", size);
                let mut kept_velocities = bench.output("kept_velocities", size);
                let mut moved_positions = bench.output("moved_positions", size);
                let mut moved_velocities = bench.input("moved_velocities", &case.velocities);
                for (velocity, positions, velocities) in [
                    (VelocityKeyword::Off, &mut positions, &mut velocities),
                    (VelocityKeyword::InPlaceVelocity, &mut moved_positions, &mut moved_velocities),
                    (VelocityKeyword::KeepVelocity, &mut kept_positions, &mut kept_velocities),
                ] {
                    let sorted = velocity != VelocityKeyword::InPlaceVelocity;
                    bench.dispatch(
                        &UpdateVelocity {
                            variant: UpdateVelocityVariant { precision, periodic: true, velocity },
                            quantized_positions: at.read(),
                            step_state: step_state.uniform(),
                            kernel: kernel.uniform(),
                            sorted_positions: sorted_positions.read(),
                            sorted_velocities: sorted.then(|| sorted_velocities.read()),
                            positions: positions.write(),
                            velocities: velocities.write(),
                            counters: (velocity != VelocityKeyword::KeepVelocity).then(|| counters.write()),
                            step_params: Some(step_params.uniform()),
                        },
                        size,
                    );
                }
                let mut done = bench.run();
                let (positions, velocities) = (done.read(&positions, size), done.read(&velocities, size));
                ensure_eq!(done.read::<Position>(&moved_positions, size), positions);
                ensure_eq!(done.read::<Velocity>(&moved_velocities, size), velocities);
                // Positions are those of the other variant, whatever velocities are.
                ensure_eq!(done.read::<Position>(&kept_positions, size), positions);
                ensure_eq!(done.read::<Velocity>(&kept_velocities, size), case.velocities);
                let step = step_of(&params, false);
                for i in 0..size {
                    let from = vector(case.positions[i].position_m);
                    let to = from + quantization.offset(corrected[i], start[i]) * f64::from(kernel_params().support_m);
                    check_image(&mut worst, positions[i].position_m, to, &params, step.domain_size_m.length());
                    let before = vector(case.velocities[i].velocity_m_s);
                    let (expected, _) = update_velocity(from, to, before, &step);
                    let scale = before.length() + (to - from).length() / step.dt_s;
                    worst.check3(velocities[i].velocity_m_s, expected, scale).or_raise();
                    crossed += u32::from(step.wrapped(to) != to);
                }
            }
        }
        worst.report(device);
    }
    ensure!(crossed > 100, "{crossed} particles crossed a seam");
}

pub(crate) fn densities_match_their_twins(device: &Device) {
    // As without periods: sums of up to a hundred terms of at most 1.
    let mut worst = device.worst("density_ratios, periodic", 64.0 * ROUNDING);
    let mut rng = rng(83);
    let mut missed = 0;
    for (axes, has_walls) in AXES.map(|axes| (axes, false)).into_iter().chain([(AXES[0], true)]) {
        for size in sizes(device, DensityRatios::GROUP_SIZE[0] as usize) {
            let (mut case, params) = case_for(&mut rng, size, axes);
            let at_m = case.positions_m();
            let period_m = vector(params.period_m);
            case.neighbours = list_images(&at_m, |_| false, SUPPORT_M, period_m);
            let mut bench = Bench::new(device);
            let positions = bench.input("positions", &case.positions);
            let velocities = bench.input("velocities", &case.velocities);
            let (neighbours, list_heads) = case.upload_neighbours(&mut bench);
            let mut ratios = bench.output("density_ratios", size);
            let groups = size.div_ceil(MeasureParticles::GROUP_SIZE[0] as usize);
            let mut group_measures = bench.output::<MeasureSums>("group_measures", groups);
            let mut histograms = bench.output::<u32>("histograms", 1024);
            let step_params = bench.uniform("step_params", params);
            let kernel = bench.uniform("kernel", kernel_params());
            let step_state = bench.uniform("step_state", step_state(size, params.dt_s));
            bench.dispatch(
                &DensityRatios {
                    variant: DensityRatiosVariant { walls: has_walls.into(), periodic: true },
                    positions: positions.read(),
                    neighbours: neighbours.read(),
                    list_heads: list_heads.read(),
                    solid_contacts: None,
                    density_ratios: ratios.write(),
                    step_state: step_state.uniform(),
                    step_params: step_params.uniform(),
                    kernel: kernel.uniform(),
                },
                size,
            );
            bench.dispatch(
                &MeasureParticles {
                    variant: MeasureParticlesVariant { density: true, walls: has_walls.into(), periodic: true },
                    positions: positions.read(),
                    velocities: velocities.read(),
                    neighbours: Some(neighbours.read()),
                    list_heads: Some(list_heads.read()),
                    solid_contacts: None,
                    group_measures: group_measures.write(),
                    histograms: Some(histograms.write()),
                    step_state: step_state.uniform(),
                    step_params: step_params.uniform(),
                    kernel: Some(kernel.uniform()),
                },
                size,
            );
            let mut done = bench.run();
            let ratios: Vec<f32> = done.read(&ratios, size);
            let sums: Vec<MeasureSums> = done.read(&group_measures, groups);
            let smoothing = Smoothing { period_m, ..smoothing_of(&kernel_params()) };
            let open = list_neighbours(&at_m, |_| false, SUPPORT_M);
            let axes = BVec3::from_array(axes.map(|is_periodic| !is_periodic));
            let walls = DomainWalls { axes, ..walls_of(&kernel_params(), vector(params.domain_size_m)) };
            let ratio_of =
                |i: usize, list: &[usize]| density_ratio(i, &at_m, list, &smoothing, has_walls.then_some(&walls));
            let mut errors = 0.0;
            for i in 0..size {
                let expected = ratio_of(i, &case.neighbours[i]);
                errors += (expected - 1.0).abs();
                // The kernel takes a list of nobody that begins nowhere for one that no step has made.
                if case.neighbours[i].is_empty() {
                    continue;
                }
                worst.check(ratios[i], expected, expected).or_raise();
                // Without the images it would be another.
                missed += usize::from((f64::from(ratios[i]) - ratio_of(i, &open[i])).abs() > 1e-3);
            }
            let sum: f64 = sums.iter().map(|sums| f64::from(sums.density_error_sum)).sum();
            worst.check((sum / errors.max(1.0)) as f32, errors / errors.max(1.0), 1.0).or_raise();
            ensure_eq!(sums.iter().map(|sums| sums.particles).sum::<u32>(), size as u32);
        }
    }
    // Of some thousand, or fewer where sizes are kept small.
    ensure!(missed > 300, "{missed} particles had neighbours across a seam");
    worst.report(device);
}
