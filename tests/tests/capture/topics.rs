//! Every topic of a capture, its clocks, its counters, its size, and what it says of a device's heat.

use std::{collections::BTreeSet, fs, path::Path, time::Duration, time::UNIX_EPOCH};

use brooklet_capture::{Capture, CaptureCost, CaptureOptions, CaptureWriter, DeviceState, Level, StateRow, ThermalRow};
use brooklet_gpu::{FrameReport, RecordingId, Span, SpanFlag, TimingStatus};
use brooklet_tests::captures::{events::everything, frame_report};

fn options() -> CaptureOptions {
    CaptureOptions { start: UNIX_EPOCH + Duration::from_secs(1_700_000_000), ..CaptureOptions::default() }
}

fn read(bytes: &[u8]) -> Capture {
    Capture::read(std::io::Cursor::new(bytes), bytes.len() as u64, "test.mcap").unwrap()
}

/// Topics and `log_time`s in the order of the file, by the library's own reader.
fn messages(bytes: &[u8]) -> Vec<(String, u64, u64)> {
    let stream = mcap::MessageStream::new(bytes).unwrap().map(Result::unwrap);
    stream.map(|message| (message.channel.topic.clone(), message.log_time, message.publish_time)).collect()
}

#[test]
fn every_topic_is_there_and_one_that_is_not_used_is_not() {
    let bytes = everything();
    let topics: BTreeSet<String> = messages(&bytes).into_iter().map(|(topic, ..)| topic).collect();
    assert_eq!(topics, brooklet_capture::TOPICS.map(String::from).into());
    let capture = read(&bytes);
    assert_eq!(capture.states.len(), 2);
    assert_eq!((capture.states[1].rung, &*capture.states[1].precision), (3, "half"));
    assert_eq!(capture.thermal[0].cpu_c, Some(61.5));
    assert_eq!((&*capture.checks[0].name, &*capture.checks[0].verdict), ("Xsph", "wrong"));

    let mut quiet = Vec::new();
    let mut writer = CaptureWriter::new(&mut quiet, "test.mcap".into(), options()).unwrap();
    writer.frame(&frame_report(0)).unwrap();
    writer.thermal(0, &ThermalRow::default()).unwrap();
    writer.finish().unwrap();
    let text = String::from_utf8_lossy(&quiet).into_owned();
    for topic in ["/gpu/state", "/device/thermal", "/sim/particles", "/view/image", "/log"] {
        assert!(!text.contains(topic), "{topic}");
    }
}

#[test]
fn log_time_never_goes_back_and_what_was_raised_is_counted() {
    let mut bytes = Vec::new();
    let mut writer = CaptureWriter::new(&mut bytes, "test.mcap".into(), options()).unwrap();
    for frame in 0..4 {
        // A state is known at once, a frame's times later.
        writer.state(frame_report(frame).wall_ns + 30_000_000, &StateRow::default()).unwrap();
        writer.frame(&frame_report(frame)).unwrap();
    }
    let totals = writer.finish().unwrap();
    let messages = messages(&bytes);
    assert!(messages.windows(2).all(|pair| pair[0].1 <= pair[1].1), "{messages:?}");
    let raised = messages.iter().filter(|(_, log, publish)| log > publish).count() as u64;
    assert_eq!((raised, totals.trust.log_times_raised), (12, 12), "three messages a frame");
    let publish: Vec<u64> = messages.iter().filter(|m| m.0 == "/gpu/frame").map(|m| m.2).collect();
    assert_eq!(publish, [0, 1, 2, 3].map(|frame| 1_700_000_000_000_000_000 + frame_report(frame).wall_ns));
}

#[test]
fn lies_and_losses_are_counted() {
    let mut bytes = Vec::new();
    let mut writer = CaptureWriter::new(&mut bytes, "test.mcap".into(), options()).unwrap();
    use SpanFlag::*;
    let flags = [Zero, Negative, Negative, Overlapping, Overlapping, Overlapping, Gap, Ok];
    let spans = flags.map(|flag| Span {
        recording: RecordingId::outside("step"),
        stage: "a",
        begin_ticks: 10,
        end_ticks: 90,
        flag,
    });
    let lies = FrameReport { spans: spans.into(), dropped_spans: 5, ..frame_report(0) };
    writer.frame(&lies).unwrap();
    // Frames 1 to 6 are lost; a new engine begins at 0 again, which loses none.
    for frame in [7, 8, 0, 1] {
        writer.frame(&frame_report(frame)).unwrap();
    }
    let trust = writer.finish().unwrap().trust;
    let capture = read(&bytes);
    let row = &capture.frames[0];
    let counts = [row.zero_spans, row.negative_spans, row.overlapping_spans, row.gap_spans, row.flagged_spans];
    assert_eq!((counts, row.dropped_spans), ([1, 2, 3, 1, 7], 5));
    assert!(row.pass_sum_ms > row.gpu_ms);
    assert_eq!(capture.frames.iter().map(|row| row.dropped_frames).collect::<Vec<_>>(), [0, 6, 0, 0, 0]);
    assert_eq!((trust.flagged_spans(), trust.dropped_spans, trust.dropped_frames), (7, 5, 6));
    assert_eq!((trust.frames, trust.sums_over_frame), (5, 1));
    assert_eq!(capture.metadata["trust"], trust.fields().into_iter().map(|(k, v)| (k.to_string(), v)).collect());
    let mut again = brooklet_capture::Trust::default();
    capture.frames.iter().for_each(|row| again.add(row));
    // Which times were raised is known to the writer alone: all of the two frames that begin anew.
    again.log_times_raised = 6;
    assert_eq!(again, trust, "the rows say what the metadata says");
}

#[test]
fn stages_that_come_later_get_their_field() {
    let mut bytes = Vec::new();
    let mut writer = CaptureWriter::new(&mut bytes, "test.mcap".into(), options()).unwrap();
    writer.frame(&frame_report(0)).unwrap();
    let mut overlay = frame_report(1);
    overlay.spans.truncate(1);
    overlay.spans[0].stage = "overlay";
    writer.flush().unwrap();
    writer.frame(&overlay).unwrap();
    writer.frame(&frame_report(2)).unwrap();
    writer.finish().unwrap();
    let capture = read(&bytes);
    assert_eq!(capture.stages, ["count_cells", "scan_groups", "overlay"]);
    assert_eq!(capture.stage_ms("overlay").len(), 1);
    assert_eq!(capture.spans.len(), 7);
    assert_eq!(&*capture.spans[3].stage, "overlay");
}

#[test]
fn cost_and_clocks_are_stated() {
    let mut bytes = Vec::new();
    let mut writer = CaptureWriter::new(&mut bytes, "test.mcap".into(), options()).unwrap();
    writer.cost(&CaptureCost::of_pairs(&[(10.1, 10.0), (20.2, 20.0)]).unwrap()).unwrap();
    (0..3).try_for_each(|frame| writer.frame(&frame_report(frame))).unwrap();
    writer.log(5, Level::Warning, "a line").unwrap();
    writer.finish().unwrap();
    let capture = read(&bytes);
    assert_eq!(capture.metadata["capture_cost"]["share"], "0.010000");
    assert_eq!(capture.metadata["clocks"]["zero_unix_ns"], "1700000000000000000");
    assert_eq!(capture.metadata["ticks"]["at_ticks"], frame_report(0).spans[0].begin_ticks.to_string());
}

/// A frame of `passes` passes, with ticks of 1 ns that jitter.
fn wide_report(frame: u64, passes: u64) -> FrameReport {
    const STAGES: [&str; 10] = [
        "count_cells",
        "reduce_groups",
        "scan_groups",
        "list_neighbours",
        "constrain_density",
        "correct_positions",
        "update_velocity",
        "draw_thickness",
        "draw_sun_depth",
        "draw_water",
    ];
    let begin = 1_234_567_890_123_456 + frame * 16_666_667;
    let span = |pass: u64| {
        let begin_ticks = begin + pass * 400_000 + (frame * 7919 + pass * 104_729) % 9_973;
        let stage: &'static str = Box::leak(format!("{}_{}", STAGES[pass as usize % 10], pass * 7 / 10).into());
        Span {
            recording: RecordingId::outside("step"),
            stage,
            begin_ticks,
            end_ticks: begin_ticks + 380_000 + frame % 977,
            flag: SpanFlag::Ok,
        }
    };
    FrameReport {
        frame,
        wall_ns: frame * 16_666_667,
        spans: (0..passes).map(span).collect(),
        dropped_spans: 0,
        readbacks: Vec::new(),
        timing: TimingStatus::InsidePasses,
        timestamp_period_ns: 1.0,
    }
}

/// Takes bytes and keeps their number.
struct Counted(std::rc::Rc<std::cell::Cell<u64>>);

impl std::io::Write for Counted {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.0.set(self.0.get() + bytes.len() as u64);
        Ok(bytes.len())
    }
    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

#[test]
fn ten_minutes_of_forty_passes_at_60_frames_a_second_stay_under_100_mb() {
    let bytes = std::rc::Rc::new(std::cell::Cell::new(0));
    let options = CaptureOptions { flush_every: Duration::from_secs(3600), ..options() };
    let mut writer = CaptureWriter::new(Counted(bytes.clone()), "test.mcap".into(), options).unwrap();
    let mut report = wide_report(0, 40);
    let pattern: Vec<FrameReport> = (0..16).map(|frame| wide_report(frame, 40)).collect();
    let frames = 36_000;
    for frame in 0..frames {
        report.frame = frame;
        report.wall_ns = frame * 16_666_667;
        for (to, from) in report.spans.iter_mut().zip(&pattern[frame as usize % 16].spans) {
            to.begin_ticks = from.begin_ticks + frame / 16 * 16 * 16_666_667;
            to.end_ticks = from.end_ticks + frame / 16 * 16 * 16_666_667;
        }
        writer.frame(&report).unwrap();
        if frame % 60 == 0 {
            writer.state(report.wall_ns, &StateRow { event: "rung 1".into(), ..StateRow::default() }).unwrap();
            writer.thermal(report.wall_ns, &ThermalRow { cpu_c: Some(61.25), ..ThermalRow::default() }).unwrap();
            writer.flush().unwrap();
        }
    }
    let totals = writer.finish().unwrap();
    println!("{} bytes, {:.1} us of the processor a frame", bytes.get(), 1e3 * totals.capture_ms / frames as f64);
    assert!(bytes.get() < 100_000_000, "{} bytes", bytes.get());
    assert!(bytes.get() > 20_000_000, "{} bytes are too few for what was given", bytes.get());
}

#[test]
fn heat_clocks_and_power_are_read_where_the_system_tells() {
    let folder = tempfile::tempdir().unwrap();
    let sys = folder.path();
    assert!(DeviceState::find_in(sys).read().is_empty(), "nothing is told, nothing is known");
    let write = |path: &str, text: &str| {
        let path = sys.join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, format!("{text}\n")).unwrap();
    };
    write("class/thermal/thermal_zone0/type", "x86_pkg_temp");
    write("class/thermal/thermal_zone0/temp", "61500");
    write("class/thermal/thermal_zone1/type", "battery");
    write("class/thermal/thermal_zone1/temp", "-274000");
    write("class/hwmon/hwmon0/name", "amdgpu");
    write("class/hwmon/hwmon0/temp1_input", "72000");
    write("class/hwmon/hwmon0/temp2_input", "nonsense");
    for (cpu, khz) in [(0, "2000000"), (1, "3000000")] {
        write(&format!("devices/system/cpu/cpu{cpu}/cpufreq/scaling_cur_freq"), khz);
        write(&format!("devices/system/cpu/cpu{cpu}/cpufreq/scaling_governor"), "powersave");
    }
    write("devices/system/cpu/cpufreq/boost", "1");
    write("class/drm/card0/device/hwmon/hwmon3/freq1_input", "1750000000");
    write("class/power_supply/BAT0/type", "Battery");
    write("class/power_supply/BAT0/capacity", "83");
    write("class/power_supply/BAT0/status", "Discharging");
    write("class/power_supply/BAT0/current_now", "2000000");
    write("class/power_supply/BAT0/voltage_now", "11500000");
    write("class/power_supply/AC/type", "Mains");
    write("class/power_supply/AC/online", "0");
    let state = DeviceState::find_in(sys);
    let row = state.read();
    assert_eq!((row.cpu_c, row.gpu_c, row.hottest_c), (Some(61.5), Some(72.0), Some(72.0)));
    assert_eq!((row.cpu_mhz, row.gpu_mhz), (Some(2500.0), Some(1750.0)));
    assert_eq!((row.governor.as_deref(), row.power_source.as_deref()), (Some("powersave"), Some("battery")));
    assert_eq!((row.battery_percent, row.power_w), (Some(83.0), Some(23.0)));
    write("class/power_supply/AC/online", "1");
    assert_eq!(state.read().power_source.as_deref(), Some("mains"), "read anew each time");
    assert!(Path::new("/sys").exists() || DeviceState::find().read().is_empty());
}
