//! Domains for closed forms: periodic along an axis, of two dimensions, open. What must hold of any fluid
//! in them.

use brooklet_fluid::solver::pbf::IterationWeights;
use brooklet_fluid::{Scene, grid};
use brooklet_reference::column::Column;
use brooklet_reference::params::nearest_image;
use brooklet_tests::extreme::Case;
use brooklet_tests::rng;
use glam::DVec3;
use rand::RngExt;

const SPACING_M: f64 = 0.02;

/// A domain of so many spacings, filled with fluid from below to `layers`, without gravity.
fn filled(spacings: [u32; 3], layers: u32, domain: &str) -> String {
    let [x, y, z] = spacings.map(|n| f64::from(n) * SPACING_M);
    let top = f64::from(layers) * SPACING_M;
    format!(
        "spacing_m = {SPACING_M}\ngravity_m_s2 = [0, 0, 0]\n[domain]\nmin_m = [-1, 2, 5]\n\
         max_m = [{}, {}, {}]\n{domain}\n[[fluid]]\nblock = {{ min_m = [-1, 2, 5], max_m = [{}, {}, {}] }}\n\
         [outputs]\nmeasure_every_steps = 1\n",
        x - 1.0,
        y + 2.0,
        z + 5.0,
        x - 1.0,
        top + 2.0,
        z + 5.0
    )
}

const BOX: &str = "periodic = [true, true, true]";
const SHEET: &str = "periodic = [true, true, false]\ndimensions = 2";

#[test]
fn a_periodic_lattice_has_density_one_and_stays_at_rest() {
    // A place's step a step: what a density above 1 by its rounding may ask for, and each is undone by the next. With
    // 28 neighbours and momentum a dozen of them are measured, and in 10 s slowly more.
    let tolerance_m_s = 40.0 * 1.9e-6 * 2.0 * SPACING_M * 240.0;
    for (name, text, count) in [
        ("box", filled([8, 16, 8], 16, BOX), 1024),
        ("sheet", filled([16, 24, 1], 24, SHEET), 384),
        ("sheet, h = 3 d", filled([24, 24, 1], 24, &format!("{SHEET}\n[solver]\nsupport_ratio = 3.0")), 576),
    ] {
        let mut case = Case::new(&text, &[]);
        assert_eq!(case.count(), count);
        let start = case.state();
        let stats = case.run(60);
        println!("{name}: density off by {:.1e}, {:.1e} m/s", stats.density_error.max, stats.max_speed_m_s);
        // Sums of some thirty terms, of places a rounding off.
        assert!(stats.density_error.max < 1e-4, "{name}: {}", stats.density_error.max);
        assert!(stats.max_speed_m_s < tolerance_m_s, "{name}: {} m/s", stats.max_speed_m_s);
        let after = case.state();
        let far = start.at_m().iter().zip(after.at_m()).map(|(a, b)| (*a - b).length()).fold(0.0, f64::max);
        assert!(far < 5e-3 * SPACING_M, "{name}: {far} m");
    }
    // With the faces open instead, the same particles have neighbours on one side only.
    let open = filled([8, 16, 8], 16, "walls = false");
    let stats = Case::new(&open, &[]).run(1);
    assert!(stats.density_error.max > 0.3, "{}", stats.density_error.max);
}

/// How far the particles of two runs are apart once those of the second are moved back by `shift_m`: the mean,
/// and the largest distance from it, m.
fn apart(still: &mut Case, moving: &mut Case, shift_m: DVec3) -> (DVec3, f64) {
    let period_m = DVec3::from_array(still.scene().period_m());
    let (a, b) = (still.state().at_m(), moving.state().at_m());
    let apart: Vec<DVec3> = a.iter().zip(&b).map(|(a, b)| nearest_image(*b - *a - shift_m, period_m)).collect();
    let mean = apart.iter().sum::<DVec3>() / apart.len() as f64;
    (mean, apart.iter().map(|d| (*d - mean).length()).fold(0.0, f64::max))
}

#[test]
fn a_seam_is_nowhere() {
    // At rest, and as fast as half a support a step, over several sides: a full lattice for long, and a
    // squeezed drop for as long as its expansion does not yet multiply roundings by more than some hundred.
    // Moving, positions round anew each step, and a correction by one step of a place is 1.8e-5 m/s: some
    // of them, kept for a second, are 1e-4 m.
    for (dimensions, side, velocity) in [(3, [16, 16, 16], [4.0, -1.7, 2.2]), (2, [32, 16, 1], [4.0, -2.4, 0.0])] {
        let text = filled(side, side[1], if dimensions == 3 { BOX } else { SHEET });
        for (name, size, steps, tolerance) in [("lattice", 1.0, 240, 1e-2), ("drop", 0.97, 20, 2e-3)] {
            let start = |velocity_m_s: [f64; 3]| {
                // The cells of a coarse correction stay where they are: it is not the same for what is shifted.
                let settings =
                    ["solver.deterministic=true", "solver.max_speed_m_s=20", "solver.pbf.coarse_correction=false"];
                let mut case = Case::new(&text, &settings);
                let middle = case.state().at_m().iter().sum::<DVec3>() / case.count() as f64;
                case.place(|_, position, velocity| {
                    *velocity = velocity_m_s.map(|v| v as f32);
                    for (axis, x) in position.iter_mut().enumerate().take(dimensions) {
                        *x = (middle[axis] + size * (f64::from(*x) - middle[axis])) as f32;
                    }
                });
                case
            };
            let (mut still, mut moving) = (start([0.0; 3]), start(velocity));
            let before = still.state().at_m();
            still.run(steps);
            moving.run(steps);
            let shift_m = DVec3::from_array(velocity) * f64::from(steps) * still.scene().solver.dt_s;
            assert!(shift_m.x > 0.5 * still.scene().period_m()[0], "it crossed no seam");
            let (mean, far) = apart(&mut still, &mut moving, shift_m);
            println!(
                "{dimensions}-D {name} over {:.1} sides: {:.1e} spacings apart, mean {:.1e}",
                shift_m.x / still.scene().period_m()[0],
                far / SPACING_M,
                mean.length() / SPACING_M
            );
            // A step's length is rounded once and acts on all alike: v dt by 2^-24 of itself, a few times over.
            assert!(mean.length() < 1e-5 * shift_m.length() + 1e-3 * SPACING_M, "{name}: {mean}");
            assert!(far < tolerance * SPACING_M, "{name}: {far}");
            let moved = still.state().at_m().iter().zip(&before).map(|(a, b)| (*a - *b).length()).fold(0.0, f64::max);
            assert!(name == "lattice" || moved > 0.1 * SPACING_M, "{name}: nothing happened, {moved}");
        }
    }
}

#[test]
fn momentum_is_kept_across_seams() {
    for (name, text) in [("box", filled([16, 16, 8], 16, BOX)), ("sheet", filled([32, 32, 1], 32, SHEET))] {
        let mut case = Case::new(&text, &["forces.xsph=0.05"]);
        let mut rng = rng(95);
        let dimensions = case.scene().domain.dimensions as usize;
        case.place(|_, position, velocity| {
            for axis in 0..dimensions {
                position[axis] += 0.3 * SPACING_M as f32 * (rng.random::<f32>() - 0.5);
                velocity[axis] = 2.0 * rng.random::<f32>() - 1.0;
            }
        });
        let sum = |case: &mut Case| case.state().velocities_m_s().iter().sum::<DVec3>();
        let speeds = case.state().velocities_m_s().iter().map(|v| v.length()).sum::<f64>();
        let before = sum(&mut case);
        let stats = case.run(120);
        let drift = (sum(&mut case) - before).length() / speeds;
        println!("{name}: momentum drifts by {drift:.1e} of what moves in 120 steps");
        assert_eq!((stats.escaped, stats.quarantined), (0, 0));
        // As in free space (`physics`): a random walk of roundings.
        assert!(drift < 2e-5, "{name}: {drift}");
        // Density is that of the box: no particle more nor less fits.
        assert!(stats.density_error.mean < 0.05, "{name}: {}", stats.density_error.mean);
    }
}

#[test]
fn columns_between_seams_and_in_tanks_are_compressed_as_the_law_says() {
    // Periodic along the floor, so that nothing is moved by walls; then a tank of two dimensions.
    let floor = "periodic = [true, false, true]";
    let sheet = "periodic = [true, false, false]\ndimensions = 2";
    let tank = "dimensions = 2";
    for (name, text, dimensions) in [
        ("3-D, periodic", filled([8, 32, 8], 20, floor), 3),
        ("2-D, periodic", filled([8, 32, 1], 20, sheet), 2),
        ("2-D, tank", filled([16, 32, 1], 20, tank), 2),
    ] {
        let settings = ["gravity_m_s2=[0, -9.81, 0]", "solver.dt_s=0.0025", "solver.pbf.acceleration=none"];
        let mut case = Case::new(&text, &settings);
        let start = case.state().at_m();
        let middle = |at_m: &[DVec3]| at_m.iter().map(|at| at.y).sum::<f64>() / at_m.len() as f64;
        let solver = case.scene().solver.clone();
        let law = Column {
            dimensions,
            layers: 20,
            spacing_m: SPACING_M,
            support_ratio: solver.support_ratio,
            gravity_m_s2: 9.81,
            dt_s: solver.dt_s,
            relaxation: IterationWeights::of(case.scene()).response / f64::from(solver.pbf.iterations),
            iterations: solver.pbf.iterations,
            cfm: solver.pbf.cfm,
        }
        .bottom_compression();
        let stats = case.recovers(1.2);
        let end = case.state().at_m();
        let loss = 1.0 - middle(&end) / middle(&start);
        println!("{name}: {loss:.4} of the height lost, compression {:.4}, law {law:.4}", stats.compression.max);
        // Half of the bottom's compression is the mean's; the rest is the free surface's layer.
        // 1.5 times the error measured, 5.6 %.
        assert!(loss > 0.0 && loss < law, "{name}: {loss}");
        assert!((stats.compression.max / law - 1.0).abs() < 0.085, "{name}: {} {law}", stats.compression.max);
        assert_eq!((stats.escaped, stats.quarantined), (0, 0));
        // In two dimensions all keep to their plane, exactly.
        let depth_m = case.scene().domain.size_m()[2] as f32;
        if dimensions == 2 {
            assert!(case.state().positions.iter().all(|position| position[2] == 0.5 * depth_m));
            assert!(case.state().velocities.iter().all(|velocity| velocity[2] == 0.0));
        }
    }
}

#[test]
fn particles_at_one_point_of_a_plane_part_in_it() {
    let mut case = Case::new(&filled([16, 16, 1], 4, "walls = false\ndimensions = 2"), &[]);
    let plane = case.state().positions[0][2];
    case.place(|_, position, _| *position = [0.1, 0.1, position[2]]);
    case.run(200);
    let state = case.state();
    assert!(state.positions.iter().all(|position| position[2] == plane), "some left the plane");
    let nearest = state.nearest_m().into_iter().fold(f64::INFINITY, f64::min);
    assert!(nearest > 0.1 * SPACING_M, "{nearest}");
}

#[test]
fn masses_and_counts_are_those_of_two_dimensions() {
    let scene = Scene::from_toml(&filled([16, 24, 1], 10, "dimensions = 2"), "flat.toml", &[]).unwrap();
    assert_eq!(scene.particle_count(), 160);
    // Per metre of depth: 0.32 m by 0.2 m of water.
    let mass_kg_m = 160.0 * scene.particle_mass_kg();
    assert!((mass_kg_m - 64.0).abs() < 1e-9, "{mass_kg_m}");
    // However deep the domain is.
    let mut deep = scene.clone();
    deep.domain.max_m[2] += 1.0;
    assert_eq!(deep.particle_count(), 0, "the plane has moved out of the block");
    deep.fluids[0].block.as_mut().unwrap().max_m[2] += 1.0;
    assert_eq!(deep.particle_count(), 160);
}

#[test]
fn a_large_open_domain_costs_what_its_fluid_does() {
    let text = filled([16_384, 16_384, 1], 1, "walls = false\ndimensions = 2")
        .replace("max_m = [326.68, 2.02, 5.02]", "max_m = [-0.36, 2.64, 5.02]");
    let scene = Scene::from_toml(&text, "open.toml", &[]).unwrap();
    let count = scene.particle_count() as u32;
    assert_eq!(count, 1024);
    let params = grid::params(&scene, count);
    assert!(params.cell_count <= 1 << 16 && params.cells[2] == 1, "{:?}", params.cells);
    // It is open: a drop thrown out is counted, and flies on freely.
    let mut case = Case::of(&scene);
    case.place(|_, _, velocity| *velocity = [-1.0, 0.5, 0.0]);
    let stats = case.run(200);
    assert_eq!((stats.particles, stats.escaped), (1024, 1024));
    assert!((stats.momentum_kg_m_s[0] / (1024.0 * scene.particle_mass_kg()) + 1.0).abs() < 1e-3);
    assert_eq!(stats.max_speed_m_s, stats.max_speed_m_s.clamp(1.0, 1.3));
}
