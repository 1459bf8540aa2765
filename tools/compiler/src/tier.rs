//! The device tiers' limits, and the lowest tier that a module fits.

use crate::reflect::{Kind, Reflection};

/// Device classes, lowest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Tier {
    /// Adreno 540 with Vulkan 1.0.61, SwiftShader.
    Floor,
    /// Adreno 6xx/7xx, Mali.
    Mobile,
    /// Desktop GPUs.
    Desktop,
}

/// What a tier promises to every stage.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Threads of a group.
    pub threads: u32,
    /// Bytes of groupshared memory.
    pub shared_bytes: u32,
    /// Storage buffers of a stage.
    pub storage_buffers: u32,
    /// Storage images of a stage.
    pub storage_images: u32,
    /// Sampled textures of a stage.
    pub textures: u32,
    /// Uniform buffers of a stage.
    pub uniforms: u32,
    /// Bytes of a uniform buffer.
    pub uniform_bytes: u32,
}

impl Tier {
    /// All tiers, lowest first.
    pub const ALL: [Self; 3] = [Self::Floor, Self::Mobile, Self::Desktop];

    /// `floor`, `mobile` or `desktop`.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|tier| tier.name() == name)
    }
    /// Its name in pragmas and the manifest.
    pub fn name(self) -> &'static str {
        match self {
            Self::Floor => "floor",
            Self::Mobile => "mobile",
            Self::Desktop => "desktop",
        }
    }
    /// Its limits. Floor: SwiftShader's 256 threads and what Vulkan 1.0 promises (16 KiB, 4 storage
    /// images), with 8 storage buffers; mobile: an Adreno 540's 512 threads and 32 KiB.
    pub fn limits(self) -> Limits {
        let floor = Limits {
            threads: 256,
            shared_bytes: 16 << 10,
            storage_buffers: 8,
            storage_images: 4,
            textures: 16,
            uniforms: 11,
            uniform_bytes: 16 << 10,
        };
        match self {
            Self::Floor => floor,
            Self::Mobile => Limits {
                threads: 512,
                shared_bytes: 32 << 10,
                storage_buffers: 16,
                storage_images: 8,
                uniform_bytes: 64 << 10,
                ..floor
            },
            Self::Desktop => Limits {
                threads: 1024,
                shared_bytes: 48 << 10,
                storage_buffers: 32,
                storage_images: 16,
                uniform_bytes: 64 << 10,
                ..floor
            },
        }
    }
    /// SPIR-V capabilities that its devices have beyond those that every device has.
    /// Storage images without a format, or with one of the extended formats, are on no tier: wgpu
    /// enables neither.
    fn has(self, capability: &str) -> bool {
        const EVERYWHERE: [&str; 8] = [
            "Shader",
            "Matrix",
            "ImageQuery",
            "DerivativeControl",
            "Sampled1D",
            "Image1D",
            "SampledBuffer",
            "ImageBuffer",
        ];
        EVERYWHERE.contains(&capability)
            || (self == Self::Desktop
                && (capability.starts_with("GroupNonUniform")
                    || ["Float16", "Int16", "Int64", "Float64"].contains(&capability)))
    }

    /// What a module asks for beyond this tier; empty if it fits.
    pub fn excess(self, module: &Reflection) -> Vec<String> {
        let limits = self.limits();
        let mut excess = Vec::new();
        let count = |wanted: fn(&Kind) -> bool| module.bindings.iter().filter(|b| wanted(&b.kind)).count() as u32;
        let amounts = [
            (module.group_size.iter().product(), limits.threads, "threads a group"),
            (module.group_size[2], 64, "threads along z"),
            (module.shared_bytes, limits.shared_bytes, "bytes of groupshared memory"),
            (count(|kind| matches!(kind, Kind::Storage { .. })), limits.storage_buffers, "storage buffers"),
            (count(|kind| matches!(kind, Kind::StorageImage { .. })), limits.storage_images, "storage images"),
            (count(|kind| matches!(kind, Kind::Texture { .. })), limits.textures, "sampled textures"),
            (count(|kind| matches!(kind, Kind::Uniform { .. })), limits.uniforms, "uniform buffers"),
        ];
        for (amount, limit, what) in amounts {
            if amount > limit {
                excess.push(format!("{amount} {what} (at most {limit})"));
            }
        }
        for binding in &module.bindings {
            if let Kind::Uniform { bytes, .. } = &binding.kind
                && *bytes > limits.uniform_bytes
            {
                excess.push(format!("{bytes} bytes in uniform {} (at most {})", binding.name, limits.uniform_bytes));
            }
        }
        for capability in &module.capabilities {
            if !self.has(capability) {
                excess.push(format!("SPIR-V capability {capability}"));
            }
        }
        excess
    }

    /// The lowest tier that a module fits, if any does.
    pub fn of(module: &Reflection) -> Option<Self> {
        Self::ALL.into_iter().find(|tier| tier.excess(module).is_empty())
    }
}
