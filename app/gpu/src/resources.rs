//! The table of declared buffers and textures: plain data, no memory.

use crate::recording::{Recording, RecordingId};
use brooklet_kernels::{Buffer, Format, ResourceId, Texture};

/// What a declared resource is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A buffer of elements `stride_bytes` apart.
    Buffer {
        /// Size of an element in bytes.
        stride_bytes: u32,
        /// Number of elements.
        len: u32,
    },
    /// A 2-D texture.
    Texture {
        /// Its format.
        format: Format,
        /// Width and height in pixels.
        size_px: [u32; 2],
    },
}

/// One declared resource.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ResourceInfo {
    /// Its name in plans, errors and graphics debuggers.
    pub label: String,
    /// Buffer or texture, and its size.
    pub shape: Shape,
    /// Whether its content lasts from one recording to the next; such a resource is always wanted.
    pub state: bool,
    /// Of a texture: formats that hold what it is for as well, best first.
    pub others: &'static [Format],
}

impl ResourceInfo {
    /// Size of its content in bytes, before any rounding by an allocator.
    pub fn bytes(&self) -> u64 {
        match self.shape {
            Shape::Buffer { stride_bytes, len } => u64::from(stride_bytes) * u64::from(len),
            Shape::Texture { format, size_px } => {
                bytes_per_pixel(format) * u64::from(size_px[0]) * u64::from(size_px[1])
            }
        }
    }
    /// Whether it is a texture.
    pub fn is_texture(&self) -> bool {
        matches!(self.shape, Shape::Texture { .. })
    }
}

/// Bytes of one pixel. `Depth24Plus` is counted as 4: drivers use D24 or D32.
pub fn bytes_per_pixel(format: Format) -> u64 {
    match format {
        Format::R16Float => 2,
        Format::R32Float
        | Format::Rg16Float
        | Format::R32Uint
        | Format::Rgba8Unorm
        | Format::Rgba8UnormSrgb
        | Format::Depth32Float
        | Format::Depth24Plus => 4,
        Format::Rg32Float | Format::Rgba16Float => 8,
        Format::Rgba32Float => 16,
    }
}

/// Table of declared buffers and textures. A recording names its entries; a plan says which of
/// them get memory.
#[derive(Clone, Debug, Default)]
pub struct Resources {
    entries: Vec<ResourceInfo>,
    recordings: u32,
    saves_memory: bool,
    /// Entries that a declaration of the same label and shape may yet repeat ([`Resources::repeating`]).
    repeatable: Vec<ResourceId>,
}

impl Resources {
    /// An empty table.
    pub fn new() -> Self {
        Self::default()
    }

    /// An empty table for recordings that rather take less memory than fewer dispatches.
    pub fn saving_memory() -> Self {
        Self { saves_memory: true, ..Self::default() }
    }

    /// Whether its recordings rather take less memory than fewer dispatches.
    pub fn saves_memory(&self) -> bool {
        self.saves_memory
    }

    fn declare(&mut self, label: &str, shape: Shape, state: bool) -> ResourceId {
        self.declare_as(ResourceInfo { label: label.to_owned(), shape, state, others: &[] })
    }

    fn declare_as(&mut self, info: ResourceInfo) -> ResourceId {
        if let Some(at) = self.repeatable.iter().position(|id| self.entries[id.0 as usize] == info) {
            return self.repeatable.remove(at);
        }
        let id = ResourceId(self.entries.len() as u32);
        self.entries.push(info);
        id
    }

    /// Runs `declare`, in which a declaration that equals one since the table had `first` entries is that one, each once. For
    /// recordings of which a frame runs one or another: memory that both need is then there once.
    pub fn repeating<R>(&mut self, first: usize, declare: impl FnOnce(&mut Self) -> R) -> R {
        self.repeatable = (first as u32..self.entries.len() as u32).map(ResourceId).collect();
        let declared = declare(self);
        self.repeatable.clear();
        declared
    }

    /// Number of entries.
    pub fn len(&self) -> usize {
        self.entries.len()
    }

    /// Whether nothing is declared.
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// Declares a transient buffer of `len` elements: each recording writes it before reading it,
    /// and what it holds between two recordings is not defined.
    pub fn buffer<T>(&mut self, label: &str, len: u32) -> Buffer<T> {
        Buffer::new(self.declare(label, buffer_shape::<T>(len), false), len)
    }

    /// Declares a buffer that lasts: it is zero at the start, keeps what recordings and
    /// `Engine::write` put there, and commands that write it are never left out.
    pub fn persistent<T>(&mut self, label: &str, len: u32) -> Buffer<T> {
        Buffer::new(self.declare(label, buffer_shape::<T>(len), true), len)
    }

    /// Declares a transient texture.
    pub fn texture(&mut self, label: &str, format: Format, size_px: [u32; 2]) -> Texture {
        Texture { id: self.declare(label, Shape::Texture { format, size_px }, false), size_px }
    }

    /// Declares a texture whose content may have any of `formats`: the first that the device can do with what a plan does
    /// with it ([`crate::Plan::with_formats_of`]).
    pub fn texture_in(&mut self, label: &str, formats: &'static [Format], size_px: [u32; 2]) -> Texture {
        let (format, others) = match formats {
            [] => (Format::Rgba8Unorm, formats),
            [format, others @ ..] => (*format, others),
        };
        let shape = Shape::Texture { format, size_px };
        Texture { id: self.declare_as(ResourceInfo { label: label.to_owned(), shape, state: false, others }), size_px }
    }

    /// Gives a texture another of its formats.
    pub(crate) fn set_format(&mut self, id: ResourceId, other: Format) {
        if let Some(ResourceInfo { shape: Shape::Texture { format, .. }, .. }) = self.entries.get_mut(id.0 as usize) {
            *format = other;
        }
    }

    /// An empty recording over these resources.
    pub fn recording(&mut self, label: &'static str) -> Recording {
        let id = RecordingId::new(self.recordings, label);
        self.recordings += 1;
        Recording::new(id)
    }

    /// The entry of `id`; `None` if it belongs to another table.
    pub fn get(&self, id: ResourceId) -> Option<&ResourceInfo> {
        self.entries.get(id.0 as usize)
    }

    /// Size of `id`'s content in bytes; 0 if it belongs to another table.
    pub fn bytes(&self, id: ResourceId) -> u64 {
        self.get(id).map_or(0, ResourceInfo::bytes)
    }

    /// Name of `id`; `?` if it belongs to another table.
    pub fn label(&self, id: ResourceId) -> &str {
        self.get(id).map_or("?", |entry| &entry.label)
    }

    /// All entries in order of their declaration.
    pub fn iter(&self) -> impl Iterator<Item = (ResourceId, &ResourceInfo)> {
        self.entries.iter().enumerate().map(|(index, entry)| (ResourceId(index as u32), entry))
    }
}

fn buffer_shape<T>(len: u32) -> Shape {
    Shape::Buffer { stride_bytes: size_of::<T>() as u32, len }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_those_of_the_content() {
        let mut table = Resources::new();
        let empty = table.buffer::<u32>("empty", 0);
        let vectors = table.persistent::<[f32; 4]>("vectors", 1000);
        let picture = table.texture("picture", Format::Rgba16Float, [3, 5]);
        assert_eq!(table.bytes(empty.id), 0);
        assert_eq!(table.bytes(vectors.id), 16_000);
        assert_eq!(table.bytes(picture.id), 3 * 5 * 8);
        assert_eq!(table.label(vectors.id), "vectors");
        assert_eq!(table.label(ResourceId(99)), "?");
        assert!(table.get(vectors.id).is_some_and(|entry| entry.state));
    }
}
