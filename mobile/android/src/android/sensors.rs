//! The accelerometer, read by a thread of its own: the looper of the app's thread knows only android-activity's
//! sources.

use std::ffi::CString;
use std::ptr::NonNull;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::Duration;

use android_activity::ndk_sys as sys;
use ndk::looper::ThreadLooper;

/// Fifty a second; a slower sensor gives what it has.
const PERIOD_US: i32 = 20_000;
const IDENT: i32 = 1;
/// How soon the thread sees that it shall end.
const PATIENCE: Duration = Duration::from_millis(100);

/// Readings while this lives.
pub struct Sensors {
    shared: Arc<Shared>,
    thread: Option<JoinHandle<()>>,
}

#[derive(Default)]
struct Shared {
    latest: Mutex<Option<[f32; 3]>>,
    ends: AtomicBool,
}

impl Sensors {
    /// Begins to read. A device without an accelerometer gives nothing.
    pub fn begin(package: &str) -> Self {
        let shared = Arc::new(Shared::default());
        let (of_thread, package) = (shared.clone(), CString::new(package).unwrap_or_default());
        let thread = std::thread::Builder::new().name("sensors".into()).spawn(move || match Queue::open(&package) {
            Some(queue) => queue.read_into(&of_thread),
            None => ::log::warn!("no accelerometer: gravity stays as the scene has it"),
        });
        Self { shared, thread: thread.inspect_err(|error| ::log::warn!("no thread for sensors: {error}")).ok() }
    }

    /// The latest reading that was not taken yet, m/s² along the device's axes.
    pub fn take(&self) -> Option<[f32; 3]> {
        self.shared.latest.lock().unwrap_or_else(PoisonError::into_inner).take()
    }
}

impl Drop for Sensors {
    fn drop(&mut self) {
        self.shared.ends.store(true, Ordering::Relaxed);
        if let Some(thread) = self.thread.take() {
            // It panics at nothing, and there is nothing left to do if it did.
            drop(thread.join());
        }
    }
}

/// The accelerometer's queue, of the thread that opened it.
struct Queue {
    looper: ThreadLooper,
    manager: NonNull<sys::ASensorManager>,
    sensor: NonNull<sys::ASensor>,
    queue: NonNull<sys::ASensorEventQueue>,
}

impl Queue {
    fn open(package: &CString) -> Option<Self> {
        let looper = ThreadLooper::prepare();
        // SAFETY: every pointer is what the call before gave, and not null. The manager and the sensor are the
        // system's and outlive the process; the queue is destroyed once, when this is dropped.
        unsafe {
            let manager = NonNull::new(sys::ASensorManager_getInstanceForPackage(package.as_ptr()))?;
            let sensor = sys::ASensorManager_getDefaultSensor(manager.as_ptr(), sys::ASENSOR_TYPE_ACCELEROMETER);
            let sensor = NonNull::new(sensor.cast_mut())?;
            let queue = NonNull::new(sys::ASensorManager_createEventQueue(
                manager.as_ptr(),
                looper.as_foreign().ptr().as_ptr(),
                IDENT,
                None,
                std::ptr::null_mut(),
            ))?;
            let opened = Self { looper, manager, sensor, queue };
            (sys::ASensorEventQueue_enableSensor(queue.as_ptr(), sensor.as_ptr()) >= 0).then_some(())?;
            // A sensor that takes no other rate keeps its own.
            sys::ASensorEventQueue_setEventRate(queue.as_ptr(), sensor.as_ptr(), PERIOD_US);
            Some(opened)
        }
    }

    fn read_into(&self, shared: &Shared) {
        while !shared.ends.load(Ordering::Relaxed) {
            if self.looper.poll_once_timeout(PATIENCE).is_err() {
                return ::log::warn!("the accelerometer's queue failed");
            }
            if let Some(reading) = self.latest() {
                *shared.latest.lock().unwrap_or_else(PoisonError::into_inner) = Some(reading);
            }
        }
    }

    /// Takes all that is there.
    fn latest(&self) -> Option<[f32; 3]> {
        let mut latest = None;
        // SAFETY: all bits nought are an event; the queue writes at most one event into the one there is room for. An
        // event of the accelerometer has three numbers, whichever member of the union names them.
        unsafe {
            let mut event: sys::ASensorEvent = std::mem::zeroed();
            while sys::ASensorEventQueue_getEvents(self.queue.as_ptr(), &raw mut event, 1) > 0 {
                if event.type_ == sys::ASENSOR_TYPE_ACCELEROMETER {
                    let [x, y, z, ..] = event.__bindgen_anon_1.__bindgen_anon_1.data;
                    latest = Some([x, y, z]);
                }
            }
        }
        latest.filter(|reading| reading.iter().all(|axis| axis.is_finite()))
    }
}

impl Drop for Queue {
    fn drop(&mut self) {
        // SAFETY: made in `open`, of this thread, destroyed here alone.
        unsafe {
            sys::ASensorEventQueue_disableSensor(self.queue.as_ptr(), self.sensor.as_ptr());
            sys::ASensorManager_destroyEventQueue(self.manager.as_ptr(), self.queue.as_ptr());
        }
    }
}
