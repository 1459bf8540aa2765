//! Pools with one body, and what says how it floats.

use brooklet_fluid::Scene;
use brooklet_fluid::scene::body_mass_kg;
use brooklet_kernels::{BodyState, Position};

/// A flat box, whose proportions are stable at every density.
pub const FLAT_BOX: &str = "box = { size_m = [0.2, 0.1, 0.2] }";

/// Height of that box, and of any shape that stands for it, m.
pub const HEIGHT_M: f64 = 0.1;
/// Depth of a pool in which the ground is so far below a shape that water there has no layers, m.
pub const DEEP_M: f64 = 0.25;
/// And of one that has few particles, m.
pub const SHALLOW_M: f64 = 0.15;
/// Surface of the pool's ground, m².
const GROUND_M2: f64 = 0.4 * 0.4;

/// One body in a pool whose corner is the origin: sides of the tank and the water's depth, m.
fn pool([x, y, z]: [f64; 3], depth_m: f64, body: &str, method: &str, spacing_m: f64) -> Scene {
    let text = format!(
        "spacing_m = {spacing_m}\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [{x}, {y}, {z}]\n\
         [[fluid]]\nblock = {{ min_m = [0, 0, 0], max_m = [{x}, {depth_m}, {z}] }}\n\
         [[solid]]\n{body}\n[solver]\nmethod = \"{method}\"\n[outputs]\nmeasure_every_steps = 1\n"
    );
    Scene::from_toml(&text, "afloat", &[]).unwrap_or_else(|error| panic!("{error}"))
}

/// A shape as high as [`HEIGHT_M`] in a pool of some depth, afloat where it will be.
pub fn floating(shape: &str, density_kg_m3: f64, method: &str, spacing_m: f64, depth_m: f64) -> Scene {
    let height_m = depth_m + HEIGHT_M * (0.5 - density_kg_m3 / 1000.0);
    let body = format!("{shape}\ncentre_m = [0.2, {height_m}, 0.2]\ndensity_kg_m3 = {density_kg_m3}");
    pool([0.4, depth_m + 0.15, 0.4], depth_m, &body, method, spacing_m)
}

/// How deep it is in water that is as dense as it is told to be, m: of the fluid's volume, the body's, and the ground's surface.
pub fn draft_m(scene: &Scene, state: &BodyState) -> f64 {
    let mass_kg = scene.particle_count() as f64 * scene.particle_mass_kg() + body_mass_kg(&scene.solids[0]);
    mass_kg / 1000.0 / GROUND_M2 - bottom_m(state)
}

/// How deep it is in the water that there is, m: twice the mean height of what stands beside it, as far as half of the gap
/// from the walls. An equation of state has water less high than it is told to be.
pub fn draft_below_surface_m(positions: &[Position], state: &BodyState) -> f64 {
    let middle_m = 0.5 * GROUND_M2.sqrt();
    let heights_m: Vec<f64> = positions
        .iter()
        .map(|at| at.position_m.map(f64::from))
        .filter(|[x, _, z]| (x - middle_m).abs().max((z - middle_m).abs()) > 0.75 * middle_m)
        .map(|[_, y, _]| y)
        .collect();
    2.0 * heights_m.iter().sum::<f64>() / heights_m.len() as f64 - bottom_m(state)
}

fn bottom_m(state: &BodyState) -> f64 {
    f64::from(state.position_m[1]) - 0.5 * HEIGHT_M
}

/// A long square prism, half as heavy as water, which floats on its edge (45 degrees), nearly flat.
pub fn prism(method: &str, spacing_m: f64) -> Scene {
    let body = "box = { size_m = [0.14, 0.14, 0.36] }\nturned_deg = [0, 0, 8]\ncentre_m = [0.25, 0.21, 0.2]\n\
                density_kg_m3 = 500";
    pool([0.5, 0.4, 0.4], 0.2, body, method, spacing_m)
}

/// By how much a body is turned around z, degrees, of a shape that a quarter turn leaves as it is: -45 to 45.
pub fn turned_around_z_deg(state: &BodyState) -> f64 {
    let [_, _, z, w] = state.rotation.map(f64::from);
    let turned_deg = 2.0 * z.atan2(w).to_degrees();
    turned_deg - 90.0 * (turned_deg / 90.0).round()
}

/// A ball as heavy as water in the middle of a pool.
pub fn neutral(method: &str, spacing_m: f64) -> Scene {
    let body = "sphere = { radius_m = 0.08 }\ncentre_m = [0.2, 0.2, 0.2]\ndensity_kg_m3 = 1000";
    pool([0.4, 0.5, 0.4], 0.4, body, method, spacing_m)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_are_told_up_to_a_quarter() {
        for (turned_deg, told_deg) in
            [(0.0_f64, 0.0), (8.0, 8.0), (44.0, 44.0), (46.0, -44.0), (90.0, 0.0), (-100.0, -10.0)]
        {
            let half = 0.5 * turned_deg.to_radians();
            let state =
                BodyState { rotation: [0.0, 0.0, half.sin() as f32, half.cos() as f32], ..BodyState::default() };
            assert!((turned_around_z_deg(&state) - told_deg).abs() < 1e-4, "{turned_deg}");
        }
    }
}
