//! What runs in each row, and what some of them are judged by.

use brooklet_reference::column::Column;
use glam::DVec3;

use crate::backend::GpuRun;
use crate::case::{Case, FreeFall, bottom_compression, method_of, own_path, with_speed};
use crate::{Figure, Setup, SetupResult};

/// A box of `size_m` at the origin with a block in it, and `more` lines.
fn pool(size_m: [f64; 3], block_m: [f64; 3], more: &str) -> String {
    let ([x, y, z], [a, b, c]) = (size_m, block_m);
    format!(
        "spacing_m = 0.02
        [domain]
        min_m = [0, 0, 0]
        max_m = [{x}, {y}, {z}]
        [[fluid]]
        block = {{ min_m = [0, 0, 0], max_m = [{a}, {b}, {c}] }}
        {more}"
    )
}

pub(super) fn two_particles(settings: &[String]) -> SetupResult {
    FreeFall.setup(settings)
}

pub(super) fn one_point(settings: &[String]) -> SetupResult {
    let mut setup = Setup::new("one-point", &pool([0.3; 3], [0.08; 3], ""), settings, 2.0, 8)?;
    setup.place(|at, _| *at = DVec3::new(0.15, 0.1, 0.15));
    Ok(setup.squeezed())
}

pub(super) fn one_cell(settings: &[String]) -> SetupResult {
    let mut setup = Setup::new("one-cell", &pool([0.4; 3], [0.2; 3], ""), settings, 4.0, 8)?;
    let middle = DVec3::new(0.2, 0.1, 0.2);
    // A cell is 2 cm: the block shrinks to 1.5 cm.
    setup.place(|at, _| *at = middle + (*at - DVec3::splat(0.1)) * 0.075);
    Ok(setup.squeezed())
}

pub(super) fn list_overflow(settings: &[String]) -> SetupResult {
    let more = "[solver]\nneighbour_slots = 16";
    Setup::new("list-overflow", &pool([0.3, 0.3, 0.2], [0.2; 3], more), settings, 0.5, 4)
}

pub(super) fn overflow_counted(_: &Setup, run: &GpuRun) -> Vec<Figure> {
    let counted = run.counted().neighbour_overflow as f64;
    vec![Figure::at_least(
        "neighbours counted",
        counted,
        "",
        1000.0,
        "26 neighbours in 16 slots, 1,000 particles: short by so many",
    )]
}

pub(super) fn capacity(settings: &[String]) -> SetupResult {
    // 257 x 256 x 256 particles: ids have 24 bits.
    Setup::new("capacity", &pool([5.14, 5.12, 5.12], [5.14, 5.12, 5.12], ""), settings, 0.1, 2)
}

/// A small dam break with its domain's corner anywhere, a number of times as large; ten steps.
fn moved(name: &str, corner_m: f64, scale: f64, settings: &[String]) -> SetupResult {
    let at = |x: f64| corner_m + scale * x;
    let text = format!(
        "spacing_m = {}
        [domain]
        min_m = [{1}, {1}, {1}]
        max_m = [{2}, {2}, {2}]
        [[fluid]]
        block = {{ min_m = [{1}, {1}, {1}], max_m = [{3}, {3}, {2}] }}
        [solver]
        dt_s = {4}",
        // Powers of two, which f64 holds at 10 km as well.
        scale * 0.015625,
        at(0.0),
        at(0.25),
        at(0.125),
        scale.sqrt() / 256.0,
    );
    Setup::new(name, &text, settings, scale.sqrt() * 12.0 / 256.0, 3)
}

pub(super) fn at_origin(settings: &[String]) -> SetupResult {
    moved("at-origin", 0.0, 1.0, settings)
}

pub(super) fn far_origin(settings: &[String]) -> SetupResult {
    moved("far-origin", 1.0e4, 1.0, settings)
}

pub(super) fn large(settings: &[String]) -> SetupResult {
    moved("large", 0.0, 1024.0, settings)
}

pub(super) fn long_steps(settings: &[String]) -> SetupResult {
    let more = "[solver]\ndt_s = 0.04166667";
    Setup::new("dt-times-10", &pool([0.4, 0.5, 0.16], [0.16, 0.32, 0.16], more), settings, 5.0, 10)
}

/// A small dam break by a solver with `more` settings.
fn dam(name: &str, settings: &[String], more: &[String], end_s: f64, samples: u32) -> SetupResult {
    let text = pool([0.4, 0.5, 0.16], [0.16, 0.32, 0.16], "");
    Setup::new(name, &text, &[settings, more].concat(), end_s, samples)
}

/// A column at rest between its walls: a second of it would take a hundred thousand substeps.
pub(super) fn stiff(settings: &[String]) -> SetupResult {
    let text = pool([0.16, 0.5, 0.16], [0.16, 0.32, 0.16], "");
    let plain = Setup::new("stiffness-times-1000", &text, settings, 1.0, 1)?;
    let path = own_path(method_of(settings), "stiffness_m2_s2").unwrap_or_default();
    let stiff = format!("{path}={:?}", 1000.0 * plain.scene.stiffness_m2_s2());
    Setup::new("stiffness-times-1000", &text, &[settings, &[stiff]].concat(), 0.15, 6)
}

/// Of a viscosity that is set, a thousand times what the solver has without: it creeps, so a tenth of a second will do.
pub(super) fn viscous(settings: &[String]) -> SetupResult {
    let name = "viscosity-times-1000";
    match own_path(method_of(settings), "viscosity_m2_s") {
        Some(path) => {
            let plain = dam(name, settings, &[], 1.0, 1)?;
            dam(name, settings, &[format!("{path}={:?}", 1000.0 * plain.scene.sph_viscosity_m2_s())], 0.1, 6)
        }
        None => dam(name, settings, &["forces.xsph=1.0".into()], 4.0, 8),
    }
}

pub(super) fn density_ratio(settings: &[String]) -> SetupResult {
    let more = "[[solid]]
        box = { size_m = [0.1, 0.06, 0.1] }
        centre_m = [0.12, 0.13, 0.12]
        density_kg_m3 = 100
        [[solid]]
        sphere = { radius_m = 0.05 }
        centre_m = [0.28, 0.08, 0.28]
        density_kg_m3 = 10000";
    Setup::new("density-ratio", &pool([0.4, 0.3, 0.4], [0.4, 0.1, 0.4], more), settings, 3.0, 8)
}

/// Of the wall below.
const WALL_M_S: f64 = 4.7;

/// A wall that stands in water, and is then driven through it for a third of a tenth of a second.
pub(super) fn moving_wall(settings: &[String]) -> SetupResult {
    let (begins_s, way_m) = (0.1, 0.15);
    let ends_s = begins_s + way_m / WALL_M_S;
    let key =
        |time_s: f64, x_m: f64| format!("[[solid.keyframe]]\ntime_s = {time_s}\ncentre_m = [{x_m}, 0.25, 0.08]\n");
    let keys = [key(0.0, 0.06), key(begins_s, 0.06), key(ends_s, 0.06 + way_m)].concat();
    let more = format!("[[solid]]\nbox = {{ size_m = [0.04, 0.46, 0.14] }}\n{keys}");
    Setup::new("moving-wall", &pool([0.6, 0.5, 0.16], [0.6, 0.1, 0.16], &more), settings, 0.4, 40)
}

/// A wall that nothing gives way to throws what it meets at twice its speed, and no faster.
pub(super) fn bounded_ejection(_: &Setup, run: &GpuRun) -> Vec<Figure> {
    let fastest_m_s = run.measured.iter().map(|measured| measured.stats.max_speed_m_s).fold(0.0, f64::max);
    vec![
        Figure::judged("fastest over the wall", fastest_m_s / WALL_M_S, "", 2.0, "of what stands and is met by a wall"),
        Figure::at_least("pushed", fastest_m_s / WALL_M_S, "", 0.5, "the wall meets water"),
    ]
}

/// The law of ten times the step, 16 layers: past its range it says more than there is, so it bounds.
pub(super) fn within_the_law(setup: &Setup, run: &GpuRun) -> Vec<Figure> {
    let law = bottom_compression(setup, &Column { layers: 16, dimensions: 3, ..column(setup.scene.substep_s()) });
    let Some(last) = run.measured.last() else { return Vec::new() };
    let ratio = last.stats.compression.p99 / law;
    vec![Figure::judged(
        "compression over the law's",
        ratio,
        "",
        1.0,
        "p99 at the end over the law's bottom compression",
    )]
}

/// A column of 200 layers in two dimensions, eight particles wide, whose bottom the law squeezes by .15.
fn column(dt_s: f64) -> Column {
    Column {
        dimensions: 2,
        layers: 200,
        spacing_m: 0.02,
        support_ratio: 2.0,
        gravity_m_s2: 9.81,
        dt_s,
        relaxation: 0.5,
        iterations: 4,
        cfm: 0.01,
    }
}

pub(super) fn tall_column(settings: &[String]) -> SetupResult {
    let dt_s = column(1.0).dt_s_for(0.15);
    let text = format!(
        "spacing_m = 0.02
        [domain]
        min_m = [0, 0, 0]
        max_m = [0.16, 4.4, 0.02]
        periodic = [true, false, false]
        dimensions = 2
        [[fluid]]
        block = {{ min_m = [0, 0, 0], max_m = [0.16, 4.0, 0.02] }}
        [solver]
        dt_s = {dt_s:?}"
    );
    Setup::new("tall-column", &text, settings, 4.0, 80)
}

pub(super) fn law_holds(setup: &Setup, run: &GpuRun) -> Vec<Figure> {
    let column = column(setup.scene.substep_s());
    let last = &run.measured[run.measured.len() / 2..];
    let p99 = last.iter().map(|m| m.stats.compression.p99).sum::<f64>() / last.len().max(1) as f64;
    let ratio = p99 / bottom_compression(setup, &column);
    // The law is of so many iterations: what ends by a tolerance has it as a bound.
    if own_path(setup.scene.solver.method.name(), "divergence_tolerance").is_some() {
        return vec![Figure::judged("compression over the law's", ratio, "", 1.0, "p99, mean of the last half")];
    }
    let off = ratio - 1.0;
    vec![Figure::judged(
        "law's error",
        off,
        "",
        0.2,
        "measured p99 over the law's bottom compression, mean of the last half",
    )]
}

pub(super) fn sheet(settings: &[String]) -> SetupResult {
    let text = "
        spacing_m = 0.02
        [domain]
        min_m = [0, 0, 0]
        max_m = [0.6, 0.3, 0.6]
        [[fluid]]
        block = { min_m = [0.04, 0.1, 0.04], max_m = [0.56, 0.12, 0.56] }";
    Setup::new("sheet", text, settings, 2.0, 8)
}

pub(super) fn no_clumps(setup: &Setup, run: &GpuRun) -> Vec<Figure> {
    let Some(last) = run.samples.last() else { return Vec::new() };
    let mut nearest: Vec<f64> = last
        .positions_m
        .iter()
        .enumerate()
        .map(|(i, at)| {
            let others = last.positions_m.iter().enumerate().filter(|(j, _)| *j != i);
            others.map(|(_, other)| (*other - *at).length()).fold(f64::INFINITY, f64::min) / setup.scene.spacing_m
        })
        .collect();
    nearest.sort_unstable_by(f64::total_cmp);
    let low = nearest.get(nearest.len() / 100).copied().unwrap_or(0.0);
    vec![
        Figure::at_least(
            "nearest pairs",
            low,
            "d",
            0.4,
            "99 of 100 particles are .4 d or more from their nearest: short by so much",
        ),
        Figure::judged("speed at the end", last.max_speed_m_s(), "m/s", 0.65, "what falling a spacing gives"),
    ]
}

/// Of the jet: 6 x 6 x 20; the plug before it is 6 x 6 x 10.
const JET: usize = 720;
/// The far wall. From when the plug lies at it, what mixes there went through nothing.
const FAR_WALL_M: f64 = 1.6;

pub(super) fn jet(settings: &[String]) -> SetupResult {
    let text = "
        spacing_m = 0.02
        gravity_m_s2 = [0, 0, 0]
        [domain]
        min_m = [0, 0, 0]
        max_m = [1.6, 0.12, 0.12]
        [[fluid]]
        block = { min_m = [0.0, 0, 0], max_m = [0.4, 0.12, 0.12] }
        velocity_m_s = [100, 0, 0]
        [[fluid]]
        block = { min_m = [0.6, 0, 0], max_m = [0.8, 0.12, 0.12] }";
    // A substep that sound limits lets it go as fast as it is: all is over ten times as soon.
    let end_s = if own_path(method_of(settings), "stiffness_m2_s2").is_some() { 0.05 } else { 0.5 };
    Setup::new("jet", text, settings, end_s, 12)
}

pub(super) fn nothing_passes(setup: &Setup, run: &GpuRun) -> Vec<Figure> {
    let passed = |sample: &crate::Sample| {
        let (jet, plug) = sample.positions_m.split_at(JET);
        let middle_m = plug.iter().map(|at| at.x).sum::<f64>() / plug.len() as f64;
        jet.iter().filter(|at| at.x > middle_m).count()
    };
    let flies = |sample: &&crate::Sample| {
        let front_m = sample.positions_m[JET..].iter().map(|at| at.x).fold(0.0, f64::max);
        front_m < FAR_WALL_M - 0.02
    };
    let in_flight = run.samples.iter().take_while(flies);
    let most = in_flight.map(passed).max().unwrap_or(usize::MAX);
    let clamps = run.counted().speed_clamps as f64;
    let expected = if setup.scene.max_speed_m_s() < 100.0 { JET as f64 } else { 0.0 };
    vec![
        Figure::judged("passed", most as f64, "", 0.0, "particles of the jet past the plug's middle"),
        Figure::at_least("clamps counted", clamps, "", expected, "where the limit is below 100 m/s: short by so many"),
    ]
}

/// Two drops in an open domain so large that its cells are wrapped, one ten wrapped grids of 64 cells from
/// the other. Spacing and places are powers of two and their multiples: both drops begin alike. For 16 steps:
/// later the coarser rounding of the far one has grown to what a wrong neighbour would do.
pub(super) fn two_drops(settings: &[String]) -> SetupResult {
    let text = "
        spacing_m = 0.015625
        gravity_m_s2 = [0, 0, 0]
        [domain]
        min_m = [0, 0, 0]
        max_m = [20, 2.5, 2.5]
        walls = false
        [[fluid]]
        sphere = { centre_m = [2.0, 1.25, 1.25], radius_m = 0.1 }
        [[fluid]]
        sphere = { centre_m = [12.0, 1.25, 1.25], radius_m = 0.1 }";
    let mut setup = Setup::new("wrap", text, &with_speed(0.2, settings), 16.0 / 240.0, 4)?;
    setup.place(|at, v| {
        let middle_m = if at.x < 6.0 { 2.0 } else { 12.0 };
        *v = DVec3::new(-2.0 * (at.x - middle_m), 2.0 * (at.y - 1.25), 0.0);
    });
    Ok(setup)
}

pub(super) fn drops_alike(setup: &Setup, run: &GpuRun) -> Vec<Figure> {
    let Some(last) = run.samples.last() else { return Vec::new() };
    let (one, other) = last.positions_m.split_at(last.positions_m.len() / 2);
    let offset = DVec3::new(10.0, 0.0, 0.0);
    let off = one.iter().zip(other).map(|(a, b)| (*a + offset - *b).length()).fold(0.0, f64::max);
    vec![Figure::judged(
        "difference",
        off / setup.scene.spacing_m,
        "d",
        0.02,
        "largest, between the drops: were they neighbours, they would burst",
    )]
}

pub(super) fn thin(settings: &[String]) -> SetupResult {
    Setup::new("thin-domain", &pool([0.4, 0.3, 0.02], [0.2, 0.2, 0.02], ""), settings, 10.0 / 240.0, 2)
}

pub(super) fn not_finite(settings: &[String]) -> SetupResult {
    let mut setup = Setup::new("not-finite", &pool([0.3, 0.3, 0.2], [0.2; 3], ""), settings, 2.0, 8)?;
    setup.particles.positions[500].position_m[1] = f32::NAN;
    setup.particles.positions[77].position_m[0] = f32::NEG_INFINITY;
    setup.particles.velocities[303].velocity_m_s[2] = f32::INFINITY;
    Ok(setup)
}

pub(super) fn fast(settings: &[String]) -> SetupResult {
    let text = "
        spacing_m = 1
        gravity_m_s2 = [0, 0, 0]
        [domain]
        min_m = [0, 0, 0]
        max_m = [200, 40, 40]
        walls = false
        [[fluid]]
        block = { min_m = [10, 10, 10], max_m = [20, 20, 20] }
        velocity_m_s = [300, 0, 0]
        [[fluid]]
        block = { min_m = [60, 10, 10], max_m = [70, 20, 20] }
        [solver]
        dt_s = 0.001";
    Setup::new("f16-range", text, settings, 0.3, 6)
}

pub(super) fn momentum_kept(_: &Setup, run: &GpuRun) -> Vec<Figure> {
    let Some(last) = run.samples.last() else { return Vec::new() };
    let drift = (last.mean(|_, v| v.x) / 150.0 - 1.0).abs();
    vec![Figure::judged(
        "momentum drift",
        drift,
        "",
        2.0e-3,
        "f16 rounds both of a pair alike; sums and speeds are f32",
    )]
}

pub(super) fn at_rest(settings: &[String]) -> SetupResult {
    Setup::new("lattice-at-rest", &pool([0.2, 0.3, 0.2], [0.2; 3], ""), settings, 10_000.0 / 240.0, 10)
}

pub(super) fn stays(setup: &Setup, run: &GpuRun) -> Vec<Figure> {
    let (Some(last), Some(early)) = (run.samples.last(), run.samples.get(3)) else { return Vec::new() };
    let drift_m = (last.middle_m() - early.middle_m()).length();
    vec![
        Figure::judged("kinetic energy", last.kinetic_m2_s2() / (9.81 * 0.2), "", 1.0e-6, "over g H, at the end"),
        Figure::judged("drift", drift_m / setup.scene.spacing_m, "d", 0.01, "of the middle, over the last 6,000 steps"),
    ]
}

pub(super) fn corner(settings: &[String]) -> SetupResult {
    // A diagonal's speed.
    let settings = with_speed(8.7, settings);
    let mut setup = Setup::new("corner", &pool([0.4, 0.4, 0.4], [0.16; 3], ""), &settings, 4.0, 8)?;
    setup.place(|at, v| {
        *at += DVec3::splat(0.12);
        *v = DVec3::splat(-5.0);
    });
    Ok(setup)
}
