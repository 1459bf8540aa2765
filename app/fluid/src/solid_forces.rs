//! What the fluid pushes solids with whose force is measured (`solid.*.measure_force`).
//!
//! The GPU sums what particles give back, from a session's begin on (`boundary/bodies/react.hlsli`); a measurement reads the
//! sums, and a force is what one grew by since the measurement before, over the time between. Integers: none is lost however
//! long a session lasts.

use brooklet_gpu::ResourceId;
use brooklet_kernels::REACTION_WORDS;

use crate::body_motion::reaction_sums;
use crate::boundary::bodies::BodyBuffers;
use crate::boundary::solids::unit_kg_m_s;
use crate::scene::Scene;

/// Reads them.
pub(crate) struct SolidForces {
    /// The reactions, which a measurement reads back.
    pub reactions: ResourceId,
    bodies: usize,
    /// Time and sums of the last measurement; at first those of the begin, when all is 0.
    last: Option<(f64, Vec<[i64; 3]>)>,
}

impl SolidForces {
    /// Of a session that begins at a time; none where no force is measured.
    pub fn of(bodies: Option<&BodyBuffers>, begin_s: f64) -> Option<Self> {
        let bodies = bodies?;
        let measured = bodies.measured();
        (measured > 0).then(|| Self {
            reactions: bodies.reactions.id,
            bodies: bodies.count as usize,
            last: Some((begin_s, vec![[0; 3]; measured as usize])),
        })
    }

    /// The sums are another session's: the next measurement has none to be held against.
    pub fn begin_anew(&mut self) {
        self.last = None;
    }

    /// The mean force on each since the last measurement, N, of what one read back; 0 where no time has passed.
    pub fn take(&mut self, bytes: &[u8], scene: &Scene, time_s: f64) -> Vec<[f64; 3]> {
        let words: Vec<u32> = bytemuck::pod_collect_to_vec(bytes);
        let of_solids = words.chunks_exact(REACTION_WORDS as usize).skip(self.bodies);
        let impulse = |[x, y, z, ..]: [i64; 6]| [x, y, z];
        let sums: Vec<[i64; 3]> = of_solids.map(reaction_sums).map(impulse).collect();
        let unit_kg_m_s = unit_kg_m_s(scene);
        let grown = |(before_s, before): &(f64, Vec<[i64; 3]>)| -> Vec<[f64; 3]> {
            let per_s = if time_s > *before_s { unit_kg_m_s / (time_s - before_s) } else { 0.0 };
            let force_n = |(now, before): (&[i64; 3], &[i64; 3])| {
                std::array::from_fn(|axis| now[axis].wrapping_sub(before[axis]) as f64 * per_s)
            };
            sums.iter().zip(before).map(force_n).collect()
        };
        let forces_n = self.last.as_ref().map_or_else(|| vec![[0.0; 3]; sums.len()], grown);
        self.last = Some((time_s, sums));
        forces_n
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_force_is_what_a_sum_grew_by_over_the_time_between() {
        let text = "spacing_m = 0.1\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [1, 1, 1]\n\
            [[solid]]\nsphere = { radius_m = 0.3 }\ncentre_m = [0.5, 0.5, 0.5]\nmeasure_force = true\n";
        let scene = Scene::from_toml(text, "ball", &[]).unwrap();
        let unit = unit_kg_m_s(&scene);
        let mut forces = SolidForces { reactions: ResourceId(0), bodies: 1, last: Some((0.0, vec![[0; 3]])) };
        let bytes = |sums: [i64; 3]| {
            let words = sums.into_iter().flat_map(|sum| [sum as u32, (sum >> 32) as u32]);
            // A body's stand before it.
            let of_solid: Vec<u32> = words.chain([9; 10]).collect();
            let all: Vec<u32> = std::iter::repeat_n(7, REACTION_WORDS as usize).chain(of_solid).collect();
            bytemuck::cast_slice(&all).to_vec()
        };
        let near = |got: Vec<[f64; 3]>, wanted: [f64; 3]| {
            got.len() == 1 && (0..3).all(|axis| (got[0][axis] / unit - wanted[axis]).abs() < 1e-6 * wanted[axis].abs())
        };
        assert!(near(forces.take(&bytes([1 << 40, -3, 8]), &scene, 0.5), [2.0 * (1_u64 << 40) as f64, -6.0, 16.0]));
        assert!(near(
            forces.take(&bytes([(1 << 40) + 5, -7, 8 - (1 << 33)]), &scene, 1.5),
            [5.0, -4.0, -(2.0_f64.powi(33))]
        ));
        assert!(!near(forces.take(&bytes([(1 << 40) + 6, -8, 9]), &scene, 2.5), [2.0, -1.0, 1.0]));
        assert_eq!(forces.take(&bytes([0; 3]), &scene, 2.5), [[0.0; 3]], "no time");
        forces.begin_anew();
        assert_eq!(forces.take(&bytes([5; 3]), &scene, 9.0), [[0.0; 3]]);
    }
}
