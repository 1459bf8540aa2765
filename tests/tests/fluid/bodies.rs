//! Solids that the fluid moves: they float where Archimedes says, take what the fluid loses, rest on what is under them, and go
//! on from a saved state.

use brooklet_fluid::scene::body_mass_kg;
use brooklet_fluid::state::State;
use brooklet_fluid::{BodyMotion, ParticleSource, Scene, Session, SessionRecorder, reaction_sums};
use brooklet_tests::afloat::{FLAT_BOX, SHALLOW_M, draft_m, floating};
use brooklet_tests::{gpu, gpu_of_long_run, small};
use glam::{DQuat, DVec3};

fn vector(of: [f32; 3]) -> DVec3 {
    DVec3::from_array(of.map(f64::from))
}

const FLAT_HULL: &str = "hull = { points_m = [[-0.1, -0.05, -0.1], [0.1, -0.05, -0.1], [-0.1, 0.05, -0.1], [0.1, 0.05, -0.1], \
    [-0.1, -0.05, 0.1], [0.1, -0.05, 0.1], [-0.1, 0.05, 0.1], [0.1, 0.05, 0.1]] }";

#[test]
fn a_box_floats_as_deep_as_archimedes_says() {
    let steps = if small() { 5 } else { 200 };
    for (density_kg_m3, method) in [(300.0, "pbf"), (700.0, "pbf"), (500.0, "dfsph"), (500.0, "sph")] {
        let scene = floating(FLAT_BOX, density_kg_m3, method, 0.025, SHALLOW_M);
        let mut session = Session::new(&gpu_of_long_run(&scene), &scene).unwrap();
        let mut drafts_m = Vec::new();
        for step in 0..steps {
            session.step().unwrap();
            if step >= steps / 2 && step % 10 == 0 {
                drafts_m.push(draft_m(&scene, &session.read_bodies().unwrap().states[0]));
            }
        }
        let state = session.read_bodies().unwrap().states[0];
        assert!(state.position_m.iter().all(|x| x.is_finite()));
        if small() {
            continue;
        }
        let (draft_m, expected_m) = (drafts_m.iter().sum::<f64>() / drafts_m.len() as f64, density_kg_m3 * 1e-4);
        println!("{density_kg_m3} kg/m³ with {method}: draft {draft_m:.4} m, {expected_m:.4} expected; {state:?}");
        assert!(
            (draft_m - expected_m).abs() < 0.00625,
            "{draft_m} m, not {expected_m}: more than a quarter of a spacing"
        );
        assert!(state.rotation[3].abs() > 0.99, "it tilts: {:?}", state.rotation);
    }
}

/// A drop hits a ball that neither falls.
#[test]
fn momentum_goes_from_fluid_to_body_in_free_space() {
    let text = "spacing_m = 0.025\ngravity_m_s2 = [0, 0, 0]\n[domain]\nwalls = false\nmin_m = [0, 0, 0]\nmax_m = [1, 1, 1]\n\
         [[fluid]]\nsphere = { centre_m = [0.3, 0.5, 0.5], radius_m = 0.12 }\nvelocity_m_s = [2, 0.2, 0]\n\
         [[solid]]\nsphere = { radius_m = 0.1 }\ncentre_m = [0.55, 0.5, 0.5]\ndensity_kg_m3 = 500\n\
         [outputs]\nmeasure_every_steps = 1\n";
    for method in ["pbf", "sph", "dfsph", "none"] {
        let scene = Scene::from_toml(text, "hit", &[format!("solver.method={method}")]).unwrap();
        let mass_kg = body_mass_kg(&scene.solids[0]);
        let mut session = Session::new(&gpu(), &scene).unwrap();
        let mut momenta = |steps: u32| {
            (0..steps).for_each(|_| session.step().unwrap());
            session.measure().unwrap();
            let stats = session.finish().unwrap().into_iter().filter_map(|report| report.stats).next_back().unwrap();
            let bodies = session.read_bodies().unwrap();
            let state = bodies.states[0];
            // What the fluid gave and the body has not taken yet counts as well.
            let unit_kg_m_s = brooklet_fluid::boundary::solids::solids_params(&scene).unit_kg_m_s;
            let sums = reaction_sums(&bodies.reactions);
            let given = DVec3::from_array(std::array::from_fn(|k| sums[k] as f64 * f64::from(unit_kg_m_s)));
            let body = mass_kg * vector(state.velocity_m_s) + vector(state.owed_kg_m_s) + given;
            (DVec3::from_array(stats.momentum_kg_m_s), body)
        };
        let (fluid, body) = momenta(1);
        let (first, before) = (fluid + body, fluid.length());
        let (fluid, body) = momenta(if small() { 4 } else { 60 });
        let off = (fluid + body - first).length() / before;
        println!("{method}: {fluid} + {body} kg m/s, off by {off:.5}");
        assert!(off < 0.01, "{method}: {first} became {fluid} and {body}");
        assert!(small() || body.x > 0.1 * before, "{method}: the body took {body} of {before}");
    }
}

/// The same box, as the hull of its corners and as a shape of its own.
#[test]
fn a_hull_floats_as_deep_as_the_box_that_it_is() {
    let [of_box, of_hull] = [FLAT_BOX, FLAT_HULL].map(|shape| floating(shape, 500.0, "pbf", 0.025, SHALLOW_M));
    let [one, other] = [&of_box, &of_hull].map(|scene| brooklet_fluid::scene::bodies(scene)[0]);
    assert!((one.inverse_mass_per_kg / other.inverse_mass_per_kg - 1.0).abs() < 1e-6);
    for (one, other) in one.inertia_kg_m2.iter().zip(other.inertia_kg_m2) {
        assert!((one / other - 1.0).abs() < 1e-5, "{one} and {other}");
    }
    if small() {
        return;
    }
    let mut session = Session::new(&gpu_of_long_run(&of_hull), &of_hull).unwrap();
    let mut drafts_m = Vec::new();
    for step in 0..160 {
        session.step().unwrap();
        if step >= 100 && step % 10 == 0 {
            drafts_m.push(draft_m(&of_hull, &session.read_bodies().unwrap().states[0]));
        }
    }
    let draft_m = drafts_m.iter().sum::<f64>() / drafts_m.len() as f64;
    println!("draft {draft_m:.4} m");
    assert!((draft_m - 0.05).abs() < 0.00625, "{draft_m} m: more than a quarter of a spacing off");
}

/// Without fluid, by a small angle: T = 2 pi sqrt(I / (m g d)).
#[test]
fn a_body_on_a_hinge_swings_as_a_compound_pendulum() {
    let text = "spacing_m = 0.05\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [1, 1, 1]\n\
         [[fluid]]\nblock = { min_m = [0.9, 0.9, 0.9], max_m = [0.95, 0.95, 0.95] }\n\
         [[solid]]\nbox = { size_m = [0.06, 0.4, 0.2] }\nturned_deg = [0, 0, 6]\ncentre_m = [0.5, 0.5, 0.5]\n\
         density_kg_m3 = 800\nhinge = { axis = [0, 0, 2], at_m = [HX, HY, 0.4] }\n\
         [solver]\nmethod = \"none\"\n";
    // On its top edge's middle.
    let arm_m = DQuat::from_rotation_z(6_f64.to_radians()) * DVec3::new(0.0, 0.2, 0.0);
    let text = text.replace("HX", &(0.5 + arm_m.x).to_string()).replace("HY", &(0.5 + arm_m.y).to_string());
    let scene = Scene::from_toml(&text, "pendulum", &[]).unwrap();
    let mut session = Session::new(&gpu_of_long_run(&scene), &scene).unwrap();
    let dt_s = scene.solver.dt_s;
    let squared_m2 = (0.06 * 0.06 + 0.4 * 0.4) / 12.0 + 0.2 * 0.2;
    let period_s = std::f64::consts::TAU * (squared_m2 / (9.81 * 0.2_f64)).sqrt();
    let angle = |session: &mut Session| {
        session.step().unwrap();
        let state = session.read_bodies().unwrap().states[0];
        let place_m = vector(state.position_m) - (DVec3::new(0.5, 0.5, 0.5) + arm_m).with_z(0.5);
        assert!((place_m.length() - 0.2).abs() < 1e-5, "the hinge lets go: {}", place_m.length());
        assert!((f64::from(state.position_m[2]) - 0.5).abs() < 1e-6 && state.rotation[0].abs() < 1e-6, "{state:?}");
        place_m.x.atan2(-place_m.y)
    };
    let steps = if small() { 20 } else { (2.2 * period_s / dt_s) as usize };
    let angles: Vec<f64> = (0..steps).map(|_| angle(&mut session)).collect();
    if small() {
        return;
    }
    // Where it swings through its lowest place, in one direction.
    let crossings: Vec<f64> = angles
        .windows(2)
        .enumerate()
        .filter(|(_, pair)| pair[0] < 0.0 && pair[1] >= 0.0 || pair[0] > 0.0 && pair[1] <= 0.0)
        .map(|(step, pair)| (step as f64 + pair[0] / (pair[0] - pair[1])) * dt_s)
        .collect();
    let measured_s = crossings[2] - crossings[0];
    println!("{measured_s} s, {period_s} s expected");
    // A swing of 6 degrees takes .07 % longer, a step of semi-implicit Euler (w dt)²/24 less.
    assert!((measured_s / period_s - 1.0).abs() < 0.003, "{measured_s} s, not {period_s}");
}

/// Without fluid: a ball falls on a box that lies on the floor, and both come to rest on each other.
#[test]
fn bodies_fall_bounce_and_come_to_rest_on_each_other() {
    let text = "spacing_m = 0.05\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [1, 1, 1]\n\
         [[fluid]]\nblock = { min_m = [0.9, 0.9, 0.9], max_m = [0.95, 0.95, 0.95] }\n\
         [[solid]]\nbox = { size_m = [0.4, 0.2, 0.4] }\ncentre_m = [0.5, 0.3, 0.5]\ndensity_kg_m3 = 800\nfriction = 0.5\n\
         [[solid]]\nsphere = { radius_m = 0.1 }\ncentre_m = [0.5, 0.7, 0.5]\ndensity_kg_m3 = 2000\nrestitution = 0.5\n\
         [solver]\nmethod = \"none\"\n[outputs]\nmeasure_every_steps = 1\n";
    let scene = Scene::from_toml(text, "fall", &[]).unwrap();
    let mut session = Session::new(&gpu_of_long_run(&scene), &scene).unwrap();
    let mut falls = |seconds: f64| {
        (0..(seconds / scene.solver.dt_s).round() as u32).for_each(|_| session.step().unwrap());
        session.read_bodies().unwrap().states
    };
    // Free fall for .1 s: g t²/2 and a rounding of steps.
    let states = falls(0.1);
    let fell_m = 0.5 * 9.81 * 0.01;
    assert!((f64::from(states[1].position_m[1]) - (0.7 - fell_m)).abs() < 0.006, "{:?}", states[1]);
    let states = falls(if small() { 0.5 } else { 2.5 });
    println!("{states:?}");
    assert!((states[0].position_m[1] - 0.1).abs() < 0.01, "the box lies on the floor: {:?}", states[0]);
    assert!(small() || (states[1].position_m[1] - 0.3).abs() < 0.01, "the ball lies on the box: {:?}", states[1]);
    let fastest_m_s = states.iter().map(|state| vector(state.velocity_m_s).length()).fold(0.0, f64::max);
    assert!(small() || fastest_m_s < 0.05, "{fastest_m_s} m/s");
}

#[test]
fn a_saved_state_goes_on_bit_for_bit() {
    let scene = floating(FLAT_BOX, 400.0, "pbf", 0.025, SHALLOW_M).with_setting("solver.deterministic=true").unwrap();
    let mut session = Session::new(&gpu(), &scene).unwrap();
    (0..6).for_each(|_| session.step().unwrap());
    let saved = session.read_state().unwrap();
    let bytes = saved.to_bytes();
    let read = State::from_bytes(&bytes, "test").unwrap();
    assert_eq!(read.bodies, saved.bodies);
    let recorder = SessionRecorder::new(&read.scene, ParticleSource::Given(read.particles.clone()));
    let mut planned = recorder.sweep().unwrap();
    planned.start_at(&read);
    let mut resumed = Session::start(&gpu(), planned).unwrap();
    for _ in 0..6 {
        session.step().unwrap();
        resumed.step().unwrap();
    }
    let (one, other) = (session.read_particles().unwrap(), resumed.read_particles().unwrap());
    assert!(one.positions == other.positions && one.velocities == other.velocities, "particles go on alike");
    assert_eq!(session.read_bodies().unwrap(), resumed.read_bodies().unwrap());
    // The comparator: a body that begins anew does not.
    resumed.write_bodies(&BodyMotion::first(&scene));
    resumed.step().unwrap();
    session.step().unwrap();
    assert_ne!(session.read_bodies().unwrap(), resumed.read_bodies().unwrap());
    // A rotation that is none is refused.
    let mut broken = saved.clone();
    broken.bodies.states[0].rotation = [0.0; 4];
    let message = State::from_bytes(&broken.to_bytes(), "test").unwrap_err().to_string();
    assert!(message.contains("the state of body 0"), "{message}");
}

#[test]
fn a_scene_without_bodies_has_nothing_of_them() {
    let stages = |scene: &Scene| {
        let planned = SessionRecorder::new(scene, ParticleSource::Count(100)).sweep().unwrap();
        format!("{:?}", planned.plan.passes().into_iter().map(|pass| pass.stage).collect::<Vec<_>>())
    };
    let scene = floating(FLAT_BOX, 500.0, "pbf", 0.025, SHALLOW_M);
    let mut standing = scene.clone();
    standing.solids[0].density_kg_m3 = None;
    for stage in ["find_contacts", "step_bodies", "gather_reactions"] {
        assert!(stages(&scene).contains(stage) && !stages(&standing).contains(stage), "{stage}");
    }
}
