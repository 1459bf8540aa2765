//! Water at rest: what it presses its side with, layer by layer.

use super::{Case, Converge, Reference, setting};
use crate::{Figure, Sample, Series, Setup, SetupResult};

/// A pool whose side is made of pieces, two spacings high each, that tell what pushes them. At rest a piece bears ρ g times
/// how far its middle is below the surface.
pub struct WallPressure;

const DEPTH_M: f64 = 0.24;
const SIDE_M: f64 = 0.16;
const SPACING_M: f64 = 0.02;
const DT_S: f64 = 1.0 / 240.0;
const END_S: f64 = 2.0;
const PIECES: usize = 6;
const G_M_S2: f64 = 9.81;

/// Height of a piece, m.
const PIECE_M: f64 = DEPTH_M / PIECES as f64;

/// Of a piece, from below: its middle's height, m.
fn middle_m(piece: usize) -> f64 {
    (piece as f64 + 0.5) * PIECE_M
}

/// What it bears at rest, Pa.
fn expected_pa(piece: usize) -> f64 {
    1000.0 * G_M_S2 * (DEPTH_M - middle_m(piece))
}

/// What each piece bears in the mean of the last quarter, Pa; none of a run that tells no forces.
fn pressures_pa(samples: &[Sample]) -> Option<[f64; PIECES]> {
    let forces = || samples.iter().flat_map(|sample| &sample.forces).filter(|force| force.time_s > 0.75 * END_S);
    let count = forces().count();
    let mean_n = |piece: usize| -forces().map(|force| force.on_solids_n[piece].x).sum::<f64>() / count as f64;
    (count > 0).then(|| std::array::from_fn(|piece| mean_n(piece) / (PIECE_M * SIDE_M)))
}

impl Case for WallPressure {
    fn name(&self) -> &'static str {
        "wall-pressure"
    }

    fn summary(&self) -> &'static str {
        "what water at rest presses a side with (hydrostatics)"
    }

    fn reference(&self) -> Reference {
        Reference::Analytic
    }

    fn spacing_m(&self) -> f64 {
        SPACING_M
    }

    fn setup(&self, settings: &[String]) -> SetupResult {
        let spacing_m = setting(settings, "spacing_m", SPACING_M);
        let dt_s = DT_S * spacing_m / SPACING_M;
        let wall_m = 3.0 * SPACING_M;
        let piece = |piece: usize| {
            // The highest goes on to where no water comes, and is as high as the others as far as water stands.
            let top_m = if piece + 1 == PIECES { 2.0 * DEPTH_M } else { (piece + 1) as f64 * PIECE_M };
            let bottom_m = if piece == 0 { -wall_m } else { piece as f64 * PIECE_M };
            format!(
                "[[solid]]\nbox = {{ size_m = [{wall_m:?}, {:?}, {:?}] }}\ncentre_m = [{:?}, {:?}, {:?}]\n\
                 measure_force = true\n",
                top_m - bottom_m,
                2.0 * SIDE_M,
                0.5 * wall_m,
                0.5 * (bottom_m + top_m),
                0.5 * SIDE_M,
            )
        };
        let pieces: String = (0..PIECES).map(piece).collect();
        let far_m = wall_m + SIDE_M;
        let text = format!(
            "spacing_m = {spacing_m}
            [domain]
            min_m = [0, 0, 0]
            max_m = [{far_m}, {}, {SIDE_M}]
            [[fluid]]
            block = {{ min_m = [{wall_m}, 0, 0], max_m = [{far_m}, {DEPTH_M}, {SIDE_M}] }}
            {pieces}
            [solver]
            dt_s = {dt_s}",
            1.5 * DEPTH_M,
        );
        Ok(Setup::new(self.name(), &text, settings, END_S, 8)?.relaxed())
    }

    fn figures(&self, _: &Setup, samples: &[Sample], _: Converge<'_>) -> Option<Vec<Figure>> {
        let found_pa = pressures_pa(samples).unwrap_or([f64::NAN; PIECES]);
        let bottom_pa = 1000.0 * G_M_S2 * DEPTH_M;
        let offs: [f64; PIECES] = std::array::from_fn(|piece| (found_pa[piece] - expected_pa(piece)) / bottom_pa);
        let rms = (offs.iter().map(|off| off * off).sum::<f64>() / PIECES as f64).sqrt();
        let judged = Figure::judged(
            "pressure off",
            rms,
            "",
            0.05,
            "root mean square over ρ g times the depth, of which a layer has 8 %; mean of the last quarter",
        );
        let all: f64 = found_pa.iter().sum();
        let whole = all / (0..PIECES).map(expected_pa).sum::<f64>() - 1.0;
        let told = Figure::told("whole side off", whole, "", "force on all of it over ρ g depth²/2, less one");
        Some(vec![judged, told, Figure::told("lowest piece off", offs[0], "", "over ρ g times the depth")])
    }

    fn series(&self, _: &Setup, samples: &[Sample]) -> Vec<Series> {
        let Some(found_pa) = pressures_pa(samples) else { return Vec::new() };
        vec![Series {
            name: "pressure".into(),
            x: "height, cm".into(),
            y: "pressure on the side, Pa".into(),
            computed: (0..PIECES).map(|piece| (100.0 * middle_m(piece), found_pa[piece])).collect(),
            reference: (0..PIECES).map(|piece| (100.0 * middle_m(piece), expected_pa(piece))).collect(),
            measured: false,
        }]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Force;
    use glam::DVec3;

    #[test]
    fn hydrostatics_is_not_off_and_a_side_that_bears_alike_everywhere_is() {
        let setup = WallPressure.setup(&[]).unwrap();
        assert_eq!(setup.scene.solids.len(), PIECES);
        let off = |pressure_pa: &dyn Fn(usize) -> f64| {
            let push = |piece: usize| -DVec3::X * pressure_pa(piece) * PIECE_M * SIDE_M;
            let on_solids_n: Vec<DVec3> = (0..PIECES).map(push).collect();
            let forces = vec![
                Force { time_s: 0.1, on_solids_n: vec![DVec3::X; PIECES] },
                Force { time_s: 0.9 * END_S, on_solids_n },
            ];
            let samples = [Sample { forces, ..Sample::default() }];
            WallPressure.figures(&setup, &samples, &|_| None).unwrap()[0].value.unwrap()
        };
        assert!(off(&expected_pa) < 1e-12);
        assert!(off(&|_| expected_pa(2)) > 0.2);
        assert!(off(&|piece| 0.85 * expected_pa(piece)) > 0.05);
        assert_eq!(WallPressure.figures(&setup, &[Sample::default()], &|_| None).unwrap()[0].value, None);
    }
}
