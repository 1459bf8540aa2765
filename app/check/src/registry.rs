//! The list of known answers: each once, by room and name, with the stages it is the known answer of.

use crate::device::KnownAnswer;
use crate::rooms;

/// Hands the list of known answers to a macro: `room { name: [stages], ... }`. [`KNOWN_ANSWERS`] is made of
/// it, and the tests are, one each.
#[macro_export]
macro_rules! for_each_known_answer {
    ($make:ident) => {
        $make! {
            anisotropic_mesh {
                the_mesh_of_ellipsoids_matches_its_twin: ["count_bins", "scatter_bins", "gather_field", "mesh_normals"],
            }
            anisotropy {
                ellipsoids_are_their_twins: ["anisotropy"],
                bodies_without_thickness_have_finite_ellipsoids: ["anisotropy"],
                a_list_that_was_never_made_is_no_spray_and_quarantined_ones_stay_so: ["anisotropy"],
            }
            body_forces {
                apply_fields_matches_its_twin: ["apply_fields"],
            }
            boundary {
                walls_match_their_twin: ["correct_positions", "measure_particles"],
                narrow_walls_match_their_twin: ["correct_positions", "measure_particles"],
            }
            bodies {
                find_contacts_matches_its_twin: ["find_contacts"],
                step_bodies_matches_its_twin: ["step_bodies"],
                gather_reactions_matches_its_twin: ["gather_reactions"],
            }
            drag_body {
                drag_body_matches_its_twin: ["drag_body"],
                a_body_is_dragged_to_where_the_hand_is: ["drag_body"],
            }
            body_reactions {
                bodies_take_back_what_stops_paths: ["collide_solids"],
                bodies_take_back_what_confines_displacements: ["confine_displacements"],
            }
            coarse_correction {
                coarsen_constraint_is_exact: ["coarsen_constraint"],
                relax_multiplier_matches_its_twin: ["relax_multiplier"],
                a_wrong_end_mixing_conductance_or_sweep_is_told_apart: ["relax_multiplier"],
                prolong_multiplier_matches_its_twin: ["prolong_multiplier"],
                constraints_are_restricted_to_their_cells: ["constrain_density"],
            }
            constrain_density {
                constrain_density_matches_its_twin: ["constrain_density"],
                without_mixing_a_lone_particle_is_no_fault: ["constrain_density"],
                momentum_matches_its_twin: ["constrain_density"],
                a_wrong_weight_of_an_iteration_is_told_apart: ["constrain_density"],
            }
            count_covered {
                what_is_covered_is_counted: ["count_covered"],
            }
            dfsph {
                correct_pressure_matches_its_twin: ["correct_pressure"],
                a_wrong_setting_of_a_solve_is_told_apart: ["correct_pressure"],
                apply_pressure_matches_its_twin: ["apply_pressure"],
                pressure_keeps_momentum_in_free_space: ["apply_pressure"],
            }
            dfsph_coarse {
                what_is_left_over_goes_to_cells_and_pressure_comes_back: ["restrict_pressure", "prolong_pressure"],
            }
            dfsph_factors {
                factor_pressure_matches_its_twin: ["factor_pressure"],
                pairs_that_are_too_close_part_oppositely: ["factor_pressure"],
            }
            dfsph_moves {
                shift_positions_matches_its_twin: ["shift_positions"],
                limit_velocity_matches_its_twin: ["limit_velocity"],
            }
            dfsph_solves {
                carry_pressure_and_apply_gravity_are_exact: ["carry_pressure", "apply_gravity"],
                solves_end_when_little_is_left_or_nothing_is_left_to_try: ["begin_solve", "end_iteration"],
            }
            diffuse {
                crest_normals_match_their_twin: ["crest_normals"],
                count_spawned_matches_its_twin: ["count_spawned"],
                spawn_diffuse_matches_its_twin: ["spawn_diffuse", "settle_diffuse"],
            }
            diffuse_moves {
                advect_diffuse_matches_its_twin: ["advect_diffuse"],
                collide_diffuse_matches_its_twin: ["collide_diffuse"],
            }
            drag {
                drag_matches_its_twin: ["drag"],
                a_drag_of_another_radius_or_velocity_fails: ["drag"],
                a_scene_is_dragged_only_if_somebody_asks: ["drag"],
            }
            drag_walls {
                drag_walls_matches_its_twin: ["drag_walls"],
                a_wrong_face_or_wall_is_told_apart: ["drag_walls"],
            }
            drains {
                drain_particles_matches_its_twin: ["drain_particles"],
                limited_drains_match_their_twins: ["mark_drained", "take_drained", "settle_drain"],
                compaction_matches_its_twin: ["mark_active", "list_movers", "fill_holes", "count_compacted"],
            }
            drawn_caustics {
                each_stage_is_its_twin: [
                    "draw_sun_depth", "draw_smooth_sun_depth", "draw_sun_thickness", "refract_photons",
                    "smooth_photons", "draw_caustics",
                ],
                calm_water_lights_the_floor_evenly: ["draw_caustics", "refract_photons"],
                a_lattice_does_not_comb_the_light: ["draw_caustics", "refract_photons"],
                flux_is_kept: ["draw_caustics"],
            }
            drawn_diffuse {
                what_is_splatted_is_its_twin: ["draw_diffuse"],
            }
            drawn_solids {
                solids_are_lit_where_their_poses_put_them: ["draw_solids", "draw_solids_shadow"],
                glass_lets_through_what_its_twin_does: ["draw_glass"],
                triangles_lie_on_their_shapes_and_close_them: [],
            }
            drawn_sun_volume {
                the_suns_volume_is_its_twin: ["count_sun_volume", "sum_sun_volume"],
                a_ball_shades_the_pool_below_it: ["count_sun_volume", "sum_sun_volume"],
            }
            drawn_thickness {
                the_nearest_spheres_and_their_thickness_are_their_twins: [
                    "draw_fluid_depth", "draw_opaque_planes", "draw_thickness",
                ],
                thickness_of_one_particle_is_its_volume: ["draw_thickness"],
            }
            emitters {
                open_emitters_matches_its_twin: ["open_emitters"],
                emit_particles_matches_its_twin: ["emit_particles"],
                guide_particles_matches_its_twin: ["guide_particles"],
            }
            grid {
                count_cells_matches_its_twin: ["count_cells"],
                a_dispatch_longer_than_a_row_of_groups_reaches_all: ["count_cells"],
                positions_far_outside_have_no_cell: ["count_cells"],
                reorder_matches_its_twin: ["reorder"],
                keep_order_matches_its_twin: ["keep_order"],
                rank_members_matches_its_twin: ["rank_by_id", "scatter_cell_members"],
                sort_is_a_permutation_in_order_of_cells: ["count_cells", "scan_groups", "reorder"],
            }
            hardware {
                the_order_of_atomics_changes_no_sorted_result: ["count_cells", "rank_by_id", "scatter_cell_members"],
                numbers_too_small_to_be_normal_do_no_harm: ["predict", "reorder"],
                coordinates_at_faces_are_rounded_as_on_the_host: ["count_cells", "reorder"],
                a_long_dispatch_is_not_cut_short: [],
                a_lost_device_is_told_and_another_goes_on: [],
            }
            list {
                list_neighbours_matches_brute_force: ["list_neighbours"],
                a_wrapped_grid_lists_what_a_dense_one_does: ["count_cells", "list_neighbours"],
                periodic_lists_are_those_of_the_nearest_images: ["count_cells", "list_neighbours"],
                neighbours_without_a_slot_are_counted: ["list_neighbours"],
                lists_reach_over_escapes: ["list_neighbours"],
                list_equals_brute_force_anywhere: ["list_neighbours"],
            }
            marching_cubes {
                mark_blocks_lists_what_its_twin_lists: ["count_bins", "mark_blocks", "list_blocks"],
                what_is_not_listed_has_no_surface: ["mark_blocks", "list_blocks"],
                gather_field_matches_its_twin: ["gather_field"],
                mesh_normals_match_their_twin: ["mesh_normals"],
                meshes_are_closed_and_those_of_the_twin: [
                    "scatter_bins", "count_mesh", "finish_mesh", "emit_vertices", "emit_triangles",
                ],
                random_particles_in_random_boxes_give_closed_meshes: [
                    "scatter_bins", "count_mesh", "finish_mesh", "emit_vertices", "emit_triangles",
                ],
                normals_point_out_of_the_fluid: ["mesh_normals"],
                what_finds_no_room_is_counted_and_nothing_is_written_beyond_the_end: [
                    "list_blocks", "count_mesh", "finish_mesh", "emit_triangles",
                ],
            }
            measure {
                density_ratios_are_their_twins: ["density_ratios"],
                measures_match_their_twins: ["measure_particles", "measure_totals"],
                percentiles_are_those_of_a_walk_from_the_highest_bin_down: ["measure_totals"],
                totals_add_up_any_number_of_groups: ["measure_totals"],
            }
            none {
                bounce_walls_matches_its_twin: ["bounce_walls"],
                integrate_particles_matches_its_twin: ["integrate_particles"],
                a_wrong_setting_is_noticed: ["integrate_particles"],
                states_that_are_not_finite_are_quarantined: ["integrate_particles"],
            }
            particles {
                predict_matches_its_twin: ["predict"],
                states_that_are_not_finite_are_quarantined: ["predict"],
                free_fall_is_exact_to_rounding: ["predict"],
                rows_of_groups_fold: ["predict"],
            }
            periodic {
                predict_matches_its_twin: ["predict"],
                integrate_particles_matches_its_twin: ["integrate_particles"],
                update_velocity_matches_its_twin: ["update_velocity"],
                densities_match_their_twins: ["density_ratios", "measure_particles"],
            }
            pictures {
                points_are_as_stored: [
                    "draw_floor", "draw_sky", "draw_edges", "draw_shadow", "draw_particles", "draw_shade", "draw_resolve",
                ],
                points_by_density_are_as_stored: ["density_ratios", "draw_particles", "draw_shade"],
                points_by_fluid_are_as_stored: ["draw_particles", "draw_shade"],
                no_fluid_is_as_stored: ["draw_floor", "draw_sky", "draw_edges", "draw_resolve"],
                water_is_as_stored: [
                    "draw_floor", "draw_sky", "draw_edges", "draw_fluid_depth", "draw_smooth_narrow_range",
                    "draw_sun_thickness", "draw_opaque_planes", "draw_thickness", "draw_water", "draw_resolve",
                    "draw_sun_depth", "draw_smooth_sun_depth", "refract_photons", "smooth_photons", "draw_caustics",
                ],
                water_without_light_of_its_own_is_as_stored: [
                    "draw_floor", "draw_fluid_depth", "draw_smooth_narrow_range", "draw_sun_thickness",
                    "draw_opaque_planes", "draw_thickness", "draw_water",
                ],
                water_of_spheres_is_as_stored: [
                    "draw_fluid_depth", "draw_thickness", "draw_water", "draw_sun_depth", "draw_smooth_sun_depth",
                    "draw_sun_thickness", "refract_photons", "smooth_photons", "draw_caustics",
                ],
                meshed_water_is_as_stored: [
                    "draw_floor", "draw_mesh_depth", "draw_sun_thickness", "draw_opaque_planes", "draw_thickness",
                    "draw_water", "draw_sun_depth", "draw_caustics",
                ],
                meshed_water_without_light_of_its_own_is_as_stored: [
                    "draw_floor", "draw_mesh_depth", "draw_sun_thickness", "draw_opaque_planes", "draw_thickness",
                    "draw_water",
                ],
                points_and_solids_are_as_stored: [
                    "draw_floor", "draw_shade", "draw_solids", "draw_solids_shadow", "draw_glass",
                ],
                water_and_solids_are_as_stored: [
                    "draw_floor", "draw_water", "draw_solids", "draw_solids_shadow", "draw_glass",
                ],
                water_without_light_of_its_own_and_solids_are_as_stored: [
                    "draw_floor", "draw_water", "draw_solids", "draw_solids_shadow", "draw_glass",
                ],
                meshed_water_and_solids_are_as_stored: [
                    "draw_floor", "draw_water", "draw_solids", "draw_solids_shadow", "draw_glass",
                ],
                metal_is_as_stored: ["draw_metal"],
                meshed_metal_is_as_stored: ["draw_metal"],
                metal_and_solids_are_as_stored: ["draw_metal"],
                meshed_metal_and_solids_are_as_stored: ["draw_metal"],
                a_cross_fade_is_as_stored: ["draw_fluid_depth", "draw_mesh_depth", "draw_water", "draw_cross_fade"],
            }
            refine {
                smooth_normals_matches_its_twin: ["smooth_normals"],
                subdivided_meshes_are_the_twin_s_and_closed: [
                    "count_edges", "count_rings", "finish_subdivision", "list_rings", "scan_groups", "size_mesh",
                    "sort_rings", "subdivide_edges", "subdivide_middles", "subdivide_triangles",
                ],
                meshed_particles_stay_closed: [
                    "finish_subdivision", "subdivide_edges", "subdivide_middles", "subdivide_triangles",
                ],
                what_finds_no_room_is_counted_and_nothing_is_written_beyond_the_end: [
                    "finish_subdivision", "subdivide_triangles", "subdivide_middles",
                ],
                smoothing_lowers_the_error_of_normals_and_keeps_edges: ["smooth_normals"],
                subdivision_is_nearer_to_a_ball_than_midpoints: ["subdivide_edges"],
            }
            repel_walls {
                repel_walls_matches_its_twin: ["repel_walls"],
                a_wrong_wall_that_repels_is_told_apart: ["repel_walls"],
            }
            runs {
                two_deterministic_runs_have_one_hash: [],
                frames_in_flight_read_back_their_own_values: [],
                the_clock_runs_forward: [],
            }
            sample {
                every_stride_th_particle_has_its_place_however_they_are_sorted: ["sample_particles"],
                a_sample_of_other_particles_fails: ["sample_particles"],
                a_scene_is_sampled_only_if_somebody_wants_it_and_never_beyond_what_was_allowed: ["sample_particles"],
            }
            scan {
                reduce_and_scan_groups_match_their_twins: ["reduce_groups", "scan_groups"],
                scan_of_several_levels_matches_its_twin: ["reduce_groups", "scan_groups"],
                scan_of_anything: ["reduce_groups", "scan_groups"],
            }
            slots {
                begin_substep_matches_its_twin: ["begin_substep"],
                time_is_summed_without_losing_any: ["begin_substep"],
                count_active_matches_its_twin: ["count_active"],
                activate_particles_and_claim_slots_match_their_twins: ["activate_particles", "claim_slots"],
                deactivate_particles_matches_its_twin: ["deactivate_particles"],
            }
            solid_contacts {
                densities_near_solids_match_their_twin: ["density_ratios", "measure_particles"],
                constraints_near_solids_match_their_twin: ["constrain_density"],
                corrections_near_solids_match_their_twin: ["correct_positions"],
            }
            solid_forces {
                add_solid_density_matches_its_twin: ["add_solid_density"],
                add_solid_acceleration_matches_its_twin: ["add_solid_acceleration"],
            }
            solid_shifts {
                shifts_end_at_solids: ["shift_positions"],
            }
            solids {
                move_solids_matches_its_twin: ["move_solids"],
                mark_solids_is_exact: ["mark_solids"],
                collide_solids_matches_its_twin: ["collide_solids"],
                confine_displacements_matches_its_twin: ["confine_displacements"],
                sample_solids_matches_its_twin: ["sample_solids"],
            }
            solver {
                correct_positions_matches_its_twin: ["correct_positions"],
                corrections_hold_the_whole_displacement_below_the_support: ["correct_positions"],
                corrections_keep_momentum_in_free_space: ["correct_positions"],
                particles_at_one_point_part_oppositely: ["correct_positions"],
                update_velocity_matches_its_twin: ["update_velocity"],
            }
            sph {
                compute_density_matches_its_twin: ["compute_density"],
                accelerate_matches_its_twin: ["accelerate"],
                a_wrong_kernel_or_term_of_sph_is_told_apart: ["compute_density", "accelerate"],
            }
            sph_step {
                advect_matches_its_twin: ["advect"],
                choose_time_step_matches_its_twin: ["choose_time_step"],
                lists_are_kept_until_particles_have_moved_too_far: ["choose_time_step"],
                find_fastest_matches_its_twin: ["find_fastest"],
                end_step_visits_all_again: ["end_step"],
            }
            surface {
                every_filter_is_its_twin: [
                    "draw_smooth_narrow_range", "draw_smooth_curvature_flow", "draw_smooth_bilateral",
                    "draw_smooth_gaussian",
                ],
                normals_are_their_twins: ["draw_surface_normals"],
                nothing_and_one_particle_make_no_holes_in_numbers: [
                    "draw_smooth_narrow_range", "draw_smooth_curvature_flow", "draw_smooth_bilateral",
                    "draw_smooth_gaussian",
                ],
            }
            velocity {
                xsph_matches_its_twin: ["xsph"],
                curl_matches_its_twin: ["curl"],
                confine_vorticity_matches_its_twin: ["confine_vorticity"],
            }
            warm_start {
                start_warm_matches_its_twin: ["start_warm"],
                keep_pressure_matches_its_twin: ["keep_pressure"],
            }
        }
    };
}

macro_rules! list {
    ($($room:ident { $($name:ident: [$($stage:literal),* $(,)?],)+ })+) => {
        /// Every case.
        pub static KNOWN_ANSWERS: &[KnownAnswer] = &[$($(KnownAnswer {
            room: stringify!($room),
            name: stringify!($name),
            stages: &[$($stage),*],
            run: rooms::$room::$name,
        }),+),+];
    };
}

for_each_known_answer!(list);
