//! Surfaces that come and go on one device: memory goes back to what it was, and a format that a device lacks is
//! said by name before anything is allocated.

use brooklet_fluid::{Scene, record};
use brooklet_gpu::{Engine, Gpu, GpuError, GpuOptions, Plan, RecordingId, Resources, check_formats};
use brooklet_kernels::Format;
use brooklet_render::{FrameOptions, Particles, View, frame};
use brooklet_tests::gpu;
use wgpu::{TextureFormatFeatureFlags as Can, TextureFormatFeatures, TextureUsages};

/// Every surface there is, and what is optional of it.
const SURFACES: [&str; 6] = [
    "surface.method=none",
    "surface.method=points",
    "surface={ method = 'screen-space', caustics = true }",
    "surface={ method = 'screen-space', caustics = false, anisotropic = false, smoothing = 'none' }",
    "surface={ method = 'screen-space', smoothing = 'curvature-flow', iterations = 3 }",
    "surface={ method = 'points', color_by = 'density' }",
];

/// The plan of a scene with its picture, and the stages it brings.
fn plan(setting: &str) -> (Plan, [RecordingId; 4]) {
    let small = ["spacing_m=0.1", "outputs.width_px=48", "outputs.height_px=32", "outputs.measure_every_steps=0"];
    let settings: Vec<String> = small.iter().chain([&setting]).map(|s| s.to_string()).collect();
    let scene = Scene::load("calm-pool", &settings).expect("a scene");
    let mut resources = Resources::new();
    let recorded = record(&mut resources, &scene);
    let mut recordings = recorded.recordings();
    let options = FrameOptions::for_scene(&scene, gpu().tier());
    let passes =
        frame::record(&mut resources, &View::of_scene(&scene), &Particles::of(&recorded), &options).expect("a frame");
    let color = passes.color.id;
    let ids = [recorded.init.id(), passes.init.id(), recorded.step.id(), passes.draw.id()];
    recordings.extend([passes.init, passes.draw]);
    (Plan::sweep(resources, recordings, &[color]).expect("a plan"), ids)
}

/// A step and a picture of it, and what the engine had allocated for them.
fn draw(gpu: &Gpu, setting: &str) -> u64 {
    let (plan, ids) = plan(setting);
    let mut engine = Engine::new(gpu, plan).expect("an engine");
    engine.run(&ids, &[]).expect("it draws");
    engine.finish().expect("it ends");
    engine.allocated_bytes()
}

/// What the driver holds for this device, as wgpu's allocator counts it.
fn held_bytes(gpu: &Gpu) -> u64 {
    // Once to let go of what was dropped, once more of what that let go of.
    for _ in 0..2 {
        gpu.device().poll(wgpu::PollType::wait_indefinitely()).expect("it waits");
    }
    gpu.device().generate_allocator_report().expect("Vulkan's allocator reports").total_allocated_bytes
}

#[test]
fn surfaces_that_come_and_go_leave_nothing() {
    // A device of its own: other tests allocate, too.
    let options =
        GpuOptions { tier: Some(gpu().tier()), device_name: Some(gpu().info().name.clone()), ..Default::default() };
    let gpu = Gpu::open(&options).expect("a device");
    // What the first of each leaves for good: pipelines, and the pool's memory.
    let first: Vec<u64> = SURFACES.iter().map(|setting| draw(&gpu, setting)).collect();
    assert!(first[0] < first[1] && first[1] < first[2], "{first:?}");
    gpu.trim();
    let before = held_bytes(&gpu);
    for round in 0..50 {
        let surface = (5 * round + 2) % SURFACES.len();
        assert_eq!(draw(&gpu, SURFACES[surface]), first[surface], "round {round}: {}", SURFACES[surface]);
        assert!(gpu.pooled_bytes() <= first.iter().sum(), "round {round}: {} bytes pooled", gpu.pooled_bytes());
    }
    gpu.trim();
    assert_eq!(gpu.pooled_bytes(), 0);
    let after = held_bytes(&gpu);
    println!("50 changes of surface: {before} bytes held before, {after} after; a surface takes {first:?}");
    assert_eq!(after, before);
    // The count can fail: what is kept is counted.
    let kept = Engine::new(&gpu, plan(SURFACES[2]).0).expect("an engine");
    assert!(held_bytes(&gpu) >= before + kept.allocated_bytes(), "what an engine holds is not in the report");
}

/// A device that can do everything with every format but `lacking`.
fn all_but(lacking: Format, usage: TextureUsages, can: Can) -> impl Fn(Format) -> TextureFormatFeatures {
    move |format| {
        let all = TextureFormatFeatures { allowed_usages: TextureUsages::all(), flags: Can::all() };
        match format == lacking {
            true => TextureFormatFeatures { allowed_usages: all.allowed_usages - usage, flags: all.flags - can },
            false => all,
        }
    }
}

#[test]
fn a_format_that_is_missing_is_said_by_name() {
    let (none, draw) = (TextureUsages::empty(), TextureUsages::RENDER_ATTACHMENT);
    let water = plan(SURFACES[2]).0;
    for (lacking, usage, can, texture, used_as) in [
        (Format::R16Float, none, Can::BLENDABLE, "thickness", "blended to"),
        (Format::R16Float, none, Can::FILTERABLE, "thickness", "read with a filter"),
        (Format::R32Float, draw, Can::empty(), "inverse_depth", "drawn to"),
        (Format::Rgba16Float, none, Can::BLENDABLE, "", "blended to"),
        (Format::Rgba8Unorm, draw, Can::empty(), "picture", "drawn to"),
    ] {
        let error = check_formats("a phone", &water, &all_but(lacking, usage, can)).expect_err("a format is missing");
        let text = error.to_string();
        let names = [format!("{lacking:?}"), texture.into(), used_as.into(), "a phone".into()];
        assert!(names.iter().all(|name| text.contains(name)), "{text}");
        assert!(matches!(error, GpuError::MissingFormat { .. }));
    }
    // What nothing is drawn with, nobody misses: R32Float is never blended, nor R16Float drawn by points.
    assert_eq!(
        check_formats("a phone", &water, &all_but(Format::R32Float, none, Can::BLENDABLE | Can::FILTERABLE)),
        Ok(())
    );
    let points = plan(SURFACES[1]).0;
    assert_eq!(check_formats("a phone", &points, &all_but(Format::R16Float, TextureUsages::all(), Can::all())), Ok(()));
    // And what is promised of each format anywhere is enough for every surface.
    let guaranteed = |format| brooklet_gpu::texture_format(format).guaranteed_format_features(wgpu::Features::empty());
    for setting in SURFACES {
        assert_eq!(check_formats("any device", &plan(setting).0, &guaranteed), Ok(()), "{setting}");
    }
}
