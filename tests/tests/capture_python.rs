//! A capture opens with an independent reader: the Python package `mcap`.
//!
//! `tools/test` prepares that package and names its Python in `BROOKLET_PYTHON`. Without it the
//! test says that it was skipped, and fails where `BROOKLET_REQUIRE_PYTHON` is set, as in CI.

mod capture_support;

use std::time::Duration;

use brooklet_capture::{CaptureOptions, CaptureWriter, StatField};
use capture_support::{frame_report, python::read_in_python};
use serde_json::json;

#[test]
fn python_reads_the_same_capture() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("test.mcap");
    let options = CaptureOptions {
        stages: vec!["count_cells".into(), "scan_groups".into(), "idle".into()],
        stats: vec![StatField::new("front_m", "m", "Largest x")],
        start: std::time::UNIX_EPOCH + Duration::from_secs(1_700_000_000),
        flush_every: Duration::ZERO,
    };
    let mut writer = CaptureWriter::create(&path, options).unwrap();
    writer.metadata("build", [("version", "0.1.0".to_string())]).unwrap();
    writer.attach("scene.toml", "application/toml", b"spacing_m = 0.02\n").unwrap();
    let frames = 4;
    for frame in 0..frames {
        let report = frame_report(frame);
        writer.frame(&report).unwrap();
        writer.stats(frame, report.wall_ns, &[frame as f64 * 0.5]).unwrap();
    }
    writer.finish().unwrap();

    let Some(seen) = read_in_python(&path) else {
        return;
    };
    let seen = seen.unwrap();
    assert_eq!(seen["metadata"]["build"]["version"], "0.1.0");
    assert_eq!(seen["attachments"]["scene.toml"], "spacing_m = 0.02\n");
    assert!(seen["chunks"].as_u64().unwrap() >= frames);
    let topics = &seen["topics"];
    let passes = &topics["/gpu/passes"];
    assert_eq!(
        passes["fields"],
        json!(["frame", "wall_s", "count_cells_ms", "scan_groups_ms", "idle_ms"]),
        "the schema names every stage of the plan"
    );
    for frame in 0..frames {
        let (at, report) = (frame as usize, frame_report(frame));
        let log_ns = 1_700_000_000_000_000_000 + report.wall_ns;
        assert_eq!(topics["/gpu/frame"]["log_times"][at], log_ns);
        assert_eq!(topics["/gpu/frame"]["rows"][at]["frame"], frame);
        assert_eq!(topics["/gpu/frame"]["rows"][at]["spans"], 3);
        for (stage, ms, _) in report.stage_ms() {
            assert_eq!(passes["rows"][at][format!("{stage}_ms")], ms);
        }
        assert_eq!(topics["/sim/stats"]["rows"][at]["front_m"], frame as f64 * 0.5);
        let span = &topics["/gpu/span"]["rows"][at * 3];
        assert_eq!(span["begin_ticks"], report.spans[0].begin_ticks);
        assert_eq!(span["end_ticks"], report.spans[0].end_ticks);
    }

    // The comparison can fail: a file with a changed byte in a message is refused.
    let mut bytes = std::fs::read(&path).unwrap();
    let at = bytes.windows(11).position(|window| window == b"\"front_m\":0").expect("a message with the front");
    bytes[at + 2] = b'x';
    std::fs::write(&path, bytes).unwrap();
    let refused = read_in_python(&path).unwrap().unwrap_err();
    assert!(refused.to_lowercase().contains("crc"), "{refused}");
}
