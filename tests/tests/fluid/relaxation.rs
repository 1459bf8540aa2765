//! Compression that a start or a change of settings leaves over is taken out while time stands.

use brooklet_fluid::particles::{ParticleSet, sample_lattice};
use brooklet_fluid::session::{MOST_ROUNDS, NO_COMPRESSION};
use brooklet_fluid::{ParticleSource, Scene, Session, SessionPlan, SessionRecorder, Stats, relax_particles};
use brooklet_tests::gpu;

/// A pool in two dimensions, 40 x 20 particles.
const POOL: &str = "
spacing_m = 0.02
[domain]
min_m = [0, 0, 0]
max_m = [0.8, 0.8, 0.02]
dimensions = 2
[[fluid]]
block = { min_m = [0, 0, 0], max_m = [0.8, 0.4, 0.02] }
[solver]
support_ratio = 3
deterministic = true
";

fn pool(settings: &[&str]) -> Scene {
    let settings: Vec<String> = settings.iter().map(|&s| s.into()).collect();
    Scene::from_toml(POOL, "pool.toml", &settings).unwrap()
}

fn planned(scene: &Scene, source: ParticleSource, relaxes: bool) -> SessionPlan {
    let recorder = SessionRecorder::new(scene, source);
    if relaxes { recorder.with_relaxation() } else { recorder }.sweep().unwrap()
}

fn measured(session: &mut Session) -> Stats {
    session.measure().unwrap();
    session.finish().unwrap();
    session.stats().unwrap()
}

fn stepped(session: &mut Session, steps: u32) -> Stats {
    (0..steps).for_each(|_| session.step().unwrap());
    measured(session)
}

/// Kinetic energy before and after a pool's one substep becomes eight, J.
fn raised(relaxes: bool) -> [f64; 2] {
    let mut old = Session::start(&gpu(), planned(&pool(&[]), ParticleSource::Scene, relaxes)).unwrap();
    let before = stepped(&mut old, 120);
    let scene = pool(&["solver.substeps=8"]);
    let count = ParticleSource::Count(old.slot_count());
    let mut new = Session::start(&gpu(), planned(&scene, count, relaxes)).unwrap();
    new.adopt(&old).unwrap();
    assert_eq!((new.steps(), new.simulated_s()), (old.steps(), old.simulated_s()), "time stands");
    [before.kinetic_j, stepped(&mut new, 1).kinetic_j]
}

#[test]
fn more_substeps_do_not_throw_a_pool_up() {
    let [before, after] = raised(true);
    assert!(after < 1.5 * before, "{before} J became {after} J");
    // Left in, the pool's compression becomes motion: measured 7.5 times, and over 100 without the coarse correction,
    // which leaves less of it.
    let [before, after] = raised(false);
    assert!(after > 4.0 * before, "{before} J became {after} J: this test sees nothing");
}

#[test]
fn a_shorter_step_does_not_either() {
    let raised = |relaxes: bool| {
        let mut session = Session::start(&gpu(), planned(&pool(&[]), ParticleSource::Scene, relaxes)).unwrap();
        let before = stepped(&mut session, 120).kinetic_j;
        let other = planned(&pool(&["solver.dt_s=0.0005"]), ParticleSource::Count(session.slot_count()), relaxes);
        assert!(session.apply(&other).unwrap());
        stepped(&mut session, 1).kinetic_j / before
    };
    let [with, without] = [true, false].map(raised);
    assert!(with < 1.5 && without > 4.0, "{with} {without}");
}

#[test]
fn a_start_is_relaxed_before_time_begins() {
    // A tenth less high.
    let squashed = |session: &mut Session| {
        let mut particles = session.read_particles().unwrap();
        particles.positions.iter_mut().for_each(|at| at.position_m[1] *= 0.9);
        session.write_particles(&particles);
    };
    let mut session = Session::start(&gpu(), planned(&pool(&[]), ParticleSource::Scene, true)).unwrap();
    squashed(&mut session);
    let done = session.relax_start().unwrap().unwrap();
    let [before, after] = done.compression.map(|compression| compression.mean);
    assert!(done.rounds > 1 && before > 0.05 && after < 2.1e-4, "{done:?}");
    assert_eq!(measured(&mut session).kinetic_j, 0.0);
    let again = session.relax_start().unwrap().unwrap();
    assert_eq!(again.rounds, 0, "{again:?}");
    // Nothing is recorded for who does not ask.
    let mut without = Session::start(&gpu(), planned(&pool(&[]), ParticleSource::Scene, false)).unwrap();
    assert_eq!(without.relax_start().unwrap(), None);
}

/// Two blocks that are closer to each other than lattices are, in short substeps.
fn two_blocks() -> Scene {
    let close = POOL.replace(
        "[0.8, 0.4, 0.02] }",
        "[0.4, 0.4, 0.02] }\n[[fluid]]\nblock = { min_m = [0.39, 0, 0], max_m = [0.8, 0.4, 0.02] }",
    );
    Scene::from_toml(
        &close,
        "two-blocks.toml",
        &["outputs.measure_every_steps=0", "solver.substeps=8"].map(String::from),
    )
    .unwrap()
}

#[test]
fn a_session_of_a_scene_begins_without_compression_measured_or_not() {
    let scene = two_blocks();
    let start = |source: ParticleSource| {
        let mut session = Session::start(&gpu(), planned(&scene, source, false)).unwrap();
        let before = session.read_particles().unwrap();
        session.step().unwrap();
        let after = session.read_particles().unwrap();
        let fastest = after.velocities.iter().map(|v| v.velocity_m_s.map(f32::abs).into_iter().fold(0.0, f32::max));
        (session.start_relaxation(), before, fastest.fold(0.0, f32::max))
    };
    let (done, relaxed, fastest_m_s) = start(ParticleSource::Scene);
    let [before, after] = done.unwrap().compression;
    assert!(before.max > 0.01 && after.is_within(&NO_COMPRESSION), "{done:?}");
    // What gravity gives in a step is .04 m/s. The coarse correction takes out at once what little is left of
    // compression everywhere, which plain iterations take many substeps for: measured .16, without it below .1.
    assert!(fastest_m_s < 0.2, "{fastest_m_s} m/s");
    let lattice = sample_lattice(&scene);
    let ids = |particles: &ParticleSet| particles.positions.iter().map(|at| at.tag).collect::<Vec<_>>();
    assert!(ids(&relaxed) == ids(&lattice) && relaxed.velocities == lattice.velocities);
    assert!(start(ParticleSource::Scene).1.positions == relaxed.positions, "bit for bit, as ordered");
    let (none, given, fastest_m_s) = start(ParticleSource::Given(lattice.clone()));
    assert!(none.is_none() && given.positions == lattice.positions, "a saved state stays");
    assert!(fastest_m_s > 0.3, "{fastest_m_s} m/s: this test sees nothing");
    // What is held between walls is given up early.
    let full = Scene::from_toml(POOL, "full.toml", &["domain.max_m=[0.8, 0.4, 0.02]".into()]).unwrap();
    let mut squashed = sample_lattice(&full);
    squashed.positions.iter_mut().take(80).for_each(|at| at.position_m[1] = 0.2);
    let more = sample_lattice(&full).positions.len();
    let mut both = squashed.clone();
    both.positions.extend(squashed.positions.iter().take(more / 5).map(|at| brooklet_kernels::Position {
        position_m: [at.position_m[0] + 0.007, at.position_m[1] + 0.007, at.position_m[2]],
        tag: at.tag + more as u32,
    }));
    both.velocities.extend(squashed.velocities.iter().take(more / 5));
    let done = relax_particles(&gpu(), &full, &mut both).unwrap().unwrap();
    assert!(done.rounds < MOST_ROUNDS / 2 && !done.compression[1].is_within(&NO_COMPRESSION), "{done:?}");
}

#[test]
fn a_start_at_rest_goes_on_bit_for_bit() {
    let settings = ["spacing_m=0.05", "solver.deterministic=true"].map(String::from);
    let scene = Scene::load("colliding-drops", &settings).unwrap();
    let run = |relaxes: bool| {
        let mut session = Session::start(&gpu(), planned(&scene, ParticleSource::Scene, relaxes)).unwrap();
        let rounds = session.relax_start().unwrap().map(|done| done.rounds);
        (0..5).for_each(|_| session.step().unwrap());
        (rounds, session.read_particles().unwrap())
    };
    let [(rounds, with), (_, without)] = [true, false].map(run);
    assert_eq!(rounds, Some(0));
    assert!(with.positions == without.positions && with.velocities == without.velocities);
}

#[test]
fn relaxation_takes_no_memory_and_is_there_where_it_is_asked_for() {
    for settings in [&[][..], &["solver.pbf.s_corr_k=0.001", "solver.precision=relaxed", "forces.xsph=0.1"]] {
        let scene = pool(settings);
        let [with, without] = [true, false].map(|relaxes| planned(&scene, ParticleSource::Scene, relaxes).plan);
        assert_eq!(with.buffers(), without.buffers());
        let kept = |plan: &brooklet_gpu::Plan| {
            plan.passes().iter().filter(|pass| pass.module.name.contains("KEEP_VELOCITY")).count()
        };
        assert_eq!((kept(&with), kept(&without)), (2, 0));
        let corrections = with.passes().into_iter().filter(|pass| pass.stage == "correct_positions");
        let s_corr: Vec<bool> = corrections.map(|pass| pass.module.name.contains("S_CORR")).collect();
        assert_eq!(s_corr, [!settings.is_empty(), false], "it would push on for ever");
    }
}
