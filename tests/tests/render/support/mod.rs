//! The f64 twin of what the frame draws to its depth buffer, and the comparators of pictures.

use brooklet_fluid::Slots;
use brooklet_gpu::{Engine, Plan, Resources, Tier};
use brooklet_kernels::{Position, Velocity};
use brooklet_render::{Camera, Coloring, FrameOptions, Particles, View, frame};
use brooklet_tests::gpu;
use glam::{DVec2, DVec3};

/// Bit of a tag that says: quarantined, not to be drawn.
pub const QUARANTINED: u32 = brooklet_kernels::QUARANTINED;

/// Vulkan lets a device round a triangle's corners to sixteenths of a pixel; all that a pixel shows
/// may be displaced by as much.
const SNAP_PX: f64 = 1.0 / 16.0;

/// A sphere to draw: where, relative to the domain, and its tag.
#[derive(Clone, Copy, Debug)]
pub struct Sphere {
    pub at_m: DVec3,
    pub tag: u32,
}

pub fn sphere(x: f64, y: f64, z: f64, fluid: u32) -> Sphere {
    // Positions are f32 on the GPU: the twin sees the same numbers.
    Sphere { at_m: DVec3::new(x, y, z).as_vec3().as_dvec3(), tag: fluid << 24 }
}

/// The view all tests share: a domain away from the world's origin, seen by its framing camera.
pub fn view(size_px: [u32; 2]) -> View {
    let (domain_min_m, domain_max_m) = (DVec3::new(4.0, -2.0, 1.0), DVec3::new(6.0, -1.0, 2.0));
    View { camera: Camera::framing(domain_min_m, domain_max_m, size_px), domain_min_m, domain_max_m, size_px }
}

pub fn options() -> FrameOptions {
    FrameOptions {
        tier: Tier::Desktop,
        surface: brooklet_render::SurfaceOptions::Points,
        radius_m: 0.11,
        coloring: Coloring::Fluid,
        supersample: 1,
        shadow_texels: 256,
        edges: true,
        diffuse: None,
    }
}

/// A drawn picture.
pub struct Picture {
    pub size_px: [u32; 2],
    /// sRGB, four bytes a pixel.
    pub rgba: Vec<u8>,
    /// Reversed depth of the drawn pixels; empty where the format cannot be read back.
    pub depth: Vec<f32>,
}

impl Picture {
    pub fn rgb(&self, x: u32, y: u32) -> [i32; 3] {
        let at = 4 * (y as usize * self.size_px[0] as usize + x as usize);
        [0, 1, 2].map(|channel| i32::from(self.rgba[at + channel]))
    }

    pub fn brightness(&self, x: u32, y: u32) -> i32 {
        self.rgb(x, y).iter().sum()
    }
}

/// Draws spheres at rest on the tests' device.
pub fn draw(view: &View, options: &FrameOptions, spheres: &[Sphere]) -> Picture {
    draw_moving(view, options, spheres, &vec![DVec3::ZERO; spheres.len()])
}

/// Draws spheres with velocities in m/s.
pub fn draw_moving(view: &View, options: &FrameOptions, spheres: &[Sphere], velocities_m_s: &[DVec3]) -> Picture {
    let count = spheres.len() as u32;
    let mut resources = Resources::new();
    let positions = resources.persistent::<Position>("positions", count);
    let velocities = resources.persistent::<Velocity>("velocities", count);
    let slots = Slots::declare(&mut resources, count);
    let particles = Particles {
        positions: &positions,
        velocities: &velocities,
        slots: &slots,
        neighbours: None,
        densities: None,
        diffuse: None,
    };
    let passes = frame::record(&mut resources, view, &particles, options).expect("a frame");
    let (color, depth) = (passes.color.alias(), passes.depth.alias());
    let ids = [passes.init.id(), passes.draw.id()];
    let plan = Plan::sweep(resources, vec![passes.init, passes.draw], &[color.id]).expect("a plan");
    let mut engine = Engine::new(&gpu(), plan).expect("an engine");
    let particles: Vec<Position> =
        spheres.iter().map(|sphere| Position { position_m: sphere.at_m.as_vec3().into(), tag: sphere.tag }).collect();
    let moving: Vec<Velocity> = velocities_m_s
        .iter()
        .map(|velocity| Velocity { velocity_m_s: velocity.as_vec3().into(), age_s: 0.0 })
        .collect();
    if count > 0 {
        engine.write(&positions, &particles);
        if options.coloring != Coloring::Fluid {
            engine.write(&velocities, &moving);
        }
    }
    engine.run(&ids, &[]).expect("it draws");
    let rgba = engine.read_texture(&color).expect("a picture");
    let depth = match options.tier {
        Tier::Floor => Vec::new(),
        _ => bytemuck::pod_collect_to_vec(&engine.read_texture(&depth).expect("its depth")),
    };
    Picture { size_px: view.size_px, rgba, depth }
}

/// What a ray meets first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Met {
    Sphere(usize),
    Floor,
    Sky,
}

/// Ray casting in f64 through a point of the drawn picture, in drawn pixels from the top left:
/// what is met, and its reversed depth.
fn cast(view: &View, options: &FrameOptions, spheres: &[Sphere], at_px: DVec2) -> (Met, f64) {
    let eye_m = view.camera.eye_m - view.domain_min_m;
    let axes = view.camera.axes();
    let tan_half = view.tan_half();
    let drawn_px = DVec2::new(f64::from(view.size_px[0]), f64::from(view.size_px[1])) * f64::from(options.supersample);
    let at = at_px / drawn_px;
    let forward = -axes.z_axis;
    let ray = forward + (2.0 * at.x - 1.0) * tan_half.x * axes.x_axis + (1.0 - 2.0 * at.y) * tan_half.y * axes.y_axis;
    let direction = ray.normalize();

    let (mut met, mut nearest_m) = (Met::Sky, f64::INFINITY);
    for (index, sphere) in spheres.iter().enumerate().filter(|(_, sphere)| sphere.tag & QUARANTINED == 0) {
        let center_m = sphere.at_m - eye_m;
        let along_m = direction.dot(center_m);
        let aside_m = (center_m - along_m * direction).length();
        if aside_m < options.radius_m {
            let hit_m = along_m - (options.radius_m * options.radius_m - aside_m * aside_m).sqrt();
            if hit_m < nearest_m {
                (met, nearest_m) = (Met::Sphere(index), hit_m);
            }
        }
    }
    let floor_m = -eye_m.y / direction.y;
    if direction.y < 0.0 && floor_m < nearest_m {
        (met, nearest_m) = (Met::Floor, floor_m);
    }
    (met, view.near_m() / (nearest_m * direction.dot(forward)))
}

/// What the depth buffer may hold at a drawn pixel, lowest and highest; `None` where a device may
/// see one thing or another, on an outline.
fn depth_twin(view: &View, options: &FrameOptions, spheres: &[Sphere], x: u32, y: u32) -> Option<(f64, f64)> {
    let middle_px = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
    let (met, depth) = cast(view, options, spheres, middle_px);
    let (mut low, mut high) = (depth, depth);
    for aside in [DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y] {
        let (other, depth) = cast(view, options, spheres, middle_px + SNAP_PX * aside);
        if other != met {
            return None;
        }
        (low, high) = (low.min(depth), high.max(depth));
    }
    // The floor ends where the fade hides its end, which is beyond every sphere.
    let floors_end = view.near_m() / (4.0 * view.diagonal_m().max((view.camera.eye_m - view.domain_min_m).length()));
    (met != Met::Floor || low > floors_end).then_some((low, high))
}

/// Compares a depth buffer with the twin: the largest relative difference beyond what rounding
/// corners allows, and how many pixels were on an outline.
///
/// # Errors
/// At the first pixel that differs by more than `tolerance`.
pub fn compare_depth(
    picture: &Picture,
    view: &View,
    options: &FrameOptions,
    spheres: &[Sphere],
    tolerance: f64,
) -> Result<(f64, usize), String> {
    let [width, height] = view.size_px.map(|side| side * options.supersample);
    let (mut worst, mut undecided) = (0.0f64, 0);
    for y in 0..height {
        for x in 0..width {
            let got = f64::from(picture.depth[(y * width + x) as usize]);
            let Some((low, high)) = depth_twin(view, options, spheres, x, y) else {
                undecided += 1;
                continue;
            };
            let beyond = (low - got).max(got - high).max(0.0) / high.max(1e-9);
            worst = worst.max(beyond);
            // NaN compares with nothing: it must not pass.
            if got.is_nan() || beyond > tolerance {
                return Err(format!("pixel {x}, {y}: depth {got}, expected {low} to {high}"));
            }
        }
    }
    Ok((worst, undecided))
}

/// Compares two pictures of one size: the largest difference of a channel.
///
/// # Errors
/// If a channel of a pixel differs by more than `steps` of 255.
pub fn compare_colors(got: &Picture, expected: &Picture, steps: i32) -> Result<i32, String> {
    let mut worst = 0;
    for y in 0..got.size_px[1] {
        for x in 0..got.size_px[0] {
            let (a, b) = (got.rgb(x, y), expected.rgb(x, y));
            let difference = (0..3).map(|channel| (a[channel] - b[channel]).abs()).max().unwrap_or(0);
            worst = worst.max(difference);
            if difference > steps {
                return Err(format!("pixel {x}, {y}: {a:?}, expected {b:?}"));
            }
        }
    }
    Ok(worst)
}
