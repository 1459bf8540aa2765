//! Vulkan device, recordings as data, engine and GPU timing; knows no fluids
