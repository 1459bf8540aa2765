//! The run's pictures: the render room's recordings beside the simulation's.

use std::path::Path;

use brooklet_fluid::{Recorded, Scene};
use brooklet_gpu::{Engine, Recording, ResourceId, Resources, Texture, Tier};
use brooklet_render::{FrameOptions, Particles, View, png};

use crate::failure::Failure;

/// A picture of the particles as they are on the GPU.
pub struct Picture {
    color: Texture,
}

impl Picture {
    /// Records how the scene is drawn from its own camera; the recordings are that of the
    /// uniforms, which runs once first, and that of a picture.
    pub fn record(
        resources: &mut Resources,
        scene: &Scene,
        recorded: &Recorded,
        tier: Tier,
    ) -> Result<(Self, [Recording; 2]), Failure> {
        let passes = brooklet_render::record(
            resources,
            &View::of_scene(scene),
            &Particles::of(recorded),
            &FrameOptions::for_scene(scene, tier),
        )
        .map_err(|error| Failure::Input(format!("scene {}: {error}", scene.name)))?;
        let picture = Self { color: passes.color };
        Ok((picture, [passes.init, passes.recording]))
    }

    /// What a plan with pictures wants.
    pub fn id(&self) -> ResourceId {
        self.color.id
    }

    /// Waits for the last picture that was drawn, and copies it to the host.
    pub fn read(&self, engine: &mut Engine) -> Result<Vec<u8>, Failure> {
        engine.read_texture(&self.color).map_err(Failure::stopped)
    }

    /// Writes a picture that was read.
    pub fn save(&self, path: &Path, rgba: &[u8]) -> Result<(), Failure> {
        png::save(path, self.color.size_px, rgba).map_err(Failure::stopped)
    }
}
