//! What lower precision does to the density, beside VALIDATION's table: relative to the density, rms
//! and largest over a squeezed, jittered lattice at d = 2 cm, h = 2 d. (`app/fluid/PRECISION.md`.)

use brooklet_kernels::{ConstrainDensity, ConstrainDensityVariant, PbfParams, PositionLambda, PrecisionKeyword};
use brooklet_reference::measure::density::density_ratio;
use brooklet_reference::shared::quantized_position::Quantization;
use brooklet_reference::solver::pbf::constrain_density::constrain_density;
use brooklet_tests::cases::{
    Case, fluid, kernel_params, pbf_of, pbf_params, precisions, quantization_of, smoothing_of,
};
use brooklet_tests::harness::Bench;
use brooklet_tests::{rng, small};
use glam::DVec3;
use half::f16;

/// With so much constraint force mixing a denominator is hardly more than that, and lambda is no f16 that is so small
/// that it has fewer bits.
const MIXING: f32 = 1.0e3;

/// Density ratios of compressed particles as the kernel sums and stores them, from their lambdas.
fn summed(case: &Case, precision: PrecisionKeyword) -> Vec<f64> {
    let device = &brooklet_tests::device();
    let packed = quantization_of(precision) == Quantization::Packed;
    let mut bench = Bench::new(device);
    let quantized_positions = bench.input("quantized_positions", &case.quantized_positions(quantization_of(precision)));
    let (neighbours, list_heads) = case.upload_neighbours(&mut bench);
    let mut position_lambdas = bench.output::<PositionLambda>("position_lambdas", case.count());
    let mut packed_position_lambdas = bench.output::<[u32; 2]>("packed_position_lambdas", case.count());
    let step_params = bench.uniform("step_params", case.step_params());
    let kernel = bench.uniform("kernel", kernel_params());
    let params = PbfParams { cfm: MIXING, ..pbf_params() };
    let pbf = bench.uniform("pbf", params);
    let step_state = bench.uniform("step_state", case.step_state());
    bench.dispatch(
        &ConstrainDensity {
            variant: ConstrainDensityVariant { precision, ..ConstrainDensityVariant::default() },
            quantized_positions: quantized_positions.read(),
            sorted_positions: None,
            neighbours: neighbours.read(),
            list_heads: list_heads.read(),
            solid_contacts: None,
            position_lambdas: (!packed).then(|| position_lambdas.write()),
            packed_position_lambdas: packed.then(|| packed_position_lambdas.write()),
            lambda_totals: None,
            step_state: step_state.uniform(),
            step_params: step_params.uniform(),
            kernel: kernel.uniform(),
            pbf: pbf.uniform(),
            coarse_cells: None,
            coarse: None,
            iteration: None,
        },
        case.count(),
    );
    let mut done = bench.run();
    let lambdas: Vec<f64> = match packed {
        true => {
            let stored: Vec<[u32; 2]> = done.read(&packed_position_lambdas, case.count());
            stored.iter().map(|&[_, z_lambda]| f16::from_bits(z_lambda as u16).to_f64()).collect()
        }
        false => done.read(&position_lambdas, case.count()).iter().map(|c| f64::from(c.lambda)).collect(),
    };
    let (smoothing, pbf) = (smoothing_of(&kernel_params()), pbf_of(&params));
    let positions_m = case.positions_m();
    let denominator =
        |i: usize| constrain_density(i, &positions_m, &case.neighbours[i], &smoothing, &pbf, None).denominator;
    lambdas.iter().enumerate().map(|(i, lambda)| 1.0 - lambda * denominator(i)).collect()
}

/// Relative to the expected density: rms and largest.
fn errors(got: impl Iterator<Item = f64>, expected: &[f64]) -> [f64; 2] {
    let errors: Vec<f64> = got
        .zip(expected)
        .filter(|(_, expected)| **expected > 1.0)
        .map(|(got, expected)| (got / expected - 1.0).abs())
        .collect();
    assert!(errors.len() > 100, "only {} particles are compressed", errors.len());
    let mean_square = errors.iter().map(|e| e * e).sum::<f64>() / errors.len() as f64;
    [mean_square.sqrt(), errors.iter().copied().fold(0.0, f64::max)]
}

fn densities(case: &Case, positions_m: &[DVec3]) -> Vec<f64> {
    let smoothing = smoothing_of(&kernel_params());
    (0..case.count()).map(|i| density_ratio(i, positions_m, &case.neighbours[i], &smoothing, None)).collect()
}

#[test]
fn densities_lose_no_more_than_stated() {
    let device = &brooklet_tests::device();
    let case = fluid(&mut rng(71), if small() { 1000 } else { 8000 });
    let exact = densities(&case, &case.positions_m());
    for (precision, _) in precisions(device) {
        // Sums of f32: some 30 roundings. A pair in f16 is off by up to 8e-4, and the sum by the
        // random walk of 30; relaxed may be either. Lambda's f16 is off by 2.4e-4 of the compression.
        let [rms_allowed, max_allowed] = match precision {
            PrecisionKeyword::Off => [2.0e-6, 1.0e-5],
            PrecisionKeyword::RelaxedPrecision | PrecisionKeyword::HalfPrecision => [5.0e-4, 2.0e-3],
        };
        let [rms, max] = errors(summed(&case, precision).into_iter(), &exact);
        println!("density, {precision:?}: rms {rms:.1e}, max {max:.1e}");
        assert!(rms < rms_allowed && max < max_allowed, "{precision:?}: rms {rms:e}, max {max:e}");
    }
    for (quantized_positions, [rms_allowed, max_allowed]) in
        [(Quantization::Full, [1.0e-6, 1.0e-5]), (Quantization::Packed, [3.0e-5, 1.5e-4])]
    {
        // In f64, so that the rounding of quantized_positions is all.
        let [rms, max] = errors(densities(&case, &case.quantized_m(quantized_positions)).into_iter(), &exact);
        println!("density from quantized_positions of {quantized_positions:?}: rms {rms:.1e}, max {max:.1e}");
        assert!(rms < rms_allowed && max < max_allowed, "{quantized_positions:?}: rms {rms:e}, max {max:e}");
        assert!(rms > 0.0, "rounding cannot leave no trace");
    }
}
