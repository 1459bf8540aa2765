//! `write` and `unlink` of a program whose folder `FULL_DISK_PATH` has room for `FULL_DISK_BYTES`. Loaded before
//! the C library (`LD_PRELOAD`); built by rustc alone, for the tests of full disks.

use std::ffi::{CStr, c_char, c_int, c_long, c_void};
use std::os::unix::ffi::OsStrExt;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicI64, Ordering::SeqCst};

unsafe extern "C" {
    fn dlsym(handle: *mut c_void, name: *const c_char) -> *mut c_void;
    fn __errno_location() -> *mut c_int;
}

const RTLD_NEXT: *mut c_void = -1isize as *mut c_void;
const ENOSPC: c_int = 28;

type Write = unsafe extern "C" fn(c_int, *const c_void, usize) -> isize;
type Unlink = unsafe extern "C" fn(*const c_char) -> c_int;

static USED: AtomicI64 = AtomicI64::new(0);

fn folder() -> Option<&'static (PathBuf, i64)> {
    static FOLDER: OnceLock<Option<(PathBuf, i64)>> = OnceLock::new();
    let read = || Some((std::env::var_os("FULL_DISK_PATH")?.into(), std::env::var("FULL_DISK_BYTES").ok()?.parse().ok()?));
    FOLDER.get_or_init(read).as_ref()
}

/// # Safety
/// As that of the C library.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn write(file: c_int, bytes: *const c_void, count: usize) -> isize {
    // SAFETY: the C library's own function of that name, with the caller's arguments.
    let next: Write = unsafe { std::mem::transmute(dlsym(RTLD_NEXT, c"write".as_ptr())) };
    let mut allowed = count;
    if let Some((folder, room)) = folder()
        && std::fs::read_link(format!("/proc/self/fd/{file}")).is_ok_and(|path| path.starts_with(folder))
    {
        let left = (room - USED.load(SeqCst)).max(0) as usize;
        if left == 0 && count > 0 {
            // SAFETY: a pointer of this thread's.
            unsafe { *__errno_location() = ENOSPC };
            return -1;
        }
        allowed = count.min(left);
        USED.fetch_add(allowed as i64, SeqCst);
    }
    // SAFETY: as above; no more bytes than the caller has.
    unsafe { next(file, bytes, allowed) }
}

/// # Safety
/// As that of the C library.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn unlink(path: *const c_char) -> c_int {
    // SAFETY: as above.
    let next: Unlink = unsafe { std::mem::transmute(dlsym(RTLD_NEXT, c"unlink".as_ptr())) };
    // SAFETY: the caller's text ends with a zero.
    let name = Path::new(std::ffi::OsStr::from_bytes(unsafe { CStr::from_ptr(path) }.to_bytes()));
    let whole = std::path::absolute(name).unwrap_or_default();
    let bytes = std::fs::metadata(name).map_or(0, |file| file.len() as c_long);
    // SAFETY: as above.
    let done = unsafe { next(path) };
    if done == 0 && folder().is_some_and(|(folder, _)| whole.starts_with(folder)) {
        USED.fetch_sub(bytes, SeqCst);
    }
    done
}
