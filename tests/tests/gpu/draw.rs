//! Render passes of the engine, on pictures small enough to check every pixel.

use crate::support::{DrawHalf, DrawSwapped, gpu};
use brooklet_gpu::{Blend, DepthTest, DrawState, Engine, Format, Load, Plan, Resources, Targets};

const SIZE: [u32; 2] = [20, 12];

fn pixel(picture: &[u8], x: u32, y: u32) -> [u8; 4] {
    let start = 4 * (y * SIZE[0] + x) as usize;
    [picture[start], picture[start + 1], picture[start + 2], picture[start + 3]]
}

#[test]
fn a_triangle_covers_its_half_and_a_sampled_copy_is_exact() {
    let gpu = gpu();
    let mut resources = Resources::new();
    let mut color = resources.buffer::<[f32; 4]>("color", 1);
    let picture = resources.texture("picture", Format::Rgba8Unorm, SIZE);
    let copy = resources.texture("copy", Format::Rgba8Unorm, SIZE);
    let mut frame = resources.recording("frame");
    frame.upload(&mut color, &[[1.0, 0.5, 0.0, 1.0]]);
    let targets = Targets { color: vec![(&picture, Load::Clear([0.0, 0.0, 1.0, 1.0]))], depth: None };
    frame.draw(&DrawHalf { color: color.uniform() }, &targets, DrawState::default(), 3, 1);
    let targets = Targets { color: vec![(&copy, Load::Clear([0.0; 4]))], depth: None };
    frame.draw(&DrawSwapped { picture: picture.read() }, &targets, DrawState::default(), 3, 1);
    let frame_id = frame.id();
    let plan = Plan::sweep(resources, vec![frame], &[copy.id]).expect("a plan");
    let mut engine = Engine::new(&gpu, plan).expect("an engine");
    engine.run(&[frame_id], &[]).expect("it runs");
    let picture = engine.read_texture(&picture).expect("the picture");
    let copy = engine.read_texture(&copy).expect("the copy");
    assert_eq!(picture.len(), 4 * (SIZE[0] * SIZE[1]) as usize, "no padding");
    assert_eq!(pixel(&picture, 1, SIZE[1] - 2), [255, 128, 0, 255], "lower left");
    assert_eq!(pixel(&picture, SIZE[0] - 2, 1), [0, 0, 255, 255], "upper right");
    for y in 0..SIZE[1] {
        for x in 0..SIZE[0] {
            let [r, g, b, a] = pixel(&picture, x, y);
            assert_eq!(pixel(&copy, x, y), [b, g, r, a], "pixel {x}, {y}");
        }
    }
    let report = engine.finish().expect("it finishes").remove(0);
    let stages: Vec<_> = report.spans.iter().map(|span| span.stage).collect();
    assert_eq!(stages, ["draw_half", "draw_swapped"]);
}

#[test]
fn kept_targets_share_a_pass_and_depth_and_blending_hold() {
    let gpu = gpu();
    let mut resources = Resources::new();
    let mut green = resources.buffer::<[f32; 4]>("green", 1);
    let mut red = resources.buffer::<[f32; 4]>("red", 1);
    let picture = resources.texture("picture", Format::Rgba8Unorm, SIZE);
    let depth = resources.texture("depth", Format::Depth32Float, SIZE);
    let mut frame = resources.recording("frame");
    frame.upload(&mut green, &[[0.0, 1.0, 0.0, 1.0]]);
    frame.upload(&mut red, &[[1.0, 0.0, 0.0, 0.5]]);
    let first = Targets { color: vec![(&picture, Load::Clear([0.0; 4]))], depth: Some((&depth, Load::Clear(1.0))) };
    let then = Targets { color: vec![(&picture, Load::Keep)], depth: Some((&depth, Load::Keep)) };
    let solid = DrawState { depth_test: DepthTest::Less, depth_write: true, ..DrawState::default() };
    // At the same depth: the strict test hides the second, and the third is mixed in.
    frame.draw(&DrawHalf { color: green.uniform() }, &first, solid, 3, 1);
    frame.draw(&DrawHalf { color: red.uniform() }, &then, solid, 3, 1);
    let mixed = DrawState { depth_test: DepthTest::LessEqual, blend: Blend::Alpha, ..DrawState::default() };
    frame.draw(&DrawHalf { color: red.uniform() }, &then, mixed, 3, 1);
    let frame_id = frame.id();
    let plan = Plan::sweep(resources, vec![frame], &[picture.id, depth.id]).expect("a plan");
    let mut engine = Engine::new(&gpu, plan).expect("an engine");
    engine.run(&[frame_id], &[]).expect("it runs");
    let colours = engine.read_texture(&picture).expect("the picture");
    // Half red over green; drivers may round a half either way.
    let [r, g, b, a] = pixel(&colours, 1, SIZE[1] - 2);
    assert!((127..=128).contains(&r) && (127..=128).contains(&g) && b == 0, "{r} {g} {b} {a}");
    assert_eq!(pixel(&colours, SIZE[0] - 2, 1), [0; 4], "cleared");
    let depths: Vec<f32> = bytemuck::pod_collect_to_vec(&engine.read_texture(&depth).expect("depth"));
    let at = |x: u32, y: u32| depths[(y * SIZE[0] + x) as usize];
    assert_eq!((at(1, SIZE[1] - 2), at(SIZE[0] - 2, 1)), (0.5, 1.0));
    assert_eq!(engine.dispatch_count(), 3);
}

#[test]
fn indirect_draws_draw_what_the_gpu_says() {
    let gpu = gpu();
    let mut resources = Resources::new();
    let mut color = resources.buffer::<[f32; 4]>("color", 1);
    let args = resources.persistent::<[u32; 6]>("args", 1);
    let picture = resources.texture("picture", Format::Rgba8Unorm, SIZE);
    let mut frame = resources.recording("frame");
    frame.upload(&mut color, &[[0.25, 0.0, 0.0, 1.0]]);
    let targets = Targets { color: vec![(&picture, Load::Clear([0.0, 0.0, 0.0, 1.0]))], depth: None };
    let add = DrawState { blend: Blend::Additive, ..DrawState::default() };
    frame.draw_indirect(&DrawHalf { color: color.uniform() }, &targets, add, &args, 8, 3);
    let frame_id = frame.id();
    let plan = Plan::sweep(resources, vec![frame], &[picture.id]).expect("a plan");
    assert!(plan.passes()[0].indirect);
    let mut engine = Engine::new(&gpu, plan).expect("an engine");
    // Each instance adds a quarter of red; with no instance the target is cleared all the same.
    for instances in [0_u32, 1, 3] {
        engine.write(&args, &[[7, 7, 3, instances, 0, 0]]);
        engine.run(&[frame_id], &[]).expect("it runs");
        let colours = engine.read_texture(&picture).expect("the picture");
        let [red, ..] = pixel(&colours, 1, SIZE[1] - 2);
        // 8 bits round each sum.
        assert!(red.abs_diff((63.75 * f64::from(instances)).round() as u8) <= 2, "{red} of {instances} instances");
        assert_eq!(pixel(&colours, SIZE[0] - 2, 1), [0, 0, 0, 255]);
    }
}
