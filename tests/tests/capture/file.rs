//! A capture gives back what was written, also when it was cut, damaged, or the disk ran full.

use std::{
    cell::RefCell,
    io::{Error, ErrorKind, Write},
    rc::Rc,
    time::{Duration, UNIX_EPOCH},
};

use brooklet_capture::{Capture, CaptureError, CaptureOptions, CaptureWriter, StatField};
use brooklet_tests::captures::{self as support, frame_report};

/// A disk with room for a number of bytes; what it holds can be looked at from outside.
#[derive(Clone)]
struct Disk {
    bytes: Rc<RefCell<Vec<u8>>>,
    room: usize,
}

impl Disk {
    fn new(room: usize) -> Self {
        Self { bytes: Rc::default(), room }
    }
}

impl Write for Disk {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        let mut held = self.bytes.borrow_mut();
        let fits = bytes.len().min(self.room - held.len());
        if fits == 0 && !bytes.is_empty() {
            return Err(Error::from(ErrorKind::StorageFull));
        }
        held.extend(&bytes[..fits]);
        Ok(fits)
    }
    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

fn options() -> CaptureOptions {
    CaptureOptions {
        stages: vec!["count_cells".into(), "scan_groups".into(), "idle".into()],
        stats: vec![
            StatField::new("front_m", "m", "Largest x"),
            StatField::new("density_error", "1", "Mean of |rho/rho0 - 1|"),
        ],
        start: UNIX_EPOCH + Duration::from_secs(1_700_000_000),
        // A chunk a frame, so that a small file has many.
        flush_every: Duration::ZERO,
        ..CaptureOptions::default()
    }
}

const FRAMES: u64 = 6;

/// Writes the test's capture as far as the disk takes it; the errors met, and whether `finish`
/// said that all was written.
fn write(disk: &Disk) -> (Vec<CaptureError>, bool) {
    let mut errors = Vec::new();
    let mut writer = match CaptureWriter::new(disk.clone(), "test.mcap".into(), options()) {
        Ok(writer) => writer,
        Err(error) => return (vec![error], false),
    };
    let mut keep = |result: Result<(), CaptureError>| errors.extend(result.err());
    keep(writer.metadata("build", [("version", "0.1.0".to_string())]));
    keep(writer.attach("scene.toml", "application/toml", b"spacing_m = 0.02\n"));
    for frame in 0..FRAMES {
        keep(writer.frame(&frame_report(frame)));
        keep(writer.stats(frame, frame * 1000, &[frame as f64 * 0.5, f64::NAN]));
    }
    match writer.finish() {
        Ok(totals) => (errors, totals.complete),
        Err(error) => {
            errors.push(error);
            (errors, false)
        }
    }
}

fn whole() -> Vec<u8> {
    let disk = Disk::new(usize::MAX);
    let (errors, complete) = write(&disk);
    assert!(errors.is_empty() && complete, "{errors:?}");
    disk.bytes.take()
}

fn read(bytes: &[u8]) -> Result<Capture, CaptureError> {
    Capture::read(std::io::Cursor::new(bytes), bytes.len() as u64, "test.mcap")
}

#[test]
fn raw_ticks_may_be_of_every_so_many_frames() {
    let disk = Disk::new(usize::MAX);
    let options = CaptureOptions { spans_every: 4, ..options() };
    let mut writer = CaptureWriter::new(disk.clone(), "test.mcap".into(), options).unwrap();
    for frame in 0..FRAMES {
        writer.frame(&frame_report(frame)).unwrap();
    }
    writer.finish().unwrap();
    let capture = read(&disk.bytes.take()).unwrap();
    assert_eq!((capture.frames.len(), capture.passes.len()), (FRAMES as usize, FRAMES as usize));
    let with_ticks: std::collections::BTreeSet<u64> = capture.spans.iter().map(|span| span.frame).collect();
    assert_eq!(with_ticks, [0, 4].into());
}

#[test]
fn what_was_written_is_read() {
    let capture = read(&whole()).unwrap();
    assert!(capture.complete);
    assert_eq!(capture.frames.len(), FRAMES as usize);
    assert_eq!(capture.stages, ["count_cells", "scan_groups", "idle"]);
    assert_eq!(capture.stat_fields, options().stats);
    assert_eq!(capture.metadata["build"]["version"], "0.1.0");
    assert_eq!(capture.attachments[0].data, b"spacing_m = 0.02\n");
    for frame in 0..FRAMES {
        let report = frame_report(frame);
        let row = &capture.frames[frame as usize];
        assert_eq!((row.frame, row.spans), (frame, report.spans.len() as u32));
        assert_eq!(row.gpu_ms, report.gpu_ms());
        assert_eq!(row.wall_s, report.wall_ns as f64 * 1e-9);
        assert!(row.capture_ms >= 0.0 && row.capture_ms < 10_000.0);
        let passes = &capture.passes[frame as usize].stage_ms;
        assert_eq!(passes.len(), report.stage_ms().len());
        for (stage, ms, _) in report.stage_ms() {
            // Half of a nanosecond, to which times are rounded.
            assert!((passes[stage] - ms).abs() <= 0.5e-6, "frame {frame}, {stage}");
        }
        let sum: f64 = report.stage_ms().iter().map(|(_, ms, _)| ms).sum();
        assert_eq!(row.pass_sum_ms, Some(sum));
        let spans: Vec<_> = capture.spans.iter().filter(|s| s.frame == frame).collect();
        assert_eq!(spans.len(), report.spans.len());
        for (read, written) in spans.iter().zip(&report.spans) {
            assert_eq!((read.begin_ticks, read.end_ticks), (written.begin_ticks, written.end_ticks));
            assert_eq!((&*read.recording, &*read.stage), (written.recording.label(), written.stage));
        }
        let stats = &capture.stats[frame as usize].values;
        assert_eq!(stats["front_m"], frame as f64 * 0.5);
        assert!(!stats.contains_key("density_error"), "NaN leaves a gap");
    }
    let flagged: u32 = capture.frames.iter().map(|row| row.flagged_spans).sum();
    let odd = capture.spans.iter().filter(|span| span.flag != "ok").count();
    assert_eq!(flagged as usize, odd);
    assert!(odd > 0, "the reports hold a flagged span");
}

#[test]
fn a_file_cut_at_any_byte_gives_every_complete_chunk() {
    let bytes = whole();
    let records = support::records(&bytes);
    assert!(
        records.iter().filter(|r| r.opcode == support::CHUNK).count() >= 2 * FRAMES as usize,
        "a chunk for every frame and every measurement"
    );
    for cut in 0..bytes.len() {
        let result = read(&bytes[..cut]);
        if cut < mcap::MAGIC.len() {
            assert!(matches!(result, Err(CaptureError::NotMcap { .. })), "cut {cut}");
            continue;
        }
        let capture = result.unwrap_or_else(|error| panic!("cut {cut}: {error}"));
        let expected: usize = records.iter().filter(|record| record.end <= cut).map(|record| record.messages).sum();
        assert_eq!(support::messages(&capture), expected, "cut {cut} of {}", bytes.len());
        assert!(!capture.complete, "cut {cut}");
    }
}

#[test]
fn a_full_disk_is_said_once_and_leaves_a_readable_capture() {
    // Two captures differ by some bytes: the time that capturing took is written in decimals.
    let length = whole().len() - 200;
    for room in (0..length).step_by(19) {
        let disk = Disk::new(room);
        let (errors, complete) = write(&disk);
        assert_eq!(errors.len(), 1, "room {room}: {errors:?}");
        let message = errors[0].to_string();
        assert!(message.contains("test.mcap"), "{message}");
        assert!(message.contains("no storage space"), "{message}");
        assert!(!complete, "room {room}");
        let held = disk.bytes.take();
        if room >= mcap::MAGIC.len() {
            let expected: usize = support::records(&held).iter().map(|record| record.messages).sum();
            let capture = read(&held).unwrap();
            assert_eq!(support::messages(&capture), expected, "room {room}");
        }
    }
}

#[test]
fn damaged_bytes_never_panic_and_never_give_a_wrong_frame() {
    let bytes = whole();
    let sound = read(&bytes).unwrap();
    for at in (mcap::MAGIC.len()..bytes.len()).step_by(3) {
        let mut damaged = bytes.clone();
        damaged[at] ^= 0x40;
        let Ok(capture) = read(&damaged) else {
            continue;
        };
        // Chunks carry a checksum: a damaged one is missing as a whole.
        let known = |row| sound.frames.contains(row);
        assert!(capture.frames.iter().all(known), "byte {at}");
        assert!(capture.spans.iter().all(|row| sound.spans.contains(row)), "byte {at}");
        let lost = capture.frames.len() < sound.frames.len();
        assert!(!(lost && capture.complete), "byte {at}: a loss that nobody is told of");
    }
}

#[test]
fn other_files_are_refused_in_words() {
    let name = |bytes: &[u8]| read(bytes).unwrap_err().to_string();
    assert!(name(b"").contains("test.mcap: not an MCAP file: it starts with nothing"));
    assert!(name(b"\x89PNG\r\n\x1a\n....").contains("89 50 4e 47"));

    let mut other = mcap::Writer::new(std::io::Cursor::new(Vec::new())).unwrap();
    other.add_channel(0, "/camera", "json", &Default::default()).unwrap();
    other.finish().unwrap();
    let message = name(&other.into_inner().into_inner());
    assert!(message.contains("/camera") && message.contains("/gpu/frame"), "{message}");

    let missing = Capture::open("no/such.mcap".as_ref()).unwrap_err().to_string();
    assert!(missing.contains("no/such.mcap: cannot open"), "{missing}");
}

#[test]
fn wrong_use_is_refused_in_words() {
    let disk = Disk::new(usize::MAX);
    let mut writer = CaptureWriter::new(disk.clone(), "test.mcap".into(), options()).unwrap();
    let error = writer.stats(0, 0, &[1.0]).unwrap_err().to_string();
    assert!(error.contains("1 statistics were given, 2 are declared"), "{error}");

    for name in ["frame", "wall_s", "front_m"] {
        let mut wrong = options();
        wrong.stats.push(StatField::new(name, "1", "taken"));
        let error = CaptureWriter::new(disk.clone(), "test.mcap".into(), wrong).err().expect("a name that is taken");
        assert!(error.to_string().contains(name), "{error}");
    }
}

#[test]
fn without_statistics_there_is_no_such_topic() {
    let disk = Disk::new(usize::MAX);
    let mut none = options();
    none.stats.clear();
    let mut writer = CaptureWriter::new(disk.clone(), "test.mcap".into(), none).unwrap();
    writer.frame(&frame_report(0)).unwrap();
    writer.stats(0, 0, &[]).unwrap();
    writer.finish().unwrap();
    let bytes = disk.bytes.take();
    assert!(read(&bytes).unwrap().stats.is_empty());
    let text = String::from_utf8_lossy(&bytes).into_owned();
    assert!(!text.contains("/sim/stats"));
}
