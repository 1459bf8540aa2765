//! What solids look like where their scene does not say.

use brooklet_fluid::scene::{SolidLook, SolidSettings};
use brooklet_kernels::SolidPaint;

/// Of opaque ones, by their number: earth and paint, well apart from water (sRGB).
const PAINTS: [[f64; 3]; 6] = [
    [0.85, 0.43, 0.25],
    [0.90, 0.72, 0.36],
    [0.56, 0.62, 0.38],
    [0.68, 0.30, 0.34],
    [0.80, 0.76, 0.68],
    [0.46, 0.42, 0.46],
];
/// Of ground: what grows where it is level, and what is left where it is steep or wet.
const GROUND: [[f64; 3]; 2] = [[0.36, 0.41, 0.23], [0.47, 0.39, 0.30]];
/// Of glass.
const GLASS: [f64; 3] = [0.80, 0.93, 0.89];

/// What the shaders are told of a solid's look, which is the scene's of this `index`.
pub fn paint(solid: &SolidSettings, index: usize) -> SolidPaint {
    let own = match solid.look {
        SolidLook::Solid if solid.terrain.is_some() => GROUND[0],
        SolidLook::Solid => PAINTS[index % PAINTS.len()],
        SolidLook::Glass => GLASS,
    };
    let color = solid.color.unwrap_or(own);
    let other = match (solid.terrain.is_some(), solid.color) {
        (true, None) => GROUND[1],
        (true, Some(color)) => color.map(|channel| 0.7 * channel),
        (false, _) => color,
    };
    let [color, other] = [color, other].map(|color| color.map(|channel| linear(channel) as f32));
    let gloss = if solid.terrain.is_some() { 0.12 } else { 1.0 };
    SolidPaint { color, other, gloss, ..SolidPaint::default() }
}

/// Linear light of an sRGB channel.
fn linear(encoded: f64) -> f64 {
    if encoded <= 0.04045 { encoded / 12.92 } else { ((encoded + 0.055) / 1.055).powf(2.4) }
}
