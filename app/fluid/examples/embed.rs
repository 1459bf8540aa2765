//! Brooklet inside another wgpu program, on that program's own device.
//! `cargo run --release -p brooklet-fluid --example embed`

use brooklet_fluid::{FrameRequest, Scene, Session};
use brooklet_gpu::Gpu;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // The host program's own wgpu set-up; Brooklet only says which features and limits it needs.
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor {
        backends: wgpu::Backends::VULKAN,
        ..wgpu::InstanceDescriptor::new_without_display_handle()
    });
    let adapter = pollster::block_on(instance.request_adapter(&Default::default()))?;
    let tier = brooklet_gpu::highest_tier(&adapter)?;
    let (device, queue) = pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor {
        required_features: Gpu::required_features(&adapter),
        required_limits: Gpu::required_limits(&adapter, tier),
        ..Default::default()
    }))?;

    // The session shares device and queue; `positions` stay on the GPU for the host to draw.
    let gpu = Gpu::from_device(&adapter, device, queue, Some(tier))?;
    let scene = Scene::load("falling-ball", &["spacing_m=0.04".into()])?;
    let mut session = Session::new(&gpu, &scene)?;
    for frame in 1..=60 {
        session.submit(&FrameRequest { steps: 1, measure: frame == 60, ..FrameRequest::default() })?;
    }
    session.finish()?;
    let stats = session.stats().ok_or("the scene does not measure")?;
    println!("{} particles, mean compression {:.2} %", stats.particles, 100.0 * stats.compression.mean);
    Ok(())
}
