//! A capture opens with an independent reader: the Python package `mcap`.
//!
//! `tools/test` prepares that package and names its Python in `BROOKLET_PYTHON`. Without it the
//! test says that it was skipped, and fails where `BROOKLET_REQUIRE_PYTHON` is set, as in CI.

use brooklet_tests::captures::{
    events::{PICTURE, POINTS, ZERO_NS, everything},
    frame_report,
    python::read_in_python,
};
use serde_json::{Value, json};

#[test]
fn python_reads_the_same_capture() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("test.mcap");
    std::fs::write(&path, everything()).unwrap();
    let frames = 6;

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
        let log_ns = ZERO_NS + report.wall_ns;
        assert_eq!(topics["/gpu/frame"]["log_times"][at], log_ns);
        assert_eq!(topics["/gpu/frame"]["rows"][at]["frame"], frame);
        assert_eq!(topics["/gpu/frame"]["rows"][at]["spans"], 3);
        for (stage, ms, _) in report.stage_ms() {
            let read = passes["rows"][at][format!("{stage}_ms")].as_f64().unwrap();
            assert!((read - ms).abs() <= 0.5e-6, "{stage}: {read} for {ms}");
        }
        assert_eq!(topics["/sim/stats"]["rows"][at]["front_m"], frame as f64 * 0.5);
        let spans = &topics["/gpu/span"]["rows"][at];
        assert_eq!(spans["passes"], json!(["step/count_cells", "step/scan_groups", "step/scan_groups"]));
        for (number, span) in report.spans.iter().enumerate() {
            let first = spans["first_ticks"].as_u64().unwrap();
            let begin = spans["begin_ticks"][number].as_u64().unwrap();
            assert_eq!(first + begin, span.begin_ticks);
            assert_eq!(spans["ticks"][number].as_u64(), Some(span.end_ticks - span.begin_ticks));
        }
    }

    let last_ns = ZERO_NS + frame_report(frames).wall_ns;
    let only = |topic: &str| -> &Value {
        assert_eq!(topics[topic]["log_times"], json!([last_ns]), "{topic}");
        &topics[topic]["rows"][0]
    };
    assert_eq!(topics["/gpu/state"]["rows"][1]["rung_name"], "precision");
    assert_eq!(only("/device/thermal")["cpu_c"], 61.5);
    assert_eq!(only("/log")["message"], "a \"line\"\nof two");
    assert_eq!(only("/log")["level"], 3);
    assert_eq!(topics["/log"]["schema"], "foxglove.Log");
    let image = only("/view/image");
    assert_eq!((&image["format"], &image["unix_ns"]), (&json!("png"), &json!(last_ns)));
    assert_eq!(image["data"], base64(PICTURE));
    let cloud = only("/sim/particles");
    assert_eq!(cloud["names"], json!(["x", "y", "z", "speed"]));
    assert_eq!(cloud["points"], json!(POINTS.map(|point| point.map(f64::from))));

    // The comparison can fail: a file with a changed byte in a message is refused.
    let mut bytes = std::fs::read(&path).unwrap();
    let at = bytes.windows(11).position(|window| window == b"\"front_m\":0").expect("a message with the front");
    bytes[at + 2] = b'x';
    std::fs::write(&path, bytes).unwrap();
    let refused = read_in_python(&path).unwrap().unwrap_err();
    assert!(refused.to_lowercase().contains("crc"), "{refused}");
}

/// As Python's `base64.b64encode` writes it.
fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for part in bytes.chunks(3) {
        let word = part.iter().fold(0_u32, |word, byte| word << 8 | u32::from(*byte)) << (8 * (3 - part.len()));
        for place in 0..4 {
            let is_there = place <= part.len();
            text.push(if is_there { char::from(LETTERS[(word >> (18 - 6 * place)) as usize & 63]) } else { '=' });
        }
    }
    text
}
