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
    let heights_m =
        (0..21 * 17).map(|k| 0.1 + 0.05 * ((k % 21) as f64 * 0.7).sin() + 0.04 * ((k / 21) as f64 * 0.9).cos());
    let heights = Heights { columns: 21, rows: 17, heights_m: heights_m.collect() };
    terrain(&heights, [1.0, 0.8], 0.1, -0.1)
}

fn shapes() -> [(&'static str, Mesh); 4] {
    let mut rng = Rng::with_seed(3);
    let mut one = || rng.f64() - 0.5;
    let points: Vec<DVec3> = (0..40).map(|_| DVec3::new(one(), 0.6 * one(), one())).collect();
    [
        ("box", cuboid(DVec3::new(0.3, 0.2, 0.1))),
        ("ball", ball(0.3, 16)),
        ("hull", hull(&points).unwrap()),
        ("hills", hills()),
    ]
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
    (0..count).map(|_| low_m - beyond_m + DVec3::new(one(), one(), one()) * (high_m - low_m + 2.0 * beyond_m)).collect()
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
        for index in (0..field.distances_m.len()).step_by(7) {
            let [x, y, z] = field.nodes.map(|side| side as usize);
            let at = DVec3::new((index % x) as f64, (index / x % y) as f64, (index / (x * y)) as f64);
            assert!(index < x * y * z);
            let expected_m = brute_force_m(&mesh, field.min_m + at * field.cell_m);
            worst = worst.max((f64::from(field.distances_m[index]) - expected_m).abs());
        }
        assert!(worst < 1e-7, "{name}: off by {worst}");
        // The comparator: a mesh a millimetre larger.
        let wrong = mesh.clone().scaled(1.005);
        let away_m = (brute_force_m(&wrong, field.min_m) - f64::from(field.distances_m[0])).abs();
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
        for index in (0..field.distances_m.len()).step_by(11) {
            let [away, plane] = [field.distances_m[index], field.planes()[index]].map(f64::from);
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
    let field = Field::new(
        &cuboid(DVec3::new(4.0, 1.0, 4.0)),
        &FieldOptions { cell_m: 0.25, support_m: Some(1.0), sheet_m: None },
    );
    let [x, y, z] = field.nodes.map(|side| side as usize);
    for row in 0..y {
        let index = x / 2 + x * (row + y * (z / 2));
        let [away, plane] = [field.distances_m[index], field.planes()[index]].map(f64::from);
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
    for flat in
        [vec![], vec![DVec3::ONE; 9], (0..20).map(|k| DVec3::new(f64::from(k), f64::from(k * k), 1.0)).collect()]
    {
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
    assert!(
        tree.nearest_m(DVec3::new(0.0, height_m, 0.0), 1.0).unwrap().distance(DVec3::new(0.0, height_m, 0.0)) < 1e-9
    );
    assert!(tree.winding(DVec3::new(0.0, height_m - 0.01, 0.0)) > 0.9);
    assert!(tree.winding(DVec3::new(0.0, height_m + 0.02, 0.0)) < 0.1);
}

#[test]
fn a_sheet_is_as_thick_as_it_is_told() {
    let square = Mesh {
        positions_m: [[-1, -1], [1, -1], [1, 1], [-1, 1]]
            .map(|[x, z]: [i32; 2]| DVec3::new(x.into(), 0.0, z.into()))
            .into(),
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
    assert_eq!(field.planes().len(), field.distances_m.len());
    let took_s = begun.elapsed().as_secs_f64();
    println!("{} triangles, {} nodes: {took_s:.2} s", mesh.triangles.len(), field.distances_m.len());
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
