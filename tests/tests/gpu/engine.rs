//! The engine on a real driver: recordings give the right numbers, what is left out does not
//! exist, results come back in order, and every failure is an error that says what to do.

use crate::support::{Any, Arguments, Increment, Scale, compute, gpu, only, options, words};
use brooklet_gpu::{
    Engine, FrameReport, Gpu, GpuError, GpuOptions, LeftOutKind, Plan, RecordingId, Resources, SpanFlag, Tier,
    TimingStatus,
};
use brooklet_kernels::{Access, Module};

/// `counter += 1` over `len` words in recording `step`.
struct Counting {
    engine: Engine,
    step: RecordingId,
    counter: brooklet_kernels::Buffer<u32>,
}

fn counting(gpu: &Gpu, len: u32) -> Counting {
    let mut resources = Resources::new();
    let mut counter = resources.persistent::<u32>("counter", len);
    let mut step = resources.recording("step");
    step.dispatch(&Increment { values: counter.write() }, len);
    let step_id = step.id();
    let plan = Plan::sweep(resources, vec![step], &[]).expect("a plan");
    Counting { engine: Engine::new(gpu, plan).expect("an engine"), step: step_id, counter }
}

#[test]
fn a_recording_runs_in_order_and_exactly() {
    let gpu = gpu();
    // Sizes past every edge: none, one, a group less one, a group, one more, a row of groups.
    for len in [0, 1, 63, 64, 65, 1000, 64 * 32_768 + 1] {
        let mut resources = Resources::new();
        let mut input = resources.buffer::<u32>("input", len);
        let mut middle = resources.buffer::<u32>("middle", len);
        let mut output = resources.persistent::<u32>("output", len);
        let mut factor = resources.buffer::<[u32; 4]>("factor", 1);
        let data: Vec<u32> = (0..len).map(|i| i.wrapping_mul(2_654_435_761)).collect();
        let mut run = resources.recording("run");
        run.upload(&mut input, &data);
        run.upload(&mut factor, &[[3, 0, 0, 0]]);
        run.clear(&mut middle);
        run.dispatch(&Scale { from: input.read(), to: middle.write(), factor: factor.uniform() }, len);
        // A second upload of the same buffer: what ran before it must have seen the first.
        run.upload(&mut factor, &[[5, 0, 0, 0]]);
        run.dispatch(&Scale { from: middle.read(), to: input.write(), factor: factor.uniform() }, len);
        run.copy(&input, &mut output);
        let run_id = run.id();
        let plan = Plan::sweep(resources, vec![run], &[]).expect("a plan");
        let mut engine = Engine::new(&gpu, plan).expect("an engine");
        engine.run(&[run_id], &[]).expect("it runs");
        let expected: Vec<u32> =
            data.iter().map(|x| x.wrapping_mul(3).wrapping_add(1).wrapping_mul(5).wrapping_add(1)).collect();
        assert!(engine.read(&output).expect("output") == expected, "{len} words");
    }
}

#[test]
fn a_buffer_is_bound_at_exactly_its_length() {
    // `Increment` asks the buffer for its length; more groups than it has elements must not reach
    // the rest of a pooled allocation.
    let gpu = gpu();
    let mut counting = counting(&gpu, 70);
    counting.engine.run(&[counting.step], &[]).expect("it runs");
    assert_eq!(counting.engine.read(&counting.counter).expect("read"), [1; 70]);
    assert_eq!(counting.engine.wgpu_buffer(counting.counter.id).map(|buffer| buffer.size() >= 280), Some(true));
}

#[test]
fn indirect_dispatches_run_what_the_gpu_says() {
    let gpu = gpu();
    let mut resources = Resources::new();
    let wanted = resources.persistent::<u32>("wanted", 1);
    let mut args = resources.buffer::<[u32; 3]>("args", 1);
    let mut values = resources.persistent::<u32>("values", 256);
    let mut run = resources.recording("run");
    run.dispatch(&Arguments { wanted: wanted.read(), args: args.write() }, 1);
    run.dispatch_indirect(&Increment { values: values.write() }, &args, 0, 256);
    let run_id = run.id();
    let plan = Plan::sweep(resources, vec![run], &[]).expect("a plan");
    let mut engine = Engine::new(&gpu, plan).expect("an engine");
    engine.write(&wanted, &[3]);
    engine.run(&[run_id], &[]).expect("it runs");
    engine.write(&wanted, &[1]);
    engine.run(&[run_id], &[]).expect("it runs");
    engine.write(&wanted, &[0]);
    engine.run(&[run_id], &[]).expect("it runs");
    let mut expected = vec![0; 256];
    expected[..192].fill(1);
    expected[..64].fill(2);
    assert_eq!(engine.read(&values).expect("values"), expected);
}

#[test]
fn indirect_arguments_are_read_behind_their_offset_and_must_be_there() {
    let gpu = gpu();
    let mut resources = Resources::new();
    let mut args = resources.buffer::<[u32; 5]>("args", 1);
    let mut values = resources.persistent::<u32>("values", 256);
    let mut run = resources.recording("run");
    run.upload(&mut args, &[[9, 9, 2, 1, 1]]);
    run.dispatch_indirect(&Increment { values: values.write() }, &args, 8, 256);
    run.dispatch_indirect(&Increment { values: values.write() }, &args, 8, 0);
    let run_id = run.id();
    assert!(run.errors().is_empty() && run.commands().len() == 2, "no items at most: nothing");
    let plan = Plan::sweep(resources, vec![run], &[]).expect("a plan");
    let pass = &plan.passes()[0];
    assert!(pass.indirect && pass.count == 1);
    let mut engine = Engine::new(&gpu, plan).expect("an engine");
    engine.run(&[run_id], &[]).expect("it runs");
    let mut expected = vec![0; 256];
    expected[..128].fill(1);
    assert_eq!(engine.read(&values).expect("values"), expected);

    for offset_bytes in [6, 12, 20, u32::MAX - 3] {
        let mut resources = Resources::new();
        let (args, mut values) = (resources.buffer::<[u32; 5]>("args", 1), resources.persistent::<u32>("values", 4));
        let mut run = resources.recording("run");
        run.dispatch_indirect(&Increment { values: values.write() }, &args, offset_bytes, 4);
        let error = run.errors()[0].to_string();
        let parts = [format!("12 bytes of arguments at byte {offset_bytes} of a buffer of 20"), "increment".into()];
        assert!(parts.iter().all(|part| error.contains(part)), "{error}");
        Plan::sweep(resources, vec![run], &[]).expect_err("the plan refuses it");
    }
}

#[test]
fn fifty_frames_come_back_in_order() {
    let gpu = gpu();
    let mut counting = counting(&gpu, 100);
    let mut reports: Vec<FrameReport> = Vec::new();
    for frame in 0..50 {
        let number = counting.engine.run(&[counting.step], &[counting.counter.id]).expect("it runs");
        assert_eq!(number, frame);
        if frame % 7 == 0 {
            reports.extend(counting.engine.reports());
        }
    }
    reports.extend(counting.engine.finish().expect("all finish"));
    assert_eq!(reports.len(), 50, "none is lost");
    for (frame, report) in reports.iter().enumerate() {
        assert_eq!(report.frame, frame as u64);
        let (id, bytes) = &report.readbacks[0];
        assert_eq!(*id, counting.counter.id);
        let values: Vec<u32> = bytemuck::pod_collect_to_vec(bytes);
        assert_eq!(values, vec![frame as u32 + 1; 100], "frame {frame} as it was then");
    }
    assert!(reports.is_sorted_by_key(|report| report.wall_ns));
}

#[test]
fn a_steady_frame_allocates_nothing() {
    let gpu = gpu();
    let mut counting = counting(&gpu, 100);
    for _ in 0..8 {
        counting.engine.run(&[counting.step], &[counting.counter.id]).expect("it runs");
    }
    let allocations = counting.engine.allocation_count();
    let bytes = counting.engine.allocated_bytes();
    for _ in 0..20 {
        counting.engine.run(&[counting.step], &[counting.counter.id]).expect("it runs");
    }
    assert_eq!(counting.engine.allocation_count(), allocations);
    assert_eq!(counting.engine.allocated_bytes(), bytes);
    // A larger frame needs more, so the counter can move.
    counting.engine.run(&[counting.step; 3000], &[]).expect("it runs");
    assert!(counting.engine.allocation_count() > allocations);
}

#[test]
fn every_dispatch_has_its_span() {
    let gpu = gpu();
    assert!(gpu.timing().is_measured(), "{:?}", gpu.timing());
    // Enough for a second query set.
    let mut counting = counting(&gpu, 64);
    counting.engine.run(&[counting.step; 2500], &[]).expect("it runs");
    let reports = counting.engine.finish().expect("it finishes");
    let report = &reports[0];
    assert_eq!(report.spans.len(), 2500);
    assert_eq!(report.timing, gpu.timing());
    assert_eq!(counting.engine.dispatch_count(), 2500);
    assert!(counting.engine.timestamp_query_count() > 2500);
    assert!(report.spans.iter().all(|span| span.stage == "increment" && span.recording == counting.step));
    assert!(report.spans.iter().any(|span| span.flag == SpanFlag::Ok), "some can be believed");
    let stages = report.stage_ms();
    assert_eq!((stages.len(), stages[0].0, stages[0].2), (1, "increment", 2500));
    let frame_ms = report.gpu_ms().expect("the frame has a time");
    assert!(stages[0].1 <= frame_ms * (1.0 + 1e-9), "{} ms in {frame_ms} ms", stages[0].1);
    assert_eq!(counting.engine.read(&counting.counter).expect("read"), [2500; 64]);
}

#[test]
fn without_timing_there_is_no_query() {
    let gpu = Gpu::open(&GpuOptions::default()).expect("a device");
    let mut counting = counting(&gpu, 64);
    counting.engine.run(&[counting.step; 10], &[]).expect("it runs");
    let reports = counting.engine.finish().expect("it finishes");
    assert_eq!(reports[0].timing, TimingStatus::Off);
    assert!(reports[0].spans.is_empty());
    assert_eq!(counting.engine.timestamp_query_count(), 0);
    assert_eq!(counting.engine.dispatch_count(), 10);
}

#[test]
fn what_nothing_wants_is_neither_run_nor_allocated() {
    let gpu = gpu();
    let build = |wanted: bool| {
        let mut resources = Resources::new();
        let mut kept = resources.persistent::<u32>("kept", 64);
        let mut unwanted = resources.buffer::<u32>("unwanted", 1 << 20);
        let mut step = resources.recording("step");
        step.clear(&mut unwanted);
        step.dispatch(&Increment { values: unwanted.write() }, 1 << 20);
        step.dispatch(&Increment { values: kept.write() }, 64);
        let outputs = if wanted { vec![unwanted.id] } else { Vec::new() };
        let step_id = step.id();
        let plan = Plan::sweep(resources, vec![step], &outputs).expect("a plan");
        let left_out = plan.left_out().to_vec();
        let mut engine = Engine::new(&gpu, plan).expect("an engine");
        engine.run(&[step_id], &[]).expect("it runs");
        assert_eq!(engine.read(&kept).expect("kept"), [1; 64]);
        (engine, unwanted, left_out)
    };
    let (mut with, unwanted, left_out) = build(true);
    assert!(left_out.is_empty(), "{left_out:?}");
    assert_eq!(with.dispatch_count(), 2);
    assert_eq!(with.read(&unwanted).expect("unwanted")[1_000_000], 1);

    let (mut without, unwanted, left_out) = build(false);
    assert_eq!(without.dispatch_count(), 1);
    assert_eq!(with.allocated_bytes() - without.allocated_bytes(), 4 << 20);
    assert_eq!(with.allocation_count() - without.allocation_count(), 1);
    assert!(without.wgpu_buffer(unwanted.id).is_none());
    let stage = left_out.iter().find(|entry| entry.kind == LeftOutKind::Stage);
    assert_eq!(
        stage.map(|entry| (entry.name.as_str(), entry.reason.as_str())),
        Some(("increment", "some of its runs: nothing wanted reads unwanted then"))
    );
    let error = without.read(&unwanted).expect_err("it has no memory");
    assert!(error.to_string().contains("unwanted cannot be read"), "{error}");
    let step = only(&without);
    assert!(without.run(&[step], &[unwanted.id]).is_err());
}

#[test]
fn memory_is_used_again_and_starts_at_zero() {
    let gpu = gpu();
    let mut first = counting(&gpu, 5000);
    first.engine.run(&[first.step], &[]).expect("it runs");
    drop(first);
    let pooled = gpu.pooled_bytes();
    assert!(pooled >= 20_000);
    let mut second = counting(&gpu, 5000);
    assert!(gpu.pooled_bytes() <= pooled - 20_000, "taken from the pool");
    second.engine.run(&[second.step], &[]).expect("it runs");
    assert_eq!(second.engine.read(&second.counter).expect("read"), [1; 5000]);
    drop(second);
    gpu.trim();
    assert_eq!(gpu.pooled_bytes(), 0);
}

#[test]
fn a_forced_floor_runs_with_the_floors_limits() {
    let floor = GpuOptions { tier: Some(Tier::Floor), ..options() };
    let gpu = Gpu::open(&floor).expect("every device reaches the floor");
    assert_eq!(gpu.tier(), Tier::Floor);
    let limits = gpu.device().limits();
    assert_eq!(limits.max_storage_buffers_per_shader_stage, 8);
    assert_eq!(limits.max_compute_invocations_per_workgroup, 256);
    assert_eq!(limits.max_storage_textures_per_shader_stage, 4);
    assert_eq!(limits.max_storage_buffer_binding_size, 128 << 20);
    let beyond = wgpu::Features::SUBGROUP | wgpu::Features::SHADER_F16;
    assert!(!gpu.device().features().intersects(beyond));
    let mut counting = counting(&gpu, 1000);
    counting.engine.run(&[counting.step; 2], &[]).expect("it runs");
    assert_eq!(counting.engine.read(&counting.counter).expect("read"), [2; 1000]);
}

#[test]
fn a_module_above_the_tier_or_its_limits_is_refused_by_name() {
    let floor = GpuOptions { tier: Some(Tier::Floor), ..options() };
    let gpu = Gpu::open(&floor).expect("a device");
    let source = "@group(0) @binding(0) var<storage, read_write> values: array<u32>;
                  @compute @workgroup_size(64) fn main() { values[0] = 1u; }";
    let module = compute("Fancy+HALF", source, vec![words("values", 0, Access::ReadWrite)]);
    let build = |module: Module| {
        let mut resources = Resources::new();
        let mut values = resources.persistent::<u32>("values", 1);
        let mut step = resources.recording("step");
        let module: &'static Module = Box::leak(Box::new(module));
        step.dispatch(&Any { module, values: values.write() }, 1);
        let plan = Plan::sweep(resources, vec![step], &[]).expect("a plan");
        Engine::new(&gpu, plan).map(|_| ())
    };
    assert_eq!(build(module), Ok(()));
    let above = build(Module { tier: Tier::Mobile, ..module }).expect_err("above the tier");
    assert!(above.to_string().contains("Fancy+HALF is made for the mobile tier"), "{above}");
    let wide = build(Module { group_size: [512, 1, 1], ..module }).expect_err("too many threads");
    assert!(wide.to_string().contains("512 threads a group"), "{wide}");
    let broken = build(Module { spirv: brooklet_kernels::Spirv::Plain(&[0; 64]), ..module }).expect_err("no SPIR-V");
    assert!(broken.to_string().contains("Fancy+HALF"), "{broken}");
}

#[test]
fn the_callers_own_device_serves() {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor {
        backends: wgpu::Backends::VULKAN,
        ..wgpu::InstanceDescriptor::new_without_display_handle()
    });
    let adapter = pollster::block_on(instance.request_adapter(&Default::default())).expect("one");
    let tier = brooklet_gpu::highest_tier(&adapter).expect("it reaches the floor");
    let open = |features| {
        pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor {
            required_features: features,
            required_limits: Gpu::required_limits(&adapter, tier),
            ..Default::default()
        }))
        .expect("it opens")
    };
    let (device, queue) = open(Gpu::required_features(&adapter));
    let gpu = Gpu::from_device(&adapter, device, queue, Some(tier)).expect("it serves");
    assert_eq!(gpu.info().name, adapter.get_info().name);
    let mut counting = counting(&gpu, 10);
    counting.engine.run(&[counting.step], &[]).expect("it runs");
    assert_eq!(counting.engine.read(&counting.counter).expect("read"), [1; 10]);

    let (device, queue) = open(wgpu::Features::empty());
    let error = Gpu::from_device(&adapter, device, queue, None).expect_err("no passthrough");
    assert!(error.to_string().contains("PASSTHROUGH_SHADERS"), "{error}");
}

#[test]
fn lesser_timestamps_are_used_and_said() {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor {
        backends: wgpu::Backends::VULKAN,
        ..wgpu::InstanceDescriptor::new_without_display_handle()
    });
    let adapter = pollster::block_on(instance.request_adapter(&Default::default())).expect("one");
    let run = |without: wgpu::Features| {
        let request = adapter.request_device(&wgpu::DeviceDescriptor {
            required_features: Gpu::required_features(&adapter) - without,
            required_limits: Gpu::required_limits(&adapter, Tier::Floor),
            ..Default::default()
        });
        let (device, queue) = pollster::block_on(request).expect("it opens");
        let gpu = Gpu::from_device(&adapter, device, queue, Some(Tier::Floor)).expect("it serves");
        let mut counting = counting(&gpu, 64);
        // More than a query set holds.
        counting.engine.run(&[counting.step; 2100], &[]).expect("it runs");
        let report = counting.engine.finish().expect("it finishes").remove(0);
        assert_eq!(counting.engine.read(&counting.counter).expect("read"), [2100; 64]);
        (report.timing, report.spans.len(), report.gpu_ms())
    };
    let (timing, spans, ms) = run(wgpu::Features::TIMESTAMP_QUERY_INSIDE_PASSES);
    assert_eq!((timing, spans), (TimingStatus::PassPerStage, 2100));
    assert!(ms.is_some_and(|ms| ms > 0.0));
    let all = wgpu::Features::TIMESTAMP_QUERY | wgpu::Features::TIMESTAMP_QUERY_INSIDE_PASSES;
    assert_eq!(run(all), (TimingStatus::Unsupported, 0, None));
}

#[test]
fn a_device_that_does_not_exist_is_answered_with_those_that_do() {
    let name = |name: &str| GpuOptions { device_name: Some(name.into()), ..options() };
    let error = Gpu::open(&name("no such card")).expect_err("there is none");
    let GpuError::NoSuchDevice { present, .. } = &error else {
        panic!("{error}");
    };
    let reports = brooklet_gpu::adapters();
    assert_eq!(present.len(), reports.len());
    for report in &reports {
        assert!(error.to_string().contains(&report.info.name), "{error}");
    }
    // Any part of a name, in any case.
    let part = reports[0].info.name[1..4].to_uppercase();
    let gpu = Gpu::open(&name(&part)).expect("part of a name is enough");
    assert!(gpu.info().name.to_uppercase().contains(&part));
    assert!(reports[0].tier.is_some());
}

#[test]
fn a_buffer_beyond_the_binding_limit_is_named() {
    let gpu = gpu();
    let limit = gpu.device().limits().max_storage_buffer_binding_size;
    let len = u32::try_from(limit / 16 + 1).unwrap_or(u32::MAX);
    let mut resources = Resources::new();
    let mut small = resources.persistent::<u32>("small", 16);
    let mut huge = resources.persistent::<[u32; 4]>("neighbour_list", len);
    let mut step = resources.recording("step");
    step.dispatch(&Increment { values: small.write() }, 16);
    let module = brooklet_kernels::Kernel::module(&Increment { values: small.write() });
    let words = brooklet_kernels::Buffer::<u32>::new(huge.id, 4);
    step.clear(&mut huge);
    let mut words = words;
    step.dispatch(&Any { module, values: words.write() }, 16);
    let plan = Plan::sweep(resources, vec![step], &[]).expect("a plan");
    let error = Engine::new(&gpu, plan).map(|_| ()).expect_err("too large");
    assert_eq!(
        error,
        GpuError::BufferTooLarge {
            label: "neighbour_list".into(),
            bytes: u64::from(len) * 16,
            limit,
            limit_name: "max_storage_buffer_binding_size",
        }
    );
}

#[test]
fn a_lost_device_is_an_error() {
    let gpu = gpu();
    let mut counting = counting(&gpu, 1000);
    counting.engine.run(&[counting.step], &[]).expect("it runs");
    assert_eq!(gpu.is_lost(), None);
    gpu.device().destroy();
    let mut runs = 0;
    let error = loop {
        // A frame handed over in the same instant may still be taken.
        match counting.engine.run(&[counting.step], &[counting.counter.id]) {
            Ok(_) if runs < 10 => runs += 1,
            Ok(_) => panic!("ten frames ran on a destroyed device"),
            Err(error) => break error,
        }
    };
    assert!(matches!(error, GpuError::DeviceLost { .. }), "{error}");
    assert!(gpu.is_lost().is_some());
    assert!(counting.engine.read(&counting.counter).is_err());
    assert!(counting.engine.finish().is_err());
    counting.engine.write(&counting.counter, &[1]);
    assert!(Engine::new(&gpu, Plan::sweep(Resources::new(), Vec::new(), &[]).expect("a plan")).is_err());
}

#[test]
fn wrong_calls_are_errors_that_name_what_is_wrong() {
    let gpu = gpu();
    let mut counting = counting(&gpu, 10);
    let error = counting.engine.run(&[Resources::new().recording("stpe").id()], &[]).expect_err("no such recording");
    assert_eq!(error.to_string(), "there is no recording \"stpe\"; the plan has: step");
    let mut other = Resources::new();
    other.recording("first");
    let elsewhere = other.recording("step").id();
    assert!(counting.engine.run(&[elsewhere], &[]).is_err(), "a handle of another table");
    counting.engine.write(&counting.counter, &[7; 11]);
    let error = counting.engine.run(&[counting.step], &[]).expect_err("it was too long");
    assert_eq!(error.to_string(), "11 elements were written to buffer counter, which has 10");
    counting.engine.run(&[counting.step], &[]).expect("and then it goes on");
}
