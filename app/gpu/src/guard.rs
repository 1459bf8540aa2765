//! A device together with what its driver reports of it outside of any call.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// An open device that keeps its faults.
#[derive(Clone)]
pub(crate) struct Guard {
    pub device: wgpu::Device,
    faults: Arc<Faults>,
}

/// What the driver reports outside of a call.
#[derive(Default)]
struct Faults {
    lost: Mutex<Option<String>>,
    stray: Mutex<Option<String>>,
}

impl Guard {
    /// Keeps the device's loss from now on.
    pub fn new(device: wgpu::Device) -> Self {
        let faults = Arc::new(Faults::default());
        let kept = Arc::clone(&faults);
        device.set_device_lost_callback(move |reason, message| {
            let text = match reason {
                wgpu::DeviceLostReason::Destroyed => "it was destroyed".to_owned(),
                wgpu::DeviceLostReason::Unknown => message,
            };
            lock(&kept.lost).get_or_insert(text);
        });
        Self { device, faults }
    }

    /// Keeps errors that no call asked for as well, where they would end the program. A device of
    /// the caller's own has the caller's handler.
    pub fn keep_stray_errors(&self, describe: fn(&wgpu::Error) -> String) {
        let kept = Arc::clone(&self.faults);
        self.device.on_uncaptured_error(Arc::new(move |error| {
            lock(&kept.stray).get_or_insert_with(|| describe(&error));
        }));
    }

    /// Why the device was lost, if it was.
    pub fn is_lost(&self) -> Option<String> {
        lock(&self.faults.lost).clone()
    }

    /// The first error since the last time that no call asked for.
    pub fn take_stray(&self) -> Option<String> {
        lock(&self.faults.stray).take()
    }

    /// Runs `work`, and turns what wgpu has against it into an error.
    pub fn scoped<T>(&self, work: impl FnOnce() -> T) -> Result<T, wgpu::Error> {
        let internal = self.device.push_error_scope(wgpu::ErrorFilter::Internal);
        let memory = self.device.push_error_scope(wgpu::ErrorFilter::OutOfMemory);
        let validation = self.device.push_error_scope(wgpu::ErrorFilter::Validation);
        let result = work();
        let errors = [
            pollster::block_on(validation.pop()),
            pollster::block_on(memory.pop()),
            pollster::block_on(internal.pop()),
        ];
        match errors.into_iter().flatten().next() {
            Some(error) => Err(error),
            None => Ok(result),
        }
    }
}

/// The value behind a lock, also after another thread panicked with it: each of ours is whole
/// between any two statements.
pub(crate) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
