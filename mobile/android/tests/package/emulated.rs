//! The library's own self-test, on an emulated 64-bit ARM, with glibc in place of Android's C library.

use std::path::Path;
use std::process::Command;

use crate::{built, library, output};

/// As Debian's libc6-dev-arm64-cross has it.
const ARM64: &str = "/usr/aarch64-linux-gnu";

fn run(emulator: &Path, library: &Path) -> Result<String, String> {
    let libraries = format!("LD_LIBRARY_PATH={}", emulator.display());
    let mut command = Command::new("qemu-aarch64-static");
    output(command.args(["-L", ARM64, "-E", &libraries]).arg(emulator.join("run")).arg(library))
}

/// Every check passes, and each fails when it, and only it, gets a wrong input.
fn holds(lines: &str) -> bool {
    let lines: Vec<&str> = lines.lines().collect();
    lines.len() > 1 && lines.iter().enumerate().all(|(number, line)| *line == format!("{number} {number}"))
}

#[test]
fn the_library_passes_its_self_test_on_an_emulated_processor() {
    let (Some(folder), Some(library)) = (built(), library()) else { return };
    let emulator = folder.join("emulator");
    let lines = run(&emulator, &library).unwrap_or_else(|error| panic!("{error}"));
    assert!(holds(&lines), "check with a wrong input, check that failed:\n{lines}");
    // A library that is none is refused, not passed over.
    let error = run(&emulator, &emulator.join("libc.so")).expect_err("glibc passes for the app");
    assert!(error.contains("undefined symbol"), "{error}");
}

#[test]
fn lines_that_do_not_hold_are_refused() {
    assert!(holds("0 0\n1 1\n2 2\n"));
    for wrong in ["", "0 0\n", "0 1\n1 1\n", "0 0\n1 0\n", "0 0\n1 1\n2 1\n"] {
        assert!(!holds(wrong), "{wrong:?} is taken");
    }
}
