//! What newer systems have and API 26 has not, looked up when it runs: a symbol that the linker knew of would keep the
//! library from being loaded at all.

use std::ffi::CStr;

use libloading::Library;

/// `libandroid.so`, which every process has.
pub struct System(Library);

impl System {
    /// None where it cannot be opened, which only a broken system has.
    pub fn open() -> Option<Self> {
        // SAFETY: the library is in the process already, so nothing of it runs by being opened.
        unsafe { Library::new("libandroid.so") }.inspect_err(|error| ::log::warn!("{error}")).ok().map(Self)
    }

    /// A function of it, if the system has it.
    ///
    /// # Safety
    /// `F` is the function's type as the NDK's headers have it. It stays valid: the library is never unloaded.
    pub unsafe fn function<F: Copy>(&self, name: &CStr) -> Option<F> {
        // SAFETY: as the caller says.
        unsafe { self.0.get::<F>(name.to_bytes_with_nul()) }.ok().map(|function| *function)
    }
}
