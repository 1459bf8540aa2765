//! From a module's bindings to wgpu's layouts and samplers.

use crate::draw::texture_format;
use crate::resources::{Resources, Shape};
use brooklet_kernels::{Access, BindingInfo, BindingKind, Bound, Format, Module};
use wgpu::{BindingType, BufferBindingType, ShaderStages, TextureSampleType};

/// The entries of set 0 for what is bound; a slot is visible to the modules that list it.
pub(crate) fn entries(
    modules: &[(&Module, ShaderStages)],
    bound: &[Bound],
    resources: &Resources,
) -> Vec<wgpu::BindGroupLayoutEntry> {
    bound
        .iter()
        .map(|bound| {
            let visibility = modules
                .iter()
                .filter(|(module, _)| {
                    let mut slots = module.bindings.iter().map(|binding| binding.slot);
                    slots.any(|slot| slot == bound.info.slot)
                })
                .fold(ShaderStages::empty(), |all, (_, stage)| all | *stage);
            let format = bound.resource.and_then(|id| resources.get(id)).and_then(|entry| match entry.shape {
                Shape::Texture { format, .. } => Some(format),
                Shape::Buffer { .. } => None,
            });
            wgpu::BindGroupLayoutEntry {
                binding: bound.info.slot,
                visibility,
                ty: binding_type(&bound.info, format),
                count: None,
            }
        })
        .collect()
}

fn binding_type(info: &BindingInfo, bound_format: Option<Format>) -> BindingType {
    match info.kind {
        BindingKind::Uniform { .. } => buffer(BufferBindingType::Uniform),
        BindingKind::Storage { access, .. } => buffer(BufferBindingType::Storage { read_only: access == Access::Read }),
        BindingKind::Texture { filterable } => BindingType::Texture {
            sample_type: match bound_format {
                Some(Format::R32Uint) => TextureSampleType::Uint,
                Some(Format::Depth32Float | Format::Depth24Plus) => TextureSampleType::Depth,
                _ => TextureSampleType::Float { filterable },
            },
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        },
        BindingKind::StorageTexture { format, access } => BindingType::StorageTexture {
            access: match (access, format) {
                (Access::Read, _) => wgpu::StorageTextureAccess::ReadOnly,
                // Devices read back only single 32-bit channels without an extension.
                (Access::ReadWrite, Format::R32Float | Format::R32Uint) => wgpu::StorageTextureAccess::ReadWrite,
                (Access::ReadWrite, _) => wgpu::StorageTextureAccess::WriteOnly,
            },
            format: texture_format(format),
            view_dimension: wgpu::TextureViewDimension::D2,
        },
        BindingKind::Sampler => BindingType::Sampler(sampler_type(info.name)),
    }
}

fn buffer(ty: BufferBindingType) -> BindingType {
    BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None }
}

fn sampler_type(name: &str) -> wgpu::SamplerBindingType {
    let name = name.to_lowercase();
    if name.contains("compare") {
        wgpu::SamplerBindingType::Comparison
    } else if name.contains("point") {
        wgpu::SamplerBindingType::NonFiltering
    } else {
        wgpu::SamplerBindingType::Filtering
    }
}

/// The sampler that a name describes, as Unity's inline samplers do: `point`, `linear` or
/// `trilinear`; `clamp`, `repeat`, `mirror` or `mirroronce` (clamped here: few devices have it);
/// `compare`. Linear and clamped where the name says nothing.
pub(crate) fn sampler(name: &str) -> wgpu::SamplerDescriptor<'_> {
    let lower = name.to_lowercase();
    let filter = if lower.contains("point") { wgpu::FilterMode::Nearest } else { wgpu::FilterMode::Linear };
    let address = if lower.contains("repeat") {
        wgpu::AddressMode::Repeat
    } else if lower.contains("mirror") && !lower.contains("mirroronce") {
        wgpu::AddressMode::MirrorRepeat
    } else {
        wgpu::AddressMode::ClampToEdge
    };
    wgpu::SamplerDescriptor {
        label: Some(name),
        address_mode_u: address,
        address_mode_v: address,
        address_mode_w: address,
        mag_filter: filter,
        min_filter: filter,
        mipmap_filter: if lower.contains("trilinear") {
            wgpu::MipmapFilterMode::Linear
        } else {
            wgpu::MipmapFilterMode::Nearest
        },
        compare: lower.contains("compare").then_some(wgpu::CompareFunction::LessEqual),
        ..Default::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_samplers_name_is_its_settings() {
        let clamp = sampler("sampler_linear_clamp");
        assert_eq!(clamp.mag_filter, wgpu::FilterMode::Linear);
        assert_eq!(clamp.address_mode_u, wgpu::AddressMode::ClampToEdge);
        let repeat = sampler("SamplerPointRepeat");
        assert_eq!(repeat.mag_filter, wgpu::FilterMode::Nearest);
        assert_eq!(repeat.address_mode_v, wgpu::AddressMode::Repeat);
        assert_eq!(repeat.compare, None);
        let compare = sampler("sampler_linear_clamp_compare");
        assert_eq!(compare.compare, Some(wgpu::CompareFunction::LessEqual));
        assert_eq!(sampler_type("sampler_point_clamp"), wgpu::SamplerBindingType::NonFiltering);
    }
}
