//! What every compilation is told.

/// Flags of every compilation, besides target profile, entry point and defines.
pub const FLAGS: [&str; 5] =
    ["-spirv", "-fspv-target-env=vulkan1.0", "-O3", "-Wno-unknown-pragmas", "-DSHADER_API_VULKAN=1"];
