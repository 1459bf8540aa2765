//! The solids of a scene in its pictures: triangles that are made and uploaded once, and moved on the GPU by the poses that
//! the simulation left there.
//!
//! Opaque ones are drawn before the floor, so that they are in what water refracts and in the depth that hides it. Those of
//! glass are drawn last, in two halves around the water. (Shaders: `frame/solids.hlsl`, `solids_shadow.hlsl`, `glass.hlsl`.)

mod meshes;
mod paint;
pub mod triangles;

use brooklet_fluid::scene::{SolidLook, solids};
use brooklet_fluid::{Recorded, Scene};
use brooklet_gpu::{Blend, Cull, DepthTest, DrawState, Load, Recording, Resources, Targets};
use brooklet_kernels::{
    Buffer, DrawGlass, DrawGlassVariant, DrawSolids, DrawSolidsShadow, DrawSolidsVariant, SolidPaint, SolidPose,
    SolidVertex, SunKeyword, Texture, WaterKeyword, WaterStyle,
};

use crate::FrameOptions;
use crate::formats;
use crate::frame::uniforms::FrameUniforms;
use crate::surface::screen_space::SunVolume;
pub use paint::paint;
use triangles::SolidTriangles;

/// Segments around what is round: an outline that a picture's pixels do not tell from a circle, as long as solids are few.
const SEGMENTS: u32 = 48;
const SEGMENTS_OF_MANY: u32 = 32;
const FEW: usize = 16;

/// The solids that are drawn with a scene's particles.
#[derive(Clone, Copy)]
pub struct Solids<'a> {
    /// Their shapes and looks.
    pub scene: &'a Scene,
    /// Where they are, relative to the domain's lowest corner.
    pub poses: &'a Buffer<SolidPose>,
}

impl<'a> Solids<'a> {
    /// Those of a recorded simulation; none of a scene that has none.
    pub fn of(scene: &'a Scene, recorded: &'a Recorded) -> Option<Self> {
        recorded.solid_poses.as_ref().map(|poses| Self { scene, poses })
    }

    /// The triangles of those that look so.
    pub fn triangles(&self, look: SolidLook) -> SolidTriangles {
        let mut triangles = SolidTriangles::default();
        let segments = if self.scene.solids.len() > FEW { SEGMENTS_OF_MANY } else { SEGMENTS };
        for (number, solid) in (0..).zip(&solids(self.scene).0) {
            let settings = &self.scene.solids[number as usize];
            if settings.look == look {
                triangles.add(number, solid, segments, settings);
            }
        }
        triangles
    }
}

/// What the fluid takes of the sun before it reaches a solid.
pub(crate) enum SunThrough<'a> {
    Nothing,
    Points(&'a Texture),
    Water { volume: &'a SunVolume, style: &'a Buffer<WaterStyle> },
}

/// The solids on the GPU.
pub(crate) struct SolidPasses {
    opaque: Option<(Mesh, Texture)>,
    glass: Option<Mesh>,
    paints: Buffer<SolidPaint>,
    poses: Buffer<SolidPose>,
}

struct Mesh {
    vertices: Buffer<SolidVertex>,
    indices: Buffer<u32>,
}

impl SolidPasses {
    /// Declares what they are drawn from. `init` uploads it.
    pub fn declare(
        resources: &mut Resources,
        init: &mut Recording,
        solids: &Solids<'_>,
        options: &FrameOptions,
    ) -> Self {
        let mut paints = resources.persistent("solid_paints", solids.poses.len);
        let all: Vec<SolidPaint> =
            solids.scene.solids.iter().enumerate().map(|(index, solid)| paint(solid, index)).collect();
        init.upload(&mut paints, &all);
        let mut mesh = |[vertices, indices]: [&str; 2], look| {
            let triangles = solids.triangles(look);
            (!triangles.indices.is_empty()).then(|| {
                let mut mesh = Mesh {
                    vertices: resources.persistent(vertices, triangles.vertices.len() as u32),
                    indices: resources.persistent(indices, triangles.indices.len() as u32),
                };
                init.upload(&mut mesh.vertices, &triangles.vertices);
                init.upload(&mut mesh.indices, &triangles.indices);
                mesh
            })
        };
        let opaque = mesh(["solid_vertices", "solid_indices"], SolidLook::Solid);
        let glass = mesh(["glass_vertices", "glass_indices"], SolidLook::Glass);
        let opaque = opaque.map(|mesh| {
            let formats = formats::depth_buffer(options.tier);
            (mesh, resources.texture_in("solids_shadow_map", formats, [options.shadow_texels; 2]))
        });
        Self { opaque, glass, paints, poses: solids.poses.alias() }
    }

    /// What of the sun the opaque ones hide, if there are any.
    pub fn shadow_map(&self) -> Option<&Texture> {
        self.opaque.as_ref().map(|(_, shadow_map)| shadow_map)
    }

    /// Draws that map.
    pub fn record_shadow(&self, recording: &mut Recording, uniforms: &FrameUniforms) {
        let Some((mesh, shadow_map)) = &self.opaque else { return };
        recording.draw(
            &DrawSolidsShadow {
                solid_indices: mesh.indices.read(),
                solid_vertices: mesh.vertices.read(),
                solid_poses: self.poses.read(),
                light: uniforms.light.uniform(),
            },
            &Targets { color: vec![], depth: Some((shadow_map, Load::Clear(0.0))) },
            DrawState { depth_test: DepthTest::Greater, depth_write: true, ..DrawState::default() },
            mesh.indices.len,
            1,
        );
    }

    /// Draws the opaque ones over what is `drawn`, or to what is cleared; whether there are any.
    pub fn record_opaque(
        &self,
        recording: &mut Recording,
        uniforms: &FrameUniforms,
        (radiance, depth, drawn): (&Texture, &Texture, bool),
        sun: &SunThrough<'_>,
    ) -> bool {
        let Some((mesh, shadow_map)) = &self.opaque else { return false };
        let plain = DrawSolids {
            variant: DrawSolidsVariant { sun: SunKeyword::Off },
            solid_indices: mesh.indices.read(),
            solid_vertices: mesh.vertices.read(),
            solid_poses: self.poses.read(),
            solid_paints: self.paints.read(),
            view: uniforms.view.uniform(),
            solids_shadow_map: shadow_map.read(),
            light: uniforms.light.uniform(),
            style: uniforms.style.uniform(),
            shadow_map: None,
            sun_volume: None,
            volume: None,
            water: None,
        };
        let draw = match sun {
            SunThrough::Nothing => plain,
            SunThrough::Points(map) => DrawSolids {
                variant: DrawSolidsVariant { sun: SunKeyword::PointsSun },
                shadow_map: Some(map.read()),
                ..plain
            },
            SunThrough::Water { volume, style } => DrawSolids {
                variant: DrawSolidsVariant { sun: SunKeyword::VolumeSun },
                sun_volume: Some(volume.above_m.read()),
                volume: Some(volume.params.uniform()),
                water: Some(style.uniform()),
                ..plain
            },
        };
        let targets = match drawn {
            true => Targets { color: vec![(radiance, Load::Keep)], depth: Some((depth, Load::Keep)) },
            false => Targets { color: vec![(radiance, Load::Clear([0.0; 4]))], depth: Some((depth, Load::Clear(0.0))) },
        };
        let nearer =
            DrawState { depth_test: DepthTest::Greater, depth_write: true, cull: Cull::Back, ..DrawState::default() };
        recording.draw(&draw, &targets, nearer, mesh.indices.len, 1);
        true
    }

    /// Draws those of glass over `onto`: all that nothing opaque hides, or with water those behind it or before it.
    pub fn record_glass(
        &self,
        recording: &mut Recording,
        uniforms: &FrameUniforms,
        (onto, depth): (&Texture, &Texture),
        water: Option<(WaterKeyword, &Texture)>,
    ) {
        let Some(mesh) = &self.glass else { return };
        let draw = DrawGlass {
            variant: DrawGlassVariant { water: water.map_or(WaterKeyword::Off, |(keyword, _)| keyword) },
            solid_indices: mesh.indices.read(),
            solid_vertices: mesh.vertices.read(),
            solid_poses: self.poses.read(),
            solid_paints: self.paints.read(),
            view: uniforms.view.uniform(),
            light: uniforms.light.uniform(),
            style: uniforms.style.uniform(),
            inverse_depth: water.map(|(_, inverse_depth)| inverse_depth.read()),
        };
        let targets = Targets { color: vec![(onto, Load::Keep)], depth: Some((depth, Load::Keep)) };
        // What faces away from the eye is behind what faces it.
        for cull in [Cull::Front, Cull::Back] {
            let state = DrawState { depth_test: DepthTest::Greater, blend: Blend::Alpha, cull, ..DrawState::default() };
            recording.draw(&draw, &targets, state, mesh.indices.len, 1);
        }
    }
}
