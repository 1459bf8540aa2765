//! Particles that come and go on the GPU: counts, ids, and the motion of everybody else.

use brooklet_fluid::particles::{id_of, is_inactive};
use brooklet_fluid::state::State;
use brooklet_fluid::{
    DrainBox, FrameRequest, ParticleBlock, ParticleSource, Scene, Session, SessionRecorder, SessionReport, visit_slots,
};
use brooklet_kernels::{Position, StepState, Velocity};
use brooklet_tests::small;
use brooklet_tests::{gpu, rng};
use rand::RngExt;

/// A block that falls to one end of a long tank and stays there. Far from it particles come and go, and are too slow to
/// reach it before they do.
const SCENE: &str = "spacing_m = 0.1
gravity_m_s2 = [-1.0, 0.0, 0.0]
[domain]
min_m = [0.0, 0.0, 0.0]
max_m = [6.0, 1.2, 0.8]
[[fluid]]
block = { min_m = [0.2, 0.1, 0.0], max_m = [0.8, 0.7, 0.8] }
[solver]
deterministic = true
[outputs]
measure_every_steps = 1
";
/// All that ever comes, and none of the block, is in it.
const DRAIN: DrainBox = DrainBox { min_m: [1.5, -1.0, -1.0], max_m: [7.0, 2.0, 2.0] };
const MOST: u32 = 60;
/// Slots that the scene begins without: few enough that blocks find none, now and then.
const SPARE: u32 = 70;

fn scene(capacity: Option<u32>) -> Scene {
    let more = capacity.map(|capacity| format!("capacity={capacity}"));
    Scene::from_toml(SCENE, "long-tank", &more.into_iter().collect::<Vec<_>>()).unwrap()
}

fn session(scene: &Scene) -> Session {
    let recorder = SessionRecorder::new(scene, ParticleSource::Scene).with_slot_changes(MOST);
    Session::start(&gpu(), recorder.sweep().unwrap()).unwrap()
}

/// Particles by id, those of the block alone.
fn block(session: &mut Session, particles: usize) -> Vec<(Position, Velocity)> {
    let set = session.read_particles().unwrap();
    let mut block = vec![Default::default(); particles];
    for (position, velocity) in set.positions.iter().zip(&set.velocities) {
        if let Some(slot) = block.get_mut(id_of(position.tag) as usize) {
            *slot = (*position, *velocity);
        }
    }
    block
}

/// What a frame is to do, drawn from a seed.
struct Change {
    drains: bool,
    comes: Option<ParticleBlock>,
}

fn changes(seed: u64, steps: usize) -> Vec<Change> {
    let mut rng = rng(seed);
    (0..steps)
        .map(|_| Change {
            drains: rng.random_bool(0.1),
            comes: rng.random_bool(0.2).then(|| ParticleBlock {
                first_m: [4.2 + 0.4 * rng.random::<f64>(), 0.4, 0.15],
                spacing_m: 0.11,
                counts: [rng.random_range(1..=3), rng.random_range(1..=4), rng.random_range(1..=5)],
                velocity_m_s: [0.0, -0.5, 0.1],
                fluid: 1,
            }),
        })
        .collect()
}

fn run(session: &mut Session, change: &Change) {
    let request = FrameRequest {
        deactivate: change.drains.then_some(&DRAIN),
        activate: change.comes.as_ref(),
        steps: 1,
        measure: true,
        ..FrameRequest::default()
    };
    session.submit(&request).unwrap();
}

#[test]
fn particles_come_and_go_for_five_hundred_steps_and_nobody_else_is_moved() {
    let particles = scene(None).particle_count() as usize;
    let capacity = particles as u32 + SPARE;
    let steps = if small() { 60 } else { 500 };
    let scene_alone = scene(None);
    let mut alone = Session::new(&gpu(), &scene_alone).unwrap();
    let mut changing = session(&scene(Some(capacity)));
    let (mut present, mut overflow, mut came, mut full) = (0, 0, 0, 0);
    let mut expected = Vec::new();
    for change in changes(5, steps) {
        alone.step().unwrap();
        run(&mut changing, &change);
        // Slots that are emptied are free after the next sort only: this frame's block still finds them taken.
        let taken = present;
        if change.drains {
            present = 0;
        }
        let wanted = change.comes.map_or(0, |block| block.counts.iter().product::<u32>());
        let found = wanted.min(SPARE - taken);
        present += found;
        overflow += wanted - found;
        came += found;
        full += u32::from(found < wanted);
        expected.push((particles as u32 + present, wanted - found));
    }
    assert!(small() || (came > 500 && full > 2), "{came} came, {full} blocks found no room");
    let frames: Vec<SessionReport> = changing.finish().unwrap();
    // The newest 64 are kept; one by one they say what the host expects.
    let newest = expected.iter().rev().zip(frames.iter().rev());
    assert!(newest.len() > 20);
    for (&(count, lost), frame) in newest {
        let stats = frame.stats.unwrap();
        assert_eq!((stats.particles, stats.counters.capacity_overflow), (count, lost), "after step {}", frame.steps);
    }
    assert!(overflow > 0 || small());

    let (got, expected_block) = (block(&mut changing, particles), block(&mut alone, particles));
    assert!(got == expected_block, "the block moves as if nobody came, bit for bit");
    let set = changing.read_particles().unwrap();
    let mut ids: Vec<u32> = set.positions.iter().map(|position| id_of(position.tag)).collect();
    ids.sort_unstable();
    assert!(ids.into_iter().eq(0..capacity), "each slot keeps its id, and is there once");
    let active = particles + present as usize;
    let split = set.positions.iter().position(|position| is_inactive(position.tag)).unwrap_or(capacity as usize);
    assert!(split == active && set.positions[split..].iter().all(|position| is_inactive(position.tag)));
    let state: StepState = state(&mut changing);
    assert_eq!(state.active_count, active as u32);
    let simulated_s = changing.simulated_s();
    assert!((f64::from(state.time_s) / simulated_s - 1.0).abs() < 1e-6, "{} of {simulated_s} s", state.time_s);

    let mut again = session(&scene(Some(capacity)));
    changes(5, steps).iter().for_each(|change| run(&mut again, change));
    let bits = |set: &brooklet_fluid::particles::ParticleSet| {
        [bytemuck::cast_slice::<_, u8>(&set.positions), bytemuck::cast_slice(&set.velocities)].concat()
    };
    assert!(bits(&again.read_particles().unwrap()) == bits(&set), "a run is the same each time, ids as well");
}

fn state(session: &mut Session) -> StepState {
    let buffer = session.recorded().slots.state.alias();
    session.engine_mut().read(&buffer).unwrap()[0]
}

#[test]
fn spare_slots_change_nothing_that_moves() {
    let particles = scene(None).particle_count() as usize;
    let mut alone = Session::new(&gpu(), &scene(None)).unwrap();
    let mut roomy = Session::new(&gpu(), &scene(Some(4 * particles as u32))).unwrap();
    for _ in 0..20 {
        alone.step().unwrap();
        roomy.step().unwrap();
    }
    assert!(block(&mut alone, particles) == block(&mut roomy, particles));
    assert_eq!(state(&mut roomy).active_count as usize, particles);
    assert_eq!(state(&mut roomy).slot_count as usize, particles, "none of the spare slots is visited");
}

#[test]
fn a_slider_leaves_what_the_gpu_counts() {
    let mut session = session(&scene(Some(400)));
    let block = changes(5, 60).into_iter().find_map(|change| change.comes).unwrap();
    session.submit(&FrameRequest { activate: Some(&block), steps: 3, ..FrameRequest::default() }).unwrap();
    let before = state(&mut session);
    assert_eq!(before.active_count, before.slot_count);
    assert!(before.active_count as u64 > scene(None).particle_count());
    let mut faster = scene(Some(400));
    faster.solver.dt_s /= 2.0;
    let planned = SessionRecorder::new(&faster, ParticleSource::Count(400)).with_slot_changes(MOST).sweep().unwrap();
    assert!(session.apply(&planned).unwrap(), "a step of time is a number");
    session.step().unwrap();
    let after = state(&mut session);
    assert_eq!((after.active_count, after.slot_count), (before.active_count, before.slot_count));
    assert_eq!(after.dt_s, before.dt_s / 2.0);
    assert!((after.time_s - before.time_s - after.dt_s * faster.solver.substeps as f32).abs() < 1e-6);
}

#[test]
fn what_cannot_be_activated_is_said() {
    let mut session = session(&scene(Some(400)));
    let block = ParticleBlock { first_m: [1.0; 3], spacing_m: 0.1, counts: [1; 3], velocity_m_s: [0.0; 3], fluid: 0 };
    let wrong = [
        (ParticleBlock { counts: [61, 1, 1], ..block }, "61 particles; it was recorded for 60"),
        (ParticleBlock { counts: [u32::MAX; 3], ..block }, "recorded for 60"),
        (ParticleBlock { first_m: [f64::NAN, 0.0, 0.0], ..block }, "finite"),
        (ParticleBlock { velocity_m_s: [0.0, 1e300, 0.0], ..block }, "finite"),
        (ParticleBlock { spacing_m: 0.0, ..block }, "spacing is 0 m"),
        (ParticleBlock { fluid: 127, ..block }, "fluid is 127"),
    ];
    for (block, part) in wrong {
        let request = FrameRequest { activate: Some(&block), steps: 1, ..FrameRequest::default() };
        let error = session.submit(&request).expect_err(part).to_string();
        assert!(error.contains(part), "{error}");
    }
    assert_eq!(session.steps(), 0, "nothing of a refused frame is done");
    session.submit(&FrameRequest { activate: Some(&block), steps: 1, ..FrameRequest::default() }).unwrap();
}

#[test]
fn a_saved_state_has_its_inactive_slots() {
    let scene = scene(Some(400));
    let mut session = session(&scene);
    let all = changes(6, 30);
    all.iter().for_each(|change| run(&mut session, change));
    let saved = session.read_state().unwrap();
    let read = State::from_bytes(&saved.to_bytes(), "test").unwrap();
    assert_eq!(read.scene.capacity, Some(400));

    let recorder =
        SessionRecorder::new(&read.scene, ParticleSource::Given(read.particles.clone())).with_slot_changes(MOST);
    let mut planned = recorder.sweep().unwrap();
    planned.start_at(&read);
    let mut resumed = Session::start(&gpu(), planned).unwrap();
    assert_eq!(state(&mut resumed), StepState { dt_s: 0.0, ..state_after_sort(&mut session) });
    for change in changes(7, 30) {
        run(&mut session, &change);
        run(&mut resumed, &change);
    }
    let (one, other) = (session.read_particles().unwrap(), resumed.read_particles().unwrap());
    assert!(one.positions == other.positions && one.velocities == other.velocities, "both go on alike");
    assert_eq!(state(&mut session).active_count, state(&mut resumed).active_count);
}

/// The session's state, had it begun where its last sort left it.
fn state_after_sort(session: &mut Session) -> StepState {
    let last = state(session);
    StepState { dt_s: last.dt_s, time_s: last.time_s, time_lost_s: last.time_lost_s, ..visit_slots(last.active_count) }
}
