//! The phone's app without a phone: touched by a script, on a small screen, on whatever Vulkan there is.

mod capture;
mod check;
mod coming_and_going;
mod gravity;
#[path = "../../../tests/src/python.rs"]
mod python;
mod report;
mod touched;

use std::path::Path;
use std::time::Duration;

use brooklet_gpu::{Gpu, GpuOptions, Tier};
use brooklet_mobile::script::Hand;
use brooklet_mobile::{App, AppPaths, Checked};
use tempfile::TempDir;

const SIZE_PX: [u32; 2] = [360, 640];
const SMALL_PX: [u32; 2] = [180, 320];
/// Longer than a software driver on a busy machine takes for anything here.
const LONG: Duration = Duration::from_secs(120);

fn options() -> GpuOptions {
    let tier = match std::env::var("BROOKLET_TIER").as_deref() {
        Ok("floor") => Some(Tier::Floor),
        Ok("desktop") => Some(Tier::Desktop),
        _ => Some(Tier::Mobile),
    };
    GpuOptions { device_name: std::env::var("BROOKLET_DEVICE").ok(), tier, timing: true, ..GpuOptions::default() }
}

fn app(folder: &Path) -> App {
    let paths = AppPaths { files: folder.join("files"), cache: folder.join("cache") };
    App::new(paths).with_gpu_options(options())
}

/// That everything is right on this device, as a first start would have found.
fn mark_checked(folder: &Path) {
    let gpu = Gpu::open(&options()).unwrap();
    Checked { of: Checked::key(&gpu), cases: 1, ..Checked::default() }.save(&folder.join("files")).unwrap();
}

/// An app in which the first scene runs, in a folder of its own.
fn running() -> (Hand, TempDir) {
    let folder = tempfile::tempdir().unwrap();
    mark_checked(folder.path());
    let hand = started(app(folder.path()));
    (hand, folder)
}

/// Until the first scene runs.
fn started(mut app: App) -> Hand {
    app.resume_offscreen(SIZE_PX, 1.0);
    assert_eq!(app.failure(), None);
    let mut hand = Hand::new(app, 1.0);
    assert!(hand.until(LONG, |hand| current(hand).is_some()), "no scene: {:?}", said(&hand));
    hand
}

fn current(hand: &Hand) -> Option<&brooklet_viewer::viewer_scene::ViewerScene> {
    hand.app.viewer()?.current()
}

fn said(hand: &Hand) -> Vec<String> {
    hand.app.viewer().map_or(Vec::new(), |viewer| viewer.messages().map(str::to_owned).collect())
}

/// Runs a test that is ignored in a process of its own, with the folder it is to use; nothing of it is waited for.
fn in_own_process(test: &str, folder: &Path) -> std::process::Command {
    let mut command = std::process::Command::new(std::env::current_exe().unwrap());
    command.args(["--exact", test, "--ignored", "--nocapture", "--test-threads=1"]).env("BROOKLET_FOLDER", folder);
    command
}

fn own_folder() -> std::path::PathBuf {
    std::env::var_os("BROOKLET_FOLDER").expect("run by another test").into()
}
