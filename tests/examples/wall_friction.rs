//! Two published dam breaks over a floor of rising friction: `cargo run --release -p brooklet-tests --example wall_friction`.

use brooklet_study::backend::{Options, run};
use brooklet_study::case::case;

fn main() {
    for name in ["square-column", "martin-moyce"] {
        for friction in [0.0, 0.003, 0.007, 0.014, 0.03, 0.06] {
            let case = case(name).unwrap();
            let settings = ["slip=friction".into(), format!("friction={friction}")];
            let setup = case.setup(&settings.map(|setting| format!("domain.faces.y_min.{setting}"))).unwrap();
            let run = run(&brooklet_tests::gpu(), &setup, &Options::default()).unwrap();
            let figures = case.figures(&setup, &run.samples, &|_| None).unwrap();
            let told: Vec<String> =
                figures.iter().map(|f| format!("{} {:.4}", f.name, f.value.unwrap_or(f64::NAN))).collect();
            println!("{name} c_f {friction}: {}", told.join(", "));
        }
    }
}
