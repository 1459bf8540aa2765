//! The meshed surface of ellipsoids against its twin.
//!
//! A kernel's offset is good to a rounding of its coordinate, some 17 spacings; some 200 kernels, none above 0.6, add up
//! to a density of 1: `FIELD` roundings of a spacing.

use crate::compare::{ROUNDING, Worst};
use crate::device::Device;
use crate::wrong::{Named as _, OrRaise as _, ensure};
use brooklet_kernels::{BLOCK_LISTED, Ellipsoid, GatherField, Kernel, MeshNormals, Position};
use brooklet_reference::surface::anisotropic_field::{MeshKernel, anisotropic_field_in_walls};
use brooklet_reference::surface::marching_cubes::check_closed;
use brooklet_reference::surface::mesh_blocks::block_at;
use brooklet_render::surface::marching_cubes::MarchingCubesOptions;

use crate::numbers::rng;
use glam::{DMat3, DVec3, UVec3};
use half::f16;
use rand::{Rng, RngExt};

use super::anisotropy::stretch;
use super::marching_cubes::{SPACING_M, is_beyond, lattice, min_m, options, run_with};

const FIELD: f64 = 120.0;
const NORMAL: f64 = 600.0;

fn halves(low: f64, high: f64) -> u32 {
    u32::from(f16::from_f64(low).to_bits()) | u32::from(f16::from_f64(high).to_bits()) << 16
}

/// Ellipsoids of all sizes and directions, some as narrow as there are, near their particles.
fn ellipsoids(rng: &mut impl Rng, positions: &[Position]) -> Vec<Ellipsoid> {
    positions
        .iter()
        .map(|position| {
            let turn =
                DMat3::from_rotation_x(rng.random_range(0.0..6.0)) * DMat3::from_rotation_z(rng.random_range(0.0..6.0));
            let ratio = rng.random_range(0.25..1.0);
            let size = if rng.random::<f64>() < 0.2 { rng.random_range(0.42..1.0) } else { 1.0 };
            // Alone, it is drawn as a drop of spray is.
            let (size, ratio) = if positions.len() == 1 { (0.42, 1.0) } else { (size, ratio) };
            let axes = DVec3::new(1.0, 1.0, ratio) * size / f64::cbrt(ratio);
            let stretch = turn * DMat3::from_diagonal(axes) * turn.transpose();
            let offset_m = DVec3::from_array([0; 3].map(|_| rng.random_range(-0.1..0.1))) * SPACING_M;
            let center_m = DVec3::from_array(position.position_m.map(f64::from)) + offset_m;
            Ellipsoid {
                center_m: center_m.max(DVec3::splat(1e-4)).as_vec3().to_array(),
                tag: position.tag,
                stretch: [
                    halves(stretch.x_axis.x, stretch.y_axis.y),
                    halves(stretch.z_axis.z, stretch.x_axis.y),
                    halves(stretch.x_axis.z, stretch.y_axis.z),
                ],
                reserved: 0,
            }
        })
        .collect()
}

pub(crate) fn the_mesh_of_ellipsoids_matches_its_twin(device: &Device) {
    let mut rng = rng(87);
    let mut field = device.worst(GatherField::STAGE, FIELD * ROUNDING);
    let mut normals = device.worst(MeshNormals::STAGE, NORMAL * ROUNDING);
    let size_m = SPACING_M * DVec3::new(8.0, 10.0, 9.0);
    let half_m = DVec3::splat(0.5 * SPACING_M);
    let cases = [
        ("nothing", lattice(&mut rng, half_m, UVec3::ZERO)),
        ("one particle", lattice(&mut rng, DVec3::splat(5.3 * SPACING_M), UVec3::ONE)),
        ("a block", lattice(&mut rng, DVec3::splat(2.5 * SPACING_M), UVec3::new(4, 3, 3))),
        ("a pool", lattice(&mut rng, half_m, UVec3::new(8, if device.small() { 2 } else { 3 }, 9))),
    ];
    for (name, positions) in cases {
        let ellipsoids = ellipsoids(&mut rng, &positions);
        let options = MarchingCubesOptions { anisotropic: true, ..options(size_m) };
        let got = run_with(device, &positions, Some(&ellipsoids), &options);
        check_closed(&got.triangles).named(name);
        let kernels: Vec<MeshKernel> = ellipsoids
            .iter()
            .map(|ellipsoid| {
                MeshKernel::new(
                    DVec3::from_array(ellipsoid.center_m.map(f64::from)),
                    DMat3::from_cols_array_2d(&stretch(ellipsoid).map(|column| column.map(f64::from))),
                    SPACING_M,
                )
            })
            .collect();
        let walls_m = [DVec3::ZERO, size_m];
        let mut checked = 0;
        for (block, &entry) in got.entries.iter().enumerate().filter(|(_, entry)| **entry >= BLOCK_LISTED) {
            let first = block_at(block, &got.params).as_uvec3() * 4;
            for i in 0..64 {
                let grid_point = first + UVec3::new(i % 4, i / 4 % 4, i / 16);
                let value_m = got.field_m[(64 * (entry - BLOCK_LISTED) + i) as usize];
                if is_beyond(grid_point, &got.params) || value_m.abs() == SPACING_M as f32 {
                    continue;
                }
                let at_m = (min_m(&options) + options.cell_m * grid_point.as_dvec3()).clamp(DVec3::ZERO, size_m);
                let (expected_m, _) = anisotropic_field_in_walls(at_m, &kernels, SPACING_M, walls_m);
                field.check(value_m, expected_m, SPACING_M).named(name);
                checked += 1;
            }
        }
        for vertex in &got.vertices {
            let [at_m, normal] = [vertex.position_m, vertex.normal].map(|v| DVec3::from_array(v.map(f64::from)));
            let at_wall = (0..3).any(|axis| normal[axis].abs() == 1.0);
            let (_, gradient) =
                anisotropic_field_in_walls(at_m.clamp(DVec3::ZERO, size_m), &kernels, SPACING_M, walls_m);
            if at_wall || gradient.length() < 0.05 {
                continue;
            }
            let expected = -gradient.normalize();
            for axis in 0..3 {
                normals.check(vertex.normal[axis], expected[axis], 1.0 / gradient.length().min(1.0)).or_raise();
            }
        }
        ensure!(name == "nothing" || (checked > 100 && !got.vertices.is_empty()), "{name}: {checked} points");
    }
    field.report(device);
    normals.report(device);
    let mut worst = Worst::new("fed a wrong field", FIELD * ROUNDING);
    ensure!(worst.check(1e-4, 1.1e-4, SPACING_M).is_err());
}
