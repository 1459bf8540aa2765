//! The stages of `forces/` that work on velocities alone, against their twins: viscosity, curl,
//! vorticity confinement. Tolerances are those of sums over pairs (`tolerance_of_pairs`).

use crate::bench::Bench;
use crate::cases::{
    fluid, force_params, forces_of, kernel_params, precisions, quantization_of, sizes, smoothing_of, step_of,
    step_state,
};
use crate::compare::{tolerance_of_pairs, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::OrRaise as _;
use brooklet_kernels::{
    ConfineVorticity, ConfineVorticityVariant, Curl, CurlVariant, Kernel, PrecisionKeyword, Vorticity, Xsph,
    XsphVariant,
};
use brooklet_reference::forces::confine_vorticity::confine_vorticity;
use brooklet_reference::forces::curl::curl;
use brooklet_reference::forces::xsph::xsph;
use brooklet_reference::shared::quantized_position::Quantization;
use brooklet_reference::shared::wendland;
use rand::RngExt;

/// Roundings of f16 that a viscous velocity may be off by: .33 are measured.
const XSPH_HALF: f64 = 1.0;
/// And a curl: 3.3.
const CURL_HALF: f64 = 12.0;
/// And a confined velocity: .23.
const CONFINE_HALF: f64 = 0.75;

/// Every variant: its precision, how large its roundings are, and its quantized_positions.
fn variants(device: &Device) -> Vec<(PrecisionKeyword, f64, Quantization)> {
    precisions(device)
        .into_iter()
        .map(|(precision, rounding)| (precision, rounding, quantization_of(precision)))
        .collect()
}

fn name(kernel: &str, precision: PrecisionKeyword) -> String {
    format!("{kernel} {precision:?}")
}

pub(crate) fn xsph_matches_its_twin(device: &Device) {
    for (precision, rounding, quantization) in variants(device) {
        let mut worst = device.worst(name(Xsph::STAGE, precision), tolerance_of_pairs(rounding, XSPH_HALF));
        let mut rng = rng(41);
        let (smoothing, forces) = (smoothing_of(&kernel_params()), forces_of(&force_params()));
        for size in sizes(device, Xsph::GROUP_SIZE[0] as usize) {
            let case = fluid(&mut rng, size);
            let mut bench = Bench::new(device);
            let quantized_buffer = bench.input("quantized_positions", &case.quantized_positions(quantization));
            let velocities = bench.input("velocities", &case.velocities);
            let (neighbours, list_heads) = case.upload_neighbours(&mut bench);
            let mut smoothed = bench.output("smoothed_velocities", size);
            let step_params = bench.uniform("step_params", case.step_params());
            let kernel = bench.uniform("kernel", kernel_params());
            let force_buffer = bench.uniform("forces", force_params());
            let step_state = bench.uniform("step_state", step_state(size, case.step_params().dt_s));
            bench.dispatch(
                &Xsph {
                    variant: XsphVariant { precision },
                    quantized_positions: quantized_buffer.read(),
                    velocities: velocities.read(),
                    neighbours: neighbours.read(),
                    list_heads: list_heads.read(),
                    smoothed_velocities: smoothed.write(),
                    step_state: step_state.uniform(),
                    step_params: step_params.uniform(),
                    kernel: kernel.uniform(),
                    forces: force_buffer.uniform(),
                },
                size,
            );
            let got = bench.run().read(&smoothed, size);
            let (positions_m, velocities_m_s) = (case.quantized_m(quantization), case.velocities_m_s());
            for (i, got) in got.iter().enumerate() {
                let expected = xsph(i, &positions_m, &velocities_m_s, &case.neighbours[i], &smoothing, &forces);
                // No speed is above 2 sqrt(3) m/s.
                worst.check3(got.velocity_m_s, expected, 3.5).or_raise();
            }
        }
        worst.report(device);
    }
}

pub(crate) fn curl_matches_its_twin(device: &Device) {
    for (precision, rounding, quantization) in variants(device) {
        let mut worst = device.worst(name(Curl::STAGE, precision), tolerance_of_pairs(rounding, CURL_HALF));
        let mut rng = rng(42);
        let smoothing = smoothing_of(&kernel_params());
        for size in sizes(device, Curl::GROUP_SIZE[0] as usize) {
            let case = fluid(&mut rng, size);
            let mut bench = Bench::new(device);
            let quantized_buffer = bench.input("quantized_positions", &case.quantized_positions(quantization));
            let velocities = bench.input("velocities", &case.velocities);
            let (neighbours, list_heads) = case.upload_neighbours(&mut bench);
            let mut vorticities = bench.output("vorticities", size);
            let step_params = bench.uniform("step_params", case.step_params());
            let kernel = bench.uniform("kernel", kernel_params());
            let step_state = bench.uniform("step_state", step_state(size, case.step_params().dt_s));
            bench.dispatch(
                &Curl {
                    variant: CurlVariant { precision },
                    quantized_positions: quantized_buffer.read(),
                    velocities: velocities.read(),
                    neighbours: neighbours.read(),
                    list_heads: list_heads.read(),
                    vorticities: vorticities.write(),
                    step_state: step_state.uniform(),
                    step_params: step_params.uniform(),
                    kernel: kernel.uniform(),
                },
                size,
            );
            let got = bench.run().read(&vorticities, size);
            let (positions_m, velocities_m_s) = (case.quantized_m(quantization), case.velocities_m_s());
            for (i, got) in got.iter().enumerate() {
                let expected = curl(i, &positions_m, &velocities_m_s, &case.neighbours[i], &smoothing);
                let terms: f64 = case.neighbours[i]
                    .iter()
                    .map(|&j| {
                        let offset = (positions_m[j] - positions_m[i]) / smoothing.support_m;
                        let slope = wendland::slope(offset.length()) * smoothing.weight / smoothing.support_m;
                        (velocities_m_s[j] - velocities_m_s[i]).length() * slope.abs()
                    })
                    .sum();
                // Without neighbours both are zero, whatever they are relative to.
                let scale = terms.max(1e-3);
                worst.check3(got.vorticity_per_s, expected, scale).or_raise();
                worst.check(got.magnitude_per_s, expected.length(), scale).or_raise();
            }
        }
        worst.report(device);
    }
}

pub(crate) fn confine_vorticity_matches_its_twin(device: &Device) {
    for (precision, rounding, quantization) in variants(device) {
        let mut worst =
            device.worst(name(ConfineVorticity::STAGE, precision), tolerance_of_pairs(rounding, CONFINE_HALF));
        let mut rng = rng(43);
        let (smoothing, forces) = (smoothing_of(&kernel_params()), forces_of(&force_params()));
        for size in sizes(device, ConfineVorticity::GROUP_SIZE[0] as usize) {
            let case = fluid(&mut rng, size);
            let vorticities_per_s: Vec<Vorticity> = (0..size)
                .map(|_| {
                    let curl = [0; 3].map(|_| rng.random::<f32>() * 200.0 - 100.0);
                    Vorticity { vorticity_per_s: curl, magnitude_per_s: vector(curl).length() as f32 }
                })
                .collect();
            let mut bench = Bench::new(device);
            let quantized_buffer = bench.input("quantized_positions", &case.quantized_positions(quantization));
            let vorticities = bench.input("vorticities", &vorticities_per_s);
            let (neighbours, list_heads) = case.upload_neighbours(&mut bench);
            let mut velocities = bench.input("velocities", &case.velocities);
            let step_params = bench.uniform("step_params", case.step_params());
            let force_buffer = bench.uniform("forces", force_params());
            let step_state = bench.uniform("step_state", step_state(size, case.step_params().dt_s));
            bench.dispatch(
                &ConfineVorticity {
                    variant: ConfineVorticityVariant { precision },
                    quantized_positions: quantized_buffer.read(),
                    vorticities: vorticities.read(),
                    neighbours: neighbours.read(),
                    list_heads: list_heads.read(),
                    velocities: velocities.write(),
                    step_state: step_state.uniform(),
                    step_params: step_params.uniform(),
                    forces: force_buffer.uniform(),
                },
                size,
            );
            let got = bench.run().read(&velocities, size);
            let (positions_m, velocities_m_s) = (case.quantized_m(quantization), case.velocities_m_s());
            let vorticities_per_s: Vec<_> = vorticities_per_s.iter().map(|s| vector(s.vorticity_per_s)).collect();
            let step = step_of(&case.step_params(), false);
            for (i, got) in got.iter().enumerate() {
                let expected = confine_vorticity(
                    i,
                    &positions_m,
                    velocities_m_s[i],
                    &vorticities_per_s,
                    &case.neighbours[i],
                    &step,
                    &smoothing,
                    &forces,
                );
                // The push is along a direction, known as well as its terms are to their sum.
                let push = forces.vorticity_m_s * vorticities_per_s[i].length() * step.dt_s;
                let doubt = match expected.steepness_per_s {
                    0.0 => 1.0,
                    steepness => 1.0 + (expected.terms_per_s + vorticities_per_s[i].length()) / steepness,
                };
                worst
                    .check3(got.velocity_m_s, expected.velocity_m_s, velocities_m_s[i].length() + push * doubt)
                    .or_raise();
            }
        }
        worst.report(device);
    }
}
