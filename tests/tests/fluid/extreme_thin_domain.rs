//! Case 16: fewer than three cells along an axis. No cell is visited twice: densities are those of
//! brute force, and the fluid comes to rest.

use brooklet_reference::boundary::walls::{DomainWalls, WallScales};
use brooklet_reference::grid::list_neighbours::list_neighbours;
use brooklet_reference::measure::density::density_ratio;
use brooklet_reference::params::Smoothing;
use brooklet_reference::shared::lattice;
use brooklet_tests::compare::Worst;
use brooklet_tests::extreme::Case;
use brooklet_tests::rng;
use glam::{BVec3, DVec3};
use rand::RngExt;

/// A domain of so many cells (h/2 = a spacing each), filled from below to half its height at least.
fn thin(cells: [u32; 3], gravity: f64) -> String {
    let [x, y, z] = cells.map(|n| 0.02 * f64::from(n));
    let filled = 0.02 * f64::from(cells[1].div_ceil(2));
    format!(
        "spacing_m = 0.02\ngravity_m_s2 = [0, {gravity}, 0]\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [{x}, {y}, {z}]\n\
         [[fluid]]\nblock = {{ min_m = [0, 0, 0], max_m = [{x}, {filled}, {z}] }}\n\
         [outputs]\nmeasure_every_steps = 1\n"
    )
}

const CELLS: [[u32; 3]; 8] = [[1, 1, 1], [2, 1, 5], [1, 2, 2], [2, 2, 2], [7, 1, 1], [1, 6, 2], [2, 5, 6], [2, 20, 2]];

#[test]
fn densities_are_those_of_brute_force() {
    let device = &brooklet_tests::device();
    let mut rng = rng(16);
    let mut worst = Worst::new("densities in thin domains", 1.0e-5);
    for cells in CELLS {
        let mut case = Case::new(&thin(cells, 0.0), &["solver.pbf.iterations=0", "forces.xsph=0"]);
        let size_m = DVec3::from_array(case.scene().domain.size_m());
        // Anywhere that the walls leave: nothing moves then.
        case.place(|_, position_m, _| {
            for axis in 0..3 {
                position_m[axis] = (size_m[axis] * rng.random_range(0.3..0.7)) as f32;
            }
        });
        let stats = case.run(1);
        let at_m = case.state().at_m();
        let walls = DomainWalls {
            dimensions: 3,
            axes: BVec3::TRUE,
            scales: WallScales::new(3, 2.0),
            domain_size_m: size_m,
            support_m: 0.04,
        };
        let smoothing = Smoothing::new(0.04, lattice::weight(3, 2.0));
        let lists = list_neighbours(&at_m, |_| false, 0.04);
        let errors: Vec<f64> = (0..at_m.len())
            .map(|i| (density_ratio(i, &at_m, &lists[i], &smoothing, Some(&walls)) - 1.0).abs())
            .collect();
        let mean = errors.iter().sum::<f64>() / errors.len() as f64;
        // Sums of up to some hundred terms of at most 0.4, in f32.
        worst.check(stats.density_error.mean as f32, mean, mean.max(1.0)).unwrap();
        let max = errors.iter().copied().fold(0.0, f64::max);
        worst.check(stats.density_error.max as f32, max, max.max(1.0)).unwrap();
    }
    worst.report(device);
}

#[test]
fn a_thin_fluid_comes_to_rest() {
    for cells in CELLS {
        let mut case = Case::new(&thin(cells, -9.81), &[]);
        let stats = case.recovers(1.0);
        println!(
            "case 16: {cells:?} cells, {} particles: at rest {:.1e} m/s, compression at most {:.3}",
            case.count(),
            stats.max_speed_m_s,
            stats.compression.max
        );
    }
}
