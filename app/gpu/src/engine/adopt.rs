//! Content of another engine's buffers, taken over on the GPU.

use super::Engine;
use crate::error::GpuError;
use crate::recording::{Command, RecordingId};
use brooklet_kernels::ResourceId;
use std::collections::BTreeSet;

impl Engine {
    /// Copies every buffer that both engines have by name and size, and that outlives a run in both, from `old`, but those that a recording of
    /// `but_of` uploads: this engine's own parameters. Both engines are of one device.
    ///
    /// # Errors
    /// If the device is lost.
    pub fn adopt(&mut self, old: &Engine, but_of: &[RecordingId]) -> Result<(), GpuError> {
        let own: BTreeSet<ResourceId> = but_of
            .iter()
            .flat_map(|recording| self.plan.commands(*recording))
            .filter_map(|command| match command {
                Command::Upload { to, .. } => Some(*to),
                _ => None,
            })
            .collect();
        let others = old.plan.buffers();
        let kept = self.plan.buffers().into_iter().filter(|buffer| !own.contains(&buffer.id) && self.keeps(buffer.id));
        let copies: Vec<_> = kept
            .filter_map(|buffer| {
                let same = others.iter().find(|other| other.label == buffer.label && other.bytes == buffer.bytes)?;
                if !old.keeps(same.id) {
                    return None;
                }
                Some((old.arena.buffer_of(same.id)?, self.arena.buffer_of(buffer.id)?, buffer.bytes))
            })
            .collect();
        let gpu = &self.gpu;
        gpu.guarded(|| {
            let mut encoder = gpu.device().create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            for (from, to, bytes) in copies {
                encoder.copy_buffer_to_buffer(from, 0, to, 0, bytes.next_multiple_of(4));
            }
            gpu.queue().submit([encoder.finish()]);
        })
    }
}
