//! What Linux and Android tell of heat, clocks and power, read from `/sys`. Which files there are is found
//! once; a reading takes well under a millisecond, and once a second is enough.

use std::{
    fs,
    path::{Path, PathBuf},
};

use crate::ThermalRow;

/// Hotter than this is a sensor that is not there.
const MOST_C: f64 = 200.0;

/// The files of this machine.
#[derive(Clone, Debug, Default)]
pub struct DeviceState {
    sensors: Vec<Sensor>,
    cpu_clocks: Vec<PathBuf>,
    gpu_clock: Option<(PathBuf, f64)>,
    governor: Option<PathBuf>,
    mains: Vec<PathBuf>,
    battery: Option<PathBuf>,
}

#[derive(Clone, Debug)]
struct Sensor {
    path: PathBuf,
    part: Part,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Part {
    Cpu,
    Gpu,
    Other,
}

impl Part {
    fn of(name: &str) -> Self {
        let name = name.to_lowercase();
        let has = |words: &[&str]| words.iter().any(|word| name.contains(word));
        if has(&["gpu", "amdgpu", "nouveau", "radeon", "kgsl"]) {
            Self::Gpu
        } else if has(&["cpu", "coretemp", "k10temp", "x86_pkg", "zenpower", "soc"]) {
            Self::Cpu
        } else {
            Self::Other
        }
    }
}

impl DeviceState {
    /// Finds what this machine tells.
    pub fn find() -> Self {
        Self::find_in(Path::new("/sys"))
    }

    /// As [`DeviceState::find`], in a tree like that of `/sys`.
    pub fn find_in(sys: &Path) -> Self {
        let mut found = Self::default();
        for zone in folders(&sys.join("class/thermal"), "thermal_zone") {
            found.add_sensor(zone.join("temp"), &text(&zone.join("type")).unwrap_or_default());
        }
        for chip in folders(&sys.join("class/hwmon"), "hwmon") {
            let name = text(&chip.join("name")).unwrap_or_default();
            for number in 1..=8 {
                found.add_sensor(chip.join(format!("temp{number}_input")), &name);
            }
        }
        let cpus = folders(&sys.join("devices/system/cpu"), "cpu");
        let clocks = cpus.iter().map(|cpu| cpu.join("cpufreq/scaling_cur_freq"));
        found.cpu_clocks = clocks.filter(|path| number(path).is_some()).collect();
        found.governor = cpus.iter().map(|cpu| cpu.join("cpufreq/scaling_governor")).find(|path| text(path).is_some());
        found.gpu_clock = gpu_clocks(sys).into_iter().find(|(path, _)| number(path).is_some());
        for supply in folders(&sys.join("class/power_supply"), "") {
            match text(&supply.join("type")).as_deref() {
                Some("Battery") => found.battery = Some(supply),
                Some("Mains" | "USB") => found.mains.push(supply.join("online")),
                _ => {}
            }
        }
        found
    }

    fn add_sensor(&mut self, path: PathBuf, name: &str) {
        if number(&path).is_some() {
            self.sensors.push(Sensor { path, part: Part::of(name) });
        }
    }

    /// Reads it now; what cannot be read is absent.
    pub fn read(&self) -> ThermalRow {
        let mut row = ThermalRow::default();
        for sensor in &self.sensors {
            let Some(celsius) = number(&sensor.path).map(|milli| milli * 1e-3).filter(|c| *c > 0.0 && *c < MOST_C)
            else {
                continue;
            };
            let part = match sensor.part {
                Part::Cpu => Some(&mut row.cpu_c),
                Part::Gpu => Some(&mut row.gpu_c),
                Part::Other => None,
            };
            for hottest in part.into_iter().chain([&mut row.hottest_c]) {
                *hottest = Some(hottest.unwrap_or(celsius).max(celsius));
            }
        }
        let clocks: Vec<f64> = self.cpu_clocks.iter().filter_map(|path| number(path)).collect();
        if !clocks.is_empty() {
            row.cpu_mhz = Some(clocks.iter().sum::<f64>() / clocks.len() as f64 * 1e-3);
        }
        row.gpu_mhz = self.gpu_clock.as_ref().and_then(|(path, mhz)| Some(number(path)? * mhz));
        row.governor = self.governor.as_ref().and_then(|path| text(path));
        let is_on_mains = self.mains.iter().any(|path| number(path) == Some(1.0));
        if let Some(battery) = &self.battery {
            row.battery_percent = number(&battery.join("capacity"));
            let micro_w = number(&battery.join("power_now")).or_else(|| {
                // µA times µV.
                Some(number(&battery.join("current_now"))? * number(&battery.join("voltage_now"))? * 1e-6)
            });
            row.power_w = micro_w.map(|micro_w| micro_w.abs() * 1e-6);
            let is_charged = text(&battery.join("status")).is_some_and(|status| status != "Discharging");
            row.power_source = Some(if is_on_mains || is_charged { "mains" } else { "battery" }.into());
        } else if is_on_mains {
            row.power_source = Some("mains".into());
        }
        row
    }
}

/// Files that may have a GPU's clock, and what makes MHz of their number: AMD's hwmon, Intel's, Adreno's.
fn gpu_clocks(sys: &Path) -> Vec<(PathBuf, f64)> {
    let mut files: Vec<(PathBuf, f64)> = Vec::new();
    for card in folders(&sys.join("class/drm"), "card") {
        files.push((card.join("gt_cur_freq_mhz"), 1.0));
        for chip in folders(&card.join("device/hwmon"), "hwmon") {
            files.push((chip.join("freq1_input"), 1e-6));
        }
    }
    files.push((sys.join("class/kgsl/kgsl-3d0/gpuclk"), 1e-6));
    files
}

/// Entries of a folder whose name is this and a number, or any with an empty one; in order.
fn folders(of: &Path, name: &str) -> Vec<PathBuf> {
    let is_wanted = |path: &PathBuf| {
        let found = path.file_name().unwrap_or_default().to_string_lossy();
        name.is_empty()
            || found
                .strip_prefix(name)
                .is_some_and(|rest| !rest.is_empty() && rest.bytes().all(|byte| byte.is_ascii_digit()))
    };
    let entries = fs::read_dir(of).into_iter().flatten().flatten();
    let mut found: Vec<PathBuf> = entries.map(|entry| entry.path()).filter(is_wanted).collect();
    found.sort_unstable();
    found
}

fn text(path: &Path) -> Option<String> {
    let text = fs::read_to_string(path).ok()?;
    Some(text.trim().to_string()).filter(|text| !text.is_empty())
}

fn number(path: &Path) -> Option<f64> {
    text(path)?.parse().ok().filter(|number: &f64| number.is_finite())
}
