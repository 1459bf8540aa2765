//! Surfaces and pictures against twins and optics.

mod drawn_caustics;
mod drawn_thickness;
mod picture;
mod picture_water;
mod support;
mod surface_ellipsoids;
mod surface_switching;
