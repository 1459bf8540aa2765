//! Ellipsoids from neighbours, against their twin. The matrix is compared, which is unique, and not
//! its eigenvectors, which are not.

use crate::bench::Bench;
use crate::cases::{Case, LIST_CHUNKS, SPACING_M, SUPPORT_M, fluid, sizes, step_state, vectors};
use crate::compare::{HALF_ROUNDING, Worst};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{Named as _, OrRaise as _, Wrong, ensure, ensure_eq};
use brooklet_kernels::{
    Anisotropy, AnisotropyParams, Ellipsoid, Kernel, LEAST_VARIANCE, ListHead, Position, QUARANTINED, SPRAY_RADIUS,
    SurfaceParams,
};
use brooklet_reference::grid::list_neighbours::list_neighbours;
use brooklet_reference::shared::list;
use brooklet_reference::surface::anisotropy::{Ellipsoid as Twin, anisotropy};
use glam::DVec3;
use rand::RngExt;

const GROUP: usize = Anisotropy::GROUP_SIZE[0] as usize;

/// Of a column's length. Its elements are kept in f16, which some devices round toward zero: twice
/// half the distance to the next. What f32 loses before is a hundredth of that.
const STRETCH_TOLERANCE: f64 = 2.02 * HALF_ROUNDING;
/// Of h. Positions within 4 h of the origin are differences of f32 (2^-22 of 4 h); the mean of some
/// 60 adds a few roundings.
const CENTER_TOLERANCE: f64 = 4e-6;

/// What the kernel is told: how far neighbours count, and where they end.
type Params = (AnisotropyParams, SurfaceParams);

/// No wall near.
fn open() -> Params {
    (
        AnisotropyParams { support_m: SUPPORT_M as f32, list_chunks: LIST_CHUNKS, ..AnisotropyParams::default() },
        SurfaceParams { wall_min_m: [-1e18; 3], wall_max_m: [1e18; 3], ..SurfaceParams::default() },
    )
}

fn run(device: &Device, case: &Case, params: Params) -> Vec<Ellipsoid> {
    run_with(device, case, params, UNLISTED)
}

/// How the list of nobody begins after a step; before the first all heads are zero.
const NOBODY: ListHead = ListHead { entries: 0, first: u32::MAX };
const UNLISTED: Option<usize> = None;

/// `unlisted` has no list yet, as before the first step.
fn run_with(device: &Device, case: &Case, (params, surface): Params, unlisted: Option<usize>) -> Vec<Ellipsoid> {
    let mut bench = Bench::new(device);
    let positions = bench.input("positions", &case.positions);
    let (lists, mut heads) = list::encoded(&case.neighbours, LIST_CHUNKS);
    for (i, head) in heads.iter_mut().enumerate().filter(|(_, head)| head.entries == 0) {
        *head = if unlisted == Some(i) { ListHead::default() } else { NOBODY };
    }
    let (neighbours, list_heads) = (bench.input("neighbours", &lists), bench.input("list_heads", &heads));
    let mut ellipsoids = bench.output("ellipsoids", case.count());
    let params = bench.uniform("anisotropy", params);
    let surface = bench.uniform("surface", surface);
    let step_state = bench.uniform("step_state", step_state(case.count(), 0.0));
    bench.dispatch(
        &Anisotropy {
            positions: positions.read(),
            neighbours: neighbours.read(),
            list_heads: list_heads.read(),
            ellipsoids: ellipsoids.write(),
            step_state: step_state.uniform(),
            anisotropy: params.uniform(),
            surface: surface.uniform(),
        },
        case.count(),
    );
    bench.run().read(&ellipsoids, case.count())
}

/// Columns of the matrix, from its six halves.
pub(super) fn stretch(ellipsoid: &Ellipsoid) -> [[f32; 3]; 3] {
    let half = |index: usize| half_value((ellipsoid.stretch[index / 2] >> (16 * (index % 2))) as u16);
    let [xx, yy, zz, xy, xz, yz] = [0, 1, 2, 3, 4, 5].map(half);
    [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
}

/// The number that 16 bits are in f16 (IEEE 754 binary16).
fn half_value(bits: u16) -> f32 {
    let sign = if bits >> 15 == 1 { -1.0 } else { 1.0 };
    let (exponent, fraction) = (i32::from(bits >> 10 & 31), f32::from(bits & 1023) / 1024.0);
    match exponent {
        0 => sign * fraction * 2f32.powi(-14),
        31 => f32::NAN,
        _ => sign * (1.0 + fraction) * 2f32.powi(exponent - 15),
    }
}

struct Compared {
    stretch: Worst,
    center: Worst,
}

impl Compared {
    fn new() -> Self {
        Self {
            stretch: Worst::new(format!("{} stretch", Anisotropy::STAGE), STRETCH_TOLERANCE),
            center: Worst::new(format!("{} center", Anisotropy::STAGE), CENTER_TOLERANCE),
        }
    }

    fn one(&mut self, got: &Ellipsoid, twin: &Twin, reach_m: f64) -> Result<(), Wrong> {
        let columns = stretch(got);
        for (axis, column) in columns.into_iter().enumerate() {
            self.stretch.check3(column, twin.stretch.col(axis), twin.stretch.col(axis).length())?;
        }
        self.center.check3(got.center_m, twin.center_m, reach_m)
    }

    /// Every ellipsoid of a fluid. Its own size widens what f32 positions can tell apart.
    fn all(&mut self, case: &Case, (params, surface): &Params, got: &[Ellipsoid]) -> Result<(), Wrong> {
        let positions_m = case.positions_m();
        let farthest_m = positions_m.iter().map(|at| at.abs().max_element()).fold(0.0, f64::max);
        for (i, got) in got.iter().enumerate() {
            if got.tag != case.positions[i].tag {
                return Err(format!("particle {i}: tag {:x}", got.tag).into());
            }
            let twin = anisotropy(i, &positions_m, &case.neighbours[i], params, surface);
            self.one(got, &twin, SUPPORT_M.max(farthest_m / 4.0))
                .map_err(|error| error.named(format_args!("particle {i}")))?;
        }
        Ok(())
    }
}

/// The case of particles at these positions, with their neighbours.
fn placed(at_m: impl IntoIterator<Item = DVec3>) -> Case {
    let positions: Vec<Position> = at_m
        .into_iter()
        .enumerate()
        .map(|(i, at)| Position { position_m: at.as_vec3().into(), tag: i as u32 })
        .collect();
    let neighbours = list_neighbours(&vectors(&positions), |_| false, SUPPORT_M);
    Case { velocities: Vec::new(), neighbours, size_m: DVec3::ONE, positions }
}

pub(crate) fn ellipsoids_are_their_twins(device: &Device) {
    let mut check = Compared::new();
    let mut rng = rng(61);
    for size in sizes(device, GROUP) {
        let case = fluid(&mut rng, size);
        let (kernel, no_walls) = open();
        let walls = SurfaceParams { wall_min_m: [0.0; 3], wall_max_m: [0.1, 0.2, 0.35], ..no_walls };
        for params in [(kernel, no_walls), (kernel, walls)] {
            let got = run(device, &case, params);
            ensure_eq!(got.len(), size);
            check.all(&case, &params, &got).or_raise();
        }
        // A support a hundredth wider is another ellipsoid.
        if size > GROUP {
            let wrong = AnisotropyParams { support_m: 1.01 * kernel.support_m, ..kernel };
            Compared::new()
                .all(&case, &open(), &run(device, &case, (wrong, no_walls)))
                .expect_err("another support must differ");
            Compared::new().all(&case, &open(), &run(device, &case, (kernel, walls))).expect_err("walls must differ");
        }
    }
    check.stretch.report(device);
    check.center.report(device);
}

pub(crate) fn bodies_without_thickness_have_finite_ellipsoids(device: &Device) {
    let mut rng = rng(62);
    let mut check = Compared::new();
    let middle = DVec3::splat(0.1);
    let mut jitter = || 0.3 * SPACING_M * (rng.random::<f64>() - 0.5);
    let (along, beside) = (DVec3::new(0.6, 0.64, 0.48), DVec3::new(0.8, -0.48, -0.36));
    let steps = |i: i32| f64::from(i - 4) * SPACING_M;
    let coplanar =
        placed((0..81).map(|i| middle + along * (steps(i % 9) + jitter()) + beside * (steps(i / 9) + jitter())));
    let collinear = placed((0..9).map(|i| middle + along * steps(i)));
    let coincident = placed((0..20).map(|_| middle));
    let nearly = placed((0..20).map(|i| middle + DVec3::X * 1e-7 * f64::from(i)));
    let cases = [("coplanar", coplanar), ("collinear", collinear), ("coincident", coincident), ("nearly", nearly)];
    for (name, case) in &cases {
        let got = run(device, case, open());
        check.all(case, &open(), &got).named(name);
    }
    let thinness = |case: &Case| {
        let at = case.count() / 2;
        let (params, surface) = open();
        let twin = anisotropy(at, &case.positions_m(), &case.neighbours[at], &params, &surface);
        let (axes, _) = brooklet_reference::surface::anisotropy::eigen(twin.stretch);
        axes.max_element() / axes.min_element()
    };
    // A sheet is as thin as allowed, particles in one point are a sphere.
    ensure!((thinness(&cases[0].1) - 4.0).abs() < 1e-6, "{}", thinness(&cases[0].1));
    ensure!((thinness(&cases[2].1) - 1.0).abs() < 1e-9 && LEAST_VARIANCE > 0.0);
    check.stretch.report(device);
    check.center.report(device);
}

pub(crate) fn a_list_that_was_never_made_is_no_spray_and_quarantined_ones_stay_so(device: &Device) {
    // 0: never listed; 1 and 2: a pair; 3: quarantined, not finite; 4: alone.
    let mut case = placed([0.0, 0.5, 0.51, 0.7, 0.9].map(DVec3::splat));
    case.positions[3] = Position { position_m: [f32::NAN, f32::INFINITY, 0.0], tag: QUARANTINED | 3 };
    let got = run_with(device, &case, open(), Some(0));
    let full = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    ensure_eq!((stretch(&got[0]), got[0].center_m), (full, [0.0; 3]));
    let (pair, alone) = (stretch(&got[1])[0][0], stretch(&got[4])[0][0]);
    ensure!((alone - SPRAY_RADIUS).abs() < 1e-3 && alone < pair && pair < 0.9, "{alone} {pair}");
    ensure_eq!(got[3].tag, QUARANTINED | 3);
    ensure_eq!(stretch(&got[3]), full, "no NaN where nobody draws");
}
