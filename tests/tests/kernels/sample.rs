//! `measure/sample_particles` against its twin, and as a program records it.

use brooklet_fluid::measure::record_sample;
use brooklet_fluid::particles::id_of;
use brooklet_fluid::{Scene, record};
use brooklet_gpu::{Engine, Plan, Resources};
use brooklet_kernels::{FLUID_SHIFT, Kernel, QUARANTINED, SampleParams, SampleParticles};
use brooklet_reference::measure::sample_particles::sample_particles;
use brooklet_reference::particles::predict::Particle;
use brooklet_study::backend::reference_particle;
use brooklet_tests::cases::{Case, fluid, sizes};
use brooklet_tests::compare::{ROUNDING, Worst, vector};
use brooklet_tests::harness::Bench;
use brooklet_tests::{gpu, rng};
use rand::RngExt;

fn run(case: &Case, stride: u32) -> Vec<[f32; 4]> {
    let slots = case.count().div_ceil(stride as usize);
    let mut bench = Bench::new();
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
fn check(case: &Case, samples: &[[f32; 4]], stride: usize) -> Result<usize, String> {
    let particles: Vec<Particle> =
        case.positions.iter().zip(&case.velocities).map(|(p, v)| reference_particle(p, v)).collect();
    let ids: Vec<usize> = case.positions.iter().map(|p| id_of(p.tag) as usize).collect();
    let expected = sample_particles(&particles, &ids, stride);
    if samples.len() != expected.len() {
        return Err(format!("{} samples, expected {}", samples.len(), expected.len()));
    }
    let mut worst = Worst::new(SampleParticles::STAGE, 6.0 * ROUNDING);
    for (slot, (&[x, y, z, speed_m_s], expected)) in samples.iter().zip(&expected).enumerate() {
        let Some((position_m, expected_m_s)) = expected else {
            match [x, y, z, speed_m_s].iter().all(|value| value.is_nan()) {
                true => continue,
                false => return Err(format!("{slot}: a quarantined particle is at {x}, {y}, {z}")),
            }
        };
        if vector([x, y, z]) != *position_m {
            return Err(format!("{slot}: {x}, {y}, {z} is not {position_m}"));
        }
        worst.check(speed_m_s, *expected_m_s, expected_m_s.max(1e-3))?;
    }
    if expected.iter().any(Option::is_some) {
        worst.report();
    }
    Ok(expected.len())
}

#[test]
fn every_stride_th_particle_has_its_place_however_they_are_sorted() {
    let mut rng = rng(71);
    for size in sizes(SampleParticles::GROUP_SIZE[0] as usize) {
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
            let samples = run(&case, stride);
            assert_eq!(check(&case, &samples, stride as usize), Ok(size.div_ceil(stride as usize)));
        }
    }
}

#[test]
fn a_sample_of_other_particles_fails() {
    let case = fluid(&mut rng(72), 200);
    let mut samples = run(&case, 3);
    assert!(check(&case, &samples, 3).is_ok());
    assert!(check(&case, &samples, 4).is_err());
    samples.swap(5, 6);
    assert!(check(&case, &samples, 3).is_err());
    samples.swap(5, 6);
    samples[9][3] *= 1.0 + 1e-6;
    assert!(check(&case, &samples, 3).is_err());
    samples[9] = [f32::NAN; 4];
    assert!(check(&case, &samples, 3).is_err());
}

#[test]
fn a_scene_is_sampled_only_if_somebody_wants_it_and_never_beyond_what_was_allowed() {
    let scene = Scene::load("calm-pool", &["spacing_m=0.1".into()]).unwrap();
    for most_points in [0, 1, 100, 1_000_000] {
        let mut resources = Resources::new();
        let recorded = record(&mut resources, &scene);
        let sample = record_sample(&mut resources, &recorded, most_points);
        let count = recorded.slots.capacity;
        assert_eq!(sample.samples.len, count.div_ceil(sample.stride));
        assert!(sample.samples.len <= most_points.max(1));
        assert!(sample.stride == 1 || count.div_ceil(sample.stride - 1) > most_points, "no more is left out than must");
        let mut recordings = recorded.recordings();
        recordings.push(sample.recording.clone());
        let (init, step) = (recorded.init.id(), recorded.step.id());
        let has_sample = |plan: &Plan| plan.passes().iter().any(|pass| pass.stage == SampleParticles::STAGE);
        let without = Plan::sweep(resources.clone(), recordings.clone(), &[]).unwrap();
        assert!(!has_sample(&without));
        let plan = Plan::sweep(resources, recordings, &[sample.samples.id]).unwrap();
        assert!(has_sample(&plan));
        let mut engine = Engine::new(&gpu(), plan).unwrap();
        engine.run(&[init, step, step, sample.recording.id()], &[sample.samples.id]).unwrap();
        let report = engine.finish().unwrap().remove(0);
        let samples: Vec<[f32; 4]> = bytemuck::pod_collect_to_vec(&report.readbacks[0].1);
        let mut positions = engine.read(&recorded.positions).unwrap();
        positions.sort_by_key(|position| id_of(position.tag));
        for (slot, sampled) in samples.iter().enumerate() {
            assert_eq!(sampled[..3], positions[slot * sample.stride as usize].position_m);
        }
    }
}
