//! Particles that do not interact, as a scene: what their plan has, where they go, and how they end.

use brooklet_fluid::particles::{ParticleSet, fluid_of, id_of, is_simulated, sample_lattice};
use brooklet_fluid::{Scene, Session, record};
use brooklet_gpu::{Plan, Resources};
use brooklet_kernels::INACTIVE_FLUID;
use brooklet_tests::compare::{ROUNDING, Worst, vector};
use brooklet_tests::gpu;
use brooklet_tests::twin::twin;

fn scene(settings: &[&str]) -> Scene {
    let settings: Vec<String> = ["spacing_m=0.02"].iter().chain(settings).map(|&s| s.into()).collect();
    Scene::load("sparks", &settings).unwrap()
}

#[test]
fn its_plan_has_no_grid_no_lists_and_no_densities() {
    let mut resources = Resources::new();
    let recorded = record(&mut resources, &scene(&[]));
    assert!(recorded.neighbours.is_none() && recorded.densities.is_none());
    let plan = Plan::sweep(resources, recorded.recordings(), recorded.measure_id().as_slice()).unwrap();
    let stages: Vec<&str> = plan.passes().iter().map(|pass| pass.stage).collect();
    assert_eq!(stages, ["begin_substep", "integrate_particles", "measure_particles", "measure_totals"]);
    let modules: Vec<&str> = plan.passes().iter().map(|pass| pass.module.name).collect();
    assert_eq!(modules[2], "MeasureParticles", "the variant without densities");
    let labels: Vec<String> = plan.buffers().into_iter().map(|buffer| buffer.label).collect();
    for absent in ["cell_starts", "neighbours", "list_heads", "smoothing_kernel_params", "pbf_params", "force_params"] {
        assert!(!labels.iter().any(|label| label == absent), "{absent} in {labels:?}");
    }
}

#[test]
fn sparks_fly_as_their_twins() {
    let scene = scene(&[]);
    let start = sample_lattice(&scene);
    let mut fluid = twin(&scene, &start.positions, &start.velocities);
    let mut session = Session::new(&gpu(), &scene).unwrap();
    const STEPS: u32 = 120;
    for _ in 0..STEPS {
        session.step().unwrap();
        fluid.substep();
    }
    let ParticleSet { positions, velocities } = session.read_particles().unwrap();
    // Roundings of each step add up, and a bounce one step later shows as the way of a step.
    let size_m = vector(scene.domain.size_m().map(|x| x as f32)).length();
    let mut worst = Worst::new("sparks after 120 steps", f64::from(STEPS) * 4.0 * ROUNDING);
    let (mut compared, mut ended) = (0, 0);
    for (position, velocity) in positions.iter().zip(&velocities) {
        let expected = &fluid.particles[id_of(position.tag) as usize];
        assert_eq!(is_simulated(position.tag), expected.is_simulated());
        if !expected.is_simulated() {
            assert_eq!(fluid_of(position.tag), INACTIVE_FLUID);
            ended += 1;
            continue;
        }
        let off = (vector(velocity.velocity_m_s) - expected.velocity_m_s).length();
        if off < 1e-3 {
            worst.check3(position.position_m, expected.position_m, size_m).unwrap();
            compared += 1;
        }
    }
    println!("{compared} of {} compared, {ended} ended", positions.len());
    assert!(compared + ended >= positions.len() - positions.len() / 50, "{compared} compared, {ended} ended");
    assert!(compared > 50 && ended > 1);
}

#[test]
fn all_sparks_go_out_and_their_energy_only_falls() {
    let scene = scene(&["gravity_m_s2=[0,0,0]", "solver.none.lifetime_s=0.5"]);
    let mut session = Session::new(&gpu(), &scene).unwrap();
    let mut energies = Vec::new();
    let mut counts = Vec::new();
    for _ in 0..14 {
        session.measure().unwrap();
        session.finish().unwrap();
        let stats = session.stats().unwrap();
        assert!(!stats.has_density && stats.density_error.max == 0.0 && stats.quarantined == 0);
        energies.push(stats.kinetic_j);
        counts.push(stats.particles);
        for _ in 0..10 {
            session.step().unwrap();
        }
    }
    assert_eq!(counts[0] as usize, sample_lattice(&scene).positions.len());
    assert!(counts.is_sorted_by(|a, b| a >= b) && counts[5] < counts[0], "{counts:?}");
    assert!(energies.is_sorted_by(|a, b| a >= b) && energies[1] < energies[0], "{energies:?}");
    assert_eq!((*counts.last().unwrap(), *energies.last().unwrap()), (0, 0.0));
}

#[test]
fn what_others_have_is_refused_with_its_name() {
    let message = |setting: &str| Scene::load("sparks", &[setting.into()]).unwrap_err().to_string();
    for (setting, words) in [
        ("solver.pbf.iterations=4", "solver.pbf.iterations = 4: not with solver.method = \"none\""),
        ("forces.xsph=0.1", "forces.xsph = 0.1: not with solver.method = \"none\"; methods that have it: pbf"),
        ("solver.neighbour_slots=8", "solver.neighbour_slots = 8: not with"),
        ("surface.color_by=density", "particles that do not interact have no density"),
        ("solver.none.restitution=1.5", "solver.none.restitution = 1.5: must be a number from 0 to 1"),
    ] {
        assert!(message(setting).contains(words), "{setting}: {}", message(setting));
    }
    let other = Scene::load("dam-break", &["solver.none.drag_per_s=1".into()]).unwrap_err().to_string();
    assert!(other.contains("not with solver.method = \"pbf\"; methods that have it: none"), "{other}");
}
