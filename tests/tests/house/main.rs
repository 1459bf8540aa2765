//! The repository keeps its own rules, and its shaders are fresh.

mod project;
mod reload;
mod shaders;
mod shaders_parts;
mod shaders_unity;
