//! Formats of a picture's textures: the best first, then those that hold what it is for as well, for devices that cannot draw to,
//! blend to or filter the best ([`brooklet_gpu::Resources::texture_in`]).
//!
//! A device of Vulkan's core finds one in each list: the specification's tables of mandatory formats (Formats, "Required Format
//! Support", since 1.0) have R32, RG32 and RGBA32 float drawn to, R16, RG16 and RGBA16 float blended to and filtered as well, and
//! one of D32 and X8D24 as a depth buffer. An unsigned R32 has the same row as R32 float: it would help no device that lacks that.

use brooklet_kernels::{Format, Tier};

/// Inverse depths and particle indices, drawn to and loaded. Normals are restored from them: nothing of 16 bits is among these,
/// and a picture made with any of them is the same, bit for bit.
pub const DEPTH: &[Format] = &[Format::R32Float, Format::Rg32Float, Format::Rgba32Float];
/// Thickness, blended to and filtered: with those of 16 bits the same, with those of 32 less is rounded.
pub const THICKNESS: &[Format] = &[
    Format::R16Float,
    Format::Rg16Float,
    Format::Rgba16Float,
    Format::R32Float,
    Format::Rg32Float,
    Format::Rgba32Float,
];
/// Light, and normals as they are shaded with.
pub const LIGHT: &[Format] = &[Format::Rgba16Float, Format::Rgba32Float];
/// Planes and normals that nothing is restored from: in 16 bits a plane is off by .1 of half a spacing at most, seen from 4 m.
pub const PLANES: &[Format] = &[Format::Rgba32Float, Format::Rgba16Float];

/// A tier's depth buffer: `floor` draws to one of 24 bits, which its devices have.
pub fn depth_buffer(tier: Tier) -> &'static [Format] {
    match tier {
        Tier::Floor => &[Format::Depth24Plus, Format::Depth32Float],
        Tier::Mobile | Tier::Desktop => &[Format::Depth32Float, Format::Depth24Plus],
    }
}
