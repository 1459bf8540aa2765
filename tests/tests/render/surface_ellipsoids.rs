//! Ellipsoids as they are drawn: against rays through the twin's ellipsoids, from awkward cameras, and
//! before the first step, when nobody has listed neighbours yet.

use brooklet_fluid::grid::Neighbours;
use brooklet_fluid::scene::Smoothing;
use brooklet_fluid::{Scene, Slots, record, visit_slots};
use brooklet_gpu::{Engine, Plan, Resources};
use brooklet_kernels::{FrameView, ListHead, Position, QUARANTINED};
use brooklet_reference::grid::list_neighbours::list_neighbours;
use brooklet_reference::shared::list;
use brooklet_reference::surface::anisotropy::{Ellipsoid, anisotropy};
use brooklet_render::frame::{self, FrameValues};
use brooklet_render::surface::screen_space::{self, ScreenSpaceOptions};
use brooklet_render::{Camera, FrameOptions, Particles, SurfaceOptions, View};
use brooklet_tests::cases::{LIST_CHUNKS, vectors};
use brooklet_tests::{gpu, rng};
use glam::DVec3;
use rand::RngExt as _;

const SPACING_M: f64 = 0.05;
/// Of a pixel's inverse_depth. A matrix in f16 moves the surface by up to 2^-10 of the longest radius,
/// 1.6 x 0.04 m, at 2 m; seen at a slope of 1 to 3 that is three times as much along the ray.
const TOLERANCE: f64 = 1e-4;
/// Share of the covered pixels whose rays graze an ellipsoid: there no tolerance would do.
const GRAZING: f64 = 0.005;

fn view(size_px: [u32; 2], eye_m: DVec3) -> View {
    View {
        camera: Camera { eye_m, target_m: DVec3::new(0.5, 0.4, 0.5), fov_deg: 32.0 },
        domain_min_m: DVec3::ZERO,
        domain_max_m: DVec3::ONE,
        size_px,
    }
}

fn options() -> (ScreenSpaceOptions, FrameOptions) {
    let text = format!("spacing_m = {SPACING_M}\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [1, 1, 1]\nwalls = true\n");
    let mut scene = Scene::from_toml(&text, "ellipsoids", &[]).expect("a scene");
    scene.surface.smoothing = Smoothing::None;
    let surface = ScreenSpaceOptions::for_scene(&scene, gpu().tier());
    assert!(surface.anisotropic, "ellipsoids are the default");
    let frame = FrameOptions { supersample: 1, ..FrameOptions::for_scene(&scene, gpu().tier()) };
    (surface, FrameOptions { surface: SurfaceOptions::ScreenSpace(surface), ..frame })
}

/// A rough pool with a splash above it, not as wide as its tank.
fn splash(seed: u64) -> Vec<Position> {
    let mut rng = rng(seed);
    let mut all: Vec<[f64; 3]> = (0..14 * 14 * 5)
        .map(|i| [i % 14, i / 196, i / 14 % 14].map(|n| SPACING_M * (f64::from(n) + 0.5 + 0.3 * rng.random::<f64>())))
        .collect();
    all.extend((0..80).map(|_| [0.2, 0.3, 0.2].map(|low| low + 0.5 * rng.random::<f64>())));
    let place = |(i, at): (usize, [f64; 3])| Position { position_m: at.map(|x| x as f32), tag: i as u32 };
    all.into_iter().enumerate().map(place).collect()
}

struct Drawn {
    inverse_depth: Vec<f32>,
    view: FrameView,
    ellipsoids: Vec<Ellipsoid>,
}

fn draw(view: &View, positions: &[Position]) -> Drawn {
    let (surface, frame) = options();
    let values = FrameValues::new(view, &frame).expect("values");
    let count = positions.len() as u32;
    let (at_m, quarantined) = (vectors(positions), |i: usize| positions[i].tag & QUARANTINED != 0);
    let neighbours = list_neighbours(&at_m, quarantined, surface.support_m);
    let (lists, mut heads) = list::encoded(&neighbours, LIST_CHUNKS);
    heads.iter_mut().filter(|head| head.entries == 0).for_each(|head| head.first = u32::MAX);
    let mut resources = Resources::new();
    let mut buffer = resources.persistent::<Position>("positions", count);
    let velocities = resources.persistent("velocities", count);
    let mut listed = Neighbours {
        deltas: resources.persistent("neighbours", lists.len() as u32),
        heads: resources.persistent("list_heads", count),
    };
    let mut frame_view = resources.persistent("frame_view", 1);
    let (mut init, mut recording) = (resources.recording("init"), resources.recording("draw"));
    init.upload(&mut frame_view, &[values.view]);
    init.upload(&mut buffer, positions);
    init.upload(&mut listed.deltas, &lists);
    init.upload(&mut listed.heads, &heads);
    let mut slots = Slots::declare(&mut resources, count);
    init.upload(&mut slots.state, &[visit_slots(count)]);
    let particles = Particles {
        positions: &buffer,
        velocities: &velocities,
        slots: &slots,
        neighbours: Some(&listed),
        densities: None,
        diffuse: None,
    };
    let into = (&mut init, &mut recording);
    let drawn =
        screen_space::record(&mut resources, into, &frame_view, &particles, view.size_px, gpu().tier(), &surface);
    let ids = [init.id(), recording.id()];
    let plan = Plan::sweep(resources, vec![init, recording], &[drawn.raw.id]).expect("a plan");
    let is_made = plan.passes().iter().any(|pass| pass.stage == "anisotropy");
    assert!(is_made || count == 0, "ellipsoids are drawn");
    let mut engine = Engine::new(&gpu(), plan).expect("an engine");
    engine.run(&ids, &[]).expect("it draws");
    let inverse_depth = bytemuck::pod_collect_to_vec(&engine.read_texture(&drawn.raw).expect("a texture"));
    let (params, walls) = (screen_space::anisotropy::params(&surface, LIST_CHUNKS), surface.params());
    let seen = (0..positions.len()).filter(|&i| !quarantined(i));
    let ellipsoids = seen.map(|i| anisotropy(i, &at_m, &neighbours[i], &params, &walls)).collect();
    Drawn { inverse_depth, view: values.view, ellipsoids }
}

/// The inverse_depth of the nearest ellipsoid, cut off at the tank, along the ray of a pixel.
fn along_ray(drawn: &Drawn, ellipsoids: &[(DVec3, glam::DMat3)], x: usize, y: usize) -> f64 {
    let vector = |v: [f32; 3]| DVec3::from(v.map(f64::from));
    let view = &drawn.view;
    let ndc = [
        (x as f64 + 0.5) / f64::from(view.size_px[0]) * 2.0 - 1.0,
        1.0 - (y as f64 + 0.5) / f64::from(view.size_px[1]) * 2.0,
    ];
    let ray = vector(view.forward)
        + vector(view.right) * (ndc[0] * f64::from(view.tan_half_width))
        + vector(view.up) * (ndc[1] * f64::from(view.tan_half_height));
    let eye_m = vector(view.eye_m);
    let (a, b) = (-eye_m / ray, (DVec3::ONE - eye_m) / ray);
    let (enter_box, leave_box) = (a.min(b).max_element(), a.max(b).min_element());
    let meets = ellipsoids.iter().filter_map(|(center_m, unstretch)| {
        let (from, along) = (*unstretch * (eye_m - *center_m), *unstretch * ray);
        let half = from.dot(along) / along.length_squared();
        let gap = half * half - (from.length_squared() - 1.0) / along.length_squared();
        let (enter, leave) = ((-half - gap.sqrt()).max(enter_box), (-half + gap.sqrt()).min(leave_box));
        (gap > 0.0 && enter <= leave).then_some(1.0 / enter)
    });
    meets.fold(0.0, f64::max)
}

/// How many of the covered pixels are not as rays find them.
fn beyond(drawn: &Drawn, grown: f64) -> (usize, usize) {
    let radius_m = options().0.radius_m * grown;
    let ellipsoids: Vec<_> = drawn.ellipsoids.iter().map(|e| (e.center_m, (e.stretch * radius_m).inverse())).collect();
    let width = drawn.view.size_px[0] as usize;
    let (mut covered, mut beyond) = (0, 0);
    for (index, &got) in drawn.inverse_depth.iter().enumerate() {
        let expected = along_ray(drawn, &ellipsoids, index % width, index / width);
        covered += usize::from(expected > 0.0);
        // Written so that a NaN is beyond.
        let is_close = (f64::from(got) - expected).abs() <= TOLERANCE * expected;
        beyond += usize::from(!is_close);
    }
    (covered, beyond)
}

#[test]
fn an_ellipsoid_is_where_rays_meet_it() {
    for (seed, eye_m) in
        [(71, DVec3::new(0.7, 0.9, 2.6)), (72, DVec3::new(-1.4, 0.2, 0.3)), (73, DVec3::new(0.5, 2.8, 0.6))]
    {
        let drawn = draw(&view([111, 73], eye_m), &splash(seed));
        let (covered, off) = beyond(&drawn, 1.0);
        println!("ellipsoids from {eye_m}: {off} of {covered} pixels beyond {TOLERANCE:.1e}");
        assert!(covered > 1000 && off as f64 <= GRAZING * covered as f64, "{off} of {covered}");
        // Ellipsoids a fiftieth larger are others.
        let (_, off) = beyond(&drawn, 1.02);
        assert!(off as f64 > 40.0 * GRAZING * covered as f64, "it cannot fail: {off} of {covered}");
    }
}

#[test]
fn awkward_particles_and_cameras_leave_no_number_that_is_none() {
    let pool = splash(74);
    let mut lost = splash(75);
    for (i, particle) in lost.iter_mut().enumerate() {
        *particle = Position { position_m: [f32::NAN, f32::INFINITY, 0.5], tag: QUARANTINED | i as u32 };
    }
    let one_place: Vec<Position> = pool[..90].iter().map(|p| Position { position_m: [0.5; 3], ..*p }).collect();
    let usual = DVec3::new(0.7, 0.9, 2.6);
    for (what, eye_m, positions, is_seen) in [
        ("nothing", usual, &[][..], false),
        ("one", usual, &pool[..1], true),
        ("all in one place", usual, &one_place, true),
        ("quarantined", usual, &lost, false),
        ("a camera inside", DVec3::new(0.3, 0.1, 0.3), &pool, true),
        ("a camera in a particle", vectors(&pool)[400], &pool, true),
        ("a camera at 10 km", DVec3::new(0.5, 3e3, 9.5e3), &pool, true),
    ] {
        let drawn = draw(&view([160, 90], eye_m), positions);
        assert!(drawn.inverse_depth.iter().all(|n| n.is_finite() && *n >= 0.0), "{what}");
        let is_covered = drawn.inverse_depth.iter().any(|&n| n > 0.0);
        // From 10 km a pixel is far wider than all of the fluid: it may be seen, or not.
        assert!(is_covered == is_seen || what == "a camera at 10 km", "{what}: {is_covered}");
    }
}

/// Picture of a scene before its first step, with the heads of the lists that `head` gives.
fn before_first_step(anisotropic: bool, listed: bool, head: Option<ListHead>) -> Vec<u8> {
    let settings = ["outputs.width_px=160", "outputs.height_px=90", "spacing_m=0.05", "outputs.measure_every_steps=0"];
    let mut scene = Scene::load("calm-pool", &settings.map(String::from)).expect("a scene");
    scene.surface.anisotropic = anisotropic;
    let mut resources = Resources::new();
    let recorded = record(&mut resources, &scene);
    let mut recordings = recorded.recordings();
    let particles = Particles::of(&recorded);
    let particles = Particles { neighbours: particles.neighbours.filter(|_| listed), ..particles };
    let options = FrameOptions::for_scene(&scene, gpu().tier());
    let passes = frame::record(&mut resources, &View::of_scene(&scene), &particles, &options).expect("a frame");
    let (init, draw) = ([recorded.init.id(), passes.init.id()], passes.draw.id());
    recordings.extend([passes.init, passes.draw]);
    let plan = Plan::sweep(resources, recordings, &[passes.color.id]).expect("a plan");
    let mut engine = Engine::new(&gpu(), plan).expect("an engine");
    engine.run(&init, &[]).expect("it starts");
    if let Some(head) = head {
        engine.write(&recorded.neighbours.as_ref().unwrap().heads, &vec![head; recorded.slots.capacity as usize]);
    }
    engine.run(&[draw], &[]).expect("a picture");
    engine.read_texture(&passes.color).expect("a picture")
}

/// The picture of step 0 is of a body of water and not of spray.
#[test]
fn before_the_first_step_particles_are_drawn_in_full() {
    let spheres = before_first_step(false, false, None);
    let off = |picture: &[u8]| picture.iter().zip(&spheres).filter(|(a, b)| a.abs_diff(**b) > 2).count();
    for anisotropic in [false, true] {
        let first = before_first_step(anisotropic, true, None);
        assert!(off(&first) * 1000 < spheres.len(), "anisotropic {anisotropic}: {} bytes differ", off(&first));
        // As if a step had found each of them alone.
        let spray = before_first_step(anisotropic, true, Some(ListHead { entries: 0, first: u32::MAX }));
        assert!(off(&spray) * 20 > spheres.len(), "anisotropic {anisotropic}: {} bytes differ", off(&spray));
    }
}
