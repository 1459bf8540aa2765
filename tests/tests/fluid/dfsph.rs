//! Divergence-free SPH as scenes: what its plan has, what it keeps, how it rests and how often its solves iterate for that.

use brooklet_fluid::particles::id_of;
use brooklet_fluid::{Scene, Session, Stats, record};
use brooklet_gpu::{Plan, Resources};
use brooklet_reference::boundary::mirror::Mirrors;
use brooklet_reference::boundary::sample_boundary;
use brooklet_reference::shared::wendland;
use brooklet_reference::solver::Solver;
use brooklet_reference::step::Fluid;
use brooklet_tests::compare::vector;
use brooklet_tests::extreme::Case;
use brooklet_tests::twin::twin;
use brooklet_tests::{gpu, gpu_of_long_run};
use glam::DVec3;

/// A pool that fills a box of .4 x .8 x .4 m up to .5 m.
const POOL: &str = "
spacing_m = 0.05
[domain]
min_m = [0, 0, 0]
max_m = [0.4, 0.8, 0.4]
[[fluid]]
block = { min_m = [0, 0, 0], max_m = [0.4, 0.5, 0.4] }
[solver]
method = \"dfsph\"
dt_s = 0.002
";

fn from_text(text: &str, settings: &[&str]) -> Scene {
    let settings: Vec<String> = settings.iter().map(|&s| s.into()).collect();
    Scene::from_toml(text, "dfsph.toml", &settings).unwrap()
}

fn dam_break(settings: &[&str]) -> Scene {
    let settings: Vec<String> = ["solver.method=dfsph"].iter().chain(settings).map(|&s| s.into()).collect();
    Scene::load("dam-break", &settings).unwrap()
}

/// Runs `steps` steps, measuring after every `every` of them.
fn run(session: &mut Session, steps: u32, every: u32) -> Vec<Stats> {
    let mut history = Vec::new();
    for step in 1..=steps {
        session.step().unwrap();
        if step % every == 0 {
            session.measure().unwrap();
            history.extend(session.finish().unwrap().into_iter().filter_map(|frame| frame.stats));
        }
    }
    history
}

#[test]
fn its_plan_has_its_own_stages_and_none_of_another_solver() {
    let stages = |settings: &[&str]| {
        let mut resources = Resources::new();
        let recorded = record(&mut resources, &dam_break(settings));
        let plan = Plan::sweep(resources, recorded.recordings(), recorded.measure_id().as_slice()).unwrap();
        let mut stages: Vec<&str> = plan.passes().iter().map(|pass| pass.stage).collect();
        stages.dedup();
        stages.join(" ")
    };
    let sort = "begin_substep advect count_cells reduce_groups scan_groups reorder list_neighbours";
    let one = ["spacing_m=0.05", "solver.dfsph.max_divergence_iterations=1", "solver.dfsph.max_density_iterations=1"];
    let measure = "measure_particles measure_totals";
    // Passes are listed once, where they come first.
    let solves = "apply_pressure begin_solve correct_pressure end_iteration limit_velocity shift_positions";
    let forces = "factor_pressure apply_gravity xsph";
    assert_eq!(stages(&one), format!("{sort} carry_pressure {forces} {solves} {measure}"));
    let fixed = [&one[..], &["solver.dfsph.fixed_iterations=true", "solver.dfsph.warm_start=false"]].concat();
    let solves = "correct_pressure apply_pressure limit_velocity";
    assert_eq!(stages(&fixed), format!("{sort} {forces} {solves} shift_positions {measure}"));
    // What parts particles at one point moves them without a density solve, too.
    let alone = [&fixed[..], &["solver.dfsph.max_density_iterations=0"]].concat();
    assert_eq!(stages(&alone), format!("{sort} {forces} {solves} shift_positions {measure}"));
    let deep = [&fixed[..], &["solver.dfsph.coarse_correction=true", "solver.dfsph.max_density_iterations=0"]].concat();
    let grid = "restrict_pressure relax_multiplier prolong_pressure";
    let coarse = stages(&deep).replace(" coarsen_constraint", "");
    assert_eq!(
        coarse,
        format!("{sort} {forces} correct_pressure {grid} apply_pressure limit_velocity shift_positions {measure}")
    );
}

#[test]
fn a_compressed_ball_in_free_space_keeps_its_momentum() {
    let text = "spacing_m = 0.05\ngravity_m_s2 = [0, 0, 0]\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [2, 2, 2]\nwalls = false\n\
        [[fluid]]\nsphere = { centre_m = [1, 1, 1], radius_m = 0.3 }\nvelocity_spread_m_s = [1, 1, 1]\n\
        [solver]\nmethod = \"dfsph\"\ndt_s = 0.002\n";
    let scene = from_text(text, &[]);
    let mut session = Session::new(&gpu(), &scene).unwrap();
    let history = run(&mut session, 50, 10);
    let [first, last] = [history[0], history[4]].map(|stats| DVec3::from_array(stats.momentum_kg_m_s));
    let scale = scene.particle_mass_kg() * f64::from(history[0].particles) * history[0].max_speed_m_s;
    println!("momentum {first} then {last}, {:.1e} of {scale:.3}", (last - first).length());
    assert!(history[0].counters.divergence_iterations > 0);
    assert!((last - first).length() < 1e-5 * scale, "{first} {last} of {scale}");
}

#[test]
fn a_pool_at_rest_stays_calm_and_a_warm_start_saves_its_iterations() {
    let iterations = |settings: &[&str], steps: u32| {
        let mut session = Session::new(&gpu(), &from_text(POOL, settings)).unwrap();
        let history = run(&mut session, 2 * steps, steps);
        let (stats, counters) = (history[1], history[1].counters);
        assert_eq!(counters.unsolved, 0, "{settings:?}");
        let a_step =
            [counters.divergence_iterations, counters.density_iterations].map(|n| f64::from(n) / f64::from(steps));
        println!(
            "{settings:?}: {a_step:.2?} iterations a step, {:.2e} J, fastest {:.4} m/s, compression {:.5} / {:.5}",
            stats.kinetic_j, stats.max_speed_m_s, stats.compression.mean, stats.compression.max
        );
        (a_step[0], stats)
    };
    let many = "solver.dfsph.max_divergence_iterations=200";
    let (_, stats) = iterations(&[many], 160);
    // Both in the same steps: a pool that settles takes more than one at rest.
    let (warm, _) = iterations(&[many], 20);
    let (cold, _) = iterations(&[many, "solver.dfsph.warm_start=false"], 20);
    assert!(2.0 * warm < cold, "warm {warm}, cold {cold}");
    // 80 kg that a wave of 1 cm would give .8 J.
    assert!(stats.kinetic_j < 0.05 && stats.compression.mean < 5e-3, "{stats:?}");
}

#[test]
fn a_settled_pool_stands_on_its_floor_by_pressure_alone() {
    const STEPS: usize = 800;
    let scene = from_text(POOL, &[]);
    let mut session = Session::new(&gpu_of_long_run(&scene), &scene).unwrap();
    let mut start = session.read_particles().unwrap();
    start.positions.sort_by_key(|at| id_of(at.tag));
    let mut fluid = twin(&scene, &start.positions, &start.velocities);
    let weight_n = start.positions.len() as f64 * scene.particle_mass_kg() * 9.81;
    // What the floor pushes the fluid by over its weight: its images, or what the wall-weight function would make of the same
    // pressures.
    let borne = |fluid: &Fluid| {
        let Solver::Dfsph(dfsph) = &fluid.solver else { panic!("DFSPH") };
        let lists = dfsph.neighbours(&fluid.particles, &fluid.step);
        let of = |k: usize| fluid.particles[k].multipliers[0];
        let (mut push, mut weighed) = (0.0, 0.0);
        for (i, particle) in fluid.particles.iter().enumerate() {
            let mirrors = Mirrors::at(particle.position_m, fluid.walls.as_ref());
            for image in mirrors.images().filter(|image| image.flipped.y && mirrors.from_walls.y > 0.0) {
                for &j in lists[i].iter().chain([&i]) {
                    let offset = dfsph.smoothing.offset(particle.position_m, fluid.particles[j].position_m);
                    let slope = wendland::gradient(mirrors.offset(offset, image)) * dfsph.smoothing.weight;
                    push -= (of(i) + of(j)) * slope.y;
                }
            }
            let is_low = particle.position_m.y < 0.5 * fluid.step.domain_size_m.y;
            let gradient = sample_boundary(particle.position_m, fluid.walls.as_ref()).gradient;
            weighed -= if is_low { 2.0 * of(i) * gradient.y } else { 0.0 };
        }
        let step_s = fluid.step.dt_s;
        [push, weighed]
            .map(|push| push * scene.particle_mass_kg() * dfsph.smoothing.support_m / (step_s * step_s) / weight_n)
    };
    let mut sums = [0.0; 2];
    for step in 0..STEPS {
        fluid.substep();
        if step >= STEPS / 2 {
            sums.iter_mut().zip(borne(&fluid)).for_each(|(sum, share)| *sum += share);
        }
    }
    let [share, weighed] = sums.map(|sum| sum / (STEPS - STEPS / 2) as f64);
    println!("the floor bears {share:.5} of the weight; by the wall-weight function {weighed:.3}");
    // A public closed-form wall integral reaches .2 % (genesis-world, PR 2857).
    assert!((share - 1.0).abs() < 2e-3, "{share}");
    assert!(weighed < 0.9, "{weighed}");
}

#[test]
fn a_start_that_is_squashed_flies_apart_no_faster_than_it_falls() {
    // A tenth too dense, which as pressure would fling particles at tens of m/s.
    let text = POOL.replace("spacing_m = 0.05", "spacing_m = 0.05\ngravity_m_s2 = [0, 0, 0]");
    let squashed = |settings: &[&str]| {
        let mut case = Case::of(&from_text(&text, settings));
        case.place(|_, position, _| position[1] *= 0.9);
        case.run(50)
    };
    let stats = squashed(&[]);
    println!("{:.2e} J, compression {:?}", stats.kinetic_j, stats.compression);
    assert!(stats.kinetic_j < 1e-3 && stats.compression.mean < 5e-3, "{stats:?}");
    // Nothing else takes it out.
    let left = squashed(&["solver.dfsph.max_density_iterations=0"]);
    assert!(left.compression.mean > 0.03, "{left:?}");
}

#[test]
fn a_small_dam_break_goes_as_its_twin() {
    // A fixed number of iterations: where rounding decides over one more, both go on otherwise.
    let fixed = ["fixed_iterations=true", "max_divergence_iterations=8", "max_density_iterations=2"];
    let fixed = fixed.map(|setting| format!("solver.dfsph.{setting}"));
    let settings: Vec<&str> = ["spacing_m=0.1"].into_iter().chain(fixed.iter().map(String::as_str)).collect();
    let scene = dam_break(&settings);
    let mut session = Session::new(&gpu(), &scene).unwrap();
    let mut start = session.read_particles().unwrap();
    start.positions.sort_by_key(|at| id_of(at.tag));
    let mut fluid = twin(&scene, &start.positions, &start.velocities);
    for _ in 0..20 {
        session.step().unwrap();
        fluid.substep();
    }
    let particles = session.read_particles().unwrap();
    let mean = particles
        .positions
        .iter()
        .map(|at| (vector(at.position_m) - fluid.particles[id_of(at.tag) as usize].position_m).length());
    let mean_m = mean.sum::<f64>() / particles.positions.len() as f64;
    println!("off by {mean_m:.2e} m");
    assert!(mean_m < 0.01 * scene.spacing_m, "{mean_m}");
}

#[test]
fn what_is_not_finite_is_parked_and_the_others_go_on() {
    let mut case = Case::of(&from_text(POOL, &[]));
    case.place(|i, position, velocity| match i {
        7 => position[0] = f32::NAN,
        11 => velocity[1] = f32::INFINITY,
        _ => {}
    });
    let stats = case.run(100);
    assert_eq!(stats.quarantined, 2);
    assert!(stats.max_speed_m_s < 1.0 && stats.compression.mean < 0.01, "{stats:?}");
}

#[test]
fn every_form_of_it_runs() {
    let flat = "domain.dimensions=2";
    for settings in [
        &["solver.precision=relaxed"][..],
        &["capacity=1000"],
        &["solver.deterministic=true"],
        &["forces.xsph=0.05", "forces.vorticity_m_s=0.01"],
        &["domain.periodic=[true, false, false]"],
        &[flat],
        &[
            "solver.dfsph.fixed_iterations=true",
            "solver.dfsph.max_divergence_iterations=4",
            "solver.dfsph.max_density_iterations=1",
        ],
        &["solver.substeps=2"],
    ] {
        let mut session = Session::new(&gpu(), &from_text(POOL, settings)).unwrap();
        let stats = run(&mut session, 60, 60)[0];
        println!("{settings:?}: {:.4} m/s, compression {:.5}", stats.max_speed_m_s, stats.compression.mean);
        assert!(stats.max_speed_m_s < 0.5 && stats.compression.mean < 0.01, "{settings:?}: {stats:?}");
        assert_eq!((stats.quarantined, stats.escaped), (0, 0));
    }
}

#[test]
fn iterations_that_are_too_few_are_said() {
    let mut session = Session::new(&gpu(), &from_text(POOL, &["solver.dfsph.max_divergence_iterations=1"])).unwrap();
    let counters = run(&mut session, 20, 20)[0].counters;
    assert!(counters.unsolved > 0 && counters.divergence_iterations <= 20, "{counters:?}");
    let message = |setting: &str| {
        let settings = [setting.to_owned()];
        Scene::from_toml(POOL, "dfsph.toml", &settings).unwrap_err().to_string()
    };
    for (setting, words) in [
        (
            "solver.dfsph.max_divergence_iterations=0",
            "solver.dfsph.max_divergence_iterations = 0: must be a whole number from 1",
        ),
        ("solver.dfsph.momentum=1", "solver.dfsph.momentum = 1"),
        ("solver.pbf.iterations=4", "not with solver.method = \"dfsph\""),
    ] {
        assert!(message(setting).contains(words), "{setting}: {}", message(setting));
    }
}

/// A column of so many layers, eight particles wide, between periodic ends.
fn column(layers: u32) -> String {
    let height_m = 0.02 * f64::from(layers);
    format!(
        "spacing_m = 0.02\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [0.16, {:?}, 0.02]\nperiodic = [true, false, false]\n\
         dimensions = 2\n[[fluid]]\nblock = {{ min_m = [0, 0, 0], max_m = [0.16, {height_m:?}, 0.02] }}\n\
         [solver]\nmethod = \"dfsph\"\ndt_s = 0.002\n",
        height_m + 0.4
    )
}

#[test]
fn a_deep_column_stands_by_its_coarse_grid_and_short_substeps() {
    let scene = from_text(&column(160), &[]);
    assert_eq!(scene.substeps(), 2);
    // As deep as the scene's own, and no more than is asked for.
    assert_eq!(from_text(&column(20), &[]).substeps(), 1);
    assert_eq!(from_text(&column(20), &["solver.substeps=3"]).substeps(), 3);
    assert_eq!(from_text(&column(20), &["solver.dt_s=0.018"]).substeps(), 4);
    assert_eq!(from_text(&column(160), &["gravity_m_s2=[0,0,0]"]).substeps(), 1);
    let stands = |settings: &[&str]| {
        let mut session = Session::new(&gpu(), &from_text(&column(160), settings)).unwrap();
        let history = run(&mut session, 150, 10);
        let fastest_m_s = history.iter().map(|stats| stats.max_speed_m_s).fold(0.0, f64::max);
        let stats = history[history.len() - 1];
        println!("{settings:?}: fastest {fastest_m_s:.3} m/s, {:?}, {:?}", stats.compression, stats.counters);
        (fastest_m_s, stats.compression.p99)
    };
    let (fastest_m_s, p99) = stands(&[]);
    assert!(fastest_m_s < 0.3 && p99 < 0.02, "{fastest_m_s} m/s, {p99}");
    let (fastest_m_s, _) = stands(&["solver.dfsph.coarse_correction=false"]);
    assert!(fastest_m_s > 0.6, "{fastest_m_s} m/s without the grid");
}

#[test]
fn a_coarse_grid_that_cannot_be_is_refused() {
    let settings = ["solver.method=dfsph", "solver.dfsph.coarse_correction=true"].map(String::from);
    let error = Scene::from_toml(&POOL.replace("0.4, 0.8, 0.4", "0.4, 0.8, 0.1"), "dfsph.toml", &settings).unwrap_err();
    assert!(error.to_string().contains("the domain is narrower along z than a cell of 2 h"), "{error}");
}

#[test]
fn particles_at_one_point_part_and_come_to_rest() {
    for count in [2_usize, 64] {
        let side_m = 0.02 * (count as f64).cbrt().ceil();
        let text = format!(
            "spacing_m = 0.02\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [0.3, 0.3, 0.3]\n\
             [[fluid]]\nblock = {{ min_m = [0, 0, 0], max_m = [{side_m:?}, {:?}, {:?}] }}\n\
             [solver]\nmethod = \"dfsph\"\n[outputs]\nmeasure_every_steps = 1\n",
            if count == 2 { 0.02 } else { side_m },
            if count == 2 { 0.02 } else { side_m },
        );
        let mut case = Case::of(&from_text(&text, &[]));
        assert_eq!(case.count(), count);
        case.place(|_, position, _| *position = [0.15, 0.1, 0.15]);
        let stats = case.run(240);
        let mut nearest_m = case.state().nearest_m();
        nearest_m.sort_by(f64::total_cmp);
        println!(
            "{count}: nearest {:.2} d, {:.3} m/s, {:?}",
            nearest_m[0] / 0.02,
            stats.max_speed_m_s,
            stats.compression
        );
        assert!(nearest_m[0] > 0.2 * 0.02 && stats.max_speed_m_s < 0.63, "{nearest_m:?} {stats:?}");
        assert_eq!(stats.quarantined, 0);
    }
}
