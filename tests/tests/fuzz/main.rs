//! Scene files and captures with faults: in a process of its own, whose memory is watched.

mod cases;
mod support;
