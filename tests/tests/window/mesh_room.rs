//! A window whose surface's mesh lacks room says so once, and its next pictures have it. No display is needed.

use std::path::PathBuf;
use std::time::{Duration, Instant};

use brooklet_fluid::Scene;
use brooklet_tests::gpu;
use brooklet_tests::mesh_files::scene_of_drops;
use brooklet_viewer::{Settings, Viewer};

#[test]
fn the_next_pictures_have_the_room_that_a_mesh_lacked() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("drops.toml");
    std::fs::write(&path, scene_of_drops()).unwrap();
    let scene = Scene::load(&path.display().to_string(), &[]).unwrap();
    let settings = Settings { folder: PathBuf::new(), budget_ms: Some(1000.0), rung: Some(0) };
    let mut viewer = Viewer::new(&gpu(), wgpu::TextureFormat::Rgba8Unorm, scene, settings, [64, 36]);
    let begun = Instant::now();
    let (mut before, mut said) = (None, false);
    // Until a plan with more room runs, and a while longer.
    let mut frames_since = 0;
    while frames_since < 20 {
        assert!(begun.elapsed() < Duration::from_secs(120), "no room is made; said: {said}");
        let input = egui::RawInput {
            screen_rect: Some(egui::Rect::from_min_size(egui::Pos2::ZERO, egui::vec2(640.0, 360.0))),
            ..egui::RawInput::default()
        };
        viewer.frame(input, None).unwrap();
        said |= viewer.messages().any(|text| text.contains("lacked room"));
        let Some(current) = viewer.current() else { continue };
        let buffers = current.session.engine().plan().buffers();
        let listed = buffers.iter().find(|buffer| buffer.label == "listed_blocks").expect("a mesh").bytes;
        frames_since += usize::from(listed > *before.get_or_insert(listed));
        std::thread::sleep(Duration::from_millis(5));
    }
    assert!(said && !viewer.is_loading(), "said: {said}; once more a plan is made");
}
