// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from shaders/hlsl.
//! All kernels, draws and host-visible structs.

mod bench_constrain_density_by_index;
mod bench_copy;
mod bench_count_cells_aggregated;
mod bench_gather_elements;
mod bench_list_neighbours_by_index;
mod bench_multiply_add;
mod bench_reorder_index;
mod bench_scan_groups_doubling;
mod bench_scan_groups_tree;
mod bench_scan_step;

pub use bench_constrain_density_by_index::*;
pub use bench_copy::*;
pub use bench_count_cells_aggregated::*;
pub use bench_gather_elements::*;
pub use bench_list_neighbours_by_index::*;
pub use bench_multiply_add::*;
pub use bench_reorder_index::*;
pub use bench_scan_groups_doubling::*;
pub use bench_scan_groups_tree::*;
pub use bench_scan_step::*;

/// Every module of this crate, for building all pipelines at start.
pub fn modules() -> impl Iterator<Item = &'static brooklet_kernels::Module> {
    [
        bench_constrain_density_by_index::MODULES,
        bench_copy::MODULES,
        bench_count_cells_aggregated::MODULES,
        bench_gather_elements::MODULES,
        bench_list_neighbours_by_index::MODULES,
        bench_multiply_add::MODULES,
        bench_reorder_index::MODULES,
        bench_scan_groups_doubling::MODULES,
        bench_scan_groups_tree::MODULES,
        bench_scan_step::MODULES,
    ]
    .into_iter()
    .flatten()
    .copied()
}
