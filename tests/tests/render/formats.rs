//! Textures in another format, where the device cannot do with the best what a picture does with it: what is drawn, and said.

use brooklet_fluid::{FrameRequest, Scene, Session};
use brooklet_gpu::{FormatUse, Gpu, GpuOptions, Plan};
use brooklet_kernels::{Format, Tier};
use brooklet_render::{Concession, FramePasses, ScenePlan, StartError, start_stepping_down};
use brooklet_tests::gpu;

/// A device that cannot do some things with some formats.
fn device(without: &[(Format, FormatUse)]) -> Gpu {
    let options = GpuOptions {
        tier: Some(gpu().tier()),
        device_name: Some(gpu().info().name.clone()),
        without_formats: without.to_vec(),
        ..GpuOptions::default()
    };
    Gpu::open(&options).expect("a device")
}

/// Every kind of texture that a picture has.
fn scene(method: &str) -> Scene {
    let settings = ["spacing_m=0.08", "outputs.width_px=96", "outputs.height_px=72", "solver.deterministic=true"];
    let caustics = format!("surface.caustics={}", method != "points");
    let method = format!("surface.method='{method}'");
    let settings = settings.into_iter().chain([method.as_str(), &caustics]);
    Scene::load("dam-break", &settings.map(str::to_owned).collect::<Vec<_>>()).expect("a scene")
}

/// The picture after two steps, and what the device did without.
fn picture(gpu: &Gpu, scene: &Scene) -> (Vec<u8>, Vec<Concession>) {
    let plan = |scene: &Scene| -> Option<Plan> { Some(ScenePlan::of_count(scene, 64, gpu.tier()).ok()?.session.plan) };
    let start = |scene: &Scene| -> Result<(Session, FramePasses), StartError> {
        let planned = ScenePlan::new(scene, gpu.tier()).expect("a plan");
        Ok((brooklet_render::start(gpu, planned.session)?, planned.passes.expect("a picture")))
    };
    let cause = |error: &StartError| Some(error.gpu_error().clone());
    let ((mut session, passes), same, concessions) =
        start_stepping_down(gpu, scene, &plan, start, cause).expect("it starts");
    assert!(same == *scene, "a format has others: no setting is given up: {concessions:?}");
    session.submit(&FrameRequest { steps: 2, then: &[passes.draw.id()], ..FrameRequest::default() }).expect("it runs");
    session.finish().expect("it ends");
    let again = ScenePlan::new(scene, gpu.tier()).expect("a plan");
    assert!(session.apply(&again.session).expect("it applies"), "a changed number needs no other engine");
    (session.engine_mut().read_texture(&passes.color).expect("a picture"), concessions)
}

/// Mean and largest difference of two pictures, in 255ths.
fn difference(one: &[u8], other: &[u8]) -> (f64, u8) {
    let differences = one.iter().zip(other).map(|(a, b)| a.abs_diff(*b));
    (differences.clone().map(f64::from).sum::<f64>() / one.len() as f64, differences.max().unwrap_or_default())
}

/// What other formats round off, and a few times as much: .02 in the mean and 1 in a pixel on lavapipe.
const MOST: (f64, u8) = (0.1, 4);

#[test]
fn pictures_in_other_formats_are_the_same() {
    let any = |formats: &[Format]| formats.iter().map(|format| (*format, FormatUse::Any)).collect::<Vec<_>>();
    let best = device(&[]);
    for method in ["screen-space", "marching-cubes", "points"] {
        let scene = scene(method);
        let (expected, none) = picture(&best, &scene);
        assert!(none.is_empty(), "{none:?}");
        let depth = match best.tier() {
            Tier::Floor => Format::Depth24Plus,
            Tier::Mobile | Tier::Desktop => Format::Depth32Float,
        };
        // What is taken away, a texture, what it has instead; and whether not a bit changes for it.
        let inverse = if method == "points" { "seen" } else { "inverse_depth" };
        let mut cases = vec![
            (vec![(Format::R32Float, FormatUse::Drawn)], inverse, Format::Rg32Float, "drawn to", true),
            (any(&[Format::R32Float, Format::Rg32Float]), inverse, Format::Rgba32Float, "drawn to", true),
            (any(&[depth]), "depth", Format::Depth24Plus, "a depth buffer", false),
        ];
        if method != "points" {
            let (one, two) = (Format::R16Float, Format::Rg16Float);
            cases.extend([
                (vec![(one, FormatUse::Blended)], "thickness", two, "blended to", true),
                (vec![(one, FormatUse::Filtered)], "thickness", two, "read with a filter", true),
                (any(&[one, two]), "thickness", Format::Rgba16Float, "blended to", true),
                (any(&[Format::Rgba32Float]), "opaque_planes", Format::Rgba16Float, "drawn to", false),
            ]);
        }
        if best.tier() == Tier::Desktop {
            cases.push((any(&[Format::Rgba16Float]), "radiance", Format::Rgba32Float, "", false));
        }
        for (without, texture, format, used_as, is_exact) in cases {
            let format = if format == depth { Format::Depth32Float } else { format };
            let (got, concessions) = picture(&device(&without), &scene);
            let (mean, most) = difference(&got, &expected);
            println!("{method} without {without:?}: {texture} in {format:?}: mean {mean:.4}, most {most} of 255");
            let said = concessions
                .iter()
                .find(|said| said.setting.ends_with(&format!("in {format:?}")) && said.setting.contains(texture));
            let said = said.unwrap_or_else(|| panic!("{texture} in {format:?} is not among {concessions:?}"));
            assert!(said.reason.contains(used_as) && said.reason.contains("cannot use"), "{}", said.reason);
            assert!(!is_exact || got == expected, "{method} without {without:?}: {mean}, {most}");
            assert!(mean <= MOST.0 && most <= MOST.1, "{method} without {without:?}: {mean}, {most}");
        }
        // The comparison sees another picture.
        let other = Scene::from_toml(&scene.to_toml(), "other.toml", &["fluid.0.block.max_m=[0.3, 0.4, 0.3]".into()]);
        let (other, _) = picture(&best, &other.expect("a scene"));
        assert!(difference(&other, &expected).0 > 10.0 * MOST.0);
    }
}
