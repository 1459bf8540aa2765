//! What the shaders are told of the smoothing kernel, and of what it counts beyond walls.

use brooklet_kernels::SmoothingKernelParams;

use crate::boundary::{WallScales, wall_kernel_fraction};
use crate::scene::Scene;
use crate::smoothing_kernel::lattice;

/// What the shaders are given.
pub fn smoothing_kernel_params(scene: &Scene) -> SmoothingKernelParams {
    with_walls_if(scene.domain.wall.model.counts_in_density(), params_with_walls(scene))
}

/// A kernel whose walls count, or are left out.
pub(crate) fn with_walls_if(they_count: bool, kernel: SmoothingKernelParams) -> SmoothingKernelParams {
    if they_count { kernel } else { without_walls(kernel) }
}

/// Of walls that are no part of the density, or do not answer to pressure: shares that count nothing.
pub(crate) fn without_walls(kernel: SmoothingKernelParams) -> SmoothingKernelParams {
    SmoothingKernelParams { wall_plane: 0.0, wall_edge: 0.0, wall_corner: 0.0, ..kernel }
}

/// With walls as part of the density, whatever the scene's are.
pub(crate) fn params_with_walls(scene: &Scene) -> SmoothingKernelParams {
    let (dimensions, support_ratio) = (scene.domain.dimensions, scene.solver.support_ratio);
    let walls = WallScales::new(dimensions, support_ratio);
    SmoothingKernelParams {
        support_m: scene.support_m() as f32,
        inverse_support_per_m: (1.0 / scene.support_m()) as f32,
        weight: lattice(dimensions, support_ratio).weight as f32,
        wall_plane: walls.plane as f32,
        wall_edge: walls.edge as f32,
        wall_corner: walls.corner as f32,
        along_z: if scene.domain.is_flat() { 0.0 } else { 1.0 },
        reserved: 0.0,
        wall_kernel_fraction: wall_kernel_fraction(dimensions).map(|c| c as f32),
    }
}
