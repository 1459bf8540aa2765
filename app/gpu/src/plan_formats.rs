//! What a plan does with its textures, against what a device can do with their formats.
//!
//! Vulkan promises every format that Brooklet uses in every use that it has for it, but drivers are asked all the
//! same, before anything is allocated. A texture whose format they lack in one of its uses gets another that holds what it is
//! for ([`crate::Resources::texture_in`]); where there is none it is said by name.

use crate::device::Gpu;
use crate::draw::Blend;
use crate::error::GpuError;
use crate::formats::{FormatSupport, OtherFormat};
use crate::plan::Plan;
use crate::recording::Command;
use crate::resources::Shape;
use brooklet_kernels::{BindingKind, Bound, Format, ResourceId};
use std::collections::BTreeSet;
use wgpu::{TextureFormatFeatureFlags as Can, TextureUsages};

/// Something that a plan does with a texture.
struct Use {
    id: ResourceId,
    usage: TextureUsages,
    can: Can,
    used_as: &'static str,
}

impl Use {
    fn works(&self, format: Format, support: &impl FormatSupport) -> bool {
        let features = support.features(format);
        // Depth is never filtered, whatever a kernel's binding would allow.
        let is_depth = matches!(format, Format::Depth32Float | Format::Depth24Plus);
        let can = if is_depth { self.can - Can::FILTERABLE } else { self.can };
        features.allowed_usages.contains(self.usage) && features.flags.contains(can)
    }
}

/// All that `plan` does with its textures, in order.
fn uses(plan: &Plan) -> Vec<Use> {
    let mut uses = Vec::new();
    let bound_use = |bound: &Bound| {
        let (usage, can, used_as) = match bound.info.kind {
            BindingKind::Texture { filterable: true } => {
                (TextureUsages::TEXTURE_BINDING, Can::FILTERABLE, "read with a filter")
            }
            BindingKind::Texture { .. } => (TextureUsages::TEXTURE_BINDING, Can::empty(), "read"),
            BindingKind::StorageTexture { .. } => (TextureUsages::STORAGE_BINDING, Can::empty(), "written by kernels"),
            _ => return None,
        };
        bound.resource.map(|id| Use { id, usage, can, used_as })
    };
    for command in plan.recordings.iter().flat_map(|recording| &recording.commands) {
        match command {
            Command::Dispatch(dispatch) => uses.extend(dispatch.bindings.iter().filter_map(bound_use)),
            Command::Draw(draw) => {
                uses.extend(draw.bindings.iter().filter_map(bound_use));
                let usage = TextureUsages::RENDER_ATTACHMENT;
                let (can, used_as) = match draw.state.blend {
                    Blend::None => (Can::empty(), "drawn to"),
                    Blend::Alpha | Blend::Additive => (Can::BLENDABLE, "blended to"),
                };
                uses.extend(draw.targets.color.iter().map(|(id, _)| Use { id: *id, usage, can, used_as }));
                let depth = draw.targets.depth.iter();
                uses.extend(depth.map(|(id, _)| Use { id: *id, usage, can: Can::empty(), used_as: "a depth buffer" }));
            }
            Command::Upload { .. } | Command::Clear { .. } | Command::Copy { .. } | Command::Forget { .. } => {}
        }
    }
    uses
}

fn format_of(plan: &Plan, id: ResourceId) -> Option<Format> {
    match plan.resources().get(id)?.shape {
        Shape::Texture { format, .. } => Some(format),
        Shape::Buffer { .. } => None,
    }
}

/// Checks that `device` can do with each texture of `plan` what the plan does with it.
///
/// # Errors
/// At the first that it cannot, naming texture, format and use.
pub fn check_formats(device: &str, plan: &Plan, support: &impl FormatSupport) -> Result<(), GpuError> {
    uses(plan).iter().try_for_each(|used| match format_of(plan, used.id) {
        Some(format) if !used.works(format, support) => Err(GpuError::MissingFormat {
            device: device.to_owned(),
            label: plan.resources().label(used.id).to_owned(),
            format: format!("{format:?}"),
            used_as: used.used_as,
        }),
        _ => Ok(()),
    })
}

/// The textures of `plan` whose format the device lacks in one of their uses, and the first of their others that it has in all.
fn other_formats(plan: &Plan, support: &impl FormatSupport) -> Vec<(ResourceId, OtherFormat)> {
    let uses = uses(plan);
    let mut seen = BTreeSet::new();
    let mut others = Vec::new();
    for used in &uses {
        let Some(lacking) = format_of(plan, used.id).filter(|format| !used.works(*format, support)) else { continue };
        let Some(entry) = plan.resources().get(used.id).filter(|_| seen.insert(used.id)) else { continue };
        let all =
            |format: Format| uses.iter().filter(|other| other.id == used.id).all(|other| other.works(format, support));
        if let Some(format) = entry.others.iter().copied().find(|format| all(*format)) {
            let (label, used_as) = (entry.label.clone(), used.used_as);
            others.push((used.id, OtherFormat { label, lacking, used_as, format }));
        }
    }
    others
}

impl Plan {
    /// The plan for `gpu`: textures whose format it cannot use as they are used have another that it can, where one of those they
    /// were declared with is.
    pub fn with_formats_of(mut self, gpu: &Gpu) -> Plan {
        for (id, other) in other_formats(&self, gpu.formats()) {
            self.resources.set_format(id, other.format);
            self.other_formats.push(other);
        }
        self
    }

    /// Textures that have another format for the device's sake.
    pub fn other_formats(&self) -> &[OtherFormat] {
        &self.other_formats
    }
}
