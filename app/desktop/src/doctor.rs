//! `brooklet doctor`: the devices of this machine, and what each of them lacks.

use brooklet_gpu::{AdapterReport, GpuError, adapters, tier_name};
use serde_json::{Map, Value, json};

use crate::{cli::DoctorOptions, failure::Failure};

/// Prints every adapter, or checks one; fails when none of them can run Brooklet.
pub fn doctor(options: &DoctorOptions) -> Result<(), Failure> {
    if let Some(scene) = &options.check {
        return check(options, scene);
    }
    let reports = adapters();
    if options.json {
        let list: Vec<Value> = reports.iter().map(as_json).collect();
        say!("{}", serde_json::to_string_pretty(&list).map_err(Failure::stopped)?);
    } else {
        for (index, report) in reports.iter().enumerate() {
            print(report, index == 0 && report.tier.is_some());
        }
    }
    if reports.is_empty() {
        return Err(Failure::input(GpuError::NoVulkan));
    }
    if reports.iter().all(|report| report.tier.is_none()) {
        return Err(Failure::Input("no device of this machine can run Brooklet".into()));
    }
    Ok(())
}

#[cfg(feature = "check")]
fn check(options: &DoctorOptions, scene: &str) -> Result<(), Failure> {
    crate::check::check(options, scene)
}

#[cfg(not(feature = "check"))]
fn check(_: &DoctorOptions, _: &str) -> Result<(), Failure> {
    Err(Failure::Input(
        "this build leaves `brooklet doctor --check` out; `cargo run --release -- doctor --check` builds and runs the whole \
         program"
            .into(),
    ))
}

fn print(report: &AdapterReport, is_default: bool) {
    let info = &report.info;
    let chosen = if is_default { ", used by default" } else { "" };
    say!("{} ({}{chosen})", info.name, info.device_type);
    say!("  driver    {} {}, {}", info.driver, info.driver_info, info.backend);
    say!("  tier      {}", report.tier.map_or("none: Brooklet cannot run on it", tier_name));
    if info.device_type == "cpu" {
        say!("  note      a driver that runs on the processor: its times are the processor's");
    }
    for (index, missing) in report.missing.iter().enumerate() {
        let head = if index == 0 { "missing" } else { "" };
        say!("  {head:<9} {}: {}", missing.what, missing.cost);
    }
    if report.missing.is_empty() {
        say!("  missing   nothing");
    }
    for (index, (name, value)) in info.limits.iter().enumerate() {
        let head = if index == 0 { "limits" } else { "" };
        say!("  {head:<9} {name} {value}");
    }
    say!();
}

fn as_json(report: &AdapterReport) -> Value {
    let info = &report.info;
    let limits: Map<String, Value> =
        info.limits.iter().map(|(name, value)| (name.to_string(), (*value).into())).collect();
    let missing: Vec<Value> =
        report.missing.iter().map(|missing| json!({ "what": missing.what, "cost": missing.cost })).collect();
    json!({
        "name": info.name,
        "device_type": info.device_type,
        "driver": info.driver,
        "driver_info": info.driver_info,
        "backend": info.backend,
        "tier": report.tier.map(tier_name),
        "missing": missing,
        "limits": limits,
    })
}
