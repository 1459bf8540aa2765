//! A plan's commands with their pipelines, bind groups and memory: ready to be encoded.

use crate::device::Gpu;
use crate::draw::{Load, texture_format};
use crate::error::{GpuError, describe};
use crate::layout;
use crate::memory::{Arena, Memory};
use crate::order::encoding_order;
use crate::pipelines::{DrawKey, Entries, check_module, identity};
use crate::plan::Plan;
use crate::planned::PlannedRecording;
use crate::recording::{Command, Dispatch, DrawCall, Groups, Instances, RecordingId};
use crate::resources::{Resources, Shape};
use brooklet_kernels::{BindingKind, Bound, Module, ResourceId};
use std::collections::{HashMap, HashSet};
use wgpu::ShaderStages;
use wgpu::util::DeviceExt;

/// A recording, ready to be encoded.
pub(crate) struct Ready {
    pub id: RecordingId,
    pub steps: Vec<Step>,
}

pub(crate) enum Step {
    Clear { buffer: wgpu::Buffer, bytes: u64 },
    Copy { from: wgpu::Buffer, to: wgpu::Buffer, bytes: u64 },
    Dispatch(DispatchStep),
    Draws(DrawsStep),
}

pub(crate) struct DispatchStep {
    pub stage: &'static str,
    pub pipeline: wgpu::ComputePipeline,
    pub bind_group: wgpu::BindGroup,
    pub groups: StepGroups,
}

pub(crate) enum StepGroups {
    Fixed([u32; 3]),
    Indirect { args: wgpu::Buffer, offset_bytes: u64 },
}

/// Draws that share a render pass.
pub(crate) struct DrawsStep {
    pub color: Vec<(wgpu::TextureView, wgpu::LoadOp<wgpu::Color>)>,
    pub depth: Option<(wgpu::TextureView, wgpu::LoadOp<f32>)>,
    pub draws: Vec<DrawStep>,
}

pub(crate) struct DrawStep {
    pub stage: &'static str,
    pub pipeline: wgpu::RenderPipeline,
    pub bind_group: wgpu::BindGroup,
    pub vertices: u32,
    pub instances: StepInstances,
}

pub(crate) enum StepInstances {
    Fixed(u32),
    Indirect { args: wgpu::Buffer, offset_bytes: u64 },
}

/// What preparing a plan allocated besides its resources.
#[derive(Clone, Copy, Default)]
pub(crate) struct Staging {
    pub bytes: u64,
    pub count: u64,
}

/// What a pipeline is told apart by before it is built: its modules.
type Modules = (usize, Option<usize>);

fn modules(command: &Command) -> Option<Modules> {
    match command {
        Command::Dispatch(dispatch) => Some((identity(dispatch.module), None)),
        Command::Draw(draw) => Some((identity(draw.vertex), draw.fragment.map(identity))),
        Command::Upload { .. } | Command::Clear { .. } | Command::Copy { .. } | Command::Forget { .. } => None,
    }
}

/// How many pipelines `plan` has, as [`prepare`] counts them.
pub(crate) fn pipeline_count(plan: &Plan) -> usize {
    let commands = plan.recordings.iter().flat_map(|recording| &recording.commands);
    commands.filter_map(modules).collect::<HashSet<_>>().len()
}

/// Builds every pipeline and bind group of `plan`; tells `progress` after each pipeline how many
/// there are, of how many, and the new one's name.
pub(crate) fn prepare(
    gpu: &Gpu,
    plan: &Plan,
    arena: &Arena,
    progress: &mut dyn FnMut(usize, usize, &str),
) -> Result<(Vec<Ready>, Staging), GpuError> {
    let mut preparer = Preparer {
        gpu,
        resources: plan.resources(),
        arena,
        bind_groups: HashMap::new(),
        staging: Staging::default(),
        built: HashSet::new(),
        total: pipeline_count(plan),
        progress,
    };
    let mut ready = Vec::new();
    for recording in &plan.recordings {
        ready.push(preparer.recording(recording)?);
    }
    gpu.pipelines().save();
    Ok((ready, preparer.staging))
}

type GroupKey = (Entries, Vec<(u32, Option<ResourceId>, &'static str)>);

struct Preparer<'a> {
    gpu: &'a Gpu,
    resources: &'a Resources,
    arena: &'a Arena,
    /// Iterations bind the same again and again; they share a bind group.
    bind_groups: HashMap<GroupKey, wgpu::BindGroup>,
    staging: Staging,
    built: HashSet<Modules>,
    total: usize,
    progress: &'a mut dyn FnMut(usize, usize, &str),
}

impl Preparer<'_> {
    fn recording(&mut self, recording: &PlannedRecording) -> Result<Ready, GpuError> {
        let mut steps: Vec<Step> = Vec::new();
        let mut open: Option<&DrawCall> = None;
        for command in encoding_order(&recording.commands) {
            if matches!(command, Command::Forget { .. }) {
                continue;
            }
            let Command::Draw(draw) = command else {
                open = None;
                let step = self.step(command)?;
                steps.push(step);
                continue;
            };
            let shared =
                open.is_some_and(|first| first.targets.continued_by(&draw.targets) && !self.writes_storage(draw));
            match steps.last_mut() {
                Some(Step::Draws(pass)) if shared => pass.draws.push(self.draw(draw)?),
                _ => {
                    open = Some(draw);
                    steps.push(Step::Draws(DrawsStep {
                        color: draw
                            .targets
                            .color
                            .iter()
                            .map(|(id, load)| Ok((self.view(*id)?, color_load(*load))))
                            .collect::<Result<_, GpuError>>()?,
                        depth: match draw.targets.depth {
                            Some((id, load)) => Some((self.view(id)?, depth_load(load))),
                            None => None,
                        },
                        draws: vec![self.draw(draw)?],
                    }));
                }
            }
        }
        Ok(Ready { id: recording.id, steps })
    }

    /// Whether a draw writes storage, which an earlier draw of the same pass may not see.
    fn writes_storage(&self, draw: &DrawCall) -> bool {
        draw.bindings.iter().any(|bound| {
            matches!(
                bound.info.kind,
                BindingKind::Storage { access: brooklet_kernels::Access::ReadWrite, .. }
                    | BindingKind::StorageTexture { .. }
            )
        })
    }

    fn step(&mut self, command: &Command) -> Result<Step, GpuError> {
        match command {
            Command::Upload { to, data } => {
                let to = self.buffer(*to)?;
                let bytes = data.len() as u64;
                let from = self
                    .gpu
                    .scoped(|| {
                        self.gpu.device().create_buffer_init(&wgpu::util::BufferInitDescriptor {
                            label: Some("upload"),
                            contents: data,
                            usage: wgpu::BufferUsages::COPY_SRC,
                        })
                    })
                    .map_err(|_| GpuError::OutOfMemory {
                        label: "upload".into(),
                        bytes,
                        allocated: self.arena.allocated_bytes() + self.staging.bytes,
                    })?;
                self.staging.bytes += bytes;
                self.staging.count += 1;
                Ok(Step::Copy { from, to, bytes })
            }
            // No more than its content: its memory may be much larger.
            Command::Clear { to } => Ok(Step::Clear {
                buffer: self.buffer(*to)?,
                bytes: self.resources.bytes(*to).next_multiple_of(wgpu::COPY_BUFFER_ALIGNMENT),
            }),
            Command::Copy { from, to, bytes } => {
                Ok(Step::Copy { from: self.buffer(*from)?, to: self.buffer(*to)?, bytes: *bytes })
            }
            Command::Dispatch(dispatch) => self.dispatch(dispatch).map(Step::Dispatch),
            Command::Draw(_) | Command::Forget { .. } => {
                Err(GpuError::Refused { reason: "what is no step of its own was to be one".into() })
            }
        }
    }

    fn report(&mut self, modules: Modules, name: &str) {
        if self.built.insert(modules) {
            (self.progress)(self.built.len(), self.total, name);
        }
    }

    fn dispatch(&mut self, dispatch: &Dispatch) -> Result<DispatchStep, GpuError> {
        let module = dispatch.module;
        check_module(module, self.gpu.tier(), &self.gpu.device().limits())?;
        let entries = layout::entries(&[(module, ShaderStages::COMPUTE)], &dispatch.bindings, self.resources);
        let pipeline = self.gpu.pipelines().compute(self.gpu.guard(), module, &entries)?;
        self.report((identity(module), None), module.name);
        let bind_group = self.bind_group(module, &entries, &dispatch.bindings)?;
        Ok(DispatchStep {
            stage: dispatch.stage,
            pipeline,
            bind_group,
            groups: match dispatch.groups {
                Groups::Fixed(groups) => StepGroups::Fixed(groups),
                Groups::Indirect(args) => {
                    StepGroups::Indirect { args: self.buffer(args.buffer)?, offset_bytes: args.offset_bytes.into() }
                }
            },
        })
    }

    fn draw(&mut self, draw: &DrawCall) -> Result<DrawStep, GpuError> {
        let limits = self.gpu.device().limits();
        let mut modules = vec![(draw.vertex, ShaderStages::VERTEX)];
        modules.extend(draw.fragment.map(|module| (module, ShaderStages::FRAGMENT)));
        for (module, _) in &modules {
            check_module(module, self.gpu.tier(), &limits)?;
        }
        let entries = {
            let modules: Vec<(&Module, ShaderStages)> =
                modules.iter().map(|(module, stage)| (*module, *stage)).collect();
            layout::entries(&modules, &draw.bindings, self.resources)
        };
        let color = draw.targets.color.iter().map(|(id, _)| self.format(*id));
        let key = DrawKey {
            vertex: identity(draw.vertex),
            fragment: draw.fragment.map(identity),
            entries: entries.clone(),
            color: color.collect::<Result<_, _>>()?,
            depth: match draw.targets.depth {
                Some((id, _)) => Some(self.format(id)?),
                None => None,
            },
            state: draw.state,
        };
        let pipeline = self.gpu.pipelines().draw(self.gpu.guard(), key, draw.vertex, draw.fragment)?;
        self.report((identity(draw.vertex), draw.fragment.map(identity)), draw.vertex.name);
        let bind_group = self.bind_group(draw.vertex, &entries, &draw.bindings)?;
        let instances = match draw.instances {
            Instances::Fixed(count) => StepInstances::Fixed(count),
            Instances::Indirect(args) => {
                StepInstances::Indirect { args: self.buffer(args.buffer)?, offset_bytes: args.offset_bytes.into() }
            }
        };
        Ok(DrawStep { stage: draw.stage, pipeline, bind_group, vertices: draw.vertices, instances })
    }

    fn bind_group(
        &mut self,
        module: &'static Module,
        entries: &Entries,
        bindings: &[Bound],
    ) -> Result<wgpu::BindGroup, GpuError> {
        let bound = bindings.iter().map(|bound| (bound.info.slot, bound.resource, bound.info.name)).collect();
        let key = (entries.clone(), bound);
        if let Some(group) = self.bind_groups.get(&key) {
            return Ok(group.clone());
        }
        let mut samplers = Vec::new();
        for bound in bindings {
            if bound.info.kind == BindingKind::Sampler {
                let sampler = self.gpu.pipelines().sampler(self.gpu.guard(), bound.info.name);
                samplers.push((bound.info.slot, sampler));
            }
        }
        let mut group_entries = Vec::new();
        for bound in bindings {
            let slot = bound.info.slot;
            let sampler = samplers.iter().find(|(of, _)| *of == slot);
            let resource = match (sampler, bound.resource.and_then(|id| self.arena.get(id))) {
                (Some((_, sampler)), _) => wgpu::BindingResource::Sampler(sampler),
                (None, Some(Memory::Texture { view, .. })) => wgpu::BindingResource::TextureView(view),
                (None, Some(Memory::Buffer { buffer, .. })) => wgpu::BindingResource::Buffer(wgpu::BufferBinding {
                    buffer,
                    offset: 0,
                    size: wgpu::BufferSize::new(self.bound_bytes(bound)),
                }),
                (None, None) => return Err(missing(bound.info.name)),
            };
            group_entries.push(wgpu::BindGroupEntry { binding: slot, resource });
        }
        let group_layout = self.gpu.pipelines().group_layout(self.gpu.guard(), entries);
        let group = self
            .gpu
            .scoped(|| {
                self.gpu.device().create_bind_group(&wgpu::BindGroupDescriptor {
                    label: Some(module.name),
                    layout: &group_layout,
                    entries: &group_entries,
                })
            })
            .map_err(|error| GpuError::Refused { reason: format!("{}: {}", module.name, describe(&error)) })?;
        self.gpu.check()?;
        self.bind_groups.insert(key, group.clone());
        Ok(group)
    }

    /// Exactly the content's size, since kernels ask a buffer for its length; an empty buffer
    /// binds one element, as nothing cannot be bound.
    fn bound_bytes(&self, bound: &Bound) -> u64 {
        let bytes = bound.resource.map_or(0, |id| self.resources.bytes(id));
        let least = match bound.info.kind {
            BindingKind::Storage { stride_bytes, .. } => u64::from(stride_bytes),
            BindingKind::Uniform { bytes } => u64::from(bytes),
            _ => 0,
        };
        let bytes = if bytes == 0 { least } else { bytes };
        bytes.max(4).next_multiple_of(4)
    }

    fn buffer(&self, id: ResourceId) -> Result<wgpu::Buffer, GpuError> {
        self.arena.buffer_of(id).cloned().ok_or_else(|| missing(self.resources.label(id)))
    }

    fn view(&self, id: ResourceId) -> Result<wgpu::TextureView, GpuError> {
        self.arena.get(id).and_then(Memory::view).cloned().ok_or_else(|| missing(self.resources.label(id)))
    }

    fn format(&self, id: ResourceId) -> Result<wgpu::TextureFormat, GpuError> {
        match self.resources.get(id).map(|entry| entry.shape) {
            Some(Shape::Texture { format, .. }) => Ok(texture_format(format)),
            _ => Err(missing(self.resources.label(id))),
        }
    }
}

fn missing(label: &str) -> GpuError {
    GpuError::Refused { reason: format!("{label} is used, and has no memory of its kind") }
}

fn color_load(load: Load<[f64; 4]>) -> wgpu::LoadOp<wgpu::Color> {
    match load {
        Load::Clear([r, g, b, a]) => wgpu::LoadOp::Clear(wgpu::Color { r, g, b, a }),
        Load::Keep => wgpu::LoadOp::Load,
    }
}

fn depth_load(load: Load<f32>) -> wgpu::LoadOp<f32> {
    match load {
        Load::Clear(depth) => wgpu::LoadOp::Clear(depth),
        Load::Keep => wgpu::LoadOp::Load,
    }
}
