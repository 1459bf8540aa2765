//! What spawns diffuse particles, against its twins: `diffuse/crest_normals`, `diffuse/count_spawned`, `diffuse/spawn_diffuse`.

use crate::bench::Bench;
use crate::cases::{Case, SUPPORT_M, fluid, kernel_params, out_of_part, sizes, step_state};
use crate::compare::{ROUNDING, Worst, check_exact, report_exact, tolerance_of_pairs, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, Wrong, ensure, ensure_eq};
use brooklet_fluid::Scene;
use brooklet_fluid::diffuse::diffuse_params;
use brooklet_fluid::particles::{id_of, is_simulated};
use brooklet_kernels::{
    Buffer, CountSpawned, Counters, CrestNormals, DiffuseParams, DiffuseParticle, DiffuseState, Kernel as _,
    SettleDiffuse, SpawnDiffuse, StepParams, StepState,
};
use brooklet_reference::diffuse::count_spawned::{Fluid, chance, due};
use brooklet_reference::diffuse::crest_normals::crest_normal;
use brooklet_reference::diffuse::spawn_diffuse::{Spawning, settled, spawned};
use brooklet_reference::diffuse::{Diffuse, Domain, Particle};
use glam::DVec3;
use rand::RngExt;

const DT_S: f32 = 1.0 / 240.0;
const TIME_S: f32 = 0.731;

/// Some of a random fluid's particles are below each limit, some between, some above.
pub(super) fn params(settings: &[&str]) -> DiffuseParams {
    let settings: Vec<String> = settings.iter().map(|&setting| setting.into()).collect();
    let mut scene = Scene::load("dam-break", &settings).or_raise();
    scene.diffuse = Some(brooklet_fluid::scene::DiffuseSettings {
        trapped_air_per_s: 900.0,
        wave_crest_per_s: 700.0,
        trapped_air_min_m_s: Some(0.8),
        trapped_air_max_m_s: Some(3.0),
        wave_crest_min: 0.02,
        wave_crest_max: 0.6,
        energy_min_j_kg: Some(0.8),
        energy_max_j_kg: Some(3.0),
        ..Default::default()
    });
    diffuse_params(&scene, scene.diffuse_particles().or_raise())
}

pub(super) fn domain_of(step: &StepParams) -> Domain {
    Domain {
        wall_min_m: vector(step.wall_min_m),
        wall_max_m: vector(step.wall_max_m),
        period_m: vector(step.period_m),
        support_m: SUPPORT_M,
    }
}

/// Some take no part; walls on all sides, or on none.
fn case_of(size: usize, seed: u64, walls: bool) -> (Case, StepParams) {
    let mut case = fluid(&mut rng(seed), size);
    for (i, position) in case.positions.iter_mut().enumerate() {
        position.tag |= out_of_part(i);
    }
    let far = if walls { 0.0 } else { 1e30 };
    let step = case.step_params();
    let step = StepParams {
        wall_min_m: step.wall_min_m.map(|low| low - far),
        wall_max_m: step.wall_max_m.map(|high| high + far),
        ..step
    };
    (case, step)
}

fn state(size: usize) -> StepState {
    StepState { time_s: TIME_S, ..step_state(size, DT_S) }
}

fn run_normals(device: &Device, case: &Case, step: StepParams, params: DiffuseParams) -> Vec<[f32; 4]> {
    let mut bench = Bench::new(device);
    let size = case.count();
    let positions = bench.input("positions", &case.positions);
    let (neighbours, list_heads) = case.upload_neighbours(&mut bench);
    let mut normals: Buffer<[f32; 4]> = bench.output("crest_normals", size);
    let step_state = bench.uniform("step_state", state(size));
    let step_params = bench.uniform("step_params", step);
    let kernel = bench.uniform("kernel", kernel_params());
    let params = bench.uniform("diffuse_params", params);
    bench.dispatch(
        &CrestNormals {
            positions: positions.read(),
            neighbours: neighbours.read(),
            list_heads: list_heads.read(),
            crest_normals: normals.write(),
            step_state: step_state.uniform(),
            step_params: step_params.uniform(),
            kernel: kernel.uniform(),
            diffuse_params: params.uniform(),
        },
        size,
    );
    bench.run().read(&normals, size)
}

/// A direction is known as well as its terms are to their sum.
fn compare_normals(
    worst: &mut Worst,
    case: &Case,
    step: &StepParams,
    params: &DiffuseParams,
    got: &[[f32; 4]],
) -> Result<(), Wrong> {
    let (positions_m, domain, diffuse) = (case.positions_m(), domain_of(step), Diffuse::of(params));
    for (i, got) in got.iter().enumerate() {
        let direction = [got[0], got[1], got[2]];
        if !is_simulated(case.positions[i].tag) {
            worst.check3(direction, DVec3::ZERO, 1.0)?;
            continue;
        }
        let expected = crest_normal(i, &positions_m, &case.neighbours[i], &domain, &diffuse);
        let terms = 3.0 * diffuse.normal + case.neighbours[i].len() as f64;
        let length = expected.sum.length();
        if length > 1e-3 {
            worst.check3(direction, expected.sum / length, (terms / length).max(1.0))?;
        }
        // Its slope over the length is 6 at most.
        worst.check(got[3], expected.surface, 6.0 * terms / diffuse.normal)?;
    }
    Ok(())
}

pub(crate) fn crest_normals_match_their_twin(device: &Device) {
    let tolerance = tolerance_of_pairs(ROUNDING, 0.0);
    let mut worst = device.worst(CrestNormals::STAGE, tolerance);
    for (settings, walls) in [(&[][..], true), (&[][..], false), (&["domain.dimensions=2"][..], true)] {
        let params = params(settings);
        for (seed, size) in sizes(device, CrestNormals::GROUP_SIZE[0] as usize).into_iter().enumerate() {
            let (case, step) = case_of(size, 800 + seed as u64, walls);
            let got = run_normals(device, &case, step, params);
            compare_normals(&mut worst, &case, &step, &params, &got).or_raise();
        }
    }
    worst.report(device);
    let (case, step) = case_of(333, 809, true);
    let params = params(&[]);
    let got = run_normals(device, &case, step, params);
    let open = StepParams { wall_max_m: step.wall_max_m.map(|high| high + 1e30), ..step };
    let mut wrong = Worst::new(CrestNormals::STAGE, tolerance);
    ensure!(compare_normals(&mut wrong, &case, &open, &params, &got).is_err(), "it sees walls");
}

fn run_counts(
    device: &Device,
    case: &Case,
    normals: &[[f32; 4]],
    step: StepParams,
    params: DiffuseParams,
) -> (Vec<u32>, u32) {
    let mut bench = Bench::new(device);
    // Some slots behind those that are visited.
    let (size, visited) = (case.count(), case.count() - case.count() / 5);
    let positions = bench.input("positions", &case.positions);
    let velocities = bench.input("velocities", &case.velocities);
    let (neighbours, list_heads) = case.upload_neighbours(&mut bench);
    let normals = bench.input("crest_normals", normals);
    let mut counts = bench.input("spawn_counts", &vec![77_u32; size]);
    let mut counters = bench.input("counters", &[Counters::default()]);
    let step_state = bench.uniform("step_state", state(visited));
    let step_params = bench.uniform("step_params", step);
    let kernel = bench.uniform("kernel", kernel_params());
    let params = bench.uniform("diffuse_params", params);
    bench.dispatch(
        &CountSpawned {
            positions: positions.read(),
            velocities: velocities.read(),
            neighbours: neighbours.read(),
            list_heads: list_heads.read(),
            crest_normals: normals.read(),
            spawn_counts: counts.write(),
            counters: counters.write(),
            step_state: step_state.uniform(),
            step_params: step_params.uniform(),
            kernel: kernel.uniform(),
            diffuse_params: params.uniform(),
        },
        size,
    );
    let mut done = bench.run();
    (done.read(&counts, size), done.read(&counters, 1)[0].diffuse_dropped)
}

/// The counts that a rounding allows, of each: what is due, and its chance, may be a ten-thousandth off, relative to what a
/// potential of 1 makes due.
fn allowed(case: &Case, normals: &[[f32; 4]], step: &StepParams, params: &DiffuseParams) -> Vec<[u32; 2]> {
    let (positions_m, velocities_m_s) = (case.positions_m(), case.velocities_m_s());
    let normals: Vec<(DVec3, f64)> = normals.iter().map(|n| (vector([n[0], n[1], n[2]]), f64::from(n[3]))).collect();
    let fluid = Fluid { positions_m: &positions_m, velocities_m_s: &velocities_m_s, normals: &normals };
    let (domain, diffuse) = (domain_of(step), Diffuse::of(params));
    let dt_s = f64::from(DT_S) * f64::from(params.substeps);
    let doubt = 1e-4 * (diffuse.trapped_air_per_s + diffuse.wave_crest_per_s) * dt_s;
    let visited = case.count() - case.count() / 5;
    (0..case.count())
        .map(|i| {
            let tag = case.positions[i].tag;
            if i >= visited || !is_simulated(tag) {
                return [0, 0];
            }
            let [low, high] = due(i, &fluid, &case.neighbours[i], dt_s, &domain, &diffuse);
            let chance = chance(id_of(tag), TIME_S);
            // What is due of nobody has no chance.
            let most = if high > 0.0 { (high + doubt + chance) as u32 } else { 0 };
            [if low > doubt { (low - doubt + chance).max(0.0) as u32 } else { 0 }, most]
        })
        .collect()
}

fn compare_counts(got: &[u32], allowed: &[[u32; 2]]) -> Result<(), Wrong> {
    check_exact(&got.iter().zip(allowed).map(|(got, [low, high])| *got.clamp(low, high)).collect::<Vec<_>>(), got)
}

pub(crate) fn count_spawned_matches_its_twin(device: &Device) {
    let mut cases = 0;
    for (settings, walls) in [(&[][..], true), (&["solver.substeps=3"][..], false)] {
        let params = params(settings);
        for (seed, size) in sizes(device, CountSpawned::GROUP_SIZE[0] as usize).into_iter().enumerate() {
            let (case, step) = case_of(size, 820 + seed as u64, walls);
            let normals = run_normals(device, &case, step, params);
            let (got, dropped) = run_counts(device, &case, &normals, step, params);
            let allowed = allowed(&case, &normals, &step, &params);
            compare_counts(&got, &allowed).or_raise();
            ensure_eq!(dropped, 0);
            let narrow = allowed.iter().filter(|[low, high]| low == high).count();
            ensure!(20 * narrow >= 19 * size, "{narrow} of {size} are sure");
            let kinds = [0, 1, 2].map(|n| got.iter().filter(|&&count| count.min(2) == n).count());
            ensure!(size < 300 || kinds.iter().all(|&kind| 40 * kind > size), "{kinds:?} spawn none, one, more");
            cases += size;
        }
    }
    report_exact(device, CountSpawned::STAGE, cases);
    // Others would spawn others; and more than a particle may are counted.
    let (case, step) = case_of(333, 829, true);
    let params = params(&[]);
    let normals = run_normals(device, &case, step, params);
    let (got, _) = run_counts(device, &case, &normals, step, params);
    let changed = [
        DiffuseParams { trapped_air_least_m_s: 1.0, ..params },
        DiffuseParams { wave_crest_per_s: 0.0, ..params },
        DiffuseParams { energy_inverse_range_kg_j: 0.2, ..params },
    ];
    for other in changed {
        ensure!(compare_counts(&got, &allowed(&case, &normals, &step, &other)).is_err(), "it sees {other:?}");
    }
    let many = DiffuseParams { trapped_air_per_s: 1.0e6, ..params };
    let (got, dropped) = run_counts(device, &case, &normals, step, many);
    let total = allowed(&case, &normals, &step, &many).iter().map(|[low, _]| u64::from(*low)).sum::<u64>();
    let counted = got.iter().map(|&count| u64::from(count)).sum::<u64>() + u64::from(dropped);
    ensure!(got.iter().max() == Some(&256) && counted.abs_diff(total) * 1000 < total, "{counted} of {total}");
}

struct Spawned {
    particles: Vec<DiffuseParticle>,
    state: DiffuseState,
    counters: Counters,
}

fn run_spawn(
    device: &Device,
    case: &Case,
    counts: &[u32],
    before: &[DiffuseParticle],
    ring: DiffuseState,
    params: DiffuseParams,
) -> Spawned {
    let mut bench = Bench::new(device);
    let size = case.count();
    let mut offset = 0;
    let offsets: Vec<u32> = counts
        .iter()
        .map(|&count| {
            offset += count;
            offset - count
        })
        .collect();
    let positions = bench.input("positions", &case.positions);
    let velocities = bench.input("velocities", &case.velocities);
    let (_, list_heads) = case.upload_neighbours(&mut bench);
    let counts = bench.input("spawn_counts", counts);
    let offsets = bench.input("spawn_offsets", &offsets);
    let mut diffuse = bench.input("diffuse", before);
    let mut counters = bench.input("counters", &[Counters::default()]);
    let mut ring = bench.input("diffuse_state", &[ring]);
    let step_state = bench.uniform("step_state", state(size));
    let uniform = bench.uniform("diffuse_params", params);
    bench.dispatch(
        &SpawnDiffuse {
            positions: positions.read(),
            velocities: velocities.read(),
            list_heads: list_heads.read(),
            spawn_counts: counts.read(),
            spawn_offsets: offsets.read(),
            diffuse: diffuse.write(),
            counters: counters.write(),
            diffuse_state: ring.uniform(),
            step_state: step_state.uniform(),
            diffuse_params: uniform.uniform(),
        },
        size,
    );
    bench.dispatch(
        &SettleDiffuse {
            spawn_counts: counts.read(),
            spawn_offsets: offsets.read(),
            settled_state: ring.write(),
            counters: counters.write(),
            diffuse_params: uniform.uniform(),
        },
        1,
    );
    let mut done = bench.run();
    Spawned {
        particles: done.read(&diffuse, params.capacity as usize),
        state: done.read(&ring, 1)[0],
        counters: done.read(&counters, 1)[0],
    }
}

/// Compares a particle: its place, its velocity and its share of neighbours within roundings of what they are made of, its
/// lifetime within two.
pub(super) fn compare_particle(worst: &mut Worst, got: &DiffuseParticle, expected: &Particle) -> Result<(), Wrong> {
    worst.check3(got.position_m, expected.position_m, 1.0)?;
    worst.check3(got.velocity_m_s, expected.velocity_m_s, 4.0)?;
    worst.check(got.crowd, expected.crowd, 2.0)?;
    worst.check(got.lifetime_s, expected.lifetime_s, 2.0)
}

fn compare_spawned(
    worst: &mut Worst,
    case: &Case,
    counts: &[u32],
    ring: &DiffuseState,
    params: &DiffuseParams,
    got: &Spawned,
) -> Result<(), Wrong> {
    let diffuse = Diffuse::of(params);
    let dt_s = f64::from(DT_S) * f64::from(params.substeps);
    let mut rank = 0;
    for (i, &count) in counts.iter().enumerate() {
        let of = Spawning {
            id: id_of(case.positions[i].tag),
            position_m: vector(case.positions[i].position_m),
            velocity_m_s: vector(case.velocities[i].velocity_m_s),
            neighbours: case.neighbours[i].len() as u32,
        };
        for k in 0..count {
            if rank < params.capacity {
                let slot = (ring.next_slot + rank) % params.capacity;
                compare_particle(worst, &got.particles[slot as usize], &spawned(&of, k, TIME_S, dt_s, &diffuse))?;
            }
            rank += 1;
        }
    }
    Ok(())
}

/// Sines and products of a handful of numbers of at most a few metres: 64 roundings. An angle up to 2 pi in f32 is off by 4, and
/// Vulkan lets a sine be off by 2^-11: what is aside, at most the cylinder's radius (.015 m) and .12 of a speed of 3.5 m/s, so.
const SPAWN_TOLERANCE: f64 = 64.0 * ROUNDING + 0.12 / 2048.0;

pub(crate) fn spawn_diffuse_matches_its_twin(device: &Device) {
    let mut worst = device.worst(SpawnDiffuse::STAGE, SPAWN_TOLERANCE);
    let mut cases = 0;
    let all = sizes(device, SpawnDiffuse::GROUP_SIZE[0] as usize);
    for (seed, size) in all.into_iter().enumerate().filter(|(_, size)| *size > 0) {
        for (capacity, next_slot) in [(5000, 0), (97, 41), (1, 0)] {
            let params = DiffuseParams { capacity, ..params(&["solver.substeps=2"]) };
            let (case, _) = case_of(size, 840 + seed as u64, true);
            let mut rng = rng(850 + seed as u64);
            let counts: Vec<u32> = case
                .positions
                .iter()
                .map(|position| if is_simulated(position.tag) { [0, 0, 1, 3][rng.random_range(0..4)] } else { 0 })
                .collect();
            // Every third slot is taken.
            let taken = |slot: u32| DiffuseParticle {
                lifetime_s: if slot.is_multiple_of(3) { 1.0 } else { 0.0 },
                ..DiffuseParticle::default()
            };
            let before: Vec<DiffuseParticle> = (0..capacity).map(taken).collect();
            let ring = DiffuseState { next_slot, instance_count: next_slot, ..DiffuseState::default() };
            let got = run_spawn(device, &case, &counts, &before, ring, params);
            compare_spawned(&mut worst, &case, &counts, &ring, &params, &got).or_raise();
            let total: u32 = counts.iter().sum();
            let (expected, took) = settled(&ring, total, capacity);
            ensure_eq!(got.state, expected);
            let over = (0..took).filter(|rank| ((next_slot + rank) % capacity).is_multiple_of(3)).count();
            let counted = Counters {
                diffuse_spawned: took,
                diffuse_dropped: total - took,
                diffuse_overwritten: over as u32,
                ..Counters::default()
            };
            ensure_eq!(got.counters, counted);
            let touched = |slot: u32| (slot + capacity - next_slot) % capacity < took;
            for slot in (0..capacity).filter(|&slot| !touched(slot)) {
                ensure_eq!(got.particles[slot as usize], before[slot as usize], "slot {slot} is nobody's");
            }
            cases += 1;
            let mut wrong = Worst::new(SpawnDiffuse::STAGE, SPAWN_TOLERANCE);
            let other = DiffuseParams { lifetime_s: params.lifetime_s + 0.5, ..params };
            let tells = compare_spawned(&mut wrong, &case, &counts, &ring, &other, &got);
            ensure!(total == 0 || tells.is_err(), "it sees another lifetime");
        }
    }
    worst.report(device);
    report_exact(device, SettleDiffuse::STAGE, cases);
}
