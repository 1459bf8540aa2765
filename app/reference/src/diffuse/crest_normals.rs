//! The surface's normal at fluid particles. (Shader: `diffuse/crest_normals.compute`.)

use glam::DVec3;

use super::walls_near::normal_of_walls;
use super::{Diffuse, Domain};
use crate::params::nearest_image;

/// A normal, before it is one of length 1.
#[derive(Clone, Copy, Debug)]
pub struct Normal {
    /// The sum.
    pub sum: DVec3,
    /// How much of a surface there is, 0 to 1.
    pub surface: f64,
}

/// That of particle `i`.
pub fn crest_normal(
    i: usize,
    positions_m: &[DVec3],
    neighbours: &[usize],
    domain: &Domain,
    diffuse: &Diffuse,
) -> Normal {
    let walls = normal_of_walls(positions_m[i], domain) * diffuse.normal * DVec3::new(1.0, 1.0, diffuse.along_z);
    let fluid: DVec3 = neighbours
        .iter()
        .map(|&j| {
            let offset_m = nearest_image(positions_m[i] - positions_m[j], domain.period_m);
            offset_m.normalize_or_zero() * (1.0 - offset_m.length() / domain.support_m).max(0.0)
        })
        .sum();
    let sum = walls + fluid;
    let t = ((sum.length() / diffuse.normal - 0.2) / 0.25).clamp(0.0, 1.0);
    Normal { sum, surface: t * t * (3.0 - 2.0 * t) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use brooklet_kernels::DiffuseParams;

    #[test]
    fn a_block_has_normals_on_its_free_sides_alone() {
        let params = DiffuseParams {
            inverse_normal: (12.0 / (8.0 * std::f64::consts::PI)) as f32,
            inverse_neighbours: 1.0,
            inverse_weight: 1.0,
            along_z: 1.0,
            ..DiffuseParams::default()
        };
        let diffuse = Diffuse::of(&params);
        let positions_m: Vec<DVec3> = (0..1000)
            .map(|n| DVec3::new(f64::from(n % 10), f64::from(n / 10 % 10), f64::from(n / 100)) + 0.5)
            .collect();
        // Walls all around but above.
        let domain = Domain {
            wall_min_m: DVec3::ZERO,
            wall_max_m: DVec3::new(10.0, 1e30, 10.0),
            period_m: DVec3::ZERO,
            support_m: 2.0,
        };
        let lists = crate::grid::list_neighbours::list_neighbours(&positions_m, |_| false, 2.0);
        for (i, position_m) in positions_m.iter().enumerate() {
            let normal = crest_normal(i, &positions_m, &lists[i], &domain, &diffuse);
            // Where two walls meet, what is beyond both counts twice, and three times in a corner.
            let walls_near =
                [position_m.x, position_m.z].iter().map(|&at| usize::from(!(2.0..=8.0).contains(&at))).sum::<usize>()
                    + usize::from(position_m.y < 2.0);
            if walls_near > 1 {
                assert!(position_m.y > 8.0 || normal.sum.length() < 1.1, "{position_m}: {normal:?}");
            } else if position_m.y > 9.0 {
                let direction = normal.sum.normalize();
                assert!(normal.surface > 0.9 && direction.y > 0.95, "{position_m}: {normal:?}");
            } else if position_m.y < 8.0 {
                assert!(normal.surface < 0.05, "{position_m}: {normal:?}");
            }
        }
    }
}
