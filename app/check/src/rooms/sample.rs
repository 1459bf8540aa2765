//! `measure/sample_particles` against its twin, and as a program records it.

use crate::bench::Bench;
use crate::cases::{Case, fluid, sizes};
use crate::compare::{ROUNDING, Worst, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, Wrong, ensure, ensure_eq};
use brooklet_fluid::measure::record_sample;
use brooklet_fluid::particles::id_of;
use brooklet_fluid::{Scene, record};
use brooklet_gpu::{Plan, Resources};
use brooklet_kernels::{FLUID_SHIFT, Kernel, QUARANTINED, SampleParams, SampleParticles};
use brooklet_reference::measure::sample_particles::sample_particles;
use brooklet_reference::particles::predict::Particle;
use rand::RngExt;

fn run(device: &Device, case: &Case, stride: u32) -> Vec<[f32; 4]> {
    let slots = case.count().div_ceil(stride as usize);
    let mut bench = Bench::new(device);
    let positions = bench.input("positions", &case.positions);
    let velocities = bench.input("velocities", &case.velocities);
    let mut samples = bench.output("samples", slots);
    let params = SampleParams { stride, capacity: case.count() as u32, ..SampleParams::default() };
    let params = bench.uniform("sample_params", params);
    bench.dispatch(
        &SampleParticles {
            positions: positions.read(),
            velocities: velocities.read(),
            samples: samples.write(),
            sample_params: params.uniform(),
        },
        case.count(),
    );
    bench.run().read(&samples, slots)
}

/// Positions exactly, and speeds: three products, two sums and a square root of 3 units in the last
/// place, half of the first five's: 6 roundings.
fn check(device: &Device, case: &Case, samples: &[[f32; 4]], stride: usize) -> Result<usize, Wrong> {
    let particles: Vec<Particle> =
        case.positions.iter().zip(&case.velocities).map(|(p, v)| Particle::of(p, v)).collect();
    let ids: Vec<usize> = case.positions.iter().map(|p| id_of(p.tag) as usize).collect();
    let expected = sample_particles(&particles, &ids, stride);
    if samples.len() != expected.len() {
        return Err(format!("{} samples, expected {}", samples.len(), expected.len()).into());
    }
    let mut worst = Worst::new(SampleParticles::STAGE, 6.0 * ROUNDING);
    for (slot, (&[x, y, z, speed_m_s], expected)) in samples.iter().zip(&expected).enumerate() {
        let Some((position_m, expected_m_s)) = expected else {
            match [x, y, z, speed_m_s].iter().all(|value| value.is_nan()) {
                true => continue,
                false => return Err(format!("{slot}: a quarantined particle is at {x}, {y}, {z}").into()),
            }
        };
        if vector([x, y, z]) != *position_m {
            return Err(format!("{slot}: {x}, {y}, {z} is not {position_m}").into());
        }
        worst.check(speed_m_s, *expected_m_s, expected_m_s.max(1e-3))?;
    }
    if expected.iter().any(Option::is_some) {
        worst.report(device);
    }
    Ok(expected.len())
}

pub(crate) fn every_stride_th_particle_has_its_place_however_they_are_sorted(device: &Device) {
    let mut rng = rng(71);
    for size in sizes(device, SampleParticles::GROUP_SIZE[0] as usize) {
        for stride in [1, 2, 7, 64, 5000] {
            let mut case = fluid(&mut rng, size);
            for i in (1..size).rev() {
                case.positions.swap(i, rng.random_range(0..=i));
            }
            for (i, position) in case.positions.iter_mut().enumerate() {
                // The bits of fluids are no part of an id; the last number's slot is inactive.
                position.tag |= ((i % 128) as u32) << FLUID_SHIFT;
                position.tag |= if i % 5 == 3 { QUARANTINED } else { 0 };
            }
            let samples = run(device, &case, stride);
            ensure_eq!(check(device, &case, &samples, stride as usize), Ok(size.div_ceil(stride as usize)));
        }
    }
}

pub(crate) fn a_sample_of_other_particles_fails(device: &Device) {
    let case = fluid(&mut rng(72), 200);
    let mut samples = run(device, &case, 3);
    ensure!(check(device, &case, &samples, 3).is_ok());
    ensure!(check(device, &case, &samples, 4).is_err());
    samples.swap(5, 6);
    ensure!(check(device, &case, &samples, 3).is_err());
    samples.swap(5, 6);
    samples[9][3] *= 1.0 + 1e-6;
    ensure!(check(device, &case, &samples, 3).is_err());
    samples[9] = [f32::NAN; 4];
    ensure!(check(device, &case, &samples, 3).is_err());
}

pub(crate) fn a_scene_is_sampled_only_if_somebody_wants_it_and_never_beyond_what_was_allowed(device: &Device) {
    let scene = Scene::load("calm-pool", &["spacing_m=0.1".into()]).or_raise();
    for most_points in [0, 1, 100, 1_000_000] {
        let mut resources = Resources::new();
        let recorded = record(&mut resources, &scene);
        let sample = record_sample(&mut resources, &recorded, most_points);
        let count = recorded.slots.capacity;
        ensure_eq!(sample.samples.len, count.div_ceil(sample.stride));
        ensure!(sample.samples.len <= most_points.max(1));
        ensure!(sample.stride == 1 || count.div_ceil(sample.stride - 1) > most_points, "no more is left out than must");
        let mut recordings = recorded.recordings();
        recordings.push(sample.recording.clone());
        let (init, step) = (recorded.init.id(), recorded.step.id());
        let has_sample = |plan: &Plan| plan.passes().iter().any(|pass| pass.stage == SampleParticles::STAGE);
        let without = Plan::sweep(resources.clone(), recordings.clone(), &[]).or_raise();
        ensure!(!has_sample(&without));
        let plan = Plan::sweep(resources, recordings, &[sample.samples.id]).or_raise();
        ensure!(has_sample(&plan));
        let mut engine = device.engine(plan);
        engine.run(&[init, step, step, sample.recording.id()], &[sample.samples.id]).or_raise();
        let report = engine.finish().or_raise().remove(0);
        let samples: Vec<[f32; 4]> = bytemuck::pod_collect_to_vec(&report.readbacks[0].1);
        let mut positions = engine.read(&recorded.positions).or_raise();
        positions.sort_by_key(|position| id_of(position.tag));
        for (slot, sampled) in samples.iter().enumerate() {
            ensure_eq!(sampled[..3], positions[slot * sample.stride as usize].position_m);
        }
    }
}
