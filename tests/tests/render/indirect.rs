//! Where the GPU says how many particles there are, the picture is the one of as many that the host counts.

use brooklet_fluid::{FrameRequest, Scene, Session};
use brooklet_render::ScenePlan;
use brooklet_tests::gpu;

/// A picture after two steps of a scene with these settings, and which passes are indirect.
fn picture(settings: &[&str]) -> (Vec<u8>, Vec<&'static str>) {
    let small = ["spacing_m=0.08", "outputs.width_px=64", "outputs.height_px=48", "solver.deterministic=true"];
    let settings: Vec<String> = small.iter().chain(settings).map(|&setting| setting.into()).collect();
    let scene = Scene::load("dam-break", &settings).expect("a scene");
    let planned = ScenePlan::new(&scene, gpu().tier()).expect("a plan");
    let indirect = planned.plan().passes().iter().filter(|pass| pass.indirect).map(|pass| pass.stage).collect();
    let passes = planned.passes.expect("a picture");
    let mut session = Session::start(&gpu(), planned.session).expect("a session");
    session.submit(&FrameRequest { steps: 2, then: &[passes.draw.id()], ..FrameRequest::default() }).expect("it runs");
    session.finish().expect("it ends");
    (session.engine_mut().read_texture(&passes.color).expect("a picture"), indirect)
}

#[test]
fn spare_slots_are_not_drawn() {
    for surface in ["points", "screen-space"] {
        let surface = format!("surface.method='{surface}'");
        let (expected, none) = picture(&[&surface]);
        assert!(none.is_empty(), "a number that stays is the host's: {none:?}");
        let (got, indirect) = picture(&[&surface, "capacity=5000"]);
        for stage in ["predict", "correct_positions", "measure_particles"] {
            assert!(indirect.contains(&stage), "{stage} is not among {indirect:?}");
        }
        assert!(indirect.iter().filter(|stage| stage.starts_with("draw_")).count() >= 2, "{indirect:?}");
        assert!(got == expected, "{surface}: the pictures differ");
        let (fewer, _) = picture(&[&surface, "fluid.0.block.max_m=[0.3, 0.4, 0.3]"]);
        assert!(fewer != expected, "the comparison sees other particles");
    }
}
