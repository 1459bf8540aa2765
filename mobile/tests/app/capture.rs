//! Captures that are taken in the app.

use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::Stdio;
use std::time::{Duration, Instant};

use brooklet_capture::Capture;

use crate::python::read_in_python;
use crate::{LONG, SIZE_PX, app, in_own_process, mark_checked, own_folder, running, said, started};

/// `/device/thermal` comes where the system tells temperatures: not on every machine.
const TOPICS: [&str; 8] =
    ["/gpu/frame", "/gpu/passes", "/gpu/span", "/gpu/state", "/sim/stats", "/sim/particles", "/view/image", "/log"];

fn captures(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = std::fs::read_dir(folder.join("files")) else { return Vec::new() };
    let paths = entries.map(|entry| entry.unwrap().path());
    paths.filter(|path| path.extension().is_some_and(|ending| ending == "mcap")).collect()
}

fn read(path: &Path) -> Capture {
    let length = std::fs::metadata(path).unwrap().len();
    Capture::read(File::open(path).unwrap(), length, "capture").unwrap()
}

#[test]
fn a_capture_has_every_topic_and_what_is_flushed_is_there_before_its_end() {
    let (mut hand, folder) = running();
    assert!(hand.steps(2, LONG));
    hand.tap("capture").unwrap();
    let begun = Instant::now();
    assert!(hand.until(LONG, |_| begun.elapsed() > Duration::from_millis(1500)));
    assert!(hand.steps(4, LONG));
    let [path]: [PathBuf; 1] = captures(folder.path()).try_into().unwrap();
    hand.app.suspend();
    let in_background = read(&path);
    assert!(in_background.frames.len() > 2, "{} frames are in the file", in_background.frames.len());
    hand.app.resume_offscreen(SIZE_PX, 1.0);
    assert!(hand.steps(2, LONG));
    hand.tap("capture").unwrap();
    assert!(hand.app.viewer().unwrap().capture().is_none());
    let whole = read(&path);
    assert!(whole.frames.len() > in_background.frames.len());

    let Some(seen) = read_in_python("../tests/read_capture.py", &path) else { return };
    let seen = seen.unwrap();
    let has = |topic: &str| seen["topics"][topic]["rows"].as_array().is_some_and(|rows| !rows.is_empty());
    let missing: Vec<&str> = TOPICS.into_iter().filter(|topic| !has(topic)).collect();
    assert!(
        missing.is_empty(),
        "{missing:?} of {:?}",
        seen["topics"].as_object().map(|topics| topics.keys().cloned().collect::<Vec<_>>())
    );
    assert!(!has("/nobody/s"));
    assert_eq!(seen["metadata"]["build"]["program"], "brooklet mobile");
    assert!(seen["metadata"]["self_check"]["summary"].as_str().is_some_and(|text| text.contains("right")));
}

#[test]
#[ignore = "run by an_app_that_is_killed_leaves_its_capture, in a process of its own"]
fn captures_until_it_is_killed() {
    let folder = own_folder();
    mark_checked(&folder);
    let mut hand = started(app(&folder));
    assert!(hand.steps(1, LONG));
    hand.tap("capture").unwrap();
    loop {
        hand.steps(1, LONG);
    }
}

#[test]
fn an_app_that_is_killed_leaves_its_capture() {
    let folder = tempfile::tempdir().unwrap();
    let mut child =
        in_own_process("capture::captures_until_it_is_killed", folder.path()).stdout(Stdio::null()).spawn().unwrap();
    let begun = Instant::now();
    let frames = || {
        captures(folder.path()).first().map_or(0, |path| {
            let length = std::fs::metadata(path).unwrap().len();
            Capture::read(File::open(path).unwrap(), length, "capture").map_or(0, |capture| capture.frames.len())
        })
    };
    while frames() < 3 && begun.elapsed() < LONG {
        std::thread::sleep(Duration::from_millis(200));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(frames() >= 3, "{} frames", frames());
    // A file that is none is seen.
    let broken = folder.path().join("broken.mcap");
    std::fs::write(&broken, b"no capture").unwrap();
    assert!(Capture::read(File::open(&broken).unwrap(), 10, "broken").is_err());
}

#[test]
fn a_folder_that_cannot_be_written_is_named_and_the_water_goes_on() {
    let folder = tempfile::tempdir().unwrap();
    mark_checked(folder.path());
    let mut hand = started(app(folder.path()));
    std::fs::remove_dir_all(folder.path().join("files")).unwrap();
    std::fs::write(folder.path().join("files"), b"a file where the folder was").unwrap();
    hand.tap("capture").unwrap();
    let name = folder.path().join("files").display().to_string();
    assert!(said(&hand).iter().any(|text| text.contains(&name)), "{:?}", said(&hand));
    assert!(hand.app.viewer().unwrap().capture().is_none());
    assert!(hand.steps(1, LONG), "it goes on");
}
