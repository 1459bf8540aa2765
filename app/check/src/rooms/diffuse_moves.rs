//! What moves diffuse particles, against its twins: `diffuse/advect_diffuse`, `diffuse/collide_diffuse`.

use super::diffuse::{compare_particle, domain_of, params};
use super::solids::{self, DT_S, PATH_TOLERANCE, STOP_M, confined, is_fickle, near_solids, paths, single, walls};
use crate::bench::Bench;
use crate::cases::{SUPPORT_M, fluid, grid_params, out_of_part, sizes, step_of, step_state};
use crate::compare::{ROUNDING, Worst, slot_state, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, Wrong, ensure, ensure_eq};
use brooklet_fluid::particles::is_simulated;
use brooklet_kernels::{
    AdvectDiffuse, AdvectDiffuseVariant, CollideDiffuse, Counters, DiffuseParams, DiffuseParticle, DiffuseState,
    GridParams, Kernel as _, Position, StepParams, Velocity,
};
use brooklet_reference::boundary::solids::collide::Moving;
use brooklet_reference::diffuse::advect_diffuse::advected;
use brooklet_reference::diffuse::collide_diffuse::collided;
use brooklet_reference::diffuse::{Diffuse, Particle};
use brooklet_reference::grid::count_cells::{cell_of_slot, count_cells};
use brooklet_reference::params::Grid;
use glam::DVec3;
use rand::RngExt;

/// What bounds the domain of a case.
#[derive(Clone, Copy, PartialEq)]
enum Bounds {
    Walls,
    Nothing,
    Periods,
    /// Nothing, and cells that stand for others.
    Wrapped,
}

struct Around {
    positions: Vec<Position>,
    velocities: Vec<Velocity>,
    cell_starts: Vec<u32>,
    grid: GridParams,
    step: StepParams,
    walls: bool,
}

/// A fluid in the order of its cells.
fn around(size: usize, seed: u64, bounds: Bounds) -> Around {
    let case = fluid(&mut rng(seed), size);
    let unit_m = 4.0 * SUPPORT_M;
    // Whole periods, and room for spray.
    let side_m = ((case.size_m.x + SUPPORT_M) / unit_m).ceil() * unit_m;
    let size_m = DVec3::splat(side_m);
    let mut grid = grid_params(size_m, 0.5 * SUPPORT_M);
    let side = [side_m as f32; 3];
    let open = [1e30; 3];
    let mut step = StepParams { domain_size_m: side, max_speed_m_s: 25.0, ..case.step_params() };
    (step.wall_min_m, step.wall_max_m) =
        if bounds == Bounds::Walls { ([0.0; 3], side) } else { (open.map(|x| -x), open) };
    match bounds {
        Bounds::Periods => {
            grid.seam_cells = grid.domain_cells;
            (step.period_m, step.inverse_period_per_m) = (side, side.map(|side| 1.0 / side));
        }
        Bounds::Wrapped => {
            grid.cells = [8; 3];
            grid.cell_count = 512;
        }
        Bounds::Walls | Bounds::Nothing => {}
    }
    let twin = Grid {
        cells: grid.cells,
        domain_cells: grid.domain_cells,
        cell_size_m: grid.cell_size_m.into(),
        support_m: grid.support_m.into(),
    };
    let mut order: Vec<(u32, Position, Velocity)> = case
        .positions
        .iter()
        .zip(&case.velocities)
        .enumerate()
        .map(|(i, (position, velocity))| {
            // Off the domain's corner, so that some are near a seam and some are not.
            let position_m = position.position_m.map(|x| x + 0.001);
            let position = Position { position_m, tag: position.tag | out_of_part(i) };
            (cell_of_slot(vector(position_m), slot_state(position.tag), &twin), position, *velocity)
        })
        .collect();
    order.sort_by_key(|(cell, ..)| *cell);
    let cells: Vec<u32> = order.iter().map(|(cell, ..)| *cell).collect();
    let mut start = 0;
    let counts = count_cells(&cells, grid.cell_count);
    let cell_starts = counts
        .iter()
        .map(|&count| {
            start += count;
            start - count
        })
        .collect();
    Around {
        positions: order.iter().map(|(_, position, _)| *position).collect(),
        velocities: order.iter().map(|(.., velocity)| *velocity).collect(),
        cell_starts,
        grid,
        step,
        walls: bounds == Bounds::Walls,
    }
}

/// Everywhere, most of them near the fluid; some slots are empty, some end in the step.
fn particles(count: usize, seed: u64, around: &Around) -> Vec<DiffuseParticle> {
    let mut rng = rng(seed);
    let side_m = around.step.domain_size_m[0];
    (0..count)
        .map(|i| {
            let reach_m = if i % 5 == 0 { side_m } else { 0.6 * side_m };
            let mut number = || rng.random::<f32>();
            let position_m = [0; 3].map(|_| 0.01 * side_m + 0.98 * reach_m * number());
            let velocity_m_s = [0; 3].map(|_| 6.0 * number() - 3.0);
            let lifetime_s = [1.5, 0.002, 0.0, 0.7][i % 4];
            let position_m = if i % 97 == 13 { position_m.map(|x| x + 3.0 * side_m) } else { position_m };
            DiffuseParticle { position_m, lifetime_s, velocity_m_s, crowd: 0.3 }
        })
        .collect()
}

fn run_advect(
    device: &Device,
    around: &Around,
    before: &[DiffuseParticle],
    params: DiffuseParams,
    in_use: u32,
) -> (Vec<DiffuseParticle>, u32) {
    let mut bench = Bench::new(device);
    let positions = bench.input("positions", &around.positions);
    let velocities = bench.input("velocities", &around.velocities);
    let cell_starts = bench.input("cell_starts", &around.cell_starts);
    let mut diffuse = bench.input("diffuse", before);
    let mut counters = bench.input("counters", &[Counters::default()]);
    let ring = bench.uniform("diffuse_state", DiffuseState { instance_count: in_use, ..DiffuseState::default() });
    let state = bench.uniform("step_state", step_state(around.positions.len(), around.step.dt_s));
    let step = bench.uniform("step_params", around.step);
    let grid = bench.uniform("grid", around.grid);
    let params = bench.uniform("diffuse_params", params);
    let cell_by_cell = around.grid.cells != around.grid.domain_cells || around.step.period_m[0] > 0.0;
    bench.dispatch(
        &AdvectDiffuse {
            variant: AdvectDiffuseVariant { walls: around.walls, cell_by_cell },
            positions: positions.read(),
            velocities: velocities.read(),
            cell_starts: cell_starts.read(),
            diffuse: diffuse.write(),
            counters: counters.write(),
            diffuse_state: ring.uniform(),
            step_state: state.uniform(),
            step_params: step.uniform(),
            grid: grid.uniform(),
            diffuse_params: params.uniform(),
        },
        before.len(),
    );
    let mut done = bench.run();
    (done.read(&diffuse, before.len()), done.read(&counters, 1)[0].diffuse_ended)
}

pub(super) fn of(particle: &DiffuseParticle) -> Particle {
    Particle {
        position_m: vector(particle.position_m),
        velocity_m_s: vector(particle.velocity_m_s),
        lifetime_s: particle.lifetime_s.into(),
        crowd: particle.crowd.into(),
    }
}

/// How many were told apart: spray, foam, bubbles, and those that are left out.
#[derive(Debug, Default)]
struct Kinds {
    spray: usize,
    foam: usize,
    bubbles: usize,
    fickle: usize,
    ended: usize,
}

fn compare_advected(
    worst: &mut Worst,
    around: &Around,
    (before, got): (&[DiffuseParticle], &[DiffuseParticle]),
    params: &DiffuseParams,
    kinds: &mut Kinds,
) -> Result<(), Wrong> {
    let fluid: Vec<(DVec3, DVec3)> = around
        .positions
        .iter()
        .zip(&around.velocities)
        .filter(|(position, _)| is_simulated(position.tag))
        .map(|(position, velocity)| (vector(position.position_m), vector(velocity.velocity_m_s)))
        .collect();
    let mut step = step_of(&around.step, around.walls);
    step.dt_s *= f64::from(params.substeps);
    let (domain, diffuse) = (domain_of(&around.step), Diffuse::of(params));
    for (before, got) in before.iter().zip(got) {
        if before.lifetime_s == 0.0 {
            ensure_eq!(got, before, "an empty slot");
            continue;
        }
        let expected = advected(&of(before), &fluid, &step, &domain, &diffuse);
        if expected.is_fickle {
            kinds.fickle += 1;
            continue;
        }
        let particle = expected.particle;
        kinds.ended += usize::from(particle.lifetime_s == 0.0);
        match particle.crowd {
            crowd if crowd < 0.18 => kinds.spray += 1,
            crowd if crowd <= 0.6 => kinds.foam += 1,
            _ => kinds.bubbles += 1,
        }
        let mut particle = particle;
        // Which side of a seam it is on a rounding decides.
        let period_m = vector(around.step.period_m);
        particle.position_m = vector(got.position_m)
            + brooklet_reference::params::nearest_image(particle.position_m - vector(got.position_m), period_m);
        compare_particle(worst, got, &particle)?;
    }
    Ok(())
}

/// A velocity is a mean over up to sixty others, of at most 3.5 m/s, and what a wall takes of it a difference of places over a step.
const ADVECT_TOLERANCE: f64 = 256.0 * ROUNDING;

pub(crate) fn advect_diffuse_matches_its_twin(device: &Device) {
    let mut worst = device.worst(AdvectDiffuse::STAGE, ADVECT_TOLERANCE);
    let mut kinds = Kinds::default();
    let mut all = 0;
    for bounds in [Bounds::Walls, Bounds::Nothing, Bounds::Periods, Bounds::Wrapped] {
        for (seed, size) in sizes(device, AdvectDiffuse::GROUP_SIZE[0] as usize).into_iter().enumerate() {
            let around = around(if size % 2 == 1 { 1500 } else { size }, 860 + seed as u64, bounds);
            let before = particles(size, 870 + seed as u64, &around);
            let params = params(if seed % 2 == 0 { &[] } else { &["solver.substeps=2"] });
            let (got, ended) = run_advect(device, &around, &before, params, size as u32);
            compare_advected(&mut worst, &around, (&before, &got), &params, &mut kinds).or_raise();
            let gone = before.iter().zip(&got).filter(|(b, g)| b.lifetime_s > 0.0 && g.lifetime_s == 0.0).count();
            ensure_eq!(ended as usize, gone, "those that end are counted");
            all += size;
        }
    }
    let few = if device.small() { 5 } else { 50 };
    let least = [kinds.spray, kinds.foam, kinds.bubbles, kinds.ended].into_iter().min();
    ensure!(least > Some(few) && 20 * kinds.fickle < all, "{kinds:?} of {all}");
    worst.report(device);
    let around = around(1500, 879, Bounds::Walls);
    let before = particles(333, 878, &around);
    let right = params(&[]);
    let (got, _) = run_advect(device, &around, &before, right, 333);
    for wrong_params in [DiffuseParams { buoyancy: 2.5, ..right }, DiffuseParams { drag: 0.5, ..right }] {
        let mut wrong = Worst::new(AdvectDiffuse::STAGE, ADVECT_TOLERANCE);
        let both = (&before[..], &got[..]);
        let told = compare_advected(&mut wrong, &around, both, &wrong_params, &mut Kinds::default());
        ensure!(told.is_err(), "it sees {wrong_params:?}");
    }
    // Slots that are not in use are not visited.
    let (got, _) = run_advect(device, &around, &before, right, 100);
    ensure!(got[100..] == before[100..] && got[..100] != before[..100], "a hundred are in use");
}

pub(crate) fn collide_diffuse_matches_its_twin(device: &Device) {
    let case = solids::case();
    let mut rng = rng(890);
    let mut worst = device.worst(CollideDiffuse::STAGE, PATH_TOLERANCE);
    let (mut stopped, mut fickle, mut refused, mut all) = (0, 0, 0, 0);
    for (turn, size) in sizes(device, CollideDiffuse::GROUP_SIZE[0] as usize).into_iter().enumerate() {
        let substeps = 1 + turn as u32 % 3;
        let moving = case.moving(solids::TIMES_S[turn % solids::TIMES_S.len()]);
        let standing: Vec<Moving> = moving.iter().map(|(solid, _, pose)| (solid.clone(), *pose, *pose)).collect();
        let starts_m = near_solids(&mut rng, size, &moving);
        let ends_m: Vec<DVec3> =
            paths(&mut rng, &starts_m, 6.0 / 240.0 * f64::from(substeps)).into_iter().map(confined).collect();
        let step_s = f64::from(DT_S) * f64::from(substeps);
        let before: Vec<DiffuseParticle> = (0..size)
            .map(|i| DiffuseParticle {
                position_m: single(ends_m[i]),
                velocity_m_s: single((ends_m[i] - starts_m[i]) / step_s),
                lifetime_s: [1.0, 0.001, 0.5][i % 3],
                crowd: [0.1, 0.4, 0.9][i / 3 % 3],
            })
            .collect();
        let mut bench = Bench::new(device);
        let solids = bench.input("solids", &case.solids);
        let poses = bench.input("solid_poses", &case.poses(&moving));
        let fields = bench.input("solid_fields", &case.fields);
        let blocks = bench.input("solid_blocks", &case.blocks(&moving));
        let mut diffuse = bench.input("diffuse", &before);
        let mut counters = bench.input("counters", &[Counters::default()]);
        let ring = DiffuseState { instance_count: size as u32, ..DiffuseState::default() };
        let ring = bench.uniform("diffuse_state", ring);
        let state = bench.uniform("step_state", step_state(1, DT_S));
        let step_params = bench.uniform("step_params", walls());
        let solids_params = bench.uniform("solids_params", case.params);
        let diffuse_params = bench.uniform("diffuse_params", DiffuseParams { substeps, ..params(&[]) });
        bench.dispatch(
            &CollideDiffuse {
                solids: solids.read(),
                solid_poses: poses.read(),
                solid_fields: fields.read(),
                solid_blocks: blocks.read(),
                diffuse: diffuse.write(),
                counters: counters.write(),
                diffuse_state: ring.uniform(),
                step_state: state.uniform(),
                step_params: step_params.uniform(),
                solids_params: solids_params.uniform(),
                diffuse_params: diffuse_params.uniform(),
            },
            size,
        );
        let mut done = bench.run();
        let got = done.read(&diffuse, size);
        let gone = got.iter().filter(|particle| particle.lifetime_s == 0.0).count();
        ensure_eq!(done.read(&counters, 1)[0].diffuse_ended as usize, gone);
        for i in 0..size {
            all += 1;
            let particle = of(&before[i]);
            let substep = (substeps, f64::from(DT_S));
            let at = |stop_m: f64, start_m: DVec3, end_m: DVec3| {
                let velocity_m_s = (end_m - start_m) / step_s;
                collided(
                    &Particle { position_m: end_m, velocity_m_s, ..particle },
                    substep,
                    &standing,
                    stop_m,
                    confined,
                )
            };
            if is_fickle(starts_m[i], ends_m[i], |start_m, end_m| at(STOP_M, start_m, end_m).position_m) {
                fickle += 1;
                continue;
            }
            let expected = collided(&particle, substep, &standing, STOP_M, confined);
            worst.check3(got[i].position_m, expected.position_m, STOP_M).or_raise();
            worst.check3(got[i].velocity_m_s, expected.velocity_m_s, STOP_M / step_s).or_raise();
            let is_stopped = expected.position_m.distance(ends_m[i]) > 0.1 * STOP_M;
            if is_stopped || expected.position_m == ends_m[i] {
                worst.check(got[i].lifetime_s, expected.lifetime_s, 1e-3).or_raise();
            }
            stopped += usize::from(is_stopped);
            let mut wrong = Worst::new(CollideDiffuse::STAGE, PATH_TOLERANCE);
            let thicker = collided(&particle, substep, &standing, 1.2 * STOP_M, confined);
            refused += usize::from(is_stopped && wrong.check3(got[i].position_m, thicker.position_m, STOP_M).is_err());
        }
    }
    ensure!(stopped * 20 > all && fickle * 10 < all, "{stopped} of {all} stopped, {fickle} left out");
    ensure!(5 * refused > stopped, "{refused} of {stopped} would tell a distance a fifth larger apart");
    worst.report(device);
}
