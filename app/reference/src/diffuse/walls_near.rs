//! What of a ball lies inside walls, and what fluid beyond them would add to a normal. (Shader: `diffuse/walls_near.hlsli`.)

use glam::DVec3;

use super::Domain;

/// Of a ball of radius 1 before a plane at distance `t`: its cap beyond has the volume pi (1 - t)^2 (2 + t) / 3.
pub fn share_before(t: f64) -> f64 {
    let t = t.clamp(0.0, 1.0);
    1.0 - 0.25 * (1.0 - t).powi(2) * (2.0 + t)
}

/// As if the walls of each axis were alone.
pub fn share_inside(position_m: DVec3, domain: &Domain) -> f64 {
    let [low, high] = distances(position_m, domain);
    (0..3).map(|axis| share_before(low[axis]) * share_before(high[axis])).product()
}

/// pi times the integral from t to 1 of (s² - t²)(1 - s), over its value at t = 0.
pub fn normal_beyond(t: f64) -> f64 {
    let t = t.clamp(0.0, 1.0);
    12.0 * (1.0 / 12.0 - t.powi(2) / 2.0 + 2.0 * t.powi(3) / 3.0 - t.powi(4) / 4.0)
}

/// Of all walls, over a flat surface's.
pub fn normal_of_walls(position_m: DVec3, domain: &Domain) -> DVec3 {
    let [low, high] = distances(position_m, domain);
    let along = |axis: usize| normal_beyond(low[axis]) - normal_beyond(high[axis]);
    DVec3::new(along(0), along(1), along(2))
}

/// From the walls, in h.
fn distances(position_m: DVec3, domain: &Domain) -> [DVec3; 2] {
    [position_m - domain.wall_min_m, domain.wall_max_m - position_m].map(|away_m| away_m / domain.support_m)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sums over a fine lattice of a ball of radius 1: how many lie beyond the plane z = t, and their normals' z.
    fn summed(t: f64) -> [f64; 2] {
        const SIDE: i32 = 60;
        let at = |k: i32| (f64::from(k) + 0.5) / f64::from(SIDE);
        let cell = f64::from(SIDE).powi(-3);
        let [mut volume, mut normal] = [0.0; 2];
        for z in 0..SIDE {
            for y in -SIDE..SIDE {
                for x in -SIDE..SIDE {
                    let place = DVec3::new(at(x), at(y), at(z));
                    let r = place.length();
                    if place.z > t && r < 1.0 {
                        volume += cell;
                        normal += cell * place.z / r * (1.0 - r);
                    }
                }
            }
        }
        [volume, normal]
    }

    #[test]
    fn closed_forms_are_the_integrals() {
        let pi = std::f64::consts::PI;
        for t in [0.0, 0.25, 0.5, 0.8, 1.0] {
            let [volume, normal] = summed(t);
            assert!((1.0 - volume / (4.0 / 3.0 * pi) - share_before(t)).abs() < 2e-3, "{t}");
            assert!((normal / (pi / 12.0) - normal_beyond(t)).abs() < 4e-3, "{t}");
        }
    }
}
