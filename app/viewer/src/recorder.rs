//! The window's capture: every frame, what was measured, what was changed, a picture a second.

use std::fs::File;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use brooklet_capture::{
    CaptureClock, CaptureCost, CaptureError, CaptureOptions, CaptureTotals, CaptureWriter, DeviceState, Level,
    StatField, StateRow,
};
use brooklet_fluid::{SessionReport, captured_fields, captured_values};
use brooklet_gpu::{Gpu, tier_name};
use brooklet_kernels::MeshCounts;
use brooklet_render::surface::marching_cubes::{MESH_FIELDS, mesh_values};

use crate::messages::Kind;
use crate::thumbnail::{Picture, Thumbnails};
use crate::viewer_scene::ViewerScene;

/// What captures are told of the program that writes them.
pub(crate) fn build(program: &str) -> Vec<(String, String)> {
    vec![("program".into(), program.into()), ("version".into(), env!("CARGO_PKG_VERSION").into())]
}

/// Pictures, points and heat are recorded so often.
const SLOWLY: Duration = Duration::from_secs(1);

/// Raw ticks are recorded of every so many frames: with several steps a frame they are most of a capture,
/// and ten minutes of it stay below 100 MB.
const SPANS_EVERY: u32 = 4;

/// A capture being written.
pub struct Recorder {
    /// Its file.
    pub path: PathBuf,
    writer: CaptureWriter<File>,
    clock: CaptureClock,
    has_density: bool,
    /// How many values a measurement has, but for a mesh's.
    fluid_fields: usize,
    has_mesh: bool,
    heat: DeviceState,
    thumbnails: Thumbnails,
    frames: u64,
    heat_read: Option<Instant>,
    picture_taken: Option<Instant>,
}

impl Recorder {
    /// Creates the file and writes what holds for all of it.
    pub fn begin(
        path: PathBuf,
        gpu: &Gpu,
        current: &ViewerScene,
        about: &[(String, Vec<(String, String)>)],
    ) -> Result<Self, CaptureError> {
        let clock = CaptureClock::new();
        let has_mesh = current.is_meshed();
        let mesh = MESH_FIELDS.into_iter().filter(|_| has_mesh);
        let options = CaptureOptions {
            stats: captured_fields(current.session.scene())
                .map(StatField::from)
                .chain(mesh.map(StatField::from))
                .collect(),
            start: clock.start(),
            spans_every: SPANS_EVERY,
            ..CaptureOptions::default()
        };
        let mut writer = CaptureWriter::create(&path, options)?;
        writer.device(gpu.info(), tier_name(gpu.tier()))?;
        for (name, fields) in about {
            writer.metadata(name, fields.clone())?;
        }
        let mut recorder = Self {
            path,
            writer,
            clock,
            has_density: current.session.scene().solver.method.interacts(),
            fluid_fields: captured_fields(current.session.scene()).count(),
            has_mesh,
            heat: DeviceState::find(),
            thumbnails: Thumbnails::new(),
            frames: 0,
            heat_read: None,
            picture_taken: None,
        };
        recorder.scene(current)?;
        Ok(recorder)
    }

    /// Another scene is recorded from now on.
    pub fn scene(&mut self, scene: &ViewerScene) -> Result<(), CaptureError> {
        let simulated = scene.session.scene();
        self.writer.plan(scene.session.engine().plan())?;
        let name = format!("{}.toml", simulated.name);
        self.writer.attach(&name, "application/toml", simulated.to_toml().as_bytes())
    }

    /// A frame that came back, handed over at that time.
    pub fn frame(
        &mut self,
        frame: SessionReport,
        mesh: Option<&MeshCounts>,
        handed: Instant,
    ) -> Result<(), CaptureError> {
        let values = captured_values(&frame);
        let SessionReport { mut report, stats, .. } = frame;
        report.frame = self.frames;
        report.wall_ns = self.clock.ns_at(handed);
        self.frames += 1;
        self.writer.frame(&report)?;
        // A scene whose particles have no densities has none of the fields that this capture began with, or the other
        // way round, and so has one with other solids whose force is measured: its measurements are left out.
        let same = stats.is_some_and(|stats| stats.has_density == self.has_density);
        if let Some(mut values) = values.filter(|values| same && values.len() == self.fluid_fields) {
            if self.has_mesh {
                values.extend(mesh_values(&mesh.copied().unwrap_or_default()));
            }
            self.writer.stats(report.frame, report.wall_ns, &values)?;
        }
        Ok(())
    }

    /// What is done about once a second, and what was made of the last picture.
    pub fn now_and_then(&mut self) -> Result<(), CaptureError> {
        if is_due(self.heat_read) {
            self.heat_read = Some(Instant::now());
            self.writer.thermal(self.clock.ns(), &self.heat.read())?;
        }
        while let Some((taken, jpeg)) = self.thumbnails.ready() {
            self.writer.image(self.clock.ns_at(taken), "jpeg", &jpeg)?;
        }
        Ok(())
    }

    /// Whether the next picture should come back to the host.
    pub fn wants_picture(&mut self) -> bool {
        let is_due = is_due(self.picture_taken);
        if is_due {
            self.picture_taken = Some(Instant::now());
        }
        is_due
    }

    /// A picture that came back: it is made small on another thread, and written when that is done.
    pub fn picture(&mut self, size_px: [u32; 2], rgba: &[u8], taken: Instant) {
        self.thumbnails.give(Picture { size_px, rgba: rgba.to_vec(), taken });
    }

    /// Points of the fluid: x, y, z in m and speed in m/s.
    pub fn particles(&mut self, points: &[[f32; 4]], handed: Instant) -> Result<(), CaptureError> {
        self.writer.particles(self.clock.ns_at(handed), points)
    }

    /// What is computed and drawn from now on.
    pub fn state(&mut self, state: &StateRow) -> Result<(), CaptureError> {
        self.writer.state(self.clock.ns(), state)
    }

    /// Something was said in the window.
    pub fn log(&mut self, kind: Kind, text: &str) -> Result<(), CaptureError> {
        let level = match kind {
            Kind::Done => Level::Info,
            Kind::Warning => Level::Warning,
            Kind::Error => Level::Error,
        };
        self.writer.log(self.clock.ns(), level, text)
    }

    /// What capturing costs, where somebody measured it.
    pub fn cost(&mut self, cost: &CaptureCost) -> Result<(), CaptureError> {
        self.writer.cost(cost)
    }

    /// Writes what is recorded so far.
    pub fn flush(&mut self) -> Result<(), CaptureError> {
        self.writer.flush()
    }

    /// Bytes written so far.
    pub fn bytes(&self) -> u64 {
        self.writer.bytes_written()
    }

    /// Its file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Writes the end.
    pub fn finish(mut self) -> Result<CaptureTotals, CaptureError> {
        for (taken, jpeg) in self.thumbnails.finish() {
            self.writer.image(self.clock.ns_at(taken), "jpeg", &jpeg)?;
        }
        self.writer.finish()
    }
}

fn is_due(last: Option<Instant>) -> bool {
    last.is_none_or(|last| last.elapsed() >= SLOWLY)
}
