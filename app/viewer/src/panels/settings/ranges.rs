//! How far sliders go: what is useful, not what is allowed. Other values can be typed.

use brooklet_fluid::scene::Limits;

/// A slider's ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Range {
    pub least: f64,
    pub most: f64,
    pub logarithmic: bool,
}

const fn plain(least: f64, most: f64) -> Range {
    Range { least, most, logarithmic: false }
}

const USEFUL: &[(&str, Range)] = &[
    ("solver.dt_s", Range { least: 5e-4, most: 0.02, logarithmic: true }),
    ("solver.substeps", plain(1.0, 8.0)),
    ("solver.pbf.iterations", plain(0.0, 16.0)),
    ("solver.support_ratio", plain(1.5, 3.0)),
    ("solver.pbf.relaxation", plain(0.05, 1.0)),
    ("solver.pbf.cfm", Range { least: 1e-4, most: 1.0, logarithmic: true }),
    ("solver.pbf.s_corr_k", plain(0.0, 0.5)),
    ("solver.pbf.s_corr_distance_ratio", plain(0.0, 0.9)),
    ("forces.xsph", plain(0.0, 0.5)),
    ("forces.vorticity_m_s", plain(0.0, 1.0)),
    ("solver.max_speed_m_s", Range { least: 0.1, most: 100.0, logarithmic: true }),
    ("solver.neighbour_slots", plain(8.0, 128.0)),
    ("surface.iterations", plain(0.0, 100.0)),
    ("surface.smoothing_ratio", plain(0.0, 6.0)),
    ("surface.radius_ratio", plain(0.3, 1.5)),
    ("surface.refraction", plain(0.0, 2.0)),
    ("outputs.measure_every_steps", plain(0.0, 32.0)),
    ("domain.dimensions", plain(2.0, 3.0)),
];

/// The slider's ends for a field that is allowed within `limits` and is `value` now.
pub(super) fn of(path: &str, limits: Limits, value: f64) -> Range {
    let known = USEFUL.iter().find(|(known, _)| *known == path).map(|(_, range)| *range);
    known.unwrap_or_else(|| {
        // Fields without useful ends of their own are lengths and densities: some times larger or smaller.
        // By powers of two, so that the ends stay while the slider moves.
        let middle = if value > 0.0 { 2f64.powf(value.log2().round()) } else { 1.0 };
        Range { least: (middle / 8.0).max(limits.least), most: (8.0 * middle).min(limits.most), logarithmic: true }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use brooklet_fluid::Scene;
    use brooklet_fluid::scene::Kind;

    #[test]
    fn sliders_stay_within_what_is_allowed_and_know_their_fields() {
        let settings = Scene::load("dam-break", &[]).unwrap().settings();
        for (path, range) in USEFUL {
            let setting = settings.iter().find(|setting| setting.path == *path).unwrap_or_else(|| panic!("no {path}"));
            let (Kind::Number(limits) | Kind::Whole(limits)) = setting.kind else { panic!("{path} is no number") };
            assert!(limits.least <= range.least && range.least < range.most && range.most <= limits.most, "{path}");
        }
    }
}
