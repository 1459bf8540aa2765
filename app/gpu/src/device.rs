//! The device: chosen by name, the best there is, or handed in by the caller.

use crate::error::{GpuError, describe, tier_name};
use crate::formats::{DeviceFormats, FormatUse};
use crate::guard::{Guard, lock};
use crate::pipelines::Pipelines;
use crate::pool::Pool;
use crate::tier;
use crate::timing::TimingStatus;
use brooklet_kernels::{Format, Tier};
use std::path::PathBuf;
use std::sync::{Arc, Mutex, MutexGuard};

/// How to open a device.
#[derive(Clone, Debug, Default)]
pub struct GpuOptions {
    /// Part of the device's name, in any case; the best device if `None`.
    pub device_name: Option<String>,
    /// Tier to use it as, asking only for that tier's limits; the highest it reaches if `None`.
    pub tier: Option<Tier>,
    /// Folder where compiled pipelines are kept between runs; not kept if `None`.
    pub pipeline_cache: Option<PathBuf>,
    /// Whether GPU times are taken.
    pub timing: bool,
    /// Whether the name of each kernel that the driver is about to build is noted in that folder, so that one which ends
    /// the program is done without at the next start (`canary.rs`). A program that is killed looks the same: so it is for
    /// programs that nobody kills while they start.
    pub watch_builds: bool,
    /// What not to do with formats, though the device can: to see what is then done instead.
    pub without_formats: Vec<(Format, FormatUse)>,
    /// Whether Vulkan's validation layers stay away though `BROOKLET_VALIDATION=1` asks for them.
    pub without_layers: bool,
}

/// What is known of a device.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DeviceInfo {
    /// Its name.
    pub name: String,
    /// Its driver's name.
    pub driver: String,
    /// Its driver's version.
    pub driver_info: String,
    /// `vulkan`.
    pub backend: String,
    /// `discrete`, `integrated`, `virtual`, `cpu` or `other`.
    pub device_type: String,
    /// PCI vendor.
    pub vendor: u32,
    /// PCI device.
    pub device: u32,
    /// Nanoseconds a timestamp tick lasts.
    pub timestamp_period_ns: f64,
    /// Limits it was opened with, by wgpu's names.
    pub limits: Vec<(&'static str, u64)>,
}

/// An open device with its queue. Cheap to clone: all clones are the same device.
#[derive(Clone)]
pub struct Gpu {
    inner: Arc<Inner>,
}

struct Inner {
    guard: Guard,
    queue: wgpu::Queue,
    tier: Tier,
    info: DeviceInfo,
    timing: TimingStatus,
    formats: DeviceFormats,
    adapter: wgpu::Adapter,
    pool: Mutex<Pool>,
    pipelines: Mutex<Pipelines>,
}

impl Gpu {
    /// Opens a device.
    ///
    /// # Errors
    /// If there is no Vulkan, no such device, or it lacks what Brooklet needs.
    pub fn open(options: &GpuOptions) -> Result<Gpu, GpuError> {
        Self::open_on(&instance(!options.without_layers), None, options)
    }

    /// As [`Gpu::open`], on an instance of [`vulkan_instance`], a device that shows its pictures on `surface`.
    ///
    /// # Errors
    /// As [`Gpu::open`], or if none of the devices can show anything there.
    pub fn open_on(
        instance: &wgpu::Instance,
        surface: Option<&wgpu::Surface<'_>>,
        options: &GpuOptions,
    ) -> Result<Gpu, GpuError> {
        let all = adapters_of(instance);
        let is_there = !all.is_empty();
        let shows = |adapter: &wgpu::Adapter| surface.is_none_or(|surface| adapter.is_surface_supported(surface));
        let able: Vec<wgpu::Adapter> = all.into_iter().filter(shows).collect();
        if is_there && able.is_empty() {
            return Err(GpuError::ShowsNothing);
        }
        let adapter = choose(able, options.device_name.as_deref())?;
        let info = adapter.get_info();
        require_passthrough(&info, adapter.features())?;
        let tier = match options.tier {
            Some(tier) => tier,
            None => tier::highest_tier(&adapter)?,
        };
        let available = adapter.limits();
        tier::check(&info.name, tier, &available)?;
        let wanted = Self::required_features(&adapter) | (tier::useful_on(tier) & adapter.features());
        let request = adapter.request_device(&wgpu::DeviceDescriptor {
            label: Some("brooklet"),
            required_features: wanted,
            required_limits: tier::limits_for(tier, &available),
            ..Default::default()
        });
        let (device, queue) = pollster::block_on(request)
            .map_err(|error| GpuError::OpenFailed { device: info.name.clone(), reason: describe(&error) })?;
        let guard = Guard::new(device);
        guard.keep_stray_errors(|error| describe(error));
        Ok(Self::assemble(guard, queue, tier, options, &adapter))
    }

    /// Uses the caller's own device, opened with [`Gpu::required_features`] and
    /// [`Gpu::required_limits`]. Sets the device's lost callback, and nothing else of it. GPU
    /// times are taken if the device has timestamps.
    ///
    /// # Errors
    /// If the device lacks a feature, or a limit of the tier (the highest it reaches if `None`).
    pub fn from_device(
        adapter: &wgpu::Adapter,
        device: wgpu::Device,
        queue: wgpu::Queue,
        tier: Option<Tier>,
    ) -> Result<Gpu, GpuError> {
        let info = adapter.get_info();
        require_passthrough(&info, adapter.features())?;
        if !device.features().contains(tier::ESSENTIAL) {
            return Err(GpuError::MissingFeature { device: info.name, feature: "PASSTHROUGH_SHADERS" });
        }
        let limits = device.limits();
        let tier = match tier {
            Some(tier) => tier,
            None => tier::highest(&info.name, info.vendor, &limits)?,
        };
        tier::check(&info.name, tier, &limits)?;
        let options = GpuOptions { timing: true, ..GpuOptions::default() };
        Ok(Self::assemble(Guard::new(device), queue, tier, &options, adapter))
    }

    fn assemble(guard: Guard, queue: wgpu::Queue, tier: Tier, options: &GpuOptions, adapter: &wgpu::Adapter) -> Gpu {
        let device = &guard.device;
        let adapter_info = adapter.get_info();
        let features = device.features();
        let timing = if !options.timing {
            TimingStatus::Off
        } else if features.contains(wgpu::Features::TIMESTAMP_QUERY | wgpu::Features::TIMESTAMP_QUERY_INSIDE_PASSES) {
            TimingStatus::InsidePasses
        } else if features.contains(wgpu::Features::TIMESTAMP_QUERY) {
            TimingStatus::PassPerStage
        } else {
            TimingStatus::Unsupported
        };
        let info = device_info(&adapter_info, &device.limits(), f64::from(queue.get_timestamp_period()));
        let pipelines = Pipelines::new(device, &adapter_info, options.pipeline_cache.as_deref(), options.watch_builds);
        let pool = Pool::new(device.limits().max_buffer_size);
        Gpu {
            inner: Arc::new(Inner {
                guard,
                queue,
                tier,
                info,
                timing,
                formats: DeviceFormats::of(adapter, features, &options.without_formats),
                adapter: adapter.clone(),
                pool: Mutex::new(pool),
                pipelines: Mutex::new(pipelines),
            }),
        }
    }

    /// Features that a device must be opened with, of those that `adapter` has.
    pub fn required_features(adapter: &wgpu::Adapter) -> wgpu::Features {
        tier::ESSENTIAL | (tier::useful() & adapter.features())
    }

    /// Limits that a device must be opened with to be used as `tier`.
    pub fn required_limits(adapter: &wgpu::Adapter, tier: Tier) -> wgpu::Limits {
        tier::limits_for(tier, &adapter.limits())
    }

    /// The tier it is used as.
    pub fn tier(&self) -> Tier {
        self.inner.tier
    }

    /// What is known of the device.
    pub fn info(&self) -> &DeviceInfo {
        &self.inner.info
    }

    /// How its GPU times are taken.
    pub fn timing(&self) -> TimingStatus {
        self.inner.timing
    }

    /// wgpu's adapter.
    pub fn adapter(&self) -> &wgpu::Adapter {
        &self.inner.adapter
    }

    /// wgpu's device.
    pub fn device(&self) -> &wgpu::Device {
        &self.inner.guard.device
    }

    /// wgpu's queue.
    pub fn queue(&self) -> &wgpu::Queue {
        &self.inner.queue
    }

    /// Why the device was lost, if it was.
    pub fn is_lost(&self) -> Option<String> {
        self.inner.guard.is_lost()
    }

    /// How the kept pipelines were found.
    pub fn pipeline_cache(&self) -> crate::pipelines::CacheStatus {
        lock(&self.inner.pipelines).cache_status()
    }

    /// Bytes of GPU memory that wait in the pool for the next engine.
    pub fn pooled_bytes(&self) -> u64 {
        lock(&self.inner.pool).free_bytes()
    }

    /// Builds `module` no more on this device: its variant, by its whole name, computes wrongly there. Engines that have it
    /// keep it.
    pub fn refuse(&self, module: &str, reason: &str) {
        lock(&self.inner.pipelines).refuse(module, reason);
    }

    /// Builds `module` after all, if it is only suspected of having ended an earlier program; whether it was.
    pub fn trust(&self, module: &str) -> bool {
        lock(&self.inner.pipelines).trust(module)
    }

    /// Modules that are not built on this device, and why: refused, or they ended the program at an earlier start.
    pub fn refused(&self) -> Vec<(String, String)> {
        let refused = lock(&self.inner.pipelines);
        refused.refused().iter().map(|(module, reason)| (module.clone(), reason.clone())).collect()
    }

    /// Gives pooled memory back to the driver.
    pub fn trim(&self) {
        lock(&self.inner.pool).trim();
    }

    /// Whether the device lacks anything of what every device is to do with a format.
    pub fn lacks_formats(&self) -> bool {
        self.inner.formats.lacks_any()
    }

    pub(crate) fn formats(&self) -> &DeviceFormats {
        &self.inner.formats
    }

    pub(crate) fn pool(&self) -> MutexGuard<'_, Pool> {
        lock(&self.inner.pool)
    }

    pub(crate) fn pipelines(&self) -> MutexGuard<'_, Pipelines> {
        lock(&self.inner.pipelines)
    }

    /// An error that came outside of any call since the last time, or the device's loss.
    pub(crate) fn check(&self) -> Result<(), GpuError> {
        if let Some(reason) = self.is_lost() {
            return Err(GpuError::DeviceLost { reason });
        }
        match self.inner.guard.take_stray() {
            Some(reason) => Err(GpuError::Refused { reason }),
            None => Ok(()),
        }
    }

    pub(crate) fn guard(&self) -> &Guard {
        &self.inner.guard
    }

    /// Runs `work`, and turns what wgpu has against it into an error.
    pub(crate) fn scoped<T>(&self, work: impl FnOnce() -> T) -> Result<T, wgpu::Error> {
        self.inner.guard.scoped(work)
    }

    /// As [`Gpu::scoped`], for commands: what wgpu refuses there is this program's mistake, unless
    /// the device is lost.
    pub(crate) fn guarded<T>(&self, work: impl FnOnce() -> T) -> Result<T, GpuError> {
        let result = self.scoped(work);
        self.check()?;
        result.map_err(|error| self.cause_of(GpuError::Refused { reason: describe(&error) }))
    }

    /// The device's loss if that is behind `error`. wgpu reports a loss only once it has looked
    /// after all finished work; until then, calls fail in their own ways.
    pub(crate) fn cause_of(&self, error: GpuError) -> GpuError {
        let wait = wgpu::PollType::wait_indefinitely();
        match self.poll_as(wait) {
            Err(lost @ GpuError::DeviceLost { .. }) => lost,
            _ => error,
        }
    }

    /// Lets wgpu look after finished work; `None` does not wait.
    pub(crate) fn poll(&self, wait_for: Option<wgpu::SubmissionIndex>) -> Result<(), GpuError> {
        self.check()?;
        self.poll_as(match wait_for {
            Some(index) => wgpu::PollType::Wait { submission_index: Some(index), timeout: None },
            None => wgpu::PollType::Poll,
        })
    }

    fn poll_as(&self, poll_type: wgpu::PollType) -> Result<(), GpuError> {
        // wgpu 30 panics in `poll` when the device is lost while it waits. A loss is no mistake
        // of the program's, so it must not end it.
        let polled = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| self.inner.guard.device.poll(poll_type)));
        self.check()?;
        match polled {
            Ok(Ok(_)) => Ok(()),
            Ok(Err(error)) => Err(GpuError::Refused { reason: describe(&error) }),
            Err(_) => Err(GpuError::DeviceLost { reason: "waiting for it failed".into() }),
        }
    }
}

impl std::fmt::Debug for Gpu {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Gpu({}, {})", self.inner.info.name, tier_name(self.inner.tier))
    }
}

fn require_passthrough(info: &wgpu::AdapterInfo, features: wgpu::Features) -> Result<(), GpuError> {
    if info.backend == wgpu::Backend::Vulkan && features.contains(tier::ESSENTIAL) {
        Ok(())
    } else {
        Err(GpuError::NoPassthrough { device: info.name.clone(), backend: format!("{:?}", info.backend) })
    }
}

/// Every Vulkan device of this machine.
pub(crate) fn vulkan_adapters() -> Vec<wgpu::Adapter> {
    adapters_of(&vulkan_instance())
}

fn adapters_of(instance: &wgpu::Instance) -> Vec<wgpu::Adapter> {
    pollster::block_on(instance.enumerate_adapters(wgpu::Backends::VULKAN))
}

/// What devices, and surfaces for [`Gpu::open_on`], come from.
pub fn vulkan_instance() -> wgpu::Instance {
    instance(true)
}

fn instance(layers: bool) -> wgpu::Instance {
    // VALIDATION_INDIRECT_CALL stays off: it would add a hidden dispatch to every indirect one.
    let mut flags = wgpu::InstanceFlags::empty();
    if layers && std::env::var_os("BROOKLET_VALIDATION").is_some_and(|value| value == "1") {
        flags |= wgpu::InstanceFlags::VALIDATION | wgpu::InstanceFlags::DEBUG;
    }
    wgpu::Instance::new(wgpu::InstanceDescriptor {
        backends: wgpu::Backends::VULKAN,
        flags,
        // Refuse an allocation just before the driver would fail or swap: where the driver tells
        // its budget, too little memory is then an error that names the buffer.
        memory_budget_thresholds: wgpu::MemoryBudgetThresholds {
            for_resource_creation: Some(98),
            for_device_loss: None,
        },
        ..wgpu::InstanceDescriptor::new_without_display_handle()
    })
}

fn choose(adapters: Vec<wgpu::Adapter>, wanted: Option<&str>) -> Result<wgpu::Adapter, GpuError> {
    if adapters.is_empty() {
        return Err(GpuError::NoVulkan);
    }
    let infos: Vec<wgpu::AdapterInfo> = adapters.iter().map(wgpu::Adapter::get_info).collect();
    let present: Vec<String> = infos.iter().map(|info| info.name.clone()).collect();
    let usable = |index: usize| adapters[index].features().contains(tier::ESSENTIAL);
    let best = (0..infos.len())
        .filter(|index| wanted.is_none_or(|wanted| is_called(&infos[*index].name, wanted)))
        .min_by_key(|index| (!usable(*index), rank(infos[*index].device_type)));
    match best {
        Some(index) => Ok(adapters.into_iter().nth(index).ok_or(GpuError::NoVulkan)?),
        None => Err(GpuError::NoSuchDevice { wanted: wanted.unwrap_or_default().to_owned(), present }),
    }
}

fn is_called(name: &str, wanted: &str) -> bool {
    name.to_lowercase().contains(&wanted.to_lowercase())
}

/// Order of preference, best first.
pub(crate) fn rank(device_type: wgpu::DeviceType) -> u32 {
    match device_type {
        wgpu::DeviceType::DiscreteGpu => 0,
        wgpu::DeviceType::IntegratedGpu => 1,
        wgpu::DeviceType::VirtualGpu => 2,
        wgpu::DeviceType::Cpu => 3,
        wgpu::DeviceType::Other => 4,
    }
}

pub(crate) fn device_info(adapter: &wgpu::AdapterInfo, limits: &wgpu::Limits, timestamp_period_ns: f64) -> DeviceInfo {
    DeviceInfo {
        name: adapter.name.clone(),
        driver: adapter.driver.clone(),
        driver_info: adapter.driver_info.clone(),
        backend: adapter.backend.to_str().to_owned(),
        device_type: match adapter.device_type {
            wgpu::DeviceType::DiscreteGpu => "discrete",
            wgpu::DeviceType::IntegratedGpu => "integrated",
            wgpu::DeviceType::VirtualGpu => "virtual",
            wgpu::DeviceType::Cpu => "cpu",
            wgpu::DeviceType::Other => "other",
        }
        .to_owned(),
        vendor: adapter.vendor,
        device: adapter.device,
        timestamp_period_ns,
        limits: named_limits(limits),
    }
}

fn named_limits(limits: &wgpu::Limits) -> Vec<(&'static str, u64)> {
    macro_rules! named {
        ($($name:ident),* $(,)?) => { vec![$((stringify!($name), u64::from(limits.$name))),*] };
    }
    named![
        max_storage_buffer_binding_size,
        max_buffer_size,
        max_uniform_buffer_binding_size,
        max_storage_buffers_per_shader_stage,
        max_uniform_buffers_per_shader_stage,
        max_storage_textures_per_shader_stage,
        max_sampled_textures_per_shader_stage,
        max_samplers_per_shader_stage,
        max_bind_groups,
        max_compute_workgroup_storage_size,
        max_compute_invocations_per_workgroup,
        max_compute_workgroup_size_x,
        max_compute_workgroup_size_y,
        max_compute_workgroup_size_z,
        max_compute_workgroups_per_dimension,
        max_texture_dimension_2d,
        max_color_attachments,
        min_storage_buffer_offset_alignment,
        min_uniform_buffer_offset_alignment,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_match_in_part_and_in_any_case() {
        assert!(is_called("llvmpipe (LLVM 15.0.6, 256 bits)", "LLVMpipe"));
        assert!(!is_called("llvmpipe (LLVM 15.0.6, 256 bits)", "geforce"));
    }

    #[test]
    fn no_adapter_is_no_vulkan() {
        let error = choose(Vec::new(), None).expect_err("there is none");
        assert!(error.to_string().contains("mesa-vulkan-drivers"));
    }

    #[test]
    fn a_discrete_card_goes_before_a_cpu() {
        use wgpu::DeviceType as D;
        let mut kinds = [D::Cpu, D::Other, D::IntegratedGpu, D::DiscreteGpu, D::VirtualGpu];
        kinds.sort_by_key(|kind| rank(*kind));
        assert_eq!(kinds, [D::DiscreteGpu, D::IntegratedGpu, D::VirtualGpu, D::Cpu, D::Other]);
    }
}
