//! The session that steps a scene: what frames report, and what goes on in another session.

use brooklet_fluid::{FrameRequest, ParticleSource, Scene, Session, SessionPlan, SessionRecorder};
use brooklet_tests::gpu;

fn scene(settings: &[&str]) -> Scene {
    let small = ["spacing_m=0.1", "solver.deterministic=true", "outputs.measure_every_steps=4"];
    let settings: Vec<String> = small.iter().chain(settings).map(|&s| s.into()).collect();
    Scene::load("dam-break", &settings).unwrap()
}

fn count_only(scene: &Scene, count: u32) -> SessionPlan {
    SessionRecorder::new(scene, ParticleSource::Count(count)).sweep().unwrap()
}

fn steps(steps: u32) -> FrameRequest<'static> {
    FrameRequest { steps, ..FrameRequest::default() }
}

fn bits(session: &mut Session) -> Vec<u8> {
    let particles = session.read_particles().unwrap();
    [bytemuck::cast_slice(&particles.positions), bytemuck::cast_slice(&particles.velocities)].concat()
}

#[test]
fn frames_say_which_steps_they_did_and_what_they_measured() {
    let scene = scene(&[]);
    let mut session = Session::new(&gpu(), &scene).unwrap();
    assert!(session.finish().unwrap().is_empty(), "the first recordings are nobody's frame");
    session.submit(&FrameRequest { measure: true, ..steps(3) }).unwrap();
    session.submit(&steps(2)).unwrap();
    session.measure().unwrap();
    let frames = session.finish().unwrap();
    let done: Vec<_> = frames.iter().map(|frame| (frame.steps, frame.stats.is_some())).collect();
    assert_eq!(done, [(3, true), (5, false), (5, true)]);
    for frame in &frames {
        assert_eq!(frame.simulated_s, frame.steps as f64 * scene.solver.dt_s);
    }
    assert!(frames.windows(2).all(|pair| pair[0].report.frame < pair[1].report.frame));
    let last = frames[2].stats.unwrap();
    assert_eq!(session.stats(), Some(last));
    assert_eq!(last.particles, session.slot_count());
    assert_ne!(frames[0].stats, frames[2].stats, "two steps on, the fluid has moved");
}

#[test]
fn what_the_session_was_not_recorded_with_is_not_done() {
    let scene = scene(&["outputs.measure_every_steps=0"]);
    let mut session = Session::new(&gpu(), &scene).unwrap();
    let before = bits(&mut session);
    session.submit(&FrameRequest { measure: true, sample: true, ..FrameRequest::default() }).unwrap();
    let frames = session.finish().unwrap();
    assert!(frames[0].stats.is_none() && frames[0].report.readbacks.is_empty());
    assert!(session.stats().is_none() && session.samples_id().is_none());
    assert!(bits(&mut session) == before);
    let elsewhere = count_only(&scene, 1).recorded.measure_id();
    assert!(elsewhere.is_none());
}

#[test]
fn an_adopted_session_goes_on_bit_for_bit() {
    let scene = scene(&[]);
    let mut old = Session::new(&gpu(), &scene).unwrap();
    old.submit(&steps(7)).unwrap();
    let mut new = Session::start(&gpu(), count_only(&scene, old.slot_count())).unwrap();
    let fresh = bits(&mut new);
    new.adopt(&old).unwrap();
    assert_eq!((new.steps(), new.simulated_s()), (7, old.simulated_s()));
    assert!(bits(&mut new) == bits(&mut old) && bits(&mut new) != fresh);
    for session in [&mut old, &mut new] {
        session.submit(&steps(5)).unwrap();
    }
    assert!(bits(&mut new) == bits(&mut old));
    assert_eq!(new.steps(), 12);
}

#[test]
fn an_adopted_session_keeps_its_own_numbers() {
    let (still, windy) = (scene(&[]), scene(&["gravity_m_s2=[3,-5,0]"]));
    let mut old = Session::new(&gpu(), &still).unwrap();
    old.submit(&steps(3)).unwrap();
    let mut new = Session::start(&gpu(), count_only(&windy, old.slot_count())).unwrap();
    new.adopt(&old).unwrap();
    let mut taken = Session::start(&gpu(), count_only(&still, old.slot_count())).unwrap();
    taken.adopt(&old).unwrap();
    assert!(taken.apply(&count_only(&windy, old.slot_count())).unwrap());
    for session in [&mut old, &mut new, &mut taken] {
        session.submit(&steps(4)).unwrap();
    }
    assert!(bits(&mut new) == bits(&mut taken) && bits(&mut new) != bits(&mut old));
}

#[test]
fn time_counts_each_step_with_its_own_length() {
    let (slow, fast) = (scene(&["solver.dt_s=0.002"]), scene(&["solver.dt_s=0.001"]));
    let mut session = Session::new(&gpu(), &slow).unwrap();
    session.submit(&steps(3)).unwrap();
    assert!(session.apply(&count_only(&fast, session.slot_count())).unwrap());
    session.submit(&steps(4)).unwrap();
    assert!((session.simulated_s() - 0.010).abs() < 1e-15, "{}", session.simulated_s());
    let frames = session.finish().unwrap();
    assert!((frames[0].simulated_s - 0.006).abs() < 1e-15, "as it was when the frame was handed over");
    assert!(!session.apply(&count_only(&fast, session.slot_count() + 1)).unwrap(), "another number of particles");
    assert!(!session.apply(&count_only(&scene(&["spacing_m=0.12"]), session.slot_count())).unwrap());
}
