//! What the kernels of iterations and measures make of a particle's contact with solids, against its twin.

use crate::bench::Bench;
use crate::cases::{Case, SUPPORT_M, kernel_params, pbf_params, sizes, step_state, walls_of};
use crate::compare::{ROUNDING, Worst, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, ensure};
use brooklet_kernels::{
    ConstrainDensity, ConstrainDensityVariant, CorrectPositions, CorrectPositionsVariant, Counters, DensityRatios,
    DensityRatiosVariant, Kernel as _, MeasureParticles, MeasureParticlesVariant, MeasureSums, NO_BODY, PbfParams,
    Position, PositionLambda, SmoothingKernelParams, SolidContact, SolidsParams, StepParams, Velocity, WallsKeyword,
};
use brooklet_reference::boundary::mirror::{Mirrors, SolidMirror};
use brooklet_reference::boundary::solids::contact::{SolidSample, sample_solids_near};
use brooklet_reference::boundary::solids::shapes::BeyondPlane;
use brooklet_reference::shared::quantized_position::Quantization;
use brooklet_reference::shared::wendland;
use glam::DVec3;
use rand::{Rng, RngExt};

const STOP_M: f64 = 0.25 * SUPPORT_M;
const RELAXATION: f64 = 0.6;

/// As heavy a kernel as makes lone particles compressed.
fn kernel() -> SmoothingKernelParams {
    SmoothingKernelParams { weight: 0.9, ..kernel_params() }
}

/// Pairs of particles, far from all others, with a contact each; some are near walls.
pub(super) struct Pairs {
    pub(super) case: Case,
    pub(super) contacts: Vec<SolidContact>,
}

fn direction(rng: &mut impl Rng) -> DVec3 {
    let mut one = || rng.random::<f64>() * 2.0 - 1.0;
    DVec3::new(one(), one(), one() + 1.5).normalize()
}

pub(super) fn pairs(rng: &mut impl Rng, count: usize) -> Pairs {
    let apart_m = 3.0 * SUPPORT_M;
    let mut positions = Vec::new();
    for i in 0..count {
        let cell = DVec3::new((i / 2 % 8) as f64, (i / 16 % 8) as f64, (i / 128) as f64);
        let middle_m = apart_m * (cell + 0.1);
        let beside_m = if i % 2 == 0 { DVec3::ZERO } else { 0.5 * SUPPORT_M * direction(rng) };
        positions.push(Position { position_m: (middle_m + beside_m).as_vec3().to_array(), tag: i as u32 });
    }
    let contacts = positions
        .iter()
        .map(|position| {
            let [normal, stop_normal] = [direction(rng), direction(rng)];
            let away_m = SUPPORT_M * (1.4 * rng.random::<f64>() - 0.2);
            let stop_away_m = STOP_M * (0.9 + 0.6 * rng.random::<f64>());
            let at_m = vector(position.position_m);
            SolidContact {
                normal: normal.as_vec3().to_array(),
                offset_m: (normal.dot(at_m) - away_m) as f32,
                stop_normal: stop_normal.as_vec3().to_array(),
                stop_offset_m: (stop_normal.dot(at_m) - stop_away_m) as f32,
                // A third of them is no body.
                body: if rng.random_range(0..3) == 0 { NO_BODY } else { 1 },
                ..SolidContact::default()
            }
        })
        .collect();
    let neighbours = (0..count).map(|i| if (i ^ 1) < count { vec![i ^ 1] } else { Vec::new() }).collect();
    let velocities = vec![Velocity::default(); count];
    Pairs { case: Case { positions, velocities, neighbours, size_m: DVec3::new(8.0, 8.0, 17.0) * apart_m }, contacts }
}

/// What a contact's half-space is to a particle at a place.
pub(super) fn plane_sample(contact: &SolidContact, at_m: DVec3, kernel: &SmoothingKernelParams) -> SolidSample {
    let (plane, wall_plane) = (BeyondPlane::of(kernel), f64::from(kernel.wall_plane));
    sample_solids_near(vector(contact.normal), contact.offset_m.into(), at_m, SUPPORT_M, &plane, wall_plane)
}

impl Pairs {
    pub(super) fn step(&self) -> StepParams {
        StepParams { wall_offset_m: -1.0, ..self.case.step_params() }
    }

    fn sample(&self, i: usize, at_m: DVec3) -> SolidSample {
        plane_sample(&self.contacts[i], at_m, &kernel())
    }

    /// The density ratio of a particle that sees itself and its neighbours in walls and solids.
    fn mirrored_density(&self, i: usize, places_m: &[DVec3]) -> f64 {
        let contact = &self.contacts[i];
        let normal = vector(contact.normal);
        let distance = (normal.dot(places_m[i]) - f64::from(contact.offset_m)) / SUPPORT_M;
        let walls = Mirrors::at(places_m[i], Some(&walls_of(&kernel(), self.case.size_m)));
        let mirrors = Mirrors { solids: Some(SolidMirror { normal, distance, speed_m_s: 0.0 }), ..walls };
        let seen = std::iter::once(i).chain(self.case.neighbours[i].iter().copied());
        let offsets = seen.map(|j| (places_m[i] - places_m[j]) / SUPPORT_M);
        let of = |offset| mirrors.images().map(move |image| wendland::kernel(mirrors.offset(offset, image).length()));
        f64::from(kernel().weight) * offsets.flat_map(of).sum::<f64>()
    }

    /// Density ratio and boundary gradient of a particle at its place.
    fn density(&self, i: usize, places_m: &[DVec3]) -> (f64, DVec3) {
        let walls = walls_of(&kernel(), self.case.size_m).sample(places_m[i]);
        let (density, gradient) = self.sample(i, places_m[i]).with_walls(&walls);
        let near =
            self.case.neighbours[i].iter().map(|&j| wendland::kernel((places_m[i] - places_m[j]).length() / SUPPORT_M));
        (density + f64::from(kernel().weight) * (1.0 + near.sum::<f64>()), gradient)
    }
}

/// Distances are differences of places up to a metre, over h: 25 times some 8 roundings, of shares with a slope of 2.5 and of
/// gradients with one of 10. Both are around 1.
const TOLERANCE: f64 = 4096.0 * ROUNDING;

pub(crate) fn densities_near_solids_match_their_twin(device: &Device) {
    let mut rng = rng(194);
    let mut worst = device.worst(DensityRatios::STAGE, TOLERANCE);
    let mut measured = device.worst(MeasureParticles::STAGE, TOLERANCE);
    let group = DensityRatios::GROUP_SIZE[0] as usize;
    for (mirrors, size) in
        [0, 1].into_iter().flat_map(|mirrors| sizes(device, group).into_iter().map(move |n| (mirrors, n)))
    {
        let pairs = pairs(&mut rng, size);
        let mut bench = Bench::new(device);
        let positions = bench.input("positions", &pairs.case.positions);
        let velocities = bench.input("velocities", &pairs.case.velocities);
        let (neighbours, list_heads) = pairs.case.upload_neighbours(&mut bench);
        let contacts = bench.input("solid_contacts", &pairs.contacts);
        let mut ratios = bench.output::<f32>("density_ratios", size);
        let groups = size.div_ceil(MeasureParticles::GROUP_SIZE[0] as usize);
        let mut sums = bench.output::<MeasureSums>("group_measures", groups);
        let mut histograms = bench.output::<u32>("histograms", 1024);
        let state = bench.uniform("step_state", step_state(size, 0.01));
        let step_params = bench.uniform("step_params", StepParams { mirrors, ..pairs.step() });
        let kernel = bench.uniform("kernel", kernel());
        bench.dispatch(
            &DensityRatios {
                variant: DensityRatiosVariant { walls: WallsKeyword::SolidWalls, periodic: false },
                positions: positions.read(),
                neighbours: neighbours.read(),
                list_heads: list_heads.read(),
                solid_contacts: Some(contacts.read()),
                density_ratios: ratios.write(),
                step_state: state.uniform(),
                step_params: step_params.uniform(),
                kernel: kernel.uniform(),
            },
            size,
        );
        bench.dispatch(
            &MeasureParticles {
                variant: MeasureParticlesVariant { density: true, walls: WallsKeyword::SolidWalls, periodic: false },
                positions: positions.read(),
                velocities: velocities.read(),
                neighbours: Some(neighbours.read()),
                list_heads: Some(list_heads.read()),
                solid_contacts: Some(contacts.read()),
                group_measures: sums.write(),
                histograms: Some(histograms.write()),
                step_state: state.uniform(),
                step_params: step_params.uniform(),
                kernel: Some(kernel.uniform()),
            },
            size,
        );
        let mut done = bench.run();
        let places_m = pairs.case.positions_m();
        let got = done.read(&ratios, size);
        let density =
            |i| if mirrors == 1 { pairs.mirrored_density(i, &places_m) } else { pairs.density(i, &places_m).0 };
        let expected: Vec<f64> = (0..size).map(density).collect();
        let mut refused = size < 2;
        // One without neighbours counts as not listed yet.
        let listed = got.iter().zip(&expected).zip(&pairs.case.neighbours).filter(|(_, near)| !near.is_empty());
        for ((got, expected), _) in listed {
            worst.check(*got, *expected, 1.0).or_raise();
            refused |= Worst::new(DensityRatios::STAGE, TOLERANCE).check(*got, 1.001 * expected, 1.0).is_err();
        }
        ensure!(refused, "a density a thousandth larger");
        let error: f64 = expected.iter().map(|ratio| (ratio - 1.0).abs()).sum();
        let got: f64 = done.read(&sums, groups).iter().map(|sums| f64::from(sums.density_error_sum)).sum();
        measured.check(got as f32, error, size.max(1) as f64).or_raise();
    }
    worst.report(device);
    measured.report(device);
}

pub(crate) fn constraints_near_solids_match_their_twin(device: &Device) {
    let mut rng = rng(195);
    let mut worst = device.worst(ConstrainDensity::STAGE, TOLERANCE);
    let pbf = PbfParams { cfm: 1.0, ..pbf_params() };
    for size in sizes(device, ConstrainDensity::GROUP_SIZE[0] as usize) {
        let pairs = pairs(&mut rng, size);
        let mut bench = Bench::new(device);
        let quantized = bench.input("quantized_positions", &pairs.case.quantized_positions(Quantization::Full));
        let sorted = bench.input("sorted_positions", &pairs.case.positions);
        let (neighbours, list_heads) = pairs.case.upload_neighbours(&mut bench);
        let contacts = bench.input("solid_contacts", &pairs.contacts);
        let mut lambdas = bench.output::<PositionLambda>("position_lambdas", size);
        let state = bench.uniform("step_state", step_state(size, 0.01));
        let step_params = bench.uniform("step_params", pairs.step());
        let kernel_buffer = bench.uniform("kernel", kernel());
        let pbf_buffer = bench.uniform("pbf", pbf);
        bench.dispatch(
            &ConstrainDensity {
                variant: ConstrainDensityVariant {
                    walls: WallsKeyword::SolidWalls,
                    ..ConstrainDensityVariant::default()
                },
                quantized_positions: quantized.read(),
                sorted_positions: Some(sorted.read()),
                neighbours: neighbours.read(),
                list_heads: list_heads.read(),
                solid_contacts: Some(contacts.read()),
                position_lambdas: Some(lambdas.write()),
                packed_position_lambdas: None,
                lambda_totals: None,
                step_state: state.uniform(),
                step_params: step_params.uniform(),
                kernel: kernel_buffer.uniform(),
                pbf: pbf_buffer.uniform(),
                coarse_cells: None,
                coarse: None,
                iteration: None,
            },
            size,
        );
        let got = bench.run().read(&lambdas, size);
        let places_m = pairs.case.quantized_m(Quantization::Full);
        let mut refused = size == 0;
        for (i, got) in got.iter().enumerate() {
            let (density, mut own) = pairs.density(i, &places_m);
            let mut denominator = f64::from(pbf.cfm);
            for &j in &pairs.case.neighbours[i] {
                let gradient = wendland::gradient((places_m[i] - places_m[j]) / SUPPORT_M) * f64::from(kernel().weight);
                own += gradient;
                denominator += gradient.length_squared();
            }
            let lambda = -(density - 1.0).max(0.0) / (denominator + own.length_squared());
            worst.check(got.lambda, lambda, 1.0).or_raise();
            refused |= Worst::new(ConstrainDensity::STAGE, TOLERANCE).check(got.lambda, 1.01 * lambda, 1.0).is_err();
        }
        ensure!(refused, "a lambda a hundredth larger");
    }
    worst.report(device);
}

pub(crate) fn corrections_near_solids_match_their_twin(device: &Device) {
    let mut rng = rng(196);
    let mut worst = device.worst(CorrectPositions::STAGE, TOLERANCE);
    let params = PbfParams {
        relaxation: RELAXATION as f32,
        s_corr_k: 0.0,
        separation: 0.0,
        max_correction_m: 1e3,
        ..pbf_params()
    };
    let (mut stopped, mut refused, mut given_back, mut all) = (0, 0, 0, 0);
    for size in sizes(device, CorrectPositions::GROUP_SIZE[0] as usize) {
        let pairs = pairs(&mut rng, size);
        let start = pairs.case.quantized_positions(Quantization::Full);
        let lambdas: Vec<f32> = (0..size).map(|_| -0.05 * rng.random::<f32>()).collect();
        let position_lambdas: Vec<PositionLambda> = start
            .iter()
            .zip(&lambdas)
            .map(|(&quantized_position, &lambda)| PositionLambda { quantized_position, lambda, total: 0.0 })
            .collect();
        let mut bench = Bench::new(device);
        let input = bench.input("position_lambdas", &position_lambdas);
        let sorted = bench.input("sorted_positions", &pairs.case.positions);
        let (neighbours, list_heads) = pairs.case.upload_neighbours(&mut bench);
        let mut contacts = bench.input("solid_contacts", &pairs.contacts);
        let mut after = bench.output::<[u32; 2]>("quantized_positions", size);
        let mut counters = bench.input("counters", &[Counters::default()]);
        let state = bench.uniform("step_state", step_state(size, 0.01));
        let step_params = bench.uniform("step_params", pairs.step());
        let kernel_buffer = bench.uniform("kernel", kernel());
        let pbf = bench.uniform("pbf", params);
        let solids_params = bench.uniform(
            "solids_params",
            SolidsParams { stop_m: STOP_M as f32, units_per_m_s: 1.0, ..SolidsParams::default() },
        );
        bench.dispatch(
            &CorrectPositions {
                variant: CorrectPositionsVariant {
                    walls: WallsKeyword::SolidWalls,
                    ..CorrectPositionsVariant::default()
                },
                position_lambdas: Some(input.read()),
                packed_position_lambdas: None,
                sorted_positions: sorted.read(),
                neighbours: neighbours.read(),
                list_heads: list_heads.read(),
                solid_contacts: Some(contacts.write()),
                quantized_positions: after.write(),
                counters: counters.write(),
                step_state: state.uniform(),
                step_params: step_params.uniform(),
                kernel: kernel_buffer.uniform(),
                pbf: pbf.uniform(),
                solids_params: Some(solids_params.uniform()),
            },
            size,
        );
        let mut done = bench.run();
        let (got, taken) = (done.read(&after, size), done.read(&contacts, size));
        let places_m = pairs.case.quantized_m(Quantization::Full);
        for i in 0..size {
            let at_m = places_m[i];
            let lambda = f64::from(lambdas[i]);
            let solids = pairs.sample(i, at_m);
            let walls = walls_of(&kernel(), pairs.case.size_m).sample(at_m);
            let (_, gradient) = solids.with_walls(&walls);
            let left = (1.0 - walls.density).clamp(0.0, 1.0);
            let own: DVec3 = pairs.case.neighbours[i]
                .iter()
                .map(|&j| {
                    let slope = wendland::gradient((at_m - places_m[j]) / SUPPORT_M) * f64::from(kernel().weight);
                    slope * (lambda + f64::from(lambdas[j]))
                })
                .sum();
            let correction = RELAXATION * (solids.along(own * walls.correction_scale) + 2.0 * lambda * gradient);
            let fluids = own * walls.correction_scale;
            let of_solids = solids.along(fluids) - fluids + 2.0 * lambda * solids.gradient * left;
            let mut given_m = RELAXATION * of_solids * SUPPORT_M;
            let mut expected_m = at_m + correction * SUPPORT_M;
            let contact = &pairs.contacts[i];
            let stop = vector(contact.stop_normal);
            let gap_m = stop.dot(expected_m) - f64::from(contact.stop_offset_m) - STOP_M;
            expected_m -= stop * gap_m.min(0.0);
            given_m -= stop * gap_m.min(0.0);
            let given_m_s = if contact.body == NO_BODY { DVec3::ZERO } else { given_m / 0.01 };
            worst.check3(taken[i].taken_m_s, given_m_s, SUPPORT_M / 0.01).or_raise();
            let mut other = Worst::new(CorrectPositions::STAGE, TOLERANCE);
            given_back += usize::from(other.check3(taken[i].taken_m_s, 1.01 * given_m_s, SUPPORT_M / 0.01).is_err());
            stopped += usize::from(gap_m < 0.0);
            let got_m = Quantization::Full.near(got[i], at_m / SUPPORT_M) * SUPPORT_M;
            let moved = |position_m: DVec3| (position_m - at_m) / SUPPORT_M;
            worst.check3(moved(got_m).as_vec3().to_array(), moved(expected_m), 1.0).or_raise();
            let mut wrong = Worst::new(CorrectPositions::STAGE, TOLERANCE);
            refused +=
                usize::from(wrong.check3(moved(got_m).as_vec3().to_array(), 1.01 * moved(expected_m), 1.0).is_err());
            all += 1;
        }
    }
    ensure!(10 * stopped > all && 3 * refused > all, "{stopped} of {all} stopped, {refused} told apart");
    ensure!(6 * given_back > all, "{given_back} of {all} would tell a hundredth more given back apart");
    worst.report(device);
}
