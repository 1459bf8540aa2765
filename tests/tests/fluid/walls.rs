//! Walls that drag: channels against their closed forms, friction against its own; walls by distance, penalty or deflection
//! against their twins and at rest; and what a plan has of them.

use std::iter::zip;

use brooklet_fluid::particles::{id_of, sample_lattice};
use brooklet_fluid::{Scene, Session, record};
use brooklet_gpu::{Plan, Resources};
use brooklet_kernels::{DragWalls, Kernel as _, RepelWalls};
use brooklet_study::backend::{Options, run};
use brooklet_study::case::{COUETTE, Case, POISEUILLE};
use brooklet_tests::compare::vector;
use brooklet_tests::twin::twin;
use brooklet_tests::{gpu, gpu_of_long_run};
use glam::DVec3;

/// Error and fitted viscosity's error of a channel at a spacing.
fn channel(case: &dyn Case, spacing_m: f64) -> [f64; 2] {
    let setup = case.setup(&[format!("spacing_m={spacing_m}")]).unwrap();
    let options = Options { stop: &|| false, edit: None, progress: &|_| {} };
    let run = run(&gpu(), &setup, &options).unwrap();
    let figures = case.figures(&setup, &run.samples, &|_| None).unwrap();
    println!("{} at d = H/{:.0}: {figures:?}", case.name(), 1.0 / spacing_m);
    [0, 1].map(|index| figures[index].value.unwrap())
}

#[test]
fn channels_start_as_their_closed_forms() {
    for case in [COUETTE, POISEUILLE] {
        let all @ [coarse, middle, fine] = [0.2, 0.1, 0.05].map(|spacing_m| channel(&case, spacing_m));
        // Between two alone an error that changes its sign hides the order.
        assert!(middle[0] < 0.015 && fine[0] < coarse[0] / (1.8 * 1.8), "{}: {all:?}", case.name());
        assert!(fine[1].abs() < 0.05, "{}: fitted viscosity off by {}", case.name(), fine[1]);
    }
}

/// A slab that fills a box periodic along x and z, and slides.
const SLAB: &str = r#"
spacing_m = 0.05
gravity_m_s2 = [0, 0, 0]
[domain]
min_m = [0, 0, 0]
max_m = [0.4, 0.5, 0.4]
periodic = [true, false, true]
[[fluid]]
block = { min_m = [0, 0, 0], max_m = [0.4, 0.5, 0.4] }
velocity_m_s = [2, 0, 0]
[solver]
dt_s = 0.004
"#;

fn slab(settings: &[&str]) -> Scene {
    let settings: Vec<String> = settings.iter().map(|&s| s.into()).collect();
    Scene::from_toml(SLAB, "slab.toml", &settings).unwrap()
}

const ROUGH: &str = "domain.faces.y_min={ slip = \"friction\", friction = 0.2 }";

/// Whether a plan has a stage, and how many buffers of a name.
fn parts(settings: &[&str], stage: &str, buffer: &str) -> (bool, usize) {
    let mut resources = Resources::new();
    let recorded = record(&mut resources, &slab(settings));
    let plan = Plan::sweep(resources, recorded.recordings(), recorded.measure_id().as_slice()).unwrap();
    let passes = plan.passes().iter().filter(|pass| pass.stage == stage).count();
    (passes > 0, plan.buffers().iter().filter(|of| of.label == buffer).count())
}

#[test]
fn free_slip_has_no_stage_and_no_buffer() {
    let parts = |settings: &[&str]| parts(settings, DragWalls::STAGE, "wall_faces");
    for method in ["pbf", "sph"] {
        let method = format!("solver.method={method}");
        assert_eq!(parts(&[&method]), (false, 0));
        assert_eq!(parts(&[&method, "domain.faces={ y_min = {}, y_max = { slip = \"free-slip\" } }"]), (false, 0));
        assert_eq!(parts(&[&method, ROUGH]), (true, 1));
    }
}

/// The mean velocity along x after some steps.
fn sliding_m_s(scene: &Scene, steps: u32) -> f64 {
    let mut session = Session::new(&gpu_of_long_run(scene), scene).unwrap();
    for _ in 0..steps {
        session.step().unwrap();
    }
    let velocities = session.read_particles().unwrap().velocities;
    velocities.iter().map(|v| f64::from(v.velocity_m_s[0])).sum::<f64>() / velocities.len() as f64
}

#[test]
fn a_wall_takes_its_shear_stress_of_what_slides_over_it() {
    // In one substep the slab is uniform: it loses c_f/2 v² dt of its height, but for what a layer is already slower at
    // the substep's end, c_f L v dt of it, L at most 1.6/h.
    for method in ["pbf", "sph"] {
        let method = format!("solver.method={method}");
        let fixed = if method.ends_with("sph") { "solver.sph.adaptive_substeps=false" } else { "solver.substeps=1" };
        let v = 2.0;
        let dt_s = 0.0005;
        let (rough, dt) =
            ("domain.faces.y_min={ slip = \"friction\", friction = 0.02 }", format!("solver.dt_s={dt_s}"));
        let scene = slab(&[&method, rough, fixed, &dt]);
        let lost = (v - sliding_m_s(&scene, 1)) * scene.domain.size_m()[1];
        let expected = 0.5 * 0.02 * v * v * dt_s;
        println!("{method}: lost {lost:.4e} m²/s of {expected:.4e}");
        assert!((lost / expected - 1.0).abs() < 0.01, "{method}: {lost} and {expected}");
        let smooth = slab(&[&method, fixed, &dt]);
        assert!((v - sliding_m_s(&smooth, 1)).abs() < 1e-6, "{method}: nothing is lost without");
    }
}

#[test]
fn a_moving_wall_takes_the_fluid_along() {
    let lid = "domain.faces.y_max={ slip = \"friction\", friction = 0.5, velocity_m_s = [2, 0, 3] }";
    let mut session = Session::new(&gpu(), &slab(&[lid, "fluid.0.velocity_m_s=[2,0,0]"])).unwrap();
    for _ in 0..20 {
        session.step().unwrap();
    }
    let after = session.read_particles().unwrap();
    let (mut upper, mut lower) = ([0.0; 2], 0.0_f64);
    for (position, velocity) in after.positions.iter().zip(&after.velocities) {
        let v = vector(velocity.velocity_m_s);
        if position.position_m[1] > 0.45 {
            upper = [upper[0] + v.z, upper[1] + 1.0];
        } else if position.position_m[1] < 0.25 {
            lower = lower.max(v.z.abs());
        }
    }
    let upper = upper[0] / upper[1];
    assert!(upper > 0.5 && lower < 0.1 * upper, "under the lid {upper} m/s, below {lower}");
}

#[test]
fn walls_that_do_not_repel_have_no_stage_and_no_buffer() {
    let parts = |settings: &[&str]| parts(settings, RepelWalls::STAGE, "repel_params");
    for method in ["pbf", "sph"] {
        let method = format!("solver.method={method}");
        assert_eq!(parts(&[&method]), (false, 0));
        assert_eq!(parts(&[&method, "domain.wall.model=pressure"]), (false, 0));
        assert_eq!(parts(&[&method, "domain.wall.model=distance"]), (false, 0));
        assert_eq!(parts(&[&method, "domain.wall.model=penalty"]), (true, 1));
    }
}

#[test]
fn a_slab_that_falls_on_walls_which_repel_is_its_twins() {
    let models = ["penalty", "deflection"].map(|model| format!("domain.wall.model={model}"));
    // Substeps of the GPU's choice would be one more or less where a rounding decides, and a contact's first differs by that.
    let all = ["solver={ method = \"pbf\" }", "solver={ method = \"sph\", sph = { adaptive_substeps = false } }"];
    let steps = ["solver.dt_s=0.004", "solver.dt_s=0.0005"];
    for ((method, dt), model) in zip(all, steps).flat_map(|method| models.iter().map(move |model| (method, model))) {
        let scene = slab(&[
            method,
            dt,
            model,
            "gravity_m_s2=[0,-9.81,0]",
            "fluid.0.velocity_m_s=[0.5,-1,0]",
            // They come to the wall in the first substep, between its ends.
            "fluid.0.block={ min_m = [0, 0.0003, 0], max_m = [0.4, 0.4503, 0.4] }",
        ]);
        // Few, before the layers above are pressed together: quantized distances then err alike in each pair of a layer.
        let (off_m_s, _) = from_twin(&scene, 4);
        println!("{method}, {model}: {off_m_s:.1e} m/s from the twin");
        assert!(off_m_s < 1e-3, "{method}, {model}: {off_m_s}");
    }
}

#[test]
fn a_pool_rests_at_its_walls_by_distance_as_by_pressure() {
    for method in ["pbf", "sph"] {
        let pool = Scene::from_toml(
            "spacing_m = 0.02\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [0.12, 0.2, 0.12]\n\
             [[fluid]]\nblock = { min_m = [0, 0, 0], max_m = [0.12, 0.12, 0.12] }\n",
            "pool",
            &[format!("solver.method={method}"), "domain.wall.model=distance".into()],
        )
        .unwrap();
        let mut session = Session::new(&gpu_of_long_run(&pool), &pool).unwrap();
        for _ in 0..120 {
            session.step().unwrap();
        }
        let after = session.read_particles().unwrap();
        let nearest = |axis: usize| {
            after.positions.iter().map(|at| f64::from(at.position_m[axis]) / pool.spacing_m).fold(9.0, f64::min)
        };
        let middle = after.positions.iter().map(|at| f64::from(at.position_m[1])).sum::<f64>() / 216.0 / 0.06;
        println!("{method}: {:?} d from walls, middle at {middle} of the lattice's", [0, 1, 2].map(nearest));
        // Where the lattice stood, but for what gravity moves in a substep; a wall nobody counts would take 15 %.
        assert!((0..3).all(|axis| nearest(axis) > 0.45), "{method}");
        assert!((middle - 1.0).abs() < 0.03, "{method}: {middle}");
    }
}

/// How far a slab's velocities are from its twin's after some steps at most, and its slowest along x there, m/s.
fn from_twin(scene: &Scene, steps: u32) -> (f64, f64) {
    let start = sample_lattice(scene);
    let mut fluid = twin(scene, &start.positions, &start.velocities);
    let mut session = Session::new(&gpu(), scene).unwrap();
    for _ in 0..steps {
        session.step().unwrap();
        for _ in 0..scene.substeps() {
            fluid.substep();
        }
    }
    let got = session.read_particles().unwrap();
    let mut off_m_s = 0.0_f64;
    for (position, velocity) in got.positions.iter().zip(&got.velocities) {
        let expected: DVec3 = fluid.particles[id_of(position.tag) as usize].velocity_m_s;
        off_m_s = off_m_s.max((vector(velocity.velocity_m_s) - expected).length());
    }
    (off_m_s, fluid.particles.iter().map(|p| p.velocity_m_s.x).fold(2.0, f64::min))
}

#[test]
fn a_slab_over_walls_is_its_twins() {
    for settings in [
        &["solver.method=pbf", ROUGH, "gravity_m_s2=[0,-9.81,0]"][..],
        &["solver.method=sph", "domain.faces.y_min.slip=no-slip", "gravity_m_s2=[0,-9.81,0]"],
    ] {
        let scene = slab(settings);
        let (off_m_s, slowest) = from_twin(&scene, 10);
        println!("{settings:?}: {off_m_s:.1e} m/s from the twin, the slowest at {slowest}");
        assert!(off_m_s < 1e-3 && slowest < 1.95, "{off_m_s}, {slowest}");
    }
}
