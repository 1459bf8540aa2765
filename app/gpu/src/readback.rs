//! What comes back from the GPU: a ring of buffers, one a frame in flight, that holds a frame's
//! ticks and the buffers and textures that were asked for, so that no frame waits for its own results.

use crate::copy_out::CopyOut;
use crate::device::Gpu;
use crate::error::GpuError;
use crate::memory::Memory;
use crate::timing::{FrameReport, SpanSlot, TimingStatus, spans};
use brooklet_kernels::ResourceId;
use std::sync::Arc;
use std::sync::atomic::{AtomicU8, Ordering};

/// Queries a set may have in wgpu.
pub(crate) const QUERIES_A_SET: u32 = wgpu::QUERY_SET_MAX_QUERIES;
const TICK_BYTES: u64 = 8;

/// Bytes that a frame of so many timestamps takes on the GPU and on the way back.
pub fn timestamp_bytes(timestamps: u64) -> u64 {
    let sets = timestamps.div_ceil(u64::from(QUERIES_A_SET) - 1);
    // Query sets, what they are resolved to, and what the host reads.
    3 * sets * u64::from(QUERIES_A_SET) * TICK_BYTES
}

const PENDING: u8 = 0;
const ARRIVED: u8 = 1;
const FAILED: u8 = 2;

/// A place in the ring: a frame in flight, or room for one.
pub(crate) struct Slot {
    pub frame: u64,
    pub wall_ns: u64,
    pub ticks: Ticks,
    /// What was asked for, and its place in `host`.
    readbacks: Vec<(CopyOut, u64)>,
    pub submission: Option<wgpu::SubmissionIndex>,
    host: Option<wgpu::Buffer>,
    resolve: Option<wgpu::Buffer>,
    state: Arc<AtomicU8>,
    used_bytes: u64,
}

/// The timestamps of a frame.
#[derive(Default)]
pub(crate) struct Ticks {
    sets: Vec<wgpu::QuerySet>,
    next: u32,
    /// Queries written of each set, from its start.
    written: Vec<u32>,
    pub spans: Vec<SpanSlot>,
}

impl Ticks {
    pub fn restart(&mut self) {
        self.next = 0;
        self.written.clear();
        self.spans.clear();
    }

    /// Makes room; returns how many query sets were made.
    pub fn reserve(&mut self, gpu: &Gpu, ticks: u32) -> Result<u64, GpuError> {
        // A pair never straddles two sets, so each set may lose one query.
        let needed = ticks.div_ceil(QUERIES_A_SET - 1) as usize;
        let mut made = 0;
        while self.sets.len() < needed {
            let set = gpu.guarded(|| {
                gpu.device().create_query_set(&wgpu::QuerySetDescriptor {
                    label: Some("timestamps"),
                    ty: wgpu::QueryType::Timestamp,
                    count: QUERIES_A_SET,
                })
            })?;
            self.sets.push(set);
            made += 1;
        }
        Ok(made)
    }

    /// The next `count` queries, all of one set: the set, the first's place in it, and its number
    /// in the frame.
    pub fn take(&mut self, count: u32) -> Option<(&wgpu::QuerySet, u32, u32)> {
        if self.next % QUERIES_A_SET + count > QUERIES_A_SET {
            self.next = self.next.next_multiple_of(QUERIES_A_SET);
        }
        let number = self.next;
        let set = (number / QUERIES_A_SET) as usize;
        let place = number % QUERIES_A_SET;
        self.written.resize(set + 1, 0);
        self.written[set] = place + count;
        self.next += count;
        self.sets.get(set).map(|set| (set, place, number))
    }

    pub fn written(&self) -> u64 {
        self.written.iter().map(|count| u64::from(*count)).sum()
    }

    fn bytes(&self) -> u64 {
        u64::from(self.next) * TICK_BYTES
    }
}

/// What making room allocated.
#[derive(Clone, Copy, Default)]
pub(crate) struct Grown {
    pub count: u64,
    pub bytes: u64,
}

impl Slot {
    pub fn new() -> Self {
        Self {
            frame: 0,
            wall_ns: 0,
            ticks: Ticks::default(),
            readbacks: Vec::new(),
            submission: None,
            host: None,
            resolve: None,
            state: Arc::new(AtomicU8::new(PENDING)),
            used_bytes: 0,
        }
    }

    /// Makes room for the frame's ticks and for these resources.
    pub fn prepare(&mut self, gpu: &Gpu, ticks: u32, wanted: &[CopyOut]) -> Result<Grown, GpuError> {
        let mut grown = Grown::default();
        self.ticks.restart();
        grown.count += self.ticks.reserve(gpu, ticks)?;
        let tick_bytes = u64::from(ticks.div_ceil(QUERIES_A_SET - 1) * QUERIES_A_SET) * TICK_BYTES;
        self.readbacks.clear();
        let mut end = tick_bytes;
        for copy in wanted {
            let place = end.next_multiple_of(u64::from(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT));
            self.readbacks.push((*copy, place));
            end = (place + copy.host_bytes()).next_multiple_of(wgpu::MAP_ALIGNMENT);
        }
        self.used_bytes = end;
        use wgpu::BufferUsages as U;
        grown += grow(gpu, &mut self.resolve, tick_bytes, U::QUERY_RESOLVE | U::COPY_SRC, "ticks")?;
        grown += grow(gpu, &mut self.host, end, U::MAP_READ | U::COPY_DST, "readback")?;
        Ok(grown)
    }

    /// Encodes the copies of ticks, buffers and textures to where the host can read them.
    pub fn encode<'a>(&self, encoder: &mut wgpu::CommandEncoder, memory_of: impl Fn(ResourceId) -> Option<&'a Memory>) {
        let Some(host) = &self.host else { return };
        if let Some(resolve) = &self.resolve {
            for (set, written) in self.ticks.written.iter().enumerate() {
                let offset = set as u64 * u64::from(QUERIES_A_SET) * TICK_BYTES;
                if let Some(queries) = self.ticks.sets.get(set) {
                    encoder.resolve_query_set(queries, 0..*written, resolve, offset);
                }
            }
            if self.ticks.bytes() > 0 {
                encoder.copy_buffer_to_buffer(resolve, 0, host, 0, self.ticks.bytes());
            }
        }
        for (copy, place) in &self.readbacks {
            copy.encode(encoder, memory_of(copy.id), host, *place);
        }
    }

    /// Asks for the results; call after the frame was submitted.
    pub fn request(&mut self, gpu: &Gpu) {
        // A new flag each frame: a callback that comes late must not speak for a later frame.
        self.state = Arc::new(AtomicU8::new(PENDING));
        let state = Arc::clone(&self.state);
        match self.host.as_ref().filter(|_| self.used_bytes > 0) {
            Some(host) => host.map_async(wgpu::MapMode::Read, 0..self.used_bytes, move |result| {
                let arrived = if result.is_ok() { ARRIVED } else { FAILED };
                state.store(arrived, Ordering::Release);
            }),
            None => gpu.queue().on_submitted_work_done(move || state.store(ARRIVED, Ordering::Release)),
        }
    }

    /// Whether the results are there.
    pub fn has_arrived(&self) -> Result<bool, GpuError> {
        match self.state.load(Ordering::Acquire) {
            PENDING => Ok(false),
            ARRIVED => Ok(true),
            _ => Err(GpuError::Refused { reason: format!("the results of frame {} could not be mapped", self.frame) }),
        }
    }

    /// Takes the results.
    pub fn report(&mut self, timing: TimingStatus, period_ns: f64) -> Result<FrameReport, GpuError> {
        let mut ticks: Vec<u64> = Vec::new();
        let mut readbacks = Vec::with_capacity(self.readbacks.len());
        if let Some(host) = self.host.as_ref().filter(|_| self.used_bytes > 0) {
            let range = host.slice(0..self.used_bytes).get_mapped_range();
            let bytes = range.map_err(|error| GpuError::Refused { reason: error.to_string() })?;
            ticks = bytemuck::pod_collect_to_vec(&bytes[..self.ticks.bytes() as usize]);
            for (copy, place) in &self.readbacks {
                readbacks.push((copy.id, copy.content(&bytes[*place as usize..])));
            }
            drop(bytes);
            host.unmap();
        }
        let spans = spans(&self.ticks.spans, &ticks);
        Ok(FrameReport {
            frame: self.frame,
            wall_ns: self.wall_ns,
            dropped_spans: (self.ticks.spans.len() - spans.len()) as u32,
            spans,
            readbacks,
            timing,
            timestamp_period_ns: period_ns,
        })
    }

    pub fn bytes(&self) -> u64 {
        let size = |buffer: &Option<wgpu::Buffer>| buffer.as_ref().map_or(0, wgpu::Buffer::size);
        size(&self.host) + size(&self.resolve)
    }
}

impl std::ops::AddAssign for Grown {
    fn add_assign(&mut self, other: Self) {
        self.count += other.count;
        self.bytes += other.bytes;
    }
}

fn grow(
    gpu: &Gpu,
    buffer: &mut Option<wgpu::Buffer>,
    bytes: u64,
    usage: wgpu::BufferUsages,
    label: &str,
) -> Result<Grown, GpuError> {
    if buffer.as_ref().map_or(0, wgpu::Buffer::size) >= bytes {
        return Ok(Grown::default());
    }
    let made = gpu.scoped(|| {
        gpu.device().create_buffer(&wgpu::BufferDescriptor {
            label: Some(label),
            size: bytes.next_multiple_of(16),
            usage,
            mapped_at_creation: false,
        })
    });
    gpu.check()?;
    *buffer = Some(made.map_err(|_| GpuError::OutOfMemory { label: label.to_owned(), bytes, allocated: 0 })?);
    Ok(Grown { count: 1, bytes })
}
