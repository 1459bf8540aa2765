//! Where diffuse particles begin, and the ring of their slots. (Shader: `diffuse/spawn_diffuse.compute`.)

use brooklet_kernels::{DiffuseState, GROUPS_PER_ROW};
use glam::DVec3;
use std::f64::consts::TAU;

use super::{Diffuse, Particle};
use crate::shared::hash::{hash, share};

/// Of the speed: how fast one at the cylinder's side parts from its axis.
const SPREADING: f64 = 0.12;

/// A fluid particle that spawns.
#[derive(Clone, Copy, Debug)]
pub struct Spawning {
    /// Its id.
    pub id: u32,
    /// Where it is, m.
    pub position_m: DVec3,
    /// How fast, m/s.
    pub velocity_m_s: DVec3,
    /// Its neighbours.
    pub neighbours: u32,
}

/// The `k`-th that it spawns at `time_s`, in a step of `dt_s`.
pub fn spawned(of: &Spawning, k: u32, time_s: f32, dt_s: f64, diffuse: &Diffuse) -> Particle {
    let seed = hash(hash(of.id.wrapping_add(hash(time_s.to_bits()))).wrapping_add(k));
    let number = |n: u32| share(seed.wrapping_add(n));
    let axis = if of.velocity_m_s == DVec3::ZERO { DVec3::Y } else { of.velocity_m_s.normalize() };
    // Duff et al. 2017.
    let side = if axis.z < 0.0 { -1.0 } else { 1.0 };
    let a = -1.0 / (side + axis.z);
    let across = DVec3::new(1.0 + side * axis.x * axis.x * a, side * axis.x * axis.y * a, -side * axis.x);
    let upward = DVec3::new(axis.x * axis.y * a, side + axis.y * axis.y * a, -axis.y);
    let angle = TAU * number(1);
    let aside =
        number(0).sqrt() * (angle.cos() * across + angle.sin() * upward) * DVec3::new(1.0, 1.0, diffuse.along_z);
    Particle {
        position_m: of.position_m + aside * diffuse.spread_m - of.velocity_m_s * dt_s * number(2),
        velocity_m_s: of.velocity_m_s + aside * SPREADING * of.velocity_m_s.length(),
        lifetime_s: diffuse.lifetime_s * (0.5 + number(3)),
        crowd: f64::from(of.neighbours) / diffuse.neighbours,
    }
}

/// The ring after `due` were to be spawned, and how many of them were.
pub fn settled(before: &DiffuseState, due: u32, capacity: u32) -> (DiffuseState, u32) {
    let taken = due.min(capacity);
    let instance_count = (before.instance_count + taken).min(capacity);
    let groups = instance_count.div_ceil(64);
    let state = DiffuseState {
        groups: [groups.min(GROUPS_PER_ROW), groups.div_ceil(GROUPS_PER_ROW), 1],
        next_slot: (before.next_slot + taken) % capacity,
        vertex_count: 3,
        instance_count,
        first_vertex: 0,
        first_instance: 0,
    };
    (state, taken)
}
