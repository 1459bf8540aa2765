//! Many iterations of a drop at half its case's spacing: its stretched lattice has modes beyond the interval that the weights
//! are made for, and 24 iterations in one cycle let it fly apart (area +49 to +220 %, energy rise .15 to .76).

use brooklet_study::Verdict;
use brooklet_study::backend::{Options, run};
use brooklet_study::case::case;
use brooklet_study::energy;

#[test]
fn they_gain_no_energy() {
    let case = case("elliptical-drop").unwrap();
    let settings = ["spacing_m=0.03125", "solver.pbf.iterations=24"].map(String::from);
    let setup = case.setup(&settings).unwrap();
    let run = run(&brooklet_tests::gpu(), &setup, &Options::default()).unwrap();
    let figures = case.figures(&setup, &run.samples, &|_| None).unwrap();
    let axes = figures.iter().find(|figure| figure.name == "axis error").unwrap().value.unwrap();
    let rise = &energy::figures(&setup, &run, case.energy_rise())[0];
    // .013 in four runs.
    assert!(axes < 0.02 && rise.verdict() == Verdict::Meets, "{axes} {rise:?}");
}
