//! What the shaders are told of solids that the fluid moves: their inertia, the points that they touch others with, and how
//! they begin.

use std::f64::consts::{PI, TAU};

use brooklet_kernels::{BodyState, MAX_BODIES, RigidBody, SHAPE_BOX, SHAPE_CAPSULE, SHAPE_CYLINDER, SurfacePoint};
use brooklet_shapes::MassProperties;
use glam::{DMat3, DQuat, DVec3};

use super::solid_shapes::{cavity_m, from_shape_m, halves, motion};
use super::{Scene, SolidSettings};

/// Bodies that a scene may have.
pub(super) const MOST_BODIES: usize = MAX_BODIES as usize;
/// Points around a rim.
const RIM_POINTS: u32 = 12;

/// Of a shape between two corners, for a density of 1 kg/m³.
fn filled(shape: u32, min_m: DVec3, max_m: DVec3) -> MassProperties {
    let (half_m, centre_of_mass_m) = (0.5 * (max_m - min_m), 0.5 * (min_m + max_m));
    let squares = half_m * half_m;
    let (volume_m3, inertia_m5) = match shape {
        SHAPE_BOX => {
            let volume_m3 = 8.0 * half_m.element_product();
            let sums = DVec3::new(squares.y + squares.z, squares.x + squares.z, squares.x + squares.y);
            (volume_m3, volume_m3 / 3.0 * sums)
        }
        _ => {
            let round_m3 = TAU * squares.x * half_m.y;
            let across = round_m3 * (squares.x / 4.0 + squares.y / 3.0);
            let cylinder = DVec3::new(across, 0.5 * round_m3 * squares.x, across);
            let ball_m3 = if shape == SHAPE_CAPSULE { 4.0 / 3.0 * PI * half_m.x.powi(3) } else { 0.0 };
            // Two halves of a ball, each half a length away.
            let apart = ball_m3 * (0.4 * squares.x + squares.y + 0.75 * half_m.x * half_m.y);
            (round_m3 + ball_m3, cylinder + DVec3::new(apart, 0.4 * ball_m3 * squares.x, apart))
        }
    };
    MassProperties { volume_m3, centre_of_mass_m, inertia_m5: DMat3::from_diagonal(inertia_m5) }
}

/// What a body is made of.
#[derive(Clone, Copy, Debug)]
struct Matter {
    /// For a density of 1 kg/m³.
    mass: MassProperties,
    /// The same of what it displaces if nothing fills its cavity: its shape.
    outer: MassProperties,
    /// Of the shape, m².
    area_m2: f64,
    /// The largest of its faces, m².
    largest_face_m2: f64,
}

/// Of a shape as `Solid::half_m` has it, with a cavity; or of triangles.
fn matter(solid: &SolidSettings) -> Matter {
    if let Some(triangles) = solid.triangles() {
        let (mass, mesh) = (triangles.mass_properties(), &triangles.solid);
        return Matter { mass, outer: mass, area_m2: mesh.area_m2(), largest_face_m2: mesh.largest_shadow_m2() };
    }
    let (shape, half_m, _) = halves(solid);
    let outer = filled(shape, -half_m, half_m);
    let cavity = cavity_m(solid).map(|[min_m, max_m]| filled(shape, min_m.max(-half_m), max_m.min(half_m)));
    let mass = cavity.map_or(outer, |cavity| without(&outer, &cavity));
    let (area_m2, largest_face_m2) = match shape {
        SHAPE_BOX => {
            let faces = 4.0 * DVec3::new(half_m.y * half_m.z, half_m.x * half_m.z, half_m.x * half_m.y);
            (2.0 * faces.element_sum(), faces.max_element())
        }
        _ => {
            let side_m2 = 2.0 * TAU * half_m.x * half_m.y;
            let end_m2 = PI * half_m.x.powi(2);
            let ends_m2 = if shape == SHAPE_CAPSULE { 4.0 * end_m2 } else { 2.0 * end_m2 };
            (side_m2 + ends_m2, end_m2.max(4.0 * half_m.x * half_m.y))
        }
    };
    Matter { mass, outer, area_m2, largest_face_m2 }
}

/// What is left of a whole.
fn without(whole: &MassProperties, part: &MassProperties) -> MassProperties {
    let volume_m3 = whole.volume_m3 - part.volume_m3;
    let first_m4 = whole.volume_m3 * whole.centre_of_mass_m - part.volume_m3 * part.centre_of_mass_m;
    let centre_of_mass_m = first_m4 / volume_m3;
    let inertia_m5 = whole.inertia_about_m5(centre_of_mass_m) - part.inertia_about_m5(centre_of_mass_m);
    MassProperties { volume_m3, centre_of_mass_m, inertia_m5 }
}

/// Moments and products of a symmetric tensor as shaders have them.
fn moments_and_products(of: DMat3) -> ([f32; 3], [f32; 3]) {
    let moments = DVec3::new(of.x_axis.x, of.y_axis.y, of.z_axis.z);
    let products = DVec3::new(of.x_axis.y, of.y_axis.z, of.z_axis.x);
    (moments.as_vec3().to_array(), products.as_vec3().to_array())
}

/// A body's mass, kg; of a solid that is none 0.
pub fn body_mass_kg(solid: &SolidSettings) -> f64 {
    solid.density_kg_m3.map_or(0.0, |density_kg_m3| density_kg_m3 * matter(solid).mass.volume_m3)
}

/// The solids of a scene that are bodies, with their places among the solids.
pub(super) fn body_solids(scene: &Scene) -> impl Iterator<Item = (usize, &SolidSettings, f64)> {
    let solids = scene.solids.iter().enumerate();
    solids.filter_map(|(index, solid)| Some((index, solid, solid.density_kg_m3?)))
}

/// How many points all of their surfaces have.
pub fn surface_point_count(scene: &Scene) -> u32 {
    body_solids(scene).map(|(_, solid, _)| points_of(solid).len() as u32).sum()
}

/// What the shaders are told of the bodies.
pub fn bodies(scene: &Scene) -> Vec<RigidBody> {
    let rest_density_kg_m3 = scene.rest_density_kg_m3();
    let of = |(index, solid, density_kg_m3): (usize, &SolidSettings, f64)| {
        let matter = matter(solid);
        let (mass, outer) = (matter.mass, matter.outer);
        // A disc that moves along its axis takes 8/3 r³ along (Lamb 1932, art. 108), of which half is enough.
        let disc_m3 = 4.0 / 3.0 * (matter.largest_face_m2 / PI).powf(1.5);
        let (inertia_kg_m2, products_kg_m2) = moments_and_products(mass.inertia_m5 * density_kg_m3);
        let (added_inertia_kg_m2, added_products_kg_m2) = moments_and_products(outer.inertia_m5 * rest_density_kg_m3);
        RigidBody {
            centre_of_mass_m: mass.centre_of_mass_m.as_vec3().to_array(),
            inverse_mass_per_kg: (1.0 / (density_kg_m3 * mass.volume_m3)) as f32,
            inertia_kg_m2,
            products_kg_m2,
            added_mass_kg: (rest_density_kg_m3 * outer.volume_m3.max(disc_m3)) as f32,
            added_inertia_kg_m2,
            added_products_kg_m2,
            wet_per_push: (scene.fitted_spacing_m().powi(2) / matter.area_m2) as f32,
            solid: index as u32,
            ..hinged(scene, solid, &matter, density_kg_m3)
        }
    };
    body_solids(scene).map(of).collect()
}

/// What a hinge makes of a body; nothing of a free one.
fn hinged(scene: &Scene, solid: &SolidSettings, matter: &Matter, density_kg_m3: f64) -> RigidBody {
    let (centre_m, rotation) = beginning(solid);
    let Some((axis, hinge_m)) = hinge_line(solid, centre_m) else { return RigidBody::default() };
    let place_m = rotation.conjugate() * (hinge_m - centre_m);
    let axis_in_frame = rotation.conjugate() * axis;
    let around_m5 = |of: &MassProperties| axis_in_frame.dot(of.inertia_about_m5(place_m) * axis_in_frame);
    RigidBody {
        hinge_m: (hinge_m - DVec3::from_array(scene.domain.min_m)).as_vec3().to_array(),
        hinge_inertia_kg_m2: (density_kg_m3 * around_m5(&matter.mass)) as f32,
        hinge_axis: axis.as_vec3().to_array(),
        hinge_added_kg_m2: (scene.rest_density_kg_m3() * around_m5(&matter.outer)) as f32,
        hinge_place_m: place_m.as_vec3().to_array(),
        ..RigidBody::default()
    }
}

/// The direction and a point of the line that a body turns around, in the scene's coordinates; none of a free one.
fn hinge_line(solid: &SolidSettings, centre_m: DVec3) -> Option<(DVec3, DVec3)> {
    let hinge = solid.hinge?;
    Some((DVec3::from_array(hinge.axis).normalize(), hinge.at_m.map_or(centre_m, DVec3::from_array)))
}

/// Where a body's middle begins, in the scene's coordinates, and how it is turned.
fn beginning(solid: &SolidSettings) -> (DVec3, DQuat) {
    motion(solid).0.first().map_or((DVec3::ZERO, DQuat::IDENTITY), |pose| (pose.centre_m, pose.rotation))
}

/// How the bodies begin, relative to the domain's lowest corner.
pub fn first_body_states(scene: &Scene) -> Vec<BodyState> {
    let origin_m = DVec3::from_array(scene.domain.min_m);
    let of = |(_, solid, _): (usize, &SolidSettings, f64)| {
        let (centre_m, rotation) = beginning(solid);
        let position_m = centre_m + rotation * matter(solid).mass.centre_of_mass_m;
        let spin_rad_s = DVec3::from_array(solid.spin_deg_s.map(f64::to_radians));
        let velocity_m_s = match hinge_line(solid, centre_m) {
            Some((_, hinge_m)) => spin_rad_s.cross(position_m - hinge_m),
            None => DVec3::from_array(solid.velocity_m_s),
        };
        BodyState {
            position_m: (position_m - origin_m).as_vec3().to_array(),
            rotation: rotation.as_quat().to_array(),
            velocity_m_s: velocity_m_s.as_vec3().to_array(),
            spin_rad_s: spin_rad_s.as_vec3().to_array(),
            ..BodyState::default()
        }
    };
    body_solids(scene).map(of).collect()
}

/// The points of all bodies' surfaces, body by body.
pub fn surface_points(scene: &Scene) -> Vec<SurfacePoint> {
    let bodies = body_solids(scene).enumerate();
    bodies
        .flat_map(|(body, (_, solid, _))| {
            let point = move |(place_m, radius_m): (DVec3, f64)| SurfacePoint {
                place_m: place_m.as_vec3().to_array(),
                radius_m: radius_m as f32,
                body: body as u32,
                ..SurfacePoint::default()
            };
            points_of(solid).into_iter().map(point)
        })
        .collect()
}

/// Balls on a solid's surface, in its frame: place and radius, m. None where an open one has no surface.
pub(super) fn points_of(solid: &SolidSettings) -> Vec<(DVec3, f64)> {
    if let Some(triangles) = solid.triangles() {
        return triangles.points_m().iter().map(|&place_m| (place_m, 0.0)).collect();
    }
    let (shape, half_m, extent_m) = halves(solid);
    let along =
        |half_m: f64, count: u32| (0..count).map(move |k| half_m * (2.0 * f64::from(k) / f64::from(count - 1) - 1.0));
    let points: Vec<(DVec3, f64)> = match shape {
        SHAPE_CAPSULE if half_m.y == 0.0 => vec![(DVec3::ZERO, half_m.x)],
        SHAPE_CAPSULE => {
            let count = (2.0 * half_m.y / half_m.x).ceil().clamp(1.0, 8.0) as u32 + 1;
            along(half_m.y, count).map(|y| (DVec3::Y * y, half_m.x)).collect()
        }
        SHAPE_CYLINDER => {
            let rims = along(half_m.y, if half_m.y > half_m.x { 3 } else { 2 });
            let rim = |y: f64| (0..RIM_POINTS).map(move |k| (TAU * f64::from(k) / f64::from(RIM_POINTS), y));
            let on_rims =
                rims.flat_map(rim).map(|(angle, y)| DVec3::new(half_m.x * angle.cos(), y, half_m.x * angle.sin()));
            on_rims.chain([DVec3::Y * half_m.y, DVec3::NEG_Y * half_m.y]).map(|place_m| (place_m, 0.0)).collect()
        }
        _ => {
            let shortest_m = half_m.min_element();
            let counts = half_m.to_array().map(|side_m| (side_m / shortest_m).ceil().clamp(2.0, 4.0) as u32 + 1);
            let lattice = along(half_m.x, counts[0]).flat_map(|x| {
                along(half_m.y, counts[1])
                    .flat_map(move |y| along(half_m.z, counts[2]).map(move |z| DVec3::new(x, y, z)))
            });
            let on_surface = |place_m: &DVec3| (0..3).any(|axis| place_m[axis].abs() >= half_m[axis] * (1.0 - 1e-9));
            lattice.filter(on_surface).map(|place_m| (place_m, 0.0)).collect()
        }
    };
    let Some([min_m, max_m]) = cavity_m(solid) else { return points };
    let hair_m = 1e-6 * extent_m.max_element();
    let is_of_solid = |(place_m, _): &(DVec3, f64)| {
        from_shape_m(shape, *place_m - 0.5 * (min_m + max_m), 0.5 * (max_m - min_m)) >= -hair_m
    };
    match shape {
        // Its points are inside, and its ends are never open.
        SHAPE_CAPSULE => points,
        _ => points.into_iter().filter(is_of_solid).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{BoxShape, OpenFaces, RoundShape, SphereShape};

    /// Sums over a grid.
    fn summed(solid: &SolidSettings) -> (f64, DVec3, DVec3) {
        let (shape, half_m, extent_m) = halves(solid);
        let cavity_m = cavity_m(solid);
        let (steps, mut volume_m3, mut first, mut second) = (80, 0.0, DVec3::ZERO, DVec3::ZERO);
        let step_m = 2.0 * extent_m / f64::from(steps);
        for k in 0..steps * steps * steps {
            let cell = DVec3::new(f64::from(k % steps), f64::from(k / steps % steps), f64::from(k / steps / steps));
            let at_m = -extent_m + step_m * (cell + 0.5);
            let in_cavity = cavity_m.is_some_and(|[min_m, max_m]| {
                from_shape_m(shape, at_m - 0.5 * (min_m + max_m), 0.5 * (max_m - min_m)) < 0.0
            });
            if from_shape_m(shape, at_m, half_m) < 0.0 && !in_cavity {
                let of_m3 = step_m.element_product();
                volume_m3 += of_m3;
                first += of_m3 * at_m;
                second += of_m3 * at_m * at_m;
            }
        }
        let middle_m = first / volume_m3;
        let squares = second - volume_m3 * middle_m * middle_m;
        (volume_m3, middle_m, DVec3::new(squares.y + squares.z, squares.x + squares.z, squares.x + squares.y))
    }

    fn solids() -> [SolidSettings; 5] {
        let cuboid = Some(BoxShape { size_m: [0.3, 0.5, 0.8] });
        let round = Some(RoundShape { radius_m: 0.2, length_m: 0.9 });
        let hollow = |open| SolidSettings { thickness_m: Some(0.1), open, ..SolidSettings::default() };
        [
            SolidSettings { cuboid, ..SolidSettings::default() },
            SolidSettings { capsule: round, ..hollow(None) },
            SolidSettings { sphere: Some(SphereShape { radius_m: 0.4 }), ..SolidSettings::default() },
            SolidSettings { cylinder: round, ..hollow(Some(OpenFaces::YMax)) },
            SolidSettings { cuboid, ..hollow(Some(OpenFaces::YMax)) },
        ]
    }

    /// A grid of 80 cells a side misjudges a surface by a share of a cell: 1.5 % of an inertia.
    #[test]
    fn inertia_is_that_of_a_grid_of_points() {
        for solid in solids() {
            let (volume_m3, middle_m, inertia_m5) = summed(&solid);
            let mass = matter(&solid).mass;
            let moments = DVec3::from_array(moments_and_products(mass.inertia_m5).0.map(f64::from));
            assert!((mass.volume_m3 / volume_m3 - 1.0).abs() < 0.015, "{solid:?}: {} and {volume_m3}", mass.volume_m3);
            assert!(
                mass.centre_of_mass_m.distance(middle_m) < 0.005,
                "{solid:?}: {} and {middle_m}",
                mass.centre_of_mass_m
            );
            let off = (moments / inertia_m5 - 1.0).abs();
            assert!(off.max_element() < 0.015, "{solid:?}: {} and {inertia_m5}", mass.inertia_m5);
        }
    }

    #[test]
    fn points_are_on_the_surface_and_not_on_a_lid_that_is_not_there() {
        for solid in solids() {
            let (shape, half_m, _) = halves(&solid);
            let points = points_of(&solid);
            assert!(!points.is_empty() && points.len() <= 64, "{solid:?}: {}", points.len());
            for (place_m, radius_m) in points {
                assert!((from_shape_m(shape, place_m, half_m) + radius_m).abs() < 1e-9, "{solid:?}: {place_m}");
                let inner_m = half_m - 0.1;
                let on_lid = solid.open == Some(OpenFaces::YMax)
                    && place_m.y > inner_m.y
                    && (place_m.x.abs() < inner_m.x - 1e-3 && place_m.z.abs() < inner_m.z - 1e-3);
                assert!(!on_lid || shape == SHAPE_CYLINDER && place_m.x.hypot(place_m.z) > 0.1, "{solid:?}: {place_m}");
            }
        }
    }
}
