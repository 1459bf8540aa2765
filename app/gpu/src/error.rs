//! What can go wrong, and what to do about it.

use brooklet_kernels::Tier;

/// Opening a device, or running on it, failed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum GpuError {
    /// No Vulkan driver, or no device that it drives.
    #[error(
        "no Vulkan device: install your GPU's driver, or a software one \
         (Debian and Ubuntu: apt-get install libvulkan1 mesa-vulkan-drivers; \
         Fedora: dnf install vulkan-loader mesa-vulkan-drivers)"
    )]
    NoVulkan,
    /// No adapter has this name.
    #[error("no device is called \"{wanted}\"; there are: {}", present.join(", "))]
    NoSuchDevice {
        /// The name asked for.
        wanted: String,
        /// Names of the adapters there are.
        present: Vec<String>,
    },
    /// No adapter can present to the window's surface.
    #[error("no Vulkan device of this machine can show pictures in a window here; `brooklet run` needs no window")]
    ShowsNothing,
    /// The caller's own device lacks a feature.
    #[error(
        "{device} was opened without the wgpu feature {feature}; \
         ask for Gpu::required_features when opening it"
    )]
    MissingFeature {
        /// The device.
        device: String,
        /// The feature.
        feature: &'static str,
    },
    /// The adapter cannot run SPIR-V modules as they are.
    #[error(
        "{device} cannot run SPIR-V as it is (wgpu's PASSTHROUGH_SHADERS); it drives {backend}, and Vulkan is needed"
    )]
    NoPassthrough {
        /// The device.
        device: String,
        /// Its API.
        backend: String,
    },
    /// The adapter does not reach a tier.
    #[error("{device} is below the {tier} tier: {limit} is {available}, {needed} is needed")]
    MissingLimit {
        /// The device.
        device: String,
        /// The tier asked for.
        tier: &'static str,
        /// wgpu's name of the limit.
        limit: &'static str,
        /// What the tier needs.
        needed: u64,
        /// What there is.
        available: u64,
    },
    /// The device cannot do with a format what a texture is there for.
    #[error("{device} cannot use {format} as texture {label} is: {used_as}")]
    MissingFormat {
        /// The device.
        device: String,
        /// The texture.
        label: String,
        /// Its format.
        format: String,
        /// What the plan does with it.
        used_as: &'static str,
    },
    /// The driver refused to open the device.
    #[error("{device} could not be opened: {reason}")]
    OpenFailed {
        /// The device.
        device: String,
        /// What the driver says.
        reason: String,
    },
    /// A module is made for a higher tier than the device is used as.
    #[error(
        "kernel {module} is made for the {needs} tier, and the device runs as {has}; \
         choose a variant for {has}, or force no lower tier"
    )]
    ModuleAboveTier {
        /// The module.
        module: &'static str,
        /// The module's tier.
        needs: &'static str,
        /// The device's tier.
        has: &'static str,
    },
    /// A module exceeds a limit of the device.
    #[error("kernel {module} needs {needed} {what}, and the device allows {limit}")]
    ModuleLimit {
        /// The module.
        module: &'static str,
        /// What it needs too much of.
        what: &'static str,
        /// How much.
        needed: u64,
        /// What the device allows.
        limit: u64,
    },
    /// A buffer is larger than a binding or a buffer may be.
    #[error("buffer {label} has {bytes} bytes, and the device allows {limit} ({limit_name})")]
    BufferTooLarge {
        /// The buffer.
        label: String,
        /// Its size.
        bytes: u64,
        /// The limit.
        limit: u64,
        /// wgpu's name of the limit.
        limit_name: &'static str,
    },
    /// A texture is larger than the device allows.
    #[error("texture {label} has {width} x {height} pixels, and the device allows {limit} a side")]
    TextureTooLarge {
        /// The texture.
        label: String,
        /// Its width.
        width: u32,
        /// Its height.
        height: u32,
        /// The limit.
        limit: u32,
    },
    /// The device has no memory left.
    #[error("out of GPU memory at {label}: {bytes} bytes more are needed, and {allocated} are allocated")]
    OutOfMemory {
        /// The buffer or texture.
        label: String,
        /// Its size.
        bytes: u64,
        /// What was allocated before.
        allocated: u64,
    },
    /// The driver could not compile a kernel.
    #[error("the driver could not build kernel {module}: {reason}")]
    Pipeline {
        /// The module, with its variant.
        module: &'static str,
        /// What the driver says.
        reason: String,
    },
    /// A kernel is not to be built on this device.
    #[error("kernel {module} is not used on this device: {reason}")]
    ModuleRefused {
        /// The module, with its variant.
        module: &'static str,
        /// Why.
        reason: String,
    },
    /// The device is gone.
    #[error("the GPU device was lost: {reason}")]
    DeviceLost {
        /// What the driver says.
        reason: String,
    },
    /// A recording that the plan does not have was to run.
    #[error("there is no recording \"{name}\"; the plan has: {}", present.join(", "))]
    NoSuchRecording {
        /// The name asked for.
        name: String,
        /// Names there are.
        present: Vec<&'static str>,
    },
    /// A resource that the plan left out was to be read.
    #[error("{label} cannot be read: {reason}")]
    NotReadable {
        /// The resource.
        label: String,
        /// Why not.
        reason: &'static str,
    },
    /// A plan was to take over an engine that has other memory.
    #[error("the new plan cannot take over {label}: {reason}; make a new engine")]
    OtherMemory {
        /// The first resource that differs.
        label: String,
        /// How.
        reason: &'static str,
    },
    /// More was written than a buffer holds.
    #[error("{elements} elements were written to buffer {label}, which has {room}")]
    WriteTooLong {
        /// The buffer.
        label: String,
        /// Elements written.
        elements: usize,
        /// Elements it has.
        room: u32,
    },
    /// wgpu refused a command: a mistake in this program.
    #[error("the GPU interface refused a command: {reason}")]
    Refused {
        /// What wgpu says.
        reason: String,
    },
}

/// A tier's name, as `--tier` takes it.
pub fn tier_name(tier: Tier) -> &'static str {
    match tier {
        Tier::Floor => "floor",
        Tier::Mobile => "mobile",
        Tier::Desktop => "desktop",
    }
}

/// wgpu's error with its causes, on one line.
pub(crate) fn describe(error: &dyn std::error::Error) -> String {
    let mut text = one_line(&error.to_string());
    let mut cause = error.source();
    while let Some(inner) = cause {
        let inner_text = one_line(&inner.to_string());
        if !text.contains(&inner_text) {
            text.push_str(": ");
            text.push_str(&inner_text);
        }
        cause = inner.source();
    }
    text
}

fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
