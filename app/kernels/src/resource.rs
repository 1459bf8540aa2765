//! Buffers and textures as plain data: names a recording uses, not memory.

use std::marker::PhantomData;

/// Index of a declared buffer or texture in its resource table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ResourceId(pub u32);

/// A declared buffer of `len` elements of `T`. Not `Clone`: borrowing it mutably for
/// [`BufMut`] is what keeps one dispatch from binding it twice when it is written.
#[derive(Debug, PartialEq, Eq)]
pub struct Buffer<T> {
    /// Its index in the resource table.
    pub id: ResourceId,
    /// Number of elements.
    pub len: u32,
    element: PhantomData<fn() -> T>,
}

impl<T> Buffer<T> {
    /// Names the buffer `id`; made by the resource table, which knows its size.
    pub fn new(id: ResourceId, len: u32) -> Self {
        Self { id, len, element: PhantomData }
    }
    /// Binds it to be read.
    pub fn read(&self) -> Buf<'_, T> {
        Buf { id: self.id, borrow: PhantomData }
    }
    /// Binds it to be read and written.
    pub fn write(&mut self) -> BufMut<'_, T> {
        BufMut { id: self.id, borrow: PhantomData }
    }
    /// Binds it as a uniform buffer.
    pub fn uniform(&self) -> Uniform<'_, T> {
        Uniform { id: self.id, borrow: PhantomData }
    }
    /// A second name of the same buffer, for another room that only reads it (drawing what was
    /// simulated).
    pub fn alias(&self) -> Self {
        Self::new(self.id, self.len)
    }
}

/// `StructuredBuffer<T>` or `ByteAddressBuffer`: read only.
#[derive(Clone, Copy, Debug)]
pub struct Buf<'a, T> {
    /// The bound buffer.
    pub id: ResourceId,
    borrow: PhantomData<&'a T>,
}

/// `RWStructuredBuffer<T>`: read and written.
#[derive(Debug)]
pub struct BufMut<'a, T> {
    /// The bound buffer.
    pub id: ResourceId,
    borrow: PhantomData<&'a mut T>,
}

/// `ConstantBuffer<T>`.
#[derive(Clone, Copy, Debug)]
pub struct Uniform<'a, T> {
    /// The bound buffer.
    pub id: ResourceId,
    borrow: PhantomData<&'a T>,
}

/// Texture formats the tiers distinguish.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Format {
    R32Float,
    Rg32Float,
    Rgba32Float,
    R16Float,
    Rg16Float,
    Rgba16Float,
    R32Uint,
    Rgba8Unorm,
    Rgba8UnormSrgb,
    Depth32Float,
    Depth24Plus,
}

/// A declared texture.
#[derive(Debug, PartialEq, Eq)]
pub struct Texture {
    /// Its index in the resource table.
    pub id: ResourceId,
    /// Width and height in pixels.
    pub size_px: [u32; 2],
}

impl Texture {
    /// Binds it to be sampled or loaded.
    pub fn read(&self) -> Tex<'_> {
        Tex { id: self.id, borrow: PhantomData }
    }
    /// Binds it as a storage image.
    pub fn write(&mut self) -> TexMut<'_> {
        TexMut { id: self.id, borrow: PhantomData }
    }
    /// A second name of the same texture, for another room that only reads it.
    pub fn alias(&self) -> Self {
        Self { id: self.id, size_px: self.size_px }
    }
}

/// `Texture2D`: sampled or loaded.
#[derive(Clone, Copy, Debug)]
pub struct Tex<'a> {
    /// The bound texture.
    pub id: ResourceId,
    borrow: PhantomData<&'a ()>,
}

/// `RWTexture2D`: a storage image.
#[derive(Debug)]
pub struct TexMut<'a> {
    /// The bound texture.
    pub id: ResourceId,
    borrow: PhantomData<&'a mut ()>,
}
