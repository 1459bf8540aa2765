//! Windows that come and go, devices that are lost or not there.

use std::time::Duration;

use brooklet_gpu::GpuOptions;
use brooklet_viewer::action::Action;

use crate::{LONG, SIZE_PX, SMALL_PX, app, current, in_own_process, own_folder, running, said};

/// Memory of this process, bytes.
fn resident_bytes() -> u64 {
    let text = std::fs::read_to_string("/proc/self/statm").unwrap();
    4096 * text.split_whitespace().nth(1).unwrap().parse::<u64>().unwrap()
}

/// Whether memory at the end is more than a share above what it was, by the medians of a third at either end.
fn grows(bytes: &[u64]) -> bool {
    let median = |part: &[u64]| {
        let mut sorted = part.to_vec();
        sorted.sort_unstable();
        sorted[sorted.len() / 2]
    };
    let third = bytes.len() / 3;
    median(&bytes[bytes.len() - third..]) > median(&bytes[..third]) + 8_000_000
}

#[test]
#[ignore = "run by a_hundred_suspends_and_resumes_keep_the_device_and_take_no_memory, in a process of its own"]
fn suspends_a_hundred_times() {
    let (mut hand, _folder) = running();
    // The ladder would go up and down with the machine's load, and memory with it.
    hand.app.viewer_mut().unwrap().handle_action(Action::Rung(10));
    hand.settle();
    assert!(hand.steps(2, LONG));
    let device = hand.app.gpu().unwrap().device().clone();
    let mut bytes = Vec::new();
    for round in 0..100 {
        hand.app.suspend();
        assert_eq!(hand.frame(), brooklet_mobile::Wake::OnEvent, "nothing is painted in the background");
        hand.app.resume_offscreen(if round % 20 == 19 { SIZE_PX } else { SMALL_PX }, 1.0);
        hand.settle();
        bytes.push(resident_bytes());
    }
    assert_eq!(*hand.app.gpu().unwrap().device(), device);
    assert!(!grows(&bytes), "{bytes:?}");
    let before = current(&hand).unwrap().session.steps();
    assert!(hand.steps(1, LONG) && before > 0, "the scene goes on where it was");
    let leak: Vec<u64> = (0..100).map(|round| 1_000_000 * round).collect();
    assert!(grows(&leak), "a megabyte a round is seen");
}

#[test]
fn a_hundred_suspends_and_resumes_keep_the_device_and_take_no_memory() {
    let folder = tempfile::tempdir().unwrap();
    // Other tests' memory is not its own.
    let done = in_own_process("coming_and_going::suspends_a_hundred_times", folder.path()).output().unwrap();
    let [out, err] = [&done.stdout, &done.stderr].map(|text| String::from_utf8_lossy(text));
    assert!(done.status.success(), "{out}{err}");
    assert!(String::from_utf8_lossy(&done.stdout).contains("1 passed"), "it did not run");
}

#[test]
fn a_lost_device_is_opened_anew_and_said_and_a_second_time_ends_it_in_words() {
    let (mut hand, _folder) = running();
    hand.app.gpu().unwrap().device().destroy();
    let again = |hand: &mut brooklet_mobile::script::Hand| {
        current(hand).is_some() && said(hand).iter().any(|text| text.contains("started again"))
    };
    assert!(hand.until(LONG, again), "{:?}, {:?}", hand.app.failure(), said(&hand));
    hand.app.gpu().unwrap().device().destroy();
    assert!(hand.until(Duration::from_secs(20), |hand| hand.app.failure().is_some()));
    assert!(hand.app.failure().unwrap().contains("stopped twice"), "{:?}", hand.app.failure());
    assert_eq!(hand.frame(), brooklet_mobile::Wake::OnEvent);
    // Whoever comes back to it tries again.
    hand.app.resume_offscreen(SIZE_PX, 1.0);
    assert_eq!(hand.app.failure(), None);
}

#[test]
fn sizes_and_densities_that_are_none_do_no_harm() {
    let (mut hand, _folder) = running();
    for (size_px, density) in [([0, 0], 1.0), ([1, 1], 0.0), ([u32::MAX, 3], f32::NAN), ([40, 4000], 100.0)] {
        hand.app.suspend();
        hand.app.resume_offscreen(size_px, density);
        hand.settle();
        assert_eq!(hand.app.failure(), None, "{size_px:?}");
    }
}

#[test]
fn a_device_that_is_not_there_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let options = GpuOptions { device_name: Some("nobody's".into()), ..crate::options() };
    let mut app = app(folder.path()).with_gpu_options(options);
    assert_eq!(app.frame(), brooklet_mobile::Wake::OnEvent, "there is no window");
    app.resume_offscreen(SIZE_PX, 1.0);
    assert!(app.failure().is_some_and(|text| text.contains("nobody's")), "{:?}", app.failure());
    app.thermal_headroom(f32::NAN);
    app.low_memory();
    app.suspend();
    assert!(!app.back());
}

#[test]
#[ignore = "run by without_vulkan_it_says_so, in a process of its own"]
fn opens_without_vulkan() {
    let mut app = app(&own_folder());
    app.resume_offscreen(SIZE_PX, 1.0);
    println!("FAILURE: {}", app.failure().unwrap_or("none"));
    assert_eq!(app.frame(), brooklet_mobile::Wake::OnEvent);
}

#[test]
fn without_vulkan_it_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let nothing = folder.path().join("no-driver.json");
    let mut command = in_own_process("coming_and_going::opens_without_vulkan", folder.path());
    command.env("VK_DRIVER_FILES", &nothing).env("VK_ICD_FILENAMES", &nothing).env_remove("VK_ADD_DRIVER_FILES");
    let done = command.output().unwrap();
    let text = String::from_utf8_lossy(&done.stdout);
    assert!(done.status.success() && text.contains("FAILURE: ") && text.contains("Vulkan"), "{text}");
}
