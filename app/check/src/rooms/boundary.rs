//! `boundary/`: what the kernels add for walls, against its twin. It has no kernel of its own: a lone
//! particle's density and correction show it.

use crate::bench::Bench;
use crate::cases::{SUPPORT_M, kernel_params, pbf_params, step_state, vectors, walls_of};
use crate::compare::{ROUNDING, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, ensure};
use brooklet_kernels::{
    CorrectPositions, CorrectPositionsVariant, Counters, ListHead, MeasureParticles, MeasureParticlesVariant,
    MeasureSums, PbfParams, Position, PositionLambda, StepParams, Velocity,
};
use brooklet_reference::boundary::BoundarySample;
use brooklet_reference::shared::quantized_position::Quantization;
use glam::DVec3;
use rand::RngExt;

/// Positions near every wall, edge and corner of a box, on its faces and in its middle.
fn probes(size_m: DVec3) -> Vec<Position> {
    let mut rng = rng(61);
    let mut at = Vec::new();
    for i in 0..27 {
        let pick = [i % 3, i / 3 % 3, i / 9];
        for _ in 0..8 {
            let position_m: [f64; 3] = std::array::from_fn(|axis| {
                let near = rng.random::<f64>() * SUPPORT_M;
                match pick[axis] {
                    0 => near,
                    1 => size_m[axis] - near,
                    _ => size_m[axis] * rng.random::<f64>(),
                }
            });
            at.push(position_m);
        }
    }
    at.push([0.0; 3]);
    at.push(size_m.to_array());
    at.push((size_m / 2.0).to_array());
    at.iter().enumerate().map(|(i, at_m)| Position { position_m: at_m.map(|x| x as f32), tag: i as u32 }).collect()
}

const DT_S: f32 = 0.01;

fn params(size_m: DVec3) -> StepParams {
    StepParams {
        dt_s: DT_S,
        domain_size_m: size_m.to_array().map(|x| x as f32),
        wall_offset_m: -1.0,
        wall_max_m: size_m.to_array().map(|x| x as f32),
        max_speed_m_s: 1.0,
        ..StepParams::default()
    }
}

/// Density ratios that walls add at each position: each is measured alone.
fn densities(device: &Device, positions: &[Position], size_m: DVec3) -> Vec<f64> {
    let weight = f64::from(kernel_params().weight);
    let mut bench = Bench::new(device);
    let kernel = bench.uniform("kernel", kernel_params());
    let step_params = bench.uniform("step_params", params(size_m));
    let velocities = bench.input("velocities", &[Velocity::default()]);
    let neighbours = bench.input("neighbours", &[[0_u32; 2]]);
    let list_heads = bench.input("list_heads", &[ListHead::default()]);
    let mut measures = Vec::new();
    for position in positions {
        let positions = bench.input("positions", &[*position]);
        let mut group_measures = bench.output::<MeasureSums>("group_measures", 1);
        let mut histograms = bench.output("histograms", 1024);
        let step_state = bench.uniform("step_state", step_state(1, DT_S));
        bench.dispatch(
            &MeasureParticles {
                variant: MeasureParticlesVariant { density: true, walls: true.into(), periodic: false },
                positions: positions.read(),
                velocities: velocities.read(),
                neighbours: Some(neighbours.read()),
                list_heads: Some(list_heads.read()),
                solid_contacts: None,
                group_measures: group_measures.write(),
                histograms: Some(histograms.write()),
                step_state: step_state.uniform(),
                step_params: step_params.uniform(),
                kernel: Some(kernel.uniform()),
            },
            1,
        );
        measures.push(group_measures);
    }
    let mut done = bench.run();
    measures
        .iter()
        .map(|buffer| {
            let sums = done.read(buffer, 1)[0];
            // |ratio - 1| and its positive part give the ratio back.
            let error = match sums.compression_sum {
                0.0 => -sums.density_error_sum,
                compression => compression,
            };
            f64::from(error) + 1.0 - weight
        })
        .collect()
}

/// Gradients of the density that walls add, from corrections with lambda = -1/4 and factors of 1: the correction
/// is then half the negative gradient times h, below the h that a substep may move a particle by.
fn gradients(device: &Device, positions: &[Position], size_m: DVec3) -> Vec<DVec3> {
    let count = positions.len();
    let pbf = PbfParams { relaxation: 1.0, max_correction_m: 1e3, ..pbf_params() };
    let inverse_support_per_m = kernel_params().inverse_support_per_m;
    let start: Vec<[u32; 2]> = positions
        .iter()
        .map(|p| Quantization::Full.quantize(p.position_m.map(|x| x * inverse_support_per_m)))
        .collect();
    let position_lambdas: Vec<PositionLambda> = start
        .iter()
        .map(|&quantized_position| PositionLambda { quantized_position, lambda: -0.25, total: 0.0 })
        .collect();
    let mut bench = Bench::new(device);
    let input = bench.input("position_lambdas", &position_lambdas);
    let positions = bench.input("sorted_positions", positions);
    let neighbours = bench.input("neighbours", &vec![[0_u32; 2]; count]);
    let list_heads = bench.input("list_heads", &vec![ListHead::default(); count]);
    let mut after = bench.output::<[u32; 2]>("quantized_positions", count);
    let mut counters = bench.input("counters", &[Counters::default()]);
    let step_params = bench.uniform("step_params", params(size_m));
    let kernel = bench.uniform("kernel", kernel_params());
    let pbf = bench.uniform("pbf", pbf);
    let step_state = bench.uniform("step_state", step_state(count, DT_S));
    bench.dispatch(
        &CorrectPositions {
            variant: CorrectPositionsVariant { walls: true.into(), ..CorrectPositionsVariant::default() },
            position_lambdas: Some(input.read()),
            packed_position_lambdas: None,
            sorted_positions: positions.read(),
            neighbours: neighbours.read(),
            list_heads: list_heads.read(),
            solid_contacts: None,
            quantized_positions: after.write(),
            counters: counters.write(),
            step_state: step_state.uniform(),
            step_params: step_params.uniform(),
            kernel: kernel.uniform(),
            pbf: pbf.uniform(),
            solids_params: None,
        },
        count,
    );
    let after = bench.run().read(&after, count);
    start.iter().zip(after).map(|(&before, after)| 2.0 * Quantization::Full.offset(before, after)).collect()
}

fn check(device: &Device, size_m: DVec3, names: [&'static str; 2]) -> Vec<(BoundarySample, f64)> {
    // A density is at most 3 sums of some 20 roundings each, and its slope over a distance, which is
    // rounded too, is at most 2. A gradient is read from a move of a quantized position, which rounds to half a
    // step of 1.9e-6 h along each axis, and that is half of it: 56 roundings more.
    let mut density = device.worst(names[0], 64.0 * ROUNDING);
    let mut gradient = device.worst(names[1], 128.0 * ROUNDING);
    let positions = probes(size_m);
    let walls = walls_of(&kernel_params(), vector(params(size_m).domain_size_m));
    let got_densities = densities(device, &positions, size_m);
    let samples: Vec<BoundarySample> = vectors(&positions).into_iter().map(|at| walls.sample(at)).collect();
    for (got, expected) in got_densities.iter().zip(&samples) {
        density.check(*got as f32, expected.density, 1.0).or_raise();
    }
    let got_gradients = gradients(device, &positions, size_m);
    let mut results = Vec::new();
    for (i, expected) in samples.into_iter().enumerate() {
        gradient.check3(got_gradients[i].to_array().map(|g| g as f32), expected.gradient, 1.0).or_raise();
        results.push((expected, got_densities[i]));
    }
    density.report(device);
    gradient.report(device);
    results
}

pub(crate) fn walls_match_their_twin(device: &Device) {
    let wide = check(device, DVec3::new(0.3, 0.2, 0.5), ["measure_particles, walls", "correct_positions, walls"]);
    ensure!(wide.iter().any(|(walls, _)| walls.density > 0.5), "no position was in a corner");
    ensure!(wide.iter().any(|(walls, _)| walls.density == 0.0), "no position was far from walls");
}

pub(crate) fn narrow_walls_match_their_twin(device: &Device) {
    let size_m = DVec3::new(1.2 * SUPPORT_M, 0.3, 1.7 * SUPPORT_M);
    check(device, size_m, ["measure_particles, narrow walls", "correct_positions, narrow walls"]);
}

#[cfg(test)]
mod tests {
    use brooklet_fluid::{boundary, smoothing_kernel};
    use brooklet_reference::boundary::walls::{WallScales, beyond_wall};
    use brooklet_reference::shared::lattice;

    #[test]
    fn walls_count_as_their_twin_says() {
        for (dimensions, support_ratio) in [2, 3].into_iter().flat_map(|n| [2.0, 2.5, 3.0].map(|ratio| (n, ratio))) {
            let host = boundary::WallScales::new(dimensions, support_ratio);
            let twin = WallScales::new(dimensions, support_ratio);
            let scales = [(host.plane, twin.plane), (host.edge, twin.edge), (host.corner, twin.corner)];
            // Two dimensions have no corners.
            for (host, twin) in &scales[..dimensions as usize] {
                assert!((host / twin - 1.0).abs() < 1e-12, "{dimensions}-D, h = {support_ratio} d: {host} {twin}");
            }
            let sums = smoothing_kernel::lattice(dimensions, support_ratio);
            assert!((sums.weight / lattice::weight(dimensions, support_ratio) - 1.0).abs() < 1e-12);
            for i in 0..=10 {
                let distance = f64::from(i) / 10.0;
                let (host, twin) = (boundary::beyond_wall(dimensions, distance), beyond_wall(dimensions, distance));
                assert!((host - twin).abs() < 1e-15, "{dimensions}-D, at {distance}: {host} {twin}");
            }
        }
    }
}
