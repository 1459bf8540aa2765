// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from shaders/hlsl.
//! All kernels, draws and host-visible structs.

mod boundary_bodies_drag_body;
mod boundary_bodies_find_contacts;
mod boundary_bodies_gather_reactions;
mod boundary_bodies_layout;
mod boundary_bodies_step_bodies;
mod boundary_drag_walls;
mod boundary_layout;
mod boundary_repel_walls;
mod boundary_solids_collide_solids;
mod boundary_solids_confine_displacements;
mod boundary_solids_layout;
mod boundary_solids_mark_solids;
mod boundary_solids_move_solids;
mod boundary_solids_sample_solids;
mod diffuse_advect_diffuse;
mod diffuse_collide_diffuse;
mod diffuse_count_spawned;
mod diffuse_crest_normals;
mod diffuse_diffuse;
mod diffuse_foam;
mod diffuse_layout;
mod diffuse_spawn_diffuse;
mod emitters_compact;
mod emitters_drain_particles;
mod emitters_emit_particles;
mod emitters_guide_particles;
mod emitters_layout;
mod emitters_limit_drain;
mod emitters_open_emitters;
mod forces_apply_fields;
mod forces_confine_vorticity;
mod forces_curl;
mod forces_xsph;
mod frame_cross_fade;
mod frame_edges;
mod frame_floor;
mod frame_glass;
mod frame_layout;
mod frame_particles;
mod frame_resolve;
mod frame_shade;
mod frame_shadow;
mod frame_sky;
mod frame_solids;
mod frame_solids_shadow;
mod grid_count_active;
mod grid_count_cells;
mod grid_keep_order;
mod grid_list_neighbours;
mod grid_rank_by_id;
mod grid_reorder;
mod grid_scan;
mod grid_scatter_cell_members;
mod keywords;
mod measure_density_ratios;
mod measure_measure_particles;
mod measure_measure_totals;
mod measure_sample_particles;
mod particles_activate;
mod particles_advect;
mod particles_begin_substep;
mod particles_bounce_walls;
mod particles_deactivate;
mod particles_drag;
mod particles_end_step;
mod particles_limit_velocity;
mod particles_predict;
mod shared_layout;
mod solver_dfsph_apply_gravity;
mod solver_dfsph_apply_pressure;
mod solver_dfsph_carry_pressure;
mod solver_dfsph_coarse_pressure;
mod solver_dfsph_correct_pressure;
mod solver_dfsph_factor_pressure;
mod solver_dfsph_layout;
mod solver_dfsph_shift_positions;
mod solver_dfsph_solve_state;
mod solver_none_integrate_particles;
mod solver_none_layout;
mod solver_pbf_coarsen_constraint;
mod solver_pbf_constrain_density;
mod solver_pbf_correct_positions;
mod solver_pbf_keep_pressure;
mod solver_pbf_layout;
mod solver_pbf_prolong_multiplier;
mod solver_pbf_relax_multiplier;
mod solver_pbf_start_warm;
mod solver_pbf_update_velocity;
mod solver_sph_accelerate;
mod solver_sph_add_solid_acceleration;
mod solver_sph_add_solid_density;
mod solver_sph_choose_time_step;
mod solver_sph_compute_density;
mod solver_sph_find_fastest;
mod solver_sph_layout;
mod surface_anisotropy;
mod surface_caustics;
mod surface_count_covered;
mod surface_count_sun_volume;
mod surface_fluid_depth;
mod surface_layout;
mod surface_mesh_count_bins;
mod surface_mesh_count_mesh;
mod surface_mesh_emit_triangles;
mod surface_mesh_emit_vertices;
mod surface_mesh_finish_mesh;
mod surface_mesh_gather_field;
mod surface_mesh_layout;
mod surface_mesh_list_blocks;
mod surface_mesh_mark_blocks;
mod surface_mesh_mesh_depth;
mod surface_mesh_mesh_normals;
mod surface_mesh_scatter_bins;
mod surface_metal;
mod surface_opaque_planes;
mod surface_refine_count_edges;
mod surface_refine_count_rings;
mod surface_refine_finish_subdivision;
mod surface_refine_layout;
mod surface_refine_list_rings;
mod surface_refine_size_mesh;
mod surface_refine_smooth_normals;
mod surface_refine_sort_rings;
mod surface_refine_subdivide_edges;
mod surface_refine_subdivide_middles;
mod surface_refine_subdivide_triangles;
mod surface_refract_photons;
mod surface_smooth_bilateral;
mod surface_smooth_curvature_flow;
mod surface_smooth_gaussian;
mod surface_smooth_narrow_range;
mod surface_smooth_photons;
mod surface_smooth_sun_depth;
mod surface_sum_sun_volume;
mod surface_sun_depth;
mod surface_sun_thickness;
mod surface_surface_normals;
mod surface_thickness;
mod surface_water;

pub use boundary_bodies_drag_body::*;
pub use boundary_bodies_find_contacts::*;
pub use boundary_bodies_gather_reactions::*;
pub use boundary_bodies_layout::*;
pub use boundary_bodies_step_bodies::*;
pub use boundary_drag_walls::*;
pub use boundary_layout::*;
pub use boundary_repel_walls::*;
pub use boundary_solids_collide_solids::*;
pub use boundary_solids_confine_displacements::*;
pub use boundary_solids_layout::*;
pub use boundary_solids_mark_solids::*;
pub use boundary_solids_move_solids::*;
pub use boundary_solids_sample_solids::*;
pub use diffuse_advect_diffuse::*;
pub use diffuse_collide_diffuse::*;
pub use diffuse_count_spawned::*;
pub use diffuse_crest_normals::*;
pub use diffuse_diffuse::*;
pub use diffuse_foam::*;
pub use diffuse_layout::*;
pub use diffuse_spawn_diffuse::*;
pub use emitters_compact::*;
pub use emitters_drain_particles::*;
pub use emitters_emit_particles::*;
pub use emitters_guide_particles::*;
pub use emitters_layout::*;
pub use emitters_limit_drain::*;
pub use emitters_open_emitters::*;
pub use forces_apply_fields::*;
pub use forces_confine_vorticity::*;
pub use forces_curl::*;
pub use forces_xsph::*;
pub use frame_cross_fade::*;
pub use frame_edges::*;
pub use frame_floor::*;
pub use frame_glass::*;
pub use frame_layout::*;
pub use frame_particles::*;
pub use frame_resolve::*;
pub use frame_shade::*;
pub use frame_shadow::*;
pub use frame_sky::*;
pub use frame_solids::*;
pub use frame_solids_shadow::*;
pub use grid_count_active::*;
pub use grid_count_cells::*;
pub use grid_keep_order::*;
pub use grid_list_neighbours::*;
pub use grid_rank_by_id::*;
pub use grid_reorder::*;
pub use grid_scan::*;
pub use grid_scatter_cell_members::*;
pub use keywords::*;
pub use measure_density_ratios::*;
pub use measure_measure_particles::*;
pub use measure_measure_totals::*;
pub use measure_sample_particles::*;
pub use particles_activate::*;
pub use particles_advect::*;
pub use particles_begin_substep::*;
pub use particles_bounce_walls::*;
pub use particles_deactivate::*;
pub use particles_drag::*;
pub use particles_end_step::*;
pub use particles_limit_velocity::*;
pub use particles_predict::*;
pub use shared_layout::*;
pub use solver_dfsph_apply_gravity::*;
pub use solver_dfsph_apply_pressure::*;
pub use solver_dfsph_carry_pressure::*;
pub use solver_dfsph_coarse_pressure::*;
pub use solver_dfsph_correct_pressure::*;
pub use solver_dfsph_factor_pressure::*;
pub use solver_dfsph_layout::*;
pub use solver_dfsph_shift_positions::*;
pub use solver_dfsph_solve_state::*;
pub use solver_none_integrate_particles::*;
pub use solver_none_layout::*;
pub use solver_pbf_coarsen_constraint::*;
pub use solver_pbf_constrain_density::*;
pub use solver_pbf_correct_positions::*;
pub use solver_pbf_keep_pressure::*;
pub use solver_pbf_layout::*;
pub use solver_pbf_prolong_multiplier::*;
pub use solver_pbf_relax_multiplier::*;
pub use solver_pbf_start_warm::*;
pub use solver_pbf_update_velocity::*;
pub use solver_sph_accelerate::*;
pub use solver_sph_add_solid_acceleration::*;
pub use solver_sph_add_solid_density::*;
pub use solver_sph_choose_time_step::*;
pub use solver_sph_compute_density::*;
pub use solver_sph_find_fastest::*;
pub use solver_sph_layout::*;
pub use surface_anisotropy::*;
pub use surface_caustics::*;
pub use surface_count_covered::*;
pub use surface_count_sun_volume::*;
pub use surface_fluid_depth::*;
pub use surface_layout::*;
pub use surface_mesh_count_bins::*;
pub use surface_mesh_count_mesh::*;
pub use surface_mesh_emit_triangles::*;
pub use surface_mesh_emit_vertices::*;
pub use surface_mesh_finish_mesh::*;
pub use surface_mesh_gather_field::*;
pub use surface_mesh_layout::*;
pub use surface_mesh_list_blocks::*;
pub use surface_mesh_mark_blocks::*;
pub use surface_mesh_mesh_depth::*;
pub use surface_mesh_mesh_normals::*;
pub use surface_mesh_scatter_bins::*;
pub use surface_metal::*;
pub use surface_opaque_planes::*;
pub use surface_refine_count_edges::*;
pub use surface_refine_count_rings::*;
pub use surface_refine_finish_subdivision::*;
pub use surface_refine_layout::*;
pub use surface_refine_list_rings::*;
pub use surface_refine_size_mesh::*;
pub use surface_refine_smooth_normals::*;
pub use surface_refine_sort_rings::*;
pub use surface_refine_subdivide_edges::*;
pub use surface_refine_subdivide_middles::*;
pub use surface_refine_subdivide_triangles::*;
pub use surface_refract_photons::*;
pub use surface_smooth_bilateral::*;
pub use surface_smooth_curvature_flow::*;
pub use surface_smooth_gaussian::*;
pub use surface_smooth_narrow_range::*;
pub use surface_smooth_photons::*;
pub use surface_smooth_sun_depth::*;
pub use surface_sum_sun_volume::*;
pub use surface_sun_depth::*;
pub use surface_sun_thickness::*;
pub use surface_surface_normals::*;
pub use surface_thickness::*;
pub use surface_water::*;

/// Every module of this crate, for building all pipelines at start.
pub fn modules() -> impl Iterator<Item = &'static crate::Module> {
    [
        boundary_bodies_drag_body::MODULES,
        boundary_bodies_find_contacts::MODULES,
        boundary_bodies_gather_reactions::MODULES,
        boundary_bodies_step_bodies::MODULES,
        boundary_drag_walls::MODULES,
        boundary_repel_walls::MODULES,
        boundary_solids_collide_solids::MODULES,
        boundary_solids_confine_displacements::MODULES,
        boundary_solids_mark_solids::MODULES,
        boundary_solids_move_solids::MODULES,
        boundary_solids_sample_solids::MODULES,
        diffuse_advect_diffuse::MODULES,
        diffuse_collide_diffuse::MODULES,
        diffuse_count_spawned::MODULES,
        diffuse_crest_normals::MODULES,
        diffuse_diffuse::MODULES,
        diffuse_foam::MODULES,
        diffuse_spawn_diffuse::MODULES,
        emitters_compact::MODULES,
        emitters_drain_particles::MODULES,
        emitters_emit_particles::MODULES,
        emitters_guide_particles::MODULES,
        emitters_limit_drain::MODULES,
        emitters_open_emitters::MODULES,
        forces_apply_fields::MODULES,
        forces_confine_vorticity::MODULES,
        forces_curl::MODULES,
        forces_xsph::MODULES,
        frame_cross_fade::MODULES,
        frame_edges::MODULES,
        frame_floor::MODULES,
        frame_glass::MODULES,
        frame_particles::MODULES,
        frame_resolve::MODULES,
        frame_shade::MODULES,
        frame_shadow::MODULES,
        frame_sky::MODULES,
        frame_solids::MODULES,
        frame_solids_shadow::MODULES,
        grid_count_active::MODULES,
        grid_count_cells::MODULES,
        grid_keep_order::MODULES,
        grid_list_neighbours::MODULES,
        grid_rank_by_id::MODULES,
        grid_reorder::MODULES,
        grid_scan::MODULES,
        grid_scatter_cell_members::MODULES,
        measure_density_ratios::MODULES,
        measure_measure_particles::MODULES,
        measure_measure_totals::MODULES,
        measure_sample_particles::MODULES,
        particles_activate::MODULES,
        particles_advect::MODULES,
        particles_begin_substep::MODULES,
        particles_bounce_walls::MODULES,
        particles_deactivate::MODULES,
        particles_drag::MODULES,
        particles_end_step::MODULES,
        particles_limit_velocity::MODULES,
        particles_predict::MODULES,
        solver_dfsph_apply_gravity::MODULES,
        solver_dfsph_apply_pressure::MODULES,
        solver_dfsph_carry_pressure::MODULES,
        solver_dfsph_coarse_pressure::MODULES,
        solver_dfsph_correct_pressure::MODULES,
        solver_dfsph_factor_pressure::MODULES,
        solver_dfsph_shift_positions::MODULES,
        solver_dfsph_solve_state::MODULES,
        solver_none_integrate_particles::MODULES,
        solver_pbf_coarsen_constraint::MODULES,
        solver_pbf_constrain_density::MODULES,
        solver_pbf_correct_positions::MODULES,
        solver_pbf_keep_pressure::MODULES,
        solver_pbf_prolong_multiplier::MODULES,
        solver_pbf_relax_multiplier::MODULES,
        solver_pbf_start_warm::MODULES,
        solver_pbf_update_velocity::MODULES,
        solver_sph_accelerate::MODULES,
        solver_sph_add_solid_acceleration::MODULES,
        solver_sph_add_solid_density::MODULES,
        solver_sph_choose_time_step::MODULES,
        solver_sph_compute_density::MODULES,
        solver_sph_find_fastest::MODULES,
        surface_anisotropy::MODULES,
        surface_caustics::MODULES,
        surface_count_covered::MODULES,
        surface_count_sun_volume::MODULES,
        surface_fluid_depth::MODULES,
        surface_mesh_count_bins::MODULES,
        surface_mesh_count_mesh::MODULES,
        surface_mesh_emit_triangles::MODULES,
        surface_mesh_emit_vertices::MODULES,
        surface_mesh_finish_mesh::MODULES,
        surface_mesh_gather_field::MODULES,
        surface_mesh_list_blocks::MODULES,
        surface_mesh_mark_blocks::MODULES,
        surface_mesh_mesh_depth::MODULES,
        surface_mesh_mesh_normals::MODULES,
        surface_mesh_scatter_bins::MODULES,
        surface_metal::MODULES,
        surface_opaque_planes::MODULES,
        surface_refine_count_edges::MODULES,
        surface_refine_count_rings::MODULES,
        surface_refine_finish_subdivision::MODULES,
        surface_refine_list_rings::MODULES,
        surface_refine_size_mesh::MODULES,
        surface_refine_smooth_normals::MODULES,
        surface_refine_sort_rings::MODULES,
        surface_refine_subdivide_edges::MODULES,
        surface_refine_subdivide_middles::MODULES,
        surface_refine_subdivide_triangles::MODULES,
        surface_refract_photons::MODULES,
        surface_smooth_bilateral::MODULES,
        surface_smooth_curvature_flow::MODULES,
        surface_smooth_gaussian::MODULES,
        surface_smooth_narrow_range::MODULES,
        surface_smooth_photons::MODULES,
        surface_smooth_sun_depth::MODULES,
        surface_sum_sun_volume::MODULES,
        surface_sun_depth::MODULES,
        surface_sun_thickness::MODULES,
        surface_surface_normals::MODULES,
        surface_thickness::MODULES,
        surface_water::MODULES,
    ]
    .into_iter()
    .flatten()
    .copied()
}
