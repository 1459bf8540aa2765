//! Memory for what a plan keeps.

use crate::device::Gpu;
use crate::draw::texture_format;
use crate::error::{GpuError, describe};
use crate::plan::Plan;
use crate::plan_formats::check_formats;
use crate::pool::{BufferKind, TextureKind};
use crate::recording::{Command, Groups, Instances};
use crate::resources::Shape;
use crate::sharing::Sharing;
use brooklet_kernels::{BindingKind, Bound, Format, ResourceId};
use std::collections::BTreeMap;
use wgpu::{BufferUsages, TextureUsages};

/// An allocated resource.
pub(crate) enum Memory {
    Buffer { buffer: wgpu::Buffer, kind: BufferKind },
    Texture { texture: wgpu::Texture, view: wgpu::TextureView, kind: TextureKind },
}

impl Memory {
    pub fn bytes(&self) -> u64 {
        match self {
            Self::Buffer { kind, .. } => kind.bytes,
            Self::Texture { kind, .. } => kind.bytes(),
        }
    }
    pub fn buffer(&self) -> Option<&wgpu::Buffer> {
        match self {
            Self::Buffer { buffer, .. } => Some(buffer),
            Self::Texture { .. } => None,
        }
    }
    pub fn view(&self) -> Option<&wgpu::TextureView> {
        match self {
            Self::Texture { view, .. } => Some(view),
            Self::Buffer { .. } => None,
        }
    }
}

/// A plan's resources in memory. Goes back to the device's pool when dropped.
pub(crate) struct Arena {
    gpu: Gpu,
    items: BTreeMap<ResourceId, Memory>,
    sharing: Sharing,
}

/// What a resource is used as.
#[derive(Clone, Copy)]
pub(crate) struct Uses {
    buffer: BufferUsages,
    texture: TextureUsages,
}

impl Default for Uses {
    fn default() -> Self {
        Self { buffer: BufferUsages::empty(), texture: TextureUsages::empty() }
    }
}

impl Arena {
    /// Allocates what `plan` keeps, all zero; tells `progress` each one's name before.
    pub fn new(gpu: &Gpu, plan: &Plan, progress: &mut dyn FnMut(&str)) -> Result<Arena, GpuError> {
        let uses = check_sizes(gpu, plan)?;
        let mut arena = Arena { gpu: gpu.clone(), items: BTreeMap::new(), sharing: plan.sharing.clone() };
        let mut dirty = Vec::new();
        for kept in plan.buffers().into_iter().filter(|kept| kept.memory == kept.id) {
            progress(&kept.label);
            let mut uses = uses.get(&kept.id).copied().unwrap_or_default();
            if plan.wanted().contains(&kept.id) {
                // A host program may show it.
                uses.texture |= TextureUsages::TEXTURE_BINDING;
            }
            let allocated = match plan.resources().get(kept.id).map(|entry| entry.shape) {
                Some(Shape::Texture { format, size_px }) => arena.texture(&kept.label, format, size_px, uses.texture),
                _ => arena.buffer(&kept.label, kept.bytes, uses.buffer, &mut dirty),
            };
            arena.items.insert(kept.id, allocated?);
        }
        arena.zero(&dirty)?;
        Ok(arena)
    }

    fn buffer(
        &self,
        label: &str,
        bytes: u64,
        usage: BufferUsages,
        dirty: &mut Vec<wgpu::Buffer>,
    ) -> Result<Memory, GpuError> {
        let usage = usage | BufferUsages::STORAGE | BufferUsages::COPY_SRC | BufferUsages::COPY_DST;
        let kind = self.gpu.pool().buffer_kind(bytes, usage);
        let pooled = self.allocate(label, kind.bytes, || self.gpu.pool().buffer(self.gpu.device(), kind, label))?;
        if pooled.used {
            dirty.push(pooled.item.clone());
        }
        Ok(Memory::Buffer { buffer: pooled.item, kind })
    }

    fn texture(
        &self,
        label: &str,
        format: Format,
        size_px: [u32; 2],
        usage: TextureUsages,
    ) -> Result<Memory, GpuError> {
        // Drivers choose the layout of Depth24Plus, so it cannot be copied out.
        let copied = match format {
            Format::Depth24Plus => TextureUsages::empty(),
            _ => TextureUsages::COPY_SRC,
        };
        let usage = match usage | copied {
            usage if usage.is_empty() => TextureUsages::TEXTURE_BINDING,
            usage => usage,
        };
        let kind = TextureKind { size_px: size_px.map(|side| side.max(1)), format: texture_format(format), usage };
        let pooled = self.allocate(label, kind.bytes(), || self.gpu.pool().texture(self.gpu.device(), kind, label))?;
        let view = pooled.item.create_view(&wgpu::TextureViewDescriptor::default());
        Ok(Memory::Texture { texture: pooled.item, view, kind })
    }

    /// Allocates; if that fails, once more without what the pool holds.
    fn allocate<T>(&self, label: &str, bytes: u64, make: impl Fn() -> T) -> Result<T, GpuError> {
        let error = match self.gpu.scoped(&make) {
            Ok(made) => return self.gpu.check().map(|()| made),
            Err(error) => error,
        };
        self.gpu.check()?;
        if !matches!(error, wgpu::Error::OutOfMemory { .. }) {
            return Err(GpuError::Refused { reason: describe(&error) });
        }
        self.gpu.trim();
        self.gpu.scoped(make).map_err(|_| GpuError::OutOfMemory {
            label: label.to_owned(),
            bytes,
            allocated: self.allocated_bytes(),
        })
    }

    /// New memory is zero (wgpu sees to it), pooled memory is not.
    fn zero(&self, dirty: &[wgpu::Buffer]) -> Result<(), GpuError> {
        if dirty.is_empty() {
            return Ok(());
        }
        self.gpu.guarded(|| {
            let mut encoder = self.gpu.device().create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            for buffer in dirty {
                encoder.clear_buffer(buffer, 0, None);
            }
            self.gpu.queue().submit([encoder.finish()]);
        })
    }

    /// Whether another plan, made over the same resources, finds all that it keeps.
    pub fn serves(&self, plan: &Plan) -> Result<(), GpuError> {
        let uses = memory_uses(plan, &collect_uses(plan));
        for kept in plan.buffers() {
            if kept.memory != self.sharing.memory(kept.id) {
                return Err(GpuError::OtherMemory { label: kept.label, reason: "it shares other memory" });
            }
            let uses = uses.get(&kept.memory).copied().unwrap_or_default();
            let reason = match self.get(kept.id) {
                None => "the plan before left it out",
                Some(Memory::Buffer { kind, .. }) if kind.usage.contains(uses.buffer) => continue,
                Some(Memory::Texture { kind, .. }) if kind.usage.contains(uses.texture) => continue,
                Some(_) => "it is used in another way",
            };
            return Err(GpuError::OtherMemory { label: kept.label, reason });
        }
        Ok(())
    }

    pub fn get(&self, id: ResourceId) -> Option<&Memory> {
        self.items.get(&self.sharing.memory(id))
    }

    pub fn buffer_of(&self, id: ResourceId) -> Option<&wgpu::Buffer> {
        self.get(id).and_then(Memory::buffer)
    }

    pub fn allocated_bytes(&self) -> u64 {
        self.items.values().map(Memory::bytes).sum()
    }

    pub fn len(&self) -> usize {
        self.items.len()
    }
}

impl Drop for Arena {
    fn drop(&mut self) {
        if self.gpu.is_lost().is_some() {
            return;
        }
        let mut pool = self.gpu.pool();
        for memory in std::mem::take(&mut self.items).into_values() {
            match memory {
                Memory::Buffer { buffer, kind } => pool.give_buffer(kind, buffer),
                Memory::Texture { texture, kind, .. } => pool.give_texture(kind, texture),
            }
        }
    }
}

/// Checks that the device's limits and formats allow each resource that `plan` keeps; returns how each memory is used.
pub(crate) fn check_sizes(gpu: &Gpu, plan: &Plan) -> Result<BTreeMap<ResourceId, Uses>, GpuError> {
    check_formats(&gpu.info().name, plan, gpu.formats())?;
    let uses = collect_uses(plan);
    let limits = gpu.device().limits();
    for kept in plan.buffers() {
        check_size(plan, kept.id, uses.get(&kept.id).copied(), &limits)?;
    }
    Ok(memory_uses(plan, &uses))
}

fn collect_uses(plan: &Plan) -> BTreeMap<ResourceId, Uses> {
    let mut uses: BTreeMap<ResourceId, Uses> = BTreeMap::new();
    for command in plan.recordings.iter().flat_map(|recording| &recording.commands) {
        match command {
            Command::Dispatch(dispatch) => {
                add_bindings(&mut uses, &dispatch.bindings);
                if let Groups::Indirect(args) = dispatch.groups {
                    uses.entry(args.buffer).or_default().buffer |= BufferUsages::INDIRECT;
                }
            }
            Command::Draw(draw) => {
                add_bindings(&mut uses, &draw.bindings);
                if let Instances::Indirect(args) = draw.instances {
                    uses.entry(args.buffer).or_default().buffer |= BufferUsages::INDIRECT;
                }
                let color = draw.targets.color.iter().map(|(id, _)| *id);
                for id in color.chain(draw.targets.depth.map(|(id, _)| id)) {
                    uses.entry(id).or_default().texture |= TextureUsages::RENDER_ATTACHMENT;
                }
            }
            Command::Upload { .. } | Command::Clear { .. } | Command::Copy { .. } | Command::Forget { .. } => {}
        }
    }
    uses
}

/// How each memory is used: as all that have it are.
fn memory_uses(plan: &Plan, uses: &BTreeMap<ResourceId, Uses>) -> BTreeMap<ResourceId, Uses> {
    let mut of_memory: BTreeMap<ResourceId, Uses> = BTreeMap::new();
    for (id, uses) in uses {
        let all = of_memory.entry(plan.sharing.memory(*id)).or_default();
        all.buffer |= uses.buffer;
        all.texture |= uses.texture;
    }
    of_memory
}

fn add_bindings(uses: &mut BTreeMap<ResourceId, Uses>, bindings: &[Bound]) {
    for bound in bindings {
        let Some(id) = bound.resource else { continue };
        let uses = uses.entry(id).or_default();
        match bound.info.kind {
            BindingKind::Uniform { .. } => uses.buffer |= BufferUsages::UNIFORM,
            BindingKind::Storage { .. } => uses.buffer |= BufferUsages::STORAGE,
            BindingKind::Texture { .. } => uses.texture |= TextureUsages::TEXTURE_BINDING,
            BindingKind::StorageTexture { .. } => uses.texture |= TextureUsages::STORAGE_BINDING,
            BindingKind::Sampler => {}
        }
    }
}

fn check_size(plan: &Plan, id: ResourceId, uses: Option<Uses>, limits: &wgpu::Limits) -> Result<(), GpuError> {
    let label = plan.resources().label(id).to_owned();
    let uses = uses.unwrap_or_default();
    if let Some(Shape::Texture { size_px, .. }) = plan.resources().get(id).map(|r| r.shape) {
        let [width, height] = size_px;
        let limit = limits.max_texture_dimension_2d;
        if width.max(height) > limit {
            return Err(GpuError::TextureTooLarge { label, width, height, limit });
        }
        return Ok(());
    }
    let bytes = plan.resources().bytes(id);
    let bounds = [
        (
            uses.buffer.contains(BufferUsages::STORAGE),
            limits.max_storage_buffer_binding_size,
            "max_storage_buffer_binding_size",
        ),
        (
            uses.buffer.contains(BufferUsages::UNIFORM),
            limits.max_uniform_buffer_binding_size,
            "max_uniform_buffer_binding_size",
        ),
        (true, limits.max_buffer_size, "max_buffer_size"),
    ];
    for (applies, limit, limit_name) in bounds {
        if applies && bytes > limit {
            return Err(GpuError::BufferTooLarge { label, bytes, limit, limit_name });
        }
    }
    Ok(())
}
