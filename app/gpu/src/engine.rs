//! Runs a plan's recordings.

mod adopt;
mod download;
mod swap_modules;

use crate::device::Gpu;
use crate::encode::{Encoder, tick_bound};
use crate::error::GpuError;
use crate::memory::{Arena, Memory, check_sizes};
use crate::plan::Plan;
use crate::readback::{Grown, Slot};
use crate::recording::RecordingId;
use crate::steps::{Ready, Staging, pipeline_count, prepare};
use crate::timing::FrameReport;
use brooklet_kernels::{Buffer, ResourceId};
use bytemuck::Pod;
use std::collections::VecDeque;
use std::time::Instant;

/// Frames that may be in flight before `run` waits for the oldest.
pub const FRAMES_IN_FLIGHT: usize = 4;

/// A window that loads a scene makes all of these on a thread of its own.
const _: () = {
    const fn is_send<T: Send>() {}
    is_send::<Gpu>();
    is_send::<Plan>();
    is_send::<Engine>();
};

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
        Self::new_with_progress(gpu, plan, &mut |_, _, _| ())
    }

    /// [`Engine::new`], saying how far it is: `progress(done, total, what)` is called before each
    /// buffer and texture is allocated (`done` 0: all memory is one step), and after the memory and
    /// each pipeline (`what` its kernel and variant). May run on any thread, while other engines of
    /// the device run on theirs.
    ///
    /// # Errors
    /// As [`Engine::new`].
    pub fn new_with_progress(
        gpu: &Gpu,
        plan: Plan,
        progress: &mut dyn FnMut(usize, usize, &str),
    ) -> Result<Engine, GpuError> {
        gpu.check()?;
        let plan = plan.with_formats_of(gpu);
        let total = 1 + pipeline_count(&plan);
        let arena = Arena::new(gpu, &plan, &mut |label| progress(0, total, label))?;
        progress(1, total, "memory");
        let (ready, staging) = prepare(gpu, &plan, &arena, &mut |built, _, module| progress(1 + built, total, module))?;
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
        match gpu.lacks_formats() {
            true => check_sizes(gpu, &plan.clone().with_formats_of(gpu)).map(|_| ()),
            false => check_sizes(gpu, plan).map(|_| ()),
        }
    }

    /// The device.
    pub fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    /// The plan.
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// Hands `recordings` to the GPU as one frame, in order (one may come more than once), and
    /// asks for the content that `readbacks`, buffers and textures, have at its end. Waits for no result, unless
    /// [`FRAMES_IN_FLIGHT`] frames are under way: then for the oldest. Returns the frame's number;
    /// its [`FrameReport`] comes with [`Engine::reports`], which keeps each one until then.
    ///
    /// # Errors
    /// If the device is lost, or a recording or a readback is not in the plan.
    pub fn run(&mut self, recordings: &[RecordingId], readbacks: &[ResourceId]) -> Result<u64, GpuError> {
        if let Some(error) = self.pending_error.take() {
            return Err(error);
        }
        let order = recordings.iter().map(|id| self.find(*id)).collect::<Result<Vec<usize>, _>>()?;
        let wanted = readbacks.iter().map(|id| self.copy_out(*id)).collect::<Result<Vec<_>, GpuError>>()?;

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
            slot.encode(&mut commands, |id| arena.get(id));
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

    fn find(&self, id: RecordingId) -> Result<usize, GpuError> {
        self.ready.iter().position(|ready| ready.id == id).ok_or_else(|| GpuError::NoSuchRecording {
            name: id.label().to_owned(),
            present: self.ready.iter().map(|ready| ready.id.label()).collect(),
        })
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
    /// not written, nor one whose memory others use too: nothing reads it. Too much data is an error of the next run.
    pub fn write<T: Pod>(&mut self, to: &Buffer<T>, data: &[T]) {
        if data.len() > to.len as usize {
            self.pending_error.get_or_insert(GpuError::WriteTooLong {
                label: self.plan.resources().label(to.id).to_owned(),
                elements: data.len(),
                room: to.len,
            });
        } else if let Some(buffer) = self.arena.buffer_of(to.id).filter(|_| !data.is_empty() && self.keeps(to.id)) {
            let queue = self.gpu.queue();
            let written = self.gpu.guarded(|| queue.write_buffer(buffer, 0, bytemuck::cast_slice(data)));
            if let Err(error) = written {
                self.pending_error.get_or_insert(error);
            }
        }
    }

    /// As [`Engine::write`], over what an upload of the plan filled once: the running plan is then one that uploads `data`, and
    /// another is held against that ([`Engine::take_uploads`]).
    pub fn write_uploaded<T: Pod>(&mut self, to: &Buffer<T>, data: &[T]) {
        self.write(to, data);
        self.plan.set_uploads(to.id, bytemuck::cast_slice(data));
    }

    /// Takes the numbers of a plan that is the running one but for the content of uploads of the recordings
    /// `of`, and writes those that changed before the next run: what such recordings filled once is then as if
    /// they had been `other`'s. False, and nothing is written, if `other` needs an engine of its own.
    ///
    /// # Errors
    /// If the device is lost.
    pub fn take_uploads(&mut self, other: &Plan, of: &[RecordingId]) -> Result<bool, GpuError> {
        // As this engine's own plan is.
        let other = match self.gpu.lacks_formats() {
            true => &other.clone().with_formats_of(&self.gpu),
            false => other,
        };
        let Some(changed) = self.plan.changed_uploads(other) else { return Ok(false) };
        if changed.iter().any(|upload| !of.contains(&upload.recording)) {
            return Ok(false);
        }
        let (arena, queue) = (&self.arena, self.gpu.queue());
        self.gpu.guarded(|| {
            for upload in &changed {
                if let Some(buffer) = arena.buffer_of(upload.to) {
                    queue.write_buffer(buffer, 0, &upload.data);
                }
            }
        })?;
        self.plan.take_uploads(other);
        Ok(true)
    }

    /// Finished frames since the last call, in order; none is ever lost.
    pub fn reports(&mut self) -> Vec<FrameReport> {
        self.in_flight();
        self.reports.drain(..).collect()
    }

    /// Frames handed to the GPU that it is not done with, at most [`FRAMES_IN_FLIGHT`]; asks the
    /// device, and waits for nothing. A window that runs a frame only while this is below two shows
    /// no picture later than two frames after its input.
    pub fn in_flight(&mut self) -> usize {
        // An error here is the next run's error.
        if let Err(error) = self.gpu.poll(None).and_then(|()| self.collect()) {
            self.pending_error.get_or_insert(error);
        }
        self.in_flight.len()
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
    /// it out, or if others use its memory between two runs. It may be longer than its content, which starts at its start.
    pub fn wgpu_buffer(&self, id: ResourceId) -> Option<&wgpu::Buffer> {
        self.arena.buffer_of(id).filter(|_| self.keeps(id))
    }

    /// Whether a resource's content is there between two runs: state's is, and of all that shares no memory.
    fn keeps(&self, id: ResourceId) -> bool {
        let is_state = self.plan.resources().get(id).is_some_and(|entry| entry.state);
        is_state || !self.plan.sharing.is_shared(id)
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
