//! Buffers and textures that outlive an engine, so that the next one need not allocate.

use std::collections::HashMap;
use std::hash::Hash;

/// Smallest allocation: what the smallest uniform block needs.
const SMALLEST_BYTES: u64 = 16;

/// Rounds a size up so that similar sizes share memory: eight classes an octave, so that at most
/// an eighth is given away.
pub(crate) fn size_class(bytes: u64) -> u64 {
    let bytes = bytes.max(SMALLEST_BYTES);
    let step = (1u64 << bytes.ilog2().saturating_sub(3)).max(4);
    bytes.div_ceil(step) * step
}

/// Things put aside by kind.
#[derive(Debug)]
pub(crate) struct Shelf<K, V> {
    items: HashMap<K, Vec<V>>,
}

impl<K: Eq + Hash, V> Default for Shelf<K, V> {
    fn default() -> Self {
        Self { items: HashMap::new() }
    }
}

impl<K: Eq + Hash, V> Shelf<K, V> {
    pub fn take(&mut self, kind: &K) -> Option<V> {
        self.items.get_mut(kind)?.pop()
    }
    pub fn put(&mut self, kind: K, item: V) {
        self.items.entry(kind).or_default().push(item);
    }
    pub fn iter(&self) -> impl Iterator<Item = (&K, &V)> {
        self.items.iter().flat_map(|(kind, items)| items.iter().map(move |item| (kind, item)))
    }
    pub fn clear(&mut self) {
        self.items.clear();
    }
}

/// What a pooled buffer is interchangeable by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct BufferKind {
    pub bytes: u64,
    pub usage: wgpu::BufferUsages,
}

/// What a pooled texture is interchangeable by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct TextureKind {
    pub size_px: [u32; 2],
    pub format: wgpu::TextureFormat,
    pub usage: wgpu::TextureUsages,
}

impl TextureKind {
    /// Bytes of its pixels; drivers may pad them.
    pub fn bytes(&self) -> u64 {
        let pixel = self.format.block_copy_size(None).unwrap_or(4);
        u64::from(pixel) * u64::from(self.size_px[0]) * u64::from(self.size_px[1])
    }
}

/// A buffer from the pool.
pub(crate) struct Pooled<V> {
    pub item: V,
    /// Whether it may hold what an earlier engine left in it.
    pub used: bool,
}

/// Free buffers and textures of a device.
pub(crate) struct Pool {
    max_buffer_bytes: u64,
    buffers: Shelf<BufferKind, wgpu::Buffer>,
    textures: Shelf<TextureKind, wgpu::Texture>,
}

impl Pool {
    pub fn new(max_buffer_bytes: u64) -> Self {
        Self { max_buffer_bytes, buffers: Shelf::default(), textures: Shelf::default() }
    }

    /// The kind of buffer that serves `bytes`.
    pub fn buffer_kind(&self, bytes: u64, usage: wgpu::BufferUsages) -> BufferKind {
        let class = size_class(bytes);
        BufferKind {
            // A class must not push a buffer that is allowed over the limit.
            bytes: if class <= self.max_buffer_bytes { class } else { bytes.next_multiple_of(4) },
            usage,
        }
    }

    pub fn buffer(&mut self, device: &wgpu::Device, kind: BufferKind, label: &str) -> Pooled<wgpu::Buffer> {
        match self.buffers.take(&kind) {
            Some(item) => Pooled { item, used: true },
            None => Pooled {
                item: device.create_buffer(&wgpu::BufferDescriptor {
                    label: Some(label),
                    size: kind.bytes,
                    usage: kind.usage,
                    mapped_at_creation: false,
                }),
                used: false,
            },
        }
    }

    pub fn texture(&mut self, device: &wgpu::Device, kind: TextureKind, label: &str) -> Pooled<wgpu::Texture> {
        match self.textures.take(&kind) {
            Some(item) => Pooled { item, used: true },
            None => Pooled {
                item: device.create_texture(&wgpu::TextureDescriptor {
                    label: Some(label),
                    size: wgpu::Extent3d { width: kind.size_px[0], height: kind.size_px[1], depth_or_array_layers: 1 },
                    mip_level_count: 1,
                    sample_count: 1,
                    dimension: wgpu::TextureDimension::D2,
                    format: kind.format,
                    usage: kind.usage,
                    view_formats: &[],
                }),
                used: false,
            },
        }
    }

    pub fn give_buffer(&mut self, kind: BufferKind, buffer: wgpu::Buffer) {
        self.buffers.put(kind, buffer);
    }

    pub fn give_texture(&mut self, kind: TextureKind, texture: wgpu::Texture) {
        self.textures.put(kind, texture);
    }

    pub fn free_bytes(&self) -> u64 {
        let buffers: u64 = self.buffers.iter().map(|(kind, _)| kind.bytes).sum();
        let textures: u64 = self.textures.iter().map(|(kind, _)| kind.bytes()).sum();
        buffers + textures
    }

    pub fn trim(&mut self) {
        self.buffers.clear();
        self.textures.clear();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn classes_hold_their_sizes_and_waste_little() {
        for bytes in (0..5_000).chain([1 << 20, (1 << 20) + 1, 128 << 20, (5 << 30) + 12_345]) {
            let class = size_class(bytes);
            assert!(class >= bytes.max(16), "{bytes} in {class}");
            assert!(class.is_multiple_of(4));
            assert_eq!(class, size_class(class), "a class is its own class");
            if bytes >= 64 {
                assert!(class - bytes <= bytes / 8, "{bytes} in {class}");
            }
        }
        assert_eq!(size_class(128 << 20), 128 << 20);
    }

    #[test]
    fn a_class_does_not_exceed_the_devices_limit() {
        let pool = Pool::new(1_000_001 * 4);
        let usage = wgpu::BufferUsages::STORAGE;
        assert_eq!(pool.buffer_kind(4_000_000, usage).bytes, 4_000_000);
        assert!(pool.buffer_kind(1_000_004, usage).bytes > 1_000_004);
    }

    #[test]
    fn a_shelf_gives_back_what_fits_and_nothing_else() {
        let mut shelf = Shelf::<(u64, u32), &str>::default();
        shelf.put((256, 1), "a");
        shelf.put((256, 1), "b");
        shelf.put((512, 1), "c");
        assert_eq!(shelf.iter().count(), 3);
        assert_eq!(shelf.take(&(256, 2)), None);
        assert_eq!(shelf.take(&(512, 1)), Some("c"));
        assert_eq!(shelf.take(&(512, 1)), None);
        assert_eq!(shelf.iter().count(), 2);
        shelf.clear();
        assert_eq!(shelf.take(&(256, 1)), None);
    }
}
