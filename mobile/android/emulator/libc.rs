//! What Android's C library has and glibc has not: beside it, the arm64 library runs under an emulator of the processor.

#![no_std]

use core::ffi::{c_char, c_int};

unsafe extern "C" {
    fn __errno_location() -> *mut c_int;
}

/// Android's name for where `errno` is.
#[unsafe(no_mangle)]
extern "C" fn __errno() -> *mut c_int {
    // SAFETY: it takes nothing, and cannot fail.
    unsafe { __errno_location() }
}

/// No property is set. `value` has room for 92 characters.
#[unsafe(no_mangle)]
unsafe extern "C" fn __system_property_get(_name: *const c_char, value: *mut c_char) -> c_int {
    // SAFETY: the caller's buffer has room for an empty string.
    unsafe { *value = 0 };
    0
}

/// The streams of stdio, which nothing that runs here uses.
#[unsafe(no_mangle)]
static mut __sF: [u64; 128] = [0; 128];
