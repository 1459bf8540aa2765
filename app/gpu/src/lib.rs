//! Vulkan device, recordings as data, the sweep that leaves out what nothing wants, an engine
//! that runs the rest, and GPU times as plain data. Knows no fluids.

mod adapters;
mod cache;
mod copy_out;
mod device;
mod draw;
mod driver;
mod encode;
mod engine;
mod error;
mod formats;
mod guard;
mod layout;
mod memory;
mod order;
mod pass_timer;
mod pipelines;
mod plan;
mod plan_difference;
mod plan_modules;
mod pool;
mod readback;
pub mod recording;
mod resources;
mod run_times;
mod steps;
mod tier;
mod timing;

pub use adapters::{AdapterReport, Missing, adapters};
pub use brooklet_kernels::{Buffer, Format, ResourceId, Texture, Tier};
pub use cache::CacheStatus;
pub use device::{DeviceInfo, Gpu, GpuOptions, vulkan_instance};
pub use draw::{Blend, Cull, DepthTest, DrawState, Load, RecordedTargets, Targets, Topology, texture_format};
pub use driver::DriverFacts;
pub use engine::{Engine, FRAMES_IN_FLIGHT};
pub use error::{GpuError, tier_name};
pub use formats::{FormatSupport, check_formats};
pub use pass_timer::PassTimer;
pub use plan::{KeptBuffer, LeftOut, LeftOutKind, PassInfo, Plan, PlanError};
pub use plan_difference::ChangedUpload;
pub use readback::timestamp_bytes;
pub use recording::{Command, Groups, IndirectArgs, Instances, RecordError, Recording, RecordingId, group_grid};
pub use resources::{ResourceInfo, Resources, Shape};
pub use run_times::{PassTimes, Passes, Quantiles, Timings, quantile, stages, warm_up_frames};
pub use tier::{Shortfall, TIERS, highest_tier};
pub use timing::{FrameReport, Span, SpanFlag, TimingStatus};
