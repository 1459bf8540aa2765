//! Shaders that change while a program runs them.

use std::path::Path;

use brooklet_compiler::{Places, Recompiled, compile_one};
use brooklet_fluid::{Scene, record};
use brooklet_gpu::{Engine, Plan, Resources};
use brooklet_kernels::{Module, Tier, modules};
use brooklet_tests::gpu;

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

/// The shaders in a folder of their own, to be edited, beside what is committed of them.
fn checkout() -> (tempfile::TempDir, Places) {
    fn copy(from: &Path, to: &Path) {
        std::fs::create_dir_all(to).unwrap();
        for entry in std::fs::read_dir(from).unwrap().map(Result::unwrap) {
            match entry.path().is_dir() {
                true => copy(&entry.path(), &to.join(entry.file_name())),
                false => drop(std::fs::copy(entry.path(), to.join(entry.file_name())).unwrap()),
            }
        }
    }
    let folder = tempfile::tempdir().unwrap();
    copy(&root().join("shaders/hlsl"), folder.path());
    let places = Places { shaders: folder.path().to_owned(), ..Places::below(root()) };
    (folder, places)
}

fn edit(places: &Places, file: &str, from: &str, to: &str) {
    let path = places.shaders.join(file);
    let text = std::fs::read_to_string(&path).unwrap();
    assert!(text.contains(from), "{file} has no {from:?}");
    std::fs::write(&path, text.replacen(from, to, 1)).unwrap();
}

/// The running module that a new one replaces.
fn running(new: &Recompiled) -> &'static Module {
    modules().find(|module| module.name == new.name).unwrap_or_else(|| panic!("{}", new.name))
}

fn replacement(new: &Recompiled) -> &'static Module {
    let tier = match new.tier.name() {
        "floor" => Tier::Floor,
        "mobile" => Tier::Mobile,
        _ => Tier::Desktop,
    };
    running(new).with_spirv(&new.spirv, new.shared_bytes, tier)
}

fn names(modules: &[Recompiled]) -> Vec<&str> {
    modules.iter().map(|module| module.name.as_str()).collect()
}

#[test]
fn an_edited_kernel_goes_on_with_the_particles_that_are_there() {
    let (_folder, places) = checkout();
    let scene = Scene::load("calm-pool", &["spacing_m=0.1".into(), "domain.walls=false".into()]).unwrap();
    let mut resources = Resources::new();
    let recorded = record(&mut resources, &scene);
    let plan = Plan::sweep(resources, recorded.recordings(), &[]).unwrap();
    let mut engine = Engine::new(&gpu(), plan.clone()).unwrap();
    engine.run(&[recorded.init.id(), recorded.step.id()], &[]).unwrap();
    let before = recorded.particles(&mut engine).unwrap();
    let mean_m_s = |velocities: &[brooklet_kernels::Velocity]| {
        velocities.iter().map(|v| f64::from(v.velocity_m_s[1])).sum::<f64>() / velocities.len() as f64
    };
    let fallen_m_s = mean_m_s(&before.velocities);

    edit(&places, "particles/predict.compute", "velocity_m_s += step_params", "velocity_m_s -= 3.0 * step_params");
    let new = compile_one(&places, &places.shaders.join("particles/predict.compute")).unwrap();
    assert_eq!(names(&new), ["Predict", "Predict+PERIODIC", "Predict+WALLS", "Predict+WALLS+PERIODIC"]);
    let of = |module: &'static Module| new.iter().find(|new| new.name == module.name).map(replacement);
    engine.swap_modules(plan.with_modules(of).unwrap()).unwrap();
    assert_eq!(recorded.particles(&mut engine).unwrap().positions, before.positions);
    engine.run(&[recorded.step.id()], &[]).unwrap();
    let after = recorded.particles(&mut engine).unwrap();
    // Gravity turned round and three times as strong: solver and viscosity keep the mean.
    let change = mean_m_s(&after.velocities) - fallen_m_s;
    let expected = 3.0 * 9.81 * scene.solver.dt_s;
    assert!((change / expected - 1.0).abs() < 0.01, "{change} m/s, expected {expected}");
}

#[test]
fn an_include_brings_every_kernel_that_includes_it_and_a_comment_changes_none() {
    let (_folder, places) = checkout();
    edit(&places, "shared/periodic.hlsli", "#ifndef", "// One line more.\n#ifndef");
    let new = compile_one(&places, Path::new("shared/periodic.hlsli")).unwrap();
    let stages: std::collections::BTreeSet<&str> =
        names(&new).iter().map(|name| name.split('+').next().unwrap_or_default()).collect();
    assert!(stages.contains("Predict") && stages.contains("MeasureParticles"), "{stages:?}");
    assert!(!stages.contains("Reorder"), "{stages:?}");
    for new in &new {
        assert!(std::ptr::eq(replacement(new), running(new)), "{}: the same words are the same module", new.name);
    }
    edit(&places, "frame/sky.hlsl", "#pragma", "// Another.\n#pragma");
    let new = compile_one(&places, Path::new("frame/sky.hlsl")).unwrap();
    assert_eq!(names(&new), ["DrawSky.vertex", "DrawSky.fragment"]);
    // No window runs what only benchmarks run, alone or beside what the product runs.
    edit(&places, "bench/copy.compute", "#pragma", "// One.\n#pragma");
    assert!(compile_one(&places, Path::new("bench/copy.compute")).unwrap().is_empty());
    let new = compile_one(&places, Path::new("grid/cell.hlsli")).unwrap();
    assert!(names(&new).contains(&"CountCells") && !names(&new).contains(&"CountCellsAggregated"), "{new:?}");
    std::fs::write(places.shaders.join("alone.hlsl"), "float Alone() { return 1.0; }\n").unwrap();
    assert!(compile_one(&places, &places.shaders.join("alone.hlsl")).unwrap().is_empty());
}

#[test]
fn what_cannot_be_reloaded_says_where_and_why() {
    let refused = |file: &str, from: &str, to: &str| {
        let (_folder, places) = checkout();
        edit(&places, file, from, to);
        compile_one(&places, Path::new(file)).expect_err(to).to_string()
    };
    let predict = "particles/predict.compute";
    let error = refused(predict, "velocity_m_s += step_params", "velocity_m_s += stop_params");
    assert!(error.contains("predict.compute:") && error.contains("stop_params"), "{error}");
    let line = std::fs::read_to_string(root().join("shaders/hlsl").join(predict)).unwrap();
    let line = line.lines().position(|line| line.contains("velocity_m_s += step_params")).unwrap() + 1;
    assert!(error.contains(&format!("predict.compute:{line}")), "{error}");

    let error = refused(predict, "velocity_m_s = Slowed(velocity_m_s);", "");
    assert!(error.contains("it no longer uses counters") && error.contains("again"), "{error}");
    let error = refused(predict, "[numthreads(PARTICLE_GROUP, 1, 1)]", "[numthreads(32, 1, 1)]");
    assert!(error.contains("its group has [32, 1, 1] threads, not [64, 1, 1]"), "{error}");
    let error = refused(predict, "#pragma kernel Predict", "#pragma kernel Predict SLOWER");
    assert!(error.contains("no such kernel or variant"), "{error}");
    let error = refused("shared/layout.hlsli", "SCAN_ITEMS = 16", "SCAN_ITEMS = 8");
    assert!(error.contains("layout.hlsli") && error.contains("the host has these"), "{error}");
    let error = refused("grid/scan.compute", "[numthreads", "[numthreads(1, 2");
    assert!(error.contains("scan.compute"), "{error}");
}
