//! What the shaders are told of emitters and drains, and how many slots what they emit may take.

use std::f64::consts::PI;

use brooklet_kernels::{
    DRAIN_BOX, DRAIN_OUTSIDE, DRAIN_SPHERE, Drain, Emitter, EmitterPoint, EmitterState, Keyframe, MAX_DRAINS,
    MAX_EMITTERS,
};
use glam::DVec3;

use super::fill::points_of;
use super::lattice::WHOLE;
use super::solid_shapes::{Pose, motion};
use super::{DrainSettings, EmitterSettings, Fluid, Scene};

/// Emitters that a scene may have.
pub(super) const MOST_EMITTERS: usize = MAX_EMITTERS as usize;
/// Drains that a scene may have.
pub(super) const MOST_DRAINS: usize = MAX_DRAINS as usize;
/// Layers that an emitter may emit in a substep.
pub(super) const MOST_LAYERS: f64 = 64.0;
/// How far along each axis a particle may be from its lattice point, in spacings: no two layers are the same, and a jet's
/// density is that at rest to .5 % (`fluid/emitters`). Position Based Fluids make a velocity of more.
pub(super) const JITTER: f64 = 0.005;

/// What the shaders are told of a scene's emitters.
#[derive(Clone, Debug, Default)]
pub struct EmitterTables {
    /// Of each.
    pub emitters: Vec<Emitter>,
    /// Of all of them, one after the other.
    pub points: Vec<EmitterPoint>,
    /// Likewise.
    pub keyframes: Vec<Keyframe>,
}

impl EmitterTables {
    /// Particles that a substep emits at most.
    pub fn most_a_substep(&self) -> u32 {
        self.emitters.iter().map(|emitter| emitter.points.saturating_mul(emitter.most_layers)).sum()
    }
}

impl EmitterSettings {
    /// Its direction, of length 1; down where it has none.
    pub(super) fn towards(&self) -> DVec3 {
        DVec3::from_array(self.direction).try_normalize().unwrap_or(DVec3::NEG_Y)
    }

    /// Along its nozzle's width and height, of length 1.
    fn axes(&self, scene: &Scene) -> [DVec3; 2] {
        let towards = self.towards();
        let across = match scene.domain.is_flat() {
            true => DVec3::Z.cross(towards),
            false => DVec3::Y.cross(towards).try_normalize().unwrap_or(DVec3::X),
        };
        [across, towards.cross(across)]
    }

    /// Points of a layer, m: of a nozzle in its frame, of what fills at once in the scene's coordinates.
    pub(super) fn points_m(&self, scene: &Scene) -> Vec<DVec3> {
        if self.fills() {
            let fluid = Fluid {
                block: self.block.clone(),
                sphere: self.sphere.clone(),
                cylinder: None,
                velocity_m_s: [0.0; 3],
                velocity_spread_m_s: [0.0; 3],
                rest_density_kg_m3: scene.rest_density_kg_m3(),
            };
            return points_of(&fluid, scene).into_iter().map(DVec3::from_array).collect();
        }
        let spacing_m = scene.fitted_spacing_m();
        let [across, up] = self.axes(scene);
        let rows = |side_m: f64| {
            let count = (side_m / spacing_m + WHOLE).floor();
            (0..count as u32).map(move |k| f64::from(k) - 0.5 * (count - 1.0))
        };
        let places: Vec<[f64; 2]> = match (self.radius_m, self.width_m) {
            (Some(radius_m), _) if scene.domain.is_flat() => {
                rows((2.0 * radius_m).max(spacing_m)).map(|u| [u, 0.0]).collect()
            }
            (Some(radius_m), _) => disc(radius_m / spacing_m),
            (None, Some(width_m)) if scene.domain.is_flat() => rows(width_m).map(|u| [u, 0.0]).collect(),
            (None, Some(width_m)) => {
                let height_m = self.height_m.unwrap_or_default();
                rows(height_m).flat_map(|v| rows(width_m).map(move |u| [u, v])).collect()
            }
            (None, None) => Vec::new(),
        };
        places.into_iter().map(|[u, v]| spacing_m * (u * across + v * up)).collect()
    }

    /// Where its nozzle is at times, and after which time that begins again, s.
    pub(super) fn motion(&self, scene: &Scene) -> (Vec<Pose>, f64) {
        let (mut poses, period_s) = motion(&self.frame());
        for pose in &mut poses {
            if scene.domain.is_flat() {
                pose.centre_m.z = scene.domain.plane_z_m();
            }
        }
        (poses, period_s)
    }

    /// Layers that flowed from it until a time, s, not rounded.
    fn flowed(&self, scene: &Scene, time_s: f64) -> f64 {
        let flows_s = time_s.min(self.end_s.unwrap_or(f64::INFINITY)) - self.start_s;
        self.speed_m_s * flows_s.max(0.0) / scene.fitted_spacing_m()
    }

    /// Particles of it that there are at most until a time, s.
    pub fn most_particles(&self, scene: &Scene, until_s: f64) -> f64 {
        let layers = match self.fills() {
            true => f64::from(u8::from(self.start_s <= until_s)),
            false => {
                let flowed = (self.flowed(scene, until_s) + 0.5).floor();
                let living = self.speed_m_s * self.lifetime_s.unwrap_or(f64::INFINITY) / scene.fitted_spacing_m();
                flowed.min((living + 1.0).ceil())
            }
        };
        layers * self.points_m(scene).len() as f64
    }

    /// Its state at a time, had the scene run from its start in such substeps.
    fn state_at(&self, scene: &Scene, time_s: f64) -> EmitterState {
        let opened_s = time_s - scene.substep_s();
        let layers = match self.fills() {
            true => f64::from(u8::from(time_s > 0.0 && opened_s >= self.start_s)),
            false => (self.flowed(scene, opened_s) + 0.5).floor(),
        };
        let moved = if self.fills() { 0.0 } else { self.flowed(scene, time_s) - layers };
        EmitterState { moved: moved as f32, layers: layers as u32, ..EmitterState::default() }
    }
}

/// The points of a square lattice of spacing 1 in a disc: of the ways to lay it out the one whose number is nearest to its area.
fn disc(radius: f64) -> Vec<[f64; 2]> {
    let reach = radius.floor() as i32 + 1;
    let laid_out = |shift: [f64; 2]| -> Vec<[f64; 2]> {
        let square = (-reach..=reach)
            .flat_map(|v| (-reach..=reach).map(move |u| [f64::from(u) + shift[0], f64::from(v) + shift[1]]));
        square.filter(|[u, v]| u.hypot(*v) <= radius * (1.0 + 1.0e-9)).collect()
    };
    let off = |points: &Vec<[f64; 2]>| (points.len() as f64 - PI * radius * radius).abs();
    let mut best = laid_out([0.0, 0.0]);
    for shift in [[0.5, 0.5], [0.5, 0.0]] {
        let points = laid_out(shift);
        if off(&points) < off(&best) && !points.is_empty() {
            best = points;
        }
    }
    best
}

/// What the shaders are told of a scene's emitters: relative to the domain's lowest corner.
pub fn emitters(scene: &Scene) -> EmitterTables {
    let mut tables = EmitterTables::default();
    let origin_m = DVec3::from_array(scene.domain.min_m);
    let spacing_m = scene.fitted_spacing_m();
    // Where the GPU chooses substeps, one may take all of a step.
    let longest_s = if scene.adapts_substeps() { scene.solver.dt_s } else { scene.substep_s() };
    for settings in &scene.emitters {
        let fills = settings.fills();
        let (poses, period_s) = match fills {
            true => (vec![Pose { centre_m: origin_m, ..Pose::standing() }], 0.0),
            false => settings.motion(scene),
        };
        let shift_m = if fills { origin_m } else { DVec3::ZERO };
        let points_m = settings.points_m(scene);
        let [across, up] = settings.axes(scene).map(|axis| axis.as_vec3().to_array());
        tables.emitters.push(Emitter {
            direction: settings.towards().as_vec3().to_array(),
            speed_m_s: settings.speed_m_s as f32,
            first_point: tables.points.len() as u32,
            points: points_m.len() as u32,
            first_keyframe: tables.keyframes.len() as u32,
            keyframe_count: poses.len() as u32,
            period_s: period_s as f32,
            start_s: settings.start_s as f32,
            end_s: settings.end_s.unwrap_or(f64::from(f32::MAX)) as f32,
            lifetime_s: settings.lifetime_s.unwrap_or_default() as f32,
            layers_per_m: if fills { 0.0 } else { (1.0 / spacing_m) as f32 },
            jitter_m: if fills { 0.0 } else { (JITTER * spacing_m) as f32 },
            fluid: settings.fluid,
            most_layers: match fills {
                true => 1,
                false => (settings.speed_m_s * longest_s / spacing_m).ceil().min(MOST_LAYERS) as u32 + 1,
            },
            across,
            half_width_m: settings.radius_m.or(settings.width_m.map(|side_m| 0.5 * side_m)).unwrap_or_default() as f32,
            up,
            // Of a line in two dimensions any will do.
            half_height_m: settings.width_m.map_or(0.0, |width_m| 0.5 * settings.height_m.unwrap_or(width_m)) as f32,
        });
        let place = |place_m: DVec3| EmitterPoint { place_m: (place_m - shift_m).as_vec3().to_array(), reserved: 0.0 };
        tables.points.extend(points_m.into_iter().map(place));
        tables.keyframes.extend(poses.iter().map(|pose| Keyframe {
            position_m: (pose.centre_m - origin_m).as_vec3().to_array(),
            time_s: pose.time_s as f32,
            rotation: pose.rotation.as_quat().to_array(),
        }));
    }
    tables
}

/// The states of a scene's emitters at a time, had it run from its start.
pub fn emitter_states(scene: &Scene, time_s: f64) -> Vec<EmitterState> {
    scene.emitters.iter().map(|emitter| emitter.state_at(scene, time_s)).collect()
}

/// What the shaders are told of a scene's drains: relative to the domain's lowest corner.
pub fn drains(scene: &Scene) -> Vec<Drain> {
    let relative_m = |place_m: [f64; 3]| std::array::from_fn(|axis| (place_m[axis] - scene.domain.min_m[axis]) as f32);
    let particle_m3 = scene.fitted_spacing_m().powi(scene.domain.dimensions as i32);
    let of = |drain: &DrainSettings| {
        let (shape, min_m, max_m) = match (&drain.block, &drain.sphere) {
            (Some(block), _) => (DRAIN_BOX, relative_m(block.min_m), relative_m(block.max_m)),
            (_, Some(sphere)) => (DRAIN_SPHERE, relative_m(sphere.centre_m), [sphere.radius_m as f32; 3]),
            (None, None) => (DRAIN_OUTSIDE, [0.0; 3], scene.domain.size_m().map(|side_m| side_m as f32)),
        };
        let particles_per_s = drain.most_m3_s.map_or(0.0, |most_m3_s| most_m3_s / particle_m3) as f32;
        Drain { min_m, shape, max_m, particles_per_s }
    };
    scene.drains.iter().map(of).collect()
}

impl Scene {
    /// Slots for particles, where their number changes: those that the scene says, else as many as it begins with and its
    /// emitters emit in `outputs.seconds`; none where their number stays.
    pub fn slot_capacity(&self) -> Option<u32> {
        let changes = !self.emitters.is_empty() || !self.drains.is_empty();
        self.capacity.or_else(|| changes.then(|| self.most_particles().clamp(1.0, f64::from(u32::MAX)) as u32))
    }

    /// Particles that there are at most within `outputs.seconds`, if none is drained.
    pub(super) fn most_particles(&self) -> f64 {
        let emitted = self.emitters.iter().map(|emitter| emitter.most_particles(self, self.outputs.seconds));
        self.particle_count() as f64 + emitted.sum::<f64>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_disc_has_about_as_many_points_as_its_area_holds() {
        assert_eq!(disc(0.1).len(), 1, "one where there is no room for more");
        for radius in [0.6, 1.0, 1.5, 2.2, 3.3, 5.0, 10.4] {
            let points = disc(radius);
            let area = PI * radius * radius;
            assert!((points.len() as f64 / area - 1.0).abs() < 0.3 / radius, "{radius}: {} of {area}", points.len());
            let mean = points.iter().fold([0.0; 2], |sum, point| [sum[0] + point[0], sum[1] + point[1]]);
            assert!(points.iter().all(|[u, v]| u.hypot(*v) <= radius + 1e-6), "{radius}");
            assert!(mean.iter().all(|sum| sum.abs() < 0.51 * points.len() as f64), "{radius}: {mean:?}");
        }
    }
}
