//! A phone that computes wrongly.

use std::time::Duration;

use brooklet_kernels::Module;
use brooklet_mobile::{Asked, Checked, WrongAnswer};

use crate::{app, current, in_own_process, mark_checked, own_folder, said, started};

/// A variant that subtracts where it should add: OpFSub in place of each OpFAdd.
fn broken(name: &str) -> &'static Module {
    let module = brooklet_kernels::modules().find(|module| module.name == name).unwrap();
    let mut words: Vec<u32> =
        module.spirv.chunks_exact(4).map(|word| u32::from_le_bytes(word.try_into().unwrap())).collect();
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
    Box::leak(Box::new(Module { spirv, hash: "broken", ..*module }))
}

#[test]
fn a_kernel_that_computes_wrongly_is_found_named_and_done_without() {
    let folder = tempfile::tempdir().unwrap();
    let name = "SmoothNormals";
    let asked = Asked { rooms: vec!["refine".into()], replacements: vec![broken(name)] };
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
#[ignore = "run by a_check_that_is_cut_short_leaves_nothing_that_is_believed, in a process of its own"]
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
