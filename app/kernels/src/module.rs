//! What is known of a compiled module: its words, its bindings, the tier it needs.

use crate::resource::{Format, ResourceId};
use crate::spirv::Spirv;

/// Device classes, lowest first. A module's tier is the lowest one whose limits it keeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Tier {
    /// Adreno 540 with Vulkan 1.0.61, SwiftShader: no subgroups, groups of at most 256 threads,
    /// at most 8 storage buffers and 4 storage images a stage.
    Floor,
    /// Adreno 6xx/7xx, Mali: bindings of at most 128 MiB.
    Mobile,
    /// Discrete and integrated desktop GPUs.
    Desktop,
}

/// The pipeline stage a module's one entry point is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum StageKind {
    /// A compute kernel.
    Compute,
    /// A vertex stage.
    Vertex,
    /// A fragment stage.
    Fragment,
}

/// How a kernel uses a resource.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Access {
    /// Only read.
    Read,
    /// Read and written (a `BufMut` counts as both).
    ReadWrite,
}

/// What stands at a binding slot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BindingKind {
    /// A uniform buffer of `bytes` bytes.
    Uniform {
        /// Size of the block in bytes.
        bytes: u32,
    },
    /// A storage buffer whose elements are `stride_bytes` apart.
    Storage {
        /// Read only, or read and written.
        access: Access,
        /// Distance of two elements in bytes.
        stride_bytes: u32,
    },
    /// A sampled 2-D texture.
    Texture {
        /// Whether it is sampled as depth or needs no filtering (`Texture2D<float>` of R32F).
        filterable: bool,
    },
    /// A storage image.
    StorageTexture {
        /// Its format, as `[[vk::image_format]]` gives it.
        format: Format,
        /// Read only, or read and written.
        access: Access,
    },
    /// A sampler; its settings are read from its name, as Unity's inline samplers
    /// (`sampler_linear_clamp`, `sampler_point_repeat`).
    Sampler,
}

/// One binding of a module.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BindingInfo {
    /// The resource's name in HLSL.
    pub name: &'static str,
    /// Its slot in set 0; slots are dense (0..n) in each module or draw.
    pub slot: u32,
    /// What stands there.
    pub kind: BindingKind,
}

/// One SPIR-V 1.0 module with one entry point.
#[derive(Clone, Copy, Debug)]
pub struct Module {
    /// Kernel name with the keywords that are on: `CorrectPositions`, `CorrectPositions+S_CORR`.
    pub name: &'static str,
    /// Name of the entry point inside the module.
    pub entry: &'static str,
    /// Which stage it is for.
    pub stage: StageKind,
    /// Its words.
    pub spirv: Spirv,
    /// Its bindings, by slot.
    pub bindings: &'static [BindingInfo],
    /// Threads of a group (`[numthreads]`); ones for graphics stages.
    pub group_size: [u32; 3],
    /// Bytes of groupshared memory.
    pub shared_bytes: u32,
    /// The lowest tier whose limits it keeps.
    pub tier: Tier,
    /// Path of its source below `shaders/hlsl`.
    pub source: &'static str,
    /// SHA-256 over flattened source, defines, flags and compiler version, in hex.
    pub hash: &'static str,
}

impl Module {
    /// The same module with other SPIR-V, of the same entry point, bindings and group: a shader that was
    /// compiled anew while the program runs. It is kept until the program ends, as every module is; if
    /// nothing changed it is the module itself.
    pub fn with_spirv(&'static self, spirv: &[u8], shared_bytes: u32, tier: Tier) -> &'static Module {
        if *self.spirv.bytes() == *spirv {
            return self;
        }
        Box::leak(Box::new(Module { spirv: Spirv::Plain(spirv.to_vec().leak()), shared_bytes, tier, ..*self }))
    }
}

/// A resource bound to a slot of a module.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bound {
    /// The binding.
    pub info: BindingInfo,
    /// What is bound; `None` only for samplers.
    pub resource: Option<ResourceId>,
}

/// A variant needs a resource that was not given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BindingError {
    /// Module that needs it.
    pub module: &'static str,
    /// Field that is `None`.
    pub field: &'static str,
}

impl std::fmt::Display for BindingError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "kernel {} needs {}, which was not given", self.module, self.field)
    }
}

impl std::error::Error for BindingError {}

/// A compute kernel with its resources and its variant chosen.
pub trait Kernel {
    /// The stage's one name everywhere: snake_case of the kernel's (`count_cells`).
    const STAGE: &'static str;
    /// Threads of a group.
    const GROUP_SIZE: [u32; 3];
    /// The module of the chosen variant.
    fn module(&self) -> &'static Module;
    /// What is bound at each of that module's slots, in order of the slots.
    fn bindings(&self) -> Result<Vec<Bound>, BindingError>;
}

/// A vertex and a fragment stage with their resources and variant chosen. Slots are numbered over
/// the union of both stages' bindings.
pub trait Draw {
    /// The stage's one name everywhere: snake_case of the file's.
    const STAGE: &'static str;
    /// The vertex module of the chosen variant.
    fn vertex(&self) -> &'static Module;
    /// The fragment module of the chosen variant; `None` for a depth-only draw.
    fn fragment(&self) -> Option<&'static Module>;
    /// What is bound at each slot of the union, in order of the slots.
    fn bindings(&self) -> Result<Vec<Bound>, BindingError>;
}
