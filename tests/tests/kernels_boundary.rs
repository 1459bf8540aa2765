//! `boundary/`: the walls' table against an independent integration, and what the kernels read from
//! it against the table's twin. It has no kernel of its own: a lone particle's density and
//! correction show it.

use brooklet_fluid::boundary::{WALL_NODES, wall_weights};
use brooklet_kernels::{
    Constrained, CorrectPositions, CorrectPositionsVariant, Counters, MeasureParticles, MeasureParticlesVariant,
    MeasureSums, PbfParams, Position, StepParams, Velocity, WallsKeyword,
};
use brooklet_reference::boundary::walls::{DomainWalls, WallDensity, Walls};
use brooklet_reference::shared::place::Places;
use brooklet_tests::cases::{SUPPORT_M, SUPPORT_RATIO, kernel_params, pbf_params, vectors, wall_table};
use brooklet_tests::compare::{ROUNDING, Worst, vector};
use brooklet_tests::harness::Bench;
use brooklet_tests::rng;
use glam::DVec3;
use rand::RngExt;

/// Nodes to compare: every one on the axes and diagonals, and a coarse net between.
fn probes() -> Vec<[usize; 3]> {
    let last = WALL_NODES - 1;
    let mut probes = Vec::new();
    for k in 0..WALL_NODES {
        probes.extend([[k, last, last], [last, k, last], [last, last, k], [k, k, last], [k, k, k], [0, k, 3]]);
    }
    for z in (0..WALL_NODES).step_by(6) {
        for y in (0..WALL_NODES).step_by(5) {
            probes.extend((0..WALL_NODES).step_by(7).map(|x| [x, y, z]));
        }
    }
    probes
}

#[test]
fn table_matches_an_independent_integration() {
    // The table is integrated by the midpoint rule with steps of h/124: errors of the order of
    // (1/124)^2 = 6.5e-5 of the kernel's curvature, and its scale is taken where the shader
    // interpolates.
    for support_ratio in [2.0, 2.5, 3.0] {
        let mut density = Worst::new("wall_weights table, density", 2e-3);
        let mut gradient = Worst::new("wall_weights table, gradient", 1e-2);
        let walls = Walls::new(support_ratio);
        let table = wall_weights(support_ratio);
        assert_eq!(table.len(), WALL_NODES.pow(3));
        for [x, y, z] in probes() {
            let at = DVec3::new(x as f64, y as f64, z as f64) / (WALL_NODES - 1) as f64;
            let [gx, gy, gz, value] = table[(z * WALL_NODES + y) * WALL_NODES + x];
            density.check(value, walls.density(at), 1.0).unwrap();
            gradient.check3([gx, gy, gz], walls.gradient(at), 1.0).unwrap();
        }
        density.report();
        gradient.report();
    }
}

/// Positions near every wall, edge and corner of a box, on its faces and in its middle.
fn places(size_m: DVec3) -> Vec<Position> {
    let mut rng = rng(61);
    let mut at = Vec::new();
    for i in 0..27 {
        let pick = [i % 3, i / 3 % 3, i / 9];
        for _ in 0..8 {
            let place: [f64; 3] = std::array::from_fn(|axis| {
                let near = rng.random::<f64>() * SUPPORT_M;
                match pick[axis] {
                    0 => near,
                    1 => size_m[axis] - near,
                    _ => size_m[axis] * rng.random::<f64>(),
                }
            });
            at.push(place);
        }
    }
    at.push([0.0; 3]);
    at.push(size_m.to_array());
    at.push((size_m / 2.0).to_array());
    at.iter().enumerate().map(|(i, place)| Position { position_m: place.map(|x| x as f32), tag: i as u32 }).collect()
}

fn params(size_m: DVec3, count: usize) -> StepParams {
    StepParams {
        dt_s: 0.01,
        domain_size_m: size_m.to_array().map(|x| x as f32),
        wall_offset_m: -1.0,
        max_speed_m_s: 1.0,
        particle_count: count as u32,
        ..StepParams::default()
    }
}

/// Density ratios that walls add at each place: each is measured alone.
fn densities(places: &[Position], size_m: DVec3, walls: WallsKeyword) -> Vec<f64> {
    let weight = f64::from(kernel_params().weight);
    let mut bench = Bench::new();
    let weights = bench.input("wall_weights", &wall_weights(SUPPORT_RATIO));
    let kernel = bench.uniform("kernel", kernel_params());
    let step_params = bench.uniform("step_params", params(size_m, 1));
    let velocities = bench.input("velocities", &[Velocity::default()]);
    let neighbours = bench.input("neighbours", &[[0_u32; 4]]);
    let neighbour_counts = bench.input("neighbour_counts", &[0_u32]);
    let mut measures = Vec::new();
    for place in places {
        let positions = bench.input("positions", &[*place]);
        let mut group_measures = bench.output::<MeasureSums>("group_measures", 1);
        let mut histograms = bench.output("histograms", 1024);
        bench.dispatch(
            &MeasureParticles {
                variant: MeasureParticlesVariant { walls },
                positions: positions.read(),
                velocities: velocities.read(),
                neighbours: neighbours.read(),
                neighbour_counts: neighbour_counts.read(),
                group_measures: group_measures.write(),
                histograms: histograms.write(),
                wall_weights: Some(weights.read()),
                step_params: step_params.uniform(),
                kernel: kernel.uniform(),
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

/// Gradients of the density that walls add, from corrections with lambda = -1/2 and factors of 1:
/// the correction is then the negative gradient times h.
fn gradients(places: &[Position], size_m: DVec3, walls: WallsKeyword) -> Vec<DVec3> {
    let count = places.len();
    let pbf = PbfParams { relaxation: 1.0, max_correction_m: 1e3, ..pbf_params() };
    let inverse_support_per_m = kernel_params().inverse_support_per_m;
    let start: Vec<[u32; 2]> =
        places.iter().map(|p| Places::Full.place_of(p.position_m.map(|x| x * inverse_support_per_m))).collect();
    let constrained: Vec<Constrained> =
        start.iter().map(|&place| Constrained { place, lambda: -0.5, reserved: 0.0 }).collect();
    let mut bench = Bench::new();
    let input = bench.input("constrained", &constrained);
    let positions = bench.input("sorted_positions", places);
    let neighbours = bench.input("neighbours", &vec![[0_u32; 4]; count]);
    let neighbour_counts = bench.input("neighbour_counts", &vec![0_u32; count]);
    let mut after = bench.output::<[u32; 2]>("places", count);
    let mut counters = bench.input("counters", &[Counters::default()]);
    let weights = bench.input("wall_weights", &wall_weights(SUPPORT_RATIO));
    let step_params = bench.uniform("step_params", params(size_m, count));
    let kernel = bench.uniform("kernel", kernel_params());
    let pbf = bench.uniform("pbf", pbf);
    bench.dispatch(
        &CorrectPositions {
            variant: CorrectPositionsVariant { walls, ..CorrectPositionsVariant::default() },
            constrained: Some(input.read()),
            packed_constrained: None,
            sorted_positions: Some(positions.read()),
            neighbours: neighbours.read(),
            neighbour_counts: neighbour_counts.read(),
            places: after.write(),
            counters: counters.write(),
            wall_weights: Some(weights.read()),
            step_params: step_params.uniform(),
            kernel: kernel.uniform(),
            pbf: pbf.uniform(),
        },
        count,
    );
    let after = bench.run().read(&after, count);
    start.iter().zip(after).map(|(&before, after)| Places::Full.apart(before, after)).collect()
}

fn check(size_m: DVec3, walls_keyword: WallsKeyword, names: [&'static str; 2]) -> Vec<(WallDensity, f64)> {
    // A table value is a lerp of lerps of eight nodes of at most 1.5, the place between them known
    // to a few roundings of the distance (31 steps wide): 128 roundings. A gradient is read from a
    // move of a place, which rounds to half a step of 1.9e-6 h along each axis: 28 roundings more.
    let mut density = Worst::new(names[0], 128.0 * ROUNDING);
    let mut gradient = Worst::new(names[1], 256.0 * ROUNDING);
    let places = places(size_m);
    let weights = wall_weights(SUPPORT_RATIO);
    let table = wall_table(&weights);
    let walls = DomainWalls {
        weight: &table,
        domain_size_m: vector(params(size_m, 0).domain_size_m),
        support_m: f64::from(kernel_params().support_m),
    };
    let got_densities = densities(&places, size_m, walls_keyword);
    let got_gradients = gradients(&places, size_m, walls_keyword);
    let mut results = Vec::new();
    for (i, at) in vectors(&places).into_iter().enumerate() {
        let expected = walls.at(at);
        density.check(got_densities[i] as f32, expected.density, 1.0).unwrap();
        gradient.check3(got_gradients[i].to_array().map(|g| g as f32), expected.gradient, 1.0).unwrap();
        results.push((expected, got_densities[i]));
    }
    density.report();
    gradient.report();
    results
}

#[test]
fn wall_weights_match_their_twin() {
    let wide =
        check(DVec3::new(0.3, 0.2, 0.5), WallsKeyword::Walls, ["wall_weights, density", "wall_weights, gradient"]);
    assert!(wide.iter().any(|(walls, _)| walls.density > 0.5), "no place was in a corner");
    assert!(wide.iter().any(|(walls, _)| walls.density == 0.0), "no place was far from walls");
}

#[test]
fn narrow_wall_weights_match_their_twin() {
    check(
        DVec3::new(1.2 * SUPPORT_M, 0.3, 1.7 * SUPPORT_M),
        WallsKeyword::NarrowWalls,
        ["narrow wall_weights, density", "narrow wall_weights, gradient"],
    );
    // In a wide domain both variants say the same.
    let size_m = DVec3::new(0.3, 0.2, 0.5);
    let places = places(size_m);
    let near = densities(&places, size_m, WallsKeyword::Walls);
    let narrow = densities(&places, size_m, WallsKeyword::NarrowWalls);
    let mut worst = Worst::new("narrow wall_weights in a wide domain", 128.0 * ROUNDING);
    for (near, narrow) in near.iter().zip(&narrow) {
        worst.check(*narrow as f32, *near, 1.0).unwrap();
    }
    worst.report();
}
