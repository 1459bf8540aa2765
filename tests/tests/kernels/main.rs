//! Every kernel against its f64 twin.

mod anisotropic_mesh;
mod anisotropy;
mod bench;
mod boundary;
mod constrain_density;
mod count_covered;
mod drag;
mod drawn_caustics;
mod drawn_sun_volume;
mod drawn_thickness;
mod grid;
mod list;
mod marching_cubes;
mod measure;
mod none;
mod pairs;
mod particles;
mod periodic;
mod refine;
mod sample;
mod scan;
mod slots;
mod solver;
mod step;
mod surface;
mod velocity;
