//! What walls cost the fluid: channels at three spacings, and two published dam breaks over a floor of rising friction:
//! `cargo run --release -p brooklet-tests --example walls`.

use brooklet_study::backend::{Options, run};
use brooklet_study::case::case;

/// The figures of a case with settings, in one line.
fn told(name: &str, settings: &[String]) -> String {
    let case = case(name).unwrap();
    let setup = case.setup(settings).unwrap();
    let run = run(&brooklet_tests::gpu(), &setup, &Options::default()).unwrap();
    let figures = case.figures(&setup, &run.samples, &|_| None).unwrap();
    let told: Vec<String> = figures.iter().map(|f| format!("{} {:.4}", f.name, f.value.unwrap_or(f64::NAN))).collect();
    told.join(", ")
}

fn main() {
    for (name, spacing_m) in ["couette", "poiseuille"].iter().flat_map(|name| [0.1, 0.05, 0.025].map(|d| (name, d))) {
        println!("{name} d = {spacing_m} H: {}", told(name, &[format!("spacing_m={spacing_m}")]));
    }
    for name in ["square-column", "martin-moyce"] {
        for friction in [0.0, 0.003, 0.005, 0.006, 0.007, 0.008, 0.014, 0.03] {
            let settings = ["slip=friction".into(), format!("friction={friction}")];
            let settings = settings.map(|setting| format!("domain.faces.y_min.{setting}"));
            println!("{name} c_f {friction}: {}", told(name, &settings));
        }
    }
}
