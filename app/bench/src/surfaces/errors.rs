//! How far a drawn surface is from the one that is known.

use serde::Serialize;

use super::seen::Seen;

/// Pixels this close to an outline see the surface edge on, and are counted apart.
const RIM_PX: usize = 3;

/// Errors of one picture.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Errors {
    /// Angle between normals over the pixels of both surfaces, degrees: the mean,
    pub normal_mean_deg: f64,
    /// what 95 of 100 pixels stay below,
    pub normal_p95_deg: f64,
    /// and the mean of those three pixels or more inside both outlines.
    pub normal_inner_mean_deg: f64,
    /// Pixels that only one of the surfaces covers, over the length of the known one's outline, in
    /// pixels: how far the outline is off on average.
    pub outline_px: f64,
    /// The same in particle spacings.
    pub outline_spacings: f64,
    /// Pixels that the known surface covers.
    pub covered_px: usize,
}

/// Compares `drawn` with `known`; `spacing_px` is how many pixels a spacing takes at the body.
/// None if they have no pixel in common.
pub fn errors(drawn: &Seen, known: &Seen, spacing_px: f64) -> Option<Errors> {
    let inner = inner(drawn, known);
    let (mut angles, mut inner_angles) = (Vec::new(), Vec::new());
    let mut differ = 0_usize;
    for (i, (a, b)) in drawn.normals.iter().zip(&known.normals).enumerate() {
        match (a, b) {
            (Some(a), Some(b)) => {
                // Of two unit vectors, exact also where the cosine is nearly 1.
                let angle_deg = (2.0 * (0.5 * (*a - *b).length()).min(1.0).asin()).to_degrees();
                angles.push(angle_deg);
                if inner[i] {
                    inner_angles.push(angle_deg);
                }
            }
            (None, None) => {}
            _ => differ += 1,
        }
    }
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    angles.sort_unstable_by(f64::total_cmp);
    let last = angles.len().checked_sub(1)?;
    let outline_px = differ as f64 / known.outline_px().max(1.0);
    Some(Errors {
        normal_mean_deg: mean(&angles),
        normal_p95_deg: angles[(0.95 * last as f64).round() as usize],
        normal_inner_mean_deg: if inner_angles.is_empty() { mean(&angles) } else { mean(&inner_angles) },
        outline_px,
        outline_spacings: outline_px / spacing_px,
        covered_px: known.normals.iter().flatten().count(),
    })
}

/// Which pixels both surfaces cover, with all around them.
fn inner(a: &Seen, b: &Seen) -> Vec<bool> {
    let [width, height] = a.size_px.map(|side| side as usize);
    let both: Vec<bool> = a.normals.iter().zip(&b.normals).map(|(a, b)| a.is_some() && b.is_some()).collect();
    (0..both.len())
        .map(|i| {
            let (x, y) = (i % width, i / width);
            let around = |at: usize, end: usize| at.saturating_sub(RIM_PX)..(at + RIM_PX + 1).min(end);
            both[i] && around(y, height).all(|y| around(x, width).all(|x| both[y * width + x]))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    /// A disc of radius `radius_px` whose normals are `normal`.
    fn disc(radius_px: f64, normal: DVec3) -> Seen {
        let there = |i: usize| DVec3::new((i % 64) as f64 - 31.5, (i / 64) as f64 - 31.5, 0.0).length() < radius_px;
        Seen { size_px: [64, 64], normals: (0..64 * 64).map(|i| there(i).then_some(normal)).collect() }
    }

    #[test]
    fn known_errors_are_found() {
        let known = disc(20.0, DVec3::Z);
        let same = errors(&known, &known, 4.0).unwrap();
        assert_eq!((same.normal_mean_deg, same.outline_px), (0.0, 0.0));
        let tilted = DVec3::new(0.0, 10.0_f64.to_radians().sin(), 10.0_f64.to_radians().cos());
        let wrong = errors(&disc(22.0, tilted), &known, 4.0).unwrap();
        assert!((wrong.normal_mean_deg - 10.0).abs() < 1e-9 && (wrong.normal_p95_deg - 10.0).abs() < 1e-9);
        // Two pixels wider all around.
        assert!((wrong.outline_px - 2.0).abs() < 0.25, "{}", wrong.outline_px);
        assert_eq!(wrong.outline_spacings, wrong.outline_px / 4.0);
        let nothing = Seen { size_px: [64, 64], normals: vec![None; 64 * 64] };
        assert!(errors(&nothing, &known, 4.0).is_none());
    }
}
