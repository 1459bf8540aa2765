//! Surfaces and pictures against twins and optics.

mod auto;
mod formats;
mod indirect;
mod mesh;
mod mesh_room;
mod phones;
mod picture;
mod picture_metal;
mod picture_water;
mod solids;
mod step_down;
mod support;
mod surface_ellipsoids;
mod surface_switching;
