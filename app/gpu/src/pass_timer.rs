//! Times the passes of any wgpu program, on its own device, as the engine times its own: the same
//! [`FrameReport`]s, late by some frames, and nothing ever waits for them.

use crate::recording::RecordingId;
use crate::timing::{FrameReport, SpanSlot, TimingStatus, spans};
use std::sync::Arc;
use std::sync::atomic::{AtomicU8, Ordering};
use std::time::Instant;

/// Frames whose results may be on their way. One more than engines have: the host's frame begins before
/// an engine's and ends behind it.
const PLACES: usize = 5;
const TICK_BYTES: u64 = 8;

const FREE: u8 = 0;
const PENDING: u8 = 1;
const ARRIVED: u8 = 2;
const FAILED: u8 = 3;

/// What every span's recording is called.
const RECORDING: RecordingId = RecordingId::outside("host");

/// Times passes by the timestamps at their begin and end.
///
/// A frame: [`PassTimer::begin_frame`], a [`PassTimer::compute_pass`] or [`PassTimer::render_pass`] for
/// each pass's descriptor, and [`PassTimer::resolve`] into the encoder that is submitted last. Reports come
/// with [`PassTimer::reports`]. A device without timestamps gives reports without spans
/// ([`TimingStatus::Unsupported`]); a frame that begins when all places are still on their way is not
/// timed, and counted by [`PassTimer::dropped_frames`].
pub struct PassTimer {
    device: wgpu::Device,
    timing: TimingStatus,
    period_ns: f64,
    started: Instant,
    most_passes: u32,
    places: Vec<Place>,
    /// The place of the frame that is recorded now.
    open: Option<usize>,
    frames: u64,
    dropped_frames: u64,
    ready: Vec<FrameReport>,
}

struct Place {
    /// None where the device has no timestamps.
    memory: Option<Memory>,
    slots: Vec<SpanSlot>,
    frame: u64,
    wall_ns: u64,
    dropped_spans: u32,
    state: Arc<AtomicU8>,
}

struct Memory {
    queries: wgpu::QuerySet,
    resolved: wgpu::Buffer,
    host: wgpu::Buffer,
}

impl PassTimer {
    /// What a device must be opened with to be timed, as far as the adapter has it.
    pub fn wanted_features(adapter: &wgpu::Adapter) -> wgpu::Features {
        adapter.features() & wgpu::Features::TIMESTAMP_QUERY
    }

    /// For at most `most_passes` passes a frame (those beyond are counted as dropped spans). `started` is
    /// the moment that `wall_ns` of the reports counts from: an engine's reports on the same clock can then
    /// be joined by [`FrameReport::append`].
    pub fn new(device: &wgpu::Device, queue: &wgpu::Queue, most_passes: u32, started: Instant) -> Self {
        let most_passes = most_passes.clamp(1, wgpu::QUERY_SET_MAX_QUERIES / 2);
        let is_timed = device.features().contains(wgpu::Features::TIMESTAMP_QUERY);
        let place = || Place {
            memory: is_timed.then(|| Memory::new(device, most_passes)),
            slots: Vec::with_capacity(most_passes as usize),
            frame: 0,
            wall_ns: 0,
            dropped_spans: 0,
            state: Arc::new(AtomicU8::new(FREE)),
        };
        Self {
            device: device.clone(),
            timing: if is_timed { TimingStatus::OwnPasses } else { TimingStatus::Unsupported },
            period_ns: f64::from(queue.get_timestamp_period()),
            started,
            most_passes,
            places: (0..PLACES).map(|_| place()).collect(),
            open: None,
            frames: 0,
            dropped_frames: 0,
            ready: Vec::new(),
        }
    }

    /// Begins a frame and returns its number. One that was begun and not resolved is given up.
    pub fn begin_frame(&mut self) -> u64 {
        self.collect();
        if self.open.take().is_some() {
            self.dropped_frames += 1;
        }
        let frame = self.frames;
        self.frames += 1;
        self.open = self.places.iter().position(|place| place.state.load(Ordering::Acquire) == FREE);
        match self.open {
            Some(place) => {
                let place = &mut self.places[place];
                place.slots.clear();
                place.frame = frame;
                place.wall_ns = self.started.elapsed().as_nanos() as u64;
                place.dropped_spans = 0;
            }
            None => self.dropped_frames += 1,
        }
        frame
    }

    /// The `timestamp_writes` of a compute pass that does `stage`; none where it is not timed.
    pub fn compute_pass(&mut self, stage: &'static str) -> Option<wgpu::ComputePassTimestampWrites<'_>> {
        let (query_set, first) = self.take(stage)?;
        Some(wgpu::ComputePassTimestampWrites {
            query_set,
            beginning_of_pass_write_index: Some(first),
            end_of_pass_write_index: Some(first + 1),
        })
    }

    /// The `timestamp_writes` of a render pass that does `stage`; none where it is not timed.
    pub fn render_pass(&mut self, stage: &'static str) -> Option<wgpu::RenderPassTimestampWrites<'_>> {
        let (query_set, first) = self.take(stage)?;
        Some(wgpu::RenderPassTimestampWrites {
            query_set,
            beginning_of_pass_write_index: Some(first),
            end_of_pass_write_index: Some(first + 1),
        })
    }

    fn take(&mut self, stage: &'static str) -> Option<(&wgpu::QuerySet, u32)> {
        let place = &mut self.places[self.open?];
        let memory = place.memory.as_ref()?;
        if place.slots.len() as u32 == self.most_passes {
            place.dropped_spans += 1;
            return None;
        }
        let first = 2 * place.slots.len() as u32;
        place.slots.push(SpanSlot { recording: RECORDING, stage, begin: first, end: first + 1 });
        Some((&memory.queries, first))
    }

    /// Ends the frame: `commands` must be submitted, behind or with all passes of the frame.
    pub fn resolve(&mut self, commands: &mut wgpu::CommandEncoder) {
        let Some(open) = self.open.take() else { return };
        let place = &mut self.places[open];
        // A new flag each frame: a callback that comes late must not speak for a later frame.
        place.state = Arc::new(AtomicU8::new(PENDING));
        let Some(memory) = place.memory.as_ref().filter(|_| !place.slots.is_empty()) else {
            place.state.store(ARRIVED, Ordering::Release);
            return;
        };
        let queries = 2 * place.slots.len() as u32;
        let bytes = u64::from(queries) * TICK_BYTES;
        commands.resolve_query_set(&memory.queries, 0..queries, &memory.resolved, 0);
        commands.copy_buffer_to_buffer(&memory.resolved, 0, &memory.host, 0, bytes);
        let answer = Answer(Arc::clone(&place.state));
        commands.map_buffer_on_submit(&memory.host, wgpu::MapMode::Read, 0..bytes, move |mapped| {
            answer.0.store(if mapped.is_ok() { ARRIVED } else { FAILED }, Ordering::Release);
        });
    }

    /// Reports of finished frames since the last call, in order. Waits for nothing: the program polls its
    /// device as it does anyway, or submits.
    pub fn reports(&mut self) -> Vec<FrameReport> {
        self.collect();
        std::mem::take(&mut self.ready)
    }

    /// As [`PassTimer::reports`], after all frames in flight have come: at the end of a program.
    pub fn finish(&mut self) -> Vec<FrameReport> {
        // A device that is lost has no more to give.
        let _ = self.device.poll(wgpu::PollType::wait_indefinitely());
        self.reports()
    }

    /// Frames without a report, or that will have none: no place was free, they were given up, or their
    /// results could not be read.
    pub fn dropped_frames(&self) -> u64 {
        self.dropped_frames
    }

    /// How times are taken.
    pub fn timing(&self) -> TimingStatus {
        self.timing
    }

    /// Takes finished frames up to the oldest that is still on its way.
    fn collect(&mut self) {
        loop {
            let on_their_way = self
                .places
                .iter()
                .enumerate()
                .filter(|(index, place)| Some(*index) != self.open && place.state.load(Ordering::Acquire) != FREE);
            let Some((oldest, _)) = on_their_way.min_by_key(|(_, place)| place.frame) else { return };
            let place = &mut self.places[oldest];
            match place.state.load(Ordering::Acquire) {
                ARRIVED => match place.ticks() {
                    Some(ticks) => {
                        let spans = spans(&place.slots, &ticks);
                        self.ready.push(FrameReport {
                            frame: place.frame,
                            wall_ns: place.wall_ns,
                            dropped_spans: place.dropped_spans + (place.slots.len() - spans.len()) as u32,
                            spans,
                            readbacks: Vec::new(),
                            timing: self.timing,
                            timestamp_period_ns: self.period_ns,
                        });
                    }
                    None => self.dropped_frames += 1,
                },
                FAILED => self.dropped_frames += 1,
                _ => return,
            }
            place.state.store(FREE, Ordering::Release);
        }
    }
}

/// A frame's flag on its way with the mapping; commands that are never submitted drop it unanswered.
struct Answer(Arc<AtomicU8>);

impl Drop for Answer {
    fn drop(&mut self) {
        let _ = self.0.compare_exchange(PENDING, FAILED, Ordering::AcqRel, Ordering::Acquire);
    }
}

impl Place {
    /// The frame's ticks; none if they cannot be read.
    fn ticks(&self) -> Option<Vec<u64>> {
        let Some(memory) = self.memory.as_ref().filter(|_| !self.slots.is_empty()) else {
            return Some(Vec::new());
        };
        let bytes = 2 * self.slots.len() as u64 * TICK_BYTES;
        let ticks = {
            let mapped = memory.host.slice(0..bytes).get_mapped_range().ok()?;
            bytemuck::pod_collect_to_vec(&mapped)
        };
        memory.host.unmap();
        Some(ticks)
    }
}

impl Memory {
    fn new(device: &wgpu::Device, most_passes: u32) -> Self {
        let count = 2 * most_passes;
        let buffer = |label, usage| {
            device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size: u64::from(count) * TICK_BYTES,
                usage,
                mapped_at_creation: false,
            })
        };
        use wgpu::BufferUsages as U;
        Self {
            queries: device.create_query_set(&wgpu::QuerySetDescriptor {
                label: Some("pass timer"),
                ty: wgpu::QueryType::Timestamp,
                count,
            }),
            resolved: buffer("pass timer ticks", U::QUERY_RESOLVE | U::COPY_SRC),
            host: buffer("pass timer host", U::COPY_DST | U::MAP_READ),
        }
    }
}
