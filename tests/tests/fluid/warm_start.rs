//! Substeps that begin with a share of the last one's pressure.

use brooklet_fluid::particles::{ParticleSet, resample};
use brooklet_fluid::state::State;
use brooklet_fluid::{DrainBox, FrameRequest, ParticleBlock, ParticleSource, Scene, Session, SessionRecorder};
use brooklet_kernels::WarmStart;
use brooklet_tests::gpu;
use brooklet_tests::states::state_of;

const COLUMN: &str = "
spacing_m = 0.05
[domain]
min_m = [0, 0, 0]
max_m = [0.4, 1.2, 0.4]
[[fluid]]
block = { min_m = [0, 0, 0], max_m = [0.4, 1.0, 0.4] }
[solver]
deterministic = true
[solver.pbf]
coarse_correction = false
";

fn scene(settings: &[&str]) -> Scene {
    let settings: Vec<String> = settings.iter().map(|&s| s.into()).collect();
    Scene::from_toml(COLUMN, "column.toml", &settings).unwrap()
}

fn begin(scene: &Scene, source: ParticleSource) -> Session {
    Session::start(&gpu(), SessionRecorder::new(scene, source).sweep().unwrap()).unwrap()
}

fn session(settings: &[&str]) -> Session {
    begin(&scene(settings), ParticleSource::Scene)
}

fn compression(session: &mut Session, steps: u32) -> f64 {
    (0..steps).for_each(|_| session.step().unwrap());
    session.measure().unwrap();
    session.finish().unwrap();
    session.stats().unwrap().compression.mean
}

#[test]
fn a_column_is_less_compressed() {
    for precision in ["full", "relaxed"] {
        let precision = format!("solver.precision={precision}");
        let [cold, warm] = ["0", "0.3"]
            .map(|share| compression(&mut session(&[&precision, &format!("solver.pbf.warm_start={share}")]), 120));
        println!("{precision}: mean compression {cold:.5} cold, {warm:.5} warm");
        assert!(warm < 0.9 * cold, "{cold} {warm}");
    }
}

const WARM: &str = "solver.pbf.warm_start=0.3";
/// What differs by the warm start alone: with a coarse correction, lambdas are held against their sum in any case.
const COARSE: &str = "solver.pbf.coarse_correction=true";

/// What the next substep begins with, by slot.
fn kept(session: &mut Session) -> Vec<WarmStart> {
    let buffer = session.recorded().warm_starts.as_ref().unwrap().alias();
    session.engine_mut().read(&buffer).unwrap()
}

fn is_cold(session: &mut Session) -> bool {
    kept(session).iter().all(|warm| *warm == WarmStart::default())
}

/// A column that stood for a while, and has something to keep.
fn stood(settings: &[&str]) -> Session {
    let mut session = session(settings);
    (0..20).for_each(|_| session.step().unwrap());
    assert!(!is_cold(&mut session));
    session
}

fn bits(particles: &ParticleSet) -> Vec<u8> {
    [bytemuck::cast_slice(&particles.positions), bytemuck::cast_slice(&particles.velocities)].concat()
}

/// What particles are after so many steps.
fn after(scene: &Scene, particles: &ParticleSet, steps: u32) -> Vec<u8> {
    let mut session = begin(scene, ParticleSource::Given(particles.clone()));
    (0..steps).for_each(|_| session.step().unwrap());
    bits(&session.read_particles().unwrap())
}

#[test]
fn a_saved_state_and_a_resampled_one_begin_cold() {
    let warm = scene(&[WARM, COARSE]);
    let (finer, cold) = (warm.with_setting("spacing_m=0.04").unwrap(), scene(&["solver.pbf.warm_start=0", COARSE]));
    let particles = stood(&[WARM, COARSE]).read_particles().unwrap();
    let saved = state_of(warm.clone(), particles.clone(), 20, 0.0);
    let read = State::from_bytes(&saved.to_bytes(), "test").unwrap();
    let resampled = resample(&warm, &particles, &finer);
    let finer_cold = finer.with_setting("solver.pbf.warm_start=0").unwrap();
    for (warm, cold, particles) in [(&warm, &cold, &read.particles), (&finer, &finer_cold, &resampled)] {
        let [one, two] = [1, 2].map(|steps| (after(warm, particles, steps), after(cold, particles, steps)));
        assert!(one.0 == one.1, "the first step is as without");
        assert!(two.0 != two.1, "and the second is not: this test sees something");
    }
}

#[test]
fn others_in_their_slots_begin_cold() {
    let mut session = stood(&[WARM]);
    let particles = session.read_particles().unwrap();
    session.write_particles(&particles);
    assert!(is_cold(&mut session));
}

#[test]
fn another_length_of_step_begins_cold_and_another_gravity_does_not() {
    for (setting, expected) in [("solver.dt_s=0.002", true), ("gravity_m_s2=[0, -5, 0]", false)] {
        let mut session = stood(&[WARM]);
        let count = ParticleSource::Count(session.slot_count());
        let planned = SessionRecorder::new(&scene(&[WARM, setting]), count).sweep().unwrap();
        assert!(session.apply(&planned).unwrap(), "{setting} is a number");
        assert_eq!(is_cold(&mut session), expected, "{setting}");
    }
    // Another number of substeps is another plan, which takes over the particles alone.
    let mut old = stood(&[WARM]);
    let more = scene(&[WARM, "solver.substeps=2"]);
    let mut new = begin(&more, ParticleSource::Count(old.slot_count()));
    new.adopt(&old).unwrap();
    assert!(is_cold(&mut new));
    assert!(bits(&new.read_particles().unwrap()) == bits(&old.read_particles().unwrap()));
}

#[test]
fn an_activated_particle_begins_cold() {
    let scene = scene(&[WARM, "capacity=1400"]);
    let recorder = SessionRecorder::new(&scene, ParticleSource::Scene).with_slot_changes(64);
    let mut session = Session::start(&gpu(), recorder.sweep().unwrap()).unwrap();
    let steps = |steps| FrameRequest { steps, ..FrameRequest::default() };
    session.submit(&steps(20)).unwrap();
    let particles = scene.particle_count() as usize;
    // The lowest layers, which bear all others.
    let drain = DrainBox { min_m: [-1.0; 3], max_m: [1.0, 0.1, 1.0] };
    session.submit(&FrameRequest { deactivate: Some(&drain), ..steps(1) }).unwrap();
    let left = session
        .read_particles()
        .unwrap()
        .positions
        .iter()
        .filter(|at| !brooklet_fluid::particles::is_inactive(at.tag))
        .count();
    assert!(left + 64 <= particles, "{left} of {particles}");
    let before = kept(&mut session);
    assert!(before[..left].iter().any(|warm| *warm != WarmStart::default()));
    assert!(before[left..].iter().all(|warm| *warm == WarmStart::default()), "who comes finds a slot that is cold");
    let block = ParticleBlock {
        first_m: [0.1, 1.1, 0.1],
        spacing_m: 0.05,
        counts: [4, 1, 4],
        velocity_m_s: [0.0; 3],
        fluid: 0,
    };
    session.submit(&FrameRequest { activate: Some(&block), ..steps(0) }).unwrap();
    assert!(kept(&mut session)[left..].iter().all(|warm| *warm == WarmStart::default()));
}
