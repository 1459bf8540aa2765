//! What every shipped scene comes to on this device: a table of the rung that the ladder took by itself, and of frames a second.

use std::time::{Duration, Instant};

use brooklet_fluid::shipped_scenes;
use brooklet_gpu::tier_name;
use brooklet_mobile::App;
use brooklet_mobile::script::Hand;
use brooklet_viewer::ladder::RUNGS;

use crate::Options;

/// A scene in software may take so long to be there.
const LONG: Duration = Duration::from_secs(300);
/// The ladder has so long from a scene's first frame on,
const SETTLES: Duration = Duration::from_secs(5);
/// and frames are counted so long after that.
const COUNTED: Duration = Duration::from_secs(3);

pub fn run(mut app: App, options: &Options) -> Result<(), String> {
    let size_px = [options.size[0], options.size[1]].map(|points| (points * options.scale).round() as u32);
    app.resume_offscreen(size_px, options.scale);
    if let Some(reason) = app.failure() {
        return Err(reason.to_owned());
    }
    let mut hand = Hand::new(app, options.scale);
    let begun = Instant::now();
    if !hand.until(LONG, |hand| is_shown(hand, None)) {
        return Err("no scene began".into());
    }
    if let (Some(gpu), Some(checked)) = (hand.app.gpu(), hand.app.checked()) {
        let [width, height] = size_px;
        println!("{} ({} tier), a screen of {width} x {height}", gpu.info().name, tier_name(gpu.tier()));
        println!("first scene after {:.1} s; self-check: {}\n", begun.elapsed().as_secs_f64(), checked.summary());
    }
    println!("| scene | particles | of | picture | frames/s | pace | opened in | given up |");
    println!("|---|---|---|---|---|---|---|---|");
    let mut scenes: Vec<&str> = shipped_scenes().map(|(name, _)| name).collect();
    scenes.sort_by_key(|name| !name.starts_with("phone"));
    for name in scenes {
        println!("{}", row(&mut hand, name)?);
    }
    Ok(())
}

/// Whether a scene runs: that one, or any.
fn is_shown(hand: &Hand, name: Option<&str>) -> bool {
    let current = hand.app.viewer().and_then(|viewer| viewer.current());
    current.is_some_and(|current| name.is_none_or(|name| current.scene.name == name))
}

fn row(hand: &mut Hand, name: &str) -> Result<String, String> {
    let opened = Instant::now();
    if let Some(viewer) = hand.app.viewer_mut() {
        viewer.open(name);
    }
    let is_there = |hand: &mut Hand| {
        let is_loading = hand.app.viewer().is_none_or(brooklet_viewer::Viewer::is_loading);
        is_shown(hand, Some(name)) && !is_loading
    };
    if !hand.until(LONG, is_there) {
        let said: Vec<&str> = hand.app.viewer().map_or(Vec::new(), |viewer| viewer.messages().collect());
        return Err(format!("{name} did not begin: {}", said.join("; ")));
    }
    let opened_s = opened.elapsed().as_secs_f64();
    hand.until(SETTLES, |_| false);
    let simulated_s =
        |hand: &Hand| hand.app.viewer().and_then(|v| v.current()).map_or(0.0, |current| current.session.simulated_s());
    let (counted, before_s) = (Instant::now(), simulated_s(hand));
    let frames = frames_within(hand, COUNTED);
    let wall_s = counted.elapsed().as_secs_f64();
    let pace = (simulated_s(hand) - before_s) / wall_s;
    let viewer = hand.app.viewer().ok_or("the device was lost")?;
    let current = viewer.current().ok_or("the scene is gone")?;
    let [width, height] = current.view().size_px;
    let given_up = match RUNGS[viewer.rung()].given_up(&current.scene) {
        all if all.is_empty() => "nothing".to_owned(),
        given_up => given_up,
    };
    Ok(format!(
        "| `{name}` | {} | {} | {width} x {height} | {:.1} | {pace:.2} | {opened_s:.1} s | {given_up} |",
        current.session.slot_count(),
        current.scene.particle_count(),
        f64::from(frames) / wall_s,
    ))
}

/// Frames that are handed to the GPU within that time.
fn frames_within(hand: &mut Hand, time: Duration) -> u32 {
    let handed = |hand: &Hand| hand.app.viewer().map_or(0, brooklet_viewer::Viewer::frames);
    let before = handed(hand);
    hand.until(time, |_| false);
    u32::try_from(handed(hand) - before).unwrap_or(u32::MAX)
}
