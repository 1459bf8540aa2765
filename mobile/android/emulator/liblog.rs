//! Android's log, to stderr.

#![no_std]

use core::ffi::{c_char, c_int};

unsafe extern "C" {
    fn dprintf(file: c_int, format: *const c_char, ...) -> c_int;
}

/// A line of the log.
#[unsafe(no_mangle)]
unsafe extern "C" fn __android_log_write(_priority: c_int, tag: *const c_char, text: *const c_char) -> c_int {
    // SAFETY: two strings of the caller's for two of the format's.
    unsafe { dprintf(2, c"%s: %s\n".as_ptr(), tag, text) }
}

/// A line of one of the logs.
#[unsafe(no_mangle)]
unsafe extern "C" fn __android_log_buf_write(
    _log: c_int,
    priority: c_int,
    tag: *const c_char,
    text: *const c_char,
) -> c_int {
    // SAFETY: as the caller's.
    unsafe { __android_log_write(priority, tag, text) }
}
