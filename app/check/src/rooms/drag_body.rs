//! `boundary/bodies/drag_body`: the kernel against its twin, and as a program records it.

use super::bodies::{Case, case, twin_body, twin_state};
use crate::bench::Bench;
use crate::compare::{Worst, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, Wrong, ensure, ensure_eq};
use brooklet_fluid::drag_body::{BodyDrag, record_drag_body};
use brooklet_fluid::{Scene, record};
use brooklet_gpu::{Plan, Resources};
use brooklet_kernels::{BodyDragParams, BodyState, DragBody, Kernel as _, NO_BODY};
use brooklet_reference::boundary::bodies::drag_body::{self as twin, drag_body};
use glam::DVec3;
use rand::{Rng, RngExt};

fn run(device: &Device, case: &Case, params: BodyDragParams) -> Vec<BodyState> {
    let mut bench = Bench::new(device);
    let bodies = bench.input("bodies", &case.bodies);
    let mut states = bench.input("body_states", &case.states);
    let body_drag = bench.uniform("body_drag_params", params);
    bench.dispatch(&DragBody { bodies: bodies.read(), body_states: states.write(), body_drag: body_drag.uniform() }, 1);
    bench.run().read(&states, case.states.len())
}

fn twin_of(params: &BodyDragParams) -> twin::BodyDrag {
    twin::BodyDrag {
        grip_m: vector(params.grip_m),
        target_m: vector(params.target_m),
        kept: params.kept.into(),
        pull_per_s: params.pull_per_s.into(),
        kept_spin: params.kept_spin.into(),
        most_m_s: params.most_m_s.into(),
    }
}

/// A place of up to a metre is known to 6e-8 m, of which `pull_per_s` (10 at most) makes 1e-6 m/s, a few times over; Cramer's
/// rule has some fifty operations on numbers of a few m/s.
const TOLERANCE: f64 = 2e-5;

fn check(
    got: &[BodyState],
    case: &Case,
    params: &BodyDragParams,
    drag: &twin::BodyDrag,
    worst: &mut Worst,
) -> Result<(), Wrong> {
    for (b, (got, before)) in got.iter().zip(&case.states).enumerate() {
        if b != params.body as usize {
            ensure_eq!(got, before, "body {b} is not dragged");
            continue;
        }
        let body = twin_body(&case.bodies[b]);
        let expected = drag_body(&body, &twin_state(before), drag);
        let diagonal = [body.inertia_kg_m2.x_axis.x, body.inertia_kg_m2.y_axis.y, body.inertia_kg_m2.z_axis.z];
        let arm_m = (diagonal.into_iter().fold(f64::INFINITY, f64::min) / body.mass_kg).sqrt();
        worst.check3(got.velocity_m_s, expected.velocity_m_s, 4.0)?;
        worst.check3(got.spin_rad_s, expected.spin_rad_s, 4.0 / arm_m)?;
        ensure_eq!((got.position_m, got.rotation), (before.position_m, before.rotation));
        ensure_eq!((got.owed_kg_m_s, got.owed_kg_m2_s), (before.owed_kg_m_s, before.owed_kg_m2_s));
    }
    Ok(())
}

fn params(case: &Case, body: u32, rng: &mut impl Rng) -> BodyDragParams {
    let mut one = |most: f64| DVec3::from_array(std::array::from_fn(|_| most * (rng.random::<f64>() * 2.0 - 1.0)));
    let state = &case.states[body as usize];
    BodyDragParams {
        grip_m: one(0.12).as_vec3().to_array(),
        body,
        target_m: (vector(state.position_m) + one(0.3)).as_vec3().to_array(),
        kept: 0.6,
        pull_per_s: 8.0,
        kept_spin: 0.9,
        most_m_s: 2.0,
        ..BodyDragParams::default()
    }
}

pub(crate) fn drag_body_matches_its_twin(device: &Device) {
    let mut rng = rng(231);
    let mut worst = device.worst(DragBody::STAGE, TOLERANCE);
    let (mut all, mut refused) = (0, 0);
    for _ in 0..if device.small() { 2 } else { 6 } {
        let case = case(&mut rng);
        for body in 0..case.bodies.len() as u32 {
            let params = params(&case, body, &mut rng);
            let got = run(device, &case, params);
            let right = twin_of(&params);
            check(&got, &case, &params, &right, &mut worst).or_raise();
            for wrong in [
                twin::BodyDrag { grip_m: right.grip_m + DVec3::X * 1e-3, ..right },
                twin::BodyDrag { kept_spin: 0.99 * right.kept_spin, ..right },
            ] {
                let mut told = Worst::new(DragBody::STAGE, TOLERANCE);
                refused += usize::from(check(&got, &case, &params, &wrong, &mut told).is_err());
                all += 1;
            }
        }
        let idle = BodyDragParams { body: NO_BODY, ..params(&case, 0, &mut rng) };
        ensure_eq!(run(device, &case, idle), case.states, "nobody drags");
    }
    // A grip that is a millimetre aside may do the same where it is as far away in the direction of the pull.
    ensure!(10 * refused > 9 * all, "{refused} of {all} wrong drags are told apart");
    worst.report(device);
}

/// A block that hangs in the air, of twice the density of what there is none of.
const HUNG: &str = r#"
spacing_m = 0.05
gravity_m_s2 = [0, 0, 0]
[domain]
min_m = [1, 2, 3]
max_m = [2, 3, 4]
[[fluid]]
block = { min_m = [1, 2, 3], max_m = [1.1, 2.1, 3.1] }
[[solid]]
box = { size_m = [0.2, 0.1, 0.2] }
centre_m = [1.5, 2.5, 3.5]
density_kg_m3 = 2000
[solver]
method = "none"
"#;

pub(crate) fn a_body_is_dragged_to_where_the_hand_is(device: &Device) {
    let planned = |text: &str| {
        let scene = Scene::from_toml(text, "hung", &[]).or_raise();
        let mut resources = Resources::new();
        let mut recorded = record(&mut resources, &scene);
        let pass = record_drag_body(&mut resources, &mut recorded);
        let drags = pass.as_ref().map(|pass| pass.recording.clone());
        let recordings = recorded.recordings().into_iter().chain(drags).collect();
        (Plan::sweep(resources, recordings, &[]).or_raise(), scene, recorded, pass)
    };
    let drags = |plan: &Plan| plan.passes().iter().filter(|pass| pass.stage == DragBody::STAGE).count();
    let (without, .., pass) = planned(&HUNG.replace("density_kg_m3 = 2000", ""));
    ensure!(pass.is_none() && drags(&without) == 0, "a scene without bodies has no pass for them");
    ensure!(without.buffers().iter().all(|buffer| buffer.label != "body_drag_params"));
    let (plan, scene, recorded, pass) = planned(HUNG);
    ensure_eq!(drags(&plan), 1);
    let (pass, bodies) = (pass.or_raise(), recorded.bodies.as_ref().or_raise());
    let mut engine = device.engine(plan);
    engine.run(&[recorded.init.id(), pass.recording.id()], &[]).or_raise();
    let first = engine.read(&bodies.states).or_raise();
    ensure_eq!(first[0].velocity_m_s, [0.0; 3], "nothing moves before the first drag");

    let target_m = DVec3::new(0.7, 0.75, 0.4);
    let drag = BodyDrag {
        body: 0,
        grip_m: [0.08, 0.05, 0.0],
        target_m: target_m.to_array(),
        dt_s: scene.solver.dt_s,
        tau_s: 0.05,
        most_m_s: 4.0,
    };
    for idle in [
        BodyDrag { body: 1, ..drag },
        BodyDrag { dt_s: 0.0, ..drag },
        BodyDrag { tau_s: 0.0, ..drag },
        BodyDrag { target_m: [f64::NAN; 3], ..drag },
        BodyDrag { grip_m: [0.0, f64::INFINITY, 0.0], ..drag },
    ] {
        pass.write(&mut engine, &scene, &idle);
        engine.run(&[pass.recording.id()], &[]).or_raise();
        ensure_eq!(engine.read(&bodies.states).or_raise(), first, "{idle:?}");
    }
    let grip_m = |state: &BodyState| {
        let rotation = glam::DQuat::from_array(state.rotation.map(f64::from));
        vector(state.position_m) + rotation * DVec3::from_array(drag.grip_m)
    };
    let begin_m = target_m.distance(grip_m(&first[0]));
    let mut left = Vec::new();
    for _ in 0..300 {
        pass.write(&mut engine, &scene, &drag);
        engine.run(&[pass.recording.id(), recorded.step.id()], &[]).or_raise();
        let states = engine.read(&bodies.states).or_raise();
        left.push(target_m.distance(grip_m(&states[0])) / begin_m);
    }
    // Critically damped: near the target's side all the way, 2/e left after tau (12 steps), 5/e^4 after 4 tau.
    ensure!((0.65..0.85).contains(&left[11]), "{} of the way is left after tau", left[11]);
    ensure!((0.04..0.16).contains(&left[47]), "{} is left after four tau", left[47]);
    // Held by an edge it swings around the hand, and pulls at that until the swing is over.
    ensure!(left[95] < 0.04 && left[299] < 0.012 && left.is_sorted_by(|a, b| *b < a + 1e-3), "{left:?}");
}
