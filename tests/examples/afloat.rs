//! How bodies float: drafts by density, spacing and solver; a prism that turns on its edge; a ball as heavy as water.
//! `cargo run --release --example afloat -- drafts|prism|neutral [METHOD ...] [density=KG_M3 ...] [spacing_m=M ...]
//! [jitter=SPACINGS] [SECTION.FIELD=VALUE ...]`: settings of the scene, and by how much its particles are moved at random before
//! they begin, so that no lattice is in a body's way.

use brooklet_fluid::{Scene, Session};
use brooklet_kernels::BodyState;
use brooklet_tests::afloat::{
    DEEP_M, FLAT_BOX, HEIGHT_M, draft_below_surface_m, draft_m, floating, neutral, prism, turned_around_z_deg,
};
use rand::RngExt;

const SPACINGS_M: [f64; 2] = [0.025, 0.4 / 24.0];
const DENSITIES_KG_M3: [f64; 5] = [200.0, 350.0, 500.0, 700.0, 900.0];

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let Some((what, methods)) = arguments.split_first() else { panic!("drafts, prism or neutral") };
    let named: Vec<&str> = methods.iter().map(String::as_str).filter(|method| !method.contains('=')).collect();
    let methods = if named.is_empty() { vec!["pbf", "sph", "dfsph"] } else { named };
    let densities_kg_m3 = chosen(&arguments, "density=", &DENSITIES_KG_M3);
    let start = Start {
        settings: arguments
            .iter()
            .filter(|given| given.split('=').next().is_some_and(|path| path.contains('.')))
            .cloned()
            .collect(),
        jitter: chosen(&arguments, "jitter=", &[0.0])[0],
    };
    for method in methods {
        for &spacing_m in &chosen(&arguments, "spacing_m=", &SPACINGS_M) {
            match what.as_str() {
                "drafts" => densities_kg_m3.iter().for_each(|&density| drafts(method, spacing_m, density, &start)),
                "prism" => turns(method, spacing_m, &start),
                "neutral" => drifts(method, spacing_m, &start),
                other => panic!("{other}: drafts, prism or neutral"),
            }
        }
    }
}

/// What differs from the scenes of `brooklet_tests::afloat`.
struct Start {
    settings: Vec<String>,
    /// Furthest along each axis, in spacings.
    jitter: f64,
}

impl Start {
    fn set(&self, scene: Scene) -> Scene {
        self.settings.iter().fold(scene, |scene, setting| scene.with_setting(setting).expect("a setting"))
    }

    fn shake(&self, scene: &Scene, session: &mut Session) {
        if self.jitter == 0.0 {
            return;
        }
        let mut random = brooklet_tests::rng(1);
        let mut particles = session.read_particles().expect("a device");
        for position in &mut particles.positions {
            position.position_m = position
                .position_m
                .map(|x| x + (self.jitter * scene.spacing_m * (random.random_range(-1.0..=1.0))) as f32);
        }
        session.write_particles(&particles);
    }
}

/// The numbers behind a name among the arguments, or all.
fn chosen(arguments: &[String], name: &str, all: &[f64]) -> Vec<f64> {
    let given: Vec<f64> =
        arguments.iter().filter_map(|given| given.strip_prefix(name)).map(|x| x.parse().expect("a number")).collect();
    if given.is_empty() { all.to_vec() } else { given }
}

/// Runs a scene, and calls `visit` with the time and the session so many times a second.
fn course(scene: &Scene, start: &Start, seconds: f64, times_a_second: f64, mut visit: impl FnMut(f64, &mut Session)) {
    let mut session = Session::new(&brooklet_tests::gpu(), scene).expect("a device");
    start.shake(scene, &mut session);
    let (steps, every) = ((seconds / scene.solver.dt_s) as u32, (1.0 / times_a_second / scene.solver.dt_s) as u32);
    for step in 1..=steps {
        session.step().expect("a step");
        if step % every == 0 {
            visit(f64::from(step) * scene.solver.dt_s, &mut session);
        }
    }
}

fn body(session: &mut Session) -> BodyState {
    session.read_bodies().expect("a device").states[0]
}

fn drafts(method: &str, spacing_m: f64, density_kg_m3: f64, start: &Start) {
    let scene = start.set(floating(FLAT_BOX, density_kg_m3, method, spacing_m, DEEP_M));
    let (mut told_m, mut seen_m, mut upright) = (Vec::new(), Vec::new(), 1.0);
    course(&scene, start, 2.0, 20.0, |time_s, session| {
        let state = body(session);
        upright = state.rotation[3].abs();
        if time_s > 1.0 {
            told_m.push(draft_m(&scene, &state));
            let particles = session.read_particles().expect("a device");
            seen_m.push(draft_below_surface_m(&particles.positions, &state));
        }
    });
    let mean_m = |of: &[f64]| of.iter().sum::<f64>() / of.len() as f64;
    let expected_m = HEIGHT_M * density_kg_m3 / 1000.0;
    let [told_off_m, seen_off_m] = [&told_m, &seen_m].map(|of| mean_m(of) - expected_m);
    let allowed_m = (0.05 * expected_m).max(0.25 * spacing_m);
    println!(
        "| {method} | {:.1} | {density_kg_m3} | {:.1} | {:+.1} | {:+.1} | {:.1} | {} |{}",
        1e3 * spacing_m,
        1e3 * expected_m,
        1e3 * seen_off_m,
        1e3 * told_off_m,
        1e3 * allowed_m,
        if upright > 0.99 { "upright" } else { "tilted" },
        if seen_off_m.abs() <= allowed_m { "" } else { " off" }
    );
}

fn turns(method: &str, spacing_m: f64, start: &Start) {
    course(&start.set(prism(method, spacing_m)), start, 8.0, 1.0, |time_s, session| {
        let turned_deg = turned_around_z_deg(&body(session));
        println!("{method} {:.1} mm, {time_s:.1} s: {turned_deg:.1} degrees", 1e3 * spacing_m);
    });
}

fn drifts(method: &str, spacing_m: f64, start: &Start) {
    course(&start.set(neutral(method, spacing_m)), start, 10.0, 1.0, |time_s, session| {
        let at_m = body(session).position_m;
        let moved_m = at_m.iter().map(|x| (f64::from(*x) - 0.2).powi(2)).sum::<f64>().sqrt();
        println!(
            "{method} {:.1} mm, {time_s:.1} s: {:.2} spacings from where it began, at {at_m:?}",
            1e3 * spacing_m,
            moved_m / spacing_m
        );
    });
}
