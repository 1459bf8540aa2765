//! Loads the library that it is given as Android would, every symbol at once, and runs its self-test: first as it is,
//! then with a wrong input for each check. Prints a line for each: the check that got the wrong input, the check that
//! failed. Exit code 1 if the library cannot be loaded, with the reason.

#![no_std]

use core::ffi::{CStr, c_char, c_int, c_void};

unsafe extern "C" {
    fn dlopen(name: *const c_char, flags: c_int) -> *mut c_void;
    fn dlsym(library: *mut c_void, name: *const c_char) -> *mut c_void;
    fn dlerror() -> *const c_char;
    fn dprintf(file: c_int, format: *const c_char, ...) -> c_int;
}

const RTLD_NOW: c_int = 2;

#[unsafe(no_mangle)]
unsafe extern "C" fn main(_count: c_int, arguments: *const *const c_char) -> c_int {
    // SAFETY: a program has at least its name, and a null behind its arguments; the symbols have the types that
    // `self_test.rs` gives them.
    unsafe {
        let library = dlopen(*arguments.add(1), RTLD_NOW);
        let symbol = |name: &CStr| if library.is_null() { library } else { dlsym(library, name.as_ptr()) };
        let entry = symbol(c"ANativeActivity_onCreate");
        let count = symbol(c"brooklet_self_test_count");
        let test = symbol(c"brooklet_self_test");
        if entry.is_null() || count.is_null() || test.is_null() {
            dprintf(2, c"%s\n".as_ptr(), dlerror());
            return 1;
        }
        let count: extern "C" fn() -> u32 = core::mem::transmute(count);
        let test: extern "C" fn(u32) -> u32 = core::mem::transmute(test);
        let mut wrong = 0;
        while wrong <= count() {
            dprintf(1, c"%u %u\n".as_ptr(), wrong, test(wrong));
            wrong += 1;
        }
    }
    0
}
