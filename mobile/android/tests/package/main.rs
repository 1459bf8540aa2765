//! What tools/android built, before a phone loads it: the library's ELF, the package's manifest, signature and
//! alignment, and the library's self-test under an emulator of the processor.

mod elf;
mod emulated;
mod manifest;
mod package;

use std::path::PathBuf;
use std::process::Command;

/// Where tools/android --test has put things. None where nobody says, which is said, and fails where it is required.
fn built() -> Option<PathBuf> {
    let Some(folder) = std::env::var_os("BROOKLET_ANDROID") else {
        assert!(
            std::env::var_os("BROOKLET_REQUIRE_ANDROID").is_none(),
            "BROOKLET_REQUIRE_ANDROID is set and BROOKLET_ANDROID is not: name the folder that tools/android --test made"
        );
        println!("SKIPPED: BROOKLET_ANDROID does not name the folder that tools/android --test makes");
        return None;
    };
    Some(folder.into())
}

fn library() -> Option<PathBuf> {
    Some(built()?.join("lib/arm64-v8a/libbrooklet.so"))
}

/// A file of this crate.
fn own(path: &str) -> String {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(path);
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// What a program prints; what it complains of if it fails.
fn output(command: &mut Command) -> Result<String, String> {
    let output = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    if output.status.success() { Ok(text) } else { Err(text + &String::from_utf8_lossy(&output.stderr)) }
}

fn nothing(wrong: &[String]) {
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
