//! Content of a plan's resources, back on the host.

use super::Engine;
use crate::copy_out::CopyOut;
use crate::error::GpuError;
use crate::memory::Memory;
use crate::resources::{Shape, bytes_per_pixel};
use brooklet_kernels::{Buffer, Format, ResourceId, Texture};
use bytemuck::Pod;

impl Engine {
    /// Waits for all that was run, and reads a buffer. For tests and final outputs.
    ///
    /// # Errors
    /// If the plan left it out, or the device is lost.
    pub fn read<T: Pod>(&mut self, from: &Buffer<T>) -> Result<Vec<T>, GpuError> {
        Ok(bytemuck::pod_collect_to_vec(&self.download(from.id)?))
    }

    /// Waits for all that was run, and reads a texture: rows from the top, without padding.
    ///
    /// # Errors
    /// If the plan left it out, its format cannot be copied, or the device is lost.
    pub fn read_texture(&mut self, from: &Texture) -> Result<Vec<u8>, GpuError> {
        self.download(from.id)
    }

    /// How to copy a resource to the host.
    pub(super) fn copy_out(&self, id: ResourceId) -> Result<CopyOut, GpuError> {
        let resources = self.plan.resources();
        let refuse = |reason| Err(GpuError::NotReadable { label: resources.label(id).to_owned(), reason });
        if !self.keeps(id) {
            return refuse("its memory is another's by then; name it among the wanted outputs");
        }
        match (self.arena.get(id), resources.get(id).map(|entry| entry.shape)) {
            (Some(Memory::Texture { .. }), Some(Shape::Texture { format: Format::Depth24Plus, .. })) => {
                refuse("drivers choose the layout of Depth24Plus; use Depth32Float")
            }
            (Some(Memory::Texture { .. }), Some(Shape::Texture { format, size_px: [width, height] })) => {
                Ok(CopyOut::of_texture(id, bytes_per_pixel(format) * u64::from(width), height))
            }
            (Some(Memory::Buffer { .. }), _) => Ok(CopyOut::of_buffer(id, resources.bytes(id))),
            // Nothing is all there, without memory.
            (_, Some(_)) if resources.bytes(id) == 0 => Ok(CopyOut::of_buffer(id, 0)),
            _ => refuse("the plan left it out; name it among the wanted outputs"),
        }
    }

    /// Copies something to the host and waits for it.
    fn download(&mut self, id: ResourceId) -> Result<Vec<u8>, GpuError> {
        let copy = self.copy_out(id)?;
        if copy.host_bytes() == 0 {
            return Ok(Vec::new());
        }
        let gpu = &self.gpu;
        let (host, submission) = gpu.guarded(|| {
            let host = gpu.device().create_buffer(&wgpu::BufferDescriptor {
                label: Some("download"),
                size: copy.host_bytes(),
                usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            });
            let mut encoder = gpu.device().create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            copy.encode(&mut encoder, self.arena.get(id), &host, 0);
            let submission = gpu.queue().submit([encoder.finish()]);
            host.map_async(wgpu::MapMode::Read, .., |_| ());
            (host, submission)
        })?;
        gpu.poll(Some(submission))?;
        let mapped = host.slice(..).get_mapped_range();
        let content = mapped.map_err(|error| GpuError::Refused { reason: error.to_string() })?;
        Ok(copy.content(&content))
    }
}
