//! The scenes that come with the program.

use super::SceneError;
use super::nearest::nearest;

const SCENES: &[(&str, &str)] = &[
    ("dam-break", include_str!("../../scenes/dam-break.toml")),
    ("double-dam-break", include_str!("../../scenes/double-dam-break.toml")),
    ("breaking-wave", include_str!("../../scenes/breaking-wave.toml")),
    ("falling-ball", include_str!("../../scenes/falling-ball.toml")),
    ("faucet", include_str!("../../scenes/faucet.toml")),
    ("fountain", include_str!("../../scenes/fountain.toml")),
    ("falling-balls", include_str!("../../scenes/falling-balls.toml")),
    ("calm-pool", include_str!("../../scenes/calm-pool.toml")),
    ("martin-moyce", include_str!("../../scenes/martin-moyce.toml")),
    ("colliding-drops", include_str!("../../scenes/colliding-drops.toml")),
    ("glass", include_str!("../../scenes/glass.toml")),
    ("rotating-box", include_str!("../../scenes/rotating-box.toml")),
    ("pour", include_str!("../../scenes/pour.toml")),
    ("puddles", include_str!("../../scenes/puddles.toml")),
    ("sphere-drop", include_str!("../../scenes/sphere-drop.toml")),
    ("boats", include_str!("../../scenes/boats.toml")),
    ("river", include_str!("../../scenes/river.toml")),
    ("water-wheel", include_str!("../../scenes/water-wheel.toml")),
    ("spheric-2", include_str!("../../scenes/spheric-2.toml")),
    ("phone-1k", include_str!("../../scenes/phone-1k.toml")),
    ("phone-5k", include_str!("../../scenes/phone-5k.toml")),
    ("sparks", include_str!("../../scenes/sparks.toml")),
];

/// Name and summary of each shipped scene.
pub fn shipped_scenes() -> impl Iterator<Item = (&'static str, &'static str)> {
    SCENES.iter().map(|&(name, text)| {
        let summary = text
            .lines()
            .find_map(|line| line.strip_prefix("summary = \""))
            .and_then(|rest| rest.strip_suffix('"'))
            .unwrap_or_default();
        (name, summary)
    })
}

pub(super) fn text_of(name: &str) -> Option<&'static str> {
    SCENES.iter().find(|(shipped, _)| *shipped == name).map(|&(_, text)| text)
}

pub(super) fn unknown(name: &str) -> SceneError {
    let names: Vec<&str> = SCENES.iter().map(|&(shipped, _)| shipped).collect();
    SceneError::Unknown {
        name: name.into(),
        nearest: nearest(name, names.iter().copied()).unwrap_or_default().into(),
        shipped: names.join(", "),
    }
}
