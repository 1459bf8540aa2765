//! Pass timings and named statistics to and from MCAP; serves any wgpu program
