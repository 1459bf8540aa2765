//! How finely a surface is meshed, and how much room there is.

use super::refine::RefineOptions;
use crate::error::RenderError;
use brooklet_fluid::Scene;
use brooklet_kernels::{BLOCK_CELLS, KERNEL_REACH, KERNEL_STRETCH, MARKED_BLOCKS, MeshParams};

/// A particle's reach in the field, over the spacing (twin: `brooklet_reference::surface::surface_field`).
const REACH_RATIO: f64 = 2.0;
/// The same of the widest ellipsoid.
const WIDEST_REACH_RATIO: f64 = KERNEL_REACH as f64 * KERNEL_STRETCH as f64;
/// Radius of a particle alone, over the spacing.
const RADIUS_RATIO: f64 = 0.55;
/// Sum of weights below which nothing is inside.
const LEAST_WEIGHT: f64 = 0.6;
/// Where the walls of an axis without walls stand: finite in f32 even when squared.
const FAR_M: f64 = 1.0e15;

/// Cells along an axis at most, far more than there may be blocks.
const MOST_CELLS: f64 = 1.0e9;
/// Blocks of the whole grid at most: 64 MiB for each table over them.
const MOST_GRID_BLOCKS: f64 = 16_777_216.0;

/// Options of a meshed surface. Lengths in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MarchingCubesOptions {
    /// Particle spacing.
    pub spacing_m: f64,
    /// Least side of a cell. Cells are as many as fit the domain along each axis, so that walls stand between them; a
    /// quarter of a spacing or more, as the grid ends a block behind the domain.
    pub cell_m: f64,
    /// Whether the field is made all over the grid, instead of in the blocks that the surface may cross: three passes
    /// and two prefix sums fewer, for small grids.
    pub dense: bool,
    /// Whether the field is the density of the particles' ellipsoids (Yu & Turk 2013), where there are some, instead of
    /// Zhu & Bridson's of the particles.
    pub anisotropic: bool,
    /// Size of the domain, from whose lowest corner positions are counted.
    pub domain_size_m: [f64; 3],
    /// Where walls cut the surface off; infinite along axes without.
    pub wall_bounds_m: [[f64; 3]; 2],
    /// Blocks of 4 x 4 x 4 cells that the surface may cross.
    pub most_blocks: u32,
    /// Vertices there is room for.
    pub most_vertices: u32,
    /// Triangles there is room for.
    pub most_triangles: u32,
    /// What is done with the mesh.
    pub refine: RefineOptions,
}

impl MarchingCubesOptions {
    /// Cells as the scene asks for, with room for a surface of its particles that are a few layers thick.
    pub fn for_scene(scene: &Scene) -> Self {
        let slots = usize::try_from(scene.particle_count()).unwrap_or(usize::MAX);
        let slots = slots.max(scene.slot_capacity().unwrap_or_default() as usize);
        let spacing_m = scene.fitted_spacing_m();
        let domain_size_m = scene.domain.size_m();
        let longest_m = domain_size_m.iter().copied().fold(0.0, f64::max);
        let (cell_m, dense) = match scene.surface.mesh.dense_cells {
            0 => (scene.surface.mesh.cell_ratio * spacing_m, false),
            cells => (longest_m / f64::from(cells), true),
        };
        let particles = Self::for_particles(slots, spacing_m, cell_m, domain_size_m, scene.domain.wall_bounds_m());
        let refine = RefineOptions::for_scene(scene, particles.most_vertices);
        Self { dense, anisotropic: scene.surface.mesh.anisotropic, refine, ..particles }
    }

    /// With as much room for so many particles; the mesh is that of their balls, as it is.
    pub fn for_particles(
        count: usize,
        spacing_m: f64,
        cell_m: f64,
        domain_size_m: [f64; 3],
        wall_bounds_m: [[f64; 3]; 2],
    ) -> Self {
        // A surface particle has four cells of half a spacing of surface above it, each with a vertex and two triangles; a
        // splash, where all are at the surface, has four times that.
        let finer = (0.5 * spacing_m / cell_m).powi(2);
        let room = |each: f64, least: u32, most: u32| ((count as f64 * each * finer) as u32).clamp(least, most);
        let most_vertices = room(16.0, 1 << 14, 1 << 22);
        Self {
            spacing_m,
            cell_m,
            dense: false,
            anisotropic: false,
            domain_size_m,
            wall_bounds_m,
            most_blocks: room(2.0, 1 << 10, 1 << 17),
            most_vertices,
            most_triangles: 2 * most_vertices,
            refine: RefineOptions::none(spacing_m),
        }
    }

    /// Cells of the domain along each axis.
    pub fn cells(&self) -> [u32; 3] {
        self.domain_size_m.map(|side_m| (side_m / self.cell_m * (1.0 + 1e-9)).floor().clamp(1.0, MOST_CELLS) as u32)
    }

    /// Blocks along each axis: over the domain, and one before and behind it.
    pub fn blocks(&self) -> [u32; 3] {
        // Cells and the point that ends them.
        self.cells().map(|cells| (cells + 1).div_ceil(BLOCK_CELLS) + 2)
    }

    /// That the grid of blocks has no more than a buffer's worth.
    ///
    /// # Errors
    /// Says how many there are, and how many are allowed.
    pub(crate) fn check(&self) -> Result<(), RenderError> {
        let blocks: f64 = self.blocks().iter().map(|&n| f64::from(n)).product();
        if blocks <= MOST_GRID_BLOCKS {
            return Ok(());
        }
        Err(RenderError::NotAllowed {
            field: "surface.method",
            value: format!("marching-cubes over {blocks:.3e} blocks of cells"),
            allowed: "16777216 are allowed: make spacing_m larger or the domain smaller, or choose screen-space",
        })
    }

    /// What the shaders are given.
    pub fn params(&self) -> MeshParams {
        let (cells, blocks) = (self.cells(), self.blocks());
        let cell_m: [f64; 3] = std::array::from_fn(|axis| self.domain_size_m[axis] / f64::from(cells[axis]));
        let reach_m = self.spacing_m * if self.anisotropic { WIDEST_REACH_RATIO } else { REACH_RATIO };
        // Bins of two spacings have eight particles, few enough to be passed over and enough to be counted.
        let least_m = cell_m.iter().copied().fold(f64::INFINITY, f64::min);
        let bin_cells = (2.0 * self.spacing_m / least_m).round().max(1.0) as u32;
        let bins = cells.map(|cells| cells.div_ceil(bin_cells));
        let [wall_min_m, wall_max_m] =
            self.wall_bounds_m.map(|corner_m| corner_m.map(|m| m.clamp(-FAR_M, FAR_M) as f32));
        let walls = |axis: usize| self.wall_bounds_m[0][axis].is_finite();
        let block_count = blocks.iter().product();
        MeshParams {
            min_m: cell_m.map(|side_m| -f64::from(BLOCK_CELLS) as f32 * side_m as f32),
            spacing_m: self.spacing_m as f32,
            cell_m: cell_m.map(|side_m| side_m as f32),
            reach_m: reach_m as f32,
            blocks,
            block_count,
            cells,
            bin_cells,
            bins,
            bin_count: bins.iter().product(),
            // Where no wall is, the grid's outermost points are outside, so that the mesh is closed.
            low_point: std::array::from_fn(|axis| if walls(axis) { BLOCK_CELLS } else { 1 }),
            radius_m: (RADIUS_RATIO * self.spacing_m) as f32,
            high_point: std::array::from_fn(|axis| match walls(axis) {
                true => BLOCK_CELLS + cells[axis],
                false => BLOCK_CELLS * blocks[axis] - 2,
            }),
            least_weight: LEAST_WEIGHT as f32,
            wall_min_m,
            most_blocks: if self.dense { block_count } else { self.most_blocks },
            wall_max_m,
            most_vertices: self.most_vertices,
            mark_groups: blocks.map(|blocks| blocks.div_ceil(MARKED_BLOCKS)),
            most_triangles: self.most_triangles,
        }
    }
}
