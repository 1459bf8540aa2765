//! A picture: floor, sky, the domain's edges, solids, the fluid as its surface options say, and the resolve
//! to display colours.

mod auto;
mod look;
pub(crate) mod options;
pub(crate) mod uniforms;

pub use auto::AutoPasses;
pub use options::{Coloring, FrameOptions};
pub use uniforms::{FrameUniforms, FrameValues};

use brooklet_fluid::diffuse::DiffuseSlots;
use brooklet_gpu::{
    Blend, DepthTest, DrawState, Engine, FrameReport, Load, Recording, RecordingId, ResourceId, Resources, Targets,
};
use brooklet_kernels::{
    Buffer, DiffuseStyle, DrawEdges, DrawEdgesVariant, DrawFloor, DrawFloorVariant, DrawResolve, DrawResolveVariant,
    DrawSky, Format, FrameLight, MeshCounts, ShadowKeyword, SurfaceParams, Texture, WaterKeyword, WaterStyle,
};

use crate::diffuse::{self, DiffuseWater};
use crate::formats;
use crate::solids::{SolidPasses, Solids, SunThrough};
use crate::surface::auto::Shown;
use crate::surface::screen_space::{self, Caustics, Shapes, SunVolume, Sunlit, Thickness, Water, sun_volume};
use crate::surface::{MarchingCubesOptions, Particles, ScreenSpaceOptions, SmoothedSurface, SurfaceOptions, points};
use crate::{RenderError, View};

/// A picture's recordings and what they draw to.
#[derive(Debug)]
pub struct FramePasses {
    /// Uploads camera, light and style; to be run once before the first picture.
    pub init: Recording,
    /// Draws the picture.
    pub draw: Recording,
    /// The picture: `Rgba8Unorm`, already sRGB-encoded, of the view's size. This is what to want
    /// of a plan, and to read back.
    pub color: Texture,
    /// Light of what is opaque, and of glass behind water, in the drawn pixels.
    pub radiance: Texture,
    /// Depth of what is opaque in the drawn pixels, supersampled and reversed: near / distance, 0
    /// where the sky is.
    pub depth: Texture,
    /// The water and its light, where it is drawn as a surface.
    pub water: Option<WaterPasses>,
    /// What draws it with a mesh, where `draw` and `water` are screen space and each picture is chosen.
    pub auto: Option<AutoPasses>,
    /// Camera, light and style, to be written when they change.
    pub uniforms: FrameUniforms,
}

impl FramePasses {
    /// What the picture's mesh came to, to be read back with the picture's frame; none where no mesh is drawn.
    pub fn mesh_counts(&self) -> Option<&Buffer<MeshCounts>> {
        let meshed = self.auto.as_ref().map(|auto| &auto.meshed_water).or(self.water.as_ref());
        meshed?.surface.mesh_counts.as_ref()
    }

    /// What draws pictures: a frame runs one of them.
    pub fn recordings(&self) -> impl Iterator<Item = &Recording> {
        [&self.draw].into_iter().chain(self.auto.iter().flat_map(|auto| [&auto.meshed, &auto.both]))
    }

    /// What draws the next picture, of `particles`. `fades`: it follows the last one closely enough for a change of the
    /// surface's method to be seen.
    pub fn next(&mut self, engine: &mut Engine, particles: u32, fades: bool) -> RecordingId {
        let draw = self.draw.id();
        self.auto.as_mut().map_or(draw, |auto| auto.next(engine, draw, particles, fades))
    }

    /// What is read back with the picture that [`FramePasses::next`] chose: what became of its mesh, and what chooses the
    /// next one ([`FramePasses::learn`]).
    pub fn readbacks(&self) -> impl Iterator<Item = ResourceId> {
        let mesh = self.mesh_counts().filter(|_| self.draws_mesh()).map(|counts| counts.id);
        self.auto.iter().map(|auto| auto.covered_px.id).chain(mesh)
    }

    /// Whether the next picture of as many particles would show another method's surface, or more of it.
    pub fn fades(&self, particles: u32) -> bool {
        self.auto.as_ref().is_some_and(|auto| auto.fades(particles))
    }

    /// Whether that picture has a mesh.
    pub fn draws_mesh(&self) -> bool {
        self.auto.as_ref().map_or(self.mesh_counts().is_some(), |auto| auto.shown() != Shown::ScreenSpace)
    }

    /// Takes what a finished frame tells of its picture; what its mesh came to, if it had one.
    pub fn learn(&mut self, report: &FrameReport) -> Option<MeshCounts> {
        if let Some(auto) = &mut self.auto {
            auto.learn(report);
        }
        report.first(self.mesh_counts()?)
    }

    /// Draws on as the passes before these did, of another plan.
    pub fn go_on_from(&mut self, before: &FramePasses) {
        if let (Some(auto), Some(before)) = (&mut self.auto, &before.auto) {
            auto.go_on_from(before);
        }
    }
}

/// What a picture of water is made from.
#[derive(Debug)]
pub struct WaterPasses {
    /// The fluid's surface.
    pub surface: SmoothedSurface,
    /// How much fluid the eye and the sun look through.
    pub thickness: Thickness,
    /// Sunlight on the floor, where it is carried there photon by photon.
    pub caustics: Option<Caustics>,
    /// How much water is nearer the sun, where the water shades itself.
    pub sun_volume: Option<SunVolume>,
    /// Light and optical depth of spray, foam and bubbles, where there are any.
    pub diffuse_light: Option<Texture>,
}

/// Records how particles are drawn.
///
/// # Errors
/// When the view or an option is not allowed; the error names it.
pub fn record(
    resources: &mut Resources,
    view: &View,
    particles: &Particles<'_>,
    options: &FrameOptions,
) -> Result<FramePasses, RenderError> {
    record_with_solids(resources, view, particles, None, options)
}

/// The same with solids among the particles.
///
/// # Errors
/// When the view or an option is not allowed; the error names it.
pub fn record_with_solids(
    resources: &mut Resources,
    view: &View,
    particles: &Particles<'_>,
    solids: Option<Solids<'_>>,
    options: &FrameOptions,
) -> Result<FramePasses, RenderError> {
    let values = FrameValues::new(view, options)?;
    let tells_density = options.surface == SurfaceOptions::Points && options.coloring == Coloring::Density;
    if tells_density && (particles.densities.is_none() || particles.neighbours.is_none()) {
        return Err(RenderError::not_allowed("coloring", options.coloring, "densities need the particles' neighbours"));
    }
    let mut uniforms = FrameUniforms {
        view: resources.persistent("frame_view", 1),
        light: resources.persistent("frame_light", 1),
        style: resources.persistent("frame_style", 1),
    };
    let mut init = resources.recording("draw_init");
    init.upload(&mut uniforms.view, &[values.view]);
    init.upload(&mut uniforms.light, &[values.light]);
    init.upload(&mut uniforms.style, &[values.style]);

    let drawn_px = view.size_px.map(|side| side * options.supersample);
    let radiance = resources.texture_in("radiance", formats::LIGHT, drawn_px);
    let depth = resources.texture_in("depth", formats::depth_buffer(options.tier), drawn_px);
    let color = resources.texture("picture", Format::Rgba8Unorm, view.size_px);
    let mut draw = resources.recording("draw");
    let solids = solids.map(|solids| SolidPasses::declare(resources, &mut init, &solids, options));
    let diffuse = particles.diffuse.zip(options.diffuse).map(|(slots, look)| {
        let mut style = resources.persistent("diffuse_style", 1);
        init.upload(&mut style, &[look.style()]);
        (slots, style)
    });
    let mut frame = Frame {
        resources,
        recording: &mut draw,
        uniforms: &uniforms,
        options,
        light: values.light,
        solids: solids.as_ref(),
        diffuse: diffuse.as_ref().map(|(slots, style)| (*slots, style)),
    };
    let onto = (&radiance, &depth);
    let mut auto = None;
    let water = match &options.surface {
        SurfaceOptions::None => {
            frame.solids_shadow();
            let drawn = frame.solids(onto, false, &SunThrough::Nothing);
            frame.surroundings(onto, ShadowOf::Nothing, drawn);
            frame.edges(&radiance, Some(&depth), None);
            frame.glass(&radiance, &depth, None);
            frame.resolve(&radiance, Some(&depth), None, &color);
            None
        }
        SurfaceOptions::Points => {
            frame.solids_shadow();
            let solids_shadow = frame.solids.and_then(SolidPasses::shadow_map);
            let looks = (frame.uniforms, options, solids_shadow);
            let shadow_map = points::record(frame.resources, frame.recording, looks, particles, onto);
            frame.solids(onto, true, &SunThrough::Points(&shadow_map));
            frame.surroundings(onto, ShadowOf::Points(&shadow_map), true);
            frame.diffuse(onto, None);
            frame.edges(&radiance, Some(&depth), None);
            frame.glass(&radiance, &depth, None);
            frame.resolve(&radiance, Some(&depth), None, &color);
            None
        }
        SurfaceOptions::ScreenSpace(water) => {
            Some(frame.water(&mut init, (view, water, None), particles, onto, &color))
        }
        SurfaceOptions::MarchingCubes(water, mesh) => {
            Some(frame.water(&mut init, (view, water, Some(mesh)), particles, onto, &color))
        }
        SurfaceOptions::Auto(water, mesh, choice) => {
            let (water, passes) =
                auto::record(&mut frame, &mut init, (view, water, mesh, choice), particles, onto, &color);
            auto = Some(passes);
            Some(water)
        }
    };
    Ok(FramePasses { init, draw, color, radiance, depth, water, auto, uniforms })
}

/// What shades the floor.
enum ShadowOf<'a> {
    Nothing,
    Points(&'a Texture),
    Water { sun_thickness: &'a Texture, surface: &'a Buffer<SurfaceParams>, water: &'a Buffer<WaterStyle> },
    Caustics { caustics: &'a Caustics, surface: &'a Buffer<SurfaceParams> },
}

/// A picture's recording in the making.
struct Frame<'a> {
    resources: &'a mut Resources,
    recording: &'a mut Recording,
    uniforms: &'a FrameUniforms,
    options: &'a FrameOptions,
    light: FrameLight,
    solids: Option<&'a SolidPasses>,
    diffuse: Option<(&'a DiffuseSlots, &'a Buffer<DiffuseStyle>)>,
}

impl Frame<'_> {
    /// Records into another recording, of which a frame runs one or the other: what is declared there as it was since there
    /// were `first` resources is the same.
    fn repeating<R>(&mut self, first: usize, recording: &mut Recording, record: impl FnOnce(&mut Frame<'_>) -> R) -> R {
        let Self { uniforms, options, light, solids, diffuse, .. } = *self;
        self.resources.repeating(first, |resources| {
            record(&mut Frame { resources, recording, uniforms, options, light, solids, diffuse })
        })
    }

    /// The shadow map of opaque solids.
    fn solids_shadow(&mut self) {
        if let Some(solids) = self.solids {
            solids.record_shadow(self.recording, self.uniforms);
        }
    }

    /// The opaque solids; whether anything is drawn then.
    fn solids(&mut self, (radiance, depth): (&Texture, &Texture), drawn: bool, sun: &SunThrough<'_>) -> bool {
        let onto = (radiance, depth, drawn);
        drawn | self.solids.is_some_and(|solids| solids.record_opaque(self.recording, self.uniforms, onto, sun))
    }

    /// The solids of glass: all, or with water those behind it or before it.
    fn glass(&mut self, onto: &Texture, depth: &Texture, water: Option<(WaterKeyword, &Texture)>) {
        if let Some(solids) = self.solids {
            solids.record_glass(self.recording, self.uniforms, (onto, depth), water);
        }
    }

    /// Floor and sky. What hides little is drawn after what hides much (`drawn` says whether
    /// anything was), so that hidden pixels are not shaded.
    fn surroundings(&mut self, (radiance, depth): (&Texture, &Texture), shadow: ShadowOf<'_>, drawn: bool) {
        let (view, light, style) =
            (self.uniforms.view.uniform(), self.uniforms.light.uniform(), self.uniforms.style.uniform());
        let solids_shadow_map = self.solids.and_then(SolidPasses::shadow_map);
        let variant = |shadow| DrawFloorVariant { shadow, solids_shadow: solids_shadow_map.is_some() };
        let plain = DrawFloor {
            variant: variant(ShadowKeyword::Off),
            solids_shadow_map: solids_shadow_map.map(Texture::read),
            shadow_map: None,
            sun_thickness: None,
            sun_depth: None,
            caustics: None,
            surface: None,
            water: None,
            view,
            light,
            style,
        };
        let floor = match shadow {
            ShadowOf::Nothing => plain,
            ShadowOf::Points(map) => {
                DrawFloor { variant: variant(ShadowKeyword::PointsShadow), shadow_map: Some(map.read()), ..plain }
            }
            ShadowOf::Water { sun_thickness, surface, water } => DrawFloor {
                variant: variant(ShadowKeyword::WaterShadow),
                sun_thickness: Some(sun_thickness.read()),
                surface: Some(surface.uniform()),
                water: Some(water.uniform()),
                ..plain
            },
            ShadowOf::Caustics { caustics, surface } => DrawFloor {
                variant: variant(ShadowKeyword::CausticsShadow),
                sun_depth: Some(caustics.sun_depth.read()),
                caustics: Some(caustics.light.read()),
                surface: Some(surface.uniform()),
                ..plain
            },
        };
        let first = match drawn {
            true => Targets { color: vec![(radiance, Load::Keep)], depth: Some((depth, Load::Keep)) },
            false => Targets { color: vec![(radiance, Load::Clear([0.0; 4]))], depth: Some((depth, Load::Clear(0.0))) },
        };
        let nearer = DrawState { depth_test: DepthTest::Greater, depth_write: true, ..DrawState::default() };
        self.recording.draw(&floor, &first, nearer, 6, 1);
        let onto = Targets { color: vec![(radiance, Load::Keep)], depth: Some((depth, Load::Keep)) };
        let behind = DrawState { depth_test: DepthTest::GreaterEqual, ..DrawState::default() };
        self.recording.draw(&DrawSky { view, light }, &onto, behind, 3, 1);
    }

    /// The domain's edges: all that no opaque thing hides, or with water those behind it or those
    /// before it.
    fn edges(&mut self, onto: &Texture, depth: Option<&Texture>, water: Option<(WaterKeyword, &Texture)>) {
        if !self.options.edges {
            return;
        }
        let draw = DrawEdges {
            variant: DrawEdgesVariant { water: water.map_or(WaterKeyword::Off, |(keyword, _)| keyword) },
            inverse_depth: water.map(|(_, inverse_depth)| inverse_depth.read()),
            view: self.uniforms.view.uniform(),
            style: self.uniforms.style.uniform(),
        };
        let targets = Targets { color: vec![(onto, Load::Keep)], depth: depth.map(|depth| (depth, Load::Keep)) };
        let depth_test = if depth.is_some() { DepthTest::Greater } else { DepthTest::Off };
        self.recording.draw(
            &draw,
            &targets,
            DrawState { depth_test, blend: Blend::Alpha, ..DrawState::default() },
            6,
            12,
        );
    }

    /// Spray, foam and bubbles over `onto`.
    fn diffuse(&mut self, onto: (&Texture, &Texture), water: Option<&DiffuseWater<'_>>) -> Option<Texture> {
        let diffuse = self.diffuse?;
        Some(diffuse::record(self.resources, self.recording, self.uniforms, diffuse, onto, water))
    }

    fn resolve(&mut self, radiance: &Texture, depth: Option<&Texture>, water: Option<&Texture>, color: &Texture) {
        self.recording.draw(
            &DrawResolve {
                variant: DrawResolveVariant { water: water.is_some() },
                radiance: radiance.read(),
                depth_map: depth.map(Texture::read),
                water: water.map(Texture::read),
                view: self.uniforms.view.uniform(),
                light: self.uniforms.light.uniform(),
                style: depth.map(|_| self.uniforms.style.uniform()),
            },
            &Targets { color: vec![(color, Load::Clear([0.0; 4]))], depth: None },
            DrawState::default(),
            3,
            1,
        );
    }

    /// The surface, smoothed in screen space or meshed, the opaque scene behind it, and the water over that.
    fn water(
        &mut self,
        init: &mut Recording,
        (view, options, mesh): (&View, &ScreenSpaceOptions, Option<&MarchingCubesOptions>),
        particles: &Particles<'_>,
        (radiance, depth): (&Texture, &Texture),
        color: &Texture,
    ) -> WaterPasses {
        let uniforms = self.uniforms;
        let tier = self.options.tier;
        self.solids_shadow();
        let into = (&mut *init, &mut *self.recording);
        let (resources, view_buffer, size_px) = (&mut *self.resources, &uniforms.view, radiance.size_px);
        let surface = match mesh {
            Some(mesh) => {
                let (size, water) = ((size_px, tier), (options, mesh));
                screen_space::record_meshed(resources, into, view_buffer, particles, size, water)
            }
            None => screen_space::record(resources, into, view_buffer, particles, size_px, tier, options),
        };
        let mut style = self.resources.persistent("water_style", 1);
        init.upload(&mut style, &[options.water()]);
        let shapes = Shapes::new(particles, surface.ellipsoids.as_ref());
        let sun = (&uniforms.light, self.options.shadow_texels);
        let sun = screen_space::record_sun_thickness(self.resources, self.recording, &shapes, &surface.params, sun);
        let sunlit = Sunlit { light: &uniforms.light, params: &surface.params, water: &style, sun_thickness: &sun };
        let grid = (options.photons, tier);
        let caustics = (options.photons > 0)
            .then(|| screen_space::record_caustics(self.resources, self.recording, &shapes, &sunlit, grid));
        let shadow = match &caustics {
            Some(caustics) => ShadowOf::Caustics { caustics, surface: &surface.params },
            None => ShadowOf::Water { sun_thickness: &sun, surface: &surface.params, water: &style },
        };
        let volume = options.self_shadow.then(|| {
            let values = sun_volume::params(options.spacing_m, &self.light);
            let into = (&mut *init, &mut *self.recording);
            sun_volume::record(self.resources, into, particles, &uniforms.light, values)
        });
        let through = volume.as_ref().map_or(SunThrough::Nothing, |volume| SunThrough::Water { volume, style: &style });
        let drawn = self.solids((radiance, depth), false, &through);
        self.surroundings((radiance, depth), shadow, drawn);
        let behind = Some((WaterKeyword::BehindWater, &surface.inverse_depth));
        self.edges(radiance, Some(depth), behind);
        self.glass(radiance, depth, behind);
        let size_px = view.size_px.map(|side| side.div_ceil(options.thickness_divisor));
        let looks = (&uniforms.view, depth, size_px);
        let (eye, opaque_planes) =
            screen_space::record_thickness(self.resources, self.recording, &shapes, &surface.params, looks);
        let solids_shadow_map = self.solids.and_then(SolidPasses::shadow_map);
        let seen = if options.metal_reflectance.is_some() {
            let (onto, metal) = ((depth, solids_shadow_map), (&surface, &style, &sun));
            screen_space::record_metal(self.resources, self.recording, uniforms, metal, onto)
        } else {
            let sun_volume = volume.as_ref();
            let water = Water { surface: &surface, thickness: &eye, style: &style, sun_volume, solids_shadow_map };
            screen_space::record_water(self.resources, self.recording, uniforms, &water, (radiance, depth))
        };
        let (inverse_depth, style) = (&surface.inverse_depth, &style);
        let diffuse_light =
            self.diffuse((&seen, depth), Some(&DiffuseWater { inverse_depth, style, solids_shadow_map }));
        // Solids hide edges that are before the water behind them.
        let hiding = solids_shadow_map.map(|_| depth);
        let before = Some((WaterKeyword::BeforeWater, &surface.inverse_depth));
        self.edges(&seen, hiding, before);
        self.glass(&seen, depth, before);
        self.resolve(radiance, None, Some(&seen), color);
        WaterPasses {
            surface,
            thickness: Thickness { eye, opaque_planes, sun },
            caustics,
            sun_volume: volume,
            diffuse_light,
        }
    }
}
