//! What the shaders are told of a step.

use brooklet_kernels::StepParams;

use crate::grid;
use crate::scene::Scene;

/// What the shaders are given.
pub fn step_params(scene: &Scene) -> StepParams {
    let (size_m, period_m) = (scene.domain.size_m(), scene.period_m());
    let [wall_min_m, wall_max_m] =
        scene.domain.wall_bounds_m().map(|corner_m| corner_m.map(|m| m.clamp(-FAR_M, FAR_M) as f32));
    StepParams {
        gravity_m_s2: scene.gravity_m_s2.map(|g| g as f32),
        dt_s: scene.substep_s() as f32,
        domain_size_m: size_m.map(|size_m| size_m as f32),
        wall_offset_m: scene.wall_offset_m() as f32,
        wall_min_m,
        max_speed_m_s: scene.max_speed_m_s() as f32,
        wall_max_m,
        period_m: period_m.map(|period_m| period_m as f32),
        mirrors: u32::from(scene.solver.method.mirrors_walls()),
        list_chunks: grid::list_chunks(scene),
        inverse_period_per_m: period_m.map(|period_m| if period_m > 0.0 { (1.0 / period_m) as f32 } else { 0.0 }),
        ..StepParams::default()
    }
}

/// Where the walls of an axis without walls stand: finite in f32 even over the smallest support.
const FAR_M: f64 = 1.0e30;
