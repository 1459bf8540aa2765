//! The simulation's own time: hands frames to the GPU, and takes what comes back.

use std::collections::VecDeque;
use std::path::PathBuf;
use std::time::Instant;

use brooklet_capture::StateRow;
use brooklet_fluid::{SessionReport, Stats};
use brooklet_gpu::FrameReport;
use brooklet_kernels::MeshCounts;
use brooklet_render::png;
use brooklet_render::surface::marching_cubes::MeshRoom;

use crate::ViewerError;
use crate::clock::{Clock, steps_within};
use crate::drag::PendingDrag;
use crate::flow::Flow;
use crate::governor::FrameCost;
use crate::grip::PendingGrip;
use crate::in_flight::{InFlightFrame, InFlightFrames};
use crate::jobs::Jobs;
use crate::messages::{Kind, Messages};
use crate::recorder::Recorder;
use crate::times::Times;
use crate::viewer_scene::{ViewerFrame, ViewerScene};

/// A scene's course.
pub struct Playback {
    /// Whether it stands.
    pub paused: bool,
    /// Its time.
    pub clock: Clock,
    /// What its frames took.
    pub times: Times,
    /// The last measurement.
    pub stats: Option<Stats>,
    /// Where the next picture is kept.
    pub screenshot: Option<PathBuf>,
    /// The capture being written.
    pub recorder: Option<Recorder>,
    /// What is being written beside the frames.
    pub jobs: Jobs,
    /// Frames that were handed to the GPU.
    pub frames: u64,
    /// How the fluid is dragged in the next frame.
    pub drag: Option<PendingDrag>,
    /// How a body is.
    pub grip: Option<PendingGrip>,
    /// What came and went.
    pub flow: Flow,
    in_flight: InFlightFrames,
    /// Came back, and wait for the times of what was painted over them.
    returned: VecDeque<(SessionReport, InFlightFrame)>,
    painted: VecDeque<FrameReport>,
    started: Instant,
    last_advance: Instant,
    last_return: Instant,
    single_steps: u32,
    is_stale: bool,
    measured_step: u64,
    fresh_times: bool,
    /// What the last picture's mesh came to.
    pub mesh: Option<MeshCounts>,
    /// Room that it lacked.
    pub mesh_room: Option<MeshRoom>,
}

/// Reports that wait for another one no longer than this many frames.
const MOST_WAITING: usize = 4;

impl Playback {
    pub(crate) fn new() -> Self {
        Self {
            paused: false,
            clock: Clock::default(),
            times: Times::default(),
            stats: None,
            screenshot: None,
            recorder: None,
            jobs: Jobs::default(),
            frames: 0,
            drag: None,
            grip: None,
            flow: Flow::default(),
            in_flight: InFlightFrames::default(),
            returned: VecDeque::new(),
            painted: VecDeque::new(),
            started: Instant::now(),
            last_advance: Instant::now(),
            last_return: Instant::now(),
            single_steps: 0,
            is_stale: true,
            measured_step: 0,
            fresh_times: false,
            mesh: None,
            mesh_room: None,
        }
    }

    /// Another scene from now on; `carries` says whether it goes on with the state of the one before.
    pub fn begin(&mut self, current: &ViewerScene, carries: bool, messages: &mut Messages) {
        self.in_flight.clear();
        self.returned.clear();
        (self.mesh, self.mesh_room) = (None, None);
        self.is_stale = true;
        let density_error = std::mem::take(&mut self.times.density_error);
        let energy_j = std::mem::take(&mut self.times.energy_j);
        let passes = current.session.engine().plan().passes();
        self.times.restart(current.frame_recordings().into_iter().flat_map(|recording| {
            passes.iter().filter(move |pass| pass.recording == recording).map(|pass| pass.stage)
        }));
        if carries {
            self.times.density_error = density_error;
            self.times.energy_j = energy_j;
        }
        self.measured_step = current.session.steps();
        self.last_advance = Instant::now();
        self.record(messages, |recorder| recorder.scene(current));
    }

    /// One step more, and then stand.
    pub fn step_once(&mut self) {
        self.paused = true;
        self.single_steps += 1;
    }

    /// The next frame is drawn even if nothing moves.
    pub fn redraw(&mut self) {
        self.is_stale = true;
    }

    /// Something changed that a capture tells of.
    pub fn note(&mut self, state: &StateRow, messages: &mut Messages) {
        self.is_stale = true;
        self.record(messages, |recorder| recorder.state(state));
    }

    /// Notes in the capture what capturing costs.
    pub fn record_cost(&mut self, cost: &brooklet_capture::CaptureCost, messages: &mut Messages) {
        self.record(messages, |recorder| recorder.cost(cost));
    }

    /// Writes what the capture has so far.
    pub fn flush_capture(&mut self, messages: &mut Messages) {
        self.record(messages, Recorder::flush);
    }

    /// Whether frames come without anybody asking.
    pub fn is_moving(&self) -> bool {
        !self.paused
            || self.single_steps > 0
            || self.is_stale
            || !self.in_flight.is_empty()
            || self.screenshot.is_some()
    }

    /// Whether another frame may be handed to the GPU.
    pub fn has_room(&self) -> bool {
        self.in_flight.has_room()
    }

    /// Does something with the capture, if there is one. Its first failure is said, and ends it: what was
    /// written stays readable, and the window goes on.
    fn record(
        &mut self,
        messages: &mut Messages,
        job: impl FnOnce(&mut Recorder) -> Result<(), brooklet_capture::CaptureError>,
    ) {
        if let Some(recorder) = &mut self.recorder
            && let Err(error) = job(recorder)
        {
            self.recorder = None;
            messages.notify(Kind::Error, error.to_string());
        }
    }

    /// Takes the frames that came back, and the times of what was painted over them.
    ///
    /// # Errors
    /// If the device is lost.
    pub fn take_reports(
        &mut self,
        current: &mut ViewerScene,
        painted: Vec<FrameReport>,
        messages: &mut Messages,
    ) -> Result<(), ViewerError> {
        self.painted.extend(painted);
        for frame in current.session.reports() {
            if let Some(in_flight) = self.in_flight.end(frame.report.frame) {
                self.returned.push_back((frame, in_flight));
            }
        }
        while let Some((_, in_flight)) = self.returned.front() {
            let wanted = in_flight.painted;
            let is_there = wanted.is_none_or(|frame| self.painted.back().is_some_and(|report| report.frame >= frame));
            if !is_there && self.returned.len() <= MOST_WAITING {
                break;
            }
            let Some((mut frame, in_flight)) = self.returned.pop_front() else { break };
            while let Some(painted) =
                self.painted.pop_front_if(|painted| wanted.is_some_and(|frame| painted.frame <= frame))
            {
                if Some(painted.frame) == wanted {
                    frame.report.append(painted);
                }
            }
            self.take(frame, &in_flight, current, messages);
        }
        while self.painted.len() > 8 * MOST_WAITING {
            self.painted.pop_front();
        }
        for (kind, text) in messages.take_unlogged() {
            self.record(messages, |recorder| recorder.log(kind, &text));
        }
        self.record(messages, Recorder::now_and_then);
        match current.session.engine().gpu().is_lost() {
            Some(reason) => Err(ViewerError::Gpu(brooklet_gpu::GpuError::DeviceLost { reason })),
            None => Ok(()),
        }
    }

    fn take(
        &mut self,
        frame: SessionReport,
        in_flight: &InFlightFrame,
        current: &mut ViewerScene,
        messages: &mut Messages,
    ) {
        let SessionReport { report, stats, .. } = &frame;
        if let Some(counts) = current.learn(report) {
            self.mesh_room = current.lacked_room(&counts);
            self.mesh = Some(counts);
        }
        // A fade goes on though nothing moves.
        self.is_stale |= current.fades();
        let time_s = (in_flight.handed - self.started).as_secs_f64();
        let now = Instant::now();
        // Where the GPU tells no times: since it was handed over, or since the one before it came back.
        let wall_ms = 1e3 * (now - in_flight.handed.max(self.last_return)).as_secs_f64();
        self.last_return = now;
        self.times.take(report, (current.session.step_id(), in_flight.request.steps), time_s, wall_ms);
        self.fresh_times = true;
        if let Some(stats) = stats {
            let [kinetic_j, energy_j] = &mut self.times.energy_j;
            kinetic_j.push(time_s, stats.kinetic_j);
            energy_j.push(time_s, stats.kinetic_j + stats.potential_j);
        }
        if let Some(stats) = stats.filter(|stats| stats.has_density) {
            self.times.density_error.push(time_s, 100.0 * stats.density_error.mean);
        }
        for (id, bytes) in &report.readbacks {
            if *id == current.picture_id() {
                self.keep_picture(bytes, in_flight, current, messages);
            } else if Some(*id) == current.session.samples_id() {
                let points = points(bytes, current);
                self.record(messages, |recorder| recorder.particles(&points, in_flight.handed));
            }
        }
        if let Some(stats) = stats {
            self.flow.take(stats);
        }
        self.stats = stats.or(self.stats);
        let mesh = self.mesh;
        self.record(messages, |recorder| recorder.frame(frame, mesh.as_ref(), in_flight.handed));
    }

    fn keep_picture(&mut self, rgba: &[u8], in_flight: &InFlightFrame, current: &ViewerScene, messages: &mut Messages) {
        let size_px = current.view().size_px;
        if in_flight.request.records
            && let Some(recorder) = &mut self.recorder
        {
            recorder.picture(size_px, rgba, in_flight.handed);
        }
        if in_flight.request.screenshot
            && let Some(path) = self.screenshot.take()
        {
            let rgba = rgba.to_vec();
            self.jobs.begin(messages, move || {
                let folder = path.parent().unwrap_or(&path);
                std::fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
                png::save(&path, size_px, &rgba).map_err(|error| error.to_string())?;
                Ok(format!("screenshot {}", path.display()))
            });
        }
    }

    /// What a step and a picture took; once for each frame that came back.
    pub fn take_cost(&mut self) -> Option<FrameCost> {
        if !std::mem::take(&mut self.fresh_times) {
            return None;
        }
        Some(FrameCost { step_ms: self.times.step_ms.last()?, draw_ms: self.times.draw_ms.last()? })
    }

    /// Hands the next frame to the GPU if it has room for one and something is to be done; says whether it did.
    ///
    /// # Errors
    /// If the device is lost.
    pub fn advance(&mut self, current: &mut ViewerScene, budget_ms: f64) -> Result<bool, ViewerError> {
        if !self.in_flight.has_room() {
            return Ok(false);
        }
        let elapsed_s = self.last_advance.elapsed().as_secs_f64();
        self.last_advance = Instant::now();
        let most = self.times.cost_ms().map_or(1, |(step_ms, draw_ms)| steps_within(budget_ms, draw_ms, step_ms));
        let (dt_s, every) = {
            let scene = current.session.scene();
            (scene.solver.dt_s, u64::from(scene.outputs.measure_every_steps))
        };
        let steps = match (std::mem::take(&mut self.single_steps), self.paused) {
            (0, true) => 0,
            (0, false) => self.clock.steps(elapsed_s, dt_s, most),
            (single, _) => single,
        };
        let screenshot = self.screenshot.is_some();
        if steps == 0 && !self.is_stale && !screenshot {
            return Ok(false);
        }
        let done = current.session.steps() + u64::from(steps);
        let measures = every > 0 && steps > 0 && done >= self.measured_step + every;
        let records = self.recorder.as_mut().is_some_and(Recorder::wants_picture);
        let advance_s = f64::from(steps) * dt_s;
        let (drag, grip) = if steps > 0 { (self.drag.take(), self.grip.take()) } else { (None, None) };
        let request = ViewerFrame { steps, measures, screenshot, records };
        let drag = drag.map(|drag| drag.over(advance_s));
        let frame = current.run(&request, drag.as_ref(), grip.map(|grip| grip.over(advance_s)).as_ref())?;
        if measures {
            self.measured_step = done;
        }
        self.is_stale = false;
        self.frames += 1;
        let now = Instant::now();
        let time_s = (now - self.started).as_secs_f64();
        self.times.frame_ms.push(time_s, 1e3 * elapsed_s);
        if elapsed_s > 0.0 && !self.paused {
            self.times.speed.push(time_s, advance_s / elapsed_s);
        }
        self.in_flight.begin(InFlightFrame { frame, request, handed: now, painted: None });
        Ok(true)
    }

    /// Which frame of the painter shows the one that was just handed over.
    pub fn painted_as(&mut self, frame: u64) {
        self.in_flight.painted_as(frame);
    }
}

/// Points in the scene's coordinates; what is quarantined has none.
fn points(bytes: &[u8], current: &ViewerScene) -> Vec<[f32; 4]> {
    let samples: Vec<[f32; 4]> = bytemuck::pod_collect_to_vec(bytes);
    let min_m = current.view().domain_min_m.as_vec3();
    let is_whole = |sample: &[f32; 4]| sample.iter().all(|value| value.is_finite());
    samples
        .into_iter()
        .filter(is_whole)
        .map(|[x, y, z, speed]| [x + min_m.x, y + min_m.y, z + min_m.z, speed])
        .collect()
}
