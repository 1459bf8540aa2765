//! The mechanical energy of a run. Nothing drives a case from outside once it moves, so what walls, viscosity and the
//! solver take is the only way for it to change: it may fall, and what it rises by came from nowhere. Of a case that
//! something drives, it is not judged.
//!
//! But for what compression holds. It grows with depth, and is a spring's: a column of height H that is compressed by ε at
//! the floor, and by ε₀ when it has come to rest, holds (ε²/ε₀) g H / 6 over its mass, and gives it back when it bounces.
//! Without a loss ε would be 2 ε₀.

use brooklet_fluid::scene::{Method, SolidSettings};
use glam::DVec3;

use crate::backend::GpuRun;
use crate::{Figure, Sample, Setup};

/// Of the energy at play: what it may rise by.
pub const RISE: f64 = 0.01;
/// Compression of 99 of 100 particles below which what a start was squeezed by on purpose is spent.
const SPENT: f64 = 0.1;

/// The program's 99th percentile is within 3 % of itself.
const P99_WITHIN: f64 = 1.03;

/// Energy over mass at the moments of a run, m²/s².
struct Course {
    /// Kinetic.
    kinetic: Vec<f64>,
    /// Kinetic and potential, as the integrator keeps it.
    total: Vec<f64>,
}

/// What a run of `setup` is judged by, from its relaxed start on: the largest rise of its energy over its lowest so far, and
/// what was taken of it in all. Nothing where gravity drives fluid round a periodic axis, or a solid moves as it is told.
pub fn figures(setup: &Setup, run: &GpuRun, limit: f64) -> Vec<Figure> {
    let spent = || run.measured.iter().position(|measured| measured.stats.compression.p99 < SPENT);
    let from = if setup.squeezed { spent().map_or(usize::MAX, |index| index + 1) } else { 0 };
    let all: Vec<&Sample> = std::iter::once(&run.start).chain(&run.samples).skip(from).collect();
    let compression = || run.measured.iter().map(|measured| measured.stats.compression.p99);
    let (most, at_rest) = (compression().fold(0.0, f64::max), compression().next_back().unwrap_or(0.0));
    // Of what is compressed by nothing, nothing.
    let overshoot = most / at_rest.max(0.5 * most).max(f64::MIN_POSITIVE);
    let held_m2_s2 = P99_WITHIN.powi(2) * most * overshoot * g_times_height(setup, &run.start) / 6.0;
    judged(setup, &all, held_m2_s2, limit)
}

/// As [`figures`] of samples alone, whose compression nobody measured.
pub fn of_samples(setup: &Setup, samples: &[&Sample], limit: f64) -> Vec<Figure> {
    judged(setup, samples, 0.0, limit)
}

/// m²/s².
fn g_times_height(setup: &Setup, start: &Sample) -> f64 {
    let g_m_s2 = DVec3::from_array(setup.scene.gravity_m_s2);
    let depths = || start.positions_m.iter().map(|at| g_m_s2.dot(*at)).filter(|depth| depth.is_finite());
    (depths().fold(f64::NEG_INFINITY, f64::max) - depths().fold(f64::INFINITY, f64::min)).max(0.0)
}

fn judged(setup: &Setup, samples: &[&Sample], held_m2_s2: f64, limit: f64) -> Vec<Figure> {
    let scene = &setup.scene;
    let falls_round = scene.gravity_m_s2.iter().zip(scene.period_m()).any(|(g, period_m)| *g != 0.0 && period_m != 0.0);
    if falls_round || scene.solids.iter().any(SolidSettings::is_driven) {
        return Vec::new();
    }
    let course = course(setup, samples);
    let g_m_s2 = DVec3::from_array(scene.gravity_m_s2).length();
    // Fluid at rest has no kinetic energy to hold a rise against: then it is what lifting it by a spacing takes.
    let at_play = course.kinetic.iter().copied().fold(g_m_s2 * scene.fitted_spacing_m(), f64::max);
    let (mut least, mut rise) = (f64::INFINITY, if course.total.is_empty() { f64::NAN } else { 0.0 });
    for &total in &course.total {
        least = least.min(total);
        // f64::max would drop a NaN.
        rise = if total - least > rise || total.is_nan() { total - least } else { rise };
    }
    let taken = course.total.first().zip(course.total.last()).map_or(f64::NAN, |(first, last)| first - last);
    vec![
        Figure::judged(
            "energy rise",
            // What is not a number stays one.
            if rise <= held_m2_s2 { 0.0 } else { (rise - held_m2_s2) / at_play },
            "",
            limit,
            "largest, over the lowest so far and what compression holds; over the largest kinetic energy, or over g d",
        ),
        Figure::told("energy taken", taken / at_play, "", "by walls, viscosity and the solver, in all; over the same"),
    ]
}

/// Of the particles that are sound at all of these moments.
fn course(setup: &Setup, samples: &[&Sample]) -> Course {
    let scene = &setup.scene;
    let (g_m_s2, dt_s) = (DVec3::from_array(scene.gravity_m_s2), scene.substep_s());
    let is_sound = |i: usize| {
        let finite = |of: &[DVec3]| of.get(i).is_some_and(|v| v.is_finite());
        samples.iter().all(|sample| finite(&sample.positions_m) && finite(&sample.velocities_m_s))
    };
    let sound: Vec<usize> = (0..setup.count()).filter(|&i| is_sound(i)).collect();
    let mean = |of: &dyn Fn(usize) -> f64| match sound.len() {
        0 => f64::NAN,
        count => sound.iter().map(|&i| of(i)).sum::<f64>() / count as f64,
    };
    let kinetic = |sample: &&Sample| mean(&|i| 0.5 * sample.velocities_m_s[i].length_squared());
    // Symplectic Euler keeps v²/2 - g x + dt g v / 2 of what falls freely, exactly; DFSPH moves first, with it half a step
    // the other way.
    let half_s = if scene.solver.method == Method::Dfsph { -0.5 * dt_s } else { 0.5 * dt_s };
    let potential = |sample: &&Sample| mean(&|i| g_m_s2.dot(half_s * sample.velocities_m_s[i] - sample.positions_m[i]));
    let kinetic: Vec<f64> = samples.iter().map(kinetic).collect();
    let total = kinetic.iter().zip(samples).map(|(kinetic, sample)| kinetic + potential(sample)).collect();
    Course { kinetic, total }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Verdict;
    use crate::case::{Case, FreeFall, TAYLOR_GREEN};

    /// Two particles that fall as the integrator has them fall, their speeds `factor` times as high at the end.
    fn falling(setup: &Setup, factor: f64) -> Vec<Sample> {
        let (g, dt_s) = (DVec3::from_array(setup.scene.gravity_m_s2), setup.scene.substep_s());
        let mut now = setup.start();
        let mut samples = vec![now.clone()];
        for k in 1..=20 {
            for (at, v) in now.positions_m.iter_mut().zip(&mut now.velocities_m_s) {
                *v = (*v + g * dt_s) * if k == 20 { factor } else { 1.0 };
                *at += *v * dt_s;
            }
            samples.push(now.clone());
        }
        samples
    }

    fn rise(setup: &Setup, samples: &[Sample]) -> Figure {
        of_samples(setup, &samples.iter().collect::<Vec<_>>(), RISE).swap_remove(0)
    }

    fn measured(p99: f64) -> crate::backend::Measured {
        let compression = brooklet_fluid::measure::Summary { mean: 0.5 * p99, p99, max: p99 };
        let stats = brooklet_fluid::Stats { compression, ..brooklet_fluid::Stats::default() };
        crate::backend::Measured { time_s: 0.0, stats }
    }

    #[test]
    fn free_fall_neither_gains_nor_loses_and_a_push_is_seen() {
        let setup = FreeFall.setup(&[]).unwrap();
        let still = rise(&setup, &falling(&setup, 1.0));
        assert!(still.value.unwrap() < 1e-9, "{still:?}");
        assert_eq!(rise(&setup, &falling(&setup, 0.5)).verdict(), Verdict::Meets, "it may lose");
        assert_eq!(rise(&setup, &falling(&setup, 1.05)).verdict(), Verdict::FallsShort);
        let taken = of_samples(&setup, &falling(&setup, 0.5).iter().collect::<Vec<_>>(), RISE).swap_remove(1);
        assert!(taken.value.unwrap() > 0.1, "{taken:?}");
    }

    #[test]
    fn a_rise_in_the_middle_and_what_is_not_finite_are_seen() {
        let setup = TAYLOR_GREEN.setup(&[]).unwrap();
        let at = |factor: f64| {
            let mut sample = setup.start();
            sample.velocities_m_s.iter_mut().for_each(|v| *v *= factor);
            sample
        };
        let verdict = |factors: &[f64]| rise(&setup, &factors.iter().map(|&f| at(f)).collect::<Vec<_>>()).verdict();
        assert_eq!(verdict(&[1.0, 0.9, 0.9, 0.8]), Verdict::Meets);
        // Below the start's, and yet from nowhere.
        assert_eq!(verdict(&[1.0, 0.8, 0.9, 0.7]), Verdict::FallsShort);
        assert_eq!(verdict(&[1.0, f64::NAN]), Verdict::FallsShort);
        assert_eq!(rise(&setup, &[]).verdict(), Verdict::FallsShort, "nothing was seen");
        // One that is out takes nothing with it.
        let mut lost = at(0.9);
        lost.positions_m[3] = DVec3::NAN;
        assert_eq!(rise(&setup, &[at(1.0), lost]).verdict(), Verdict::Meets);
    }

    #[test]
    fn what_is_driven_is_not_judged() {
        let solid = |keyframes: &str| {
            let text = format!(
                "spacing_m = 0.05\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [1, 1, 1]\n[[fluid]]\n\
                 block = {{ min_m = [0, 0, 0], max_m = [0.4, 0.4, 0.4] }}\n[[solid]]\n\
                 box = {{ size_m = [0.2, 0.2, 0.2] }}\n{keyframes}"
            );
            Setup::new("driven", &text, &[], 1.0, 1).unwrap()
        };
        let judged = |setup: Setup| of_samples(&setup, &[&setup.start()], RISE).len();
        assert_eq!(judged(solid("centre_m = [0.8, 0.5, 0.5]")), 2, "it stands");
        assert_eq!(judged(solid("centre_m = [0.8, 0.5, 0.5]\ndensity_kg_m3 = 500")), 2, "the fluid moves it");
        assert_eq!(judged(solid("centre_m = [0.8, 0.5, 0.5]\nspin_deg_s = [0, 90, 0]")), 0);
        let keys = "[[solid.keyframe]]\ntime_s = 0.0\ncentre_m = [0.8, 0.5, 0.5]\n\
                    [[solid.keyframe]]\ntime_s = 1.0\ncentre_m = [0.7, 0.5, 0.5]";
        assert_eq!(judged(solid(keys)), 0);
    }

    #[test]
    fn what_compression_holds_may_come_back_and_no_more() {
        let setup = crate::case::HYDROSTATIC.setup(&[]).unwrap();
        let height_m = setup.start().positions_m.iter().map(|at| at.y).fold(0.0, f64::max);
        let at = |lifted_m: f64| {
            let mut sample = setup.start();
            sample.positions_m.iter_mut().for_each(|at| at.y += lifted_m);
            sample
        };
        let verdict_of = |lifted_m: f64, p99: [f64; 2]| {
            let measured = p99.map(measured).to_vec();
            let samples = vec![at(0.0), at(lifted_m)];
            figures(&setup, &GpuRun { start: at(0.0), samples, measured, ..GpuRun::default() }, RISE)[0].verdict()
        };
        let verdict = |lifted_m: f64, p99: f64| verdict_of(lifted_m, [p99; 2]);
        let held_m = 0.12 * height_m / 6.0;
        assert_eq!(verdict_of(1.7 * held_m, [0.12, 0.06]), Verdict::Meets);
        assert_eq!(verdict_of(2.3 * held_m, [0.12, 0.06]), Verdict::FallsShort);
        assert_eq!(verdict_of(2.3 * held_m, [0.12, 0.0]), Verdict::FallsShort);
        assert_eq!(verdict(0.9 * held_m, 0.12), Verdict::Meets);
        assert_eq!(verdict(1.2 * held_m, 0.12), Verdict::FallsShort);
        assert_eq!(verdict(0.9 * held_m, 0.01), Verdict::FallsShort, "it was not compressed");
    }

    #[test]
    fn a_squeezed_start_is_judged_once_it_is_spent() {
        let mut setup = TAYLOR_GREEN.setup(&[]).unwrap();
        let at = |factor: f64, time_s: f64| {
            let mut sample = setup.start();
            sample.velocities_m_s.iter_mut().for_each(|v| *v *= factor);
            Sample { time_s, ..sample }
        };
        let run = |factors: [f64; 4], p99: [f64; 3]| GpuRun {
            start: at(factors[0], 0.0),
            samples: factors[1..].iter().map(|&f| at(f, 1.0)).collect(),
            measured: p99.map(measured).to_vec(),
            ..GpuRun::default()
        };
        let parts = run([0.0, 1.0, 0.9, 0.8], [0.05, 0.02, 0.01]);
        let late = run([0.0, 1.0, 0.9, 1.0], [0.3, 0.05, 0.01]);
        let never = run([0.0, 1.0, 0.9, 0.8], [0.3, 0.3, 0.3]);
        let verdict = |setup: &Setup, run: &GpuRun| figures(setup, run, RISE)[0].verdict();
        assert_eq!(verdict(&setup, &parts), Verdict::FallsShort);
        setup.squeezed = true;
        assert_eq!(
            [&parts, &late, &never].map(|run| verdict(&setup, run)),
            [Verdict::Meets, Verdict::FallsShort, Verdict::FallsShort]
        );
    }
}
