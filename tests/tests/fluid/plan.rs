//! What a scene does not need is not dispatched, not allocated, not timed, and not in the shader.

use std::collections::BTreeSet;

use brooklet_fluid::{Scene, Session, record, record_count};
use brooklet_gpu::{Engine, Gpu, GpuOptions, Plan, Resources, Tier, TimingStatus};
use brooklet_render::{FrameOptions, Particles, View};
use brooklet_tests::gpu;

const SMALL: &[&str] = &["spacing_m=0.1", "outputs.width_px=32", "outputs.height_px=32", "surface.method=none"];

fn scene(settings: &[&str]) -> Scene {
    let settings: Vec<String> = SMALL.iter().chain(settings).map(|&s| s.into()).collect();
    Scene::load("calm-pool", &settings).unwrap()
}

/// The plan of a scene with its pictures, if it has some.
fn plan(settings: &[&str]) -> Plan {
    let scene = scene(settings);
    let mut resources = Resources::new();
    let recorded = record(&mut resources, &scene);
    let mut wanted: Vec<_> = recorded.measure_id().into_iter().collect();
    let mut recordings = recorded.recordings();
    if scene.outputs.images > 0 {
        let options = FrameOptions::for_scene(&scene, gpu().tier());
        let view = View::of_scene(&scene);
        let passes = brooklet_render::record(&mut resources, &view, &Particles::of(&recorded), &options).unwrap();
        recordings.extend([passes.init, passes.draw]);
        wanted.push(passes.color.id);
    }
    Plan::sweep(resources, recordings, &wanted).unwrap()
}

fn stages(plan: &Plan) -> BTreeSet<&'static str> {
    plan.passes().iter().map(|pass| pass.stage).collect()
}

fn modules(plan: &Plan) -> BTreeSet<&'static str> {
    plan.passes().iter().map(|pass| pass.module.name).collect()
}

fn buffers(plan: &Plan) -> BTreeSet<String> {
    plan.buffers().into_iter().map(|buffer| buffer.label).collect()
}

/// What the engine counted of one run of everything in a plan.
struct Counted {
    dispatches: u64,
    /// Before the first run: all but the ring of results.
    allocations: u64,
    /// Of the ring.
    ring_allocations: u64,
    timestamps: u64,
    timed_stages: BTreeSet<&'static str>,
}

fn count_on(gpu: &Gpu, plan: Plan) -> Counted {
    let recordings: Vec<_> = plan.recordings().collect();
    let mut engine = Engine::new(gpu, plan).unwrap();
    let allocations = engine.allocation_count();
    engine.run(&recordings, &[]).unwrap();
    let reports = engine.finish().unwrap();
    Counted {
        dispatches: engine.dispatch_count(),
        allocations,
        ring_allocations: engine.allocation_count() - allocations,
        timestamps: engine.timestamp_query_count(),
        timed_stages: reports.iter().flat_map(|report| &report.spans).map(|span| span.stage).collect(),
    }
}

fn count(plan: Plan) -> Counted {
    count_on(&gpu(), plan)
}

/// An optional term: how to do without, how to have it, and what it brings.
struct Term {
    without: &'static str,
    with: &'static str,
    stages: &'static [&'static str],
    buffers: &'static [&'static str],
    /// Part of the names of the modules that have its code.
    variant: Option<&'static str>,
}

const TERMS: &[Term] = &[
    Term {
        without: "solver.deterministic=false",
        with: "solver.deterministic=true",
        stages: &["scatter_cell_members", "rank_by_id"],
        buffers: &["cell_members"],
        variant: None,
    },
    Term {
        without: "forces.vorticity_m_s=0",
        with: "forces.vorticity_m_s=0.1",
        stages: &["curl", "confine_vorticity"],
        buffers: &["vorticities"],
        variant: None,
    },
    Term {
        without: "forces.xsph=0",
        with: "forces.xsph=0.05",
        stages: &["xsph"],
        // It reads velocities where the sort left them, updated in place.
        buffers: &[],
        variant: Some("IN_PLACE_VELOCITY"),
    },
    Term {
        without: "solver.pbf.s_corr_k=0",
        with: "solver.pbf.s_corr_k=0.1",
        stages: &[],
        buffers: &[],
        variant: Some("S_CORR"),
    },
    Term {
        without: "domain.walls=false",
        with: "domain.walls=true",
        stages: &[],
        buffers: &[],
        variant: Some("WALLS"),
    },
    Term {
        without: "domain={ min_m = [0, 0, 0], max_m = [0.8, 0.5, 0.5] }",
        with: "domain={ min_m = [0, 0, 0], max_m = [0.8, 0.5, 0.5], periodic = [true, false, false] }",
        stages: &[],
        buffers: &[],
        variant: Some("PERIODIC"),
    },
    Term {
        without: "outputs.measure_every_steps=0",
        with: "outputs.measure_every_steps=1",
        stages: &["measure_particles", "measure_totals"],
        buffers: &["measure", "group_measures", "histograms"],
        variant: None,
    },
    Term {
        without: "outputs.images=0",
        with: "outputs.images=1",
        stages: &["draw_floor", "draw_sky", "draw_edges", "draw_resolve"],
        buffers: &["picture", "radiance", "depth", "frame_view", "frame_light", "frame_style"],
        variant: None,
    },
    Term {
        without: "surface.method=none",
        with: "surface.method=points",
        stages: &["draw_shadow", "draw_particles", "draw_shade"],
        buffers: &["seen", "shadow_map"],
        variant: Some("POINTS_SHADOW"),
    },
    Term {
        without: "surface={ method = 'points', color_by = 'fluid' }",
        with: "surface={ method = 'points', color_by = 'density' }",
        stages: &["density_ratios"],
        buffers: &["density_ratios"],
        variant: None,
    },
    Term {
        without: "surface.method=none",
        with: "surface={ method = 'screen-space', caustics = false, self_shadow = false }",
        stages: &[
            "anisotropy",
            "draw_fluid_depth",
            "draw_smooth_narrow_range",
            "draw_opaque_planes",
            "draw_thickness",
            "draw_sun_thickness",
            "draw_water",
        ],
        buffers: &[
            "anisotropy_params",
            "ellipsoids",
            "surface_params",
            "water_style",
            "fluid_inverse_depth",
            "smoothed_inverse_depth",
            "half_smoothed_inverse_depth",
            "fluid_depth",
            "opaque_planes",
            "thickness",
            "sun_thickness",
            "water",
        ],
        variant: Some("WATER"),
    },
    Term {
        without: "surface={ method = 'screen-space', anisotropic = false }",
        with: "surface={ method = 'screen-space', anisotropic = true }",
        stages: &["anisotropy"],
        buffers: &["anisotropy_params", "ellipsoids"],
        variant: Some("ELLIPSOID"),
    },
    Term {
        without: "surface={ method = 'screen-space', caustics = false }",
        with: "surface={ method = 'screen-space', caustics = true }",
        stages: &["draw_sun_depth", "draw_smooth_sun_depth", "refract_photons", "smooth_photons", "draw_caustics"],
        buffers: &[
            "sun_depth",
            "half_smoothed_sun_depth",
            "smoothed_sun_depth",
            "sun_covered",
            "bent_photons",
            "half_smoothed_photons",
            "photons",
            "caustics",
        ],
        variant: Some("DrawCaustics"),
    },
    Term {
        without: "surface={ method = 'screen-space', self_shadow = false }",
        with: "surface={ method = 'screen-space', self_shadow = true }",
        stages: &["count_sun_volume", "sum_sun_volume"],
        buffers: &["sun_volume_params", "sun_volume_counts", "sun_volume"],
        variant: Some("SELF_SHADOW"),
    },
    Term {
        without: "surface={ method = 'screen-space', smoothing = 'none' }",
        with: "surface={ method = 'screen-space', smoothing = 'curvature-flow' }",
        stages: &["draw_smooth_curvature_flow"],
        buffers: &["smoothed_inverse_depth", "half_smoothed_inverse_depth"],
        variant: None,
    },
    Term {
        without: "surface={ method = 'marching-cubes', mesh = { smooth_normals = 0 } }",
        with: "surface={ method = 'marching-cubes', mesh = { smooth_normals = 2 } }",
        stages: &["size_mesh", "count_rings", "reduce_groups", "list_rings", "sort_rings", "smooth_normals"],
        buffers: &[
            "refine_params",
            "mesh_size",
            "ring_counts",
            "ring_places",
            "ring_starts",
            "ring_starts_sums_1",
            "ring_starts_offsets_1",
            "rings",
            "smoothed_vertices",
        ],
        variant: None,
    },
    Term {
        without: "surface={ method = 'marching-cubes', mesh = { smooth_normals = 2, subdivide = 1 } }",
        with: "surface={ method = 'marching-cubes', mesh = { smooth_normals = 2, subdivide = 3 } }",
        stages: &["count_edges", "finish_subdivision", "subdivide_edges", "subdivide_middles", "subdivide_triangles"],
        buffers: &[
            "edge_counts",
            "edge_starts",
            "edge_starts_sums_1",
            "edge_starts_offsets_1",
            "fine_counts",
            "fine_vertices",
            "fine_indices",
        ],
        variant: None,
    },
    Term {
        without: "solver.pbf.iterations=0",
        with: "solver.pbf.iterations=1",
        stages: &["constrain_density", "correct_positions"],
        buffers: &["position_lambdas"],
        variant: None,
    },
];

/// Draws that share a pass with another: below the desktop tier, where GPUs draw a pass tile by tile, they have one
/// time together, under the first one's name.
const SHARED: &[(&str, &str)] = &[("draw_sky", "draw_floor"), ("draw_edges", "draw_floor")];

/// The stage whose time has `stage` in it.
fn timed_as(stage: &'static str) -> &'static str {
    let first = SHARED.iter().find(|(draw, _)| gpu().tier() != Tier::Desktop && *draw == stage);
    first.map_or(stage, |(_, first)| first)
}

#[test]
fn each_optional_term_takes_all_it_brings_along() {
    for term in TERMS {
        let Term { without, with, .. } = term;
        let (lean, full) = (plan(&[without]), plan(&[with]));
        // Exactly these and nothing else fall away, by name.
        let brought = |of: &BTreeSet<&'static str>, than: &BTreeSet<&'static str>| -> BTreeSet<&str> {
            of.difference(than).copied().collect()
        };
        assert_eq!(brought(&stages(&full), &stages(&lean)), term.stages.iter().copied().collect(), "{with}");
        assert!(stages(&lean).is_subset(&stages(&full)), "{without} brings a stage");
        let fallen: BTreeSet<String> = buffers(&full).difference(&buffers(&lean)).cloned().collect();
        assert_eq!(fallen, term.buffers.iter().map(|label| label.to_string()).collect(), "{with}");
        assert_eq!(buffers(&lean).difference(&buffers(&full)).next(), None, "{without} brings a buffer");
        // And by bytes: those of the buffers that fell away.
        let bytes: u64 = full.buffers().iter().filter(|b| fallen.contains(&b.label)).map(|b| b.bytes).sum();
        let [full_bytes, lean_bytes] = [&full, &lean].map(|plan| plan.clone().without_sharing().bytes());
        assert_eq!(full_bytes - lean_bytes, bytes, "{with}");
        assert!(bytes > 0 || term.variant.is_some(), "{without} saves no byte");
        if let Some(variant) = term.variant {
            assert!(modules(&full).iter().any(|module| module.contains(variant)), "{with}: {:?}", modules(&full));
            assert!(!modules(&lean).iter().any(|module| module.contains(variant)), "{without}: {:?}", modules(&lean));
        }

        // And so it runs: what the engine handed to the driver, not what the plan says.
        let dispatches = |plan: &Plan| -> u64 { plan.passes().iter().map(|pass| u64::from(pass.count)).sum() };
        let fewer_dispatches = dispatches(&full) - dispatches(&lean);
        let fewer_buffers = term.buffers.len() as u64;
        let is_timed = gpu().timing().is_measured();
        let (lean, full) = (count(lean.without_sharing()), count(full.without_sharing()));
        assert_eq!(full.dispatches - lean.dispatches, fewer_dispatches, "{with}");
        assert!(full.allocations - lean.allocations >= fewer_buffers, "{with}");
        assert_eq!(full.allocations > lean.allocations, fewer_buffers > 0, "{with}");
        assert!(!is_timed || full.timestamps - lean.timestamps >= fewer_dispatches, "{with}");
        assert_eq!(is_timed && full.timestamps > lean.timestamps, is_timed && fewer_dispatches > 0, "{with}");
        for stage in term.stages {
            assert!(!lean.timed_stages.contains(stage), "{without}: {stage} is timed");
            assert!(!is_timed || full.timed_stages.contains(timed_as(stage)), "{with}: {stage} is not timed");
        }
    }
}

/// Two parts a side leave nothing within a triangle.
#[test]
fn triangles_cut_in_four_have_no_vertices_within() {
    let settings = |parts: u32| plan(&[&format!("surface={{ method = 'marching-cubes', mesh.subdivide = {parts} }}")]);
    let (four, nine) = (stages(&settings(2)), stages(&settings(3)));
    assert_eq!(nine.difference(&four).collect::<Vec<_>>(), [&"subdivide_middles"]);
}

/// Two dimensions are other parameters, not other code; periodic axes are not in the iterations.
/// Modules of `constrain_density` and buffers for momentum that a scene brings.
fn momentum(settings: &[&str]) -> (Vec<&'static str>, Vec<String>) {
    let plan = plan(&[settings, &["outputs.images=0"]].concat());
    let modules = modules(&plan).into_iter().filter(|name| name.starts_with("ConstrainDensity")).collect();
    let is_momentum = |label: &String| label.starts_with("pbf_iteration") || label == "lambda_totals";
    (modules, buffers(&plan).into_iter().filter(is_momentum).collect())
}

#[test]
fn an_acceleration_that_is_off_or_has_nothing_to_do_brings_no_code_and_no_buffer() {
    let plain = (vec!["ConstrainDensity+WALLS"], vec![]);
    let momentum = |settings: &[&str]| momentum(&[settings, &["solver.pbf.coarse_correction=false"]].concat());
    let chebyshev = "solver.pbf.acceleration=chebyshev";
    assert_eq!(momentum(&["solver.pbf.acceleration=none"]), plain);
    for nothing_to_do in ["solver.pbf.iterations=0", "solver.pbf.iterations=1"] {
        let (modules, buffers) = momentum(&[chebyshev, nothing_to_do]);
        assert!(modules.iter().all(|module| plain.0.contains(module)) && buffers.is_empty(), "{modules:?} {buffers:?}");
    }
    let four: Vec<String> = (0..4).map(|n| format!("pbf_iteration_{n}")).collect();
    assert_eq!(momentum(&[chebyshev]), (vec!["ConstrainDensity+WALLS+MOMENTUM"], four));
    // The sum of lambdas has room beside them, but for packed ones.
    let six: Vec<String> = (0..6).map(|n| format!("pbf_iteration_{n}")).collect();
    let many = "solver.pbf.iterations=6";
    assert_eq!(momentum(&[chebyshev, many]), (vec!["ConstrainDensity+WALLS+ACCUMULATED_MOMENTUM"], six.clone()));
    let (modules, buffers) = momentum(&[chebyshev, many, "solver.precision=relaxed"]);
    assert_eq!(modules, ["ConstrainDensity+WALLS+ACCUMULATED_MOMENTUM+RELAXED_PRECISION"]);
    assert_eq!(buffers, [&["lambda_totals".to_owned()][..], &six].concat());
}

#[test]
fn a_coarse_correction_brings_a_few_small_passes_whose_number_does_not_depend_on_the_sweeps() {
    let settings = |more: &[&str]| plan(&[&["outputs.images=0"][..], more].concat());
    let (off, on) =
        (settings(&["solver.pbf.coarse_correction=false"]), settings(&["solver.pbf.coarse_correction=true"]));
    assert_eq!(stages(&settings(&[])), stages(&on), "the default has it");
    let too_few = settings(&["solver.pbf.iterations=1"]);
    assert!(!stages(&too_few).contains("relax_multiplier"), "iterations without momentum do without");
    // What is full has no surface, what is thin nothing but walls, and of what is huge the cells do not fit.
    let full = ["fluid.0.block.max_m.1=0.5"];
    let thin = ["domain.max_m.2=0.3", "fluid.0.block.max_m.2=0.3"];
    let huge = ["domain.max_m=[60, 60, 60]"];
    for none in [&full[..], &thin, &huge] {
        assert!(!stages(&settings(none)).contains("relax_multiplier"), "{none:?}");
    }
    let brought: BTreeSet<_> = stages(&on).difference(&stages(&off)).copied().collect();
    // The pool is a single tile of the coarse grid.
    assert_eq!(brought, ["relax_multiplier", "prolong_multiplier"].into_iter().collect());
    let fallen: BTreeSet<_> = buffers(&on).difference(&buffers(&off)).cloned().collect();
    assert_eq!(
        fallen,
        ["coarse_grid_0", "coarse_cells_0", "coarse_multipliers_0"].map(str::to_owned).into_iter().collect()
    );
    assert!(modules(&on).contains("ConstrainDensity+WALLS+RESTRICTED_MOMENTUM"));
    assert!(!modules(&off).iter().any(|module| module.contains("RESTRICTED")));
    // Twice as many cells along an axis are two dispatches more.
    let count = |plan: &Plan, stage| plan.passes().iter().filter(|p| p.stage == stage).map(|p| p.count).sum::<u32>();
    let large = settings(&["solver.pbf.coarse_correction=true", "domain.max_m=[12.8, 0.5, 0.5]"]);
    let passes = ["coarsen_constraint", "relax_multiplier", "prolong_multiplier"].map(|stage| count(&large, stage));
    assert_eq!(passes, [2, 3, 1]);
}

#[test]
fn a_warm_start_brings_two_passes_and_a_buffer() {
    let settings = |more: &[&str]| plan(&[&["outputs.images=0"][..], more].concat());
    for coarse in ["solver.pbf.coarse_correction=false", "solver.pbf.coarse_correction=true"] {
        let (off, on) = (settings(&[coarse]), settings(&[coarse, "solver.pbf.warm_start=0.3"]));
        let brought: BTreeSet<_> = stages(&on).difference(&stages(&off)).copied().collect();
        assert_eq!(brought, ["start_warm", "keep_pressure"].into_iter().collect());
        let new: BTreeSet<_> = buffers(&on).difference(&buffers(&off)).cloned().collect();
        assert_eq!(new, BTreeSet::from(["warm_starts".to_owned()]));
    }
}

#[test]
fn domains_of_other_shapes_bring_no_code_but_that_of_periodic_axes() {
    let settings = |domain: &str| plan(&[&format!("domain={{ min_m = [0, 0, 0], max_m = [0.8, 0.8, 0.8]{domain} }}")]);
    let solid = settings("");
    assert!(!modules(&solid).iter().any(|module| module.contains("PERIODIC")));
    assert_eq!(modules(&settings(", dimensions = 2")), modules(&solid));
    let periodic = settings(", periodic = [true, true, false]");
    let named: BTreeSet<&str> =
        periodic.passes().iter().filter(|pass| pass.module.name.contains("PERIODIC")).map(|pass| pass.stage).collect();
    let expected = ["predict", "count_cells", "list_neighbours", "update_velocity", "measure_particles"];
    assert_eq!(named, expected.into_iter().collect());
    // Of walls along periodic axes only, nothing is left.
    let open = settings(", periodic = [true, true, true]");
    assert!(!modules(&open).iter().any(|module| module.contains("WALLS")));
}

/// A term that is off is not in the shader either.
#[test]
fn a_variant_without_a_term_has_less_code() {
    let code = |term: &str, on: bool| {
        brooklet_kernels::modules()
            .filter(|module| module.name.starts_with("CorrectPositions") && !module.name.contains("NARROW"))
            .filter(|module| module.name.contains(term) == on)
            .map(|module| module.spirv.len())
            .min()
            .unwrap()
    };
    for term in ["S_CORR", "WALLS"] {
        assert!(code(term, false) < code(term, true), "{term}");
    }
}

#[test]
fn without_times_no_query_is_made_and_nothing_is_allocated_for_them() {
    let options = |timing| GpuOptions {
        device_name: Some(gpu().info().name.clone()),
        tier: Some(gpu().tier()),
        timing,
        ..GpuOptions::default()
    };
    let everything = ["outputs.images=1", "outputs.measure_every_steps=1"];
    let [off, on] = [false, true].map(|timing| count_on(&Gpu::open(&options(timing)).unwrap(), plan(&everything)));
    assert_eq!((off.timestamps, off.ring_allocations), (0, 0), "no query set, no buffer to resolve it to");
    assert!(off.timed_stages.is_empty());
    assert_eq!((off.dispatches, off.allocations), (on.dispatches, on.allocations), "timing changes nothing else");
    if gpu().timing() != TimingStatus::Unsupported {
        assert!(on.timestamps > on.dispatches && on.ring_allocations >= 2);
        let bound: u64 = plan(&everything).recordings().map(|name| plan(&everything).timestamp_bound(name)).sum();
        assert!(on.timestamps <= bound, "{} timestamps where the plan says {bound} at most", on.timestamps);
    }
}

/// What `brooklet plan` and the list of what is left out use: a plan of so many particles, without them.
#[test]
fn a_plan_of_a_number_of_particles_is_that_of_the_particles() {
    let settings = ["outputs.images=0", "forces.vorticity_m_s=0.1"];
    let made = plan(&settings);
    let scene = scene(&settings);
    let particles = scene.particle_count() as u32;
    let mut resources = Resources::new();
    let recorded = record_count(&mut resources, &scene, particles);
    let wanted = recorded.measure_id();
    let counted = Plan::sweep(resources, recorded.recordings(), wanted.as_slice()).unwrap();
    assert_eq!(counted.buffers(), made.buffers());
    assert_eq!(counted.left_out(), made.left_out());
    let passes = |plan: &Plan| -> Vec<_> {
        plan.passes().iter().map(|pass| (pass.recording, pass.module.name, pass.count)).collect()
    };
    assert_eq!(passes(&counted), passes(&made));
}

#[test]
fn a_session_whose_reports_nobody_takes_keeps_few() {
    let mut session = Session::new(&gpu(), &scene(&["solver.pbf.iterations=1"])).unwrap();
    session.measure().unwrap();
    for _ in 0..200 {
        session.step().unwrap();
    }
    let kept = session.finish().unwrap().len();
    assert!((1..=64).contains(&kept), "{kept} reports");
    assert!(session.stats().is_some(), "the measurement that came with one of the others is kept");
}
