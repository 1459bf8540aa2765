//! What a plan does with its textures, against what a device can do with their formats.
//!
//! Vulkan promises every format that Brooklet uses in every use that it has for it, but drivers are asked all the
//! same, before anything is allocated: what they lack is then said by name.

use crate::draw::{Blend, texture_format};
use crate::error::GpuError;
use crate::plan::Plan;
use crate::recording::Command;
use crate::resources::Shape;
use brooklet_kernels::{BindingKind, Bound, Format, ResourceId};
use wgpu::{TextureFormatFeatureFlags as Can, TextureFormatFeatures, TextureUsages};

/// What a device can do with a format.
pub trait FormatSupport {
    /// Its features for `format`.
    fn features(&self, format: Format) -> TextureFormatFeatures;
}

impl<F: Fn(Format) -> TextureFormatFeatures> FormatSupport for F {
    fn features(&self, format: Format) -> TextureFormatFeatures {
        self(format)
    }
}

const FORMATS: [Format; 11] = [
    Format::R32Float,
    Format::Rg32Float,
    Format::Rgba32Float,
    Format::R16Float,
    Format::Rg16Float,
    Format::Rgba16Float,
    Format::R32Uint,
    Format::Rgba8Unorm,
    Format::Rgba8UnormSrgb,
    Format::Depth32Float,
    Format::Depth24Plus,
];

/// What an adapter said of each format.
#[derive(Clone, Debug)]
pub(crate) struct AdapterFormats(Vec<(Format, TextureFormatFeatures)>);

impl AdapterFormats {
    /// All but those `without` which the device is to be used.
    pub fn of(adapter: &wgpu::Adapter, without: &[Format]) -> Self {
        let features = |format| (format, adapter.get_texture_format_features(texture_format(format)));
        Self(FORMATS.into_iter().filter(|format| !without.contains(format)).map(features).collect())
    }
}

impl FormatSupport for AdapterFormats {
    fn features(&self, format: Format) -> TextureFormatFeatures {
        let known = self.0.iter().find(|(known, _)| *known == format);
        known.map_or(
            TextureFormatFeatures { allowed_usages: TextureUsages::empty(), flags: Can::empty() },
            |(_, features)| *features,
        )
    }
}

/// Checks that `device` can do with each texture of `plan` what the plan does with it.
///
/// # Errors
/// At the first that it cannot, naming texture, format and use.
pub fn check_formats(device: &str, plan: &Plan, support: &impl FormatSupport) -> Result<(), GpuError> {
    let needs = |id: ResourceId, usage: TextureUsages, can: Can, used_as: &'static str| {
        let Some(Shape::Texture { format, .. }) = plan.resources().get(id).map(|entry| entry.shape) else {
            return Ok(());
        };
        let features = support.features(format);
        if features.allowed_usages.contains(usage) && features.flags.contains(can) {
            return Ok(());
        }
        let label = plan.resources().label(id).to_owned();
        Err(GpuError::MissingFormat { device: device.to_owned(), label, format: format!("{format:?}"), used_as })
    };
    let bound_needs = |bound: &Bound| match (bound.resource, bound.info.kind) {
        (Some(id), BindingKind::Texture { filterable: true }) if is_filtered(plan, id) => {
            needs(id, TextureUsages::TEXTURE_BINDING, Can::FILTERABLE, "read with a filter")
        }
        (Some(id), BindingKind::Texture { .. }) => needs(id, TextureUsages::TEXTURE_BINDING, Can::empty(), "read"),
        (Some(id), BindingKind::StorageTexture { .. }) => {
            needs(id, TextureUsages::STORAGE_BINDING, Can::empty(), "written by kernels")
        }
        _ => Ok(()),
    };
    for command in plan.recordings.iter().flat_map(|recording| &recording.commands) {
        match command {
            Command::Dispatch(dispatch) => dispatch.bindings.iter().try_for_each(bound_needs)?,
            Command::Draw(draw) => {
                draw.bindings.iter().try_for_each(bound_needs)?;
                let blend = if draw.state.blend == Blend::None { Can::empty() } else { Can::BLENDABLE };
                let used_as = if blend.is_empty() { "drawn to" } else { "blended to" };
                for (id, _) in &draw.targets.color {
                    needs(*id, TextureUsages::RENDER_ATTACHMENT, blend, used_as)?;
                }
                if let Some((id, _)) = &draw.targets.depth {
                    needs(*id, TextureUsages::RENDER_ATTACHMENT, Can::empty(), "a depth buffer")?;
                }
            }
            Command::Upload { .. } | Command::Clear { .. } | Command::Copy { .. } | Command::Forget { .. } => {}
        }
    }
    Ok(())
}

/// Depth is never filtered, whatever a kernel's binding would allow.
fn is_filtered(plan: &Plan, id: ResourceId) -> bool {
    let shape = plan.resources().get(id).map(|entry| entry.shape);
    !matches!(shape, Some(Shape::Texture { format: Format::Depth32Float | Format::Depth24Plus, .. }))
}
