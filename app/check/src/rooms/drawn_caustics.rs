//! Sunlight through water onto the floor, stage by stage against its twins, and against what optics says of calm
//! and of curved water. Each twin gets what the device made before it, bit for bit.

use crate::cases::{out_of_part, vectors};
use crate::compare::nearest_of;
use crate::device::Device;
use crate::drawn::record_frame;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, Wrong, ensure, ensure_eq, note};
use brooklet_fluid::particles::is_simulated;
use brooklet_fluid::scene::Smoothing;
use brooklet_gpu::Plan;
use brooklet_kernels::{FrameLight, Position, SurfaceParams, WaterStyle};
use brooklet_reference::surface::Along;
use brooklet_reference::surface::caustics::{caustics, caustics_doubt};
use brooklet_reference::surface::refract_photons::{self, Photon, refract_photons};
use brooklet_reference::surface::smooth_photons::smooth_photons;
use brooklet_reference::surface::smooth_sun_depth::smooth_sun_depth;
use brooklet_reference::surface::sun_depth::sun_depth;
use brooklet_reference::surface::sun_map::{SunMap, shadow_position, world_from_shadow};
use brooklet_reference::surface::thickness::sun_thickness;
use brooklet_render::frame::FrameValues;
use brooklet_render::{Camera, Coloring, FrameOptions, ScreenSpaceOptions, SurfaceOptions, View};
use glam::{DVec2, DVec3};
use rand::RngExt as _;

/// Of shadow depth, which spans 2.4 m: f32's roundings of sums of a few terms near 1.
const DEPTH_TOLERANCE: f64 = 2e-6;
/// Share of the covered cells whose rays graze a sphere or fall between comparisons.
const UNDECIDED: f64 = 0.01;
/// Of a texel of the sun's map: slopes are differences of f32 depths, a rounding of which over the spacing of
/// photons turns a ray by 1e-5.
const PLACE_TOLERANCE: f64 = 2e-5;
/// Of light, over the sun's: sums of some tens of f16 numbers around 1, each rounded.
const LIGHT_TOLERANCE: f64 = 2e-2;

/// Of the light on the floor, root mean square, that a lattice of particles may make stripes of; 0.55 where only means of both sides smoothed.
const MOST_STRIPES: f64 = 0.1;

const SPACING_M: f64 = 0.05;

fn view() -> View {
    View {
        camera: Camera { eye_m: DVec3::new(0.7, 0.9, 2.6), target_m: DVec3::new(0.5, 0.4, 0.5), fov_deg: 32.0 },
        domain_min_m: DVec3::ZERO,
        domain_max_m: DVec3::ONE,
        size_px: [32, 32],
    }
}

fn options(device: &Device, photons: u32) -> (ScreenSpaceOptions, FrameOptions) {
    let surface = ScreenSpaceOptions {
        spacing_m: SPACING_M,
        radius_m: 0.04,
        wall_bounds_m: [DVec3::ZERO, DVec3::ONE],
        anisotropic: false,
        support_m: 0.1,
        smoothing: Smoothing::None,
        iterations: 0,
        smoothing_m: 0.1,
        most_reach_px: 24,
        range_m: 0.1,
        clamp_m: 0.04,
        thickness_divisor: 2,
        absorption_per_m: DVec3::new(2.0, 0.5, 0.2),
        refraction: 1.0,
        metal_reflectance: None,
        photons,
        self_shadow: false,
    };
    let frame = FrameOptions {
        tier: device.gpu().tier(),
        surface: SurfaceOptions::ScreenSpace(surface),
        radius_m: 0.03,
        coloring: Coloring::Fluid,
        supersample: 1,
        shadow_texels: 2 * photons,
        edges: false,
        diffuse: None,
    };
    (surface, frame)
}

/// A pool as deep as half of its tank, its particles off their lattice by `jitter` of a spacing.
fn pool(jitter: f64) -> Vec<Position> {
    let mut rng = rng(91);
    let position = |i: u32| {
        let lattice = [i % 20, i / 400, i / 20 % 20].map(f64::from);
        let at = lattice.map(|n| SPACING_M * (n + 0.5 + jitter * (rng.random::<f64>() - 0.5)));
        Position { position_m: at.map(|x| x as f32), tag: i }
    };
    (0..20 * 20 * 10).map(position).collect()
}

/// The pool, less a corner, with a ball and drops above it.
fn splash() -> Vec<Position> {
    let mut rng = rng(92);
    let mut all: Vec<Position> =
        pool(0.4).into_iter().filter(|p| p.position_m[0] + p.position_m[2] < 1.5 || p.position_m[1] < 0.1).collect();
    all.extend((0..120).map(|i| Position {
        position_m: [0.2 + 0.3 * rng.random::<f32>(), 0.6 + 0.3 * rng.random::<f32>(), 0.3 + 0.3 * rng.random::<f32>()],
        tag: out_of_part(i),
    }));
    all
}

struct Drawn {
    raw: SunMap,
    smoothed: SunMap,
    thickness: SunMap,
    bent: Vec<Photon>,
    photons: Vec<Photon>,
    light_map: Vec<DVec3>,
    params: SurfaceParams,
    light: FrameLight,
    water: WaterStyle,
}

fn halves(bytes: &[u8]) -> Vec<f64> {
    bytes.chunks_exact(2).map(|pair| f64::from(half::f16::from_le_bytes([pair[0], pair[1]]))).collect()
}

fn draw(device: &Device, positions: &[Position], photons: u32) -> Drawn {
    let (view, (surface, options)) = (view(), options(device, photons));
    let (resources, passes) = record_frame(&view, &options, positions);
    let water = passes.water.or_raise();
    let caustics = water.caustics.or_raise();
    // The picture itself is not wanted here.
    let maps = [caustics.raw.id, caustics.sun_depth.id, caustics.light.id, water.thickness.sun.id];
    let wanted = [&maps[..], &[caustics.bent.id, caustics.photons.id]].concat();
    let ids = [passes.init.id(), passes.draw.id()];
    let plan = Plan::sweep(resources, vec![passes.init, passes.draw], &wanted).or_raise();
    let mut engine = device.engine(plan);
    engine.run(&ids, &[]).or_raise();
    let mut map = |texture| {
        let values: Vec<f32> = bytemuck::pod_collect_to_vec(&engine.read_texture(texture).or_raise());
        SunMap { side: photons as usize, values: values.into_iter().map(f64::from).collect() }
    };
    let (raw, smoothed) = (map(&caustics.raw), map(&caustics.sun_depth));
    let thickness = halves(&engine.read_texture(&water.thickness.sun).or_raise());
    let light_map = halves(&engine.read_texture(&caustics.light).or_raise());
    let [bent, smoothed_photons] = [&caustics.bent, &caustics.photons].map(|photons| {
        let photons = engine.read(photons).or_raise().into_iter().map(|photon| Photon {
            uv: DVec2::from_array(photon.uv.map(f64::from)),
            path_m: photon.path_m.into(),
            share: photon.share.into(),
        });
        photons.collect()
    });
    let absorption_per_m = surface.absorption_per_m.as_vec3().into();
    Drawn {
        raw,
        smoothed,
        thickness: SunMap { side: 2 * photons as usize, values: thickness },
        bent,
        photons: smoothed_photons,
        light_map: light_map.chunks_exact(4).map(DVec3::from_slice).collect(),
        params: surface.params(),
        light: FrameValues::new(&view, &options).or_raise().light,
        water: WaterStyle { absorption_per_m, ..WaterStyle::default() },
    }
}

/// Largest difference of those within the tolerance, and how many of the covered are beyond it.
///
/// # Errors
/// If those are more than [`UNDECIDED`] allows.
fn compare(got: &[f64], expected: &[f64], tolerance: f64) -> Result<(f64, usize), Wrong> {
    ensure_eq!(got.len(), expected.len());
    let covered = expected.iter().filter(|&&value| value != 0.0).count();
    let (mut worst, mut beyond) = (0.0f64, 0);
    for (got, expected) in got.iter().zip(expected) {
        let difference = (got - expected).abs();
        // A NaN is beyond.
        match difference <= tolerance {
            true => worst = worst.max(difference),
            false => beyond += 1,
        }
    }
    match beyond as f64 <= UNDECIDED * covered as f64 {
        true => Ok((worst, beyond)),
        false => Err(format!("{beyond} of {covered} differ by more than {tolerance:e}").into()),
    }
}

pub(crate) fn each_stage_is_its_twin(device: &Device) {
    let positions = splash();
    let drawn: Vec<Position> = positions.iter().copied().filter(|p| is_simulated(p.tag)).collect();
    let snap = device.snap_px();
    // Sizes that no block of 2, 4, 8 or 16 divides.
    for photons in [37, 61] {
        let Drawn { raw, smoothed, thickness, bent, photons: even, light_map, params, light, water } =
            draw(device, &positions, photons);
        let report = |stage: &'static str, tolerance: f64, (worst, beyond): (f64, usize)| {
            device.compared(stage, photons as usize * photons as usize, [worst, tolerance]);
            note!(
                device,
                "kernel {stage}, {photons} a side: tolerance {tolerance:.0e}, largest difference {worst:.1e}, {beyond} undecided"
            );
        };
        let met = |params: &SurfaceParams| -> Vec<f64> {
            let corners = [DVec2::ZERO, DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y].map(|aside| snap * aside);
            nearest_of(&raw.values, &corners.map(|aside| sun_depth(&vectors(&drawn), params, &light, aside).values))
        };
        let matched =
            compare(&raw.values, &met(&params), DEPTH_TOLERANCE).map_err(|wrong| wrong.of("draw_sun_depth")).or_raise();
        report("draw_sun_depth", DEPTH_TOLERANCE, matched);
        let wrong = met(&SurfaceParams { radius_m: 1.05 * params.radius_m, ..params });
        compare(&raw.values, &wrong, DEPTH_TOLERANCE).expect_err("spheres a twentieth larger");

        let smooth = |params: &SurfaceParams| {
            (0..3).fold(raw.clone(), |map, _| {
                smooth_sun_depth(&smooth_sun_depth(&map, params, &light, Along::X), params, &light, Along::Y)
            })
        };
        let matched = compare(&smoothed.values, &smooth(&params).values, DEPTH_TOLERANCE)
            .map_err(|wrong| wrong.of("draw_smooth_sun_depth"))
            .or_raise();
        report("draw_smooth_sun_depth", DEPTH_TOLERANCE, matched);
        let wrong = smooth(&SurfaceParams { sun_smoothing_m: 1.1 * params.sun_smoothing_m, ..params });
        compare(&smoothed.values, &wrong.values, DEPTH_TOLERANCE).expect_err("a reach a tenth longer");

        let expected = sun_thickness(&vectors(&drawn), &params, &light, 2 * photons as usize);
        let most = expected.values.iter().fold(0.0, |a: f64, b| a.max(*b));
        // Some forty discs add up in f16, each sum cut to 2^-10 of itself.
        let tolerance = 0.03 * most;
        let matched = compare(&thickness.values, &expected.values, tolerance)
            .map_err(|wrong| wrong.of("draw_sun_thickness"))
            .or_raise();
        report("draw_sun_thickness", tolerance, matched);
        let wrong: Vec<f64> = expected.values.iter().map(|value| 1.1 * value).collect();
        compare(&thickness.values, &wrong, tolerance).expect_err("a tenth more");

        let flat = |photons: &[Photon]| -> Vec<f64> {
            photons.iter().flat_map(|p| [p.uv.x, p.uv.y, 0.1 * p.path_m, 0.1 * p.share]).collect()
        };
        let expected = refract_photons(&smoothed, &thickness, &params, &light);
        let matched = compare(&flat(&bent), &flat(&expected), PLACE_TOLERANCE)
            .map_err(|wrong| wrong.of("refract_photons"))
            .or_raise();
        report("refract_photons", PLACE_TOLERANCE, matched);
        let wrong = FrameLight { shadow_range_m: 1.0, shadow_v: light.shadow_u, ..light };
        let wrong = refract_photons(&smoothed, &thickness, &params, &wrong);
        compare(&flat(&bent), &flat(&wrong), PLACE_TOLERANCE).expect_err("another sun");
        let unbent = SunMap { side: smoothed.side, values: smoothed.values.iter().map(|d| d.min(0.5)).collect() };
        let wrong = refract_photons(&unbent, &thickness, &params, &light);
        compare(&flat(&bent), &flat(&wrong), PLACE_TOLERANCE).expect_err("another surface");

        let smooth = |params: &SurfaceParams| {
            let half = smooth_photons(&bent, &smoothed, params, &light, Along::X);
            smooth_photons(&half, &smoothed, params, &light, Along::Y)
        };
        let matched = compare(&flat(&even), &flat(&smooth(&params)), PLACE_TOLERANCE)
            .map_err(|wrong| wrong.of("smooth_photons"))
            .or_raise();
        report("smooth_photons", PLACE_TOLERANCE, matched);
        let wrong = smooth(&SurfaceParams { spacing_m: 1.1 * params.spacing_m, ..params });
        compare(&flat(&even), &flat(&wrong), PLACE_TOLERANCE).expect_err("a reach a tenth longer");

        let values = |map: &[DVec3]| -> Vec<f64> { map.iter().flat_map(|color| color.to_array()).collect() };
        // Between what tents give that are all moved the one way or the other.
        let met = |water: &WaterStyle| {
            let expected = caustics(&even, &params, &light, water);
            let doubt = caustics_doubt(&even, &params, &light, water, snap);
            let bounds = [-1.0, 1.0].map(|side| {
                values(&expected.iter().zip(&doubt).map(|(light, doubt)| *light + side * *doubt).collect::<Vec<_>>())
            });
            nearest_of(&values(&light_map), &bounds)
        };
        let matched = compare(&values(&light_map), &met(&water), LIGHT_TOLERANCE)
            .map_err(|wrong| wrong.of("draw_caustics"))
            .or_raise();
        report("draw_caustics", LIGHT_TOLERANCE, matched);
        let wrong = WaterStyle { absorption_per_m: [2.6, 0.5, 0.2], ..water };
        compare(&values(&light_map), &met(&wrong), LIGHT_TOLERANCE).expect_err("darker water");
    }
}

/// Mean and standard deviation of the green light in the middle of a pool, and what optics says of it.
fn evenness(drawn: &Drawn) -> (f64, f64, f64) {
    let texels = drawn.light.shadow_texels as usize;
    let (mut values, mut expected) = (Vec::new(), Vec::new());
    let to_sun = DVec3::from_array(drawn.light.to_sun.map(f64::from));
    let bent = refract_photons::refract(-to_sun, DVec3::Y, 0.7502).or_raise();
    for (index, color) in drawn.light_map.iter().enumerate() {
        let uv = [index % texels, index / texels].map(|at| (at as f64 + 0.5) / texels as f64);
        // On the floor: along the sun's ray to height 0.
        let at_m = world_from_shadow(&drawn.light, DVec3::new(uv[0], uv[1], 0.5));
        let at_m = at_m - to_sun * (at_m.y / to_sun.y);
        // Where all light came in through the top: what comes in through the wall toward the sun, from the left
        // and from behind, ends at 0.68 and 0.60 m, and the tents of its last photons, which fall on glass that they all but graze, up
        // to 0.1 m further. The far walls cut the thickness that is seen along unbent rays.
        let inside = (0.78..0.86).contains(&at_m.x) && (0.74..0.86).contains(&at_m.z);
        if inside {
            values.push(color.y);
            let path_m = 0.5 / -bent.y;
            let reflected = 0.0204 + 0.9796 * (1.0 - to_sun.y).powi(5);
            expected.push((1.0 - reflected) * (-0.5 * path_m).exp());
        }
    }
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let middle = mean(&values);
    let spread = mean(&values.iter().map(|v| (v - middle).powi(2)).collect::<Vec<_>>()).sqrt();
    (middle, spread, mean(&expected))
}

/// Flux is kept and even under calm water: no photon noise, none of the grid's pattern.
pub(crate) fn calm_water_lights_the_floor_evenly(device: &Device) {
    let calm = draw(device, &pool(0.0), 96);
    let (mean, spread, expected) = evenness(&calm);
    note!(device, "calm pool: light {mean:.4} +- {spread:.4}, {expected:.4} by Fresnel, Snell and Beer-Lambert");
    // The water's top stands within a tenth of a spacing of the lattice's: half a percent of light.
    ensure!((mean - expected).abs() < 0.02 * expected, "{mean} {expected}");
    ensure!(spread < 0.03 * mean, "{spread}");
    // The measure can fail: rough water is not even.
    let mut rough = pool(0.0);
    for particle in &mut rough {
        particle.position_m[1] *= 1.0 + 0.1 * (12.0 * particle.position_m[0]).sin();
    }
    let (_, spread, _) = evenness(&draw(device, &rough, 96));
    note!(device, "waves: +- {spread:.4}");
    ensure!(spread > 0.1 * mean, "{spread}");
}

/// How much light on the floor differs from the mean of what is half a spacing to both sides along z, where stripes of
/// a lattice would have their dark: root mean square over the mean.
fn stripes(drawn: &Drawn) -> f64 {
    let map = SunMap {
        side: drawn.light.shadow_texels as usize,
        values: drawn.light_map.iter().map(|color| color.y).collect(),
    };
    let light_at = |x: f64, z: f64| {
        let at = shadow_position(&drawn.light, DVec3::new(x, 0.0, z));
        map.bilinear(at.x, at.y)
    };
    let half_m = 0.5 * SPACING_M;
    let places: Vec<(f64, f64)> =
        (0..90 * 60).map(|i| (0.1 + 0.01 * f64::from(i % 90), 0.2 + 0.01 * f64::from(i / 90))).collect();
    let squares = places
        .iter()
        .map(|&(x, z)| (light_at(x, z) - 0.5 * (light_at(x, z - half_m) + light_at(x, z + half_m))).powi(2));
    let mean = places.iter().map(|&(x, z)| light_at(x, z)).sum::<f64>() / places.len() as f64;
    (squares.sum::<f64>() / places.len() as f64).sqrt() / mean
}

pub(crate) fn a_lattice_does_not_comb_the_light(device: &Device) {
    // A column that leans over: its front is a lattice's rows, seen by the sun edge on.
    let column: Vec<Position> = (0..14 * 12 * 20)
        .map(|i| {
            let at = [i % 14, i / 280, i / 14 % 20].map(|n| SPACING_M * (f64::from(n) + 0.5));
            let lean_m = 0.15 * (at[0] / 0.7).powi(2) * at[1];
            Position { position_m: [at[0] as f32, (at[1] - lean_m) as f32, at[2] as f32], tag: i }
        })
        .collect();
    let lattice = stripes(&draw(device, &column, 128));
    // The measure can fail: water with waves of four spacings.
    let mut corrugated = column;
    for particle in &mut corrugated {
        particle.position_m[1] -= if particle.tag / 14 % 4 < 2 { 0.04 } else { 0.0 };
    }
    let wavy = stripes(&draw(device, &corrugated, 128));
    note!(
        device,
        "stripes of a lattice: {lattice:.4} of the light, {wavy:.4} of a corrugated one; at most {MOST_STRIPES}"
    );
    ensure!(lattice <= MOST_STRIPES, "{lattice}");
    ensure!(wavy > MOST_STRIPES, "{wavy}");
}

/// Every photon's light arrives, whatever the water does to it.
pub(crate) fn flux_is_kept(device: &Device) {
    let drawn = draw(device, &splash(), 61);
    let texels = f64::from(drawn.light.shadow_texels);
    let params = drawn.params;
    let clear = WaterStyle { absorption_per_m: [0.0; 3], ..drawn.water };
    let inside = |photon: &&Photon| {
        photon.share > 0.0 && photon.uv.cmpge(DVec2::splat(0.1)).all() && photon.uv.cmple(DVec2::splat(0.9)).all()
    };
    let kept: Vec<Photon> =
        drawn.photons.iter().map(|p| if inside(&p) { *p } else { Photon { share: 0.0, ..*p } }).collect();
    let sent: f64 = kept.iter().map(|photon| photon.share).sum::<f64>() / f64::from(params.photons).powi(2);
    let arrived: f64 =
        caustics(&kept, &params, &drawn.light, &clear).iter().map(|color| color.y).sum::<f64>() / (texels * texels);
    note!(device, "flux: sent {sent:.5}, arrived {arrived:.5} of the map's");
    // Tents of a texel's width are summed by texels: exact along the map's axes, within some percent across.
    ensure!(sent > 0.1 && (arrived / sent - 1.0).abs() < 0.02, "{sent} {arrived}");
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sun overhead, its map 1 m wide and a metre deep around a point of the floor.
    fn overhead(texels: usize) -> FrameLight {
        FrameLight {
            to_sun: [0.0, 1.0, 0.0],
            shadow_range_m: 4.0,
            shadow_texels: texels as f32,
            shadow_u: [1.0, 0.0, 0.0, 0.5],
            shadow_v: [0.0, 0.0, 1.0, 0.5],
            shadow_depth: [0.0, 0.25, 0.0, 0.1],
            shadow_texel_m: 1.0 / texels as f32,
            ..FrameLight::default()
        }
    }

    /// A lens of water of radius of curvature R focuses overhead light n R / (n - 1) below its top.
    #[test]
    fn curved_water_focuses_where_optics_says() {
        let (side, radius_m) = (101usize, 0.5f64);
        let light = overhead(2 * side);
        let params = SurfaceParams {
            spacing_m: 0.01,
            range_m: 0.5,
            wall_min_m: [-10.0; 3],
            wall_max_m: [10.0; 3],
            photons: side as f32,
            ..SurfaceParams::default()
        };
        let focal_m = radius_m / (1.0 - 0.7502);
        // Mean distance from the axis at which the middle's photons land, over that at which they enter.
        let gathered = |depth_m: f64| {
            let empty = SunMap { side, values: Vec::new() };
            let height_m = |(x, y): (i64, i64)| {
                let [x, z] = [x, y].map(|at| (at as f64 + 0.5) / side as f64 - 0.5);
                depth_m - radius_m + (radius_m * radius_m - x * x - z * z).max(0.2).sqrt()
            };
            let depths = empty.texels().map(|at| shadow_position(&light, DVec3::new(0.0, height_m(at), 0.0)).z);
            let surface = SunMap { side, values: depths.collect() };
            let water = SunMap { side: 2 * side, values: vec![depth_m / 0.01; 4 * side * side] };
            let photons = refract_photons(&surface, &water, &params, &light);
            let (mut entered, mut landed) = (0.0, 0.0);
            for (photon, (x, y)) in photons.iter().zip(empty.texels()) {
                let from = DVec2::new(x as f64 + 0.5, y as f64 + 0.5) / side as f64 - 0.5;
                // Near the axis: beyond, spherical aberration is no mistake.
                if from.length() < 0.06 {
                    entered += from.length();
                    landed += (photon.uv - 0.5).length();
                }
            }
            let brightest = caustics(&photons, &params, &light, &WaterStyle::default());
            (landed / entered, brightest.iter().map(|color| color.y).fold(0.0, f64::max))
        };
        let [(half, dim), (at_focus, bright), (beyond, _)] = [0.5, 1.0, 1.5].map(|share| gathered(share * focal_m));
        println!(
            "lens of {radius_m} m, focus at {focal_m:.3} m: gathered to {half:.3}, {at_focus:.3}, {beyond:.3}; brightest {dim:.1}, {bright:.1}"
        );
        // Rays straight on from entry to focus; the aberration at 0.06 m is under a hundredth of it.
        assert!((half - 0.5).abs() < 0.02 && at_focus < 0.03 && (beyond - 0.5).abs() < 0.03);
        assert!(bright > 10.0 * dim && dim > 2.0, "{dim} {bright}");
    }
}
