//! Listens to Vulkan's validation layers, which `BROOKLET_VALIDATION=1` asks for: whatever they
//! say ends the run of the tests, as nobody reads warnings between passing tests.

use log::{Level, LevelFilter, Log, Metadata, Record};
use std::io::Write;

/// What layers say without a fault of this program, by VUID or its words, each with its reason. Otherwise version 1.3.239
/// (Debian 12) is silent with Mesa's CPU driver.
const KNOWN: &[(&str, &str)] = &[(
    "Invalid source language operand: 10",
    "debug information of the panels' shaders names WGSL, a number younger than these layers",
)];

/// What the message that ends a run begins with.
pub const ENDED: &str = "Vulkan's validation layers have a message";
/// What wgpu says where the layers are asked for and not installed.
pub const NOT_INSTALLED: &str = "unable to find layer";

/// Whether the layers are asked for.
pub fn is_asked_for() -> bool {
    std::env::var_os("BROOKLET_VALIDATION").is_some_and(|value| value == "1")
}

struct Listener;

/// Hears the layers from now on. Called before a device is opened; more than once does no harm.
pub fn listen() {
    // At this level wgpu asks the layers for their warnings too.
    if log::set_logger(&Listener).is_ok() {
        log::set_max_level(LevelFilter::Warn);
    }
}

/// Whether a message of wgpu's is one of a layer, or of a layer that is missing.
fn is_fault(target: &str, message: &str, known: &[(&str, &str)]) -> bool {
    let is_a_layers = message.contains("VALIDATION") && known.iter().all(|(vuid, _)| !message.contains(vuid));
    target.starts_with("wgpu_hal::vulkan") && (is_a_layers || message.contains(NOT_INSTALLED))
}

impl Log for Listener {
    fn enabled(&self, metadata: &Metadata<'_>) -> bool {
        metadata.level() <= Level::Warn
    }

    fn log(&self, record: &Record<'_>) {
        let message = record.args().to_string();
        if self.enabled(record.metadata()) && is_fault(record.target(), &message, KNOWN) {
            // The layer called from inside a Vulkan call, through which a panic must not unwind;
            // and what a test prints is shown only after its end, which does not come.
            let thread = std::thread::current();
            let test = thread.name().unwrap_or("a thread without a name");
            let _ = writeln!(std::io::stderr(), "{ENDED}, in {test}: {message}");
            std::process::abort();
        }
    }

    fn flush(&self) {}
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faults_are_told_from_other_messages() {
        let hal = "wgpu_hal::vulkan::instance";
        let message = "VALIDATION [VUID-vkCmdDraw-None-1 (0x1)]\n\twrong";
        assert!(is_fault(hal, message, &[]));
        assert!(is_fault(hal, "InstanceFlags::VALIDATION requested, but unable to find layer: x", &[("VUID-a", "")]));
        assert!(!is_fault(hal, message, &[("VUID-vkCmdDraw-None-1", "a reason")]));
        assert!(!is_fault("somebody_else", message, &[]));
        assert!(!is_fault(hal, "GENERAL [Loader Message (0x0)]", &[]));
        assert!(KNOWN.iter().all(|(words, reason)| words.len() > 12 && !reason.is_empty()));
    }
}
