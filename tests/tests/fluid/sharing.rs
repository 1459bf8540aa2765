//! Buffers that share memory: the same particles, bit for bit, as with memory for each, and as with garbage in whatever
//! nobody is to need.

use brooklet_fluid::particles::ParticleSet;
use brooklet_fluid::{FrameRequest, ParticleSource, Scene, Session, SessionRecorder};
use brooklet_gpu::{GpuError, Plan, Tier};
use brooklet_render::ScenePlan;
use brooklet_tests::{gpu, small};

const SCENE: &str = "
spacing_m = 0.05
[domain]
min_m = [0, 0, 0]
max_m = [1.2, 0.8, 0.5]
[[fluid]]
block = { min_m = [0, 0, 0], max_m = [0.4, 0.4, 0.5] }
[solver]
deterministic = true
";

/// One for each set of buffers that a substep has.
const CASES: &[&[&str]] = &[
    // Two substeps, momentum with a coarse grid.
    &["solver.substeps=2", "solver.pbf.iterations=2", "forces.xsph=0.02"],
    &["solver.pbf.coarse_correction=false", "solver.pbf.acceleration='none'", "forces.xsph=0"],
    &["solver.pbf.iterations=8", "forces.xsph=0.02", "forces.vorticity_m_s=0.02"],
    &["solver.pbf.warm_start=0.2", "solver.substeps=2", "forces.vorticity_m_s=0.02", "forces.xsph=0"],
    &["solver.precision='relaxed'", "solver.pbf.warm_start=0.2", "forces.xsph=0.02"],
    &["capacity=1500", "solver.substeps=2", "forces.xsph=0.02"],
    &["domain.periodic=[true, false, false]", "solver.pbf.s_corr_k=0.001"],
    &["solver.method='none'"],
    // Substeps that the GPU chooses, of which the last visit nothing.
    &["solver.method='sph'", "solver.sph.stiffness_m2_s2=300"],
    &["solver.method='sph'", "solver.sph.adaptive_substeps=false", "solver.substeps=20"],
];

fn scene(settings: &[&str]) -> Scene {
    let settings: Vec<String> = settings.iter().map(|&setting| setting.into()).collect();
    Scene::from_toml(SCENE, "sharing.toml", &settings).unwrap()
}

/// The particles after some frames of each kind.
fn particles(scene: &Scene, tier: Tier, relaxes: bool, change: fn(Plan) -> Plan) -> ParticleSet {
    let mut recorder = SessionRecorder::for_tier(scene, ParticleSource::Scene, tier).with_samples(100);
    if relaxes {
        recorder = recorder.with_relaxation();
    }
    if scene.capacity.is_some() {
        recorder = recorder.with_slot_changes(100);
    }
    let mut planned = recorder.sweep().unwrap();
    planned.plan = change(planned.plan);
    let mut session = Session::start(&gpu(), planned).unwrap();
    for _ in 0..if small() { 3 } else { 5 } {
        session.submit(&FrameRequest { steps: 3, measure: true, sample: true, ..FrameRequest::default() }).unwrap();
    }
    if relaxes {
        session.relax_start().unwrap();
    }
    session.submit(&FrameRequest { steps: 2, measure: true, ..FrameRequest::default() }).unwrap();
    session.read_particles().unwrap()
}

fn bits(particles: &ParticleSet) -> (&[u8], &[u8]) {
    (bytemuck::cast_slice(&particles.positions), bytemuck::cast_slice(&particles.velocities))
}

#[test]
fn particles_are_the_same_with_shared_memory_and_with_garbage() {
    for (number, settings) in CASES.iter().enumerate() {
        let scene = scene(settings);
        // Only without relaxation do a phone's positions stand where velocities stood. It comes before what cases differ in:
        // the first two show both ways.
        for relaxes in [true, false].into_iter().filter(|relaxes| number < 2 || *relaxes == (number % 2 == 0)) {
            let apart = particles(&scene, Tier::Desktop, relaxes, Plan::without_sharing);
            assert!(apart.positions.iter().any(|at| at.position_m != [0.0; 3]) && apart.velocities.len() > 500);
            for tier in [Tier::Desktop, Tier::Floor] {
                let shared = particles(&scene, tier, relaxes, |plan| plan);
                assert!(bits(&shared) == bits(&apart), "{settings:?}, {tier:?}: shared memory");
                let garbage = particles(&scene, tier, relaxes, Plan::with_garbage);
                assert!(bits(&garbage) == bits(&apart), "{settings:?}, {tier:?}: garbage");
            }
        }
    }
}

#[test]
fn what_shares_memory_is_no_more_than_it_was_and_reading_it_is_refused() {
    let scene = scene(CASES[0]);
    let planned = SessionRecorder::new(&scene, ParticleSource::Scene).sweep().unwrap();
    let apart = planned.plan.clone().without_sharing().bytes();
    assert!(planned.plan.bytes() < apart * 85 / 100, "{} of {apart}", planned.plan.bytes());
    // It has another's memory, and is no state: two of those never share.
    let buffers = planned.plan.buffers();
    let shared = buffers.iter().find(|b| b.memory != b.id && b.label == "cell_counts").unwrap().clone();
    let (positions, measure) = (planned.recorded.positions.id, planned.recorded.measure_id().unwrap());
    let mut session = Session::start(&gpu(), planned).unwrap();
    session.step().unwrap();
    let read =
        |session: &mut Session, id| session.submit(&FrameRequest { readbacks: &[id], ..FrameRequest::default() });
    let error = read(&mut session, shared.id).unwrap_err();
    assert!(matches!(&error, GpuError::NotReadable { label, .. } if *label == shared.label), "{error}");
    // State and wanted outputs are read.
    read(&mut session, positions).unwrap();
    read(&mut session, measure).unwrap();
}

/// Of a phone's scenes the tier's bytes with nothing drawn, and with a picture, as `brooklet plan` says them.
#[test]
fn a_phones_particle_takes_no_more_than_it_does() {
    for (tier, most) in [(Tier::Desktop, 176.0), (Tier::Mobile, 160.0), (Tier::Floor, 160.0)] {
        let bare = ["outputs.images=0".to_owned(), "surface.method='none'".to_owned()];
        let bare = ScenePlan::new(&Scene::load("phone-5k", &bare).unwrap(), tier).unwrap();
        let bytes = bare.session.recorded.bytes_per_particle(bare.plan()).unwrap();
        println!("{tier:?}: {bytes:.1} bytes a particle with nothing drawn");
        assert!(bytes <= most && bytes > most - 20.0, "{tier:?}: {bytes}");
        let planned = ScenePlan::new(&Scene::load("phone-5k", &[]).unwrap(), tier).unwrap();
        let bytes = planned.session.recorded.bytes_per_particle(planned.plan()).unwrap();
        let apart = planned.plan().clone().without_sharing();
        let before = planned.session.recorded.bytes_per_particle(&apart).unwrap();
        println!("{tier:?}: {bytes:.1} bytes a particle, {before:.1} with memory for each buffer");
        assert!(bytes <= most + 2.0 && before > 205.0, "{tier:?}: {bytes} of {before}");
        // In the app, which draws: what stands in no memory that a picture needs in any case.
        let own = planned.session.recorded.own_bytes_per_particle(planned.plan()).unwrap();
        println!("{tier:?}: {own:.1} of its own beside a picture");
        assert!(own <= 130.0 && own > 80.0, "{tier:?}: {own}");
    }
}

#[test]
fn no_shipped_plan_lets_a_buffer_clobber_another() {
    for (name, _) in brooklet_fluid::shipped_scenes() {
        for tier in [Tier::Desktop, Tier::Floor] {
            let planned = ScenePlan::new(&Scene::load(name, &[]).unwrap(), tier).unwrap();
            assert_eq!(planned.plan().first_clobbered(), None, "{name} on {tier:?}");
        }
    }
}
