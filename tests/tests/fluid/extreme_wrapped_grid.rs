//! Case 15: drops as many cells apart as the wrapped grid has. They share their cells, and must not
//! feel each other: each does what it does alone.

use brooklet_fluid::{Scene, grid};
use brooklet_tests::extreme::Case;

/// A power of two, so that drops far apart have the same places in their cells.
const SPACING_M: f64 = 0.015_625;
/// Of a side of the domain, in spacings, which are cells.
const SIDE: u32 = 300;

/// Blocks of 4 x 4 x 4 squeezed particles, their corners so many spacings from the domain's.
fn drops(corners: &[[u32; 3]]) -> String {
    let side_m = f64::from(SIDE) * SPACING_M;
    let mut scene = format!(
        "spacing_m = {SPACING_M}\ngravity_m_s2 = [0, 0, 0]\n[domain]\nmin_m = [0, 0, 0]\n\
         max_m = [{side_m}, {side_m}, {side_m}]\n[solver]\ndeterministic = true\n[outputs]\nmeasure_every_steps = 1\n"
    );
    for corner in corners {
        let [x, y, z] = corner.map(|k| f64::from(k) * SPACING_M);
        let edge_m = 4.0 * SPACING_M;
        scene += &format!(
            "[[fluid]]\nblock = {{ min_m = [{x}, {y}, {z}], max_m = [{}, {}, {}] }}\nvelocity_m_s = [0.5, 0.25, -0.5]\n",
            x + edge_m,
            y + edge_m,
            z + edge_m
        );
    }
    scene
}

#[test]
fn drops_a_whole_grid_apart_do_not_feel_each_other() {
    let text = drops(&[[20, 20, 20]]);
    let scene = Scene::from_toml(&text, "wrap.toml", &[]).unwrap();
    let cells = grid::wrapped(grid::cells(&scene), 128).expect("a domain so empty is wrapped");
    let mut alone = Case::new(&text, &[]);
    let start = alone.state();
    let alone_stats = alone.run(60);
    let alone = alone.state();
    let moved = (alone.at_m()[0] - start.at_m()[0]).length();
    assert!(moved > 2.0 * SPACING_M, "{moved}");
    for axes in [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]] {
        let other: [u32; 3] = std::array::from_fn(|axis| 20 + axes[axis] * cells[axis]);
        assert!(other.iter().all(|&k| k + 30 < SIDE), "{other:?} leaves the domain");
        let mut case = Case::new(&drops(&[[20, 20, 20], other]), &[]);
        assert_eq!(case.count(), 128);
        let stats = case.run(60);
        let both = case.state();
        let shift =
            glam::DVec3::from_array(std::array::from_fn(|axis| f64::from(axes[axis] * cells[axis]))) * SPACING_M;
        let mut furthest = 0.0_f64;
        for id in 0..64 {
            furthest = furthest.max((both.at_m()[id] - alone.at_m()[id]).length());
            furthest = furthest.max((both.at_m()[64 + id] - alone.at_m()[id] - shift).length());
        }
        // Further from the corner f32 positions are rounded coarser: 2^-23 of 4 m, 60 times over.
        println!("case 15: {axes:?} x {cells:?} cells apart: within {:.1e} spacings", furthest / SPACING_M);
        assert!(furthest < 2e-3 * SPACING_M, "{axes:?}: {furthest} m");
        let difference = (stats.density_error.max - alone_stats.density_error.max).abs();
        assert!(difference < 1e-3, "{axes:?}: density error {difference}");
    }
}
