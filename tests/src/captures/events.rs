//! A capture with a message on every topic.

use std::time::{Duration, UNIX_EPOCH};

use brooklet_capture::{CaptureOptions, CaptureWriter, CheckRow, Level, Point, StatField, StateRow, ThermalRow};

use super::frame_report;

/// Unix time of the capture's zero, ns.
pub const ZERO_NS: u64 = 1_700_000_000_000_000_000;
/// What stands for a picture.
pub const PICTURE: &[u8] = b"\x89PNG\r\n\x1a\nnot really";
/// The points that are written.
pub const POINTS: [Point; 3] = [[0.0, 1.0, 2.0, 0.5], [-1.5, 0.25, 1e-3, 3.0], [7.0, 8.0, 9.0, 0.0]];

/// Six frames, one a chunk, and everything else at least once.
pub fn everything() -> Vec<u8> {
    let mut bytes = Vec::new();
    let options = CaptureOptions {
        stages: vec!["count_cells".into(), "scan_groups".into(), "idle".into()],
        stats: vec![StatField::new("front_m", "m", "Largest x")],
        start: UNIX_EPOCH + Duration::from_nanos(ZERO_NS),
        flush_every: Duration::ZERO,
        ..CaptureOptions::default()
    };
    let mut writer = CaptureWriter::new(&mut bytes, "test.mcap".into(), options).unwrap();
    writer.metadata("build", [("version", "0.1.0".to_string())]).unwrap();
    writer.attach("scene.toml", "application/toml", b"spacing_m = 0.02\n").unwrap();
    let state = StateRow {
        event: "begun".into(),
        tier: "desktop".into(),
        precision: "full".into(),
        surface: "screen-space".into(),
        rung_name: "full quality".into(),
        ..StateRow::default()
    };
    writer.state(0, &state).unwrap();
    for frame in 0..6 {
        let report = frame_report(frame);
        writer.frame(&report).unwrap();
        writer.stats(frame, report.wall_ns, &[frame as f64 * 0.5]).unwrap();
    }
    let now_ns = frame_report(6).wall_ns;
    let half = StateRow {
        event: "precision half: 21 ms a frame".into(),
        precision: "half".into(),
        rung: 3,
        rung_name: "precision".into(),
        paused: true,
        particles: Some(27_000),
        render_scale: Some(0.5),
        ..state
    };
    writer.state(now_ns, &half).unwrap();
    let warm = ThermalRow { cpu_c: Some(61.5), governor: Some("powersave".into()), ..ThermalRow::default() };
    writer.thermal(now_ns, &warm).unwrap();
    let checked = CheckRow { of: "module".into(), name: "Xsph".into(), verdict: "wrong".into(), ..CheckRow::default() };
    writer.check(now_ns, &checked).unwrap();
    writer.log(now_ns, Level::Warning, "a \"line\"\nof two").unwrap();
    writer.image(now_ns, "png", PICTURE).unwrap();
    writer.particles(now_ns, &POINTS).unwrap();
    writer.finish().unwrap();
    bytes
}
