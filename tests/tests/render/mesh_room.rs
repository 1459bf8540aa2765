//! A mesh whose buffers are too small: what is lost is counted, what is drawn is a part of the whole, nothing is written
//! beyond, and with the room that it asks for it is whole.

use brooklet_fluid::{Slots, visit_slots};
use brooklet_gpu::{Engine, Plan, ResourceId, Resources};
use brooklet_kernels::{MeshCounts, MeshVertex, Position};
use brooklet_reference::surface::marching_cubes::check_closed;
use brooklet_render::surface::marching_cubes::export::{ExportError, HostMesh, check_room, mesh_particles};
use brooklet_render::surface::marching_cubes::{MeshRoom, RefineOptions, is_whole, record};
use brooklet_render::{MarchingCubesOptions, Particles};
use brooklet_tests::{gpu, rng};
use rand::RngExt;

const SPACING_M: f64 = 0.02;
const SIZE_M: f64 = 20.0 * SPACING_M;

/// A ball of fluid, off its lattice by a tenth of the spacing.
fn ball() -> Vec<Position> {
    let mut rng = rng(14);
    let mut positions = Vec::new();
    for cell in 0..12 * 12 * 12 {
        let jitter = [0; 3].map(|_| 0.2 * (rng.random::<f64>() - 0.5));
        let at: [f64; 3] = std::array::from_fn(|axis| f64::from(cell / [1, 12, 144][axis] % 12) + jitter[axis]);
        if at.iter().map(|x| (x - 5.5).powi(2)).sum::<f64>() < 36.0 {
            positions.push(Position { position_m: at.map(|x| (SPACING_M * (4.0 + x)) as f32), tag: 0 });
        }
    }
    positions
}

fn options(count: usize) -> MarchingCubesOptions {
    let walls = [[f64::NEG_INFINITY; 3], [f64::INFINITY; 3]];
    MarchingCubesOptions::for_particles(count, SPACING_M, 0.5 * SPACING_M, [SIZE_M; 3], walls)
}

/// What a frame draws with the room of `options`, and its buffers with all that lies behind their content.
struct Frame {
    counts: MeshCounts,
    mesh: HostMesh,
    behind: Vec<u8>,
}

fn frame(positions: &[Position], options: &MarchingCubesOptions) -> Frame {
    let count = positions.len() as u32;
    let mut resources = Resources::new();
    let mut at = resources.persistent("positions", count);
    let velocities = resources.persistent("velocities", count);
    let mut slots = Slots::declare(&mut resources, count);
    let mut init = resources.recording("init");
    init.upload(&mut slots.state, &[visit_slots(count)]);
    init.upload(&mut at, positions);
    let mut draw = resources.recording("draw");
    let particles = Particles {
        positions: &at,
        velocities: &velocities,
        slots: &slots,
        neighbours: None,
        densities: None,
        diffuse: None,
    };
    let surface = record(&mut resources, (&mut init, &mut draw), (&particles, None), options);
    let wanted = [surface.vertices.id, surface.indices.id, surface.counts.id];
    let ids = [init.id(), draw.id()];
    let plan = Plan::sweep(resources, vec![init, draw], &wanted).expect("a plan");
    let mut engine = Engine::new(&gpu(), plan).expect("an engine");
    engine.run(&ids, &[]).expect("it runs");
    let counts: MeshCounts = engine.read(&surface.counts).expect("counts")[0];
    let mut vertices: Vec<MeshVertex> = engine.read(&surface.vertices).expect("vertices");
    let mut indices: Vec<u32> = engine.read(&surface.indices).expect("indices");
    let behind = [(surface.vertices.id, 32 * vertices.len()), (surface.indices.id, 4 * indices.len())]
        .into_iter()
        .flat_map(|(id, content)| all_of(&engine, id).split_off(content))
        .collect();
    vertices.truncate(counts.vertices as usize);
    indices.truncate(counts.index_count as usize);
    let triangles = indices.as_chunks().0.to_vec();
    Frame { counts, mesh: HostMesh { vertices, triangles, ..HostMesh::default() }, behind }
}

/// A buffer to the end of its memory.
fn all_of(engine: &Engine, id: ResourceId) -> Vec<u8> {
    let from = engine.wgpu_buffer(id).expect("it is in the plan");
    let gpu = engine.gpu();
    let host = gpu.device().create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: from.size(),
        usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    let mut encoder = gpu.device().create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    encoder.copy_buffer_to_buffer(from, 0, &host, 0, from.size());
    gpu.queue().submit([encoder.finish()]);
    host.map_async(wgpu::MapMode::Read, .., |_| ());
    gpu.device().poll(wgpu::PollType::wait_indefinitely()).expect("the copy ends");
    host.slice(..).get_mapped_range().expect("it is mapped").to_vec()
}

/// Roundings differ from frame to frame, as the order of particles within a bin does; numbers do not.
const SAME_M: f64 = 1e-4 * SPACING_M;

/// Whether all of `part`'s vertices are those of `whole` by number, and its triangles are, but for those in one point,
/// which are drawn as nothing.
fn is_part(part: &HostMesh, whole: &HostMesh) -> bool {
    let is_same = |(own, other): (&MeshVertex, &MeshVertex)| {
        (0..3).all(|axis| f64::from(own.position_m[axis] - other.position_m[axis]).abs() < SAME_M)
    };
    let mut triangles = part.triangles.iter().zip(&whole.triangles);
    part.vertices.len() <= whole.vertices.len()
        && part.triangles.len() <= whole.triangles.len()
        && part.vertices.iter().zip(&whole.vertices).all(is_same)
        && triangles.all(|(own, other)| own == other || *own == [0; 3])
}

fn is_same(mesh: &HostMesh, other: &HostMesh) -> bool {
    is_part(mesh, other) && mesh.triangles == other.triangles
}

/// Triangles that are drawn.
fn drawn(mesh: &HostMesh) -> u32 {
    mesh.triangles.iter().filter(|corners| **corners != [0; 3]).count() as u32
}

#[test]
fn too_little_room_draws_a_part_and_the_next_frame_has_it_all() {
    let positions = ball();
    let roomy = options(positions.len());
    let whole = mesh_particles(&gpu(), &positions, &roomy).expect("a mesh");
    check_closed(&whole.triangles).expect("it is closed");
    let needs = MeshRoom {
        blocks: whole.blocks,
        vertices: whole.vertices.len() as u32,
        triangles: whole.triangles.len() as u32,
    };
    // Odd numbers, so that memory is larger than content.
    let [few_vertices, few_triangles] = [(needs.vertices / 2) | 1, (needs.triangles / 3) | 1];
    for small in [
        MeshRoom { vertices: few_vertices, ..needs },
        MeshRoom { triangles: few_triangles, ..needs },
        MeshRoom { vertices: few_vertices, triangles: few_triangles, ..needs },
        MeshRoom { vertices: 1, triangles: 1, ..needs },
    ] {
        let first = frame(&positions, &roomy.with_room(small));
        let counts = &first.counts;
        assert_eq!(counts.vertices + counts.lost_vertices, needs.vertices, "{small:?}");
        assert_eq!((counts.vertices, counts.triangles), (small.vertices, small.triangles), "{small:?}");
        assert!(is_part(&first.mesh, &whole), "{small:?}");
        assert_eq!(drawn(&first.mesh) + counts.lost_triangles, needs.triangles, "{small:?}");
        assert!(!first.behind.is_empty() && first.behind.iter().all(|byte| *byte == 0), "{small:?}");
        // The next frames; one that lacked vertices alone may turn out to lack triangles.
        let mut room = small;
        let mut frames = 0;
        let mut next = first;
        while let Some(needed) = room.needed(&next.counts, 0.25, 1) {
            (room, frames) = (needed, frames + 1);
            next = frame(&positions, &roomy.with_room(room));
        }
        assert!(frames <= 2 && is_whole(&next.counts) && is_same(&next.mesh, &whole), "{small:?}: {frames} frames");
    }
    // A comparison that can fail.
    let mut other = whole.clone();
    other.vertices[needs.vertices as usize / 2].position_m[1] += 2.0 * SAME_M as f32;
    assert!(!is_same(&other, &whole));
    let mut other = whole.clone();
    other.triangles[0].rotate_left(1);
    assert!(!is_part(&other, &whole));
}

#[test]
fn without_a_block_the_rest_is_as_it_was() {
    let positions = ball();
    let roomy = options(positions.len());
    let whole = mesh_particles(&gpu(), &positions, &roomy).expect("a mesh");
    let lost = whole.blocks / 4;
    let small = MeshRoom { blocks: whole.blocks - lost, ..roomy.room() };
    let first = frame(&positions, &roomy.with_room(small));
    assert_eq!((first.counts.blocks, first.counts.lost_blocks), (small.blocks, lost));
    // The mesh has a hole where blocks are missing; what comes before is as it was.
    let same = first.mesh.triangles.iter().zip(&whole.triangles).take_while(|(own, other)| own == other).count();
    assert!(same > whole.triangles.len() / 4, "{same} of {}", whole.triangles.len());
    assert!(drawn(&first.mesh) < drawn(&whole));
    let room = small.needed(&first.counts, 0.25, 1).expect("it lacks some");
    let next = frame(&positions, &roomy.with_room(room));
    assert!(is_whole(&next.counts) && is_same(&next.mesh, &whole));
}

#[test]
fn a_subdivided_mesh_lacks_room_after_that_as_well() {
    let positions = ball();
    let coarse = options(positions.len());
    for parts in [2, 3] {
        let refine = RefineOptions { parts, ..coarse.refine };
        let roomy = MarchingCubesOptions { refine, ..coarse }.with_room(coarse.room());
        let whole = mesh_particles(&gpu(), &positions, &roomy).expect("a mesh");
        check_closed(&whole.triangles).expect("it is closed");
        let needs = [whole.vertices.len() as u32, whole.triangles.len() as u32];
        // Room for the mesh, and too little for what it is subdivided to: of vertices, or of triangles.
        for most in [[needs[0] / 3, needs[1]], [needs[0], needs[1] / 5]] {
            let refine = RefineOptions { most_vertices: most[0], most_triangles: most[1], ..roomy.refine };
            let small = MarchingCubesOptions { refine, ..roomy };
            let Frame { counts, mesh, .. } = frame(&positions, &small);
            assert_eq!([counts.vertices, counts.triangles], most, "{parts} parts");
            assert_eq!(counts.vertices + counts.lost_vertices, needs[0], "{parts} parts");
            assert_eq!(drawn(&mesh) + counts.lost_triangles, needs[1], "{parts} parts");
            assert!(is_part(&mesh, &whole), "{parts} parts");
            let room = small.room().needed(&counts, 0.25, parts).expect("it lacks some");
            let next = frame(&positions, &small.with_room(room));
            assert!(is_whole(&next.counts) && is_same(&next.mesh, &whole), "{parts} parts");
        }
        let least = roomy.with_room(MeshRoom { blocks: 1, vertices: 1, triangles: 1 });
        let grown = mesh_particles(&gpu(), &positions, &least).expect("a mesh");
        assert!((2..=5).contains(&grown.runs) && is_same(&grown, &whole), "{parts} parts: {} runs", grown.runs);
    }
}

#[test]
fn an_export_makes_room_until_nothing_is_lost() {
    let positions = ball();
    let roomy = options(positions.len());
    let whole = mesh_particles(&gpu(), &positions, &roomy).expect("a mesh");
    assert_eq!(whole.runs, 1);
    let least = roomy.with_room(MeshRoom { blocks: 1, vertices: 1, triangles: 1 });
    let grown = mesh_particles(&gpu(), &positions, &least).expect("a mesh");
    assert!((2..=4).contains(&grown.runs), "{} runs", grown.runs);
    assert!(is_same(&grown, &whole));
    check_closed(&grown.triangles).expect("it is closed");
    // The particles fill (4/3) pi 6^3 spacings cubed, but for those at the rim.
    let expected_m3 = positions.len() as f64 * SPACING_M.powi(3);
    assert!((whole.volume_m3() / expected_m3 - 1.0).abs() < 0.03, "{} for {expected_m3}", whole.volume_m3());
    assert!(mesh_particles(&gpu(), &[], &roomy).expect("an empty mesh").triangles.is_empty());
}

#[test]
fn what_fits_is_said_and_fits() {
    let positions = [[0.0_f32; 3], [1000.0; 3]].map(|position_m| Position { position_m, tag: 0 });
    let far = MarchingCubesOptions { domain_size_m: [1000.0; 3], ..options(2) };
    let Err(ExportError::TooFine { fits_m, reason, .. }) = mesh_particles(&gpu(), &positions, &far) else {
        panic!("a box of 10^13 blocks is meshed");
    };
    assert!(reason.contains("blocks"), "{reason}");
    let coarser = |cell_m| MarchingCubesOptions { cell_m, ..far };
    check_room(&gpu(), 2, &coarser(fits_m)).expect("what was said to fit");
    assert!(check_room(&gpu(), 2, &coarser(0.9 * fits_m)).is_err(), "much smaller cells fit as well");

    let roomy = options(positions.len());
    let endless = roomy.with_room(MeshRoom { vertices: 1 << 28, ..roomy.room() });
    let Err(ExportError::TooFine { fits_m, reason, .. }) = check_room(&gpu(), 2, &endless) else {
        // 8 GiB in a binding.
        assert!(gpu().device().limits().max_storage_buffer_binding_size >= 1 << 33);
        return;
    };
    assert!(reason.contains("mesh_vertices") && fits_m > roomy.cell_m, "{reason} {fits_m}");
    let Err(ExportError::TooMany { fits, .. }) = check_room(&gpu(), 1 << 31, &roomy) else {
        panic!("2^31 particles fit");
    };
    check_room(&gpu(), fits as usize, &roomy).expect("as many as were said to fit");
}
