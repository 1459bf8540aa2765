//! The meshed surface in pictures: calm water is flat.

use brooklet_fluid::{FrameRequest, Scene, Session};
use brooklet_render::ScenePlan;
use brooklet_tests::gpu;
use glam::DVec3;

/// What a picture has of the water's surface.
struct Seen {
    /// Unit normals where there is water.
    normals: Vec<DVec3>,
    /// Share of the picture that is water.
    covered: f64,
    /// Passes of its plan.
    stages: Vec<&'static str>,
}

/// Calm water seen from far above, after two steps.
fn from_above(method: &str) -> Seen {
    let settings: Vec<String> = [
        "spacing_m=0.04",
        "outputs.width_px=96",
        "outputs.height_px=96",
        "solver.deterministic=true",
        "camera={ eye_m = [0.25, 20.0, 0.2501], target_m = [0.25, 0.0, 0.25], fov_deg = 2.0 }",
        &format!("surface.method='{method}'"),
    ]
    .map(Into::into)
    .to_vec();
    let scene = Scene::load("calm-pool", &settings).expect("a scene");
    let mut planned = ScenePlan::new(&scene, gpu().tier()).expect("a plan");
    let passes = planned.passes.take().expect("a picture");
    let stages = planned.plan().passes().iter().map(|pass| pass.stage).collect();
    let surface = passes.water.expect("water").surface;
    let mut session = Session::start(&gpu(), planned.session).expect("a session");
    session.submit(&FrameRequest { steps: 2, then: &[passes.draw.id()], ..FrameRequest::default() }).expect("it runs");
    session.finish().expect("it ends");
    let bytes = session.engine_mut().read_texture(&surface.normals).expect("normals");
    let halves: Vec<[half::f16; 4]> = bytemuck::pod_collect_to_vec::<u8, u16>(&bytes)
        .chunks(4)
        .map(|texel| std::array::from_fn(|i| half::f16::from_bits(texel[i])))
        .collect();
    let normals: Vec<DVec3> = halves
        .iter()
        .filter(|texel| texel[3].to_f64() > 0.5)
        .map(|texel| DVec3::from_array(std::array::from_fn(|axis| texel[axis].to_f64())))
        .collect();
    Seen { covered: normals.len() as f64 / halves.len() as f64, normals, stages }
}

#[test]
fn a_meshed_pool_is_flat() {
    let seen = from_above("marching-cubes");
    for stage in ["mark_blocks", "gather_field", "count_mesh", "scan_groups", "emit_vertices", "draw_mesh_depth"] {
        assert!(seen.stages.contains(&stage), "{stage} is not among {:?}", seen.stages);
    }
    assert!(!seen.stages.iter().any(|stage| stage.starts_with("draw_smooth_narrow")), "no filter smooths a mesh");
    assert!(seen.covered > 0.3, "{}", seen.covered);
    let degrees: Vec<f64> = seen.normals.iter().map(|normal| normal.y.min(1.0).acos().to_degrees()).collect();
    let mean = degrees.iter().sum::<f64>() / degrees.len() as f64;
    let tilted = degrees.iter().filter(|&&angle| angle > 20.0).count() as f64 / degrees.len() as f64;
    // Up to the glass: a vertex there has the top's normal, what lies in the glass has the glass's.
    assert!(mean < 1.0 && tilted < 0.002, "{mean:.1} degrees off upright, {:.1} % by more than 20", 100.0 * tilted);
}
