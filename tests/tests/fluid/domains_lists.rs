//! Neighbour lists of a whole step in domains with periodic axes, and in two dimensions: those of brute
//! force over the nearest images, in grids that are dense and in ones that are wrapped.

use brooklet_fluid::particles::ParticleSet;
use brooklet_fluid::scene::Precision;
use brooklet_fluid::{Scene, grid, record_particles};
use brooklet_gpu::{Engine, Plan, Resources};
use brooklet_kernels::{Kernel, ListHead, ListNeighbours, Position, Velocity};
use brooklet_reference::grid::list_neighbours::{check_list, list_images, list_neighbours};
use brooklet_reference::shared::quantized_position::Quantization;
use brooklet_tests::cases::{SPACING_M, SUPPORT_M, fluid, sizes, vectors};
use brooklet_tests::compare::{report_exact, vector};
use brooklet_tests::{gpu, rng};
use glam::DVec3;
use rand::{Rng, RngExt};

/// A domain of so many cells (a spacing each), whose particles stay where they are.
fn scene(cells: [u32; 3], periodic: [bool; 3], dimensions: u32, precision: Precision) -> Scene {
    let [x, y, z] = cells.map(|n| f64::from(n) * SPACING_M);
    let text = format!(
        "spacing_m = {SPACING_M}\ngravity_m_s2 = [0, 0, 0]\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [{x}, {y}, {z}]\n\
         walls = false\nperiodic = {periodic:?}\ndimensions = {dimensions}\n\
         [solver]\nneighbour_slots = 256\nprecision = \"{}\"\n[solver.pbf]\niterations = 0\n[forces]\nxsph = 0\n",
        precision.name()
    );
    Scene::from_toml(&text, "lists.toml", &[]).unwrap()
}

/// A squeezed blob around the domain's corner, so around all its seams, and as many anywhere.
fn scattered(rng: &mut impl Rng, count: usize, scene: &Scene) -> ParticleSet {
    let size_m = DVec3::from_array(scene.domain.size_m());
    let flat = scene.domain.is_flat();
    let blob: Vec<DVec3> = fluid(rng, count.div_ceil(2)).positions.iter().map(|p| vector(p.position_m)).collect();
    let middle_m = blob.iter().fold(DVec3::ZERO, |far, at| far.max(*at)) / 2.0;
    let positions = (0..count)
        .map(|i| {
            let mut at = match blob.get(i) {
                Some(at) => *at - middle_m,
                None => DVec3::new(rng.random(), rng.random(), rng.random()) * size_m * 1.1 - 0.05 * size_m,
            };
            for axis in 0..3 {
                if scene.domain.periodic[axis] {
                    at[axis] = at[axis].rem_euclid(size_m[axis]);
                }
            }
            if flat {
                at.z = size_m.z / 2.0;
            }
            Position { position_m: at.to_array().map(|x| x as f32), tag: i as u32 }
        })
        .collect();
    ParticleSet { positions, velocities: vec![Velocity::default(); count] }
}

/// Steps once, and returns the number of neighbours if all lists are right; the last that is not, if not.
fn check(scene: &Scene, emitted: ParticleSet, images: bool) -> Result<usize, String> {
    let count = emitted.positions.len();
    let mut resources = Resources::new();
    let recorded = record_particles(&mut resources, scene, emitted);
    let plan = Plan::sweep(resources, recorded.recordings(), &[]).unwrap();
    let mut engine = Engine::new(&gpu(), plan).unwrap();
    engine.run(&[recorded.init.id(), recorded.step.id()], &[]).unwrap();
    let positions: Vec<Position> = engine.read(&recorded.positions).unwrap();
    let heads: Vec<ListHead> = engine.read(&recorded.neighbours.as_ref().unwrap().heads).unwrap();
    let deltas: Vec<[u32; 2]> = engine.read(&recorded.neighbours.as_ref().unwrap().deltas).unwrap();

    let at_m = vectors(&positions);
    let size_m = DVec3::from_array(scene.domain.size_m().map(|x| f64::from(x as f32)));
    let period_m = DVec3::from_array(scene.period_m());
    // What is within a rounding of the face of an open axis may be in the grid or not: nobody is.
    let alone = |i: usize| at_m[i].clamp(DVec3::ZERO, size_m) != at_m[i];
    let expected = match images {
        true => list_images(&at_m, alone, SUPPORT_M, period_m),
        false => list_neighbours(&at_m, alone, SUPPORT_M),
    };
    // A distance rounds to steps of the two quantized positions, and those across a seam by its own f32.
    let quantization = match scene.solver.precision.packs_positions() {
        true => Quantization::Packed,
        false => Quantization::Full,
    };
    let doubt_m = (2.0 * quantization.step() + 1e-6) * SUPPORT_M + 4.0 * f64::from(f32::EPSILON) * size_m.max_element();
    let mut listed = 0;
    for i in 0..count {
        let list = grid::listed(i as u32, heads[i], &deltas, grid::list_chunks(scene));
        let found: Vec<usize> = list.map(|j| j as usize).collect();
        assert!(found.is_sorted(), "particle {i}: {found:?}");
        check_list(i, &found, &expected[i], &at_m, SUPPORT_M, period_m, doubt_m)?;
        listed += found.len();
    }
    Ok(listed)
}

#[test]
fn periodic_lists_equal_brute_force_over_the_nearest_images() {
    let device = &brooklet_tests::device();
    let mut rng = rng(91);
    let mut compared = 0;
    let axes = [[true, false, false], [false, true, false], [false, false, true], [true; 3]];
    for periodic in axes {
        for size in sizes(device, ListNeighbours::GROUP_SIZE[0] as usize) {
            let precision = if size % 2 == 0 { Precision::Relaxed } else { Precision::Full };
            let scene = scene([8, 16, 24], periodic, 3, precision);
            assert_eq!(grid::wrapped(grid::cells(&scene), size as u32), None);
            compared += check(&scene, scattered(&mut rng, size, &scene), true).unwrap();
        }
        // Brute force without images is told apart.
        let scene = scene([8, 16, 24], periodic, 3, Precision::Full);
        assert!(check(&scene, scattered(&mut rng, 600, &scene), false).is_err(), "{periodic:?}");
    }
    assert!(compared > 100_000, "{compared}");
    report_exact(device, "list_neighbours, periodic (but for distances within two steps of h)", compared);
}

#[test]
fn periodic_lists_in_wrapped_grids_do_too() {
    let device = &brooklet_tests::device();
    // Sides that are and are not whole numbers of the grid.
    let mut rng = rng(92);
    let mut compared = 0;
    for (cells, periodic) in
        [([400, 8, 200], [true; 3]), ([512, 64, 64], [true, false, true]), ([24, 904, 40], [true; 3])]
    {
        let scene = scene(cells, periodic, 3, Precision::Full);
        assert!(grid::wrapped(grid::cells(&scene), 2000).is_some());
        compared += check(&scene, scattered(&mut rng, 2000, &scene), true).unwrap();
    }
    assert!(compared > 10_000, "{compared}");
    report_exact(device, "list_neighbours, periodic and wrapped", compared);
}

#[test]
fn flat_lists_equal_brute_force() {
    let device = &brooklet_tests::device();
    let mut rng = rng(93);
    let mut compared = 0;
    for (cells, periodic) in
        [([24, 16, 1], [false; 3]), ([24, 16, 3], [true, true, false]), ([640, 480, 1], [true, false, false])]
    {
        for size in sizes(device, ListNeighbours::GROUP_SIZE[0] as usize) {
            let scene = scene(cells, periodic, 2, Precision::Full);
            compared += check(&scene, scattered(&mut rng, size.min(700), &scene), true).unwrap();
        }
    }
    assert!(compared > 10_000, "{compared}");
    report_exact(device, "list_neighbours in two dimensions", compared);
}
