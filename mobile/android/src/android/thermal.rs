//! Thermal headroom: how near the device is to being slowed down, from Android 12 on.

use std::ffi::{c_float, c_int};
use std::ptr::NonNull;
use std::time::{Duration, Instant};

use super::system::System;

/// `AThermalManager`.
enum Manager {}

type Acquire = unsafe extern "C" fn() -> *mut Manager;
type Release = unsafe extern "C" fn(*mut Manager);
type Headroom = unsafe extern "C" fn(*mut Manager, c_int) -> c_float;

/// The system answers at most once a second, and says NaN to whoever asks more often.
const EVERY: Duration = Duration::from_secs(2);
/// How far ahead it is asked to look.
const AHEAD_S: c_int = 10;

/// Where the system tells of its headroom.
pub struct Thermal {
    manager: NonNull<Manager>,
    release: Release,
    headroom: Headroom,
    asked: Option<Instant>,
}

impl Thermal {
    /// None before Android 12, or where the system has no such service.
    pub fn open(system: &System) -> Option<Self> {
        // SAFETY: the types are those of <android/thermal.h>; the manager is released once, when this is dropped.
        unsafe {
            let acquire: Acquire = system.function(c"AThermal_acquireManager")?;
            let release = system.function(c"AThermal_releaseManager")?;
            let headroom = system.function(c"AThermal_getThermalHeadroom")?;
            let manager = NonNull::new(acquire())?;
            Some(Self { manager, release, headroom, asked: None })
        }
    }

    /// 0 is cool, 1 is where the system slows down; NaN where it does not know. None if it was asked just now.
    pub fn headroom(&mut self) -> Option<f32> {
        let now = Instant::now();
        if self.asked.is_some_and(|asked| now - asked < EVERY) {
            return None;
        }
        self.asked = Some(now);
        // SAFETY: the manager lives until this is dropped.
        Some(unsafe { (self.headroom)(self.manager.as_ptr(), AHEAD_S) })
    }
}

impl Drop for Thermal {
    fn drop(&mut self) {
        // SAFETY: acquired in `open`, released here alone.
        unsafe { (self.release)(self.manager.as_ptr()) }
    }
}
