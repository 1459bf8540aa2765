//! What a window asks of the engine while it runs: progress, few frames in flight, pictures that come
//! back without a stall, and other shaders over the same memory.

use crate::support::{DrawHalf, Increment, Scale, compute, gpu, only, words};
use brooklet_gpu::{
    DrawState, Engine, FRAMES_IN_FLIGHT, Format, Gpu, GpuError, Load, Plan, Resources, Targets, Texture,
};
use brooklet_kernels::{Access, Buffer, Module};

/// `counter += 1` twice over `len` words, of which `scaled` is three times as much and one.
fn counting(len: u32) -> (Plan, Buffer<u32>, Buffer<u32>) {
    let mut resources = Resources::new();
    let mut counter = resources.persistent::<u32>("counter", len);
    let mut scaled = resources.persistent::<u32>("scaled", len);
    let mut factor = resources.buffer::<[u32; 4]>("factor", 1);
    let mut step = resources.recording("step");
    step.upload(&mut factor, &[[3, 0, 0, 0]]);
    step.dispatch(&Increment { values: counter.write() }, len);
    step.dispatch(&Increment { values: counter.write() }, len);
    step.dispatch(&Scale { from: counter.read(), to: scaled.write(), factor: factor.uniform() }, len);
    (Plan::sweep(resources, vec![step], &[]).expect("a plan"), counter, scaled)
}

#[test]
fn making_an_engine_says_how_far_it_is_from_any_thread() {
    let gpu = gpu();
    let (plan, counter, _) = counting(100);
    let (mut engine, said) = std::thread::spawn(move || {
        let mut said = Vec::new();
        let mut say = |done: usize, total: usize, what: &str| said.push((done, total, what.to_owned()));
        let engine = Engine::new_with_progress(&gpu, plan, &mut say).expect("an engine");
        (engine, said)
    })
    .join()
    .expect("the thread ends");
    let said: Vec<_> = said.iter().map(|(done, total, what)| (*done, *total, what.as_str())).collect();
    let expected =
        [(0, 3, "counter"), (0, 3, "scaled"), (0, 3, "factor"), (1, 3, "memory"), (2, 3, "Increment"), (3, 3, "Scale")];
    assert_eq!(said, expected);
    let recording = only(&engine);
    engine.run(&[recording], &[]).expect("it runs");
    assert_eq!(engine.read(&counter).expect("counter"), [2; 100]);
}

#[test]
fn engines_are_made_on_one_thread_while_another_runs_its_own() {
    let gpu = gpu();
    let (plan, counter, _) = counting(5000);
    let mut running = Engine::new(&gpu, plan.clone()).expect("an engine");
    let making = std::thread::spawn(move || {
        (0..8)
            .map(|_| {
                // Modules that the device has not seen, so that each time something is built.
                let by_ten = increment_by_ten();
                let changed = plan
                    .clone()
                    .with_modules(|module| (module.name == "Increment").then_some(by_ten))
                    .expect("it fits");
                let broken: &'static Module = Box::leak(Box::new(Module { shared_bytes: u32::MAX, ..*by_ten }));
                let refused = plan
                    .clone()
                    .with_modules(|module| (module.name == "Increment").then_some(broken))
                    .expect("it fits");
                assert!(Engine::new(&gpu, refused).is_err(), "an error here is this thread's own");
                let mut made = Engine::new(&gpu, changed).expect("an engine");
                let recording = only(&made);
                made.run(&[recording], &[]).expect("it runs");
                made.read(&counting(5000).1).expect("counter")
            })
            .all(|values| values == [20; 5000])
    });
    let mut frames = 0;
    while frames < 20 || !making.is_finished() {
        let recording = only(&running);
        running.run(&[recording], &[]).expect("it runs");
        frames += 1;
    }
    assert!(making.join().expect("the thread ends"));
    assert_eq!(running.read(&counter).expect("counter"), vec![2 * frames; 5000]);
}

#[test]
fn frames_in_flight_and_reports_are_all_frames() {
    let (plan, counter, _) = counting(100_000);
    let mut engine = Engine::new(&gpu(), plan).expect("an engine");
    assert_eq!(engine.in_flight(), 0);
    let mut reports = 0;
    for frame in 1..=20 {
        let recording = only(&engine);
        engine.run(&[recording], &[counter.id]).expect("it runs");
        let in_flight = engine.in_flight();
        assert!(in_flight <= FRAMES_IN_FLIGHT);
        // What `in_flight` no longer counts is in the reports, and maybe more since.
        reports += engine.reports().len();
        assert!(reports + in_flight >= frame && reports <= frame, "{reports} + {in_flight} of {frame}");
    }
    while engine.in_flight() > 0 {
        std::thread::yield_now();
    }
    assert_eq!(reports + engine.reports().len(), 20);
}

struct Painting {
    engine: Engine,
    color: Buffer<[f32; 4]>,
    picture: Texture,
}

fn painting(gpu: &Gpu, size_px: [u32; 2], format: Format) -> Painting {
    let mut resources = Resources::new();
    let color = resources.persistent::<[f32; 4]>("color", 1);
    let picture = resources.texture("picture", format, size_px);
    let mut frame = resources.recording("frame");
    let targets = Targets { color: vec![(&picture, Load::Clear([0.0, 0.0, 1.0, 1.0]))], depth: None };
    frame.draw(&DrawHalf { color: color.uniform() }, &targets, DrawState::default(), 3, 1);
    let plan = Plan::sweep(resources, vec![frame], &[picture.id]).expect("a plan");
    Painting { engine: Engine::new(gpu, plan).expect("an engine"), color, picture }
}

#[test]
fn textures_come_back_with_their_frame_without_padding_or_new_memory() {
    let gpu = gpu();
    // Rows of less than, exactly, and a little more than the 256 bytes that copies align them to.
    for (size_px, format) in [
        ([20, 12], Format::Rgba8Unorm),
        ([64, 3], Format::Rgba8Unorm),
        ([65, 5], Format::Rgba8Unorm),
        ([7, 9], Format::R16Float),
        ([33, 2], Format::Rgba16Float),
    ] {
        let Painting { mut engine, color, picture } = painting(&gpu, size_px, format);
        let red = |frame: u64| [[frame as f32 / 8.0, 1.0, 0.0, 1.0]];
        // Each frame's picture, read one by one with waiting.
        let mut expected = Vec::new();
        for frame in 0..8 {
            engine.write(&color, &red(frame));
            let recording = only(&engine);
            engine.run(&[recording], &[]).expect("it runs");
            expected.push(engine.read_texture(&picture).expect("the picture"));
        }
        assert!(expected.windows(2).all(|two| two[0] != two[1]), "the frames differ");
        engine.finish().expect("it finishes");
        let mut reports = Vec::new();
        let mut allocations = 0;
        for frame in 0..8 {
            engine.write(&color, &red(frame));
            let recording = only(&engine);
            engine.run(&[recording], &[color.id, picture.id, color.id]).expect("it runs");
            reports.extend(engine.reports());
            if frame + 1 == FRAMES_IN_FLIGHT as u64 {
                allocations = engine.allocation_count();
            }
        }
        assert_eq!(engine.allocation_count(), allocations, "the ring is warm");
        reports.extend(engine.finish().expect("it finishes"));
        assert_eq!(reports.len(), 8);
        for (frame, (report, expected)) in reports.iter().zip(&expected).enumerate() {
            let ids: Vec<_> = report.readbacks.iter().map(|(id, _)| *id).collect();
            assert_eq!(ids, [color.id, picture.id, color.id]);
            assert!(report.readbacks[1].1 == *expected, "{size_px:?} {format:?}, frame {frame}");
            for (_, bytes) in [&report.readbacks[0], &report.readbacks[2]] {
                assert_eq!(bytemuck::pod_collect_to_vec::<u8, [f32; 4]>(bytes), red(frame as u64));
            }
        }
    }
}

#[test]
fn a_texture_that_cannot_come_back_is_refused_and_says_why() {
    let gpu = gpu();
    let mut resources = Resources::new();
    let color = resources.persistent::<[f32; 4]>("color", 1);
    let picture = resources.texture("picture", Format::Rgba8Unorm, [4, 4]);
    let inverse_depth = resources.texture("inverse_depth", Format::Depth24Plus, [4, 4]);
    let spare = resources.texture("spare", Format::Rgba8Unorm, [4, 4]);
    let mut frame = resources.recording("frame");
    let targets =
        Targets { color: vec![(&picture, Load::Clear([0.0; 4]))], depth: Some((&inverse_depth, Load::Clear(1.0))) };
    frame.draw(&DrawHalf { color: color.uniform() }, &targets, DrawState::default(), 3, 1);
    let plan = Plan::sweep(resources, vec![frame], &[picture.id]).expect("a plan");
    let mut engine = Engine::new(&gpu, plan).expect("an engine");
    for (id, words) in
        [(spare.id, "spare cannot be read: the plan left it out"), (inverse_depth.id, "use Depth32Float")]
    {
        let recording = only(&engine);
        let error = engine.run(&[recording], &[id]).expect_err(words).to_string();
        assert!(error.contains(words), "{error}");
    }
    let recording = only(&engine);
    engine.run(&[recording], &[picture.id]).expect("it runs all the same");
    assert_eq!(engine.finish().expect("it finishes").len(), 1, "what was refused was no frame");
}

/// `values[i] += 10`, bound as [`Increment`] binds.
fn increment_by_ten() -> &'static Module {
    Box::leak(Box::new(compute(
        "Increment",
        "@group(0) @binding(0) var<storage, read_write> values: array<u32>;
         @compute @workgroup_size(64)
         fn main(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) thread: u32) {
             let i = group.x * 64u + thread;
             if (i < arrayLength(&values)) { values[i] = values[i] + 10u; }
         }",
        vec![words("values", 0, Access::ReadWrite)],
    )))
}

#[test]
fn other_shaders_take_over_the_memory_and_a_failure_leaves_the_old_ones_running() {
    let gpu = gpu();
    let (plan, counter, scaled) = counting(1000);
    let mut engine = Engine::new(&gpu, plan.clone()).expect("an engine");
    let by_ten = increment_by_ten();
    let changed = plan.clone().with_modules(|module| (module.name == "Increment").then_some(by_ten)).expect("it fits");
    for _ in 0..3 {
        let recording = only(&engine);
        engine.run(&[recording], &[counter.id]).expect("it runs");
    }
    let bytes = engine.allocated_bytes();
    // Three frames are under way, and end with what they began with.
    engine.swap_modules(changed.clone()).expect("it is taken");
    assert_eq!(engine.allocated_bytes(), bytes, "nothing is allocated twice");
    let recording = only(&engine);
    assert_eq!(engine.run(&[recording], &[counter.id]), Ok(3), "frames go on counting");

    let broken: &'static Module =
        Box::leak(Box::new(Module { spirv: brooklet_kernels::Spirv::Plain(&[0; 64]), ..*by_ten }));
    let refused = plan.clone().with_modules(|module| (module.name == "Increment").then_some(broken)).expect("it fits");
    let error = engine.swap_modules(refused).expect_err("no SPIR-V").to_string();
    assert!(error.contains("kernel Increment: it is no SPIR-V"), "{error}");
    let recording = only(&engine);
    engine.run(&[recording], &[counter.id]).expect("it goes on with the last good ones");

    let seen: Vec<u32> = engine
        .finish()
        .expect("it finishes")
        .iter()
        .map(|report| bytemuck::pod_collect_to_vec::<u8, u32>(&report.readbacks[0].1)[999])
        .collect();
    assert_eq!(seen, [2, 4, 6, 26, 46]);
    assert_eq!(engine.read(&counter).expect("counter"), [46; 1000]);
    assert_eq!(engine.read(&scaled).expect("scaled"), [139; 1000]);
    assert!(std::ptr::eq(engine.plan().passes()[0].module, by_ten));
    engine.swap_modules(plan).expect("and back");
    let recording = only(&engine);
    engine.run(&[recording], &[]).expect("it runs");
    assert_eq!(engine.read(&counter).expect("counter"), [48; 1000]);
}

#[test]
fn a_plan_over_other_memory_is_not_taken() {
    let (plan, counter, _) = counting(64);
    let mut engine = Engine::new(&gpu(), plan).expect("an engine");
    let refused = |engine: &mut Engine, plan: Plan, words: &str| match engine.swap_modules(plan) {
        Err(error @ GpuError::OtherMemory { .. }) => assert!(error.to_string().contains(words), "{error}"),
        other => panic!("{other:?}"),
    };
    refused(&mut engine, counting(65).0, "counter: the two plans declare it differently");
    let mut fewer = Resources::new();
    fewer.persistent::<u32>("counter", 64);
    let plan = Plan::sweep(fewer, vec![], &[]).expect("a plan");
    refused(&mut engine, plan, "scaled: the two plans declare it differently");
    let recording = only(&engine);
    engine.run(&[recording], &[]).expect("it runs as before");
    assert_eq!(engine.read(&counter).expect("counter"), [2; 64]);
}
