//! How a picture is drawn.

use brooklet_fluid::Scene;
use brooklet_fluid::scene::PointColor;
use brooklet_kernels::{MeshCounts, Tier};

use crate::RenderError;
use crate::diffuse_look::DiffuseLook;
use crate::surface::marching_cubes::MeshRoom;
use crate::surface::{MarchingCubesOptions, SurfaceOptions};

/// What a particle's colour tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Coloring {
    /// Its speed, from deep blue at rest to white foam at this speed, m/s.
    Speed {
        /// Speed that is drawn white, m/s.
        foam_m_s: f64,
    },
    /// Its fluid. Velocities are then not read.
    Fluid,
    /// Its density ratio, from blue below the rest density over white to red above.
    Density,
}

/// How a picture is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameOptions {
    /// The device's tier: `floor` draws to a 24-bit depth buffer.
    pub tier: Tier,
    /// What is drawn of the fluid.
    pub surface: SurfaceOptions,
    /// Radius of a drawn particle, m.
    pub radius_m: f64,
    /// What colours tell.
    pub coloring: Coloring,
    /// Drawn pixels a side of one picture pixel, 1 to 4: 2 is smooth, 1 costs about a third.
    pub supersample: u32,
    /// Side of the shadow map, texels.
    pub shadow_texels: u32,
    /// Whether the domain's edges are drawn. Safe to drop anywhere: they only show its size.
    pub edges: bool,
    /// How spray, foam and bubbles look, where there are any.
    pub diffuse: Option<DiffuseLook>,
}

impl FrameOptions {
    /// Options that suit a scene: spheres that just overlap, foam at the speed of a fall from the
    /// fluid's top (or the fluids' own speed, without gravity), and four drawn pixels for each of
    /// the picture's, as far as every device has textures of that size.
    pub fn for_scene(scene: &Scene, tier: Tier) -> Self {
        Self {
            tier,
            surface: SurfaceOptions::for_scene(scene, tier),
            radius_m: 0.55 * scene.fitted_spacing_m(),
            coloring: match scene.surface.color_by {
                PointColor::Speed => Coloring::Speed { foam_m_s: foam_m_s(scene) },
                PointColor::Fluid => Coloring::Fluid,
                PointColor::Density => Coloring::Density,
            },
            supersample: if scene.outputs.width_px.max(scene.outputs.height_px) > 2048 { 1 } else { 2 },
            shadow_texels: 512,
            edges: true,
            diffuse: DiffuseLook::for_scene(scene),
        }
    }

    /// The same with at least so much room for the surface's mesh, where one is drawn.
    pub fn with_mesh_room(mut self, room: MeshRoom) -> Self {
        if let Some(mesh) = self.surface.mesh_mut() {
            *mesh = mesh.with_room(mesh.room().max(room));
        }
        self
    }

    /// The room for the surface's mesh, where one is drawn.
    pub fn mesh_room(&self) -> Option<MeshRoom> {
        self.surface.mesh().map(MarchingCubesOptions::room)
    }

    /// Room that the surface's mesh lacked which came to `counts` ([`crate::MarchingCubesOptions::lacked_room`]).
    pub fn lacked_mesh_room(&self, counts: &MeshCounts, spare: f64) -> Option<MeshRoom> {
        self.surface.mesh()?.lacked_room(counts, spare)
    }

    pub(super) fn check(&self) -> Result<(), RenderError> {
        let positive = |field, value: f64| {
            let allowed = "must be above 0 and finite";
            (value.is_finite() && value > 0.0).then_some(()).ok_or(RenderError::not_allowed(field, value, allowed))
        };
        positive("radius_m", self.radius_m)?;
        if let Coloring::Speed { foam_m_s } = self.coloring {
            positive("foam_m_s", foam_m_s)?;
        }
        if !(1..=4).contains(&self.supersample) {
            return Err(RenderError::not_allowed("supersample", self.supersample, "1 to 4 are allowed"));
        }
        if !(16..=4096).contains(&self.shadow_texels) {
            return Err(RenderError::not_allowed("shadow_texels", self.shadow_texels, "16 to 4096 are allowed"));
        }
        match &self.surface {
            SurfaceOptions::ScreenSpace(options) => options.check(),
            SurfaceOptions::MarchingCubes(options, mesh) => options.check().and_then(|()| mesh.check()),
            SurfaceOptions::Auto(options, mesh, auto) => {
                options.check().and_then(|()| mesh.check()).and_then(|()| auto.check())
            }
            SurfaceOptions::Points | SurfaceOptions::None => Ok(()),
        }
    }
}

fn foam_m_s(scene: &Scene) -> f64 {
    let length = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    let top_m = scene
        .fluids
        .iter()
        .map(|fluid| {
            let block = fluid.block.as_ref().map(|block| block.max_m[1]);
            let sphere = fluid.sphere.as_ref().map(|sphere| sphere.centre_m[1] + sphere.radius_m);
            block.or(sphere).unwrap_or(scene.domain.min_m[1]) - scene.domain.min_m[1]
        })
        .fold(0.0, f64::max);
    let own_m_s = scene.fluids.iter().map(|fluid| length(fluid.velocity_m_s)).fold(0.0, f64::max);
    let speed_m_s = (2.0 * length(scene.gravity_m_s2) * top_m).sqrt().max(own_m_s);
    if speed_m_s.is_finite() && speed_m_s > 0.0 { speed_m_s } else { 1.0 }
}
