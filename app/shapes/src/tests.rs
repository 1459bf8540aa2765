//! Meshes, fields and files against brute force and closed forms.

use fastrand::Rng;
use glam::DVec3;

use crate::{Bvh, Field, FieldOptions, Flaw, Heights, Mesh, checked, hull, nearest_on_triangle, plane_share, terrain};

pub fn cuboid(half_m: DVec3) -> Mesh {
    let corners: Vec<DVec3> = (0..8)
        .map(|k| half_m * DVec3::from_array([0, 1, 2].map(|axis| if k >> axis & 1 == 1 { 1.0 } else { -1.0 })))
        .collect();
    hull(&corners).unwrap()
}

/// A ball's surface, closed, of about `2 * around * around` triangles.
pub fn ball(radius_m: f64, around: usize) -> Mesh {
    let mut mesh = Mesh::default();
    for ring in 0..=around {
        let (sine, cosine) = (std::f64::consts::PI * ring as f64 / around as f64).sin_cos();
        for k in 0..2 * around {
            let turn = std::f64::consts::PI * k as f64 / around as f64;
            mesh.positions_m.push(radius_m * DVec3::new(sine * turn.cos(), cosine, sine * turn.sin()));
        }
    }
    let at = |ring: usize, k: usize| (ring * 2 * around + k % (2 * around)) as u32;
    for (ring, k) in (0..around).flat_map(|ring| (0..2 * around).map(move |k| (ring, k))) {
        let [a, b, c, d] = [at(ring, k), at(ring, k + 1), at(ring + 1, k), at(ring + 1, k + 1)];
        mesh.triangles.extend([[a, b, c], [b, d, c]]);
    }
    mesh
}

fn hills() -> Mesh {
    let heights_m = (0..21 * 17).map(|k| 0.1 + 0.05 * ((k % 21) as f64 * 0.7).sin() + 0.04 * ((k / 21) as f64 * 0.9).cos());
    let heights = Heights { columns: 21, rows: 17, heights_m: heights_m.collect() };
    terrain(&heights, [1.0, 0.8], 0.1, -0.1)
}

fn shapes() -> [(&'static str, Mesh); 4] {
    let mut rng = Rng::with_seed(3);
    let mut one = || rng.f64() - 0.5;
    let points: Vec<DVec3> = (0..40).map(|_| DVec3::new(one(), 0.6 * one(), one())).collect();
    [("box", cuboid(DVec3::new(0.3, 0.2, 0.1))), ("ball", ball(0.3, 16)), ("hull", hull(&points).unwrap()), ("hills", hills())]
        .map(|(name, mesh)| (name, checked(mesh, false).unwrap().0))
}

/// The distance from a place by all triangles, negative where their solid angles add up to a whole turn.
fn brute_force_m(mesh: &Mesh, place_m: DVec3) -> f64 {
    let (mut away_m, mut turns) = (f64::INFINITY, 0.0);
    for triangle in 0..mesh.triangles.len() {
        let corners_m = mesh.corners_m(triangle);
        away_m = away_m.min(nearest_on_triangle(place_m, corners_m).distance(place_m));
        let [a, b, c] = corners_m.map(|corner_m| (corner_m - place_m).normalize());
        let above = a.dot(b.cross(c));
        turns += above.atan2(1.0 + a.dot(b) + b.dot(c) + c.dot(a)) / std::f64::consts::TAU;
    }
    if turns > 0.5 { -away_m } else { away_m }
}

fn places(mesh: &Mesh, count: usize, beyond_m: f64) -> Vec<DVec3> {
    let [low_m, high_m] = mesh.bounds_m();
    let mut rng = Rng::with_seed(7);
    let mut one = || rng.f64();
    (0..count)
        .map(|_| low_m - beyond_m + DVec3::new(one(), one(), one()) * (high_m - low_m + 2.0 * beyond_m))
        .collect()
}

/// The nearest point of a triangle is nearer than any on a lattice over it, and on it.
#[test]
fn the_nearest_point_of_a_triangle_is_the_nearest() {
    let mut rng = Rng::with_seed(1);
    let mut one = || 2.0 * rng.f64() - 1.0;
    for number in 0..400 {
        let mut corners = [(); 3].map(|()| DVec3::new(one(), one(), one()));
        if number % 5 == 0 {
            // Without an area.
            corners[2] = corners[0].lerp(corners[1], 1.7);
        }
        let place = 2.0 * DVec3::new(one(), one(), one());
        let [a, b, c] = corners;
        let nearest = nearest_on_triangle(place, corners);
        let mut least = f64::INFINITY;
        for i in 0..=40 {
            for j in 0..=40 - i {
                let (u, v) = (f64::from(i) / 40.0, f64::from(j) / 40.0);
                least = least.min((a + (b - a) * u + (c - a) * v).distance(place));
            }
        }
        let away = nearest.distance(place);
        assert!(away <= least + 1e-12 && away > least - 0.1, "{away} and {least}");
    }
}

#[test]
fn fields_know_at_their_nodes_what_all_triangles_say() {
    for (name, mesh) in shapes() {
        let options = FieldOptions { cell_m: 0.04, support_m: Some(0.16), sheet_m: None };
        let field = Field::new(&mesh, &options);
        let mut worst = 0.0_f64;
        for index in (0..field.values.len()).step_by(7) {
            let [x, y, z] = field.nodes.map(|side| side as usize);
            let at = DVec3::new((index % x) as f64, (index / x % y) as f64, (index / (x * y)) as f64);
            assert!(index < x * y * z);
            let expected_m = brute_force_m(&mesh, field.min_m + at * field.cell_m);
            worst = worst.max((f64::from(field.values[index][0]) - expected_m).abs());
        }
        assert!(worst < 1e-7, "{name}: off by {worst}");
        // The comparator: a mesh a millimetre larger.
        let wrong = mesh.clone().scaled(1.005);
        let away_m = (brute_force_m(&wrong, field.min_m) - f64::from(field.values[0][0])).abs();
        assert!(away_m > 1e-4, "{name}");
    }
}

/// Between nodes: never more than half a cell's diagonal over the true distance, and what is stated of edges and faces.
#[test]
fn between_nodes_fields_are_off_by_no_more_than_is_said() {
    let cell_m = 0.02;
    for (name, mesh, most) in shapes().map(|(name, mesh)| (name, mesh, if name == "ball" { 0.1 } else { 0.46 })) {
        let field = Field::new(&mesh, &FieldOptions { cell_m, support_m: None, sheet_m: None });
        let (mut over, mut under) = (0.0_f64, 0.0_f64);
        for place_m in places(&mesh, 3000, 0.1) {
            let (got_m, expected_m) = (field.distance_m(place_m), brute_force_m(&mesh, place_m));
            if expected_m.abs() > 3.0 * cell_m {
                continue;
            }
            over = over.max((got_m - expected_m) / cell_m);
            under = under.max((expected_m - got_m) / cell_m);
        }
        println!("{name}: {over:.3} of a cell over, {under:.3} under");
        assert!(over < most && over < 0.867, "{name}: {over} of a cell over the distance");
        assert!(under < 0.867, "{name}: {under} of a cell under the distance");
    }
    let flat = cuboid(DVec3::new(1.0, 0.2, 1.0));
    let field = Field::new(&flat, &FieldOptions { cell_m: 0.03, support_m: None, sheet_m: None });
    for place_m in places(&flat, 300, 0.0) {
        let above_m = DVec3::new(0.6 * place_m.x, 0.23 + 0.1 * place_m.y, 0.6 * place_m.z);
        assert!((field.distance_m(above_m) - (above_m.y - 0.2)).abs() < 1e-7);
    }
}

/// How much of the kernel of radius 1 around a place lies in a mesh, by a sum over places.
fn integral(tree: &Bvh, place: DVec3) -> f64 {
    const POINTS: i32 = 32;
    let (mut inside, mut all) = (0.0, 0.0);
    let at = |k: i32| (f64::from(k) + 0.5) / f64::from(POINTS) * 2.0 - 1.0;
    for x in 0..POINTS {
        for y in 0..POINTS {
            for z in 0..POINTS {
                let q = DVec3::new(at(x), at(y), at(z));
                let t = (1.0 - q.length()).max(0.0);
                let weight = t.powi(4) * (1.0 + 4.0 * q.length());
                all += weight;
                inside += if weight > 0.0 && tree.winding(place + q) > 0.5 { weight } else { 0.0 };
            }
        }
    }
    inside / all
}

/// Lengths are in supports: cells of a quarter, as half a spacing is.
#[test]
fn shares_of_the_kernel_are_close_to_their_integrals() {
    let turned = |mesh: Mesh| {
        let turn = glam::DQuat::from_euler(glam::EulerRot::XYZ, 0.4, 0.9, 0.2);
        Mesh { positions_m: mesh.positions_m.iter().map(|&at| turn * at).collect(), ..mesh }
    };
    let cases = [
        ("box", turned(cuboid(DVec3::new(1.0, 0.5, 2.0))), 0.02),
        ("ball of a support", ball(1.0, 24), 0.01),
        ("wall of half a spacing", turned(cuboid(DVec3::new(1.5, 0.125, 1.5))), 0.02),
    ];
    for (name, mesh, tolerance) in cases {
        let field = Field::new(&mesh, &FieldOptions { cell_m: 0.25, support_m: Some(1.0), sheet_m: None });
        let tree = Bvh::new(&mesh);
        let [x, y, _] = field.nodes.map(|side| side as usize);
        let mut worst = (0.0_f64, 0.0);
        let mut compared = 0;
        for index in (0..field.values.len()).step_by(11) {
            let [away, plane] = field.values[index].map(f64::from);
            // Where particles may be.
            if !(0.25..0.9).contains(&away) {
                continue;
            }
            let at = DVec3::new((index % x) as f64, (index / x % y) as f64, (index / (x * y)) as f64);
            let expected = integral(&tree, field.min_m + at * field.cell_m);
            let off = plane_share(plane) - expected;
            worst = if off.abs() > worst.0 { (off.abs(), away) } else { worst };
            compared += 1;
        }
        println!("{name}: off by {:.4} at {:.2}, of {compared} nodes", worst.0, worst.1);
        assert!(compared > 20 && worst.0 < tolerance, "{name}: off by {worst:?}");
    }
    // Beside a face it is the face's own distance.
    let field = Field::new(&cuboid(DVec3::new(4.0, 1.0, 4.0)), &FieldOptions { cell_m: 0.25, support_m: Some(1.0), sheet_m: None });
    let [x, y, z] = field.nodes.map(|side| side as usize);
    for row in 0..y {
        let [away, plane] = field.values[x / 2 + x * (row + y * (z / 2))].map(f64::from);
        assert!((away - plane).abs() < 1e-5, "{away} and {plane}");
    }
}

#[test]
fn meshes_are_repaired_or_refused() {
    let good = cuboid(DVec3::ONE);
    assert_eq!(checked(good.clone(), false).unwrap().1.said(), None);
    let mut inverted = good.clone();
    inverted.flip();
    let (mended, repairs) = checked(inverted, false).unwrap();
    assert!(repairs.inverted && (mended.volume_m3() - 8.0).abs() < 1e-12);
    let mut twisted = good.clone();
    twisted.triangles[3].swap(0, 1);
    let (mended, repairs) = checked(twisted, false).unwrap();
    assert!(repairs.turned == 1 && (mended.volume_m3() - 8.0).abs() < 1e-12, "{repairs:?}");
    let mut open = good.clone();
    open.triangles.pop();
    assert!(matches!(checked(open.clone(), false), Err(Flaw::Open { edges: 3, .. })));
    assert!(checked(open, true).is_ok());
    assert_eq!(checked(Mesh::default(), false), Err(Flaw::Empty));
    let mut nowhere = good.clone();
    nowhere.positions_m[2].y = f64::NAN;
    assert!(matches!(checked(nowhere, false), Err(Flaw::NoPlace { corner: 2, .. })));
    let mut short = good.clone();
    short.triangles[1][2] = 99;
    assert_eq!(checked(short, false), Err(Flaw::NoCorner { triangle: 1, corner: 99, corners: 8 }));
    let flat = Mesh { positions_m: vec![DVec3::ZERO, DVec3::X, DVec3::X * 2.0], triangles: vec![[0, 1, 2]] };
    assert_eq!(checked(flat, true), Err(Flaw::Flat(1)));
    // Each corner three times, as a file has one with three normals, and a triangle of one line.
    let mut split = Mesh::default();
    for triangle in 0..good.triangles.len() {
        let first = split.positions_m.len() as u32;
        split.positions_m.extend(good.corners_m(triangle));
        split.triangles.push([first, first + 1, first + 2]);
    }
    split.triangles.push([0, 0, 1]);
    let (mended, repairs) = checked(split, false).unwrap();
    assert_eq!((mended.positions_m.len(), repairs.degenerate), (8, 1));
    // A strip with half a turn has one side.
    let strip: Vec<DVec3> = (0..24)
        .flat_map(|k| {
            let turn = std::f64::consts::TAU * f64::from(k) / 24.0;
            let out = DVec3::new(turn.cos(), 0.0, turn.sin());
            let across = 0.3 * (out * (0.5 * turn).cos() + DVec3::Y * (0.5 * turn).sin());
            [out - across, out + across]
        })
        .collect();
    let triangles: Vec<[u32; 3]> = (0..24_u32)
        .flat_map(|k| {
            let next = if k == 23 { [1, 0] } else { [2 * k + 2, 2 * k + 3] };
            [[2 * k, 2 * k + 1, next[0]], [2 * k + 1, next[1], next[0]]]
        })
        .collect();
    assert!(matches!(checked(Mesh { positions_m: strip, triangles }, false), Err(Flaw::Open { .. })));
}

/// Overlapping pieces are one solid, and a ball in a ball that faces inward is a cavity.
#[test]
fn pieces_may_overlap_and_be_hollow() {
    let mut two = ball(0.3, 12);
    let corners = two.positions_m.len() as u32;
    let other = ball(0.3, 12);
    two.positions_m.extend(other.positions_m.iter().map(|&at_m| at_m + DVec3::X * 0.25));
    two.triangles.extend(other.triangles.iter().map(|triangle| triangle.map(|corner| corner + corners)));
    let (two, _) = checked(two, false).unwrap();
    let options = FieldOptions { cell_m: 0.03, support_m: None, sheet_m: None };
    assert!(Field::new(&two, &options).distance_m(DVec3::X * 0.125) < 0.0);
    let mut hollow = ball(0.3, 12);
    let mut inner = ball(0.2, 12);
    inner.flip();
    let corners = hollow.positions_m.len() as u32;
    hollow.positions_m.extend(inner.positions_m);
    hollow.triangles.extend(inner.triangles.iter().map(|triangle| triangle.map(|corner| corner + corners)));
    let (hollow, repairs) = checked(hollow, false).unwrap();
    assert!(!repairs.inverted && repairs.turned == 0, "{repairs:?}");
    let field = Field::new(&hollow, &options);
    assert!(field.distance_m(DVec3::ZERO) > 0.15 && field.distance_m(DVec3::X * 0.25) < 0.0);
}

#[test]
fn hulls_hold_their_points_and_no_more() {
    let mut rng = Rng::with_seed(5);
    for count in [4, 9, 60, 500] {
        let mut one = || 2.0 * rng.f64() - 1.0;
        let points: Vec<DVec3> = (0..count).map(|_| DVec3::new(one(), one(), one())).collect();
        let mesh = hull(&points).unwrap();
        let (mesh, repairs) = checked(mesh, false).unwrap();
        assert_eq!(repairs.said(), None);
        for triangle in 0..mesh.triangles.len() {
            let (normal, [a, ..]) = (mesh.area_normal_m2(triangle).normalize(), mesh.corners_m(triangle));
            assert!(points.iter().all(|&at| normal.dot(at - a) < 1e-8));
        }
    }
    // A lattice: many points on each face.
    let lattice: Vec<DVec3> =
        (0..125).map(|k| DVec3::new(f64::from(k % 5), f64::from(k / 5 % 5), f64::from(k / 25))).collect();
    assert!((checked(hull(&lattice).unwrap(), false).unwrap().0.volume_m3() - 64.0).abs() < 1e-9);
    for flat in [vec![], vec![DVec3::ONE; 9], (0..20).map(|k| DVec3::new(f64::from(k), f64::from(k * k), 1.0)).collect()] {
        assert!(hull(&flat).unwrap_err().contains("in one plane"));
    }
    assert!(hull(&[DVec3::NAN; 4]).unwrap_err().contains("point 0"));
    assert!(hull(&vec![DVec3::ZERO; 5000]).unwrap_err().contains("4096 fit"));
}

#[test]
fn ground_is_closed_and_as_high_as_it_says() {
    let (mesh, repairs) = checked(hills(), false).unwrap();
    assert_eq!(repairs.said(), None);
    let [low_m, high_m] = mesh.bounds_m();
    assert!((low_m - DVec3::new(-0.6, -0.1, -0.5)).length() < 1e-9 && (high_m.x - 0.6).abs() < 1e-9);
    let tree = Bvh::new(&mesh);
    // Column 10, row 8 is in the middle.
    let height_m = 0.1 + 0.05 * (10.0_f64 * 0.7).sin() + 0.04 * (8.0_f64 * 0.9).cos();
    assert!(tree.nearest_m(DVec3::new(0.0, height_m, 0.0), 1.0).unwrap().distance(DVec3::new(0.0, height_m, 0.0)) < 1e-9);
    assert!(tree.winding(DVec3::new(0.0, height_m - 0.01, 0.0)) > 0.9);
    assert!(tree.winding(DVec3::new(0.0, height_m + 0.02, 0.0)) < 0.1);
}

#[test]
fn a_sheet_is_as_thick_as_it_is_told() {
    let square = Mesh {
        positions_m: [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(|[x, z]: [i32; 2]| DVec3::new(x.into(), 0.0, z.into())).into(),
        triangles: vec![[0, 1, 2], [0, 2, 3]],
    };
    let (square, _) = checked(square, true).unwrap();
    let field = Field::new(&square, &FieldOptions { cell_m: 0.05, support_m: Some(0.2), sheet_m: Some(0.1) });
    assert!((field.distance_m(DVec3::new(0.1, 0.17, 0.2)) - 0.12).abs() < 1e-6);
    assert!((field.distance_m(DVec3::new(0.1, -0.17, 0.2)) - 0.12).abs() < 1e-6);
    assert!(field.distance_m(DVec3::ZERO) < -0.02);
    assert_eq!(field.lost(&square, 0.02), 0.0);
    // Thin between two nodes it is lost.
    let thin = Field::new(&square, &FieldOptions { cell_m: 0.09, support_m: None, sheet_m: Some(0.001) });
    assert!(thin.lost(&square, 0.02) > 0.5, "{}", thin.lost(&square, 0.02));
}

#[test]
fn a_hundred_thousand_triangles_take_seconds() {
    let (mesh, _) = checked(ball(0.3, 159), false).unwrap();
    assert!(mesh.triangles.len() > 99_000);
    let begun = std::time::Instant::now();
    let field = Field::new(&mesh, &FieldOptions { cell_m: 0.01, support_m: Some(0.04), sheet_m: None });
    let took_s = begun.elapsed().as_secs_f64();
    println!("{} triangles, {} nodes: {took_s:.2} s", mesh.triangles.len(), field.values.len());
    assert!(took_s < 60.0);
}

#[test]
fn heights_are_resampled_by_their_means() {
    let heights_m: Vec<f64> = (0..90 * 70).map(|k| 1.0 + 2.0 * f64::from(k % 90) / 89.0).collect();
    let coarse = Heights { columns: 90, rows: 70, heights_m }.resampled([10, 500]);
    assert_eq!((coarse.columns, coarse.rows), (10, 70));
    for (index, height_m) in coarse.heights_m.iter().enumerate() {
        let expected_m = 1.0 + 2.0 * (index % 10) as f64 / 9.0;
        // At an end half a step is cut off.
        assert!((height_m - expected_m).abs() < 0.07, "{index}: {height_m} m, {expected_m} m");
    }
}

#[cfg(feature = "import")]
mod files {
    use super::*;
    use crate::import::{image, mesh_of};
    use base64::Engine as _;

    const OBJ: &str = "# a cube\nv -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n\
        f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 4 1 5 8\n";

    /// A cube of two units as glTF, whose JSON has one part replaced, turned by a node.
    fn gltf(from: &str, to: &str) -> String {
        let corners = mesh_of(OBJ.as_bytes(), "obj").unwrap();
        let mut bytes: Vec<u8> =
            corners.positions_m.iter().flat_map(|at| at.as_vec3().to_array()).flat_map(f32::to_le_bytes).collect();
        bytes.extend(corners.triangles.iter().flatten().flat_map(|&corner| (corner as u16).to_le_bytes()));
        let data = base64::engine::general_purpose::STANDARD.encode(&bytes);
        let text = format!(
            r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],
            "nodes":[{{"children":[1],"scale":[2,1,1]}},{{"mesh":0,"translation":[1,0,0]}}],
            "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1}}]}}],
            "accessors":[{{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3","min":[-1,-1,-1],"max":[1,1,1]}},
            {{"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}}],
            "bufferViews":[{{"buffer":0,"byteLength":96}},{{"buffer":0,"byteOffset":96,"byteLength":72}}],
            "buffers":[{{"byteLength":168,"uri":"data:application/octet-stream;base64,{data}"}}]}}"#
        );
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1)
    }

    #[test]
    fn obj_and_gltf_are_the_meshes_that_they_say() {
        let (cube, repairs) = checked(mesh_of(OBJ.as_bytes(), "obj").unwrap(), false).unwrap();
        assert_eq!(repairs.said(), None);
        assert!((cube.volume_m3() - 8.0).abs() < 1e-12);
        let (moved, repairs) = checked(mesh_of(gltf("", "").as_bytes(), "gltf").unwrap(), false).unwrap();
        assert_eq!(repairs.said(), None);
        assert!((moved.volume_m3() - 16.0).abs() < 1e-9);
        assert_eq!(moved.bounds_m(), [DVec3::new(0.0, -1.0, -1.0), DVec3::new(4.0, 1.0, 1.0)]);
        // Mirrored by its node it still faces outward.
        let mirrored = mesh_of(gltf("[2,1,1]", "[-2,1,1]").as_bytes(), "gltf").unwrap();
        assert!((mirrored.volume_m3() - 16.0).abs() < 1e-9);
    }

    #[test]
    fn files_that_lie_are_refused_by_what_they_lie_about() {
        let refused = |from: &str, to: &str| mesh_of(gltf(from, to).as_bytes(), "gltf").unwrap_err();
        let cases = [
            (r#""byteLength":168"#, r#""byteLength":99999999999"#, "buffer 0 is said to have 99999999999 bytes, and 168"),
            (r#""count":36"#, r#""count":4000000000"#, "accessor 1 of 4000000000 elements that reaches beyond"),
            (r#""byteOffset":96,"byteLength":72"#, r#""byteOffset":96,"byteLength":96"#, ""),
            (r#""byteOffset":96"#, r#""byteOffset":18446744073709551615"#, ""),
            (r#""children":[1]"#, r#""children":[0,1]"#, "nodes in a circle"),
            ("data:application/octet-stream;base64,", "data:text/plain,", "not base64"),
            ("data:application/octet-stream;base64,", "../../etc/passwd?", "must be a file beside it"),
            (r#""mesh":0"#, r#""mesh":7"#, "no glTF file"),
            (r#""componentType":5123"#, r#""componentType":5126"#, "indices that are not whole"),
            (r#""POSITION":0"#, r#""POSITION":1"#, ""),
            (r#""POSITION":0"#, r#""POSITION":9"#, "positions in accessor 9, and there are 2"),
            (r#"{"asset""#, r#"{"asset"#, "no glTF file"),
            (r#""scenes":[{"nodes":[0]}],"#, r#""scenes":[],"#, ""),
        ];
        for (from, to, words) in cases {
            match mesh_of(gltf(from, to).as_bytes(), "gltf") {
                Err(error) => assert!(error.contains(words) && !error.contains('\n'), "{to}: {error}"),
                // A view that is longer than what it is used for.
                Ok(_) => assert!(to.ends_with(":96"), "{to} is read"),
            }
        }
        // An index of a corner that is not there.
        let last = refused(r#""count":8"#, r#""count":7"#);
        assert!(last.contains("has index 7 in place") && last.contains("there are 7 positions"), "{last}");
        for (text, words) in [
            ("v 1 2\nf 1 1 1\n", "no OBJ file"),
            ("v 1 2 3\nf 1 2 9\n", "out of bounds"),
            ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -9\n", ""),
            ("v a b c\n", "position parse error"),
        ] {
            let error = mesh_of(text.as_bytes(), "obj").map(|mesh| checked(mesh, false));
            match error {
                Err(error) => assert!(error.contains(words), "{text}: {error}"),
                Ok(read) => assert!(read.is_err(), "{text} is read"),
            }
        }
    }

    /// Damaged files are read or refused, without a panic and without memory that they do not explain.
    #[test]
    fn damaged_files_do_no_harm() {
        let mut rng = Rng::with_seed(11);
        let png = png_of(png::BitDepth::Sixteen, &[0, 0, 255, 255, 128, 0, 64, 0]);
        let mut glb = b"glTF\x02\0\0\0".to_vec();
        let json = gltf("", "");
        let padded = format!("{json}{}", " ".repeat(json.len().wrapping_neg() % 4));
        glb.extend((padded.len() as u32 + 20).to_le_bytes());
        glb.extend((padded.len() as u32).to_le_bytes());
        glb.extend(b"JSON");
        glb.extend(padded.bytes());
        assert!(mesh_of(&glb, "glb").is_ok());
        let (mut read, mut refused) = (0, 0);
        for (text, ending) in
            [(OBJ.as_bytes().to_vec(), "obj"), (json.into_bytes(), "gltf"), (glb, "glb"), (png, "png")]
        {
            for _ in 0..15000 {
                let mut bytes = text.clone();
                for _ in 0..rng.usize(1..4) {
                    let at = rng.usize(0..bytes.len());
                    match rng.u8(0..4) {
                        0 => bytes[at] ^= 1 << rng.u8(0..8),
                        1 => bytes[at] = b"0123456789-.e{}[],\"\n "[rng.usize(0..21)],
                        2 => bytes.truncate(at + 1),
                        _ => {
                            let other = rng.usize(0..bytes.len());
                            let piece: Vec<u8> = bytes[at.min(other)..at.max(other)].iter().take(40).copied().collect();
                            bytes.splice(at..at, piece);
                        }
                    }
                }
                let is_read = match ending {
                    "png" => image(&bytes).is_ok(),
                    _ => mesh_of(&bytes, ending).and_then(|mesh| checked(mesh, false).map_err(|flaw| flaw.to_string())).is_ok(),
                };
                *(if is_read { &mut read } else { &mut refused }) += 1;
            }
        }
        println!("{read} read, {refused} refused");
        assert!(read > 100 && refused > 1000);
    }

    fn png_of(depth: png::BitDepth, pixels: &[u8]) -> Vec<u8> {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, 2, 2);
        encoder.set_color(png::ColorType::Grayscale);
        encoder.set_depth(depth);
        encoder.write_header().unwrap().write_image_data(pixels).unwrap();
        bytes
    }

    #[test]
    fn gray_images_are_shares_of_white() {
        let bytes = image(&png_of(png::BitDepth::Eight, &[0, 51, 255, 102])).unwrap();
        assert_eq!((bytes.columns, bytes.rows, bytes.shares), (2, 2, vec![0.0, 0.2, 1.0, 0.4]));
        let words = image(&png_of(png::BitDepth::Sixteen, &[0, 0, 255, 255, 51, 51, 0, 1])).unwrap();
        assert_eq!(words.shares, [0.0, 1.0, 0.2, 1.0 / 65535.0]);
        let mut colored = Vec::new();
        let mut encoder = png::Encoder::new(&mut colored, 2, 2);
        encoder.set_color(png::ColorType::Rgb);
        encoder.write_header().unwrap().write_image_data(&[0; 12]).unwrap();
        assert!(image(&colored).unwrap_err().contains("must be gray"));
        assert!(image(b"not a png").unwrap_err().contains("no PNG file"));
    }
}
