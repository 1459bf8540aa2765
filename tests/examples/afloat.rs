//! How bodies float: drafts by density, spacing and solver; a prism that turns on its edge; a ball as heavy as water.
//! `cargo run --release --example afloat -- drafts|prism|neutral [METHOD ...]`

use brooklet_fluid::{Scene, Session};
use brooklet_kernels::BodyState;
use brooklet_tests::afloat::{FLAT_BOX, HEIGHT_M, draft_m, floating, neutral, prism, turned_around_z_deg};

const SPACINGS_M: [f64; 2] = [0.025, 0.4 / 24.0];
const DENSITIES_KG_M3: [f64; 5] = [200.0, 350.0, 500.0, 700.0, 900.0];

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let Some((what, methods)) = arguments.split_first() else { panic!("drafts, prism or neutral") };
    let methods: Vec<&str> = match methods {
        [] => vec!["pbf", "sph", "dfsph"],
        given => given.iter().map(String::as_str).collect(),
    };
    for method in methods {
        for spacing_m in SPACINGS_M {
            match what.as_str() {
                "drafts" => DENSITIES_KG_M3.iter().for_each(|&density| drafts(method, spacing_m, density)),
                "prism" => turns(method, spacing_m),
                "neutral" => drifts(method, spacing_m),
                other => panic!("{other}: drafts, prism or neutral"),
            }
        }
    }
}

/// Runs a scene, and returns the time and state of its body, so many times a second.
fn course(scene: &Scene, seconds: f64, times_a_second: f64) -> Vec<(f64, BodyState)> {
    let mut session = Session::new(&brooklet_tests::gpu(), scene).expect("a device");
    let (steps, every) = ((seconds / scene.solver.dt_s) as u32, (1.0 / times_a_second / scene.solver.dt_s) as u32);
    let mut states = Vec::new();
    for step in 1..=steps {
        session.step().expect("a step");
        if step % every == 0 {
            states.push((f64::from(step) * scene.solver.dt_s, session.read_bodies().expect("a device").states[0]));
        }
    }
    states
}

fn drafts(method: &str, spacing_m: f64, density_kg_m3: f64) {
    let scene = floating(FLAT_BOX, density_kg_m3, method, spacing_m);
    let states = course(&scene, 2.0, 20.0);
    let late = &states[states.len() / 2..];
    let mean_m = late.iter().map(|(_, state)| draft_m(&scene, state)).sum::<f64>() / late.len() as f64;
    let expected_m = HEIGHT_M * density_kg_m3 / 1000.0;
    let off_m = mean_m - expected_m;
    let allowed_m = (0.05 * expected_m).max(0.25 * spacing_m);
    let upright = states.last().expect("states").1.rotation[3].abs();
    println!(
        "| {method} | {:.1} | {density_kg_m3} | {:.1} | {:.1} | {:+.1} | {:.1} | {} |{}",
        1e3 * spacing_m,
        1e3 * expected_m,
        1e3 * mean_m,
        1e3 * off_m,
        1e3 * allowed_m,
        if upright > 0.99 { "upright" } else { "tilted" },
        if off_m.abs() <= allowed_m { "" } else { " off" }
    );
}

fn turns(method: &str, spacing_m: f64) {
    for (time_s, state) in course(&prism(method, spacing_m), 8.0, 1.0) {
        println!("{method} {:.1} mm, {time_s:.1} s: {:.1} degrees", 1e3 * spacing_m, turned_around_z_deg(&state));
    }
}

fn drifts(method: &str, spacing_m: f64) {
    let scene = neutral(method, spacing_m);
    for (time_s, state) in course(&scene, 10.0, 1.0) {
        let moved_m = state.position_m.iter().map(|x| (f64::from(*x) - 0.2).powi(2)).sum::<f64>().sqrt();
        println!(
            "{method} {:.1} mm, {time_s:.1} s: {:.2} spacings from where it began, at {:?}",
            1e3 * spacing_m,
            moved_m / spacing_m,
            state.position_m
        );
    }
}
