//! f64 CPU twin of every stage, and error norms; knows no GPU.
//!
//! Each twin is written from the mathematics of its stage, in f64 and without regard to speed, in a
//! file of the stage's name. Tests run a kernel and its twin on the same input and compare.

pub mod boundary;
pub mod column;
pub mod compression;
pub mod dam_break;
pub mod diffuse;
pub mod emitters;
pub mod forces;
pub mod grid;
pub mod measure;
pub mod norms;
pub mod params;
pub mod particles;
pub mod shared;
pub mod solver;
pub mod step;
pub mod surface;
