//! The coarse grid of a deep fluid's divergence solve: what holds hundreds of layers varies so slowly that local iterations
//! would need thousands of each other. (Shader: `solver/dfsph/coarse_pressure.compute`; PBF's stages solve.)

use brooklet_kernels::CoarseGridParams;

use crate::scene::Scene;
use crate::solver::pbf::coarse_levels;

/// Layers from which on a fluid begins with a coarse grid. Below it iterations hold it, and are fewer without.
const DEEP_LAYERS: f64 = 64.0;
/// What a multiplier leaves of the residual, over the lattice's |∇C|²: as little as keeps a closed full box an ordinary case. A
/// column's pressure reaches over all of it.
const MIXING: f64 = 1.0e-4;
/// A correction takes away no more: as much as PBF's grid may add.
const LEAST: f64 = -0.25;

/// What the shaders are given of each level of `scene`, finest first; none if it has no coarse grid.
pub fn coarse_grid_params(scene: &Scene) -> Vec<CoarseGridParams> {
    let is_deep = scene.depth_m() > DEEP_LAYERS * scene.fitted_spacing_m();
    match scene.solver.dfsph.coarse_correction.unwrap_or(is_deep) {
        true => coarse_levels(scene, MIXING, LEAST),
        false => Vec::new(),
    }
}
