//! The independent reader: `read_capture.py`, with the Python package `mcap`.

use std::path::Path;

use serde_json::Value;

/// What the Python reader sees in `path`; none where there is no such Python.
pub fn read_in_python(path: &Path) -> Option<Result<Value, String>> {
    crate::python::read_in_python("read_capture.py", path)
}
