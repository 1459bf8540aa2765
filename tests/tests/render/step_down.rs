//! What the device cannot do is done without: modules that are not built, formats that it lacks.

use std::collections::BTreeSet;

use brooklet_fluid::{Scene, Session};
use brooklet_gpu::{FormatUse, Gpu, GpuError, GpuOptions, Plan};
use brooklet_kernels::{Format, Module, Spirv, Tier};
use brooklet_render::step_down::step_down;
use brooklet_render::{Concession, ScenePlan, StartError, start_stepping_down};
use brooklet_tests::gpu;

/// A device of its own: what is refused stays so.
fn device(without_formats: &[Format]) -> Gpu {
    let name = Some(gpu().info().name.clone());
    let without_formats = without_formats.iter().map(|format| (*format, FormatUse::Any)).collect();
    let options = GpuOptions { tier: Some(gpu().tier()), device_name: name, without_formats, ..GpuOptions::default() };
    Gpu::open(&options).expect("a device")
}

fn scene(name: &str, settings: &[&str]) -> Scene {
    let small = ["outputs.width_px=64", "outputs.height_px=36"];
    let settings: Vec<String> = small.iter().chain(settings).map(|setting| (*setting).to_owned()).collect();
    Scene::load(name, &settings).expect("a scene")
}

fn plan_of(scene: &Scene, tier: Tier) -> Option<Plan> {
    Some(ScenePlan::of_count(scene, 64, tier).ok()?.session.plan)
}

fn start(gpu: &Gpu, scene: &Scene) -> Result<(Scene, Vec<Concession>), StartError> {
    start_with(gpu, scene, &|_| None)
}

/// With other modules than the plan's own, of which the driver knows nothing before it builds them.
fn start_with(
    gpu: &Gpu,
    scene: &Scene,
    other: &dyn Fn(&'static Module) -> Option<&'static Module>,
) -> Result<(Scene, Vec<Concession>), StartError> {
    let plan = |scene: &Scene| plan_of(scene, gpu.tier());
    let start = |scene: &Scene| -> Result<Session, StartError> {
        let mut planned = ScenePlan::new(scene, gpu.tier()).expect("a plan").session;
        planned.plan = planned.plan.with_modules(other).expect("modules that bind alike");
        brooklet_render::start(gpu, planned)
    };
    let cause = |error: &StartError| Some(error.gpu_error().clone());
    let (_, scene, concessions) = start_stepping_down(gpu, scene, &plan, start, cause)?;
    Ok((scene, concessions))
}

/// Modules of the scene's plan that no setting does without, by kernel.
fn essential(gpu: &Gpu, scene: &Scene) -> BTreeSet<&'static str> {
    let tier = gpu.tier();
    let plan = plan_of(scene, tier).expect("a plan");
    let mut essential = BTreeSet::new();
    for module in plan.modules() {
        let error = GpuError::ModuleRefused { module: module.name, reason: "it computes wrongly".into() };
        match step_down(gpu, scene, &error, &|scene| plan_of(scene, tier)) {
            Some((other, concessions)) => {
                let without = plan_of(&other, tier).expect("a plan");
                assert!(without.modules().all(|other| other.name != module.name), "{}: {concessions:?}", module.name);
                assert!(!concessions.is_empty() && other != *scene);
            }
            None => {
                essential.insert(module.name.split('+').next().unwrap_or(module.name));
            }
        }
    }
    essential
}

#[test]
fn every_module_but_the_chains_own_can_be_done_without() {
    let gpu = device(&[]);
    let picture = ["DrawResolve.vertex", "DrawSky.fragment", "DrawSky.vertex"];
    let grid = ["CountCells", "ListNeighbours", "Reorder", "ReduceGroups", "ScanGroups"];
    let solver = ["BeginSubstep", "CorrectPositions", "Predict"];
    let chain = || picture.into_iter().chain(grid).chain(solver).collect::<BTreeSet<_>>();
    assert_eq!(essential(&gpu, &scene("dam-break", &[])), chain());
    assert_eq!(essential(&gpu, &scene("dam-break", &["surface.method=marching-cubes"])), chain());
    // With XSPH velocities are updated by another module than without.
    let without_xsph = essential(&gpu, &scene("dam-break", &["forces.xsph=0"]));
    assert_eq!(without_xsph, chain().into_iter().chain(["UpdateVelocity"]).collect());
    let all = ["forces.vorticity_m_s=0.1", "solver.pbf.warm_start=0.1", "solver.precision=half", "surface.method=auto"];
    assert!(essential(&gpu, &scene("dam-break", &all)).is_subset(&chain()), "a term makes another kernel essential");
    let particles = ["BeginSubstep", "IntegrateParticles"].into_iter().chain(picture).collect();
    assert_eq!(essential(&gpu, &scene("sparks", &[])), particles);
}

#[test]
fn a_solvers_variants_can_be_done_without_and_its_kernels_not() {
    let gpu = device(&[]);
    let picture = ["DrawResolve.vertex", "DrawSky.fragment", "DrawSky.vertex"];
    let grid = ["Advect", "CountCells", "ListNeighbours", "Reorder", "ReduceGroups", "ScanGroups"];
    let chain = |own: &[&'static str]| picture.into_iter().chain(grid).chain(own.iter().copied()).collect();
    let sph: BTreeSet<_> = chain(&["ChooseTimeStep", "EndStep", "FindFastest", "KeepOrder"]);
    let variants = [
        "spacing_m=0.04",
        "solver.method=sph",
        "solver.support_ratio=3",
        "solver.sph.surface_tension_n_m=0.07",
        "solver.sph.density_kernel=poly6",
        "solver.sph.pressure_kernel=spiky",
        "surface.method=none",
    ];
    assert_eq!(essential(&gpu, &scene("dam-break", &variants)), sph);
    let plain = ["spacing_m=0.04", "solver.method=sph", "surface.method=none"];
    let own = ["Accelerate", "ChooseTimeStep", "ComputeDensity", "EndStep", "FindFastest", "KeepOrder"];
    assert_eq!(essential(&gpu, &scene("dam-break", &plain)), chain(&own));
    // With as many iterations as are written nothing measures what is left.
    let own = ["ApplyGravity", "ApplyPressure", "BeginSubstep", "CarryPressure", "FactorPressure", "LimitVelocity"];
    let dfsph = scene("dam-break", &["spacing_m=0.04", "solver.method=dfsph", "surface.method=none"]);
    assert_eq!(essential(&gpu, &dfsph), chain(&[own.as_slice(), &["ShiftPositions"]].concat()));
}

#[test]
fn a_scene_steps_down_from_module_to_module_and_says_so() {
    let gpu = device(&[]);
    let scene = scene("dam-break", &["spacing_m=0.1", "solver.precision=relaxed"]);
    let (same, none) = start(&gpu, &scene).expect("it starts");
    assert!(none.is_empty() && same == scene);
    let has = |scene: &Scene, kernel: &str| {
        let plan = plan_of(scene, gpu.tier()).expect("a plan");
        plan.modules().find(|module| module.name.starts_with(kernel)).map(|module| module.name)
    };
    let mut now = scene.clone();
    for (kernel, setting) in [
        ("CorrectPositions", "solver.precision=full"),
        ("Anisotropy", "surface.anisotropic=false"),
        ("DrawSmoothNarrowRange", "surface.smoothing=bilateral"),
        ("DrawFluidDepth", "surface.method=marching-cubes"),
        ("GatherField", "surface.method=points"),
        ("DrawParticles", "surface.method=none"),
    ] {
        let module = has(&now, kernel).unwrap_or_else(|| panic!("{kernel} is not drawn"));
        gpu.refuse(module, "its worst element is off");
        let (next, concessions) = start(&gpu, &scene).expect("it steps down");
        let settings: Vec<&str> = concessions.iter().map(|concession| concession.setting.as_str()).collect();
        assert!(settings.contains(&setting), "{kernel}: {settings:?}");
        assert!(concessions.iter().any(|concession| concession.to_string().contains("its worst element is off")));
        assert_eq!(has(&next, module), None);
        now = next;
    }
    gpu.refuse(has(&now, "Predict").expect("it is there"), "it is broken");
    let error = start(&gpu, &scene).expect_err("nothing moves without it");
    assert!(error.to_string().contains("Predict") && error.to_string().contains("it is broken"), "{error}");
}

#[test]
fn a_pipeline_that_is_not_built_or_asks_for_too_much_is_done_without() {
    let gpu = device(&[]);
    let wanted = scene("dam-break", &["spacing_m=0.1", "outputs.images=1"]);
    let leaked = |name: &str, change: fn(&mut Module)| -> &'static Module {
        let mut module = *brooklet_kernels::modules().find(|module| module.name == name).expect("a module");
        change(&mut module);
        Box::leak(Box::new(module))
    };
    let not_built = leaked("Anisotropy", |module| module.spirv = Spirv::Plain(&[0; 8]));
    let too_wide = leaked("Anisotropy", |module| module.group_size = [1 << 20, 1, 1]);
    for (module, words) in [(not_built, "SPIR-V"), (too_wide, "1048576")] {
        let other = |own: &'static Module| (own.name == module.name).then_some(module);
        let (scene, concessions) = start_with(&gpu, &wanted, &other).expect("it steps down");
        assert!(!scene.surface.anisotropic, "{concessions:?}");
        let [concession] = concessions.as_slice() else { panic!("{concessions:?}") };
        let said = concession.to_string();
        assert!(said.contains("Anisotropy") && said.contains(words) && said.contains("anisotropic=false"), "{said}");
    }
    let (same, none) = start_with(&gpu, &wanted, &|_| None).expect("it starts");
    assert!(same == wanted && none.is_empty());
}

#[test]
fn a_format_that_is_missing_is_drawn_without() {
    let wanted = scene("dam-break", &["spacing_m=0.1"]);
    // Depths, which points have too, and no format that holds as much.
    let gpu = device(&[Format::R32Float, Format::Rg32Float, Format::Rgba32Float]);
    let (scene, concessions) = start(&gpu, &wanted).expect("it steps down");
    let last = concessions.last().expect("a concession");
    assert_eq!(last.setting, "surface.method=none", "{concessions:?}");
    assert!(last.reason.contains("R32Float"), "{}", last.reason);
    assert_ne!(scene, wanted);
    let error = start(&device(&[Format::Rgba8Unorm]), &wanted).expect_err("pictures are of it");
    assert!(error.to_string().contains("Rgba8Unorm"), "{error}");
}

#[test]
fn what_ended_a_program_and_cannot_be_done_without_is_tried_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let careful = || {
        let options = GpuOptions {
            tier: Some(gpu().tier()),
            device_name: Some(gpu().info().name.clone()),
            pipeline_cache: Some(folder.path().to_owned()),
            watch_builds: true,
            ..GpuOptions::default()
        };
        Gpu::open(&options).expect("a device")
    };
    let scene = scene("dam-break", &["spacing_m=0.1", "outputs.images=0"]);
    start(&careful(), &scene).expect("it starts");
    let Some(kept) = std::fs::read_dir(folder.path()).expect("a folder").flatten().next() else { return };
    let stem = kept.file_name().into_string().expect("a name");
    // As programs leave it that are gone: no process has this number.
    std::fs::write(folder.path().join(format!("{stem}.{}.0.building", u32::MAX)), "CountCells").expect("written");
    let gpu = careful();
    assert_eq!(gpu.refused().iter().map(|(module, _)| module.as_str()).collect::<Vec<_>>(), ["CountCells"]);
    let (same, concessions) = start(&gpu, &scene).expect("it is tried again");
    assert!(same == scene && concessions.is_empty() && gpu.refused().is_empty());
    // What is known to be wrong is not.
    gpu.refuse("CountCells", "its worst element is off");
    assert!(!gpu.trust("CountCells") && start(&gpu, &scene).is_err());
}
