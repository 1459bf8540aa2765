//! The rung that a scene begins on is the device's, and one that was chosen by hand is held. No display is needed.

use std::path::PathBuf;

use brooklet_fluid::Scene;
use brooklet_tests::gpu;
use brooklet_viewer::action::Action;
use brooklet_viewer::{Settings, Viewer};

fn open(scene: &Scene, rung: Option<usize>, window_px: [u32; 2]) -> Viewer {
    let settings = Settings { folder: PathBuf::new(), budget_ms: Some(50.0), rung };
    Viewer::new(&gpu(), wgpu::TextureFormat::Rgba8Unorm, scene.clone(), settings, window_px)
}

#[test]
fn the_first_rung_is_the_devices_and_a_chosen_one_is_held() {
    // 140,000 particles, which are sampled on the rung alone.
    let large = Scene::load("dam-break", &["spacing_m=0.012".into()]).unwrap();
    let small = Scene::load("calm-pool", &["spacing_m=0.1".into()]).unwrap();
    let window_px = [64, 36];
    let (many, few) = (open(&large, None, window_px), open(&small, None, window_px));
    assert!(many.is_auto() && few.is_auto());
    if gpu().info().device_type == "cpu" {
        assert!(many.rung() > few.rung(), "{} of 140,000 particles, {} of a few", many.rung(), few.rung());
        assert!(many.rung() > 5, "a processor begins with 140,000 particles on rung {}", many.rung());
    }
    drop((many, few));
    let mut held = open(&small, Some(2), window_px);
    assert!(!held.is_auto() && held.rung() == 2);
    held.handle_action(Action::Auto(true));
    assert!(held.is_auto());
    held.handle_action(Action::Rung(4));
    assert!(!held.is_auto() && held.rung() == 4, "a rung chosen by hand is not left");
}
