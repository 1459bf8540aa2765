//! Kernels small enough to know what they must do. They are written in WGSL and compiled by naga,
//! which wgpu brings along: the engine takes any SPIR-V, and its tests must not depend on what
//! the fluid's kernels happen to be.
use brooklet_gpu::{Engine, Gpu, GpuOptions, RecordingId, Tier};
use brooklet_kernels::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Draw, Kernel, Module, ResourceId, Spirv,
    StageKind, Tex, Uniform,
};
use naga::back::spv;
use naga::valid::{Capabilities, ValidationFlags, Validator};
use std::sync::OnceLock;

/// Options with timing, as most tests want them.
pub fn options() -> GpuOptions {
    brooklet_tests::validation::listen();
    GpuOptions { timing: true, ..GpuOptions::default() }
}

/// The default device.
pub fn gpu() -> Gpu {
    Gpu::open(&options()).expect("a Vulkan device")
}

/// The first recording of an engine's plan.
pub fn only(engine: &Engine) -> RecordingId {
    engine.plan().recordings().next().expect("a recording")
}

/// SPIR-V of a WGSL module.
pub fn spirv(source: &str) -> &'static [u8] {
    let module = naga::front::wgsl::parse_str(source).expect("WGSL parses");
    let info =
        Validator::new(ValidationFlags::all(), Capabilities::default()).validate(&module).expect("WGSL is valid");
    let mut options = spv::Options { lang_version: (1, 0), ..Default::default() };
    // As DXC does it: no flipped y, no bounds checks.
    options.flags.remove(spv::WriterFlags::ADJUST_COORDINATE_SPACE);
    let words = spv::write_vec(&module, &info, &options, None).expect("SPIR-V");
    bytemuck::cast_slice(words.leak())
}

/// A storage binding of `u32`s.
pub fn words(name: &'static str, slot: u32, access: Access) -> BindingInfo {
    BindingInfo { name, slot, kind: BindingKind::Storage { access, stride_bytes: 4 } }
}

/// A floor-tier compute module with groups of 64.
pub fn compute(name: &'static str, source: &str, bindings: Vec<BindingInfo>) -> Module {
    Module {
        name,
        entry: "main",
        stage: StageKind::Compute,
        spirv: Spirv::Plain(spirv(source)),
        bindings: bindings.leak(),
        group_size: [64, 1, 1],
        shared_bytes: 0,
        tier: Tier::Floor,
        source: "",
        hash: "",
    }
}

/// A kernel's module, made once.
macro_rules! module_once {
    ($make:expr) => {{
        static MODULE: OnceLock<Module> = OnceLock::new();
        MODULE.get_or_init(|| $make)
    }};
}

fn bound(info: BindingInfo, resource: ResourceId) -> Bound {
    Bound { info, resource: Some(resource) }
}

/// `to[i] = factor * from[i] + 1`, over the length of `to`.
pub struct Scale<'a> {
    pub from: Buf<'a, u32>,
    pub to: BufMut<'a, u32>,
    pub factor: Uniform<'a, [u32; 4]>,
}

impl Kernel for Scale<'_> {
    const STAGE: &'static str = "scale";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];
    fn module(&self) -> &'static Module {
        module_once!(compute(
            "Scale",
            "@group(0) @binding(0) var<storage, read> source: array<u32>;
             @group(0) @binding(1) var<storage, read_write> target_: array<u32>;
             @group(0) @binding(2) var<uniform> factor: vec4<u32>;
             @compute @workgroup_size(64)
             fn main(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) thread: u32) {
                 let i = (group.y * 32768u + group.x) * 64u + thread;
                 if (i < arrayLength(&target_)) { target_[i] = factor.x * source[i] + 1u; }
             }",
            vec![
                words("source", 0, Access::Read),
                words("target_", 1, Access::ReadWrite),
                BindingInfo { name: "factor", slot: 2, kind: BindingKind::Uniform { bytes: 16 } },
            ],
        ))
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        let infos = self.module().bindings;
        Ok(vec![bound(infos[0], self.from.id), bound(infos[1], self.to.id), bound(infos[2], self.factor.id)])
    }
}

/// `values[i] += 1`, over its length; `STAGE` is `increment`.
pub struct Increment<'a> {
    pub values: BufMut<'a, u32>,
}

impl Kernel for Increment<'_> {
    const STAGE: &'static str = "increment";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];
    fn module(&self) -> &'static Module {
        module_once!(compute(
            "Increment",
            "@group(0) @binding(0) var<storage, read_write> values: array<u32>;
             @compute @workgroup_size(64)
             fn main(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) thread: u32) {
                 let i = (group.y * 32768u + group.x) * 64u + thread;
                 if (i < arrayLength(&values)) { values[i] = values[i] + 1u; }
             }",
            vec![words("values", 0, Access::ReadWrite)],
        ))
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        Ok(vec![bound(self.module().bindings[0], self.values.id)])
    }
}

/// Writes the length of `values`, and then as many groups as `wanted` says, to `args`.
pub struct Arguments<'a> {
    pub wanted: Buf<'a, u32>,
    pub args: BufMut<'a, [u32; 3]>,
}

impl Kernel for Arguments<'_> {
    const STAGE: &'static str = "arguments";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];
    fn module(&self) -> &'static Module {
        module_once!(compute(
            "Arguments",
            "@group(0) @binding(0) var<storage, read> wanted: array<u32>;
             @group(0) @binding(1) var<storage, read_write> args: array<u32>;
             @compute @workgroup_size(64)
             fn main(@builtin(local_invocation_index) thread: u32) {
                 if (thread < 3u) { args[thread] = select(1u, wanted[0], thread == 0u); }
             }",
            vec![words("wanted", 0, Access::Read), words("args", 1, Access::ReadWrite),],
        ))
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        let infos = self.module().bindings;
        Ok(vec![bound(infos[0], self.wanted.id), bound(infos[1], self.args.id)])
    }
}

/// Any module, bound to one buffer: for modules that must be refused.
pub struct Any<'a> {
    pub module: &'static Module,
    pub values: BufMut<'a, u32>,
}

impl Kernel for Any<'_> {
    const STAGE: &'static str = "any";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];
    fn module(&self) -> &'static Module {
        self.module
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        Ok(vec![bound(self.module.bindings[0], self.values.id)])
    }
}

fn stage(
    name: &'static str,
    kind: StageKind,
    entry: &'static str,
    spirv: &'static [u8],
    bindings: Vec<BindingInfo>,
) -> Module {
    Module {
        name,
        entry,
        stage: kind,
        spirv: Spirv::Plain(spirv),
        bindings: bindings.leak(),
        group_size: [1, 1, 1],
        shared_bytes: 0,
        tier: Tier::Floor,
        source: "",
        hash: "",
    }
}

/// A triangle over the lower left half of the target, at depth 0.5, in a colour from a buffer.
pub struct DrawHalf<'a> {
    pub color: Uniform<'a, [f32; 4]>,
}

impl Draw for DrawHalf<'_> {
    const STAGE: &'static str = "draw_half";
    fn vertex(&self) -> &'static Module {
        module_once!(stage(
            "HalfVertex",
            StageKind::Vertex,
            "main",
            spirv(
                "@vertex fn main(@builtin(vertex_index) i: u32) -> @builtin(position) vec4<f32> {
                     // Vulkan's y points down: (-1, 1) is the lower left corner.
                     var corners = array<vec2<f32>, 3>(vec2(-1.0, -1.0), vec2(-1.0, 1.0), vec2(1.0, 1.0));
                     return vec4(corners[i], 0.5, 1.0);
                 }",
            ),
            Vec::new(),
        ))
    }
    fn fragment(&self) -> Option<&'static Module> {
        Some(module_once!(stage(
            "HalfFragment",
            StageKind::Fragment,
            "main",
            spirv(
                "@group(0) @binding(0) var<uniform> color: vec4<f32>;
                 @fragment fn main() -> @location(0) vec4<f32> { return color; }",
            ),
            vec![BindingInfo { name: "color", slot: 0, kind: BindingKind::Uniform { bytes: 16 } }],
        )))
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        let info = self.fragment().map(|module| module.bindings[0]);
        Ok(info.into_iter().map(|info| bound(info, self.color.id)).collect())
    }
}

/// Copies a picture, sampled in the middle of each pixel, with red and blue swapped.
pub struct DrawSwapped<'a> {
    pub picture: Tex<'a>,
}

impl Draw for DrawSwapped<'_> {
    const STAGE: &'static str = "draw_swapped";
    fn vertex(&self) -> &'static Module {
        module_once!(stage(
            "SwappedVertex",
            StageKind::Vertex,
            "main",
            spirv(
                "@vertex fn main(@builtin(vertex_index) i: u32) -> @builtin(position) vec4<f32> {
                     let corner = vec2(f32(i & 1u), f32(i >> 1u));
                     return vec4(4.0 * corner - 1.0, 0.5, 1.0);
                 }",
            ),
            Vec::new(),
        ))
    }
    fn fragment(&self) -> Option<&'static Module> {
        Some(module_once!(stage(
            "SwappedFragment",
            StageKind::Fragment,
            "main",
            spirv(
                "@group(0) @binding(0) var picture: texture_2d<f32>;
                 @group(0) @binding(1) var sampler_point_clamp: sampler;
                 @fragment fn main(@builtin(position) at: vec4<f32>) -> @location(0) vec4<f32> {
                     let size = vec2<f32>(textureDimensions(picture));
                     return textureSample(picture, sampler_point_clamp, at.xy / size).bgra;
                 }",
            ),
            vec![
                BindingInfo { name: "picture", slot: 0, kind: BindingKind::Texture { filterable: true } },
                BindingInfo { name: "sampler_point_clamp", slot: 1, kind: BindingKind::Sampler },
            ],
        )))
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        let infos = self.fragment().map_or(&[][..], |module| module.bindings);
        Ok(vec![bound(infos[0], self.picture.id), Bound { info: infos[1], resource: None }])
    }
}
