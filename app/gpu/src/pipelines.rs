//! Modules to pipelines: checked against tier and limits, built once a device, kept in a file.

use crate::cache::CacheFile;
pub use crate::cache::CacheStatus;
use crate::canary::{Canary, Skipped};
use crate::draw::{Blend, Cull, DepthTest, DrawState, Topology};
use crate::error::{GpuError, describe, tier_name};
use crate::guard::Guard;
use crate::layout;
use brooklet_kernels::{Module, Tier};
use std::borrow::Cow;
use std::collections::{BTreeSet, HashMap};
use std::path::Path;

/// Set 0's layout with its entries, which are also its identity.
pub(crate) type Entries = Vec<wgpu::BindGroupLayoutEntry>;

/// What a render pipeline is made of.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) struct DrawKey {
    pub vertex: usize,
    pub fragment: Option<usize>,
    pub entries: Entries,
    pub color: Vec<wgpu::TextureFormat>,
    pub depth: Option<wgpu::TextureFormat>,
    pub state: DrawState,
}

#[derive(Clone)]
struct Layout {
    group: wgpu::BindGroupLayout,
    pipeline: wgpu::PipelineLayout,
}

pub(crate) struct Pipelines {
    cache: Option<wgpu::PipelineCache>,
    file: Option<CacheFile>,
    status: CacheStatus,
    unsaved: bool,
    canary: Option<Canary>,
    /// Modules that are not built, and why.
    refused: Skipped,
    /// Those of them that ended an earlier program, or were built when it was killed.
    suspected: BTreeSet<String>,
    layouts: HashMap<Entries, Layout>,
    compute: HashMap<(usize, Entries), wgpu::ComputePipeline>,
    draws: HashMap<DrawKey, wgpu::RenderPipeline>,
    samplers: HashMap<&'static str, wgpu::Sampler>,
}

/// A module's identity: generated modules are statics.
pub(crate) fn identity(module: &'static Module) -> usize {
    std::ptr::from_ref(module) as usize
}

impl Pipelines {
    pub fn new(device: &wgpu::Device, adapter: &wgpu::AdapterInfo, folder: Option<&Path>, watches: bool) -> Self {
        let supported = device.features().contains(wgpu::Features::PIPELINE_CACHE);
        let file = folder.filter(|_| supported).and_then(|folder| CacheFile::new(folder, adapter));
        let (data, status) = match (&file, folder) {
            (Some(file), _) => file.load(),
            (None, Some(_)) => (None, CacheStatus::Unsupported),
            (None, None) => (None, CacheStatus::Off),
        };
        let cache = file.is_some().then(|| {
            // SAFETY: the data is none, or what `get_data` gave for this device, driver and
            // version: `CacheFile::load` checks its key and its hash.
            unsafe {
                device.create_pipeline_cache(&wgpu::PipelineCacheDescriptor {
                    label: Some("brooklet"),
                    data: data.as_deref(),
                    fallback: true,
                })
            }
        });
        let watched = file.as_ref().zip(folder).filter(|_| watches);
        let (canary, refused) = watched.and_then(|(file, folder)| file.canary(folder)).unzip();
        let refused = refused.unwrap_or_default();
        Self {
            canary,
            suspected: refused.keys().cloned().collect(),
            refused,
            cache,
            file,
            status,
            unsaved: false,
            layouts: HashMap::new(),
            compute: HashMap::new(),
            draws: HashMap::new(),
            samplers: HashMap::new(),
        }
    }

    pub fn cache_status(&self) -> CacheStatus {
        self.status.clone()
    }

    /// Builds `module` no more, and says why.
    pub fn refuse(&mut self, module: &str, reason: &str) {
        self.refused.insert(module.to_owned(), reason.to_owned());
        self.suspected.remove(module);
    }

    /// Builds `module` after all, if it is only suspected; whether it was.
    pub fn trust(&mut self, module: &str) -> bool {
        let was_suspected = self.suspected.remove(module);
        if was_suspected {
            self.refused.remove(module);
        }
        was_suspected
    }

    /// Modules that are not built, and why.
    pub fn refused(&self) -> &Skipped {
        &self.refused
    }

    fn check_refused(&self, module: &'static Module) -> Result<(), GpuError> {
        match self.refused.get(module.name) {
            Some(reason) => Err(GpuError::ModuleRefused { module: module.name, reason: reason.clone() }),
            None => Ok(()),
        }
    }

    /// Lets the driver build something out of `module`.
    fn build<T>(
        &mut self,
        gpu: &Guard,
        module: &'static Module,
        build: impl FnOnce(&mut Self) -> T,
    ) -> Result<T, GpuError> {
        if let Some(canary) = &self.canary {
            canary.building(module.name);
        }
        let built = gpu.scoped(|| build(self));
        let built = built_or_lost(gpu, module, built);
        match (&built, &self.canary) {
            (Ok(_), Some(canary)) => canary.built(),
            // A device that is gone with it is opened again: then it is known not to be tried.
            (Err(error), _) => self.refuse(module.name, &error.to_string()),
            (Ok(_), None) => {}
        }
        built
    }

    /// Writes what was compiled since the last time. A cache that cannot be written costs time at
    /// the next start and nothing else, so it is no error.
    pub fn save(&mut self) {
        if !self.unsaved {
            return;
        }
        self.unsaved = false;
        let data = self.cache.as_ref().and_then(wgpu::PipelineCache::get_data);
        if let (Some(file), Some(data)) = (&self.file, data) {
            let _ = file.save(&data);
        }
    }

    pub fn group_layout(&mut self, gpu: &Guard, entries: &Entries) -> wgpu::BindGroupLayout {
        self.layout(gpu, entries).group
    }

    fn layout(&mut self, gpu: &Guard, entries: &Entries) -> Layout {
        if let Some(layout) = self.layouts.get(entries) {
            return layout.clone();
        }
        let device = &gpu.device;
        let group = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: None, entries });
        let pipeline = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: None,
            bind_group_layouts: &[Some(&group)],
            immediate_size: 0,
        });
        let layout = Layout { group, pipeline };
        self.layouts.insert(entries.clone(), layout.clone());
        layout
    }

    pub fn sampler(&mut self, gpu: &Guard, name: &'static str) -> wgpu::Sampler {
        self.samplers.entry(name).or_insert_with(|| gpu.device.create_sampler(&layout::sampler(name))).clone()
    }

    pub fn compute(
        &mut self,
        gpu: &Guard,
        module: &'static Module,
        entries: &Entries,
    ) -> Result<wgpu::ComputePipeline, GpuError> {
        self.check_refused(module)?;
        let key = (identity(module), entries.clone());
        if let Some(pipeline) = self.compute.get(&key) {
            return Ok(pipeline.clone());
        }
        let pipeline = self.build(gpu, module, |this| {
            let layout = this.layout(gpu, entries);
            let shader = shader_module(&gpu.device, module);
            gpu.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                label: Some(module.name),
                layout: Some(&layout.pipeline),
                module: &shader,
                entry_point: Some(module.entry),
                compilation_options: Default::default(),
                cache: this.cache.as_ref(),
            })
        })?;
        self.unsaved = true;
        self.compute.insert(key, pipeline.clone());
        Ok(pipeline)
    }

    pub fn draw(
        &mut self,
        gpu: &Guard,
        key: DrawKey,
        vertex: &'static Module,
        fragment: Option<&'static Module>,
    ) -> Result<wgpu::RenderPipeline, GpuError> {
        self.check_refused(vertex)?;
        fragment.map_or(Ok(()), |module| self.check_refused(module))?;
        if let Some(pipeline) = self.draws.get(&key) {
            return Ok(pipeline.clone());
        }
        // A crash is the fragment stage's more often than not, and a draw can be done without as a whole.
        let blamed = fragment.unwrap_or(vertex);
        let pipeline = self.build(gpu, blamed, |this| {
            let device = &gpu.device;
            let layout = this.layout(gpu, &key.entries);
            let vertex_module = shader_module(device, vertex);
            let fragment_module = fragment.map(|module| (shader_module(device, module), module));
            let targets: Vec<_> = key.color.iter().map(|f| Some(color(*f, key.state))).collect();
            device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
                label: Some(vertex.name),
                layout: Some(&layout.pipeline),
                vertex: wgpu::VertexState {
                    module: &vertex_module,
                    entry_point: Some(vertex.entry),
                    compilation_options: Default::default(),
                    buffers: &[],
                },
                primitive: primitive(key.state),
                depth_stencil: key.depth.map(|format| depth(format, key.state)),
                multisample: wgpu::MultisampleState::default(),
                fragment: fragment_module.as_ref().map(|(shader, module)| wgpu::FragmentState {
                    module: shader,
                    entry_point: Some(module.entry),
                    compilation_options: Default::default(),
                    targets: &targets,
                }),
                multiview_mask: None,
                cache: this.cache.as_ref(),
            })
        })?;
        self.unsaved = true;
        self.draws.insert(key, pipeline.clone());
        Ok(pipeline)
    }
}

/// wgpu takes a driver that cannot compile a module for a lost device, and then reports no error
/// in the call: the kernel is to blame either way, since the device was there before.
fn built_or_lost<T>(gpu: &Guard, module: &'static Module, built: Result<T, wgpu::Error>) -> Result<T, GpuError> {
    let reason = match (gpu.is_lost(), built) {
        (None, Ok(pipeline)) => return Ok(pipeline),
        (Some(lost), _) => lost,
        (None, Err(error)) => describe(&error),
    };
    Err(GpuError::Pipeline { module: module.name, reason })
}

fn shader_module(device: &wgpu::Device, module: &'static Module) -> wgpu::ShaderModule {
    let words: Vec<u32> = bytemuck::pod_collect_to_vec(&module.spirv.bytes());
    let [x, y, z] = module.group_size;
    // SAFETY: the shader compiler validated the module and numbered its bindings as wgpu does;
    // `check_module` held it against the device's limits.
    unsafe {
        device.create_shader_module_passthrough(wgpu::ShaderModuleDescriptorPassthrough {
            label: Some(module.name),
            entry_points: Cow::Owned(vec![wgpu::PassthroughShaderEntryPoint {
                name: Cow::Borrowed(module.entry),
                workgroup_size: (x, y, z),
            }]),
            spirv: Some(Cow::Owned(words)),
            ..Default::default()
        })
    }
}

fn color(format: wgpu::TextureFormat, state: DrawState) -> wgpu::ColorTargetState {
    let additive = wgpu::BlendComponent {
        src_factor: wgpu::BlendFactor::One,
        dst_factor: wgpu::BlendFactor::One,
        operation: wgpu::BlendOperation::Add,
    };
    wgpu::ColorTargetState {
        format,
        blend: match state.blend {
            Blend::None => None,
            Blend::Alpha => Some(wgpu::BlendState::ALPHA_BLENDING),
            Blend::Additive => Some(wgpu::BlendState { color: additive, alpha: additive }),
        },
        write_mask: wgpu::ColorWrites::ALL,
    }
}

fn depth(format: wgpu::TextureFormat, state: DrawState) -> wgpu::DepthStencilState {
    wgpu::DepthStencilState {
        format,
        depth_write_enabled: Some(state.depth_write),
        depth_compare: Some(match state.depth_test {
            DepthTest::Off => wgpu::CompareFunction::Always,
            DepthTest::Less => wgpu::CompareFunction::Less,
            DepthTest::LessEqual => wgpu::CompareFunction::LessEqual,
            DepthTest::Greater => wgpu::CompareFunction::Greater,
            DepthTest::GreaterEqual => wgpu::CompareFunction::GreaterEqual,
        }),
        stencil: wgpu::StencilState::default(),
        bias: wgpu::DepthBiasState::default(),
    }
}

fn primitive(state: DrawState) -> wgpu::PrimitiveState {
    wgpu::PrimitiveState {
        topology: match state.topology {
            Topology::TriangleList => wgpu::PrimitiveTopology::TriangleList,
            Topology::TriangleStrip => wgpu::PrimitiveTopology::TriangleStrip,
            Topology::LineList => wgpu::PrimitiveTopology::LineList,
            Topology::LineStrip => wgpu::PrimitiveTopology::LineStrip,
            Topology::PointList => wgpu::PrimitiveTopology::PointList,
        },
        front_face: wgpu::FrontFace::Ccw,
        cull_mode: match state.cull {
            Cull::None => None,
            Cull::Front => Some(wgpu::Face::Front),
            Cull::Back => Some(wgpu::Face::Back),
        },
        ..Default::default()
    }
}

/// The first word of every module, little-endian.
const SPIRV_MAGIC: [u8; 4] = 0x0723_0203_u32.to_le_bytes();

/// Checks what wgpu cannot of a module that it does not read: its tier, group and groupshared
/// memory.
pub(crate) fn check_module(module: &Module, tier: Tier, limits: &wgpu::Limits) -> Result<(), GpuError> {
    // Drivers may crash on what is no SPIR-V at all.
    let spirv = module.spirv.bytes();
    if !spirv.starts_with(&SPIRV_MAGIC) || !spirv.len().is_multiple_of(4) {
        return Err(GpuError::Pipeline { module: module.name, reason: "it is no SPIR-V".into() });
    }
    if module.tier > tier {
        return Err(GpuError::ModuleAboveTier {
            module: module.name,
            needs: tier_name(module.tier),
            has: tier_name(tier),
        });
    }
    let threads: u64 = module.group_size.iter().map(|n| u64::from(*n)).product();
    let [x, y, z] = module.group_size.map(u64::from);
    let amounts = [
        ("threads a group", threads, limits.max_compute_invocations_per_workgroup),
        ("threads a group along x", x, limits.max_compute_workgroup_size_x),
        ("threads a group along y", y, limits.max_compute_workgroup_size_y),
        ("threads a group along z", z, limits.max_compute_workgroup_size_z),
        ("bytes of groupshared memory", u64::from(module.shared_bytes), limits.max_compute_workgroup_storage_size),
    ];
    for (what, needed, limit) in amounts {
        if needed > u64::from(limit) {
            return Err(GpuError::ModuleLimit { module: module.name, what, needed, limit: u64::from(limit) });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use brooklet_kernels::{Spirv, StageKind};

    const MODULE: Module = Module {
        name: "Sum",
        entry: "Sum",
        stage: StageKind::Compute,
        spirv: Spirv::Plain(&SPIRV_MAGIC),
        bindings: &[],
        group_size: [256, 1, 1],
        shared_bytes: 1024,
        tier: Tier::Floor,
        source: "",
        hash: "",
    };

    #[test]
    fn a_module_is_held_against_tier_and_limits() {
        let limits = wgpu::Limits::defaults();
        assert_eq!(check_module(&MODULE, Tier::Floor, &limits), Ok(()));
        let refused = |module: Module, words: &str| {
            let error = check_module(&module, Tier::Mobile, &limits).expect_err(words);
            assert!(error.to_string().contains(words), "{error}");
        };
        refused(Module { tier: Tier::Desktop, ..MODULE }, "made for the desktop tier");
        refused(Module { group_size: [16, 17, 1], ..MODULE }, "272 threads a group");
        refused(Module { group_size: [1, 1, 65], ..MODULE }, "65 threads a group along z");
        refused(Module { spirv: Spirv::Plain(&[0; 64]), ..MODULE }, "no SPIR-V");
        refused(Module { shared_bytes: 16_388, ..MODULE }, "16388 bytes of groupshared");
    }
}
