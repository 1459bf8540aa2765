//! The pass timer on a device of its own: reports come in order, nothing stalls, what is lost is counted.

use std::time::Instant;

use brooklet_capture::Capture;
use brooklet_gpu::{FrameReport, PassTimer, SpanFlag, TimingStatus};

use crate::time_your_passes;

struct Host {
    device: wgpu::Device,
    queue: wgpu::Queue,
    view: wgpu::TextureView,
}

impl Host {
    fn new(timed: bool) -> Self {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
        let adapter = pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default())).unwrap();
        let wanted = PassTimer::wanted_features(&adapter);
        assert!(wanted.contains(wgpu::Features::TIMESTAMP_QUERY), "Mesa's CPU driver has timestamps");
        let required_features = if timed { wanted } else { wgpu::Features::empty() };
        let request = adapter.request_device(&wgpu::DeviceDescriptor { required_features, ..Default::default() });
        let (device, queue) = pollster::block_on(request).unwrap();
        let texture = device.create_texture(&wgpu::TextureDescriptor {
            label: None,
            size: wgpu::Extent3d { width: 512, height: 512, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Rgba8Unorm,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
            view_formats: &[],
        });
        Self { view: texture.create_view(&Default::default()), device, queue }
    }

    fn timer(&self, most_passes: u32) -> PassTimer {
        PassTimer::new(&self.device, &self.queue, most_passes, Instant::now())
    }

    /// A frame of a render pass for each stage and an empty compute pass.
    fn frame(&self, timer: &mut PassTimer, stages: &[&'static str]) -> wgpu::CommandBuffer {
        timer.begin_frame();
        let mut commands = self.device.create_command_encoder(&Default::default());
        for stage in stages {
            commands.begin_render_pass(&wgpu::RenderPassDescriptor {
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view: &self.view,
                    depth_slice: None,
                    resolve_target: None,
                    ops: wgpu::Operations { load: wgpu::LoadOp::Clear(wgpu::Color::RED), store: wgpu::StoreOp::Store },
                })],
                timestamp_writes: timer.render_pass(stage),
                ..Default::default()
            });
        }
        let timestamp_writes = timer.compute_pass("compute");
        commands.begin_compute_pass(&wgpu::ComputePassDescriptor { label: None, timestamp_writes });
        timer.resolve(&mut commands);
        commands.finish()
    }

    fn submit(&self, commands: wgpu::CommandBuffer) {
        self.queue.submit([commands]);
    }
}

fn stages(report: &FrameReport) -> Vec<&str> {
    report.spans.iter().map(|span| span.stage).collect()
}

#[test]
fn frames_are_timed_in_order_and_read_late() {
    let host = Host::new(true);
    let mut timer = host.timer(8);
    let mut reports = Vec::new();
    for _ in 0..30 {
        let commands = host.frame(&mut timer, &["sky", "overlay"]);
        host.submit(commands);
        // What a program that presents does anyway.
        host.device.poll(wgpu::PollType::wait_indefinitely()).unwrap();
        reports.extend(timer.reports());
    }
    reports.extend(timer.finish());
    assert_eq!(reports.len(), 30);
    assert_eq!(timer.dropped_frames(), 0);
    for (number, report) in reports.iter().enumerate() {
        assert_eq!(report.frame, number as u64);
        assert_eq!(stages(report), ["sky", "overlay", "compute"]);
        assert_eq!((report.timing, report.dropped_spans), (TimingStatus::OwnPasses, 0));
        assert!(report.spans.iter().all(|span| span.flag != SpanFlag::Negative), "{report:?}");
    }
    assert!(reports.windows(2).all(|pair| pair[0].wall_ns < pair[1].wall_ns));
    let lasting = reports.iter().filter(|report| report.gpu_ms().is_some_and(|ms| ms > 0.0));
    assert!(lasting.count() > 15, "clearing a megabyte takes time");
}

#[test]
fn what_cannot_be_timed_is_counted_and_nothing_stalls() {
    let host = Host::new(true);
    let mut timer = host.timer(2);
    let commands = host.frame(&mut timer, &["a", "b", "c"]);
    host.submit(commands);
    let reports = timer.finish();
    assert_eq!((stages(&reports[0]), reports[0].dropped_spans), (vec!["a", "b"], 2));

    // Frames whose commands are held back fill the ring; later ones go on untimed.
    let held: Vec<wgpu::CommandBuffer> = (0..8).map(|_| host.frame(&mut timer, &["a"])).collect();
    assert_eq!(timer.dropped_frames(), 3, "five places");
    held.into_iter().for_each(|commands| host.submit(commands));
    assert_eq!(timer.finish().len(), 5);

    // Commands that are never submitted, and a frame that is never resolved.
    drop(host.frame(&mut timer, &["a"]));
    timer.begin_frame();
    let commands = host.frame(&mut timer, &["a"]);
    host.submit(commands);
    assert_eq!(timer.finish().len(), 1);
    assert_eq!(timer.dropped_frames(), 5);
}

#[test]
fn a_device_without_timestamps_gives_reports_without_spans() {
    let host = Host::new(false);
    let mut timer = host.timer(8);
    for _ in 0..12 {
        let commands = host.frame(&mut timer, &["a"]);
        host.submit(commands);
    }
    let reports = timer.finish();
    assert_eq!((reports.len(), timer.dropped_frames()), (12, 0));
    assert!(
        reports.iter().all(|r| r.spans.is_empty() && r.timing == TimingStatus::Unsupported && r.gpu_ms().is_none())
    );
}

#[test]
fn the_example_writes_a_capture() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mine.mcap");
    time_your_passes::capture_to(&path).unwrap();
    let capture = Capture::open(&path).unwrap();
    assert!(capture.complete);
    assert_eq!(capture.stages, ["clear_small", "clear_large"]);
    assert_eq!(capture.frames.len() as u64 + capture.frames.iter().map(|row| row.dropped_frames).sum::<u64>(), 60);
}
