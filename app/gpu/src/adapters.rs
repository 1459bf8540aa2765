//! Every adapter with what it reaches, for `doctor`.

use crate::device::{DeviceInfo, device_info, rank, vulkan_adapters};
use crate::error::tier_name;
use crate::tier::{self, TIERS};
use brooklet_kernels::Tier;
use wgpu::Features;

/// Something an adapter lacks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Missing {
    /// What: a feature, or a limit with both numbers.
    pub what: String,
    /// What it costs.
    pub cost: String,
}

/// What Brooklet finds at an adapter.
#[derive(Clone, Debug, PartialEq)]
pub struct AdapterReport {
    /// What is known of it, with the limits it could be opened with.
    pub info: DeviceInfo,
    /// The highest tier it reaches; `None` if Brooklet cannot run on it.
    pub tier: Option<Tier>,
    /// What it lacks.
    pub missing: Vec<Missing>,
}

/// Every Vulkan adapter of this machine, the one chosen by default first. Empty without Vulkan.
pub fn adapters() -> Vec<AdapterReport> {
    let mut adapters = vulkan_adapters();
    adapters.sort_by_key(|adapter| {
        let usable = adapter.features().contains(tier::ESSENTIAL);
        (!usable, rank(adapter.get_info().device_type))
    });
    adapters.iter().map(report).collect()
}

fn report(adapter: &wgpu::Adapter) -> AdapterReport {
    let info = adapter.get_info();
    let limits = adapter.limits();
    let features = adapter.features();
    let passthrough = features.contains(tier::ESSENTIAL);
    let reached = tier::highest_tier(adapter).ok();
    let mut missing = missing_features(features);
    for tier in TIERS {
        if reached.is_some_and(|reached| tier <= reached) {
            break;
        }
        for lack in tier::shortfalls(tier, &limits) {
            missing.push(Missing {
                what: format!("{} is {}, {} is needed", lack.limit, lack.available, lack.needed),
                cost: format!("no {} tier", tier_name(tier)),
            });
        }
    }
    AdapterReport {
        // The period is a device's; nothing is opened for a report.
        info: device_info(&info, &limits, 0.0),
        tier: reached.filter(|_| passthrough),
        missing,
    }
}

fn missing_features(features: Features) -> Vec<Missing> {
    let costs = [
        (Features::PASSTHROUGH_SHADERS, "PASSTHROUGH_SHADERS", "Brooklet cannot run"),
        (Features::TIMESTAMP_QUERY, "TIMESTAMP_QUERY", "no GPU times"),
        (
            Features::TIMESTAMP_QUERY_INSIDE_PASSES,
            "TIMESTAMP_QUERY_INSIDE_PASSES",
            "timed runs use a pass per stage, which costs time of its own",
        ),
        (Features::PIPELINE_CACHE, "PIPELINE_CACHE", "kernels are compiled at every start"),
        (Features::FLOAT32_FILTERABLE, "FLOAT32_FILTERABLE", "32-bit float textures are not filtered"),
        (Features::SHADER_F16, "SHADER_F16", "no half-precision kernels"),
        (Features::SUBGROUP, "SUBGROUP", "scans use groupshared memory"),
    ];
    costs
        .into_iter()
        .filter(|(feature, ..)| !features.contains(*feature))
        .map(|(_, what, cost)| Missing { what: what.into(), cost: cost.into() })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_missing_says_what_it_costs() {
        let missing = missing_features(Features::all() - Features::TIMESTAMP_QUERY);
        assert_eq!(missing.len(), 1);
        assert_eq!(missing[0].what, "TIMESTAMP_QUERY");
        assert_eq!(missing[0].cost, "no GPU times");
    }
}
