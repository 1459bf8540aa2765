//! Runs a plan's recordings.

use crate::device::Gpu;
use crate::encode::{Encoder, tick_bound};
use crate::error::GpuError;
use crate::memory::{Arena, Memory, check_sizes};
use crate::plan::Plan;
use crate::readback::{Grown, Slot};
use crate::resources::{Shape, bytes_per_pixel};
use crate::steps::{Ready, Staging, prepare};
use crate::timing::FrameReport;
use brooklet_kernels::{Buffer, Format, ResourceId, Texture};
use bytemuck::Pod;
use std::collections::VecDeque;
use std::time::Instant;

/// Frames that may be in flight before `run` waits for the oldest.
pub const FRAMES_IN_FLIGHT: usize = 4;

/// A plan with its memory, pipelines and results. Its memory goes back to the device's pool when
/// it is dropped.
pub struct Engine {
    gpu: Gpu,
    plan: Plan,
    arena: Arena,
    ready: Vec<Ready>,
    staging: Staging,
    ring: Vec<Slot>,
    /// Places of the ring in flight, oldest first.
    in_flight: VecDeque<usize>,
    reports: VecDeque<FrameReport>,
    started: Instant,
    frames: u64,
    pending_error: Option<GpuError>,
    dispatches: u64,
    timestamps: u64,
    ring_allocations: u64,
}

impl Engine {
    /// Allocates what `plan` keeps, all zero, and builds its pipelines.
    ///
    /// # Errors
    /// If a buffer exceeds a limit or the memory, naming it; if a module is above the device's
    /// tier or the driver cannot compile it, naming kernel and variant.
    pub fn new(gpu: &Gpu, plan: Plan) -> Result<Engine, GpuError> {
        gpu.check()?;
        let arena = Arena::new(gpu, &plan)?;
        let (ready, staging) = prepare(gpu, &plan, &arena)?;
        Ok(Engine {
            gpu: gpu.clone(),
            plan,
            arena,
            ready,
            staging,
            ring: (0..FRAMES_IN_FLIGHT).map(|_| Slot::new()).collect(),
            in_flight: VecDeque::with_capacity(FRAMES_IN_FLIGHT),
            reports: VecDeque::new(),
            started: Instant::now(),
            frames: 0,
            pending_error: None,
            dispatches: 0,
            timestamps: 0,
            ring_allocations: 0,
        })
    }

    /// Whether the device's limits allow what `plan` keeps, without allocating it.
    ///
    /// # Errors
    /// If a buffer or texture exceeds a limit, naming both.
    pub fn check_sizes(gpu: &Gpu, plan: &Plan) -> Result<(), GpuError> {
        check_sizes(gpu, plan).map(|_| ())
    }

    /// The device.
    pub fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    /// The plan.
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// Hands `recordings` to the GPU as one frame, in order (a name may come more than once), and
    /// asks for the content that `readbacks` have at its end. Waits for no result, unless
    /// [`FRAMES_IN_FLIGHT`] frames are under way: then for the oldest. Returns the frame's number;
    /// its [`FrameReport`] comes with [`Engine::reports`], which keeps each one until then.
    ///
    /// # Errors
    /// If the device is lost, a name is unknown, or a readback is not in the plan.
    pub fn run(&mut self, recordings: &[&str], readbacks: &[ResourceId]) -> Result<u64, GpuError> {
        if let Some(error) = self.pending_error.take() {
            return Err(error);
        }
        let order = recordings.iter().map(|name| self.find(name)).collect::<Result<Vec<usize>, _>>()?;
        let wanted =
            readbacks.iter().map(|id| Ok((*id, self.readable_bytes(*id)?))).collect::<Result<Vec<_>, GpuError>>()?;

        self.gpu.poll(None)?;
        self.collect()?;
        let place = self.free_place()?;

        let timing = self.gpu.timing();
        let bound = if timing.is_measured() {
            let steps = order.iter().map(|index| &self.ready[*index]);
            steps.map(|ready| tick_bound(&ready.steps)).sum()
        } else {
            0
        };
        let slot = &mut self.ring[place];
        let Grown { count, .. } = slot.prepare(&self.gpu, bound, &wanted)?;
        self.ring_allocations += count;

        let arena = &self.arena;
        let ready = &self.ready;
        let gpu = &self.gpu;
        let (submission, dispatches) = gpu.guarded(|| {
            let mut encoder = Encoder::new(gpu, &mut slot.ticks);
            for index in order {
                encoder.recording(&ready[index]);
            }
            let (mut commands, dispatches) = encoder.finish();
            slot.encode(&mut commands, |id| arena.buffer_of(id));
            (gpu.queue().submit([commands.finish()]), dispatches)
        })?;
        slot.frame = self.frames;
        slot.wall_ns = self.started.elapsed().as_nanos() as u64;
        slot.submission = Some(submission);
        gpu.guarded(|| slot.request(gpu))?;
        self.timestamps += slot.ticks.written();
        self.dispatches += dispatches;
        self.in_flight.push_back(place);
        self.frames += 1;
        Ok(self.frames - 1)
    }

    fn find(&self, name: &str) -> Result<usize, GpuError> {
        self.ready.iter().position(|ready| ready.name == name).ok_or_else(|| GpuError::NoSuchRecording {
            name: name.to_owned(),
            present: self.ready.iter().map(|ready| ready.name).collect(),
        })
    }

    fn readable_bytes(&self, id: ResourceId) -> Result<u64, GpuError> {
        let refuse = |reason| Err(GpuError::NotReadable { label: self.plan.resources().label(id).to_owned(), reason });
        match self.arena.get(id) {
            Some(Memory::Buffer { .. }) => Ok(self.plan.resources().bytes(id)),
            Some(Memory::Texture { .. }) => refuse("it is a texture; use read_texture"),
            // Nothing is all there, without memory.
            None if self.plan.resources().get(id).is_some_and(|r| r.bytes() == 0) => Ok(0),
            None => refuse("the plan left it out; name it among the wanted outputs"),
        }
    }

    /// The frame's place of the ring, waiting for the frame that had it before. Places take turns
    /// whether or not an earlier one is free already: after [`FRAMES_IN_FLIGHT`] frames each has
    /// its memory, however fast the device is.
    fn free_place(&mut self) -> Result<usize, GpuError> {
        if self.in_flight.len() == self.ring.len() {
            self.wait_for_oldest()?;
        }
        Ok(self.frames as usize % self.ring.len())
    }

    fn wait_for_oldest(&mut self) -> Result<(), GpuError> {
        let Some(oldest) = self.in_flight.front() else {
            return Ok(());
        };
        self.gpu.poll(self.ring[*oldest].submission.clone())?;
        // The callback may run a moment after the wait, on another thread that polls.
        while !self.ring[*oldest].has_arrived()? {
            std::thread::yield_now();
            self.gpu.poll(None)?;
        }
        self.collect()
    }

    /// Takes the results of finished frames, in order.
    fn collect(&mut self) -> Result<(), GpuError> {
        while let Some(place) = self.in_flight.front() {
            let slot = &mut self.ring[*place];
            if !slot.has_arrived().map_err(|error| self.gpu.cause_of(error))? {
                break;
            }
            let period_ns = self.gpu.info().timestamp_period_ns;
            let report = slot.report(self.gpu.timing(), period_ns);
            self.reports.push_back(report.map_err(|error| self.gpu.cause_of(error))?);
            self.in_flight.pop_front();
        }
        Ok(())
    }

    /// Writes `data` to the start of `to` before the next run. A buffer that the plan left out is
    /// not written: nothing reads it. Too much data is an error of the next run.
    pub fn write<T: Pod>(&mut self, to: &Buffer<T>, data: &[T]) {
        if data.len() > to.len as usize {
            self.pending_error.get_or_insert(GpuError::WriteTooLong {
                label: self.plan.resources().label(to.id).to_owned(),
                elements: data.len(),
                room: to.len,
            });
        } else if let Some(buffer) = self.arena.buffer_of(to.id).filter(|_| !data.is_empty()) {
            let queue = self.gpu.queue();
            let written = self.gpu.guarded(|| queue.write_buffer(buffer, 0, bytemuck::cast_slice(data)));
            if let Err(error) = written {
                self.pending_error.get_or_insert(error);
            }
        }
    }

    /// Waits for all that was run, and reads a buffer. For tests and final outputs.
    ///
    /// # Errors
    /// If the plan left it out, or the device is lost.
    pub fn read<T: Pod>(&mut self, from: &Buffer<T>) -> Result<Vec<T>, GpuError> {
        let bytes = self.readable_bytes(from.id)?;
        let Some(buffer) = self.arena.buffer_of(from.id).filter(|_| bytes > 0) else {
            return Ok(Vec::new());
        };
        let size = bytes.next_multiple_of(4);
        let mut host = self.download(size, |encoder, host| {
            encoder.copy_buffer_to_buffer(buffer, 0, host, 0, size);
        })?;
        host.truncate(bytes as usize);
        Ok(bytemuck::pod_collect_to_vec(&host))
    }

    /// Waits for all that was run, and reads a texture: rows from the top, without padding.
    ///
    /// # Errors
    /// If the plan left it out, its format cannot be copied, or the device is lost.
    pub fn read_texture(&mut self, from: &Texture) -> Result<Vec<u8>, GpuError> {
        let resources = self.plan.resources();
        let refuse = |reason| Err(GpuError::NotReadable { label: resources.label(from.id).to_owned(), reason });
        let shape = resources.get(from.id).map(|entry| entry.shape);
        let (Some(Memory::Texture { texture, .. }), Some(Shape::Texture { format, size_px })) =
            (self.arena.get(from.id), shape)
        else {
            return refuse("the plan left it out; name it among the wanted outputs");
        };
        if format == Format::Depth24Plus {
            return refuse("drivers choose the layout of Depth24Plus; use Depth32Float");
        }
        let [width, height] = size_px;
        let row = bytes_per_pixel(format) * u64::from(width);
        let padded = row.next_multiple_of(u64::from(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT));
        if row == 0 || height == 0 {
            return Ok(Vec::new());
        }
        let host = self.download(padded * u64::from(height), |encoder, host| {
            encoder.copy_texture_to_buffer(
                texture.as_image_copy(),
                wgpu::TexelCopyBufferInfo {
                    buffer: host,
                    layout: wgpu::TexelCopyBufferLayout {
                        offset: 0,
                        bytes_per_row: Some(padded as u32),
                        rows_per_image: None,
                    },
                },
                texture.size(),
            );
        })?;
        let rows = host.chunks_exact(padded as usize);
        Ok(rows.flat_map(|padded| &padded[..row as usize]).copied().collect())
    }

    /// Copies something to the host and waits for it.
    fn download(
        &self,
        bytes: u64,
        copy: impl FnOnce(&mut wgpu::CommandEncoder, &wgpu::Buffer),
    ) -> Result<Vec<u8>, GpuError> {
        let gpu = &self.gpu;
        let (host, submission) = gpu.guarded(|| {
            let host = gpu.device().create_buffer(&wgpu::BufferDescriptor {
                label: Some("download"),
                size: bytes,
                usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            });
            let mut encoder = gpu.device().create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            copy(&mut encoder, &host);
            let submission = gpu.queue().submit([encoder.finish()]);
            host.map_async(wgpu::MapMode::Read, .., |_| ());
            (host, submission)
        })?;
        gpu.poll(Some(submission))?;
        let mapped = host.slice(..).get_mapped_range();
        let content = mapped.map_err(|error| GpuError::Refused { reason: error.to_string() })?;
        Ok(content.to_vec())
    }

    /// Finished frames since the last call, in order; none is ever lost.
    pub fn reports(&mut self) -> Vec<FrameReport> {
        // An error here is the next run's error too.
        if let Err(error) = self.gpu.poll(None).and_then(|()| self.collect()) {
            self.pending_error.get_or_insert(error);
        }
        self.reports.drain(..).collect()
    }

    /// Waits for every frame in flight; returns the reports since the last call.
    ///
    /// # Errors
    /// If the device is lost, or a write failed.
    pub fn finish(&mut self) -> Result<Vec<FrameReport>, GpuError> {
        while !self.in_flight.is_empty() {
            self.wait_for_oldest()?;
        }
        match self.pending_error.take() {
            Some(error) => Err(error),
            None => Ok(self.reports.drain(..).collect()),
        }
    }

    /// A buffer's own wgpu buffer, for a host program that draws from it; `None` if the plan left
    /// it out. It may be longer than its content, which starts at its start.
    pub fn wgpu_buffer(&self, id: ResourceId) -> Option<&wgpu::Buffer> {
        self.arena.buffer_of(id)
    }

    /// A texture's own wgpu view, for a host program that shows it; `None` if the plan left it
    /// out.
    pub fn wgpu_view(&self, id: ResourceId) -> Option<&wgpu::TextureView> {
        self.arena.get(id).and_then(Memory::view)
    }

    /// Bytes of GPU memory allocated for this engine: its resources (rounded up as the pool
    /// does), its uploads, and its ring of results.
    pub fn allocated_bytes(&self) -> u64 {
        let ring: u64 = self.ring.iter().map(Slot::bytes).sum();
        self.arena.allocated_bytes() + self.staging.bytes + ring
    }

    /// Dispatches and draws handed to the GPU so far.
    pub fn dispatch_count(&self) -> u64 {
        self.dispatches
    }

    /// Buffers, textures and query sets made for this engine so far.
    pub fn allocation_count(&self) -> u64 {
        self.arena.len() as u64 + self.staging.count + self.ring_allocations
    }

    /// Timestamps taken so far.
    pub fn timestamp_query_count(&self) -> u64 {
        self.timestamps
    }
}
