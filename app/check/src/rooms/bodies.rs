//! `boundary/bodies/`: what bodies touch, how they move and what they take back, against their twins.

use super::solids::{DT_S, STOP_M, single, walls};
use crate::bench::Bench;
use crate::cases::{out_of_part, sizes, step_state};
use crate::compare::{ROUNDING, Worst, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, Wrong, ensure, ensure_eq};
use brooklet_fluid::boundary::solids::solids_params;
use brooklet_fluid::scene::{bodies, field_nodes, first_body_states, solids, surface_points};
use brooklet_fluid::{Scene, reaction_sums};
use brooklet_kernels::{
    BodyContact, BodyState, CONTACTS_PER_POINT, FindContacts, GatherReactions, Kernel as _, NO_BODY, Position,
    REACTION_WORDS, RigidBody, Solid, SolidContact, SolidPose, SolidsParams, StepBodies, StepParams, SurfacePoint,
};
use brooklet_reference::boundary::bodies::find_contacts::{self, Other, contacts_of};
use brooklet_reference::boundary::bodies::step_bodies::{Reaction, Substep, step_bodies};
use brooklet_reference::boundary::bodies::{self as twin, Body, Hinge};
use brooklet_reference::boundary::solids::{Pose, Solid as TwinSolid};
use glam::{DMat3, DQuat, DVec3};
use rand::{Rng, RngExt};

/// Bodies of every shape among solids that stand and move, close together.
const SCENE: &str = r#"
spacing_m = 0.02
[domain]
min_m = [0, 0, 0]
max_m = [1, 1, 1]
[[solid]]
box = { size_m = [0.2, 0.1, 0.3] }
centre_m = [0.3, 0.055, 0.3]
density_kg_m3 = 400
friction = 0.4
[[solid]]
sphere = { radius_m = 0.1 }
centre_m = [0.3, 0.21, 0.3]
density_kg_m3 = 2000
restitution = 0.5
[[solid]]
box = { size_m = [0.4, 0.2, 0.4] }
centre_m = [0.7, 0.1, 0.4]
velocity_m_s = [0.2, 0, 0]
friction = 0.2
measure_force = true
[[solid]]
capsule = { radius_m = 0.05, length_m = 0.3 }
turned_deg = [0, 0, 80]
centre_m = [0.7, 0.28, 0.4]
density_kg_m3 = 700
[[solid]]
cylinder = { radius_m = 0.1, length_m = 0.2 }
thickness_m = 0.02
open = "y_max"
centre_m = [0.12, 0.12, 0.8]
density_kg_m3 = 900
friction = 0.6
[[solid]]
sphere = { radius_m = 0.05 }
centre_m = [0.12, 0.1, 0.8]
density_kg_m3 = 100
[[solid]]
hull = { points_m = [[0, 0, 0], [0.2, 0, 0.02], [0.03, 0.15, 0], [0, 0.02, 0.1]] }
centre_m = [0.25, 0.03, 0.6]
density_kg_m3 = 800
friction = 0.3
[[solid]]
box = { size_m = [0.1, 0.3, 0.1] }
turned_deg = [0, 0, 20]
centre_m = [0.3, 0.5, 0.3]
density_kg_m3 = 500
hinge = { axis = [0, 0.2, 1], at_m = [0.32, 0.6, 0.3] }
[[solid]]
wheel = { radius_m = 0.14, width_m = 0.1, paddles = 6, paddle_m = 0.04 }
centre_m = [0.75, 0.17, 0.8]
density_kg_m3 = 600
hinge = { axis = [0, 0, 1] }
[solver]
method = "none"
max_speed_m_s = 6
"#;

pub(super) struct Case {
    solids: Vec<Solid>,
    pub(super) bodies: Vec<RigidBody>,
    points: Vec<SurfacePoint>,
    pub(super) states: Vec<BodyState>,
    poses: Vec<SolidPose>,
    fields: Vec<[f32; 2]>,
    params: SolidsParams,
}

pub(super) fn quaternion(rotation: [f32; 4]) -> DQuat {
    DQuat::from_array(rotation.map(f64::from)).normalize()
}

/// Bodies a little off where the scene has them, that move.
pub(super) fn case(rng: &mut impl Rng) -> Case {
    let scene = Scene::from_toml(SCENE, "bodies", &[]).or_raise();
    let (solids, keyframes) = solids(&scene);
    let mut one = |most: f64| DVec3::from_array(std::array::from_fn(|_| most * (rng.random::<f64>() * 2.0 - 1.0)));
    let bodies = bodies(&scene);
    let mut states = first_body_states(&scene);
    for (state, body) in states.iter_mut().zip(&bodies) {
        let first_rotation = state.rotation;
        state.position_m = single(vector(state.position_m) + one(0.006));
        state.rotation = (DQuat::from_scaled_axis(one(0.05)) * quaternion(state.rotation)).as_quat().to_array();
        state.velocity_m_s = single(one(1.5));
        state.spin_rad_s = single(one(4.0));
        state.owed_kg_m_s = single(one(0.02));
        state.owed_kg_m2_s = single(one(0.001));
        if body.hinge_inertia_kg_m2 > 0.0 {
            // Turned around its hinge by what it may be.
            let axis = vector(body.hinge_axis).normalize();
            let turn = DQuat::from_axis_angle(axis, vector(state.spin_rad_s).dot(axis) * 0.01);
            let arm_m = vector(body.centre_of_mass_m) - vector(body.hinge_place_m);
            let rotation = turn * quaternion(first_rotation);
            state.rotation = rotation.as_quat().to_array();
            state.position_m = single(vector(body.hinge_m) + rotation * arm_m);
            state.spin_rad_s = single(axis * axis.dot(vector(state.spin_rad_s)));
            state.velocity_m_s = single(vector(state.spin_rad_s).cross(rotation * arm_m));
            state.owed_kg_m_s = [0.0; 3];
            state.owed_kg_m2_s = single(axis * axis.dot(vector(state.owed_kg_m2_s)));
        }
    }
    let mut poses: Vec<SolidPose> = solids
        .iter()
        .map(|solid| {
            let at = keyframes[solid.first_keyframe as usize];
            // A told one came from a substep's way to the left.
            let before_m = vector(at.position_m) - DVec3::X * 0.2 * f64::from(DT_S);
            SolidPose {
                position_m: at.position_m,
                rotation: at.rotation,
                before_m: single(before_m),
                rotation_before: at.rotation,
                ..SolidPose::default()
            }
        })
        .collect();
    for (body, state) in bodies.iter().zip(&states) {
        let pose = &mut poses[body.solid as usize];
        let to_middle_m = quaternion(state.rotation) * vector(body.centre_of_mass_m);
        pose.position_m = single(vector(state.position_m) - to_middle_m);
        pose.rotation = state.rotation;
        (pose.before_m, pose.rotation_before) = (pose.position_m, pose.rotation);
    }
    for pose in &mut poses {
        (pose.min_m, pose.max_m) = ([-9.0; 3], [9.0; 3]);
    }
    let params = SolidsParams { stop_m: STOP_M as f32, ..solids_params(&scene) };
    Case { solids, fields: field_nodes(&scene), points: surface_points(&scene), bodies, states, poses, params }
}

pub(super) fn twin_state(state: &BodyState) -> twin::BodyState {
    twin::BodyState {
        position_m: vector(state.position_m),
        rotation: quaternion(state.rotation),
        velocity_m_s: vector(state.velocity_m_s),
        spin_rad_s: vector(state.spin_rad_s),
        owed_kg_m_s: vector(state.owed_kg_m_s),
        owed_kg_m2_s: vector(state.owed_kg_m2_s),
    }
}

pub(super) fn twin_body(body: &RigidBody) -> Body {
    Body {
        centre_of_mass_m: vector(body.centre_of_mass_m),
        mass_kg: 1.0 / f64::from(body.inverse_mass_per_kg),
        inertia_kg_m2: tensor(body.inertia_kg_m2, body.products_kg_m2),
        added_mass_kg: body.added_mass_kg.into(),
        added_inertia_kg_m2: tensor(body.added_inertia_kg_m2, body.added_products_kg_m2),
        wet_per_push: body.wet_per_push.into(),
        hinge: (body.hinge_inertia_kg_m2 > 0.0).then(|| Hinge {
            at_m: vector(body.hinge_m),
            axis: vector(body.hinge_axis).normalize(),
            place_m: vector(body.hinge_place_m),
            added_kg_m2: body.hinge_added_kg_m2.into(),
        }),
    }
}

fn tensor(moments: [f32; 3], products: [f32; 3]) -> DMat3 {
    let ([xx, yy, zz], [xy, yz, zx]) = (moments.map(f64::from), products.map(f64::from));
    DMat3::from_cols_array_2d(&[[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]])
}

/// The body of a number; none of what gives its reaction without being one.
fn named(body: u32, bodies: &[RigidBody]) -> Option<usize> {
    let number = body as usize;
    (number < bodies.len()).then_some(number)
}

/// What the kernel finds, by point.
fn found(device: &Device, case: &Case) -> Vec<BodyContact> {
    let mut bench = Bench::new(device);
    let points = bench.input("surface_points", &case.points);
    let bodies = bench.input("bodies", &case.bodies);
    let states = bench.input("body_states", &case.states);
    let solids = bench.input("solids", &case.solids);
    let poses = bench.input("solid_poses", &case.poses);
    let fields = bench.input("solid_fields", &case.fields);
    let count = CONTACTS_PER_POINT as usize * case.points.len();
    let mut contacts = bench.output::<BodyContact>("body_contacts", count);
    let state = bench.uniform("step_state", step_state(1, DT_S));
    let step_params = bench.uniform("step_params", walls());
    let params = bench.uniform("solids_params", case.params);
    bench.dispatch(
        &FindContacts {
            surface_points: points.read(),
            bodies: bodies.read(),
            body_states: states.read(),
            solids: solids.read(),
            solid_poses: poses.read(),
            solid_fields: fields.read(),
            body_contacts: contacts.write(),
            step_state: state.uniform(),
            step_params: step_params.uniform(),
            solids_params: params.uniform(),
        },
        case.points.len(),
    );
    bench.run().read(&contacts, count)
}

/// Places of up to a metre are off by some eight roundings, their difference over dt by 240 times that.
const CONTACT_TOLERANCE: f64 = 16.0 * ROUNDING;
/// A contact this near the end of its reach may be found or not, m.
const DOUBT_M: f64 = 1e-4;

pub(crate) fn find_contacts_matches_its_twin(device: &Device) {
    let mut rng = rng(221);
    let mut worst = device.worst(FindContacts::STAGE, CONTACT_TOLERANCE);
    let (mut all, mut among_bodies, mut refused) = (0, 0, 0);
    for _ in 0..if device.small() { 4 } else { 16 } {
        let case = case(&mut rng);
        let others: Vec<Other> = case
            .solids
            .iter()
            .zip(&case.poses)
            .map(|(solid, pose)| Other {
                solid: TwinSolid::of(solid, &case.fields),
                pose: Pose { position_m: vector(pose.position_m), rotation: quaternion(pose.rotation) },
                before: Pose { position_m: vector(pose.before_m), rotation: quaternion(pose.rotation_before) },
                body: named(solid.body, &case.bodies),
                friction: solid.friction.into(),
                restitution: solid.restitution.into(),
            })
            .collect();
        let walls_m = [DVec3::ZERO, DVec3::ONE];
        let got = found(device, &case);
        for (point, got) in case.points.iter().zip(got.chunks_exact(CONTACTS_PER_POINT as usize)) {
            let solid = case.bodies[point.body as usize].solid as usize;
            let of = find_contacts::SurfacePoint {
                at_m: others[solid].pose.from_frame(vector(point.place_m)),
                radius_m: point.radius_m.into(),
                body: point.body as usize,
                solid,
            };
            let state = twin_state(&case.states[of.body]);
            let expected = contacts_of(&of, &state, &others, walls_m, STOP_M, DT_S.into());
            let mut sure = expected.iter().filter(|(_, within_m)| *within_m > DOUBT_M).count();
            let mut had = 0;
            for contact in got.iter().filter(|contact| contact.body != NO_BODY) {
                let is_it = |(other, _): &&(twin::BodyContact, f64)| {
                    other.other == named(contact.other, &case.bodies)
                        && other.normal.distance(vector(contact.normal)) < 1e-3
                        && (other.gap_m - f64::from(contact.gap_m)).abs() < 1e-4
                };
                let (other, within_m) = expected.iter().find(is_it).copied().unwrap_or_else(|| {
                    crate::wrong::raise(format!("{contact:?} of {of:?} is in none of {expected:?}").into())
                });
                ensure!(within_m > -DOUBT_M, "{contact:?} is out of reach");
                ensure_eq!(contact.body as usize, of.body);
                worst.check3(contact.at_m, other.at_m, 1.0).or_raise();
                worst.check(contact.gap_m, other.gap_m, 1.0).or_raise();
                // An edge's normal turns by a rounding over the distance.
                worst.check3(contact.normal, other.normal, 1.0 / other.gap_m.abs().clamp(1e-3, 0.1)).or_raise();
                if other.other.is_none() {
                    worst.check3(contact.other_m_s, other.other_m_s, 1.0 / f64::from(DT_S)).or_raise();
                }
                worst.check(contact.friction, other.friction, 1.0).or_raise();
                worst.check(contact.restitution, other.restitution, 1.0).or_raise();
                let mut wrong = Worst::new(FindContacts::STAGE, CONTACT_TOLERANCE);
                refused += usize::from(wrong.check(contact.gap_m, other.gap_m + 1e-5, 1.0).is_err());
                had += 1;
                all += 1;
                among_bodies += usize::from(other.other.is_some());
            }
            sure = sure.min(CONTACTS_PER_POINT as usize);
            ensure!(had >= sure, "{had} contacts of {of:?}, {sure} are sure: {expected:?}");
        }
    }
    ensure!(all > 40 && 20 * among_bodies > all, "{all} contacts, {among_bodies} among bodies");
    ensure!(refused == all, "{refused} of {all} would tell a gap of a hundredth of a millimetre more apart");
    worst.report(device);
}

/// A reaction as the words have it, of sums in units.
fn words(sums: [i64; 6], pushes: u32) -> Vec<u32> {
    let halves = sums.into_iter().flat_map(|sum| [sum as u32, (sum >> 32) as u32]);
    halves.chain([pushes, 0, 0, 0]).collect()
}

/// The sums of a reaction, in units, and how many pushes.
pub(super) fn sums_of(words: &[u32]) -> ([i64; 6], u32) {
    (reaction_sums(words), words[12])
}

/// Velocities are sums of up to 16 iterations' contacts, rounded to 1e-6 m/s each.
const STEP_TOLERANCE: f64 = 1e-4;

fn check_step(device: &Device, rng: &mut impl Rng, share: f64, worst: &mut Worst) -> Result<usize, Wrong> {
    let case = case(rng);
    let contacts = found(device, &case);
    let unit = f64::from(case.params.unit_kg_m_s);
    let reactions: Vec<([i64; 6], u32)> = case
        .bodies
        .iter()
        .map(|body| {
            let most = 0.2 / f64::from(body.inverse_mass_per_kg) / unit;
            let sums =
                std::array::from_fn(|k| ((rng.random::<f64>() - 0.5) * most * if k < 3 { 1.0 } else { 0.05 }) as i64);
            (sums, rng.random_range(0..200))
        })
        .collect();
    let mut bench = Bench::new(device);
    let bodies = bench.input("bodies", &case.bodies);
    let contact_buffer = bench.input("body_contacts", &contacts);
    let mut states = bench.input("body_states", &case.states);
    let all_words: Vec<u32> = reactions.iter().flat_map(|&(sums, pushes)| words(sums, pushes)).collect();
    let mut reaction_buffer = bench.input("reactions", &all_words);
    let mut poses = bench.input("solid_poses", &case.poses);
    let state = bench.uniform("step_state", step_state(1, DT_S));
    let step_params = StepParams { gravity_m_s2: [0.0, -9.81, 0.5], max_speed_m_s: 2.0, ..walls() };
    let step = bench.uniform("step_params", step_params);
    let params = bench.uniform("solids_params", case.params);
    bench.dispatch(
        &StepBodies {
            bodies: bodies.read(),
            body_contacts: contact_buffer.read(),
            body_states: states.write(),
            reactions: reaction_buffer.write(),
            solid_poses: poses.write(),
            step_state: state.uniform(),
            step_params: step.uniform(),
            solids_params: params.uniform(),
        },
        1,
    );
    let mut done = bench.run();
    let got = done.read(&states, case.states.len());
    let got_poses = done.read(&poses, case.poses.len());
    ensure!(done.read(&reaction_buffer, all_words.len()).iter().all(|word| *word == 0), "what was taken is left");

    let touching: Vec<twin::BodyContact> = contacts
        .iter()
        .filter(|contact| contact.body != NO_BODY)
        .map(|contact| twin::BodyContact {
            at_m: vector(contact.at_m),
            gap_m: contact.gap_m.into(),
            normal: vector(contact.normal),
            body: contact.body as usize,
            other: named(contact.other, &case.bodies),
            other_m_s: vector(contact.other_m_s),
            friction: contact.friction.into(),
            restitution: contact.restitution.into(),
        })
        .collect();
    let given: Vec<Reaction> = reactions
        .iter()
        .map(|(sums, pushes)| {
            let three = |at: usize| DVec3::from_array(std::array::from_fn(|k| sums[at + k] as f64 * unit)) * share;
            Reaction { impulse_kg_m_s: three(0), moment_kg_m2_s: three(3), pushes: f64::from(*pushes) }
        })
        .collect();
    let twins: Vec<Body> = case.bodies.iter().map(twin_body).collect();
    let before: Vec<twin::BodyState> = case.states.iter().map(twin_state).collect();
    let substep = Substep {
        dt_s: DT_S.into(),
        gravity_m_s2: vector(step_params.gravity_m_s2),
        max_speed_m_s: step_params.max_speed_m_s.into(),
    };
    let expected = step_bodies(&twins, &before, &given, &touching, &substep);
    for (b, (got, expected)) in got.iter().zip(&expected).enumerate() {
        let body = &twins[b];
        let arm_m = (body.inertia_kg_m2.x_axis.x / body.mass_kg).sqrt();
        worst.check3(got.velocity_m_s, expected.velocity_m_s, 2.0)?;
        worst.check3(got.spin_rad_s, expected.spin_rad_s, 2.0 / arm_m)?;
        worst.check3(got.position_m, expected.position_m, 1.0)?;
        worst.check3(got.owed_kg_m_s, expected.owed_kg_m_s, body.added_mass_kg)?;
        worst.check3(got.owed_kg_m2_s, expected.owed_kg_m2_s, body.added_mass_kg * arm_m)?;
        let turned = quaternion(got.rotation).angle_between(expected.rotation);
        worst.check(turned as f32, 0.0, 4.0)?;
        let pose = &got_poses[case.bodies[b].solid as usize];
        let middle_m = expected.position_m - expected.rotation * body.centre_of_mass_m;
        worst.check3(pose.position_m, middle_m, 1.0)?;
        ensure_eq!(pose.rotation, got.rotation);
        ensure_eq!(pose.before_m, case.poses[case.bodies[b].solid as usize].position_m);
    }
    Ok(touching.len())
}

pub(crate) fn step_bodies_matches_its_twin(device: &Device) {
    let mut rng = rng(222);
    let mut worst = device.worst(StepBodies::STAGE, STEP_TOLERANCE);
    let mut contacts = 0;
    for _ in 0..if device.small() { 4 } else { 16 } {
        contacts += check_step(device, &mut rng, 1.0, &mut worst).or_raise();
    }
    ensure!(contacts > 40, "{contacts} contacts");
    let mut wrong = Worst::new(StepBodies::STAGE, STEP_TOLERANCE);
    ensure!(check_step(device, &mut rng, 1.05, &mut wrong).is_err(), "a twentieth more of what the fluid gave");
    worst.report(device);
}

/// Each sum is of numbers that are rounded to one, and off by a rounding of their own.
pub(crate) fn gather_reactions_matches_its_twin(device: &Device) {
    let mut rng = rng(223);
    let mut worst = device.worst(GatherReactions::STAGE, 4.0 * ROUNDING);
    let mut refused = 0;
    for size in sizes(device, GatherReactions::GROUP_SIZE[0] as usize) {
        let case = case(&mut rng);
        let per_m_s = f64::from(case.params.units_per_m_s);
        let mut one = || rng.random::<f32>() * 2.0 - 1.0;
        let positions: Vec<Position> =
            (0..size).map(|i| Position { position_m: [one(), one(), one()], tag: i as u32 | out_of_part(i) }).collect();
        let contacts: Vec<SolidContact> = (0..size)
            .map(|i| SolidContact {
                body: if i % 5 == 4 { NO_BODY } else { (i % 5) as u32 },
                taken_m_s: if i % 7 == 6 { [0.0; 3] } else { [5.0 * one(), one(), 0.01 * one()] },
                ..SolidContact::default()
            })
            .collect();
        // What stood there before, so that low words carry.
        let before: Vec<i64> = (0..6 * case.bodies.len()).map(|k| (k as i64 - 9) * 4_000_000_007).collect();
        let before_words: Vec<u32> =
            before.chunks_exact(6).flat_map(|sums| words(std::array::from_fn(|k| sums[k]), 3)).collect();
        let mut bench = Bench::new(device);
        let sorted = bench.input("sorted_positions", &positions);
        let contact_buffer = bench.input("solid_contacts", &contacts);
        let states = bench.input("body_states", &case.states);
        let mut reactions = bench.input("reactions", &before_words);
        let state = bench.uniform("step_state", step_state(size, DT_S));
        let params = bench.uniform("solids_params", case.params);
        bench.dispatch(
            &GatherReactions {
                sorted_positions: sorted.read(),
                solid_contacts: contact_buffer.read(),
                body_states: states.read(),
                reactions: reactions.write(),
                step_state: state.uniform(),
                solids_params: params.uniform(),
            },
            size,
        );
        let got = bench.run().read(&reactions, before_words.len());
        for (b, got) in got.chunks_exact(REACTION_WORDS as usize).enumerate() {
            let mine = (0..size).filter(|&i| contacts[i].body as usize == b && contacts[i].taken_m_s != [0.0; 3]);
            let (mut sums, mut lengths, mut count) = ([0.0; 6], [1.0; 6], 0);
            for i in mine {
                let impulse = -vector(contacts[i].taken_m_s) * per_m_s;
                let arm_m = vector(positions[i].position_m) - vector(case.states[b].position_m);
                let six = [impulse.to_array(), arm_m.cross(impulse).to_array()].concat();
                for (k, value) in six.into_iter().enumerate() {
                    sums[k] += value;
                    // A moment is a difference of two products.
                    lengths[k] += if k < 3 { value.abs() } else { arm_m.length() * impulse.length() } + 0.5 / ROUNDING;
                }
                count += 1;
            }
            let (got, pushes) = sums_of(got);
            ensure_eq!(pushes, 3 + count);
            for k in 0..6 {
                let gained = (got[k] - before[6 * b + k]) as f64;
                let difference = (gained - sums[k]).abs() / lengths[k];
                worst.check(difference as f32, 0.0, 1.0).or_raise();
                let other = (gained - 1.01 * sums[k]).abs() / lengths[k];
                refused += usize::from(
                    Worst::new(GatherReactions::STAGE, 4.0 * ROUNDING).check(other as f32, 0.0, 1.0).is_err(),
                );
            }
        }
    }
    ensure!(refused > 30, "{refused} sums would tell a hundredth more apart");
    worst.report(device);
}
