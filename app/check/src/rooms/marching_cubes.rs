//! `surface/mesh/` against its twins: the blocks that are listed, the field, and the mesh.
//!
//! The field is a sum over some 60 particles, each good to a rounding of its offset, over their weight: `FIELD`. What
//! comes after is decided by the GPU's own field, so counts, triangles and edges are exact.

use crate::device::Device;
use crate::wrong::{Named as _, OrRaise as _, ensure, ensure_eq, note};
use std::collections::BTreeSet;

use crate::bench::Bench;
use crate::cases::{out_of_part, step_state, vectors};
use crate::compare::{ROUNDING, Worst};
use crate::numbers::rng;
use brooklet_fluid::Slots;
use brooklet_kernels::{
    BEYOND_M, BLOCK_CELLS, BLOCK_INSIDE, BLOCK_LISTED, Ellipsoid, GatherField, Kernel, MeshCounts, MeshNormals,
    MeshParams, MeshVertex, Position, Velocity,
};
use brooklet_reference::surface::marching_cubes::{FieldGrid, Mesh, check_closed, marching_cubes, volume_m3};
use brooklet_reference::surface::mesh_blocks::{block_at, class_of, count_bins, is_listed};
use brooklet_reference::surface::surface_field::surface_field_in_walls;
use brooklet_render::Particles;
use brooklet_render::surface::marching_cubes::{self, MarchingCubesOptions, RefineOptions};
use glam::{DVec3, UVec3};
use rand::{Rng, RngExt};

pub(super) const SPACING_M: f64 = 0.02;
/// Roundings that the field may be off by near the surface, over the spacing: a point and a particle 17 spacings from the
/// domain's corner are each off by 17, and the column's step from point to point by some more.
const FIELD: f64 = 64.0;
/// Roundings of a gradient, over its length and how far x̄ is off x in spacings.
const GRADIENT: f64 = 600.0;

/// What the GPU made of particles.
pub(super) struct Meshed {
    pub(super) counts: MeshCounts,
    pub(super) vertices: Vec<MeshVertex>,
    pub(super) triangles: Vec<[u32; 3]>,
    pub(super) field_m: Vec<f32>,
    pub(super) entries: Vec<u32>,
    pub(super) inside: Vec<[u32; 2]>,
    pub(super) blocks: UVec3,
    pub(super) params: MeshParams,
}

pub(super) fn options(size_m: DVec3) -> MarchingCubesOptions {
    MarchingCubesOptions {
        spacing_m: SPACING_M,
        cell_m: 0.5 * SPACING_M,
        dense: false,
        anisotropic: false,
        domain_size_m: size_m.to_array(),
        wall_bounds_m: [[0.0; 3], size_m.to_array()],
        most_blocks: 4096,
        most_vertices: 1 << 16,
        most_triangles: 1 << 17,
        refine: RefineOptions {
            smooth_normals: 0,
            parts: 1,
            distance_m: SPACING_M,
            most_vertices: 1 << 18,
            most_triangles: 1 << 19,
        },
    }
}

pub(super) fn run(device: &Device, positions: &[Position], options: &MarchingCubesOptions) -> Meshed {
    run_with(device, positions, None, options)
}

/// The same of ellipsoids, where there are some.
pub(super) fn run_with(
    device: &Device,
    positions: &[Position],
    ellipsoids: Option<&[Ellipsoid]>,
    options: &MarchingCubesOptions,
) -> Meshed {
    let count = positions.len();
    let mut bench = Bench::new(device);
    let at = bench.input("positions", positions);
    let ellipsoids = ellipsoids.map(|ellipsoids| bench.input("ellipsoids", ellipsoids));
    let velocities = bench.output::<Velocity>("velocities", count);
    let step = bench.uniform("step", step_state(count, 0.0));
    let (resources, recording) = bench.parts();
    let mut slots = Slots::declare(resources, count as u32);
    recording.copy(&step, &mut slots.state);
    let particles = Particles {
        positions: &at,
        velocities: &velocities,
        slots: &slots,
        neighbours: None,
        densities: None,
        diffuse: None,
    };
    let mesh = bench.record_with_init(|resources, init, recording| {
        marching_cubes::record(resources, (init, recording), (&particles, ellipsoids.as_ref()), options)
    });
    bench.want(&mesh.counts);
    bench.want(&mesh.vertices);
    bench.want(&mesh.indices);
    bench.want(&mesh.field_m);
    bench.want(&mesh.block_inside);
    bench.want(&mesh.block_entries);
    let mut done = bench.run();
    let counts: MeshCounts = done.read(&mesh.counts, 1)[0];
    let indices: Vec<u32> = done.read(&mesh.indices, counts.index_count as usize);
    Meshed {
        counts,
        vertices: done.read(&mesh.vertices, counts.vertices as usize),
        triangles: indices.chunks(3).map(|corners| [corners[0], corners[1], corners[2]]).collect(),
        field_m: done.read(&mesh.field_m, 64 * counts.blocks as usize),
        inside: done.read(&mesh.block_inside, options.params().block_count as usize),
        entries: done.read(&mesh.block_entries, options.params().block_count as usize),
        blocks: UVec3::from_array(options.params().blocks),
        params: options.params(),
    }
}

impl Meshed {
    /// The GPU's field at every point of the grid, as what it lists none of is taken.
    fn grid_values(&self) -> (Vec<f64>, [usize; 3]) {
        let points = (self.blocks * BLOCK_CELLS).to_array().map(|n| n as usize);
        let mut values = Vec::new();
        for z in 0..points[2] {
            for y in 0..points[1] {
                for x in 0..points[0] {
                    let [block, local] = [[x, y, z].map(|n| n / 4), [x, y, z].map(|n| n % 4)];
                    let blocks = self.blocks.as_usizevec3();
                    let entry = self.entries[(block[2] * blocks.y + block[1]) * blocks.x + block[0]];
                    let beyond = is_beyond(UVec3::new(x as u32, y as u32, z as u32), &self.params);
                    values.push(match entry {
                        _ if beyond => f64::from(BEYOND_M),
                        BLOCK_INSIDE => SPACING_M,
                        listed if listed >= BLOCK_LISTED => {
                            let first = 64 * (listed - BLOCK_LISTED) as usize;
                            f64::from(self.field_m[first + (local[2] * 4 + local[1]) * 4 + local[0]])
                        }
                        _ => -SPACING_M,
                    });
                }
            }
        }
        (values, points)
    }

    fn mesh(&self) -> Mesh {
        Mesh {
            vertices_m: self.vertices.iter().map(|v| DVec3::from_array(v.position_m.map(f64::from))).collect(),
            triangles: self.triangles.clone(),
        }
    }
}

pub(super) fn is_beyond(grid_point: UVec3, mesh: &MeshParams) -> bool {
    grid_point.cmplt(UVec3::from_array(mesh.low_point)).any()
        || grid_point.cmpgt(UVec3::from_array(mesh.high_point)).any()
}

pub(super) fn min_m(options: &MarchingCubesOptions) -> DVec3 {
    DVec3::from_array(options.params().min_m.map(f64::from))
}

/// A jittered lattice of `counts` particles from `first_m` on.
pub(super) fn lattice(rng: &mut impl Rng, first_m: DVec3, counts: UVec3) -> Vec<Position> {
    let mut positions = Vec::new();
    for z in 0..counts.z {
        for y in 0..counts.y {
            for x in 0..counts.x {
                let jitter = DVec3::from_array([0; 3].map(|_| 0.2 * (rng.random::<f64>() - 0.5)));
                let at_m = first_m + SPACING_M * (DVec3::new(x.into(), y.into(), z.into()) + jitter);
                positions.push(Position { position_m: at_m.as_vec3().to_array(), tag: positions.len() as u32 });
            }
        }
    }
    positions
}

/// Particles of the shapes of fluid that there are: in the open, at walls, alone, scattered, out of part.
pub(super) fn cases(device: &Device) -> Vec<(&'static str, DVec3, Vec<Position>)> {
    let mut rng = rng(81);
    let size_m = SPACING_M * DVec3::new(17.0, 15.0, 13.0);
    let half_m = DVec3::splat(0.5 * SPACING_M);
    let scattered = (0..if device.small() { 40 } else { 400 }).map(|i| Position {
        position_m: (size_m * DVec3::new(rng.random(), rng.random(), rng.random())).as_vec3().to_array(),
        tag: i,
    });
    let scattered: Vec<Position> = scattered.collect();
    let mut parted = lattice(&mut rng, DVec3::splat(4.0 * SPACING_M), UVec3::new(5, 5, 5));
    parted.iter_mut().enumerate().for_each(|(i, position)| position.tag |= out_of_part(i));
    vec![
        ("nothing", size_m, Vec::new()),
        ("one particle", size_m, lattice(&mut rng, DVec3::splat(5.3 * SPACING_M), UVec3::ONE)),
        ("a block in the open", size_m, lattice(&mut rng, DVec3::splat(3.5 * SPACING_M), UVec3::new(9, 7, 5))),
        ("a pool", size_m, lattice(&mut rng, half_m, UVec3::new(17, 8, 13))),
        ("full", size_m, lattice(&mut rng, half_m, UVec3::new(17, 15, 13))),
        ("scattered", size_m, scattered),
        ("all in one point", size_m, vec![Position { position_m: [0.1; 3], tag: 0 }; 100]),
        ("out of part", size_m, parted),
    ]
}

fn taking_part(positions: &[Position]) -> Vec<DVec3> {
    vectors(&positions.iter().copied().filter(|p| p.tag >> 24 == 0).collect::<Vec<_>>())
}

pub(crate) fn mark_blocks_lists_what_its_twin_lists(device: &Device) {
    for (name, size_m, positions) in cases(device) {
        let got = run(device, &positions, &options(size_m));
        let counts = count_bins(&taking_part(&positions), &got.params);
        let class = |block| class_of(block, &counts, &got.params);
        let mut listed = 0;
        for (block, &entry) in got.entries.iter().enumerate() {
            let at = block_at(block, &got.params);
            let expected = is_listed(at, class, &got.params);
            ensure_eq!(entry >= BLOCK_LISTED, expected, "{name}: block {at}");
            ensure!(expected || entry == class(at), "{name}: block {at} is {entry}");
            listed += u32::from(expected);
        }
        ensure_eq!(listed, got.counts.blocks, "{name}");
    }
}

pub(crate) fn what_is_not_listed_has_no_surface(device: &Device) {
    for (name, size_m, positions) in cases(device) {
        let (sparse, options) = (run(device, &positions, &options(size_m)), options(size_m));
        let dense = run(device, &positions, &MarchingCubesOptions { dense: true, ..options });
        ensure_eq!(dense.counts.blocks, dense.params.block_count, "{name}");
        ensure_eq!(sparse.inside, dense.inside, "{name}: the same points are inside");
        ensure_eq!(sparse.counts.triangles, dense.counts.triangles, "{name}");
        ensure_eq!(sparse.counts.vertices, dense.counts.vertices, "{name}");
        ensure!(dense.counts.blocks > sparse.counts.blocks || name == "full", "{name}: something is left out");
    }
}

pub(crate) fn gather_field_matches_its_twin(device: &Device) {
    let mut field = device.worst(GatherField::STAGE, FIELD * ROUNDING);
    for (name, size_m, positions) in cases(device) {
        let options = options(size_m);
        let got = run(device, &positions, &options);
        let particles_m = taking_part(&positions);
        let mut checked = 0;
        for (block, &entry) in got.entries.iter().enumerate() {
            if entry < BLOCK_LISTED {
                continue;
            }
            let at = block_at(block, &got.params).as_uvec3();
            let points = &got.field_m[64 * (entry - BLOCK_LISTED) as usize..][..64];
            for (i, &value_m) in points.iter().enumerate() {
                let local = UVec3::new(i as u32 % 4, i as u32 / 4 % 4, i as u32 / 16);
                let grid_point = at * BLOCK_CELLS + local;
                let is_inside = got.inside[block][i / 32] >> (i % 32) & 1 != 0;
                ensure_eq!(is_inside, value_m > 0.0, "{name}: {grid_point}");
                if is_beyond(grid_point, &got.params) {
                    ensure_eq!(value_m, BEYOND_M, "{name}: {grid_point}");
                    continue;
                }
                let at_m = (min_m(&options) + options.cell_m * grid_point.as_dvec3()).clamp(DVec3::ZERO, size_m);
                let (expected_m, _) = surface_field_in_walls(at_m, &particles_m, SPACING_M, [DVec3::ZERO, size_m]);
                if value_m.abs() == SPACING_M as f32 {
                    // All of the block is so: it is listed for the cells that end at others.
                    ensure_eq!(value_m > 0.0, expected_m > 0.0, "{name}: {grid_point}");
                    continue;
                }
                // Where little is in reach (nothing that near the surface) weights are tiny, and their quotients off.
                let scale_m = if expected_m < -0.3 * SPACING_M { 1e3 * SPACING_M } else { SPACING_M };
                field.check(value_m, expected_m, scale_m).named(name);
                checked += 1;
            }
        }
        ensure!(matches!(name, "nothing" | "full") || checked > 40, "{name}: {checked} points");
    }
    field.report(device);
    let mut worst = Worst::new("fed a wrong field", FIELD * ROUNDING);
    ensure!(worst.check(1e-4, 1.1e-4, SPACING_M).is_err());
}

pub(crate) fn mesh_normals_match_their_twin(device: &Device) {
    let mut normals = device.worst(MeshNormals::STAGE, GRADIENT * ROUNDING);
    for (name, size_m, positions) in cases(device) {
        let got = run(device, &positions, &options(size_m));
        let particles_m = taking_part(&positions);
        let (mut free, mut at_walls) = (0, 0);
        for vertex in &got.vertices {
            let [at_m, normal] = [vertex.position_m, vertex.normal].map(|v| DVec3::from_array(v.map(f64::from)));
            let on_wall = (0..3).find(|&axis| {
                let wall_m = if normal[axis] > 0.0 { size_m[axis] } else { 0.0 };
                normal[axis].abs() == 1.0 && (at_m[axis] - wall_m).abs() < 1e-6 * SPACING_M
            });
            if on_wall.is_some() {
                at_walls += 1;
                continue;
            }
            let inside_m = at_m.clamp(DVec3::ZERO, size_m);
            let (_, gradient) = surface_field_in_walls(inside_m, &particles_m, SPACING_M, [DVec3::ZERO, size_m]);
            // Where two rules meet, a rounding decides which gradient it is; where it is small, its direction is the
            // rounding's.
            if gradient.length() < 0.1 || (normal + gradient.normalize()).length() > 0.1 {
                continue;
            }
            let expected = -gradient.normalize();
            for axis in 0..3 {
                normals.check(vertex.normal[axis], expected[axis], 1.0 / gradient.length().min(1.0)).or_raise();
            }
            free += 1;
        }
        let all = got.vertices.len();
        ensure!(free + at_walls >= all * 9 / 10, "{name}: {free} and {at_walls} of {all}");
        ensure_eq!(at_walls > 0, ["a pool", "full", "scattered"].contains(&name), "{name}: {at_walls} at walls");
    }
    normals.report(device);
    let mut worst = Worst::new("fed a wrong normal", GRADIENT * ROUNDING);
    ensure!(worst.check(0.5, 0.501, 1.0).is_err());
}

pub(crate) fn meshes_are_closed_and_those_of_the_twin(device: &Device) {
    for (name, size_m, positions) in cases(device) {
        let options = options(size_m);
        let got = run(device, &positions, &options);
        let MeshCounts { lost_blocks, lost_vertices, lost_triangles, .. } = got.counts;
        ensure_eq!((lost_blocks, lost_vertices, lost_triangles), (0, 0, 0), "{name}");
        check_closed(&got.triangles).named(name);
        let (values, points) = got.grid_values();
        let grid = FieldGrid { points, min_m: min_m(&options), cell_m: DVec3::splat(options.cell_m), values: &values };
        let expected = marching_cubes(&grid);
        ensure_eq!(got.vertices.len(), expected.vertices_m.len(), "{name}");
        ensure_eq!(got.triangles.len(), expected.triangles.len(), "{name}");
        // The same triangles, whatever the order in which blocks put them.
        let mesh = got.mesh();
        let key = |mesh: &Mesh| -> BTreeSet<[[i64; 3]; 3]> {
            mesh.triangles
                .iter()
                .map(|corners| {
                    let mut at = corners.map(|vertex| {
                        (mesh.vertices_m[vertex as usize] / (1e-3 * SPACING_M)).round().as_i64vec3().to_array()
                    });
                    at.sort_unstable();
                    at
                })
                .collect()
        };
        let (one, other) = (key(&mesh), key(&expected));
        let differ = one.symmetric_difference(&other).count();
        // A coordinate that rounds to another thousandth of a spacing, in one of nine.
        ensure!(differ <= one.len() / 20, "{name}: {differ} of {} triangles stand elsewhere", one.len());
        for vertex in &got.vertices {
            let length = DVec3::from_array(vertex.normal.map(f64::from)).length();
            ensure!((length - 1.0).abs() < 1e-5, "{name}: a normal of length {length}");
        }
        let volume = volume_m3(&mesh) / SPACING_M.powi(3);
        let range = match name {
            "nothing" => 0.0..1e-9,
            // A ball of radius 0.55, cut into cells of half a spacing.
            "one particle" | "all in one point" => 0.2..0.7,
            // Edges are rounded in the open, and are not at walls.
            "a block in the open" => 0.88 * 315.0..315.0,
            "a pool" => 0.98 * 1768.0..1.02 * 1768.0,
            "full" => 0.99 * 3315.0..1.001 * 3315.0,
            _ => 1.0..f64::INFINITY,
        };
        ensure!(range.contains(&volume), "{name}: {volume} spacings cubed");
        note!(
            device,
            "{name}: {} blocks, {} triangles, {volume:.1} spacings cubed",
            got.counts.blocks,
            got.triangles.len()
        );
    }
}

pub(crate) fn random_particles_in_random_boxes_give_closed_meshes(device: &Device) {
    let mut rng = rng(83);
    for case in 0..if device.small() { 3 } else { 12 } {
        let size_m = SPACING_M * DVec3::from_array([0; 3].map(|_| 4.3 + 9.0 * rng.random::<f64>()));
        let has_wall = [0; 3].map(|_| rng.random::<bool>());
        let walls_m = [0.0, f64::INFINITY].map(|far| {
            DVec3::from_array(std::array::from_fn(|axis| match (has_wall[axis], far == 0.0) {
                (true, low) => {
                    if low {
                        0.0
                    } else {
                        size_m[axis]
                    }
                }
                (false, low) => {
                    if low {
                        -f64::INFINITY
                    } else {
                        f64::INFINITY
                    }
                }
            }))
        });
        let positions: Vec<Position> = (0..rng.random_range(0..if device.small() { 60 } else { 600 }))
            .map(|tag| {
                let share = DVec3::new(rng.random(), rng.random(), rng.random());
                Position { position_m: (size_m * share).as_vec3().to_array(), tag }
            })
            .collect();
        let options = MarchingCubesOptions {
            cell_m: SPACING_M * rng.random_range(0.25..1.2),
            wall_bounds_m: walls_m.map(|corner_m| corner_m.to_array()),
            most_blocks: 1 << 14,
            most_vertices: 1 << 18,
            most_triangles: 1 << 19,
            ..options(size_m)
        };
        let name = format!("case {case}: {} particles in {size_m}, cells of {}", positions.len(), options.cell_m);
        let sparse = run(device, &positions, &options);
        ensure_eq!((sparse.counts.lost_blocks, sparse.counts.lost_triangles), (0, 0), "{name}");
        check_closed(&sparse.triangles).named(&name);
        let mesh = sparse.mesh();
        ensure!(positions.is_empty() || volume_m3(&mesh) > 0.0, "{name}");
        let inside_walls = |at_m: &DVec3| {
            let reach = DVec3::splat(1e-4 * SPACING_M);
            at_m.cmpge(walls_m[0] - reach).all() && at_m.cmple(walls_m[1] + reach).all()
        };
        ensure!(mesh.vertices_m.iter().all(inside_walls), "{name}");
        // Particles at random leave hollows that fluid has none of, and bins that are full pass over; all the same the dense
        // mesh is closed too.
        let dense = run(device, &positions, &MarchingCubesOptions { dense: true, ..options });
        check_closed(&dense.triangles).named(format_args!("{name}, dense"));
        if !sparse.triangles.is_empty() {
            ensure!(check_closed(&sparse.triangles[1..]).is_err(), "{name}: a missing triangle is seen");
        }
    }
}

pub(crate) fn normals_point_out_of_the_fluid(device: &Device) {
    let (_, size_m, positions) = cases(device).swap_remove(2);
    let got = run(device, &positions, &options(size_m));
    let middle_m = vectors(&positions).iter().sum::<DVec3>() / positions.len() as f64;
    let outward = |vertex: &&MeshVertex| {
        let [at_m, normal] = [vertex.position_m, vertex.normal].map(|v| DVec3::from_array(v.map(f64::from)));
        normal.dot(at_m - middle_m) > 0.0
    };
    let count = got.vertices.iter().filter(outward).count();
    ensure!(count as f64 > 0.99 * got.vertices.len() as f64, "{count} of {}", got.vertices.len());
}

pub(crate) fn what_finds_no_room_is_counted_and_nothing_is_written_beyond_the_end(device: &Device) {
    let (_, size_m, positions) = cases(device).swap_remove(3);
    let all = run(device, &positions, &options(size_m)).counts;
    let half = |n: u32| n / 2;
    let fewer_triangles = MarchingCubesOptions { most_triangles: half(all.triangles), ..options(size_m) };
    let got = run(device, &positions, &fewer_triangles);
    ensure_eq!(
        (got.counts.triangles, got.counts.lost_triangles),
        (half(all.triangles), all.triangles - half(all.triangles))
    );
    let fewer_vertices = MarchingCubesOptions { most_vertices: half(all.vertices), ..options(size_m) };
    let got = run(device, &positions, &fewer_vertices);
    ensure_eq!(
        (got.counts.vertices, got.counts.lost_vertices),
        (half(all.vertices), all.vertices - half(all.vertices))
    );
    let degenerate = got.triangles.iter().filter(|corners| **corners == [0; 3]).count();
    ensure!(got.counts.lost_triangles > 0 && degenerate as u32 == got.counts.lost_triangles);
    ensure!(got.triangles.iter().flatten().all(|&vertex| vertex < half(all.vertices)));
    let fewer_blocks = MarchingCubesOptions { most_blocks: half(all.blocks), ..options(size_m) };
    let got = run(device, &positions, &fewer_blocks);
    ensure_eq!((got.counts.blocks, got.counts.lost_blocks), (half(all.blocks), all.blocks - half(all.blocks)));
    // Where a block is missing, so are the vertices of its edges.
    ensure!(got.counts.triangles > 0 && got.triangles.iter().flatten().all(|&vertex| vertex < got.counts.vertices));
}

#[cfg(test)]
mod tests {
    use brooklet_reference::surface::marching_cubes_table;
    use brooklet_render::surface::marching_cubes::table::TRIANGLE_TABLE;

    #[test]
    fn the_table_is_the_twin_s() {
        for (inside, words) in TRIANGLE_TABLE.iter().enumerate() {
            let corners = marching_cubes_table::triangles(inside as u8).concat();
            for k in 0..16 {
                let edge = words[k / 8] >> (4 * (k % 8)) & 15;
                assert_eq!(edge, corners.get(k).map_or(15, |&edge| edge.into()), "corner {k} of case {inside}");
            }
        }
    }
}
