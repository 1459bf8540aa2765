//! What each tier asks of a device, and the highest tier a device reaches.

use crate::error::{GpuError, tier_name};
use brooklet_kernels::Tier;
use wgpu::{Features, Limits};

/// All tiers, highest first.
pub const TIERS: [Tier; 3] = [Tier::Desktop, Tier::Mobile, Tier::Floor];

/// PCI vendors of tile-based mobile GPUs: Qualcomm, Arm, Imagination, Samsung. Their newest reach
/// the desktop tier's limits, but not its bandwidth nor its formats.
const MOBILE_VENDORS: [u32; 4] = [0x5143, 0x13b5, 0x1010, 0x144d];

/// What wgpu must have to run at all.
pub(crate) const ESSENTIAL: Features = Features::PASSTHROUGH_SHADERS;

/// What is used where it is, on every tier.
pub(crate) fn useful() -> Features {
    Features::TIMESTAMP_QUERY | Features::TIMESTAMP_QUERY_INSIDE_PASSES | Features::PIPELINE_CACHE
}

/// What only the desktop tier may use: a forced lower tier must not have it by accident.
pub(crate) fn useful_on(tier: Tier) -> Features {
    match tier {
        Tier::Desktop => {
            Features::SUBGROUP | Features::SHADER_F16 | Features::FLOAT32_FILTERABLE | Features::FLOAT32_BLENDABLE
        }
        Tier::Mobile | Tier::Floor => Features::empty(),
    }
}

/// The least a device of this tier has. Storage buffers, images, threads and groupshared bytes are
/// those the shader compiler holds the tier's modules to, except that desktop devices may stay
/// below what it allows (lavapipe has 32 KiB groupshared): such a module is then refused by name.
fn minima(tier: Tier) -> Limits {
    let floor = Limits {
        max_texture_dimension_1d: 4096,
        max_texture_dimension_2d: 4096,
        max_storage_buffers_per_shader_stage: 8,
        max_storage_textures_per_shader_stage: 4,
        max_compute_workgroup_storage_size: 16 << 10,
        max_storage_buffer_binding_size: 128 << 20,
        max_buffer_size: 128 << 20,
        max_buffers_and_acceleration_structures_per_shader_stage: 20,
        ..Limits::downlevel_defaults()
    };
    match tier {
        Tier::Floor => floor,
        Tier::Mobile => Limits {
            max_uniform_buffer_binding_size: 64 << 10,
            max_storage_buffers_per_shader_stage: 16,
            max_storage_textures_per_shader_stage: 8,
            max_compute_workgroup_storage_size: 32 << 10,
            max_compute_invocations_per_workgroup: 512,
            max_compute_workgroup_size_x: 512,
            max_compute_workgroup_size_y: 512,
            max_buffers_and_acceleration_structures_per_shader_stage: 28,
            ..floor
        },
        Tier::Desktop => Limits {
            max_texture_dimension_1d: 8192,
            max_texture_dimension_2d: 8192,
            max_uniform_buffer_binding_size: 64 << 10,
            max_storage_buffers_per_shader_stage: 16,
            max_storage_textures_per_shader_stage: 8,
            max_compute_workgroup_storage_size: 32 << 10,
            max_compute_invocations_per_workgroup: 1024,
            max_compute_workgroup_size_x: 1024,
            max_compute_workgroup_size_y: 1024,
            max_buffers_and_acceleration_structures_per_shader_stage: 28,
            ..floor
        },
    }
}

/// The most that is asked for: sizes of textures and buffers, which scenes differ in, are raised
/// to these where the device has them.
fn caps(tier: Tier) -> Limits {
    let minima = minima(tier);
    match tier {
        Tier::Floor | Tier::Mobile => Limits {
            max_texture_dimension_1d: 8192,
            max_texture_dimension_2d: 8192,
            max_buffer_size: 256 << 20,
            ..minima
        },
        Tier::Desktop => Limits {
            max_texture_dimension_1d: 16_384,
            max_texture_dimension_2d: 16_384,
            max_storage_buffers_per_shader_stage: 32,
            max_storage_textures_per_shader_stage: 16,
            max_compute_workgroup_storage_size: 48 << 10,
            max_storage_buffer_binding_size: u64::MAX,
            max_buffer_size: u64::MAX,
            max_buffers_and_acceleration_structures_per_shader_stage: 44,
            ..minima
        },
    }
}

/// The limits to ask a device with `available` for, to use it as `tier`.
pub(crate) fn limits_for(tier: Tier, available: &Limits) -> Limits {
    minima(tier).or_better_values_from(&caps(tier).or_worse_values_from(available))
}

/// One reason why a device is below a tier.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shortfall {
    /// wgpu's name of the limit.
    pub limit: &'static str,
    /// What the tier needs.
    pub needed: u64,
    /// What the device has.
    pub available: u64,
}

/// What keeps a device with these limits below `tier`; empty if nothing does.
pub(crate) fn shortfalls(tier: Tier, available: &Limits) -> Vec<Shortfall> {
    let mut missing = Vec::new();
    minima(tier).check_limits_with_fail_fn(available, false, |limit, needed, available| {
        missing.push(Shortfall { limit, needed, available });
    });
    missing
}

/// Checks that a device reaches `tier`.
pub(crate) fn check(device: &str, tier: Tier, available: &Limits) -> Result<(), GpuError> {
    match shortfalls(tier, available).first() {
        None => Ok(()),
        Some(missing) => Err(GpuError::MissingLimit {
            device: device.to_owned(),
            tier: tier_name(tier),
            limit: missing.limit,
            needed: missing.needed,
            available: missing.available,
        }),
    }
}

/// The highest tier that a device with these limits reaches.
pub(crate) fn highest(device: &str, vendor: u32, available: &Limits) -> Result<Tier, GpuError> {
    TIERS
        .into_iter()
        .filter(|tier| *tier != Tier::Desktop || !MOBILE_VENDORS.contains(&vendor))
        .find(|tier| shortfalls(*tier, available).is_empty())
        .map_or_else(|| check(device, Tier::Floor, available).map(|()| Tier::Floor), Ok)
}

/// The highest tier that an adapter reaches.
///
/// # Errors
/// If it is below the floor, naming the limit.
pub fn highest_tier(adapter: &wgpu::Adapter) -> Result<Tier, GpuError> {
    let info = adapter.get_info();
    highest(&info.name, info.vendor, &adapter.limits())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_forced_floor_asks_for_the_floor_alone() {
        let generous = Limits {
            max_storage_buffers_per_shader_stage: 1000,
            max_storage_buffer_binding_size: 4 << 30,
            max_buffer_size: 4 << 30,
            ..minima(Tier::Desktop)
        };
        let asked = limits_for(Tier::Floor, &generous);
        assert_eq!(asked.max_storage_buffers_per_shader_stage, 8);
        assert_eq!(asked.max_compute_invocations_per_workgroup, 256);
        assert_eq!(asked.max_storage_textures_per_shader_stage, 4);
        assert_eq!(asked.max_storage_buffer_binding_size, 128 << 20);
        let desktop = limits_for(Tier::Desktop, &generous);
        assert_eq!(desktop.max_storage_buffers_per_shader_stage, 32);
        assert_eq!(desktop.max_storage_buffer_binding_size, 4 << 30);
    }

    #[test]
    fn each_tier_is_a_device_of_that_tier() {
        for tier in TIERS {
            assert_eq!(highest("test", 0, &minima(tier)), Ok(tier));
        }
        assert_eq!(highest("phone", 0x5143, &minima(Tier::Desktop)), Ok(Tier::Mobile));
    }

    #[test]
    fn below_the_floor_names_the_limit() {
        let poor = Limits { max_storage_buffers_per_shader_stage: 4, ..minima(Tier::Floor) };
        let error = highest("old card", 0, &poor).expect_err("4 storage buffers are too few");
        let text = error.to_string();
        assert!(text.contains("old card") && text.contains("floor"), "{text}");
        assert!(text.contains("max_storage_buffers_per_shader_stage is 4, 8 is needed"), "{text}");
    }
}
