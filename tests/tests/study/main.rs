//! The study finds what is wrong.

mod faults;
mod many_iterations;
mod rows;
