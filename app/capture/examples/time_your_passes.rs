//! Times the passes of a wgpu program that has nothing to do with Brooklet, and writes a capture of them.
//!
//!     cargo run -p brooklet-capture --example time_your_passes -- mine.mcap

use std::error::Error;
use std::path::Path;

use brooklet_capture::{CaptureClock, CaptureOptions, CaptureWriter};
use brooklet_gpu::PassTimer;

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args_os().nth(1).unwrap_or("mine.mcap".into());
    capture_to(path.as_ref())
}

/// Draws sixty frames of two passes, and writes when each pass ran.
pub fn capture_to(path: &Path) -> Result<(), Box<dyn Error>> {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapter = pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default()))?;
    let (device, queue) = pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor {
        required_features: PassTimer::wanted_features(&adapter),
        ..Default::default()
    }))?;
    let [small, large] = [256, 2048].map(|side| {
        let texture = device.create_texture(&wgpu::TextureDescriptor {
            label: None,
            size: wgpu::Extent3d { width: side, height: side, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Rgba8Unorm,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
            view_formats: &[],
        });
        texture.create_view(&Default::default())
    });

    let clock = CaptureClock::new();
    let mut timer = PassTimer::new(&device, &queue, 16, clock.zero());
    let options = CaptureOptions { start: clock.start(), ..CaptureOptions::default() };
    let mut capture = CaptureWriter::create(path, options)?;
    for _ in 0..60 {
        timer.begin_frame();
        let mut commands = device.create_command_encoder(&Default::default());
        for (stage, view) in [("clear_small", &small), ("clear_large", &large)] {
            let ops = wgpu::Operations { load: wgpu::LoadOp::Clear(wgpu::Color::RED), store: wgpu::StoreOp::Store };
            commands.begin_render_pass(&wgpu::RenderPassDescriptor {
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view,
                    ops,
                    depth_slice: None,
                    resolve_target: None,
                })],
                timestamp_writes: timer.render_pass(stage),
                ..Default::default()
            });
        }
        timer.resolve(&mut commands);
        queue.submit([commands.finish()]);
        device.poll(wgpu::PollType::Poll)?;
        timer.reports().iter().try_for_each(|report| capture.frame(report))?;
    }
    timer.finish().iter().try_for_each(|report| capture.frame(report))?;
    let totals = capture.finish()?;
    println!("{}: {} frames, {} dropped", path.display(), totals.frames, timer.dropped_frames());
    Ok(())
}
