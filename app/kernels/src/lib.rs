//! Every compute and draw kernel of Brooklet as SPIR-V, with typed binding structs.
//!
//! What `src/generated` and `spirv` hold is written by the shader compiler (`tools/compiler`)
//! from `shaders/hlsl`, but for the kernels that only benchmarks run, which `brooklet-bench` holds; the few
//! types those files are made of stand beside this page. This crate knows no GPU API: `brooklet-gpu` runs what
//! it describes.

mod binding;
mod generated;
pub mod module;
pub mod resource;
mod spirv;

pub use binding::{Given, bind, bind_draw};
pub use module::{Access, BindingError, BindingInfo, BindingKind, Bound, Draw, Kernel, Module, StageKind, Tier};
pub use resource::{Buf, BufMut, Buffer, Format, ResourceId, Tex, TexMut, Texture, Uniform};
pub use spirv::Spirv;

pub use generated::*;
