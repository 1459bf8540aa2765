//! Runs that end early, by Ctrl-C, a kill or a full disk: what there is of them is closed, told
//! and readable.
#![cfg(unix)]

use std::{
    process::{Child, Command, Stdio},
    thread,
    time::{Duration, Instant},
};

use brooklet_capture::Capture;
use brooklet_tests::full_disk::{full_disks, run_on};
use brooklet_tests::program::{Ended, Workshop};

/// Starts a run, and waits until `begun` says that it is under way.
fn started(workshop: &Workshop, arguments: &[&str], begun: impl Fn() -> bool) -> Child {
    let mut child =
        workshop.command(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program starts");
    let waiting = Instant::now();
    while !begun() {
        assert!(waiting.elapsed() < Duration::from_secs(60), "nothing in a minute");
        assert!(child.try_wait().unwrap().is_none(), "the run ended by itself");
        thread::sleep(Duration::from_millis(50));
    }
    child
}

fn send(child: &Child, signal: &str) {
    let kill = Command::new("kill").args([signal, &child.id().to_string()]).status();
    assert!(kill.expect("kill is there").success());
}

/// Starts a run without end, waits until its capture has frames, and sends it `signal`.
fn signalled(workshop: &Workshop, signal: &str) -> Ended {
    let arguments = ["run", "scene.toml", "--steps", "100000000", "--out", "long"];
    let child = started(workshop, &arguments, || {
        Capture::open(&workshop.path("long/capture.mcap")).is_ok_and(|capture| !capture.frames.is_empty())
    });
    send(&child, signal);
    Ended::new(child.wait_with_output().unwrap())
}

#[test]
fn ctrl_c_and_a_request_to_end_are_followed_in_order() {
    for signal in ["-INT", "-TERM"] {
        ends_in_order(signal);
    }
}

fn ends_in_order(signal: &str) {
    let workshop = Workshop::new();
    let ended = signalled(&workshop, signal);
    assert_eq!(ended.code, Some(130), "{}", ended.stderr);
    assert!(ended.stderr.contains("interrupted") && ended.stderr.contains("long"), "{}", ended.stderr);
    let summary = workshop.json("long/summary.json");
    let steps = summary["steps"].as_u64().unwrap();
    assert_eq!(summary["interrupted"], true);
    assert!(steps > 0 && steps < 100_000_000);
    let capture = Capture::open(&workshop.path("long/capture.mcap")).unwrap();
    assert!(capture.complete);
    assert_eq!(capture.frames.len() as u64, steps, "every step that was done is captured");
}

#[test]
fn a_killed_run_leaves_a_readable_capture() {
    let workshop = Workshop::new();
    let ended = signalled(&workshop, "-KILL");
    assert_eq!(ended.code, None);
    assert!(!workshop.has("long/summary.json"));
    let capture = Capture::open(&workshop.path("long/capture.mcap")).unwrap();
    assert!(!capture.complete && !capture.frames.is_empty());
    assert!(!capture.metadata["device"].is_empty());
}

#[test]
fn a_second_ctrl_c_ends_at_once() {
    let workshop = Workshop::new();
    // Two substeps of 50 iterations of 64,000 particles take seconds, and the first Ctrl-C waits for their end.
    let slow = ["--set", "spacing_m=0.005", "--set", "solver.substeps=2", "--set", "solver.pbf.iterations=50"];
    let arguments = [&["run", "scene.toml", "--steps", "1000", "--out", "slow"], &slow[..]].concat();
    let child = started(&workshop, &arguments, || workshop.has("slow/capture.mcap"));
    // The capture is there before the first step: one that is not under way yet would never begin, and all end in order.
    thread::sleep(Duration::from_millis(500));
    send(&child, "-INT");
    thread::sleep(Duration::from_millis(50));
    send(&child, "-INT");
    let ended = Ended::new(child.wait_with_output().unwrap());
    assert_eq!(ended.code, Some(130), "{}", ended.stderr);
    assert!(!ended.stderr.contains("panicked"), "{}", ended.stderr);
    // Not in order: that is what the first one is for. What was captured is readable all the same.
    assert!(!workshop.has("slow/summary.json"));
    assert!(!Capture::open(&workshop.path("slow/capture.mcap")).unwrap().complete);
}

/// One message, exit code 1, and no file that is not whole.
fn assert_stopped(shop: &Workshop, ended: &Ended, words: &[&str], files: &[&str]) {
    assert_eq!(ended.code, Some(1), "{}", ended.stderr);
    assert!(!ended.stderr.contains("panicked"), "{}", ended.stderr);
    assert_eq!(ended.stderr.lines().filter(|line| line.starts_with("error: ")).count(), 1, "{}", ended.stderr);
    for word in words {
        assert!(ended.stderr.contains(word), "no {word:?} in {}", ended.stderr);
    }
    let mut found: Vec<String> = std::fs::read_dir(shop.path("kept/result"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    found.sort();
    assert_eq!(found, files);
}

/// Runs the program with its results on a disk with room for `kib`, in every way that a disk can be full here.
fn on_full_disks(kib: u32, arguments: &[&str], check: impl Fn(&Workshop, Ended)) {
    for disk in full_disks() {
        println!("{disk:?}");
        let shop = Workshop::new();
        let ended = run_on(disk, &shop, kib, &[arguments, &["--out", "disk/result"]].concat());
        check(&shop, ended);
    }
}

#[test]
fn a_disk_that_fills_while_pictures_are_written_costs_the_pictures_alone() {
    let large = ["--set", "outputs.width_px=400", "--set", "outputs.height_px=400", "--particles", "ply"];
    let run = ["run", "scene.toml", "--steps", "4", "--images", "2"];
    // 61 KB without the pictures, which take 134 each.
    on_full_disks(96, &[&run[..], &large].concat(), |shop, ended| {
        let files = ["capture.mcap", "particles_0000.ply", "particles_0001.ply", "summary.json"];
        let words = ["picture disk/result/frame_0000.png: cannot be written: ", "what was written is in disk/result"];
        assert_stopped(shop, &ended, &words, &files);
        let summary = shop.json("kept/result/summary.json");
        assert_eq!((summary["steps"].as_u64(), &summary["interrupted"]), (Some(4), &false.into()));
        let not_written = ["disk/result/frame_0000.png", "disk/result/frame_0001.png"];
        assert_eq!(summary["files"]["not_written"], serde_json::json!(not_written));
        assert_eq!(summary["files"]["images"], serde_json::json!([]));
        assert_eq!(summary["files"]["capture_complete"], true);
        assert!(Capture::open(&shop.path("kept/result/capture.mcap")).unwrap().complete);
    });
}

#[test]
fn a_disk_that_fills_while_capturing_leaves_a_readable_capture() {
    on_full_disks(24, &["run", "scene.toml", "--steps", "300", "--json"], |shop, ended| {
        // The capture took all the room that there was, so the summary is printed alone.
        let words = ["disk/result/capture.mcap: the capture stopped after ", "what was written is in disk/result"];
        assert_stopped(shop, &ended, &words, &["capture.mcap"]);
        let summary = ended.json();
        assert_eq!((summary["steps"].as_u64(), &summary["files"]["capture_complete"]), (Some(300), &false.into()));
        let capture = Capture::open(&shop.path("kept/result/capture.mcap")).unwrap();
        assert!(!capture.complete && !capture.metadata["device"].is_empty());
    });
}

#[test]
fn a_summary_that_cannot_be_written_is_printed() {
    on_full_disks(0, &["run", "scene.toml", "--steps", "4", "--no-capture", "--json"], |shop, ended| {
        assert_stopped(shop, &ended, &["disk/result/summary.json: cannot be written: "], &[]);
        assert_eq!(ended.json()["steps"], 4);
    });
}

#[test]
fn a_disk_that_is_full_at_the_start_is_bad_input() {
    for kib in [0, 4] {
        on_full_disks(kib, &["run", "scene.toml", "--steps", "4"], |shop, ended| {
            assert_eq!(ended.code, Some(2), "{}", ended.stderr);
            assert!(
                ended.stderr.contains("disk/result/capture.mcap: the capture cannot be begun: "),
                "{}",
                ended.stderr
            );
            assert!(!shop.has("kept/result"), "at {kib} KiB");
        });
    }
}

#[test]
fn standard_output_may_be_full_or_gone() {
    let workshop = Workshop::new();
    for arguments in [&["plan", "scene.toml"][..], &["scenes"], &["run", "scene.toml", "--steps", "1", "--out", "full"]]
    {
        let full = std::fs::File::create("/dev/full").expect("a full device");
        let ended = Ended::new(workshop.command(arguments).stdout(full).stderr(Stdio::piped()).output().unwrap());
        assert_eq!(ended.code, Some(1), "{arguments:?}: {}", ended.stderr);
        assert!(ended.stderr.contains("error: standard output: cannot be written"), "{}", ended.stderr);
        assert!(!ended.stderr.contains("panicked"), "{}", ended.stderr);
        // A reader that has seen enough, as `| head` has: no error at all.
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let ended = Ended::new(workshop.command(arguments).stdout(writer).stderr(Stdio::piped()).output().unwrap());
        assert_eq!(ended.code, Some(0), "{arguments:?}: {}", ended.stderr);
    }
    assert!(workshop.has("full/summary.json"), "the run itself went well");
}
