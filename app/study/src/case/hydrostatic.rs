//! Water at rest: a column without sides, under its own weight.

use brooklet_fluid::solver::pbf::IterationWeights;
use brooklet_reference::column::Column;

use super::{Case, Converge, Reference, own_path, setting};
use crate::{Figure, Sample, Series, Setup, SetupResult};

/// A column between a floor and air, periodic along x and z. Water keeps its height; what Jacobi
/// iterations leave of its compression is the column law's (`brooklet_reference::column`).
pub struct Hydrostatic {
    name: &'static str,
    height_m: f64,
    end_s: f64,
}

/// 20 layers of the default spacing, for 2 s.
pub const HYDROSTATIC: Hydrostatic = Hydrostatic { name: "hydrostatic", height_m: HEIGHT_M, end_s: 2.0 };
/// 12 layers for 1 s: for maps of many runs with many neighbours.
pub const SHALLOW: Hydrostatic = Hydrostatic { name: "hydrostatic-shallow", height_m: 0.24, end_s: 1.0 };

/// Of the deeper.
const HEIGHT_M: f64 = 0.4;
const SPACING_M: f64 = 0.02;
/// Of the default spacing; it shrinks with the spacing.
const DT_S: f64 = 1.0 / 240.0;

impl Case for Hydrostatic {
    fn name(&self) -> &'static str {
        self.name
    }

    fn summary(&self) -> &'static str {
        "water at rest in a column without sides keeps its height (hydrostatics)"
    }

    fn reference(&self) -> Reference {
        Reference::Analytic
    }

    fn spacing_m(&self) -> f64 {
        SPACING_M
    }

    fn setup(&self, settings: &[String]) -> SetupResult {
        let spacing_m = setting(settings, "spacing_m", SPACING_M);
        let side_m = periodic_side_m(spacing_m, setting(settings, "solver.support_ratio", 2.0), 8.0 * spacing_m);
        let dt_s = DT_S * spacing_m / SPACING_M;
        let text = format!(
            "spacing_m = {spacing_m}
            [domain]
            min_m = [0, 0, 0]
            max_m = [{side_m}, {}, {side_m}]
            periodic = [true, false, true]
            [[fluid]]
            block = {{ min_m = [0, 0, 0], max_m = [{side_m}, {}, {side_m}] }}
            [solver]
            dt_s = {dt_s}",
            1.5 * self.height_m,
            self.height_m,
        );
        Ok(Setup::new(self.name(), &text, settings, self.end_s, 20)?.relaxed())
    }

    fn figures(&self, setup: &Setup, samples: &[Sample], _: Converge<'_>) -> Option<Vec<Figure>> {
        let scene = &setup.scene;
        let layers = (self.height_m / scene.spacing_m).round();
        let column = Column {
            dimensions: scene.domain.dimensions,
            layers: layers as u32,
            spacing_m: scene.spacing_m,
            support_ratio: scene.solver.support_ratio,
            gravity_m_s2: -scene.gravity_m_s2[1],
            dt_s: scene.substep_s(),
            relaxation: IterationWeights::of(scene).response / f64::from(scene.solver.pbf.iterations.max(1)),
            iterations: scene.solver.pbf.iterations,
            cfm: scene.solver.pbf.cfm,
        };
        // The last quarter: by then the column has settled.
        let last = &samples[samples.len() - samples.len().div_ceil(4)..];
        let mean = |of: &dyn Fn(&Sample) -> f64| last.iter().map(of).sum::<f64>() / last.len() as f64;
        let height_m = mean(&|sample| 2.0 * sample.middle_m().y);
        let restless = mean(&|sample| sample.kinetic_m2_s2()) / (-scene.gravity_m_s2[1] * self.height_m);
        let mut figures = vec![
            Figure::judged(
                "height loss",
                1.0 - height_m / self.height_m,
                "",
                0.03,
                "half of the law's compression of the bottom (2 % here), and half a layer at the surface",
            ),
            Figure::judged("kinetic energy", restless, "", 5.0e-4, "over g H: what slosh of 1 cm/s would have is 1e-5"),
        ];
        // What ends iterations by a tolerance has no law.
        if own_path(scene.solver.method.name(), "divergence_tolerance").is_none() {
            let law = bottom_compression(setup, &column);
            let by = "of the bottom layer, by the column law or the equation of state";
            figures.insert(1, Figure::told("law's compression", law, "", by));
        }
        Some(figures)
    }

    fn series(&self, _: &Setup, samples: &[Sample]) -> Vec<Series> {
        let last_s = samples.last().map_or(0.0, |s| s.time_s);
        vec![Series {
            name: "height".into(),
            x: "t, s".into(),
            y: "height, cm".into(),
            computed: samples.iter().map(|s| (s.time_s, 200.0 * s.middle_m().y)).collect(),
            reference: vec![(0.0, 100.0 * self.height_m), (last_s, 100.0 * self.height_m)],
            measured: false,
        }]
    }
}

/// Compression at the bottom of a column, by the law of iterations or by the equation of state, p = rho g H.
pub(crate) fn bottom_compression(setup: &Setup, column: &Column) -> f64 {
    let sph = &setup.scene.solver.sph;
    let height_m = f64::from(column.layers) * column.spacing_m;
    match own_path(setup.scene.solver.method.name(), "stiffness_m2_s2") {
        Some(_) => {
            let over = sph.exponent * column.gravity_m_s2 * height_m / setup.scene.stiffness_m2_s2();
            (1.0 + over).powf(1.0 / sph.exponent) - 1.0
        }
        None => column.bottom_compression(),
    }
}

/// A side near `wanted_m` that a periodic axis may have, and that spacings fill: a whole multiple of
/// 4 h and of d.
pub(crate) fn periodic_side_m(spacing_m: f64, support_ratio: f64, wanted_m: f64) -> f64 {
    let step = 4.0 * support_ratio;
    let whole = |n: &u32| {
        let spacings = f64::from(*n) * step;
        (spacings - spacings.round()).abs() < 1e-9
    };
    let off = |n: &u32| (f64::from(*n) * step * spacing_m - wanted_m).abs();
    let count = (1..200).filter(whole).min_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or(1);
    f64::from(count) * step * spacing_m
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn periodic_sides_are_filled_by_lattice_and_places() {
        let spacings =
            |ratio: f64, wanted: f64| (periodic_side_m(0.01, ratio, wanted * 0.01) / 0.01 * 1e6).round() / 1e6;
        assert_eq!([spacings(2.0, 8.0), spacings(2.5, 8.0), spacings(3.0, 8.0)], [8.0, 10.0, 12.0]);
        assert_eq!([spacings(1.6, 32.0), spacings(2.2, 40.0)], [32.0, 44.0]);
    }
}
