//! The device that tests run on.

use brooklet_check::Device;
use brooklet_fluid::{Scene, Session};
use brooklet_gpu::{Gpu, GpuOptions, TIERS, Tier, tier_name};
use std::env;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Opened devices of a process: its tests share them, and those that run side by side do not wait for each other's kernels.
const DEVICES: usize = 2;

/// The device of the test that asks: the best there is, or the one that `BROOKLET_DEVICE` (part of its name) and
/// `BROOKLET_TIER` (`desktop`, `mobile`, `floor`) choose. A thread always gets the same one.
///
/// # Panics
/// Fails the test, saying why, where no such device opens: a test without a device proves nothing.
pub fn gpu() -> Gpu {
    static SHARED: Shared = [const { OnceLock::new() }; DEVICES];
    shared(&SHARED, false)
}

/// The same for a test that steps this scene hundreds of times. A scene's commands are alike in every step, and Vulkan's
/// layers take longer to look at them than a processor's driver to run them: where they are asked for, they see the scene
/// start and its first steps, and stay away from the test's own.
///
/// # Panics
/// As [`gpu`], or if the scene does not start.
pub fn gpu_of_long_run(scene: &Scene) -> Gpu {
    static SHARED: Shared = [const { OnceLock::new() }; DEVICES];
    if !crate::validation::is_asked_for() {
        return gpu();
    }
    let mut seen = Session::new(&gpu(), scene).unwrap_or_else(|error| panic!("{error}"));
    for _ in 0..STEPS_SEEN {
        seen.step().unwrap_or_else(|error| panic!("{error}"));
    }
    seen.finish().unwrap_or_else(|error| panic!("{error}"));
    shared(&SHARED, true)
}

/// Steps of a scene that the layers look at: more than are in flight, so that each buffer that is read back comes round.
const STEPS_SEEN: usize = 5;

type Shared = [OnceLock<Result<Gpu, String>>; DEVICES];

fn shared(devices: &Shared, without_layers: bool) -> Gpu {
    static NEXT: AtomicUsize = AtomicUsize::new(0);
    thread_local! {
        // The runner has a thread for each test.
        static OWN: usize = NEXT.fetch_add(1, Ordering::Relaxed) % DEVICES;
    }
    devices[OWN.with(|own| *own)]
        .get_or_init(|| open(env::var("BROOKLET_DEVICE").ok(), env::var("BROOKLET_TIER").ok(), without_layers))
        .clone()
        .unwrap_or_else(|reason| panic!("no device to test on: {reason}"))
}

/// The same, for kernels of their own and known answers.
pub fn device() -> Device {
    Device::new(gpu(), small())
}

/// Whether sizes are to be kept small: `BROOKLET_SMALL=1` leaves out those that take minutes on a driver that
/// interprets its shaders.
pub fn small() -> bool {
    env::var_os("BROOKLET_SMALL").is_some_and(|value| value != "0" && !value.is_empty())
}

fn open(device: Option<String>, tier: Option<String>, without_layers: bool) -> Result<Gpu, String> {
    crate::validation::listen();
    let set = |value: &String| !value.is_empty();
    let tier = tier.filter(set).map(|name| tier_named(&name)).transpose()?;
    let options =
        GpuOptions { device_name: device.filter(set), tier, timing: true, without_layers, ..GpuOptions::default() };
    Gpu::open(&options).map_err(|error| format!("{error}; tools/setup installs a Vulkan driver where there is none"))
}

fn tier_named(name: &str) -> Result<Tier, String> {
    TIERS
        .into_iter()
        .find(|tier| tier_name(*tier) == name)
        .ok_or_else(|| format!("BROOKLET_TIER is '{name}'; allowed: {}", TIERS.map(tier_name).join(", ")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_device_opens_on_the_tier_asked_for() {
        assert_eq!(open(None, Some("floor".into()), false).unwrap().tier(), Tier::Floor);
        assert_eq!(gpu().info(), gpu().info());
    }

    #[test]
    fn a_device_that_is_not_there_is_named() {
        let wrong = |device: &str, tier: &str| open(Some(device.into()), Some(tier.into()), false).err().unwrap();
        assert!(wrong("no such device", "").contains("no such device"));
        assert!(wrong("", "phone").contains("'phone'; allowed: desktop, mobile, floor"));
    }
}
