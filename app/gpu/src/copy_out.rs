//! How a resource's content comes to the host.

use crate::memory::Memory;
use brooklet_kernels::ResourceId;

/// A resource as rows in a host buffer: a buffer is one row, and a texture's rows are padded there as
/// copies want them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct CopyOut {
    pub id: ResourceId,
    row_bytes: u64,
    padded_bytes: u64,
    rows: u64,
}

impl CopyOut {
    pub fn of_buffer(id: ResourceId, bytes: u64) -> Self {
        Self { id, row_bytes: bytes, padded_bytes: bytes.next_multiple_of(wgpu::COPY_BUFFER_ALIGNMENT), rows: 1 }
    }

    pub fn of_texture(id: ResourceId, row_bytes: u64, rows: u32) -> Self {
        let padded_bytes = row_bytes.next_multiple_of(u64::from(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT));
        Self { id, row_bytes, padded_bytes, rows: u64::from(rows) }
    }

    /// Bytes that it takes in the host buffer.
    pub fn host_bytes(&self) -> u64 {
        self.padded_bytes * self.rows
    }

    /// Copies `memory` to `host`, from `offset` on: a multiple of 256 for a texture, of 8 for a buffer.
    pub fn encode(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        memory: Option<&Memory>,
        host: &wgpu::Buffer,
        offset: u64,
    ) {
        if self.host_bytes() == 0 {
            return;
        }
        match memory {
            Some(Memory::Buffer { buffer, .. }) => {
                encoder.copy_buffer_to_buffer(buffer, 0, host, offset, self.padded_bytes);
            }
            Some(Memory::Texture { texture, .. }) => encoder.copy_texture_to_buffer(
                texture.as_image_copy(),
                wgpu::TexelCopyBufferInfo {
                    buffer: host,
                    layout: wgpu::TexelCopyBufferLayout {
                        offset,
                        bytes_per_row: Some(self.padded_bytes as u32),
                        rows_per_image: None,
                    },
                },
                texture.size(),
            ),
            None => {}
        }
    }

    /// The content without padding; `host` begins where it was copied to.
    pub fn content(&self, host: &[u8]) -> Vec<u8> {
        if self.host_bytes() == 0 {
            return Vec::new();
        }
        let rows = host.chunks(self.padded_bytes as usize).take(self.rows as usize);
        rows.flat_map(|row| &row[..self.row_bytes as usize]).copied().collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_come_back_without_what_copies_put_between_them() {
        let id = ResourceId(3);
        let texture = CopyOut::of_texture(id, 260, 3);
        assert_eq!(texture.host_bytes(), 3 * 512);
        let host: Vec<u8> = (0..3 * 512).map(|i| if i % 512 < 260 { (i / 512) as u8 } else { 99 }).collect();
        let expected: Vec<u8> = (0..3 * 260).map(|i| (i / 260) as u8).collect();
        assert_eq!(texture.content(&host), expected);
        let buffer = CopyOut::of_buffer(id, 6);
        assert_eq!(buffer.host_bytes(), 8);
        assert_eq!(buffer.content(&[1, 2, 3, 4, 5, 6, 7, 8, 9]), [1, 2, 3, 4, 5, 6]);
        for empty in [CopyOut::of_buffer(id, 0), CopyOut::of_texture(id, 0, 7), CopyOut::of_texture(id, 12, 0)] {
            assert_eq!((empty.host_bytes(), empty.content(&[1, 2])), (0, Vec::new()));
        }
    }
}
