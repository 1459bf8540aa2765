//! A picture of the particles: shadow map, spheres, floor, sky, the domain's edges, and the
//! resolve to display colours.

mod look;

use brooklet_fluid::Scene;
use brooklet_gpu::{Blend, DepthTest, DrawState, Load, Recording, Resources, Targets};
use brooklet_kernels::{
    Buffer, DrawEdges, DrawFloor, DrawParticles, DrawResolve, DrawShade, DrawShadeVariant, DrawShadow, DrawSky, Format,
    FrameLight, FrameStyle, FrameView, Position, Texture, Tier, Velocity,
};

use crate::{RenderError, View};

/// Name of the recording that uploads camera, light and style; run it once before [`DRAW`].
pub const DRAW_INIT: &str = "draw_init";
/// Name of the recording that draws a picture.
pub const DRAW: &str = "draw";

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
}

/// How a picture is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameOptions {
    /// The device's tier: `floor` draws to a 24-bit depth buffer.
    pub tier: Tier,
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
}

impl FrameOptions {
    /// Options that suit a scene: spheres that just overlap, foam at the speed of a fall from the
    /// fluid's top (or the fluids' own speed, without gravity), and four drawn pixels for each of
    /// the picture's, as far as every device has textures of that size.
    pub fn for_scene(scene: &Scene, tier: Tier) -> Self {
        Self {
            tier,
            radius_m: 0.55 * scene.spacing_m,
            coloring: Coloring::Speed { foam_m_s: foam_m_s(scene) },
            supersample: if scene.outputs.width_px.max(scene.outputs.height_px) > 2048 { 1 } else { 2 },
            shadow_texels: 512,
            edges: true,
        }
    }

    fn check(&self) -> Result<(), RenderError> {
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
        Ok(())
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

/// Camera, light and style on the GPU.
#[derive(Debug)]
pub struct FrameUniforms {
    /// The camera.
    pub view: Buffer<FrameView>,
    /// The sun, its shadow map and the sky.
    pub light: Buffer<FrameLight>,
    /// What is drawn and how it looks.
    pub style: Buffer<FrameStyle>,
}

/// What [`FrameUniforms`] hold for a view: what [`DRAW_INIT`] uploads, and what a moving camera
/// writes before each picture (`engine.write(&uniforms.view, &[values.view])`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameValues {
    /// The camera.
    pub view: FrameView,
    /// The sun, its shadow map and the sky.
    pub light: FrameLight,
    /// What is drawn and how it looks.
    pub style: FrameStyle,
}

impl FrameValues {
    /// The values for a view.
    ///
    /// # Errors
    /// When the view or an option is not allowed; the error names it.
    pub fn new(view: &View, options: &FrameOptions) -> Result<Self, RenderError> {
        view.check()?;
        options.check()?;
        Ok(Self {
            view: look::frame_view(view, options),
            light: look::frame_light(view, options),
            style: look::frame_style(view, options),
        })
    }
}

/// A picture's recordings and what they draw to.
#[derive(Debug)]
pub struct FramePasses {
    /// Uploads camera, light and style: [`DRAW_INIT`].
    pub init: Recording,
    /// Draws the picture: [`DRAW`].
    pub recording: Recording,
    /// The picture: `Rgba8Unorm`, already sRGB-encoded, of the view's size. This is what to want
    /// of a plan, and to read back.
    pub color: Texture,
    /// Depth of the drawn pixels, supersampled and reversed: near / distance, 0 where the sky is.
    pub depth: Texture,
    /// Camera, light and style, to be written when they change.
    pub uniforms: FrameUniforms,
}

/// Records how `particle_count` particles are drawn. Positions are relative to the view's
/// `domain_min_m`.
///
/// # Errors
/// When the view or an option is not allowed; the error names it.
pub fn record(
    resources: &mut Resources,
    view: &View,
    positions: &Buffer<Position>,
    velocities: &Buffer<Velocity>,
    particle_count: u32,
    options: &FrameOptions,
) -> Result<FramePasses, RenderError> {
    let values = FrameValues::new(view, options)?;
    let mut uniforms = FrameUniforms {
        view: resources.state("frame_view", 1),
        light: resources.state("frame_light", 1),
        style: resources.state("frame_style", 1),
    };
    let mut init = Recording::new(DRAW_INIT);
    init.upload(&mut uniforms.view, &[values.view]);
    init.upload(&mut uniforms.light, &[values.light]);
    init.upload(&mut uniforms.style, &[values.style]);

    let depth_format = if options.tier == Tier::Floor { Format::Depth24Plus } else { Format::Depth32Float };
    let drawn_px = view.size_px.map(|side| side * options.supersample);
    let shadow_map = resources.texture("shadow_map", depth_format, [options.shadow_texels; 2]);
    // R32Float holds every index below 2^24 exactly, and every tier can draw to it.
    let seen = resources.texture("seen", Format::R32Float, drawn_px);
    let radiance = resources.texture("radiance", Format::Rgba16Float, drawn_px);
    let depth = resources.texture("depth", depth_format, drawn_px);
    let color = resources.texture("picture", Format::Rgba8Unorm, view.size_px);
    let (frame_view, frame_light, frame_style) =
        (uniforms.view.uniform(), uniforms.light.uniform(), uniforms.style.uniform());

    let mut recording = Recording::new(DRAW);
    let nearer = DrawState { depth_test: DepthTest::Greater, depth_write: true, ..DrawState::default() };
    recording.draw(
        &DrawShadow { positions: positions.read(), light: frame_light, style: frame_style },
        &Targets { color: vec![], depth: Some((&shadow_map, Load::Clear(0.0))) },
        nearer,
        3,
        particle_count,
    );
    recording.draw(
        &DrawParticles { positions: positions.read(), view: frame_view, style: frame_style },
        &Targets { color: vec![(&seen, Load::Clear([0.0; 4]))], depth: Some((&depth, Load::Clear(0.0))) },
        nearer,
        3,
        particle_count,
    );
    let color_fluid = options.coloring == Coloring::Fluid;
    recording.draw(
        &DrawShade {
            variant: DrawShadeVariant { color_fluid },
            seen: seen.read(),
            positions: positions.read(),
            velocities: (!color_fluid).then(|| velocities.read()),
            shadow_map: shadow_map.read(),
            view: frame_view,
            light: frame_light,
            style: frame_style,
        },
        &Targets { color: vec![(&radiance, Load::Clear([0.0; 4]))], depth: None },
        DrawState::default(),
        3,
        1,
    );
    // What hides little is drawn after what hides much, so that hidden pixels are not shaded.
    let onto = Targets { color: vec![(&radiance, Load::Keep)], depth: Some((&depth, Load::Keep)) };
    recording.draw(
        &DrawFloor { shadow_map: shadow_map.read(), view: frame_view, light: frame_light, style: frame_style },
        &onto,
        nearer,
        6,
        1,
    );
    recording.draw(
        &DrawSky { view: frame_view, light: frame_light },
        &onto,
        DrawState { depth_test: DepthTest::GreaterEqual, ..DrawState::default() },
        3,
        1,
    );
    if options.edges {
        recording.draw(
            &DrawEdges { view: frame_view, style: frame_style },
            &onto,
            DrawState { depth_test: DepthTest::Greater, blend: Blend::Alpha, ..DrawState::default() },
            6,
            12,
        );
    }
    recording.draw(
        &DrawResolve {
            radiance: radiance.read(),
            depth_map: depth.read(),
            view: frame_view,
            light: frame_light,
            style: frame_style,
        },
        &Targets { color: vec![(&color, Load::Clear([0.0; 4]))], depth: None },
        DrawState::default(),
        3,
        1,
    );
    Ok(FramePasses { init, recording, color, depth, uniforms })
}
