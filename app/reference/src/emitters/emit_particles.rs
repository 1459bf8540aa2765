//! The particles of a layer. (Shader: `emitters/emit_particles.compute`.)

use glam::{DVec3, UVec3};

use super::open_emitters::Flow;
use crate::shared::hash::hash;

/// What a layer's particles begin with.
#[derive(Clone, Copy, Debug)]
pub struct Nozzle {
    /// Its number.
    pub number: u32,
    /// Where it flows to, of length 1, in its frame.
    pub direction: DVec3,
    /// How fast, m/s.
    pub speed_m_s: f64,
    /// From layer to layer, m.
    pub spacing_m: f64,
    /// How far a particle may be from its point along each axis, m.
    pub jitter_m: DVec3,
    /// How long one lives, s; 0: for ever.
    pub lifetime_s: f64,
}

/// A particle of a layer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Emitted {
    /// Where it begins, m.
    pub position_m: DVec3,
    /// How fast it is, m/s.
    pub velocity_m_s: DVec3,
    /// Below 0: what is left of its lifetime, s.
    pub age_s: f64,
}

/// Evenly from -1 to 1 along each axis: by emitter, layer and point.
pub fn jitter(emitter: u32, layer: u32, point: u32) -> DVec3 {
    let seed = hash(point.wrapping_add(hash(layer.wrapping_add(hash(emitter)))));
    let even = |n: u32| f64::from(hash(seed.wrapping_add(n)) >> 8) / 8_388_608.0 - 1.0;
    UVec3::new(0, 1, 2).to_array().map(even).into()
}

/// The particle at a point of the `layer`-th layer of a substep of `dt_s`.
pub fn emit_particle(nozzle: &Nozzle, flow: &Flow, place_m: DVec3, layer: u32, point: u32, dt_s: f64) -> Emitted {
    let ahead_m = flow.ahead_m - f64::from(layer) * nozzle.spacing_m;
    let off_m = jitter(nozzle.number, flow.layer + layer, point) * nozzle.jitter_m;
    let in_frame_m = place_m + nozzle.direction * ahead_m + off_m;
    let [begin_m, end_m] = flow.poses.map(|pose| pose.from_frame(in_frame_m));
    Emitted {
        position_m: begin_m,
        velocity_m_s: flow.poses[0].rotation * nozzle.direction * nozzle.speed_m_s + (end_m - begin_m) / dt_s,
        age_s: -nozzle.lifetime_s,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn jitter_is_even_and_no_two_layers_are_alike() {
        let all: Vec<DVec3> = (0..2000).map(|n| jitter(n % 3, n / 100, n % 100)).collect();
        let mean = all.iter().sum::<DVec3>() / all.len() as f64;
        let square = all.iter().map(|v| *v * *v).sum::<DVec3>() / all.len() as f64;
        assert!(mean.abs().max_element() < 0.05, "{mean}");
        assert!((square - 1.0 / 3.0).abs().max_element() < 0.03, "{square}");
        assert!(all.iter().all(|v| v.abs().max_element() <= 1.0));
        assert_ne!(jitter(0, 1, 5), jitter(0, 2, 5));
        assert_ne!(jitter(0, 1, 5), jitter(1, 1, 5));
    }
}
