//! What Vulkan tells of a device and wgpu does not pass on.

use crate::device::Gpu;

/// What a driver says of itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DriverFacts {
    /// Corners of triangles are rounded to 2^-bits of a pixel: at least 4 (`subPixelPrecisionBits`).
    pub subpixel_bits: u32,
    /// So many bits of a timestamp count, then it wraps; 0: there are none (`timestampValidBits`).
    pub timestamp_bits: u32,
}

impl Gpu {
    /// What the driver says of itself.
    ///
    /// # Panics
    /// Never: a device of Brooklet's is one of Vulkan.
    pub fn driver_facts(&self) -> DriverFacts {
        // SAFETY: the handles are only asked for properties, while the device that they belong to lives.
        unsafe {
            let device = self.device().as_hal::<wgpu::hal::api::Vulkan>().expect("a device of Vulkan");
            let instance = device.shared_instance().raw_instance();
            let properties = instance.get_physical_device_properties(device.raw_physical_device());
            let families = instance.get_physical_device_queue_family_properties(device.raw_physical_device());
            let family = families.get(device.queue_family_index() as usize);
            DriverFacts {
                subpixel_bits: properties.limits.sub_pixel_precision_bits,
                timestamp_bits: family.map_or(0, |family| family.timestamp_valid_bits),
            }
        }
    }
}
