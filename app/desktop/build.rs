//! Puts the commit that the program is built from into it, for summaries and captures.

use std::{path::Path, process::Command};

fn main() {
    println!("cargo::rerun-if-env-changed=BROOKLET_COMMIT");
    // What `-dirty` depends on; without .git (a source archive) only these.
    for path in ["../../app", "../../shaders"] {
        println!("cargo::rerun-if-changed={path}");
    }
    for name in ["HEAD", "logs/HEAD"] {
        if let Some(path) = git(&["rev-parse", "--git-path", name])
            && Path::new(&path).exists()
        {
            println!("cargo::rerun-if-changed={path}");
        }
    }
    let commit = std::env::var("BROOKLET_COMMIT")
        .ok()
        .or_else(|| git(&["describe", "--always", "--dirty", "--abbrev=12", "--exclude=*"]))
        .unwrap_or_else(|| "unknown".into());
    println!("cargo::rustc-env=BROOKLET_COMMIT={commit}");
}

fn git(arguments: &[&str]) -> Option<String> {
    let output = Command::new("git").args(arguments).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?.trim().to_string();
    (output.status.success() && !text.is_empty()).then_some(text)
}
