//! A run after one that a driver ended while it built a kernel.

use std::path::Path;

use brooklet_tests::program::{Ended, Workshop};

fn run(shop: &Workshop, cache: &Path, out: &str) -> Ended {
    let arguments = ["run", "scene.toml", "--steps", "2", "--images", "1", "--careful", "--out", out];
    Ended::new(shop.command(arguments).env("XDG_CACHE_HOME", cache).output().expect("the program starts"))
}

fn stepped_down(shop: &Workshop, out: &str) -> Vec<String> {
    let summary = shop.json(&format!("{out}/summary.json"));
    serde_json::from_value(summary["stepped_down"].clone()).expect("a list")
}

#[test]
fn a_kernel_that_ended_the_program_is_done_without_and_named() {
    let shop = Workshop::new();
    let cache = shop.path("cache");
    let first = run(&shop, &cache, "first");
    assert!(first.code == Some(0), "{}", first.stderr);
    assert!(stepped_down(&shop, "first").is_empty());
    let kept = std::fs::read_dir(cache.join("brooklet")).expect("pipelines are kept").flatten().next();
    let Some(kept) = kept else { panic!("this device keeps no pipelines, and watches none") };
    let stem = kept.file_name().into_string().expect("a name");
    // As a program leaves it that is gone: no process has this number.
    let canary = cache.join("brooklet").join(format!("{stem}.{}.0.building", u32::MAX));
    std::fs::write(&canary, "Anisotropy").expect("written");

    let second = run(&shop, &cache, "second");
    assert!(second.code == Some(0), "{}", second.stderr);
    assert!(second.stderr.contains("kernel Anisotropy is not used on this device"), "{}", second.stderr);
    assert!(second.stderr.contains("so surface.anisotropic=false"), "{}", second.stderr);
    let said = stepped_down(&shop, "second");
    assert!(said.len() == 1 && said[0].contains("Anisotropy"), "{said:?}");
    let capture = std::fs::read(shop.path("second").join("capture.mcap")).expect("a capture");
    let says = |words: &[u8]| capture.windows(words.len()).any(|found| found == words);
    assert!(says(b"so surface.anisotropic=false") && !says(b"so surface.caustics=false"));
    assert!(!canary.exists(), "it was taken");

    let third = run(&shop, &cache, "third");
    assert!(
        third.code == Some(0) && stepped_down(&shop, "third").is_empty(),
        "it may have been killed: it is tried again"
    );
}
