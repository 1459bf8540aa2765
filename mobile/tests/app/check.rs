//! A phone that computes wrongly.

use std::path::Path;
use std::time::Duration;

use brooklet_fluid::scene::SurfaceMethod;
use brooklet_gpu::{FormatUse, GpuOptions};
use brooklet_kernels::{Format, Module, Spirv};
use brooklet_mobile::script::Hand;
use brooklet_mobile::{Asked, Checked, WrongAnswer};

use crate::{LONG, app, current, in_own_process, mark_checked, own_folder, running, said, started};

/// A variant that subtracts where it should add: OpFSub in place of each OpFAdd.
fn broken(name: &str) -> &'static Module {
    let module = brooklet_kernels::modules().find(|module| module.name == name).unwrap();
    let mut words: Vec<u32> =
        module.spirv.bytes().chunks_exact(4).map(|word| u32::from_le_bytes(word.try_into().unwrap())).collect();
    let (mut at, mut exchanged) = (5, 0);
    while at < words.len() {
        if words[at] & 0xffff == 129 {
            words[at] = words[at] & 0xffff_0000 | 131;
            exchanged += 1;
        }
        at += (words[at] >> 16) as usize;
    }
    assert!(exchanged > 0, "{name} adds nothing");
    let spirv = Vec::leak(words.into_iter().flat_map(u32::to_le_bytes).collect());
    Box::leak(Box::new(Module { spirv: Spirv::Plain(spirv), hash: "broken", ..*module }))
}

#[test]
fn a_kernel_that_computes_wrongly_is_found_named_and_done_without() {
    let folder = tempfile::tempdir().unwrap();
    let name = "SmoothNormals";
    let asked = Asked { rooms: vec!["refine".into()], replacements: vec![broken(name)], ..Asked::default() };
    let mut hand = started(app(folder.path()).with_asked(asked));
    let checked = hand.app.checked().unwrap().clone();
    assert!(checked.cases >= 2, "{checked:?}");
    let names: Vec<&str> = checked.wrong.iter().map(|wrong| wrong.module.as_str()).collect();
    assert_eq!(names, [name], "{checked:?}");
    assert!(said(&hand).iter().any(|text| text.contains(name)), "{:?}", said(&hand));
    let run = current(&hand).unwrap();
    assert_eq!(run.session.scene().surface.mesh.smooth_normals, 0, "{:?}", run.concessions);
    assert!(run.concessions.iter().any(|concession| concession.reason.contains(name)), "{:?}", run.concessions);
    hand.tap("menu").unwrap();
    // The next start knows.
    drop(hand);
    let hand = started(app(folder.path()));
    assert_eq!(hand.app.checked(), Some(&checked));
    assert_eq!(current(&hand).unwrap().session.scene().surface.mesh.smooth_normals, 0);
}

#[test]
fn a_wrong_kernel_that_nothing_replaces_is_refused_by_name_and_nothing_runs() {
    let folder = tempfile::tempdir().unwrap();
    let name = "Predict+WALLS";
    let asked = Asked { rooms: vec!["particles".into()], replacements: vec![broken(name)], ..Asked::default() };
    let mut app = app(folder.path()).with_asked(asked);
    app.resume_offscreen(crate::SIZE_PX, 1.0);
    let mut hand = Hand::new(app, 1.0);
    let is_refused = |hand: &mut Hand| said(hand).iter().filter(|text| text.contains(name)).count() >= 2;
    assert!(hand.until(LONG, is_refused), "the check's result, and why there is no scene: {:?}", said(&hand));
    let names: Vec<&str> = hand.app.checked().unwrap().wrong.iter().map(|wrong| wrong.module.as_str()).collect();
    assert!(names.contains(&name), "{names:?}");
    assert!(current(&hand).is_none(), "wrong water is not shown");
    // A screen that can be used, and a report of it that can be sent.
    hand.tap("menu").unwrap();
    assert_eq!(hand.app.failure(), None);
}

#[test]
fn a_start_that_finds_what_ended_the_one_before_does_without_and_says_so() {
    let (hand, folder) = running();
    drop(hand);
    let cache = folder.path().join("cache");
    let kept = std::fs::read_dir(&cache).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let stem = kept.into_iter().find(|name| !name.contains('.')).expect("pipelines are kept, and builds watched");
    let name = "SmoothNormals";
    // As a program leaves it that a driver ended: no process has this number.
    let canary = cache.join(format!("{stem}.{}.0.building", u32::MAX));
    std::fs::write(&canary, name).unwrap();
    let mut hand = started(app(folder.path()));
    assert!(!canary.exists());
    let run = current(&hand).unwrap();
    assert_eq!(run.session.scene().surface.mesh.smooth_normals, 0, "{:?}", run.concessions);
    let says = |text: &str| text.contains(name) && text.contains("the program ended while the driver built it");
    assert!(run.concessions.iter().any(|concession| says(&concession.to_string())), "{:?}", run.concessions);
    assert!(said(&hand).iter().any(|text| says(text)), "{:?}", said(&hand));
    assert!(captured(&mut hand, folder.path(), b"the program ended while the driver built it"));
    // It may have been killed: the next start tries it again.
    drop(hand);
    let hand = started(app(folder.path()));
    assert_ne!(current(&hand).unwrap().session.scene().surface.mesh.smooth_normals, 0);
}

/// Whether a capture that is begun now has these words.
fn captured(hand: &mut Hand, folder: &Path, words: &[u8]) -> bool {
    hand.tap("capture").unwrap();
    assert!(hand.steps(2, LONG));
    hand.tap("capture").unwrap();
    let files = std::fs::read_dir(folder.join("files")).unwrap().map(|entry| entry.unwrap().path());
    let capture = files.into_iter().find(|path| path.extension().is_some_and(|ending| ending == "mcap")).unwrap();
    std::fs::read(capture).unwrap().windows(words.len()).any(|found| found == words)
}

#[test]
fn a_format_that_is_missing_is_drawn_in_another_and_said() {
    let folder = tempfile::tempdir().unwrap();
    mark_checked(folder.path());
    // Neither the water's depths nor the particles' indices can be drawn to what they are best in.
    let without_formats = vec![(Format::R32Float, FormatUse::Drawn)];
    let app = app(folder.path()).with_gpu_options(GpuOptions { without_formats, ..crate::options() });
    let mut hand = started(app);
    let run = current(&hand).unwrap();
    let said_so = |text: &str| text.contains("R32Float") && text.contains("in Rg32Float");
    assert!(run.concessions.iter().any(|concession| said_so(&concession.to_string())), "{:?}", run.concessions);
    assert_ne!(run.session.scene().surface.method, SurfaceMethod::None);
    assert!(said(&hand).iter().any(|text| said_so(text)), "{:?}", said(&hand));
    assert!(captured(&mut hand, folder.path(), b"in Rg32Float"));
    assert!(!captured(&mut hand, folder.path(), b"in Rgba32Float"));
}

#[test]
fn what_was_found_on_another_driver_is_not_believed() {
    let folder = tempfile::tempdir().unwrap();
    mark_checked(folder.path());
    let gpu = brooklet_gpu::Gpu::open(&crate::options()).unwrap();
    let files = folder.path().join("files");
    let kept = Checked::load(&files, &gpu).unwrap();
    Checked { of: "another".into(), ..kept.clone() }.save(&files).unwrap();
    assert_eq!(Checked::load(&files, &gpu), None);
    std::fs::write(files.join("self-check.json"), "{").unwrap();
    assert_eq!(Checked::load(&files, &gpu), None);
    let wrong = WrongAnswer { module: "Xsph".into(), reason: "off by 1".into() };
    let bad = Checked { wrong: vec![wrong], ..kept };
    bad.save(&files).unwrap();
    assert_eq!(Checked::load(&files, &gpu).unwrap(), bad);
    assert!(bad.summary().contains("Xsph") && !bad.summary().contains("right"));
    bad.refuse_wrong(&gpu);
    assert_eq!(gpu.refused(), [("Xsph".to_owned(), "off by 1".to_owned())]);
}

#[test]
fn what_the_first_start_has_no_time_for_is_said_and_the_menu_asks_all() {
    let folder = tempfile::tempdir().unwrap();
    let asked = Asked { rooms: vec!["scan".into()], limit: Duration::ZERO, ..Asked::default() };
    let mut hand = started(app(folder.path()).with_asked(asked));
    let gpu = hand.app.gpu().unwrap().clone();
    let files = folder.path().join("files");
    let hurried = hand.app.checked().unwrap().clone();
    assert!(hurried.cases == 0 && hurried.not_reached >= 3, "{hurried:?}");
    assert!(hurried.unanswered.iter().any(|module| module.starts_with("ScanGroups")), "{hurried:?}");
    let number = format!("no time for {} more", hurried.not_reached);
    assert!(said(&hand).iter().any(|text| text.contains(&number)), "{:?}", said(&hand));
    assert_eq!(Checked::load(&files, &gpu), Some(hurried.clone()));
    let in_captures = hurried.fields().into_iter().find(|(name, _)| name == "not_reached").unwrap();
    assert_eq!(in_captures.1, hurried.not_reached.to_string());

    hand.tap("menu").unwrap();
    hand.tap("check").unwrap();
    let is_whole = |hand: &mut Hand| hand.app.checked().is_some_and(|checked| checked.not_reached == 0);
    assert!(hand.until(LONG, is_whole), "{:?}", hand.app.checked());
    let whole = hand.app.checked().unwrap().clone();
    assert!(whole.cases == hurried.not_reached && whole.wrong.is_empty() && !whole.summary().contains("no time"));
    assert_eq!(Checked::load(&files, &gpu), Some(whole));
}

#[test]
fn a_check_stands_while_the_app_is_not_in_front() {
    let folder = tempfile::tempdir().unwrap();
    let asked = Asked { rooms: vec!["scan".into(), "grid".into()], patience: LONG, ..Asked::default() };
    let mut app = app(folder.path()).with_asked(asked);
    app.resume_offscreen(crate::SIZE_PX, 1.0);
    assert!(app.suspend(), "a case is under way that a driver may be building for");
    // Long enough for the others.
    std::thread::sleep(Duration::from_secs(5));
    app.frame();
    assert!(app.checked().is_none(), "{:?}", app.checked());
    app.resume_offscreen(crate::SIZE_PX, 1.0);
    let mut hand = Hand::new(app, 1.0);
    assert!(hand.until(LONG, |hand| hand.app.checked().is_some()));
    let checked = hand.app.checked().unwrap();
    assert!(checked.cases > 5 && checked.not_reached == 0, "{checked:?}");
}

#[test]
#[ignore = "run by others, in a process of its own"]
fn begins_a_check() {
    let mut app = app(&own_folder());
    app.resume_offscreen(crate::SIZE_PX, 1.0);
    app.frame();
    assert!(app.checked().is_none());
}

#[test]
fn a_check_that_is_cut_short_leaves_nothing_that_is_believed() {
    let folder = tempfile::tempdir().unwrap();
    let mut child =
        in_own_process("check::begins_a_check", folder.path()).stdout(std::process::Stdio::null()).spawn().unwrap();
    std::thread::sleep(Duration::from_millis(300));
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(!folder.path().join("files/self-check.json").exists());
}

#[test]
fn a_program_that_ends_in_a_check_waits_for_what_the_driver_builds() {
    let folder = tempfile::tempdir().unwrap();
    // Without what drivers keep of earlier starts: then it builds.
    let mut child = in_own_process("check::begins_a_check", folder.path());
    child.env("MESA_SHADER_CACHE_DISABLE", "true");
    let done = child.output().unwrap();
    let out = String::from_utf8_lossy(&done.stdout);
    assert!(done.status.success() && out.contains("1 passed"), "{:?}: {out}", done.status);
    assert!(!folder.path().join("files/self-check.json").exists(), "it was cut short");
}
