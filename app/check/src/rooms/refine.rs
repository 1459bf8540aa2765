//! `surface/refine/` against its twins: smoothed normals, and subdivided meshes whose triangles are exactly the twin's.
//!
//! Which vertices an edge has, and where they stand in the buffers, is decided by integers: exact. A vertex on an edge is
//! a sum of four points, each good to some four roundings: `POSITION`, over the largest coordinate; its normal is that of
//! sums that are no shorter than a quarter of their terms: `NORMAL`. Smoothing takes a mean of some 7 normals, whose
//! weights are good to 16 roundings (an exponential, of differences of normals over 0.25): `SMOOTHED` for each time.

use crate::bench::Bench;
use crate::compare::{ROUNDING, check_exact, report_exact, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{Named as _, OrRaise as _, ensure, ensure_eq, note};
use brooklet_kernels::{Kernel, MeshCounts, MeshVertex, SmoothNormals, SubdivideEdges, SubdivideTriangles};
use brooklet_reference::surface::marching_cubes::{FieldGrid, Mesh, check_closed, marching_cubes};
use brooklet_reference::surface::smooth_normals::{rings, smooth_normals};
use brooklet_reference::surface::subdivide::{NormalMesh, subdivide};
use brooklet_reference::surface::surface_field::surface_field;
use brooklet_render::surface::marching_cubes::refine::{self, RefineOptions, TriangleMesh};
use glam::DVec3;
use rand::seq::SliceRandom;
use rand::{Rng, RngExt};

use super::marching_cubes as meshed;
use brooklet_render::surface::MarchingCubesOptions;

const POSITION: f64 = 16.0;
const NORMAL: f64 = 24.0;
const SMOOTHED: f64 = 16.0;
/// Standard deviations of the smoothing's weight: over the distance, and over the difference of normals.
const DISTANCE_M: f64 = 0.02;
const DIFFERENCE: f64 = 0.25;

fn options(smooth_normals: u32, parts: u32) -> RefineOptions {
    RefineOptions { smooth_normals, parts, distance_m: DISTANCE_M, most_vertices: 1 << 17, most_triangles: 1 << 18 }
}

/// What the GPU made of a mesh.
struct Refined {
    counts: MeshCounts,
    vertices: Vec<MeshVertex>,
    triangles: Vec<[u32; 3]>,
}

fn run(device: &Device, mesh: &NormalMesh, options: &RefineOptions) -> Refined {
    let vertices: Vec<MeshVertex> = (mesh.mesh.vertices_m.iter().zip(&mesh.normals))
        .map(|(at_m, normal)| MeshVertex {
            position_m: at_m.as_vec3().to_array(),
            normal: normal.as_vec3().to_array(),
            ..MeshVertex::default()
        })
        .collect();
    let counts = MeshCounts {
        index_count: 3 * mesh.mesh.triangles.len() as u32,
        instance_count: 1,
        vertices: vertices.len() as u32,
        triangles: mesh.mesh.triangles.len() as u32,
        lost_triangles: mesh.mesh.triangles.iter().filter(|corners| **corners == [0; 3]).count() as u32,
        ..MeshCounts::default()
    };
    let mut bench = Bench::new(device);
    let coarse = TriangleMesh {
        vertices: bench.input("vertices", &vertices),
        indices: bench.input("indices", mesh.mesh.triangles.as_flattened()),
        counts: bench.input("counts", &[counts]),
    };
    let refined = bench
        .record_with_init(|resources, init, recording| refine::record(resources, (init, recording), coarse, options));
    bench.want(&refined.vertices);
    bench.want(&refined.indices);
    bench.want(&refined.counts);
    let mut done = bench.run();
    let counts: MeshCounts = done.read(&refined.counts, 1)[0];
    let indices: Vec<u32> = done.read(&refined.indices, counts.index_count as usize);
    Refined {
        counts,
        vertices: done.read(&refined.vertices, counts.vertices as usize),
        triangles: indices.chunks(3).map(|corners| [corners[0], corners[1], corners[2]]).collect(),
    }
}

/// A mesh whose numbers are f32's, as the GPU gets them.
fn rounded(mesh: Mesh, normals: impl Iterator<Item = DVec3>) -> NormalMesh {
    let to_f32 = |v: DVec3| v.as_vec3().as_dvec3();
    let vertices_m = mesh.vertices_m.into_iter().map(to_f32).collect();
    NormalMesh { mesh: Mesh { vertices_m, ..mesh }, normals: normals.map(to_f32).collect() }
}

/// Two points over and under a ring of `around` others, numbered at random: as many vertices and two more.
fn bipyramid(rng: &mut impl Rng, around: u32) -> NormalMesh {
    let mut number: Vec<u32> = (0..around + 2).collect();
    number.shuffle(rng);
    let mut vertices_m = vec![DVec3::ZERO; number.len()];
    for i in 0..around {
        let angle = std::f64::consts::TAU * f64::from(i) / f64::from(around);
        vertices_m[number[i as usize] as usize] = 0.1 * DVec3::new(angle.cos(), 0.0, -angle.sin());
    }
    let [top, bottom] = [number[around as usize], number[around as usize + 1]];
    vertices_m[top as usize] = DVec3::Y * 0.1;
    vertices_m[bottom as usize] = DVec3::NEG_Y * 0.1;
    let side = |i: u32| [number[i as usize], number[((i + 1) % around) as usize]];
    let mut triangles: Vec<[u32; 3]> = (0..around).map(|i| [side(i)[0], side(i)[1], top]).collect();
    triangles.extend((0..around).map(|i| [side(i)[1], side(i)[0], bottom]));
    triangles.shuffle(rng);
    let normals: Vec<DVec3> = vertices_m.iter().map(|at_m| at_m.normalize()).collect();
    rounded(Mesh { vertices_m, triangles }, normals.into_iter())
}

/// A field's mesh over `count` points along each axis.
fn mesh_of(count: usize, cell_m: f64, min_m: DVec3, mut field: impl FnMut(DVec3) -> f64) -> Mesh {
    let mut values = Vec::new();
    for i in 0..count.pow(3) {
        let at = [i % count, i / count % count, i / count / count];
        values.push(field(min_m + cell_m * DVec3::from_array(at.map(|k| k as f64))));
    }
    marching_cubes(&FieldGrid { points: [count; 3], min_m, cell_m: DVec3::splat(cell_m), values: &values })
}

/// A ball of radius 0.1 m with wavering normals.
fn ball(rng: &mut impl Rng, cell_m: f64) -> NormalMesh {
    let count = (0.25 / cell_m).ceil() as usize;
    let mesh = mesh_of(count, cell_m, DVec3::splat(-0.123), |at_m| 0.1 - at_m.length());
    let waver = |at_m: &DVec3| {
        let off = DVec3::from_array([0; 3].map(|_| 0.4 * (rng.random::<f64>() - 0.5)));
        (at_m.normalize() + off).normalize()
    };
    let normals: Vec<DVec3> = mesh.vertices_m.iter().map(waver).collect();
    rounded(mesh, normals.into_iter())
}

/// Noise, in which every case of a cell is met.
fn noise(rng: &mut impl Rng) -> NormalMesh {
    const COUNT: i64 = 16;
    let mut at = 0;
    let mesh = mesh_of(COUNT as usize, 0.01, DVec3::ZERO, |_| {
        let place = [at % COUNT, at / COUNT % COUNT, at / COUNT / COUNT];
        at += 1;
        if place.iter().any(|k| *k == 0 || *k == COUNT - 1) { -1.0 } else { 0.5 - rng.random::<f64>() }
    });
    let normals: Vec<DVec3> = mesh.vertices_m.iter().map(|at_m| (*at_m - 0.08).normalize_or(DVec3::X)).collect();
    rounded(mesh, normals.into_iter())
}

/// Closed meshes of sizes past every group's edge, and of more vertices than a group scans.
fn cases(device: &Device) -> Vec<(String, NormalMesh)> {
    let mut rng = rng(83);
    let mut cases = vec![("nothing".to_owned(), NormalMesh::default())];
    let around: &[u32] = if device.small() { &[3, 32] } else { &[3, 31, 32, 33, 61, 62, 63, 509] };
    for &around in around {
        cases.push((format!("{} vertices", around + 2), bipyramid(&mut rng, around)));
    }
    cases.push(("a ball".into(), ball(&mut rng, 0.01)));
    cases.push(("noise".into(), noise(&mut rng)));
    cases
}

pub(crate) fn smooth_normals_matches_its_twin(device: &Device) {
    for times in [1, 3] {
        let mut worst = device.worst(SmoothNormals::STAGE, f64::from(times) * SMOOTHED * ROUNDING);
        for (name, mesh) in cases(device) {
            let got = run(device, &mesh, &options(times, 1));
            let rings = rings(mesh.normals.len(), &mesh.mesh.triangles);
            let mut expected = mesh.normals.clone();
            for _ in 0..times {
                expected = smooth_normals(&mesh.mesh.vertices_m, &expected, &rings, [DISTANCE_M, DIFFERENCE]);
            }
            ensure_eq!(got.vertices.len(), expected.len());
            for (i, vertex) in got.vertices.iter().enumerate() {
                worst.check3(vertex.normal, expected[i], 1.0).named(format_args!("{name}, vertex {i}"));
                ensure_eq!(vertex.position_m, mesh.mesh.vertices_m[i].as_vec3().to_array(), "{name}: it stays there");
            }
            check_exact(got.triangles.as_flattened(), mesh.mesh.triangles.as_flattened()).or_raise();
        }
        worst.report(device);
        ensure!(worst.check3([0.0, 1.0, 0.0], DVec3::new(1e-4, 1.0, 0.0), 1.0).is_err());
    }
}

pub(crate) fn subdivided_meshes_are_the_twin_s_and_closed(device: &Device) {
    let mut positions = device.worst(SubdivideEdges::STAGE, POSITION * ROUNDING);
    let mut normals = device.worst("subdivide_edges, normals", NORMAL * ROUNDING);
    let mut exact = 0;
    for (name, mesh) in cases(device) {
        for parts in [2, 3] {
            let got = run(device, &mesh, &options(0, parts));
            let expected = subdivide(&mesh, parts);
            check_exact(got.triangles.as_flattened(), expected.mesh.triangles.as_flattened())
                .named(format_args!("{name}, {parts} parts"));
            check_closed(&got.triangles).named(format_args!("{name}, {parts} parts"));
            exact += got.triangles.len();
            let counts = MeshCounts {
                index_count: 3 * got.triangles.len() as u32,
                instance_count: 1,
                vertices: expected.normals.len() as u32,
                triangles: expected.mesh.triangles.len() as u32,
                ..MeshCounts::default()
            };
            ensure_eq!(got.counts, counts, "{name}, {parts} parts");
            let scale_m = mesh.mesh.vertices_m.iter().map(|at_m| at_m.abs().max_element()).fold(0.0, f64::max);
            for (i, vertex) in got.vertices.iter().enumerate() {
                positions.check3(vertex.position_m, expected.mesh.vertices_m[i], scale_m).or_raise();
                // In noise a mirrored mean may be next to nothing, and its direction a rounding's.
                if name != "noise" {
                    normals.check3(vertex.normal, expected.normals[i], 1.0).or_raise();
                }
            }
            let again = run(device, &mesh, &options(0, parts));
            let bits = |refined: &Refined| -> Vec<u32> {
                refined.vertices.iter().flat_map(|v| [v.position_m, v.normal].concat()).map(f32::to_bits).collect()
            };
            check_exact(&bits(&again), &bits(&got)).named(format_args!("{name}: another run"));
        }
    }
    positions.report(device);
    normals.report(device);
    report_exact(device, SubdivideTriangles::STAGE, exact);
    ensure!(positions.check3([0.1; 3], DVec3::splat(0.1001), 0.1).is_err());
}

pub(crate) fn meshed_particles_stay_closed(device: &Device) {
    for (i, (name, size_m, particles)) in meshed::cases(device).into_iter().enumerate() {
        let parts = 2 + i as u32 % 2;
        let coarse = meshed::options(size_m);
        let refine = RefineOptions { smooth_normals: 1, parts, ..coarse.refine };
        let got = meshed::run(device, &particles, &MarchingCubesOptions { refine, ..coarse });
        ensure_eq!((got.counts.lost_blocks, got.counts.lost_triangles), (0, 0), "{name}");
        check_closed(&got.triangles).named(format_args!("{name}, {parts} parts"));
        ensure!(got.triangles.len().is_multiple_of(parts.pow(2) as usize), "{name}");
        ensure!(got.triangles.is_empty() == particles.is_empty(), "{name}");
    }
}

pub(crate) fn what_finds_no_room_is_counted_and_nothing_is_written_beyond_the_end(device: &Device) {
    let mesh = ball(&mut rng(84), 0.01);
    for parts in [2, 3] {
        let all = run(device, &mesh, &options(0, parts));
        let expected = subdivide(&mesh, parts).mesh.triangles;
        for (most_vertices, most_triangles) in [
            (all.counts.vertices / 2, all.counts.triangles),
            (all.counts.vertices, all.counts.triangles / 2 + 1),
            (mesh.normals.len() as u32 / 2, all.counts.triangles),
        ] {
            let got = run(device, &mesh, &RefineOptions { most_vertices, most_triangles, ..options(0, parts) });
            let has_place =
                |i: usize| (i as u32) < most_triangles && expected[i].iter().all(|&vertex| vertex < most_vertices);
            let wanted: Vec<[u32; 3]> =
                (0..got.triangles.len()).map(|i| if has_place(i) { expected[i] } else { [0; 3] }).collect();
            check_exact(got.triangles.as_flattened(), wanted.as_flattened()).or_raise();
            let lost = (0..expected.len()).filter(|&i| !has_place(i)).count();
            ensure_eq!(got.counts.lost_triangles as usize, lost);
            ensure!(lost > 0);
            ensure_eq!([got.counts.vertices, got.counts.triangles], [most_vertices, most_triangles]);
            ensure_eq!(got.counts.lost_vertices, all.counts.vertices - most_vertices);
        }
        // Of triangles that were lost before each part counts, and so do those of neighbours that do not find an edge.
        let mut torn = mesh.clone();
        (0..torn.mesh.triangles.len()).step_by(7).for_each(|i| torn.mesh.triangles[i] = [0; 3]);
        let got = run(device, &torn, &options(0, parts));
        let degenerate = got.triangles.iter().filter(|corners| **corners == [0; 3]).count();
        let before = torn.mesh.triangles.iter().filter(|corners| **corners == [0; 3]).count() * parts.pow(2) as usize;
        ensure!(got.counts.lost_triangles as usize == degenerate && degenerate > before, "{degenerate}, {before}");
        ensure!(got.triangles.iter().flatten().all(|&vertex| vertex < got.counts.vertices));
    }
}

/// A body of particles 2 cm apart, jittered, meshed by the twins: its mesh and the field's normals.
fn body(rng: &mut impl Rng, is_inside: impl Fn(DVec3) -> bool) -> NormalMesh {
    const SPACING_M: f64 = 0.02;
    let mut particles_m = Vec::new();
    for i in 0..16_i32.pow(3) {
        let at = DVec3::from_array([i % 16, i / 16 % 16, i / 256].map(|k| f64::from(k) - 7.5)) * SPACING_M;
        if is_inside(at) {
            let jitter = DVec3::from_array([0; 3].map(|_| 0.2 * (rng.random::<f64>() - 0.5)));
            particles_m.push(at + SPACING_M * jitter);
        }
    }
    let field = |at_m: DVec3| surface_field(at_m, particles_m.iter().copied(), SPACING_M);
    let mesh = mesh_of(32, 0.5 * SPACING_M, DVec3::splat(-0.1571), |at_m| field(at_m).0);
    let normals: Vec<DVec3> = mesh.vertices_m.iter().map(|at_m| -field(*at_m).1.normalize_or(DVec3::NEG_Y)).collect();
    rounded(mesh, normals.into_iter())
}

pub(crate) fn smoothing_lowers_the_error_of_normals_and_keeps_edges(device: &Device) {
    let mut rng = rng(85);
    // The mean angle to the known normals, degrees, where one is known.
    let error = |mesh: &NormalMesh, times: u32, exact: &dyn Fn(DVec3) -> Option<DVec3>| {
        let got = run(device, mesh, &options(times, 1));
        let angles: Vec<f64> = got
            .vertices
            .iter()
            .filter_map(|v| Some(vector(v.normal).angle_between(exact(vector(v.position_m))?).to_degrees()))
            .collect();
        angles.iter().sum::<f64>() / angles.len() as f64
    };
    let ball = body(&mut rng, |at_m| at_m.length() < 0.11);
    let radial = |at_m: DVec3| Some(at_m.normalize());
    let [before, after] = [0, 4].map(|times| error(&ball, times, &radial));
    ensure!(after < 0.75 * before, "{after:.2} degrees of {before:.2}");
    let block = body(&mut rng, |at_m| at_m.abs().max_element() < 0.1);
    // Of the sides' middles, and of what is within a spacing and a half of an edge.
    let side = |at_m: DVec3, of_edges: bool| {
        let mut by_size = [at_m.x.abs(), at_m.y.abs(), at_m.z.abs()];
        by_size.sort_by(f64::total_cmp);
        let axis = (0..3).find(|&axis| at_m[axis].abs() == by_size[2])?;
        let mut normal = DVec3::ZERO;
        normal[axis] = at_m[axis].signum();
        ((by_size[1] > 0.07) == of_edges).then_some(normal)
    };
    let [before, after] = [0, 4].map(|times| error(&block, times, &|at_m| side(at_m, false)));
    ensure!(after < 0.75 * before, "sides: {after:.2} degrees of {before:.2}");
    let [edges_before, edges_after] = [0, 4].map(|times| error(&block, times, &|at_m| side(at_m, true)));
    ensure!(edges_after < 1.05 * edges_before, "edges: {edges_after:.2} degrees of {edges_before:.2}");
    note!(device, "sides {before:.2} to {after:.2}, edges {edges_before:.2} to {edges_after:.2} degrees");
}

pub(crate) fn subdivision_is_nearer_to_a_ball_than_midpoints(device: &Device) {
    let mut mesh = ball(&mut rng(86), 0.02);
    // On the ball exactly: what is off is then subdivision's.
    mesh.mesh.vertices_m.iter_mut().for_each(|at_m| *at_m = 0.1 * at_m.normalize());
    mesh.normals = mesh.mesh.vertices_m.iter().map(|at_m| at_m.normalize()).collect();
    let off_m = |at_m: DVec3| (at_m.length() - 0.1).abs();
    let got = run(device, &mesh, &options(0, 2));
    let new = &got.vertices[mesh.normals.len()..];
    let mean_m = new.iter().map(|v| off_m(vector(v.position_m))).sum::<f64>() / new.len() as f64;
    let at_m = |vertex: u32| mesh.mesh.vertices_m[vertex as usize];
    let midpoints = mesh.mesh.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let chords: Vec<f64> = midpoints.map(|[a, b]| off_m(0.5 * (at_m(a) + at_m(b)))).collect();
    let chord_m = chords.iter().sum::<f64>() / chords.len() as f64;
    ensure!(mean_m < 0.1 * chord_m, "{mean_m:.2e} m of {chord_m:.2e} m");
    note!(device, "mean distance of new vertices {mean_m:.2e} m, of midpoints {chord_m:.2e} m");
}
