//! The surface whose method is chosen by what is seen: near it is the mesh, far the surface in screen space, and on the way
//! nothing pops.

use brooklet_fluid::{FrameRequest, Scene, Session};
use brooklet_gpu::RecordingId;
use brooklet_render::frame::FrameValues;
use brooklet_render::surface::auto::Shown;
use brooklet_render::{FrameOptions, FramePasses, ScenePlan, View};
use brooklet_tests::gpu;
use glam::DVec3;

const SIZE_PX: u32 = 96;
/// Of a picture's bytes, on average: the mesh's last digits hang on the order of a sum.
const SAME: f64 = 0.02;

fn scene(method: &str) -> Scene {
    let settings: Vec<String> = [
        "spacing_m=0.05".into(),
        format!("outputs={{ images = 1, width_px = {SIZE_PX}, height_px = {SIZE_PX} }}"),
        "solver.deterministic=true".into(),
        format!("surface={{ method = '{method}', auto = {{ least_px = 8000, px_per_particle = 1 }}, caustics = false, self_shadow = false }}"),
    ]
    .to_vec();
    Scene::load("calm-pool", &settings).expect("a scene")
}

/// A scene that is drawn again and again as it is after two steps.
struct Still {
    session: Session,
    passes: FramePasses,
    options: FrameOptions,
    view: View,
}

impl Still {
    fn new(method: &str) -> Self {
        let scene = scene(method);
        let mut planned = ScenePlan::new(&scene, gpu().tier()).expect("a plan");
        let passes = planned.passes.take().expect("a picture");
        let mut session = Session::start(&gpu(), planned.session).expect("a session");
        session.submit(&FrameRequest { steps: 2, ..FrameRequest::default() }).expect("it runs");
        session.finish().expect("it ends");
        Self { session, passes, options: FrameOptions::for_scene(&scene, gpu().tier()), view: View::of_scene(&scene) }
    }

    /// From so many times as far as at first.
    fn look(&mut self, times: f64) {
        let first = View::of_scene(self.session.scene()).camera;
        let away_m: DVec3 = first.eye_m - first.target_m;
        self.view.camera.eye_m = first.target_m + times * away_m;
        let values = FrameValues::new(&self.view, &self.options).expect("values");
        self.session.engine_mut().write(&self.passes.uniforms.view, &[values.view]);
    }

    fn picture(&mut self) -> Vec<u8> {
        let particles = self.session.slot_count();
        let draw: RecordingId = self.passes.next(self.session.engine_mut(), particles, true);
        let readbacks: Vec<_> = self.passes.readbacks().collect();
        let request = FrameRequest { then: &[draw], readbacks: &readbacks, ..FrameRequest::default() };
        self.session.submit(&request).expect("it draws");
        for frame in self.session.finish().expect("it ends") {
            self.passes.learn(&frame.report);
        }
        self.session.engine_mut().read_texture(&self.passes.color).expect("a picture")
    }

    fn shown(&self) -> Shown {
        self.passes.auto.as_ref().expect("either method").shown()
    }
}

fn difference(a: &[u8], b: &[u8]) -> f64 {
    a.iter().zip(b).map(|(a, b)| f64::from(a.abs_diff(*b))).sum::<f64>() / a.len() as f64
}

#[test]
fn the_method_follows_the_distance_and_fades() {
    let (near, far) = (0.6, 3.0);
    let [mut smoothed, mut meshed, mut auto] = ["screen-space", "marching-cubes", "auto"].map(Still::new);
    let mut both = |times| {
        [&mut smoothed, &mut meshed].map(|still| {
            still.look(times);
            still.picture()
        })
    };
    let [smoothed_near, meshed_near] = both(near);
    let [smoothed_far, meshed_far] = both(far);
    let apart = difference(&smoothed_far, &meshed_far);
    assert!(difference(&smoothed_near, &meshed_near) > 10.0 * SAME && apart > 10.0 * SAME, "methods differ: {apart}");

    auto.look(near);
    for _ in 0..3 {
        let off = difference(&auto.picture(), &meshed_near);
        assert!(off < SAME, "near it is the mesh: {off}, {:?}", auto.shown());
    }
    auto.look(far);
    let mut last = auto.picture();
    assert!(difference(&last, &meshed_far) < SAME, "it is chosen by what was seen: {:?}", auto.shown());
    let mut faded = 0;
    for _ in 0..60 {
        let picture = auto.picture();
        let step = difference(&picture, &last);
        // Twelve steps from one to the other, each with its rounding of half a byte's unit.
        assert!(step < 1.5 * apart / 12.0 + 0.5, "a step of {step} of {apart} pops");
        if let Shown::Both(opacity) = auto.shown() {
            faded += 1;
            let mix = |(a, b): (&u8, &u8)| (opacity * f64::from(*b) + (1.0 - opacity) * f64::from(*a)).round() as u8;
            let mixed: Vec<u8> = smoothed_far.iter().zip(&meshed_far).map(mix).collect();
            assert!(difference(&picture, &mixed) < 0.5, "{opacity}");
            assert!(auto.passes.fades(auto.session.slot_count()));
        }
        last = picture;
    }
    assert_eq!((faded, auto.shown()), (11, Shown::ScreenSpace));
    assert!(difference(&last, &smoothed_far) < SAME, "far it is screen space");
    assert!(!auto.passes.fades(auto.session.slot_count()), "then it stays");
}

#[test]
fn either_method_shares_what_the_other_needs() {
    let bytes = |method| ScenePlan::new(&scene(method), gpu().tier()).expect("a plan").plan().bytes();
    let [smoothed, meshed, auto] = ["screen-space", "marching-cubes", "auto"].map(bytes);
    // Beside those of one: what only the other has, a picture, and settings.
    let own = u64::from(4 * SIZE_PX * SIZE_PX);
    let alone = bytes("none");
    assert!(auto < smoothed + meshed - alone - own, "{auto} B beside {smoothed} and {meshed} of {alone}");
    assert!(auto > smoothed.max(meshed));
}
