//! Scenes: defaults, shipped ones, and each message a bad one gets.

use super::*;
use crate::particles::emit;

const SMALL: &str = "spacing_m = 0.1\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [1, 1, 1]\n[[fluid]]\nblock = { min_m = [0, 0, 0], max_m = [0.3, 0.2, 0.1] }\n";

fn load(text: &str, settings: &[&str]) -> Result<Scene, String> {
    let settings: Vec<String> = settings.iter().map(|&s| s.into()).collect();
    Scene::from_toml(text, "small.toml", &settings).map_err(|error| error.to_string())
}

#[test]
fn integers_and_defaults() {
    let scene = load(SMALL, &[]).unwrap();
    assert_eq!(scene.name, "small");
    assert_eq!(scene.solver, Solver::default());
    assert_eq!(scene.fluids[0].rest_density_kg_m3, 1000.0);
    assert_eq!(emit(&scene).positions.len(), 6);
}

#[test]
fn every_shipped_scene_loads_and_says_what_it_is() {
    for (name, summary) in shipped_scenes() {
        let scene = Scene::load(name, &[]).unwrap();
        assert_eq!(scene.summary, summary);
        assert!(!summary.is_empty(), "{name} has no summary");
        assert!(!emit(&scene).positions.is_empty(), "{name} has no particles");
        assert_eq!(Scene::from_toml(&scene.to_toml(), name, &[]).unwrap(), scene, "{name} does not survive TOML");
    }
}

#[test]
fn settings_replace_values() {
    let scene = load(SMALL, &["solver.iterations=8", "domain.max_m.1 = 2", "fluid.0.velocity_m_s=[1,0,0]"]).unwrap();
    assert_eq!(scene.solver.iterations, 8);
    assert_eq!(scene.domain.max_m, [1.0, 2.0, 1.0]);
    assert_eq!(scene.fluids[0].velocity_m_s, [1.0, 0.0, 0.0]);
}

#[test]
fn messages_name_file_field_value_and_what_is_allowed() {
    let message = |text: &str, settings: &[&str]| load(text, settings).unwrap_err();
    let cases: &[(String, &[&str])] = &[
        (message(&SMALL.replace("spacing_m", "spacin_m"), &[]), &["small.toml:1:1", "`spacin_m`", "`spacing_m`"]),
        (message(SMALL, &["solver.iteration=3"]), &["`iteration`", "`iterations`"]),
        (message(SMALL, &["solver.relaxation=0"]), &["small.toml", "solver.relaxation = 0.0", "above 0"]),
        (message(SMALL, &["solver.dt_s=nan"]), &["solver.dt_s = NaN", "positive"]),
        (message(SMALL, &["spacing_m=-1"]), &["spacing_m = -1.0", "positive"]),
        (message(SMALL, &["solver.iterations=many"]), &["small.toml", "u32", "many"]),
        (message(SMALL, &["solver.method=dfsph"]), &["dfsph", "pbf"]),
        (message(SMALL, &["fluid.0.block.max_m=[2,1,1]"]), &["fluid.0", "inside the domain"]),
        (message(SMALL, &["fluid.3.velocity_m_s=[1,0,0]"]), &["--set fluid.3", "below 1"]),
        (message(SMALL, &["solver"]), &["--set solver", "path=value"]),
        (message(SMALL, &["domain.max_m=[0,1,1]"]), &["domain.max_m", "above min_m"]),
        (message(SMALL, &["domain.max_m=[1e6,1e6,1e6]"]), &["domain", "grid cells"]),
        (message("spacing_m = ", &[]), &["small.toml:1:"]),
        (message("[domain]\nmin_m=[0,0,0]\nmax_m=[1,1,1]", &[]), &["spacing_m"]),
        (Scene::load("dam-brake", &[]).unwrap_err().to_string(), &["\"dam-brake\"", "dam-break"]),
    ];
    for (message, parts) in cases {
        for part in *parts {
            assert!(message.contains(part), "{message:?} does not say {part:?}");
        }
        assert!(!message.contains('\n'), "{message:?} has more than one line");
    }
}

#[test]
fn overlapping_fluids_share_no_place() {
    let text = format!("{SMALL}[[fluid]]\nblock = {{ min_m = [0, 0, 0], max_m = [0.4, 0.2, 0.1] }}\n");
    let emitted = emit(&load(&text, &[]).unwrap());
    assert_eq!(emitted.positions.len(), 8);
    let second = emitted.positions.iter().filter(|p| p.tag >> 24 == 1).count();
    assert_eq!(second, 2);
}
