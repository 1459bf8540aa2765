//! What happens beside the frames: states, lines of a log, pictures, points, heat, verdicts. Each topic is in the
//! file from its first message on, so that one that is never used does not appear.

use std::io::Write;

use serde_json::json;

use crate::{
    CaptureError, CaptureWriter, CheckRow, Level, StateRow, ThermalRow, foxglove,
    foxglove::Point,
    schema::{
        CHECK_TOPIC, IMAGE_TOPIC, LOG_TOPIC, PARTICLES_TOPIC, STATE_TOPIC, THERMAL_TOPIC, check_schema, log_schema,
        state_schema, thermal_schema,
    },
};

/// The channels that come with their first message.
#[derive(Default)]
pub(crate) struct EventChannels {
    state: Option<u16>,
    thermal: Option<u16>,
    check: Option<u16>,
    log: Option<u16>,
    image: Option<u16>,
    particles: Option<u16>,
}

/// All methods here take the moment in ns of the capture clock (that of the frames' `wall_ns`), and return
/// a write error once, as [`CaptureWriter`] says.
impl<W: Write> CaptureWriter<W> {
    /// Records how is computed and drawn from here on, and what changed.
    pub fn state(&mut self, wall_ns: u64, state: &StateRow) -> Result<(), CaptureError> {
        self.timed(|this| {
            let channel = match this.events.state {
                Some(channel) => channel,
                None => this.declare(STATE_TOPIC, "brooklet.State", &state_schema())?,
            };
            this.events.state = Some(channel);
            let row = StateRow { wall_s: wall_ns as f64 * 1e-9, ..state.clone() };
            this.message(channel, wall_ns, &row)?;
            this.flush_when_due()
        })
    }

    /// Records what the system tells of heat, clocks and power; nothing if that is nothing.
    pub fn thermal(&mut self, wall_ns: u64, thermal: &ThermalRow) -> Result<(), CaptureError> {
        if thermal.is_empty() {
            return Ok(());
        }
        self.timed(|this| {
            let channel = match this.events.thermal {
                Some(channel) => channel,
                None => this.declare(THERMAL_TOPIC, "brooklet.Thermal", &thermal_schema())?,
            };
            this.events.thermal = Some(channel);
            let row = ThermalRow { wall_s: wall_ns as f64 * 1e-9, ..thermal.clone() };
            this.message(channel, wall_ns, &row)?;
            this.flush_when_due()
        })
    }

    /// Records whether the device gives an answer that is known.
    pub fn check(&mut self, wall_ns: u64, check: &CheckRow) -> Result<(), CaptureError> {
        self.timed(|this| {
            let channel = match this.events.check {
                Some(channel) => channel,
                None => this.declare(CHECK_TOPIC, "brooklet.Check", &check_schema())?,
            };
            this.events.check = Some(channel);
            let row = CheckRow { wall_s: wall_ns as f64 * 1e-9, ..check.clone() };
            this.message(channel, wall_ns, &row)?;
            this.flush_when_due()
        })
    }

    /// Records a line of the log.
    pub fn log(&mut self, wall_ns: u64, level: Level, text: &str) -> Result<(), CaptureError> {
        self.timed(|this| {
            let channel = match this.events.log {
                Some(channel) => channel,
                None => this.declare(LOG_TOPIC, "foxglove.Log", &log_schema())?,
            };
            this.events.log = Some(channel);
            let unix_ns = this.unix_ns(wall_ns);
            let row = json!({
                "timestamp": { "sec": unix_ns / 1_000_000_000, "nsec": unix_ns % 1_000_000_000 },
                "level": level as u8,
                "message": text,
                "name": "brooklet",
                "file": "",
                "line": 0,
            });
            this.message(channel, wall_ns, &row)?;
            this.flush_when_due()
        })
    }

    /// Records a picture: `format` is `png` or `jpeg`, `data` the whole file. About one a second is meant.
    pub fn image(&mut self, wall_ns: u64, format: &str, data: &[u8]) -> Result<(), CaptureError> {
        self.timed(|this| {
            let channel = match this.events.image {
                Some(channel) => channel,
                None => this.declare_protobuf(IMAGE_TOPIC, foxglove::image_schema())?,
            };
            this.events.image = Some(channel);
            let unix_ns = this.unix_ns(wall_ns);
            this.bytes(channel, wall_ns, |buffer| foxglove::image(buffer, unix_ns, format, data))?;
            this.flush_when_due()
        })
    }

    /// Records points: x, y, z in m (y up) and speed in m/s. Some thousands of the particles are meant.
    pub fn particles(&mut self, wall_ns: u64, points: &[Point]) -> Result<(), CaptureError> {
        self.timed(|this| {
            let channel = match this.events.particles {
                Some(channel) => channel,
                None => this.declare_protobuf(PARTICLES_TOPIC, foxglove::points_schema())?,
            };
            this.events.particles = Some(channel);
            let unix_ns = this.unix_ns(wall_ns);
            this.bytes(channel, wall_ns, |buffer| foxglove::points(buffer, unix_ns, points))?;
            this.flush_when_due()
        })
    }
}
