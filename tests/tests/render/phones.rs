//! Every module that a phone may run, and every shipped scene, within what phones' GPUs allow and no more.

use brooklet_fluid::{FrameRequest, Scene, Session, shipped_scenes};
use brooklet_gpu::{Gpu, highest_tier};
use brooklet_kernels::{Module, modules};
use brooklet_render::ScenePlan;
use brooklet_tests::gpu;
use brooklet_tests::phones::{KINDS, PHONES, bindings};

#[test]
fn no_module_of_a_phones_tier_asks_for_more_than_the_phone_has() {
    for phone in &PHONES {
        let mut count = 0;
        for module in modules().filter(|module| module.tier <= phone.tier) {
            let excess = phone.excess(module);
            assert!(excess.is_empty(), "{} on {}: {}", module.name, phone.name, excess.join(", "));
            count += 1;
        }
        let most = |of: &dyn Fn(&Module) -> u32| {
            let largest = modules().filter(|module| module.tier <= phone.tier).max_by_key(|module| of(module));
            largest.map_or_else(String::new, |module| format!("{} ({})", of(module), module.name))
        };
        println!("{}, {count} modules; the most of each", phone.name);
        println!("  threads a group {} of {}", most(&|module| module.group_size.iter().product()), phone.threads);
        println!("  groupshared bytes {} of {}", most(&|module| module.shared_bytes), phone.shared_bytes);
        for (index, kind) in KINDS.iter().enumerate() {
            println!("  {kind} {} of {}", most(&|module| bindings(module)[index]), phone.bindings[index]);
        }
        // It can fail.
        let wide =
            Module { group_size: [phone.threads + 1, 1, 1], shared_bytes: 1 << 20, ..*modules().next().unwrap() };
        assert_eq!(phone.excess(&wide).len(), 2);
    }
}

#[test]
fn every_shipped_scene_runs_on_a_device_that_has_exactly_a_phones_limits() {
    for phone in &PHONES {
        let opened = gpu();
        let adapter = opened.adapter();
        if highest_tier(adapter).is_ok_and(|highest| highest < phone.tier) {
            println!("{} is below {}", opened.info().name, phone.name);
            continue;
        }
        let limits = phone.limits(Gpu::required_limits(adapter, phone.tier));
        let request = adapter.request_device(&wgpu::DeviceDescriptor {
            required_features: Gpu::required_features(adapter),
            required_limits: limits.clone(),
            ..Default::default()
        });
        let (device, queue) = pollster::block_on(request).expect("a device of a phone's limits");
        let threads = device.limits().max_compute_invocations_per_workgroup;
        assert_eq!(threads, limits.max_compute_invocations_per_workgroup, "it has more than the phone");
        let gpu = Gpu::from_device(adapter, device, queue, Some(phone.tier)).expect("it reaches its tier");
        for (name, _) in shipped_scenes() {
            let coarser = Scene::load(name, &[]).unwrap().spacing_m * 4.0;
            let settings =
                [format!("spacing_m={coarser}"), "outputs.width_px=64".into(), "outputs.height_px=36".into()];
            let scene = Scene::load(name, &settings).unwrap();
            let ScenePlan { session: planned, passes, .. } = ScenePlan::new(&scene, phone.tier).expect("a plan");
            let mut session = Session::start(&gpu, planned).unwrap_or_else(|error| panic!("{name}: {error}"));
            let (mut passes, particles) = (passes.expect("a picture"), session.slot_count());
            let then = [passes.next(session.engine_mut(), particles, false)];
            let frame = FrameRequest { steps: 1, measure: true, then: &then, ..FrameRequest::default() };
            let ended = session.submit(&frame).and_then(|_| session.finish());
            ended.unwrap_or_else(|error| panic!("{name} on {}: {error}", phone.name));
        }
    }
}
