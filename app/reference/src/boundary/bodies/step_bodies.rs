//! Bodies move by what pushes them and what they touch. (Shader: `boundary/bodies/step_bodies.compute`.)

use super::{Body, BodyContact, BodyState, Hinge};
use glam::{DMat3, DQuat, DVec3};

const ITERATIONS: usize = 16;
const LEFT_IN_A_SUBSTEP: f64 = 0.2;
const MOST_TURN_RAD: f64 = 0.7;

/// What the fluid gave a body in a substep.
#[derive(Clone, Copy, Debug, Default)]
pub struct Reaction {
    /// Momentum.
    pub impulse_kg_m_s: DVec3,
    /// Angular momentum about its centre of mass.
    pub moment_kg_m2_s: DVec3,
    /// How many times a particle pushed.
    pub pushes: f64,
}

/// What a substep is told.
#[derive(Clone, Copy, Debug)]
pub struct Substep {
    /// Its length.
    pub dt_s: f64,
    /// Gravity.
    pub gravity_m_s2: DVec3,
    /// Nothing is faster.
    pub max_speed_m_s: f64,
}

/// A tensor of a frame in the domain.
fn turned(rotation: DQuat, of: DMat3) -> DMat3 {
    let frame = DMat3::from_quat(rotation);
    frame * of * frame.transpose()
}

/// Huygens and Steiner.
fn around_hinge_kg_m2(body: &Body, state: &BodyState, hinge: &Hinge) -> f64 {
    let arm_m = state.position_m - hinge.at_m;
    let inertia = turned(state.rotation, body.inertia_kg_m2);
    hinge.axis.dot(inertia * hinge.axis) + body.mass_kg * hinge.axis.cross(arm_m).length_squared()
}

/// What an impulse at a place gives a body: a velocity of its centre of mass, and a spin.
fn gained(body: &Body, state: &BodyState, at_m: DVec3, impulse_kg_m_s: DVec3) -> (DVec3, DVec3) {
    if let Some(hinge) = body.hinge {
        let moment = hinge.axis.dot((at_m - hinge.at_m).cross(impulse_kg_m_s));
        let spin_rad_s = moment / around_hinge_kg_m2(body, state, &hinge) * hinge.axis;
        return (spin_rad_s.cross(state.position_m - hinge.at_m), spin_rad_s);
    }
    let moment = (at_m - state.position_m).cross(impulse_kg_m_s);
    (impulse_kg_m_s / body.mass_kg, turned(state.rotation, body.inertia_kg_m2).inverse() * moment)
}

fn force(body: &Body, state: &mut BodyState, reaction: &Reaction, step: &Substep) -> (DVec3, DVec3) {
    let wet = (reaction.pushes * body.wet_per_push).min(1.0);
    let added_kg = wet * body.added_mass_kg;
    let impulse = reaction.impulse_kg_m_s + body.mass_kg * step.gravity_m_s2 * step.dt_s;
    let inertia = turned(state.rotation, body.inertia_kg_m2);
    let added = turned(state.rotation, wet * body.added_inertia_kg_m2);
    if let Some(hinge) = body.hinge {
        let arm_m = state.position_m - hinge.at_m;
        let added_kg_m2 = wet * hinge.added_kg_m2;
        let moment = reaction.moment_kg_m2_s + arm_m.cross(impulse) + state.owed_kg_m2_s;
        let gained_rad_s = hinge.axis.dot(moment) / (around_hinge_kg_m2(body, state, &hinge) + added_kg_m2);
        state.owed_kg_m_s = DVec3::ZERO;
        state.owed_kg_m2_s = added_kg_m2 * gained_rad_s * hinge.axis;
        let spin_rad_s = (hinge.axis.dot(state.spin_rad_s) + gained_rad_s) * hinge.axis;
        return (spin_rad_s.cross(arm_m), spin_rad_s);
    }
    let gained_m_s = (impulse + state.owed_kg_m_s) / (body.mass_kg + added_kg);
    let torque =
        reaction.moment_kg_m2_s - state.spin_rad_s.cross(inertia * state.spin_rad_s) * step.dt_s + state.owed_kg_m2_s;
    let gained_rad_s = (inertia + added).inverse() * torque;
    state.owed_kg_m_s = added_kg * gained_m_s;
    state.owed_kg_m2_s = added * gained_rad_s;
    (state.velocity_m_s + gained_m_s, state.spin_rad_s + gained_rad_s)
}

/// The bodies after a substep.
pub fn step_bodies(
    bodies: &[Body],
    states: &[BodyState],
    reactions: &[Reaction],
    contacts: &[BodyContact],
    step: &Substep,
) -> Vec<BodyState> {
    let mut next = states.to_vec();
    for ((body, state), reaction) in bodies.iter().zip(&mut next).zip(reactions) {
        (state.velocity_m_s, state.spin_rad_s) = force(body, state, reaction, step);
    }
    let mut touched = vec![0.0_f64; bodies.len()];
    for contact in contacts {
        touched[contact.body] += 1.0;
        if let Some(other) = contact.other {
            touched[other] += 1.0;
        }
    }
    let mobility = |b: usize, at_m: DVec3, direction: DVec3| {
        let (velocity_m_s, spin_rad_s) = gained(&bodies[b], &states[b], at_m, direction);
        direction.dot(velocity_m_s + spin_rad_s.cross(at_m - states[b].position_m))
    };
    for _ in 0..ITERATIONS {
        let mut sums = vec![(DVec3::ZERO, DVec3::ZERO); bodies.len()];
        for contact in contacts {
            let BodyContact { at_m, normal, body, other, .. } = *contact;
            let of = |states: &[BodyState]| {
                let other_m_s = other.map_or(contact.other_m_s, |other| states[other].velocity_at(at_m));
                states[body].velocity_at(at_m) - other_m_s
            };
            let relative_m_s = of(&next);
            let away_m_s = relative_m_s.dot(normal);
            let mut wanted_m_s = -contact.gap_m / step.dt_s;
            if contact.gap_m <= 0.0 {
                let came_m_s = (-of(states).dot(normal)).max(0.0);
                wanted_m_s = (LEFT_IN_A_SUBSTEP * wanted_m_s).max(contact.restitution * came_m_s);
            }
            if away_m_s >= wanted_m_s {
                continue;
            }
            let share = other.map_or(touched[body], |other| touched[body].max(touched[other]));
            let both = |direction: DVec3| {
                mobility(body, at_m, direction) + other.map_or(0.0, |other| mobility(other, at_m, direction))
            };
            let impulse = (wanted_m_s - away_m_s) / (both(normal) * share);
            let along_m_s = relative_m_s - normal * away_m_s;
            let speed_m_s = along_m_s.length();
            let mut push = impulse * normal;
            if speed_m_s > 1e-9 && contact.friction > 0.0 {
                let direction = along_m_s / speed_m_s;
                push -= (contact.friction * impulse).min(speed_m_s / (both(direction) * share)) * direction;
            }
            let mut give = |b: usize, push: DVec3| {
                let (velocity_m_s, spin_rad_s) = gained(&bodies[b], &states[b], at_m, push);
                sums[b].0 += velocity_m_s;
                sums[b].1 += spin_rad_s;
            };
            give(body, push);
            if let Some(other) = other {
                give(other, -push);
            }
        }
        for (state, (velocity_m_s, spin_rad_s)) in next.iter_mut().zip(sums) {
            state.velocity_m_s += velocity_m_s;
            state.spin_rad_s += spin_rad_s;
        }
    }
    for (body, state) in bodies.iter().zip(&mut next) {
        state.velocity_m_s = state.velocity_m_s.clamp_length_max(step.max_speed_m_s);
        state.spin_rad_s = state.spin_rad_s.clamp_length_max(MOST_TURN_RAD / step.dt_s);
        state.position_m += state.velocity_m_s * step.dt_s;
        let w = 0.5 * step.dt_s * state.spin_rad_s;
        let q = state.rotation;
        let moved = DQuat::from_xyzw(w.x, w.y, w.z, 0.0) * q;
        state.rotation = (q + moved).normalize();
        if let Some(hinge) = body.hinge {
            state.position_m = hinge.at_m + state.rotation * (body.centre_of_mass_m - hinge.place_m);
        }
    }
    next
}
