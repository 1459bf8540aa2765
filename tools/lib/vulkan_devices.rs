//! Prints the name of every Vulkan device that can be opened, one a line. Exit code 3: there is no
//! Vulkan loader; 4: the loader finds no device. Compiled by `tools/setup` with rustc alone,
//! because it answers, before anything is built, whether a driver has to be installed.

use std::ffi::{CStr, c_char, c_int, c_void};
use std::process::exit;
use std::ptr::{null, null_mut};

#[link(name = "dl")]
unsafe extern "C" {
    fn dlopen(name: *const c_char, flags: c_int) -> *mut c_void;
    fn dlsym(library: *mut c_void, name: *const c_char) -> *mut c_void;
}

const RTLD_NOW: c_int = 2;

#[repr(C)]
struct InstanceCreateInfo {
    structure_type: u32,
    next: *const c_void,
    flags: u32,
    application: *const c_void,
    layer_count: u32,
    layers: *const c_void,
    extension_count: u32,
    extensions: *const c_void,
}

/// Start of `VkPhysicalDeviceProperties`; the rest (824 bytes in Vulkan 1.0) is only written to.
#[repr(C, align(8))]
struct DeviceProperties {
    versions_and_type: [u32; 5],
    name: [u8; 256],
    rest: [u8; 1024],
}

type CreateInstance =
    unsafe extern "C" fn(*const InstanceCreateInfo, *const c_void, *mut *mut c_void) -> i32;
type EnumerateDevices = unsafe extern "C" fn(*mut c_void, *mut u32, *mut *mut c_void) -> i32;
type GetProperties = unsafe extern "C" fn(*mut c_void, *mut DeviceProperties);

fn main() {
    // SAFETY: names and signatures are those of the Vulkan 1.0 specification; every pointer is
    // null where that is allowed, or to a live local of the right type.
    unsafe {
        let library = dlopen(c"libvulkan.so.1".as_ptr(), RTLD_NOW);
        if library.is_null() {
            exit(3);
        }
        let load = |name: &CStr| {
            let function = dlsym(library, name.as_ptr());
            if function.is_null() {
                exit(3);
            }
            function
        };
        let create: CreateInstance = std::mem::transmute(load(c"vkCreateInstance"));
        let enumerate: EnumerateDevices = std::mem::transmute(load(c"vkEnumeratePhysicalDevices"));
        let properties: GetProperties = std::mem::transmute(load(c"vkGetPhysicalDeviceProperties"));
        let info = InstanceCreateInfo {
            structure_type: 1, // VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO
            next: null(),
            flags: 0,
            application: null(),
            layer_count: 0,
            layers: null(),
            extension_count: 0,
            extensions: null(),
        };
        let mut instance = null_mut();
        if create(&info, null(), &mut instance) != 0 {
            exit(4);
        }
        let mut devices = [null_mut(); 64];
        let mut count = devices.len() as u32;
        if enumerate(instance, &mut count, devices.as_mut_ptr()) < 0 || count == 0 {
            exit(4);
        }
        for device in &devices[..count as usize] {
            let mut found: DeviceProperties = std::mem::zeroed();
            properties(*device, &mut found);
            let name = CStr::from_bytes_until_nul(&found.name).unwrap_or(c"unnamed");
            println!("{}", name.to_string_lossy());
        }
    }
}
