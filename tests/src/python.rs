//! Independent readers: scripts beside this crate, run in a Python that has the packages of
//! `tools/lib/requirements.txt`.

use std::{path::Path, process::Command};

use serde_json::Value;

/// What `script` prints of `path`; none where there is no such Python, which is said, and fails where
/// `BROOKLET_REQUIRE_PYTHON` is set.
pub fn read_in_python(script: &str, path: &Path) -> Option<Result<Value, String>> {
    let Some(python) = std::env::var_os("BROOKLET_PYTHON") else {
        assert!(
            std::env::var_os("BROOKLET_REQUIRE_PYTHON").is_none(),
            "BROOKLET_REQUIRE_PYTHON is set and BROOKLET_PYTHON is not: \
             name a Python that has the packages of tools/lib/requirements.txt"
        );
        println!("SKIPPED: BROOKLET_PYTHON does not name a Python with the packages of tools/lib/requirements.txt");
        return None;
    };
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join(script);
    let output = Command::new(&python)
        .arg(script)
        .arg(path)
        .output()
        .unwrap_or_else(|error| panic!("cannot start {}: {error}", python.display()));
    if output.status.success() {
        Some(Ok(serde_json::from_slice(&output.stdout).unwrap()))
    } else {
        Some(Err(String::from_utf8_lossy(&output.stderr).into_owned()))
    }
}
