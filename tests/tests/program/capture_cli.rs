//! `brooklet capture`: each subcommand on captures of real runs and of made-up ones, and on what is no capture.

use std::{collections::BTreeSet, fs, path::Path};

use brooklet_capture::{Capture, CaptureOptions, CaptureWriter};
use brooklet_gpu::{FrameReport, RecordingId, Span, SpanFlag, TimingStatus};
use brooklet_tests::captures::{events::everything, python::read_in_python};
use brooklet_tests::program::Workshop;

/// A capture of `frames` frames of two stages, of which `solve` takes `factor` times 2 ms.
fn made_up(path: &Path, scene: &str, factor: f64, frames: u64) {
    let mut writer = CaptureWriter::create(path, CaptureOptions::default()).unwrap();
    writer.attach("made-up.toml", "application/toml", scene.as_bytes()).unwrap();
    let mut random = seeded(frames);
    for frame in 0..frames {
        let begin = frame * 16_000_000;
        let mut at = begin;
        let mut span = |stage, ms: f64| {
            let begin_ticks = at;
            at += (ms * 1e6 * (0.98 + 0.04 * random())) as u64;
            Span { recording: RecordingId::outside("step"), stage, begin_ticks, end_ticks: at, flag: SpanFlag::Ok }
        };
        let spans = vec![span("sort", 1.0), span("solve", 2.0 * factor)];
        let report = FrameReport {
            frame,
            wall_ns: begin,
            spans,
            dropped_spans: 0,
            readbacks: Vec::new(),
            timing: TimingStatus::InsidePasses,
            timestamp_period_ns: 1.0,
        };
        writer.frame(&report).unwrap();
    }
    writer.finish().unwrap();
}

/// Seeded numbers from 0 to 1 (Park & Miller 1988).
fn seeded(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed * 7919 + 1;
    move || {
        state = state * 48_271 % 2_147_483_647;
        state as f64 / 2_147_483_647.0
    }
}

#[test]
fn a_real_run_is_summed_checked_exported_and_like_itself() {
    let workshop = Workshop::new();
    workshop.succeed(&["run", "scene.toml", "--steps", "60", "--out", "result"]);
    let file = "result/capture.mcap";
    let capture = Capture::open(&workshop.path(file)).unwrap();
    if let Some(seen) = read_in_python(&workshop.path(file)) {
        seen.expect("a real capture's messages fit their schemas");
    }
    let text = workshop.succeed(&["capture", "summary", file]).stdout;
    for wanted in [
        "device ",
        "scene.toml, plan.json, shaders.json",
        "constrain_density",
        "median ms",
        "trust ",
        "0 dropped; 0 frames dropped",
    ] {
        assert!(text.contains(wanted), "{wanted}: {text}");
    }
    let json = workshop.succeed(&["capture", "summary", file, "--json", "--plot", "passes.svg"]).json();
    assert_eq!(json["trust"]["frames"], 60);
    assert_eq!(json["topics"]["/gpu/frame"], 60);
    let mut solver = capture.stage_ms("constrain_density");
    solver.sort_by(f64::total_cmp);
    let told = json["passes"].as_array().unwrap().iter().find(|pass| pass[0] == "constrain_density").unwrap();
    let median = 0.5 * (solver[29] + solver[30]);
    // Times are kept as f32.
    assert!((told[1]["median"].as_f64().unwrap() / median - 1.0).abs() < 1e-6, "{told} for {median}");
    assert!(fs::read_to_string(workshop.path("passes.svg")).unwrap().contains("constrain_density"));

    workshop.succeed(&["capture", "check", file]);
    assert_eq!(workshop.succeed(&["capture", "check", file, "--json"]).json()["problem_count"], 0);

    let same = workshop.succeed(&["capture", "compare", file, file, "--fail-if-slower", "0%"]).stdout;
    assert!(same.contains("constrain_density") && !same.contains("different") && !same.contains("slower"), "{same}");

    workshop.succeed(&["capture", "export", file, "--csv", "tables", "--chrome-trace", "trace.json"]);
    let frames = fs::read_to_string(workshop.path("tables/gpu-frame.csv")).unwrap();
    assert_eq!(frames.lines().count(), 61);
    assert!(frames.starts_with("log_time_ns,frame,wall_s,gpu_ms,"), "{frames}");
    let spans = fs::read_to_string(workshop.path("tables/gpu-span.csv")).unwrap();
    assert_eq!(spans.lines().count(), capture.spans.len() + 1);
    let trace: serde_json::Value = serde_json::from_slice(&fs::read(workshop.path("trace.json")).unwrap()).unwrap();
    let events = trace["traceEvents"].as_array().unwrap();
    let complete: Vec<_> = events.iter().filter(|event| event["ph"] == "X").collect();
    assert_eq!(complete.len(), capture.spans.len() + 60, "each pass and each frame");
    // Passes lie inside of their frame.
    let mut frame = (0.0, 0.0);
    for event in &complete {
        let (begin, length) = (event["ts"].as_f64().unwrap(), event["dur"].as_f64().unwrap());
        if event["cat"] == "frame" {
            assert!(begin >= frame.0, "frames follow each other");
            frame = (begin, begin + length);
        } else {
            assert!(begin >= frame.0 - 1e-3 && begin + length <= frame.1 + 1e-3, "{event} in {frame:?}");
        }
    }
    assert!(events.iter().any(|event| event["ph"] == "C"), "statistics are counters");
    // What is there is kept.
    workshop.succeed(&["capture", "export", file, "--csv", "tables"]);
    assert!(workshop.has("tables-1/gpu-frame.csv"));
}

/// Topics and fields that a schema declares.
fn declared(bytes: &[u8], into: &mut BTreeSet<String>) {
    for message in mcap::MessageStream::new(bytes).unwrap() {
        let channel = message.unwrap().channel;
        into.insert(channel.topic.clone());
        let schema = channel.schema.as_ref().unwrap();
        if schema.encoding == "jsonschema" {
            let schema: serde_json::Value = serde_json::from_slice(&schema.data).unwrap();
            let fields = schema["properties"].as_object().unwrap().keys();
            into.extend(fields.map(|field| format!("{}.{field}", channel.topic)));
        }
    }
}

#[test]
fn each_path_of_the_layout_is_in_a_capture() {
    let workshop = Workshop::new();
    workshop.succeed(&["run", "scene.toml", "--steps", "4", "--images", "1", "--out", "result"]);
    let mut known = BTreeSet::new();
    declared(&fs::read(workshop.path("result/capture.mcap")).unwrap(), &mut known);
    declared(&everything(), &mut known);
    let layout = brooklet_tests::top().join("app/capture/foxglove-layout.json");
    let layout: serde_json::Value = serde_json::from_slice(&fs::read(layout).unwrap()).unwrap();
    let panels = layout["configById"].as_object().unwrap();
    let mut wanted = BTreeSet::new();
    for panel in panels.values() {
        let paths = panel["paths"].as_array().into_iter().flatten().map(|path| path["value"].as_str().unwrap());
        wanted.extend(paths.map(String::from));
        let topics = panel["topics"].as_object().into_iter().flat_map(|topics| topics.keys().cloned());
        wanted.extend(topics);
        let one = [&panel["topicToRender"], &panel["imageMode"]["imageTopic"]];
        wanted.extend(one.into_iter().filter_map(|topic| topic.as_str()).map(String::from));
    }
    let missing: Vec<_> = wanted.difference(&known).collect();
    assert!(missing.is_empty(), "{missing:?} are in no capture, which have {known:?}");
    for topic in ["/gpu/passes.", "/gpu/state.", "/sim/particles", "/view/image", "/log"] {
        assert!(wanted.iter().any(|path| path.starts_with(topic)), "the layout has nothing of {topic}");
    }
    // Each panel is shown once, and each that is shown is described.
    fn shown<'l>(part: &'l serde_json::Value, into: &mut Vec<&'l str>) {
        match part.as_str() {
            Some(panel) => into.push(panel),
            None => ["first", "second"].iter().for_each(|side| shown(&part[side], into)),
        }
    }
    let mut all = Vec::new();
    shown(&layout["layout"], &mut all);
    assert_eq!(all.len(), panels.len());
    assert!(all.iter().all(|panel| panels.contains_key(*panel)), "{all:?}");
}

#[test]
fn a_slowdown_ends_with_exit_code_1_and_a_difference_of_scenes_with_2() {
    let workshop = Workshop::new();
    made_up(&workshop.path("a.mcap"), "x = 1\n", 1.0, 300);
    made_up(&workshop.path("b.mcap"), "x = 1\n", 1.15, 310);
    made_up(&workshop.path("c.mcap"), "x = 2\n", 1.0, 320);
    let slower = workshop.run(&["capture", "compare", "a.mcap", "b.mcap", "--fail-if-slower", "5%", "--plot", "r.svg"]);
    assert_eq!(slower.code, Some(1), "{}", slower.stderr);
    assert!(
        slower.stderr.contains("slower by more than 5.0 %") && slower.stderr.contains("solve +1"),
        "{}",
        slower.stderr
    );
    assert!(!slower.stderr.contains("sort"), "{}", slower.stderr);
    assert!(fs::read_to_string(workshop.path("r.svg")).unwrap().contains("solve"));
    workshop.succeed(&["capture", "compare", "a.mcap", "b.mcap", "--fail-if-slower", "20%"]);
    workshop.succeed(&["capture", "compare", "b.mcap", "a.mcap", "--fail-if-slower", "0%"]);
    let json = workshop.succeed(&["capture", "compare", "a.mcap", "b.mcap", "--json"]).json();
    assert_eq!(json["passes"].as_array().unwrap().len(), 3, "the frame and two passes");
    assert_eq!(json["passes"][2]["verdict"], "slower");

    let other = workshop.run(&["capture", "compare", "a.mcap", "c.mcap"]);
    assert_eq!(other.code, Some(2));
    assert!(
        other.stderr.contains("different scenes: made-up.toml, with other settings: `x = 1` and `x = 2`"),
        "{}",
        other.stderr
    );
    let anyway = workshop.succeed(&["capture", "compare", "a.mcap", "c.mcap", "--anyway"]).stdout;
    assert!(anyway.contains("different scenes") && anyway.contains("of different work"), "{anyway}");
}

#[test]
fn what_is_cut_is_recovered_and_what_is_no_capture_is_refused() {
    let workshop = Workshop::new();
    let whole = everything();
    fs::write(workshop.path("cut.mcap"), &whole[..whole.len() * 3 / 4]).unwrap();
    let checked = workshop.run(&["capture", "check", "cut.mcap"]);
    assert_eq!(checked.code, Some(1), "{}", checked.stderr);
    assert!(workshop.succeed(&["capture", "summary", "cut.mcap"]).stdout.starts_with("incomplete: "));
    let told = workshop.succeed(&["capture", "recover", "cut.mcap"]).stdout;
    assert!(told.contains("cut-recovered.mcap") && told.contains("lost: "), "{told}");
    workshop.succeed(&["capture", "check", "cut-recovered.mcap"]);
    let again = workshop.run(&["capture", "recover", "cut.mcap"]);
    assert_eq!(again.code, Some(2));
    assert!(again.stderr.contains("cut-recovered.mcap exists and is kept"), "{}", again.stderr);
    assert_eq!(fs::read(workshop.path("cut.mcap")).unwrap().len(), whole.len() * 3 / 4, "the input is as it was");

    fs::write(workshop.path("empty.mcap"), b"").unwrap();
    fs::write(workshop.path("foreign.mcap"), b"\x89PNG\r\n\x1a\n....").unwrap();
    fs::write(workshop.path("magic.mcap"), mcap::MAGIC).unwrap();
    let mut other = mcap::Writer::new(std::io::Cursor::new(Vec::new())).unwrap();
    other.add_channel(0, "/camera", "json", &Default::default()).unwrap();
    other.finish().unwrap();
    fs::write(workshop.path("camera.mcap"), other.into_inner().into_inner()).unwrap();
    let version = "format_version\u{1}\0\0\x002";
    let mut newer = whole.clone();
    for at in 0..newer.len() - version.len() {
        if newer[at..].starts_with(version.as_bytes()) {
            newer[at + version.len() - 1] = b'3';
        }
    }
    for record in brooklet_tests::captures::chunk_starts(&newer) {
        newer[record + 9 + 24..record + 9 + 28].fill(0);
    }
    fs::write(workshop.path("newer.mcap"), newer).unwrap();
    for (file, wanted) in [
        ("empty.mcap", "empty.mcap: not an MCAP file: it starts with nothing (it is empty)"),
        ("foreign.mcap", "foreign.mcap: not an MCAP file: it starts with 89 50 4e 47"),
        ("camera.mcap", "camera.mcap: an MCAP file without any topic of a capture (its topics: /camera"),
        ("newer.mcap", "newer.mcap: /gpu/frame has format version 3, and this program reads version 2"),
        ("missing.mcap", "missing.mcap: cannot open: "),
        (".", ".: cannot read: it is no file"),
    ] {
        let calls: [&[&str]; 5] = [
            &["summary", file],
            &["check", file],
            &["compare", file, "cut.mcap"],
            &["recover", file, "--out", "left.mcap"],
            &["export", file, "--chrome-trace", "left.json", "--csv", "left"],
        ];
        for call in calls {
            let ended = workshop.run(&[&["capture"], call].concat());
            assert_eq!(ended.code, Some(2), "{call:?}: {}", ended.stderr);
            assert!(ended.stderr.contains(wanted) && ended.stderr.lines().count() == 1, "{call:?}: {}", ended.stderr);
        }
        assert!(!workshop.has("left.mcap") && !workshop.has("left.json") && !workshop.has("left"), "{file}");
    }
    let nothing = workshop.run(&["capture", "recover", "magic.mcap"]);
    assert_eq!(nothing.code, Some(1), "{}", nothing.stderr);
    assert!(nothing.stderr.contains("nothing whole is left of it"), "{}", nothing.stderr);
    let few = workshop.run(&["capture", "compare", "cut.mcap", "cut.mcap"]);
    assert_eq!(few.code, Some(2));
    assert!(few.stderr.contains("nothing can be compared"), "{}", few.stderr);
    for share in ["-5%", "five", "1e9"] {
        assert_eq!(workshop.run(&["capture", "compare", "a", "b", "--fail-if-slower", share]).code, Some(2));
    }
    assert_eq!(workshop.run(&["capture", "export", "cut.mcap"]).code, Some(2), "says no format");
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_while_exporting_is_said() {
    let workshop = Workshop::new();
    made_up(&workshop.path("a.mcap"), "x = 1\n", 1.0, 3000);
    for call in ["export a.mcap --csv tables", "export a.mcap --chrome-trace t.json", "recover a.mcap --out r.mcap"] {
        let limited = format!("ulimit -f 64; trap '' XFSZ; exec \"$0\" capture {call}");
        let output = std::process::Command::new("bash")
            .args(["-c", &limited])
            .arg(brooklet_tests::program::program())
            .current_dir(workshop.path("."))
            .output()
            .unwrap();
        let stderr = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{call}: {stderr}");
        assert!(stderr.contains("File too large"), "{call}: {stderr}");
    }
    let left: Vec<_> = fs::read_dir(workshop.path(".")).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(left.len(), 2, "the scene and the capture alone: {left:?}");
}
