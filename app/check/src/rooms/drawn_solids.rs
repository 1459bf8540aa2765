//! Solids where their poses put them, in the light of sun and sky, and glass over what is behind it: against rays that are
//! cast at the same triangles in f64. And those triangles against the shapes that they stand for.

use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, ensure, ensure_eq, note};
use brooklet_fluid::scene::solids;
use brooklet_fluid::scene::{Scene, SolidLook};
use brooklet_fluid::{Slots, visit_slots};
use brooklet_gpu::{Plan, Resources, Tier};
use brooklet_kernels::{FrameLight, FrameStyle, SHAPE_BOX, SHAPE_CAPSULE, SHAPE_FIELD, Solid, SolidPaint, SolidPose};
use brooklet_reference::surface::ray_of;
use brooklet_reference::surface::solids::{SolidHit, SolidScene, glass_film, solid_light};
use brooklet_render::frame::FrameValues;
use brooklet_render::solids::paint;
use brooklet_render::{Camera, Coloring, FrameOptions, Particles, Solids, SurfaceOptions, View};
use glam::{DQuat, DVec2, DVec3, EulerRot};
use rand::RngExt as _;

/// Of a color, relative to it or to a dim gray: f16 rounds each of some blends to 2^-11.
const LIGHT_TOLERANCE: f64 = 0.01;
/// Of reversed depth.
const DEPTH_TOLERANCE: f64 = 5e-5;
/// Share of the covered pixels on an edge, where a device may see one face or the other, and of those that it may see so besides
/// for each pixel that it snaps vertices by. With 4 bits of subpixels, a sixteenth, SwiftShader had .053 of solids and .085 of
/// glass, which shows its edges twice.
const ON_EDGES: [f64; 2] = [0.03, 1.2];
/// As far as the widest of a soft shadow's taps, in texels of the map, and a few more.
const SOFT_TEXELS: f64 = 5.0;
const SIZES: [[u32; 2]; 2] = [[96, 64], [37, 53]];

const OPAQUE: &str = "
[[solid]]
box = { size_m = [0.3, 0.2, 0.25] }
[[solid]]
cylinder = { radius_m = 0.16, length_m = 0.3 }
thickness_m = 0.03
open = \"y_max\"
[[solid]]
capsule = { radius_m = 0.1, length_m = 0.4 }
color = [0.2, 0.9, 0.4]
[[solid]]
box = { size_m = [0.3, 0.3, 0.2] }
thickness_m = 0.03
open = \"ends\"
";
/// Hulls with hard edges, and ground.
const TRIANGLES: &str = "
[[solid]]
hull = { points_m = [[-0.15, -0.1, 0], [0.16, -0.1, 0.1], [0, 0.14, 0.03], [0, -0.1, -0.16], [0.03, 0.02, 0.17]] }
[[solid]]
terrain = { size_m = [0.4, 0.12, 0.4], feature_m = 0.3, seed = 5 }
[[solid]]
hull = { points_m = [[-0.12, 0, 0], [0.12, 0, 0], [0, 0.12, 0], [0, -0.12, 0], [0, 0, 0.12], [0, 0, -0.12]] }
";
const GLASS: &str = "
[[solid]]
box = { size_m = [0.3, 0.2, 0.25] }
[[solid]]
cylinder = { radius_m = 0.16, length_m = 0.3 }
thickness_m = 0.03
open = \"y_max\"
look = \"glass\"
[[solid]]
sphere = { radius_m = 0.12 }
thickness_m = 0.03
look = \"glass\"
[[solid]]
box = { size_m = [0.3, 0.3, 0.2] }
thickness_m = 0.03
open = \"z_min\"
look = \"glass\"
[[solid]]
hull = { points_m = [[-0.12, 0, 0], [0.12, 0, 0], [0, 0.12, 0], [0, -0.12, 0], [0, 0, 0.12], [0, 0, -0.12]] }
look = \"glass\"
";

fn scene(solids: &str) -> Scene {
    let text = format!(
        "spacing_m = 0.05\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [1, 1, 1]\n[[fluid]]\n\
         block = {{ min_m = [0, 0, 0], max_m = [0.1, 0.1, 0.1] }}\n{solids}[solver]\nmethod = \"none\"\n"
    );
    Scene::from_toml(&text, "solids", &[]).or_raise()
}

/// Around the middle of the domain, turned in any way, so that some stand before and in each other.
fn poses(count: usize, seed: u64) -> Vec<SolidPose> {
    let mut rng = rng(seed);
    let pose = |number: usize| {
        let [x, y, z] = [0, 1, 2].map(|_| rng.random::<f64>());
        let corner = DVec3::new((number % 2) as f64, 0.0, (number / 2) as f64);
        let position_m = DVec3::new(0.28, 0.35, 0.28) + 0.44 * corner + 0.1 * DVec3::new(x, 2.0 * y, z);
        let [a, b, c] = [0, 1, 2].map(|_| std::f64::consts::TAU * rng.random::<f64>());
        let rotation = DQuat::from_euler(EulerRot::XYZ, a, b, c).as_quat().to_array();
        SolidPose { position_m: position_m.as_vec3().into(), rotation, ..SolidPose::default() }
    };
    (0..count).map(pose).collect()
}

struct Drawn {
    light: Vec<DVec3>,
    /// Reversed; empty where it cannot be read back.
    depth: Vec<f32>,
    values: FrameValues,
}

fn draw(device: &Device, scene: &Scene, poses: &[SolidPose], size_px: [u32; 2]) -> Drawn {
    let view = View {
        camera: Camera { eye_m: DVec3::new(0.9, 1.3, 2.6), target_m: DVec3::new(0.5, 0.4, 0.5), fov_deg: 25.0 },
        domain_min_m: DVec3::ZERO,
        domain_max_m: DVec3::ONE,
        size_px,
    };
    let options = FrameOptions {
        tier: device.gpu().tier(),
        surface: SurfaceOptions::None,
        radius_m: 0.03,
        coloring: Coloring::Fluid,
        supersample: 1,
        shadow_texels: 512,
        edges: false,
        diffuse: None,
    };
    let mut resources = Resources::new();
    let positions = resources.persistent("positions", 1);
    let velocities = resources.persistent("velocities", 1);
    let mut slots = Slots::declare(&mut resources, 1);
    let mut moved = resources.persistent("solid_poses", poses.len() as u32);
    let particles = Particles {
        positions: &positions,
        velocities: &velocities,
        slots: &slots,
        neighbours: None,
        densities: None,
        diffuse: None,
    };
    let solids = Solids { scene, poses: &moved };
    let mut passes =
        brooklet_render::record_with_solids(&mut resources, &view, &particles, Some(solids), &options).or_raise();
    passes.init.upload(&mut slots.state, &[visit_slots(0)]);
    passes.init.upload(&mut moved, poses);
    let ids = [passes.init.id(), passes.draw.id()];
    let wanted = [passes.color.id, passes.radiance.id, passes.depth.id];
    let plan = Plan::sweep(resources, vec![passes.init, passes.draw], &wanted).or_raise();
    let mut engine = device.engine(plan);
    engine.run(&ids, &[]).or_raise();
    let bytes = engine.read_texture(&passes.radiance).or_raise();
    let halves: Vec<f64> =
        bytes.chunks_exact(2).map(|pair| f64::from(half::f16::from_le_bytes([pair[0], pair[1]]).to_f32())).collect();
    let light: Vec<DVec3> = halves.chunks_exact(4).map(DVec3::from_slice).collect();
    ensure_eq!(light.len(), (size_px[0] * size_px[1]) as usize);
    let depth = match options.tier {
        Tier::Floor => Vec::new(),
        _ => bytemuck::pod_collect_to_vec(&engine.read_texture(&passes.depth).or_raise()),
    };
    Drawn { light, depth, values: FrameValues::new(&view, &options).or_raise() }
}

fn cast(scene: &Scene, poses: &[SolidPose], look: SolidLook) -> SolidScene {
    let shapes = Resources::new().persistent("solid_poses", poses.len() as u32);
    let triangles = Solids { scene, poses: &shapes }.triangles(look);
    let paints: Vec<SolidPaint> = scene.solids.iter().enumerate().map(|(index, solid)| paint(solid, index)).collect();
    SolidScene::new(&triangles.vertices, &triangles.indices, poses, &paints)
}

fn vector(of: [f32; 3]) -> DVec3 {
    DVec3::from_array(of.map(f64::from))
}

/// What a pixel may show at least and at most of a solid that a ray meets: the sun's light, none of it, or, near a shadow's
/// border, anything between.
fn bounds(scene: &SolidScene, hit: &SolidHit, eye_m: DVec3, (light, style): (&FrameLight, &FrameStyle)) -> Lit {
    let (normal, to_sun) = (hit.at.normal, vector(light.to_sun));
    let texel_m = f64::from(light.shadow_texel_m);
    let shown = |sun| solid_light(&hit.at, eye_m, sun, (light, style));
    let across = to_sun.any_orthonormal_pair();
    let above_m = hit.at.position_m + 1.5 * texel_m * normal;
    // On the surface's own plane, as the map's taps are compared.
    let is_shaded = |turn: f64| {
        let aside = SOFT_TEXELS * texel_m * (turn.cos() * across.0 + turn.sin() * across.1);
        let at_m = above_m + aside - normal.dot(aside) / normal.dot(to_sun).max(0.15) * to_sun;
        scene.is_shaded(at_m, light)
    };
    if normal.dot(to_sun) <= 0.0 {
        return Lit { low: shown(0.0), high: shown(0.0), sun: None };
    }
    let here = scene.is_shaded(above_m, light);
    let agree = (0..8).all(|turn| is_shaded(f64::from(turn) * std::f64::consts::FRAC_PI_4) == here);
    let sun = f64::from(u8::from(!here));
    match agree {
        true => Lit { low: shown(sun), high: shown(sun), sun: Some(!here) },
        false => Lit { low: shown(0.0), high: shown(1.0), sun: None },
    }
}

struct Lit {
    low: DVec3,
    high: DVec3,
    /// Whether the sun arrives, where that is certain.
    sun: Option<bool>,
}

/// How far outside of what is allowed a color is, over the tolerance; a NaN is.
fn off(got: DVec3, low: DVec3, high: DVec3) -> f64 {
    let beyond = (low - got).max(got - high).max(DVec3::ZERO) / high.max(DVec3::splat(0.1));
    if got.is_finite() { beyond.max_element() / LIGHT_TOLERANCE } else { f64::INFINITY }
}

#[derive(Default)]
struct Compared {
    covered: usize,
    beyond: usize,
    worst: f64,
    lit: usize,
    shaded: usize,
}

fn compare(drawn: &Drawn, scene: &SolidScene, size_px: [u32; 2]) -> Compared {
    let FrameValues { view, light, style } = &drawn.values;
    let (eye_m, size) = (vector(view.eye_m), size_px.map(|side| side as usize));
    let mut compared = Compared::default();
    for (index, &got) in drawn.light.iter().enumerate() {
        let ray = ray_of(view, size, index, DVec2::ZERO);
        let Some(hit) = scene.first(eye_m, ray) else { continue };
        let lit = bounds(scene, &hit, eye_m, (light, style));
        let mut differs = off(got, lit.low, lit.high);
        if let Some(&depth) = drawn.depth.get(index) {
            let expected = f64::from(view.near_m) / hit.along;
            differs =
                differs.max((f64::from(depth) - expected).abs() / expected / DEPTH_TOLERANCE / device_slope(&hit, ray));
        }
        compared.covered += 1;
        compared.lit += usize::from(lit.sun == Some(true));
        compared.shaded += usize::from(lit.sun == Some(false));
        if differs <= 1.0 {
            compared.worst = compared.worst.max(differs);
        } else {
            compared.beyond += 1;
        }
    }
    compared
}

/// Depth changes the faster from pixel to pixel the flatter a face is looked along.
fn device_slope(hit: &SolidHit, ray: DVec3) -> f64 {
    1.0 / hit.at.normal.dot(ray.normalize()).abs().max(0.02)
}

/// Share of the covered pixels that may differ.
fn on_edges(device: &Device) -> f64 {
    ON_EDGES[0] + ON_EDGES[1] * device.snap_px()
}

pub(crate) fn solids_are_lit_where_their_poses_put_them(device: &Device) {
    let cases = (30..).zip(SIZES).map(|(seed, size_px)| (OPAQUE, seed, size_px));
    let mut in_shadow = 0;
    for (text, seed, size_px) in cases.chain([(TRIANGLES, 32, SIZES[0])]) {
        let scene = scene(text);
        let poses = poses(scene.solids.len(), seed);
        let drawn = draw(device, &scene, &poses, size_px);
        let twin = cast(&scene, &poses, SolidLook::Solid);
        let Compared { covered, beyond, worst, lit, shaded } = compare(&drawn, &twin, size_px);
        ensure!(covered > drawn.light.len() / 10, "only {covered} pixels show a solid");
        ensure!(lit > covered / 10, "only {lit} pixels of {covered} are in the sun");
        in_shadow += shaded;
        ensure!(
            (beyond as f64) < on_edges(device) * covered as f64,
            "{beyond} of {covered} pixels differ, the others by {worst:.2} of the tolerance"
        );
        device.compared("draw_solids", covered, [worst * LIGHT_TOLERANCE, LIGHT_TOLERANCE]);
        device.compared("draw_solids_shadow", shaded, [worst * LIGHT_TOLERANCE, LIGHT_TOLERANCE]);
        note!(
            device,
            "draw_solids {size_px:?}: {beyond} of {covered} pixels on edges, the others within {worst:.2}; {lit} lit, {shaded} shaded"
        );

        // Solids that are a little elsewhere, or turned a little, are told apart.
        let mut moved = poses.clone();
        moved.iter_mut().for_each(|pose| pose.position_m[0] += 0.06);
        let mut turned = poses.clone();
        for pose in &mut turned {
            let rotation = DQuat::from_array(pose.rotation.map(f64::from));
            pose.rotation = (DQuat::from_rotation_z(0.3) * rotation).as_quat().to_array();
        }
        for wrong in [moved, turned] {
            let Compared { covered, beyond, .. } = compare(&drawn, &cast(&scene, &wrong, SolidLook::Solid), size_px);
            ensure!(beyond as f64 > on_edges(device) * covered as f64, "a wrong pose passes: {beyond} of {covered}");
        }
    }
    ensure!(in_shadow > 50, "only {in_shadow} pixels are in another solid's shadow");
}

pub(crate) fn glass_lets_through_what_its_twin_does(device: &Device) {
    let scene = scene(GLASS);
    let mut bare = scene.clone();
    bare.solids.truncate(1);
    for (seed, size_px) in (40..).zip(SIZES) {
        let poses = poses(scene.solids.len(), seed);
        let behind = draw(device, &bare, &poses[..1], size_px);
        let drawn = draw(device, &scene, &poses, size_px);
        let (glass, opaque) = (cast(&scene, &poses, SolidLook::Glass), cast(&scene, &poses, SolidLook::Solid));
        let FrameValues { view, light, style }: FrameValues = drawn.values;
        let (eye_m, size) = (vector(view.eye_m), size_px.map(|side| side as usize));
        let (mut covered, mut beyond, mut worst, mut taken, mut unlike) = (0, 0, 0.0_f64, 0, 0);
        for (index, (&got, &below)) in drawn.light.iter().zip(&behind.light).enumerate() {
            let ray = ray_of(&view, size, index, DVec2::ZERO);
            let ends = opaque.first(eye_m, ray).map_or(f64::INFINITY, |hit| hit.along);
            let hits: Vec<SolidHit> = glass.hits(eye_m, ray).filter(|hit| hit.along < ends).collect();
            if hits.is_empty() {
                continue;
            }
            // What faces away first, each half in its triangles' order.
            let halves =
                [false, true].into_iter().flat_map(|front| hits.iter().filter(move |hit| hit.is_front == front));
            let expected = halves.fold(below, |below, hit| {
                let (color, alpha) = glass_film(&hit.at, eye_m, (&light, &style));
                color + (1.0 - alpha) * below
            });
            covered += 1;
            taken += usize::from((got - below).length() > 0.02);
            unlike += usize::from(off(got, below, below) > 1.0);
            let differs = off(got, expected, expected);
            if differs <= 1.0 {
                worst = worst.max(differs);
            } else {
                beyond += 1;
            }
        }
        ensure!(covered > drawn.light.len() / 10 && taken > covered / 4, "{taken} of {covered} pixels show glass");
        ensure!((beyond as f64) < on_edges(device) * covered as f64, "{beyond} of {covered} pixels differ");
        // No glass at all is told apart.
        ensure!(unlike as f64 > on_edges(device) * covered as f64, "glass is not seen: {unlike} of {covered}");
        device.compared("draw_glass", covered, [worst * LIGHT_TOLERANCE, LIGHT_TOLERANCE]);
        note!(device, "draw_glass {size_px:?}: {beyond} of {covered} pixels on edges, the others within {worst:.2}");
    }
}

/// How far a place is from a shape without a cavity, m.
fn from_shape_m(shape: u32, place_m: DVec3, half_m: DVec3) -> f64 {
    let beyond = |beyond_m: DVec3| beyond_m.max(DVec3::ZERO).length() + beyond_m.max_element().min(0.0);
    match shape {
        SHAPE_BOX => beyond(place_m.abs() - half_m),
        SHAPE_CAPSULE => (place_m - DVec3::Y * place_m.y.clamp(-half_m.y, half_m.y)).length() - half_m.x,
        _ => beyond(DVec3::new(place_m.x.hypot(place_m.z) - half_m.x, place_m.y.abs() - half_m.y, f64::NEG_INFINITY)),
    }
}

fn from_solid_m(solid: &Solid, place_m: DVec3) -> f64 {
    let outside_m = from_shape_m(solid.shape, place_m, vector(solid.half_m));
    let [low_m, high_m] = [solid.cavity_min_m, solid.cavity_max_m].map(vector);
    let cavity_m = from_shape_m(solid.shape, place_m - 0.5 * (low_m + high_m), 0.5 * (high_m - low_m));
    if solid.is_hollow != 0 { outside_m.max(-cavity_m) } else { outside_m }
}

pub(crate) fn triangles_lie_on_their_shapes_and_close_them(_: &Device) {
    for (text, look) in [(OPAQUE, SolidLook::Solid), (TRIANGLES, SolidLook::Solid), (GLASS, SolidLook::Glass)] {
        let scene = scene(text);
        let shapes = Resources::new().persistent("solid_poses", scene.solids.len() as u32);
        let triangles = Solids { scene: &scene, poses: &shapes }.triangles(look);
        let (all, _) = solids(&scene);
        for vertex in &triangles.vertices {
            let (solid, at_m, normal) = (&all[vertex.solid as usize], vector(vertex.position_m), vector(vertex.normal));
            ensure!((normal.length() - 1.0).abs() < 1e-6, "a normal of length {}", normal.length());
            if solid.shape == SHAPE_FIELD {
                // What is drawn of ground ends where what is solid goes on.
                let own = scene.solids[vertex.solid as usize].triangles().or_raise();
                let on_m = own.drawn.as_ref().unwrap_or(&own.solid).positions_m.iter();
                let nearest_m = on_m.map(|corner_m| corner_m.distance(at_m)).fold(f64::INFINITY, f64::min);
                ensure!(nearest_m < 1e-6, "a corner is {nearest_m} m from those of its mesh, {at_m}");
                continue;
            }
            let [inside_m, on_m] = [-1e-4, 0.0].map(|along_m| from_solid_m(solid, at_m + along_m * normal));
            ensure!(on_m.abs() < 1e-6, "a corner is {on_m} m from its shape, {at_m}");
            // On a hard edge what is behind one face is on the other.
            ensure!(inside_m < 1e-6, "{inside_m} m from the shape behind the corner {at_m} with normal {normal}");
        }
        let corner = |index: &u32| vector(triangles.vertices[*index as usize].position_m);
        for (number, solid) in all.iter().enumerate().filter(|(number, _)| scene.solids[*number].look == look) {
            // The triangles' volume is the solid's: all of it is enclosed, and each is turned outward.
            let own = |of: &&[u32]| triangles.vertices[of[0] as usize].solid == number as u32;
            let volume = |of: &[u32]| corner(&of[0]).dot(corner(&of[1]).cross(corner(&of[2]))) / 6.0;
            let got_m3: f64 = triangles.indices.chunks_exact(3).filter(own).map(volume).sum();
            let own = scene.solids[number].triangles().map(|own| own.drawn.as_ref().unwrap_or(&own.solid).volume_m3());
            let expected_m3 = own.unwrap_or_else(|| volume_m3(solid));
            // 48 corners around lack 1 - sinc(2 pi / 48) of a circle, and a wall's two sides more of what it holds.
            ensure!((got_m3 / expected_m3 - 1.0).abs() < 0.01, "solid {number}: {got_m3} m3 of {expected_m3}");
        }
    }
}

fn volume_m3(solid: &Solid) -> f64 {
    let half_m = vector(solid.half_m);
    let of = |half_m: DVec3| match solid.shape {
        SHAPE_BOX => 8.0 * half_m.element_product(),
        SHAPE_CAPSULE => std::f64::consts::PI * half_m.x * half_m.x * (2.0 * half_m.y + 4.0 / 3.0 * half_m.x),
        _ => 2.0 * std::f64::consts::PI * half_m.x * half_m.x * half_m.y,
    };
    let [low_m, high_m] = [solid.cavity_min_m, solid.cavity_max_m].map(|end_m| vector(end_m).clamp(-half_m, half_m));
    of(half_m) - if solid.is_hollow != 0 { of(0.5 * (high_m - low_m)) } else { 0.0 }
}
