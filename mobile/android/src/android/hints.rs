//! Performance hints: the system is told how long a frame took of the time there was, and sets clocks by it. From
//! Android 13 on.

use std::ffi::c_int;
use std::ptr::NonNull;
use std::time::Duration;

use super::system::System;

/// `APerformanceHintManager`.
enum Manager {}
/// `APerformanceHintSession`.
enum Session {}

type GetManager = unsafe extern "C" fn() -> *mut Manager;
type Create = unsafe extern "C" fn(*mut Manager, *const i32, usize, i64) -> *mut Session;
type Report = unsafe extern "C" fn(*mut Session, i64) -> c_int;
type Close = unsafe extern "C" fn(*mut Session);

/// A frame of 60 a second.
pub const TARGET: Duration = Duration::from_nanos(16_666_667);

/// A session of the thread that opened it.
pub struct Hints {
    session: NonNull<Session>,
    report: Report,
    close: Close,
}

impl Hints {
    /// For the calling thread. None before Android 13, or where the device takes no hints.
    pub fn open(system: &System) -> Option<Self> {
        // SAFETY: the types are those of <android/performance_hint.h>; the manager is the process's own and is never
        // released; the session is closed once, when this is dropped; `gettid` cannot fail.
        unsafe {
            let get: GetManager = system.function(c"APerformanceHint_getManager")?;
            let create: Create = system.function(c"APerformanceHint_createSession")?;
            let report = system.function(c"APerformanceHint_reportActualWorkDuration")?;
            let close = system.function(c"APerformanceHint_closeSession")?;
            let manager = NonNull::new(get())?;
            let thread = libc::gettid();
            let session = create(manager.as_ptr(), &raw const thread, 1, TARGET.as_nanos() as i64);
            Some(Self { session: NonNull::new(session)?, report, close })
        }
    }

    /// What the thread's work for a frame took. Nothing is no answer.
    pub fn report(&mut self, took: Duration) {
        let ns = i64::try_from(took.as_nanos()).unwrap_or(i64::MAX);
        if ns > 0 {
            // SAFETY: the session lives until this is dropped.
            unsafe { (self.report)(self.session.as_ptr(), ns) };
        }
    }
}

impl Drop for Hints {
    fn drop(&mut self) {
        // SAFETY: made in `open`, closed here alone.
        unsafe { (self.close)(self.session.as_ptr()) }
    }
}
