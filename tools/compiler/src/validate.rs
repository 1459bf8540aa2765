//! Runs spirv-val over every module, where it is installed.

use std::path::Path;
use std::process::Command;
use std::sync::OnceLock;

use crate::cache::keep;
use crate::hash;
use crate::problem::{Problem, io_problem};

/// Whether a `spirv-val` is installed.
pub fn is_available() -> bool {
    static AVAILABLE: OnceLock<bool> = OnceLock::new();
    *AVAILABLE.get_or_init(|| Command::new("spirv-val").arg("--version").output().is_ok_and(|run| run.status.success()))
}

/// Validates a module against Vulkan 1.0. Does nothing where spirv-val is missing; what passed
/// once is remembered in `cache`.
pub fn validate(spirv: &[u8], label: &str, cache: Option<&Path>, scratch: &Path) -> Result<(), Problem> {
    if !is_available() {
        return Ok(());
    }
    let name = hash::of_bytes(spirv);
    let passed = cache.map(|cache| cache.join(format!("{name}.valid")));
    if passed.as_ref().is_some_and(|passed| passed.exists()) {
        return Ok(());
    }
    let thread = format!("{:?}", std::thread::current().id()).replace(['(', ')'], "");
    let file = scratch.join(format!("{}-{thread}-{}.spv", std::process::id(), &name[..16]));
    std::fs::write(&file, spirv).map_err(|error| io_problem("write", &file, &error))?;
    let said = validate_file(&file);
    let _ = std::fs::remove_file(&file);
    said.map_err(|said| Problem::new(format!("spirv-val refuses the module: {said}")).kernel(label))?;
    if let Some(passed) = passed {
        keep(&passed, b"");
    }
    Ok(())
}

/// Validates a module in a file; `Err` is what spirv-val says. `--relax-block-layout`: Unity's
/// loose globals may have a float3 behind a scalar (VK_KHR_relaxed_block_layout, core in 1.1).
pub fn validate_file(file: &Path) -> Result<(), String> {
    let run = Command::new("spirv-val")
        .args(["--target-env", "vulkan1.0", "--relax-block-layout"])
        .arg(file)
        .output()
        .map_err(|error| error.to_string())?;
    if run.status.success() {
        return Ok(());
    }
    Err(String::from_utf8_lossy(&run.stderr).trim().to_owned())
}
