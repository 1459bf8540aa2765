//! The study finds what is wrong.

mod faults;
