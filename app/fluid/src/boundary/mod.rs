//! What bounds the fluid: walls, periods, or nothing.
//!
//! A wall counts as fluid in the density, answers with twice the particle's own lambda, and makes up for the push along
//! itself that the fluid behind it would give (`boundary/walls.hlsli` says why). Walls stand along chosen axes: along the
//! others they are too far away to matter.
//!
//! Periodic axes are a variant of the passes outside the iterations (`shared/periodic.hlsli`): positions wrap after the
//! prediction and after the corrections, a search visits the rows beyond the seam, and measures take the nearest image.
//! A periodic side is a whole number of cells, and of 4 h, after which quantized positions repeat. So the iterations
//! know nothing of it. Lists ascend; `grid/search_wrapped.hlsli` says in which order a search meets rows beyond a seam.
//!
//! Two dimensions are parameters, not code: one layer of particles at the middle of the domain's depth, without walls
//! along z. Lattice sums, kernel fractions and masses (kg per metre along z) are those of the square lattice.
//! Differences along z are exactly 0.

pub mod bodies;
mod drag_walls;
mod repel_walls;
pub mod solids;
mod walls;

pub use drag_walls::{DragWalls, wall_faces};
pub use repel_walls::{RepelWalls, repel_params};
pub use walls::{WallScales, beyond_wall, wall_kernel_fraction};
pub(crate) use walls::{fitted_wall_kernel_fraction, share, share_slope};
