//! Vulkan device, recordings as data, the sweep that leaves out what nothing wants, an engine
//! that runs the rest, and GPU times as plain data. Knows no fluids.

pub mod draw;
pub mod error;
pub mod plan;
pub mod recording;
pub mod resources;
pub mod timing;

pub use brooklet_kernels::{Buffer, Format, ResourceId, Texture, Tier};
pub use draw::{Blend, Cull, DepthTest, DrawState, Load, Targets, Topology};
pub use error::{GpuError, tier_name};
pub use plan::{KeptBuffer, LeftOut, LeftOutKind, PassInfo, Plan, PlanError};
pub use recording::{Command, Recording};
pub use resources::{ResourceInfo, Resources, Shape};
pub use timing::{FrameReport, Span, SpanFlag, TimingStatus};
