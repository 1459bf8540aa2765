//! Walls that drag the fluid along them: one pass at a substep's end, and none where all faces are free-slip. (Shader:
//! `boundary/drag_walls.compute`.)

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{Buffer, WallFace};

use super::{share_slope, wall_kernel_fraction};
use crate::grid::NeighbourSearch;
use crate::particles::buffers::Particles;
use crate::scene::{Method, Scene, Slip};
use crate::solver::sph::shear_beyond;
use crate::step_context::StepContext;

/// What the faces of a scene are told, if any of them drags.
pub struct DragWalls {
    faces: Buffer<WallFace>,
}

/// What the shaders are given, lowest end of each axis first.
pub fn wall_faces(scene: &Scene) -> [WallFace; 6] {
    scene.domain.faces.all().map(|face| {
        let face = face.unwrap_or_default();
        let [shear_m2_s, friction] = match face.slip {
            Slip::FreeSlip => [0.0; 2],
            Slip::NoSlip => [2.0 * viscosity_m2_s(scene) * shear_scale(scene), 0.0],
            Slip::Friction => [0.0, face.friction * friction_scale(scene)],
        };
        WallFace {
            velocity_m_s: face.velocity_m_s.map(|v| v as f32),
            shear_m2_s: shear_m2_s as f32,
            friction: friction as f32,
            ..WallFace::default()
        }
    })
}

/// Kinematic viscosity of a solver that has one.
fn viscosity_m2_s(scene: &Scene) -> f64 {
    match scene.solver.method {
        Method::Sph => scene.sph_viscosity_m2_s(),
        Method::Pbf | Method::Dfsph | Method::None => 0.0,
    }
}

/// What makes a linear profile of the lattice half a spacing off a wall feel no force: of the neighbours that it lacks there
/// over 2 L/s.
fn shear_scale(scene: &Scene) -> f64 {
    let distance = 0.5 / scene.solver.support_ratio;
    shear_beyond(scene) / (2.0 * share_slope(wall_kernel_fraction(scene.domain.dimensions), distance) / distance)
}

/// What makes the sum of L over the layers of the lattice its integral, a half.
fn friction_scale(scene: &Scene) -> f64 {
    let ratio = scene.solver.support_ratio;
    let fraction = wall_kernel_fraction(scene.domain.dimensions);
    let layers = 0..ratio.ceil() as u32;
    0.5 / layers.map(|layer| share_slope(fraction, (f64::from(layer) + 0.5) / ratio) / ratio).sum::<f64>()
}

impl DragWalls {
    /// None where all faces are free-slip.
    pub(crate) fn declare(resources: &mut Resources, scene: &Scene) -> Option<Self> {
        scene.domain.has_dragging_walls().then(|| Self { faces: resources.persistent("wall_faces", 6) })
    }

    pub(crate) fn record_init(&mut self, init: &mut Recording, scene: &Scene) {
        init.upload(&mut self.faces, &wall_faces(scene));
    }

    /// Drags `particles` where a solver's substep left them.
    pub(crate) fn record(
        &self,
        recording: &mut Recording,
        context: &StepContext,
        search: &NeighbourSearch,
        particles: &mut Particles,
    ) {
        context.slots.dispatch(
            recording,
            &brooklet_kernels::DragWalls {
                positions: particles.positions.read(),
                velocities: particles.velocities.write(),
                wall_faces: self.faces.read(),
                step_state: context.slots.state.uniform(),
                step_params: context.step.uniform(),
                kernel: search.smoothing_kernel.uniform(),
            },
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene(settings: &[&str]) -> Scene {
        let settings: Vec<String> = settings.iter().map(|&s| s.into()).collect();
        Scene::load("dam-break", &settings).unwrap()
    }

    #[test]
    fn the_lattice_changes_the_closed_forms_by_little() {
        for ratio in ["2", "2.5", "3"] {
            let scene = scene(&["solver.method=sph", &format!("solver.support_ratio={ratio}")]);
            let (shear, friction) = (shear_scale(&scene), friction_scale(&scene));
            assert!((1.0..1.07).contains(&shear), "h = {ratio} d: {shear}");
            assert!((1.0..1.02).contains(&friction), "h = {ratio} d: {friction}");
        }
    }

    #[test]
    fn a_face_has_what_its_slip_has() {
        let faces = wall_faces(&scene(&[
            "solver.method=sph",
            "domain.faces.y_min={ slip = \"no-slip\", velocity_m_s = [1, 0, 2] }",
            "domain.faces.x_max={ slip = \"friction\", friction = 0.007 }",
        ]));
        let [shear, friction] = [faces.map(|face| face.shear_m2_s > 0.0), faces.map(|face| face.friction > 0.0)];
        assert_eq!(shear, [false, false, true, false, false, false]);
        assert_eq!(friction, [false, true, false, false, false, false]);
        assert_eq!(faces[2].velocity_m_s, [1.0, 0.0, 2.0]);
    }
}
